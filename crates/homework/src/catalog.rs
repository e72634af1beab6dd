//! Every exercise, with its reference solution and its known mistakes.

use std::path::PathBuf;

use cutter::{Manifest, Source};
use exercise::{Probe, Sheet};
use stage::Error;

use crate::sheets::sheet;
use crate::solutions::{MISTAKES, REFERENCES};

/// The exercises of the checkout that this was built from.
#[derive(Debug)]
pub struct Catalog {
    /// The checkout.
    pub source: Source,
    /// In the order of the book.
    pub exercises: Vec<Exercise>,
}

/// An exercise.
#[derive(Debug)]
pub struct Exercise {
    /// What it is.
    pub manifest: Manifest,
    /// The chapter's own code.
    pub reference: Probe,
    /// What is often done wrong.
    pub mistakes: Vec<Known>,
}

/// A mistake that can be recognized.
#[derive(Debug)]
pub struct Known {
    /// `far-root`
    pub name: String,
    /// The sentence that helps.
    pub says: String,
    /// The code with the mistake.
    pub probe: Probe,
}

impl Catalog {
    /// Reads the exercises. `Err` where the checkout is gone, or is not what this was built from.
    pub fn read() -> Result<Catalog, Error> {
        let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..");
        let source = Source::at(root.canonicalize().unwrap_or(root));
        let remedy =
            |error| Error::Failed(format!("{error}; run this with cargo in the checkout of the workbench"));
        let manifests = Manifest::all(&source).map_err(remedy)?;
        let known =
            |manifest| built(manifest).ok_or_else(|| remedy("the exercises have changed".to_string()));
        let exercises = manifests.into_iter().map(known).collect::<Result<_, _>>()?;
        Ok(Catalog { source, exercises })
    }

    /// The exercise with a name, `ray-sphere/closest-approach`.
    pub fn find(&self, name: &str) -> Result<&Exercise, Error> {
        self.exercises.iter().find(|it| it.manifest.name == name).ok_or_else(|| {
            let chapter = name.split('/').next().unwrap_or_default();
            let near: Vec<&str> = self.exercises.iter().map(|it| it.manifest.name.as_str()).collect();
            let here: Vec<&str> =
                near.iter().copied().filter(|it| it.split('/').next() == Some(chapter)).collect();
            let (which, names) =
                if here.is_empty() { ("there are", near) } else { ("its chapter has", here) };
            Error::Request(format!("there is no exercise {name:?}; {which} {}", names.join(", ")))
        })
    }
}

fn built(manifest: Manifest) -> Option<Exercise> {
    let (_, reference) = REFERENCES.iter().find(|(name, _)| *name == manifest.name)?;
    let mistake = |it: &cutter::Mistake| {
        let of_this =
            |(exercise, name, _): &&(&str, &str, Probe)| *exercise == manifest.name && *name == it.name;
        let (_, _, probe) = MISTAKES.iter().find(of_this)?;
        Some(Known { name: it.name.clone(), says: it.says.clone(), probe: *probe })
    };
    let mistakes = manifest.mistakes.iter().map(mistake).collect::<Option<_>>()?;
    Some(Exercise { reference: *reference, mistakes, manifest })
}

impl Exercise {
    /// All its cases, with what is expected of each.
    pub fn sheet(&self) -> Sheet {
        sheet(&self.manifest, self.reference, usize::MAX)
    }

    /// The cases that go along with the hand-out: the first of each property.
    pub fn shown(&self) -> Sheet {
        sheet(&self.manifest, self.reference, 1)
    }

    /// How many points there are.
    pub fn points(&self) -> u32 {
        self.manifest.properties.iter().map(|it| it.points).sum()
    }
}

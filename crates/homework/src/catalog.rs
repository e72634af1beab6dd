//! Every exercise, with its reference solution and its known mistakes.

use std::path::{Path, PathBuf};

use cutter::{Manifest, Source};
use exercise::{Probe, Sheet};
use stage::Error;

use crate::sheets::sheet;
use crate::solutions::{MISTAKES, REFERENCES};
use crate::state::state;

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
    /// Reads the exercises. [`Error::Failed`] where the checkout is gone, or its chapters are not what this
    /// was built from.
    pub fn read() -> Result<Catalog, Error> {
        let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..");
        let source = Source::at(root.canonicalize().unwrap_or(root));
        let remedy =
            |error| Error::Failed(format!("{error}; run this with cargo in the checkout of the workbench"));
        as_built(&source.root().join("chapters"), env!("CHAPTERS")).map_err(remedy)?;
        let manifests = Manifest::all(&source).map_err(remedy)?;
        let known =
            |manifest| built(manifest).ok_or_else(|| remedy("the exercises have changed".to_string()));
        let exercises = manifests.into_iter().map(known).collect::<Result<_, _>>()?;
        Ok(Catalog { source, exercises })
    }

    /// The exercise with a name, `ray-sphere/closest-approach`. [`Error::Request`] where there is none, with
    /// the names that there are.
    pub fn find(&self, name: &str) -> Result<&Exercise, Error> {
        self.exercises.iter().find(|it| it.manifest.name == name).ok_or_else(|| {
            let chapter = name.split('/').next().unwrap_or_default();
            let near: Vec<&str> = self.exercises.iter().map(|it| it.manifest.name.as_str()).collect();
            let here: Vec<&str> =
                near.iter().copied().filter(|it| it.split('/').next() == Some(chapter)).collect();
            // its name without that of its chapter
            let meant: Vec<&str> =
                near.iter().copied().filter(|it| it.split('/').nth(1) == Some(name)).collect();
            if !meant.is_empty() {
                let meant = meant.join(" or ");
                return Error::Request(format!("there is no exercise {name:?}; did you mean {meant}?"));
            }
            let (which, names) =
                if here.is_empty() { ("there are", near) } else { ("its chapter has", here) };
            Error::Request(format!("there is no exercise {name:?}; {which} {}", names.join(", ")))
        })
    }
}

/// Whether the chapters are in the state that this was built from: else its solutions are not those of the
/// hand-outs.
fn as_built(chapters: &Path, then: &str) -> Result<(), String> {
    let state = state(chapters).map_err(|error| format!("cannot read {}: {error}", chapters.display()))?;
    match state.to_string() == then {
        true => Ok(()),
        false => Err(format!("{} has changed since this was built", chapters.display())),
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
    /// All its cases, with what is expected of each: worked out anew each time.
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

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn a_name_without_its_chapter_is_understood_though_not_taken() {
        let catalog = Catalog::read().unwrap();
        let why = |name: &str| catalog.find(name).map(|_| ()).unwrap_err().to_string();
        assert!(why("half-quadratic").ends_with("; did you mean ray-sphere/half-quadratic?"));
        assert!(why("ray-sphere/half").contains("; its chapter has "));
        assert!(why("half").contains("; there are "));
    }

    #[test]
    fn solutions_of_other_chapters_are_not_used() {
        let folder = tempfile::tempdir().unwrap();
        for (path, text) in
            [("04-a/src/deep/b.rs", "b"), ("04-a/exercises/c.toml", "c"), ("04-a/tests/d.rs", "d")]
        {
            let path = folder.path().join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        let then = state(folder.path()).unwrap().to_string();
        fs::write(folder.path().join("04-a/tests/d.rs"), "nothing is cut from it").unwrap();
        assert_eq!(as_built(folder.path(), &then), Ok(()));
        for path in ["04-a/src/deep/b.rs", "04-a/exercises/c.toml", "04-a/src/new.rs"] {
            let path = folder.path().join(path);
            let before = fs::read(&path).ok();
            fs::write(&path, "changed").unwrap();
            let error = as_built(folder.path(), &then).unwrap_err();
            assert!(error.contains("has changed since this was built"), "{error}");
            before.map_or_else(|| fs::remove_file(&path), |text| fs::write(&path, text)).unwrap();
        }
        assert_eq!(as_built(folder.path(), &then), Ok(()));
        assert!(as_built(&folder.path().join("gone"), &then).is_err());
    }
}

//! Scenes in Eric Haines's Neutral File Format, as his
//! [Standard Procedural Databases](https://github.com/erich666/StandardProceduralDatabases) write it.
//!
//! A file is a row of words, however they are broken into lines: a keyword, then its numbers. What follows a keyword
//! stands as a form in `nff/statement.rs`. A color is 0 to 1 here as well; a background and a light may exceed 1.

mod fill;
mod light;
mod shape;
mod statement;
mod view;

use std::sync::Arc;

use crate::limits::NFF_THINGS;
use crate::source::{Source, Spot};
use crate::toml::shown;
use crate::word::{Word, Words};
use crate::{Camera, Error, Material, Object, Scene};
use light::{RawLight, lights};
use statement::{STATEMENTS, Statement};

/// What was read so far.
#[derive(Default)]
struct Reading<'t> {
    background: Option<([f64; 3], Spot<'t>)>,
    view: Option<(Camera, Spot<'t>)>,
    lights: Vec<RawLight>,
    materials: Vec<Material>,
    objects: Vec<Object>,
}

/// Reads a scene in NFF.
pub(crate) fn scene(source: Source) -> Result<Scene, Error> {
    let source = Arc::new(source);
    let mut words = Words::of(source.spot(0..source.text.len()));
    let mut reading = Reading::default();
    while let Some(word) = words.peek() {
        let Some(statement) = Statement::begin(&mut words, STATEMENTS) else {
            let problem = format!("{} is no keyword of NFF", shown(word.text));
            let remedy = "write one of `v`, `b`, `l`, `f`, `s`, `c`, `p` and `pp`, or `#` before a comment";
            return Err(word.spot.fault(&problem, remedy));
        };
        reading.statement(statement)?;
    }
    let Some((camera, _)) = reading.view else {
        let remedy = "write `v from 0 1 -6 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 512 512`";
        return Err(source.spot(0..0).fault("this scene has no view", remedy));
    };
    Ok(Scene {
        max_depth: 5,
        background: reading.background.map_or([0.0; 3], |(color, _)| color),
        ambient: [1.0; 3],
        camera,
        lights: lights(reading.lights),
        materials: reading.materials,
        objects: reading.objects,
        source: source.clone(),
    })
}

impl<'t> Reading<'t> {
    /// Reads what follows a keyword.
    fn statement(&mut self, mut statement: Statement<'_, 't>) -> Result<(), Error> {
        let keyword = statement.keyword;
        let full = [self.lights.len(), self.materials.len(), self.objects.len()].contains(&NFF_THINGS);
        if full {
            let problem = format!("more than {NFF_THINGS} objects, materials or lights are too many");
            return Err(keyword.spot.fault(&problem, "write a smaller scene"));
        }
        match keyword.text {
            "b" => {
                let color = statement.radiance()?;
                once(&self.background, keyword, "background")?;
                self.background = Some((color, keyword.spot));
            }
            "v" => {
                once(&self.view, keyword, "view")?;
                self.view = Some((view::view(statement)?, keyword.spot));
            }
            "l" => self.lights.push(light::light(statement)?),
            "f" => {
                let name = (self.materials.len() + 1).to_string();
                self.materials.push(fill::fill(name, statement)?);
            }
            _ => {
                let Some(material) = self.materials.len().checked_sub(1) else {
                    let remedy = "write an `f` before it, such as `f 1 0 0 0.7 0.2 32 0 0`";
                    return Err(keyword.spot.fault("a shape without a color: there is no `f` yet", remedy));
                };
                let id = u16::try_from(self.objects.len() + 1).ok();
                let shape = shape::shape(&mut statement)?;
                let place = statement.place();
                self.objects.push(Object { place, id, shape, transform: Vec::new(), material });
            }
        }
        Ok(())
    }
}

/// An error where something that a scene has once comes again.
fn once<T>(before: &Option<(T, Spot)>, keyword: Word, what: &str) -> Result<(), Error> {
    match before {
        None => Ok(()),
        Some((_, first)) => {
            let problem = format!("a second {what}; the first is in line {}", first.line());
            Err(keyword.spot.clash(&problem, "keep one of the two", *first, "the first"))
        }
    }
}

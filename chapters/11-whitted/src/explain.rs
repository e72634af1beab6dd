//! `--explain`: what the scene requires and what it does not, and what it would cost to model everything
//! instead.

mod cost;

use std::collections::BTreeMap;

use bounds::Parts;
use math::Real;
use stage::{Section, Transcript, Value};

use crate::requirements::dear;
use crate::show::whole;
use crate::{Requirements, Scene, Tolerance};

pub(crate) use cost::cost;

/// What the scene requires, each with its reason.
pub(crate) fn requirements<R: Real>(
    transcript: &mut Transcript,
    file: &scene_file::Scene,
    scene: &Scene<R>,
    requirements: &Requirements,
    why: Option<&Section>,
) {
    let parts = Parts::of(&scene.lit.geometry).count();
    let asked = Asked { scene, requirements, parts };
    let section = transcript.section("What the scene requires", "--explain");
    let row = |(feature, required, why): (&str, bool, String)| {
        let required = if required { "yes" } else { "no" };
        vec![Value::text(feature), Value::text(required), Value::text(why)]
    };
    let mut rows =
        vec![vec![Value::text("precision"), Value::text(R::NAME), Value::text(precision::<R>(file, why))]];
    rows.extend(asked.rows().map(row));
    section.table(&["feature", "required", "why"], rows);
    sums_above_one(section, file, scene);
    bound(section, scene);
}

/// Why this precision; where the stage chose it, the last of what it found.
fn precision<R: Real>(file: &scene_file::Scene, why: Option<&Section>) -> String {
    match (crate::from_file::scene::<f32>(file, None, None), why.and_then(|why| why.steps.last())) {
        (Err(_), _) => "the scene has numbers that f32 cannot hold".to_string(),
        (Ok(_), Some(found)) => found.note.clone(),
        (Ok(_), None) => format!("{} as asked; --precision auto finds out whether f32 is enough", R::NAME),
    }
}

/// A scene, and what it requires.
struct Asked<'a, R: Real> {
    scene: &'a Scene<R>,
    requirements: &'a Requirements,
    parts: usize,
}

impl<R: Real> Asked<'_, R> {
    /// Each feature, whether it is required, and why.
    fn rows(&self) -> impl Iterator<Item = (&'static str, bool, String)> {
        let it = self.requirements;
        [
            ("shapes", !self.scene.lit.geometry.objects.is_empty(), self.shapes()),
            ("affine objects", it.transforms, self.transforms()),
            ("texture", it.textures, self.textures()),
            ("shadows", it.shadows, self.shadows()),
            ("mirror", it.mirror, self.sent_on(it.mirror, |optics| optics.mirror, "mirrors")),
            ("refraction", it.refraction, self.sent_on(it.refraction, |optics| optics.transmit, "transmits")),
            ("media stack", it.media, self.media()),
            ("acceleration", it.tree, self.acceleration()),
        ]
        .into_iter()
    }

    fn objects(&self) -> std::ops::Range<usize> {
        0..self.scene.lit.geometry.objects.len()
    }

    fn shapes(&self) -> String {
        let mut counts: BTreeMap<&str, u64> = BTreeMap::new();
        for object in &self.scene.lit.geometry.objects {
            *counts.entry(object.shape.name()).or_default() += 1;
        }
        let named = |(name, count): (&str, u64)| {
            if count == 1 { name.to_string() } else { format!("{count} × {name}") }
        };
        let all: Vec<String> = counts.into_iter().map(named).collect();
        if all.is_empty() { "there are no objects: all is background".to_string() } else { all.join("; ") }
    }

    fn transforms(&self) -> String {
        let deformed = |shape: &signature::Shape<R>| matches!(shape, signature::Shape::Deformed(_));
        match self.scene.lit.geometry.objects.iter().filter(|object| deformed(&object.shape)).count() {
            0 => "no object is met in a space of its own: what is flat was moved once".to_string(),
            count => format!("{count} of {} objects are met in a space of their own", self.objects().len()),
        }
    }

    fn textures(&self) -> String {
        match self.scene.lit.painted.iter().filter(|painted| painted.texture.is_some()).count() {
            0 => "no object has a texture: no (u, v) is worked out".to_string(),
            count => {
                format!("{count} of {} objects have one: (u, v) is worked out there", self.objects().len())
            }
        }
    }

    fn shadows(&self) -> String {
        let lit = &self.scene.lit;
        let of = |object: usize| &lit.materials[lit.painted[object].material];
        let silent = self.objects().filter(|&object| !of(object).answers_lights()).count();
        match (lit.lights.len(), silent) {
            (0, _) => "there is no light: only what is ambient is seen; [[light]] adds one".to_string(),
            (_, silent) if silent == self.objects().len() => {
                "no material answers a light: r_d + r_s = 0".to_string()
            }
            (1, 0) => "there is a light, and every material answers it".to_string(),
            (lights, 0) => format!("{lights} lights, and every material answers them"),
            (lights, silent) => {
                let all = self.objects().len();
                format!(
                    "{lights} lights; none is asked for where r_d + r_s = 0, on {silent} of {all} objects"
                )
            }
        }
    }

    fn sent_on(&self, required: bool, coefficient: impl Fn(&crate::Optics) -> f64, verb: &str) -> String {
        let count = self.objects().filter(|&object| coefficient(self.scene.optics_of(object)) > 0.0).count();
        match (count, required) {
            (0, _) => format!("no material {verb}"),
            (_, false) => "maxDepth is 1: local shading only".to_string(),
            (count, true) => {
                format!("{count} of {} objects: to depth {}", self.objects().len(), self.scene.max_depth)
            }
        }
    }

    fn media(&self) -> String {
        let (it, scene) = (self.requirements, self.scene);
        let lets_in = |object: &usize| scene.is_solid(*object) && scene.optics_of(*object).transmit > 0.0;
        match () {
            () if it.media => "light goes into solids, and an index of refraction is not 1".to_string(),
            () if !it.refraction => "nothing goes through a surface".to_string(),
            () if !self.objects().any(|object| lets_in(&object)) => {
                "what lets light through has no inside".to_string()
            }
            () => "every index of refraction is 1: nothing is bent".to_string(),
        }
    }

    fn acceleration(&self) -> String {
        let (parts, least) = (self.parts, bounds::method::CROSSOVER);
        match (self.requirements.tree, dear(self.scene)) {
            (true, _) if parts >= least => {
                format!("{parts} parts to test; from {least} on a tree of boxes pays")
            }
            (true, dear) => {
                format!("{parts} parts to test, {dear} of them so dear that a box before one alone pays")
            }
            (false, _) => {
                format!("{parts} parts to test: with fewer than {least} a tree costs more than it saves")
            }
        }
    }
}

/// Materials that may send out more light than comes in.
fn sums_above_one<R: Real>(section: &mut Section, file: &scene_file::Scene, scene: &Scene<R>) {
    let used = |place: usize| scene.lit.painted.iter().any(|painted| painted.material == place);
    for (_, it) in file.materials.iter().enumerate().filter(|(place, _)| used(*place)) {
        let sum = it.ambient + it.diffuse + it.specular + it.mirror + it.transmit;
        if sum > 1.0 {
            let sum = Value::number((sum * 1e6).round() / 1e6).to_text();
            section.remark(format!(
                "Material {}: r_a + r_d + r_s + r_g + r_t = {sum} exceeds 1: more light may leave it than comes in.",
                it.name
            ));
        }
    }
}

/// How bright anything may be.
fn bound<R: Real>(section: &mut Section, scene: &Scene<R>) {
    let bound = Tolerance::new(scene, 0.0).bound(1).unwrap_or(f64::INFINITY);
    section
        .step("maxDepth", "how deep the recursion goes", whole(scene.max_depth.into()))
        .number("B(1)", "no pixel is brighter, linear, before clamping", bound)
        .note(
            "B(d) = max(background, L + (r_g + r_t) B(d + 1)), \
               L = r_a I_a C + Σ I (r_d C + r_s), of the brightest material",
        );
}

#[cfg(test)]
mod tests;

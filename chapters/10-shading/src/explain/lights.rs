//! Each light at the point, and the sum.

use bounds::Uncounted;
use math::{Real, Vector};
use stage::{Section, Transcript, Value};

use super::rgb;
use crate::shadow::LastBlockers;
use crate::{Fate, Lighting, Phong, Point, Rgb, phong};

/// More lights than this are summed, but not explained one by one.
const MOST: usize = 12;

/// Every light, then E.
pub(super) fn explain<R: Real>(
    transcript: &mut Transcript,
    lighting: &Lighting<'_, R>,
    point: &Point<R>,
) -> Rgb {
    let mut fates = Vec::new();
    let e = lighting
        .local(point, &mut LastBlockers::default(), &mut Uncounted, |light, fate| fates.push((light, fate)));
    for (light, fate) in fates.iter().take(MOST) {
        one(transcript, lighting, point, *light, fate);
    }
    let ambient = lighting.ambient(point.landing.object, point.color);
    let section = transcript.section("E, the sum", "CSC418 11.7.1");
    section.step("ambient", "r_a I_a C", rgb(ambient));
    for (light, fate) in fates.iter().take(MOST) {
        let (diffuse, specular) = match fate {
            Fate::Seen(phong) => (phong.diffuse, phong.specular),
            _ => (Rgb::BLACK, Rgb::BLACK),
        };
        section.step("diffuse", &format!("of light {}", light + 1), rgb(diffuse)).step(
            "specular",
            &format!("of light {}", light + 1),
            rgb(specular),
        );
    }
    if fates.len() > MOST {
        section.remark(format!("{} more lights are in the sum.", fates.len() - MOST));
    }
    section.step("E", "ambient + Σ V (diffuse + specular)", rgb(e));
    e
}

fn one<R: Real>(
    transcript: &mut Transcript,
    lighting: &Lighting<'_, R>,
    point: &Point<R>,
    light: usize,
    fate: &Fate<R>,
) {
    let it = &lighting.scene.lights[light];
    let to_light = it.position - point.landing.point;
    let section = transcript.section(format!("Light {}", light + 1), "CSC418 11.7.1, 11.7.4");
    section.vector::<R>("l̄", "where it is", it.position).step("I", "its intensity", rgb(it.intensity));
    if to_light.is_zero() || !to_light.is_finite() {
        section.step("V", "is it seen?", Value::number(0.0)).note("it is at the point, or too far away");
        return;
    }
    let material = &lighting.scene.materials[lighting.scene.painted[point.landing.object].material];
    let terms = phong::<R>(material, point.color, it.intensity, point.turned.n, to_light, point.c);
    section.vector::<R>("s⃗", "(l̄ − p̄) / ‖l̄ − p̄‖", terms.s).number("n⃗·s⃗", "", terms.n_dot_s);
    match fate {
        Fate::Behind => {
            section.note("not above 0: the surface looks away");
            section.step("V", "is it seen?", Value::number(0.0)).note("no ray is sent");
        }
        Fate::Unanswered => {
            section.step("V", "is it seen?", Value::text("not asked")).note("r_d + r_s = 0");
        }
        Fate::Shadowed(_) => {
            mirrored(section, &terms);
            section.step("V", "is it seen?", Value::number(0.0));
            section.note(blocked(lighting, point, it.position, to_light));
        }
        Fate::Seen(phong) => {
            mirrored(section, phong);
            section
                .step("V", "is it seen?", Value::number(1.0))
                .note("nothing is met between λ = 0, the point, and λ = 1, the light")
                .step("diffuse", "r_d I C max(0, n⃗·s⃗)", rgb(phong.diffuse))
                .step("specular", "r_s I max(0, c⃗·m⃗)^α", rgb(phong.specular));
        }
    }
}

fn mirrored<R: Real>(section: &mut Section, terms: &Phong<R>) {
    section.vector::<R>("m⃗", "2 (s⃗·n⃗) n⃗ − s⃗", terms.m).number("c⃗·m⃗", "", terms.c_dot_m);
    if terms.c_dot_m <= R::from(0.0) {
        section.note("not above 0: no highlight");
    }
}

/// What stands in the way first.
fn blocked<R: Real>(
    lighting: &Lighting<'_, R>,
    point: &Point<R>,
    light: R::Vec3,
    to_light: R::Vec3,
) -> String {
    let query = point.starts.to(light, to_light);
    let Some(first) = lighting.bounded.first_part(&query, &mut Uncounted) else {
        return "something stands in between".to_string();
    };
    let parts = lighting.bounded.all_parts();
    let (object, shape) = (parts.object(first.part), parts.shape(first.part).name());
    let itself = match first.part == point.landing.part {
        true if point.turned.from_outside => ", the very surface that the ray leaves: acne",
        true => ", the other side of what the ray is in",
        false if object == point.landing.object => ", the object itself",
        false => "",
    };
    let lambda = Value::number(first.lambda).to_text();
    format!("object {}, the {shape}, is first in the way, at λ = {lambda}{itself}", object + 1)
}

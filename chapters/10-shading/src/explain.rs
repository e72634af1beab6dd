//! The transcript: one pixel of the picture down to the last term, then what the picture took.

mod lights;
mod normals;
mod starts;

use bounds::{Bounded, Counts};
use math::{Ray3, Real, Vector};
use stage::{Ask, Error, Section, Transcript, Value};

use crate::layout::{COLUMNS, Part, Term, What};
use crate::own::{self, SCALES};
use crate::picture::{color, lighting, of};
use crate::render::{Landed, Rendered, Work};
use crate::{Landing, Lighting, Rgb, Scene, Start, from_file};

/// One pixel of a part of the picture. `pixel` is where that is in the whole picture, `own` where in the
/// part.
pub(crate) fn explain<R: Real>(
    transcript: &mut Transcript,
    ask: &Ask,
    file: &scene_file::Scene,
    (part, own): (Part, (u32, u32)),
    pixel: (u32, u32),
) -> Result<(), Error> {
    match part.what {
        What::Term(term) => {
            let scene = from_file::scene::<R>(file, Some(part.size)).map_err(signature::stage::fault)?;
            let whole = if ask.scene.is_some() { String::new() } else { format!("of \"{}\"", term.label()) };
            pixel_of(transcript, ask, &scene, Start::ALL[ask.method], (own, pixel), (&whole, term));
        }
        What::Cell(row, column) => {
            let scene = own::small::<f32>(SCALES[row], part.size)?;
            let whole = format!("of the small scene at {:e}", SCALES[row]);
            pixel_of(transcript, ask, &scene, COLUMNS[column], (own, pixel), (&whole, Term::All));
        }
    }
    Ok(())
}

fn pixel_of<R: Real>(
    transcript: &mut Transcript,
    ask: &Ask,
    scene: &Scene<R>,
    start: Start,
    (own, pixel): ((u32, u32), (u32, u32)),
    (whole, term): (&str, Term),
) {
    let bounded = Bounded::new(&scene.geometry, bounds::Method::Auto);
    let lighting = lighting(scene, &bounded, start);
    let samples = ask.samples.unwrap_or(1);
    // of several rays the one in the middle
    let middle = (samples / 2 * samples + samples / 2) as usize;
    let Some(ray) = lighting.rays(own, samples).nth(middle) else { return };
    let title = format!("shading · {} · {} · pixel {},{}", start.name(), R::NAME, pixel.0, pixel.1);
    let landed = lighting.landed(&ray, &mut Counts::default());
    let section = transcript.section(title, "CSC418 11.7.1");
    section.vector::<R>("ē", "the eye", ray.origin).vector::<R>("d⃗_ij", "p̄_ij − ē", ray.direction);
    if !whole.is_empty() {
        let (width, height) = scene.geometry.size;
        section.note(format!("pixel {},{} {whole}, {width} × {height}", own.0, own.1));
    }
    if samples > 1 {
        section.remark(format!("One of the {samples} × {samples} rays of this pixel, in the middle of it."));
    }
    let mut e = scene.background;
    match landed {
        None => {
            section.step("λ*", "the smallest λ ≥ 0", Value::text("none"));
            background(transcript, scene.background);
        }
        Some(Landed { landing, point }) => {
            hit(section, &lighting, &ray, &landing);
            normals::explain(transcript, &lighting, &ray, &landing);
            surface(transcript, &lighting, &landing);
            match point {
                None => {
                    e = lighting.ambient(landing.object, lighting.color(&landing));
                    let section = transcript.section("E: no way leads from so far away to a light", "");
                    section.step("E", "r_a I_a C", rgb(e));
                }
                Some(point) => {
                    starts::explain(transcript, &lighting, &point);
                    e = lights::explain(transcript, &lighting, &point);
                }
            }
        }
    }
    eight_bits(transcript, ask, &lighting, (own, samples), (e, term));
}

/// What is hit.
fn hit<R: Real>(section: &mut Section, lighting: &Lighting<'_, R>, ray: &Ray3<R>, landing: &Landing<R>) {
    let parts = lighting.bounded.all_parts();
    let face = parts.face(landing.part).map_or(String::new(), |face| format!(", face {}", face + 1));
    let shape = parts.shape(landing.part).name();
    section
        .number("λ*", "the smallest λ ≥ 0", landing.lambda)
        .note(format!("of object {}, the {shape}{face}", landing.object + 1))
        .vector::<R>("c⃗", "−d⃗ / ‖d⃗‖", -ray.direction.unit())
        .vector::<R>("p̄", "ē + λ* d⃗", landing.point);
}

/// Its material, and its color there.
fn surface<R: Real>(transcript: &mut Transcript, lighting: &Lighting<'_, R>, landing: &Landing<R>) {
    let painted = &lighting.scene.painted[landing.object];
    let material = &lighting.scene.materials[painted.material];
    let section = transcript.section("The surface there: its coefficients, and its color", "CSC418 11.7.2");
    let coefficients = [material.ambient, material.diffuse, material.specular, material.shininess];
    section.step(
        "r_a, r_d, r_s, α",
        "of its material",
        Value::Array(coefficients.map(Value::number).to_vec()),
    );
    if let Some(texture) = &painted.texture {
        let alpha_beta = landing.alpha_beta.map(|(alpha, beta)| (alpha.into(), beta.into()));
        let (u, v) = texture.mapping.uv(landing.point.in_f64(), alpha_beta);
        section
            .step("u, v", "in the object's own space", Value::Array(vec![Value::number(u), Value::number(v)]))
            .note(match &texture.texture {
                crate::Texture::Checker { scale, .. } => format!("a checker, its squares {scale} wide"),
                crate::Texture::Image { size, .. } => format!("a picture of {} × {} pixels", size.0, size.1),
            })
            .step("texture", "its color at (u, v)", rgb(texture.color(u, v)));
    }
    let formula = if painted.texture.is_some() {
        "the material's color times the texture's"
    } else {
        "the material's color"
    };
    section.step("C", formula, rgb(lighting.color(landing)));
}

fn background(transcript: &mut Transcript, color: Rgb) {
    let section = transcript.section("E: nothing is hit", "");
    section.step("E", "the background", rgb(color));
}

/// From E, or the term of it that is drawn, to the bytes of the picture.
fn eight_bits<R: Real>(
    transcript: &mut Transcript,
    ask: &Ask,
    lighting: &Lighting<'_, R>,
    (own, samples): ((u32, u32), u32),
    (e, term): (Rgb, Term),
) {
    let section = transcript.section("The pixel", "");
    let seen = lighting.pixel(own, samples, &mut Work::default());
    let (mut symbol, mut drawn) = ("E", e);
    if samples > 1 {
        drawn = seen.e;
        section.step("E", &format!("the mean of the {} rays", samples * samples), rgb(drawn));
    }
    if term != Term::All {
        (symbol, drawn) = ("drawn", of(term, &seen));
        section.step(symbol, term.label(), rgb(drawn)).note("this part of the picture shows that alone");
    }
    let formula = match ask.srgb {
        true => format!("round(255 · sRGB({symbol})), {symbol} cut at 0 and 1"),
        false => format!("round(255 {symbol}), {symbol} cut at 0 and 1"),
    };
    let bytes = color(ask, drawn).0.map(|byte| Value::number(f64::from(byte)));
    section.step("red, green, blue", &formula, Value::Array(bytes.to_vec()));
    if drawn.largest() > 1.0 {
        section.note("brighter than white, and cut");
    }
}

/// What the picture took.
pub(crate) fn picture<T>(transcript: &mut Transcript, rendered: &Rendered<T>) {
    let Work { eye_rays, hits, shadow_rays, blocked, of_eye, of_shadows } = rendered.work;
    let (width, height) = rendered.size;
    let whole = |count: u64| Value::number(count as f64);
    let section = transcript.section(format!("The {width} × {height} pixels around it"), "");
    section
        .step("eye rays", "one a sample", whole(eye_rays))
        .note(format!("{hits} of them hit"))
        .step("shadow rays", "where n⃗·s⃗ > 0 and r_d + r_s > 0", whole(shadow_rays))
        .note(format!("{blocked} of them are blocked"))
        .step("tests", "objects and faces, by eye rays", whole(of_eye.tests))
        .note(format!("and {} boxes", of_eye.boxes))
        .step("tests", "by shadow rays", whole(of_shadows.tests))
        .note(format!("and {} boxes", of_shadows.boxes));
}

/// Red, green and blue.
fn rgb(Rgb(channels): Rgb) -> Value {
    Value::Array(channels.map(Value::number).to_vec())
}

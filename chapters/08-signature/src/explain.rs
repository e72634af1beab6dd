//! The transcript: one pixel, every object's λ*, and who won.

use math::{Ray3, Real, Span};
use stage::{Error, Section, Transcript, Value};

use crate::picture::Seen;
use crate::stage::fault;
use crate::{First, Method, Object, Scene, first_hit, from_file};

/// How many objects a table shows at the most.
const ROWS: usize = 40;

/// The page's loop over all objects, for one pixel.
pub(crate) fn explain<R: Real>(
    transcript: &mut Transcript,
    method: Method,
    scene: &Scene<R>,
    (col, row): (u32, u32),
) {
    let ray = scene.ray((col, row));
    let title = format!("signature · {} · {} · pixel {col},{row}", method.name(), R::NAME);
    let section = transcript.section(title, "CSC418 11.4");
    section
        .vector::<R>("ē", "the eye", ray.origin)
        .vector::<R>("p̄_ij", "the pixel's point of the view plane", ray.at(R::from(1.0)))
        .vector::<R>("d⃗_ij", "p̄_ij − ē", ray.direction)
        .note("r̄(λ) = ē + λ d⃗: λ is 0 at the eye and 1 on the view plane");

    let first = first_hit(method, &ray, &scene.objects, Span::ahead());
    let tries: Vec<Try<R>> = scene.objects.iter().map(|object| Try::of(method, &ray, object)).collect();
    let (rows, left_out) = rows(scene, &tries);
    let columns = ["k", "objID", "object", "λ*", "λ_ij", "why"];
    match first {
        None => {
            section.step("λ_ij", "the smallest λ* ≥ 0", Value::text("none"));
        }
        Some(First { object, lambda }) => {
            let it = &scene.objects[object];
            section
                .number("λ_ij", "the smallest λ* ≥ 0", lambda)
                .note(format!("of {}", named(object, it)))
                .step("sig[i, j]", "objID_k", id(it))
                .vector::<R>("r̄(λ_ij)", "ē + λ_ij d⃗_ij", ray.at(lambda));
        }
    }
    let section = transcript.section("Every object in turn: its λ*, and λ_ij after it", "CSC418 11.4");
    section.table(&columns, rows);
    if left_out > 0 {
        section.remark(format!("{left_out} more objects: the line of the ray does not meet them."));
    }
    if scene.objects.is_empty() {
        section.remark("There are no objects: every pixel sees the background.");
    }
}

/// What became of one object.
#[derive(Clone, Copy, Debug)]
enum Try<R> {
    /// It is hit at λ*.
    Hit(R),
    /// It is hit before the origin, at −λ*.
    Behind(R),
    /// The ray runs along it.
    Along(math::Parallel),
    /// Its line passes by.
    Miss,
}

impl<R: Real> Try<R> {
    fn of(method: Method, ray: &Ray3<R>, object: &Object<R>) -> Try<R> {
        let hit = |ray: &Ray3<R>| object.shape.hit(method, ray, Span::ahead()).map(|hit| hit.t);
        if let Some(lambda) = hit(ray) {
            return Try::Hit(lambda);
        }
        if let Some(how) = object.shape.parallel(ray) {
            return Try::Along(how);
        }
        hit(&Ray3::new(ray.origin, -ray.direction)).map_or(Try::Miss, Try::Behind)
    }
}

/// The rows of the table, in the order of the loop: all objects, or where they are many those that the line meets. And how
/// many are left out.
fn rows<R: Real>(scene: &Scene<R>, tries: &[Try<R>]) -> (Vec<Vec<Value>>, usize) {
    let (mut rows, mut left_out, mut best) = (Vec::new(), 0, None::<First<R>>);
    for (object, (it, result)) in scene.objects.iter().zip(tries).enumerate() {
        let (lambda, why) = match *result {
            Try::Hit(lambda) => {
                let nearer = |it: &Try<R>| matches!(*it, Try::Hit(other) if other < lambda);
                let next = tries[object..].iter().position(nearer).map(|steps| object + steps);
                (Value::number(lambda), fate(lambda, best, next))
            }
            Try::Behind(lambda) => (Value::number(-lambda), "behind the eye: λ* < 0".to_string()),
            Try::Along(how) => (Value::text("none"), format!("missed: {}", how.reason())),
            Try::Miss => (Value::text("none"), "missed".to_string()),
        };
        if let Try::Hit(lambda) = *result
            && best.is_none_or(|best| lambda < best.lambda)
        {
            best = Some(First { object, lambda });
        }
        if scene.objects.len() > ROWS && !matches!(result, Try::Hit(_) | Try::Behind(_)) {
            left_out += 1;
            continue;
        }
        let lambda_ij = best.map_or(Value::number(R::INFINITY), |best| Value::number(best.lambda));
        let place = whole(object as u64 + 1);
        rows.push(vec![place, id(it), Value::text(it.shape.name()), lambda, lambda_ij, Value::text(why)]);
    }
    (rows, left_out)
}

/// Why an object that is hit wins or loses. `best` is the nearest of those before it in the loop, `next` the first
/// after it that is nearer than it.
fn fate<R: Real>(lambda: R, best: Option<First<R>>, next: Option<usize>) -> String {
    match (best, next) {
        (Some(best), _) if lambda == best.lambda => {
            format!("not λ* < λ_ij: a tie with object {}, which comes earlier", best.object + 1)
        }
        (Some(best), _) if lambda > best.lambda => {
            format!("not λ* < λ_ij: behind object {}", best.object + 1)
        }
        (_, Some(next)) => format!("λ* < λ_ij, until object {} comes", next + 1),
        (_, None) => "seen: no λ* is smaller".to_string(),
    }
}

fn id<R: Real>(object: &Object<R>) -> Value {
    Value::maybe(object.id.map(f64::from))
}

/// A count as a table has it.
fn whole(count: u64) -> Value {
    Value::number(count as f64)
}

/// An object by its place in the loop and its shape.
fn named<R: Real>(place: usize, object: &Object<R>) -> String {
    format!("object {}, the {}", place + 1, object.shape.name())
}

/// Gambetta's loop beside it, and where the two pages start to look.
pub(crate) fn trace_ray<R: Real>(
    transcript: &mut Transcript,
    method: Method,
    scene: &Scene<R>,
    pixel: (u32, u32),
) {
    let ray = scene.ray(pixel);
    let range = |t_min| [t_min, R::INFINITY];
    let from_plane = crate::trace_ray(method, &ray, &scene.objects, range(R::from(1.0)));
    let from_eye = first_hit(method, &ray, &scene.objects, Span::ahead());
    let section = transcript.section("TraceRay(O, D, 1, inf)", "Gambetta, Listing 2-4");
    let closest = |section: &mut Section, first: Option<First<R>>| match first {
        Some(First { object, lambda }) => {
            section
                .number("closest_t", "the smallest t in [1, inf]", lambda)
                .note(format!("closest_object: {}", named(object, &scene.objects[object])));
        }
        None => {
            section.step("closest_t", "the smallest t in [1, inf]", Value::text("none"));
            section.note("closest_object = NULL: the background");
        }
    };
    closest(section, from_plane);
    if let Some(First { lambda, .. }) = from_plane {
        section
            .number("λ*", "t − 1: the page's ray starts at p̄_ij", lambda - R::from(1.0))
            .note("CSC418 asks for λ* > 0 there");
    }
    section.remark(match (from_plane, from_eye) {
        (None, None) => "From the eye, too, there is nothing.",
        _ if from_plane == from_eye => {
            "The same object as from the eye: nothing stands before the view plane here."
        }
        (Some(plane), Some(eye)) if plane.object == eye.object => {
            "The same object as from the eye, farther on: what of it stands before the view plane is not in either \
             page's range (slip 22)."
        }
        _ => "Another than from the eye: what stands before the view plane is not in either page's range (slip 22).",
    });
}

/// The pixel by every method at both precisions.
pub(crate) fn who_else_sees_what(
    transcript: &mut Transcript,
    file: &scene_file::Scene,
    size: (u32, u32),
    pixel: (u32, u32),
) -> Result<(), Error> {
    let mut rows = Vec::new();
    rows_of::<f64>(&mut rows, file, size, pixel)?;
    // a scene may be too large for f32 and still be one
    let fits = rows_of::<f32>(&mut rows, file, size, pixel).is_ok();
    let section = transcript.section("The same pixel by every method", "");
    section.table(&["method", "precision", "objID", "λ_ij"], rows);
    if !fits {
        section.remark("The scene has numbers that f32 cannot hold.");
    }
    Ok(())
}

fn rows_of<R: Real>(
    rows: &mut Vec<Vec<Value>>,
    file: &scene_file::Scene,
    size: (u32, u32),
    pixel: (u32, u32),
) -> Result<(), Error> {
    let scene = from_file::scene::<R>(file, Some(size)).map_err(fault)?;
    for method in Method::ALL {
        let first = first_hit(method, &scene.ray(pixel), &scene.objects, Span::ahead());
        let (seen, lambda) = match first {
            Some(First { object, lambda }) => (id(&scene.objects[object]), Value::number(lambda)),
            None => (whole(0), Value::text("none")),
        };
        rows.push(vec![Value::text(method.name()), Value::text(R::NAME), seen, lambda]);
    }
    Ok(())
}

/// The whole of the signature, counted.
pub(crate) fn signature<R: Real>(transcript: &mut Transcript, scene: &Scene<R>, seen: &Seen) {
    let counts = seen.counts();
    let (pixels, objects) = (seen.objects.len() as u64, scene.objects.len());
    let nothing = pixels - counts.values().sum::<u64>();
    let section = transcript.section("The signature", "CSC418 11.4");
    let mut largest: Vec<(usize, u64)> = counts.iter().map(|(&object, &count)| (object, count)).collect();
    largest.sort_by_key(|&(object, count)| (std::cmp::Reverse(count), object));
    let mut rows: Vec<Vec<Value>> = largest
        .iter()
        .take(ROWS)
        .map(|&(object, count)| {
            let it = &scene.objects[object];
            vec![id(it), Value::text(it.shape.name()), whole(count)]
        })
        .collect();
    if nothing > 0 {
        rows.push(vec![whole(0), Value::text("nothing"), whole(nothing)]);
    }
    section.table(&["objID", "object", "pixels"], rows);
    if largest.len() > ROWS {
        section.remark(format!("{} more objects are seen, each in fewer pixels.", largest.len() - ROWS));
    }
    if largest.len() < objects {
        section.remark(format!("{} of the {objects} objects are seen in no pixel.", objects - largest.len()));
    }
    section.remark(format!(
        "{pixels} rays, each against every object: {} intersections.",
        pixels * objects as u64
    ));
}

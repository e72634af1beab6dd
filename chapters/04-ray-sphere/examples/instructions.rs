//! What the wide registers are worth: nanoseconds a ray by the scalar methods, and by a batch in either
//! kind of instructions.
//!
//! `cargo run --release -p ray-sphere --example instructions`
//!
//! The rays are of the regime "ordinary", hits and misses as they come; every answer is complete, with
//! verdict, t, point and normal. All take turns, round by round.

use std::hint::black_box;
use std::rc::Rc;
use std::time::Duration;

use lab::{Nanoseconds, Pass, Runner, runner, time};
use math::{Ray3, Real, Span};
use ray_sphere::batched::{Batch, Hits, Instructions};
use ray_sphere::{Sphere, half_quadratic, quadratic, regimes};
use stage::Precision;

const SEED: u64 = 20261123;
const RAYS: usize = 8192;
const ROUNDS: usize = 1001;
const ALLOWED: Duration = Duration::MAX;

fn main() {
    let (single, double) = (Precision::F32, Precision::F64);
    let timed = [
        ("quadratic f64", by_quadratic::<f64>(double)),
        ("quadratic f32", by_quadratic::<f32>(single)),
        ("half-quadratic f64", by_half_quadratic::<f64>(double)),
        ("half-quadratic f32", by_half_quadratic::<f32>(single)),
        ("batched f64, baseline", by_batch::<f64>(double, Instructions::Baseline)),
        ("batched f64, best", by_batch::<f64>(double, Instructions::Best)),
        ("batched f32, baseline", by_batch::<f32>(single, Instructions::Baseline)),
        ("batched f32, best", by_batch::<f32>(single, Instructions::Best)),
    ];
    let (names, mut runners): (Vec<_>, Vec<_>) = timed.into_iter().unzip();
    let figures = time(&mut runners, Pass::Throughput, RAYS, ROUNDS, ALLOWED);

    let quadratic = figures[0].median;
    println!("{RAYS} rays, {ROUNDS} rounds; × is in units of the first");
    println!("{:<22} {:>6} {:>12} {:>6}", "", "ns", "quartiles", "×");
    for (name, Nanoseconds { low, median, high }) in names.into_iter().zip(figures) {
        let quartiles = format!("{low:.2}–{high:.2}");
        println!("{name:<22} {median:>6.2} {quartiles:>12} {:>6.3}", median / quadratic);
    }
}

/// The same rays for all of a precision.
fn questions<R: Real>(precision: Precision) -> Rc<[(Ray3<R>, Sphere<R>)]> {
    let question = |case: [f64; 10]| {
        let [ox, oy, oz, dx, dy, dz, cx, cy, cz, radius] = case.map(R::round_from);
        let ray = Ray3::<R>::new(R::vec3(ox, oy, oz), R::vec3(dx, dy, dz));
        (ray, Sphere { center: R::vec3(cx, cy, cz), radius })
    };
    regimes::regimes()[0].cases(SEED, precision).take(RAYS).map(question).collect()
}

fn by_quadratic<R: Real>(precision: Precision) -> Runner<'static> {
    runner(&questions::<R>(precision), |(ray, sphere)| quadratic(ray, sphere).hit(Span::ahead()))
}

fn by_half_quadratic<R: Real>(precision: Precision) -> Runner<'static> {
    runner(&questions::<R>(precision), |(ray, sphere)| half_quadratic(ray, sphere).hit(Span::ahead()))
}

fn by_batch<R: Real>(precision: Precision, instructions: Instructions) -> Runner<'static> {
    let batch: Batch<R> = questions(precision).iter().copied().collect();
    let mut hits = Hits::new();
    Box::new(move |_, _| {
        batch.hits_into(&mut hits, Span::ahead(), instructions);
        black_box(&hits);
        batch.len()
    })
}

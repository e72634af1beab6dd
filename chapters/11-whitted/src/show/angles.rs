//! The critical angles of a scene.

use math::Real;
use stage::{Transcript, Value};

use super::Shot;
use crate::critical_angle;

/// Of no more solids pairs are looked at.
const PAIRS: usize = 64;

/// θ_c for what lets light through in the scene; with the page's two examples, where they are asked for.
pub(crate) fn critical_angles<R: Real>(transcript: &mut Transcript, shot: &Shot<'_, R>, with_examples: bool) {
    let mut rows: Vec<Vec<Value>> = Vec::new();
    let mut row = |what: &str, n: f64, toward: &str, beyond: f64| {
        let angle = critical_angle(n, beyond)
            .map_or(Value::text("none"), |angle| Value::number((angle * 1e4).round() / 1e4));
        let row =
            vec![Value::text(what), Value::number(n), Value::text(toward), Value::number(beyond), angle];
        if !rows.contains(&row) {
            rows.push(row);
        }
    };
    if with_examples {
        row("water, as on the page", 1.33, "air", 1.0);
        row("dense flint, the page's glass (slip 28)", 1.8, "air", 1.0);
    }
    let scene = shot.scene;
    let lets_in = |&object: &usize| scene.is_solid(object) && scene.optics_of(object).transmit > 0.0;
    let solids: Vec<usize> = (0..scene.lit.painted.len()).filter(lets_in).collect();
    let of = |object: usize| {
        (shot.names.material(scene.lit.painted[object].material), scene.optics_of(object).ior)
    };
    for &object in &solids {
        match of(object) {
            (name, n) if n < 1.0 => row("air", 1.0, name, n),
            (name, n) => row(name, n, "air", 1.0),
        }
    }
    let few = if solids.len() <= PAIRS { &solids[..] } else { &[] };
    for (&from, &to) in few.iter().flat_map(|from| few.iter().map(move |to| (from, to))) {
        let ((name, n), (beyond, less)) = (of(from), of(to));
        if n > less && shares_room(shot, from, to) {
            row(name, n, beyond, less);
        }
    }
    if !rows.is_empty() {
        let section = transcript.section("Critical angles", "CSC418 11.7.3");
        section.table(&["from", "n1", "into", "n2", "θ_c"], rows);
        section.remark(
            "In degrees: sin θ_c = n2 / n1. Beyond θ_c nothing is refracted. Pairs are of solids whose",
        );
        section.remark("boxes overlap: one may be inside the other.");
    }
}

/// Whether the boxes of two objects overlap.
fn shares_room<R: Real>(shot: &Shot<'_, R>, a: usize, b: usize) -> bool {
    match (shot.parts.object_bounds(a), shot.parts.object_bounds(b)) {
        (Some(a), Some(b)) => (0..3).all(|axis| a.low[axis] <= b.high[axis] && b.low[axis] <= a.high[axis]),
        _ => false,
    }
}

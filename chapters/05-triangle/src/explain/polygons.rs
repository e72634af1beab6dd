//! Two stars, and where a test ray from a point crosses their sides.

use math::Real;
use stage::{Transcript, Value};

use crate::polygon::crossing::{Crossing, Way};
use crate::polygon::even_odd::{count_naively, is_inside_as_printed};
use crate::polygon::{EvenOdd, Polygon, even_odd, star, winding};

/// A point and what is special about it.
type Place = ([f32; 2], &'static str);

const OF_THE_STAR: [Place; 7] = [
    ([0.0, 0.0], "in the middle"),
    ([-6.0, 6.5], "beside the upper tip"),
    ([0.0, -1.0], "s runs through the notch p̄8"),
    ([0.0, 3.0], "through p̄10, along p̄9p̄10"),
    ([-12.0, 10.0], "past the tip p̄1"),
    ([-12.0, 3.0], "along both level sides"),
    ([-6.0, 3.0], "on a side"),
];

const OF_THE_PENTAGRAM: [Place; 4] = [
    ([0.0, 0.0], "in the middle"),
    ([0.0, 7.0], "in a tip"),
    ([0.0, -6.0], "between two tips"),
    ([0.0, 10.0], "a corner"),
];

/// A concave star by even-odd counting, and a pentagram by both rules.
pub(crate) fn polygons<R: Real>(transcript: &mut Transcript) {
    if let Ok(star) = Polygon::<R>::new(star::in_space::<R>(&star::CONCAVE)) {
        concave(transcript, &star);
    }
    if let Ok(star) = Polygon::<R>::new(star::in_space::<R>(&star::PENTAGRAM)) {
        pentagram(transcript, &star);
    }
}

fn concave<R: Real>(transcript: &mut Transcript, star: &Polygon<R>) {
    let rows = OF_THE_STAR.map(|(point, what)| {
        let work = even_odd(star.outline(), point.map(R::from));
        let naively = count_naively(star.outline(), work.point);
        let printed = inside(is_inside_as_printed(&work));
        let mut row = place(point, what);
        row.extend([
            crossed(&work),
            count(&work, work.crossings.len()),
            Value::text(inside(work.is_inside())),
        ]);
        row.extend([unless_on_side(&work, printed.to_string()), count(&work, naively)]);
        row
    });
    let columns =
        ["x", "", "s(t) crosses, at t", "crossed", "odd is inside", "as printed", "naively crossed"];
    let section =
        transcript.section("A star with ten corners: how many sides does s(t) cross?", "CSC418 11.3.2");
    section
        .step("corners", "p̄1 … p̄10", corners(&star::CONCAVE))
        .table(&columns, rows.to_vec())
        .remark("s(t) = x + t (1, 0), t > 0. As printed, an even number is inside: upside down, for far away it is 0.")
        .remark("A side has its lower end and not its upper one, so a corner is crossed once, or twice, or not at all, as it should be.")
        .remark("Naively, with both ends, a corner on s counts for both its sides. On which side x is of a side is decided exactly.");
}

fn pentagram<R: Real>(transcript: &mut Transcript, star: &Polygon<R>) {
    let rows = OF_THE_PENTAGRAM.map(|(point, what)| {
        let work = even_odd(star.outline(), point.map(R::from));
        let around = winding(star.outline(), work.point);
        let mut row = place(point, what);
        row.extend([
            crossed(&work),
            count(&work, work.crossings.len()),
            Value::text(inside(work.is_inside())),
        ]);
        row.extend([count(&work, around.number), Value::text(inside(around.is_inside()))]);
        row
    });
    let columns = ["x", "", "s(t) crosses, at t", "crossed", "odd is inside", "winding", "≠ 0 is inside"];
    let section = transcript.section("A pentagram overlaps itself: the rules differ", "CSC418 11.3.2");
    section
        .step("corners", "p̄1 … p̄5", corners(&star::PENTAGRAM))
        .table(&columns, rows.to_vec())
        .remark("The winding number: how many sides go up (↑) across s(t), less those that go down (↓).");
}

fn corners(star: &[[f32; 2]]) -> Value {
    Value::Array(star.iter().map(|corner| Value::Array(corner.map(Value::F32).to_vec())).collect())
}

fn place(point: [f32; 2], what: &str) -> Vec<Value> {
    vec![Value::Array(point.map(Value::F32).to_vec()), Value::text(what)]
}

/// "p̄8p̄9 ↑ 4, …", or that the point is on a side.
fn crossed<R: Real>(work: &EvenOdd<R>) -> Value {
    let corner = |side: usize| side + 1;
    if let Some(side) = work.on_side {
        return Value::text(format!("x is on the side from p̄{}", corner(side)));
    }
    let crossing = |crossing: &Crossing<R>| {
        let arrow = match crossing.way {
            Way::Up => '↑',
            Way::Down => '↓',
        };
        format!("from p̄{} {arrow} {}", corner(crossing.side), Value::number(crossing.t).to_text())
    };
    let crossings: Vec<String> = work.crossings.iter().map(crossing).collect();
    Value::text(if crossings.is_empty() { "none".to_string() } else { crossings.join(", ") })
}

fn inside(is_inside: bool) -> &'static str {
    if is_inside { "inside" } else { "outside" }
}

fn count<R: Real>(work: &EvenOdd<R>, count: impl ToString) -> Value {
    unless_on_side(work, count.to_string().replace('-', "−"))
}

/// On the boundary there is nothing to count.
fn unless_on_side<R: Real>(work: &EvenOdd<R>, text: String) -> Value {
    Value::text(if work.on_side.is_some() { String::new() } else { text })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The names in the table against the corners they name.
    #[test]
    fn the_places_are_what_they_are_said_to_be() {
        let level = |name: usize| star::CONCAVE[name - 1][1];
        assert_eq!((level(8), level(10), level(9), level(1)), (-1.0, 3.0, 3.0, 10.0));
        let star = Polygon::<f64>::new(star::in_space::<f64>(&star::CONCAVE)).unwrap();
        let on_side = |point: [f32; 2]| even_odd(star.outline(), point.map(f64::from)).on_side;
        assert_eq!(on_side(OF_THE_STAR[6].0), Some(1), "from p̄2 to p̄3");
        assert_eq!(star::PENTAGRAM[0], OF_THE_PENTAGRAM[3].0);
    }
}

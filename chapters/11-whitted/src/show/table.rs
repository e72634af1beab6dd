//! The tree of rays as two tables: where each went, and what it brought.

use math::Real;
use stage::{Section, Transcript, Value};

use super::{ROWS, Shot, rgb, whole};
use crate::tree::Node;

/// A ray's place in the tree, as the tables and the headings call it.
fn number(place: usize) -> Value {
    whole(place as u64 + 1)
}

/// Where each ray went.
pub(super) fn rays<R: Real>(transcript: &mut Transcript, shot: &Shot<'_, R>) {
    let nodes = &shot.tree.nodes;
    let mut parents = vec![None; nodes.len()];
    for (place, node) in nodes.iter().enumerate() {
        node.children.iter().for_each(|&child| parents[child] = Some(place));
    }
    let row = |(place, node): (usize, &Node<R>)| {
        let (object, lambda) = match &node.landed {
            Some(landed) => (shot.names.object(landed.object), Value::number(landed.lambda)),
            None => ("none: the background", Value::text("none")),
        };
        let sent_on: Vec<String> = node.children.iter().map(|child| (child + 1).to_string()).collect();
        vec![
            number(place),
            parents[place].map_or(Value::text("the eye"), number),
            Value::text(node.sent.kind.name()),
            whole(node.sent.depth.into()),
            lambda,
            Value::text(object),
            Value::text(if sent_on.is_empty() { "none".to_string() } else { sent_on.join(", ") }),
        ]
    };
    let rows = nodes.iter().enumerate().map(row).collect();
    let section = transcript.section("The tree of its rays", "CSC418 11.7");
    section
        .table(&["ray", "sent from", "kind", "depth", "λ*", "object", "sends on"], rows)
        .rows_in_text(ROWS);
    say_what_is_left_out(section, shot);
}

/// What each ray brought.
pub(super) fn sums<R: Real>(transcript: &mut Transcript, shot: &Shot<'_, R>) {
    let row = |(place, node): (usize, &Node<R>)| {
        let own = node.landed.as_ref().map_or(node.e, |landed| landed.local);
        let weight = Value::number(node.weight);
        vec![number(place), weight, rgb(own), rgb(shot.tree.contribution(node))]
    };
    let rows = shot.tree.nodes.iter().enumerate().map(row).collect();
    let section = transcript.section("What they bring", "CSC418 11.7");
    section.table(&["ray", "w", "I", "w I"], rows).rows_in_text(ROWS);
    section
        .remark("w: the product of the coefficients from the eye on. I: the local term, or the background.");
    say_what_is_left_out(section, shot);
}

fn say_what_is_left_out<R: Real>(section: &mut Section, shot: &Shot<'_, R>) {
    let more = shot.tree.nodes.len().saturating_sub(ROWS);
    if more > 0 {
        section.remark(format!(
            "{more} more rays are in the table that --format json prints; Σ w I has them all."
        ));
    }
}

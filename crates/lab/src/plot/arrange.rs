//! Which place each label takes, so that all of them together cost the least.
//!
//! Every label takes its cheapest place in turn, then again, knowing where the others went, until none
//! moves; then two at a time make room for each other. That is done from a few starts, and the cheapest
//! arrangement wins: not the best of all, but a good one, and always the same one.

use super::extent::do_cross;
use super::labels::Label;

/// One of the places of each label, in their order. A label without a place to choose from is left out.
pub(super) fn arrange(mut choices: Vec<Vec<Label>>) -> Vec<Label> {
    choices.retain(|choices| !choices.is_empty());
    for choices in &mut choices {
        // the cheapest first, so that the search can stop early
        choices.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    }
    let arrangements = (0..STARTS).map(|start| {
        let mut chosen: Vec<Option<Label>> = vec![None; choices.len()];
        settle(&choices, &mut chosen, start);
        make_room(&choices, &mut chosen);
        let labels: Vec<Label> = chosen.into_iter().flatten().collect();
        (total_cost(&labels), labels)
    });
    arrangements.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, labels)| labels).unwrap_or_default()
}

const STARTS: usize = 8;
/// More rounds than it takes for any label to stop moving.
const ROUNDS: usize = 12;

/// Every label takes its cheapest place, one after another, until none moves. The first one depends on
/// `start`.
fn settle(choices: &[Vec<Label>], chosen: &mut [Option<Label>], start: usize) {
    let count = choices.len();
    for _ in 0..ROUNDS {
        let before = chosen.to_vec();
        for step in 0..count {
            // forward from one start, backward from the next
            let i = if start.is_multiple_of(2) { start + step } else { start + 2 * count - step } % count;
            chosen[i] = None;
            chosen[i] = Some(cheapest(&choices[i], chosen));
        }
        if chosen == before {
            break;
        }
    }
}

/// Every two labels: the one gives way, the other takes the best place, the first one what is left; kept
/// where that is cheaper for both together.
fn make_room(choices: &[Vec<Label>], chosen: &mut [Option<Label>]) {
    for _ in 0..ROUNDS {
        let mut has_moved = false;
        for i in 0..choices.len() {
            for j in (0..choices.len()).filter(|&j| j != i) {
                let before = (chosen[i], chosen[j], cost_of_two(chosen, i, j));
                (chosen[i], chosen[j]) = (None, None);
                chosen[j] = Some(cheapest(&choices[j], chosen));
                chosen[i] = Some(cheapest(&choices[i], chosen));
                if cost_of_two(chosen, i, j) < before.2 - 1e-6 {
                    has_moved = true;
                } else {
                    (chosen[i], chosen[j]) = (before.0, before.1);
                }
            }
        }
        if !has_moved {
            break;
        }
    }
}

/// The cheapest of the places, which are sorted by what they cost by themselves.
fn cheapest(choices: &[Label], chosen: &[Option<Label>]) -> Label {
    let (mut best, mut least) = (choices[0], f64::INFINITY);
    for label in choices {
        if label.cost >= least {
            break;
        }
        let cost = label.cost + cost_among(label, chosen);
        if cost < least {
            (best, least) = (*label, cost);
        }
    }
    best
}

fn cost_among(label: &Label, chosen: &[Option<Label>]) -> f64 {
    chosen.iter().flatten().map(|other| mutual_cost(label, other)).sum()
}

/// What the labels i and j cost, by themselves and among the others.
fn cost_of_two(chosen: &[Option<Label>], i: usize, j: usize) -> f64 {
    let (Some(first), Some(second)) = (chosen[i], chosen[j]) else { return f64::INFINITY };
    let others =
        (0..chosen.len()).filter(|&other| other != i && other != j).filter_map(|other| chosen[other]);
    let among = others.map(|other| mutual_cost(&first, &other) + mutual_cost(&second, &other)).sum::<f64>();
    first.cost + second.cost + mutual_cost(&first, &second) + among
}

fn total_cost(labels: &[Label]) -> f64 {
    let mutual = |i: usize| labels[..i].iter().map(|other| mutual_cost(&labels[i], other)).sum::<f64>();
    (0..labels.len()).map(|i| labels[i].cost + mutual(i)).sum()
}

/// What two labels cost each other.
fn mutual_cost(a: &Label, b: &Label) -> f64 {
    let mut cost = 0.0;
    let overlap = a.extent.inset(-0.5).overlap(&b.extent);
    if overlap > 0.0 {
        cost += 400.0 + overlap;
    }
    for (label, other) in [(a, b), (b, a)] {
        if label.leader.is_some_and(|leader| other.extent.inset(-1.0).is_crossed(leader)) {
            cost += 200.0;
        }
    }
    if let (Some(first), Some(second)) = (a.leader, b.leader)
        && do_cross(first, second)
    {
        cost += 120.0;
    }
    cost
}

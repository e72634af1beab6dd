//! From two children a node to eight.
//!
//! A node of eight could take the grandchildren of a binary one, or open its largest child again and again.
//! Which is best depends on what is below, and can be had exactly: from the leaves up, for each binary node
//! and each number of places from one to eight, the least cost of putting all that is in it there. In one
//! place it is a leaf or a node of eight of its own; in several, its two children share them. (Ylitie, Karras
//! and Laine 2017, for trees of compressed boxes.)

use super::node::{Child, LANES, Node};
use crate::tree::Tree;

/// What a search pays, in openings of a node of eight.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Prices {
    /// To look into a leaf.
    pub(crate) leaf: f32,
    /// For each object in it.
    pub(crate) object: f32,
    /// The largest leaf.
    pub(crate) most: usize,
}

impl Prices {
    /// For objects that are tested one after the other.
    pub(crate) const ONE_BY_ONE: Prices = Prices { leaf: 0.0, object: 0.5, most: LANES };
    /// For blocks of triangles that are tested at once.
    pub(crate) const BLOCKS: Prices = Prices { leaf: 1.0, object: 0.05, most: LANES };
}

/// How to put a binary node, with all that is below it, into some places of a node of eight.
#[derive(Clone, Copy)]
struct Plan {
    /// What it costs at least in i + 1 places.
    cost: [f32; LANES],
    /// How many of the i + 1 places are worth taking. In one of them the node is by itself.
    taken: [u8; LANES],
    /// If all i + 1 are taken, how many the left child gets.
    left: [u8; LANES],
    /// Whether by itself it is a leaf.
    is_leaf: bool,
    /// Its objects: the first, and how many.
    objects: (u32, u32),
}

/// Plans for all nodes, in their order. A child comes after its parent, so they are made from the last to the
/// first.
fn plans(tree: &Tree, prices: Prices) -> Vec<Plan> {
    let none =
        Plan { cost: [0.0; LANES], taken: [1; LANES], left: [0; LANES], is_leaf: true, objects: (0, 0) };
    let mut plans = vec![none; tree.nodes.len()];
    for (at, node) in tree.nodes.iter().enumerate().rev() {
        let area = node.bounds.half_area() as f32;
        let as_leaf = |count: u32| area * (prices.leaf + prices.object * count as f32);
        if node.count > 0 {
            plans[at].cost = [as_leaf(node.count); LANES];
            plans[at].objects = (node.first, node.count);
            continue;
        }
        let [left, right] = [0, 1].map(|child| plans[node.first as usize + child]);
        let plan = &mut plans[at];
        plan.objects = (left.objects.0, left.objects.1 + right.objects.1);
        // all of i + 1 places shared
        let mut shared = [f32::INFINITY; LANES];
        for (i, shared) in shared.iter_mut().enumerate().skip(1) {
            for for_left in 0..i {
                let cost = left.cost[for_left] + right.cost[i - 1 - for_left];
                if cost < *shared || plan.left[i] == 0 {
                    (*shared, plan.left[i]) = (cost, for_left as u8 + 1);
                }
            }
        }
        let as_node = area + shared[LANES - 1];
        let count = plan.objects.1;
        plan.is_leaf = count as usize <= prices.most && as_leaf(count) <= as_node;
        plan.cost[0] = if plan.is_leaf { as_leaf(count) } else { as_node };
        for (i, &shared) in shared.iter().enumerate().skip(1) {
            let all = shared < plan.cost[i - 1];
            plan.cost[i] = if all { shared } else { plan.cost[i - 1] };
            plan.taken[i] = if all { i as u8 + 1 } else { plan.taken[i - 1] };
        }
    }
    plans
}

/// The nodes, the root first.
pub(crate) fn collapse(tree: &Tree, prices: Prices) -> Vec<Node> {
    let plans = plans(tree, prices);
    let mut nodes = Vec::new();
    let mut todo = Vec::new();
    if let Some(root) = tree.nodes.first() {
        nodes.push(Node::empty());
        if plans[0].is_leaf {
            nodes[0] = Node::of(&mut [(root.bounds, leaf(&plans[0]))]);
        } else {
            todo.push((0, 0));
        }
    }
    let mut children = Vec::with_capacity(LANES);
    while let Some((binary, wide)) = todo.pop() {
        children.clear();
        // the binary node's children share all places; so do theirs what they got, as planned
        let mut open = [(binary, LANES, true); LANES];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let (at, places, must_share) = open[count];
            let plan = &plans[at];
            let taken = if must_share { LANES } else { plan.taken[places - 1] as usize };
            let node = &tree.nodes[at];
            if taken > 1 {
                let left = plan.left[taken - 1] as usize;
                let first = node.first as usize;
                open[count] = (first + 1, taken - left, false);
                open[count + 1] = (first, left, false);
                count += 2;
            } else if plan.is_leaf {
                children.push((node.bounds, leaf(plan)));
            } else {
                let child = nodes.len();
                nodes.push(Node::empty());
                children.push((node.bounds, Child::node(child)));
                todo.push((at, child));
            }
        }
        nodes[wide] = Node::of(&mut children);
    }
    nodes
}

fn leaf(plan: &Plan) -> Child {
    Child::leaf(plan.objects.0 as usize, plan.objects.1 as usize)
}

/// How many children wait at the same time at most, in the order that is worst.
pub(crate) fn most_waiting(nodes: &[Node]) -> usize {
    let mut most = vec![0; nodes.len()];
    for (at, node) in nodes.iter().enumerate().rev() {
        let children = &node.children[..node.count as usize];
        let below =
            children.iter().filter(|child| !child.is_leaf()).map(|child| most[child.0 as usize]).max();
        most[at] = (node.count as usize).max(below.map_or(0, |below| below + node.count as usize - 1));
    }
    most.first().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::super::search::Stack;
    use super::*;
    use crate::Box3;

    /// By hand: below eight children, one of which is a node with three, at worst the other seven wait while its three do.
    #[test]
    fn at_worst_all_but_the_last_wait_on_each_level() {
        let point = Box3 { low: [0.0; 3], high: [0.0; 3] };
        let node = |leaves: usize, below: Option<usize>| {
            let leaves = (0..leaves).map(|first| Child::leaf(first, 1));
            let children: Vec<Child> = leaves.chain(below.map(Child::node)).collect();
            Node::of(&mut children.into_iter().map(|child| (point, child)).collect::<Vec<_>>())
        };
        assert_eq!(most_waiting(&[]), 0);
        assert_eq!(most_waiting(&[node(5, None)]), 5);
        assert_eq!(most_waiting(&[node(7, Some(1)), node(3, None)]), 10);
        assert_eq!(most_waiting(&[node(7, Some(1)), node(0, Some(2)), node(1, None)]), 8);
        // eight levels of seven, and eight more below: 64
        let deep = |levels: usize| {
            let above = (1..=levels).map(|below| node(7, Some(below)));
            above.chain([node(8, None)]).collect::<Vec<Node>>()
        };
        assert_eq!((most_waiting(&deep(8)), Stack::of(&deep(8))), (64, Stack::Few));
        assert_eq!((most_waiting(&deep(9)), Stack::of(&deep(9))), (71, Stack::Many));
    }
}

//! The tree of all rays of a pixel, down to the last term.

use bounds::Tally;
use math::Real;
use shading::lighting::Point;
use shading::{Fate, Rgb};

use crate::{Counts, Kind, Media, Refraction, Sent, Witness};

/// A ray, what it saw, and the rays that were sent from there.
#[derive(Clone, Debug)]
pub struct Node<R: Real> {
    /// Why it was sent, from where, and what it is multiplied by.
    pub sent: Sent<R>,
    /// The product of the coefficients on the way from the eye.
    pub weight: f64,
    /// Where it landed; `None` where it saw the background.
    pub landed: Option<Landed<R>>,
    /// What it saw.
    pub e: Rgb,
    /// The rays that were sent on: places in the tree.
    pub children: Vec<usize>,
    /// The rays that were not: why they would have been sent, and how much of the pixel's radiance they could
    /// have brought at most.
    pub left_out: Vec<(Kind, f64)>,
}

/// Where a ray landed.
#[derive(Clone, Debug)]
pub struct Landed<R: Real> {
    /// The object's place in the scene.
    pub object: usize,
    /// λ, in lengths of the ray's direction.
    pub lambda: R,
    /// What the shading knows; `None` where p̄ is too far away to be a number.
    pub point: Option<Point<R>>,
    /// What became of each light, with its place in the scene.
    pub lights: Vec<(usize, Fate<R>)>,
    /// The local term.
    pub local: Rgb,
    /// How light goes through, where it does; with `Some(true)` where it enters a solid, `Some(false)` where
    /// it leaves it, and `None` for what is no solid.
    pub refraction: Option<(Refraction<R>, Option<bool>)>,
    /// The solids that the ray is in before it goes through and after, the outermost first; none where it does not.
    pub media: Vec<Vec<usize>>,
}

/// The rays in the order in which they were sent, the eye ray first.
#[derive(Clone, Debug)]
pub struct Tree<R: Real> {
    /// The first [`Tree::MOST`] rays.
    pub nodes: Vec<Node<R>>,
    /// All rays, counted.
    pub counts: Counts,
    /// What all rays add to the pixel together, see [`Tree::contribution`], in the order in which they end.
    pub sum: Rgb,
    /// Those that have not ended, the deepest last.
    open: Vec<Open>,
}

/// A ray that has not ended.
#[derive(Clone, Copy, Debug)]
struct Open {
    /// Its place in the tree; `None` where there are too many.
    place: Option<usize>,
    weight: f64,
    has_landed: bool,
}

impl<R: Real> Tree<R> {
    /// So many rays are kept, the others counted and added up: a mirror of glass in a glass doubles its rays with every
    /// level, and no reader wants them all.
    pub const MOST: usize = 1 << 13;

    /// No ray yet.
    pub fn new() -> Tree<R> {
        Tree { nodes: Vec::new(), counts: Counts::default(), sum: Rgb::BLACK, open: Vec::new() }
    }

    /// What a ray adds to the pixel by itself: its weight times what it sees without the rays that were sent on.
    pub fn contribution(&self, node: &Node<R>) -> Rgb {
        node.landed.as_ref().map_or(node.e, |landed| landed.local) * node.weight
    }

    fn node(&mut self) -> Option<&mut Node<R>> {
        let place = self.open.last()?.place?;
        self.nodes.get_mut(place)
    }

    fn landing(&mut self) -> Option<&mut Landed<R>> {
        self.node()?.landed.as_mut()
    }
}

impl<R: Real> Default for Tree<R> {
    fn default() -> Tree<R> {
        Tree::new()
    }
}

impl<R: Real> Tally for Tree<R> {
    fn boxes(&mut self, more: usize) {
        self.counts.boxes(more);
    }
    fn tests(&mut self, more: usize) {
        self.counts.tests(more);
    }
    fn hit(&mut self) {
        self.counts.hit();
    }
}

impl<R: Real> Witness<R> for Tree<R> {
    const WANTS_LANDINGS: bool = true;

    fn sent(&mut self, sent: &Sent<R>) {
        self.counts.sent(sent);
        let weight = self.open.last().map_or(1.0, |parent| parent.weight) * sent.coefficient;
        let place = (self.nodes.len() < Self::MOST).then_some(self.nodes.len());
        if let Some(place) = place {
            if let Some(parent) = self.node() {
                parent.children.push(place);
            }
            let (children, left_out) = (Vec::new(), Vec::new());
            self.nodes.push(Node { sent: *sent, weight, landed: None, e: Rgb::BLACK, children, left_out });
        }
        self.open.push(Open { place, weight, has_landed: false });
    }

    fn shadow_rays(&mut self, more: u64) {
        Witness::<R>::shadow_rays(&mut self.counts, more);
    }

    fn landed(&mut self, object: usize, lambda: R, point: Option<&Point<R>>) {
        if let Some(open) = self.open.last_mut() {
            open.has_landed = true;
        }
        if let Some(node) = self.node() {
            let (point, lights, media) = (point.copied(), Vec::new(), Vec::new());
            let (local, refraction) = (Rgb::BLACK, None);
            node.landed = Some(Landed { object, lambda, point, lights, local, refraction, media });
        }
    }

    fn light(&mut self, light: usize, fate: &Fate<R>) {
        if let Some(landed) = self.landing() {
            landed.lights.push((light, *fate));
        }
    }

    fn local(&mut self, e: Rgb) {
        if let Some(open) = self.open.last() {
            self.sum += e * open.weight;
        }
        if let Some(landed) = self.landing() {
            landed.local = e;
        }
    }

    fn media(&mut self, media: &Media) {
        if let Some(landed) = self.landing() {
            landed.media.push(media.solids().to_vec());
        }
    }

    fn refraction(&mut self, refraction: &Refraction<R>, solid: Option<bool>) {
        if let Some(landed) = self.landing() {
            landed.refraction = Some((*refraction, solid));
        }
    }

    fn left_out(&mut self, kind: Kind, at_most: f64) {
        Witness::<R>::left_out(&mut self.counts, kind, at_most);
        if let Some(node) = self.node() {
            node.left_out.push((kind, at_most));
        }
    }

    fn ends(&mut self, e: Rgb) {
        if let Some(node) = self.node() {
            node.e = e;
        }
        if let Some(open) = self.open.pop()
            && !open.has_landed
        {
            self.sum += e * open.weight;
        }
    }
}

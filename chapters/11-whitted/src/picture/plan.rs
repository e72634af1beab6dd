//! The rays of any pixel from above, as the inspector draws them: over one ground, which all pixels share.

use bounds::Parts;
use math::{Ray3, Real, Span};
use shading::Fate;
use stage::{Ink, Sketch};

use super::above::From;
use super::least_first;
use super::outlines::Outline;
use crate::show::{Names, ROWS};
use crate::tree::Node;
use crate::{Kind, Scene, Tree};

/// What is seen from above: from the lower left corner to the upper right one.
pub(crate) struct Plan {
    seen: From,
}

impl Plan {
    /// So that the eye and all that has an extent are seen.
    pub(crate) fn new<R: Real>(scene: &Scene<R>, parts: &Parts<'_, R>) -> Plan {
        // the frame of a sketch
        let (width, height) = stage::SKETCH;
        Plan { seen: From::new(scene, parts, (0.0, 0.0), (width as f32, height as f32)) }
    }

    fn sketch(&self) -> Sketch {
        let [low, high] = self.seen.corners;
        Sketch::new(low, high)
    }
}

/// A scene from above.
pub(crate) struct Above<'a, R: Real> {
    pub(crate) scene: &'a Scene<R>,
    pub(crate) parts: &'a Parts<'a, R>,
    pub(crate) names: &'a Names,
    pub(crate) plan: &'a Plan,
}

impl<R: Real> Above<'_, R> {
    /// The objects, the lowest first, with the names of their materials, and the kinds of rays.
    pub(crate) fn ground(&self) -> String {
        let (mut sketch, seen) = (self.plan.sketch(), &self.plan.seen);
        let mut named = Vec::new();
        for object in seen.lowest_first(self.scene, self.parts) {
            let below = match seen.outline(self.scene, self.parts, object) {
                Some(Outline::Circle(place, r)) => {
                    sketch.circle(place, r, Ink::Object);
                    (place.0, place.1 - r)
                }
                Some(Outline::Around(corners)) => {
                    sketch.outline(&corners, Ink::Object);
                    corners.into_iter().fold((0.0, f64::INFINITY), |a, b| if b.1 < a.1 { b } else { a })
                }
                None => continue,
            };
            let name = self.names.material(self.scene.lit.painted[object].material);
            // of many objects of a material one is named
            if !named.iter().any(|(other, _)| *other == name) {
                named.push((name, below));
            }
        }
        for (name, below) in named {
            // what is in something else is named below that
            let _ = [9.0, 24.0]
                .iter()
                .any(|&down| sketch.label_where_free(below, (0.0, down), Ink::Object, name));
        }
        let kinds = [
            (Ink::Ray, "eye"),
            (Ink::Mirror, "mirror"),
            (Ink::Refracted, "refracted"),
            (Ink::Shadow, "to a light"),
        ];
        for (place, (ink, name)) in (0_u8..).zip(kinds) {
            sketch.caption((10.0, 18.0 + 16.0 * f64::from(place)), ink, name);
        }
        sketch.into_svg()
    }

    /// The rays of a tree, the heaviest on top.
    pub(crate) fn rays(&self, tree: &Tree<R>) -> String {
        let mut sketch = self.plan.sketch();
        let places: Vec<usize> = least_first(tree).into_iter().filter(|&place| place < ROWS).collect();
        for &place in &places {
            self.shadow_rays(&mut sketch, &tree.nodes[place]);
        }
        let drawn = places.iter().filter_map(|&place| {
            let node = &tree.nodes[place];
            let (start, end) = self.plan.seen.stretch(node)?;
            sketch.arrow(start, end, ink_of(node.sent.kind), node.weight);
            Some((place, node.sent.kind, ((start.0 + end.0) / 2.0, (start.1 + end.1) / 2.0)))
        });
        let middles: Vec<_> = drawn.collect();
        // where there is no room for all numbers, the heaviest rays have theirs
        for (place, kind, middle) in middles.into_iter().rev() {
            sketch.label_where_free(middle, (0.0, -9.0), ink_of(kind), &(place + 1).to_string());
        }
        if let Some(eye) = tree.nodes.first() {
            sketch.dot(self.plan.seen.place(eye.sent.ray.origin), Ink::Ray);
        }
        sketch.into_svg()
    }

    /// To the lights that are seen, and to what stands before the others.
    fn shadow_rays(&self, sketch: &mut Sketch, node: &Node<R>) {
        let Some(landed) = &node.landed else { return };
        let Some(point) = &landed.point else { return };
        let from = point.landing.point;
        for (light, fate) in &landed.lights {
            let to_light = self.scene.lit.lights[*light].position - from;
            let share = match fate {
                Fate::Seen(_) => R::from(1.0),
                Fate::Shadowed(part) => {
                    let span = Span::new(R::SMALLEST, R::from(1.0));
                    self.parts.hit(*part, &Ray3::new(from, to_light), span).unwrap_or(R::from(0.0))
                }
                Fate::Behind | Fate::Unanswered => continue,
            };
            let (start, end) = (self.plan.seen.place(from), self.plan.seen.place(from + to_light * share));
            sketch.line(start, end, Ink::Shadow);
            if matches!(fate, Fate::Shadowed(_)) {
                sketch.dot(end, Ink::Shadow);
            }
        }
    }
}

/// How a kind of ray is drawn.
fn ink_of(kind: Kind) -> Ink {
    match kind {
        Kind::Eye => Ink::Ray,
        Kind::Mirror => Ink::Mirror,
        Kind::Refracted => Ink::Refracted,
    }
}

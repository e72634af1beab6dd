//! What objects look like from above.

use bounds::Parts;
use math::Real;
use signature::Shape;
use stage::{Anchor, Canvas, Color, Pen};

use super::LETTERS;
use super::above::{From, Place};
use crate::Scene;
use crate::show::Shot;

/// What an object looks like from above.
pub(super) enum Outline {
    /// A center and a radius.
    Circle(Place, f64),
    /// Corners.
    Around(Vec<Place>),
}

impl From {
    /// A sphere's circle; of another solid or a mesh what its box covers; nothing for what is flat, as a
    /// floor would be larger than all that stands on it.
    pub(super) fn outline<R: Real>(
        &self,
        scene: &Scene<R>,
        parts: &Parts<'_, R>,
        object: usize,
    ) -> Option<Outline> {
        match &scene.lit.geometry.objects[object].shape {
            Shape::Sphere(sphere) => {
                return Some(Outline::Circle(self.place(sphere.center), sphere.radius.into()));
            }
            Shape::Plane(_) | Shape::Triangle(_) | Shape::Polygon(_) => return None,
            _ => {}
        }
        let bounds = parts.object_bounds(object)?;
        let corner = |which: usize, axis: usize| {
            if which >> axis & 1 == 0 { bounds.low[axis] } else { bounds.high[axis] }
        };
        let corners = (0..8).map(|which| self.place_of([0, 1, 2].map(|axis| f64::from(corner(which, axis)))));
        Some(Outline::Around(hull(corners.collect())))
    }

    /// The places of the objects in the scene, the lowest first.
    pub(super) fn lowest_first<R: Real>(&self, scene: &Scene<R>, parts: &Parts<'_, R>) -> Vec<usize> {
        let height = |object: usize| {
            let bounds = parts.object_bounds(object);
            let middle = bounds.map(|it| [0, 1, 2].map(|i| f64::from(it.low[i] + it.high[i])));
            middle.map_or(f64::NEG_INFINITY, |middle| (0..3).map(|i| middle[i] * self.v[i]).sum::<f64>())
        };
        let mut objects: Vec<usize> = (0..scene.lit.geometry.objects.len()).collect();
        objects.sort_by(|&a, &b| height(a).total_cmp(&height(b)));
        objects
    }

    /// The objects, the lowest first, each in a pale tone of its color.
    pub(super) fn objects<R: Real>(&self, canvas: &mut Canvas, shot: &Shot<'_, R>) {
        let lit = &shot.scene.lit;
        for object in self.lowest_first(shot.scene, shot.parts) {
            let material = lit.painted[object].material;
            let pale = lit.materials[material].color * 0.3;
            let fill = Color::from_linear(pale.0.map(|channel| channel + 0.6));
            let rim = Pen::solid(Color::GRAY, 1.2);
            match self.outline(shot.scene, shot.parts, object) {
                Some(Outline::Circle(place, r)) => {
                    canvas.disc(self.view.at(place), self.view.length(r), fill);
                    canvas.circle(self.view.at(place), self.view.length(r), rim);
                }
                Some(Outline::Around(places)) => {
                    let points: Vec<(f32, f32)> = places.iter().map(|&place| self.view.at(place)).collect();
                    canvas.area(&points, fill);
                    for (at, &point) in points.iter().enumerate() {
                        canvas.line(point, points[(at + 1) % points.len()], rim);
                    }
                }
                None => {}
            }
        }
    }

    /// The materials' names, below the objects, where there is room.
    pub(super) fn names<R: Real>(&self, canvas: &mut Canvas, shot: &Shot<'_, R>) {
        let lit = &shot.scene.lit;
        let mut taken: Vec<(f32, f32, &str)> = Vec::new();
        for object in 0..lit.geometry.objects.len() {
            let place = match self.outline(shot.scene, shot.parts, object) {
                Some(Outline::Circle((x, y), r)) => (x, y - r),
                Some(Outline::Around(places)) => {
                    let lower = |a: Place, b: Place| if b.1 < a.1 { b } else { a };
                    places.into_iter().fold((0.0, f64::INFINITY), lower)
                }
                None => continue,
            };
            let (x, y) = self.view.at(place);
            let name = shot.names.material(lit.painted[object].material);
            // what is in something else is named below that
            for y in [y + LETTERS, y + 2.2 * LETTERS] {
                let is_near = |other: &&(f32, f32, &str)| {
                    (x - other.0).abs() < 4.0 * LETTERS && (y - other.1).abs() < LETTERS
                };
                match taken.iter().find(is_near) {
                    None => {
                        taken.push((x, y, name));
                        canvas.label((x, y), Anchor::Middle, LETTERS, Color::GRAY, name);
                        break;
                    }
                    Some(other) if other.2 == name => break,
                    Some(_) => {}
                }
            }
        }
    }
}

/// The corners of the smallest convex area around places (Andrew's monotone chain).
fn hull(mut places: Vec<Place>) -> Vec<Place> {
    places.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let half = |places: &mut dyn Iterator<Item = &Place>| {
        let mut chain: Vec<Place> = Vec::new();
        for &(x, y) in places {
            while let [.., (ax, ay), (bx, by)] = chain[..]
                && (bx - ax) * (y - ay) <= (by - ay) * (x - ax)
            {
                chain.pop();
            }
            chain.push((x, y));
        }
        chain.pop();
        chain
    };
    let mut all = half(&mut places.iter());
    all.extend(half(&mut places.iter().rev()));
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hull_has_the_corners_only() {
        let places = [(0.0, 0.0), (1.0, 1.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (1.0, 0.0)];
        assert_eq!(hull(places.to_vec()), [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]);
    }
}

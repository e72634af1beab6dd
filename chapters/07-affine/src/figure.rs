//! The figure of the book: a sphere to squash, and a ray.

use math::{Degenerate, Ray3, Real, Span, Vector};
use stage::figure::{Figure, Handle, Place, at_z_0, first_steps, hit_in_words, moved, to_hundredths};
use stage::{Ink, Section, Sketch};

use crate::explain::explain;
use crate::scene::Placed;
use crate::{Affine, Deformed, Matrix3, Method, Object};

/// A sphere half as high as wide with its upper part pushed to the right, for the start.
pub struct Squashed {
    /// t⃗
    t: Place,
    /// t⃗ and the first column of A
    first: Place,
    /// t⃗ and the second column of A
    second: Place,
    a: Place,
    /// ā + d⃗
    tip: Place,
}

impl Default for Squashed {
    fn default() -> Squashed {
        Squashed { t: (0.0, 0.0), first: (1.0, 0.0), second: (0.5, 0.5), a: (-3.0, 1.0), tip: (-2.0, 0.75) }
    }
}

impl Squashed {
    fn ray<R: Real>(&self) -> Ray3<R> {
        let [a, tip] = [self.a, self.tip].map(at_z_0::<R>);
        Ray3::new(a, tip - a)
    }

    fn affine<R: Real>(&self) -> Affine<R> {
        let [t, first, second] = [self.t, self.first, self.second].map(at_z_0::<R>);
        let third = R::vec3(R::from(0.0), R::from(0.0), R::from(1.0));
        Affine { a: Matrix3 { columns: [first - t, second - t, third] }, t }
    }

    fn deformed<R: Real>(&self) -> Result<Deformed<R>, Degenerate> {
        Deformed::for_ray(&self.ray(), Object::Sphere, self.affine())
    }

    /// The deformed circle z = 0, from the rational points of a circle, which take no sine.
    fn outline(&self) -> Vec<Place> {
        let quarter = (0..16).map(|i| {
            let s = f64::from(i) / 16.0;
            ((1.0 - s * s) / (1.0 + s * s), 2.0 * s / (1.0 + s * s))
        });
        let mut circle: Vec<Place> = quarter.collect();
        for _ in 0..3 {
            let turned: Vec<Place> = circle[circle.len() - 16..].iter().map(|&(x, y)| (-y, x)).collect();
            circle.extend(turned);
        }
        let [e1, e2] = [self.first, self.second].map(|tip| (tip.0 - self.t.0, tip.1 - self.t.1));
        let deform = |(x, y): Place| (self.t.0 + x * e1.0 + y * e2.0, self.t.1 + x * e1.1 + y * e2.1);
        circle.into_iter().map(deform).collect()
    }
}

impl Figure for Squashed {
    const CAPTION: &'static str = "A cut at z = 0, x to the right and y upward. Drag where the sphere's x \
                                   axis and its y axis go, A e1 and A e2, where its center goes, t⃗, and \
                                   the ray. Squash it flat: A then has no inverse.";
    const FRAME: (Place, Place) = ((-4.0, -2.2), (4.0, 2.6));

    fn methods() -> Vec<&'static str> {
        Method::ALL.map(Method::name).to_vec()
    }

    fn handles(&self) -> Vec<Handle> {
        let names = ["t⃗", "t⃗ + A e1", "t⃗ + A e2", "ā", "ā + d⃗"];
        let places = [self.t, self.first, self.second, self.a, self.tip];
        names.into_iter().zip(places).map(|(name, place)| Handle { name, place }).collect()
    }

    fn drag(&mut self, handle: usize, to: Place) {
        let Some(Handle { place, .. }) = self.handles().into_iter().nth(handle) else { return };
        let (x, y) = to_hundredths(place, to);
        match handle {
            0 => {
                let [first, second] = [self.first, self.second].map(|tip| moved((self.t, tip), (x, y)).1);
                (self.t, self.first, self.second) = ((x, y), first, second);
            }
            1 => self.first = (x, y),
            2 => self.second = (x, y),
            3 => (self.a, self.tip) = moved((self.a, self.tip), (x, y)),
            4 => self.tip = (x, y),
            _ => {}
        }
    }

    fn draw(&self, sketch: &mut Sketch) {
        sketch.outline(&self.outline(), Ink::Object);
        sketch.line(self.t, self.first, Ink::Length).line(self.t, self.second, Ink::Length);
        let ray = self.ray::<f64>();
        let ahead = ray.at(1e3);
        sketch.line(self.a, (ahead.x(), ahead.y()), Ink::Ray).arrow(self.a, self.tip, Ink::Normal, 1.0);
        if let Ok(deformed) = self.deformed::<f64>()
            && let Ok(Some(hit)) = Method::Robust.work(&ray, &deformed).hit(Span::ahead())
        {
            let at = (hit.point.x(), hit.point.y());
            let tip = (at.0 + 0.8 * hit.normal.x(), at.1 + 0.8 * hit.normal.y());
            sketch.arrow(at, tip, Ink::Normal, 1.0).dot(at, Ink::Ray);
        }
        let asides = [(-4.0, 18.0), (36.0, 0.0), (0.0, -16.0), (0.0, -16.0), (0.0, -16.0)];
        for (handle, aside) in self.handles().into_iter().zip(asides) {
            sketch.label(handle.place, aside, Ink::Quiet, handle.name);
        }
    }

    fn steps<R: Real>(&self, method: usize) -> Result<Section, Degenerate> {
        let placed = Placed {
            name: "sphere",
            what: "as it is dragged",
            deformed: self.deformed::<R>()?,
            seen: [0.0; 3],
            foot: [0.0; 3],
            color: [230, 159, 0],
        };
        Ok(first_steps::<R>(|transcript| explain(transcript, Method::ALL[method], &self.ray(), &placed)))
    }

    fn answer<R: Real>(&self, method: usize) -> String {
        let hit =
            self.deformed::<R>().and_then(|it| Method::ALL[method].work(&self.ray(), &it).hit(Span::ahead()));
        hit_in_words(hit, "")
    }
}

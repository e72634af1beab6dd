//! A scene with one kind of bound around its objects.

use affine::{Affine, Matrix3};
use math::{Ray3, Real, Span};
use ray_sphere::{Sphere, robust};
use signature::{First, Hit3, Method as Formulas, Scene, Shape};

use crate::all::{All, try_all};
use crate::projected::{Extents, rectangle};
use crate::trial::{Trial, Tried};
use crate::wide::{Instructions, Spheres, Version};
use crate::{
    Box3, FirstPart, Found, Leaves, Method, Nearest, Parts, Query, Reach, Slabs, Tally, Tree, Wide,
    sphere_around,
};

/// A scene with its bounds, ready for rays. Whatever the bounds are, what a ray hits first is the same.
#[derive(Debug)]
pub struct Bounded<'a, R: Real> {
    scene: &'a Scene<R>,
    parts: Parts<'a, R>,
    /// The parts of objects that nothing bounds: planes. They are tried first, and what is nearer than their
    /// hit is all that is looked for then.
    unbounded: Vec<usize>,
    bounds: Bounds<R>,
    trial: Trial,
    /// A⁻¹ and t, through which each ray is carried before each test; `None` where that is not asked for.
    carried: Option<Affine<R>>,
}

/// What is around the objects.
#[derive(Debug)]
enum Bounds<R: Real> {
    /// Nothing: all parts, spheres four at a time and the rest one by one.
    None { spheres: Vec<Spheres>, rest: Vec<usize>, version: Version },
    /// A sphere around each object; without one it is tried by every ray.
    Spheres(Vec<(usize, Option<Sphere<R>>)>),
    /// A box around each object.
    Boxes(Vec<(usize, Box3)>),
    /// For each row of the picture the objects that may be seen in it.
    Extents(Extents),
    /// Boxes in boxes, around each part.
    Tree { tree: Tree, parts: Vec<usize> },
    /// The same, eight at a time. It knows the parts themselves.
    Wide(Wide),
}

impl<'a, R: Real> Bounded<'a, R> {
    /// Works the bounds out. [`Method::Auto`] takes those that [`Method::required`] says.
    pub fn new(scene: &'a Scene<R>, method: Method) -> Bounded<'a, R> {
        Bounded::by(Formulas::Robust, scene, method)
    }

    /// The same for shapes that are met by one or the other formulas.
    ///
    /// The notes' may say of a ray that it hits what it passes by, and a bound that is not met would hide
    /// that. So that what is seen does not depend on the bounds, such a hit counts only where the ray is in
    /// the part's own box: see [`mod@crate::trial`]. A sphere around a box, or the pixels in which it is
    /// seen, are asked for by other roundings than a box is: by the notes' formulas [`Method::Sphere`] and
    /// [`Method::Extents`] bound nothing.
    pub fn by(formulas: Formulas, scene: &'a Scene<R>, method: Method) -> Bounded<'a, R> {
        let parts = Parts::of(scene);
        let objects = 0..scene.objects.len();
        let boxed: Vec<(usize, Box3)> =
            objects.filter_map(|object| Some((object, parts.object_bounds(object)?))).collect();
        let is_unbounded =
            |object: &usize| boxed.binary_search_by_key(object, |(object, _)| *object).is_err();
        let unbounded = (0..scene.objects.len())
            .filter(is_unbounded)
            .flat_map(|object| parts.of_object(object))
            .collect();
        let part_boxes = || -> (Vec<usize>, Vec<Box3>) {
            (0..parts.count()).filter_map(|part| Some((part, parts.bounds(part)?))).unzip()
        };
        let method = match (formulas, method.or_required(parts.count())) {
            (Formulas::Notes, Method::Sphere | Method::Extents) => Method::None,
            (_, method) => method,
        };
        let bounds = match method {
            Method::None | Method::Auto => {
                // a ray that surely misses a sphere may hit it by the notes' formulas: those are asked one by
                // one
                let sphere = |part| match (formulas, parts.shape(part)) {
                    (Formulas::Robust, Shape::Sphere(sphere)) => Some(*sphere),
                    _ => None,
                };
                let (spheres, rest) = Spheres::blocks((0..parts.count()).map(|part| (part, sphere(part))));
                Bounds::None { spheres, rest, version: Version::of(Instructions::Best) }
            }
            Method::Sphere => {
                let around = |(object, bounds): (usize, Box3)| {
                    // a sphere is its own
                    let own = match &scene.objects[object].shape {
                        Shape::Sphere(sphere) => Some(*sphere),
                        _ => sphere_around(&bounds),
                    };
                    (object, own)
                };
                Bounds::Spheres(boxed.into_iter().map(around).collect())
            }
            Method::Box => Bounds::Boxes(boxed),
            Method::Extents => {
                let seen = |(object, bounds)| Some((object, rectangle(scene, &bounds)?));
                Bounds::Extents(Extents::new(scene.size.1, boxed.into_iter().filter_map(seen)))
            }
            Method::Tree => {
                let (parts, boxes) = part_boxes();
                Bounds::Tree { tree: Tree::build(&boxes), parts }
            }
            Method::Wide => {
                let (parts, boxes) = part_boxes();
                Bounds::Wide(Wide::build(&boxes).naming(&parts))
            }
        };
        let trial = Trial::of(formulas, &parts);
        Bounded { scene, parts, unbounded, bounds, trial, carried: None }
    }

    /// The same for a program in which any object may be deformed: each ray is carried into a space of each
    /// part's own, before it is tried on it, though the matrix is the identity. What is seen is the same. For
    /// who wants to know what that costs.
    pub fn carrying(self) -> Bounded<'a, R> {
        let identity =
            Affine { a: Matrix3::identity(), t: R::vec3(R::from(0.0), R::from(0.0), R::from(0.0)) };
        Bounded { carried: Some(identity), ..self }
    }

    /// How many things there are to test: objects, and of a mesh its faces.
    pub fn parts(&self) -> usize {
        self.parts.count()
    }

    /// What is tested.
    pub fn all_parts(&self) -> &Parts<'a, R> {
        &self.parts
    }

    /// The formulas by which the shapes are met.
    pub fn formulas(&self) -> Formulas {
        self.trial.formulas()
    }

    /// What a pixel of the picture, (column, row) from the top left, sees first at λ ≥ 0, and where; `None`
    /// where it sees nothing. A row that the picture does not have may panic.
    #[inline]
    pub fn seen(&self, pixel: (u32, u32), counts: &mut impl Tally) -> Option<First<R>> {
        let query = Query::new(self.scene.ray(pixel), Span::ahead());
        self.first(&query, Some(pixel), counts).map(|first| self.object(first))
    }

    /// What any ray hits first in `span`, which must not begin below 0; `None` where it hits nothing. By the
    /// robust formulas it is the same as [`fn@signature::first_hit`]; of the notes' see [`Bounded::by`]. The
    /// ray must be a ray. Extents help [`Bounded::seen`] only.
    #[inline]
    pub fn first_hit(&self, ray: &Ray3<R>, span: Span<R>, counts: &mut impl Tally) -> Option<First<R>> {
        let query = Query::new(*ray, span);
        self.first_part(&query, counts).map(|first| self.object(first))
    }

    /// The part that is hit first, `None` where nothing is; on a tie the earlier one.
    #[inline]
    pub fn first_part(&self, query: &Query<R>, counts: &mut impl Tally) -> Option<FirstPart<R>> {
        self.first(query, None, counts)
    }

    /// The same, with λ only if it was needed.
    #[inline]
    pub fn find(&self, query: &Query<R>, counts: &mut impl Tally) -> Option<Found<R>> {
        let (part, lambda) = self.search::<false>(query, None, counts)?;
        Some(Found { part, lambda })
    }

    /// Where the ray hits what [`Bounded::find`] found for the same query: λ, the point and the unit normal.
    /// λ is worked out once, for this part.
    #[inline]
    pub fn hit_of(&self, query: &Query<R>, found: Found<R>) -> Option<Hit3<R>> {
        let Found { part, lambda } = found;
        let span = Span::new(query.span.min, lambda.unwrap_or(query.span.max));
        match self.parts.shape(part) {
            Shape::Sphere(sphere)
                if query.leaves == Leaves::Within(part) && self.formulas() == Formulas::Robust =>
            {
                ray_sphere::robust::hit_from_within(&query.ray, sphere, span).ok().flatten()
            }
            _ => self.parts.whole_hit(self.formulas(), part, &query.ray, span),
        }
    }

    /// Some part that is hit, `None` where nothing is: the search ends with the first that it finds. Which
    /// one that is depends on the bounds.
    #[inline]
    pub fn any_part(&self, query: &Query<R>, counts: &mut impl Tally) -> Option<usize> {
        self.search::<true>(query, None, counts).map(|(part, _)| part)
    }

    /// Whether one part is hit in the span of the query.
    #[inline]
    pub fn hits(&self, part: usize, query: &Query<R>, counts: &mut impl Tally) -> bool {
        counts.tests(1);
        let hits = self.trial.begins(&self.parts, self.carried.as_ref(), query).on(part).is_some();
        if hits {
            counts.hit();
        }
        hits
    }

    fn object(&self, first: FirstPart<R>) -> First<R> {
        First { object: self.parts.object(first.part), lambda: first.lambda }
    }

    fn first(
        &self,
        query: &Query<R>,
        pixel: Option<(u32, u32)>,
        counts: &mut impl Tally,
    ) -> Option<FirstPart<R>> {
        let (part, lambda) = self.search::<false>(query, pixel, counts)?;
        let lambda = lambda.or_else(|| self.parts.hit(part, &query.ray, query.span))?;
        Some(FirstPart { part, lambda })
    }

    /// The part that is hit first, or `ANY`, and its λ where it was worked out to its last digit.
    #[inline]
    fn search<const ANY: bool>(
        &self,
        query: &Query<R>,
        pixel: Option<(u32, u32)>,
        counts: &mut impl Tally,
    ) -> Option<(usize, Option<R>)> {
        let begins = || self.trial.begins(&self.parts, self.carried.as_ref(), query);
        match &self.bounds {
            Bounds::None { spheres, rest, version } => {
                version.run(All::<R, _, _, ANY> { spheres, rest, begins, counts })
            }
            bounds => self.search_bounded::<ANY>(bounds, query, pixel, begins(), counts),
        }
    }

    fn search_bounded<const ANY: bool>(
        &self,
        bounds: &Bounds<R>,
        query: &Query<R>,
        pixel: Option<(u32, u32)>,
        mut tried: Tried<'_, R>,
        counts: &mut impl Tally,
    ) -> Option<(usize, Option<R>)> {
        let Query { ray, span, .. } = query;
        let tried = &mut tried;
        let mut nearest = Nearest::new(*span);
        match bounds {
            Bounds::None { .. } => {}
            Bounds::Spheres(spheres) => {
                try_all::<R, ANY>(self.unbounded.iter().copied(), tried, &mut nearest, counts);
                let reach = Reach::of(*span);
                for (object, sphere) in spheres {
                    // "only test intersections with objects if there exists a positive intersection with the
                    // bounding volume"
                    counts.boxes(1);
                    if !sphere.as_ref().is_some_and(|sphere| passes(ray, sphere, reach)) {
                        try_all::<R, ANY>(self.parts.of_object(*object), tried, &mut nearest, counts);
                    }
                }
            }
            Bounds::Boxes(boxes) => {
                try_all::<R, ANY>(self.unbounded.iter().copied(), tried, &mut nearest, counts);
                let slabs = Slabs::new(ray);
                for (object, bounds) in boxes {
                    counts.boxes(1);
                    if slabs.enter(bounds, nearest.reach).is_some() {
                        try_all::<R, ANY>(self.parts.of_object(*object), tried, &mut nearest, counts);
                    }
                }
            }
            Bounds::Extents(extents) => match pixel {
                Some((col, row)) => {
                    try_all::<R, ANY>(self.unbounded.iter().copied(), tried, &mut nearest, counts);
                    for (object, seen) in extents.in_row(row) {
                        counts.boxes(1);
                        if seen.cols.contains(&col) && seen.rows.contains(&row) {
                            try_all::<R, ANY>(self.parts.of_object(*object), tried, &mut nearest, counts);
                        }
                    }
                }
                None => try_all::<R, ANY>(0..self.parts.count(), tried, &mut nearest, counts),
            },
            Bounds::Tree { tree, parts } => {
                try_all::<R, ANY>(self.unbounded.iter().copied(), tried, &mut nearest, counts);
                if !(ANY && nearest.index.is_some()) {
                    let test = |at: usize, _| tried.on(parts[at]);
                    match ANY {
                        true => tree.first_found(ray, nearest.span, counts, test),
                        false => tree.closest(ray, nearest.span, counts, test),
                    };
                }
            }
            Bounds::Wide(wide) => {
                try_all::<R, ANY>(self.unbounded.iter().copied(), tried, &mut nearest, counts);
                if !(ANY && nearest.index.is_some()) {
                    let test = |part: usize, _| tried.on(part);
                    match ANY {
                        true => wide.first_found(ray, nearest.span, counts, test),
                        false => wide.closest(ray, nearest.span, counts, test),
                    };
                }
            }
        }
        tried.nearest()
    }
}

/// Whether a ray is nowhere in a sphere within `reach`.
///
/// The page asks for a positive intersection with the sphere itself. Where a ray ends too, as one to a light
/// does, all of it may be inside, and meet the sphere on neither side: so it is the stretch between the two
/// that is asked for.
fn passes<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>, reach: Reach) -> bool {
    let rounded = |t: R| Into::<f64>::into(t) as f32;
    let roots = robust(ray, sphere).roots();
    roots.is_none_or(|roots| rounded(roots.near) > reach.max || rounded(roots.far) < reach.min)
}

#[cfg(test)]
mod tests;

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

    /// What a pixel sees first, and where.
    #[inline]
    pub fn seen(&self, pixel: (u32, u32), counts: &mut impl Tally) -> Option<First<R>> {
        let query = Query::new(self.scene.ray(pixel), Span::ahead());
        self.first(&query, Some(pixel), counts).map(|first| self.object(first))
    }

    /// What any ray hits first in `span`, which must not begin below 0: the same as
    /// [`fn@signature::first_hit`] by the robust methods. The ray must be a ray. Extents help rays of the eye
    /// only.
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

    /// Where the ray hits what was found for it: λ, the point and the normal. λ is worked out once, for this
    /// part.
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

    /// Whether one part is hit.
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
mod tests {
    use super::*;
    use crate::{Counts, Uncounted};
    use affine::Deformed;
    use glam::DVec3;
    use math::{Camera, Grid, Handedness, Window};
    use ray_plane::Plane;
    use signature::Object;
    use triangle::mesh::Mesh;

    /// By hand: from the middle of a sphere of radius 2 the ray leaves it at λ = 2; a light at λ = 1 is
    /// before that.
    #[test]
    fn as_printed_a_ray_within_the_volume_is_not_tested() {
        let volume = Sphere { center: DVec3::ZERO, radius: 2.0 };
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::X);
        let to_the_light = Span::new(0.0, 1.0);
        assert_eq!(robust(&ray, &volume).roots().unwrap().first_within(to_the_light), None, "as printed");
        assert!(!passes(&ray, &volume, Reach::of(to_the_light)));
        // a ray ahead of the sphere, behind it and beside it does pass
        for (origin, span) in
            [(-9.0, Span::new(0.0, 6.9)), (-9.0, Span::new(11.1, 20.0)), (3.0, Span::ahead())]
        {
            assert!(passes(&Ray3::<f64>::new(DVec3::X * origin, DVec3::X), &volume, Reach::of(span)));
        }
        assert!(passes(
            &Ray3::<f64>::new(DVec3::Y * 2.1, DVec3::X),
            &volume,
            Reach::of(Span::<f64>::ahead())
        ));
    }

    /// By hand, before an eye at the origin that looks along z through five columns and rows of 0.6: a unit
    /// sphere from z = 4 to 6, the plane z = 9, a square of two faces at z = 7, one more unit sphere on the
    /// right, and on the left an ellipsoid from z = 3 to 7. The parts are those objects, the third of them
    /// two.
    fn scene() -> Scene<f64> {
        let at = |x: f64| DVec3::new(x, 0.0, 5.0);
        let sphere = |x: f64| Shape::Sphere(Sphere { center: at(x), radius: 1.0 });
        let corners =
            [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 7.0));
        let square = Mesh::new(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        let longer = Matrix3::from_rows([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.0]]);
        let ellipsoid = Deformed::new(affine::Object::Sphere, Affine { a: longer, t: at(-3.0) }).unwrap();
        let shapes = [
            sphere(0.0),
            Shape::Plane(Plane { point: DVec3::Z * 9.0, normal: -DVec3::Z }),
            Shape::Mesh(square),
            sphere(3.0),
            Shape::Deformed(Box::new(ellipsoid)),
        ];
        let window = Window { left: -1.5, right: 1.5, bottom: -1.5, top: 1.5 };
        let camera = Camera::looking(DVec3::ZERO, DVec3::Z, DVec3::Y, Handedness::Left, 1.0, window).unwrap();
        let objects = shapes.map(|shape| Object { id: None, shape }).to_vec();
        Scene { camera, grid: Grid::Centers, size: (5, 5), objects }
    }

    /// Every bound, by either formulas, each ray as it is and carried.
    fn for_all(mut assert: impl FnMut(&Bounded<'_, f64>, &str)) {
        let scene = scene();
        for (formulas, method) in
            Formulas::ALL.into_iter().flat_map(|it| Method::ALL.map(|method| (it, method)))
        {
            let bounded = Bounded::by(formulas, &scene, method);
            let says = format!("{} by {}", method.name(), formulas.name());
            assert_eq!((bounded.parts(), bounded.formulas()), (6, formulas), "{says}");
            assert(&bounded, &says);
            assert(&bounded.carrying(), &format!("{says}, carried"));
        }
    }

    fn along_z(x: f64, y: f64) -> Ray3<f64> {
        Ray3::new(DVec3::new(x, y, 0.0), DVec3::Z)
    }

    #[test]
    fn every_bound_has_the_first_hit_by_hand() {
        for_all(|bounded, says| {
            for (x, y, [min, max], want) in [
                (0.0, 0.0, [0.0, f64::INFINITY], Some((0, 0, 4.0))),
                (0.0, 0.0, [4.5, f64::INFINITY], Some((0, 0, 6.0))),
                (0.0, 0.0, [4.5, 5.5], None),
                (0.5, 0.25, [6.5, f64::INFINITY], Some((2, 2, 7.0))),
                (0.25, 0.5, [6.5, f64::INFINITY], Some((2, 3, 7.0))),
                (0.0, 0.0, [7.5, 9.0], Some((1, 1, 9.0))),
                (0.0, 0.0, [7.5, 8.5], None),
                (3.0, 0.0, [0.0, f64::INFINITY], Some((3, 4, 4.0))),
                (-3.0, 0.0, [0.0, f64::INFINITY], Some((4, 5, 3.0))),
                (8.0, 8.0, [0.0, f64::INFINITY], Some((1, 1, 9.0))),
            ] {
                let (ray, span) = (along_z(x, y), Span::new(min, max));
                let query = Query::new(ray, span);
                let first = bounded.first_hit(&ray, span, &mut Uncounted);
                assert_eq!(
                    first.map(|it| (it.object, it.lambda)),
                    want.map(|it| (it.0, it.2)),
                    "{says} {x} {min}"
                );
                let found = bounded.find(&query, &mut Uncounted);
                assert_eq!(found.map(|it| it.part), want.map(|it| it.1), "{says} {x} {min}");
                let hit = found.and_then(|found| bounded.hit_of(&query, found));
                assert_eq!(
                    hit.map(|hit| (hit.t, hit.point)),
                    want.map(|it| (it.2, ray.at(it.2))),
                    "{says} {x}"
                );
                let any = bounded.any_part(&query, &mut Uncounted);
                assert_eq!(any.is_some(), want.is_some(), "{says} {x} {min}");
                assert!(any.is_none_or(|part| bounded.hits(part, &query, &mut Uncounted)), "{says} {x}");
                let hit_parts = (0..6).filter(|&part| bounded.hits(part, &query, &mut Uncounted));
                assert!(hit_parts.clone().count() >= 1 || want.is_none(), "{says} {x} {min}");
                assert!(
                    hit_parts.clone().any(|part| want.is_some_and(|want| part == want.1)) || want.is_none()
                );
            }
        });
    }

    /// The middle row: plane, ellipsoid, sphere, the other sphere, plane; and above it the plane alone.
    #[test]
    fn every_bound_sees_each_object_in_its_pixel() {
        for_all(|bounded, says| {
            for (pixel, object) in
                [((0, 2), 1), ((1, 2), 4), ((2, 2), 0), ((3, 2), 3), ((4, 2), 1), ((2, 0), 1), ((2, 4), 1)]
            {
                let seen = bounded.seen(pixel, &mut Uncounted).map(|first| first.object);
                assert_eq!(seen, Some(object), "{says} {pixel:?}");
            }
        });
    }

    /// From (0, 0, 4) on, on the first sphere: past it the square is 3 away, and within it its far side 2.
    #[test]
    fn what_a_ray_leaves_is_not_met_again_or_is_only_left() {
        let scene = scene();
        let ray = Ray3::<f64>::new(DVec3::Z * 4.0, DVec3::Z);
        for method in Method::ALL {
            let bounded = Bounded::new(&scene, method);
            for (leaves, want) in [
                (Leaves::Unknown, (0, 0.0)),
                (Leaves::Passes(0), (2, 3.0)),
                (Leaves::Passes(0).tried_idly(), (2, 3.0)),
                (Leaves::Within(0), (0, 2.0)),
                (Leaves::Within(0).tried_idly(), (0, 2.0)),
            ] {
                let query = Query { leaves, ..Query::new(ray, Span::ahead()) };
                let found = bounded.find(&query, &mut Uncounted).unwrap();
                let hit = bounded.hit_of(&query, found).unwrap();
                assert_eq!((found.part, hit.t), want, "{} {leaves:?}", method.name());
            }
        }
        assert_eq!(Leaves::Passes(0).tried_idly(), Leaves::PassesIdly(0));
    }

    /// By hand, along z: where there are bounds the plane, which has none, is tried first, and then the
    /// sphere is nearer. All four bounds are asked; that of the square is passed too, where the nearest hit
    /// so far does not count. Without bounds the sphere comes first, and nothing is nearer.
    #[test]
    fn as_much_is_tested_as_the_bounds_leave_over() {
        let scene = scene();
        for (method, counts) in [
            (Method::None, Counts { boxes: 0, tests: 6, hits: 1 }),
            (Method::Sphere, Counts { boxes: 4, tests: 4, hits: 2 }),
            (Method::Box, Counts { boxes: 4, tests: 2, hits: 2 }),
            (Method::Extents, Counts { boxes: 0, tests: 6, hits: 1 }),
        ] {
            let (bounded, mut counted) = (Bounded::new(&scene, method), Counts::default());
            let ray = along_z(0.25, 0.125);
            bounded.first_hit(&ray, Span::ahead(), &mut counted);
            assert_eq!(counted, counts, "{}", method.name());
        }
    }
}

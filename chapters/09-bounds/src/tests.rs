//! Every tree against going through all objects in turn: the same object and the same bits of t.

mod extremes;
mod scenes;

use math::{Ray3, Real, Span};
use ray_sphere::Sphere;
use triangle::{Method, Triangle};

use crate::wide::{Instructions, Wide, WideMesh};
use crate::{Box3, Counts, Nearest, Tree, Uncounted};

/// Numbers that are the same on every run.
pub(crate) struct Numbers(pub(crate) u64);

impl Numbers {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 32) << 32 | self.0.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32
    }

    pub(crate) fn below(&mut self, bound: u64) -> u64 {
        (self.bits() >> 32) % bound
    }

    /// From 0 to 1.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// From −1 to 1.
    pub(crate) fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// Of a size from 2^−power to 2^power, or a whole number.
    pub(crate) fn around_zero(&mut self, power: i32) -> f64 {
        match self.below(4) {
            0 => (self.signed() * 5.0).round(),
            _ => self.signed() * 2.0_f64.powi(self.below(2 * power as u64) as i32 - power),
        }
    }

    /// A vector with components from −size to size; now and then some of them zero, or whole.
    fn vector<R: Real>(&mut self, size: f64) -> R::Vec3 {
        let kind = self.below(6);
        let mut component = || match kind {
            0 if self.below(2) == 0 => 0.0,
            1 => (self.signed() * 3.0).round() * size,
            _ => self.signed() * size,
        };
        let [x, y, z] = [component(), component(), component()].map(R::round_from);
        R::vec3(x, y, z)
    }
}

/// What is hit, with the bits of t.
type Found = Option<(usize, u64)>;

fn found<R: Real>(hit: Option<(usize, R)>) -> Found {
    hit.map(|(index, t)| (index, Into::<f64>::into(t).to_bits()))
}

/// The answer of going through all objects in turn.
fn in_turn<R: Real>(count: usize, span: Span<R>, test: impl Fn(usize, Span<R>) -> Option<R>) -> Found {
    let mut nearest: Option<(usize, R)> = None;
    for index in 0..count {
        if let Some(t) = test(index, span).filter(|t| nearest.is_none_or(|(_, nearest)| *t < nearest)) {
            nearest = Some((index, t));
        }
    }
    found(nearest)
}

/// Both trees over boxes, with all instructions, agree with all objects in turn. How many rays hit.
fn assert_agree<R: Real>(
    boxes: &[Box3],
    rays: &[Ray3<R>],
    span: Span<R>,
    test: impl Fn(usize, &Ray3<R>, Span<R>) -> Option<R>,
) -> usize {
    let (tree, best) = (Tree::build(boxes), Wide::build(boxes));
    let base = best.clone().with(Instructions::Baseline);
    let mut hits = 0;
    for ray in rays {
        let expected = in_turn(boxes.len(), span, |index, span| test(index, ray, span));
        let by_tree = tree.closest(ray, span, &mut Uncounted, |index, span| test(index, ray, span));
        assert_eq!(found(by_tree), expected, "tree, {} {ray:?}", R::NAME);
        let mut counts = [Counts::default(); 2];
        for (wide, counts) in [&base, &best].into_iter().zip(&mut counts) {
            let by_wide = wide.closest(ray, span, counts, |index, span| test(index, ray, span));
            assert_eq!(found(by_wide), expected, "wide, {} {ray:?}", R::NAME);
            let any = wide.any(ray, span, counts, |index, span| test(index, ray, span).is_some());
            assert_eq!(any, expected.is_some(), "wide, any, {ray:?}");
        }
        assert_eq!(counts[0], counts[1], "{ray:?}");
        let any = tree.any(ray, span, &mut Uncounted, |index, span| test(index, ray, span).is_some());
        assert_eq!(any, expected.is_some(), "tree, any, {ray:?}");
        hits += usize::from(expected.is_some());
    }
    hits
}

fn sphere_boxes<R: Real>(spheres: &[Sphere<R>]) -> Vec<Box3> {
    spheres.iter().map(|sphere| Box3::around_sphere(sphere.center, sphere.radius)).collect()
}

fn assert_spheres_agree<R: Real>(spheres: &[Sphere<R>], rays: &[Ray3<R>]) -> usize {
    assert_agree(&sphere_boxes(spheres), rays, Span::ahead(), |index, ray, span| {
        ray_sphere::robust(ray, &spheres[index]).hit(span).ok()?.map(|hit| hit.t)
    })
}

/// The same of triangles, by all three trees, and the robust method.
fn assert_triangles_agree<R: Real>(triangles: &[Triangle<R>], rays: &[Ray3<R>]) -> usize {
    let test = |index: usize, ray: &Ray3<R>, span: Span<R>| {
        triangle::robust(ray, &triangles[index]).hit(span).ok()?.map(|hit| hit.t)
    };
    let best = WideMesh::of_triangles(triangles);
    let base = best.clone().with(Instructions::Baseline);
    for ray in rays {
        let expected = in_turn(triangles.len(), Span::ahead(), |index, span| test(index, ray, span));
        let mut counts = [Counts::default(); 2];
        for (mesh, counts) in [&base, &best].into_iter().zip(&mut counts) {
            let by_mesh = mesh.closest(Method::Robust, ray, Span::ahead(), counts);
            assert_eq!(found(by_mesh), expected, "{} {ray:?}", R::NAME);
            assert_eq!(mesh.any(Method::Robust, ray, Span::ahead(), counts), expected.is_some());
        }
        assert_eq!(counts[0], counts[1]);
    }
    let boxes: Vec<Box3> = triangles.iter().map(|triangle| Box3::around::<R>(triangle.corners())).collect();
    assert_agree(&boxes, rays, Span::ahead(), test)
}

#[test]
fn of_two_at_the_same_t_the_earlier_wins_whichever_comes_first() {
    for order in [[3, 5], [5, 3]] {
        let mut nearest = Nearest::new(Span::<f64>::ahead());
        nearest.put(9, 2.0);
        for index in order {
            nearest.put(index, 1.0);
        }
        assert_eq!(nearest.hit(), Some((3, 1.0)));
        nearest.put(1, 1.5);
        nearest.put(0, f64::NAN);
        assert_eq!(nearest.hit(), Some((3, 1.0)));
    }
}

#[test]
fn nothing_is_hit_where_nothing_is() {
    let ray = Ray3::<f64>::new(glam::DVec3::ZERO, glam::DVec3::X);
    assert_eq!(Tree::build(&[]).closest(&ray, Span::ahead(), &mut Uncounted, |_, _| Some(1.0)), None);
    assert_eq!(Wide::build(&[]).closest(&ray, Span::ahead(), &mut Uncounted, |_, _| Some(1.0)), None);
    let nothing = WideMesh::of_triangles(&[]);
    assert!(!nothing.any(Method::Robust, &ray, Span::ahead(), &mut Uncounted));
    assert!(nothing.is_empty());
    let corner = [glam::DVec3::ZERO, glam::DVec3::X, glam::DVec3::Y];
    let triangle = Triangle::<f64> { p1: corner[0], p2: corner[1], p3: corner[2] };
    assert!(!WideMesh::of_triangles(&[triangle]).is_empty());
}

//! One shape alone, in the precision of the rays, and how to look at it.

use affine::{Affine, Deformed, Matrix3, Object as Unit};
use lab::{Draw, Vec3};
use math::{Camera, Degenerate, Grid, Handedness, Ray3, Real, Vector, Window};
use quadric::open::OpenCone;
use ray_plane::Plane;
use ray_sphere::Sphere;
use signature::{Scene, Shape};
use stage::{Error, Precision};
use triangle::Triangle;
use triangle::mesh::Mesh;

use super::regimes::{Kind, Regime, Way};

/// A shape alone.
#[derive(Debug)]
pub(crate) struct Object<R: Real> {
    /// The scene in which nothing else is.
    pub(crate) alone: Scene<R>,
    /// What is 1e-4 of its size above it: no ray that leaves it can miss that. `None` where there is no such
    /// thing.
    pub(crate) shell: Option<Shape<R>>,
    /// Where the second ray goes.
    pub(crate) way: Way,
    looks: Looks,
    draw: Draw,
}

/// From where it is looked at, and where to.
#[derive(Debug)]
struct Looks {
    kind: Kind,
    size: f64,
    center: Vec3,
    /// From the space in which points of it are drawn.
    by: Affine<f64>,
}

/// How far above it the shell is, in sizes.
const ABOVE: f64 = 1e-4;
/// A unit vector that lies along no axis: (0.6, −0.48, 0.64).
const AWAY: [f64; 3] = [0.6, -0.48, 0.64];

impl<R: Real> Object<R> {
    /// The shape of a regime. What is not said of it is drawn from the seed.
    pub(crate) fn of(regime: &Regime, seed: u64, precision: Precision) -> Result<Object<R>, Error> {
        let mut draw = Draw::new(seed, regime.name, precision);
        let Regime { kind, size, distance, way, .. } = *regime;
        let center = match kind {
            Kind::Ground => f64::vec3(0.0, -size, 0.0),
            _ => f64::vec3(AWAY[0], AWAY[1], AWAY[2]) * distance,
        };
        let by = deformation(kind, size, center, &mut draw);
        let looks = Looks { kind, size, center, by };
        let (shape, shell) = shapes(&looks, &mut draw).map_err(|reason| Error::Failed(reason.to_string()))?;
        let alone = scene(shape).map_err(|reason| Error::Failed(reason.to_string()))?;
        Ok(Object { alone, shell, way, looks, draw })
    }

    /// What stands alone.
    pub(crate) fn shape(&self) -> &Shape<R> {
        &self.alone.objects[0].shape
    }

    /// Where the draws for its rays begin, the same every time.
    pub(crate) fn draw(&self) -> Draw {
        self.draw.clone()
    }

    /// A ray from somewhere outside to somewhere within; for what is flat, to somewhere on it.
    pub(crate) fn ray(&self, draw: &mut Draw) -> Ray3<R> {
        let Looks { kind, size, center, by } = &self.looks;
        // farther than any of the deformed shapes reaches, which is √3 (√2 + 1) at most
        let far = size * draw.log_uniform(5.0, 50.0);
        let [x, y, z] = f64::xyz(draw.direction());
        let within = f64::vec3(x, y, z) * (0.98 * draw.uniform(0.0, 1.0));
        let (eye, target) = match kind {
            // near the top, from a little above it
            Kind::Ground => {
                (f64::vec3(10.0 * x, 0.5 + 5.0 * y.abs(), 10.0 * z), draw.in_cube(10.0) + *center * 1e-5)
            }
            Kind::Triangle | Kind::Plane => {
                let (alpha, beta) = (draw.uniform(0.0, 1.0), draw.uniform(0.0, 1.0));
                let (alpha, beta) =
                    if alpha + beta > 1.0 { (1.0 - alpha, 1.0 - beta) } else { (alpha, beta) };
                let away = draw.direction();
                // a plane is seen from the side on which the other one is
                let below = away.dot(f64::cross(by.a.columns[0], by.a.columns[1])) < 0.0;
                let away = if below && *kind == Kind::Plane { -away } else { away };
                (*center + away * far, by.apply(f64::vec3(alpha, beta, 0.0)))
            }
            Kind::Cone | Kind::DeformedCone => {
                let height = draw.uniform(0.0, 0.98);
                let wide = 0.49 * (1.0 - height);
                (*center + draw.direction() * far, by.apply(f64::vec3(wide * x, wide * y, height)))
            }
            _ => (*center + draw.direction() * far, by.apply(within)),
        };
        Ray3::new(rounded::<R>(eye), rounded::<R>(target - eye))
    }
}

/// From the space of the unit shapes to the world.
fn deformation(kind: Kind, size: f64, center: Vec3, draw: &mut Draw) -> Affine<f64> {
    let uniform = |scales: [f64; 3]| {
        let [x, y, z] = scales.map(|scale| scale * size);
        Matrix3::from_rows([[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]])
    };
    let a = match kind {
        Kind::Ellipsoid | Kind::DeformedCylinder | Kind::DeformedCone | Kind::Triangle | Kind::Plane => {
            loop {
                // as likely to mirror as not, and not too flat
                let a: Matrix3<f64> = Matrix3 { columns: [0, 1, 2].map(|_| draw.in_cube(1.0)) };
                if a.determinant().abs() > 0.03 {
                    break Matrix3 { columns: a.columns.map(|column| column * size) };
                }
            }
        }
        Kind::Squashed => {
            let n = draw.direction();
            let u = draw.perpendicular(n);
            Matrix3 { columns: [u, f64::cross(n, u), n * 1e-3].map(|column| column * size) }
        }
        _ => uniform([1.0; 3]),
    };
    Affine { a, t: center }
}

/// The shape, and what is above it.
fn shapes<R: Real>(looks: &Looks, draw: &mut Draw) -> Result<(Shape<R>, Option<Shape<R>>), Degenerate> {
    let Looks { kind, size, center, by } = looks;
    let sphere =
        |radius| Shape::Sphere(Sphere { center: rounded::<R>(*center), radius: R::round_from(radius) });
    let deformed = |object| -> Result<Shape<R>, Degenerate> {
        let affine = signature::deform::rounded(by);
        Ok(Shape::Deformed(Box::new(Deformed::new(object, affine)?)))
    };
    let columns = by.a.columns;
    let shape = match kind {
        Kind::Sphere | Kind::Ground => return Ok((sphere(*size), Some(sphere(size * (1.0 + ABOVE))))),
        Kind::Plane => {
            let normal = f64::cross(columns[0], columns[1]).normalized();
            let above = *center + normal * (ABOVE * size);
            let plane =
                |point| Shape::Plane(Plane { point: rounded::<R>(point), normal: rounded::<R>(normal) });
            return Ok((plane(*center), Some(plane(above))));
        }
        Kind::Triangle => {
            let corners = [*center, *center + columns[0], *center + columns[1]].map(rounded::<R>);
            let [p1, p2, p3] = corners;
            Shape::Triangle(Triangle { p1, p2, p3 })
        }
        Kind::Mesh => octahedron(*center, *size),
        Kind::Cylinder => Shape::Solid(quadric::Shape::Cylinder),
        Kind::Cone => Shape::Solid(quadric::Shape::Cone),
        Kind::OpenCone => {
            let axis = draw.direction() * (0.5 * size);
            let [base, apex] = [*center - axis, *center + axis].map(rounded::<R>);
            let [r_b, r_a] = [0.4, 0.1].map(|radius| R::round_from(radius * size));
            Shape::OpenCone(OpenCone::new(base, r_b, apex, r_a))
        }
        Kind::Ellipsoid | Kind::Squashed => deformed(Unit::Sphere)?,
        Kind::DeformedCylinder => deformed(Unit::Cylinder)?,
        Kind::DeformedCone => deformed(Unit::Cone)?,
    };
    Ok((shape, None))
}

fn octahedron<R: Real>(center: Vec3, size: f64) -> Shape<R> {
    let corner = |x, y, z| rounded::<R>(center + f64::vec3(x, y, z) * size);
    let corners =
        [1.0, -1.0].map(|s| [corner(s, 0.0, 0.0), corner(0.0, s, 0.0), corner(0.0, 0.0, s)]).concat();
    // each octant, seen from outside with its corners to the left
    let faces = vec![[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
    match Mesh::new(corners, faces) {
        Ok(mesh) => Shape::Mesh(mesh.smooth()),
        Err(_) => unreachable!("all faces name a corner"),
    }
}

fn rounded<R: Real>(v: Vec3) -> R::Vec3 {
    let [x, y, z] = f64::xyz(v).map(R::round_from);
    R::vec3(x, y, z)
}

/// A scene of one object. The camera is not used.
fn scene<R: Real>(shape: Shape<R>) -> Result<Scene<R>, Degenerate> {
    let (zero, one, size) = (R::from(0.0), R::from(1.0), (1, 1));
    let (eye, forward, up) = (R::vec3(zero, zero, zero), R::vec3(zero, zero, -one), R::vec3(zero, one, zero));
    let window = Window::around_axis(one, size);
    let camera = Camera::looking(eye, forward, up, Handedness::Right, one, window)?;
    let objects = vec![signature::Object { id: Some(1), shape }];
    Ok(Scene { camera, grid: Grid::Centers, size, objects })
}

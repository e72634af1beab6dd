//! n⃗ three ways, where the shape has three.

use affine::{Deformed, Object};
use math::{Ray3, Real, Vector};
use quadric::Shape as Solid;
use signature::Shape;
use stage::{Section, Transcript, Value};

use crate::normal::{Smooth, by_gradient, by_tangents};
use crate::{Landing, Lighting};

/// The normals of the surface, and the one that is shaded with.
pub(super) fn explain<R: Real>(
    transcript: &mut Transcript,
    lighting: &Lighting<'_, R>,
    ray: &Ray3<R>,
    landing: &Landing<R>,
) {
    let section = transcript.section("The normal, three ways", "CSC418 11.6");
    let (parts, n) = (lighting.bounded.all_parts(), landing.face_normal);
    match parts.shape(landing.part) {
        Shape::Sphere(sphere) => {
            let x = (landing.point - sphere.center) / sphere.radius;
            section.vector::<R>("x̄", "(p̄ − c̄) / r, on the unit sphere", x);
            both::<R>(section, Smooth::Sphere, x, n, |n| n);
        }
        Shape::Solid(solid) => solids::<R>(section, *solid, (landing.point, n), n, |n| n),
        Shape::Deformed(deformed) => of_deformed(section, deformed, landing.point, n),
        Shape::Triangle(triangle) => {
            let (a, b) = (triangle.p2 - triangle.p1, triangle.p3 - triangle.p1);
            tangents_of_flat::<R>(section, a, b, n);
        }
        Shape::Mesh(mesh) => {
            let triangle = mesh.triangle(parts.face(landing.part).unwrap_or(0));
            tangents_of_flat::<R>(section, triangle.p2 - triangle.p1, triangle.p3 - triangle.p1, n);
            if mesh.normals().is_some() {
                section
                    .vector::<R>("n⃗", "interpolated between the corners", landing.normal)
                    .number("n⃗·n⃗_face", "", landing.normal.dot(n))
                    .note("1 where the surface is as flat as its face");
            }
        }
        Shape::Plane(plane) => {
            section.vector::<R>("∇f", "n⃗ of (p̄ − p̄1)·n⃗ = 0", plane.normal);
            section.vector::<R>("n⃗", "∇f / ‖∇f‖", n);
        }
        Shape::Polygon(_) | Shape::OpenCone(_) => {
            section.vector::<R>("n⃗", "as its method has it", n);
        }
    }
    let turned = landing.turned_toward(ray.direction);
    section.vector::<R>("n⃗", "turned toward the viewer", turned.n).note(match turned.from_outside {
        true => "it already is",
        false => "the ray comes from the other side",
    });
}

/// Gradient and tangents of a smooth unit shape, carried into the world, beside what the method of the shape
/// says.
fn both<R: Real>(
    section: &mut Section,
    shape: Smooth,
    x: R::Vec3,
    n: R::Vec3,
    carried: impl Fn(R::Vec3) -> R::Vec3,
) {
    let gradient = by_gradient::<R>(shape, x);
    let first = carried(gradient.n);
    section.vector::<R>("∇f", f_of(shape), gradient.gradient);
    section.vector::<R>("n⃗", "∇f / ‖∇f‖", first);
    let tangents = by_tangents::<R>(shape, x);
    if !tangents.n.is_finite() {
        section.step("∂s/∂α", "along the parallel of latitude", Value::text("none"));
        section.note("on the axis every α is the same point");
        return;
    }
    let second = carried(tangents.n);
    section
        .vector::<R>("∂s/∂α", "around the axis", tangents.along_alpha)
        .vector::<R>("∂s/∂β", "along it", tangents.along_beta)
        .vector::<R>("cross", "∂s/∂α × ∂s/∂β", tangents.cross);
    section.note(if tangents.was_turned {
        "inward: turned"
    } else {
        "outward: the sign is that of the order of α and β"
    });
    section
        .vector::<R>("n⃗", "∂s/∂α × ∂s/∂β at unit length, outward", second)
        .vector::<R>("n⃗", "by the method that found λ*", n)
        .number(
            "apart",
            "the largest distance between the three",
            [first - second, first - n, second - n]
                .into_iter()
                .map(|v| v.length())
                .fold(R::from(0.0), |a, b| if b > a { b } else { a }),
        );
    section.note("a rounding or two of the p̄ that they are taken at");
}

fn f_of(shape: Smooth) -> &'static str {
    match shape {
        Smooth::Sphere => "of f = x² + y² + z² − 1",
        Smooth::Cylinder => "of f = x² + y² − 1",
        Smooth::Cone => "of f = x² + y² − ¼(1 − z)²",
    }
}

/// A solid's wall is smooth, its caps are flat. `own_n` is n⃗ in the solid's own space, of any length.
fn solids<R: Real>(
    section: &mut Section,
    solid: Solid,
    (x, own_n): (R::Vec3, R::Vec3),
    n: R::Vec3,
    carried: impl Fn(R::Vec3) -> R::Vec3,
) {
    let (zero, one) = (R::from(0.0), R::from(1.0));
    let [across_x, across_y, along] = R::xyz(own_n);
    // a cap's normal is the axis; a wall's has less along it than across it
    if across_x * across_x + across_y * across_y < along * along {
        let cap = R::vec3(zero, zero, if along > zero { one } else { -one });
        section.vector::<R>("∇f", "of f = ± z − h, a cap", cap).vector::<R>("n⃗", "∇f / ‖∇f‖", n);
        return;
    }
    let smooth = match solid {
        Solid::Cylinder => Smooth::Cylinder,
        Solid::Cone => Smooth::Cone,
    };
    both::<R>(section, smooth, x, n, carried);
}

fn of_deformed<R: Real>(section: &mut Section, deformed: &Deformed<R>, p: R::Vec3, n: R::Vec3) {
    let x = deformed.inverse.times(p - deformed.affine.t);
    section.vector::<R>("x̄", "A⁻¹ (p̄ − t), in the object's own space", x);
    let carried = |n| deformed.inverse.transposed_times(n).normalized();
    let own_n = deformed.affine.a.transposed_times(n);
    section.remark("Each n⃗ is carried into the world by A⁻ᵀ, and then has length 1 (CSC418 11.6.1).");
    match deformed.object {
        Object::Sphere => both::<R>(section, Smooth::Sphere, x, n, carried),
        Object::Cylinder => solids::<R>(section, Solid::Cylinder, (x, own_n), n, carried),
        Object::Cone => solids::<R>(section, Solid::Cone, (x, own_n), n, carried),
        Object::Plane | Object::Triangle => {
            section.vector::<R>("n⃗", "A⁻ᵀ (0, 0, 1) at unit length", n);
        }
    }
}

/// p̄(α, β) = p̄1 + α (p̄2 − p̄1) + β (p̄3 − p̄1)
fn tangents_of_flat<R: Real>(section: &mut Section, a: R::Vec3, b: R::Vec3, n: R::Vec3) {
    section
        .vector::<R>("∂p̄/∂α", "p̄2 − p̄1", a)
        .vector::<R>("∂p̄/∂β", "p̄3 − p̄1", b)
        .vector::<R>("cross", "∂p̄/∂α × ∂p̄/∂β", R::cross(a, b))
        .vector::<R>("n⃗_face", "at unit length", n);
}

#[cfg(test)]
mod tests {
    use bounds::{Bounded, Query, Uncounted};
    use glam::DVec3;
    use math::Span;
    use stage::{Ask, Chapter};

    use super::*;
    use crate::{Start, from_file, picture};

    /// A triangle in the plane z = 0 whose normal leans toward x at its second corner.
    const BENT: &str = "\
        v 0 0 0\nv 4 0 0\nv 0 4 0\nvn 0 0 1\nvn 0.6 0 0.8\nvn 0 0 1\nf 1//1 2//2 3//3\n";
    const SCENE: &str = "\
        [camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\n[material.m]\n\
        [[object]]\nmaterial = \"m\"\nmesh = { file = \"bent.obj\", smooth = true }\n";

    /// What is said of a ray toward its point (1, 1, 0), where α = β = ¼.
    fn said(direction: DVec3) -> (Section, Landing<f64>) {
        let files = [("bent.toml", SCENE.as_bytes()), ("bent.obj", BENT.as_bytes())];
        let file = scene_file::Scene::built_in("bent.toml", &files).unwrap();
        let scene = from_file::scene::<f64>(&file, Some((4, 3))).unwrap();
        let bounded = Bounded::new(&scene.geometry, bounds::Method::Auto);
        let ray = Ray3::<f64>::new(DVec3::new(1.0, 1.0, 0.0) - direction * 2.0, direction);
        let query = Query::new(ray, Span::ahead());
        let landing = Landing::of(&bounded, &query, &mut Uncounted, |_| false).unwrap();
        let mut transcript = Transcript::new(&crate::stage::Shading.about(), &Ask::default());
        explain(&mut transcript, &picture::lighting(&scene, &bounded, Start::Bound), &ray, &landing);
        (transcript.sections.remove(0), landing)
    }

    fn last<'a>(section: &'a Section, symbol: &str) -> &'a Value {
        &section.steps.iter().rfind(|step| step.symbol == symbol).unwrap().value
    }

    /// By hand: ½ (0, 0, 1) + ¼ (0.6, 0, 0.8) + ¼ (0, 0, 1) = (0.15, 0, 0.95), of the length √0.925. From
    /// either side n⃗·n⃗_face is the same, for both are as the surface has them; and toward the viewer both
    /// turn.
    #[test]
    fn an_interpolated_normal_turns_with_its_face() {
        let leaning = DVec3::new(0.15, 0.0, 0.95) / 0.925_f64.sqrt();
        for z in [-1.0, 1.0] {
            let (section, landing) = said(DVec3::new(0.0, 0.0, z));
            let Value::F64(along) = *last(&section, "n⃗·n⃗_face") else { panic!("a number") };
            assert!((along - 0.95 / 0.925_f64.sqrt()).abs() < 4.0 * f64::EPSILON, "{along}");
            assert_eq!(along, landing.normal.dot(landing.face_normal), "to the last digit");
            assert!((landing.normal - leaning).length() < 4.0 * f64::EPSILON);
            let turned = landing.turned_toward(DVec3::new(0.0, 0.0, z));
            assert_eq!((turned.n, turned.face), (landing.normal * -z, DVec3::Z * -z));
            assert_eq!(last(&section, "n⃗"), &Value::vector::<f64>(turned.n));
        }
    }

    /// By hand: d · n_face < 0, though d · n > 0. By itself n⃗ would turn, and light the face from behind.
    #[test]
    fn a_normal_that_leans_away_does_not_turn_by_itself() {
        let direction = DVec3::new(10.0, 0.0, -1.0);
        let (section, landing) = said(direction);
        assert!(landing.normal.dot(direction) > 0.0 && landing.face_normal.dot(direction) < 0.0);
        assert_eq!(last(&section, "n⃗"), &Value::vector::<f64>(landing.normal));
    }
}

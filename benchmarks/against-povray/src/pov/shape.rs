//! The shapes.

use affine::{Affine, Object};
use math::{Real, Vector};
use quadric::open::OpenCone;
use signature::Shape;

use super::number::{number, vector};

type V = <f64 as Real>::Vec3;

/// A shape with its surface, on a line or several. The faces of a patch stand alone, as POV-Ray's own
/// examples have them; those of a mesh are one `mesh`.
pub(super) fn shape(it: &Shape<f64>, surface: &str, is_patch: bool) -> String {
    let body = match it {
        Shape::Sphere(sphere) => format!("sphere {{ {}, {}", v(sphere.center), number(sphere.radius)),
        Shape::Plane(plane) => {
            let n = plane.normal.normalized();
            format!("plane {{ {}, {}", v(n), number(n.dot(plane.point)))
        }
        Shape::Triangle(it) => format!("triangle {{ {}, {}, {}", v(it.p1), v(it.p2), v(it.p3)),
        Shape::Polygon(it) => polygon(it.corners(), it.plane().normal),
        Shape::Mesh(it) => {
            let faces = (0..it.faces().len()).map(|face| {
                let corners = it.triangle(face);
                let corners = [corners.p1, corners.p2, corners.p3];
                triangle(corners, it.normals().map(|normals| normals[face]))
            });
            if is_patch {
                return faces.map(|face| format!("{face} {surface} }}\n")).collect();
            }
            format!("mesh {{\n{}", faces.map(|face| format!("  {face} }}\n")).collect::<String>())
        }
        Shape::Solid(quadric::Shape::Cylinder) => CYLINDER.to_string(),
        Shape::Solid(quadric::Shape::Cone) => CONE.to_string(),
        Shape::OpenCone(cone) => open_cone(cone),
        Shape::Deformed(it) => format!("{} {}", unit(it.object), matrix(&it.affine)),
    };
    format!("{body} {surface} }}\n")
}

const SPHERE: &str = "sphere { <0,0,0>, 1";
const CYLINDER: &str = "cylinder { <0,0,-1>, <0,0,1>, 1";
const CONE: &str = "cone { <0,0,0>, 0.5, <0,0,1>, 0";

/// Chapter 07's objects, before they are deformed.
fn unit(object: Object) -> &'static str {
    match object {
        Object::Sphere => SPHERE,
        Object::Cylinder => CYLINDER,
        Object::Cone => CONE,
        Object::Plane => "plane { <0,0,1>, 0",
        Object::Triangle => "triangle { <0,0,0>, <1,0,0>, <0,1,0>",
    }
}

/// POV-Ray multiplies from the left, a point being a row: it reads the columns of our A one after another,
/// then t.
fn matrix(affine: &Affine<f64>) -> String {
    let numbers: Vec<String> =
        affine.a.columns.into_iter().chain([affine.t]).flat_map(f64::xyz).map(number).collect();
    format!("matrix <{}>", numbers.join(","))
}

fn triangle([a, b, c]: [V; 3], normals: Option<[V; 3]>) -> String {
    match normals {
        Some([na, nb, nc]) => {
            format!("smooth_triangle {{ {}, {}, {}, {}, {}, {}", v(a), v(na), v(b), v(nb), v(c), v(nc))
        }
        None => format!("triangle {{ {}, {}, {}", v(a), v(b), v(c)),
    }
}

/// POV-Ray leaves out, without a word, a polygon whose corners are farther from its plane than 1e-10, as
/// corners of six digits are. They are brought to the plane that ours has, through the first of them. It
/// closes where it began.
fn polygon(corners: &[V], normal: V) -> String {
    let n = normal.normalized();
    let flat = |corner: V| corner - n * n.dot(corner - corners[0]);
    let listed: Vec<String> = corners.iter().chain(corners.first()).map(|&corner| v(flat(corner))).collect();
    format!("polygon {{ {}, {}", listed.len(), listed.join(", "))
}

fn open_cone(it: &OpenCone<f64>) -> String {
    let (base, apex) = (v(it.base), v(it.apex));
    if it.base_radius == it.apex_radius {
        format!("cylinder {{ {base}, {apex}, {} open", number(it.base_radius))
    } else {
        format!("cone {{ {base}, {}, {apex}, {} open", number(it.base_radius), number(it.apex_radius))
    }
}

fn v(of: V) -> String {
    vector(f64::xyz(of))
}

#[cfg(test)]
mod tests;

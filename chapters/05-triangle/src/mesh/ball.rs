//! A closed mesh to shoot at: a bumpy ball.

use std::collections::HashMap;

use math::{Real, Vector};

use super::Mesh;

/// How often the octahedron's faces are divided for the ball of `trade`: 8 · 4³ = 512 triangles.
pub const DIVISIONS: u32 = 3;

/// A ball of radius 1 or so around `center`, closed and bumpy: an octahedron whose faces are divided in four so many
/// times, its vertices pushed out to a distance that depends on the direction. It has 8 · 4^divisions faces.
///
/// Each vertex is rounded once to the precision and shared by all its faces. They are shaded flat, with
/// normals that point outward. The center must be finite.
pub fn bumpy_ball<R: Real>(divisions: u32, center: [f64; 3]) -> Mesh<R> {
    let (mut directions, mut faces) = octahedron();
    for _ in 0..divisions {
        faces = divided(&mut directions, &faces);
    }
    let vertex = |direction: Direction| {
        let [x, y, z] = pushed_out(direction);
        let [x, y, z] = [x + center[0], y + center[1], z + center[2]].map(R::round_from);
        R::vec3(x, y, z)
    };
    let vertices = directions.into_iter().map(vertex).collect();
    Mesh { vertices, faces, normals: None }
}

type Direction = <f64 as Real>::Vec3;

/// Its six vertices, and its eight faces, counterclockwise seen from outside.
fn octahedron() -> (Vec<Direction>, Vec<[usize; 3]>) {
    let vertices = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]];
    let vertices = vertices.map(|[x, y, z]| f64::vec3(f64::from(x), f64::from(y), f64::from(z)));
    let faces = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
    (vertices.to_vec(), faces.to_vec())
}

/// Each face in four: three at its corners and one between the middles of its sides. Two faces that share a side
/// share its middle.
fn divided(vertices: &mut Vec<Direction>, faces: &[[usize; 3]]) -> Vec<[usize; 3]> {
    let mut middles: HashMap<(usize, usize), usize> = HashMap::new();
    let mut middle = |a: usize, b: usize| {
        *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
            let between = vertices[a] + vertices[b];
            vertices.push(between.normalized());
            vertices.len() - 1
        })
    };
    let mut smaller = Vec::with_capacity(4 * faces.len());
    for &[a, b, c] in faces {
        let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
        smaller.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
    }
    smaller
}

/// The vertex in a direction: 1 + b/8 away, where b, from −3 to 3, goes up and down three times along each axis.
fn pushed_out(direction: Direction) -> [f64; 3] {
    let [x, y, z] = f64::xyz(direction);
    let waves = |x: f64| x * (4.0 * x * x - 3.0); // Chebyshev's third polynomial
    let bumps = waves(x) * waves(y) + waves(y) * waves(z) + waves(z) * waves(x);
    f64::xyz(direction * (1.0 + bumps / 8.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Euler: V − E + F = 2, every edge has two faces, and they run along it in opposite ways.
    #[test]
    fn the_ball_is_closed() {
        for divisions in 0..=DIVISIONS {
            let ball = bumpy_ball::<f64>(divisions, [0.0; 3]);
            assert_eq!(ball.faces().len(), 8 * 4_usize.pow(divisions));
            let mut edges = HashMap::new();
            for &[a, b, c] in ball.faces() {
                for edge in [(a, b), (b, c), (c, a)] {
                    *edges.entry(edge).or_insert(0) += 1;
                }
            }
            let (vertices, faces) = (ball.vertices().len(), ball.faces().len());
            assert!(edges.iter().all(|(&(a, b), &times)| times == 1 && edges.contains_key(&(b, a))));
            assert_eq!(vertices + faces, edges.len() / 2 + 2);
        }
    }

    #[test]
    fn its_faces_look_outward() {
        let ball = bumpy_ball::<f64>(DIVISIONS, [0.0; 3]);
        for face in 0..ball.faces().len() {
            let triangle = ball.triangle(face);
            assert!(triangle.normal().dot(triangle.p1) > 0.0, "face {face}");
        }
        let away: Vec<f64> = ball.vertices().iter().map(|vertex| vertex.length()).collect();
        assert!(away.iter().all(|r| (0.625..=1.375).contains(r)));
        assert!(away.iter().any(|&r| r < 0.9) && away.iter().any(|&r| r > 1.1), "bumpy");
    }

    /// By hand: 4x³ − 3x is −1 at ½, −11/16 at ¼ and 1 at 1, and so b = 11/16 − 11/16 − 1 = −1, and the vertex is at
    /// 7/8. (The formula asks for no unit vector.) Along an axis two of the waves are 0, and b is too.
    #[test]
    fn a_vertex_is_pushed_out_by_its_waves() {
        assert_eq!(pushed_out(f64::vec3(0.5, 0.25, 1.0)), [0.4375, 0.21875, 0.875]);
        assert_eq!(pushed_out(f64::vec3(0.0, -1.0, 0.0)), [0.0, -1.0, 0.0]);
    }
}

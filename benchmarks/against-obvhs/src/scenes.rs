//! What is traced: Haines's balls, the bunny, and a torus of a million triangles.

use std::f64::consts::TAU;
use std::io::Read;
use std::path::Path;

use math::Real;
use triangle::Triangle;

/// Spheres, and the camera that looks at them.
pub(crate) struct Balls {
    /// Center and radius.
    pub(crate) spheres: Vec<([f64; 3], f64)>,
    pub(crate) camera: Camera,
}

/// A camera at `from` that looks at `at`, with a full angle of view in degrees.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Camera {
    pub(crate) from: [f64; 3],
    pub(crate) at: [f64; 3],
    pub(crate) up: [f64; 3],
    pub(crate) angle: f64,
}

/// Corners, three to a triangle.
pub(crate) struct Triangles {
    pub(crate) name: &'static str,
    pub(crate) corners: Vec<[[f64; 3]; 3]>,
    pub(crate) camera: Camera,
}

impl Triangles {
    /// In a precision.
    pub(crate) fn rounded<R: Real>(&self) -> Vec<Triangle<R>> {
        let triangle = |&[a, b, c]: &[[f64; 3]; 3]| Triangle {
            p1: vector::<R>(a),
            p2: vector::<R>(b),
            p3: vector::<R>(c),
        };
        self.corners.iter().map(triangle).collect()
    }
}

/// The spheres and the view of a packed NFF file, and nothing else of it.
pub(crate) fn balls(path: &Path) -> Result<Balls, String> {
    let file = std::fs::File::open(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut text = String::new();
    let unpacked = flate2::read::GzDecoder::new(file).read_to_string(&mut text);
    unpacked.map_err(|error| format!("{}: {error}", path.display()))?;
    let mut spheres = Vec::new();
    let mut camera = Camera { from: [0.0; 3], at: [0.0; 3], up: [0.0; 3], angle: 0.0 };
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let name = words.next().unwrap_or("");
        let n: Vec<f64> = words.filter_map(|word| word.parse().ok()).collect();
        match (name, n.as_slice()) {
            ("s", &[x, y, z, r]) => spheres.push(([x, y, z], r)),
            ("from", &[x, y, z]) => camera.from = [x, y, z],
            ("at", &[x, y, z]) => camera.at = [x, y, z],
            ("up", &[x, y, z]) => camera.up = [x, y, z],
            ("angle", &[angle]) => camera.angle = angle,
            _ => {}
        }
    }
    Ok(Balls { spheres, camera })
}

/// The triangles of an OBJ file.
pub(crate) fn bunny(path: &Path) -> Result<Triangles, String> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    let mut corners = Vec::new();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let n: Vec<f64> = words.filter_map(|word| word.parse().ok()).collect();
                vertices.push([n[0], n[1], n[2]]);
            }
            Some("f") => {
                let place = |word: &str| word.split('/').next().and_then(|n| n.parse::<usize>().ok());
                let places: Vec<usize> = words.filter_map(place).collect();
                corners.push([0, 1, 2].map(|corner| vertices[places[corner] - 1]));
            }
            _ => {}
        }
    }
    Ok(Triangles { name: "bunny", camera: facing(&corners), corners })
}

/// A torus with a bumpy tube: 1000 × 500 squares, two triangles each.
pub(crate) fn torus() -> Triangles {
    const AROUND: usize = 1000;
    const TUBE: usize = 500;
    let point = |i: usize, j: usize| {
        let [u, v] =
            [(i % AROUND) as f64 / AROUND as f64, (j % TUBE) as f64 / TUBE as f64].map(|turns| turns * TAU);
        let tube = 0.4 + 0.03 * (23.0 * u).sin() * (11.0 * v).sin();
        let from_axis = 1.0 + tube * v.cos();
        [from_axis * u.cos(), tube * v.sin(), from_axis * u.sin()]
    };
    let mut corners = Vec::with_capacity(2 * AROUND * TUBE);
    for i in 0..AROUND {
        for j in 0..TUBE {
            let square = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
            corners.push([square[0], square[1], square[2]]);
            corners.push([square[0], square[2], square[3]]);
        }
    }
    Triangles { name: "torus", camera: facing(&corners), corners }
}

/// From above and in front, with all of it in view.
fn facing(corners: &[[[f64; 3]; 3]]) -> Camera {
    let (low, high) = extent(corners);
    let at = [0, 1, 2].map(|axis| 0.5 * (low[axis] + high[axis]));
    let size = [0, 1, 2].map(|axis| high[axis] - low[axis]).into_iter().fold(0.0, f64::max);
    let from = [at[0] + 0.3 * size, at[1] + 0.8 * size, at[2] + 1.2 * size];
    Camera { from, at, up: [0.0, 1.0, 0.0], angle: 45.0 }
}

/// The smallest and the largest coordinates.
pub(crate) fn extent(corners: &[[[f64; 3]; 3]]) -> ([f64; 3], [f64; 3]) {
    let mut extent = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for corner in corners.iter().flatten() {
        for (axis, &x) in corner.iter().enumerate() {
            extent.0[axis] = extent.0[axis].min(x);
            extent.1[axis] = extent.1[axis].max(x);
        }
    }
    extent
}

/// A vector of the precision.
pub(crate) fn vector<R: Real>(v: [f64; 3]) -> R::Vec3 {
    let [x, y, z] = v.map(R::round_from);
    R::vec3(x, y, z)
}

use glam::DVec3;
use math::Hit;

use super::*;

/// The square from (0, 0) to (2, 2) at z = 0, in two faces that share the diagonal.
fn square() -> Mesh<f64> {
    let vertices = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    Mesh::new(vertices.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).unwrap()
}

fn down(x: f64, y: f64) -> Ray3<f64> {
    Ray3::new(DVec3::new(x, y, 3.0), -DVec3::Z)
}

#[test]
fn the_face_and_the_place_in_it() {
    // by hand: (1.5, 0.5) = ½ (2, 0) + ¼ (2, 2), and (0.5, 1) = ¼ (2, 2) + ¼ (0, 2)
    for method in Method::ALL {
        for (x, y, face, alpha_beta) in [(1.5, 0.5, 0, (0.5, 0.25)), (0.5, 1.0, 1, (0.25, 0.25))] {
            let found = square().hit(method, &down(x, y), Span::ahead()).unwrap().unwrap();
            assert_eq!((found.face, found.alpha_beta), (face, Some(alpha_beta)));
            assert_eq!((found.hit.t, found.hit.point), (3.0, DVec3::new(x, y, 0.0)));
            assert_eq!((found.hit.normal, found.shading_normal), (DVec3::Z, DVec3::Z));
        }
        let found = square().hit(method, &down(1.0, 1.0), Span::ahead()).unwrap().unwrap();
        assert_eq!(found.face, 0, "the earlier one at the shared edge");
        assert_eq!(square().hit(method, &down(3.0, 1.0), Span::ahead()), Ok(None));
        assert_eq!(square().hit(method, &down(1.0, 1.0), Span::new(0.0, 2.0)), Ok(None));
    }
}

#[test]
fn the_nearest_of_several_faces_in_the_span() {
    let corner = |x, y, z| DVec3::new(x, y, z);
    let vertices = (0..3).flat_map(|z| {
        let z = f64::from(z);
        [corner(0.0, 0.0, z), corner(2.0, 0.0, z), corner(0.0, 2.0, z)]
    });
    let mesh = Mesh::<f64>::new(vertices.collect(), vec![[0, 1, 2], [6, 7, 8], [3, 4, 5]]).unwrap();
    for method in Method::ALL {
        let at =
            |span| mesh.hit(method, &down(0.5, 0.5), span).unwrap().map(|found| (found.face, found.hit.t));
        assert_eq!(at(Span::ahead()), Some((1, 1.0)));
        assert_eq!(at(Span::new(1.5, 10.0)), Some((2, 2.0)));
        assert_eq!(at(Span::new(2.5, 10.0)), Some((0, 3.0)));
    }
}

#[test]
fn a_face_without_area_is_passed_over() {
    let vertices = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [0.0, 2.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    let faces = vec![[0, 2, 1], [0, 1, 1], [0, 1, 3]];
    let mesh = Mesh::<f64>::new(vertices.to_vec(), faces).unwrap().smooth();
    for method in Method::ALL {
        for (x, y) in [(0.5, 0.5), (1.0, 0.0)] {
            let found = mesh.hit(method, &down(x, y), Span::ahead()).unwrap().unwrap();
            assert_eq!((found.face, found.shading_normal), (2, DVec3::Z));
        }
        let only = Mesh::<f64>::new(vertices.to_vec(), vec![[0, 2, 1]]).unwrap();
        assert_eq!(only.hit(method, &down(1.0, 0.0), Span::ahead()), Ok(None));
        let still = Ray3::<f64>::new(DVec3::ZERO, DVec3::ZERO);
        assert_eq!(only.hit(method, &still, Span::ahead()), Err(Degenerate::ZeroDirection));
        let lost = Ray3::<f64>::new(DVec3::ZERO, DVec3::INFINITY);
        assert_eq!(mesh.hit(method, &lost, Span::ahead()), Err(Degenerate::NotFinite));
    }
}

/// A roof: over the x axis two faces meet, one of them three times as large as the other.
#[test]
fn a_vertex_has_the_mean_of_its_faces_by_area() {
    let vertices = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -3.0]].map(DVec3::from);
    let mesh = Mesh::<f64>::new(vertices.to_vec(), vec![[0, 1, 2], [0, 3, 1]]).unwrap();
    // by hand: (2,0,0) × (0,1,0) = (0, 0, 2), and (0,0,−3) × (2,0,0) = (0, −6, 0)
    let mean = DVec3::new(0.0, -6.0, 2.0).normalize();
    let smooth = mesh.smooth();
    let normals = smooth.normals().unwrap();
    let near = |a: DVec3, b: DVec3| assert!((a - b).length() < 1e-15, "{a} {b}");
    for (normal, expected) in [(normals[0][0], mean), (normals[0][1], mean), (normals[0][2], DVec3::Z)] {
        near(normal, expected);
    }
    near(normals[1][1], -DVec3::Y);
    // halfway from the edge's middle to the corner of the first face: α = ¼, β = ½
    let found = smooth.hit(Method::Matrix, &down(0.5, 0.5), Span::ahead()).unwrap().unwrap();
    assert_eq!((found.face, found.alpha_beta, found.hit.normal), (0, Some((0.25, 0.5)), DVec3::Z));
    near(found.shading_normal, (mean / 2.0 + DVec3::Z / 2.0).normalize());
}

#[test]
fn normals_that_are_given_count_and_the_mean_stands_in() {
    let tilted = DVec3::new(0.0, 3.0, 4.0);
    let given = [[Some(tilted), None, Some(DVec3::ZERO)], [Some(DVec3::NAN), None, Some(-DVec3::Z)]];
    let mesh = square().with_normals(&given).unwrap();
    let unit = DVec3::new(0.0, 0.6, 0.8);
    let expected = [[unit, DVec3::Z, DVec3::Z], [DVec3::Z, DVec3::Z, -DVec3::Z]];
    let off = mesh.normals().unwrap().iter().flatten().zip(expected.iter().flatten());
    assert!(off.into_iter().all(|(a, b)| (*a - *b).length() < 1e-15));
    let error = square().with_normals(&given[..1]).unwrap_err();
    assert_eq!(error, NotAMesh::NormalsMissing { given: 1, faces: 2 });
    // halfway between (0, 0), where the normal is that of the square, and (0, 2), where it is the opposite
    let found = mesh.hit(Method::Robust, &down(0.0, 1.0), Span::ahead()).unwrap().unwrap();
    assert_eq!((found.face, found.shading_normal), (1, DVec3::Z), "they cancel: the face's own");
}

/// "An interpolated normal turns with its face."
#[test]
fn both_normals_turn_or_neither_does() {
    let leaning = DVec3::new(0.8, 0.0, 0.6);
    let hit = Hit { t: 1.0, point: DVec3::ZERO, normal: DVec3::Z };
    let found = MeshHit::<f64> { hit, face: 0, alpha_beta: None, shading_normal: leaning };
    assert_eq!(found.turned_toward(DVec3::new(0.0, 0.0, -1.0)), [DVec3::Z, leaning]);
    assert_eq!(found.turned_toward(DVec3::new(0.0, 0.0, 1.0)), [-DVec3::Z, -leaning]);
    // d · n < 0, though d · leaning > 0: seen from the front, the face is not turned, and so neither is the other
    assert_eq!(found.turned_toward(DVec3::new(1.0, 0.0, -0.1)), [DVec3::Z, leaning]);
}

#[test]
fn what_is_no_mesh_is_refused() {
    let vertices = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
    let new = |vertices: &[DVec3], faces: &[[usize; 3]]| Mesh::<f64>::new(vertices.to_vec(), faces.to_vec());
    assert_eq!(new(&vertices, &[]), Err(NotAMesh::NoFaces));
    let out_of_range = NotAMesh::NoSuchVertex { face: 1, vertex: 3, count: 3 };
    assert_eq!(new(&vertices, &[[0, 1, 2], [2, 1, 3]]), Err(out_of_range));
    assert_eq!(
        out_of_range.to_string(),
        "face 1 names vertex 3, and there are 3, counted from 0: name one of them"
    );
    let lost = [DVec3::ZERO, DVec3::NAN, DVec3::Y];
    assert_eq!(new(&lost, &[[0, 1, 2]]), Err(NotAMesh::NotFinite { vertex: 1 }));
}

/// From inside a closed ball every ray meets it, and smooth normals are near those of the ball.
#[test]
fn a_ray_from_inside_the_ball_meets_it() {
    let smooth = ball::bumpy_ball::<f64>(2, [0.0; 3]).smooth();
    for i in 0..500 {
        let (u, v) = (f64::from(i) * 0.618, f64::from(i) * 0.4142);
        let direction = DVec3::new(u.fract() - 0.5, v.fract() - 0.5, (u + v).fract() - 0.5);
        let ray = Ray3::<f64>::new(DVec3::ZERO, direction);
        let found = smooth.hit(Method::Robust, &ray, Span::ahead()).unwrap().unwrap();
        assert!((found.shading_normal.length() - 1.0).abs() < 1e-15);
        assert!(found.shading_normal.dot(found.hit.normal) > 0.5, "{direction}");
        let [outward, _] = found.turned_toward(direction);
        assert_eq!(outward, -found.hit.normal, "seen from inside");
    }
}

/// By hand: (0, 1, 0) × (−4, 0, 3) = (3, 0, 4), which is 5 long. 3/5 and 4/5 are rounded once.
#[test]
fn the_normal_of_a_lone_face_is_a_unit_vector() {
    let vertices = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-4.0, 0.0, 3.0]].map(DVec3::from);
    let mesh = Mesh::<f64>::new(vertices.to_vec(), vec![[0, 1, 2]]).unwrap().smooth();
    assert_eq!(mesh.normals(), Some(&[[DVec3::new(0.6, 0.0, 0.8); 3]][..]));
}

/// By hand: a quarter of X and of Y, which have 0, and half of Z: (¼, ¼, ½), which is √6/4 long.
#[test]
fn a_normal_is_interpolated_between_the_corners() {
    let none = [None; 3];
    let mesh = square().with_normals(&[[Some(DVec3::X), Some(DVec3::Y), Some(DVec3::Z)], none]).unwrap();
    assert_eq!(mesh.normal_at(0, (1.0, 0.0)), Some(DVec3::Y));
    let n = mesh.normal_at(0, (0.25, 0.5)).unwrap();
    // twice as long along z to the last digit, and of length 1 to the roundings of its three components
    assert_eq!((n.y, n.z), (n.x, 2.0 * n.x));
    assert!((n.length_squared() - 1.0).abs() <= 4.0 * f64::EPSILON, "{n}");
    assert_eq!(square().normal_at(0, (0.25, 0.5)), None, "shaded flat");
    let opposite = [[Some(DVec3::X), Some(-DVec3::X), None], none];
    assert_eq!(square().with_normals(&opposite).unwrap().normal_at(0, (0.5, 0.0)), None, "they cancel");
}

/// By hand: d · n = 0, which is not from behind.
#[test]
fn from_the_side_nothing_is_turned() {
    let hit = Hit { t: 1.0, point: DVec3::ZERO, normal: DVec3::Z };
    let found = MeshHit::<f64> { hit, face: 0, alpha_beta: None, shading_normal: DVec3::Y };
    assert_eq!(found.turned_toward(DVec3::X), [DVec3::Z, DVec3::Y]);
}

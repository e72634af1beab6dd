use super::*;
use math::Span;

#[test]
fn the_corners_are_their_colors() {
    let triangle = crate::scene::triangle::<f64>();
    for method in Method::ALL {
        for (point, color) in [
            (triangle.p1, [0, 0, 255]),
            (triangle.p2, [255, 0, 0]),
            (triangle.p3, [0, 255, 0]),
            // by hand: a quarter of p̄1 and p̄3 and half of p̄2; 63.75 and 127.5 to the nearest
            (triangle.p1 * 0.25 + triangle.p2 * 0.5 + triangle.p3 * 0.25, [128, 64, 64]),
        ] {
            let ray = Ray3::<f64>::new(point * 0.5, point);
            let seen = barycentric::color(method, &ray, &triangle);
            assert_eq!(seen, Some(Color(color)), "{}", method.name());
        }
        assert_eq!(barycentric::color(method, &view_ray((0.9, 0.0)), &triangle), None);
    }
}

#[test]
fn the_panels_show_what_they_say() {
    let canvas = draw::<f64>(Method::Robust, (720, 540), None).unwrap();
    let at = |x: f32, y: f32| canvas.pixel(x as u32, y as u32).unwrap();
    let [even_odd, winding] = PENTAGRAMS.map(|part| {
        let (x, y) = stars::pentagram_view(&part).at((1.5, 1.0));
        at(x, y)
    });
    assert_ne!(even_odd, winding, "the middle");
    // beside a ring or a line the worked ray's color is that of α = 1/8, β = 1/2: (32, 128, 96) or near
    let (x, y) = barycentric::view().at((-0.04, 0.1));
    let Color([red, green, blue]) = at(x, y + 22.0);
    assert!(green > red && blue > red, "{red} {green} {blue}");
}

/// Whatever the shape, a pixel's ring is drawn where its ray meets what the picture shows there.
#[test]
fn a_pixel_of_the_triangle_hits_it_at_any_size() {
    for size in [(720, 540), (64, 48), (1600, 300), (120, 400)] {
        let mut canvas = Canvas::new(size, Color::WHITE).unwrap();
        let layout = Layout::of(size);
        canvas.fit(layout.width, layout.height);
        let mut hits = 0;
        for (col, row) in (0..size.0).flat_map(|col| (0..size.1).map(move |row| (col, row))) {
            if !TRIANGLE.holds(canvas.place_of((col, row))) {
                continue;
            }
            let ray = ray_of::<f64>(size, Some((col, row))).unwrap();
            hits += u32::from(
                Method::Matrix.work(&ray, &crate::scene::triangle()).hit(Span::ahead()).unwrap().is_some(),
            );
            if hits > 20 {
                break;
            }
        }
        assert!(hits > 20, "{size:?}");
    }
}

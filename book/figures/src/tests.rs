use super::*;
use affine::figure::Squashed;
use ray_plane::figure::RayAndPlane;
use ray_sphere::figure::RayAndSphere;
use ray_wall::figure::RayAndWall;
use triangle::figure::RayAndTriangle;
use whitted::figure::RayAndSurface;

/// Every method's steps and answers, and the drawing.
fn all<F: Figure>(shown: &mut Shown<F>) -> String {
    let mut text = String::new();
    for method in 0..F::methods().len() {
        shown.choose(method);
        shown.values();
        text += &shown.said;
    }
    shown.drawing();
    text + &shown.said
}

/// Whatever is dragged wherever, onto each other and to the border too, is answered; what moves is seen.
fn is_answered_wherever_it_is<F: Figure>() {
    let mut shown = Shown::<F>::default();
    let start = all(&mut shown);
    assert!(!start.contains("NaN") && !start.contains("no answer"), "{start}");
    let handles = shown.figure.handles().len();
    for number in 0..handles {
        shown.reset();
        shown.nudge(number, 0.1, 0.2);
        assert_ne!(all(&mut shown), start, "handle {number} moves nothing");
        // onto each of the others: a direction, a normal, a radius of zero
        for other in 0..handles {
            shown.reset();
            let (x, y) = shown.figure.handles()[other].place;
            shown.figure.drag(number, (x, y));
            assert!(!all(&mut shown).contains("NaN"), "{number} onto {other}: {}", all(&mut shown));
        }
        for (x, y) in [(0.0, 0.0), (480.0, 0.0), (480.0, 320.0), (0.0, 320.0), (-1e6, 1e6)] {
            shown.drag(number, x, y);
            let drawing = {
                shown.drawing();
                shown.said.clone()
            };
            assert!(!drawing.contains("NaN") && !drawing.contains("inf"), "{number} at {x}, {y}: {drawing}");
            all(&mut shown);
        }
    }
    for dial in 0..shown.figure.dials().len() {
        shown.reset();
        shown.turn(dial, 2.0);
        assert_ne!(all(&mut shown), start, "dial {dial} turns nothing");
        shown.turn(dial, 1e9);
        let Dial { value, most, .. } = shown.figure.dials()[dial].clone();
        assert_eq!(value, most);
    }
    shown.reset();
    assert_eq!(all(&mut shown), start);
    shown.drag(99, 1.0, 1.0);
    shown.choose(99);
    assert_eq!(all(&mut shown), start, "what is not there is not moved");
}

#[test]
fn a_wall_is_answered_wherever_it_is() {
    is_answered_wherever_it_is::<RayAndWall>();
}

#[test]
fn a_plane_is_answered_wherever_it_is() {
    is_answered_wherever_it_is::<RayAndPlane>();
}

#[test]
fn a_sphere_is_answered_wherever_it_is() {
    is_answered_wherever_it_is::<RayAndSphere>();
}

#[test]
fn a_triangle_is_answered_wherever_it_is() {
    is_answered_wherever_it_is::<RayAndTriangle>();
}

#[test]
fn a_squashed_sphere_is_answered_wherever_it_is() {
    is_answered_wherever_it_is::<Squashed>();
}

#[test]
fn a_surface_is_answered_wherever_it_is() {
    is_answered_wherever_it_is::<RayAndSurface>();
}

/// By hand: House's ray meets the wall at t = 3 in (4, 1); without a direction there is no answer.
#[test]
fn what_is_said_is_the_methods_own() {
    let mut shown = Shown::<RayAndWall>::default();
    shown.values();
    assert!(shown.said.contains("<td>t = 3 at (4, 1)</td><td>t = 3 at (4, 1)</td>"), "{}", shown.said);
    assert!(shown.said.contains("<td>(front − p_x) / u_x</td><td>3</td><td>3</td>"), "{}", shown.said);
    shown.nudge(1, -1.0, 0.0);
    shown.values();
    assert!(shown.said.contains("There is no answer: "), "{}", shown.said);
}

/// By hand: 0.48 · 0.13 = 0.39 · 0.16, so that in the plane of the drawing A has no area as the numbers are written. As
/// they are read, one precision finds none and the other a little; each is shown what it has.
#[test]
fn one_precision_may_have_an_answer_where_the_other_has_none() {
    let mut shown = Shown::<Squashed>::default();
    let mut said = Vec::new();
    for [first, second] in [[(0.48, 0.39), (0.16, 0.13)], [(0.36, 0.39), (0.24, 0.26)]] {
        shown.reset();
        shown.figure.drag(0, (0.0, 0.0));
        shown.figure.drag(1, first);
        shown.figure.drag(2, second);
        shown.values();
        assert!(shown.said.contains("<td>"), "steps of the one that has some");
        said.extend(
            ["f32", "f64"].map(|name| shown.said.contains(&format!("There is no answer in {name}: "))),
        );
    }
    assert_eq!(said, [true, false, false, true]);
}

/// The worked example of the triangle is seen at (−1/8, 1/8), its corner p̄1 at (−2/3, −1/3): neither is a hundredth.
#[test]
fn an_arrow_key_moves_along_its_axis_and_no_other() {
    fn of<F: Figure>() {
        for number in 0..F::default().handles().len() {
            let mut shown = Shown::<F>::default();
            let before = shown.figure.handles()[number].place;
            shown.nudge(number, 0.0, 0.1);
            let up = shown.figure.handles()[number].place;
            shown.reset();
            shown.nudge(number, 0.1, 0.0);
            let aside = shown.figure.handles()[number].place;
            assert_eq!((up.0, aside.1), (before.0, before.1), "handle {number}");
        }
    }
    of::<RayAndWall>();
    of::<RayAndPlane>();
    of::<RayAndSphere>();
    of::<RayAndTriangle>();
    of::<Squashed>();
    of::<RayAndSurface>();
}

/// By hand: a ray that climbs 1 on 2 comes at arctan 2 = 63.4° to the normal, and from water (1.33) into air
/// nothing goes through beyond 48.75°.
#[test]
fn from_below_nothing_goes_through_beyond_the_critical_angle() {
    let mut shown = Shown::<RayAndSurface>::default();
    shown.figure.drag(0, (-2.0, -1.0));
    shown.figure.drag(1, (-1.0, -0.5));
    let text = all(&mut shown);
    assert!(text.contains("total internal reflection") && text.contains("48.7535"), "{text}");
}

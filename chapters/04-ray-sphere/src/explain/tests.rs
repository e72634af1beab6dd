//! What the steps say, by hand.

use super::*;
use crate::scene::three_spheres;
use glam::DVec3;

/// By hand: from the center of the red sphere, around (0, −1, 3) with radius 1, along z by twos: out at t = ½.
#[test]
fn from_inside_t_is_where_the_ray_leaves() {
    let ray = Ray3::<f64>::new(DVec3::new(0.0, -1.0, 3.0), DVec3::new(0.0, 0.0, 2.0));
    let [red, ..] = three_spheres::<f64>();
    for (method, expected) in
        [(Method::ClosestApproach, ("t_close + a", 1.0)), (Method::Shortcut, ("(t_close + a) / ‖D‖", 0.5))]
    {
        let mut transcript =
            Transcript { stage: "ray-sphere", method: method.name(), precision: "f64", sections: Vec::new() };
        explain(&mut transcript, method, &ray, &red);
        let steps = &transcript.sections[0].steps;
        let step = |symbol: &str| steps.iter().find(|step| step.symbol == symbol).unwrap();
        assert_eq!((step("t").formula.as_str(), &step("t").value), (expected.0, &Value::number(expected.1)));
        assert_eq!(step("x_hit").value, Value::vector::<f64>(DVec3::new(0.0, -1.0, 4.0)));
    }
}

use super::*;
use crate::{Requirements, Tolerance, Tracer, from_file, render};
use bounds::Bounded;
use stage::{Ask, Chapter};

/// The sections about the pixel (0, 0) of a scene, within a tolerance.
fn sections(text: &str, tolerance: Option<f64>) -> Vec<Section> {
    let file = scene_file::Scene::from_toml("scene.toml", text, std::path::Path::new("")).unwrap();
    let scene = from_file::scene::<f64>(&file, None, None).unwrap();
    let required = Requirements::of(&scene, Parts::of(&scene.lit.geometry).count());
    let bounded = Bounded::new(&scene.lit.geometry, required.bounds());
    let tolerance = tolerance.map(|e| Tolerance::new(&scene, e));
    let tracer = Tracer::new(&scene, &bounded, &required, tolerance);
    let tree = render::tree(&tracer, (0, 0), 1).unwrap();
    let rendered = render::render(&tracer, scene.lit.geometry.size, 1, Some(1), None).unwrap();
    let names = &Names::new(&file, &scene);
    let parts = bounded.all_parts();
    let shot = Shot { scene: &scene, parts, names, pixel: (0, 0), samples: 1, srgb: false, tree: &tree };
    let mut transcript = Transcript::new(&crate::stage::Whitted.about(), &Ask::default());
    pixel(&mut transcript, Method::Robust, &shot, rendered.at((0, 0)));
    rays(&mut transcript, &shot);
    transcript.sections
}

/// Two mirrors that face each other, each ray worth 0.001.
fn hall(depth: u32) -> String {
    let wall = "[[object]]\nmaterial = \"m\"\nplane = { normal = [0, 0, 1], point = ";
    format!(
        "max_depth = {depth}\n[camera]\neye = [0, 0, 0]\nforward = [0, 0, 1]\nsize = [1, 1]\n\
         [material.m]\nambient = 0.001\ndiffuse = 0\nmirror = 1\n{wall}[0, 0, 1] }}\n{wall}[0, 0, -1] }}\n"
    )
}

fn value<'a>(section: &'a Section, symbol: &str) -> &'a Value {
    &section.steps.iter().find(|step| step.symbol == symbol).unwrap().value
}

#[test]
fn a_thousand_rays_end_in_a_table_that_ends() {
    let sections = sections(&hall(1000), None);
    let [first, tree, sums, ray_1, ..] = &sections[..] else { panic!() };
    assert_eq!(value(first, "rays"), &Value::F64(1000.0));
    let Value::Array(channels) = value(first, "Σ w I") else { panic!() };
    let Value::F64(sum) = channels[0] else { panic!() };
    assert!((sum - 1.0).abs() < 1e-13, "{sum}");
    assert_eq!(value(first, "pixel"), &Value::Array(vec![Value::F64(255.0); 3]));
    for section in [tree, sums] {
        let table = section.table.as_ref().unwrap();
        assert_eq!((table.rows.len(), table.in_text), (1000, ROWS), "all in JSON");
        let said = section.remarks.last().unwrap();
        assert!(said.starts_with(&format!("{} more rays are in the table", 1000 - ROWS)), "{said}");
    }
    assert_eq!(ray_1.title, "Ray 1 · eye · depth 1");
    assert_eq!(sections.len(), 3 + 1000);
    assert_eq!(sections.iter().filter(|section| section.in_text).count(), 3 + FULL);
}

/// B(3) = 0.001, B(2) = 0.002: with 0.0015 the third ray is left out, which is said where it would have left.
#[test]
fn what_is_left_out_is_said() {
    let sections = sections(&hall(3), Some(0.0015));
    assert_eq!(value(&sections[0], "left out"), &Value::F64(1.0));
    let ray_2 = &sections[4];
    let m_s = ray_2.steps.iter().find(|step| step.symbol == "m⃗_s").unwrap();
    assert!(m_s.note.starts_with("left out: it could bring 0.00100"), "{}", m_s.note);
    assert!(ray_2.steps.iter().any(|step| step.symbol == "E" && step.formula == "I_l"));
}

/// A local term comes back from its steps: r_a I_a C + Σ V (diffuse + specular).
#[test]
fn the_terms_of_a_ray_add_up() {
    let text = "[camera]\neye = [0, 2, 3]\nlook_at = [0, 0, 0]\nsize = [1, 1]\n\
                [[light]]\nposition = [2, 4, 1]\nintensity = [0.5, 0.25, 1]\n\
                [[light]]\nposition = [0, -4, 0]\nintensity = [1, 1, 1]\n\
                [[light]]\nposition = [-2, 4, 0]\nintensity = [0.25, 1, 1]\n\
                [material.m]\nspecular = 0.5\nshininess = 4\n\
                [[object]]\nmaterial = \"m\"\nplane = { point = [0, 0, 0], normal = [0, 1, 0] }\n\
                [[object]]\nmaterial = \"m\"\nsphere = { center = [-1, 2, 0], radius = 0.5 }\n";
    let sections = sections(text, None);
    let ray = &sections[3];
    let rgb = |symbol: &str| -> Vec<f64> {
        let Value::Array(channels) = value(ray, symbol) else { panic!("{symbol}") };
        channels.iter().map(|channel| if let Value::F64(x) = channel { *x } else { panic!() }).collect()
    };
    // light 1 is seen, light 2 is below the plane, light 3 is behind the sphere
    let v = ["V_1", "V_2", "V_3"].map(|symbol| value(ray, symbol).clone());
    assert_eq!(v, [1.0, 0.0, 0.0].map(Value::F64));
    for channel in 0..3 {
        let sum = rgb("ambient")[channel] + (rgb("diffuse_1")[channel] + rgb("specular_1")[channel]);
        assert_eq!(rgb("I_l")[channel], sum);
    }
    assert!(!ray.steps.iter().any(|step| step.symbol == "diffuse_2" || step.symbol == "diffuse_3"));
}

/// Through a ball of glass with a hollow about its middle: into the glass, into the hollow, out of both.
#[test]
fn the_media_are_said_at_each_crossing() {
    let ball = |material: &str, radius: f64| {
        format!(
            "[[object]]\nmaterial = \"{material}\"\nsphere = {{ center = [0, 0, 0], radius = {radius} }}\n"
        )
    };
    let text = "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nsize = [1, 1]\n\
                [material.g]\ndiffuse = 0\ntransmit = 1\nior = 1.5\n[material.h]\ndiffuse = 0\ntransmit = 1\n"
        .to_string()
        + &ball("g", 2.0)
        + &ball("h", 1.0);
    let sections = sections(&text, None);
    let said: Vec<String> = sections
        .iter()
        .flat_map(|section| section.steps.iter().filter(|step| step.symbol == "media"))
        .map(|step| step.value.to_text())
        .collect();
    let (g, h) = ("1, sphere of g", "2, sphere of h");
    let all = [
        format!("[] → [{g}]"),
        format!("[{g}] → [{g}; {h}]"),
        format!("[{g}; {h}] → [{g}]"),
        format!("[{g}] → []"),
    ];
    assert_eq!(said, all);
}

//! How a surface answers light.
//!
//! POV-Ray multiplies the ambient and the diffuse term by 1 − t where a pigment lets the share t through; our
//! E does not. So they are divided by it, which gives the same sum. Highlight and mirror are not weighted by
//! either.

use scene_file::{Error, Material, Object, Scene};
use signature::Shape;

use super::number::{number, vector};

/// `texture { … }`
pub(super) fn material(it: &Material) -> String {
    let mut pigment = format!("rgb {}", vector(it.color));
    let mut kept = 1.0;
    if it.transmit > 0.0 {
        let [red, green, blue] = it.color.map(number);
        pigment = format!("rgbt <{red},{green},{blue},{}>", number(it.transmit));
        kept = 1.0 - it.transmit;
    }
    let of_kept = |coefficient: f64| number(if coefficient == 0.0 { 0.0 } else { coefficient / kept });
    let mut finish = format!("ambient {} diffuse {}", of_kept(it.ambient), of_kept(it.diffuse));
    if it.specular > 0.0 {
        finish += &format!(" phong {} phong_size {}", number(it.specular), number(it.shininess));
    }
    if it.mirror > 0.0 {
        finish += &format!(" reflection {{ rgb {} }}", number(it.mirror));
    }
    format!("texture {{ pigment {{ {pigment} }} finish {{ {finish} }} }}")
}

/// ` interior { … }` for a solid that light goes through; nothing for a surface, which rays pass unbent.
pub(super) fn interior(shape: &Shape<f64>, it: &Material) -> String {
    let is_solid = match shape {
        Shape::Sphere(_) | Shape::Solid(_) => true,
        Shape::Deformed(deformed) => !deformed.object.is_flat(),
        Shape::Plane(_) | Shape::Triangle(_) | Shape::Polygon(_) | Shape::Mesh(_) | Shape::OpenCone(_) => {
            false
        }
    };
    let bends = is_solid && it.transmit > 0.0;
    if bends { format!(" interior {{ ior {} }}", number(it.ior)) } else { String::new() }
}

/// Refuses what POV-Ray would draw differently.
pub(super) fn check(file: &Scene, object: &Object, it: &Material) -> Result<(), Error> {
    if let Some(texture) = &it.texture {
        let problem = "POV-Ray is told of no textures here";
        return Err(file.fault(texture.place, problem, "take the texture out, or leave the scene out"));
    }
    if it.transmit == 1.0 && it.ambient + it.diffuse > 0.0 {
        let problem = format!("`{}` lets all light through, and POV-Ray then has it return none", it.name);
        let remedy = "make its `ambient` and `diffuse` 0, or its `transmit` less than 1";
        return Err(file.fault(object.place, &problem, remedy));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn scene(material: &str) -> Scene {
        let text = format!(
            "[camera]\neye = [0, 0, 9]\nlook_at = [0, 0, 0]\n[material.it]\n{material}\n\
             [[object]]\nsphere = {{ center = [0, 0, 0], radius = 1 }}\nmaterial = \"it\"\n"
        );
        Scene::from_toml("it.toml", &text, Path::new("")).unwrap()
    }

    fn written(of: &str) -> String {
        material(&scene(of).materials[0])
    }

    #[test]
    fn what_a_matte_material_does_not_have_is_not_written() {
        let want = "texture { pigment { rgb <1,1,1> } finish { ambient 0.1 diffuse 0.9 } }";
        assert_eq!(written(""), want);
    }

    #[test]
    fn all_through_and_nothing_returned_is_said_as_it_is() {
        let want = "texture { pigment { rgbt <1,1,1,1> } finish { ambient 0 diffuse 0 } }";
        assert_eq!(written("ambient = 0\ndiffuse = 0\ntransmit = 1"), want);
    }

    #[test]
    fn what_would_be_drawn_differently_is_refused() {
        let refused = |of: &str| {
            let file = scene(of);
            check(&file, &file.objects[0], &file.materials[0]).unwrap_err().to_string()
        };
        let problem = refused("transmit = 1");
        assert!(problem.starts_with("it.toml:7:1: `it` lets all light through"), "{problem}");
        let problem = refused("texture = { checker = [[1, 1, 1], [0, 0, 0]] }");
        assert!(problem.starts_with("it.toml:5:11: POV-Ray is told of no textures"), "{problem}");
    }
}

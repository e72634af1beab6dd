//! The stage as a whole: what is said is what is drawn, what is counted, and lights where none should be.

use std::path::Path;

use bounds::Bounded;
use math::Real;
use stage::{Ask, Chapter, Precision, Section, Value};

use crate::picture::lighting;
use crate::render::{Rendered, Seen, render};
use crate::stage::Shading;
use crate::{Lighting, Rgb, Scene, Start, from_file, layout, own};

/// The value of the last step of that name.
fn value(sections: &[Section], symbol: &str) -> Option<Value> {
    let mut steps = sections.iter().flat_map(|section| &section.steps);
    steps.rfind(|step| step.symbol == symbol).map(|step| step.value.clone())
}

/// The three bytes that the transcript ends with are those of the picture, in every part of it, by every
/// method.
#[test]
fn what_is_explained_is_what_is_drawn() {
    // all parts; a picture of half that size has room for the scene alone
    let (whole, alone) = ((480, 433), (234, 176));
    let all = layout::parts(whole);
    let mut places: Vec<((u32, u32), (u32, u32))> =
        [(26, 146), (71, 91), (78, 56), (146, 106), (126, 141), (196, 1)]
            .map(|pixel| (alone, pixel))
            .to_vec();
    // each term alone, and a cell of each row, each by another method
    let parts = all[1..5].iter().chain(all[5..].iter().step_by(6));
    places.extend(parts.map(|part| (whole, (part.at.0 + part.size.0 / 2, part.at.1 + part.size.1 / 2))));
    let requests = [(0, Precision::F64, false), (1, Precision::F32, true), (3, Precision::F32, false)];
    for (number, ((method, precision, srgb), &(size, pixel))) in
        requests.into_iter().cycle().zip(&places).enumerate()
    {
        // once with four rays a pixel, which takes four times as long
        let samples = (number == 5).then_some(2);
        let ask =
            Ask { method, precision, size: Some(size), pixel: Some(pixel), srgb, samples, ..Ask::default() };
        let shown = match precision {
            Precision::F32 => Chapter::show::<f32>(&Shading, &ask),
            Precision::F64 => Chapter::show::<f64>(&Shading, &ask),
        };
        let shown = shown.unwrap();
        // beside the ring, where nothing is drawn over it
        let drawn = shown.picture.pixel(pixel.0, pixel.1).unwrap().0;
        let said = value(&shown.transcript.sections, "red, green, blue").unwrap();
        let want = Value::Array(drawn.map(|byte| Value::number(f64::from(byte))).to_vec());
        assert_eq!(said, want, "{ask:?}");
    }
}

fn rendered<R: Real>(scene: &Scene<R>, start: Start, threads: usize) -> Rendered<Seen> {
    let bounded = Bounded::new(&scene.geometry, bounds::Method::Auto);
    render(&lighting(scene, &bounded, start), 1, Some(threads), Seen::clone).unwrap()
}

#[test]
fn the_picture_and_its_counts_do_not_depend_on_the_threads() {
    let scene = from_file::scene::<f64>(&own::file().unwrap(), Some((97, 71))).unwrap();
    let [one, three] = [1, 3].map(|threads| rendered(&scene, Start::Bound, threads));
    assert!(one.pixels == three.pixels && one.work == three.work);
    assert_eq!(one.work.eye_rays, 97 * 71);
}

/// A scene of 40 x 30 pixels from a text.
fn scene<R: Real>(text: &str) -> Scene<R> {
    let camera = "[camera]\neye = [0, 2, 6]\nlook_at = [0, 0.8, 0]\n[material.m]\n";
    let file = scene_file::Scene::from_toml("test", &format!("{camera}{text}"), Path::new("")).unwrap();
    from_file::scene(&file, Some((40, 30))).unwrap()
}

fn light(position: [f64; 3]) -> String {
    format!("[[light]]\nposition = {position:?}\nintensity = [1, 1, 1]\n")
}

const GROUND: &str = "[[object]]\nplane = { point = [0, 0, 0], normal = [0.1, 1, 0.2] }\nmaterial = \"m\"\n";
const BALL: &str = "[[object]]\nsphere = { center = [0, 1, 0], radius = 0.7 }\nmaterial = \"m\"\n";

/// Where r_d + r_s = 0 no light is asked for, unless idle rays are wanted; it looks the same.
#[test]
fn a_surface_that_answers_no_light_asks_for_none() {
    let scene = scene::<f64>(&format!("diffuse = 0\nspecular = 0\n{}{GROUND}{BALL}", light([0.0, 5.0, 3.0])));
    let bounded = Bounded::new(&scene.geometry, bounds::Method::Auto);
    let [sparing, idle] = [false, true].map(|idle_shadows| {
        let lighting = Lighting { idle_shadows, ..lighting(&scene, &bounded, Start::Bound) };
        render(&lighting, 1, Some(1), |seen| seen.e).unwrap()
    });
    assert!(sparing.work.hits > 0);
    assert_eq!(sparing.work.shadow_rays, 0);
    assert!(idle.work.shadow_rays > 0);
    assert!(sparing.pixels == idle.pixels);
}

/// A light at the eye sees what the eye sees: there are no shadows.
#[test]
fn a_light_at_the_eye_casts_no_shadow() {
    fn at_the_eye<R: Real>() {
        let mut file = own::file().unwrap();
        file.lights.truncate(1);
        let mut scene = from_file::scene::<R>(&file, Some((160, 120))).unwrap();
        scene.lights[0].position = scene.geometry.camera.e;
        let work = rendered(&scene, Start::Bound, 2).work;
        assert!(work.shadow_rays > work.hits * 9 / 10, "{work:?}");
        assert_eq!(work.blocked, 0, "{work:?}");
    }
    at_the_eye::<f64>();
    at_the_eye::<f32>();
}

/// From within a ball no light comes out, whoever asks.
#[test]
fn a_light_inside_of_a_ball_lights_nothing_outside() {
    let scene = scene::<f64>(&format!("{}{GROUND}{BALL}", light([0.1, 1.2, 0.0])));
    for start in [Start::Bound, Start::Exclude, Start::None] {
        let rendered = rendered(&scene, start, 1);
        assert!(rendered.pixels.iter().all(|seen| seen.lit.largest() <= 0.0), "{start:?}");
        assert!(rendered.work.blocked > 0, "the ground asks, and the ball is in the way");
    }
}

/// A light that lies on a surface is not behind it: what looks at it is lit, but for the surface itself, for
/// which it is level.
#[test]
fn a_light_on_a_surface_is_seen_from_before_it() {
    let ground = "[[object]]\nplane = { point = [0, 0, 0], normal = [0, 1, 0] }\nmaterial = \"m\"\n";
    let scene = scene::<f64>(&format!("{}{ground}{BALL}", light([0.0, 0.0, 2.5])));
    let lit = rendered(&scene, Start::Bound, 1);
    let of = |object: usize| {
        let pixels = (0..30).flat_map(|row| (0..40).map(move |col| (col, row)));
        let seen =
            |pixel: &(u32, u32)| scene.geometry.seen(signature::Method::Robust, *pixel) == Some(object);
        pixels.filter(seen).filter(|&pixel| lit.at(pixel).lit.largest() > 0.0).count()
    };
    assert!(of(1) > 20, "{}", of(1));
    assert_eq!(of(0), 0);
}

/// Of two surfaces in one place the earlier is seen, and neither shades the other.
#[test]
fn coincident_surfaces_are_one() {
    let lights = light([3.0, 5.0, 4.0]);
    let work = |objects: &str| rendered(&scene::<f64>(&format!("{lights}{objects}")), Start::Bound, 1);
    let (once, twice) = (work(&format!("{GROUND}{BALL}")), work(&format!("{GROUND}{GROUND}{BALL}{BALL}")));
    assert!(once.pixels == twice.pixels && once.work.blocked > 0);
}

/// Lights that no number can reach from a point, a light at a point that is seen, and a scene without any
/// light.
#[test]
fn odd_lights_are_no_trouble() {
    let far = [1e308, 1e308, 1e308];
    for lights in [light(far), light([0.0, 1.0, 0.7]) + &light([0.0, 2.0, 6.0]), String::new()] {
        let scene = scene::<f64>(&format!("{lights}{GROUND}{BALL}"));
        for start in Start::ALL {
            for seen in rendered(&scene, start, 1).pixels {
                assert!(seen.e.0.iter().all(|channel| channel.is_finite() && *channel >= 0.0), "{seen:?}");
            }
        }
    }
}

/// What a small picture of the chapter's scene takes and shows, wherever its second rays start: the rays, the tests, and the
/// sums of all pixels, term by term, to their last digits.
#[test]
fn what_a_picture_takes() {
    fn lines<R: Real>() -> String {
        let scene = from_file::scene::<R>(&own::file().unwrap(), Some((64, 48))).unwrap();
        let line = |start: Start| {
            let Rendered { pixels, work, .. } = rendered(&scene, start, 2);
            let sum = |term: fn(&Seen) -> Rgb| {
                pixels.iter().fold([0.0; 3], |sum: [f64; 3], seen| {
                    let term = term(seen).0;
                    [sum[0] + term[0], sum[1] + term[1], sum[2] + term[2]]
                })
            };
            let [ambient, diffuse, specular] =
                [sum(|it| it.ambient), sum(|it| it.diffuse), sum(|it| it.specular)];
            format!(
                "{} {}: {work:?}\n  E {:?}\n  ambient {ambient:?}, diffuse {diffuse:?}\n  specular {specular:?}\n",
                start.name(),
                R::NAME,
                sum(|it| it.e)
            )
        };
        Start::ALL.into_iter().map(line).collect()
    }
    insta::assert_snapshot!(lines::<f64>() + &lines::<f32>());
}

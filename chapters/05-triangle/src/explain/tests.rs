use stage::{Ask, Chapter, Precision};

use super::*;
use crate::picture::ray_of;
use crate::stage::RayTriangle;

fn shown(method: Method, precision: Precision, size: (u32, u32), pixel: Option<(u32, u32)>) -> Transcript {
    let place = Method::ALL.iter().position(|&other| other == method).unwrap();
    let mut transcript = Transcript::new(
        &RayTriangle.about(),
        &Ask { method: place, precision, size: Some(size), pixel, ..Ask::default() },
    );
    match precision {
        Precision::F32 => explain(&mut transcript, method, &ray_of::<f32>(size, pixel).unwrap()),
        Precision::F64 => explain(&mut transcript, method, &ray_of::<f64>(size, pixel).unwrap()),
    }
    transcript
}

fn value(section: &Section, symbol: &str) -> String {
    let step = section.steps.iter().find(|step| step.symbol == symbol);
    step.unwrap_or_else(|| panic!("no {symbol}")).value.to_text()
}

/// By hand: n⃗ = (0, 8, 12), (p̄1 − ā) · n⃗ = −33 and d⃗ · n⃗ = −11; α = 1/8 and β = 1/2.
#[test]
fn the_worked_example_by_every_method() {
    for precision in Precision::ALL {
        for (method, symbols) in [
            (Method::HalfPlanes, [("(p̄1 − ā) · n⃗", "−33"), ("d⃗ · n⃗", "−11"), ("λ*", "3")]),
            (Method::Matrix, [("det_λ", "−33"), ("det M", "−11"), ("λ", "3")]),
            (Method::Robust, [("v", "−1.375"), ("d⃗ · n⃗", "−11"), ("λ", "3")]),
        ] {
            let transcript = shown(method, precision, (720, 540), None);
            let first = &transcript.sections[0];
            for (symbol, text) in symbols.into_iter().chain([("α", "0.125"), ("β", "0.5")]) {
                assert_eq!(value(first, symbol), text, "{} {symbol}", method.name());
            }
            assert_eq!(value(first, "x_hit"), "(−0.5, 0.5, −4)");
        }
    }
}

/// The page's two questions, and what is not one of them.
#[test]
fn parallel_rays_have_their_verdicts() {
    for method in Method::ALL {
        for precision in Precision::ALL {
            let transcript = shown(method, precision, (8, 6), None);
            let is_question = |section: &&Section| section.title.starts_with("What does it mean");
            let table = transcript.sections.iter().find(is_question).unwrap().table.as_ref().unwrap();
            let verdicts: Vec<String> = table.rows.iter().map(|row| row[4].to_text()).collect();
            let expected = ["hit", "hit", "miss", "parallel", "in-plane", "in-plane", "in-plane", "hit"];
            assert_eq!(verdicts, expected, "{}", method.name());
        }
    }
}

/// Through every pixel there is a ray with a verdict, and nothing is NaN or minus zero; with n⃗ = (0, 8, 12) the row of y = 1.5 is
/// parallel, and out of the picture but for tall ones.
#[test]
fn every_pixel_is_explained() {
    for method in Method::ALL {
        for size in [(8, 6), (2, 40), (24, 3)] {
            for pixel in (0..size.0).flat_map(|col| (0..size.1).map(move |row| (col, row))) {
                let transcript = shown(method, Precision::F32, size, Some(pixel));
                let text = transcript.to_string();
                let minus_zero = text.split([' ', '\n', '(', ')', ',']).any(|word| word == "−0");
                assert!(!text.contains("NaN") && !minus_zero, "{pixel:?}:\n{text}");
                value(&transcript.sections[0], "x_hit");
            }
        }
    }
    let mut transcript = shown(Method::Matrix, Precision::F64, (8, 6), None);
    let level = crate::scene::view_ray::<f64>((0.25, 1.5));
    for method in Method::ALL {
        explain(&mut transcript, method, &level);
        let text = transcript.to_string();
        assert!(!text.contains("NaN") && text.contains("parallel"), "{text}");
    }
}

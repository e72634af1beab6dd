use std::io::Read;
use std::path::PathBuf;

use flate2::read::ZlibDecoder;

use super::*;
use crate::{About, Ink, Sketch, Transcript};

/// A picture whose rays say where they are; the ray of one pixel cannot be looked at.
struct Places {
    size: (u32, u32),
    bad: Option<(u32, u32)>,
}

impl Inspect for Places {
    fn size(&self) -> (u32, u32) {
        self.size
    }

    fn first(&self) -> (u32, u32) {
        (0, 0)
    }

    fn caption(&self) -> &'static str {
        "d < r & more"
    }

    fn look(&self, pixel: (u32, u32)) -> Result<Look, Error> {
        if self.bad == Some(pixel) {
            return Err(Error::Failed("no thread".to_string()));
        }
        let mut section = Section::new("<b>", "");
        section.number("col", "", f64::from(pixel.0)).number("row", "", f64::from(pixel.1));
        let mut sketch = Sketch::new((0.0, 0.0), (1.0, 1.0));
        sketch.dot((0.5, 0.5), Ink::Ray);
        let color = Color([pixel.0 as u8, pixel.1 as u8, 7]);
        Ok(Look { color, sections: vec![section], drawing: sketch.into_svg() })
    }
}

fn about() -> About {
    About {
        number: 4,
        name: "places",
        teaches: "where pixels are",
        notes: "",
        methods: vec!["notes"],
        size: (1, 1),
        picture: "",
        flags: &[],
        inputs: &[],
        words: &[],
        results: &[],
        trade: "",
        regimes: Vec::new(),
    }
}

/// A page in a folder of its own, which is empty but for it.
fn page(name: &str, rays: &Places) -> (PathBuf, Result<String, Error>) {
    let folder = std::env::temp_dir().join(format!("stage-inspect-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("page.html");
    let written = write_page(&path, &about(), &Transcript::new(&about(), &Ask::default()), rays);
    (folder, written.map(|()| std::fs::read_to_string(path).unwrap()))
}

/// What stands between two texts, the first time.
fn between<'a>(text: &'a str, start: &str, end: &str) -> &'a str {
    text.split_once(start).unwrap().1.split_once(end).unwrap().0
}

fn bytes(base64: &str) -> Vec<u8> {
    let letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let bits: String = base64
        .chars()
        .filter_map(|letter| letters.find(letter))
        .map(|place| format!("{place:06b}"))
        .collect();
    bits.as_bytes()
        .chunks_exact(8)
        .map(|eight| u8::from_str_radix(std::str::from_utf8(eight).unwrap(), 2).unwrap())
        .collect()
}

/// The pixel as its page has it.
fn unpacked(page: &str, (col, row): (u32, u32)) -> serde_json::Value {
    let packed = between(page, &format!(" id=\"r{row}-{}\">", col / 64), "<");
    let mut lines = String::new();
    ZlibDecoder::new(&bytes(packed)[..]).read_to_string(&mut lines).unwrap();
    serde_json::from_str(lines.lines().nth(col as usize % 64).unwrap()).unwrap()
}

#[test]
fn every_pixel_is_in_its_place() {
    let (folder, page) = page("whole", &Places { size: (130, 3), bad: None });
    let page = page.unwrap();
    for pixel in [(0, 0), (63, 0), (64, 1), (127, 2), (129, 2)] {
        let look = unpacked(&page, pixel);
        let [col, row] = [pixel.0, pixel.1].map(|place| place.to_string());
        let steps = serde_json::json!([["col", "", col, ""], ["row", "", row, ""]]);
        assert_eq!(look["sections"], serde_json::json!([["<b>", "", steps, [], [], []]]), "{pixel:?}");
        assert_eq!(look["drawing"], "<circle class=\"ray dot\" cx=\"240\" cy=\"160\" r=\"3.2\"/>");
    }
    let png = bytes(between(&page, "data:image/png;base64,", "\""));
    let picture = image::load_from_memory(&png).unwrap().into_rgb8();
    assert_eq!((picture.dimensions(), picture.get_pixel(129, 2).0), ((130, 3), [129, 2, 7]));
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_page_needs_nothing_but_itself_and_keeps_text_text() {
    let (folder, page) = page("alone", &Places { size: (1, 1), bad: None });
    let page = page.unwrap();
    assert!(page.contains("d &lt; r &amp; more") && !page.contains("d < r"));
    for outside in ["http:", "https:", "url(", "@import", "<link"] {
        assert!(!page.contains(outside), "{outside}");
    }
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_page_is_the_same_every_time() {
    let rays = Places { size: (70, 2), bad: None };
    let [(folder, one), (other_folder, other)] = [page("one", &rays), page("other", &rays)];
    assert_eq!(one.unwrap(), other.unwrap());
    std::fs::remove_dir_all(folder).unwrap();
    std::fs::remove_dir_all(other_folder).unwrap();
}

#[test]
fn a_ray_that_fails_leaves_no_page_and_is_the_cause() {
    let (folder, page) = page("failed", &Places { size: (3, 3), bad: Some((1, 2)) });
    assert_eq!(page.unwrap_err().to_string(), "no thread");
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 0);
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn without_a_size_a_page_takes_every_kth_pixel() {
    let middle = |(width, height): (u32, u32)| (width / 2, height / 2);
    let inspected = |ask: &Ask, own| ask.to_inspect(own, middle).unwrap();
    let all = Ask::default();
    assert_eq!(inspected(&all, (540, 540)), ((180, 180), (90, 90)));
    assert_eq!(inspected(&all, (960, 720)), ((192, 144), (96, 72)));
    assert_eq!(inspected(&all, (3, 2)), ((3, 2), (1, 1)));
    assert_eq!(inspected(&all, (1 << 28, 1)), ((1 << 15, 1), (1 << 14, 0)));
    let asked = Ask { size: Some((400, 300)), pixel: Some((399, 299)), ..Ask::default() };
    assert_eq!(inspected(&asked, (3, 2)), ((400, 300), (399, 299)));
    let pixel = Ask { pixel: Some((539, 0)), ..Ask::default() };
    assert_eq!(inspected(&pixel, (540, 540)), ((180, 180), (179, 0)));
    assert!(pixel.to_inspect((10, 10), middle).is_err_and(|error| error.status() == 2));
}

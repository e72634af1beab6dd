//! The page itself: the packed rays, the picture, and the script that unpacks a ray.

use std::io::{self, Write};
use std::path::Path;

use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageError};
use serde::ser::{Serialize, SerializeMap, SerializeTuple, Serializer};

use super::packed::{Base64, Packed};
use super::{Inspect, Look};
use crate::pixels::reserved;
use crate::sketch::escaped;
use crate::{About, Error, Progress, SKETCH, Section, Step, Transcript, Value, write_whole};

/// So many pixels of a row are packed together: few enough to be unpacked at once, many enough that what they
/// have in common is worth little.
const STRIP: u32 = 64;

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// Writes the page, ray by ray: of the rays no more than one is held at a time, of the picture three bytes a
/// pixel.
///
/// [`Error::Failed`] where the file cannot be written, or a ray cannot be looked at; then the file is what it
/// was before.
pub(crate) fn write_page(
    path: &Path,
    about: &About,
    shown: &Transcript,
    rays: &dyn Inspect,
) -> Result<(), Error> {
    // What ended the page, where it was not the file.
    let mut failed = None;
    let mut picture = reserved(3, rays.size())?;
    let written = write_whole(path, |page| {
        let kept = rays_of(page, rays, &mut picture, &mut failed);
        kept.and_then(|()| body(page, about, shown, rays, &picture))
    });
    match failed {
        Some(error) => Err(error),
        None => written,
    }
}

/// The head, and the packed rays: a strip of pixels is a script that no browser runs.
fn rays_of(
    page: &mut dyn Write,
    rays: &dyn Inspect,
    picture: &mut Vec<u8>,
    failed: &mut Option<Error>,
) -> io::Result<()> {
    head(page)?;
    let (width, height) = rays.size();
    let progress = Progress::patient(height.into(), "inspector");
    for row in 0..height {
        for first in (0..width).step_by(STRIP as usize) {
            write!(page, "<script type=\"application/zlib\" id=\"r{row}-{}\">", first / STRIP)?;
            let mut packed = Packed::new(&mut *page);
            for col in first..width.min(first + STRIP) {
                let look = rays.look((col, row)).map_err(|error| {
                    *failed = Some(error);
                    io::Error::other("a ray could not be looked at")
                })?;
                picture.extend(look.color.0);
                // a line at once: each write costs the packer the same
                let mut line = serde_json::to_vec(&look)?;
                line.push(b'\n');
                packed.write_all(&line)?;
            }
            packed.finish()?;
            writeln!(page, "</script>")?;
        }
        progress.done();
    }
    Ok(())
}

fn head(page: &mut dyn Write) -> io::Result<()> {
    write!(
        page,
        r#"<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy"
 content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<style>
{STYLE}</style>
"#
    )
}

/// What is seen of the page.
fn body(
    page: &mut dyn Write,
    about: &About,
    shown: &Transcript,
    rays: &dyn Inspect,
    picture: &[u8],
) -> io::Result<()> {
    let (number, name, teaches) = (about.number, escaped(about.name), escaped(about.teaches));
    let (method, precision) = (escaped(shown.method), escaped(shown.precision));
    let ((width, height), (col, row)) = (rays.size(), rays.first());
    let (ground, caption) = (rays.ground(), escaped(rays.caption()));
    let (last_col, last_row) = (width - 1, height - 1);
    write!(
        page,
        r#"<title>{name}: the inspector</title>
</head>
<body>
<header>
<h1><span class="number">{number:02}</span> {name}: the inspector</h1>
<p>{teaches}. Method <b>{method}</b>, {precision}, {width} × {height} pixels.</p>
</header>
<main>
<section class="picture" aria-label="Picture">
<div id="frame" tabindex="0" role="application" aria-label="The picture" aria-describedby="keys"
 data-width="{width}" data-height="{height}" data-col="{col}" data-row="{row}" data-strip="{STRIP}">
<img alt="The picture, one ray a pixel" width="{width}" height="{height}" draggable="false"
 src="data:image/png;base64,"#
    )?;
    let mut base64 = Base64::new(&mut *page);
    let png = PngEncoder::new(&mut base64).write_image(picture, width, height, ExtendedColorType::Rgb8);
    png.map_err(|error| match error {
        ImageError::IoError(error) => error,
        other => io::Error::other(other),
    })?;
    base64.finish()?;
    write!(
        page,
        r#"">
<div id="mark"></div>
</div>
<p><label for="pixel">Pixel, column,row</label>
<input id="pixel" value="{col},{row}" autocomplete="off" spellcheck="false" aria-describedby="range">
<span id="range">0,0 to {last_col},{last_row}</span></p>
<p id="keys">Point at a pixel; a click holds it, another lets go; a tap shows it. On the picture the arrow
keys move by a pixel, with Shift by ten.</p>
</section>
<section class="drawing" aria-label="Drawing">
<svg id="drawing" viewBox="0 0 {} {}" role="img" aria-label="{caption}"><g>{ground}</g><g id="ray"></g></svg>
<p>{caption}</p>
</section>
<section id="steps" aria-label="Steps" aria-live="polite"><noscript>The steps of a pixel are unpacked by a
script, and scripts are off. <code>cargo run -p {name} -- --method {method} --precision {precision}
--size {width}x{height} --pixel {col},{row}</code>, with what else this page was made with, prints them.</noscript></section>
</main>
<script>
{SCRIPT}</script>
</body>
</html>
"#,
        SKETCH.0, SKETCH.1
    )
}

impl Serialize for Look {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let sections: Vec<Brief<'_>> = self.sections.iter().map(Brief).collect();
        let mut map = serializer.serialize_map(Some(2))?;
        map.serialize_entry("sections", &sections)?;
        map.serialize_entry("drawing", &self.drawing)?;
        map.end()
    }
}

/// A section as the terminal shows it, in a list: title, source, steps, columns, rows, remarks.
struct Brief<'a>(&'a Section);

impl Serialize for Brief<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Section { title, source, steps, table, remarks, .. } = self.0;
        let step = |Step { symbol, formula, value, note }: &Step| {
            [symbol.clone(), formula.clone(), value.to_text(), note.clone()]
        };
        let steps: Vec<[String; 4]> = steps.iter().map(step).collect();
        let texts = |row: &Vec<Value>| row.iter().map(Value::to_text).collect();
        let rows: Vec<Vec<String>> =
            table.iter().flat_map(|table| table.rows.iter().take(table.in_text).map(texts)).collect();
        let columns = table.as_ref().map_or(&[][..], |table| &table.columns);
        let mut list = serializer.serialize_tuple(6)?;
        list.serialize_element(title)?;
        list.serialize_element(source)?;
        list.serialize_element(&steps)?;
        list.serialize_element(columns)?;
        list.serialize_element(&rows)?;
        list.serialize_element(remarks)?;
        list.end()
    }
}

//! The gallery: one page with every picture, every transcript and every trade, and the ways into the book and
//! to the inspectors. It opens from disk, and needs neither a network nor a script.

use std::io::{self, Write};

use stage::{Flag, escaped};

use crate::drawings;
use crate::run::{Finished, book_page, inspector_page, trade_drawing};

/// How the page looks, at any width, in light and in dark.
const STYLE: &str = include_str!("gallery.css");

/// Writes the page, HTML in UTF-8. Its pictures are expected beside it, as `NAME.png`, and its drawings as
/// `trade/NAME.svg`. The error is that of `page`.
pub fn write(finished: &[Finished], page: &mut dyn Write) -> io::Result<()> {
    let title = "First Hit: the stages";
    writeln!(
        page,
        r#"<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{title}</title>
<style>
{STYLE}</style>
</head>
<body>
<header>
<h1>{title}</h1>
<p>Ray tracing, one concept at a time. Every stage follows the worked example of the notes:
its picture, each intermediate value in the notes’ own symbols, and what speed costs in accuracy.
All of them again: <code>cargo run --release</code></p>
</header>"#
    )?;
    contents(finished, page)?;
    writeln!(page, "<main>")?;
    for stage in finished {
        section(stage, page)?;
    }
    writeln!(page, "</main>\n</body>\n</html>")
}

/// The table of contents.
fn contents(finished: &[Finished], page: &mut dyn Write) -> io::Result<()> {
    writeln!(page, "<nav aria-label=\"Stages\">\n<ol>")?;
    for Finished { about, .. } in finished {
        let (number, name, teaches) = (about.number, escaped(about.name), escaped(about.teaches));
        writeln!(
            page,
            r##"<li><a href="#{name}"><span class="number">{number:02}</span> {name}</a> <span>{teaches}</span></li>"##
        )?;
    }
    writeln!(page, "</ol>\n</nav>")
}

/// One stage: what it teaches, its picture, its transcript.
fn section(stage: &Finished, page: &mut dyn Write) -> io::Result<()> {
    let Finished { about, transcript, size: (width, height), .. } = stage;
    let (number, name) = (about.number, escaped(about.name));
    let (teaches, notes, picture) = (escaped(about.teaches), escaped(about.notes), escaped(about.picture));
    let (method, precision) = (escaped(transcript.method), escaped(transcript.precision));
    let transcript = escaped(&transcript.to_string());
    let (chapter, inspector, trade) = (chapter(stage), inspector(stage), trade(stage));
    // The caption says what the alternative text says, so a screen reader hears it once.
    writeln!(
        page,
        r#"<section id="{name}" aria-labelledby="{name}-title">
<h2 id="{name}-title"><span class="number">{number:02}</span> {name}</h2>
<p class="teaches">{teaches}</p>
<dl>
<div><dt>Notes</dt><dd>{notes}</dd></div>
<div><dt>Method</dt><dd>{method}, {precision}</dd></div>
<div><dt>Command</dt><dd><code>cargo run -p {name}</code></dd></div>
{chapter}{inspector}</dl>
<div class="work">
<figure>
<a href="{name}.png"><img src="{name}.png" width="{width}" height="{height}" alt="{picture}"></a>
<figcaption aria-hidden="true">{picture}</figcaption>
</figure>
<pre tabindex="0" role="region" aria-label="Transcript of {name}">{transcript}</pre>
</div>
{trade}</section>"#
    )
}

/// The way to the book's chapter, or how to make the book.
fn chapter(stage: &Finished) -> String {
    let name = escaped(stage.about.name);
    let way = match stage.in_book {
        true => {
            format!(r#"<a href="{}">the derivation, the code, the questions</a>"#, escaped(&book_page(&name)))
        }
        false => "<code>cargo run -p book</code> makes the book".to_string(),
    };
    format!("<div><dt>Book</dt><dd>{way}</dd></div>\n")
}

/// The way to the page of every pixel's ray, or how to make it; nothing for a stage that makes none.
fn inspector(stage: &Finished) -> String {
    if !stage.about.flags.contains(&Flag::Inspect) {
        return String::new();
    }
    let (name, page) = (escaped(stage.about.name), inspector_page(stage.about.name));
    let place = escaped(&stage.picture.with_file_name(&page).display().to_string());
    let way = match stage.inspected {
        true => format!(r#"<a href="{}">every pixel’s ray, step by step</a>"#, escaped(&page)),
        false => format!(
            "<code>cargo run -p {name} -- --inspect {place}</code> lets you look at every pixel’s ray"
        ),
    };
    format!("<div><dt>Inspector</dt><dd>{way}</dd></div>\n")
}

/// What `trade` drew, the upper part of it where it is long.
fn trade(stage: &Finished) -> String {
    let Some((width, height)) = drawings::trade_of(stage.about.name).and_then(drawings::size) else {
        return String::new();
    };
    let (name, drawing) = (escaped(stage.about.name), escaped(&trade_drawing(stage.about.name)));
    let measured = escaped(stage.about.trade);
    format!(
        r#"<figure class="trade">
<a href="{drawing}"><img src="{drawing}" width="{width}" height="{height}" loading="lazy"
 alt="Speed for accuracy: the trade of {name}, the whole drawing"></a>
<figcaption>Speed for accuracy, as measured for the book; the whole drawing is behind it. {measured}
Your own machine: <code>cargo run --release -p {name} -- trade</code></figcaption>
</figure>
"#
    )
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use stage::{Ask, Stage};

    use super::*;
    use crate::stages;

    /// With a small picture, as nobody looks at it.
    fn finished(stage: &dyn Stage) -> Finished {
        let about = stage.about();
        let shown = stage.show(&Ask { size: Some((96, 72)), ..Ask::default() }).unwrap();
        let picture = PathBuf::from(about.name).with_extension("png");
        let (transcript, size) = (shown.transcript, shown.picture.size());
        Finished { about, transcript, picture, size, in_book: false, inspected: false }
    }

    fn page(finished: &[Finished]) -> String {
        let mut page = Vec::new();
        write(finished, &mut page).unwrap();
        String::from_utf8(page).unwrap()
    }

    /// What stands between `start` and the next quote, wherever `start` is.
    fn quoted<'a>(page: &'a str, start: &str) -> Vec<&'a str> {
        page.split(start).skip(1).filter_map(|rest| rest.split('"').next()).collect()
    }

    #[test]
    fn escaped_text_has_no_markup_left() {
        assert_eq!(escaped(r#"d < r & 'a' > "b""#), "d &lt; r &amp; &#39;a&#39; &gt; &quot;b&quot;");
        assert_eq!(escaped("‖x_close − c‖"), "‖x_close − c‖");
    }

    /// Every link leads to a place in the page or to what lies beside it, and nowhere else.
    #[test]
    fn every_link_resolves() {
        let mut finished: Vec<Finished> = stages::ALL.iter().map(|stage| finished(*stage)).collect();
        let with_inspector = |it: &&mut Finished| it.about.flags.contains(&Flag::Inspect);
        let inspected = finished.iter_mut().filter(with_inspector).map(|it| it.inspected = true).count();
        finished[2].in_book = true;
        let page = page(&finished);
        let places = quoted(&page, " id=\"");
        let links: Vec<&str> =
            [" href=\"", " src=\""].iter().flat_map(|start| quoted(&page, start)).collect();
        let pages = inspected + 1;
        assert_eq!(links.len(), 5 * finished.len() + pages, "contents, picture, drawing and their links");
        for link in links {
            let found = match link.strip_prefix('#') {
                Some(place) => places.contains(&place),
                None => finished.iter().any(|Finished { about, picture, in_book, inspected, .. }| {
                    picture == Path::new(link)
                        || trade_drawing(about.name) == link
                        || *in_book && book_page(about.name) == link
                        || *inspected && inspector_page(about.name) == link
                }),
            };
            assert!(found, "{link}");
        }
        assert!(!STYLE.contains("url(") && !STYLE.contains("@import"));
        assert_eq!(places.len(), places.iter().collect::<std::collections::HashSet<_>>().len());
    }

    #[test]
    fn stages_stand_in_the_order_given_with_all_they_say() {
        let finished: Vec<Finished> = stages::ALL.iter().map(|stage| finished(*stage)).collect();
        let page = page(&finished);
        let mut rest = page.split_once("<main>").unwrap().1;
        for Finished { about, transcript, .. } in &finished {
            for part in [about.name, about.teaches, about.notes, about.picture, &transcript.to_string()] {
                rest = rest.split_once(&escaped(part)).unwrap_or_else(|| panic!("{part}")).1;
            }
        }
    }

    /// What is not there is not linked, but said how to make; a stage without an inspector says nothing of
    /// one.
    #[test]
    fn what_is_not_there_has_a_command() {
        let [wall, sphere] = [stages::ALL[1], stages::ALL[3]].map(finished);
        let [of_wall, of_sphere] = [page(&[wall]), page(&[sphere])];
        assert!(of_wall.contains("<code>cargo run -p book</code>") && !of_wall.contains("Inspector"));
        let command = "<code>cargo run -p ray-sphere -- --inspect ray-sphere-inspect.html</code>";
        assert!(of_sphere.contains(command), "{of_sphere}");
    }

    /// Markup in any text that a stage gives stays text.
    #[test]
    fn nothing_a_stage_says_becomes_markup() {
        let mut stage = finished(stages::ALL[0]);
        let nasty = "\"><script>x</script>";
        (stage.about.teaches, stage.about.notes, stage.about.picture) = (nasty, nasty, nasty);
        stage.transcript.section(nasty, nasty).remark(nasty);
        let page = page(&[stage]);
        assert!(!page.contains("<script"), "{page}");
        assert!(!page.contains(nasty));
    }
}

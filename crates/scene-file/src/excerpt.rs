//! The line that is to blame, as rustc would show it.

use std::ops::Range;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

use crate::source::{Source, Spot, boundary, first_line, line_start};

/// So many bytes of a line are looked at on either side of where a place starts: a file may be all one line.
const CONTEXT: usize = 1 << 12;

/// A title, the line of the spot with the spot underlined, the line of the other spot, the remedy.
pub(crate) fn render(title: &str, spot: Spot, remedy: &str, also: Option<(Spot, &str)>) -> String {
    let main = Excerpt::new(spot);
    let mut lines = vec![main.snippet().annotation(AnnotationKind::Primary.span(main.marked.clone()))];
    if let Some((spot, label)) = also {
        let mark = |span| AnnotationKind::Context.span(span).label(label);
        match main.find(spot) {
            Some(span) => lines = vec![lines.remove(0).annotation(mark(span))],
            None => {
                let other = Excerpt::new(spot);
                lines.push(other.snippet().path(&spot.source.name).annotation(mark(other.marked.clone())));
            }
        }
    }
    let title = Level::ERROR.no_name().primary_title(title);
    Renderer::plain().render(&[title.elements(lines).element(Level::HELP.message(remedy))])
}

/// Part of one line of a file.
struct Excerpt<'a> {
    source: &'a Source,
    /// Which bytes of the file.
    bytes: Range<usize>,
    /// What of them is underlined.
    marked: Range<usize>,
}

impl<'a> Excerpt<'a> {
    fn new(spot: Spot<'a>) -> Excerpt<'a> {
        let (text, before) = (&spot.source.text, spot.source.before(spot.place.start));
        let middle = before.len();
        let start = line_start(before).max(boundary(text, middle.saturating_sub(CONTEXT)));
        let rest = first_line(&text[middle..boundary(text, middle + CONTEXT)]);
        let (from, marked) = (middle - start, spot.text().len().min(rest.len()));
        Excerpt { source: spot.source, bytes: start..middle + rest.len(), marked: from..from + marked }
    }

    /// Where in the excerpt a spot is, if it is there.
    fn find(&self, spot: Spot) -> Option<Range<usize>> {
        let (start, end) = (spot.place.start, spot.place.start + spot.text().len());
        let within =
            std::ptr::eq(spot.source, self.source) && self.bytes.start <= start && end <= self.bytes.end;
        within.then(|| start - self.bytes.start..end - self.bytes.start)
    }

    fn snippet<T: Clone>(&self) -> Snippet<'a, T> {
        let line = self.source.line(self.bytes.start);
        Snippet::source(&self.source.text[self.bytes.clone()]).line_start(line)
    }
}

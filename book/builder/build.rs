//! The whole way: pages filled, made into HTML beside the place, judged, and moved there.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::fs;
use std::io::{Error, ErrorKind};
use std::path::{Path, PathBuf};
use std::rc::Rc;

use cutter::named::Sources;
use mdbook_driver::MDBook;
use mdbook_driver::book::{Book, BookItem};
use mdbook_driver::errors::Result as Done;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};
use stage::Scratch;

use crate::figures::Figures;
use crate::page::{Filler, place};
use crate::shown::Shown;
use crate::{Fault, links, pictures};

/// Builds the book of the project at `root` into the folder `out`.
///
/// Where anything is wrong, all of it is told, and what was in `out` before stays. An older book there is replaced;
/// a folder with anything else in it is refused. Where the program is interrupted, what was begun is removed, see
/// [`stage::clean_up_when_interrupted`].
pub fn build(root: &Path, out: &Path) -> Result<(), Vec<Fault>> {
    let whole = |what: String| vec![Fault::new("book", 0, what)];
    taken(out).map_or(Ok(()), |what| Err(whole(what)))?;
    let failed =
        |error: Error| whole(format!("cannot put the book at {}: {error}; write elsewhere", out.display()));
    let new = aside(out, "new");
    let beside = Scratch::new(|| fs::create_dir_all(&new).map(|()| new.clone())).map_err(failed)?;
    into(root, beside.path(), &whole)?;
    swap(out, beside.path()).map_err(failed)
}

/// Why a book cannot be put at `out`; `None` where there is nothing, nothing in it, or an older book.
fn taken(out: &Path) -> Option<String> {
    let place = out.display();
    if out.file_name().is_none() {
        return Some(format!("a book has a folder of its own: name it, as {place}/book"));
    }
    let mut entries = match fs::read_dir(out) {
        Ok(entries) => entries,
        Err(error) if error.kind() == ErrorKind::NotFound => return None,
        Err(error) => return Some(format!("cannot put the book at {place}: {error}; name another folder")),
    };
    let is_book =
        ["index.html", "toc.html", "katex/katex.min.js"].iter().all(|file| out.join(file).is_file());
    let is_free = is_book || entries.next().is_none();
    (!is_free)
        .then(|| format!("{place} holds something that is no book, and would be lost; name another folder"))
}

/// Puts the new book in its place. What is there is moved away first, and removed when the new one stands.
fn swap(out: &Path, new: &Path) -> std::io::Result<()> {
    if !out.exists() {
        return fs::rename(new, out);
    }
    let old = aside(out, "old");
    fs::rename(out, &old)?;
    if let Err(error) = fs::rename(new, out) {
        fs::rename(&old, out)?;
        return Err(error);
    }
    fs::remove_dir_all(old)
}

/// A folder beside the place, on the same disk.
fn aside(out: &Path, what: &str) -> PathBuf {
    let name = out.file_name().unwrap_or_default().to_string_lossy();
    out.with_file_name(format!(".{name}.{}-{what}", std::process::id()))
}

fn into(root: &Path, folder: &Path, whole: &dyn Fn(String) -> Vec<Fault>) -> Result<(), Vec<Fault>> {
    let seen = Rc::new(RefCell::new(Seen::default()));
    let mut book = MDBook::load(root.join("book")).map_err(|error| whole(format!("{error:#}")))?;
    book.config.build.build_dir = folder.to_path_buf();
    book.with_preprocessor(Fill { root: root.to_path_buf(), seen: Rc::clone(&seen) });
    let built = book.build();
    let Seen { pictures, faults } = seen.take();
    if !faults.is_empty() {
        return Err(faults);
    }
    built.map_err(|error| whole(format!("{error:#}")))?;
    pictures::draw(&pictures, &folder.join("pictures")).map_err(whole)?;
    let faults = links::faults(folder).map_err(whole)?;
    if faults.is_empty() { Ok(()) } else { Err(faults) }
}

/// What the pages needed, and what was wrong with them.
#[derive(Default)]
struct Seen {
    pictures: BTreeSet<String>,
    faults: Vec<Fault>,
}

/// Fills every page.
struct Fill {
    root: PathBuf,
    seen: Rc<RefCell<Seen>>,
}

impl Preprocessor for Fill {
    fn name(&self) -> &str {
        "fill"
    }

    fn run(&self, _: &PreprocessorContext, mut book: Book) -> Done<Book> {
        let mut seen = self.seen.borrow_mut();
        let sources = match Sources::read(&self.root) {
            Ok(sources) => sources,
            Err(what) => {
                seen.faults.push(Fault::new("book", 0, what));
                return Ok(book);
            }
        };
        let figures = Figures::of(&self.root);
        let filler = Filler { root: &self.root, sources: &sources, figures, shown: Shown::default() };
        book.for_each_mut(|item| {
            let BookItem::Chapter(chapter) = item else { return };
            let Some(path) = &chapter.source_path else { return };
            match filler.page(&place(path), &chapter.content) {
                Ok(page) => {
                    chapter.content = page.text;
                    seen.pictures.extend(page.pictures);
                }
                Err(faults) => seen.faults.extend(faults),
            }
        });
        Ok(book)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_book_is_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("out");
        assert_eq!(taken(&out), None, "nothing there");
        fs::create_dir(&out).unwrap();
        assert_eq!(taken(&out), None, "nothing in it");
        fs::write(out.join("letter.txt"), "dear").unwrap();
        assert!(taken(&out).is_some_and(|why| why.contains("would be lost")));
        assert!(build(folder.path(), &out).is_err() && out.join("letter.txt").is_file());
        for file in ["index.html", "toc.html"] {
            fs::write(out.join(file), "").unwrap();
        }
        fs::create_dir(out.join("katex")).unwrap();
        fs::write(out.join("katex/katex.min.js"), "").unwrap();
        assert_eq!(taken(&out), None, "an older book");
        for nameless in [".", "..", "/"] {
            assert!(taken(Path::new(nameless)).is_some_and(|why| why.contains("a folder of its own")));
        }
        assert!(taken(&out.join("letter.txt")).is_some());
    }

    #[test]
    fn the_new_book_takes_the_old_ones_place() {
        let folder = tempfile::tempdir().unwrap();
        let [out, new] = ["out", "new"].map(|name| folder.path().join(name));
        for (place, text) in [(&out, "old"), (&new, "new")] {
            fs::create_dir(place).unwrap();
            fs::write(place.join("index.html"), text).unwrap();
        }
        swap(&out, &new).unwrap();
        assert_eq!(fs::read_to_string(out.join("index.html")).unwrap(), "new");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "the old one is gone");
        assert!(swap(&out, &new).is_err(), "there is no new one");
        assert_eq!(fs::read_to_string(out.join("index.html")).unwrap(), "new", "and this one stays");
    }
}

//! The whole way: pages filled, made into HTML beside the place, judged, and moved there.

use std::cell::RefCell;
use std::fs;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use mdbook_driver::MDBook;
use mdbook_driver::book::{Book, BookItem};
use mdbook_driver::errors::Result as Done;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};

use crate::figures::Figures;
use crate::named::Sources;
use crate::page::{Filler, place};
use crate::shown::Shown;
use crate::{Fault, links, pictures};

/// Builds the book of the project at `root` into the folder `out`.
///
/// Where anything is wrong, all of it is told, and what was in `out` before stays.
pub fn build(root: &Path, out: &Path) -> Result<(), Vec<Fault>> {
    let whole = |what: String| vec![Fault::new("book", 0, what)];
    let aside = aside(out);
    let made = into(root, &aside, &whole).and_then(|()| {
        let swap = || {
            if out.exists() {
                fs::remove_dir_all(out)?;
            }
            fs::rename(&aside, out)
        };
        swap().map_err(|error| whole(format!("cannot put the book at {}: {error}", out.display())))
    });
    if made.is_err() {
        // What is half made is of no use to anyone, and what cannot be removed does no harm.
        let _ = fs::remove_dir_all(&aside);
    }
    made
}

/// A folder beside the place, on the same disk.
fn aside(out: &Path) -> PathBuf {
    let name = out.file_name().unwrap_or_default().to_string_lossy();
    out.with_file_name(format!(".{name}.{}", std::process::id()))
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
    pictures: Vec<String>,
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

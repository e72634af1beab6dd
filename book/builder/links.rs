//! The links of the built book: each leads to a file or a place within one.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

use crate::Fault;

/// Every link and every source of a page that leads nowhere.
///
/// What leads to another host is let through as a link, and is a fault where the page itself would load it.
pub(crate) fn faults(book: &Path) -> Result<Vec<Fault>, String> {
    let mut pages = BTreeMap::new();
    let mut files = BTreeSet::new();
    let mut open = vec![book.to_path_buf()];
    while let Some(path) = open.pop() {
        let trouble = |error: std::io::Error| format!("{}: {error}", path.display());
        if path.is_dir() {
            open.extend(fs::read_dir(&path).map_err(trouble)?.filter_map(|entry| Some(entry.ok()?.path())));
            continue;
        }
        let inside = path.strip_prefix(book).unwrap_or(&path).to_path_buf();
        if path.extension().is_some_and(|it| it == "html") {
            pages.insert(inside.clone(), fs::read_to_string(&path).map_err(trouble)?);
        }
        files.insert(inside);
    }
    let places: BTreeMap<&PathBuf, BTreeSet<&str>> =
        pages.iter().map(|(page, text)| (page, attributes(text, "id").collect())).collect();
    let mut found = Vec::new();
    for (page, text) in &pages {
        // one page that repeats all the others, for paper
        if page == Path::new("print.html") {
            continue;
        }
        for (link, is_loaded) in attributes(text, "href")
            .map(|link| (link, false))
            .chain(attributes(text, "src").map(|link| (link, true)))
        {
            if let Some(what) = fault(page, link, is_loaded, &files, &places) {
                found.push(Fault::new(page, 0, what));
            }
        }
    }
    Ok(found)
}

fn fault(
    page: &Path,
    link: &str,
    is_loaded: bool,
    files: &BTreeSet<PathBuf>,
    places: &BTreeMap<&PathBuf, BTreeSet<&str>>,
) -> Option<String> {
    if link.starts_with("data:") {
        return None;
    }
    if link.contains("://") || link.starts_with("//") {
        return is_loaded.then(|| format!("{link} would be loaded from a network"));
    }
    let (file, place) = link.split_once('#').unwrap_or((link, ""));
    let target = match file {
        "" => page.to_path_buf(),
        file => joined(page, file),
    };
    if !files.contains(&target) {
        return Some(format!("{link} leads to {}, which is not there", target.display()));
    }
    let is_there = place.is_empty() || places.get(&target).is_some_and(|places| places.contains(place));
    (!is_there).then(|| format!("{link}: {} has no place #{place}", target.display()))
}

/// A link as seen from the folder of its page.
fn joined(page: &Path, link: &str) -> PathBuf {
    let mut target = page.parent().unwrap_or(Path::new("")).to_path_buf();
    for part in Path::new(link).components() {
        match part {
            Component::ParentDir => {
                target.pop();
            }
            Component::Normal(name) => target.push(name),
            _ => {}
        }
    }
    if link.ends_with('/') || target == Path::new("") { target.join("index.html") } else { target }
}

/// What an attribute is in every element of a page, outside scripts.
fn attributes<'a>(page: &'a str, name: &'a str) -> impl Iterator<Item = &'a str> {
    let tags = page.split('<').filter(|tag| tag.starts_with(|sign: char| sign.is_ascii_alphabetic()));
    tags.filter_map(move |tag| {
        let tag = tag.split('>').next()?;
        let start = tag.find(&format!(" {name}=\""))? + name.len() + 3;
        tag[start..].split('"').next()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(pages: &[(&str, &str)]) -> Vec<String> {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in pages {
            let place = folder.path().join(name);
            fs::create_dir_all(place.parent().unwrap()).unwrap();
            fs::write(place, text).unwrap();
        }
        faults(folder.path()).unwrap().iter().map(ToString::to_string).collect()
    }

    #[test]
    fn links_that_hold() {
        let a = "<h1 id=\"top\">A</h1><a href=\"b/c.html#there\">c</a><a href=\"#top\"></a><img src=\"p.png\">\
                 <a href=\"https://example.org/\">out</a>";
        let c = "<p id=\"there\"></p><a class=\"x\" href=\"../a.html\">a</a>";
        assert_eq!(found(&[("a.html", a), ("b/c.html", c), ("p.png", "")]), [""; 0]);
    }

    #[test]
    fn links_that_do_not() {
        let a = "<a href=\"b.html\">b</a><a href=\"#here\"></a><img src=\"https://example.org/p.png\">";
        let expected = [
            "a.html: b.html leads to b.html, which is not there",
            "a.html: #here: a.html has no place #here",
            "a.html: https://example.org/p.png would be loaded from a network",
        ];
        assert_eq!(found(&[("a.html", a)]), expected);
    }
}

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
    let mut loaded = Vec::new();
    while let Some(path) = open.pop() {
        let trouble = |error: std::io::Error| format!("{}: {error}", path.display());
        if path.is_dir() {
            open.extend(fs::read_dir(&path).map_err(trouble)?.filter_map(|entry| Some(entry.ok()?.path())));
            continue;
        }
        let inside = path.strip_prefix(book).unwrap_or(&path).to_path_buf();
        if path.extension().is_some_and(|it| it == "css") {
            let text = fs::read_to_string(&path).map_err(trouble)?;
            loaded.extend(from_elsewhere(&text).map(|what| Fault::new(&inside, 0, what)));
        }
        if path.extension().is_some_and(|it| it == "html") {
            pages.insert(inside.clone(), fs::read_to_string(&path).map_err(trouble)?);
        }
        files.insert(inside);
    }
    let places: BTreeMap<&PathBuf, BTreeSet<&str>> =
        pages.iter().map(|(page, text)| (page, attributes(text, "id").collect())).collect();
    let mut found = loaded;
    for (page, text) in &pages {
        // one page that repeats all the others, for paper
        if page == Path::new("print.html") {
            continue;
        }
        for (link, is_loaded) in links(text) {
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

/// Every link of a page, and whether the page loads what it leads to by itself.
fn links(page: &str) -> impl Iterator<Item = (&str, bool)> {
    tags(page).flat_map(|tag| {
        let is_loaded = tag.starts_with("link ");
        let href = attribute(tag, "href").map(|link| (link, is_loaded));
        let others = ["src", "poster", "data", "srcset"].into_iter();
        href.into_iter().chain(others.filter_map(|name| Some((attribute(tag, name)?, true))))
    })
}

/// What a style sheet would load from a network.
fn from_elsewhere(style: &str) -> impl Iterator<Item = String> {
    let named = ["url(", "@import"].into_iter().flat_map(|start| style.split(start).skip(1));
    named.filter_map(|rest| {
        let place = rest.trim_start_matches([' ', '"', '\'', '(']).split(['"', '\'', ')', ';']).next()?;
        let is_elsewhere = place.contains("://") || place.starts_with("//");
        (is_elsewhere && !place.starts_with("data:"))
            .then(|| format!("{place} would be loaded from a network"))
    })
}

/// What an attribute is in every element of a page, outside scripts.
fn attributes<'a>(page: &'a str, name: &'a str) -> impl Iterator<Item = &'a str> {
    tags(page).filter_map(move |tag| attribute(tag, name))
}

fn tags(page: &str) -> impl Iterator<Item = &str> {
    let tags = page.split('<').filter(|tag| tag.starts_with(|sign: char| sign.is_ascii_alphabetic()));
    tags.filter_map(|tag| tag.split('>').next())
}

fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let start = tag.find(&format!(" {name}=\""))? + name.len() + 3;
    tag[start..].split('"').next()
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

    #[test]
    fn what_a_page_or_a_style_would_fetch() {
        let a = "<link rel=\"stylesheet\" href=\"https://example.org/a.css\"><a href=\"https://example.org/\">out</a>";
        let style = "@import \"//example.org/b.css\"; p { background: url('https://example.org/p.png') } \
                     i { background: url(p.png) url(data:x) }";
        let expected = [
            "a.css: https://example.org/p.png would be loaded from a network",
            "a.css: //example.org/b.css would be loaded from a network",
            "a.html: https://example.org/a.css would be loaded from a network",
        ];
        assert_eq!(found(&[("a.html", a), ("a.css", style)]), expected);
    }
}

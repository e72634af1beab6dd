//! What every exercise keeps to, as far as its text tells.

use std::path::PathBuf;

use cutter::formulas::{comments, formulas, plain};
use cutter::source::Files;
use cutter::{Manifest, Source, cut, docs, statements};

fn source() -> Source {
    Source::at(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../.."))
}

/// The files of a hand-out that have code of the chapter.
fn chapters_files(source: &Source, exercise: &Manifest) -> Files {
    let mut files = exercise.library(source, &exercise.questions()).unwrap();
    files.remove("probe.rs");
    files
}

/// What the student is told: the task, the questions, the words of `[docs]`, and the formulas that the probe
/// writes beside the values.
fn told(source: &Source, exercise: &Manifest) -> String {
    let questions = exercise.regions(source).unwrap().into_iter().map(|region| region.question);
    let probe = source.read(&exercise.probe()).unwrap();
    let docs = exercise.docs.values().flat_map(|words| words.values().cloned());
    plain(&format!("{} {probe} {}", exercise.task, questions.chain(docs).collect::<Vec<_>>().join(" ")))
}

/// What a hand-out leaves unsaid, by the words in its `[docs]`, no other comment says: neither as the page
/// writes it nor as the region's code and its comments do. What the task tells is no secret.
#[test]
fn no_comment_has_the_formula_that_is_asked_for() {
    let source = source();
    let (mut looked_for, mut found) = (0, Vec::new());
    for exercise in Manifest::all(&source).unwrap() {
        let mut answers = Vec::new();
        for (file, words) in exercise.docs.iter().filter(|(file, _)| !file.starts_with("given/")) {
            let text = source.read(&format!("{}/src/{file}", exercise.folder)).unwrap();
            answers.extend(formulas(&comments(&docs::unsaid(&text, words).unwrap())));
        }
        for region in exercise.regions(&source).unwrap() {
            answers.extend(formulas(&comments(&region.lines)));
            answers
                .extend(statements(&region).unwrap().iter().map(|it| plain(it)).filter(|it| it.len() >= 5));
        }
        let told = told(&source, &exercise);
        answers.retain(|it| !told.contains(it.as_str()));
        looked_for += answers.len();
        for (path, text) in chapters_files(&source, &exercise) {
            let said = plain(&comments(&text));
            let leaks = answers.iter().filter(|it| said.contains(it.as_str()));
            found.extend(leaks.map(|it| format!("{}: a comment in {path} has {it}", exercise.name)));
        }
    }
    assert!(looked_for > 200, "{looked_for} formulas");
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// The names of the values that a region makes: what its `let`s bind, and the fields of its last expression.
fn made(region: &cut::Region) -> Vec<String> {
    fn bound(pattern: &syn::Pat, names: &mut Vec<String>) {
        match pattern {
            syn::Pat::Ident(it) => names.push(it.ident.to_string()),
            syn::Pat::Type(it) => bound(&it.pat, names),
            syn::Pat::Tuple(it) => it.elems.iter().for_each(|it| bound(it, names)),
            syn::Pat::Slice(it) => it.elems.iter().for_each(|it| bound(it, names)),
            _ => {}
        }
    }
    let block: syn::Block = syn::parse_str(&format!("{{\n{}}}", region.lines)).unwrap();
    let mut names = Vec::new();
    for statement in &block.stmts {
        match statement {
            syn::Stmt::Local(it) => bound(&it.pat, &mut names),
            syn::Stmt::Expr(syn::Expr::Struct(it), None) => {
                // `ray: *ray` makes nothing
                let copies =
                    |it: &&syn::FieldValue| matches!(it.expr, syn::Expr::Unary(_) | syn::Expr::Path(_));
                let fields = it.fields.iter().filter(|it| !copies(it));
                names.extend(fields.filter_map(|it| match &it.member {
                    syn::Member::Named(name) => Some(name.to_string()),
                    syn::Member::Unnamed(_) => None,
                }));
            }
            _ => {}
        }
    }
    names
}

/// Of the values that are asked for no comment gives the formula, if the task does not tell it: neither what
/// is said of a field of that name, nor an equation that begins with it.
#[test]
fn what_is_asked_for_is_said_without_its_formula() {
    let source = source();
    let (mut count, mut found) = (0, Vec::new());
    for exercise in Manifest::all(&source).unwrap() {
        let (files, told) = (chapters_files(&source, &exercise), told(&source, &exercise));
        for (file, regions) in exercise.asks(&source).unwrap() {
            let all = comments(&files[&file]);
            let clauses = all.split(['\n', ',', ';', ':', '`']).flat_map(|clause| clause.split(" and "));
            let equations = clauses.filter_map(|clause| clause.split_once('='));
            let equations: Vec<(&str, &str)> = equations.collect();
            for name in regions.iter().flat_map(made) {
                count += 1;
                let named = [(name.clone(), String::new())].into_iter().collect();
                let mut said = formulas(&comments(&docs::unsaid(&files[&file], &named).unwrap()));
                let is_it = |left: &str| left.split_whitespace().last().is_some_and(|it| plain(it) == name);
                let of_it = equations.iter().filter(|(left, _)| is_it(left));
                said.extend(of_it.flat_map(|(_, right)| formulas(right)));
                said.retain(|it| !told.contains(it.as_str()));
                found.extend(
                    said.into_iter().map(|it| format!("{}: {file} says of {name} {it}", exercise.name)),
                );
            }
        }
    }
    assert!(count > 100, "{count} values");
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// What earlier exercises of a chapter ask comes along solved; what later ones ask is hidden, where the file
/// comes along.
#[test]
fn what_later_exercises_of_the_chapter_ask_is_hidden() {
    let source = source();
    let all = Manifest::all(&source).unwrap();
    let mut count = 0;
    for (place, exercise) in all.iter().enumerate() {
        for later in all[place + 1..].iter().filter(|it| it.chapter == exercise.chapter) {
            for name in &later.holes {
                let here = exercise.file_of(&source, name);
                if here.is_ok() && here == later.file_of(&source, name) && !exercise.holes.contains(name) {
                    count += 1;
                    let (one, other) = (&exercise.name, &later.name);
                    assert!(exercise.hides.contains(name), "{one} has {name} of {other} solved: `hides` it");
                }
            }
        }
        for name in &exercise.hides {
            let asks = |it: &&Manifest| it.chapter == exercise.chapter && it.holes.contains(name);
            assert!(all[place + 1..].iter().any(|it| asks(&it)), "{} hides {name} for nobody", exercise.name);
        }
    }
    assert!(count > 0);
}

/// Nobody gets points for the answer that is shown.
#[test]
fn every_property_has_a_case_that_is_not_shown() {
    for exercise in Manifest::all(&source()).unwrap() {
        for asked in &exercise.properties {
            assert!(asked.cases.len() > 1, "{}, {}: its only case is shown", exercise.name, asked.name);
            let same = asked.cases[1..].iter().any(|case| *case == asked.cases[0]);
            assert!(!same, "{}, {}: the shown case is there twice", exercise.name, asked.name);
        }
    }
}

/// Where several values share a question each says which it is.
#[test]
fn no_two_holes_ask_the_same() {
    let source = source();
    for exercise in Manifest::all(&source).unwrap() {
        for (path, text) in chapters_files(&source, &exercise) {
            let mut asked: Vec<&str> =
                text.lines().filter_map(|line| line.split_once("todo!(\"")).map(|it| it.1).collect();
            asked.retain(|question| !question.starts_with("nothing is to be done here"));
            let count = asked.len();
            asked.sort();
            asked.dedup();
            assert_eq!(asked.len(), count, "{}: {path} asks something twice", exercise.name);
        }
    }
}

/// Regions are named once in a chapter's file, and all of them are somebody's.
#[test]
fn every_region_is_asked_for() {
    let source = source();
    let all = Manifest::all(&source).unwrap();
    for exercise in &all {
        let path = format!("{}/src/{}", exercise.folder, exercise.file);
        for region in cut::regions(&source.read(&path).unwrap()).unwrap() {
            let asks = |it: &&Manifest| it.folder == exercise.folder && it.holes.contains(&region.name);
            assert!(all.iter().any(|it| asks(&it)), "{path}: nobody asks for {}", region.name);
        }
    }
}

//! No hand-out has a line of a solution in it, in any of its files.

use cutter::cut::{squeezed, statements};
use homework::Catalog;
use rayon::prelude::*;

/// What is shorter than this, without white space, says nothing: `d.dot(d)` is in every file.
const SHORT: usize = 12;

#[test]
fn no_hand_out_contains_a_solutions_lines() {
    let catalog = Catalog::read().unwrap();
    catalog.exercises.par_iter().for_each(|exercise| {
        let name = &exercise.manifest.name;
        let files = homework::hand_out(&catalog, exercise).unwrap();
        let squeezed: Vec<_> = files.iter().map(|(path, text)| (path, squeezed(text))).collect();
        let mut looked_for = 0;
        for region in exercise.manifest.regions(&catalog.source).unwrap() {
            for statement in statements(&region).unwrap().iter().filter(|it| it.len() >= SHORT) {
                looked_for += 1;
                for (path, text) in &squeezed {
                    assert!(!text.contains(statement.as_str()), "{name}: {path} has {statement}");
                }
            }
        }
        assert!(looked_for > 0, "{name}: its solution is too short to be looked for");
        for (path, text) in &files {
            for mark in ["// exercise ", "cfg(test)"] {
                assert!(!text.contains(mark), "{name}: {path} has {mark}");
            }
        }
    });
}

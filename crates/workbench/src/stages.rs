//! The stages there are.

use stage::Stage;

/// Every stage, in the order of the book.
pub static ALL: &[&dyn Stage] = &[
    pinhole::stage::STAGE,
    ray_wall::stage::STAGE,
    ray_plane::stage::STAGE,
    ray_sphere::stage::STAGE,
    triangle::stage::STAGE,
    quadric::stage::STAGE,
    affine::stage::STAGE,
    signature::stage::STAGE,
    bounds::stage::STAGE,
    shading::stage::STAGE,
    whitted::stage::STAGE,
];

/// The names of them all.
pub fn names() -> Vec<&'static str> {
    ALL.iter().map(|stage| stage.about().name).collect()
}

/// The stages with these names, in the order of the book, each once; all of them where no name is
/// given. A name that no stage has is passed over.
pub fn named(names: &[&str]) -> Vec<&'static dyn Stage> {
    let wanted = |stage: &&dyn Stage| names.is_empty() || names.contains(&stage.about().name);
    ALL.iter().copied().filter(wanted).collect()
}

/// How many columns the longest of some names takes.
pub(crate) fn widest<'a>(names: impl IntoIterator<Item = &'a str>) -> usize {
    names.into_iter().map(str::len).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_is_in_the_order_of_the_book() {
        let numbers: Vec<u32> = ALL.iter().map(|stage| stage.about().number).collect();
        assert!(numbers.is_sorted_by(|a, b| a < b), "{numbers:?}");
    }

    #[test]
    fn a_name_means_one_stage() {
        for name in names() {
            assert_eq!(named(&[name, name]).len(), 1, "{name}");
        }
        assert_eq!(named(&[]).len(), ALL.len());
    }
}

//! The bounds of this chapter, and which of them a scene requires.

/// What is around the objects, by the names that `--method` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// What the scene requires.
    Auto,
    /// Nothing: every ray is tried on every object.
    None,
    /// A sphere around each object.
    Sphere,
    /// A box around each object.
    Box,
    /// The rectangle of pixels in which each object may be seen.
    Extents,
    /// A tree of boxes, two by two.
    Tree,
    /// A tree of boxes, eight by eight.
    Wide,
}

/// From so many parts on a tree of eight by eight is faster than trying them all; with fewer none is built.
///
/// Measured by `cargo run --release -p bounds -- trade`, whose line `crossover` names the number of spheres
/// from which on `wide` takes less time than `none`.
pub const CROSSOVER: usize = 32;

impl Method {
    /// Every method, the default first, then in the order of the page and of what follows from it.
    pub const ALL: [Method; 7] = [
        Method::Auto,
        Method::None,
        Method::Sphere,
        Method::Box,
        Method::Extents,
        Method::Tree,
        Method::Wide,
    ];

    /// The name that `--method` takes.
    pub fn name(self) -> &'static str {
        match self {
            Method::Auto => "auto",
            Method::None => "none",
            Method::Sphere => "sphere",
            Method::Box => "box",
            Method::Extents => "extents",
            Method::Tree => "tree",
            Method::Wide => "wide",
        }
    }

    /// What a scene of so many parts requires: nothing below [`CROSSOVER`], else a tree.
    pub fn required(parts: usize) -> Method {
        if parts < CROSSOVER { Method::None } else { Method::Wide }
    }

    /// The method itself, or what a scene of so many parts requires in place of [`Method::Auto`].
    pub fn or_required(self, parts: usize) -> Method {
        if self == Method::Auto { Method::required(parts) } else { self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_spheres_require_no_tree() {
        assert_eq!(Method::required(3), Method::None);
        assert_eq!(Method::required(7382), Method::Wide);
        assert_eq!(Method::required(CROSSOVER - 1), Method::None);
        assert_eq!(Method::required(CROSSOVER), Method::Wide);
        assert_eq!(Method::Tree.or_required(3), Method::Tree, "what is asked for is done");
    }
}

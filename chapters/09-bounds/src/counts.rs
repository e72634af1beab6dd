//! Count before you time.

/// What a search did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Bounds that were tested: boxes, spheres, or rectangles of pixels.
    pub boxes: u64,
    /// Objects that were tested, of a mesh its faces.
    pub tests: u64,
    /// Tests that met their object, in the span that was left.
    pub hits: u64,
}

/// Who counts: [`Counts`], or [`Uncounted`], which costs nothing as nothing is left of it in the compiled
/// program.
pub trait Tally {
    /// So many more bounds were tested.
    fn boxes(&mut self, more: usize);
    /// So many more objects were tested, of a mesh its faces.
    fn tests(&mut self, more: usize);
    /// One more object was hit.
    fn hit(&mut self);
}

/// Nobody counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Uncounted;

impl Tally for Counts {
    #[inline(always)]
    fn boxes(&mut self, more: usize) {
        self.boxes += more as u64;
    }
    #[inline(always)]
    fn tests(&mut self, more: usize) {
        self.tests += more as u64;
    }
    #[inline(always)]
    fn hit(&mut self) {
        self.hits += 1;
    }
}

impl Tally for Uncounted {
    #[inline(always)]
    fn boxes(&mut self, _more: usize) {}
    #[inline(always)]
    fn tests(&mut self, _more: usize) {}
    #[inline(always)]
    fn hit(&mut self) {}
}

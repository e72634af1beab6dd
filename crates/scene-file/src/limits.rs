//! How much a scene may hold. Everything is bounded before memory is taken for it.

/// Bytes of a scene in TOML. Its tree takes some 60 bytes of memory a byte for objects as people write them, and at most
/// some 420, for tables within tables with one letter each; 65535 objects, as many as there are ids, take 6 MB of text.
pub(crate) const TOML_BYTES: u64 = 8 << 20;

/// Bytes of a scene in NFF.
pub(crate) const NFF_BYTES: u64 = 256 << 20;

/// Objects, materials or lights of a scene in NFF.
pub(crate) const NFF_THINGS: usize = 1 << 22;

/// Bytes of all the meshes and pictures of a scene together.
pub(crate) const ASSET_BYTES: u64 = 256 << 20;

/// Faces of all the meshes of a scene together, fans counted triangle by triangle.
pub(crate) const FACES: usize = 1 << 23;

/// Pixels of all the pictures of a scene together.
pub(crate) const TEXELS: u64 = 1 << 26;

/// Bytes that decoding one picture may take, whatever it carries beside its pixels.
pub(crate) const PICTURE_MEMORY: u64 = 512 << 20;

/// Pixels of what a camera sees.
pub(crate) const PIXELS: u64 = 1 << 28;

//! How much a scene may hold. Everything is bounded before memory is taken for it.

/// Bytes of a scene in TOML; 65535 objects, as many as there are ids, take 6 MB of text.
pub(crate) const TOML_BYTES: u64 = 8 << 20;

/// Bytes that the tables and lists of a scene in TOML may take, however short its text.
pub(crate) const TREE_BYTES: usize = 32 << 20;

/// And so many for each byte of the text. Objects as people write them take some 40; tables within tables of one
/// letter each would take 400.
pub(crate) const TREE_BYTES_A_BYTE: usize = 64;

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

//! From where a scene is seen.

use crate::{At, Place};

/// The camera of a scene file.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// Where the file describes it.
    pub place: Place,
    /// ē, in the world.
    pub eye: At<[f64; 3]>,
    /// Where it looks.
    pub view: At<View>,
    /// What points up in the picture, of any length but 0.
    pub up: At<[f64; 3]>,
    /// Which way is right.
    pub handedness: Handedness,
    /// From the eye to the view plane, above 0, in units of the scene.
    pub distance: At<f64>,
    /// How much of the view plane is seen.
    pub extent: At<Extent>,
    /// Columns and rows: neither 0, at most 2^28 pixels in all.
    pub size: At<(u32, u32)>,
    /// Where in a pixel its ray goes.
    pub grid: At<Grid>,
}

/// Where a camera looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum View {
    /// At a point of the world.
    At([f64; 3]),
    /// Along a direction of any length but 0.
    Forward([f64; 3]),
}

/// How much of the view plane is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// Height 1 about the axis, the width by the picture's aspect.
    Height1,
    /// Left, right, bottom and top on the view plane, in units of the scene: left < right, bottom < top.
    Window([f64; 4]),
    /// NFF's `angle`: the full vertical angle in degrees, above 0 and below 180; the width by the picture's aspect.
    Angle(f64),
}

/// Which way is right when one looks forward with up above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handedness {
    /// forward × up
    Right,
    /// up × forward: Gambetta's axes.
    Left,
}

/// Where the rays of a row of pixels go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grid {
    /// Through the middle of each pixel (House).
    Centers,
    /// From edge to edge (CSC418).
    Edges,
    /// Through Gambetta's corners.
    Lattice,
}

//! Which ray belongs to a pixel? The pinhole camera, and three grids of pixels.
//!
//! A pinhole throws an upside-down picture on the film behind it. Computer graphics moves the view
//! plane in front, where the picture stands upright; the similar triangles are the same ([`project`]).
//! To cast a ray from the eye through a point of the view plane is that projection read backwards
//! ([`cast_through`]).
//!
//! Where on the view plane a pixel lies is a matter of taste, and each of the three notes has its own:
//! [`house`] takes the centers of the pixels, [`gambetta`] a lattice of their corners, [`csc418`] a
//! grid from edge to edge. Each returns a struct with every number on the way to the ray, by the
//! formula of its page. (Later chapters take the same points from [`math::Grid`].) Two pages go on to the
//! loop over the pixels, [`house::raycast`] and [`gambetta::main_method`], and [`letter`] is what there is
//! to see.
//!
//! The lowest row of a window of four by four pixels, one unit away, and its column at the right:
//!
//! ```
//! use glam::DVec3;
//! use math::Window;
//! use pinhole::house_pixel;
//!
//! let window = Window { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 };
//! let work = house_pixel::<f64>(&window, 1.0, (4, 4), (0, 3));
//! assert_eq!(work.pixwidth, 0.5);
//! assert_eq!(work.p, DVec3::new(0.75, -0.75, -1.0));
//! ```

pub mod csc418;
#[cfg(feature = "stage")]
mod explain;
pub mod gambetta;
pub mod house;
pub mod letter;
#[cfg(feature = "stage")]
mod measure;
#[cfg(feature = "stage")]
mod picture;
pub mod projection;
#[cfg(feature = "stage")]
mod report;
#[cfg(feature = "stage")]
pub mod stage;

pub use csc418::{Csc418Pixel, csc418_pixel};
pub use gambetta::{GambettaPixel, canvas_coordinates, canvas_to_viewport};
pub use house::{HousePixel, house_pixel, house_row};
pub use projection::{CastThrough, Projection, cast_through, project};

//! A scene from what a file says: the numbers in the precision of the rays, and what means nothing refused at its
//! place.

mod camera;
mod object;

use math::Real;
use scene_file::Error;

use crate::Scene;

pub use object::transform;

/// The scene of a file, for a picture of `size` = (columns, rows), neither 0; `None`: of the size that the
/// file says.
///
/// An [`Error`] with its place where the camera has no frame, no rays or no such grid, where a shape has no
/// extent or is no polygon or mesh, where a transform has no inverse, and where a number is too large for R.
pub fn scene<R: Real>(file: &scene_file::Scene, size: Option<(u32, u32)>) -> Result<Scene<R>, Error> {
    let size = size.unwrap_or(file.camera.size.value);
    let (camera, grid) = camera::camera(file, size)?;
    let objects = file.objects.iter().map(|it| object::object(file, it)).collect::<Result<_, _>>()?;
    Ok(Scene { camera, grid, size, objects })
}

/// A point or vector in R.
fn vector<R: Real>([x, y, z]: [f64; 3]) -> R::Vec3 {
    R::vec3(R::round_from(x), R::round_from(y), R::round_from(z))
}

/// What to do about numbers of which R keeps too little: `mend` them, or take a precision that keeps more where there is
/// one.
fn or_f64<R: Real>(mend: &str) -> String {
    let wider = if R::NAME == f64::NAME { "" } else { ", or take --precision f64" };
    format!("{mend}{wider}")
}

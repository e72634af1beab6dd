//! A whole picture, on several threads.

use math::Real;
use shading::Rgb;
use stage::{Error, Tile, Workers, tiled};

use crate::{Counts, Path, Tracer, Tree};

/// The radiance of every pixel, row by row from the top, and what it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendered {
    /// Columns and rows.
    pub size: (u32, u32),
    /// Linear, before clamping.
    pub radiance: Vec<Rgb>,
    /// Exact.
    pub counts: Counts,
}

impl Rendered {
    /// The radiance of a pixel of the picture.
    pub(crate) fn at(&self, (col, row): (u32, u32)) -> Rgb {
        self.radiance[row as usize * self.size.0 as usize + col as usize]
    }
}

/// What a thread needs of its stack beside the rays: 1 MiB.
const STACK: usize = 1 << 20;
/// What a ray needs of it, rayTrace and rtShade together. Seen for a tree of a thousand rays, mirrored or refracted, are
/// 2.5 KiB in `dev` and 6 KiB where nothing is optimized.
const STACK_A_RAY: usize = 16 << 10;

/// Traces a picture with `samples` × `samples` rays a pixel, as [`Tracer::pixel`] takes them. `size` is the
/// size that the scene was made for. The same for every number of threads; `None`: all that the machine has.
/// `progress` is the name of a bar on a terminal; `None`: no bar.
///
/// [`Error::Failed`] where the memory or the threads cannot be had.
pub fn render<R: Real>(
    tracer: &Tracer<'_, R>,
    size: (u32, u32),
    samples: u32,
    threads: Option<usize>,
    progress: Option<&'static str>,
) -> Result<Rendered, Error> {
    let workers = Workers { threads, stack: stack(tracer), progress };
    let mut counts = Counts::default();
    let radiance = tiled(
        size,
        &workers,
        |tile: &Tile, values: &mut [Rgb]| {
            let (mut path, mut counts) = (Path::default(), Counts::default());
            let pixels = tile.rows.clone().flat_map(|row| tile.cols.clone().map(move |col| (col, row)));
            for (pixel, value) in pixels.zip(values) {
                *value = tracer.pixel(pixel, samples, &mut path, &mut counts);
            }
            counts
        },
        |tile| counts.add(&tile),
    )?;
    Ok(Rendered { size, radiance, counts })
}

/// What a thread needs of its stack to trace as deep as the scene says.
pub(crate) fn stack<R: Real>(tracer: &Tracer<'_, R>) -> usize {
    stack_to(tracer.max_depth())
}

/// The same for a depth.
pub(crate) fn stack_to(depth: u32) -> usize {
    STACK + depth as usize * STACK_A_RAY
}

/// All rays of a pixel; of `samples` × `samples` in it, at least 1 × 1, those of the one in the middle, or
/// after it.
///
/// [`Error::Failed`] where a thread with a stack for them cannot be had.
pub fn tree<R: Real>(tracer: &Tracer<'_, R>, pixel: (u32, u32), samples: u32) -> Result<Tree<R>, Error> {
    let middle = R::round_from((f64::from(samples / 2) + 0.5) / f64::from(samples));
    with_stack(stack(tracer), || {
        let mut tree = Tree::new();
        tracer.eye_ray(&tracer.ray(pixel, (middle, middle)), &mut Path::default(), &mut tree);
        tree
    })
}

/// What `work` returns, on a thread with a stack of so many bytes.
///
/// [`Error::Failed`] where it cannot be had.
pub(crate) fn with_stack<T: Send>(stack: usize, work: impl FnOnce() -> T + Send) -> Result<T, Error> {
    std::thread::scope(|scope| {
        let thread =
            std::thread::Builder::new().stack_size(stack).spawn_scoped(scope, work).map_err(|error| {
                let mebibytes = stack.div_ceil(1 << 20);
                Error::Failed(format!(
                    "cannot start a thread with a stack of {mebibytes} MiB: {error}; ask for less --depth"
                ))
            })?;
        Ok(thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
    })
}

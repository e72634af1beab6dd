//! A picture by tiles, on several threads: the same picture and the same counts, however many there are.

use std::io;
use std::ops::Range;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread::{Builder, available_parallelism, scope};

use crate::pixels::reserved;
use crate::{Error, Progress};

/// A square of a picture: [`Tile::SIDE`] columns and rows, fewer at the right and the lower border.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tile {
    /// Its columns in the picture.
    pub cols: Range<u32>,
    /// Its rows in the picture.
    pub rows: Range<u32>,
}

impl Tile {
    /// The columns and rows of a whole tile: few enough that the dearest one does not keep the threads
    /// waiting for long, many enough that dealing tiles out costs nothing beside the work.
    pub const SIDE: u32 = 32;
}

/// Who does the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Workers {
    /// How many threads, at least one; `None`: as many as the machine has. Never more than there are tiles.
    pub threads: Option<usize>,
    /// The stack of each thread, in bytes.
    pub stack: usize,
    /// The name of a bar on standard error, shown where that is a terminal and the work takes a while.
    pub progress: Option<&'static str>,
}

/// A value for every pixel of a picture of `size` = (columns, rows), row by row from the top, a tile at a
/// time.
///
/// `work` fills the values of a tile, row by row from its top, each of them T's default until then, and
/// returns what it counted. `merge` is given those counts in the order of the tiles, row by row from the top
/// left. Both, and so the whole answer, are the same for every number of threads. A panic in `work` is a
/// panic here.
///
/// [`Error::Failed`] where the memory for the values or a thread cannot be had; then nothing is merged.
pub fn tiled<T: Clone + Default + Send, S: Send>(
    size: (u32, u32),
    workers: &Workers,
    work: impl Fn(&Tile, &mut [T]) -> S + Sync,
    merge: impl FnMut(S),
) -> Result<Vec<T>, Error> {
    let mut all = reserved(1, size)?;
    all.resize(size.0 as usize * size.1 as usize, T::default());
    let counted = fill(size, workers, &mut all, &work)?;
    counted.into_iter().for_each(merge);
    Ok(all)
}

/// Fills the values of a whole picture, and returns what was counted in the order of the tiles.
fn fill<T: Clone + Default + Send, S: Send>(
    (width, height): (u32, u32),
    workers: &Workers,
    all: &mut [T],
    work: &(impl Fn(&Tile, &mut [T]) -> S + Sync),
) -> Result<Vec<S>, Error> {
    let across = width.div_ceil(Tile::SIDE) as usize;
    let tiles = across * height.div_ceil(Tile::SIDE) as usize;
    // The rows of a tile lie apart in the picture, those of a band of tiles together: a band is lent to one
    // thread at a time, to copy a finished tile into.
    let width = width as usize;
    let bands: Vec<Mutex<&mut [T]>> =
        all.chunks_mut((Tile::SIDE as usize * width).max(1)).map(Mutex::new).collect();
    let next = AtomicUsize::new(0);
    let progress = workers.progress.map(|name| Progress::patient(tiles as u64, name));

    let one_thread = || {
        let mut scratch = vec![T::default(); (Tile::SIDE * Tile::SIDE) as usize];
        let mut counted = Vec::new();
        loop {
            let place = next.fetch_add(1, Ordering::Relaxed);
            if place >= tiles {
                return counted;
            }
            let tile = tile_at(place, across, (width as u32, height));
            let (first, cols, rows) = (tile.cols.start as usize, tile.cols.len(), tile.rows.len());
            let values = &mut scratch[..cols * rows];
            counted.push((place, work(&tile, values)));
            // Whoever panics does so in `work`, with no band in hand.
            let mut band = bands[place / across].lock().unwrap_or_else(PoisonError::into_inner);
            for (row, values) in band.chunks_mut(width).zip(values.chunks_mut(cols)) {
                // what comes back are the defaults that the next tile begins with
                row[first..first + cols].swap_with_slice(values);
            }
            drop(band);
            if let Some(progress) = &progress {
                progress.done();
            }
        }
    };
    let threads =
        workers.threads.unwrap_or_else(|| available_parallelism().map_or(1, |threads| threads.get()));
    // Where a thread is missing, those that are at work already stop at their next tile.
    let give_up = || next.store(tiles, Ordering::Relaxed);
    let counted = on_threads(threads.clamp(1, tiles.max(1)), workers.stack, one_thread, give_up)?;

    let mut counted: Vec<(usize, S)> = counted.into_iter().flatten().collect();
    counted.sort_unstable_by_key(|(place, _)| *place);
    Ok(counted.into_iter().map(|(_, counted)| counted).collect())
}

/// What each of so many threads returns. Where one of them cannot be had, `give_up` is to end those before
/// it.
fn on_threads<S: Send>(
    threads: usize,
    stack: usize,
    work: impl Fn() -> S + Sync,
    give_up: impl Fn(),
) -> Result<Vec<S>, Error> {
    let work = &work;
    scope(|scope| {
        let start = |number| {
            Builder::new().stack_size(stack).spawn_scoped(scope, work).map_err(|error| {
                give_up();
                no_thread(number, stack, &error)
            })
        };
        let started: Vec<_> = (1..=threads).map(start).collect::<Result<_, Error>>()?;
        Ok(started
            .into_iter()
            .map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)))
            .collect())
    })
}

/// The tile at a place of their order, row by row, `across` to a row.
fn tile_at(place: usize, across: usize, (width, height): (u32, u32)) -> Tile {
    let [col, row] = [place % across, place / across].map(|tiles| tiles as u32 * Tile::SIDE);
    Tile { cols: col..width.min(col + Tile::SIDE), rows: row..height.min(row + Tile::SIDE) }
}

/// What to say where a thread cannot be had.
fn no_thread(number: usize, stack: usize, error: &io::Error) -> Error {
    let remedy = match number {
        1 => "end other programs, which take its memory or its place",
        _ => "ask for fewer, such as --threads 1",
    };
    let mebibytes = stack.div_ceil(1 << 20);
    Error::Failed(format!("cannot start thread {number} with a stack of {mebibytes} MiB: {error}; {remedy}"))
}

#[cfg(test)]
mod tests;

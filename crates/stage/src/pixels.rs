//! One value a pixel, on as many threads as the machine has.

use std::sync::{Mutex, PoisonError};
use std::thread::{Builder, available_parallelism, scope};

use crate::Error;

/// A value for every pixel of a picture of `size` = (columns, rows), neither 0, row by row from the top, by
/// its column and row. It does not depend on how many threads there are.
///
/// [`Error::Failed`] where the memory for it cannot be had.
pub fn each_pixel<T: Clone + Default + Send>(
    size: (u32, u32),
    value: impl Fn(u32, u32) -> T + Sync,
) -> Result<Vec<T>, Error> {
    let mut all = reserved(1, size)?;
    all.resize(size.0 as usize * size.1 as usize, T::default());
    by_row(&mut all, size.0 as usize, |row, values| {
        for (col, place) in (0..).zip(values) {
            *place = value(col, row);
        }
    });
    Ok(all)
}

/// Fills rows of `width` values, each by its number: whichever thread is free takes the next strip of them.
/// Where a thread cannot be had the others do its work, and this one at least is there.
pub(crate) fn by_row<T: Send>(all: &mut [T], width: usize, fill: impl Fn(u32, &mut [T]) + Sync) {
    const ROWS_EACH: usize = 8;
    let threads = available_parallelism().map_or(1, |threads| threads.get());
    let strips = Mutex::new(all.chunks_mut(ROWS_EACH * width).enumerate());
    let next = || strips.lock().unwrap_or_else(PoisonError::into_inner).next();
    let work = || {
        while let Some((strip, rows)) = next() {
            let first_row = strip * ROWS_EACH;
            for (row, values) in (first_row as u32..).zip(rows.chunks_mut(width)) {
                fill(row, values);
            }
        }
    };
    scope(|scope| {
        let help = || Builder::new().spawn_scoped(scope, work).is_ok();
        // counted until one is missing
        let _ = (1..threads).take_while(|_| help()).count();
        work();
    });
}

/// Memory for so many values a pixel; [`Error::Failed`] where it cannot be had.
pub(crate) fn reserved<T>(each: usize, size: (u32, u32)) -> Result<Vec<T>, Error> {
    let total = usize::try_from(u64::from(size.0) * u64::from(size.1)).ok().and_then(|n| n.checked_mul(each));
    let mut data = Vec::new();
    match total.map(|total| data.try_reserve_exact(total)) {
        Some(Ok(())) => Ok(data),
        _ => Err(no_memory(size)),
    }
}

/// What to say where there is no memory for a picture.
pub(crate) fn no_memory((width, height): (u32, u32)) -> Error {
    Error::Failed(format!(
        "there is no memory for a picture of {width}x{height} pixels; ask for a smaller --size"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_pixel_has_its_own_value() {
        for size in [(1, 1), (7, 30), (30, 7), (3, 8)] {
            let all = each_pixel(size, |col, row| (col, row)).unwrap();
            let want: Vec<_> = (0..size.1).flat_map(|row| (0..size.0).map(move |col| (col, row))).collect();
            assert_eq!(all, want);
        }
    }
}

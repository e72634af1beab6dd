use super::*;

/// Workers without a bar.
fn workers(threads: usize) -> Workers {
    Workers { threads: Some(threads), stack: 1 << 16, progress: None }
}

/// The column and the row of every pixel, and the tiles in the order in which they were merged.
fn places(size: (u32, u32), threads: usize) -> (Vec<(u32, u32)>, Vec<Tile>) {
    let mut merged = Vec::new();
    let work = |tile: &Tile, values: &mut [(u32, u32)]| {
        let pixels = tile.rows.clone().flat_map(|row| tile.cols.clone().map(move |col| (col, row)));
        assert_eq!(pixels.clone().count(), values.len());
        for (value, pixel) in values.iter_mut().zip(pixels) {
            assert_eq!(*value, (0, 0), "the default until it is filled");
            *value = pixel;
        }
        tile.clone()
    };
    let all = tiled(size, &workers(threads), work, |tile| merged.push(tile)).unwrap();
    (all, merged)
}

#[test]
fn every_pixel_is_filled_in_its_place_by_any_number_of_threads() {
    for size in [(1, 1), (32, 32), (33, 1), (1, 33), (31, 70), (100, 64), (320, 240)] {
        let want: Vec<_> = (0..size.1).flat_map(|row| (0..size.0).map(move |col| (col, row))).collect();
        for threads in [1, 2, 3, 16, 1024] {
            assert_eq!(places(size, threads).0, want, "{size:?} on {threads}");
        }
    }
}

#[test]
fn counts_come_in_the_order_of_the_tiles() {
    let tile = |cols, rows| Tile { cols, rows };
    let want = [tile(0..32, 0..32), tile(32..40, 0..32), tile(0..32, 32..33), tile(32..40, 32..33)];
    for threads in [1, 2, 7] {
        assert_eq!(places((40, 33), threads).1, want);
    }
}

#[test]
fn without_a_number_the_machine_says_how_many() {
    let all = Workers { threads: None, ..workers(1) };
    let ones = tiled((50, 50), &all, |_, values| values.fill(1_u8), |()| ()).unwrap();
    assert_eq!(ones, [1; 2500]);
}

#[test]
fn a_thread_has_the_stack_that_is_asked_for() {
    // each call keeps 1 KiB, so 4000 of them need more than the 2 MiB of an ordinary thread
    fn deep(calls: u32) -> u32 {
        let kept = std::hint::black_box([calls; 256]);
        if calls == 0 { 0 } else { 1 + deep(calls - 1) + kept[0] - calls }
    }
    let large = Workers { stack: 64 << 20, ..workers(1) };
    let depths = tiled((1, 1), &large, |_, values| values.fill(deep(4000)), |()| ()).unwrap();
    assert_eq!(depths, [4000]);
}

#[test]
#[should_panic(expected = "the second tile")]
fn a_panic_is_handed_on() {
    let work = |tile: &Tile, _: &mut [u8]| assert_ne!(tile.cols.start, 32, "the second tile");
    let _ = tiled((96, 1), &workers(2), work, |()| ());
}

#[test]
fn no_memory_is_an_error() {
    let work = |_: &Tile, _: &mut [[u64; 8]]| panic!("nothing is begun");
    // 2^64 values of 64 bytes
    let error = tiled((u32::MAX, u32::MAX), &workers(1), work, |()| ()).unwrap_err();
    assert!(error.to_string().contains("ask for a smaller --size"), "{error}");
}

/// A stack as large as the address space cannot be had.
#[cfg(target_os = "linux")]
#[test]
fn a_thread_that_cannot_be_had_is_an_error() {
    let huge = Workers { stack: 1 << 60, ..workers(2) };
    let mut merged = 0;
    let error = tiled((64, 64), &huge, |_, values| values.fill(1_u8), |()| merged += 1).unwrap_err();
    assert_eq!((error.status(), merged), (1, 0));
    assert!(error.to_string().contains("cannot start thread 1"), "{error}");
    assert!(no_thread(2, 1, &io::ErrorKind::OutOfMemory.into()).to_string().contains("--threads 1"));
}

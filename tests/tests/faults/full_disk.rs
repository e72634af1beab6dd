//! A disk that is full.

use crate::command::{DRAWINGS, GALLERY, HAND_OUT, PAGES, PICTURES, WHOLE_GALLERY, Writer};
use crate::files::{Files, OLD};
use crate::room::{no_rooms, run_on_small_disk};

/// Nothing fits any more: all that was there stays, and nothing else is.
fn assert_nothing_fits(writer: &Writer) {
    let (run, left) = run_on_small_disk(&writer.files, 0, &writer.args());
    writer.assert_failed(&run, left.path(), "the disk is full; free some space, or write elsewhere");
}

/// Half of it fits: each file is old or whole, some are old, and none is hidden.
fn assert_half_fits(writer: &Writer) {
    let (run, left) = run_on_small_disk(&writer.files, 1, &writer.args());
    assert_eq!(run.status, 1, "{writer:?}: {run:?}");
    assert!(run.errors.contains(": the disk is full; "), "{writer:?}: {run:?}");
    let left = Files::in_folder(left.path());
    left.assert_whole(false);
    assert!(left.names().eq(writer.files.names()), "{writer:?}: {:?}", left.names().collect::<Vec<_>>());
    assert!(left.contents().any(|content| content == OLD.as_bytes()), "{writer:?}");
}

#[test]
fn the_old_picture_stays() {
    if no_rooms() {
        return;
    }
    for writer in &*PICTURES {
        assert!(writer.files.content("picture.png").len() > 4096, "{writer:?}: more than fits");
        assert_nothing_fits(writer);
        assert_half_fits(writer);
    }
}

#[test]
fn the_old_pages_stay() {
    if no_rooms() {
        return;
    }
    for writer in &*PAGES {
        assert_nothing_fits(writer);
        assert_half_fits(writer);
    }
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn the_old_drawings_stay() {
    if no_rooms() {
        return;
    }
    for writer in &*DRAWINGS {
        assert_nothing_fits(writer);
    }
}

fn assert_it_stays(gallery: &Writer) {
    if no_rooms() {
        return;
    }
    assert_nothing_fits(gallery);
    assert_half_fits(gallery);
}

#[test]
fn the_old_gallery_stays() {
    assert_it_stays(&GALLERY);
}

#[test]
#[ignore = "every stage draws, several times, which takes minutes: .ci/full runs it"]
fn the_whole_old_gallery_stays() {
    assert_it_stays(&WHOLE_GALLERY);
}

#[test]
fn no_half_of_a_hand_out_is_there() {
    if no_rooms() {
        return;
    }
    for spare in [1, 4] {
        let (run, left) = run_on_small_disk(&Files::none(), spare, &HAND_OUT.args());
        assert_eq!(run.status, 1, "{run:?}");
        assert!(
            run.errors.starts_with("error: cannot make attempt: ")
                && run.errors.ends_with("; free some space\n"),
            "{run:?}"
        );
        assert_eq!(Files::in_folder(left.path()), Files::none());
    }
}

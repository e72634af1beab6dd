//! The state of the chapters, as a number: what was cut from them is up to date as long as it is the same.

use std::fs;
use std::io;
use std::path::Path;

/// The state of the files that exercises are cut from: those of each chapter's `src` and `exercises`, by
/// their names and contents. FNV-1a, 64 bits: it tells apart what was edited, and is no protection against
/// intent.
pub(crate) fn state(chapters: &Path) -> io::Result<u64> {
    let mut state = 0xcbf2_9ce4_8422_2325;
    for chapter in sorted(chapters)? {
        for folder in ["src", "exercises"].map(|name| chapter.join(name)) {
            if folder.is_dir() {
                add(chapters, &folder, &mut state)?;
            }
        }
    }
    Ok(state)
}

fn add(chapters: &Path, folder: &Path, state: &mut u64) -> io::Result<()> {
    for path in sorted(folder)? {
        if path.is_dir() {
            add(chapters, &path, state)?;
        } else if path.extension().is_some_and(|it| it == "rs" || it == "toml") {
            let name = path.strip_prefix(chapters).unwrap_or(&path);
            let name = name.iter().flat_map(|part| part.as_encoded_bytes().iter().chain(b"/"));
            for &byte in name.chain(&fs::read(&path)?) {
                *state = (*state ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
            }
        }
    }
    Ok(())
}

fn sorted(folder: &Path) -> io::Result<Vec<std::path::PathBuf>> {
    let entries = fs::read_dir(folder)?.map(|entry| entry.map(|it| it.path()));
    let mut paths: Vec<_> = entries.collect::<io::Result<_>>()?;
    paths.sort();
    Ok(paths)
}

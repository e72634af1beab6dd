//! `to-pov SCENE`: writes the scene in POV-Ray's language to standard output.

use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

use against_povray::pov::{self, Wanted};
use scene_file::Scene;

const USAGE: &str = "\
usage: to-pov SCENE [--size WIDTHxHEIGHT] [--depth N] [--whole-shadows] [--print-size] > FILE.pov
  --size, --depth   what is drawn, where it is not what the scene says
  --whole-shadows   what lets light through casts a whole shadow, as in our model
  --print-size      prints the size and the depth to draw, as `WIDTH HEIGHT DEPTH`, and nothing else";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let (path, wanted, print_size) = match asked(&words) {
        Some(asked) => asked,
        None => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    let written = Scene::read(Path::new(path)).and_then(|file| {
        if print_size {
            let (columns, rows) = wanted.size.unwrap_or(file.camera.size.value);
            return Ok(format!("{columns} {rows} {}\n", wanted.depth.unwrap_or(file.max_depth)));
        }
        pov::scene(&file, wanted)
    });
    match written {
        Ok(text) => match std::io::stdout().lock().write_all(text.as_bytes()) {
            Ok(()) => ExitCode::SUCCESS,
            Err(why) => {
                eprintln!("cannot write the scene: {why}");
                ExitCode::FAILURE
            }
        },
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(error.status())
        }
    }
}

/// The scene's path, what is wanted, and whether only the size is.
fn asked<'a>(words: &[&'a str]) -> Option<(&'a str, Wanted, bool)> {
    let (mut path, mut wanted, mut print_size) = (None, Wanted::default(), false);
    let mut words = words.iter();
    while let Some(&word) = words.next() {
        match word {
            "--size" => {
                let (columns, rows) = words.next()?.split_once('x')?;
                let size: (u32, u32) = (columns.parse().ok()?, rows.parse().ok()?);
                let at_least_one = size.0 > 0 && size.1 > 0;
                wanted.size = at_least_one.then_some(size);
                wanted.size?;
            }
            "--depth" => wanted.depth = Some(words.next()?.parse().ok().filter(|&depth| depth > 0)?),
            "--whole-shadows" => wanted.whole_shadows = true,
            "--print-size" => print_size = true,
            _ if word.starts_with('-') || path.is_some() => return None,
            _ => path = Some(word),
        }
    }
    Some((path?, wanted, print_size))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_asked() {
        let (path, wanted, print_size) = asked(&["--size", "30x20", "a.toml", "--depth", "3"]).unwrap();
        assert_eq!((path, wanted.size, wanted.depth, print_size), ("a.toml", Some((30, 20)), Some(3), false));
        for wrong in
            [vec![], vec!["a", "b"], vec!["a", "--size", "30"], vec!["a", "--size", "0x3"], vec!["a", "--x"]]
        {
            assert!(asked(&wrong).is_none(), "{wrong:?}");
        }
    }
}

//! `same-picture ONE.png OTHER.png`: how far two pictures are apart.

use std::path::Path;
use std::process::ExitCode;

use against_povray::Difference;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [one, other] = words.as_slice() else {
        eprintln!("usage: same-picture ONE.png OTHER.png");
        return ExitCode::from(2);
    };
    match Difference::of_files(Path::new(one), Path::new(other)) {
        Ok(Difference { mean, visible }) => {
            let most = Difference::VISIBLE;
            println!(
                "mean difference {mean:.3}/255; {:.3} % of the pixels by more than {most}/255",
                100.0 * visible
            );
            ExitCode::SUCCESS
        }
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

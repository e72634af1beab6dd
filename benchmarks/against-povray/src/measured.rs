//! What was measured of one scene, read from the folder where the script `run` puts it.

use std::fs;
use std::path::Path;

use crate::{Difference, Statistics, Transcript};

/// One scene by both programs.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The name of its folder.
    pub name: String,
    /// What POV-Ray counted, as [`Measured::read`] makes it comparable.
    pub pov: Statistics,
    /// Median processor seconds of POV-Ray's tracing, over the rounds.
    pub pov_seconds: f64,
    /// Median user seconds of the whole process, over the rounds.
    pub pov_whole: f64,
    /// Ours, if it was drawn.
    pub ours: Option<Ours>,
}

/// The same scene by `whitted`.
#[derive(Clone, Copy, Debug)]
pub struct Ours {
    /// What it counted.
    pub rays: Transcript,
    /// Median user seconds of the whole process, over the rounds.
    pub seconds: f64,
    /// Between the two pictures.
    pub difference: Difference,
}

impl Measured {
    /// Reads `povray.1.txt`, `povray.1.time`, … and, if they are there, `whitted.1.json`, `whitted.1.time`, …
    /// of a folder.
    ///
    /// What POV-Ray counts is not always what it traces. At its deepest level it still counts the rays that
    /// it would send on, and returns black for each at once: a run with one level less, `level-less.txt`,
    /// counts exactly the rays that the deeper one traces. It is only missing where depth is 1, and there are
    /// none. And a ray to a light counts again for every surface that lets it through: `whole-shadows.txt` is
    /// of a run where none does.
    ///
    /// What is wrong, and with which file.
    pub fn read(folder: &Path) -> Result<Measured, String> {
        let file = |name: &str| folder.join(name);
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let runs: Vec<Statistics> =
            rounds(folder, "povray", "txt").map(|path| pov(&path)).collect::<Result<_, _>>()?;
        let Some(&(mut statistics)) = runs.first() else {
            return Err(format!("{}: not there; draw the scene first", file("povray.1.txt").display()));
        };
        (statistics.reflected, statistics.refracted) = match statistics.depth {
            1 => (0, 0),
            _ => pov(&file("level-less.txt")).map(|counts| (counts.reflected, counts.refracted))?,
        };
        statistics.shadow = pov(&file("whole-shadows.txt"))?.shadow;
        statistics.rays = statistics.eye() + statistics.reflected + statistics.refracted;
        let pov_seconds = median(runs.iter().map(|run| run.trace_seconds).collect());
        let pov_whole = seconds(folder, "povray")?;
        let ours = match file("whitted.1.json").exists() {
            true => Some(Ours::read(folder)?),
            false => None,
        };
        Ok(Measured { name, pov: statistics, pov_seconds, pov_whole, ours })
    }

    /// All rays of POV-Ray's, shadow rays counted.
    pub fn pov_rays(&self) -> u64 {
        self.pov.rays + self.pov.shadow
    }
}

impl Ours {
    fn read(folder: &Path) -> Result<Ours, String> {
        let file = |name: &str| folder.join(name);
        let json = file("whitted.1.json");
        let rays = Transcript::read(&text(&json)?).map_err(|why| format!("{}: {why}", json.display()))?;
        let seconds = seconds(folder, "whitted")?;
        let difference = Difference::of_files(&file("whole-shadows.png"), &file("whitted.png"))?;
        Ok(Ours { rays, seconds, difference })
    }
}

/// The files of the first round, the second, and so on, as far as there are any.
fn rounds<'a>(
    folder: &'a Path,
    program: &'a str,
    ending: &'a str,
) -> impl Iterator<Item = std::path::PathBuf> + 'a {
    let path = move |round: u32| folder.join(format!("{program}.{round}.{ending}"));
    (1..).map(path).take_while(|path| path.exists())
}

/// The median of the user seconds that the script noted of a program.
fn seconds(folder: &Path, program: &str) -> Result<f64, String> {
    let seconds = rounds(folder, program, "time").map(|path| {
        let text = text(&path)?;
        // what the program says on standard error comes before
        let last = text.lines().last().unwrap_or_default();
        last.parse().map_err(|_| format!("{}: no seconds: {last}", path.display()))
    });
    Ok(median(seconds.collect::<Result<_, _>>()?))
}

fn pov(path: &Path) -> Result<Statistics, String> {
    Statistics::read(&text(path)?).map_err(|why| format!("{}: {why}", path.display()))
}

fn text(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|why| format!("{}: {why}", path.display()))
}

/// The middle one, or the mean of the two in the middle; NaN of none.
pub fn median(mut of: Vec<f64>) -> f64 {
    of.sort_by(f64::total_cmp);
    match of.len() {
        0 => f64::NAN,
        odd if odd % 2 == 1 => of[odd / 2],
        even => 0.5 * (of[even / 2 - 1] + of[even / 2]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), 2.5);
        assert!(median(vec![]).is_nan());
    }

    #[test]
    fn a_folder_without_a_run_says_what_to_do() {
        let why = Measured::read(Path::new("src")).unwrap_err();
        assert_eq!(why, "src/povray.1.txt: not there; draw the scene first");
    }
}

//! What POV-Ray 3.7 prints about a picture.

/// The statistics of one picture, as POV-Ray counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Statistics {
    /// Columns and rows.
    pub size: (u64, u64),
    /// `Max Level`, the allowed one: rayTrace's maxDepth.
    pub depth: u64,
    /// Every ray but those to lights.
    pub rays: u64,
    /// Rays to the lights, and one more for every surface that lets one through.
    pub shadow: u64,
    /// Mirror rays.
    pub reflected: u64,
    /// Rays that go on through a surface, bent or not.
    pub refracted: u64,
    /// Processor seconds of the tracing alone: reading the scene, building its boxes and writing the picture
    /// are not in it.
    pub trace_seconds: f64,
}

impl Statistics {
    /// Out of all that POV-Ray prints with `+V`. Which line is missing where one is.
    pub fn read(text: &str) -> Result<Statistics, String> {
        let lines: Vec<&str> = text.split(['\n', '\r']).map(str::trim).collect();
        let starting = |label: &str| lines.iter().position(|line| line.starts_with(label));
        let missing = |label: &str| format!("no `{label}` in what POV-Ray printed: draw with +V");
        // of a kind of ray of which there is none, POV-Ray prints no line
        let count =
            |label: &str| starting(label).map_or(Some(0), |at| first_whole(&lines[at][label.len()..]));
        let needed = |label: &str| {
            starting(label)
                .and_then(|at| first_whole(&lines[at][label.len()..]))
                .ok_or_else(|| missing(label))
        };
        let resolution = starting("Image Resolution").map(|at| lines[at]).unwrap_or_default();
        let size = resolution["Image Resolution".len().min(resolution.len())..].split_once('x');
        let size = size.and_then(|(columns, rows)| Some((first_whole(columns)?, first_whole(rows)?)));
        let allowed = starting("Rays:").and_then(|at| lines[at].rsplit_once('/')).map(|(_, allowed)| allowed);
        // the line after `Trace Time` has the processor's seconds
        let trace = starting("Trace Time:").and_then(|at| lines.get(at + 1)).and_then(|line| {
            let (_, seconds) = line.split_once(" with ")?;
            seconds.split(' ').next()?.parse().ok()
        });
        let of_kind = |label: &str| count(label).ok_or_else(|| missing(label));
        Ok(Statistics {
            size: size.ok_or_else(|| missing("Image Resolution"))?,
            depth: allowed.and_then(first_whole).ok_or_else(|| missing("Max Level"))?,
            rays: needed("Rays:")?,
            shadow: of_kind("Shadow Ray Tests:")?,
            reflected: of_kind("Reflected Rays:")?,
            refracted: of_kind("Refracted Rays:")? + of_kind("Transmitted Rays:")?,
            trace_seconds: trace.ok_or_else(|| missing("Trace Time"))?,
        })
    }

    /// Rays from the eye: one a pixel.
    pub fn eye(&self) -> u64 {
        self.size.0 * self.size.1
    }
}

/// The whole number that a text begins with, after blanks.
fn first_whole(text: &str) -> Option<u64> {
    text.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    const PRINTED: &str = "Rendered 307200 of 307200 pixels (100%)\r\n\
        Render Statistics\n\
        Image Resolution 640 x 480\n\
        Pixels:           307200   Samples:               0   Smpls/Pxl: 0.00\n\
        Rays:            1037544   Saved:                 0   Max Level: 2/3\n\
        Shadow Ray Tests:            557094   Succeeded:                157400\n\
        Reflected Rays:                471878\n\
        Refracted Rays:                200000\n\
        Transmitted Rays:               58466\n\
        Radiosity Time:   No radiosity\n\
        \x20 Trace Time:       0 hours  0 minutes  0 seconds (0.178 seconds)\n\
        \x20             using 1 thread(s) with 0.156 CPU-seconds total\n";

    #[test]
    fn all_kinds_of_rays_and_the_seconds() {
        let it = Statistics::read(PRINTED).unwrap();
        assert_eq!((it.size, it.depth, it.rays), ((640, 480), 3, 1037544));
        assert_eq!([it.eye(), it.shadow, it.reflected, it.refracted], [307200, 557094, 471878, 258466]);
        assert_eq!(it.trace_seconds, 0.156);
    }

    #[test]
    fn a_kind_that_is_not_printed_is_0() {
        let it = Statistics::read(&PRINTED.replace("Reflected Rays:                471878\n", "")).unwrap();
        assert_eq!(it.reflected, 0);
    }

    #[test]
    fn what_is_cut_short_is_said() {
        let cut = &PRINTED[..PRINTED.find("using").unwrap()];
        assert!(Statistics::read(cut).unwrap_err().contains("Trace Time"));
        assert!(Statistics::read("").unwrap_err().contains("Image Resolution"));
    }
}

//! What `whitted --format json` prints about a picture.

use serde_json::Value;

/// The rays of one picture of ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transcript {
    /// From the eye.
    pub eye: u64,
    /// To the lights.
    pub shadow: u64,
    /// Mirror rays.
    pub mirror: u64,
    /// Rays that go on through a surface, bent or not.
    pub refracted: u64,
}

impl Transcript {
    /// The section of the transcript that has the counts.
    pub const SECTION: &str = "The rays of the picture";

    /// Out of the JSON. What is missing where something is.
    pub fn read(text: &str) -> Result<Transcript, String> {
        let json: Value =
            serde_json::from_str(text).map_err(|why| format!("no transcript in JSON: {why}"))?;
        let steps = json["steps"].as_array().ok_or("no `steps` in the transcript")?;
        let count = |symbol: &str| {
            let is_it = |step: &&Value| step["section"] == Transcript::SECTION && step["symbol"] == symbol;
            let value = steps.iter().find(is_it).and_then(|step| step["value"].as_f64());
            // a count below 2^53 is a number of JSON exactly
            value.map(|value| value as u64).ok_or_else(|| {
                format!("no number `{symbol}` under “{}” in the transcript", Transcript::SECTION)
            })
        };
        Ok(Transcript {
            eye: count("eye")?,
            shadow: count("shadow")?,
            mirror: count("mirror")?,
            refracted: count("refracted")?,
        })
    }

    /// All of them.
    pub fn rays(&self) -> u64 {
        self.eye + self.shadow + self.mirror + self.refracted
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(section: &str, symbol: &str, value: &str) -> String {
        format!(r#"{{"symbol": "{symbol}", "formula": "", "value": {value}, "section": "{section}"}}"#)
    }

    #[test]
    fn the_counts_of_the_section_and_no_other() {
        let rays = Transcript::SECTION;
        let steps = [
            step("elsewhere", "eye", "[0, 0, 0]"),
            step(rays, "eye", "100"),
            step(rays, "shadow", "50.0"),
            step(rays, "mirror", "7"),
            step(rays, "refracted", "0"),
        ];
        let json = |steps: &[String]| format!(r#"{{"stage": "whitted", "steps": [{}]}}"#, steps.join(","));
        let read = Transcript::read(&json(&steps)).unwrap();
        assert_eq!(read, Transcript { eye: 100, shadow: 50, mirror: 7, refracted: 0 });
        assert_eq!(read.rays(), 157);
        assert!(Transcript::read(&json(&steps[..4])).unwrap_err().contains("`refracted`"));
        assert!(Transcript::read("error").unwrap_err().starts_with("no transcript"));
    }
}

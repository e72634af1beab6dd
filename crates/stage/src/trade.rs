//! What `trade` is asked and what it answers: records in the contract's columns, a report to read, and
//! drawings.

use std::path::{Path, PathBuf};

use serde::ser::{Serialize, SerializeMap, Serializer};

use crate::value::digits;
use crate::{Canvas, Error, Precision, write_picture, write_whole};

/// What `trade` is asked to measure.
#[derive(Clone, Debug, PartialEq)]
pub struct TradeAsk {
    /// The method to measure, by its place in [`About::methods`](crate::About::methods); `None`: all.
    pub method: Option<usize>,
    /// The precision to measure at; `None`: both.
    pub precision: Option<Precision>,
    /// The regimes to measure in, by name; none named: all.
    pub regimes: Vec<String>,
    /// How many cases of each regime are judged, at least 1; `None`: as many as the stage judges by itself,
    /// fewer where that is to be quick.
    pub cases: Option<usize>,
    /// The seed of the cases.
    pub seed: u64,
    /// Whether to take seconds instead of a minute.
    pub quick: bool,
    /// The scene file to measure in; `None`: the stage's own scenes, its regimes.
    pub scene: Option<PathBuf>,
}

impl TradeAsk {
    /// Nothing is left out: every method, both precisions, every regime, and those are the stage's own.
    pub fn is_for_all(&self) -> bool {
        self.method.is_none() && self.precision.is_none() && self.regimes.is_empty() && self.scene.is_none()
    }

    /// Whether a method is measured, by its place.
    pub fn wants_method(&self, method: usize) -> bool {
        self.method.is_none_or(|asked| asked == method)
    }

    /// Whether a precision is measured at.
    pub fn wants_precision(&self, precision: Precision) -> bool {
        self.precision.is_none_or(|asked| asked == precision)
    }
}

/// What `trade` found.
#[derive(Clone, Debug)]
pub struct Traded {
    /// The report.
    pub text: String,
    /// The same numbers, one record a method, precision and regime.
    pub records: Vec<Record>,
    /// The drawings.
    pub drawings: Vec<Drawing>,
}

/// One record: fields by their names, in order. All records of a stage have the same names.
pub type Record = Vec<(&'static str, Field)>;

/// What stands in a field.
#[derive(Clone, Debug, PartialEq)]
pub enum Field {
    /// A name.
    Text(String),
    /// A count.
    Count(u64),
    /// A measured number.
    Number(f64),
    /// Yes or no.
    Flag(bool),
    /// It does not apply.
    Nothing,
}

/// A drawing and what its file is called: `NAME-trade.svg` has the ending `trade.svg`.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// What follows the stage's name.
    pub ending: &'static str,
    /// What is drawn.
    pub sheet: Sheet,
}

/// A drawing of lines, or of pixels.
#[derive(Clone, Debug)]
pub enum Sheet {
    /// The text of an SVG.
    Svg(String),
    /// A picture, written as a PNG.
    Picture(Canvas),
}

/// How the answer is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TradeFormat {
    Text,
    Json,
    Csv,
}

impl Traded {
    /// Writes the drawings beside `picture`, one a step: where it went, or why it could not be written. One
    /// that fails does not keep the next from being written.
    pub(crate) fn write_drawings(&self, picture: &Path) -> impl Iterator<Item = Result<PathBuf, Error>> {
        self.drawings.iter().map(|Drawing { ending, sheet }| {
            let place = place_beside(picture, ending);
            match sheet {
                Sheet::Svg(text) => write_whole(&place, |file| file.write_all(text.as_bytes()))?,
                Sheet::Picture(canvas) => write_picture(canvas, &place)?,
            }
            Ok(place)
        })
    }

    /// The numbers as `trade` prints them.
    pub(crate) fn report(&self, format: TradeFormat) -> String {
        match format {
            TradeFormat::Text => format!("{}\n", self.text),
            TradeFormat::Json => {
                let records: Vec<Json<'_>> = self.records.iter().map(Json).collect();
                serde_json::to_string_pretty(&records).expect("a record has only string keys") + "\n"
            }
            TradeFormat::Csv => {
                let names = self.records.first().map_or(String::new(), |record| {
                    record.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(",") + "\n"
                });
                let line = |record: &Record| {
                    record.iter().map(|(_, field)| field.to_csv()).collect::<Vec<_>>().join(",") + "\n"
                };
                names + &self.records.iter().map(line).collect::<String>()
            }
        }
    }
}

/// Where a drawing goes, beside the file that `show` would write: `out/NAME.png` and `trade.svg` make
/// `out/NAME-trade.svg`.
pub(crate) fn place_beside(picture: &Path, ending: &str) -> PathBuf {
    let mut name = picture.file_stem().unwrap_or_default().to_os_string();
    name.push("-");
    name.push(ending);
    picture.with_file_name(name)
}

impl Field {
    fn to_csv(&self) -> String {
        match self {
            Field::Text(text) => text.clone(),
            Field::Count(count) => count.to_string(),
            Field::Number(x) => digits(*x),
            Field::Flag(flag) => flag.to_string(),
            Field::Nothing => String::new(),
        }
    }
}

/// A record as a JSON object.
struct Json<'a>(&'a Record);

impl Serialize for Json<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, field) in self.0 {
            map.serialize_entry(name, field)?;
        }
        map.end()
    }
}

impl Serialize for Field {
    /// What is not finite is "inf", "-inf" or "nan", what does not apply is null.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Field::Text(text) => serializer.serialize_str(text),
            Field::Count(count) => serializer.serialize_u64(*count),
            Field::Number(x) if x.is_finite() => serializer.serialize_f64(*x),
            Field::Number(x) => serializer.serialize_str(&digits(*x)),
            Field::Flag(flag) => serializer.serialize_bool(*flag),
            Field::Nothing => serializer.serialize_none(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_field_in_both_formats() {
        let record = vec![
            ("method", Field::Text("notes".to_string())),
            ("cases", Field::Count(7)),
            ("ns_per_ray", Field::Number(1.5)),
            ("worst", Field::Number(f64::INFINITY)),
            ("pareto", Field::Flag(true)),
            ("t_ulp_max", Field::Nothing),
        ];
        let traded = Traded { text: String::new(), records: vec![record], drawings: Vec::new() };
        assert_eq!(
            traded.report(TradeFormat::Csv),
            "method,cases,ns_per_ray,worst,pareto,t_ulp_max\nnotes,7,1.5,inf,true,\n"
        );
        let json: serde_json::Value = serde_json::from_str(&traded.report(TradeFormat::Json)).unwrap();
        let want = serde_json::json!([{
            "method": "notes", "cases": 7, "ns_per_ray": 1.5, "worst": "inf", "pareto": true, "t_ulp_max": null
        }]);
        assert_eq!(json, want);
    }

    #[test]
    fn drawings_stand_beside_the_picture_but_for_those_that_cannot() {
        let folder = std::env::temp_dir().join(format!("trade-drawings-{}", std::process::id()));
        std::fs::create_dir_all(folder.join("ray-wall-map.svg")).unwrap();
        let drawing = |ending| Drawing { ending, sheet: Sheet::Svg("<svg/>".to_string()) };
        let drawings = ["map.svg", "trade.svg"].map(drawing).to_vec();
        let traded = Traded { text: String::new(), records: Vec::new(), drawings };
        let places: Vec<_> = traded.write_drawings(&folder.join("ray-wall.png")).collect();
        let [Err(error), Ok(place)] = &places[..] else { panic!("{places:?}") };
        assert!(error.to_string().contains("ray-wall-map.svg: it is a folder"), "{error}");
        assert_eq!(place, &folder.join("ray-wall-trade.svg"));
        assert_eq!(std::fs::read_to_string(place).unwrap(), "<svg/>");
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn a_name_that_is_not_utf_8_is_kept() {
        use std::ffi::OsStr;
        use std::os::unix::ffi::OsStrExt;

        let [picture, drawing] = [&b"out/\xff.png"[..], b"out/\xff-trade.svg"].map(OsStr::from_bytes);
        assert_eq!(place_beside(Path::new(picture), "trade.svg"), Path::new(drawing));
    }
}

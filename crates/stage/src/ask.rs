//! What a stage is asked, and what it answers.

use std::path::PathBuf;

use math::Real;

use crate::{Canvas, Case, Error, Flag, Ids, Inspector, Row, Section, TradeAsk, Traded, Transcript};

/// A chapter as it is written: all that a new stage has to say.
pub trait Chapter: Sync {
    /// Its name, its methods, where it stands in the book.
    fn about(&self) -> About;

    /// Explains one ray and draws the picture, both computed in R.
    ///
    /// [`Error::Request`] where the method cannot serve the request (`edges` with a single column).
    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error>;

    /// The precision to show in where the stage is left to choose, see [`Flag::Auto`]: what is asked for,
    /// unless a chapter knows better.
    ///
    /// [`Error::Request`] where the request cannot be served at any precision, as by [`Chapter::show`].
    fn precision(&self, ask: &Ask) -> Result<Chosen, Error> {
        Ok(Chosen { precision: ask.precision, why: None })
    }

    /// Hands the rays of the picture, computed in R, to `write`, which looks at them one by one. Only a stage that
    /// lists [`Flag::Inspect`] is asked.
    ///
    /// [`Error::Request`] where the request cannot be served, as by [`Chapter::show`]; the error of `write`.
    fn inspect<R: Real>(&self, _: &Ask, _: Inspector<'_>) -> Result<(), Error> {
        Err(no_inspector(&self.about()))
    }

    /// Answers one row of a case file in R; an invalid case is a row too. A stage whose [`About::inputs`] are empty
    /// has no case files, and is never asked.
    ///
    /// [`Error::Request`] where a field is no number, from [`Case::numbers`].
    fn eval<R: Real>(&self, _: &Ask, _: &Case<'_>) -> Result<Row, Error> {
        Err(Error::Request(format!("{} has no case files", self.about().name)))
    }

    /// Measures the methods and precisions against each other.
    ///
    /// [`Error::Request`] where a regime is asked for that there is not, or the scene file is none;
    /// [`Error::Failed`] where the memory or a thread for it cannot be had.
    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error>;
}

/// A chapter as the commands see it: the precision is part of the request. Every [`Chapter`] is one.
pub trait Stage: Sync {
    /// See [`Chapter::about`].
    fn about(&self) -> About;

    /// See [`Chapter::show`].
    fn show(&self, ask: &Ask) -> Result<Shown, Error>;

    /// See [`Chapter::inspect`].
    fn inspect(&self, _: &Ask, _: Inspector<'_>) -> Result<(), Error> {
        Err(no_inspector(&self.about()))
    }

    /// See [`Chapter::eval`].
    fn eval(&self, ask: &Ask, case: &Case<'_>) -> Result<Row, Error>;

    /// See [`Chapter::trade`].
    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error>;
}

impl<C: Chapter> Stage for C {
    fn about(&self) -> About {
        Chapter::about(self)
    }

    fn show(&self, ask: &Ask) -> Result<Shown, Error> {
        let asked = || Chosen { precision: ask.precision, why: None };
        let Chosen { precision, why } = if ask.auto { self.precision(ask)? } else { asked() };
        let ask = &Ask { precision, why, ..ask.clone() };
        match precision {
            Precision::F32 => Chapter::show::<f32>(self, ask),
            Precision::F64 => Chapter::show::<f64>(self, ask),
        }
    }

    fn inspect(&self, ask: &Ask, write: Inspector<'_>) -> Result<(), Error> {
        match ask.precision {
            Precision::F32 => Chapter::inspect::<f32>(self, ask, write),
            Precision::F64 => Chapter::inspect::<f64>(self, ask, write),
        }
    }

    fn eval(&self, ask: &Ask, case: &Case<'_>) -> Result<Row, Error> {
        match ask.precision {
            Precision::F32 => Chapter::eval::<f32>(self, ask, case),
            Precision::F64 => Chapter::eval::<f64>(self, ask, case),
        }
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        Chapter::trade(self, ask)
    }
}

/// What a stage says whose rays cannot be looked at one by one.
fn no_inspector(about: &About) -> Error {
    Error::Request(format!("{} has no inspector; --pixel explains a ray", about.name))
}

/// What every stage says of itself.
#[derive(Clone, Debug)]
pub struct About {
    /// Its place in the book, from 1.
    pub number: u32,
    /// The package, the binary and the picture.
    pub name: &'static str,
    /// What it teaches, in one line.
    pub teaches: &'static str,
    /// The pages of the notes it follows.
    pub notes: &'static str,
    /// The names that `--method` takes; the first is the default.
    pub methods: Vec<&'static str>,
    /// The picture's default size: columns, rows.
    pub size: (u32, u32),
    /// What the picture shows, in one or two sentences.
    pub picture: &'static str,
    /// The flags of `show` and `trade` that not every stage has.
    pub flags: &'static [Flag],
    /// The columns of a case that `eval` reads; empty for a stage without case files, which has no `eval`.
    pub inputs: &'static [&'static str],
    /// Those of them that hold a word and not a number, with the words there are. Among the numbers of a case a
    /// word is its place in this list, from 0.
    pub words: &'static [Words],
    /// The columns that `eval` writes.
    pub results: &'static [&'static str],
    /// What `trade` measures and draws, in one or two sentences.
    pub trade: &'static str,
    /// The names that `trade --regime` takes and what each is, the ordinary one first.
    pub regimes: Vec<(&'static str, &'static str)>,
}

/// A column of words: its name, and the words that may stand in it.
pub type Words = (&'static str, &'static [&'static str]);

/// One request: which method, at which precision, about which pixel of a picture of which size.
///
/// What is asked when nothing is said, [`Ask::default`]: the stage's first method, f64, its own size, the worked example.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ask {
    /// The method's place in [`About::methods`].
    pub method: usize,
    /// f32 or f64.
    pub precision: Precision,
    /// The picture's columns and rows; neither is 0, and there are at most 2^28 pixels. `None`: the stage's or the
    /// scene's own, see [`Ask::size_or`].
    pub size: Option<(u32, u32)>,
    /// The pixel whose ray is explained: column and row, (0, 0) the top left.
    /// `None`: the worked example of the notes.
    pub pixel: Option<(u32, u32)>,
    /// The scene file; `None`: the chapter's own scene.
    pub scene: Option<PathBuf>,
    /// Whether the picture is encoded by the sRGB curve; else its bytes are linear.
    pub srgb: bool,
    /// N, for N × N rays a pixel, from 1 to 64; `None`: one.
    pub samples: Option<u32>,
    /// How many threads work, from 1 to 1024; `None`: as many as the machine has.
    pub threads: Option<usize>,
    /// How deep the recursion goes, from 1 to 1000; `None`: as deep as the scene says.
    pub depth: Option<u32>,
    /// By how much a channel of a pixel may differ for what is left out, in linear radiance; finite and not
    /// negative. `None`: nothing is left out.
    pub tolerance: Option<f64>,
    /// Whether to say what the scene requires.
    pub explain: bool,
    /// Whether the stage was left to choose the precision; what it chose is then [`Ask::precision`].
    pub auto: bool,
    /// Why it chose that one, to be told among the steps.
    pub why: Option<Section>,
}

impl Ask {
    /// The picture's size: as asked, else `own`.
    ///
    /// [`Error::Request`] where the pixel that is asked for lies outside such a picture.
    pub fn size_or(&self, own: (u32, u32)) -> Result<(u32, u32), Error> {
        let size = self.size.unwrap_or(own);
        if let Some((col, row)) = self.pixel.filter(|&(col, row)| col >= size.0 || row >= size.1) {
            let ((width, height), last) = (size, (size.0 - 1, size.1 - 1));
            return Err(Error::Request(format!(
                "pixel {col},{row} lies outside the picture of {width}x{height} pixels; the last one is {},{}",
                last.0, last.1
            )));
        }
        Ok(size)
    }
}

/// A precision that a stage chose, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Chosen {
    /// What to show in.
    pub precision: Precision,
    /// What was found, see [`Ask::why`].
    pub why: Option<Section>,
}

/// The precision a method computes in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// binary32
    F32,
    /// binary64
    #[default]
    F64,
}

impl Precision {
    /// Both, in the order of the command line's help.
    pub const ALL: [Precision; 2] = [Precision::F32, Precision::F64];

    /// The name that `--precision` takes.
    pub fn name(self) -> &'static str {
        match self {
            Precision::F32 => f32::NAME,
            Precision::F64 => f64::NAME,
        }
    }
}

/// The answer to `show`.
pub struct Shown {
    /// The steps.
    pub transcript: Transcript,
    /// The picture, of the size that was asked for.
    pub picture: Canvas,
    /// The ids of the objects that are seen, where the stage has [`Flag::Ids`].
    pub ids: Option<Ids>,
}

//! Cases drawn at random, the same for the same seed: ordinary numbers, and those that break formulas.

use stage::{About, Precision, Stage};

/// A source of cases.
pub(crate) struct Draw {
    state: u64,
    precision: Precision,
}

/// How the numbers of a row are drawn.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// Zeros, ones, and the ends of the range of exponents and of its square root.
    Special,
    /// Whole numbers from −9 to 9.
    Whole,
    /// From −1 to 1.
    Unit,
    /// Any bits that are a finite number.
    Bits,
    /// Any exponent: those of a row have nothing to do with each other.
    FarApart,
}

const KINDS: [Kind; 5] = [Kind::Special, Kind::Whole, Kind::Unit, Kind::Bits, Kind::FarApart];

impl Draw {
    pub(crate) fn new(seed: u64, precision: Precision) -> Draw {
        let state = if precision == Precision::F32 { !seed } else { seed };
        Draw { state, precision }
    }

    /// A case file of a stage, with the row's `regime` as its last column.
    pub(crate) fn case_file(&mut self, stage: &dyn Stage, rows: usize) -> String {
        let about = stage.about();
        let rows = (0..rows).map(|_| {
            let (regime, mut row) = self.row(about.inputs);
            for (column, words) in about.words {
                let place = about.inputs.iter().position(|name| name == column).unwrap();
                row[place] = self.below(words.len() as u64) as f64;
            }
            let tied = self.tie(about.inputs, &mut row);
            if (tied || regime == "exact") && self.below(4) == 0 {
                // One number a digit off.
                let place = self.place_of_a_number(&about);
                row[place] = self.next_up(row[place]);
            }
            self.make_possible(about.inputs, &mut row);
            self.spoil(&about, &mut row);
            format!("{},{regime}\n", about.row_of(&row, self.precision))
        });
        let rows: String = rows.collect();
        format!("{},regime\n{rows}", about.inputs.join(","))
    }

    /// The numbers of a row, whatever they mean.
    fn row(&mut self, columns: &[&str]) -> (&'static str, Vec<f64>) {
        match self.below(8) {
            0..3 => ("mixed", columns.iter().map(|_| self.number(None)).collect()),
            3..5 => {
                let kind = self.kind();
                ("alike", columns.iter().map(|_| self.number(Some(kind))).collect())
            }
            5 => ("far_apart", columns.iter().map(|_| self.number(Some(Kind::FarApart))).collect()),
            _ => ("exact", self.small_wholes(columns)),
        }
    }

    /// Small whole numbers, lengths times one power of two and directions times another: tangents,
    /// parallels and touches at every scale.
    fn small_wholes(&mut self, columns: &[&str]) -> Vec<f64> {
        let [length, direction] = [(); 2].map(|()| self.power());
        let scale = |column: &str| if is_direction(column) { direction } else { length };
        columns.iter().map(|column| self.whole(3) * scale(column)).collect()
    }

    /// Ties what would seldom coincide: touches, tangents and parallels of any numbers. Whether it did.
    fn tie(&mut self, columns: &[&str], row: &mut [f64]) -> bool {
        let (on, along) = match self.below(8) {
            0 => (true, false),
            1 => (false, true),
            2 => (true, true),
            _ => return false,
        };
        let place = |name: &str| columns.iter().position(|column| *column == name);
        let set = |row: &mut [f64], name: &str, number: f64| row[place(name).unwrap()] = number;
        let get = |row: &[f64], name: &str| place(name).map(|place| row[place]);
        if on {
            // The origin on the wall, at the point of the plane, at the center.
            let names = [("ox", "front"), ("ox", "px"), ("oy", "py"), ("oz", "pz")];
            for (name, same) in names.into_iter().chain([("ox", "cx"), ("oy", "cy"), ("oz", "cz")]) {
                if let Some(number) = get(row, same) {
                    set(row, name, number);
                }
            }
        }
        if along && place("front").is_some() {
            set(row, "dx", 0.0);
        }
        if along && place("nx").is_some() {
            let [dx, dy] = ["dx", "dy"].map(|name| get(row, name).unwrap());
            for (name, number) in [("nx", dy), ("ny", -dx), ("nz", 0.0)] {
                set(row, name, number);
            }
        }
        if let Some([az, bz, cz, dz]) = places(columns, ["az", "bz", "cz", "dz"])
            && along
        {
            // A triangle across the z axis, and a ray that is, too; with `on` it runs within it.
            (row[bz], row[cz], row[dz]) = (row[az], row[az], 0.0);
        }
        if on && let Some([o, a]) = places(columns, ["ox", "ax"]) {
            // The origin at a corner.
            row.copy_within(a..a + 3, o);
        }
        if let Some([ox, oy, dx, dy, _]) = places(columns, ["ox", "oy", "dx", "dy", "shape"]) {
            if on {
                // The origin on the wall of the unit cylinder, where it is not deformed.
                (row[ox], row[oy]) = (1.0, 0.0);
            }
            if along {
                (row[dx], row[dy]) = (0.0, 0.0);
            }
        }
        if let Some([dz, a13, a23, a31, a32]) = places(columns, ["dz", "a13", "a23", "a31", "a32"])
            && along
        {
            // The z axis stays: the ray is parallel to a plane across it, and with `on` lies in it.
            for zero in [dz, a13, a23, a31, a32] {
                row[zero] = 0.0;
            }
            if let Some([oz, tz, dx]) = places(columns, ["oz", "tz", "dx"]) {
                row[dx] = 1.0;
                if on {
                    row[oz] = row[tz];
                }
            }
        }
        if along && place("r").is_some() {
            // Down the z axis at a distance r from the center; with `on` it touches at t = 0.
            let [cy, r] = ["cy", "r"].map(|name| get(row, name).unwrap());
            for (name, number) in [("cx", 0.0), ("ox", r), ("oy", cy), ("dx", 0.0), ("dy", 0.0)] {
                set(row, name, number);
            }
        }
        true
    }

    /// Puts in order what most cases should have in order.
    fn make_possible(&mut self, columns: &[&str], row: &mut [f64]) {
        let place = |name: &str| columns.iter().position(|column| *column == name);
        for (low, high) in [("front", "back"), ("left", "right"), ("bottom", "top")] {
            if let Some((low, high)) = place(low).zip(place(high))
                && row[low] > row[high]
                && self.below(8) > 0
            {
                row.swap(low, high);
            }
        }
        for positive in ["r", "distance"] {
            if let Some(at) = place(positive).filter(|_| self.below(8) > 0) {
                row[at] = row[at].abs();
            }
        }
        for (length, within) in [("width", "col"), ("height", "row")] {
            if let Some((length, within)) = place(length).zip(place(within))
                && self.below(16) > 0
            {
                let most = if self.below(8) == 0 { 1 << 24 } else { 9 };
                let count = 1 + self.below(most);
                row[length] = count as f64;
                row[within] = self.below(count) as f64;
            }
        }
    }

    /// Makes a few cases invalid: a number that is not finite, a vector of zeros.
    fn spoil(&mut self, about: &About, row: &mut [f64]) {
        let columns = about.inputs;
        match self.below(64) {
            0 => {
                let place = self.place_of_a_number(about);
                row[place] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][self.below(3) as usize];
            }
            1 => {
                let vector = if self.below(2) == 0 { "d" } else { "n" };
                let of_vector = |column: &&str| is_direction(column) && column.starts_with(vector);
                for (number, _) in row.iter_mut().zip(columns).filter(|(_, column)| of_vector(column)) {
                    *number = if self.below(2) == 0 { 0.0 } else { -0.0 };
                }
            }
            _ => {}
        }
    }

    /// The place of a column that holds no word.
    fn place_of_a_number(&mut self, about: &About) -> usize {
        loop {
            let place = self.below(about.inputs.len() as u64) as usize;
            if about.words.iter().all(|(column, _)| *column != about.inputs[place]) {
                return place;
            }
        }
    }

    fn kind(&mut self) -> Kind {
        KINDS[self.below(KINDS.len() as u64) as usize]
    }

    /// A finite number of a kind, or of any.
    fn number(&mut self, kind: Option<Kind>) -> f64 {
        let kind = kind.unwrap_or_else(|| self.kind());
        let number = match kind {
            Kind::Special => self.special(),
            Kind::Whole => self.whole(9),
            Kind::Unit => self.unit(),
            Kind::Bits => self.bits(),
            Kind::FarApart => self.unit() * self.power(),
        };
        self.rounded(number)
    }

    fn special(&mut self) -> f64 {
        let wide = self.precision == Precision::F64;
        let (smallest, smallest_normal, largest) = match wide {
            true => (f64::from_bits(1), f64::MIN_POSITIVE, f64::MAX),
            false => (f32::from_bits(1).into(), f32::MIN_POSITIVE.into(), f32::MAX.into()),
        };
        let (root, end) = if wide { (1e150, 1e300) } else { (1e19, 1e38) };
        let magnitudes = [0.0, 1.0, smallest, smallest_normal, largest, root, 1.0 / root, end, 1.0 / end];
        let magnitude = magnitudes[self.below(magnitudes.len() as u64) as usize];
        if self.below(2) == 0 { magnitude } else { -magnitude }
    }

    fn whole(&mut self, most: u64) -> f64 {
        self.below(2 * most + 1) as f64 - most as f64
    }

    fn unit(&mut self) -> f64 {
        let number = self.fraction() * 2.0 - 1.0;
        self.rounded(number)
    }

    /// A power of two: nearly as large or as small as normal numbers are.
    fn power(&mut self) -> f64 {
        let most = if self.precision == Precision::F64 { 1018 } else { 122 };
        2.0_f64.powi(self.below(2 * most + 1) as i32 - most as i32)
    }

    fn bits(&mut self) -> f64 {
        loop {
            let number = match self.precision {
                Precision::F32 => f32::from_bits((self.next() >> 32) as u32).into(),
                Precision::F64 => f64::from_bits(self.next()),
            };
            if number.is_finite() {
                return number;
            }
        }
    }

    fn rounded(&self, number: f64) -> f64 {
        match self.precision {
            Precision::F32 => (number as f32).into(),
            Precision::F64 => number,
        }
    }

    fn next_up(&self, number: f64) -> f64 {
        match self.precision {
            Precision::F32 => (number as f32).next_up().into(),
            Precision::F64 => number.next_up(),
        }
    }

    /// A whole number from 0 to `count` − 1; a bias of count / 2^64 does no harm.
    fn below(&mut self, count: u64) -> u64 {
        self.next() % count
    }

    /// From 0 to 1.
    fn fraction(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Sixty-four bits (SplitMix64).
    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.state;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }
}

/// The places of columns; `None` where one of them is missing.
fn places<const N: usize>(columns: &[&str], names: [&str; N]) -> Option<[usize; N]> {
    let found = names.map(|name| columns.iter().position(|column| *column == name));
    found.iter().all(Option::is_some).then(|| found.map(Option::unwrap_or_default))
}

/// A component of a direction or of a normal.
fn is_direction(column: &str) -> bool {
    ["dx", "dy", "dz", "nx", "ny", "nz"].contains(&column)
}

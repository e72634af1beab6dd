//! Text in Haines's neutral file format, with numbers as his programs print them.

use std::fmt::Write;

/// Three coordinates.
pub(crate) type Point = [f64; 3];

/// A scene that is being written.
pub(crate) struct Nff(String);

/// Who looks from where, under which light.
pub(crate) struct View<'a> {
    pub(crate) from: Point,
    pub(crate) at: Point,
    pub(crate) up: Point,
    pub(crate) hither: f64,
    pub(crate) lights: &'a [Point],
}

impl Nff {
    /// A blue sky, 45 degrees across, 512 by 512 pixels.
    pub(crate) fn new(view: &View<'_>) -> Nff {
        let View { from, at, up, hither, lights } = view;
        let (from, at, up, hither) = (numbers(from), numbers(at), numbers(up), number(*hither));
        let mut nff = Nff("b 0.078 0.361 0.753\n".to_string());
        nff.line(format_args!(
            "v\nfrom {from}\nat {at}\nup {up}\nangle 45\nhither {hither}\nresolution 512 512"
        ));
        for light in *lights {
            nff.line(format_args!("l {}", numbers(light)));
        }
        nff
    }

    /// `f`: color, K_d, K_s, shininess, T and the index of refraction.
    pub(crate) fn material(&mut self, color: Point, [k_d, k_s, shine, t, ior]: [f64; 5]) {
        let rest = numbers(&[k_d, k_s, shine, t, ior]);
        self.line(format_args!("f {} {rest}", numbers(&color)));
    }

    pub(crate) fn sphere(&mut self, center: Point, radius: f64) {
        self.line(format_args!("s {} {}", numbers(&center), number(radius)));
    }

    /// From the base and its radius to the apex and its.
    pub(crate) fn cone(&mut self, (base, base_radius): (Point, f64), (apex, apex_radius): (Point, f64)) {
        let [base_radius, apex_radius] = [base_radius, apex_radius].map(number);
        self.line(format_args!("c {} {base_radius} {} {apex_radius}", numbers(&base), numbers(&apex)));
    }

    pub(crate) fn polygon(&mut self, corners: &[Point]) {
        self.line(format_args!("p {}", corners.len()));
        for corner in corners {
            self.line(format_args!("{}", numbers(corner)));
        }
    }

    pub(crate) fn text(self) -> String {
        self.0
    }

    fn line(&mut self, line: std::fmt::Arguments<'_>) {
        writeln!(self.0, "{line}").expect("a text grows");
    }
}

fn numbers(all: &[f64]) -> String {
    all.iter().map(|x| number(*x)).collect::<Vec<_>>().join(" ")
}

/// Six digits, without zeros at the end: C's `%g`.
fn number(x: f64) -> String {
    let scientific = format!("{x:.5e}");
    let Some((digits, exponent)) = scientific.split_once('e') else { return scientific };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let trimmed = |digits: &str| match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.').to_string(),
        false => digits.to_string(),
    };
    if (-4..6).contains(&exponent) {
        return trimmed(&format!("{x:.0$}", (5 - exponent) as usize));
    }
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{}e{sign}{:02}", trimmed(digits), exponent.abs())
}

#[test]
fn six_digits_as_c_prints_them() {
    let cases = [
        (0.0, "0"),
        (1.5, "1.5"),
        (-2.613125929752753, "-2.61313"),
        (0.0061728395, "0.00617284"),
        (100_000.0, "100000"),
        (1e6, "1e+06"),
        (-2.220446e-16, "-2.22045e-16"),
        (0.999_999_9, "1"),
    ];
    for (x, text) in cases {
        assert_eq!(number(x), text);
    }
}

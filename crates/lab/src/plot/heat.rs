//! The colors of a failure map.

use stage::Color;

use super::axis::log10;
use super::map::Cell;
use super::palette::mixed;

/// Nine colors of viridis (Smith, van der Walt, Firing, 2015), evenly spaced: equal steps of the scale look
/// equally far apart, and it grows lighter throughout, so it survives a printer without colors.
const VIRIDIS: [Color; 9] = [
    Color([68, 1, 84]),
    Color([71, 45, 123]),
    Color([59, 82, 139]),
    Color([44, 114, 142]),
    Color([33, 145, 140]),
    Color([40, 174, 128]),
    Color([94, 201, 98]),
    Color([173, 220, 48]),
    Color([253, 231, 37]),
];

/// The lightest color stands for 10 to this power ulps, and for all that is more.
pub(super) const LAST_POWER: i32 = 16;

/// Where no case fell.
pub(super) const EMPTY: Color = Color([240, 240, 240]);

/// Where all verdicts are wrong; where few are, it is vermillion.
const ALL_WRONG: Color = Color([160, 40, 0]);

/// The color of a cell.
pub(super) fn color(cell: Cell) -> Color {
    match cell {
        Cell::Empty => EMPTY,
        Cell::Wrong(share) if share.is_nan() => ALL_WRONG,
        Cell::Wrong(share) => mixed(Color::VERMILLION, ALL_WRONG, share),
        // an error that is no number is not a small one
        Cell::Ulps(ulps) if ulps.is_nan() => of_power(f64::from(LAST_POWER)),
        Cell::Ulps(ulps) => of_power(log10(ulps.max(1.0))),
    }
}

/// The color of 10 to this power ulps.
pub(super) fn of_power(power: f64) -> Color {
    let last = VIRIDIS.len() - 1;
    let place = (power / f64::from(LAST_POWER)).clamp(0.0, 1.0) * last as f64;
    let below = (place.floor() as usize).min(last - 1);
    mixed(VIRIDIS[below], VIRIDIS[below + 1], place - below as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lightness(Color([r, g, b]): Color) -> f64 {
        0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
    }

    #[test]
    fn more_ulps_are_lighter_up_to_the_end_of_the_scale() {
        let scale: Vec<f64> = (0..=160).map(|tenth| lightness(of_power(f64::from(tenth) / 10.0))).collect();
        assert!(scale.windows(2).all(|pair| pair[1] > pair[0]));
        for small in [0.0, 0.5, 1.0, -1.0] {
            assert_eq!(color(Cell::Ulps(small)), VIRIDIS[0]);
        }
        for large in [1e16, 1e300, f64::INFINITY, f64::NAN] {
            assert_eq!(color(Cell::Ulps(large)), VIRIDIS[8]);
        }
        assert_eq!(color(Cell::Ulps(1e8)), VIRIDIS[4]);
    }

    #[test]
    fn a_wrong_verdict_is_no_color_of_the_scale() {
        let far = |Color(a): Color, Color(b): Color| (0..3).map(|i| a[i].abs_diff(b[i])).max();
        for tenth in 0..=160 {
            let power = f64::from(tenth) / 10.0;
            let scale = of_power(power);
            for share in [0.0, 0.1, 0.5, 1.0, f64::NAN] {
                assert!(far(scale, color(Cell::Wrong(share))) > Some(60), "{power}, {share}");
            }
            assert!(far(scale, EMPTY) > Some(60));
        }
    }
}

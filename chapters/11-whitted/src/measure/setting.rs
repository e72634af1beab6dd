//! What can be set, and which settings are measured.

use signature::Method;
use stage::{Precision, TradeAsk};

/// A setting of all that trades time for accuracy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Whose formulas meet the shapes.
    pub method: Method,
    /// The precision.
    pub precision: Precision,
    /// The page's maxDepth.
    pub depth: u32,
    /// E of `--tolerance`; `None`: nothing is left out.
    pub tolerance: Option<f64>,
    /// N of `--samples`: N × N rays a pixel.
    pub samples: u32,
}

impl Setting {
    /// The samples that are measured.
    pub const SAMPLES: [u32; 4] = [4, 3, 2, 1];
    /// The tolerances that are measured, beside none.
    pub const TOLERANCES: [f64; 2] = [0.003, 0.03];

    /// What is to be typed to get it in a scene of such a depth; what goes without saying is not said.
    pub fn flags(&self, own_depth: u32) -> String {
        let mut flags = String::new();
        if self.method != Method::Robust {
            flags += &format!(" --method {}", self.method.name());
        }
        if self.precision != Precision::F64 {
            flags += &format!(" --precision {}", self.precision.name());
        }
        if self.depth != own_depth {
            flags += &format!(" --depth {}", self.depth);
        }
        if let Some(e) = self.tolerance {
            flags += &format!(" --tolerance {e}");
        }
        if self.samples != 1 {
            flags += &format!(" --samples {}", self.samples);
        }
        flags
    }
}

/// The dearest that anybody would take: nothing is saved, and as many samples as are measured.
pub(super) fn safest(depth: u32) -> Setting {
    let samples = Setting::SAMPLES[0];
    Setting { method: Method::Robust, precision: Precision::F64, depth, tolerance: None, samples }
}

/// The depths that are measured in a scene of such a depth: its own first.
fn depths(own: u32) -> Vec<u32> {
    let less = [own.div_ceil(2), 3, 2, 1];
    let mut depths = vec![own];
    for depth in less {
        if depths.last().is_some_and(|last| depth < *last) {
            depths.push(depth);
        }
    }
    depths
}

/// All that are asked for, in a scene of such a depth, from the dearest on; the safest is the first in any
/// case.
pub(super) fn settings(ask: &TradeAsk, own_depth: u32) -> Vec<Setting> {
    let mut all = vec![safest(own_depth)];
    let methods: Vec<Method> = (0..Method::ALL.len())
        .filter(|place| ask.wants_method(*place))
        .map(|place| Method::ALL[place])
        .collect();
    for precision in [Precision::F64, Precision::F32].into_iter().filter(|it| ask.wants_precision(*it)) {
        for &method in &methods {
            for depth in depths(own_depth) {
                for tolerance in std::iter::once(None).chain(Setting::TOLERANCES.map(Some)) {
                    for samples in Setting::SAMPLES {
                        let setting = Setting { method, precision, depth, tolerance, samples };
                        // at depth 1 there is nothing to leave out
                        if setting != all[0] && (depth > 1 || tolerance.is_none()) {
                            all.push(setting);
                        }
                    }
                }
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depths_go_down_to_local_light_alone() {
        assert_eq!(depths(50), [50, 25, 3, 2, 1]);
        assert_eq!(depths(5), [5, 3, 2, 1]);
        assert_eq!(depths(4), [4, 2, 1]);
        assert_eq!(depths(1), [1]);
    }

    #[test]
    fn only_what_differs_is_typed() {
        let safest = Setting { samples: 1, ..safest(5) };
        assert_eq!(safest.flags(5), "");
        let all = Setting {
            method: Method::Notes,
            precision: Precision::F32,
            depth: 3,
            tolerance: Some(0.003),
            samples: 2,
        };
        assert_eq!(all.flags(5), " --method notes --precision f32 --depth 3 --tolerance 0.003 --samples 2");
    }
}

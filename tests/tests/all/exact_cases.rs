//! Every method against the case files of exact answers: what `robust` keeps to, and what the notes'
//! methods lose.

use std::collections::BTreeMap;

use stage::Precision;
use tests::{Bars, STAGES, stage_named};

use crate::exact::{Answer, answers, assert_none, case_file};

/// A stage with exact answers, and what its method `robust` promises about them.
struct Promise {
    stage: &'static str,
    /// The parameters of a hit.
    parameters: &'static [&'static str],
    /// How far a point is from the surface, and the size of the numbers it was computed from.
    residual: fn(answer: &Answer, point: [f64; 3]) -> (f64, f64),
}

impl Promise {
    /// The most that the parameters may be off, in ulps: what is seen of these cases, which is less than
    /// what the method promises of all.
    fn bar(&self, precision: Precision) -> u64 {
        Bars::of(self.stage).seen(precision)
    }
}

const PROMISES: &[Promise] = &[
    Promise { stage: "ray-wall", parameters: &["t", "t_out"], residual: from_the_wall },
    Promise { stage: "ray-plane", parameters: &["t"], residual: from_the_plane },
    Promise { stage: "ray-sphere", parameters: &["t", "t_out"], residual: from_the_sphere },
    Promise { stage: "triangle", parameters: &["t"], residual: from_the_barycentric },
    Promise { stage: "quadric", parameters: &["t"], residual: from_the_solid },
    Promise { stage: "affine", parameters: &["t"], residual: from_the_line },
];

/// x − front or x − back, whichever face is nearer.
fn from_the_wall(answer: &Answer, [x, _, _]: [f64; 3]) -> (f64, f64) {
    let [front, back] = answer.want.numbers(["front", "back"]);
    ((x - front).abs().min((x - back).abs()), x.abs())
}

/// n · (x − p) / ‖n‖
fn from_the_plane(answer: &Answer, x: [f64; 3]) -> (f64, f64) {
    let p = answer.want.numbers(["px", "py", "pz"]);
    let n = answer.want.numbers(["nx", "ny", "nz"]);
    // A normal of a length near 1, so that nothing overflows.
    let largest = n.map(f64::abs).into_iter().fold(0.0, f64::max);
    let n = n.map(|component| component / largest);
    let distance = (0..3).map(|i| n[i] * (x[i] - p[i])).sum::<f64>() / length(n);
    (distance.abs(), length(p))
}

/// ‖x − c‖ − r, and x − (c + r n) with the normal that was printed: the larger of the two.
fn from_the_sphere(answer: &Answer, x: [f64; 3]) -> (f64, f64) {
    let c = answer.want.numbers(["cx", "cy", "cz"]);
    let r = answer.want.number("r");
    let n = answer.got.numbers(["nx", "ny", "nz"]);
    let from_center = [0, 1, 2].map(|i| x[i] - c[i]);
    let from_normal = length([0, 1, 2].map(|i| from_center[i] - r * n[i]));
    ((length(from_center) - r).abs().max(from_normal), length(c) + r)
}

/// x − (a + α (b − a) + β (c − a)) with the α and β that were printed.
fn from_the_barycentric(answer: &Answer, x: [f64; 3]) -> (f64, f64) {
    let [a, b, c] = [["ax", "ay", "az"], ["bx", "by", "bz"], ["cx", "cy", "cz"]]
        .map(|columns| answer.want.numbers(columns));
    let [alpha, beta] = answer.got.numbers(["alpha", "beta"]);
    // Weighted corners and not differences: these overflow where the corners do not.
    let gamma = 1.0 - alpha - beta;
    let point = [0, 1, 2].map(|i| gamma * a[i] + alpha * b[i] + beta * c[i]);
    (length([0, 1, 2].map(|i| x[i] - point[i])), length(a) + length(b) + length(c))
}

/// How far from the wall of the unit cylinder or cone or from one of its caps, whichever is nearer.
fn from_the_solid(answer: &Answer, [x, y, z]: [f64; 3]) -> (f64, f64) {
    let (wall, cap) = match answer.want.text("shape") {
        "cylinder" => (x.hypot(y) - 1.0, z.abs() - 1.0),
        _ => (x.hypot(y) - (1.0 - z) / 2.0, z),
    };
    (wall.abs().min(cap.abs()), 1.0)
}

/// x − (o + t d): the surface is deformed, the ray is not.
fn from_the_line(answer: &Answer, x: [f64; 3]) -> (f64, f64) {
    let [o, d] = [["ox", "oy", "oz"], ["dx", "dy", "dz"]].map(|columns| answer.want.numbers(columns));
    let t = answer.got.number("t");
    (length([0, 1, 2].map(|i| x[i] - (o[i] + t * d[i]))), 0.0)
}

/// ‖v‖, without overflow on the way.
fn length([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}

/// Every promise at both precisions.
fn promises() -> impl Iterator<Item = (&'static Promise, Precision)> {
    PROMISES.iter().flat_map(|promise| Precision::ALL.map(|precision| (promise, precision)))
}

/// The answers of a method to the file of its own precision.
fn own_answers(stage: &str, method: &str, precision: Precision) -> Vec<Answer> {
    answers(&case_file(stage, precision), stage, method, precision)
}

#[test]
fn robust_agrees_with_the_exact_answers() {
    let mut failures = Vec::new();
    for (promise, precision) in promises() {
        for answer in own_answers(promise.stage, "robust", precision) {
            let fault = fault(&answer, promise, precision);
            failures.extend(fault.map(|fault| format!("{fault}; {}", answer.place)));
        }
    }
    assert_none(failures);
}

/// What is wrong with an answer; `None` where it is right.
fn fault(answer: &Answer, promise: &Promise, precision: Precision) -> Option<String> {
    let Answer { want, got, .. } = answer;
    let differ = |column: &str| format!("{column}: want {:?}, got {:?}", want.text(column), got.text(column));
    if !answer.has_right_verdict() {
        return Some(differ("hit"));
    }
    match want.text("hit") {
        "1" => promise.parameters.iter().find_map(|column| {
            let (ulps, bar) = (answer.ulps(column, precision), promise.bar(precision));
            (ulps > bar).then(|| format!("{}, {ulps} ulps off, the bar is {bar}", differ(column)))
        }),
        "invalid" => got.text("reason").is_empty().then(|| "no reason is given".to_string()),
        _ => (got.text("reason") != want.text("reason")).then(|| differ("reason")),
    }
}

/// The bars are not wider than they need be.
#[test]
fn what_is_seen_of_robust_is_the_bar() {
    for (promise, precision) in promises() {
        let answers = own_answers(promise.stage, "robust", precision);
        let hits = answers.iter().filter(|answer| answer.is_hit());
        let ulps = hits.flat_map(|hit| promise.parameters.iter().map(|column| hit.ulps(column, precision)));
        let (stage, precision_name) = (promise.stage, precision.name());
        assert_eq!(
            ulps.max(),
            Some(promise.bar(precision)),
            "{stage} {precision_name}: the bar is in bars.rs"
        );
    }
}

#[test]
fn hit_points_lie_on_the_surface() {
    let mut failures = Vec::new();
    for (promise, precision) in promises() {
        let (epsilon, smallest, largest) = match precision {
            Precision::F32 => (f32::EPSILON.into(), f32::from_bits(1).into(), f32::MAX.into()),
            Precision::F64 => (f64::EPSILON, f64::from_bits(1), f64::MAX),
        };
        for answer in own_answers(promise.stage, "robust", precision).iter().filter(|answer| answer.is_hit())
        {
            let (point, size) = hit_point(answer);
            // A t or a point beyond the largest number is not on the surface, and cannot be.
            if size > largest {
                continue;
            }
            let (residual, surface) = (promise.residual)(answer, point);
            // t is off by as many ulps as the bar allows, t d and the sum by a half each, and the residual is rounded as well.
            let bound = (promise.bar(precision) as f64 + 4.0) * epsilon * (size + surface) + 8.0 * smallest;
            if residual.is_nan() || residual > bound {
                failures.push(format!("{residual:e} from the surface, at most {bound:e}; {}", answer.place));
            }
        }
    }
    assert_none(failures);
}

#[test]
fn normals_have_length_one() {
    let mut failures = Vec::new();
    for (promise, precision) in promises() {
        let epsilon = if precision == Precision::F32 { f32::EPSILON.into() } else { f64::EPSILON };
        let answers = own_answers(promise.stage, "robust", precision);
        for answer in answers.iter().filter(|answer| !answer.got.text("nx").is_empty()) {
            let off = length(answer.got.numbers(["nx", "ny", "nz"])) - 1.0;
            if off.is_nan() || off.abs() > 4.0 * epsilon {
                failures.push(format!("the length of the normal is off by {off:e}; {}", answer.place));
            }
        }
    }
    assert_none(failures);
}

/// The point of a hit (z = 0 in the plane), and how large the numbers of o + t d are on the way.
fn hit_point(answer: &Answer) -> ([f64; 3], f64) {
    let t = answer.got.number("t");
    let (mut point, mut size) = ([0.0; 3], 0.0);
    let axes = ["x", "y", "z"].into_iter().filter(|axis| !answer.got.text(axis).is_empty());
    for (i, axis) in axes.enumerate() {
        let [o, d] = answer.want.numbers([&format!("o{axis}"), &format!("d{axis}")]);
        point[i] = answer.got.number(axis);
        size += o.abs() + (t * d).abs();
    }
    (point, size)
}

#[test]
fn no_method_prints_nan_in_any_column_or_a_negative_t_for_a_hit() {
    let mut failures = Vec::new();
    for (promise, file_precision) in promises() {
        let file = case_file(promise.stage, file_precision);
        for method in stage_named(promise.stage).unwrap().about().methods {
            for precision in Precision::ALL {
                for answer in answers(&file, promise.stage, method, precision) {
                    let t = answer.got.text("t");
                    let nan = answer.got.nan_columns();
                    if !nan.is_empty() || answer.is_hit() && (t.is_empty() || t.starts_with('-')) {
                        failures.push(format!("t = {t}, nan in {nan:?}; {}", answer.place));
                    }
                }
            }
        }
    }
    assert_none(failures);
}

/// What a method gets wrong in one regime.
#[derive(Clone, Copy, Debug, Default)]
struct Losses {
    /// Hits that are none, misses that are none.
    wrong_verdicts: usize,
    /// How far t is off at most, in ulps, where the verdict is right.
    worst_t: u64,
}

/// What a method gets wrong, by regime.
fn losses(stage: &str, method: &str, precision: Precision) -> BTreeMap<String, Losses> {
    let mut regimes: BTreeMap<String, Losses> = BTreeMap::new();
    for answer in own_answers(stage, method, precision) {
        let losses = regimes.entry(answer.regime().to_string()).or_default();
        if !answer.has_right_verdict() {
            losses.wrong_verdicts += 1;
        } else if answer.is_hit() {
            losses.worst_t = losses.worst_t.max(answer.ulps("t", precision));
        }
    }
    regimes
}

#[test]
fn robust_is_at_least_as_accurate_as_every_other_method() {
    for (Promise { stage, .. }, precision) in promises() {
        let robust = losses(stage, "robust", precision);
        for method in stage_named(stage).unwrap().about().methods {
            for (regime, other) in losses(stage, method, precision) {
                let ours = robust[&regime];
                assert!(
                    ours.wrong_verdicts <= other.wrong_verdicts && ours.worst_t <= other.worst_t,
                    "{stage} {} {regime}: robust {ours:?}, {method} {other:?}",
                    precision.name()
                );
            }
        }
    }
}

/// In these regimes the first method judges worse than the second, at f64.
struct Ordering {
    stage: &'static str,
    worse: &'static str,
    better: &'static str,
    regimes: &'static [&'static str],
    why: &'static str,
}

const MORE_WRONG_VERDICTS: &[Ordering] = &[
    Ordering {
        stage: "ray-plane",
        worse: "notes",
        better: "robust",
        regimes: &["on_plane", "near_parallel"],
        why: "the signs of n · (p_r − p_0) and n · u_r decide, and both are rounded sums whose terms cancel",
    },
    Ordering {
        stage: "ray-plane",
        worse: "notes",
        better: "robust",
        regimes: &["bits"],
        why: "products of very large or very small numbers overflow or vanish, and their signs with them",
    },
    Ordering {
        stage: "ray-sphere",
        worse: "quadratic",
        better: "closest-approach",
        regimes: &["far", "far_extreme", "tiny", "grazing", "grazing_far"],
        why: "b² − 4ac subtracts numbers of the size of distance², beside which r² is below the last digit; \
              d = ‖x_close − c‖ is measured next to the sphere",
    },
    Ordering {
        stage: "ray-sphere",
        worse: "half-quadratic",
        better: "closest-approach",
        regimes: &["far", "far_extreme", "tiny", "grazing", "grazing_far"],
        why: "B² − A C is b² − 4ac with the twos divided out: the same digits are lost",
    },
    Ordering {
        stage: "ray-sphere",
        worse: "closest-approach",
        better: "quadratic",
        regimes: &["surface_exact"],
        why: "a ray that starts on the sphere, in whole numbers: ⟨CO, CO⟩ − r² is exactly 0 and so is the root; \
              t_close − √(r² − d²) comes out a digit beside 0, and falls behind the origin",
    },
    Ordering {
        stage: "ray-sphere",
        worse: "closest-approach",
        better: "robust",
        regimes: &["tangent_exact", "on_surface", "scene_scale_extreme", "dir_scale_extreme", "bits"],
        why: "d < r is decided on rounded numbers, and squares overflow or vanish",
    },
];

#[test]
fn the_notes_methods_misjudge_where_digits_cancel() {
    for Ordering { stage, worse, better, regimes, why } in MORE_WRONG_VERDICTS {
        let [loser, winner] = [worse, better].map(|method| losses(stage, method, Precision::F64));
        for regime in *regimes {
            let [lost, won] = [loser[*regime], winner[*regime]].map(|losses| losses.wrong_verdicts);
            assert!(lost > won, "{stage} {regime}: {worse} {lost}, {better} {won}; yet {why}");
        }
    }
}

const LESS_ACCURATE: &[Ordering] = &[
    Ordering {
        stage: "ray-wall",
        worse: "notes",
        better: "robust",
        regimes: &["ordinary", "thin", "far"],
        why: "(front − p_x) / u_x is rounded twice",
    },
    Ordering {
        stage: "ray-plane",
        worse: "notes",
        better: "robust",
        regimes: &["ordinary", "shifted", "near_parallel"],
        why: "n · u_r loses the digits that cancel in its sum, and t divides by it; \
              p_r − p_0 has lost some before, where both are far from the world's origin",
    },
    Ordering {
        stage: "ray-sphere",
        worse: "quadratic",
        better: "closest-approach",
        regimes: &["ordinary", "far", "far_extreme", "tiny"],
        why: "the discriminant has lost digits before the root is taken, and every one of them is missing from t",
    },
    Ordering {
        stage: "ray-sphere",
        worse: "closest-approach",
        better: "quadratic",
        regimes: &["shifted"],
        why: "everything stands far from the world's origin: x_close has the coarse digits of there, \
              CO = O − C is taken first and has its own",
    },
];

#[test]
fn the_notes_methods_lose_digits_of_t() {
    for Ordering { stage, worse, better, regimes, why } in LESS_ACCURATE {
        let [loser, winner] = [worse, better].map(|method| losses(stage, method, Precision::F64));
        for regime in *regimes {
            let [lost, won] = [loser[*regime], winner[*regime]].map(|losses| losses.worst_t);
            assert!(lost > 2 * won, "{stage} {regime}: {worse} {lost} ulps, {better} {won} ulps; yet {why}");
        }
    }
}

#[test]
fn every_stage_with_exact_answers_is_tested() {
    for stage in STAGES {
        let name = stage.about().name;
        let promised = PROMISES.iter().any(|promise| promise.stage == name);
        assert_eq!(promised, case_file(name, Precision::F64).exists(), "{name}");
    }
}

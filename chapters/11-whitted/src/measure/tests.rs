use signature::Method;

use super::*;

fn ask(regime: &str) -> TradeAsk {
    TradeAsk {
        method: None,
        precision: None,
        regimes: vec![regime.to_string()],
        cases: None,
        seed: 1,
        quick: false,
        scene: None,
    }
}

/// Eight pixels, and no more rounds than it takes.
fn measured(ask: &TradeAsk) -> Measured {
    let scene = SCENES.into_iter().find(|scene| scene.name == ask.regimes[0]).unwrap();
    let effort = Effort { pixels: 8, one_of: 4, allowed: Duration::ZERO };
    in_scene(scene.name.to_string(), String::new(), &scene.file().unwrap(), ask, effort).unwrap()
}

/// The same with a mesh, in glass and at depth 50: what is off is off as far as it may be, and in the right
/// order.
#[test]
fn what_each_setting_costs_in_accuracy() {
    for name in ["whitted", "teapot", "hall-of-mirrors"] {
        let measured = measured(&ask(name));
        let safest = measured.safest().unwrap();
        assert_eq!(safest.setting, setting::safest(measured.depth));
        assert_eq!(safest.alone, Off::default(), "{name}: it is its own yardstick");
        assert!(safest.off.rmse > 0.0, "{name}: and is no reference");
        assert!(measured.entries.iter().any(|entry| entry.on_front));
        for entry in &measured.entries {
            let Setting { method, precision, depth, tolerance, samples } = entry.setting;
            assert_eq!(entry.counts.eye, 8 * u64::from(samples * samples), "{name}");
            assert!(entry.seconds > 0.0);
            // what a tolerance leaves out is at most E
            let exact = (method, precision, depth) == (Method::Robust, Precision::F64, measured.depth);
            if exact {
                assert!(entry.alone.largest <= tolerance.unwrap_or(0.0), "{name}: {entry:?}");
            }
            // fewer rays, and the more depth is left away the fewer
            assert!(entry.counts.rays() <= safest.counts.rays(), "{name}: {entry:?}");
        }
        let local = measured.entries.iter().filter(|entry| entry.setting.depth == 1);
        assert!(local.clone().all(|entry| entry.counts.mirror + entry.counts.refracted == 0));
        assert!(local.clone().all(|entry| entry.alone.rmse > 0.01), "{name}: what mirrors is missing");
    }
}

/// What is asked for, and the yardstick.
#[test]
fn one_method_at_one_precision() {
    let notes = Method::ALL.iter().position(|method| *method == Method::Notes);
    let ask = TradeAsk { method: notes, precision: Some(Precision::F32), ..ask("gambetta") };
    let entries = measured(&ask).entries;
    assert_eq!(entries[0].setting, setting::safest(4));
    let others = entries[1..].iter().map(|entry| (entry.setting.method, entry.setting.precision));
    assert!(entries.len() > 1 && others.into_iter().all(|it| it == (Method::Notes, Precision::F32)));
}

#[test]
fn a_scene_that_there_is_not() {
    assert!(matches!(measure(&ask("nowhere")), Err(Error::Request(_))));
}

/// By hand: 2 s are a twentieth more than 1.95 s, and as good as as fast.
#[test]
fn the_fastest_that_is_exact_enough() {
    let entry = |seconds, rmse| Entry {
        setting: setting::safest(5),
        seconds,
        counts: Counts::default(),
        off: Off { rmse, largest: rmse },
        alone: Off::default(),
        on_front: true,
    };
    let measured = Measured {
        name: String::new(),
        what: String::new(),
        path: None,
        size: (1, 1),
        depth: 5,
        pixels: 1,
        entries: vec![entry(9.0, 0.001), entry(2.0, 0.01), entry(1.95, 0.02), entry(1.0, 0.1)],
    };
    let below = |e| measured.fastest_below(e).map(|entry| entry.seconds);
    assert_eq!([1e-4, 0.005, 0.03, 0.2].map(below), [None, Some(9.0), Some(2.0), Some(1.0)]);
}

/// Between two mirrors at the greatest depth: more than the stack of a test holds.
#[test]
fn a_thousand_levels_are_measured_too() {
    let path = std::env::temp_dir().join(format!("whitted-deep-{}.toml", std::process::id()));
    let wall = "[[object]]\nmaterial = \"m\"\nplane = { normal = [0, 0, 1], point = ";
    let text = format!(
        "max_depth = 1000\n[camera]\neye = [0, 0, 0]\nforward = [0, 0, 1]\nsize = [1, 1]\n\
         [material.m]\nambient = 0.001\ndiffuse = 0\nmirror = 1\n{wall}[0, 0, 1] }}\n{wall}[0, 0, -1] }}\n"
    );
    std::fs::write(&path, text).unwrap();
    let ask = TradeAsk {
        regimes: Vec::new(),
        precision: Some(Precision::F64),
        scene: Some(path.clone()),
        cases: Some(1),
        quick: true,
        ..ask("")
    };
    let measured = measure(&ask).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert_eq!((measured[0].depth, measured[0].entries[0].counts.rays()), (1000, 16_000));
}

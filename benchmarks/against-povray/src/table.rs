//! The tables: how many rays, and how many a second.

use crate::Measured;

/// The rays of each scene by kind, POV-Ray's and ours, and how far the pictures are apart.
pub fn counts(of: &[Measured]) -> String {
    let head =
        ["scene", "program", "eye", "shadow", "mirror", "refracted", "mean difference", "pixels apart"];
    let mut rows = vec![head.map(String::from).to_vec()];
    for it in of {
        let pov = [it.pov.eye(), it.pov.shadow, it.pov.reflected, it.pov.refracted];
        rows.push([vec![it.name.clone(), "POV-Ray".into()], pov.map(|n| n.to_string()).to_vec()].concat());
        if let Some(ours) = &it.ours {
            let rays = [ours.rays.eye, ours.rays.shadow, ours.rays.mirror, ours.rays.refracted];
            let apart = vec![
                format!("{:.3}/255", ours.difference.mean),
                format!("{:.3} %", 100.0 * ours.difference.visible),
            ];
            let first = vec![String::new(), "whitted".into()];
            rows.push([first, rays.map(|n| n.to_string()).to_vec(), apart].concat());
        }
    }
    aligned(&rows)
}

/// Seconds and millions of rays a second of each scene, and how many times as fast ours is: by time, since
/// both draw the same picture. The whole of our process is set against the tracing alone of POV-Ray's, which
/// is the stricter, and against the whole of it. `is_averaged` says which scenes are in the geometric means
/// of the last line.
pub fn rates(of: &[Measured], is_averaged: impl Fn(&Measured) -> bool) -> String {
    let head = [
        "scene",
        "size",
        "depth",
        "POV trace s",
        "Mray/s",
        "POV all s",
        "ours all s",
        "Mray/s",
        "× trace",
        "× all",
    ];
    let mut rows = vec![head.map(String::from).to_vec()];
    let mut ratios = Vec::new();
    for it in of {
        let rate = |rays: u64, seconds: f64| format!("{:.2}", 1e-6 * rays as f64 / seconds);
        let mut row = vec![
            it.name.clone(),
            format!("{} × {}", it.pov.size.0, it.pov.size.1),
            it.pov.depth.to_string(),
            format!("{:.3}", it.pov_seconds),
            rate(it.pov_rays(), it.pov_seconds),
            format!("{:.3}", it.pov_whole),
        ];
        if let Some(ours) = &it.ours {
            let faster = [it.pov_seconds, it.pov_whole].map(|seconds| seconds / ours.seconds);
            row.extend([format!("{:.3}", ours.seconds), rate(ours.rays.rays(), ours.seconds)]);
            row.extend(faster.map(|times| format!("{times:.2}")));
            if is_averaged(it) {
                ratios.push(faster);
            }
        }
        rows.push(row);
    }
    let mut text = aligned(&rows);
    if !ratios.is_empty() {
        let mean = |which: usize| {
            let logarithms = ratios.iter().map(|faster| faster[which].ln()).sum::<f64>();
            (logarithms / ratios.len() as f64).exp()
        };
        let (tracing, whole, scenes) = (mean(0), mean(1), ratios.len());
        text +=
            &format!("geometric mean over the {scenes} SPD scenes: {tracing:.2} × trace, {whole:.2} × all\n");
    }
    text
}

/// Columns as wide as their widest cell; the first is set to the left, the others to the right.
fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width =
        |column: usize| rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max();
    let widths: Vec<usize> = (0..columns).map(|column| width(column).unwrap_or(0)).collect();
    let line = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).enumerate().map(|(column, (cell, &width))| match column {
            0 => format!("{cell:<width$}"),
            _ => format!("{cell:>width$}"),
        });
        cells.collect::<Vec<_>>().join("  ").trim_end().to_string() + "\n"
    };
    rows.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measured::Ours;
    use crate::{Difference, Statistics, Transcript};

    fn scene(name: &str, pov_seconds: f64, seconds: f64) -> Measured {
        let pov = Statistics {
            size: (1000, 1000),
            depth: 5,
            rays: 1_500_000,
            shadow: 500_000,
            reflected: 300_000,
            refracted: 200_000,
            trace_seconds: pov_seconds,
        };
        let rays = Transcript { eye: 1_000_000, shadow: 500_000, mirror: 300_000, refracted: 200_000 };
        let difference = Difference { mean: 0.25, visible: 0.01 };
        Measured {
            name: name.into(),
            pov,
            pov_seconds,
            pov_whole: pov_seconds + 1.0,
            ours: Some(Ours { rays, seconds, difference }),
        }
    }

    #[test]
    fn two_million_rays_in_four_seconds_and_in_half_a_second() {
        let text = rates(&[scene("a", 4.0, 0.5)], |_| false);
        let line: Vec<&str> = text.lines().nth(1).unwrap().split_whitespace().collect();
        assert_eq!(
            line,
            ["a", "1000", "×", "1000", "5", "4.000", "0.50", "5.000", "0.500", "4.00", "8.00", "10.00"]
        );
        assert_eq!(text.lines().count(), 2);
    }

    #[test]
    fn the_geometric_mean_is_of_those_asked_for() {
        // 1 and 9 make √9 = 3, and with the second more that the whole takes 2 and 10 make √20; the third is
        // not asked for
        let scenes = [scene("a", 1.0, 1.0), scene("b", 9.0, 1.0), scene("c", 100.0, 1.0)];
        let text = rates(&scenes, |it| it.name != "c");
        assert_eq!(
            text.lines().last(),
            Some("geometric mean over the 2 SPD scenes: 3.00 × trace, 4.47 × all")
        );
    }

    #[test]
    fn counts_stand_under_each_other() {
        let want = "\
scene  program      eye  shadow  mirror  refracted  mean difference  pixels apart
a      POV-Ray  1000000  500000  300000     200000
       whitted  1000000  500000  300000     200000        0.250/255       1.000 %
";
        assert_eq!(counts(&[scene("a", 1.0, 1.0)]), want);
        let alone = Measured { ours: None, ..scene("a", 1.0, 1.0) };
        assert_eq!(counts(&[alone]).lines().count(), 2);
    }
}

//! quick
mod peer;
mod rays;
mod scenes;
mod turns;

use std::path::Path;
use std::time::Instant;

use bounds::wide::WideMesh;
use bounds::*;
use math::{Ray3, Real, Span, Vector};
use peer::Peer;
use scenes::vector;
use triangle::{Method, Triangle};

fn main() {
    let dir = std::env::args().nth(1).unwrap_or("../shared/scenes".into());
    let dir = Path::new(&dir);
    let only = std::env::args().nth(2).unwrap_or("all".into());
    if only == "all" || only == "balls" {
        let balls = scenes::balls(&dir.join("nff-default/balls.nff.gz")).unwrap();
        balls_at::<f64>(&balls);
        balls_at::<f32>(&balls);
    }
    if only == "build" {
        let scene = scenes::torus();
        let triangles: Vec<Triangle<f32>> = scene
            .corners
            .iter()
            .map(|&[a, b, c]| Triangle { a: vector::<f32>(a), b: vector::<f32>(b), c: vector::<f32>(c) })
            .collect();
        let theirs = peer::triangles(&scene.corners);
        for _ in 0..3 {
            let t0 = turns::on_processor();
            let w = WideMesh::of_triangles(&triangles);
            let t1 = turns::on_processor();
            let p = Peer::build(&theirs, obvhs::BvhBuildParams::medium_build());
            let t2 = turns::on_processor();
            println!("ours {:.3} peer {:.3} ratio {:.2}", t1 - t0, t2 - t1, (t1 - t0) / (t2 - t1));
            drop((p, w));
        }
        return;
    }
    for scene in [scenes::bunny(&dir.join("obj/bunny.obj")).unwrap(), scenes::torus()] {
        if only == "all" || only == scene.name {
            mesh(&scene);
        }
    }
}

fn balls_at<R: Real>(balls: &scenes::Balls) {
    let spheres: Vec<ray_sphere::Sphere<R>> = balls
        .spheres
        .iter()
        .map(|&(c, r)| ray_sphere::Sphere { center: vector::<R>(c), radius: R::round_from(r) })
        .collect();
    let boxes: Vec<Box3> = spheres.iter().map(|s| Box3::around_sphere(s.center, s.radius)).collect();
    let rays: Vec<Ray3<R>> = rays::rounded(&rays::primary(&balls.camera, 512));
    let few: Vec<Ray3<R>> = rays.iter().copied().step_by(1024 + 11).collect();
    let (tree, wide) = (Tree::build(&boxes), Wide::build(&boxes));
    let test = |i: usize, ray: &Ray3<R>, span: Span<R>| {
        ray_sphere::robust(ray, &spheres[i]).hit(span).ok().flatten().map(|h| h.t)
    };
    let brute = |ray: &Ray3<R>| {
        let mut n = Nearest::new(Span::ahead());
        for i in 0..spheres.len() {
            if let Some(t) = test(i, ray, Span::ahead()) {
                n.put(i, t)
            }
        }
        n.hit()
    };
    let by_tree =
        |ray: &Ray3<R>| tree.closest(ray, Span::ahead(), &mut Uncounted, |i, span| test(i, ray, span));
    let by_wide =
        |ray: &Ray3<R>| wide.closest(ray, Span::ahead(), &mut Uncounted, |i, span| test(i, ray, span));
    let wrong = few.iter().filter(|r| brute(r) != by_tree(r) || brute(r) != by_wide(r)).count();
    let mut c = [Counts::default(); 2];
    for ray in &rays {
        tree.closest(ray, Span::ahead(), &mut c[0], |i, span| test(i, ray, span));
        wide.closest(ray, Span::ahead(), &mut c[1], |i, span| test(i, ray, span));
    }
    let hits = |rays: &[Ray3<R>], f: &dyn Fn(&Ray3<R>) -> bool| rays.iter().filter(|r| f(r)).count();
    println!(
        "balls {} few {} hits {} wrong {wrong} {c:?}",
        R::NAME,
        few.len(),
        hits(&rays, &|r| by_tree(r).is_some())
    );
    let s = turns::medians(
        7,
        &mut [
            &mut || few.iter().filter(|r| brute(r).is_some()).count(),
            &mut || rays.iter().filter(|r| by_tree(r).is_some()).count(),
            &mut || rays.iter().filter(|r| by_wide(r).is_some()).count(),
        ],
    );
    let ns = [s[0] / few.len() as f64 * 1e9, s[1] / rays.len() as f64 * 1e9, s[2] / rays.len() as f64 * 1e9];
    println!("ns {ns:.1?} tree {:.1}x wide {:.1}x", ns[0] / ns[1], ns[0] / ns[2]);
}

fn mesh(scene: &scenes::Triangles) {
    let triangles: Vec<Triangle<f32>> = scene
        .corners
        .iter()
        .map(|&[a, b, c]| Triangle { a: vector::<f32>(a), b: vector::<f32>(b), c: vector::<f32>(c) })
        .collect();
    let theirs = peer::triangles(&scene.corners);
    let start = Instant::now();
    let ours = WideMesh::of_triangles(&triangles);
    println!("{} {} triangles; ours built {:?}", scene.name, triangles.len(), start.elapsed());
    let start = Instant::now();
    let ours2 = WideMesh::of_triangles(&triangles);
    println!("again {:?}", start.elapsed());
    drop(ours2);
    let peers: Vec<_> = peer::PRESETS
        .iter()
        .filter(|(name, _)| std::env::args().nth(3).is_none_or(|only| only == *name))
        .map(|(name, preset)| {
            let (peer, time) = Peer::build(&theirs, preset());
            println!("  {name} built {time:?}");
            (*name, peer)
        })
        .collect();
    let primary = rays::primary(&scene.camera, 1024);
    let rays32: Vec<Ray3<f32>> = rays::rounded(&primary);
    let mut points = Vec::new();
    for (ray, line) in rays32.iter().zip(&primary) {
        if let Some((face, t)) = ours.closest(Method::Matrix, ray, Span::ahead(), &mut Uncounted) {
            let n: [f64; 3] = triangles[face].normal().in_f64();
            let n = rays::unit(n);
            let s = if n[0] * line.1[0] + n[1] * line.1[1] + n[2] * line.1[2] > 0.0 { -1.0 } else { 1.0 };
            let p = [0, 1, 2].map(|a| line.0[a] + f64::from(t) * line.1[a]);
            points.push((p, n.map(|x| x * s)));
        }
    }
    let (low, high) = scenes::extent(&scene.corners);
    let size = (0..3).map(|a| high[a] - low[a]).fold(0.0, f64::max);
    let bounce = rays::bounces(&points, size);
    let random = rays::random((low, high), 1 << 20);
    for (kind, lines) in [("primary", primary), ("bounce", bounce), ("random", random)] {
        let rays32: Vec<Ray3<f32>> = rays::rounded(&lines);
        let matrix = |r: &Ray3<f32>| ours.closest(Method::Matrix, r, Span::ahead(), &mut Uncounted);
        let robust = |r: &Ray3<f32>| ours.closest(Method::Robust, r, Span::ahead(), &mut Uncounted);
        let any = |r: &Ray3<f32>| ours.any(Method::Matrix, r, Span::ahead(), &mut Uncounted);
        let n = rays32.len();
        let mut counts = Counts::default();
        for r in &rays32 {
            ours.closest(Method::Matrix, r, Span::ahead(), &mut counts);
        }
        let hits = rays32.iter().filter(|r| matrix(r).is_some()).count();
        let rhits = rays32.iter().filter(|r| robust(r).is_some()).count();
        let ahits = rays32.iter().filter(|r| any(r)).count();
        let phits: Vec<usize> =
            peers.iter().map(|(_, p)| rays32.iter().filter(|r| p.closest(r).is_some()).count()).collect();
        println!(
            "{kind} {n} rays: hits {hits} robust {rhits} any {ahits} peer {phits:?}; per ray boxes {:.1} tests {:.1} hits {:.2}",
            counts.boxes as f64 / n as f64,
            counts.tests as f64 / n as f64,
            counts.hits as f64 / n as f64
        );
        let mut runs: Vec<Box<dyn FnMut() -> usize + '_>> = Vec::new();
        runs.push(Box::new(|| rays32.iter().filter(|r| matrix(r).is_some()).count()));
        runs.push(Box::new(|| rays32.iter().filter(|r| any(r)).count()));
        runs.push(Box::new(|| rays32.iter().filter(|r| robust(r).is_some()).count()));
        for (_, p) in &peers {
            runs.push(Box::new(|| rays32.iter().filter(|r| p.closest(r).is_some()).count()));
        }
        let mut refs: Vec<&mut dyn FnMut() -> usize> =
            runs.iter_mut().map(|b| &mut **b as &mut dyn FnMut() -> usize).collect();
        let s: Vec<f64> = turns::medians(if scene.name == "bunny" { 5 } else { 3 }, &mut refs)
            .iter()
            .map(|s| s / n as f64 * 1e9)
            .collect();
        let best = s[3..].iter().copied().fold(f64::INFINITY, f64::min);
        println!(
            "  ns closest {:.1} any {:.1} ({:.2}x) robust {:.1} | peers {:.1?} => {:.2}x",
            s[0],
            s[1],
            s[0] / s[1],
            s[2],
            &s[3..],
            best / s[0]
        );
    }
}

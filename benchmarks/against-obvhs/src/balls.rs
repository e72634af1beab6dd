//! Going through all spheres against the trees.

use bounds::{Box3, Counts, Nearest, Tree, Uncounted, Wide};
use math::{Ray3, Real, Span};
use ray_sphere::Sphere;

use crate::rays;
use crate::scenes::{Balls, vector};
use crate::turns::medians;

const SIZE: usize = 512;
const ROUNDS: usize = 7;
/// Of so many rays one is tried on all spheres.
const ONE_OF: usize = 509;

pub(crate) fn report(balls: &Balls) {
    at::<f64>(balls);
    at::<f32>(balls);
}

fn at<R: Real>(balls: &Balls) {
    let sphere = |&(center, radius): &([f64; 3], f64)| Sphere::<R> {
        center: vector::<R>(center),
        radius: R::round_from(radius),
    };
    let spheres: Vec<Sphere<R>> = balls.spheres.iter().map(sphere).collect();
    let boxes: Vec<Box3> = spheres.iter().map(|s| Box3::around_sphere(s.center, s.radius)).collect();
    let rays: Vec<Ray3<R>> = rays::rounded(&rays::primary(&balls.camera, SIZE));
    let few: Vec<Ray3<R>> = rays.iter().copied().step_by(ONE_OF).collect();
    let (tree, wide) = (Tree::build(&boxes), Wide::build(&boxes));

    let (span, test) = (Span::ahead(), |index: usize, ray: &Ray3<R>, span: Span<R>| {
        ray_sphere::robust(ray, &spheres[index]).hit(span).ok()?.map(|hit| hit.t)
    });
    let all = |ray: &Ray3<R>| {
        let mut nearest = Nearest::new(span);
        for index in 0..spheres.len() {
            if let Some(t) = test(index, ray, span) {
                nearest.put(index, t);
            }
        }
        nearest.hit()
    };
    let by_tree = |ray: &Ray3<R>| tree.closest(ray, span, &mut Uncounted, |i, span| test(i, ray, span));
    let by_wide = |ray: &Ray3<R>| wide.closest(ray, span, &mut Uncounted, |i, span| test(i, ray, span));

    let others = few.iter().filter(|ray| all(ray) != by_tree(ray) || all(ray) != by_wide(ray)).count();
    let differ = rays.iter().filter(|ray| by_tree(ray) != by_wide(ray)).count();
    let hits = rays.iter().filter(|ray| by_tree(ray).is_some()).count();
    println!("balls, {} spheres, {} by {}², robust", spheres.len(), R::NAME, SIZE);
    println!(
        "  {hits} of {} rays hit; tree and wide differ on {differ}, from all spheres on {others} of {}",
        rays.len(),
        few.len()
    );
    let mut counts = [Counts::default(); 2];
    for ray in &rays {
        tree.closest(ray, span, &mut counts[0], |index, span| test(index, ray, span));
        wide.closest(ray, span, &mut counts[1], |index, span| test(index, ray, span));
    }
    for (name, counts) in ["tree", "wide"].into_iter().zip(counts) {
        let [boxes, tests] = [counts.boxes, counts.tests].map(|count| count as f64 / rays.len() as f64);
        println!("  {name}: {boxes:.1} boxes and {tests:.2} spheres a ray");
    }
    let seconds = medians(
        ROUNDS,
        &mut [
            &mut || few.iter().filter(|ray| all(ray).is_some()).count(),
            &mut || rays.iter().filter(|ray| by_tree(ray).is_some()).count(),
            &mut || rays.iter().filter(|ray| by_wide(ray).is_some()).count(),
        ],
    );
    let per_ray = |seconds: f64, rays: &[Ray3<R>]| 1e9 * seconds / rays.len() as f64;
    let [all, tree, wide] =
        [per_ray(seconds[0], &few), per_ray(seconds[1], &rays), per_ray(seconds[2], &rays)];
    println!("  ns a ray: all {all:.0} · tree {tree:.0} · wide {wide:.0}");
    println!(
        "  tree {:.0} times as fast (reach 40), wide {:.0} times (reach 60, aim 150)",
        all / tree,
        all / wide
    );
}

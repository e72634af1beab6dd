//! Triangles: ours against obvhs, closest hit and any hit, and what more digits cost.

use bounds::wide::WideMesh;
use bounds::{Counts, Uncounted};
use math::{Ray3, Real, Span, Vector};
use triangle::{Method, Triangle};

use crate::peer::{self, PRESETS, Peer};
use crate::rays::{self, Line};
use crate::scenes::{Triangles, extent, vector};
use crate::turns::medians;

const SIZE: usize = 1024;

/// A tree in one precision, and the triangles.
struct Ours<R: Real> {
    triangles: Vec<Triangle<R>>,
    tree: WideMesh<R>,
}

impl<R: Real> Ours<R> {
    fn new(scene: &Triangles) -> Ours<R> {
        let triangles = scene.rounded::<R>();
        Ours { tree: WideMesh::of_triangles(&triangles), triangles }
    }

    fn closest(&self, method: Method, ray: &Ray3<R>) -> Option<(usize, R)> {
        self.tree.closest(method, ray, Span::ahead(), &mut Uncounted)
    }

    fn hits(&self, method: Method, rays: &[Ray3<R>]) -> usize {
        rays.iter().filter(|ray| self.closest(method, ray).is_some()).count()
    }

    fn any(&self, rays: &[Ray3<R>]) -> usize {
        rays.iter().filter(|ray| self.tree.any(Method::Matrix, ray, Span::ahead(), &mut Uncounted)).count()
    }
}

pub(crate) fn report(scene: &Triangles, rounds: usize) {
    let (single, double) = (Ours::<f32>::new(scene), Ours::<f64>::new(scene));
    let theirs = peer::triangles(&scene.corners);
    let peers = PRESETS.map(|(name, preset)| (name, Peer::build(&theirs, preset())));
    println!("{}, {} triangles", scene.name, theirs.len());
    let primary = rays::primary(&scene.camera, SIZE);
    let bounces = rays::bounces(&hits(&single, &primary), size(scene));
    let random = rays::random(extent(&scene.corners), SIZE * SIZE);
    for (kind, lines) in [("primary", primary), ("bounce", bounces), ("random", random)] {
        compare(kind, &lines, &single, &double, &peers, rounds);
    }
}

fn compare(
    kind: &str,
    lines: &[Line],
    single: &Ours<f32>,
    double: &Ours<f64>,
    peers: &[(&str, Peer)],
    rounds: usize,
) {
    let (rays, wide_rays) = (rays::rounded::<f32>(lines), rays::rounded::<f64>(lines));
    // the preset that is fastest to trace
    let (fastest, peer) = fastest(peers, &rays);

    println!("  {kind}: {} rays", rays.len());
    let [matrix, robust] = [Method::Matrix, Method::Robust].map(|method| single.hits(method, &rays));
    let others = rays.iter().filter(|ray| {
        let (ours, theirs) = (single.closest(Method::Matrix, ray), peer.closest(ray));
        ours.is_some() != theirs.is_some()
    });
    println!("    hits: matrix {matrix} · robust {robust} · obvhs {} ({fastest})", peer.hits(&rays));
    for ray in others {
        let (ours, theirs) = (single.closest(Method::Robust, ray), peer.closest(ray));
        println!("    they differ on a ray that robust says {} face {ours:?}, obvhs {theirs:?}", is(ours));
    }
    let mut counts = Counts::default();
    for ray in &rays {
        single.tree.closest(Method::Matrix, ray, Span::ahead(), &mut counts);
    }
    let [boxes, tests] = [counts.boxes, counts.tests].map(|count| count as f64 / rays.len() as f64);
    println!("    {boxes:.1} boxes and {tests:.2} triangles a ray");

    let seconds = medians(
        rounds,
        &mut [
            &mut || single.hits(Method::Matrix, &rays),
            &mut || peer.hits(&rays),
            &mut || single.any(&rays),
            &mut || single.hits(Method::Robust, &rays),
            &mut || double.hits(Method::Matrix, &wide_rays),
            &mut || double.hits(Method::Robust, &wide_rays),
        ],
    );
    let ns: Vec<f64> = seconds.iter().map(|seconds| 1e9 * seconds / rays.len() as f64).collect();
    println!("    ns a ray: closest {:.0} · obvhs {:.0} · any {:.0}", ns[0], ns[1], ns[2]);
    println!(
        "    closest is {:.2} times as fast as obvhs, any {:.2} times as closest",
        ns[1] / ns[0],
        ns[0] / ns[2]
    );
    println!(
        "    robust costs {:.2} times that, f64 {:.2}, f64 and robust {:.2}",
        ns[3] / ns[0],
        ns[4] / ns[0],
        ns[5] / ns[0]
    );
}

fn is<T>(hit: Option<T>) -> &'static str {
    if hit.is_some() { "hits" } else { "misses" }
}

fn fastest<'a>(peers: &'a [(&'a str, Peer)], rays: &[Ray3<f32>]) -> (&'a str, &'a Peer) {
    let mut runs: Vec<_> = peers.iter().map(|(_, peer)| || peer.hits(rays)).collect();
    let mut runs: Vec<&mut dyn FnMut() -> usize> = runs.iter_mut().map(|run| run as _).collect();
    let seconds = medians(3, &mut runs);
    let place = (0..peers.len()).min_by(|&a, &b| seconds[a].total_cmp(&seconds[b])).unwrap_or(0);
    (peers[place].0, &peers[place].1)
}

/// Where rays hit, and the normal that faces the eye.
fn hits(ours: &Ours<f32>, lines: &[Line]) -> Vec<Line> {
    let mut hits = Vec::new();
    for (ray, &(o, d)) in rays::rounded::<f32>(lines).iter().zip(lines) {
        if let Some((face, t)) = ours.closest(Method::Matrix, ray) {
            let n = rays::unit(ours.triangles[face].normal().in_f64());
            let sign = -vector::<f64>(n).dot(vector::<f64>(d)).signum();
            let point = [0, 1, 2].map(|axis| o[axis] + f64::from(t) * d[axis]);
            hits.push((point, n.map(|component| sign * component)));
        }
    }
    hits
}

fn size(scene: &Triangles) -> f64 {
    let (low, high) = extent(&scene.corners);
    (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max)
}

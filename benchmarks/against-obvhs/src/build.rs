//! How long a tree over a million triangles takes.

use bounds::wide::WideMesh;
use obvhs::BvhBuildParams;

use crate::peer::{self, Peer};
use crate::scenes::Triangles;
use crate::turns::medians;

/// Ours against obvhs' medium preset.
pub(crate) fn report(scene: &Triangles, rounds: usize) {
    let (ours, theirs) = (scene.rounded::<f32>(), peer::triangles(&scene.corners));
    let seconds = medians(
        rounds,
        &mut [&mut || usize::from(WideMesh::of_triangles(&ours).is_empty()), &mut || {
            usize::from(Peer::build(&theirs, BvhBuildParams::medium_build()).is_empty())
        }],
    );
    println!("build, {} triangles of the {}, f32", ours.len(), scene.name);
    println!("  wide {:.3} s · obvhs medium_build {:.3} s", seconds[0], seconds[1]);
    println!("  ours takes {:.2} times as long (reach 1.2, aim 0.8)", seconds[0] / seconds[1]);
}

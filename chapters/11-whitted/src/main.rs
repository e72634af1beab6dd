//! The stage `whitted`: see the library.

use std::time::Instant;

fn main() {
    let mut args = std::env::args().skip(1);
    let path = args.next().unwrap();
    let size: u32 = args.next().unwrap().parse().unwrap();
    let threads: usize = args.next().unwrap().parse().unwrap();
    let file = scene_file::Scene::read(std::path::Path::new(&path)).unwrap();
    let depth = args.next().map(|d| d.parse().unwrap());
    let size = if size == 0 { file.camera.size.value } else { (size, size) };
    let start = Instant::now();
    let scene = whitted::from_file::scene::<f64>(&file, Some(size), depth).unwrap();
    let parts = bounds::Bounded::new(&scene.lit.geometry, bounds::Method::None).parts();
    let req = whitted::Requirements::of(&scene, parts);
    println!("{req:?} {parts}");
    let bounded = bounds::Bounded::new(&scene.lit.geometry, req.bounds());
    let tracer = whitted::Tracer::new(&scene, &bounded, &req, None);
    println!("built {:?}", start.elapsed());
    let start = Instant::now();
    let it = whitted::render::render(&tracer, size, 1, Some(threads), None).unwrap();
    let time = start.elapsed();
    println!("{:?} {time:?} {:.3} Mray/s", it.counts, it.counts.rays() as f64 / time.as_secs_f64() / 1e6);
    let mut canvas = stage::Canvas::new(size, stage::Color::BLACK).unwrap();
    canvas.shade(|c, r| stage::Color::from_linear(it.radiance[(r * size.0 + c) as usize].0));
    stage::write_picture(&canvas, std::path::Path::new("/tmp/w.png")).unwrap();
}

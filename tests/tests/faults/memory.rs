//! No command takes more memory than 64 MB, 100 bytes a byte of input and 64 bytes a pixel.
//!
//! What counts is the most that the command has in memory at a time, as the kernel counted it
//! (`peak-memory`). Bytes of input are those of the files that it reads, pixels those of the pictures that
//! it writes and reads.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use stage::Stage;
use tests::{Folder, Run, STAGES, command_in, header, plain_row, stage_named, with_cases};

/// A command whose memory is measured.
struct Measured<'a> {
    args: &'a [&'a str],
    /// The file among the folder's that is its standard input.
    stdin: Option<&'a str>,
    /// Bytes of input.
    bytes: u64,
    pixels: u64,
    /// The exit status that it should have.
    status: i32,
}

impl<'a> Measured<'a> {
    fn new(args: &'a [&'a str]) -> Measured<'a> {
        Measured { args, stdin: None, bytes: 0, pixels: 0, status: 0 }
    }

    fn pixels(self, pixels: u64) -> Measured<'a> {
        Measured { pixels, ..self }
    }

    /// A file of the folder is read.
    fn reads(self, folder: &Folder, name: &str) -> Measured<'a> {
        let length = fs::metadata(folder.path().join(name)).expect("a file of the test's own").len();
        Measured { bytes: self.bytes + length, ..self }
    }

    fn refused(self) -> Measured<'a> {
        Measured { status: 2, ..self }
    }

    /// Runs it in a folder.
    fn assert_within(self, folder: &Folder) {
        self.assert_within_with(folder, || 0);
    }

    /// The same with more pixels, which are known when it has run.
    fn assert_within_with(self, folder: &Folder, more: impl Fn() -> u64) {
        let (peak, run) = self.run(folder.path());
        assert_eq!(run.status, self.status, "{:?}: {}", self.args, run.errors);
        let allowed = 64_000_000 + 100 * self.bytes + 64 * (self.pixels + more());
        let [has, may] = [peak, allowed].map(|bytes| bytes as f64 / 1e6);
        let said = format!("{has:6.1} MB of {may:7.1} MB: {}", self.args.join(" "));
        println!("{said}");
        assert!(peak <= allowed, "too much: {said}");
    }

    /// The most bytes of memory that it had, and how it ended.
    fn run(&self, folder: &Path) -> (u64, Run) {
        let figure = folder.join("peak");
        let words = [figure.to_str().expect("a path in UTF-8"), env!("CARGO_BIN_EXE_any-stage")];
        let args = [&words[..], self.args].concat();
        let mut command = command_in(folder, env!("CARGO_BIN_EXE_peak-memory"), &args);
        // what is printed may be long, and is not looked at
        command.stdout(std::process::Stdio::null());
        if let Some(name) = self.stdin {
            command.stdin(fs::File::open(folder.join(name)).expect("a file of the test's own"));
        }
        let run = Run::to_end(command);
        let peak = fs::read_to_string(&figure).unwrap_or_else(|error| panic!("{error}: {run:?}"));
        (peak.parse().expect("a number of bytes"), run)
    }
}

/// How many pixels the picture has that a stage draws by itself.
fn own_pixels(picture: &Path) -> u64 {
    let (width, height) = image::image_dimensions(picture).expect("a picture");
    u64::from(width) * u64::from(height)
}

/// A picture of this size, in letters and in number.
fn size_of(size: &str) -> u64 {
    size.split('x').map(|number| number.parse::<u64>().expect("a size")).product()
}

/// What they do by themselves; scenes in their light, which take longest to draw, in `.ci/full` only.
#[test]
fn what_most_stages_do_by_themselves() {
    by_themselves(STAGES.iter().copied().filter(|stage| stage.about().number < 10));
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn what_every_stage_does_by_itself() {
    by_themselves(STAGES.iter().copied());
}

fn by_themselves(stages: impl Iterator<Item = &'static dyn Stage>) {
    for stage in stages {
        let (folder, name) = (Folder::new(), stage.about().name);
        let picture = folder.path().join("picture.png");
        let args = [name, "--out", "picture.png"];
        Measured::new(&args).assert_within_with(&folder, || own_pixels(&picture));
    }
}

fn large_pictures(size: &str) {
    for stage in STAGES {
        let (folder, name) = (Folder::new(), stage.about().name);
        for precision in ["f32", "f64"] {
            let args = [name, "--size", size, "--precision", precision, "--out", "picture.png"];
            Measured::new(&args).pixels(size_of(size)).assert_within(&folder);
        }
    }
}

#[test]
fn pictures_of_a_million_pixels() {
    let folder = Folder::new();
    for name in ["pinhole", "ray-sphere", "bounds"] {
        let args = [name, "--size", "1200x900", "--out", "picture.png"];
        Measured::new(&args).pixels(1200 * 900).assert_within(&folder);
    }
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn large_pictures_of_every_stage() {
    large_pictures("2000x1500");
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn pictures_that_are_wide_or_high() {
    for size in ["1x3000000", "3000000x1"] {
        for name in ["ray-sphere", "signature", "shading", "whitted"] {
            let args = [name, "--size", size, "--out", "picture.png"];
            Measured::new(&args).pixels(size_of(size)).assert_within(&Folder::new());
        }
    }
}

/// The tree of the pixel that is explained is kept, and its rays double with every level.
#[test]
fn a_tree_of_many_rays() {
    let args = ["whitted", "--size", "16x12", "--depth", "22", "--out", "picture.png"];
    Measured::new(&args).pixels(size_of("16x12")).assert_within(&Folder::new());
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn many_rays_a_pixel_and_many_threads() {
    let folder = Folder::new();
    let size = size_of("2000x1500");
    for name in ["shading", "whitted"] {
        let args = [name, "--size", "2000x1500", "--samples", "2", "--out", "picture.png"];
        Measured::new(&args).pixels(size).assert_within(&folder);
    }
    let args = ["whitted", "--size", "640x480", "--threads", "1024", "--depth", "12", "--out", "picture.png"];
    Measured::new(&args).pixels(size_of("640x480")).assert_within(&folder);
    let args = ["signature", "--size", "2000x1500", "--ids", "ids.png", "--out", "picture.png"];
    Measured::new(&args).pixels(size).assert_within(&folder);
    let args = ["whitted", "--explain", "--out", "picture.png"];
    Measured::new(&args).pixels(size_of("960x720")).assert_within(&folder);
    let args = ["whitted", "--precision", "auto", "--tolerance", "0.01", "--out", "picture.png"];
    Measured::new(&args).pixels(size_of("960x720")).assert_within(&folder);
}

fn pages(size: &str) {
    for name in ["ray-sphere", "signature", "whitted"] {
        let args = [name, "--size", size, "--out", "picture.png", "--inspect", "page.html"];
        // of the page's own picture as well
        Measured::new(&args).pixels(2 * size_of(size)).assert_within(&Folder::new());
    }
}

#[test]
fn pages_to_look_at_rays() {
    pages("24x18");
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn large_pages_to_look_at_rays() {
    pages("640x480");
}

/// Writes a case file of at least so many bytes.
fn many_cases(folder: &Folder, stage: &dyn Stage, bytes: usize) {
    let row = format!("{}\n", plain_row(stage));
    folder.put("cases.csv", format!("{}\n{}", header(stage), row.repeat(bytes.div_ceil(row.len()))));
}

#[test]
fn cases_are_answered_one_at_a_time() {
    for name in ["ray-plane", "affine"] {
        let folder = Folder::new();
        many_cases(&folder, stage_named(name).unwrap(), 2_000_000);
        // not a byte more for the input: rows are not kept
        Measured::new(&[name, "eval", "--cases", "cases.csv"]).assert_within(&folder);
    }
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn fifty_megabytes_of_cases() {
    for stage in with_cases() {
        let (folder, name) = (Folder::new(), stage.about().name);
        many_cases(&folder, stage, 50_000_000);
        Measured::new(&[name, "eval", "--cases", "cases.csv"]).assert_within(&folder);
    }
    let folder = Folder::new();
    many_cases(&folder, stage_named("ray-wall").unwrap(), 50_000_000);
    Measured { stdin: Some("cases.csv"), ..Measured::new(&["ray-wall", "eval"]) }.assert_within(&folder);
}

#[test]
fn a_line_that_does_not_end() {
    let folder = Folder::new();
    let args = ["ray-sphere", "eval", "--cases", "cases.csv"];
    for text in ["a,".repeat(1_000_000), "a".repeat(5_000_000), format!("\"{}", "a\n".repeat(2_000_000))] {
        folder.put("cases.csv", text);
        Measured::new(&args).reads(&folder, "cases.csv").refused().assert_within(&folder);
    }
}

fn trades(cases: &str, names: &[&str]) {
    for name in names {
        let folder = Folder::new();
        let args = [name, "trade", "--quick", "--cases", cases, "--out", "measured.png"];
        Measured::new(&args).assert_within(&folder);
    }
}

#[test]
fn a_small_measurement() {
    trades("20", &["pinhole", "ray-wall"]);
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn measurements_of_every_stage() {
    let names: Vec<&str> = STAGES.iter().map(|stage| stage.about().name).collect();
    trades("20", &names);
    trades("100000", &["ray-wall", "ray-sphere"]);
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn the_gallery() {
    // the pictures are drawn side by side
    let pixels = 4_000_000;
    Measured::new(&["workbench"]).pixels(pixels).assert_within(&Folder::new());
}

#[test]
fn a_hand_out_and_the_list_of_them() {
    let folder = Folder::new();
    Measured::new(&["workbench", "exercise", "list"]).assert_within(&folder);
    Measured::new(&["workbench", "exercise", "start", "ray-sphere/closest-approach"]).assert_within(&folder);
}

/// A camera that looks at the unit square from above.
const CAMERA: &str = "[camera]\neye = [0.5, 0.5, 3.0]\nlook_at = [0.5, 0.5, 0.0]\nsize = [160, 120]\n";

/// A scene with one mesh, and the stages that read it.
fn mesh(text: &str) {
    let folder = Folder::new();
    folder.put("mesh.obj", text);
    let object = "[[object]]\nmaterial = \"a\"\nmesh = { file = \"mesh.obj\" }\n";
    folder.put("scene.toml", format!("{CAMERA}[material.a]\n{object}"));
    for name in OF_SCENES {
        // few pixels: some of these stages try every face for each
        let args = [name, "--scene", "scene.toml", "--size", "8x6", "--out", "picture.png"];
        let measured = Measured::new(&args).pixels(8 * 6);
        measured.reads(&folder, "scene.toml").reads(&folder, "mesh.obj").assert_within(&folder);
    }
}

/// A square of `side` × `side` smaller ones, of two triangles each.
fn grid(side: usize) -> String {
    let mut text = String::new();
    for (row, col) in (0..=side).flat_map(|row| (0..=side).map(move |col| (row, col))) {
        let [x, y] = [col, row].map(|place| place as f64 / side as f64);
        writeln!(text, "v {x:.4} {y:.4} 0").unwrap();
    }
    for (row, col) in (0..side).flat_map(|row| (0..side).map(move |col| (row, col))) {
        let corner = row * (side + 1) + col + 1;
        let above = corner + side + 1;
        writeln!(text, "f {corner} {} {above}\nf {} {} {above}", corner + 1, corner + 1, above + 1).unwrap();
    }
    text
}

/// Two bytes a triangle: the shortest that a mesh can be written.
fn fan(triangles: usize) -> String {
    format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1{}\n", " 2 3".repeat(triangles / 2))
}

#[test]
fn a_mesh() {
    mesh(&grid(60));
    mesh(&fan(8000));
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn large_meshes() {
    mesh(&grid(300));
    mesh(&fan(600_000));
}

/// The stages that read scenes.
const OF_SCENES: [&str; 4] = ["signature", "bounds", "shading", "whitted"];

/// A scene in a file, for some of them.
fn scene(names: &[&str], file: &str, text: &str, status: i32) {
    let folder = Folder::new();
    folder.put(file, text);
    for name in names {
        // few pixels: some of these stages try every object for each
        let args = [name, "--scene", file, "--size", "8x6", "--out", "picture.png"];
        let measured = Measured { status, ..Measured::new(&args).pixels(8 * 6) };
        measured.reads(&folder, file).assert_within(&folder);
    }
}

fn spheres_in_nff(count: usize) -> String {
    let mut text =
        "v\nfrom 0.5 0.5 3\nat 0.5 0.5 0\nup 0 1 0\nangle 40\nhither 1\nresolution 160 120\n".to_string();
    text += "f 1 1 1 1 0 1 0 1\n";
    for number in 0..count {
        writeln!(text, "s 0.{number} 0.{} 0 .001", number * 7 % 1000).unwrap();
    }
    text
}

fn spheres_in_toml(count: usize) -> String {
    let mut text = format!("{CAMERA}[material.a]\n");
    for number in 0..count {
        let place = format!("0.{number}, 0.{}, 0", number * 7 % 1000);
        writeln!(text, "[[object]]\nmaterial = \"a\"\nsphere = {{ center = [{place}], radius = 1e-3 }}")
            .unwrap();
    }
    text
}

#[test]
fn a_scene() {
    scene(&OF_SCENES, "scene.nff", &spheres_in_nff(5000), 0);
    scene(&OF_SCENES, "scene.toml", &spheres_in_toml(2000), 0);
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn large_scenes() {
    scene(&OF_SCENES, "scene.nff", &spheres_in_nff(200_000), 0);
    scene(&OF_SCENES, "scene.toml", &spheres_in_toml(40_000), 0);
}

/// Texts that are no scene, and as many values as they can be. They are refused when all of them have been
/// read, by all stages alike.
#[test]
fn what_is_no_scene() {
    let refused = |text: &str| scene(&["signature"], "scene.toml", text, 2);
    for values in ["[],".repeat(300_000), "0,".repeat(500_000), "{},".repeat(300_000)] {
        refused(&format!("a = [{values}]\n"));
    }
    let numbered = |before: &str, after: &str| -> String {
        (0..100_000).map(|number| format!("{before}a{number:x}{after}\n")).collect()
    };
    refused(&numbered("", "=0"));
    refused(&numbered("[", "]"));
    refused(&"[[a]]\n".repeat(200_000));
    // as much text as is let through, and more
    for (table, times) in
        [("{a=0},", 40_000), ("{a=0},", 150_000), ("{a.a.a.a=0},", 75_000), ("[0],", 150_000)]
    {
        refused(&format!("a = [{}]\n", table.repeat(times)));
    }
}

/// A picture of few bytes and many pixels.
#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn a_texture() {
    let folder = Folder::new();
    image::GrayImage::new(4000, 3000).save(folder.path().join("texture.png")).unwrap();
    let material = "[material.a]\ntexture = { image = \"texture.png\" }\n";
    let object = "[[object]]\nmaterial = \"a\"\nplane = { point = [0, 0, 0], normal = [0, 0, 1] }\n";
    folder.put("scene.toml", format!("{CAMERA}{material}{object}"));
    for name in ["shading", "whitted"] {
        let args = [name, "--scene", "scene.toml", "--out", "picture.png"];
        let measured = Measured::new(&args).pixels(160 * 120 + 4000 * 3000);
        measured.reads(&folder, "scene.toml").reads(&folder, "texture.png").assert_within(&folder);
    }
}

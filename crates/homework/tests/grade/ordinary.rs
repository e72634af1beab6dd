//! A class as it is: right, wrong, half done, and some who would like to get more than they earned. In `cargo
//! test`.

use std::fs;

use homework::Catalog;

use crate::class::Class;

#[test]
fn a_class_is_graded() {
    let class = Class::new();
    class.right("right");
    class.with("mistaken", |solution| solution.replace("u_r.dot(c - p_r)", "u_r.dot(c)"));
    class.with("slip", |solution| solution.replace("let d = (", "let d = 2.0_f32.into_real() * ("));
    class.that("panics", "panic!(\"no idea\\u{1b}[31m\");");
    class.that("loops", "if sphere.radius == R::from(3.0) { loop { std::hint::spin_loop(); } }");

    // only src counts, and what is given is put there anew
    let forger = class.with("forger", |solution| solution.replace("self.t_close - a", "self.t_close"));
    fs::write(forger.join("Cargo.toml"), "[package]\nname = \"mine\"\nbuild = \"build.rs\"\n").unwrap();
    fs::write(forger.join("build.rs"), "fn main() { loop {} }").unwrap();
    fs::create_dir_all(forger.join(".cargo")).unwrap();
    fs::write(forger.join(".cargo/config.toml"), "[build]\nrustc-wrapper = \"/bin/false\"\n").unwrap();
    fs::write(forger.join("src/main.rs"), "fn main() { std::process::exit(0) }").unwrap();
    fs::write(forger.join("src/probe.rs"), "pub fn probe() {}").unwrap();
    fs::create_dir_all(forger.join("given/exercise/src")).unwrap();
    fs::write(forger.join("given/exercise/src/lib.rs"), "compile_error!(\"mine\");").unwrap();

    // what is no submission is a row
    fs::create_dir(class.path("empty")).unwrap();
    fs::write(class.path("file.zip"), "PK").unwrap();
    let other = class.right("of no exercise");
    fs::write(other.join("expected.txt"), "exercise\t../../etc/passwd\n").unwrap();
    let another = class.right("of another exercise");
    fs::rename(another.join("src/closest_approach.rs"), another.join("src/quadratic.rs")).unwrap();
    // a name that is longer in UTF-8 than a file may have it
    #[cfg(target_os = "linux")]
    {
        use std::os::unix::ffi::OsStrExt;
        let folder = class.right("long name").join("src").join(std::ffi::OsStr::from_bytes(&[0xff; 200]));
        fs::create_dir(&folder).unwrap();
        fs::write(folder.join("a.rs"), "").unwrap();
    }

    let Some(grades) = class.grades() else { return };
    grades.says("right", 9, "right", "All of it is right.");
    // by hand: where the ray starts at the origin, a miss and touching, it changes nothing
    grades.says("mistaken", 2, "wrong", "from-the-world-origin");
    assert_eq!(grades.of("mistaken")["first_wrong"]["symbol"], "t_close");
    grades.says("slip", 0, "does not compile", "src/closest_approach.rs:");
    grades.says("panics", 0, "wrong", "a panic at src/closest_approach.rs:");
    assert!(!grades.said("panics").contains('\x1b'));
    // what was answered before it came to the sphere that it cannot do counts: 1 + 2 + 1 + 1
    grades.says("loops", 5, "wrong", "computed for 5 seconds");
    grades.says("forger", 2, "wrong", "surface-for-center");
    // the case that ended it, and no symbol
    let first = &grades.of("loops")["first_wrong"];
    assert!(first["symbol"] == "" && first["given"].as_str().unwrap().ends_with("r = 3"), "{first:#}");
    grades.says("empty", 0, "refused", "no expected.txt");
    grades.says("file.zip", 0, "refused", "unpacked first");
    grades.says("of another exercise", 0, "refused", "src/closest_approach.rs is where the part");
    #[cfg(target_os = "linux")]
    grades.says("long name", 0, "refused", "cannot ");
    grades.says("of no exercise", 0, "refused", "there is no exercise");
}

/// The chapter's own code, handed in for every exercise at once, has all the points: no limit is too tight
/// for any.
#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn every_reference_has_all_the_points() {
    let catalog = Catalog::read().unwrap();
    let class = Class::new();
    for exercise in &catalog.exercises {
        let manifest = &exercise.manifest;
        let folder = class.path(&manifest.name.replace('/', " "));
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("expected.txt"), format!("exercise\t{}\n", manifest.name)).unwrap();
        for (path, text) in manifest.library(&catalog.source, &Default::default()).unwrap() {
            let path = folder.join("src").join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
    }
    let Some(grades) = class.grades() else { return };
    for exercise in &catalog.exercises {
        grades.says(
            &exercise.manifest.name.replace('/', " "),
            exercise.points(),
            "right",
            "All of it is right.",
        );
    }
}

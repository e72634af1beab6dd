//! Any text is a scene in TOML or an error that can be shown.
#![no_main]

use std::path::Path;

use libfuzzer_sys::fuzz_target;
use scene_file::Scene;

fuzz_target!(|text: &str| {
    match Scene::from_toml("fuzz.toml", text, Path::new("nowhere")) {
        Err(error) => assert!(error.status() == 2 && error.to_string().starts_with("fuzz.toml:")),
        Ok(scene) => {
            for object in &scene.objects {
                scene.fault(object.place, "a problem", "a remedy");
            }
        }
    }
});

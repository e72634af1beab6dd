//! Any text is a scene in NFF or an error that can be shown.
#![no_main]

use libfuzzer_sys::fuzz_target;
use scene_file::Scene;

fuzz_target!(|text: &str| {
    match Scene::from_nff("fuzz.nff", text) {
        Err(error) => assert!(error.status() == 2 && error.to_string().starts_with("fuzz.nff:")),
        Ok(scene) => {
            for object in &scene.objects {
                scene.fault(object.place, "a problem", "a remedy");
            }
        }
    }
});

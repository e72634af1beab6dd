//! Any text is a mesh in OBJ, whose faces have corners, or an error that can be shown.
#![no_main]

use libfuzzer_sys::fuzz_target;
use scene_file::Mesh;

fuzz_target!(|text: &str| {
    match Mesh::from_obj("fuzz.obj", text) {
        Err(error) => assert!(error.status() == 2 && error.to_string().starts_with("fuzz.obj:")),
        Ok(mesh) => {
            assert!(!mesh.faces.is_empty());
            assert!(mesh.faces.iter().flatten().all(|&place| (place as usize) < mesh.vertices.len()));
            assert!(mesh.normals.is_empty() || mesh.normals.len() == mesh.faces.len());
        }
    }
});

//! The files that a scene names: meshes and pictures.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::file::{Unread, bytes_of};
use crate::limits::{ASSET_BYTES, FACES, TEXELS};
use crate::picture::Picture;
use crate::source::{Source, Spot};
use crate::toml::one_line;
use crate::{Error, Mesh, obj};

/// Where the files are.
#[derive(Clone, Copy)]
pub(crate) enum Files<'a> {
    /// In a folder.
    In(&'a Path),
    /// Part of the program: their names and what is in them.
    BuiltIn(&'a [(&'a str, &'a [u8])]),
}

/// The files that were read for a scene, each once, and how much more may be.
pub(crate) struct Assets<'a> {
    files: Files<'a>,
    meshes: HashMap<PathBuf, Arc<Mesh>>,
    pictures: HashMap<PathBuf, Picture>,
    bytes_left: u64,
    faces_left: usize,
    texels_left: u64,
}

impl Files<'_> {
    fn path(self, name: &str) -> PathBuf {
        match self {
            Files::In(folder) => folder.join(name),
            Files::BuiltIn(_) => PathBuf::from(name),
        }
    }

    fn bytes(self, path: &Path, limit: u64) -> Result<Vec<u8>, Unread> {
        match self {
            Files::In(_) => bytes_of(path, limit),
            Files::BuiltIn(all) => match all.iter().find(|(name, _)| Path::new(name) == path) {
                Some((_, bytes)) => Ok(bytes.to_vec()),
                None => Err(Unread { wrong_file: true, problem: "it is not built in".to_string() }),
            },
        }
    }
}

impl<'a> Assets<'a> {
    /// None read yet.
    pub(crate) fn new(files: Files<'a>) -> Assets<'a> {
        Assets {
            files,
            meshes: HashMap::new(),
            pictures: HashMap::new(),
            bytes_left: ASSET_BYTES,
            faces_left: FACES,
            texels_left: TEXELS,
        }
    }

    /// The mesh of an OBJ file. `asked` is where the scene names the file.
    pub(crate) fn mesh(&mut self, name: &str, asked: Spot) -> Result<Arc<Mesh>, Error> {
        let path = self.files.path(name);
        if let Some(mesh) = self.meshes.get(&path) {
            return Ok(mesh.clone());
        }
        let bytes = self.bytes(&path, "an OBJ file", asked)?;
        let source = Source::from_bytes(path.display().to_string(), bytes, Some(asked))?;
        let mesh = obj::mesh(&source, self.faces_left, Some(asked))?;
        self.faces_left -= mesh.faces.len();
        let mesh = Arc::new(mesh);
        self.meshes.insert(path, mesh.clone());
        Ok(mesh)
    }

    /// The pixels of a PNG file. `asked` is where the scene names the file.
    pub(crate) fn picture(&mut self, name: &str, asked: Spot) -> Result<Picture, Error> {
        let path = self.files.path(name);
        if let Some(picture) = self.pictures.get(&path) {
            return Ok(picture.clone());
        }
        let bytes = self.bytes(&path, "a PNG file", asked)?;
        let picture = Picture::decode(&bytes, self.texels_left).map_err(|unusable| {
            let (problem, remedy) = unusable;
            asked.fault(&format!("cannot use {}: {problem}", named(&path)), &remedy)
        })?;
        self.texels_left -= picture.pixels.len() as u64;
        self.pictures.insert(path, picture.clone());
        Ok(picture)
    }

    fn bytes(&mut self, path: &Path, kind: &str, asked: Spot) -> Result<Vec<u8>, Error> {
        let bytes = self.files.bytes(path, self.bytes_left).map_err(|unread| {
            let remedy = format!("name {kind}, relative to the folder of the scene");
            match unread.wrong_file {
                true => asked.fault(&format!("cannot read {}: {}", named(path), unread.problem), &remedy),
                false => Error::failed(&path.display().to_string(), &unread.problem, "try again"),
            }
        })?;
        self.bytes_left -= bytes.len() as u64;
        Ok(bytes)
    }
}

/// The whole name of a file for an error, in one line.
fn named(path: &Path) -> String {
    format!("`{}`", one_line(&path.display().to_string()))
}

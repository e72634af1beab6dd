//! A scene from a file or a text.

use std::path::Path;

use crate::assets::{Assets, Files};
use crate::file::bytes_of;
use crate::limits::{FACES, NFF_BYTES, TOML_BYTES};
use crate::source::Source;
use crate::{Error, Mesh, Place, Scene, nff, obj, toml};

impl Scene {
    /// Reads a scene file: Haines's NFF if its name ends in `.nff`, else TOML, with the meshes and pictures that it
    /// names, relative to its folder.
    ///
    /// An [`Error`] with the place and the remedy where the file says what it should not, where there is none, or
    /// where it cannot be read.
    pub fn read(path: &Path) -> Result<Scene, Error> {
        let ends_in = |of: &str| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(of));
        let is_nff = ends_in("nff");
        let name = path.display().to_string();
        if ends_in("obj") {
            let remedy = "name a scene in TOML whose `[[object]]` says `mesh = { file = \"…\" }`";
            return Err(Error::unreadable(&name, "a mesh alone is no scene", remedy));
        }
        let bytes =
            bytes_of(path, if is_nff { NFF_BYTES } else { TOML_BYTES }).map_err(|unread| {
                match unread.wrong_file {
                    true => Error::unreadable(&name, &unread.problem, "name a scene file, TOML or NFF"),
                    false => Error::failed(&name, &unread.problem, "try again"),
                }
            })?;
        let source = Source::from_bytes(name, bytes, None)?;
        match is_nff {
            true => nff::scene(source),
            false => {
                let folder = path.parent().unwrap_or(Path::new(""));
                toml::scene(source, &mut Assets::new(Files::In(folder)))
            }
        }
    }

    /// Reads a scene that is part of the program, and so are the files that it names: of all these files,
    /// with what is in them, the one called `name`. It is NFF if that ends in `.nff`, in small letters; else
    /// TOML.
    ///
    /// Errors as those of [`Scene::read`].
    pub fn built_in(name: &str, files: &[(&str, &[u8])]) -> Result<Scene, Error> {
        let Some((_, bytes)) = files.iter().find(|(file, _)| *file == name) else {
            return Err(Error::unreadable(name, "it is not built in", "name a scene that is"));
        };
        let source = Source::from_bytes(name.to_string(), bytes.to_vec(), None)?;
        match name.ends_with(".nff") {
            true => nff::scene(source),
            false => toml::scene(source, &mut Assets::new(Files::BuiltIn(files))),
        }
    }

    /// Reads a scene in TOML that is a text: `name` is what errors call it, and the files that it names are in
    /// `folder`.
    ///
    /// Errors as those of [`Scene::read`].
    pub fn from_toml(name: &str, text: &str, folder: &Path) -> Result<Scene, Error> {
        toml::scene(Source::new(name, text), &mut Assets::new(Files::In(folder)))
    }

    /// Reads a scene in NFF that is a text: `name` is what errors call it.
    ///
    /// Errors as those of [`Scene::read`].
    pub fn from_nff(name: &str, text: &str) -> Result<Scene, Error> {
        nff::scene(Source::new(name, text))
    }

    /// The name of its file.
    pub fn name(&self) -> &str {
        &self.source.name
    }

    /// The text of its file, in which a [`Place`] counts.
    pub fn text(&self) -> &str {
        &self.source.text
    }

    /// An error, with exit status 2, for a value that cannot be used: what is wrong with it, in half a
    /// sentence, and what to write instead. `place` is one of this scene.
    pub fn fault(&self, place: Place, problem: &str, remedy: &str) -> Error {
        self.source.spot(place).fault(problem, remedy)
    }
}

impl Mesh {
    /// Reads a mesh in OBJ that is a text: `name` is what errors call it.
    ///
    /// An [`Error`] with the place and the remedy where the text is no OBJ with at least one face.
    pub fn from_obj(name: &str, text: &str) -> Result<Mesh, Error> {
        obj::mesh(&Source::new(name, text), FACES, None)
    }
}

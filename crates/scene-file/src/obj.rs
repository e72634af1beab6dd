//! Meshes in Wavefront OBJ: the statements `v`, `vt`, `vn` and `f`.
//!
//! Readers that are well kept were weighed, and none can give what the scenes need. tobj invents a normal for a corner
//! without one, numbers the vertices anew in every group, so that vertices are no longer shared, and knows no lines;
//! obj-rs and obj read coordinates as f32; wavefront_obj refuses indices from the end. What is needed of the format is
//! little, and read here.

mod corner;
mod line;

use crate::source::{Source, Spot};
use crate::toml::shown;
use crate::{Error, Mesh};
use corner::{Corner, Counts};
use line::{Line, lines};

/// Statements of OBJ that say nothing about where a face is.
#[rustfmt::skip]
const OTHERS: &[&str] = &[
    "o", "g", "s", "mg", "usemtl", "mtllib", "usemap", "maplib", "l", "p", "vp",
    "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end", "con",
    "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "ctech", "stech", "call", "csh",
];

/// Reads a mesh of at most so many faces. `asked` is where a scene names the file.
pub(crate) fn mesh(source: &Source, most_faces: usize, asked: Option<Spot>) -> Result<Mesh, Error> {
    // First what corners refer to, which may stand after the face, then the faces.
    let (mut vertices, mut normals, mut all) = (Vec::new(), Vec::new(), Counts::default());
    for mut line in lines(source, asked) {
        match line.keyword.text {
            "v" => vertices.push(line.point()?),
            "vn" => normals.push(line.point()?),
            "vt" | "f" => {}
            other if OTHERS.contains(&other) => {}
            other => {
                let problem = format!("{} is no statement of OBJ", shown(other));
                let remedy = "write `v`, `vn`, `vt` or `f`, or `#` before a comment";
                return Err(line.fault(line.keyword.spot, &problem, remedy));
            }
        }
        all.count(line.keyword.text);
    }
    let mesh = Mesh { vertices, faces: Vec::new(), normals: Vec::new() };
    let mut reading = Reading { mesh, normals, all, so_far: Counts::default(), most_faces };
    for mut line in lines(source, asked) {
        reading.so_far.count(line.keyword.text);
        if line.keyword.text == "f" {
            reading.face(&mut line)?;
        }
    }
    if reading.mesh.faces.is_empty() {
        let remedy = "write a face such as `f 1 2 3`, or name another file";
        return Err(source.spot(0..0).asked_fault("this mesh has no faces", remedy, asked));
    }
    Ok(reading.mesh)
}

/// A mesh whose faces are being read.
struct Reading {
    mesh: Mesh,
    /// The normals of the file, to which corners refer.
    normals: Vec<[f64; 3]>,
    all: Counts,
    so_far: Counts,
    most_faces: usize,
}

impl Reading {
    /// Reads a face, as a fan about its first corner if it has more than three.
    fn face(&mut self, line: &mut Line) -> Result<(), Error> {
        let [first, mut before, mut last] = [self.corner(line)?, self.corner(line)?, self.corner(line)?];
        if last.is_none() {
            return Err(line.fault(
                line.place(),
                "a face must have 3 corners or more",
                "write for example `f 1 2 3`",
            ));
        }
        while let (Some(a), Some(b), Some(c)) = (first, before, last) {
            self.triangle([a, b, c], line)?;
            (before, last) = (last, self.corner(line)?);
        }
        Ok(())
    }

    fn corner(&self, line: &mut Line) -> Result<Option<Corner>, Error> {
        Corner::next(line, &self.all, &self.so_far)
    }

    fn triangle(&mut self, corners: [Corner; 3], line: &Line) -> Result<(), Error> {
        let Mesh { faces, normals, .. } = &mut self.mesh;
        if faces.len() == self.most_faces {
            let problem =
                "too many faces: the meshes of a scene have 2^23 in all, fans counted triangle by triangle";
            return Err(line.fault(line.keyword.spot, problem, "make the mesh coarser"));
        }
        let at_corners = corners.map(|corner| corner.normal.map(|place| self.normals[place as usize]));
        if !normals.is_empty() || at_corners.iter().any(Option::is_some) {
            // The faces before the first one with a normal have none.
            normals.resize(faces.len(), [None; 3]);
            normals.push(at_corners);
        }
        faces.push(corners.map(|corner| corner.vertex));
        Ok(())
    }
}

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
    // What corners refer to, wherever it stands.
    let (mut vertices, mut normals, mut all) = (Vec::new(), Vec::new(), Counts::default());
    for mut line in lines(source, asked) {
        match line.keyword.text {
            "v" => vertices.push(line.point()?),
            "vn" => normals.push(line.point()?),
            "vt" | "f" => {}
            other if OTHERS.contains(&other) => {}
            other => {
                let problem = format!("{} is no statement of OBJ", shown(other));
                return Err(line.fault(
                    line.keyword.spot,
                    &problem,
                    "write `v`, `vn`, `vt` or `f`, or `#` before a comment",
                ));
            }
        }
        all.count(line.keyword.text);
    }

    let mut mesh = Mesh { vertices, faces: Vec::new(), normals: Vec::new() };
    let mut so_far = Counts::default();
    for mut line in lines(source, asked) {
        so_far.count(line.keyword.text);
        if line.keyword.text == "f" {
            mesh.add_face(&mut line, &all, &so_far, &normals)?;
        }
        if mesh.faces.len() > most_faces {
            let problem = format!("more than {most_faces} faces are too many");
            return Err(line.fault(line.keyword.spot, &problem, "make the mesh coarser"));
        }
    }
    if mesh.faces.is_empty() {
        let remedy = "write a face such as `f 1 2 3`, or name another file";
        return Err(source.spot(0..0).asked_fault("this mesh has no faces", remedy, asked));
    }
    Ok(mesh)
}

impl Mesh {
    /// Adds a face, as a fan about its first corner if it has more than three.
    fn add_face(
        &mut self,
        line: &mut Line,
        all: &Counts,
        so_far: &Counts,
        normals: &[[f64; 3]],
    ) -> Result<(), Error> {
        let corner = |line: &mut Line| Corner::next(line, all, so_far);
        let too_few = |line: &Line| {
            line.fault(line.place(), "a face must have 3 corners or more", "write for example `f 1 2 3`")
        };
        let first = corner(line)?.ok_or_else(|| too_few(line))?;
        let mut before = corner(line)?.ok_or_else(|| too_few(line))?;
        let mut next = Some(corner(line)?.ok_or_else(|| too_few(line))?);
        while let Some(last) = next {
            let corners = [first, before, last];
            self.faces.push(corners.map(|corner| corner.vertex));
            let at_corners = corners.map(|corner| corner.normal.map(|place| normals[place as usize]));
            if !self.normals.is_empty() || at_corners.iter().any(Option::is_some) {
                // The faces before the first one with a normal have none.
                self.normals.resize(self.faces.len() - 1, [None; 3]);
                self.normals.push(at_corners);
            }
            before = last;
            next = corner(line)?;
        }
        Ok(())
    }
}

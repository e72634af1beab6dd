//! Every pixel's rays for the inspector: the tree of a pixel in tables, and the same rays from above.

use math::Real;
use shading::Rgb;
use signature::Method;
use signature::stage::fault;
use stage::{Ask, Chapter, Color, Error, Inspect, Inspector, Look, Transcript};

use bounds::Parts;

use crate::picture::{Above, Plan};
use crate::show::{self, Names, Shot};
use crate::stage::{Whitted, read, worked};
use crate::{Counts, Path, Requirements, Scene, Tolerance, Tracer, Tree, from_file, render};

/// The picture of a scene, pixel by pixel.
struct Rays<'a, R: Real> {
    ask: &'a Ask,
    first: (u32, u32),
    scene: &'a Scene<R>,
    parts: &'a Parts<'a, R>,
    names: &'a Names,
    tracer: &'a Tracer<'a, R>,
    plan: Plan,
}

/// Hands the rays to `write`.
///
/// [`Error::Request`] where the scene cannot be read or the pixel lies outside the picture; the error of
/// `write`.
pub(crate) fn inspect<R: Real>(ask: &Ask, write: Inspector<'_>) -> Result<(), Error> {
    let (method, file) = (Method::ALL[ask.method], read(ask.scene.as_deref())?);
    let own = ask.scene.is_none();
    let (size, first) = ask.to_inspect(file.camera.size.value, |size| worked(own, size))?;
    let scene = &from_file::scene::<R>(&file, Some(size), ask.depth).map_err(fault)?;
    let requirements = Requirements::of(scene, Parts::of(&scene.lit.geometry).count());
    let bounded = requirements.bounded(method, &scene.lit.geometry);
    let tolerance = ask.tolerance.map(|e| Tolerance::new(scene, e));
    let tracer = &Tracer::new(scene, &bounded, &requirements, tolerance);
    let (names, parts) = (&Names::new(&file, scene), bounded.all_parts());
    let plan = Plan::new(scene, parts);
    write(&Rays { ask, first, scene, parts, names, tracer, plan })
}

impl<R: Real> Rays<'_, R> {
    /// The mean of all rays through the pixel, and the tree of the one in the middle.
    fn traced(&self, pixel: (u32, u32), samples: u32) -> Result<(Rgb, Tree<R>), Error> {
        let tree = render::tree(self.tracer, pixel, samples)?;
        let mean = render::with_stack(render::stack(self.tracer), || {
            self.tracer.pixel(pixel, samples, &mut Path::default(), &mut Counts::default())
        })?;
        Ok((mean, tree))
    }
}

impl<R: Real> Inspect for Rays<'_, R> {
    fn size(&self) -> (u32, u32) {
        self.scene.lit.geometry.size
    }

    fn first(&self) -> (u32, u32) {
        self.first
    }

    fn ground(&self) -> String {
        Above { scene: self.scene, parts: self.parts, names: self.names, plan: &self.plan }.ground()
    }

    fn caption(&self) -> &'static str {
        "The pixel's rays from above, along the camera's up axis: the eye is at the left and looks to the \
         right. The numbers are those of the table; the less a ray weighs, the thinner it is. A ray to a light \
         ends in a dot where something stands in its way."
    }

    fn look(&self, pixel: (u32, u32)) -> Result<Look, Error> {
        let Rays { ask, scene, parts, names, .. } = *self;
        let samples = ask.samples.unwrap_or(1);
        let (mean, tree) = self.traced(pixel, samples)?;
        let shot = Shot { scene, parts, names, pixel, samples, srgb: ask.srgb, tree: &tree };
        let mut transcript = Transcript::new(&Whitted.about(), ask);
        show::pixel(&mut transcript, Method::ALL[ask.method], &shot, mean);
        show::tables(&mut transcript, &shot);
        show::eye_ray(&mut transcript, &shot);
        let color = if ask.srgb { Color::from_linear_srgb(mean.0) } else { Color::from_linear(mean.0) };
        let above = Above { scene, parts, names, plan: &self.plan };
        Ok(Look { color, sections: transcript.sections, drawing: above.rays(&tree) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the page has of a pixel is what `show --pixel` says of it.
    #[test]
    fn a_look_is_what_show_says_of_the_pixel() {
        for (pixel, samples, depth) in
            [((7, 4), None, None), ((0, 0), Some(2), None), ((12, 8), None, Some(2))]
        {
            let (size, pixel) = (Some((16, 12)), Some(pixel));
            let ask = Ask { size, pixel, samples, depth, ..Ask::default() };
            let shown = Whitted.show::<f64>(&ask).unwrap();
            let mut looked = None;
            let mut look = |rays: &dyn Inspect| {
                looked = Some((rays.look(rays.first())?, rays.ground()));
                Ok(())
            };
            Whitted.inspect::<f64>(&ask, &mut look).unwrap();
            let (look, ground) = looked.unwrap();
            let shown = &shown.transcript.sections;
            assert_eq!(look.sections[..2], shown[..2]);
            assert_eq!(look.sections.len(), 4);
            // a remark about all the rays may stand below the last one
            let steps =
                |sections: &[stage::Section]| sections.iter().map(|it| it.steps.clone()).collect::<Vec<_>>();
            assert_eq!(steps(&look.sections), steps(&shown[..4]));
            assert!(look.drawing.contains("class=\"ray\"") && ground.contains("<circle class=\"object\""));
        }
    }
}

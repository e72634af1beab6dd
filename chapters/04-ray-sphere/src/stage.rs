//! How this chapter shows and evaluates itself.

use math::{Ray3, Real, Span};
use stage::{About, Ask, Case, Chapter, Error, Flag, Inspector, Row, Shown, TradeAsk, Traded, Transcript};

use crate::measure::question;
use crate::regimes::regimes;
use crate::scene::{Painted, camera, pixel_ray, tangents, three_spheres, trace_ray};
use crate::{Method, explain, inspect, map, picture, reject};

/// The stage `ray-sphere`.
pub struct RaySphere;

/// The chapter's stage. Here all of it is compiled for both precisions, and whoever runs it need not do so again.
pub static STAGE: &dyn stage::Stage = &RaySphere;

impl Chapter for RaySphere {
    fn about(&self) -> About {
        About {
            number: 4,
            name: "ray-sphere",
            teaches: "a ray against a sphere, by rival roads to the same two numbers",
            notes: "House 4.4; Gambetta \"Ray Meets Sphere\", Listings 2-2 to 2-5; CSC418 11.3.3",
            methods: Method::ALL.map(Method::name).to_vec(),
            size: (540, 540),
            picture: "Gambetta's three spheres on his lattice, one ray a pixel, seen from above and from \
                      the right in the corners; the rays that touch a sphere exactly are ringed.",
            flags: &[Flag::Inspect],
            inputs: &["ox", "oy", "oz", "dx", "dy", "dz", "cx", "cy", "cz", "r"],
            words: &[],
            results: &["hit", "t", "t_out", "x", "y", "z", "nx", "ny", "nz", "reason"],
            trade: "Draws, beside the trade plot, House's claim that rejecting first is faster (reject.svg) and \
                    where each method dies (map.png).",
            regimes: regimes().iter().map(|regime| (regime.name, regime.what)).collect(),
        }
    }

    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
        let size = ask.size_or(self.about().size)?;
        let method = Method::ALL[ask.method];
        let camera = camera::<R>(size)?;
        let spheres = three_spheres::<R>();

        // The worked example looks at the center of the red sphere: V = (0, −1/3, 1), a third of the
        // viewport below the middle.
        let third = R::from(-1.0) / R::from(3.0);
        let ray = match ask.pixel {
            Some(pixel) => pixel_ray(&camera, size, pixel),
            None => camera.ray((R::from(0.0), third)),
        };
        let index = subject(method, &ray, &spheres);
        let tangents = tangents(size);
        let mut transcript = Transcript::new(&self.about(), ask);
        explain::explain(&mut transcript, method, &ray, &spheres[index]);
        explain::trace_ray(&mut transcript, method, &ray, &spheres);
        explain::both_roots(&mut transcript, &ray, &spheres[index]);
        explain::ranges(&mut transcript, &ray);
        explain::tangents(&mut transcript, &camera, size, &tangents);

        let picture = picture::draw(method, size, &camera, &ray, &tangents)?;
        Ok(Shown { transcript, picture, ids: None })
    }

    fn inspect<R: Real>(&self, ask: &Ask, write: Inspector<'_>) -> Result<(), Error> {
        inspect::inspect::<R>(ask, self.about().size, write)
    }

    fn eval<R: Real>(&self, ask: &Ask, case: &Case<'_>) -> Result<Row, Error> {
        let (ray, sphere) = question(case.numbers::<R, 10>()?);
        let work = Method::ALL[ask.method].work(&ray, &sphere);
        Ok(match (work.hit(Span::ahead()), work.roots()) {
            (Ok(Some(hit)), Some(roots)) => Row::hit()
                .number("t", hit.t)
                .number("t_out", roots.far + R::from(0.0)) // minus zero is zero
                .vector(["x", "y", "z"], hit.point)
                .vector(["nx", "ny", "nz"], hit.normal),
            (Ok(_), _) => Row::miss(""),
            (Err(degenerate), _) => Row::invalid(degenerate.reason()),
        })
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        let mut traded = lab::measure(self, ask)?.traded("Ray against sphere: speed for accuracy");
        // Where a part is asked for, these would be drawn over those of the whole.
        if ask.is_for_all() {
            traded.drawings.push(reject::draw(ask));
            traded.drawings.push(map::draw(ask)?);
        }
        Ok(traded)
    }
}

/// The sphere a ray is explained against: the one it meets first, else the one it passes closest to.
pub(crate) fn subject<R: Real>(method: Method, ray: &Ray3<R>, spheres: &[Painted<R>]) -> usize {
    if let Some((index, _)) = trace_ray(method, ray, spheres, Span::from_view_plane()) {
        return index;
    }
    let distance = |painted: &Painted<R>| crate::closest_approach(ray, &painted.sphere).d;
    let mut nearest = 0;
    for (index, painted) in spheres.iter().enumerate() {
        if distance(painted) < distance(&spheres[nearest]) {
            nearest = index;
        }
    }
    nearest
}

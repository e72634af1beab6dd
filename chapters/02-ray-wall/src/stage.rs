//! How this chapter shows and evaluates itself.

use math::{Ray2, Real, Span, Vector};
use stage::{About, Ask, Case, Chapter, Error, Row, Section, Shown, TradeAsk, Traded, Transcript, Value};

use crate::measure::question;
use crate::picture::{self, wall_of};
use crate::regimes::regimes;
use crate::{Crossing, Method, Notes, Robust, Wall, Working};

/// House's wall.
pub(crate) const WALL: Wall<f64> = Wall { front: 4.0, back: 4.5 };

/// Where the page's ray starts. The copy of the notes has lost its numbers; this origin and the
/// direction (1, 0) give t = 3 and the hit (4, 1) that the page names.
pub(crate) const ORIGIN: (f64, f64) = (1.0, 1.0);

/// The stage `ray-wall`.
pub struct RayWall;

/// The chapter's stage. Here all of it is compiled for both precisions, and whoever runs it need not do so again.
pub static STAGE: &dyn stage::Stage = &RayWall;

impl Chapter for RayWall {
    fn about(&self) -> About {
        About {
            number: 2,
            name: "ray-wall",
            teaches: "a ray in the plane against a wall: one division, and what it leaves open",
            notes: "House 4.2",
            methods: Method::ALL.map(Method::name).to_vec(),
            size: (720, 480),
            picture: "A fan of rays against House's wall, each hit marked; the ray of a pixel leads from \
                      p_r to the point of the plane under it.",
            flags: &[],
            inputs: &["ox", "oy", "dx", "dy", "front", "back"],
            words: &[],
            results: &["hit", "t", "t_out", "x", "y", "reason"],
            trade: "House's division against the one that is rounded once, in regimes from ordinary numbers to \
                    their ends: nanoseconds a ray, wrong verdicts, and how far t and the point are off. Draws the \
                    two against each other, a panel a regime (trade.svg).",
            regimes: regimes().iter().map(|regime| (regime.name, regime.what)).collect(),
        }
    }

    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
        let size = ask.size_or(self.about().size)?;
        let method = Method::ALL[ask.method];
        let canvas = picture::canvas(size)?;
        let point = |(x, y)| R::vec2(R::round_from(x), R::round_from(y));
        let origin = point(ORIGIN);
        let direction = match ask.pixel {
            Some(pixel) => point(picture::view().plane(canvas.place_of(pixel))) - origin,
            None => point((1.0, 0.0)),
        };
        let ray = Ray2::<R>::new(origin, direction);

        let mut transcript = Transcript::new(&self.about(), ask);
        explain(&mut transcript, method, &ray, &wall_of());
        every_case::<R>(&mut transcript, method);
        Ok(Shown { transcript, picture: picture::draw(canvas, method, &ray), ids: None })
    }

    fn eval<R: Real>(&self, ask: &Ask, case: &Case<'_>) -> Result<Row, Error> {
        let (ray, wall) = question(case.numbers::<R, 6>()?);
        let work = Method::ALL[ask.method].work(&ray, &wall);
        Ok(match (work.hit(Span::ahead()), work.crossing()) {
            (Ok(Some(hit)), Crossing::Through(roots)) => Row::hit()
                .number("t", hit.t)
                .number("t_out", roots.far + R::from(0.0)) // minus zero is zero
                .vector(["x", "y"], hit.point),
            (Ok(_), Crossing::Along(how)) => Row::miss(how.reason()),
            (Ok(_), _) => Row::miss(""),
            (Err(degenerate), _) => Row::invalid(degenerate.reason()),
        })
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        Ok(lab::measure(self, ask)?.traded("Ray against wall: speed for accuracy"))
    }
}

/// The method's own steps, from its own struct.
pub(crate) fn explain<R: Real>(transcript: &mut Transcript, method: Method, ray: &Ray2<R>, wall: &Wall<R>) {
    let [from, along] = [ray.origin, ray.direction].map(|v| Value::vector::<R>(v).to_text());
    let title = format!("ray-wall · {} · {} · {from} + t {along}", method.name(), R::NAME);
    let work = method.work(ray, wall);
    let source = if method == Method::Notes { "House 4.2" } else { "House 4.2, robust.rs" };
    let section = transcript.section(title, source);
    section
        .vector::<R>("p_r", "origin", ray.origin)
        .vector::<R>("u_r", "direction", ray.direction)
        .note("as given: House's has length 1; t counts its lengths")
        .number("front", "the near face of the wall, x = front", wall.front)
        .number("back", "the far face, x = back", wall.back);
    match &work {
        Working::Notes(work) => notes_steps(section, work),
        Working::Robust(work) => robust_steps(section, work),
    }
    outcome(section, &work);
}

fn notes_steps<R: Real>(section: &mut Section, work: &Notes<R>) {
    section.number("t_front", "(front − p_x) / u_x", work.t_front).number(
        "t_back",
        "(back − p_x) / u_x",
        work.t_back,
    );
}

fn robust_steps<R: Real>(section: &mut Section, work: &Robust<R>) {
    section
        .number("front − p_x", "the difference, in f64", work.to_faces[0])
        .number("back − p_x", "the difference, in f64", work.to_faces[1])
        .step("t_front", "(front − p_x) / u_x", Value::maybe(work.t_front()))
        .step("t_back", "(back − p_x) / u_x", Value::maybe(work.t_back()));
}

/// What the two parameters mean, and the hit.
fn outcome<R: Real>(section: &mut Section, work: &Working<R>) {
    let hit = match work.hit(Span::ahead()) {
        Err(degenerate) => {
            section.step("hit", "the smallest t ≥ 0", Value::text("invalid")).note(degenerate.to_string());
            return;
        }
        Ok(hit) => hit,
    };
    if let Crossing::Through(roots) = work.crossing() {
        let [near, far] = [roots.near, roots.far].map(|t| Value::number(t).to_text());
        section.note(format!("the line is inside the wall for {near} ≤ t ≤ {far}"));
    }
    match hit {
        Some(hit) => {
            let face = if hit.normal.x() < R::from(0.0) { "the front face" } else { "the back face" };
            section.number("t", "the smallest t ≥ 0", hit.t).note(face).vector::<R>(
                "x",
                "p_r + t u_r",
                hit.point,
            );
        }
        None => {
            section.step("t", "the smallest t ≥ 0", Value::text("none")).note(why(work));
        }
    }
}

pub(crate) fn why<R: Real>(work: &Working<R>) -> &'static str {
    match work.crossing() {
        Crossing::Through(_) => "the wall is behind",
        Crossing::Along(math::Parallel::Apart) => "u_x = 0: parallel to the faces, meets neither",
        Crossing::Along(math::Parallel::Within) => {
            "u_x = 0 and p_x on a face: runs along it, meets it everywhere"
        }
    }
}

/// What the page leaves open: a table of rays, one a case.
fn every_case<R: Real>(transcript: &mut Transcript, method: Method) {
    let cases = [
        ("the page's", (1.0, 1.0), (1.0, 0.0)),
        ("slanted", (1.0, 1.0), (1.0, 0.5)),
        ("twice as long a direction", (1.0, 1.0), (2.0, 0.0)),
        ("pointing away", (1.0, 1.0), (-1.0, 0.0)),
        ("starting on the front face", (4.0, 1.0), (1.0, 0.0)),
        ("starting inside", (4.25, 1.0), (1.0, 0.0)),
        ("starting inside, turned round", (4.25, 1.0), (-1.0, 0.0)),
        ("from behind", (6.0, 1.0), (-1.0, 0.0)),
        ("parallel", (1.0, 1.0), (0.0, 1.0)),
        ("parallel, inside", (4.25, 1.0), (0.0, 1.0)),
        ("within the front face", (4.0, 1.0), (0.0, 1.0)),
    ];
    let rows = cases.map(|(name, (p_x, p_y), (u_x, u_y))| {
        let number = R::round_from;
        let ray = Ray2::<R>::new(R::vec2(number(p_x), number(p_y)), R::vec2(number(u_x), number(u_y)));
        let work = method.work(&ray, &wall_of());
        let (near, far) = match work.crossing() {
            Crossing::Through(roots) => (Value::number(roots.near), Value::number(roots.far)),
            Crossing::Along(how) => (Value::text(how.reason()), Value::text("")),
        };
        let hit = work.hit(Span::ahead()).ok().flatten();
        let point = hit.map_or(Value::text("no hit"), |hit| Value::vector::<R>(hit.point));
        let t = Value::maybe(hit.map(|hit| hit.t));
        vec![
            Value::text(name),
            Value::vector::<R>(ray.origin),
            Value::vector::<R>(ray.direction),
            near,
            far,
            t,
            point,
        ]
    });
    let columns = ["a ray", "p_r", "u_r", "enters at", "leaves at", "t", "x"];
    transcript
        .section("What the page leaves open", "House 4.2")
        .table(&columns, rows.to_vec())
        .remark("The hit is the smallest t ≥ 0: from inside, where the ray leaves. Touching counts.")
        .remark(
            "With u_x = 0 the page's division is by zero: x never changes, and no t, or every t, solves it.",
        );
}

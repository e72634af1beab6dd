//! How this chapter shows and evaluates itself.

use math::{Parallel, Ray3, Real, Span};
use stage::{About, Ask, Case, Chapter, Error, Row, Section, Shown, TradeAsk, Traded, Transcript, Value};

use crate::ground::{camera, ground, pixel_ray};
use crate::measure::question;
use crate::regimes::regimes;
use crate::{Meeting, Method, Notes, Plane, Robust, Working, map, picture, signed_distance};

/// The stage `ray-plane`.
pub struct RayPlane;

/// The chapter's stage. Here all of it is compiled for both precisions, and whoever runs it need not do so again.
pub static STAGE: &dyn stage::Stage = &RayPlane;

impl Chapter for RayPlane {
    fn about(&self) -> About {
        About {
            number: 3,
            name: "ray-plane",
            teaches: "a ray against a plane: signed distance, Equation 4.2, and what parallel means",
            notes: "House 4.3",
            methods: Method::ALL.map(Method::name).to_vec(),
            size: (640, 402),
            picture: "A checkered ground plane to the horizon, one ray a pixel. On the horizon n · u_r = 0; \
                      just below it t grows without bound, and one ray a pixel no longer tells the tiles apart.",
            flags: &[],
            inputs: &["ox", "oy", "oz", "dx", "dy", "dz", "px", "py", "pz", "nx", "ny", "nz"],
            words: &[],
            results: &["hit", "t", "x", "y", "z", "distance", "reason"],
            trade: "Equation 4.2 as printed against the one whose dot products are certain, in regimes from ordinary \
                    numbers to their ends: nanoseconds a ray, wrong verdicts, and how far t and the point are off. \
                    Draws the two against each other, a panel a regime (trade.svg), and where each loses its digits \
                    (map.png).",
            regimes: regimes().iter().map(|regime| (regime.name, regime.what)).collect(),
        }
    }

    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
        let size = ask.size_or(self.about().size)?;
        let method = Method::ALL[ask.method];
        let camera = camera::<R>(size)?;
        // The worked example looks an eighth to the right and a quarter down.
        let ray = match ask.pixel {
            Some(pixel) => pixel_ray(&camera, size, pixel),
            None => camera.ray((R::from(0.125), R::from(-0.25))),
        };
        let mut transcript = Transcript::new(&self.about(), ask);
        explain(&mut transcript, method, &ray, &ground());
        three_signs::<R>(&mut transcript);
        three_questions::<R>(&mut transcript, method);
        to_the_horizon::<R>(&mut transcript, method);
        Ok(Shown { transcript, picture: picture::draw(method, size, &ray)?, ids: None })
    }

    fn eval<R: Real>(&self, ask: &Ask, case: &Case<'_>) -> Result<Row, Error> {
        let (ray, plane) = question(case.numbers::<R, 12>()?);
        let work = Method::ALL[ask.method].work(&ray, &plane);
        let row = match work.hit(Span::ahead()) {
            Ok(Some(hit)) => Row::hit().number("t", hit.t).vector(["x", "y", "z"], hit.point),
            Ok(None) => match work.meeting() {
                Meeting::Never(how) => Row::miss(how.reason()),
                Meeting::At(_) => Row::miss(""),
            },
            Err(degenerate) => return Ok(Row::invalid(degenerate.reason())),
        };
        // Where x − p_0 overflows, the notes have no distance to give.
        let distance: f64 = work.distance().into();
        Ok(if distance.is_nan() { row } else { row.number("distance", work.distance()) })
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        let mut traded = lab::measure(self, ask)?.traded("Ray against plane: speed for accuracy");
        // Where a part is asked for, it would be drawn over that of the whole.
        if ask.is_for_all() {
            traded.drawings.push(map::draw(ask)?);
        }
        Ok(traded)
    }
}

/// The method's own steps, from its own struct.
pub(crate) fn explain<R: Real>(transcript: &mut Transcript, method: Method, ray: &Ray3<R>, plane: &Plane<R>) {
    let [from, along] = [ray.origin, ray.direction].map(|v| Value::vector::<R>(v).to_text());
    let title = format!("ray-plane · {} · {} · {from} + t {along}", method.name(), R::NAME);
    let source = if method == Method::Notes { "House 4.3, Eq. 4.2" } else { "Eq. 4.2, robust.rs" };
    let section = transcript.section(title, source);
    section
        .vector::<R>("p_0", "a point of the plane", plane.point)
        .vector::<R>("n", "its normal", plane.normal)
        .vector::<R>("p_r", "origin", ray.origin)
        .vector::<R>("u_r", "direction", ray.direction)
        .note("as given: House's has length 1; t counts its lengths");
    let work = method.work(ray, plane);
    match &work {
        Working::Notes(work) => notes_steps(section, work),
        Working::Robust(work) => robust_steps(section, work),
    }
    outcome(section, &work, plane);
}

fn notes_steps<R: Real>(section: &mut Section, work: &Notes<R>) {
    section
        .vector::<R>("p_r − p_0", "from the plane to the origin", work.from_plane)
        .number("n · (p_r − p_0)", "the dot product", work.n_dot_p)
        .number("d", "n · (p_r − p_0) / ‖n‖", work.distance())
        .note(side(work.distance()))
        .number("n · u_r", "the dot product", work.n_dot_u)
        .note(slope(work.n_dot_u))
        .number("t", "−n · (p_r − p_0) / n · u_r", work.t);
}

fn robust_steps<R: Real>(section: &mut Section, work: &Robust<R>) {
    section
        .number("n · (p_r − p_0)", "the dot product", work.n_dot_p.value)
        .note(work.n_dot_p.meaning())
        .number("d", "n · (p_r − p_0) / ‖n‖", work.distance())
        .note(side(work.distance()))
        .number("n · u_r", "the dot product", work.n_dot_u.value)
        .note(format!("{}; {}", slope(work.n_dot_u.value), work.n_dot_u.meaning()));
    if let Meeting::At(t) = work.meeting() {
        section.number("t", "−n · (p_r − p_0) / n · u_r", t);
    }
}

fn side<R: Real>(d: R) -> &'static str {
    match () {
        _ if d > R::from(0.0) => "d > 0: the origin is above",
        _ if d < R::from(0.0) => "d < 0: the origin is below",
        _ => "d = 0: the origin is on the plane",
    }
}

fn slope<R: Real>(n_dot_u: R) -> &'static str {
    match () {
        _ if n_dot_u > R::from(0.0) => "> 0: along the normal",
        _ if n_dot_u < R::from(0.0) => "< 0: against the normal",
        _ => "= 0: parallel",
    }
}

/// What t means, the point, and its distance from the plane: the residual.
fn outcome<R: Real>(section: &mut Section, work: &Working<R>, plane: &Plane<R>) {
    match (work.hit(Span::ahead()), work.meeting()) {
        (Ok(Some(hit)), _) => {
            section.note("t ≥ 0: a hit").vector::<R>("x", "p_r + t u_r", hit.point).number(
                "residual",
                "n · (x − p_0) / ‖n‖",
                signed_distance(hit.point, plane).d,
            );
        }
        (_, Meeting::At(_)) => {
            section.note("t < 0: the plane is behind");
        }
        (_, Meeting::Never(how)) => {
            let meaning = match how {
                Parallel::Apart => "parallel: it never meets the plane",
                Parallel::Within => "parallel and on the plane: it lies within it",
            };
            section.step("x", "p_r + t u_r", Value::text("none")).note(meaning);
        }
    }
}

/// Signed distance, with its three signs.
fn three_signs<R: Real>(transcript: &mut Transcript) {
    let plane = ground::<R>();
    let points = [(2.0, 1.5, -3.0), (2.0, 0.0, -3.0), (2.0, -0.5, -3.0)];
    let rows = points.map(|(x, y, z)| {
        let x = R::vec3(R::from(x), R::from(y), R::from(z));
        let distance = signed_distance(x, &plane);
        let from_plane = Value::vector::<R>(distance.from_plane);
        vec![
            Value::vector::<R>(x),
            from_plane,
            Value::number(distance.d),
            Value::text(distance.side().name()),
        ]
    });
    transcript
        .section("How far is a point from the plane? d = n · (x − p_0)", "House 4.3")
        .table(&["x", "x − p_0", "d", "x is"], rows.to_vec());
}

/// "What happens if the ray is parallel? What happens to Equation 4.2? How would you test for this?"
fn three_questions<R: Real>(transcript: &mut Transcript, method: Method) {
    let cases = [
        ("down to the ground", 1.0, -0.25),
        ("up and away", 1.0, 0.25),
        ("up, from below", -1.0, 0.25),
        ("down, from on the ground", 0.0, -0.25),
        ("parallel, above", 1.0, 0.0),
        ("parallel, below", -1.0, 0.0),
        ("within the plane", 0.0, 0.0),
        ("all but parallel", 1.0, -1e-15),
    ];
    let rows = cases.map(|(name, height, fall)| {
        let (zero, one) = (R::from(0.0), R::from(1.0));
        let ray = Ray3::<R>::new(
            R::vec3(zero, R::round_from(height), zero),
            R::vec3(zero, R::round_from(fall), -one),
        );
        let printed = crate::notes(&ray, &ground());
        let work = method.work(&ray, &ground());
        let verdict = match (work.hit(Span::ahead()), work.meeting()) {
            (Ok(Some(_)), _) => "hit",
            (_, Meeting::At(_)) => "behind",
            (_, Meeting::Never(how)) => how.reason(),
        };
        let numbers = [printed.n_dot_p, printed.n_dot_u, printed.t].map(Value::number);
        [Value::text(name)].into_iter().chain(numbers).chain([Value::text(verdict)]).collect()
    });
    transcript
        .section("The page's three questions", "House 4.3")
        .table(&["a ray", "n · (p_r − p_0)", "n · u_r", "t by Eq. 4.2", "verdict"], rows.to_vec())
        .remark("Parallel, and there is no intersection: n · u_r = 0, for n is at right angles to the plane.")
        .remark("Eq. 4.2 then divides by zero: ±∞ where the ray is apart from the plane, 0/0 where it lies in it.")
        .remark("The test is n · u_r = 0 before the division, exactly. A ray that is only nearly parallel hits.");
}

/// The rows of the picture from the bottom up: n · u_r → 0 and t → ∞.
fn to_the_horizon<R: Real>(transcript: &mut Transcript, method: Method) {
    let rows = [-0.75, -0.1, -1e-2, -1e-4, -1e-8, 0.0, 1e-8].map(|y| {
        let (zero, one) = (R::from(0.0), R::from(1.0));
        let ray = Ray3::<R>::new(R::vec3(zero, one, zero), R::vec3(zero, R::round_from(y), -one));
        let work = method.work(&ray, &ground());
        let t = match work.meeting() {
            Meeting::At(t) => Value::number(t),
            Meeting::Never(how) => Value::text(how.reason()),
        };
        let point = work.hit(Span::ahead()).ok().flatten();
        let point = point.map_or(Value::text("no hit"), |hit| Value::vector::<R>(hit.point));
        vec![Value::number(R::round_from(y)), t, point]
    });
    transcript
        .section("Up the middle of the picture to the horizon", "")
        .table(&["n · u_r", "t", "x"], rows.to_vec());
}

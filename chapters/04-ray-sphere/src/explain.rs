//! The transcript: one ray against one sphere by one method, and then all of them side by side.

use math::{Camera, Degenerate, Ray3, Real, Roots, Span, Vector};
use stage::{Section, Transcript, Value};

use crate::scene::{self, BACKGROUND, Painted, Tangent, pixel_ray, three_spheres};
use crate::{Batched, ClosestApproach, HalfQuadratic, Method, Quadratic, Robust, Shortcut, Sphere, Working};

/// The method's own steps, from its own struct.
pub(crate) fn explain<R: Real>(
    transcript: &mut Transcript,
    method: Method,
    ray: &Ray3<R>,
    painted: &Painted<R>,
) {
    let [from, along] = [ray.origin, ray.direction].map(|v| Value::vector(v).to_text());
    let name = method.name();
    let title = format!("ray-sphere · {name} · {} · {from} + t {along}", R::NAME);
    let sphere = painted.sphere;
    let (source, center) = match method {
        Method::ClosestApproach => ("House 4.4", "c"),
        Method::Shortcut => ("after House 4.4", "c"),
        Method::Quadratic => ("Gambetta, Listing 2-5", "C"),
        Method::HalfQuadratic | Method::Batched => ("CSC418 11.3.3", "c̄"),
        Method::Robust => ("robust.rs", "c"),
    };
    let section = transcript.section(title, source);
    section.vector(center, "center", sphere.center).note(format!("the {} sphere", painted.name));
    section.number("r", "radius", sphere.radius);
    match method.work(ray, &sphere) {
        Working::ClosestApproach(work) => closest_approach_steps(section, &work),
        Working::Shortcut(work) => shortcut_steps(section, &work),
        Working::Quadratic(work) => quadratic_steps(section, &work),
        Working::HalfQuadratic(work) => half_quadratic_steps(section, &work),
        Working::Batched(work) => batched_steps(section, &work),
        Working::Robust(work) => robust_steps(section, &work),
    }
    if method == Method::HalfQuadratic {
        from_the_view_plane(transcript, ray, painted);
    }
}

/// CSC418's ray starts on the view plane, one direction further on: ā = p̄_ij. Other roundings, so next
/// to a tangent another verdict is possible.
fn from_the_view_plane<R: Real>(transcript: &mut Transcript, ray: &Ray3<R>, painted: &Painted<R>) {
    let from_plane = Ray3::new(ray.at(R::from(1.0)), ray.direction);
    let work = crate::half_quadratic(&from_plane, &painted.sphere);
    let section = transcript
        .section("The same from the view plane, where the page's ray starts", "CSC418 11.2, 11.3.3");
    half_quadratic_steps(section, &work);
    if let Some(case) = work.visibility() {
        section.remark(format!("Of λ1 and λ2: {}.", case.meaning()));
    }
    let from_eye = crate::half_quadratic(ray, &painted.sphere);
    if from_eye.lambda_1.is_some() != work.lambda_1.is_some() {
        section.remark(
            "From the eye the same formulas say otherwise: the ray is within a rounding of a tangent.",
        );
    }
}

/// The root that is the answer, by the formula of the nearer one or of the farther one: a ray that starts inside leaves by
/// the farther. Where both are behind it is the nearer. `note` is what is said of the nearer.
fn root_taken<R: Real>(section: &mut Section, roots: Roots<R>, [nearer, farther]: [&str; 2], note: &str) {
    let zero = R::from(0.0);
    if roots.near < zero && roots.far >= zero {
        section
            .number("t", farther, roots.far)
            .note("the nearer one is behind: from inside, where it leaves");
    } else {
        section.number("t", nearer, roots.near).note(note);
    }
}

fn closest_approach_steps<R: Real>(section: &mut Section, work: &ClosestApproach<R>) {
    let r = work.sphere.radius;
    let decision = match () {
        _ if work.d < r => "d < r: enters and leaves",
        _ if work.d == r => "d = r: touches, x_close is the hit",
        _ => "d > r: no hit",
    };
    section
        .number("‖D‖", "√(D · D)", work.length)
        .vector("u_r", "D / ‖D‖", work.u_r)
        .number("t_close", "u_r · (c − p_r)", work.t_close)
        .vector("x_close", "p_r + t_close u_r", work.x_close)
        .number("d", "‖x_close − c‖", work.d)
        .note(decision);
    let Some(roots) = work.distances() else { return };
    section.step("a", "√(r² − d²)", Value::maybe(work.a));
    root_taken(section, roots, ["t_close − a", "t_close + a"], "the nearer of t_close ± a");
    if let Ok(Some(hit)) = work.hit(Span::ahead()) {
        section.number("t / ‖D‖", "in lengths of D", hit.t).note("as all methods answer");
    }
    hit_steps(section, &work.sphere, work.hit(Span::ahead()), ["p_r + t u_r", "(x_hit − c) / r", "c"]);
}

fn shortcut_steps<R: Real>(section: &mut Section, work: &Shortcut<R>) {
    let zero = R::from(0.0);
    let decision = match () {
        _ if work.a_squared > zero => "a² > 0: enters and leaves",
        _ if work.a_squared == zero => "a² = 0: touches",
        _ => "a² < 0: no hit",
    };
    section
        .number("‖D‖", "√(D · D)", work.length)
        .vector("u_r", "D / ‖D‖", work.u_r)
        .vector("L", "c − p_r", work.l)
        .number("t_close", "u_r · L", work.t_close)
        .number("L · L", "the way to the center, squared", work.l.dot(work.l))
        .number("t_close²", "the way to x_close, squared", work.t_close * work.t_close)
        .number("d²", "L · L − t_close²", work.d_squared)
        .number("a²", "r² − d²", work.a_squared)
        .note(decision);
    let Some(roots) = work.roots() else { return };
    section.step("a", "√a²", Value::maybe(work.a));
    root_taken(section, roots, ["(t_close − a) / ‖D‖", "(t_close + a) / ‖D‖"], "in lengths of D");
    hit_steps(section, &work.sphere, work.hit(Span::ahead()), ["p_r + t D", "(x_hit − c) / r", "c"]);
}

fn batched_steps<R: Real>(section: &mut Section, work: &Batched<R>) {
    let root = |lambda: R| Value::maybe(work.roots().map(|_| lambda));
    let missing = if work.roots().is_none() { "√D is not a number, and lies in no span" } else { "" };
    coefficients(section, &work.ray, [work.a, work.b, work.c, work.d])
        .note("no branch: both roots are taken whatever D is")
        .step("λ1", "−B/A + √D/A", root(work.lambda_1))
        .note(missing)
        .step("λ2", "−B/A − √D/A", root(work.lambda_2))
        .note(missing)
        .remark("One lane. A batch does this for eight rays at once, in the same order, with the bits of half-quadratic.");
    if work.roots().is_some() {
        let hit = work.hit(Span::ahead());
        let by_lambda_1 = hit.is_ok_and(|hit| hit.is_some_and(|hit| hit.t == work.lambda_1));
        let x_formula = if by_lambda_1 { "ā + λ1 d⃗" } else { "ā + λ2 d⃗" };
        hit_steps(section, &work.sphere, hit, [x_formula, "(x_hit − c̄) / r", "c̄"]);
    }
}

fn quadratic_steps<R: Real>(section: &mut Section, work: &Quadratic<R>) {
    let zero = R::from(0.0);
    let decision = match () {
        _ if work.discriminant > zero => "> 0: enters and leaves",
        _ if work.discriminant == zero => "= 0: touches",
        _ => "< 0: no solution, no hit",
    };
    section
        .vector("CO", "O − C", work.co)
        .number("a", "⟨D, D⟩", work.a)
        .number("b", "2⟨CO, D⟩", work.b)
        .number("c", "⟨CO, CO⟩ − r²", work.c)
        .number("b² − 4ac", "the discriminant", work.discriminant)
        .note(decision);
    if work.t1.is_none() {
        return;
    }
    section.step("t1", "(−b + √(b² − 4ac)) / 2a", Value::maybe(work.t1));
    section.step("t2", "(−b − √(b² − 4ac)) / 2a", Value::maybe(work.t2));
    hit_steps(section, &work.sphere, work.hit(Span::ahead()), ["O + t D", "(x_hit − C) / r", "C"]);
}

/// The steps that half-quadratic and batched share, up to the discriminant.
fn coefficients<'a, R: Real>(
    section: &'a mut Section,
    ray: &Ray3<R>,
    [a, b, c, d]: [R; 4],
) -> &'a mut Section {
    section
        .vector("ā", "where the ray starts", ray.origin)
        .vector("d⃗", "p̄_ij − ē", ray.direction)
        .number("A", "d⃗ · d⃗", a)
        .number("B", "(ā − c̄) · d⃗", b)
        .number("C", "(ā − c̄) · (ā − c̄) − r²", c)
        .note("the page has r = 1")
        .number("D", "B² − A C", d)
}

fn half_quadratic_steps<R: Real>(section: &mut Section, work: &HalfQuadratic<R>) {
    let zero = R::from(0.0);
    let decision = match () {
        _ if work.d > zero => "> 0: two intersections",
        _ if work.d == zero => "= 0: the ray grazes the sphere",
        _ => "< 0: no intersections",
    };
    coefficients(section, &work.ray, [work.a, work.b, work.c, work.d]).note(decision);
    if work.lambda_1.is_none() {
        return;
    }
    section
        .step("λ1", "−B/A + √D/A", Value::maybe(work.lambda_1))
        .step("λ2", "−B/A − √D/A", Value::maybe(work.lambda_2))
        .note(if work.d == zero { "the same: one intersection" } else { "" });
    let hit = work.hit(Span::ahead());
    let by_lambda_1 = hit.is_ok_and(|hit| hit.is_some_and(|hit| Some(hit.t) == work.lambda_1));
    let x_formula = if by_lambda_1 { "ā + λ1 d⃗" } else { "ā + λ2 d⃗" };
    hit_steps(section, &work.sphere, hit, [x_formula, "(x_hit − c̄) / r", "c̄"]);
}

fn robust_steps<R: Real>(section: &mut Section, work: &Robust<R>) {
    let vector = |v: [f64; 3]| Value::Array(v.map(Value::F64).to_vec());
    let chord = &work.chord;
    let decision = match work.roots() {
        None => "a² < 0: no hit",
        Some(roots) if roots.near == roots.far && chord.h == Some(0.0) => "a² = 0: touches",
        Some(_) => "a² > 0: enters and leaves",
    };
    section
        .step("L", "c − p_r", vector(work.l))
        .step("L_error", "what the rounding of L dropped", vector(work.l_error))
        .step("A", "d · d", Value::F64(chord.a))
        .step("B", "L · d", Value::F64(chord.b))
        .step("t_close", "B / A", Value::F64(chord.t_close))
        .step("P", "L − t_close d", vector(chord.p))
        .note("from the closest point to the center")
        .step("δ", "P · d / A", Value::F64(chord.correction))
        .note("what the rounding of t_close left")
        .step("a²", "r² − P · P + δ P · d", Value::F64(chord.half_chord_squared))
        .note(format!("{decision}; {}", chord.certainty.meaning()));
    let (Some(h), Some(roots)) = (chord.h, work.roots()) else { return };
    section.step("h", "√(a² / A)", Value::F64(h));
    let (near, far) = match chord.c {
        None => ("t_close + (δ − h)", "t_close + (δ + h)"),
        Some(c) => {
            section.step("C", "L · L − r²", Value::F64(c)).note("C = A t_near t_far: no difference is taken");
            match chord.t_close < 0.0 {
                true => ("t_close − h", "C / (A t_near)"),
                false => ("C / (A t_far)", "t_close + h"),
            }
        }
    };
    section.number("t_near", near, roots.near).number("t_far", far, roots.far);
    hit_steps(
        section,
        &work.sphere,
        work.hit(Span::ahead()),
        ["p_r + t d, or c + r n if r < ‖t d‖", "(t d − L) / r = ((δ ∓ h) d − P) / r", "c"],
    );
}

/// The hit, its normal, and the residual of substituting it back; `c` is the letter that the page has for the center.
fn hit_steps<R: Real>(
    section: &mut Section,
    sphere: &Sphere<R>,
    hit: Result<Option<crate::Hit3<R>>, Degenerate>,
    [x_formula, n_formula, c]: [&str; 3],
) {
    let Ok(Some(hit)) = hit else {
        section.step("hit", "the smallest root ≥ 0", Value::text("none")).note("all of the sphere is behind");
        return;
    };
    let residual = (hit.point - sphere.center).length() - sphere.radius;
    section.vector("x_hit", x_formula, hit.point).vector("n", n_formula, hit.normal).number(
        "residual",
        &format!("‖x_hit − {c}‖ − r"),
        residual,
    );
}

/// Listing 2-4 over the three spheres.
pub(crate) fn trace_ray<R: Real>(
    transcript: &mut Transcript,
    method: Method,
    ray: &Ray3<R>,
    spheres: &[Painted<R>],
) {
    let span = Span::from_view_plane();
    let seen = scene::trace_ray(method, ray, spheres, span);
    let rows = spheres.iter().map(|painted| {
        let roots = method.work(ray, &painted.sphere).roots();
        let within = roots.and_then(|roots| roots.first_within(span));
        let [near, far] = [roots.map(|roots| roots.near), roots.map(|roots| roots.far)].map(Value::maybe);
        vec![Value::text(painted.name), far, near, Value::maybe(within)]
    });
    let section = transcript.section("TraceRay(O, D, t_min = 1, t_max = ∞)", "Gambetta, Listing 2-4");
    section.table(&["sphere", "t1", "t2", "the nearer in [1, ∞]"], rows.collect());
    let (color, remark) = match seen {
        Some((index, t)) => {
            let Painted { name, color, .. } = spheres[index];
            (color, format!("closest: {name}, at t = {}", Value::number(t).to_text()))
        }
        None => (BACKGROUND, "closest: none, the background".to_string()),
    };
    let color = Value::Array(color.map(|channel| Value::F64(f64::from(channel))).to_vec());
    section.remark(remark).remark(format!("color: {}", color.to_text()));
}

/// The same two numbers by every road, and how their parameters are related.
pub(crate) fn both_roots<R: Real>(transcript: &mut Transcript, ray: &Ray3<R>, painted: &Painted<R>) {
    let title = format!("Both roots of the {} sphere, by every method, in lengths of D", painted.name);
    let rows = Method::ALL.map(|method| {
        let roots = method.work(ray, &painted.sphere).roots();
        let [near, far] = [roots.map(|roots| roots.near), roots.map(|roots| roots.far)].map(Value::maybe);
        vec![Value::text(method.name()), near, far]
    });
    transcript.section(title, "").table(&["method", "enters at t", "leaves at t"], rows.to_vec());

    let house = crate::closest_approach(ray, &painted.sphere);
    let gambetta = crate::quadratic(ray, &painted.sphere);
    let one = R::from(1.0);
    let csc418 = crate::half_quadratic(&Ray3::<R>::new(ray.at(one), ray.direction), &painted.sphere);
    let (Some(distances), Some(t), Some(lambda)) = (house.distances(), gambetta.t2, csc418.lambda_2) else {
        return;
    };
    transcript
        .section("One hit, three parameters", "House, Gambetta, CSC418")
        .number("t_House", "t_close − a", distances.near)
        .number("t_House", "‖D‖ t_Gambetta", house.length * t)
        .note("the same distance")
        .number("t_Gambetta", "(−b − √(b² − 4ac)) / 2a", t)
        .number("λ_CSC418", "−B/A − √D/A", lambda)
        .number("λ_CSC418", "t_Gambetta − 1", t - one)
        .note("its ray starts at t = 1")
        .remark("House counts in units of length, Gambetta in lengths of D, CSC418 from the view plane on.");
}

/// Table 2-1, with a point of this ray in each range.
pub(crate) fn ranges<R: Real>(transcript: &mut Transcript, ray: &Ray3<R>) {
    let rows = [
        ("t < 0", "behind the camera", -1.0),
        ("0 ≤ t ≤ 1", "between the camera and the view plane", 0.5),
        ("t > 1", "in front of the view plane", 2.0),
    ];
    let rows = rows.map(|(range, meaning, t)| {
        let t = R::from(t);
        vec![Value::text(range), Value::text(meaning), Value::number(t), Value::vector(ray.at(t))]
    });
    let columns = ["range", "where", "for instance t", "O + t D"];
    transcript.section("The ranges of t", "Gambetta, Table 2-1").table(&columns, rows.to_vec());
}

/// The pixels whose rays are tangent on paper, and what each method makes of them.
pub(crate) fn tangents<R: Real>(
    transcript: &mut Transcript,
    camera: &Camera<R>,
    size: (u32, u32),
    tangents: &[Tangent],
) {
    let section = transcript.section("Exactly tangent pixels of this lattice: D = 0 on paper", "");
    let mut differ = Vec::new();
    let mut rows = Vec::new();
    for tangent in tangents {
        let (col, row) = tangent.pixel;
        let painted = three_spheres::<R>()[tangent.sphere];
        let ray = pixel_ray(camera, size, tangent.pixel);
        let roots = Method::ALL.map(|method| method.work(&ray, &painted.sphere).roots());
        if roots.iter().any(|other| other.is_some() != roots[0].is_some()) {
            differ.push(format!("{col},{row}"));
        }
        let place = [Value::text(format!("{col},{row}")), Value::text(painted.name)];
        rows.push(place.into_iter().chain(roots.map(|roots| Value::text(verdict(roots)))).collect());
    }
    if rows.is_empty() {
        section.remark("There are none.");
        return;
    }
    let columns: Vec<&str> = ["pixel", "sphere"].into_iter().chain(Method::ALL.map(Method::name)).collect();
    let pixels =
        if differ.is_empty() { "no pixel".to_string() } else { format!("pixels {}", differ.join(" and ")) };
    section
        .table(&columns, rows)
        .remark(format!(
            "In {}. Where V = (col/width − 1/2, …) had to be rounded, the ray is beside the tangent: robust shows on which side.",
            R::NAME
        ))
        .remark(format!("The pictures of the methods differ at {pixels}."));
}

fn verdict<R: Real>(roots: Option<Roots<R>>) -> &'static str {
    match roots {
        None => "misses",
        Some(roots) if roots.near == roots.far => "touches",
        Some(_) => "hits",
    }
}

#[cfg(test)]
mod tests;

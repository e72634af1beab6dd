//! How this chapter shows and evaluates itself.

use math::{Degenerate, Ray3, Real, Span, Vector};
use stage::{About, Ask, Case, Error, Precision, Row, Section, Shown, Stage, Transcript, Value};

use crate::scene::{self, BACKGROUND, Painted, camera, pixel_ray, three_spheres, trace_ray};
use crate::{ClosestApproach, HalfQuadratic, Method, Quadratic, Robust, Sphere, Working, picture};

/// The stage `ray-sphere`.
pub struct RaySphere;

impl Stage for RaySphere {
    fn about(&self) -> About {
        About {
            number: 4,
            name: "ray-sphere",
            teaches: "a ray against a sphere, by four roads to the same two numbers",
            notes: "House 4.4; Gambetta \"Ray Meets Sphere\", Listings 2-2 to 2-5; CSC418 11.3.3",
            methods: Method::ALL.map(Method::name).to_vec(),
            size: (540, 540),
            picture: "Gambetta's three spheres on his lattice, one ray a pixel, seen from above and from \
                      the right in the corners; the rays that touch a sphere exactly are ringed.",
            inputs: &["ox", "oy", "oz", "dx", "dy", "dz", "cx", "cy", "cz", "r"],
            results: &["hit", "t", "t_out", "x", "y", "z", "nx", "ny", "nz", "reason"],
        }
    }

    fn show(&self, ask: &Ask) -> Result<Shown, Error> {
        match ask.precision {
            Precision::F32 => show::<f32>(ask),
            Precision::F64 => show::<f64>(ask),
        }
    }

    fn eval(&self, ask: &Ask, case: &Case<'_>) -> Result<Row, Error> {
        match ask.precision {
            Precision::F32 => row::<f32>(ask, case),
            Precision::F64 => row::<f64>(ask, case),
        }
    }
}

fn row<R: Real>(ask: &Ask, case: &Case<'_>) -> Result<Row, Error> {
    let [ox, oy, oz, dx, dy, dz, cx, cy, cz, radius] = case.numbers::<R, 10>()?;
    let ray = Ray3::<R>::new(R::vec3(ox, oy, oz), R::vec3(dx, dy, dz));
    let sphere = Sphere { center: R::vec3(cx, cy, cz), radius };
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

fn show<R: Real>(ask: &Ask) -> Result<Shown, Error> {
    let method = Method::ALL[ask.method];
    let impossible = |degenerate: Degenerate| Error::Failed(degenerate.to_string());
    let camera = camera::<R>(ask.size).map_err(impossible)?;
    let spheres = three_spheres::<R>();

    // The worked example looks at the center of the red sphere: V = (0, −1/3, 1), a third of the
    // viewport below the middle.
    let third = R::from(-1.0) / R::from(3.0);
    let ray = match ask.pixel {
        Some(pixel) => pixel_ray(&camera, ask.size, pixel),
        None => camera.ray((R::from(0.0), third)),
    };
    let index = subject(method, &ray, &spheres).map_err(impossible)?;
    let about = RaySphere.about();
    let mut transcript = Transcript::new(&about, ask);
    explain(&mut transcript, method, &ray, &spheres[index]);
    trace_ray_section(&mut transcript, method, &ray, &spheres);
    both_roots(&mut transcript, &ray, &spheres[index]);
    ranges::<R>(&mut transcript, &ray);
    tangents(&mut transcript, ask.size);

    let picture = picture::draw::<R>(method, ask.size, &camera, &ray)?;
    Ok(Shown { transcript, picture })
}

/// The sphere a ray is explained against: the one it meets first, else the one it passes closest to.
fn subject<R: Real>(method: Method, ray: &Ray3<R>, spheres: &[Painted<R>]) -> Result<usize, Degenerate> {
    if let Some((index, _)) = trace_ray(method, ray, spheres, Span::from_view_plane())? {
        return Ok(index);
    }
    let distance = |painted: &Painted<R>| crate::closest_approach(ray, &painted.sphere).d;
    let mut nearest = 0;
    for (index, painted) in spheres.iter().enumerate() {
        if distance(painted) < distance(&spheres[nearest]) {
            nearest = index;
        }
    }
    Ok(nearest)
}

/// The method's own steps, from its own struct.
fn explain<R: Real>(transcript: &mut Transcript, method: Method, ray: &Ray3<R>, painted: &Painted<R>) {
    let [from, to] = [ray.origin, ray.direction].map(|v| Value::vector(v).to_text());
    let name = method.name();
    let title = format!("ray-sphere · {name} · {} · {from} → {to}", R::NAME);
    let sphere = painted.sphere;
    let source = match method {
        Method::ClosestApproach => "House 4.4",
        Method::Quadratic => "Gambetta, Listing 2-5",
        Method::HalfQuadratic => "CSC418 11.3.3",
        Method::Robust => "robust.rs",
    };
    let section = transcript.section(title, source);
    section.vector("c", "center", sphere.center).note(format!("the {} sphere", painted.name)).number(
        "r",
        "radius",
        sphere.radius,
    );
    match method.work(ray, &sphere) {
        Working::ClosestApproach(work) => closest_approach_steps(section, &work),
        Working::Quadratic(work) => quadratic_steps(section, &work),
        Working::HalfQuadratic(_) => {
            // CSC418's ray starts on the view plane: ā = p̄_ij, one direction further on.
            let from_plane = Ray3::<R>::new(ray.at(R::from(1.0)), ray.direction);
            half_quadratic_steps(section, &crate::half_quadratic(&from_plane, &sphere));
        }
        Working::Robust(work) => robust_steps(section, &work),
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
    section
        .step("a", "√(r² − d²)", Value::maybe(work.a))
        .number("t", "t_close − a", roots.near)
        .note("the nearer of t_close ± a");
    hit_steps(section, &work.sphere, work.hit(Span::ahead()), ["p_r + t u_r", "(x_hit − c) / r"]);
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
    section.step("t1", "(−b + √(b² − 4ac)) / 2a", Value::maybe(work.t1)).step(
        "t2",
        "(−b − √(b² − 4ac)) / 2a",
        Value::maybe(work.t2),
    );
    hit_steps(section, &work.sphere, work.hit(Span::ahead()), ["O + t D", "(x_hit − c) / r"]);
}

fn half_quadratic_steps<R: Real>(section: &mut Section, work: &HalfQuadratic<R>) {
    let zero = R::from(0.0);
    let decision = match () {
        _ if work.d > zero => "> 0: two intersections",
        _ if work.d == zero => "= 0: the ray grazes the sphere",
        _ => "< 0: no intersections",
    };
    section
        .vector("ā", "p̄_ij, on the view plane", work.ray.origin)
        .vector("d⃗", "p̄_ij − ē", work.ray.direction)
        .number("A", "d⃗ · d⃗", work.a)
        .number("B", "(ā − c̄) · d⃗", work.b)
        .number("C", "(ā − c̄) · (ā − c̄) − r²", work.c)
        .note("the page has r = 1")
        .number("D", "B² − A C", work.d)
        .note(decision);
    if work.lambda_1.is_none() {
        return;
    }
    section
        .step("λ1", "−B/A + √D/A", Value::maybe(work.lambda_1))
        .step("λ2", "−B/A − √D/A", Value::maybe(work.lambda_2))
        .note(work.visibility().map_or("", |case| case.meaning()));
    hit_steps(section, &work.sphere, work.hit(Span::ahead()), ["ā + λ d⃗", "(x_hit − c) / r"]);
}

fn robust_steps<R: Real>(section: &mut Section, work: &Robust<R>) {
    let vector = |v: [f64; 3]| Value::Array(v.map(Value::F64).to_vec());
    let decision = match () {
        _ if work.a_squared > 0.0 => "a² > 0: enters and leaves",
        _ if work.a_squared == 0.0 => "a² = 0: touches",
        _ => "a² < 0: no hit",
    };
    section
        .step("L", "c − p_r", vector(work.l))
        .step("L_error", "what the rounding of L dropped", vector(work.l_error))
        .step("A", "d · d", Value::F64(work.a))
        .step("B", "L · d", Value::F64(work.b))
        .step("C", "L · L − r²", Value::F64(work.c))
        .step("t_close", "B / A", Value::F64(work.t_close))
        .step("P", "L − t_close d", vector(work.p))
        .note("from the closest point to the center")
        .step("a²", "r² − P · P", Value::F64(work.a_squared))
        .note(format!("{decision}; {}", work.certainty.meaning()));
    let (Some(h), Some(roots)) = (work.h, work.roots()) else { return };
    let (near, far) = match work.t_close < 0.0 {
        true => ("t_close − h", "C / (A t_near)"),
        false => ("C / (A t_far)", "t_close + h"),
    };
    section
        .step("h", "√(a² / A)", Value::F64(h))
        .number("t_near", near, roots.near)
        .number("t_far", far, roots.far)
        .note("no difference is taken");
    hit_steps(section, &work.sphere, work.hit(Span::ahead()), ["c + r n", "(t d − L) / r = (∓ h d − P) / r"]);
}

/// The hit, its normal, and the residual of substituting it back.
fn hit_steps<R: Real>(
    section: &mut Section,
    sphere: &Sphere<R>,
    hit: Result<Option<crate::Hit3<R>>, Degenerate>,
    [x_formula, n_formula]: [&str; 2],
) {
    let Ok(Some(hit)) = hit else {
        section.step("hit", "the smallest root ≥ 0", Value::text("none")).note("all of the sphere is behind");
        return;
    };
    let residual = (hit.point - sphere.center).length() - sphere.radius;
    section.vector("x_hit", x_formula, hit.point).vector("n", n_formula, hit.normal).number(
        "residual",
        "‖x_hit − c‖ − r",
        residual,
    );
}

/// Listing 2-4 over the three spheres.
fn trace_ray_section<R: Real>(
    transcript: &mut Transcript,
    method: Method,
    ray: &Ray3<R>,
    spheres: &[Painted<R>],
) {
    let span = Span::from_view_plane();
    let seen = trace_ray(method, ray, spheres, span).ok().flatten();
    let rows = spheres.iter().map(|painted| {
        let roots = method.work(ray, &painted.sphere).roots();
        let within = roots.and_then(|roots| roots.first_within(span));
        let [near, far] = [roots.map(|roots| roots.near), roots.map(|roots| roots.far)].map(Value::maybe);
        vec![Value::text(painted.name), far, near, Value::maybe(within)]
    });
    let section = transcript.section("TraceRay(O, D, t_min = 1, t_max = ∞)", "Gambetta, Listing 2-4");
    section.table(&["sphere", "t1", "t2", "the nearer in [1, ∞]"], rows.collect());
    let (color, remark) = match seen {
        Some((index, hit)) => {
            let Painted { name, color, .. } = spheres[index];
            (color, format!("closest: {name}, at t = {}", Value::number(hit.t).to_text()))
        }
        None => (BACKGROUND, "closest: none, the background".to_string()),
    };
    let color = Value::Array(color.map(|channel| Value::F64(f64::from(channel))).to_vec());
    section.remark(remark).remark(format!("color: {}", color.to_text()));
}

/// The same two numbers by four roads, and how their parameters are related.
fn both_roots<R: Real>(transcript: &mut Transcript, ray: &Ray3<R>, painted: &Painted<R>) {
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
fn ranges<R: Real>(transcript: &mut Transcript, ray: &Ray3<R>) {
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
fn tangents(transcript: &mut Transcript, size: (u32, u32)) {
    let found = scene::tangents(size);
    let section = transcript.section("Exactly tangent pixels of this lattice: D = 0 on paper", "");
    let columns: Vec<&str> = ["pixel", "sphere"].into_iter().chain(Method::ALL.map(Method::name)).collect();
    let rows = found.iter().map(|tangent| {
        let (col, row) = tangent.pixel;
        let place =
            [Value::text(format!("{col},{row}")), Value::text(three_spheres::<f64>()[tangent.sphere].name)];
        place
            .into_iter()
            .chain(Method::ALL.map(|method| Value::text(verdict(method, size, tangent))))
            .collect()
    });
    section.table(&columns, rows.collect());
    section.remark("Computed in f64. The rounded direction V is off the tangent by its last digit: robust tells which way.");
}

/// What a method at f64 says of a tangent pixel.
fn verdict(method: Method, size: (u32, u32), tangent: &scene::Tangent) -> &'static str {
    let Ok(camera) = camera::<f64>(size) else { return "none" };
    let ray = pixel_ray(&camera, size, tangent.pixel);
    let roots = method.work(&ray, &three_spheres::<f64>()[tangent.sphere].sphere).roots();
    match roots {
        None => "misses",
        Some(roots) if roots.near == roots.far => "touches",
        Some(_) => "hits",
    }
}

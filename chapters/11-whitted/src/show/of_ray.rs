//! One ray: where it landed, the local term light by light, and the rays that it sends on.

use math::{Real, Vector};
use shading::lighting::Point;
use shading::{Fate, Material, Phong};
use stage::{Section, Transcript, Value};

use super::{Shot, rgb};
use crate::tree::{Landed, Node};
use crate::{Kind, Refraction, Tree, critical_angle, mirror};

/// So many lights are shown one by one.
const LIGHTS: usize = 16;

/// One ray of the tree, by its place in it.
pub(crate) fn ray<R: Real>(transcript: &mut Transcript, shot: &Shot<'_, R>, place: usize, in_text: bool) {
    let node = &shot.tree.nodes[place];
    let (kind, depth) = (node.sent.kind.name(), node.sent.depth);
    let title = format!("Ray {} · {kind} · depth {depth}", place + 1);
    let source = match node.sent.kind {
        Kind::Eye => "CSC418 11.7",
        Kind::Mirror => "CSC418 11.7.1",
        Kind::Refracted => "CSC418 11.7.3",
    };
    let section = transcript.section(title, source);
    section.in_text = in_text;
    section.vector::<R>("ā", "its origin", node.sent.ray.origin).vector::<R>(
        "b⃗",
        "its direction",
        node.sent.ray.direction,
    );
    let smallest = if node.sent.kind == Kind::Eye { "the smallest λ ≥ 0" } else { "the smallest λ > 0" };
    match &node.landed {
        None => {
            section.step("λ*", smallest, Value::text("none"));
            section.note("it meets nothing and sees the background");
        }
        Some(landed) => {
            section.number("λ*", smallest, landed.lambda);
            section.note(format!("object {}", shot.names.object(landed.object)));
            match &landed.point {
                Some(point) => landing(section, shot, landed, point),
                None => {
                    section.step("I_l", "r_a I_a C", rgb(landed.local));
                    section.note("the point is too far away to be a number: no light is asked for");
                }
            }
            sent_on(section, shot, node, landed);
        }
    }
    section.step("E", formula_of_e(shot.tree, node), rgb(node.e));
    let (own, what) = match node.landed {
        Some(_) => ("w I_l", "what it brings by itself"),
        None => ("w E", "what it brings"),
    };
    section.number("w", "the coefficients from the eye, multiplied", node.weight);
    section.step(own, what, rgb(shot.tree.contribution(node)));
}

fn number(x: f64) -> String {
    Value::number(x).to_text()
}

/// What is added up for E.
fn formula_of_e<R: Real>(tree: &Tree<R>, node: &Node<R>) -> &'static str {
    let sends = |kind: Kind| node.children.iter().any(|&child| tree.nodes[child].sent.kind == kind);
    match (node.landed.is_some(), sends(Kind::Mirror), sends(Kind::Refracted)) {
        (false, ..) => "the background",
        (true, false, false) => "I_l",
        (true, true, false) => "I_l + r_g I_mirror",
        (true, false, true) => "I_l + r_t I_refracted",
        (true, true, true) => "I_l + r_g I_mirror + r_t I_refracted",
    }
}

/// The point and its local term.
fn landing<R: Real>(section: &mut Section, shot: &Shot<'_, R>, landed: &Landed<R>, point: &Point<R>) {
    let lit = &shot.scene.lit;
    let side = if point.turned.from_outside { "as the surface has it" } else { "turned toward the viewer" };
    section
        .vector::<R>("p̄", "ā + λ* b⃗", point.landing.point)
        .vector::<R>("n⃗", "the unit normal", point.turned.n)
        .note(side);
    let n_dot_face = point.turned.n.dot(point.turned.face);
    if n_dot_face < R::from(0.0) {
        section.number("n⃗·n⃗_face", "below 0", n_dot_face);
        section
            .note("the vn of the mesh point against its winding: lights before the face count as behind it");
    }
    section.vector::<R>("c⃗", "−b⃗ / ‖b⃗‖", point.c).step("C", "color × texture", rgb(point.color));
    let material = &lit.materials[lit.painted[landed.object].material];
    if material.ambient > 0.0 {
        section.step("ambient", "r_a I_a C", rgb(lit.ambient * point.color * material.ambient));
    }
    if lit.lights.is_empty() {
        section.step("V", "the light is seen", Value::text("none")).note("the scene has no light");
    }
    for (light, fate) in landed.lights.iter().take(LIGHTS) {
        one_light(section, shot, (point, material), *light, fate);
    }
    section.step("I_l", "ambient + Σ V (diffuse + specular)", rgb(landed.local));
    if landed.lights.len() > LIGHTS {
        section.note(format!("with {} more lights that are not listed", landed.lights.len() - LIGHTS));
    }
}

/// What one light does there.
fn one_light<R: Real>(
    section: &mut Section,
    shot: &Shot<'_, R>,
    (point, material): (&Point<R>, &Material),
    light: usize,
    fate: &Fate<R>,
) {
    let number = light + 1;
    let to_light = shot.scene.lit.lights[light].position - point.landing.point;
    let named = |symbol: &str| format!("{symbol}_{number}");
    if to_light.is_zero() {
        section.step(&named("V"), "the light is seen", Value::number(0.0)).note("the light is at p̄");
        return;
    }
    if !material.answers_lights() {
        section.step(&named("V"), "the light is seen", Value::text("not asked")).note("as r_d + r_s = 0");
        return;
    }
    let s = to_light.unit();
    let (n_dot_s, of_seen) = match fate {
        Fate::Seen(phong) => (phong.n_dot_s, Some(phong)),
        _ => (point.turned.n.dot(s), None),
    };
    section.vector::<R>(&named("s⃗"), "(l̄ − p̄) / ‖l̄ − p̄‖", s).number(
        &named("n⃗·s⃗"),
        "cos of its angle",
        n_dot_s,
    );
    let (v, why) = match fate {
        Fate::Behind => (0.0, "n⃗·s⃗ ≤ 0: the light is behind the surface".to_string()),
        Fate::Unanswered => (1.0, "nothing answers it".to_string()),
        Fate::Shadowed(part) => {
            (0.0, format!("object {} stands in between", shot.names.object(shot.parts.object(*part))))
        }
        Fate::Seen(_) => (1.0, "nothing stands in between".to_string()),
    };
    section.step(&named("V"), "the light is seen", Value::number(v)).note(why);
    if let Some(phong) = of_seen {
        terms(section, named, material, phong);
    }
}

/// The terms of a light that is seen.
pub(crate) fn terms<R: Real>(
    section: &mut Section,
    named: impl Fn(&str) -> String,
    material: &Material,
    Phong { m, c_dot_m, diffuse, specular, .. }: &Phong<R>,
) {
    if material.diffuse > 0.0 {
        section.step(&named("diffuse"), "r_d I C max(0, n⃗·s⃗)", rgb(*diffuse));
    }
    if material.specular > 0.0 {
        section
            .vector::<R>(&named("m⃗"), "2 (n⃗·s⃗) n⃗ − s⃗", *m)
            .number(&named("c⃗·m⃗"), "cos of the highlight's angle", *c_dot_m)
            .step(&named("specular"), "r_s I max(0, c⃗·m⃗)^α", rgb(*specular));
    }
}

/// The rays that it sends on, or why it does not.
fn sent_on<R: Real>(section: &mut Section, shot: &Shot<'_, R>, node: &Node<R>, landed: &Landed<R>) {
    let optics = shot.scene.optics_of(landed.object);
    let Some(point) = &landed.point else { return };
    if optics.mirror == 0.0 && optics.transmit == 0.0 {
        return;
    }
    if node.sent.depth >= shot.scene.max_depth {
        let most = Value::number(f64::from(shot.scene.max_depth));
        section
            .step("maxDepth", "rays are sent on while depth < maxDepth", most)
            .note("depth is maxDepth: none is");
        return;
    }
    let bring = |kind: Kind| match node.left_out.iter().find(|(left_out, _)| *left_out == kind) {
        Some((_, at_most)) => format!("left out: it could bring {} at most", number(*at_most)),
        None => match node.children.iter().find(|&&child| shot.tree.nodes[child].sent.kind == kind) {
            Some(child) => format!("ray {}", child + 1),
            None => "sent, and not listed".to_string(),
        },
    };
    if optics.mirror > 0.0 {
        let m_s = mirror::<R>(-point.c, point.turned.n).m_s;
        section.vector::<R>("m⃗_s", "−2 (d⃗·n⃗) n⃗ + d⃗", m_s).note(bring(Kind::Mirror));
        section.number("r_g", "specularReflCoef", optics.mirror);
    }
    if let Some((refraction, through)) = &landed.refraction {
        if let ([before, after], Some(_)) = (&landed.media[..], through) {
            let [before, after] = [before, after].map(|solids| shot.names.media(solids));
            section.step(
                "media",
                "the solids it is in, the topmost last",
                Value::text(format!("{before} → {after}")),
            );
        }
        refracted(section, refraction, *through, || bring(Kind::Refracted));
        section.number("r_t", "refractiveReflCoef", optics.transmit);
    }
}

/// How light goes through there.
pub(crate) fn refracted<R: Real>(
    section: &mut Section,
    refraction: &Refraction<R>,
    through: Option<bool>,
    bring: impl Fn() -> String,
) {
    let Refraction { n1, n2, .. } = *refraction;
    let way = match through {
        Some(true) => "into the solid",
        Some(false) => "out of the solid",
        None => "a surface without an inside: unbent",
    };
    section.number("n1", "the medium that it comes from", n1).number("n2", "the medium beyond", n2).note(way);
    section.number("θ1", "degrees, cos θ1 = −d⃗·n⃗", refraction.theta1());
    if let (Some(t), Some(theta2)) = (refraction.t, refraction.theta2()) {
        section.number("θ2", "degrees, sin θ2 = (n1/n2) sin θ1", theta2);
        section.vector::<R>("t⃗", "(n1/n2) (d⃗ + cos θ1 n⃗) − cos θ2 n⃗", t).note(bring());
    } else if refraction.t.is_some() {
        section.vector::<R>("t⃗", "d⃗, as n1 = n2", refraction.t.unwrap_or(refraction.tangent)).note(bring());
    } else {
        section.step("θ2", "degrees, sin θ2 = (n1/n2) sin θ1", Value::text("none"));
        let angle = critical_angle(n1, n2).map_or("90".to_string(), |angle| format!("{angle:.4}"));
        section.note(format!("total internal reflection: θ1 is beyond θ_c = {angle}°"));
    }
}

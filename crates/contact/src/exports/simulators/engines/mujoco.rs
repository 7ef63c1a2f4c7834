//! MuJoCo: `solref` and `solimp` of a geom, in the direct and in the standard format.

use crate::exports::linear::Linear;
use crate::exports::simulators::simulated::{Given, Impedance, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, Measurement, Request, StopMotion, Tool};
use crate::limits;

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "mujoco",
    title: "MuJoCo",
    aliases: &["mjcf", "mjx"],
    law: "linear spring and damper per unit of effective mass, never pulling; semi-implicit Euler",
    combines: "of two direct solrefs the lesser of each number, of two standard ones the mean by solmix; the geom of higher priority, or a <pair>, alone",
    measured: &[
        Measurement {
            engine: "MuJoCo 4.0.0",
            solver: "Euler",
            scenes: "ball; pendulums with rotors; four-bar; double wishbone on its bump stop; stops of joints",
            worst: [Some(6.6e-4), Some(5.3e-4), Some(4.3e-4)],
            by_hand: None,
        },
        Measurement {
            engine: "MuJoCo 4.0.0",
            solver: "RK4",
            scenes: "ball; pendulums with rotors; four-bar; double wishbone on its bump stop",
            worst: [Some(3.0e-4), Some(3.2e-4), Some(3.2e-4)],
            by_hand: None,
        },
        Measurement {
            engine: "MJX 3.17.0",
            solver: "",
            scenes: "ball of 2 kg; pendulums of m̄ = 1.5 and 3.75 kg; in double precision",
            worst: [Some(7e-4), Some(6e-4), Some(5e-4)],
            by_hand: Some("2026-11-22"),
        },
    ],
    caution: "no friction (condim 1); closed loops need the exported equality_solref too, and half the step with implicitfast",
    sources: &[
        "MuJoCo 4.0.0, doc/modeling.rst, \"Solver parameters\"",
        "MuJoCo 4.0.0, doc/computation/index.rst, \"Parameters\"",
        "MuJoCo 4.0.0, src/engine/engine_core_constraint.c: mj_diagApprox, mj_makeImpedance, mj_referenceConstraint",
    ],
};

/// The direct `solref` = (−ω² f, −2ζω f) at a constant impedance d, f = d + (1−d)α.
///
/// MuJoCo's normal row is f_n = max(0, (a_ref − a)/(A + R)), A = 1/m̄, R = (1−d)/d Â, and a_ref = −(b v + κ r) with
/// κ = −solref₀/d², b = −solref₁/d; Â is MuJoCo's estimate of A, α = Â m̄. The resulting contact has the stiffness m̄ κd²/f and
/// the damping m̄ bd/f: f removes the error of the estimate. Equivalent standard format: timeconst 1/(ζωf), dampratio ζ√f.
///
/// Measured in MuJoCo 4.0.0 at the recommended step ([`Linear::explicit_step`]) and accuracy 1e-3, the worst of 25
/// phases for e = 0.05, 0.2, 0.5, 0.8, 0.95, 0.99: 8.9e-4, 7.8e-4, 6.4e-4, 5.3e-4, 5.1e-4, 7.0e-4, ball and pendulum
/// with armature alike, Euler and implicitfast; RK4 3.3e-4 … 3.9e-4. A four-bar (m̄ = 68.1 kg, α = 7.2) and a
/// double wishbone on its bump stop (392.8 kg, α = 0.35), loops closed, e = 0.2, 0.5, 0.8: at most 6.5e-4. With the
/// default equality settings the four-bar shows 0.084, 0.444, 0.789. With a wrong m̄ the restitution is correct and
/// the penetration wrong: a factor of 0.27 with the mass of the coupler, 4.8 kg.
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let (solref, scale) = direct_format(&linear, request);
    let solimp = [limits::MUJOCO_IMPEDANCE, limits::MUJOCO_IMPEDANCE, 1.0];
    let step = linear.explicit_step()?;

    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(linear.error_bound(step));
    export.add_penetration("", linear.penetration(request.speed));
    export.set("solref", solref, "1/s², 1/s");
    export.set("solimp", solimp, "-, -, m");
    export.set("timestep", step, "s");
    let standard = standard_format(&linear, scale);
    if let Some(pair) = standard {
        export.set("solref_standard", pair, "s, -");
    }
    let equality = request.options.constrained || request.options.loops_unknown;
    if equality {
        export.set("equality_solref", [2.0 * step, 1.0], "s, -");
        export.set("equality_solimp", [limits::MUJOCO_IMPEDANCE, limits::MUJOCO_IMPEDANCE, 1.0], "-, -, m");
    }
    export.add_snippet("direct format", "xml", mjcf_document(solref, solimp, step, equality));
    if let Some(pair) = standard {
        export.add_snippet("standard format", "xml", mjcf_document(pair, solimp, step, equality));
    }
    add_assumptions(&mut export, request, &linear);
    Ok(export)
}

/// Direct `solref` and its factor f.
fn direct_format(linear: &Linear, request: &Request) -> ([f64; 2], f64) {
    let alpha = request.options.diagonal_ratio.unwrap_or(1.0);
    let scale = limits::MUJOCO_IMPEDANCE + (1.0 - limits::MUJOCO_IMPEDANCE) * alpha;
    let (zeta, omega) = (linear.ratio, linear.frequency);
    // 0 − x avoids a negative zero without damping.
    ([0.0 - omega * omega * scale, 0.0 - 2.0 * zeta * omega * scale], scale)
}

/// Stop of a joint: `solreflimit` and `solimplimit`. The row is that of a contact with the inertia at the joint as m̄
/// and Â = `dof_invweight0`.
pub(crate) fn stop(request: &Request, motion: StopMotion) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let (solref, _) = direct_format(&linear, request);
    let step = linear.explicit_step()?;
    let d = limits::MUJOCO_IMPEDANCE;
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(linear.error_bound(step));
    export.add_penetration("", linear.penetration(request.speed));
    export.set("solreflimit", solref, "1/s², 1/s");
    export.set("solimplimit", [d, d, 1.0], if motion == StopMotion::Turn { "-, -, rad" } else { "-, -, m" });
    export.set("timestep", step, "s");
    let mut equality = String::new();
    if request.options.constrained {
        export.set("equality_solref", [2.0 * step, 1.0], "s, -");
        export.set("equality_solimp", [d, d, 1.0], "-, -, m");
        equality = equality_default(step);
    }
    let [k, b] = solref;
    export.add_snippet(
        "direct format",
        "xml",
        format!(
            "<mujoco>\n  <option timestep=\"{step:?}\"/>\n  <default>\n    \
             <joint solreflimit=\"{k:?} {b:?}\" solimplimit=\"{d:?} {d:?} 1.0\"/>{equality}\n  </default>\n</mujoco>\n"
        ),
    );
    export.add_assumption("For this joint alone: as a default it is for all joints; margin is 0.");
    match request.options.diagonal_ratio {
        Some(alpha) => export.add_assumption(format!("α = Â times the inertia = {alpha:?}, Â the joint's dof_invweight0.")),
        None => export.add_assumption(
            "α = Â times the inertia is taken as 1 (Â: the joint's dof_invweight0): so it is for a joint by itself.",
        ),
    }
    if request.options.constrained {
        export.add_assumption(
            "The equality constraints need their own solref and solimp as given: the defaults are compliant.",
        );
    }
    Ok(export)
}

/// timeconst and dampratio; `None` without damping (infinite time constant).
fn standard_format(linear: &Linear, scale: f64) -> Option<[f64; 2]> {
    let timeconst = 1.0 / (linear.ratio * linear.frequency * scale);
    timeconst.is_normal().then(|| [timeconst, linear.ratio * scale.sqrt()])
}

/// Equality constraints of loops: the greatest stiffness that the time step permits.
fn equality_default(step: f64) -> String {
    let d = limits::MUJOCO_IMPEDANCE;
    format!("\n    <equality solref=\"{:?} 1.0\" solimp=\"{d:?} {d:?} 1.0\"/>", 2.0 * step)
}

/// MJCF with the options and the contact parameters; `loops` adds the defaults of equality constraints.
fn mjcf_document(solref: [f64; 2], solimp: [f64; 3], step: f64, loops: bool) -> String {
    let [k, b] = solref;
    let [d0, dw, width] = solimp;
    let equality = if loops { equality_default(step) } else { String::new() };
    format!(
        "<mujoco>\n  <option timestep=\"{step:?}\"/>\n  <default>\n    \
         <geom solref=\"{k:?} {b:?}\" solimp=\"{d0:?} {dw:?} {width:?}\"/>{equality}\n  </default>\n</mujoco>\n"
    )
}

/// Adds the assumptions and limitations.
fn add_assumptions(export: &mut Export, request: &Request, linear: &Linear) {
    export.add_assumption(
        "Both geoms have these values (of two direct solrefs MuJoCo takes the lesser of each number), or a <pair> \
         or the geom of higher priority does.",
    );
    export.add_assumption(
        "Frictionless (condim 1): friction at a finite lever shifts the restitution by a few thousandths.",
    );
    export.add_assumption(
        "condim 3 with the default pyramidal cone multiplies α by μ²(1+μ²)/2; elliptic cones and condim 1 do not.",
    );
    export.add_assumption(
        "The standard format needs timeconst ≥ 2·timestep, else refsafe raises it; the direct format is not changed.",
    );
    match request.options.diagonal_ratio {
        Some(alpha) => export.add_assumption(format!("α = Â·m̄ = {alpha:?}, Â at the model's reference pose qpos0.")),
        None => export.add_assumption(format!(
            "α = Â·m̄ is taken as 1 (Â: the sum of body_invweight0[0] of the two bodies, times m̄). With the impedance \
             {} another α changes the damping ratio by {:.0e}·(α−1), relative: give α where it is above 10, \
             or set <flag diagexact=\"enable\"/>, which makes it 1 where no loop is closed.",
            limits::MUJOCO_IMPEDANCE,
            (1.0 - limits::MUJOCO_IMPEDANCE) / 2.0
        )),
    }
    if request.options.loops_unknown && !request.options.constrained {
        export.add_assumption(
            "Closed loops: m̄ is that with the loops closed, α is Â·m̄ with Â of the open tree, and the equality constraints need \
             their own solref and solimp as given, since the defaults are compliant. Without loops they have no effect.",
        );
    }
    if request.options.constrained {
        export.add_assumption(
            "Loops, mimics, locks: MuJoCo's Â is that of the open tree without these constraints, with diagexact too; α = Â·m̄ \
             with the m̄ under them. The equality constraints need their own solref and solimp as given: the \
             defaults are compliant during the contact and change the restitution.",
        );
        export.add_assumption(
            "Constraints with the integrator implicitfast need half this time step: with the full step the \
             error was 1.3e-3; Euler and RK4 stay within 1e-3.",
        );
        export.add_assumption(
            "m̄ belongs to one pose: if m̄ changes during the contact, the restitution changes too; a stiffer \
             contact or a lower speed reduces the change. Those measured in docs/reference/SIMULATORS.md changed by less \
             than 1e-3.",
        );
    }
    if linear.ratio == 0.0 {
        export.cannot.push("the standard format: without damping its time constant is infinite");
    }
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let solref = given.numbers::<2>("solref")?.ok_or_else(|| given.refuse("solref", "it is required"))?;
    let solimp = match given.numbers::<5>("solimp") {
        Ok(numbers) => numbers.unwrap_or([0.9, 0.95, 0.001, 0.5, 2.0]),
        Err(_) => {
            let [first, last, width] = given.numbers::<3>("solimp")?.unwrap_or_default();
            [first, last, width, 0.5, 2.0]
        }
    };
    // MuJoCo clips the impedances and the midpoint to this range.
    let range = 0.0001..=0.9999;
    let [first, last, width, middle, power] = solimp;
    if ![first, last, middle].iter().all(|d| range.contains(d)) || width < 0.0 || power < 1.0 {
        let why = format!(
            "{solimp:?}; expected two impedances and a midpoint from 0.0001 to 0.9999, a width of at least 0, a power of at least 1"
        );
        return Err(given.refuse("solimp", why));
    }
    let alpha = given.optional("diagonal_ratio")?.unwrap_or(1.0);
    let step = given.optional("timestep")?;
    // Both formats give the acceleration −(ω² x d(x)/d_w² + 2ζω ẋ/d_w) d/(d + (1−d)α).
    let per_mass = match solref {
        [stiffness, damping] if stiffness < 0.0 && damping <= 0.0 => [-stiffness, -damping],
        [timeconst, dampratio] if timeconst > 0.0 && dampratio > 0.0 => {
            // refsafe raises a time constant below two steps.
            let timeconst = timeconst.max(2.0 * step.unwrap_or(0.0));
            [1.0 / (timeconst * dampratio).powi(2), 2.0 / timeconst]
        }
        [first, second] => {
            let why = format!(
                "{first:?} {second:?}; expected −stiffness −damping, both negative, or timeconst dampratio, both positive"
            );
            return Err(given.refuse("solref", why));
        }
    };
    if let Some(step) = step.filter(|step| *step <= 0.0) {
        return Err(given.refuse("timestep", format!("{step:?}; expected a number above 0")));
    }
    if alpha <= 0.0 {
        return Err(given.refuse("diagonal_ratio", format!("{alpha:?}; expected a number above 0")));
    }
    let row = Impedance { mass: given.mass(), per_mass, solimp, diagonal_ratio: alpha };
    Ok(vec![SimulatedContact::of_impedance(row, step)?])
}

//! Project Chrono, smooth contacts (SMC): user coefficients, or a corrected coefficient of restitution.

use crate::exports::export::check_single_precision;
use crate::exports::linear::Linear;
use crate::exports::simulators::simulated::{ContactModel, Given, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, Measurement, Request, Tool};
use crate::{Damper, LawParameter, Separation, kelvin_voigt};

/// Chrono's mass of a body without a given mass, also of a fixed body, kg.
const DEFAULT_MASS: f64 = 1.0;

/// Radius of curvature of contacts found by Chrono's Bullet, m: default of ChCollisionInfo.
const BULLET_RADIUS: f64 = 0.1;

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "chrono",
    title: "Project Chrono (SMC)",
    aliases: &["project-chrono", "pychrono", "smc"],
    law: "Hooke: linear spring and damper, never pulling; Hertz: the same with x^(3/2) and x^(1/4) ẋ",
    combines: "the lesser coefficient of restitution; the mean of kn and of gn",
    measured: &[
        Measurement {
            engine: "Chrono 10.0.0",
            solver: "Hooke, kn and gn",
            scenes: "ball of 2 kg; pendulums of m̄ = 1.5 and 3.75 kg; four-bar of joints, m̄ = 68.1 kg; against a fixed body of 1 kg",
            worst: [Some(6.5e-4), Some(5.2e-4), Some(4.1e-4)],
            by_hand: Some("2026-11-22"),
        },
        Measurement {
            engine: "Chrono 10.0.0",
            solver: "Hertz, material properties",
            scenes: "the same, if the masses permit it, at 5e-6 s",
            worst: [None, Some(2.5e-4), Some(1.1e-4)],
            by_hand: Some("2026-11-22"),
        },
    ],
    caution: "the damping uses the masses of the two bodies alone, 1 kg by default for a fixed body; materials \
        have friction by default",
    sources: &[
        "Project Chrono, src/chrono/physics/ChContactSMC.cpp and ChSystemSMC.h",
        "Project Chrono, src/chrono/physics/ChContactMaterialSMC.h",
        "Project Chrono, src/chrono/collision/ChCollisionInfo.cpp and bullet/ChCollisionSystemBullet.cpp",
    ],
};

/// Hooke (p = 1): kn = k, gn = c/m_eff. Hooke and Hertz (p = 3/2): cr' = e_a(ζ√(m̄/m_eff)).
///
/// Chrono's force is max(0, kn x + m_eff gn ẋ), m_eff = m₁m₂/(m₁+m₂) of the own masses of the two bodies, fixed
/// bodies included, without links on joints. Chrono converts cr by the half period, e_a(ζ) = exp(−πζ/√(1−ζ²)), with
/// m_eff, and clamps the force: the rebound with cr itself is too high (0.325, 0.550, 0.808 for 0.2, 0.5, 0.8 with
/// m_eff = m̄). cr' corrects both effects and is unreachable for ζ√(m̄/m_eff) ≥ 1. The step is
/// [`Linear::explicit_step`]: Chrono's contact forces are explicit.
///
/// Measured in Chrono 10.0.0 (source of 2026-08-18): the worst of five phases for e = 0.2, 0.5, 0.8 is 6.4e-4,
/// 5.1e-4, 4.1e-4 with kn and gn, of a ball, pendulums and the four-bar alike, and joints solved by PSOR (the
/// default) or by a direct solver rebound the same to 1e-10; Hertz 2.3e-4 and 1.1e-4 for 0.5 and 0.8. The radius of
/// curvature that Hertz takes is not that of the shapes: collisions found by Bullet have ChCollisionInfo's default,
/// 0.1 m.
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let own = request.options.own_mass.ok_or(ExportError::Missing {
        tool: TOOL,
        what: LawParameter::OwnMass,
        why: "the tool computes the damping from the masses of the two bodies, not from the effective mass",
    })?;
    let other = request.options.other_own_mass.unwrap_or(DEFAULT_MASS);
    let effective = own * (other / (own + other));
    let mut export = Export::new(TOOL);
    export.set("m_eff", effective, "kg");
    let (_, exponent) = request.power_law();
    if exponent == 1.5 {
        export_hertz(&mut export, request, effective)?;
    } else if exponent == 1.0 {
        export_hooke(&mut export, request, effective)?;
    } else {
        return Err(ExportError::Exponent {
            tool: TOOL,
            exponent,
            takes: "Hooke has 1, Hertz 3/2",
            remedy: "choose one of the two",
        });
    }
    add_assumptions(&mut export, own, other);
    Ok(export)
}

/// Adds parameters and snippets of the linear (Hooke) model; `effective` is m_eff of the own masses, kg.
fn export_hooke(export: &mut Export, request: &Request, effective: f64) -> Result<(), ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let step = linear.explicit_step()?;
    let damping = linear.damping(linear.ratio) / effective;
    check_single_precision("Chrono's kn, N/m", linear.stiffness)?;
    check_single_precision("Chrono's gn, 1/s", damping)?;
    export.time_step = Some(step);
    export.error_bound = Some(linear.error_bound(step));
    export.add_penetration("", linear.penetration(request.speed));
    export.set("kn", linear.stiffness, "N/m");
    export.set("gn", damping, "1/s");
    export.set("step", step, "s");
    export.add_snippet(
        "user coefficients",
        "cpp",
        format!(
            "system.UseMaterialProperties(false);\n\
             system.SetContactForceModel(chrono::ChSystemSMC::Hooke);\n\
             material->SetKn({:?}f);\n\
             material->SetGn({damping:?}f);\n\
             material->SetFriction(0.0f);\n\
             // In the loop:\n\
             system.DoStepDynamics({step:?});\n",
            linear.stiffness
        ),
    );
    match corrected_restitution(request, effective) {
        Ok(cr) => {
            export.set("cr", cr, "");
            export.add_assumption(format!(
                "With material properties instead, SetRestitution({cr:?}f) gives the same restitution; Chrono \
                 then computes the stiffness; this was not measured."
            ));
        }
        Err(_) => export.cannot.push("this restitution by SetRestitution: user coefficients only"),
    }
    Ok(())
}

/// Adds parameters and snippets of the Hertz model; `effective` is m_eff of the own masses, kg.
fn export_hertz(export: &mut Export, request: &Request, effective: f64) -> Result<(), ExportError> {
    let cr = corrected_restitution(request, effective)?;
    // F = 4/3 E* √R x^(3/2).
    let modulus = 0.75 * request.power_law().0;
    check_single_precision("Chrono's modulus E_eff, Pa", modulus / BULLET_RADIUS.sqrt())?;
    export.set("cr", cr, "");
    export.set("E_eff·sqrt(R_eff)", modulus, "N/m^(3/2)");
    export.set("E_eff", modulus / BULLET_RADIUS.sqrt(), "Pa");
    if let Some(speed) = request.speed {
        let ratio = kelvin_voigt::ratio(request.restitution, Separation::ForceVanishes)?;
        let damper = Damper::kelvin_voigt(request.contact, ratio, Separation::ForceVanishes);
        let impact = damper.and_then(|damper| damper.impact(request.contact, speed));
        export.add_penetration("", impact.ok().map(|impact| impact.max_penetration));
    }
    export.time_step = request.options.time_step;
    let step = request
        .options
        .time_step
        .map_or_else(String::new, |step| format!("// In the loop:\nsystem.DoStepDynamics({step:?});\n"));
    export.add_snippet(
        "material properties",
        "cpp",
        format!(
            "system.UseMaterialProperties(true);\n\
             system.SetContactForceModel(chrono::ChSystemSMC::Hertz);\n\
             material->SetRestitution({cr:?}f);\n\
             material->SetFriction(0.0f);\n\
             // 1/E_eff = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, with E_eff * sqrt(R_eff) = {modulus:?} N/m^(3/2).\n\
             // R_eff is not the shapes': with Bullet's collisions it is 0.1 m, unless SetDefaultEffectiveCurvatureRadius says otherwise.\n\
             // Of two equal materials:\n\
             const double nu = material->GetPoissonRatio();\n\
             material->SetYoungModulus((float)(2 * (1 - nu * nu) * {:?}));\n{step}",
            modulus / BULLET_RADIUS.sqrt()
        ),
    );
    export.add_assumption(
        "Both materials have the restitution (the lesser of two counts). E_eff is for R_eff = 0.1 m, \
         ChCollisionInfo's default, which applies to all collisions found by Bullet, independent of the radii \
         of the shapes.",
    );
    export.add_assumption("No step is recommended and no error stated; measured with a thousandth of the contact's duration or less.");
    Ok(())
}

/// cr' for which Chrono's conversion gives the required restitution.
fn corrected_restitution(request: &Request, effective: f64) -> Result<f64, ExportError> {
    let ratio = kelvin_voigt::ratio(request.restitution, Separation::ForceVanishes)?;
    let ratio = ratio * (request.contact.mass() / effective).sqrt();
    if ratio < 1.0 {
        return Ok(kelvin_voigt::restitution(ratio, Separation::GapCloses)?);
    }
    Err(ExportError::Unreachable {
        tool: TOOL,
        restitution: request.restitution,
        why: "with a material restitution of 0 the damping is critical for the masses of the bodies alone, \
            which is the largest possible damping",
        remedy: "use user coefficients (exponent 1), change the masses of the bodies, or require a larger \
            restitution",
    })
}

/// Adds the assumptions about masses, materials, friction and precision.
fn add_assumptions(export: &mut Export, own: f64, other: f64) {
    export.add_assumption(format!(
        "The contact link alone has {own:?} kg, the other body alone {other:?} kg: Chrono divides by \
         m₁m₂/(m₁+m₂), and a \
         fixed body counts with its own mass, 1 kg unless set."
    ));
    export.add_assumption("Both materials have these values (kn and gn of two are averaged). Chrono stores them in single precision.");
    export.add_assumption(
        "No adhesion and no friction (0.6 by default); the Flores model of the same enumeration is \
            identical to Hooke.",
    );
    export.add_assumption(
        "Collisions are found in single precision: place contacts with a small penetration near the \
        origin.",
    );
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let effective = given.positive("m_eff")?;
    let step = given.optional("step")?;
    let modulus = given.optional("E_eff·sqrt(R_eff)")?;
    let of_radius = given.optional("E_eff")?.map(|modulus| modulus * BULLET_RADIUS.sqrt());
    let cr = given.optional("cr")?;
    let (stiffness, damping) = (given.optional("kn")?, given.optional("gn")?);
    if let Some((stiffness, damping)) = stiffness.zip(damping) {
        return Ok(vec![SimulatedContact::explicit(given, stiffness, damping * effective, step)?]);
    }
    let (Some(modulus), Some(cr)) = (modulus.or(of_radius), cr) else {
        return Err(
            given.refuse("kn", "it is required with gn (Hooke), or E_eff·sqrt(R_eff) with cr (Hertz)")
        );
    };
    let contact = given.contact(modulus / 0.75, 1.5)?;
    let ratio = kelvin_voigt::ratio(cr, Separation::GapCloses)? * (effective / given.mass()).sqrt();
    let damper = Damper::kelvin_voigt(contact, ratio, Separation::ForceVanishes)?;
    Ok(vec![SimulatedContact::of(ContactModel::Compliant(contact, damper))])
}

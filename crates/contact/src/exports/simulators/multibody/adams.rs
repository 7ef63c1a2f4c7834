//! Adams: the IMPACT function and contact; the same function in MotionSolve, RecurDyn and SolidWorks Motion.

use crate::ContactLawError;
use crate::exports::simulators::simulated::{ContactModel, Given, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, ImpactFunction, Request, Tool};
use crate::limits;

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "adams",
    title: "Adams (IMPACT)",
    aliases: &["impact", "motionsolve", "recurdyn", "solidworks-motion"],
    law: "spring k xᵖ and a damping that increases over the depth d; never pulls",
    combines: "none: the values apply to the pair",
    measured: &[],
    caution: "for one closing speed; with the default ERROR and HMAX the integrator steps over the start of \
        the contact",
    sources: &[
        "Adams Solver, \"IMPACT\" (help.solidworks.com, r_function_impact; adams.thisaray.com, func_impact)",
        "MotionSolve, \"IMPACT\" (help.altair.com, impact_function)",
    ],
};

/// IMPACT(x, x', x1, k, e, cmax, d) = max(0, k(x1−x)^e − STEP(x, x1−d, cmax, x1, 0) x').
///
/// GSTIFF, in the SI2 formulation, at HMAX = 0.3 d/v and ERROR = x₀/1000: GSTIFF does not search for the moment of
/// contact; only a short greatest step finds the ramp. Not run in Adams: SciPy's BDF, of the same kind, at these
/// settings (ERROR for penetration and speed) has an error of at most 1.1e-4 for e = 0.05 … 0.95, k = 1e5 and 1e8
/// N/m, 2 kg, 0.03 … 3 m/s, by 8e-3 with ERROR = 1e-3, its default, and HMAX = d/v
/// (tests/external/contact/integrators.py).
///
/// k and the exponent are the contact's; d = 0.1 x₀, cmax = ĉ k x₀ᵖ/v with the ĉ of [`ImpactFunction::damping`]. Both
/// depend on the speed; the restitution is for one speed.
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let (mass, (stiffness, p)) = (request.contact.mass(), request.power_law());
    let e = request.restitution;
    let mut export = Export::new(TOOL);
    export.set("stiffness", stiffness, "N/m^p");
    export.set("exponent", p, "");
    export.add_assumption("The model's units are kg, m, s and N; Adams/View starts with mm: there k·1000^(−p), cmax/1000, d·1000.");
    export.add_assumption(
        "No friction. GSTIFF with HMAX and ERROR as given: with the defaults the error is several 1e-2.",
    );
    export.add_assumption(
        "Not measured in Adams: the function is taken from the documentation, and the error is that \
        of another BDF integrator at these settings.",
    );
    export.add_assumption(format!(
        "A POISSON contact with restitution_coefficient = {e:?} is the alternative; its penalty is not this spring, \
         and its force law was not checked against a source."
    ));
    let Some(speed) = request.speed else {
        export.missing.push("closing speed, m/s: damping and the depth of full damping depend on it");
        return Ok(export);
    };
    let depth = ImpactFunction::undamped_penetration(p, mass, stiffness, speed)?;
    let ramp = limits::ADAMS_RAMP * depth;
    let function = ImpactFunction::new(p, limits::ADAMS_RAMP)?;
    let number = function.damping(e)?;
    export.add_penetration("", function.penetration(number).ok().map(|part| part * depth));
    // k x₀ᵖ/v = (p+1)/2 · m̄ v/x₀.
    let damping = number * (p + 1.0) / 2.0 * mass * speed / depth;
    if !damping.is_finite() {
        return Err(ContactLawError::NotRepresentable { what: "cmax, N·s/m" }.into());
    }
    export.set("cmax", damping, "N·s/m");
    export.set("d", ramp, "m");
    let largest = limits::ADAMS_STEP * ramp / speed;
    let tolerance = limits::ADAMS_TOLERANCE * depth;
    export.set("HMAX", largest, "s");
    export.set("ERROR", tolerance, "m");
    export.error_bound = Some(limits::ADAMS_ERROR);
    export.add_assumption(format!("cmax and d are for approach at {speed:?} m/s."));
    export.add_snippet(
        "SFORCE and CONTACT",
        "adams",
        format!(
            "! Adams Solver data set; marker and geometry numbers are placeholders. x1 is the distance at first \
             touch.\n\
             UNITS/FORCE = NEWTON, MASS = KILOGRAM, LENGTH = METER, TIME = SECOND\n\
             SFORCE/1, I = 11, J = 21, TRANSLATION\n\
             , FUNCTION = IMPACT(DM(11,21), VR(11,21), 0.1, {stiffness:?}, {p:?}, {damping:?}, {ramp:?})\n\
             CONTACT/1, IGEOM = 101, JGEOM = 201\n\
             , IMPACT, STIFFNESS = {stiffness:?}, EXPONENT = {p:?}\n\
             , DAMPING = {damping:?}, DMAX = {ramp:?}\n\
             INTEGRATOR/GSTIFF, SI2, ERROR = {tolerance:?}, HMAX = {largest:?}\n"
        ),
    );
    Ok(export)
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let (stiffness, exponent) = (given.positive("stiffness")?, given.positive("exponent")?);
    let contact = given.contact(stiffness, exponent)?;
    let (damping, depth) = (given.number("cmax")?, given.positive("d")?);
    given.optional("HMAX")?;
    given.optional("ERROR")?;
    Ok(vec![SimulatedContact::of(ContactModel::ImpactFunction { contact, damping, depth })])
}

//! PhysX 5, Isaac Sim and Isaac Lab: compliant contacts.

use super::export::single;
use super::linear::Linear;
use super::{Export, ExportError, Facts, Request, Tool};

const TOOL: Tool = Tool::of(&FACTS);

pub(super) const FACTS: Facts = Facts {
    name: "physx",
    title: "PhysX and Isaac",
    aliases: &["isaac", "isaac-sim", "isaac-lab", "isaaclab"],
    law: "linear spring and damper, never pulling, by implicit Euler",
    combines: "by the combine mode, average where none is set; of a rigid and a compliant material the compliant one",
    measured: &[],
    caution: "",
    sources: &[
        "PhysX 5, physx/include/PxMaterial.h",
        "PhysX 5, physx/source/lowleveldynamics/src/DyContactPrepShared.h: computeCompliantContactCoefficients",
        "Isaac Lab, isaaclab.sim.spawners.materials: RigidBodyMaterialCfg",
    ],
};

/// Force mode: stiffness k, damping c'. Acceleration mode: ω² and 2ζ'ω, per unit of the solver's effective mass.
///
/// PhysX's compliant contact is a = h(c + h k), impulse scale 1/(1 + a/m̄): implicit Euler of the linear spring and
/// damper, so ζ' = ζ − ωh/2. A negative restitution of the material is its stiffness.
pub(super) fn export(request: &Request) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let step = linear.implicit_step();
    let ratio = linear.implicit_ratio(step)?;
    let (stiffness, damping) = (linear.stiffness, linear.damping(ratio));
    let square = linear.frequency * linear.frequency;
    let rate = 2.0 * ratio * linear.frequency;
    for (what, value) in [
        ("PhysX's stiffness, N/m", stiffness),
        ("PhysX's damping, N·s/m", damping),
        ("PhysX's stiffness over mass, 1/s²", square),
        ("PhysX's damping over mass, 1/s", rate),
        ("PhysX's time step, s", step),
    ] {
        single(what, value)?;
    }
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(linear.implicit_error_bound(step));
    export.set("compliant_contact_stiffness", stiffness, "N/m");
    export.set("compliant_contact_damping", damping, "N·s/m");
    export.set("acceleration_stiffness", square, "1/s²");
    export.set("acceleration_damping", rate, "1/s");
    export.set("dt", step, "s");
    export.write(
        "PhysX, force mode",
        "cpp",
        format!(
            "// A negative restitution is a stiffness.\n\
             material->setRestitution({:?}f);\n\
             material->setDamping({damping:?}f);\n\
             material->setFlag(physx::PxMaterialFlag::eCOMPLIANT_ACCELERATION_SPRING, false);\n\
             // In the loop:\n\
             scene->simulate({step:?}f);\n",
            -stiffness
        ),
    );
    export.write(
        "PhysX, acceleration mode",
        "cpp",
        format!(
            "// A negative restitution is a stiffness, here over the solver's effective mass.\n\
             material->setRestitution({:?}f);\n\
             material->setDamping({rate:?}f);\n\
             material->setFlag(physx::PxMaterialFlag::eCOMPLIANT_ACCELERATION_SPRING, true);\n\
             // In the loop:\n\
             scene->simulate({step:?}f);\n",
            -square
        ),
    );
    export.write(
        "Isaac Lab",
        "python",
        format!(
            "import isaaclab.sim as sim_utils\n\n\
             material = sim_utils.RigidBodyMaterialCfg(\n    restitution=0.0,\n    \
             compliant_contact_stiffness={stiffness:?},\n    compliant_contact_damping={damping:?},\n)\n\
             simulation = sim_utils.SimulationCfg(dt={step:?})\n"
        ),
    );
    export.assume(
        "Both materials have these values (two compliant materials are combined by the combine mode, average by \
         default), or the other is rigid: the compliant one then wins.",
    );
    export.assume(
        "Force mode; in acceleration mode PhysX multiplies by its own effective mass, and m̄ is not needed.",
    );
    export.assume(linear.implicit_words(step));
    export.assume("PhysX computes in single precision: expect 1e-3 at best, and less at very short steps.");
    export.assume("Not measured in PhysX: read in its source, and run in a model of its compliant contact.");
    Ok(export)
}

//! Table of SDFormat: every element with its treatment. Source: SDFormat 1.12 and 1.4 (`sdf/1.12/*.sdf`), and Drake's documentation of
//! its own elements.

use super::grammar::Treatment::{Refused, Silent, Warned};
use super::grammar::{ElementRule, several, single, unexamined, unread, value};

/// Elements in `<sdf>` and `<world>`. Models and includes are examined where they are used.
pub(crate) const IN_WORLD: &[ElementRule] = &[
    unexamined("world"),
    unexamined("model"),
    unexamined("include"),
    JOINT,
    FRAME,
    unread("population", Warned("<population> makes copies of a model; they are not read")),
    unread("state", Warned("the state of a world is not read: all models are as drawn")),
    unread("plugin", Silent),
    unread("audio", Silent),
    unread("wind", Silent),
    unread("gravity", Silent),
    unread("magnetic_field", Silent),
    unread("atmosphere", Silent),
    unread("gui", Silent),
    unread("physics", Silent),
    unread("scene", Silent),
    unread("light", Silent),
    unread("actor", Silent),
    unread("road", Silent),
    unread("spherical_coordinates", Silent),
];

const NO_LOOP_OF_DRAKE: &str = "constraints of Drake are not read, and the answer without this one would be wrong: write a <joint> (ball, \
     fixed) that closes the loop instead";

/// Elements in `<model>`.
pub(crate) const IN_MODEL: &[ElementRule] = &[
    value("static"),
    POSE,
    LINK,
    JOINT,
    FRAME,
    unexamined("model"),
    unexamined("include"),
    // `model.rs` warns about plugins that join links.
    unread("plugin", Silent),
    unread("self_collide", Silent),
    unread("allow_auto_disable", Silent),
    unread("enable_wind", Silent),
    unread("gripper", Silent),
    unread(
        "drake:joint",
        Refused("joints of Drake's own are not read, and the answer without this one would be wrong"),
    ),
    unread("drake:ball_constraint", Refused(NO_LOOP_OF_DRAKE)),
    unread("drake:distance_constraint", Warned(COMPLIANT)),
    unread("drake:tendon_constraint", Warned(COMPLIANT)),
    unread("drake:linear_bushing_rpy", Warned(COMPLIANT)),
    unread("drake:linear_spring_damper", Silent),
];

/// Reason of the warning about forces that simulators use to close loops.
const COMPLIANT: &str = "a finite stiffness closes no loop in an instantaneous impact; a loop that is closed by nothing else is open here";

const POSE: ElementRule = single("pose", &["relative_to", "frame", "degrees", "rotation_format"], &[]);
const FRAME: ElementRule = several("frame", &["name", "attached_to"], &[POSE]);

const LINK: ElementRule = several("link", &["name"], IN_LINK);

const IN_LINK: &[ElementRule] = &[
    POSE,
    single("inertial", &["auto"], IN_INERTIAL),
    several(
        "collision",
        &["name"],
        &[
            POSE,
            value("density"),
            unexamined("geometry"),
            unread("laser_retro", Silent),
            unread("max_contacts", Silent),
            unread("surface", Silent),
            unread("auto_inertia_params", Silent),
            unread("frame", Silent),
            unread("drake:proximity_properties", Silent),
        ],
    ),
    several(
        "visual",
        &["name"],
        &[
            POSE,
            unexamined("geometry"),
            unread("material", Silent),
            unread("cast_shadows", Silent),
            unread("laser_retro", Silent),
            unread("transparency", Silent),
            unread("visibility_flags", Silent),
            unread("meta", Silent),
            unread("plugin", Silent),
            unread("frame", Silent),
        ],
    ),
    unread(
        "kinematic",
        Warned("a kinematic link is moved by script; here it moves with its joints. Lock a joint to hold it"),
    ),
    unread("gravity", Silent),
    unread("enable_wind", Silent),
    unread("self_collide", Silent),
    unread("must_be_base_link", Silent),
    unread("velocity_decay", Silent),
    unread("sensor", Silent),
    unread("projector", Silent),
    unread("audio_sink", Silent),
    unread("audio_source", Silent),
    unread("battery", Silent),
    unread("light", Silent),
    unread("particle_emitter", Silent),
    unread("plugin", Silent),
    unread("frame", Silent),
];

const IN_INERTIAL: &[ElementRule] = &[
    value("mass"),
    value("density"),
    POSE,
    single(
        "inertia",
        &[],
        &[value("ixx"), value("ixy"), value("ixz"), value("iyy"), value("iyz"), value("izz")],
    ),
    unread(
        "fluid_added_mass",
        Refused(
            "the added mass of a fluid is not read, and the answer without it would be wrong; remove the element to get the \
                 effective mass in air",
        ),
    ),
    unread("auto_inertia_params", Silent),
    unread("frame", Silent),
];

const JOINT: ElementRule = several("joint", &["name", "type"], IN_JOINT);

const IN_JOINT: &[ElementRule] = &[
    value("parent"),
    value("child"),
    POSE,
    single("axis", &[], IN_AXIS),
    single("axis2", &[], IN_AXIS),
    value("thread_pitch"),
    value("screw_thread_pitch"),
    value("gearbox_ratio"),
    value("gearbox_reference_body"),
    // The joints read `physics/simbody/must_be_loop_joint`.
    unread("physics", Silent),
    unread("sensor", Silent),
    unread("frame", Silent),
    unread("plugin", Silent),
    value("drake:rotor_inertia"),
    value("drake:gear_ratio"),
    single("drake:mimic", &["joint", "multiplier", "offset"], &[]),
    unread("drake:controller_gains", Silent),
];

const IN_AXIS: &[ElementRule] = &[
    single("xyz", &["expressed_in"], &[]),
    value("use_parent_model_frame"),
    single(
        "limit",
        &[],
        &[
            value("lower"),
            value("upper"),
            unread("effort", Silent),
            unread("velocity", Silent),
            unread("stiffness", Silent),
            unread("dissipation", Silent),
            unread("drake:acceleration", Silent),
        ],
    ),
    single("mimic", &["joint", "axis"], &[value("multiplier"), value("offset"), value("reference")]),
    unread("dynamics", Silent),
    unread("initial_position", Silent),
];

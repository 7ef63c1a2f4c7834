//! Table of SDFormat: every element with its treatment. Source: SDFormat 1.12 and 1.4 (`sdf/1.12/*.sdf`), and Drake's documentation of
//! its own elements.

use crate::reading::document::grammar::Treatment::{Read, Silent, Unexamined};
use crate::reading::document::grammar::{COMPLIANT, ElementRule, element, refused, unread, warned};

/// Elements in `<sdf>` and `<world>`. Models and includes are examined where they are used.
pub(crate) const IN_WORLD: &[ElementRule] = &[
    unread("world model include", Unexamined),
    JOINT,
    FRAME,
    warned("population", "<population> makes copies of a model; they are not read"),
    warned("state", "the state of a world is not read: all models are as drawn"),
    unread(
        "plugin audio wind gravity magnetic_field atmosphere gui physics scene light actor road spherical_coordinates",
        Silent,
    ),
];

/// Elements in `<model>`.
pub(crate) const IN_MODEL: &[ElementRule] = &[
    value("static"),
    POSE,
    element("link", &[("name", Read)], IN_LINK),
    JOINT,
    FRAME,
    unread("model include", Unexamined),
    // `walk.rs` warns about plugins that join links.
    unread("plugin self_collide allow_auto_disable enable_wind gripper", Silent),
    refused(
        "drake:joint",
        "joints of Drake's own are not read, and the answer without this one would be wrong",
    ),
    refused(
        "drake:ball_constraint",
        "constraints of Drake are not read, and the answer without this one would be wrong: write a <joint> (ball, \
             fixed) that closes the loop instead",
    ),
    unread("drake:distance_constraint drake:tendon_constraint drake:linear_bushing_rpy", COMPLIANT),
    unread("drake:linear_spring_damper drake:collision_filter_group", Silent),
];

/// Elements with a value as text; a parent may have one of each.
const fn value(tags: &'static str) -> ElementRule {
    element(tags, &[], &[]).single()
}

const POSE: ElementRule =
    element("pose", &[("relative_to frame degrees rotation_format", Read)], &[]).single();
const FRAME: ElementRule = element("frame", &[("name attached_to", Read)], &[POSE]);

const IN_LINK: &[ElementRule] = &[
    POSE,
    element("inertial", &[("auto", Read)], IN_INERTIAL).single(),
    element(
        "collision",
        &[("name", Read)],
        &[
            POSE,
            value("density"),
            unread("geometry", Unexamined),
            unread(
                "laser_retro max_contacts surface auto_inertia_params frame drake:proximity_properties",
                Silent,
            ),
        ],
    ),
    element(
        "visual",
        &[("name", Read)],
        &[
            POSE,
            unread("geometry", Unexamined),
            unread(
                "material cast_shadows laser_retro transparency visibility_flags meta plugin frame \
                 drake:perception_properties drake:illustration_properties drake:accepting_renderer drake:diffuse_map",
                Silent,
            ),
        ],
    ),
    warned(
        "kinematic",
        "a kinematic link is moved by script; here it moves with its joints. Lock a joint to hold it",
    ),
    unread(
        "gravity enable_wind self_collide must_be_base_link velocity_decay sensor projector audio_sink audio_source \
         battery light particle_emitter plugin frame",
        Silent,
    ),
];

const IN_INERTIAL: &[ElementRule] = &[
    value("mass density"),
    POSE,
    element("inertia", &[], &[value("ixx ixy ixz iyy iyz izz")]).single(),
    refused(
        "fluid_added_mass",
        "the added mass of a fluid is not read, and the answer without it would be wrong; remove the element to get the \
                 effective mass in air",
    ),
    unread("auto_inertia_params frame", Silent),
];

const JOINT: ElementRule = element("joint", &[("name type", Read)], IN_JOINT);

const IN_JOINT: &[ElementRule] = &[
    value("parent child"),
    POSE,
    element("axis axis2", &[], IN_AXIS).single(),
    value("thread_pitch screw_thread_pitch gearbox_ratio gearbox_reference_body"),
    // The joints read `physics/simbody/must_be_loop_joint`.
    unread("physics sensor frame plugin", Silent),
    value("drake:rotor_inertia drake:gear_ratio"),
    element("drake:mimic", &[("joint multiplier offset", Read)], &[]).single(),
    unread("drake:controller_gains", Silent),
];

const IN_AXIS: &[ElementRule] = &[
    element("xyz", &[("expressed_in", Read)], &[]).single(),
    value("use_parent_model_frame"),
    element(
        "limit",
        &[],
        &[value("lower upper"), unread("effort velocity stiffness dissipation drake:acceleration", Silent)],
    )
    .single(),
    element("mimic", &[("joint axis", Read)], &[value("multiplier offset reference")]).single(),
    element(
        "dynamics",
        &[],
        &[value("damping spring_stiffness spring_reference"), unread("friction", Silent)],
    )
    .single(),
    value("initial_position"),
];

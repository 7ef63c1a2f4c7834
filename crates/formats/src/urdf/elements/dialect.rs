//! Table of the dialect: every element and attribute with its treatment.

use Use::{Noted, Read, Refused, Silent, Warned};

/// Treatment of an element or attribute.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Use {
    /// Part of the mechanism.
    Read,
    /// Ignored without a message: no effect on the mechanics.
    Silent,
    /// Ignored with a note; the text gives the reason.
    Noted(&'static str),
    /// Ignored with a warning; the text gives the reason.
    Warned(&'static str),
    /// Not supported, and the result without this entry would be wrong: an error with this code and message.
    Refused(&'static str, &'static str),
}

/// Element of the table.
pub(crate) struct Element {
    /// Tag; elements of Drake's namespace have the prefix `drake:`.
    pub name: &'static str,
    /// Treatment.
    pub usage: Use,
    /// True if a parent may have at most one such element.
    pub single: bool,
    /// Attributes; attributes in a namespace are ignored.
    pub attributes: &'static [(&'static str, Use)],
    /// Child elements. Only children of elements with the treatment `Read` are examined.
    pub children: &'static [Element],
}

/// Element that is read; a parent may have several.
const fn read(
    name: &'static str,
    attributes: &'static [(&'static str, Use)],
    children: &'static [Element],
) -> Element {
    Element { name, usage: Read, single: false, attributes, children }
}

/// Element that is read, without children; a parent may have one.
const fn single(name: &'static str, attributes: &'static [(&'static str, Use)]) -> Element {
    Element { name, usage: Read, single: true, attributes, children: &[] }
}

/// Element with a treatment other than `Read`; attributes and children are not examined.
const fn unread(name: &'static str, usage: Use) -> Element {
    Element { name, usage, single: false, attributes: &[], children: &[] }
}

/// Treatment of an origin at a position that belongs to the other notation of loops.
const MISPLACED: Use = Refused(
    "misplaced-origin",
    "this does not belong here, and the loop frame without it would be wrong: <predecessor> and <successor> hold \
     an <origin>, <link1> and <link2> have xyz and rpy themselves",
);

/// Treatment of limits of a joint that closes a loop: the limits are ignored with a note.
const UNCHECKED_LIMIT: Use = Noted("what closes a loop has no limits; ignored, limit a joint of the tree");

/// Treatment of constraints in the notation of other programs: an error that names the replacement.
macro_rules! write_instead {
    ($write:literal) => {
        Refused(
            "loop-unsupported",
            concat!("this is not read, and the answer without it would be wrong: write ", $write, " instead"),
        )
    };
}

/// Root element.
pub(crate) const ROBOT: Element = Element {
    name: "robot",
    usage: Read,
    single: true,
    attributes: &[("name", Read), ("version", Read), ("type", Silent)],
    children: IN_ROBOT,
};

const IN_ROBOT: &[Element] = &[
    read("link", &[("name", Read), ("type", Silent)], IN_LINK),
    read(
        "joint",
        // `independent` recommends driving coordinates; the effective mass does not depend on them.
        &[("name", Read), ("type", Read), ("independent", Read), ("dont_collapse", Silent)],
        IN_JOINT,
    ),
    // armature.rs searches transmissions for Drake's rotor inertias.
    unread("transmission", Silent),
    // Joints in a `<gazebo>` close loops: GAZEBO_JOINT.
    unread("gazebo", Silent),
    unread("material", Silent),
    unread("sensor", Silent),
    unread("ros2_control", Silent),
    // survey.rs searches `<mujoco>` for equality constraints.
    unread("mujoco", Silent),
    unread("group", Silent),
    unread("frame", Silent),
    unread("capability", Silent),
    unread("self_collision_checking", Silent),
    read("loop", &[("name", Read), ("type", Read)], IN_LOOP),
    read("loop_joint", &[("name", Read), ("type", Read)], IN_LOOP_JOINT),
    read("coupling", &[("name", Read), ("type", Read)], IN_COUPLING),
    read("contact", &[("name", Read), ("type", Read)], IN_CONTACT),
    unread("constraint", write_instead!("a <loop> or a <coupling>")),
    unread(
        "drake:joint",
        Refused(
            "unsupported",
            "joints of Drake's own are not read, and the answer without this one would be wrong",
        ),
    ),
    unread("drake:ball_constraint", write_instead!("<loop type=\"spherical\">")),
    unread("drake:distance_constraint", write_instead!("<loop type=\"distance\">")),
    unread("drake:weld_constraint", write_instead!("<loop type=\"fixed\">")),
    unread("drake:coupler_constraint", write_instead!("a <coupling>, or a <mimic> in the joint,")),
];

const ORIGIN: Element = single("origin", &[("xyz", Read), ("rpy", Read), ("quat_xyzw", Read)]);

/// Element that is read; a parent may have one.
const fn single_with_children(
    name: &'static str,
    attributes: &'static [(&'static str, Use)],
    children: &'static [Element],
) -> Element {
    Element { name, usage: Read, single: true, attributes, children }
}

/// Attributes of the end of a `<loop>`: the frame is given by an `<origin>`.
const LOOP_END: &[(&str, Use)] =
    &[("link", Read), ("xyz", MISPLACED), ("rpy", MISPLACED), ("quat_xyzw", MISPLACED)];

const IN_LOOP: &[Element] = &[
    single_with_children("predecessor", LOOP_END, &[ORIGIN]),
    single_with_children("successor", LOOP_END, &[ORIGIN]),
    single("axis", &[("xyz", Read)]),
    single("axis2", &[("xyz", Read)]),
    single("distance", &[("value", Read)]),
    unread("origin", MISPLACED),
    unread("predecessor_origin", MISPLACED),
    unread("successor_origin", MISPLACED),
    unread("limit", UNCHECKED_LIMIT),
    // Damping and friction are finite forces: no effect on an instantaneous impact.
    unread("dynamics", Silent),
];

/// Attributes of the end of a `<loop_joint>`: they give the frame themselves.
const LOOP_JOINT_END: &[(&str, Use)] = &[("link", Read), ("xyz", Read), ("rpy", Read), ("quat_xyzw", Read)];

const IN_LOOP_JOINT: &[Element] = &[
    single_with_children("link1", LOOP_JOINT_END, &[unread("origin", MISPLACED)]),
    single_with_children("link2", LOOP_JOINT_END, &[unread("origin", MISPLACED)]),
    single("axis", &[("xyz", Read)]),
    single("axis2", &[("xyz", Read)]),
    single("distance", &[("value", Read)]),
    unread("origin", MISPLACED),
    unread("limit", UNCHECKED_LIMIT),
    unread("dynamics", Silent),
];

const IN_COUPLING: &[Element] = &[
    // A ratio between rates needs no position on the links.
    single_with_children("predecessor", &[("link", Read)], &[unread("origin", Silent)]),
    single_with_children("successor", &[("link", Read)], &[unread("origin", Silent)]),
    single("ratio", &[("value", Read)]),
    // Both axes are joint axes.
    unread("axis", Silent),
];

const IN_CONTACT: &[Element] = &[
    single("body", &[("link", Read), ("xyz", Read)]),
    single("other", &[("link", Read)]),
    single("normal", &[("xyz", Read)]),
    single("toward", &[("xyz", Read)]),
    single("away", &[("xyz", Read)]),
    single("gap", &[("value", Read)]),
];

const IN_LINK: &[Element] = &[
    Element { name: "inertial", usage: Read, single: true, attributes: &[], children: IN_INERTIAL },
    // geometry.rs reads the size of the shape.
    unread("visual", Silent),
    unread("collision", Silent),
    unread(
        "origin",
        Warned("a link has no origin of its own in URDF (its joint and its <inertial> have); ignored"),
    ),
    unread("sensor", Silent),
    unread("gazebo", Silent),
    unread("material", Silent),
    unread("contact", Silent),
    unread("surface", Silent),
    unread("gravity", Silent),
    unread("self_filter", Silent),
    unread("collision_checking", Silent),
    unread("self_collision_checking", Silent),
    unread("collision_bullet", Silent),
    unread("verbose", Silent),
    unread(
        "kinematic",
        Noted(
            "\"kinematic\" is a simulator's word for a body moved by script; ignored, lock its joint to hold it",
        ),
    ),
];

const IN_INERTIAL: &[Element] = &[
    ORIGIN,
    single("mass", &[("value", Read)]),
    single(
        "inertia",
        &[("ixx", Read), ("ixy", Read), ("ixz", Read), ("iyy", Read), ("iyz", Read), ("izz", Read)],
    ),
];

const IN_JOINT: &[Element] = &[
    ORIGIN,
    single("parent", &[("link", Read)]),
    single("child", &[("link", Read)]),
    single("axis", &[("xyz", Read)]),
    single(
        "limit",
        &[
            ("lower", Read),
            ("upper", Read),
            ("effort", Silent),
            ("velocity", Silent),
            ("acceleration", Silent),
            ("deceleration", Silent),
            ("jerk", Silent),
            ("stiffness", Silent),
            ("current", Silent),
            ("command_effort", Silent),
            ("gear_velocity", Silent),
        ],
    ),
    // Friction, damping and springs are finite forces: no work in an instantaneous impact.
    single(
        "dynamics",
        &[
            ("armature", Read),
            ("damping", Silent),
            ("friction", Silent),
            ("stiffness", Silent),
            ("spring_stiffness", Silent),
            ("spring_reference", Silent),
            ("mu_coulomb", Silent),
            ("mu_viscous", Silent),
            ("K", Silent),
            ("D", Silent),
        ],
    ),
    single("mimic", &[("joint", Read), ("multiplier", Read), ("offset", Read)]),
    read("actuator", &[("name", Silent)], IN_ACTUATOR),
    single("drake:rotor_inertia", &[("value", Read)]),
    single("drake:gear_ratio", &[("value", Read)]),
    unread("calibration", Silent),
    unread("safety_controller", Silent),
    unread("hardwareInterface", Silent),
    unread("joint_properties", Silent),
    unread("physics", Silent),
    unread("sensor", Silent),
    unread("gazebo", Silent),
];

/// SDF `<joint>` in a `<gazebo>` of the robot. `gazebo_joint.rs` reads the values, which are element texts and
/// frames.
pub(crate) const GAZEBO_JOINT: Element = read("joint", &[("name", Read), ("type", Read)], IN_GAZEBO_JOINT);

/// Element whose content is text; a parent may have one.
const fn single_text(name: &'static str) -> Element {
    Element { name, usage: Silent, single: true, attributes: &[], children: &[] }
}

const IN_GAZEBO_JOINT: &[Element] = &[
    single_text("pose"),
    single_text("parent"),
    single_text("child"),
    single_with_children("axis", &[], IN_GAZEBO_AXIS),
    single_with_children("axis2", &[], IN_GAZEBO_AXIS),
    unread("physics", Silent),
    unread("sensor", Silent),
];

const IN_GAZEBO_AXIS: &[Element] = &[
    single_text("xyz"),
    single_text("use_parent_model_frame"),
    unread("limit", UNCHECKED_LIMIT),
    unread("dynamics", Silent),
    unread("initial_position", Silent),
    unread("mimic", write_instead!("a <coupling>, or a <mimic> in a joint of the tree,")),
];

const IN_ACTUATOR: &[Element] = &[
    single("drake:rotor_inertia", &[("value", Read)]),
    single("drake:gear_ratio", &[("value", Read)]),
    unread("hardwareInterface", Silent),
    unread("mechanicalReduction", Silent),
];

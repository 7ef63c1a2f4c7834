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

const fn read(
    name: &'static str,
    attributes: &'static [(&'static str, Use)],
    children: &'static [Element],
) -> Element {
    Element { name, usage: Read, single: false, attributes, children }
}

const fn single(name: &'static str, attributes: &'static [(&'static str, Use)]) -> Element {
    Element { name, usage: Read, single: true, attributes, children: &[] }
}

const fn other(name: &'static str, usage: Use) -> Element {
    Element { name, usage, single: false, attributes: &[], children: &[] }
}

/// Treatment of an origin at a position that belongs to the other notation of loops.
const MISPLACED: Use = Refused(
    "misplaced-origin",
    "this does not belong here, and the loop frame without it would be wrong: <predecessor> and <successor> hold \
     an <origin>, <link1> and <link2> have xyz and rpy themselves",
);

const UNWATCHED: Use = Noted("what closes a loop has no limits; ignored, limit a joint of the tree");

/// Treatment of constraints in other languages: an error that names the replacement.
macro_rules! instead {
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
    other("transmission", Silent),
    // Joints in a `<gazebo>` close loops: GAZEBO_JOINT.
    other("gazebo", Silent),
    other("material", Silent),
    other("sensor", Silent),
    other("ros2_control", Silent),
    // survey.rs searches `<mujoco>` for equality constraints.
    other("mujoco", Silent),
    other("group", Silent),
    other("frame", Silent),
    other("capability", Silent),
    other("self_collision_checking", Silent),
    read("loop", &[("name", Read), ("type", Read)], IN_LOOP),
    read("loop_joint", &[("name", Read), ("type", Read)], IN_LOOP_JOINT),
    read("coupling", &[("name", Read), ("type", Read)], IN_COUPLING),
    other("constraint", instead!("a <loop> or a <coupling>")),
    other(
        "drake:joint",
        Refused(
            "unsupported",
            "joints of Drake's own are not read, and the answer without this one would be wrong",
        ),
    ),
    other("drake:ball_constraint", instead!("<loop type=\"spherical\">")),
    other("drake:distance_constraint", instead!("<loop type=\"distance\">")),
    other("drake:weld_constraint", instead!("<loop type=\"fixed\">")),
    other("drake:coupler_constraint", instead!("a <coupling>, or a <mimic> in the joint,")),
];

const ORIGIN: Element = single("origin", &[("xyz", Read), ("rpy", Read), ("quat_xyzw", Read)]);

const fn one(
    name: &'static str,
    attributes: &'static [(&'static str, Use)],
    children: &'static [Element],
) -> Element {
    Element { name, usage: Read, single: true, attributes, children }
}

const HOLDS: &[(&str, Use)] =
    &[("link", Read), ("xyz", MISPLACED), ("rpy", MISPLACED), ("quat_xyzw", MISPLACED)];

const IN_LOOP: &[Element] = &[
    one("predecessor", HOLDS, &[ORIGIN]),
    one("successor", HOLDS, &[ORIGIN]),
    single("axis", &[("xyz", Read)]),
    single("axis2", &[("xyz", Read)]),
    single("distance", &[("value", Read)]),
    other("origin", MISPLACED),
    other("predecessor_origin", MISPLACED),
    other("successor_origin", MISPLACED),
    other("limit", UNWATCHED),
    // Damping and friction are finite forces: no effect on an instantaneous impact.
    other("dynamics", Silent),
];

const PLACED: &[(&str, Use)] = &[("link", Read), ("xyz", Read), ("rpy", Read), ("quat_xyzw", Read)];

const IN_LOOP_JOINT: &[Element] = &[
    one("link1", PLACED, &[other("origin", MISPLACED)]),
    one("link2", PLACED, &[other("origin", MISPLACED)]),
    single("axis", &[("xyz", Read)]),
    single("axis2", &[("xyz", Read)]),
    single("distance", &[("value", Read)]),
    other("origin", MISPLACED),
    other("limit", UNWATCHED),
    other("dynamics", Silent),
];

const IN_COUPLING: &[Element] = &[
    // A ratio between rates needs no position on the links.
    one("predecessor", &[("link", Read)], &[other("origin", Silent)]),
    one("successor", &[("link", Read)], &[other("origin", Silent)]),
    single("ratio", &[("value", Read)]),
    // Both axes are joint axes.
    other("axis", Silent),
];

const IN_LINK: &[Element] = &[
    Element { name: "inertial", usage: Read, single: true, attributes: &[], children: IN_INERTIAL },
    // geometry.rs reads the size of the shape.
    other("visual", Silent),
    other("collision", Silent),
    other(
        "origin",
        Warned("a link has no origin of its own in URDF (its joint and its <inertial> have); ignored"),
    ),
    other("sensor", Silent),
    other("gazebo", Silent),
    other("material", Silent),
    other("contact", Silent),
    other("surface", Silent),
    other("gravity", Silent),
    other("self_filter", Silent),
    other("collision_checking", Silent),
    other("self_collision_checking", Silent),
    other("collision_bullet", Silent),
    other("verbose", Silent),
    other(
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
    other("calibration", Silent),
    other("safety_controller", Silent),
    other("hardwareInterface", Silent),
    other("joint_properties", Silent),
    other("physics", Silent),
    other("sensor", Silent),
    other("gazebo", Silent),
];

/// SDF `<joint>` in a `<gazebo>` of the robot. `gazebo_joint.rs` reads the values, which are element texts and
/// frames.
pub(crate) const GAZEBO_JOINT: Element = read("joint", &[("name", Read), ("type", Read)], IN_GAZEBO_JOINT);

const fn text(name: &'static str) -> Element {
    Element { name, usage: Silent, single: true, attributes: &[], children: &[] }
}

const IN_GAZEBO_JOINT: &[Element] = &[
    text("pose"),
    text("parent"),
    text("child"),
    one("axis", &[], IN_GAZEBO_AXIS),
    one("axis2", &[], IN_GAZEBO_AXIS),
    other("physics", Silent),
    other("sensor", Silent),
];

const IN_GAZEBO_AXIS: &[Element] = &[
    text("xyz"),
    text("use_parent_model_frame"),
    other("limit", UNWATCHED),
    other("dynamics", Silent),
    other("initial_position", Silent),
    other("mimic", instead!("a <coupling>, or a <mimic> in a joint of the tree,")),
];

const IN_ACTUATOR: &[Element] = &[
    single("drake:rotor_inertia", &[("value", Read)]),
    single("drake:gear_ratio", &[("value", Read)]),
    other("hardwareInterface", Silent),
    other("mechanicalReduction", Silent),
];

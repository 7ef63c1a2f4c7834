//! Table of the dialect: every element and attribute with its treatment.

use Treatment::{Noted, Read, Refused, Silent, Warned};

/// Treatment of an element or attribute.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Treatment {
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

/// Entry of the table: an element with its attributes and children.
pub(crate) struct ElementRule {
    /// Tag; elements of Drake's namespace have the prefix `drake:`.
    pub name: &'static str,
    /// Treatment.
    pub treatment: Treatment,
    /// True if a parent may have at most one such element.
    pub single: bool,
    /// Attributes; attributes in a namespace are ignored.
    pub attributes: &'static [(&'static str, Treatment)],
    /// Child elements. Only children of elements with the treatment `Read` are examined.
    pub children: &'static [ElementRule],
}

/// Element that is read; a parent may have several.
const fn element(
    name: &'static str,
    attributes: &'static [(&'static str, Treatment)],
    children: &'static [ElementRule],
) -> ElementRule {
    ElementRule { name, treatment: Read, single: false, attributes, children }
}

/// Element that is read, without children; a parent may have one.
const fn single_element(name: &'static str, attributes: &'static [(&'static str, Treatment)]) -> ElementRule {
    ElementRule { name, treatment: Read, single: true, attributes, children: &[] }
}

/// Element with a treatment other than `Read`; attributes and children are not examined.
const fn unread_element(name: &'static str, treatment: Treatment) -> ElementRule {
    ElementRule { name, treatment, single: false, attributes: &[], children: &[] }
}

/// Treatment of an origin at a position that belongs to the other notation of loops.
const MISPLACED: Treatment = Refused(
    "misplaced-origin",
    "this does not belong here, and the loop frame without it would be wrong: <predecessor> and <successor> hold \
     an <origin>, <link1> and <link2> have xyz and rpy themselves",
);

/// Treatment of limits of a joint that closes a loop: the limits are ignored with a note.
const UNCHECKED_LIMIT: Treatment =
    Noted("what closes a loop has no limits; ignored, limit a joint of the tree");

/// Treatment of constraints in the notation of other programs: an error that names the replacement.
macro_rules! write_instead {
    ($write:literal) => {
        Refused(
            "loop-unsupported",
            concat!("this is not read, and the answer without it would be wrong: write ", $write, " instead"),
        )
    };
}

/// Treatment of forces by which Drake holds loops together.
const COMPLIANT: Treatment = Warned(
    "a finite stiffness closes no loop in an instantaneous impact; a loop that is closed by nothing else is open here",
);

/// Root element.
pub(crate) const ROBOT: ElementRule = ElementRule {
    name: "robot",
    treatment: Read,
    single: true,
    attributes: &[("name", Read), ("version", Read), ("type", Silent)],
    children: IN_ROBOT,
};

const IN_ROBOT: &[ElementRule] = &[
    element("link", &[("name", Read), ("type", Silent)], IN_LINK),
    element(
        "joint",
        // `independent` recommends driving coordinates; the effective mass does not depend on them.
        &[("name", Read), ("type", Read), ("independent", Read), ("dont_collapse", Silent)],
        IN_JOINT,
    ),
    // armature.rs searches transmissions for Drake's rotor inertias.
    unread_element("transmission", Silent),
    // Joints in a `<gazebo>` close loops: GAZEBO_JOINT.
    unread_element("gazebo", Silent),
    unread_element("material", Silent),
    unread_element("sensor", Silent),
    unread_element("ros2_control", Silent),
    // survey.rs searches `<mujoco>` for equality constraints.
    unread_element("mujoco", Silent),
    unread_element("group", Silent),
    unread_element("frame", Silent),
    unread_element("capability", Silent),
    unread_element("self_collision_checking", Silent),
    element("loop", &[("name", Read), ("type", Read)], IN_LOOP),
    element("loop_joint", &[("name", Read), ("type", Read)], IN_LOOP_JOINT),
    element("coupling", &[("name", Read), ("type", Read)], IN_COUPLING),
    element("relation", &[("name", Read)], IN_RELATION),
    element("contact", &[("name", Read), ("type", Read)], IN_CONTACT),
    unread_element("constraint", write_instead!("a <loop> or a <coupling>")),
    unread_element(
        "drake:joint",
        Refused(
            "unsupported",
            "joints of Drake's own are not read, and the answer without this one would be wrong",
        ),
    ),
    unread_element("drake:ball_constraint", write_instead!("<loop type=\"spherical\">")),
    // Springs and bushings are finite forces: no work in an instantaneous impact.
    unread_element("drake:distance_constraint", COMPLIANT),
    unread_element("drake:tendon_constraint", COMPLIANT),
    unread_element("drake:linear_bushing_rpy", COMPLIANT),
    unread_element("drake:linear_spring_damper", Silent),
    unread_element("drake:weld_constraint", write_instead!("<loop type=\"fixed\">")),
    unread_element("drake:coupler_constraint", write_instead!("a <coupling>, or a <mimic> in the joint,")),
];

const ORIGIN: ElementRule = single_element("origin", &[("xyz", Read), ("rpy", Read), ("quat_xyzw", Read)]);

/// Element that is read; a parent may have one.
const fn single_element_with_children(
    name: &'static str,
    attributes: &'static [(&'static str, Treatment)],
    children: &'static [ElementRule],
) -> ElementRule {
    ElementRule { name, treatment: Read, single: true, attributes, children }
}

/// Attributes of the end of a `<loop>`: the frame is given by an `<origin>`.
const LOOP_END: &[(&str, Treatment)] =
    &[("link", Read), ("xyz", MISPLACED), ("rpy", MISPLACED), ("quat_xyzw", MISPLACED)];

const IN_LOOP: &[ElementRule] = &[
    single_element_with_children("predecessor", LOOP_END, &[ORIGIN]),
    single_element_with_children("successor", LOOP_END, &[ORIGIN]),
    single_element("axis", &[("xyz", Read)]),
    single_element("axis2", &[("xyz", Read)]),
    single_element("distance", &[("value", Read)]),
    unread_element("origin", MISPLACED),
    unread_element("predecessor_origin", MISPLACED),
    unread_element("successor_origin", MISPLACED),
    unread_element("limit", UNCHECKED_LIMIT),
    // Damping and friction are finite forces: no effect on an instantaneous impact.
    unread_element("dynamics", Silent),
];

/// Attributes of the end of a `<loop_joint>`: they give the frame themselves.
const LOOP_JOINT_END: &[(&str, Treatment)] =
    &[("link", Read), ("xyz", Read), ("rpy", Read), ("quat_xyzw", Read)];

const IN_LOOP_JOINT: &[ElementRule] = &[
    single_element_with_children("link1", LOOP_JOINT_END, &[unread_element("origin", MISPLACED)]),
    single_element_with_children("link2", LOOP_JOINT_END, &[unread_element("origin", MISPLACED)]),
    single_element("axis", &[("xyz", Read)]),
    single_element("axis2", &[("xyz", Read)]),
    single_element("distance", &[("value", Read)]),
    unread_element("origin", MISPLACED),
    unread_element("limit", UNCHECKED_LIMIT),
    unread_element("dynamics", Silent),
];

const IN_COUPLING: &[ElementRule] = &[
    // A ratio between rates needs no position on the links.
    single_element_with_children("predecessor", &[("link", Read)], &[unread_element("origin", Silent)]),
    single_element_with_children("successor", &[("link", Read)], &[unread_element("origin", Silent)]),
    single_element("ratio", &[("value", Read)]),
    // Both axes are joint axes.
    unread_element("axis", Silent),
];

const IN_RELATION: &[ElementRule] = &[
    element("joint", RELATED_JOINT, &[]),
    single_element("constant", &[("value", Read)]),
    single_element_with_children(
        "curve",
        &[("offset", Read), ("coefficients", Read)],
        &[element("joint", RELATED_JOINT, &[])],
    ),
];

const RELATED_JOINT: &[(&str, Treatment)] = &[("name", Read), ("factor", Read)];

const IN_CONTACT: &[ElementRule] = &[
    single_element("body", &[("link", Read), ("xyz", Read)]),
    single_element("other", &[("link", Read)]),
    single_element("normal", &[("xyz", Read)]),
    single_element("toward", &[("xyz", Read)]),
    single_element("away", &[("xyz", Read)]),
    single_element("gap", &[("value", Read)]),
];

const IN_LINK: &[ElementRule] = &[
    ElementRule { name: "inertial", treatment: Read, single: true, attributes: &[], children: IN_INERTIAL },
    // `geometry.rs` and `shape.rs` read the shapes; `survey.rs` lists the other children.
    unread_element("visual", Silent),
    unread_element("collision", Silent),
    unread_element(
        "origin",
        Warned("a link has no origin of its own in URDF (its joint and its <inertial> have); ignored"),
    ),
    unread_element("sensor", Silent),
    unread_element("gazebo", Silent),
    unread_element("material", Silent),
    unread_element("contact", Silent),
    unread_element("surface", Silent),
    unread_element("gravity", Silent),
    unread_element("self_filter", Silent),
    unread_element("collision_checking", Silent),
    unread_element("self_collision_checking", Silent),
    unread_element("collision_bullet", Silent),
    unread_element("verbose", Silent),
    unread_element(
        "kinematic",
        Noted(
            "\"kinematic\" is a simulator's word for a body moved by script; ignored, lock its joint to hold it",
        ),
    ),
];

const IN_INERTIAL: &[ElementRule] = &[
    ORIGIN,
    single_element("mass", &[("value", Read)]),
    single_element(
        "inertia",
        &[("ixx", Read), ("ixy", Read), ("ixz", Read), ("iyy", Read), ("iyz", Read), ("izz", Read)],
    ),
];

const IN_JOINT: &[ElementRule] = &[
    ORIGIN,
    single_element("parent", &[("link", Read)]),
    single_element("child", &[("link", Read)]),
    single_element("axis", &[("xyz", Read)]),
    single_element(
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
    single_element(
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
    single_element("mimic", &[("joint", Read), ("multiplier", Read), ("offset", Read)]),
    element("actuator", &[("name", Silent)], IN_ACTUATOR),
    single_element("drake:rotor_inertia", &[("value", Read)]),
    single_element("drake:gear_ratio", &[("value", Read)]),
    unread_element("calibration", Silent),
    unread_element("safety_controller", Silent),
    unread_element("hardwareInterface", Silent),
    unread_element("joint_properties", Silent),
    unread_element("physics", Silent),
    unread_element("sensor", Silent),
    unread_element("gazebo", Silent),
];

/// SDF `<joint>` in a `<gazebo>` of the robot. `gazebo_joint.rs` reads the values, which are element texts and
/// frames.
pub(crate) const GAZEBO_JOINT: ElementRule =
    element("joint", &[("name", Read), ("type", Read)], IN_GAZEBO_JOINT);

/// Element whose content is text; a parent may have one.
const fn single_text_element(name: &'static str) -> ElementRule {
    ElementRule { name, treatment: Silent, single: true, attributes: &[], children: &[] }
}

const IN_GAZEBO_JOINT: &[ElementRule] = &[
    single_text_element("pose"),
    single_text_element("parent"),
    single_text_element("child"),
    single_element_with_children("axis", &[], IN_GAZEBO_AXIS),
    single_element_with_children("axis2", &[], IN_GAZEBO_AXIS),
    unread_element("physics", Silent),
    unread_element("sensor", Silent),
];

const IN_GAZEBO_AXIS: &[ElementRule] = &[
    single_text_element("xyz"),
    single_text_element("use_parent_model_frame"),
    unread_element("limit", UNCHECKED_LIMIT),
    unread_element("dynamics", Silent),
    unread_element("initial_position", Silent),
    unread_element("mimic", write_instead!("a <coupling>, or a <mimic> in a joint of the tree,")),
];

const IN_ACTUATOR: &[ElementRule] = &[
    single_element("drake:rotor_inertia", &[("value", Read)]),
    single_element("drake:gear_ratio", &[("value", Read)]),
    unread_element("hardwareInterface", Silent),
    unread_element("mechanicalReduction", Silent),
];

//! Table of the dialect: every element and attribute with its treatment.

use Treatment::{Noted, Read, Refused, Silent, Text, Warned, WarnedUnless};

/// Treatment of an element or attribute.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Treatment {
    /// Part of the mechanism.
    Read,
    /// Element whose text is a value of the mechanism; attributes and children are not examined.
    Text,
    /// Ignored without a message: no effect on the mechanics.
    Silent,
    /// Ignored with a note; the text gives the reason.
    Noted(&'static str),
    /// Ignored with a warning; the text gives the reason.
    Warned(&'static str),
    /// As `Warned`, but silent if the value has no effect: one of these words, or a number of at most 0.
    WarnedUnless(&'static [&'static str], &'static str),
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
    /// Names of further child elements, without effect on the mechanics, separated by blanks.
    pub silent: &'static str,
}

impl ElementRule {
    /// The rule with child elements that have no effect.
    const fn silent(self, silent: &'static str) -> Self {
        Self { silent, ..self }
    }
}

/// Element that is read; a parent may have several.
const fn element(
    name: &'static str,
    attributes: &'static [(&'static str, Treatment)],
    children: &'static [ElementRule],
) -> ElementRule {
    ElementRule { name, treatment: Read, single: false, attributes, children, silent: "" }
}

/// Element that is read, without children; a parent may have one.
const fn single_element(name: &'static str, attributes: &'static [(&'static str, Treatment)]) -> ElementRule {
    ElementRule { single: true, ..element(name, attributes, &[]) }
}

/// Element with a treatment other than `Read`; attributes and children are not examined.
const fn unread_element(name: &'static str, treatment: Treatment) -> ElementRule {
    ElementRule { treatment, ..element(name, &[], &[]) }
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
pub(crate) const ROBOT: ElementRule =
    element("robot", &[("name", Read), ("version", Read), ("type", Silent)], IN_ROBOT);

const IN_ROBOT: &[ElementRule] = &[
    element("link", &[("name", Read), ("type", Silent)], IN_LINK),
    element(
        "joint",
        // `independent` recommends driving coordinates; the effective mass does not depend on them.
        &[("name", Read), ("type", Read), ("independent", Read), ("dont_collapse", Silent)],
        IN_JOINT,
    ),
    TRANSMISSION,
    element("gazebo", &[("reference", Read), ("name", Silent)], IN_GAZEBO).silent(GAZEBO_SETTINGS),
    unread_element("material", Silent),
    unread_element("sensor", Silent),
    element("ros2_control", ROS2_CONTROL, IN_ROS2_CONTROL).silent("hardware sensor gpio async properties"),
    element("mujoco", &[], IN_MUJOCO)
        .silent("option size visual statistic asset contact sensor keyframe custom extension"),
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
    ElementRule { single: true, ..element(name, attributes, children) }
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
    single_element_with_children("inertial", &[], IN_INERTIAL),
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
    element("actuator", NAME_AND_ROLE, IN_ACTUATOR).silent(ACTUATOR_SETTINGS),
    single_element("drake:rotor_inertia", &[("value", Read)]),
    single_element("drake:gear_ratio", &[("value", Read)]),
    unread_element("calibration", Silent),
    unread_element("safety_controller", Silent),
    unread_element("hardwareInterface", Silent),
    unread_element("controller_gains", Silent),
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
    ElementRule { single: true, ..unread_element(name, Text) }
}

const IN_GAZEBO_JOINT: &[ElementRule] = &[
    single_text_element("pose"),
    single_text_element("parent"),
    single_text_element("child"),
    single_element_with_children("axis", &[], IN_GAZEBO_AXIS),
    single_element_with_children("axis2", &[], IN_GAZEBO_AXIS),
    single_text_element("thread_pitch"),
    single_text_element("screw_thread_pitch"),
    single_text_element("gearbox_ratio"),
    single_text_element("gearbox_reference_body"),
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

/// Child elements of a transmission and of its joint and actuator: those given, and the inertia and the ratio of a rotor.
macro_rules! with_rotor_data {
    ($($rule:expr),* $(,)?) => {
        &[
            $($rule,)*
            unread_element("motorInertia", Text),
            unread_element("motor_inertia", Text),
            unread_element("rotorInertia", Text),
            unread_element("rotor_inertia", Text),
            unread_element("mechanicalReduction", Text),
            unread_element("mechanical_reduction", Text),
            unread_element("gearRatio", Text),
            unread_element("gear_ratio", Text),
        ]
    };
}

const IN_ACTUATOR: &[ElementRule] = with_rotor_data![
    single_element("drake:rotor_inertia", &[("value", Read)]),
    single_element("drake:gear_ratio", &[("value", Read)]),
];

/// Transmission of ROS, of ros2_control and of the PR2. `transmission.rs` reads the rotor inertias.
const TRANSMISSION: ElementRule =
    element("transmission", &[("name", Silent), ("type", Read)], IN_TRANSMISSION)
        .silent(TRANSMISSION_SETTINGS);

const IN_TRANSMISSION: &[ElementRule] = with_rotor_data![
    unread_element("type", Text),
    unread_element("plugin", Text),
    element("joint", NAME_AND_ROLE, IN_ACTUATOR).silent(ACTUATOR_SETTINGS),
    element("actuator", NAME_AND_ROLE, IN_ACTUATOR).silent(ACTUATOR_SETTINGS),
];

const NAME_AND_ROLE: &[(&str, Treatment)] = &[
    ("name", Read),
    ("role", Silent),
    ("motorInertia", Read),
    ("rotorInertia", Read),
    ("mechanicalReduction", Read),
];

const ROS2_CONTROL: &[(&str, Treatment)] = &[
    ("name", Silent),
    ("type", Silent),
    ("rw_rate", Silent),
    ("is_async", Silent),
    ("thread_priority", Silent),
];

const IN_ROS2_CONTROL: &[ElementRule] = &[
    TRANSMISSION,
    element("joint", &[("name", Read), ("mimic", Read)], IN_CONTROLLED_JOINT)
        .silent("command_interface state_interface limits properties"),
];

const IN_CONTROLLED_JOINT: &[ElementRule] = &[
    // `joint_couplings.rs` reads the parameters of a mimic.
    unread_element("param", Text),
    unread_element("mimic", Text),
];

/// Treatment of settings by which MuJoCo changes the masses of a URDF; the words are the defaults.
macro_rules! changes_masses {
    ($($default:literal),*) => {
        WarnedUnless(
            &[$($default),*],
            "MuJoCo changes masses or inertias by this setting, and here it is not read: write the masses and inertias that MuJoCo uses \
             into the links, or convert the file to MJCF by MuJoCo and load that",
        )
    };
}

const IN_MUJOCO: &[ElementRule] = &[
    element(
        "compiler",
        &[
            ("inertiafromgeom", changes_masses!("false", "auto")),
            ("balanceinertia", changes_masses!("false")),
            ("boundmass", changes_masses!()),
            ("boundinertia", changes_masses!()),
            ("settotalmass", changes_masses!()),
            ("inertiagrouprange", Silent),
            ("exactmeshinertia", Silent),
            ("fusestatic", Silent),
            ("discardvisual", Silent),
            ("strippath", Silent),
            ("convexhull", Silent),
            ("meshdir", Silent),
            ("texturedir", Silent),
            ("assetdir", Silent),
            ("angle", Silent),
            ("eulerseq", Silent),
            ("coordinate", Silent),
            ("autolimits", Silent),
            ("fitaabb", Silent),
            ("usethread", Silent),
            ("saveinertial", Silent),
            ("alignfree", Silent),
            ("conflict", Silent),
        ],
        &[unread_element("lengthrange", Silent)],
    ),
    unread_element(
        "equality",
        Refused(
            "loop-unsupported",
            "MuJoCo's equality constraints are not read, and the answer without them would be wrong: write a <loop> \
             (for connect: spherical, for weld: fixed), or a <coupling> or <mimic> (for joint)",
        ),
    ),
    unread_element("tendon", OF_MUJOCO),
    unread_element("actuator", OF_MUJOCO),
    unread_element("default", OF_MUJOCO),
    unread_element("worldbody", OF_MUJOCO),
    unread_element("deformable", OF_MUJOCO),
];

const OF_MUJOCO: Treatment = Warned(
    "it is not read in a URDF, neither here nor by MuJoCo; bodies, couplings and armatures belong in <link>, <joint>, <mimic> and \
     <dynamics armature>, or load an MJCF",
);

/// Treatment of a body that Gazebo adds to the robot.
const ADDED_BODY: Treatment = Warned(
    "links and models inside <gazebo>, and joints to them, are not read: write them as <link> and <joint> of the robot",
);

/// Treatment of an inertia that does not replace that of the link.
const SECOND_INERTIA: Treatment =
    Warned("masses and inertias inside <gazebo> are not read: write them into the <inertial> of the link");

/// Settings of Gazebo for the robot, a link or a joint. Source: sdformat, `parser_urdf.cc`, and SDFormat 1.11.
const IN_GAZEBO: &[ElementRule] = &[
    // `check_gazebo_joints` examines the joints, `joint_couplings.rs` plugins and mimics, `transmission.rs` armatures.
    unread_element("joint", Text),
    unread_element("mimic", Text),
    unread_element("axis", Text),
    unread_element("armature", Text),
    unread_element("link", ADDED_BODY),
    unread_element("model", ADDED_BODY),
    unread_element("include", ADDED_BODY),
    unread_element("inertial", SECOND_INERTIA),
    unread_element("inertia", SECOND_INERTIA),
    unread_element("mass", SECOND_INERTIA),
    unread_element(
        "static",
        WarnedUnless(
            &["false", "False", ""],
            "a static model does not move in Gazebo; here its joints move: lock them to hold it",
        ),
    ),
    unread_element(
        "kinematic",
        WarnedUnless(
            &["false", "False", ""],
            "a kinematic link is moved by script; here it moves with its joints: lock its joint to hold it",
        ),
    ),
];

/// Settings of Gazebo for contacts, sensors, forces and looks.
const GAZEBO_SETTINGS: &str = "plugin material visual collision sensor light projector audio audio_sink audio_source battery \
    gripper particle_emitter gravity turnGravityOff selfCollide self_collide enable_wind mu mu1 mu2 \
    fdir1 slip1 slip2 kp kd minDepth min_depth maxVel max_vel maxContacts max_contacts laserRetro \
    laser_retro surface friction bounce contact physics ode dampingFactor velocity_decay \
    provideFeedback implicitSpringDamper springReference springStiffness fudgeFactor stopCfm stopErp \
    stopKp stopKd cfmDamping initialJointPosition initial_joint_position limit dynamics \
    preserveFixedJoint disableFixedJointLumping canonicalBody must_be_base_link allow_auto_disable \
    pose origin frame genTexCoord dontUseGravity robotNamespace param gui scene verbose";

const TRANSMISSION_SETTINGS: &str = "hardwareInterface robotNamespace api node param motorTorqueConstant motorVelocityConstant \
    compensator leftActuator rightActuator flexJoint rollJoint gap_joint passive_joint \
    simulated_actuated_joint use_simulated_gripper_joint";

const ACTUATOR_SETTINGS: &str =
    "hardwareInterface role api node offset param motorTorqueConstant motorVelocityConstant maxEffort";

//! Table of the dialect: every element and attribute with its treatment. Tags of Drake's namespace have the prefix `drake:`; attributes
//! in a namespace are ignored.

use crate::reading::document::grammar::Treatment::{
    Noted, Read, Refused, Silent, Unexamined, Unlisted, WarnedUnless,
};
use crate::reading::document::grammar::{
    Attributes, COMPLIANT, ElementRule, Treatment, element, refused, unread, warned,
};

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

/// Root element.
pub(crate) const ROBOT: ElementRule = element("robot", &[("name version", Read), ("type", Silent)], IN_ROBOT);

const IN_ROBOT: &[ElementRule] = &[
    element("link", &[("name", Read), ("type", Silent)], IN_LINK),
    // `independent` recommends driving coordinates; the effective mass does not depend on them.
    element("joint", &[("name type independent", Read), ("dont_collapse", Silent)], IN_JOINT),
    TRANSMISSION,
    element("gazebo", &[("reference", Read), ("name", Silent)], IN_GAZEBO),
    unread("material sensor", Silent),
    element("ros2_control", &[("name type rw_rate is_async thread_priority", Silent)], IN_ROS2_CONTROL),
    element("mujoco", &[], IN_MUJOCO),
    unread("group frame capability self_collision_checking", Silent),
    element("loop", &[("name type", Read)], IN_LOOP),
    element("loop_joint", &[("name type", Read)], IN_LOOP_JOINT),
    element("coupling", &[("name type", Read)], IN_COUPLING),
    element("relation", &[("name", Read)], IN_RELATION),
    element("contact", &[("name type", Read)], IN_CONTACT),
    element("bushing", &[("name parent child", Read)], IN_BUSHING),
    element("elastic", &[("joint stiffness damping", Read)], &[]),
    unread("constraint", write_instead!("a <loop> or a <coupling>")),
    refused(
        "drake:joint",
        "joints of Drake's own are not read, and the answer without this one would be wrong",
    ),
    unread("drake:ball_constraint", write_instead!("<loop type=\"spherical\">")),
    // Springs and bushings are finite forces: no work in an instantaneous impact.
    unread("drake:distance_constraint drake:tendon_constraint drake:linear_bushing_rpy", COMPLIANT),
    unread("drake:linear_spring_damper drake:collision_filter_group", Silent),
    unread("drake:weld_constraint", write_instead!("<loop type=\"fixed\">")),
    unread("drake:coupler_constraint", write_instead!("a <coupling>, or a <mimic> in the joint,")),
];

/// Element without children; a parent may have one.
const fn leaf(tags: &'static str, attributes: Attributes) -> ElementRule {
    element(tags, attributes, &[]).single()
}

const ORIGIN: ElementRule = leaf("origin", &[("xyz rpy quat_xyzw", Read)]);

const IN_LOOP: &[ElementRule] = &[
    // The frame of an end is given by an `<origin>`.
    element("predecessor successor", &[("link", Read), ("xyz rpy quat_xyzw", MISPLACED)], &[ORIGIN]).single(),
    leaf("axis axis2", &[("xyz", Read)]),
    leaf("distance", &[("value", Read)]),
    unread("origin predecessor_origin successor_origin", MISPLACED),
    unread("limit", UNCHECKED_LIMIT),
    // Damping and friction are finite forces: no effect on an instantaneous impact.
    unread("dynamics", Silent),
];

const IN_LOOP_JOINT: &[ElementRule] = &[
    // The attributes of an end give its frame.
    element("link1 link2", &[("link xyz rpy quat_xyzw", Read)], &[unread("origin", MISPLACED)]).single(),
    leaf("axis axis2", &[("xyz", Read)]),
    leaf("distance", &[("value", Read)]),
    unread("origin", MISPLACED),
    unread("limit", UNCHECKED_LIMIT),
    unread("dynamics", Silent),
];

const IN_COUPLING: &[ElementRule] = &[
    // A ratio between rates needs no position on the links.
    element("predecessor successor", &[("link", Read)], &[unread("origin", Silent)]).single(),
    leaf("ratio", &[("value", Read)]),
    // Both axes are joint axes.
    unread("axis", Silent),
];

const IN_RELATION: &[ElementRule] = &[
    RELATED_JOINT,
    leaf("constant", &[("value", Read)]),
    element("curve", &[("offset coefficients", Read)], &[RELATED_JOINT]).single(),
];

const RELATED_JOINT: ElementRule = element("joint", &[("name factor", Read)], &[]);

const IN_CONTACT: &[ElementRule] = &[
    leaf("body", &[("link xyz", Read)]),
    leaf("other", &[("link", Read)]),
    leaf("normal toward away", &[("xyz", Read)]),
    leaf("gap", &[("value", Read)]),
];

const IN_BUSHING: &[ElementRule] = &[
    ORIGIN,
    leaf("stiffness", &[("xyz rpy loss_factor dynamic_factor", Read)]),
    leaf("damping preload rigid", &[("xyz rpy", Read)]),
    element("joint", &[("name", Read)], &[]),
];

const IN_LINK: &[ElementRule] = &[
    element("inertial", &[], IN_INERTIAL).single(),
    // `shapes.rs` reads the shapes; `survey.rs` lists the other children.
    unread("visual collision", Silent),
    warned("origin", "a link has no origin of its own in URDF (its joint and its <inertial> have); ignored"),
    unread(
        "sensor gazebo material contact surface gravity self_filter collision_checking self_collision_checking \
         collision_bullet verbose",
        Silent,
    ),
    unread(
        "kinematic",
        Noted(
            "\"kinematic\" is a simulator's word for a body moved by script; ignored, lock its joint to hold it",
        ),
    ),
];

const IN_INERTIAL: &[ElementRule] =
    &[ORIGIN, leaf("mass", &[("value", Read)]), leaf("inertia", &[("ixx ixy ixz iyy iyz izz", Read)])];

const IN_JOINT: &[ElementRule] = &[
    ORIGIN,
    leaf("parent child", &[("link", Read)]),
    leaf("axis", &[("xyz", Read)]),
    leaf(
        "limit",
        &[
            ("lower upper", Read),
            (
                "effort velocity acceleration deceleration jerk stiffness current command_effort gear_velocity",
                Silent,
            ),
        ],
    ),
    // Friction is a finite force: no work in an instantaneous impact.
    leaf(
        "dynamics",
        &[
            ("armature damping spring_stiffness spring_reference", Read),
            ("friction stiffness mu_coulomb mu_viscous K D", Silent),
        ],
    ),
    leaf("mimic", &[("joint multiplier offset", Read)]),
    element("actuator", NAME_AND_ROLE, IN_ACTUATOR),
    leaf("drake:rotor_inertia drake:gear_ratio", &[("value", Read)]),
    unread(
        "calibration safety_controller hardwareInterface controller_gains drake:controller_gains joint_properties physics sensor \
         gazebo",
        Silent,
    ),
];

/// SDF `<joint>` in a `<gazebo>` of the robot. `gazebo_joint.rs` reads the values, which are element texts and
/// frames.
pub(crate) const GAZEBO_JOINT: ElementRule = element("joint", &[("name type", Read)], IN_GAZEBO_JOINT);

const IN_GAZEBO_JOINT: &[ElementRule] = &[
    unread("pose parent child", Unexamined).single(),
    element("axis axis2", &[], IN_GAZEBO_AXIS).single(),
    unread("thread_pitch screw_thread_pitch gearbox_ratio gearbox_reference_body", Unexamined).single(),
    unread("physics sensor", Silent),
];

const IN_GAZEBO_AXIS: &[ElementRule] = &[
    unread("xyz use_parent_model_frame", Unexamined).single(),
    unread("limit", UNCHECKED_LIMIT),
    unread("dynamics initial_position", Silent),
    unread("mimic", write_instead!("a <coupling>, or a <mimic> in a joint of the tree,")),
];

/// Inertia and ratio of a rotor, in a transmission and in its joint and actuator.
const ROTOR_DATA: ElementRule = unread(
    "motorInertia motor_inertia rotorInertia rotor_inertia mechanicalReduction mechanical_reduction gearRatio gear_ratio",
    Unexamined,
);

const IN_ACTUATOR: &[ElementRule] = &[
    leaf("drake:rotor_inertia drake:gear_ratio", &[("value", Read)]),
    ROTOR_DATA,
    unread(
        "hardwareInterface role api node offset param motorTorqueConstant motorVelocityConstant maxEffort \
         drake:controller_gains",
        Unlisted,
    ),
];

/// Transmission of ROS, of ros2_control and of the PR2. `transmission.rs` reads the rotor inertias.
const TRANSMISSION: ElementRule =
    element("transmission", &[("name", Silent), ("type", Read)], IN_TRANSMISSION);

const IN_TRANSMISSION: &[ElementRule] = &[
    unread("type plugin", Unexamined),
    element("joint actuator", NAME_AND_ROLE, IN_ACTUATOR),
    leaf("drake:rotor_inertia drake:gear_ratio", &[("value", Read)]),
    ROTOR_DATA,
    unread(
        "hardwareInterface robotNamespace api node param motorTorqueConstant motorVelocityConstant compensator \
         leftActuator rightActuator flexJoint rollJoint gap_joint passive_joint simulated_actuated_joint \
         use_simulated_gripper_joint",
        Unlisted,
    ),
];

const NAME_AND_ROLE: Attributes =
    &[("name", Read), ("role", Silent), ("motorInertia rotorInertia mechanicalReduction", Read)];

const IN_ROS2_CONTROL: &[ElementRule] = &[
    TRANSMISSION,
    element("joint", &[("name mimic", Read)], IN_CONTROLLED_JOINT),
    unread("hardware sensor gpio async properties", Unlisted),
];

const IN_CONTROLLED_JOINT: &[ElementRule] = &[
    // `simulator_couplings.rs` reads the parameters of a mimic.
    unread("param mimic", Unexamined),
    unread("command_interface state_interface limits properties", Unlisted),
];

/// Treatment of settings by which MuJoCo changes the masses of a URDF, with the defaults of the setting.
const fn changes_masses(defaults: &'static [&'static str]) -> Treatment {
    WarnedUnless(
        defaults,
        "MuJoCo changes masses or inertias by this setting, and here it is not read: write the masses and inertias that MuJoCo uses \
         into the links, or convert the file to MJCF by MuJoCo and load that",
    )
}

const IN_MUJOCO: &[ElementRule] = &[
    element(
        "compiler",
        &[
            ("inertiafromgeom", changes_masses(&["false", "auto"])),
            ("balanceinertia", changes_masses(&["false"])),
            ("boundmass boundinertia settotalmass", changes_masses(&[])),
            (
                "inertiagrouprange exactmeshinertia fusestatic discardvisual strippath convexhull meshdir texturedir \
                 assetdir angle eulerseq coordinate autolimits fitaabb usethread saveinertial alignfree conflict",
                Silent,
            ),
        ],
        &[unread("lengthrange", Silent)],
    ),
    unread(
        "equality",
        Refused(
            "loop-unsupported",
            "MuJoCo's equality constraints are not read, and the answer without them would be wrong: write a <loop> \
             (for connect: spherical, for weld: fixed), or a <coupling> or <mimic> (for joint)",
        ),
    ),
    warned(
        "tendon actuator default worldbody deformable",
        "it is not read in a URDF, neither here nor by MuJoCo; bodies, couplings and armatures belong in <link>, <joint>, \
             <mimic> and <dynamics armature>, or load an MJCF",
    ),
    unread("option size visual statistic asset contact sensor keyframe custom extension", Unlisted),
];

/// Settings of Gazebo for the robot, a link or a joint. Source: sdformat, `parser_urdf.cc`, and SDFormat 1.11.
const IN_GAZEBO: &[ElementRule] = &[
    // `check_gazebo_joints` examines the joints, `simulator_couplings.rs` plugins and mimics, `transmission.rs` armatures.
    unread("joint mimic axis armature", Unexamined),
    warned(
        "link model include",
        "links and models inside <gazebo>, and joints to them, are not read: write them as <link> and <joint> of the robot",
    ),
    warned(
        "inertial inertia mass",
        "masses and inertias inside <gazebo> are not read: write them into the <inertial> of the link",
    ),
    unread(
        "static",
        WarnedUnless(
            &["false", "False", ""],
            "a static model does not move in Gazebo; here its joints move: lock them to hold it",
        ),
    ),
    unread(
        "kinematic",
        WarnedUnless(
            &["false", "False", ""],
            "a kinematic link is moved by script; here it moves with its joints: lock its joint to hold it",
        ),
    ),
    // Contacts, sensors, forces and looks.
    unread(
        "plugin material visual collision sensor light projector audio audio_sink audio_source battery \
         gripper particle_emitter gravity turnGravityOff selfCollide self_collide enable_wind mu mu1 mu2 \
         fdir1 slip1 slip2 kp kd minDepth min_depth maxVel max_vel maxContacts max_contacts laserRetro \
         laser_retro surface friction bounce contact physics ode dampingFactor velocity_decay \
         provideFeedback implicitSpringDamper springReference springStiffness fudgeFactor stopCfm stopErp \
         stopKp stopKd cfmDamping initialJointPosition initial_joint_position limit dynamics \
         preserveFixedJoint disableFixedJointLumping canonicalBody must_be_base_link allow_auto_disable \
         pose origin frame genTexCoord dontUseGravity robotNamespace param gui scene verbose",
        Unlisted,
    ),
];

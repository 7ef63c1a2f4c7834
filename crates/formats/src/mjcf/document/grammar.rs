//! Table of MJCF: every element and attribute with its treatment. Source: MuJoCo 3.12, `src/xml/mjcf.schema`, and the reference of
//! MuJoCo 4.0.

use crate::reading::document::grammar::Treatment::{Read, Refused, Silent};
use crate::reading::document::grammar::{
    Attributes, ElementRule, Treatment, element, refused, tags, unread, warned,
};

/// Root element.
pub(crate) const ROOT: ElementRule = element("mujoco", &[("model", Read)], IN_ROOT).open();

const FLEX: Treatment = Refused(
    "unsupported",
    "deformable bodies have no effective mass of a rigid mechanism, and the answer without them would be wrong; remove the \
     element, or replace it by rigid bodies",
);

const IN_ROOT: &[ElementRule] = &[
    element("compiler", IN_COMPILER, &[unread("lengthrange", Silent)]),
    // Time steps, solvers and contact parameters are settings of the simulation.
    element("option", &[], &[element("flag", &[("equality constraint", Read)], &[]).open()]).open(),
    unread("size statistic visual", Silent),
    element("default", &[("class", Read)], &IN_CLASS),
    unread("extension", Silent),
    element("asset", &[], IN_ASSET),
    element("worldbody", &[("childclass", Read)], &IN_BODY),
    element("deformable", &[], &[unread("flex", FLEX), unread("skin", Silent)]),
    unread("contact", Silent),
    element("equality", &[], IN_EQUALITY),
    element("tendon", &[], IN_TENDON),
    element("actuator", &[], IN_ACTUATOR),
    unread("sensor", Silent),
    // Velocities, controls and mocap poses have no form in a pose.
    element(
        "keyframe",
        &[],
        &[element("key", &[("name qpos", Read), ("time qvel act ctrl mpos mquat plastic", Silent)], &[])],
    ),
    unread("custom", Silent),
];

const IN_COMPILER: Attributes = &[
    ("autolimits boundmass boundinertia settotalmass balanceinertia strippath coordinate angle", Read),
    ("fitaabb", Silent),
    ("eulerseq meshdir", Read),
    ("texturedir", Silent),
    ("assetdir", Read),
    ("discardvisual usethread fusestatic", Silent),
    ("inertiafromgeom inertiagrouprange exactmeshinertia", Read),
    ("convexhull saveinertial alignfree conflict savecompiled savecanonical passthrough", Silent),
];

const IN_ASSET: &[ElementRule] = &[
    element("mesh", MESH, &[unread("plugin", Silent)]),
    unread("hfield skin texture material", Silent),
    element("model", &[("name file", Read), ("content_type", Silent)], &[]),
];

const MESH: Attributes = &[
    ("name class", Read),
    ("content_type", Silent),
    ("file vertex", Read),
    ("normal texcoord", Silent),
    ("face refpos refquat scale", Read),
    ("smoothnormal", Silent),
    ("maxhullvert inertia builtin", Read),
    ("params material octree_maxdepth", Silent),
];

const SCALED_FRAME: Treatment = Refused(
    "unsupported",
    "the scale of a frame is not read, and the answer without it would be wrong; write the scaled numbers into its elements",
);

/// Contents of a body.
pub(crate) static IN_BODY: [ElementRule; 13] = [
    element(
        "body",
        &[
            ("name childclass pos quat axisangle xyaxes zaxis euler mocap", Read),
            ("gravcomp sleep simple fuse user", Silent),
        ],
        &IN_BODY,
    ),
    element(
        "frame",
        &[
            ("name childclass pos quat axisangle xyaxes zaxis euler", Read),
            ("scale massscale scaling", SCALED_FRAME),
        ],
        &IN_BODY,
    ),
    // MuJoCo does not examine the attributes of <replicate>; some of its models have a prefix, which has no effect.
    element("replicate", &[("count sep offset euler childclass", Read), ("prefix", Silent)], &IN_BODY),
    element("inertial", &[("pos quat axisangle xyaxes zaxis euler mass diaginertia fullinertia", Read)], &[]),
    element("joint", JOINT, &[]),
    element("freejoint", &[("name", Read), ("group align", Silent)], &[]),
    element("geom", GEOM, &[unread("plugin", Silent)]),
    element("site", SITE, &[]),
    unread("camera light", Silent),
    element("attach", &[("model body frame prefix", Read)], &[]),
    warned("plugin", "a plugin of a body is taken as a source of finite forces and ignored"),
    refused(
        "composite",
        "composite objects are not read, and the answer without them would be wrong; save the compiled model \
             (mujoco.mj_saveLastXML) and load that file",
    ),
    unread("flexcomp", FLEX),
];

const JOINT: Attributes = &[
    ("name class type pos axis limited range ref armature stiffness springref damping springdamper", Read),
    // Friction, limits of forces and parameters of the solver: finite forces, or settings of the simulation.
    (
        "group actuatorfrclimited actuatorfrcrange actuatorgravcomp solreflimit solimplimit \
         solreffriction solimpfriction margin springyield frictionloss user",
        Silent,
    ),
];

const GEOM: Attributes = &[
    ("name", Silent),
    ("class type size mass density shellinertia fromto pos quat axisangle xyaxes zaxis euler", Read),
    ("mesh hfield group contype conaffinity", Read),
    (
        "fitscale condim priority material friction solmix solref solimp margin gap surfacevel adhesion rgba \
         castshadow fluidshape fluidcoef user",
        Silent,
    ),
];

const SITE: Attributes = &[
    ("name class fromto pos quat axisangle xyaxes zaxis euler", Read),
    ("type group material mesh size rgba user", Silent),
];

/// Contents of a class of defaults.
static IN_CLASS: [ElementRule; 10] = [
    element("default", &[("class", Read)], &IN_CLASS),
    element("mesh", MESH, &[]),
    unread("material texture", Silent),
    element("joint", JOINT, &[]),
    element("geom", GEOM, &[unread("plugin", Silent)]),
    element("site", SITE, &[]),
    unread("camera light pair", Silent),
    element("equality", &[("active", Read)], &[]).open(),
    element("tendon", &[("armature", Read), ("limited range", Silent)], &[]).open(),
    ACTUATOR,
];

const IN_EQUALITY: &[ElementRule] = &[
    element(
        "connect",
        &[("name class active", Read), ("solref solimp", Silent), ("body1 body2 anchor site1 site2", Read)],
        &[],
    ),
    element(
        "weld",
        &[
            ("name class active", Read),
            ("solref solimp", Silent),
            ("body1 body2 anchor relpose site1 site2 torquescale", Read),
        ],
        &[],
    ),
    element(
        "joint",
        &[("name class active", Read), ("solref solimp", Silent), ("joint1 joint2 polycoef", Read)],
        &[],
    ),
    element(
        "tendon",
        &[("name class active", Read), ("solref solimp", Silent), ("tendon1 tendon2 polycoef", Read)],
        &[],
    ),
    refused(
        "flex flexvert flexstrain",
        "constraints of deformable bodies are not read, and the answer without them would be wrong",
    ),
    refused(
        "distance",
        "the distance between two geoms is not read (MuJoCo removed this element in version 2.2.2), and the answer without \
             it would be wrong; use a <connect>, or a spatial tendon with an equality",
    ),
];

const TENDON: Attributes = &[("name class armature", Read), ("limited", Silent)];

const IN_TENDON: &[ElementRule] = &[
    element(
        "spatial",
        TENDON,
        &[
            element("site", &[("site", Read)], &[]),
            element("geom", &[("geom sidesite", Read)], &[]),
            element("pulley", &[("divisor", Read)], &[]),
        ],
    )
    .open(),
    element("fixed", TENDON, &[element("joint", &[("joint coef", Read)], &[])]).open(),
];

/// All actuators but plugins. Gains, ranges and dynamics of the controls are finite forces.
const ACTUATOR: ElementRule = element(
    "general motor position velocity intvelocity orientation pid damper cylinder muscle adhesion dcmotor",
    &[("class joint jointinparent tendon gear armature", Read)],
    &[],
)
.open();

const IN_ACTUATOR: &[ElementRule] = &[ElementRule { tags: "plugin", children: None, ..ACTUATOR }, ACTUATOR];

/// True for the tag of an actuator; all actuators share one set of defaults in each class.
pub(crate) fn is_actuator(tag: &str) -> bool {
    tags(IN_ACTUATOR).any(|(known, _)| known == tag)
}

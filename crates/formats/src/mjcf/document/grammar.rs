//! Table of MJCF: every element and attribute with its treatment. Source: MuJoCo 3.12, `src/xml/mjcf.schema`, and the reference of
//! MuJoCo 4.0.

use Treatment::{Read, Refused, Silent, Warned};

/// Treatment of an element or attribute.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Treatment {
    /// Part of the mechanism.
    Read,
    /// Ignored without a message: no effect on the mechanics of an impact.
    Silent,
    /// Ignored with a warning; the text gives the reason.
    Warned(&'static str),
    /// Not supported, and the result without this entry would be wrong: an error; the text gives the reason and a remedy.
    Refused(&'static str),
}

/// Children that an element may have.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Content {
    /// None of these: children are not examined.
    Unexamined,
    /// Elements of a list.
    List(&'static [ElementRule]),
    /// Contents of a body, frame or replicate.
    Body,
    /// Contents of a class of defaults.
    Class,
}

/// Entry of the table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ElementRule {
    pub tag: &'static str,
    pub treatment: Treatment,
    /// Attributes that are examined.
    pub attributes: &'static [(&'static str, Treatment)],
    /// True if other attributes have no effect; otherwise an unknown attribute is an error, as in MuJoCo.
    pub open: bool,
    pub content: Content,
}

/// Element that is read; unknown attributes are errors.
const fn element(
    tag: &'static str,
    attributes: &'static [(&'static str, Treatment)],
    content: Content,
) -> ElementRule {
    ElementRule { tag, treatment: Read, attributes, open: false, content }
}

/// Element that is read; attributes that are not listed have no effect.
const fn open_element(
    tag: &'static str,
    attributes: &'static [(&'static str, Treatment)],
    content: Content,
) -> ElementRule {
    ElementRule { tag, treatment: Read, attributes, open: true, content }
}

/// Element that is not read.
const fn unread(tag: &'static str, treatment: Treatment) -> ElementRule {
    ElementRule { tag, treatment, attributes: &[], open: true, content: Content::Unexamined }
}

impl Content {
    /// Rules of the child elements; `None` if children are not examined.
    pub fn rules(self) -> Option<&'static [ElementRule]> {
        match self {
            Content::Unexamined => None,
            Content::List(rules) => Some(rules),
            Content::Body => Some(IN_BODY),
            Content::Class => Some(IN_CLASS),
        }
    }
}

const NO_CHILDREN: Content = Content::List(&[]);

/// Root element.
pub(crate) const ROOT: ElementRule = open_element("mujoco", &[("model", Read)], Content::List(IN_ROOT));

const FLEX: Treatment = Refused(
    "deformable bodies have no effective mass of a rigid mechanism, and the answer without them would be wrong; remove the \
     element, or replace it by rigid bodies",
);

const IN_ROOT: &[ElementRule] = &[
    element("compiler", IN_COMPILER, Content::List(&[unread("lengthrange", Silent)])),
    // Time steps, solvers and contact parameters are settings of the simulation.
    open_element(
        "option",
        &[],
        Content::List(&[open_element("flag", &[("equality", Read), ("constraint", Read)], NO_CHILDREN)]),
    ),
    unread("size", Silent),
    unread("statistic", Silent),
    unread("visual", Silent),
    element("default", &[("class", Read)], Content::Class),
    unread("extension", Silent),
    element("asset", &[], Content::List(IN_ASSET)),
    element("worldbody", &[("childclass", Read)], Content::Body),
    element("deformable", &[], Content::List(&[unread("flex", FLEX), unread("skin", Silent)])),
    unread("contact", Silent),
    element("equality", &[], Content::List(IN_EQUALITY)),
    element("tendon", &[], Content::List(IN_TENDON)),
    element("actuator", &[], Content::List(IN_ACTUATOR)),
    unread("sensor", Silent),
    element("keyframe", &[], Content::List(&[KEY])),
    unread("custom", Silent),
];

/// Keyframe. Velocities, controls and mocap poses have no form in a pose.
const KEY: ElementRule = element(
    "key",
    &[
        ("name", Read),
        ("qpos", Read),
        ("time", Silent),
        ("qvel", Silent),
        ("act", Silent),
        ("ctrl", Silent),
        ("mpos", Silent),
        ("mquat", Silent),
        ("plastic", Silent),
    ],
    NO_CHILDREN,
);

const IN_COMPILER: &[(&str, Treatment)] = &[
    ("autolimits", Read),
    ("boundmass", Read),
    ("boundinertia", Read),
    ("settotalmass", Read),
    ("balanceinertia", Read),
    ("strippath", Read),
    ("coordinate", Read),
    ("angle", Read),
    ("fitaabb", Silent),
    ("eulerseq", Read),
    ("meshdir", Read),
    ("texturedir", Silent),
    ("assetdir", Read),
    ("discardvisual", Silent),
    ("usethread", Silent),
    ("fusestatic", Silent),
    ("inertiafromgeom", Read),
    ("inertiagrouprange", Read),
    ("exactmeshinertia", Read),
    ("convexhull", Silent),
    ("saveinertial", Silent),
    ("alignfree", Silent),
    ("conflict", Silent),
    ("savecompiled", Silent),
    ("savecanonical", Silent),
    ("passthrough", Silent),
];

const IN_ASSET: &[ElementRule] = &[
    element("mesh", MESH, Content::List(&[unread("plugin", Silent)])),
    unread("hfield", Silent),
    unread("skin", Silent),
    unread("texture", Silent),
    unread("material", Silent),
    element("model", &[("name", Read), ("file", Read), ("content_type", Silent)], NO_CHILDREN),
];

const MESH: &[(&str, Treatment)] = &[
    ("name", Read),
    ("class", Read),
    ("content_type", Silent),
    ("file", Read),
    ("vertex", Read),
    ("normal", Silent),
    ("texcoord", Silent),
    ("face", Read),
    ("refpos", Read),
    ("refquat", Read),
    ("scale", Read),
    ("smoothnormal", Silent),
    ("maxhullvert", Read),
    ("inertia", Read),
    ("builtin", Read),
    ("params", Silent),
    ("material", Silent),
    ("octree_maxdepth", Silent),
];

const POS: (&str, Treatment) = ("pos", Read);
const QUAT: (&str, Treatment) = ("quat", Read);
const AXISANGLE: (&str, Treatment) = ("axisangle", Read);
const XYAXES: (&str, Treatment) = ("xyaxes", Read);
const ZAXIS: (&str, Treatment) = ("zaxis", Read);
const EULER: (&str, Treatment) = ("euler", Read);

const SCALED_FRAME: Treatment = Refused(
    "the scale of a frame is not read, and the answer without it would be wrong; write the scaled numbers into its elements",
);

const IN_BODY: &[ElementRule] = &[
    element(
        "body",
        &[
            ("name", Read),
            ("childclass", Read),
            POS,
            QUAT,
            AXISANGLE,
            XYAXES,
            ZAXIS,
            EULER,
            ("mocap", Read),
            ("gravcomp", Silent),
            ("sleep", Silent),
            ("simple", Silent),
            ("fuse", Silent),
            ("user", Silent),
        ],
        Content::Body,
    ),
    element(
        "frame",
        &[
            ("name", Read),
            ("childclass", Read),
            POS,
            QUAT,
            AXISANGLE,
            XYAXES,
            ZAXIS,
            EULER,
            ("scale", SCALED_FRAME),
            ("massscale", SCALED_FRAME),
            ("scaling", SCALED_FRAME),
        ],
        Content::Body,
    ),
    element(
        "replicate",
        // MuJoCo does not examine the attributes of <replicate>; some of its models have a prefix, which has no effect.
        &[
            ("count", Read),
            ("sep", Read),
            ("offset", Read),
            ("euler", Read),
            ("childclass", Read),
            ("prefix", Silent),
        ],
        Content::Body,
    ),
    element(
        "inertial",
        &[
            POS,
            QUAT,
            AXISANGLE,
            XYAXES,
            ZAXIS,
            EULER,
            ("mass", Read),
            ("diaginertia", Read),
            ("fullinertia", Read),
        ],
        NO_CHILDREN,
    ),
    element("joint", JOINT, NO_CHILDREN),
    element("freejoint", &[("name", Read), ("group", Silent), ("align", Silent)], NO_CHILDREN),
    element("geom", GEOM, Content::List(&[unread("plugin", Silent)])),
    element("site", SITE, NO_CHILDREN),
    unread("camera", Silent),
    unread("light", Silent),
    element("attach", &[("model", Read), ("body", Read), ("frame", Read), ("prefix", Read)], NO_CHILDREN),
    unread("plugin", Warned("a plugin of a body is taken as a source of finite forces and ignored")),
    unread(
        "composite",
        Refused(
            "composite objects are not read, and the answer without them would be wrong; save the compiled model \
             (mujoco.mj_saveLastXML) and load that file",
        ),
    ),
    unread("flexcomp", FLEX),
];

const JOINT: &[(&str, Treatment)] = &[
    ("name", Read),
    ("class", Read),
    ("type", Read),
    ("pos", Read),
    ("axis", Read),
    ("limited", Read),
    ("range", Read),
    ("ref", Read),
    ("armature", Read),
    // Springs, dampers, friction, limits of forces and parameters of the solver: finite forces, or settings of the simulation.
    ("group", Silent),
    ("springdamper", Silent),
    ("actuatorfrclimited", Silent),
    ("actuatorfrcrange", Silent),
    ("actuatorgravcomp", Silent),
    ("solreflimit", Silent),
    ("solimplimit", Silent),
    ("solreffriction", Silent),
    ("solimpfriction", Silent),
    ("stiffness", Silent),
    ("margin", Silent),
    ("springref", Silent),
    ("springyield", Silent),
    ("damping", Silent),
    ("frictionloss", Silent),
    ("user", Silent),
];

const GEOM: &[(&str, Treatment)] = &[
    ("name", Silent),
    ("class", Read),
    ("type", Read),
    ("size", Read),
    ("mass", Read),
    ("density", Read),
    ("shellinertia", Read),
    ("fromto", Read),
    POS,
    QUAT,
    AXISANGLE,
    XYAXES,
    ZAXIS,
    EULER,
    ("mesh", Read),
    ("hfield", Read),
    ("group", Read),
    ("contype", Read),
    ("conaffinity", Read),
    ("fitscale", Silent),
    ("condim", Silent),
    ("priority", Silent),
    ("material", Silent),
    ("friction", Silent),
    ("solmix", Silent),
    ("solref", Silent),
    ("solimp", Silent),
    ("margin", Silent),
    ("gap", Silent),
    ("surfacevel", Silent),
    ("adhesion", Silent),
    ("rgba", Silent),
    ("castshadow", Silent),
    ("fluidshape", Silent),
    ("fluidcoef", Silent),
    ("user", Silent),
];

const SITE: &[(&str, Treatment)] = &[
    ("name", Read),
    ("class", Read),
    ("fromto", Read),
    POS,
    QUAT,
    AXISANGLE,
    XYAXES,
    ZAXIS,
    EULER,
    ("type", Silent),
    ("group", Silent),
    ("material", Silent),
    ("mesh", Silent),
    ("size", Silent),
    ("rgba", Silent),
    ("user", Silent),
];

const CLASS_OF_TENDONS: &[(&str, Treatment)] = &[("armature", Read), ("limited", Silent), ("range", Silent)];

/// Rules, and those of the twelve kinds of actuators, which `<default>` and `<actuator>` share.
macro_rules! with_actuators {
    ($($rule:expr),* $(,)?) => {
        &[
            $($rule,)*
            open_element("general", ACTUATOR, NO_CHILDREN),
            open_element("motor", ACTUATOR, NO_CHILDREN),
            open_element("position", ACTUATOR, NO_CHILDREN),
            open_element("velocity", ACTUATOR, NO_CHILDREN),
            open_element("intvelocity", ACTUATOR, NO_CHILDREN),
            open_element("orientation", ACTUATOR, NO_CHILDREN),
            open_element("pid", ACTUATOR, NO_CHILDREN),
            open_element("damper", ACTUATOR, NO_CHILDREN),
            open_element("cylinder", ACTUATOR, NO_CHILDREN),
            open_element("muscle", ACTUATOR, NO_CHILDREN),
            open_element("adhesion", ACTUATOR, NO_CHILDREN),
            open_element("dcmotor", ACTUATOR, NO_CHILDREN),
        ]
    };
}

const IN_CLASS: &[ElementRule] = with_actuators![
    element("default", &[("class", Read)], Content::Class),
    element("mesh", MESH, NO_CHILDREN),
    unread("material", Silent),
    unread("texture", Silent),
    element("joint", JOINT, NO_CHILDREN),
    element("geom", GEOM, Content::List(&[unread("plugin", Silent)])),
    element("site", SITE, NO_CHILDREN),
    unread("camera", Silent),
    unread("light", Silent),
    unread("pair", Silent),
    open_element("equality", &[("active", Read)], NO_CHILDREN),
    open_element("tendon", CLASS_OF_TENDONS, NO_CHILDREN),
];

const FLEX_EQUALITY: Treatment =
    Refused("constraints of deformable bodies are not read, and the answer without them would be wrong");

const IN_EQUALITY: &[ElementRule] = &[
    element(
        "connect",
        &[
            ("name", Read),
            ("class", Read),
            ("active", Read),
            ("solref", Silent),
            ("solimp", Silent),
            ("body1", Read),
            ("body2", Read),
            ("anchor", Read),
            ("site1", Read),
            ("site2", Read),
        ],
        NO_CHILDREN,
    ),
    element(
        "weld",
        &[
            ("name", Read),
            ("class", Read),
            ("active", Read),
            ("solref", Silent),
            ("solimp", Silent),
            ("body1", Read),
            ("body2", Read),
            ("anchor", Read),
            ("relpose", Read),
            ("site1", Read),
            ("site2", Read),
            ("torquescale", Read),
        ],
        NO_CHILDREN,
    ),
    element(
        "joint",
        &[
            ("name", Read),
            ("class", Read),
            ("active", Read),
            ("solref", Silent),
            ("solimp", Silent),
            ("joint1", Read),
            ("joint2", Read),
            ("polycoef", Read),
        ],
        NO_CHILDREN,
    ),
    element(
        "tendon",
        &[
            ("name", Read),
            ("class", Read),
            ("active", Read),
            ("solref", Silent),
            ("solimp", Silent),
            ("tendon1", Read),
            ("tendon2", Read),
            ("polycoef", Read),
        ],
        NO_CHILDREN,
    ),
    unread("flex", FLEX_EQUALITY),
    unread("flexvert", FLEX_EQUALITY),
    unread("flexstrain", FLEX_EQUALITY),
    unread(
        "distance",
        Refused(
            "the distance between two geoms is not read (MuJoCo removed this element in version 2.2.2), and the answer without \
             it would be wrong; use a <connect>, or a spatial tendon with an equality",
        ),
    ),
];

const IN_TENDON: &[ElementRule] = &[
    open_element(
        "spatial",
        &[("name", Read), ("class", Read), ("armature", Read), ("limited", Silent)],
        Content::List(&[
            element("site", &[("site", Read)], NO_CHILDREN),
            element("geom", &[("geom", Read), ("sidesite", Read)], NO_CHILDREN),
            element("pulley", &[("divisor", Read)], NO_CHILDREN),
        ]),
    ),
    open_element(
        "fixed",
        &[("name", Read), ("class", Read), ("armature", Read), ("limited", Silent)],
        Content::List(&[element("joint", &[("joint", Read), ("coef", Read)], NO_CHILDREN)]),
    ),
];

/// Attributes of all actuators. Gains, ranges and dynamics of the controls are finite forces.
const ACTUATOR: &[(&str, Treatment)] = &[
    ("class", Read),
    ("joint", Read),
    ("jointinparent", Read),
    ("tendon", Read),
    ("gear", Read),
    ("armature", Read),
];

const IN_ACTUATOR: &[ElementRule] = with_actuators![open_element("plugin", ACTUATOR, Content::Unexamined)];

/// Tags of actuators, which share one set of defaults in each class.
pub(crate) const ACTUATOR_TAGS: [&str; 13] = [
    "general",
    "motor",
    "position",
    "velocity",
    "intvelocity",
    "orientation",
    "pid",
    "damper",
    "cylinder",
    "muscle",
    "adhesion",
    "dcmotor",
    "plugin",
];

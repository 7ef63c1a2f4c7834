//! Elements of a sheet template.

/// Template of a sheet.
pub(crate) struct Template {
    pub name: &'static str,
    /// Description in one line.
    pub title: &'static str,
    /// Advice for the user.
    pub about: &'static [&'static str],
    /// True if both sides are on one axle and always built together.
    pub axle: bool,
    /// Hardpoints with example values in mm, in the axes of ISO 8855, left side.
    pub points: &'static [(&'static str, [f64; 3])],
    /// Bodies with example values.
    pub bodies: &'static [Body],
    /// Construction steps, parents first.
    pub parts: &'static [Part],
    /// Default links for the attachment of springs and similar parts: section and link.
    pub on: &'static [(&'static str, &'static str)],
}

/// Body with example values: mass, kg; centre of mass, mm; xx, yy, zz, xy, xz, yz about the centre of mass, kg·m².
pub(crate) struct Body {
    pub key: &'static str,
    pub shape: Shape,
    pub mass: f64,
    pub com: [f64; 3],
    pub inertia: [f64; 6],
}

/// Data of a body that a sheet must contain.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    /// Mass, centre of mass, inertia.
    Any,
    /// No data (a massless rod), the mass (a slender rod), or all data.
    Rod,
    /// Rotating body: the centre of mass defaults to the wheel centre.
    Spindle,
    /// Optional.
    Optional,
}

/// Step in building a mechanism. The link name `SECTION.on` stands for the link chosen in the sheet.
pub(crate) enum Part {
    /// Link on a hinge through two points; the link frame is at the first.
    Hinge { link: &'static str, parent: &'static str, points: [&'static str; 2] },
    /// Link on a hinge parallel to the vehicle's x axis.
    Swivel { link: &'static str, parent: &'static str, at: &'static str },
    /// Link on a ball joint.
    Ball { link: &'static str, joint: &'static str, parent: &'static str, at: &'static str },
    /// Link constrained only by its closures.
    Free { link: &'static str, at: &'static str },
    /// Free body of the axle, with its frame half way between the wheels.
    Axle,
    /// Link fixed to another.
    Fixed { link: &'static str, on: &'static str, at: &'static str },
    /// Spindle and wheel.
    Wheel { on: &'static str },
    /// Link between two points: a massless rod or a body.
    Rod { link: &'static str, ends: [(&'static str, &'static str); 2] },
    /// Strut on a universal joint at the top; slides along its axis.
    Strut { link: &'static str, on: &'static str, line: [&'static str; 2] },
    /// Ball joint that closes a loop.
    Close { joint: &'static str, links: [&'static str; 2], at: &'static str },
}

//! What a template of a sheet is made of.

/// A template.
pub(crate) struct Template {
    pub name: &'static str,
    /// What it is, on one line.
    pub title: &'static str,
    /// What its user should know.
    pub about: &'static [&'static str],
    /// Whether both sides are on one axle, and always built together.
    pub axle: bool,
    /// Hardpoints with example figures in mm, in the axes of ISO 8855, left side.
    pub points: &'static [(&'static str, [f64; 3])],
    /// Bodies with example figures.
    pub bodies: &'static [Body],
    /// What is built, parents first.
    pub parts: &'static [Part],
    /// Where springs and the like are attached unless the sheet has another link: key of the section and link.
    pub on: &'static [(&'static str, &'static str)],
}

/// A body and example figures: kg; centre of mass, mm; xx, yy, zz, xy, xz, yz about it in kg·m².
pub(crate) struct Body {
    pub key: &'static str,
    pub shape: Shape,
    pub mass: f64,
    pub com: [f64; 3],
    pub inertia: [f64; 6],
}

/// What a sheet must say of a body.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    /// Mass, centre of mass, inertia.
    Any,
    /// Nothing (a massless rod), its mass (a slender rod), or all.
    Rod,
    /// What turns with the wheel: its centre of mass is the wheel's centre unless it is given.
    Spindle,
    /// May be left out.
    Optional,
}

/// One step of building a mechanism. A link named `….on` is the one that the sheet attaches it to.
pub(crate) enum Part {
    /// A link on a hinge through two points; its frame stands at the first.
    Hinge { link: &'static str, parent: &'static str, points: [&'static str; 2] },
    /// A link on a hinge along the vehicle's x.
    Swivel { link: &'static str, parent: &'static str, at: &'static str },
    /// A link on a ball joint.
    Ball { link: &'static str, joint: &'static str, parent: &'static str, at: &'static str },
    /// A link that only what is attached to it holds.
    Free { link: &'static str, at: &'static str },
    /// The axle's body, free, its frame half way between the wheels.
    Axle,
    /// A link that is part of another.
    Fixed { link: &'static str, on: &'static str, at: &'static str },
    /// Spindle and wheel.
    Wheel { on: &'static str },
    /// A link between two points: a massless rod or a body.
    Rod { link: &'static str, ends: [(&'static str, &'static str); 2] },
    /// A strut on a universal joint at its top, sliding along its own line.
    Strut { link: &'static str, on: &'static str, line: [&'static str; 2] },
    /// A ball joint that closes a loop.
    Close { joint: &'static str, links: [&'static str; 2], at: &'static str },
}

//! Groups: constraints and coordinates that bind one another. Each owns its size, on which all that is decided about it
//! is measured, so that nothing about one group can depend on another.

use percuss_mechanism::JointId;

/// A tree velocity that a constraint binds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term {
    pub body: usize,
    /// Which velocity of the body's joint.
    pub component: usize,
    /// Times the velocity's own sign along the path: +1 on the successor's side, −1 on the predecessor's; a
    /// coupling's factor.
    pub factor: f64,
    /// The coordinate that the velocity follows, by index into the group's, and its multiplier.
    pub column: usize,
    pub multiplier: f64,
}

/// What takes rows of A.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Constraint {
    /// By index into the model's closures.
    Closure(usize),
    /// By index into the model's couplings.
    Coupling(usize),
    /// By index into the model's held contacts.
    Hold(usize),
}

/// A constraint's rows in its group's part of A.
#[derive(Clone, Debug)]
pub(crate) struct ConstraintRows {
    pub constraint: Constraint,
    /// First of its rows, and how many.
    pub first: usize,
    pub count: usize,
    /// The velocities it binds.
    pub terms: Vec<Term>,
}

/// Constraints and coordinates that bind one another.
#[derive(Clone, Debug, Default)]
pub(crate) struct Group {
    pub constraints: Vec<ConstraintRows>,
    /// Rows of A in all.
    pub rows: usize,
    /// Indices of coordinates, ascending.
    pub coordinates: Vec<usize>,
    /// Its characteristic length, m: how far its bodies and frames are apart with all joints at 0.
    pub size: f64,
    /// How far from the root they are, m: places are known to an ulp of that.
    pub far: f64,
    /// For each coordinate, how far a unit rate moves a point at the characteristic length, m.
    pub lengths: Vec<f64>,
    /// The joint each coordinate is a velocity of; none for the floating base.
    pub joints: Vec<Option<JointId>>,
    /// Coordinates (by index into the group's) that change the pose: all but the floating base's, from which
    /// everything is seen.
    pub movable: Vec<usize>,
    /// Bodies that its residuals depend on and its joints' own, parents first.
    pub bodies: Vec<usize>,
    /// Whether a held contact is among its constraints.
    pub is_held: bool,
}

impl Group {
    /// Index into the group's coordinates; none for one that is not of the group.
    pub fn column(&self, coordinate: usize) -> Option<usize> {
        self.coordinates.binary_search(&coordinate).ok()
    }
}

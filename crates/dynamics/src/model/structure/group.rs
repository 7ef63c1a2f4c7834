//! Groups of constraints and coordinates that are coupled with one another. Each group has its own size. All
//! decisions about a group are relative to this size, and therefore independent of other groups.

use percuss_mechanism::JointId;

/// Tree velocity that a constraint restricts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ConstraintTerm {
    pub body: usize,
    /// Index of the velocity within the body's joint.
    pub component: usize,
    /// Sign of the velocity along the path: +1 on the successor's side, −1 on the predecessor's side; the factor of a
    /// coupling.
    pub factor: f64,
    /// Factor of the velocity in the argument of a coupling's curve; otherwise 0.
    pub argument: f64,
    /// Index of the coordinate within the group, and the multiplier of the velocity.
    pub column: usize,
    pub multiplier: f64,
}

/// Constraint with rows in A.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Constraint {
    /// Index into the model's closures.
    Closure(usize),
    /// Index into the model's couplings.
    Coupling(usize),
    /// Index into the model's held contacts.
    Hold(usize),
}

/// Rows of a constraint in its group's part of A.
#[derive(Clone, Debug)]
pub(crate) struct ConstraintRows {
    pub constraint: Constraint,
    /// First row, and number of rows.
    pub first: usize,
    pub count: usize,
    /// Restricted velocities.
    pub terms: Vec<ConstraintTerm>,
}

/// Constraints and coordinates that are coupled with one another.
#[derive(Clone, Debug, Default)]
pub(crate) struct Group {
    pub constraints: Vec<ConstraintRows>,
    /// Total number of rows of A.
    pub rows: usize,
    /// Indices of the coordinates, ascending.
    pub coordinates: Vec<usize>,
    /// Characteristic length, m: extent of the group's bodies and frames with all joints at 0.
    pub size: f64,
    /// Largest distance from the root, m; position coordinates are accurate to one ulp of this distance.
    pub far: f64,
    /// For each coordinate: displacement, m, of a point at the characteristic length at unit rate.
    pub lengths: Vec<f64>,
    /// Joint of each coordinate; `None` for the floating base.
    pub joints: Vec<Option<JointId>>,
    /// Coordinates (by index into the group) that change the pose: all except those of the floating base, because
    /// poses are relative to the base.
    pub movable: Vec<usize>,
    /// Bodies of the constraint paths and of the group's joints, parents first.
    pub bodies: Vec<usize>,
    /// True if a held contact is among the constraints.
    pub is_held: bool,
}

impl Group {
    /// Index of a coordinate within the group; `None` if the coordinate is not in the group.
    pub fn column(&self, coordinate: usize) -> Option<usize> {
        self.coordinates.binary_search(&coordinate).ok()
    }
}

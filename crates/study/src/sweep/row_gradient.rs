//! Gradient of m̄ at a row of a sweep.

use crate::values::quantities::schema_of;
use percuss_mechanism::Mechanism;
use serde::ser::{Serialize, Serializer};
use std::ops::Range;
use std::sync::Arc;

/// Movable joints, sorted by name, with the index range of each joint's velocities among those of all joints.
#[derive(Debug, PartialEq)]
pub struct GradientLayout {
    joints: Vec<(String, Range<usize>)>,
}

impl GradientLayout {
    /// Layout of a mechanism.
    pub(crate) fn new(mechanism: &Mechanism) -> Arc<Self> {
        let mut first = 0;
        let numbered = mechanism.joints().iter().map(|joint| {
            let velocities = first..first + joint.kind().dofs();
            first = velocities.end;
            (joint.name().to_owned(), velocities)
        });
        let mut joints: Vec<_> = numbered.filter(|(_, velocities)| !velocities.is_empty()).collect();
        joints.sort_by(|a, b| a.0.cmp(&b.0));
        Arc::new(Self { joints })
    }

    /// Names of the joints, and the number of velocities of each.
    pub fn joints(&self) -> impl Iterator<Item = (&str, usize)> {
        self.joints.iter().map(|(name, velocities)| (name.as_str(), velocities.len()))
    }
}

/// Gradient g of m̄, one number per velocity of every movable joint, kg/rad or kg/m: dm̄/dt = Σ g q̇ for admissible motions. Empty unless
/// m̄ is finite. In JSON: an object with a list per joint name.
#[derive(Clone, Debug, PartialEq)]
pub struct RowGradient {
    layout: Arc<GradientLayout>,
    /// One number per velocity of all joints, in joint order.
    values: Vec<f64>,
}

impl RowGradient {
    /// Gradient from one number per velocity of all joints, in joint order; empty if a number is not finite.
    pub(crate) fn new(layout: &Arc<GradientLayout>, values: Vec<f64>) -> Self {
        let values = if values.iter().all(|value| value.is_finite()) { values } else { Vec::new() };
        Self { layout: Arc::clone(layout), values }
    }

    /// Gradient by joint; empty without a value.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &[f64])> {
        let known = self.layout.joints.iter();
        known.filter_map(|(name, velocities)| Some((name.as_str(), self.values.get(velocities.clone())?)))
    }

    /// One number per velocity of every movable joint, in the order of the layout; `None` for each if m̄ is not finite.
    pub fn numbers(&self) -> impl Iterator<Item = Option<f64>> {
        let all = self.layout.joints.iter().flat_map(|(_, velocities)| velocities.clone());
        all.map(|velocity| self.values.get(velocity).copied())
    }
}

schema_of!(RowGradient, std::collections::BTreeMap<String, Vec<f64>>);

impl Serialize for RowGradient {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.iter())
    }
}

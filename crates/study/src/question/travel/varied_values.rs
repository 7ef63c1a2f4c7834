//! Varied numbers of the rows of a sweep by name. The columns are stored once and shared by all rows.

use crate::values::quantities::schema_of;
use percuss_units::Dimension;
use schemars::JsonSchema;
use serde::ser::{Serialize, Serializer};
use std::sync::Arc;

/// Varied column: a component of a joint position, or the travel of a point.
#[derive(Clone, Debug, PartialEq, serde::Serialize, JsonSchema)]
pub struct VariedColumn {
    /// Name of the column: the joint; `JOINT[0]`, `JOINT[1]`, … for a joint with several numbers; or
    /// `travel:LINK`.
    pub name: String,
    /// Unit: `rad` or `m`; empty for the components of a quaternion.
    #[serde(serialize_with = "si_unit")]
    #[schemars(with = "String")]
    pub unit: Dimension,
    /// Joint of the column; null for a travel.
    #[serde(skip)]
    pub joint: Option<String>,
}

/// Value of the varied number of a path, linear between two rows.
#[derive(Clone, Debug, PartialEq, serde::Serialize, JsonSchema)]
pub struct PathPlace {
    /// Name of the column: the joint, or the travel.
    pub name: String,
    /// Value in the unit.
    pub value: f64,
    /// Unit: `rad` or `m`; empty for the components of a quaternion.
    #[serde(serialize_with = "si_unit")]
    #[schemars(with = "String")]
    pub unit: Dimension,
}

/// Serializes the SI unit of a dimension.
#[allow(clippy::trivially_copy_pass_by_ref, reason = "signature required by serde")]
fn si_unit<S: Serializer>(unit: &Dimension, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(unit.si_unit())
}

/// Varied numbers of a row. In JSON: an object by column name.
#[derive(Clone, Debug, PartialEq)]
pub struct VariedValues {
    columns: Arc<[VariedColumn]>,
    values: Vec<f64>,
}

impl VariedValues {
    /// Values of a row, one per column.
    pub(crate) fn new(columns: &Arc<[VariedColumn]>, values: &[f64]) -> Self {
        Self { columns: Arc::clone(columns), values: values.to_vec() }
    }

    /// Numbers in the order of the columns, SI units.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Numbers by column name.
    pub fn iter(&self) -> impl Iterator<Item = (&str, f64)> {
        self.columns.iter().map(|column| column.name.as_str()).zip(self.values.iter().copied())
    }
}

schema_of!(VariedValues, std::collections::BTreeMap<String, f64>);

impl Serialize for VariedValues {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.iter())
    }
}

//! What the rows of a sweep vary, by name: the columns once, the numbers for every row.

use serde::ser::{Serialize, SerializeMap, Serializer};
use std::sync::Arc;

/// A number that is varied: of a joint, or the travel of a point.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct VariedColumn {
    /// As a column is headed: the joint, `JOINT[0]`, `JOINT[1]`, … for one with several numbers, or `travel:LINK`.
    pub name: String,
    /// `rad` or `m`; empty for the components of a quaternion.
    pub unit: &'static str,
    /// The joint whose number it is; none for a travel.
    #[serde(skip)]
    pub joint: Option<String>,
}

/// The varied numbers of a row. In JSON by name.
#[derive(Clone, Debug, PartialEq)]
pub struct VariedValues {
    columns: Arc<[VariedColumn]>,
    values: Vec<f64>,
}

impl VariedValues {
    pub(crate) fn new(columns: &Arc<[VariedColumn]>, values: &[f64]) -> Self {
        Self { columns: Arc::clone(columns), values: values.to_vec() }
    }

    /// The numbers, in the order of the columns: SI units.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The numbers by name.
    pub fn iter(&self) -> impl Iterator<Item = (&str, f64)> {
        self.columns.iter().map(|column| column.name.as_str()).zip(self.values.iter().copied())
    }
}

impl Serialize for VariedValues {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.values.len()))?;
        for (name, value) in self.iter() {
            map.serialize_entry(name, &value)?;
        }
        map.end()
    }
}

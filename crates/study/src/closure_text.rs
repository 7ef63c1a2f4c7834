//! A closure in a study file.

use crate::refusal::Refusal;
use crate::study_value;
use nalgebra::Vector3;
use percuss_mechanism::{ClosureDescription, ClosureKind};
use percuss_spatial::{Transform, rotation_from_rpy};
use serde::Deserialize;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ClosureText {
    pub name: String,
    #[serde(rename = "type")]
    pub kind: String,
    pub predecessor: String,
    #[serde(default, deserialize_with = "study_value::lengths")]
    pub predecessor_xyz: [f64; 3],
    #[serde(default, deserialize_with = "study_value::angles")]
    pub predecessor_rpy: [f64; 3],
    pub successor: String,
    #[serde(default, deserialize_with = "study_value::lengths")]
    pub successor_xyz: [f64; 3],
    #[serde(default, deserialize_with = "study_value::angles")]
    pub successor_rpy: [f64; 3],
    #[serde(default, deserialize_with = "study_value::plain")]
    pub axis: Option<[f64; 3]>,
    #[serde(default, deserialize_with = "study_value::plain")]
    pub axis2: Option<[f64; 3]>,
    #[serde(default, deserialize_with = "study_value::length")]
    pub distance: Option<f64>,
}

impl ClosureText {
    pub fn describe(&self) -> Result<ClosureDescription, Refusal> {
        let named = if self.kind == "continuous" { "revolute" } else { &self.kind };
        let Some(kind) = ClosureKind::ALL.into_iter().find(|k| k.name() == named) else {
            let known: Vec<&str> = ClosureKind::ALL.iter().map(|k| k.name()).collect();
            return Err(Refusal::new(
                "closure.type",
                format!("\"{}\"; known are {}", self.kind, known.join(", ")),
            ));
        };
        let frame = |xyz: [f64; 3], rpy| Transform::new(rotation_from_rpy(rpy), xyz.into());
        let mut closure = ClosureDescription::new(&self.name, kind, &self.predecessor, &self.successor);
        closure.predecessor_frame = frame(self.predecessor_xyz, self.predecessor_rpy);
        closure.successor_frame = frame(self.successor_xyz, self.successor_rpy);
        closure.axis = self.axis.map_or(closure.axis, Vector3::from);
        closure.axis2 = self.axis2.map_or(closure.axis2, Vector3::from);
        closure.distance = self.distance;
        Ok(closure)
    }
}

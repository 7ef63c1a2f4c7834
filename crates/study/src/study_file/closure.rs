//! A closure in a study file.

use crate::question::errors::refusal::InvalidKey;
use crate::values::value::{self, NumberOrText, Triple};
use nalgebra::Vector3;
use percuss_mechanism::{ClosureDescription, ClosureKind};
use percuss_spatial::{Transform, rotation_from_rpy};
use schemars::JsonSchema;
use serde::Deserialize;

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ClosureText {
    /// Name of the loop.
    pub name: String,
    /// Kind of the loop, which defines the free motions.
    #[serde(rename = "type")]
    #[schemars(extend("enum" = kinds()))]
    pub kind: String,
    /// The first link.
    pub predecessor: String,
    /// Origin of the loop's frame in the first link, m.
    #[serde(default, deserialize_with = "value::lengths")]
    #[schemars(with = "Option<Triple>")]
    pub predecessor_xyz: [f64; 3],
    /// Axes of the loop's frame: roll, pitch, yaw, rad.
    #[serde(default, deserialize_with = "value::angles")]
    #[schemars(with = "Option<Triple>")]
    pub predecessor_rpy: [f64; 3],
    /// The second link.
    pub successor: String,
    /// Origin of the loop's frame in the second link, m.
    #[serde(default, deserialize_with = "value::lengths")]
    #[schemars(with = "Option<Triple>")]
    pub successor_xyz: [f64; 3],
    /// Axes of the loop's frame: roll, pitch, yaw, rad.
    #[serde(default, deserialize_with = "value::angles")]
    #[schemars(with = "Option<Triple>")]
    pub successor_rpy: [f64; 3],
    /// The axis, in the first frame.
    #[serde(default, deserialize_with = "value::plain")]
    #[schemars(with = "Option<Triple>")]
    pub axis: Option<[f64; 3]>,
    /// The second axis of a universal loop, in the second frame.
    #[serde(default, deserialize_with = "value::plain")]
    #[schemars(with = "Option<Triple>")]
    pub axis2: Option<[f64; 3]>,
    /// The distance of a rod, m; default: the distance with all joints at 0.
    #[serde(default, deserialize_with = "value::length")]
    #[schemars(with = "Option<NumberOrText>")]
    pub distance: Option<f64>,
}

/// Names of the kinds of loops.
fn kinds() -> Vec<&'static str> {
    ClosureKind::ALL.iter().map(|kind| kind.name()).chain(["continuous"]).collect()
}

impl ClosureText {
    /// Converts the keys to a closure.
    pub fn closure_description(&self) -> Result<ClosureDescription, InvalidKey> {
        let named = if self.kind == "continuous" { "revolute" } else { &self.kind };
        let Some(kind) = ClosureKind::ALL.into_iter().find(|k| k.name() == named) else {
            let known: Vec<&str> = ClosureKind::ALL.iter().map(|k| k.name()).collect();
            return Err(InvalidKey::new(
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

//! A closure in a study file.

use crate::question::errors::refusal::InvalidKey;
use crate::values::quantities::{Angles, Length, Point, Vector};
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
    #[serde(default)]
    pub predecessor_xyz: Point,
    /// Axes of the loop's frame: roll, pitch, yaw, rad.
    #[serde(default)]
    pub predecessor_rpy: Angles,
    /// The second link.
    pub successor: String,
    /// Origin of the loop's frame in the second link, m.
    #[serde(default)]
    pub successor_xyz: Point,
    /// Axes of the loop's frame: roll, pitch, yaw, rad.
    #[serde(default)]
    pub successor_rpy: Angles,
    /// The axis, in the first frame.
    pub axis: Option<Vector>,
    /// The second axis of a universal loop, in the second frame.
    pub axis2: Option<Vector>,
    /// The distance of a rod, m; default: the distance with all joints at 0.
    pub distance: Option<Length>,
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
        let frame = |xyz: Point, rpy: Angles| Transform::new(rotation_from_rpy(rpy.0), xyz.0.into());
        let mut closure = ClosureDescription::new(&self.name, kind, &self.predecessor, &self.successor);
        closure.predecessor_frame = frame(self.predecessor_xyz, self.predecessor_rpy);
        closure.successor_frame = frame(self.successor_xyz, self.successor_rpy);
        closure.axis = self.axis.map_or(closure.axis, |axis| axis.0.into());
        closure.axis2 = self.axis2.map_or(closure.axis2, |axis| axis.0.into());
        closure.distance = self.distance.map(|length| length.0);
        Ok(closure)
    }
}

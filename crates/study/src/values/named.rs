//! Values of flags with a name: `NAME=VALUE`.

use crate::values::drives::{GivenGearLimits, GivenSpring};
use crate::values::position::GivenPosition;
use crate::values::quantities::{Mass, Moments, Point};
use crate::values::rates::GivenRates;
use crate::values::value::reflected_inertias;
use std::fmt::Display;
use std::path::PathBuf;
use std::str::FromStr;

/// `NAME=VALUE` of a flag, split at the last equals sign.
fn named<T: FromStr<Err: Display>>(text: &str, expected: &str) -> Result<(String, T), String> {
    match text.rsplit_once('=') {
        Some((name, value)) if !name.is_empty() && !value.is_empty() => {
            Ok((name.to_owned(), value.parse().map_err(|error: T::Err| error.to_string())?))
        }
        _ => Err(format!("expected {expected}")),
    }
}

/// `JOINT=VALUE` of a flag: position of a joint, with optional units.
pub fn joint_position(text: &str) -> Result<(String, GivenPosition), String> {
    named(text, "JOINT=VALUE, such as elbow=30deg")
}

/// `JOINT=RATE` of a flag: velocities of a joint, with optional units.
pub fn joint_rates(text: &str) -> Result<(String, GivenRates), String> {
    named(text, "JOINT=RATE, such as crank=2rad/s")
}

/// `JOINT=VALUES` of a flag: reflected inertias.
pub fn joint_armature(text: &str) -> Result<(String, Vec<f64>), String> {
    let (joint, values): (String, String) =
        named(text, "JOINT=VALUE, such as elbow=0.3 or elbow=100:1e-5kg·m²")?;
    Ok((joint, reflected_inertias(&values)?))
}

/// `JOINT=LIMIT` of a flag: limits of a gear, with optional units.
pub fn gear_limit(text: &str) -> Result<(String, GivenGearLimits), String> {
    named(text, "JOINT=LIMIT, such as elbow=0.5N·m·s or elbow=80N·m")
}

/// `JOINT=K,D` of a flag: spring and damper of a joint, with optional units.
pub fn joint_spring(text: &str) -> Result<(String, GivenSpring), String> {
    named(text, "JOINT=K,D, such as elbow=900,4")
}

/// `JOINT=K,D` of a flag: stiffness and damping of a gear, with optional units.
pub fn gear_stiffness(text: &str) -> Result<(String, GivenSpring), String> {
    named(text, "JOINT=K,D, such as elbow=9e4,19")
}

/// `LINK=KG` of a flag.
pub fn link_mass(text: &str) -> Result<(String, Mass), String> {
    named(text, "LINK=KG, such as upright=10kg")
}

/// `LINK=X,Y,Z` of a flag.
pub fn link_com(text: &str) -> Result<(String, Point), String> {
    named(text, "LINK=X,Y,Z, such as upright=0,20mm,0")
}

/// `LINK=IXX,IYY,IZZ` of a flag: link and moments of inertia.
pub fn link_inertia(text: &str) -> Result<(String, Moments), String> {
    named(text, "LINK=IXX,IYY,IZZ, such as upright=0.04,0.03,0.02")
}

/// `POINT=X,Y,Z` of a flag: hardpoint and displacement.
pub fn point_shift(text: &str) -> Result<(String, Point), String> {
    named(text, "POINT=X,Y,Z, such as lower_ball=0,0,5mm")
}

/// `NAME=FOLDER` of a flag.
pub fn package(text: &str) -> Result<(String, PathBuf), String> {
    named(text, "NAME=FOLDER, such as ur_description=/opt/ros/share/ur_description")
}

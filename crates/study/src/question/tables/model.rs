//! Model table of a study file.

#[cfg(feature = "flags")]
use super::headings::{CHANGES, READING};
use crate::model::changes::Changes;
#[cfg(feature = "flags")]
use crate::values::named;
use crate::values::quantities::{Mass, Moments, Point};
use crate::values::value;
use percuss_mechanism::Accept;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Finding that is accepted in a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum Acceptable {
    /// Inertias with a negative principal moment.
    IndefiniteInertia,
    /// Inertias far too large for the size of the links.
    ImplausibleInertia,
    /// A second inertial of a link in a URDF: the first one counts.
    SecondInertial,
}

/// Contents of a model: links, joints, loops, mobility. The table has no keys.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CheckQuestion {}

/// Model of a question, with changes.
#[derive(Clone, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = CHANGES))]
#[serde(deny_unknown_fields)]
pub struct ModelTable {
    /// A URDF, MJCF or SDFormat file, or a suspension's sheet or table.
    #[cfg_attr(feature = "flags", arg(skip))]
    pub path: String,
    /// Name of the model among its variants in tables and figures; default: the name of the study.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Worksheet of a workbook; default: the first one.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NAME", help_heading = READING))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub worksheet: Option<String>,
    /// Masses and inertias from the shapes of the links: shapes, or shapes:DENSITY (kg/m³).
    ///
    /// Collision shapes, or visual ones of a link without; a mesh is its convex hull. Default density: 1000 kg/m³. Links without a shape keep
    /// their masses. A warning marks the results as estimates.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "shapes[:DENSITY]", value_parser = value::density_of_shapes, help_heading = READING)
    )]
    #[serde(
        default,
        deserialize_with = "value::shape_density",
        serialize_with = "value::shape_density_text",
        skip_serializing_if = "Option::is_none"
    )]
    #[schemars(with = "Option<String>")]
    pub masses: Option<f64>,
    /// Scale the masses and inertias of all links to this total (kg), after all other changes.
    #[cfg_attr(feature = "flags", arg(long, value_name = "KG", help_heading = READING))]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub total_mass: Option<Mass>,
    /// Change the mass of a link (kg).
    ///
    /// The moments of inertia about the centre of mass are scaled by the same factor.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK=KG", value_parser = named::link_mass, allow_hyphen_values = true))]
    #[serde(default, with = "value::named_values", skip_serializing_if = "Vec::is_empty")]
    #[schemars(with = "BTreeMap<String, Mass>")]
    pub link_mass: Vec<(String, Mass)>,
    /// Change the centre of mass of a link (m, link frame).
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK=X,Y,Z", value_parser = named::link_com, allow_hyphen_values = true))]
    #[serde(default, with = "value::named_values", skip_serializing_if = "Vec::is_empty")]
    #[schemars(with = "BTreeMap<String, Point>")]
    pub link_com: Vec<(String, Point)>,
    /// Change the moments of inertia of a link about its centre of mass (kg·m²).
    ///
    /// Three moments about the axes of the link frame, applied after a change of the mass; the products of inertia are unchanged. Units:
    /// kg m2, kg mm2, lb in2.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "LINK=IXX,IYY,IZZ", value_parser = named::link_inertia, allow_hyphen_values = true)
    )]
    #[serde(default, with = "value::named_values", skip_serializing_if = "Vec::is_empty")]
    #[schemars(with = "BTreeMap<String, Moments>")]
    pub link_inertia: Vec<(String, Moments)>,
    /// Shift a hardpoint of a suspension sheet (m; 5mm).
    ///
    /// The shift is in the axes of the sheet; numbers without a unit are in m.
    #[cfg_attr(
        feature = "flags",
        arg(long = "move", value_name = "POINT=X,Y,Z", value_parser = named::point_shift, allow_hyphen_values = true)
    )]
    #[serde(default, rename = "move", with = "value::named_values", skip_serializing_if = "Vec::is_empty")]
    #[schemars(with = "BTreeMap<String, Point>")]
    pub moves: Vec<(String, Point)>,
    /// Accept a model in spite of this finding.
    #[cfg_attr(feature = "flags", arg(long, value_enum, value_name = "FINDING", help_heading = READING))]
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub accept: Vec<Acceptable>,
}

/// Entries of a table of points.
pub(crate) fn points(table: &[(String, Point)]) -> Vec<(String, [f64; 3])> {
    table.iter().map(|(name, point)| (name.clone(), point.0)).collect()
}

/// Entries of a table of moments of inertia.
pub(crate) fn moments(table: &[(String, Moments)]) -> Vec<(String, [f64; 3])> {
    table.iter().map(|(name, moments)| (name.clone(), moments.0)).collect()
}

/// Entries of a table of masses.
pub(crate) fn masses(table: &[(String, Mass)]) -> Vec<(String, f64)> {
    table.iter().map(|(name, mass)| (name.clone(), mass.0)).collect()
}

impl ModelTable {
    /// Accepted findings.
    pub fn accepted(&self) -> Accept {
        Accept {
            indefinite_inertia: self.accept.contains(&Acceptable::IndefiniteInertia),
            implausible_inertia: self.accept.contains(&Acceptable::ImplausibleInertia),
            second_inertial: self.accept.contains(&Acceptable::SecondInertial),
        }
    }

    /// Changes to the model.
    pub fn changes(&self) -> Changes {
        Changes {
            shape_density: self.masses,
            total_mass: self.total_mass.map(|mass| mass.0),
            link_mass: masses(&self.link_mass),
            link_com: points(&self.link_com),
            link_inertia: moments(&self.link_inertia),
            moves: points(&self.moves),
        }
    }
}

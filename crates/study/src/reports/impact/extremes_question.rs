//! Question about extremes over positions.

use crate::damper::damping::damper;
use crate::evaluation::status::mass_unit;
use crate::question::damping_question::DampingQuestion;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::field::Field;
use crate::question::mass_question::triples;
use crate::question::row_source::RowSource;
use crate::reports::impact::additions::{find_bearing, find_joint};
use percuss_impact::{NormalRange, PeakForceLaw, SearchedQuantity};
use percuss_mechanism::{JointKind, Mechanism};
use percuss_units::{Dimension, Quantity};

/// Positions of the search, quantity and number of starts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExtremesQuestion {
    /// Ranges of the joints that vary. Empty for the limits of all driving joints with limits, except (without `keep`) those with a given
    /// position.
    pub ranges: Vec<GivenRange>,
    /// Links and points that stay in place over the ranges: the search covers the self-motion of the mechanism.
    pub keep: Vec<Keep>,
    /// Path of positions, in place of `ranges` and `keep`; `None` for a search over ranges.
    pub path: Option<RowSource>,
    /// Quantity whose extremes are searched.
    pub quantity: GivenQuantity,
    /// Contact law with restitution and closing speed; required for a peak force, not used for other quantities.
    pub law: Option<DampingQuestion>,
    /// Dimensions of the given units: of the closing speed, then of the stiffness of `law`; `None` for a number without a unit.
    pub dimensions: [Option<Dimension>; 2],
    /// Normals among which the extremes are searched.
    pub normals: GivenNormals,
    /// Number of starts of the search; 0 for the default.
    pub starts: usize,
}

/// Normals of the contact among which extremes are searched.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GivenNormals(pub NormalRange);

impl std::str::FromStr for GivenNormals {
    type Err = String;
    /// Reads `given`, `any` or `across:X,Y,Z`.
    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "given" => return Ok(Self(NormalRange::Given)),
            "any" => return Ok(Self(NormalRange::Any)),
            _ => {}
        }
        let wrong = || "expected given, any or across:X,Y,Z (world axes), such as across:0,0,1".to_owned();
        let axis = text.strip_prefix("across:").ok_or_else(wrong)?;
        let axis = percuss_units::parse_triple(axis, Dimension::Plain)
            .map_err(|error| format!("across:X,Y,Z is expected: {error}"))?;
        Ok(Self(NormalRange::Across(axis.into())))
    }
}

/// Quantity whose extremes are searched.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum GivenQuantity {
    /// Effective mass of the contact.
    #[default]
    Mass,
    /// Inertia reflected to a joint, with the other drivers free.
    Reflected(String),
    /// Inertia reflected to a joint, with the other drivers at rest.
    Held(String),
    /// Impulse in a bearing (joint, closure or `ground`) per closing speed, of a plastic impact.
    Bearing(String),
    /// Peak force in a bearing with the contact law of the question.
    Peak(String),
}

impl std::str::FromStr for GivenQuantity {
    type Err = String;
    /// Reads `mass`, `reflected:JOINT`, `held:JOINT`, `bearing:JOINT` or `peak:JOINT`.
    fn from_str(text: &str) -> Result<Self, String> {
        if text == "mass" {
            return Ok(Self::Mass);
        }
        match text.split_once(':') {
            Some(("reflected", joint)) => Ok(Self::Reflected(joint.to_owned())),
            Some(("held", joint)) => Ok(Self::Held(joint.to_owned())),
            Some(("bearing", joint)) => Ok(Self::Bearing(joint.to_owned())),
            Some(("peak", joint)) => Ok(Self::Peak(joint.to_owned())),
            _ => Err("expected mass, reflected:JOINT, held:JOINT, bearing:JOINT or peak:JOINT; for bearing and peak, JOINT can also be a \
                      loop closure or ground"
                .to_owned()),
        }
    }
}

impl GivenQuantity {
    /// Name of the quantity in reports: `effective_mass`, `reflected_inertia`, `held_inertia`, `bearing_impulse` or `bearing_peak_force`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Mass => "effective_mass",
            Self::Reflected(_) => "reflected_inertia",
            Self::Held(_) => "held_inertia",
            Self::Bearing(_) => "bearing_impulse",
            Self::Peak(_) => "bearing_peak_force",
        }
    }

    /// Joint or bearing of the quantity; `None` for the effective mass.
    pub fn joint(&self) -> Option<&str> {
        match self {
            Self::Mass => None,
            Self::Reflected(joint) | Self::Held(joint) | Self::Bearing(joint) | Self::Peak(joint) => {
                Some(joint)
            }
        }
    }

    /// Quantity of the search, and its unit. `is_moment`: true if the contact is a moment; `law`: contact law of a peak force.
    pub(crate) fn searched(
        &self,
        mechanism: &Mechanism,
        is_moment: bool,
        law: Option<&DampingQuestion>,
    ) -> Result<(SearchedQuantity, &'static str), StudyError> {
        if law.is_some() && !matches!(self, Self::Peak(_)) {
            return Err(StudyError::input(Field::Quantity, Fault::PeakAndLaw));
        }
        let Some(name) = self.joint() else {
            return Ok((SearchedQuantity::EffectiveMass, mass_unit(is_moment)));
        };
        let bearing = || find_bearing(mechanism, Field::Quantity, name);
        let held = match self {
            Self::Bearing(_) => {
                let quantity = SearchedQuantity::BearingImpulse { bearing: bearing()? };
                return Ok((quantity, if is_moment { "kg·m" } else { "kg" }));
            }
            Self::Peak(_) => {
                let law = law.ok_or_else(|| StudyError::input(Field::Quantity, Fault::PeakAndLaw))?;
                let law = peak_force_law(law)?;
                return Ok((SearchedQuantity::BearingPeakForce { bearing: bearing()?, law }, "N"));
            }
            Self::Mass | Self::Reflected(_) => false,
            Self::Held(_) => true,
        };
        let joint = find_joint(mechanism, Field::Quantity, name)?;
        let quantity = SearchedQuantity::ReflectedInertia { joint, held };
        let slides = mechanism.joint(joint).kind() == JointKind::Prismatic;
        Ok((quantity, if slides { "kg" } else { "kg·m²" }))
    }
}

/// Peak force of a contact law at its closing speed, as a function force · m̄^power of the effective mass.
fn peak_force_law(law: &DampingQuestion) -> Result<PeakForceLaw, StudyError> {
    let force = damper(law, 1.0)?.peak_force;
    let force = force.ok_or_else(|| StudyError::input(Field::Quantity, Fault::PeakAndLaw))?;
    Ok(PeakForceLaw { force, power: law.exponent / (law.exponent + 1.0) })
}

/// Range of a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenRange {
    /// The joint.
    pub joint: String,
    /// Lower end.
    pub lower: Quantity,
    /// Upper end.
    pub upper: Quantity,
}

impl std::str::FromStr for GivenRange {
    type Err = String;
    /// Reads `JOINT=FROM:TO`.
    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "expected JOINT=FROM:TO, such as elbow=10deg:170deg".to_owned();
        let (joint, range) =
            text.rsplit_once('=').filter(|(joint, _)| !joint.is_empty()).ok_or_else(wrong)?;
        let (lower, upper) = range.split_once(':').ok_or_else(wrong)?;
        let end = |text: &str| Quantity::parse(text).map_err(|error| error.to_string());
        Ok(Self { joint: joint.to_owned(), lower: end(lower)?, upper: end(upper)? })
    }
}

/// Link or point that stays in place: a link with its orientation, a point of a link (m, link's frame), or the coordinate of this point
/// along a direction (world axes).
#[derive(Clone, Debug, PartialEq)]
pub struct Keep {
    /// The link.
    pub link: String,
    /// The point; `None` for the position and the orientation of the link.
    pub point: Option<[f64; 3]>,
    /// The direction; `None` for all directions.
    pub normal: Option<[f64; 3]>,
}

impl std::str::FromStr for Keep {
    type Err = String;
    /// Reads `LINK`, `LINK:X,Y,Z` or `LINK:X,Y,Z:NX,NY,NZ`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (link, found) = triples(text);
        if link.is_empty() {
            return Err("expected LINK, LINK:X,Y,Z or LINK:X,Y,Z:NX,NY,NZ, such as tool:0,0,0.1".into());
        }
        let read = |text: &&str, dimension| percuss_units::parse_triple(text, dimension);
        let point = found.first().map(|text| read(text, Dimension::Length)).transpose();
        let normal = found.get(1).map(|text| read(text, Dimension::Plain)).transpose();
        Ok(Self {
            link: link.to_owned(),
            point: point.map_err(|error| error.to_string())?,
            normal: normal.map_err(|error| error.to_string())?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use percuss_contact::Law;

    /// For every law, exponent and restitution, the peak force is proportional to the same power p/(p+1) of the mass.
    #[test]
    fn peak_forces_are_powers_of_the_mass() {
        let mut count = 0;
        for law in Law::ALL {
            for (exponent, restitution) in [(1.0, 0.0), (1.0, 0.4), (1.5, 0.4), (1.5, 1.0), (2.2, 0.7)] {
                let mut question = DampingQuestion::new(restitution, 3e4);
                (question.law, question.exponent, question.speed) = (law, exponent, Some(1.7));
                let Ok(power_law) = peak_force_law(&question) else { continue };
                for mass in [0.03, 2.0, 700.0] {
                    let force = damper(&question, mass).expect("a damper").peak_force.expect("a force");
                    let expected = power_law.force * mass.powf(power_law.power);
                    assert!(
                        (force / expected - 1.0).abs() < 1e-8,
                        "{law:?} {exponent} {restitution} {mass}: {force} {expected}"
                    );
                    count += 1;
                }
            }
        }
        assert!(count >= 15, "{count}");
    }
}

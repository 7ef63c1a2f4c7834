//! Couplings: relations between the positions of tree joints.

use crate::{JointId, LinkId};

/// Relation between the positions of joints with one degree of freedom,
///
/// ```text
/// Σ fᵢ qᵢ = c + a₂ s² + a₃ s³ + a₄ s⁴,    s = s₀ + Σ gⱼ qⱼ
/// ```
///
/// with one row in A: entry fᵢ − (2 a₂ s + 3 a₃ s² + 4 a₄ s³) gᵢ of joint i. Without a curve the relation is linear. A ratio between
/// the rates of two links is the relation Σ q (successor) − ratio · Σ q (predecessor) = 0 over the joints from their nearest common
/// ancestor.
#[derive(Clone, Debug)]
pub struct Coupling {
    pub(crate) name: String,
    pub(crate) ratio: Option<LinkRatio>,
    pub(crate) terms: Vec<(JointId, f64)>,
    pub(crate) constant: f64,
    pub(crate) curve: Option<Curve>,
}

/// Ratio between the rates of two links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkRatio {
    /// Link with the independent rate.
    pub predecessor: LinkId,
    /// Link with the dependent rate.
    pub successor: LinkId,
    /// Rate of the successor divided by the rate of the predecessor.
    pub ratio: f64,
}

/// Higher powers of a coupling: a₂ s² + a₃ s³ + a₄ s⁴ with s = s₀ + Σ gⱼ qⱼ.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    pub(crate) terms: Vec<(JointId, f64)>,
    pub(crate) offset: f64,
    pub(crate) coefficients: [f64; 3],
}

impl Coupling {
    /// Name, unique among closures and couplings.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Ratio of two links; `None` for a coupling of joints.
    pub fn ratio(&self) -> Option<LinkRatio> {
        self.ratio
    }

    /// Joints with the factors fᵢ. Of a ratio of links: +1 on the successor's path, −ratio on the predecessor's path.
    pub fn terms(&self) -> &[(JointId, f64)] {
        &self.terms
    }

    /// Constant c, in the unit of the terms.
    pub fn constant(&self) -> f64 {
        self.constant
    }

    /// Higher powers; `None` for a linear coupling.
    pub fn curve(&self) -> Option<&Curve> {
        self.curve.as_ref()
    }
}

impl Curve {
    /// Joints with the factors gⱼ. Each of them is among [`Coupling::terms`] too.
    pub fn terms(&self) -> &[(JointId, f64)] {
        &self.terms
    }

    /// Offset s₀ of the argument.
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// Coefficients a₂, a₃, a₄.
    pub fn coefficients(&self) -> [f64; 3] {
        self.coefficients
    }
}

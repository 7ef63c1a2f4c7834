//! Compiled closures and couplings.

use super::body::LinkFrame;
use nalgebra::Vector3;
use percuss_mechanism::ClosureKind;

/// A compiled closure.
#[derive(Clone, Debug)]
pub(crate) struct CompiledClosure {
    pub name: String,
    pub kind: ClosureKind,
    pub predecessor: LinkFrame,
    pub successor: LinkFrame,
    /// Axis in the predecessor's loop frame.
    pub axis: Vector3<f64>,
    /// Axis in the successor's loop frame, for kinds that align axes: equal to `axis` or reversed.
    pub successor_axis: Vector3<f64>,
    /// Two unit vectors normal to the axis.
    pub normals: [Vector3<f64>; 2],
    /// Second axis of a universal closure, on the successor.
    pub axis2: Vector3<f64>,
    /// Distance of a distance closure, m.
    pub distance: f64,
    /// True if the distance was not declared, and is measured with all joints at 0.
    pub measured_distance: bool,
}

/// A compiled coupling: Σ factor · q = constant + Σ cₖ sᵏ for k = 2, 3, 4, with s = offset + Σ argument · q.
#[derive(Clone, Debug)]
pub(crate) struct CompiledCoupling {
    pub name: String,
    pub terms: Vec<CouplingTerm>,
    /// True if the sum is an angle (rad), false for a length (m).
    pub turns: bool,
    pub constant: f64,
    pub offset: f64,
    /// Coefficients c₂, c₃, c₄; `None` for a linear coupling.
    pub curve: Option<[f64; 3]>,
}

/// Joint of a coupling.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CouplingTerm {
    /// Index of the position.
    pub q: usize,
    pub body: usize,
    pub factor: f64,
    /// Factor in the argument of the curve.
    pub argument: f64,
}

impl CompiledCoupling {
    /// Argument s of the curve at the positions q.
    fn argument(&self, q: &[f64]) -> f64 {
        self.offset + self.terms.iter().map(|term| term.argument * q[term.q]).sum::<f64>()
    }

    /// Σ factor · q − constant − Σ cₖ sᵏ.
    pub fn residual(&self, q: &[f64]) -> f64 {
        let sum: f64 = self.terms.iter().map(|term| term.factor * q[term.q]).sum();
        let Some([c2, c3, c4]) = self.curve else { return sum - self.constant };
        let s = self.argument(q);
        sum - self.constant - s * s * (c2 + s * (c3 + s * c4))
    }

    /// Error of the row's entries by the rounding of the curve, in roundings of the largest entry.
    pub fn slope_roundings(&self, q: &[f64]) -> f64 {
        let Some(curve) = self.curve else { return 0.0 };
        let terms = self.terms.iter().map(|term| (term.argument * q[term.q]).abs());
        let size = self.offset.abs() + terms.sum::<f64>();
        let [c2, c3, c4] = curve.map(f64::abs);
        // k² |cₖ| Sᵏ⁻¹: derivative of a term of the slope, times its argument.
        let slope = size * (4.0 * c2 + size * (9.0 * c3 + size * 16.0 * c4));
        let [actual, _] = self.curve_derivatives(q);
        let largest = |value: &dyn Fn(&CouplingTerm) -> f64| self.terms.iter().map(value).fold(0.0, f64::max);
        let entry = largest(&|term| (term.factor - actual * term.argument).abs());
        let error = slope * largest(&|term| term.argument.abs());
        if error == 0.0 { 0.0 } else { error / entry }
    }

    /// First and second derivative of Σ cₖ sᵏ with respect to s.
    pub fn curve_derivatives(&self, q: &[f64]) -> [f64; 2] {
        let Some([c2, c3, c4]) = self.curve else { return [0.0; 2] };
        let s = self.argument(q);
        [s * (2.0 * c2 + s * (3.0 * c3 + s * 4.0 * c4)), 2.0 * c2 + s * (6.0 * c3 + s * 12.0 * c4)]
    }
}

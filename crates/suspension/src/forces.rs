//! Forces of springs and stops as given in a sheet. They have no influence on the mechanism.

/// Spring with a constant rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpringForce {
    /// Rate k, N/m: the force grows by k per compression.
    pub rate: f64,
    /// Force at the design position, N; positive: the spring is compressed. `None` if the sheet does not state the force.
    pub preload: Option<f64>,
}

/// Force of a stop over the compression after the touch, piecewise linear; the last slope continues.
#[derive(Clone, Debug, PartialEq)]
pub struct StopForce {
    /// Compressions, m, in increasing order, from 0.
    deflections: Vec<f64>,
    /// Force at each compression, N.
    forces: Vec<f64>,
}

impl StopForce {
    /// Creates a curve; `None` unless both lists have the same length of at least two, and the compressions begin at 0
    /// and increase.
    pub fn new(deflections: Vec<f64>, forces: Vec<f64>) -> Option<Self> {
        let increases = deflections.windows(2).all(|pair| pair[0] < pair[1]);
        let is_curve = deflections.len() >= 2 && deflections.len() == forces.len() && deflections[0] == 0.0;
        (is_curve && increases).then_some(Self { deflections, forces })
    }

    /// Last point of the curve: compression (m) and force (N).
    pub fn end(&self) -> (f64, f64) {
        let last = |values: &[f64]| values.last().copied().unwrap_or_default();
        (last(&self.deflections), last(&self.forces))
    }

    /// Force (N) and its slope (N/m) at a compression (m); zero before the touch. At a corner of the curve, the slope is that of the
    /// next piece.
    pub fn at(&self, compression: f64) -> (f64, f64) {
        if compression < 0.0 {
            return (0.0, 0.0);
        }
        let next =
            self.deflections.partition_point(|x| *x <= compression).clamp(1, self.deflections.len() - 1);
        let piece = next - 1;
        let slope =
            (self.forces[next] - self.forces[piece]) / (self.deflections[next] - self.deflections[piece]);
        (self.forces[piece] + slope * (compression - self.deflections[piece]), slope)
    }
}

/// Forces of one side, by the section of the sheet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ForceElements {
    /// Springs.
    pub springs: Vec<(String, SpringForce)>,
    /// Stops.
    pub stops: Vec<(String, StopForce)>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_is_piecewise_linear() {
        let curve = StopForce::new(vec![0.0, 0.01, 0.03], vec![0.0, 100.0, 700.0]).unwrap();
        for (compression, force, slope) in
            [(-0.01, 0.0, 0.0), (0.0, 0.0, 1e4), (0.005, 50.0, 1e4), (0.01, 100.0, 3e4), (0.05, 1300.0, 3e4)]
        {
            let (f, k) = curve.at(compression);
            assert!((f - force).abs() < 1e-9 && (k - slope).abs() < 1e-7, "{compression}: {f} {k}");
        }
        assert_eq!(StopForce::new(vec![0.0, 0.0], vec![0.0, 1.0]), None);
        assert_eq!(StopForce::new(vec![0.0], vec![0.0]), None);
        assert_eq!(StopForce::new(vec![0.001, 0.002], vec![0.0, 1.0]), None);
    }
}

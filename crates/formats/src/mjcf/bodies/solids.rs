//! Volumes and inertias of primitive shapes: solid, or a thin shell with the mass spread evenly over the surface.

use crate::shape::Solid;
use std::f64::consts::PI;

/// Volume (m³; area, m², of a shell) and principal moments for a mass of 1 kg, m², about the centre of the shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct UnitInertia {
    pub volume: f64,
    pub moments: [f64; 3],
}

/// Unit inertia of a solid; `None` for a mesh.
pub(crate) fn unit_inertia(solid: &Solid, is_shell: bool) -> Option<UnitInertia> {
    Some(match solid {
        Solid::Box { size } => cuboid(size.map(|edge| edge / 2.0), is_shell),
        Solid::Sphere { radius } => sphere(*radius, is_shell),
        Solid::Cylinder { radius, length } => cylinder(*radius, length / 2.0, is_shell),
        Solid::Capsule { radius, length } => capsule(*radius, length / 2.0, is_shell),
        Solid::Mesh { .. } => return None,
    })
}

/// Part of a shape: volume or area, and the moments of a unit mass across and along the z-axis.
type Part = (f64, f64, f64);

/// Body of revolution about z, made of parts with a common density.
fn revolved(parts: [Part; 2]) -> UnitInertia {
    let volume = parts.iter().map(|(volume, ..)| volume).sum::<f64>();
    let mean =
        |moment: fn(&Part) -> f64| parts.iter().map(|part| part.0 * moment(part)).sum::<f64>() / volume;
    let across = mean(|part| part.1);
    UnitInertia { volume, moments: [across, across, mean(|part| part.2)] }
}

/// Sphere.
fn sphere(radius: f64, is_shell: bool) -> UnitInertia {
    let square = radius * radius;
    let (volume, moment) = if is_shell {
        (4.0 * PI * square, 2.0 / 3.0 * square)
    } else {
        (4.0 / 3.0 * PI * square * radius, 0.4 * square)
    };
    UnitInertia { volume, moments: [moment; 3] }
}

/// Cylinder along z with half-spheres at its ends; `half` is half the length of the cylinder.
fn capsule(radius: f64, half: f64, is_shell: bool) -> UnitInertia {
    let (r2, h2) = (radius * radius, half * half);
    let ends = sphere(radius, is_shell);
    let [end, ..] = ends.moments;
    // The centroid of a half-sphere is 3/8 of the radius from its base, that of its shell one half.
    let (middle, centroid) = if is_shell {
        ((4.0 * PI * radius * half, r2 / 2.0 + h2 / 3.0, r2), 0.5)
    } else {
        ((2.0 * PI * r2 * half, r2 / 4.0 + h2 / 3.0, r2 / 2.0), 0.375)
    };
    revolved([middle, (ends.volume, end + h2 + 2.0 * centroid * radius * half, end)])
}

/// Cylinder along z; the shell includes both ends.
fn cylinder(radius: f64, half: f64, is_shell: bool) -> UnitInertia {
    let (r2, h2) = (radius * radius, half * half);
    if is_shell {
        let side = (4.0 * PI * radius * half, r2 / 2.0 + h2 / 3.0, r2);
        revolved([side, (2.0 * PI * r2, r2 / 4.0 + h2, r2 / 2.0)])
    } else {
        revolved([(2.0 * PI * r2 * half, r2 / 4.0 + h2 / 3.0, r2 / 2.0), (0.0, 0.0, 0.0)])
    }
}

/// Solid ellipsoid with semi-axes a, b, c.
pub(crate) fn ellipsoid([a, b, c]: [f64; 3]) -> UnitInertia {
    let [aa, bb, cc] = [a * a, b * b, c * c];
    UnitInertia {
        volume: 4.0 / 3.0 * PI * a * b * c,
        moments: [(bb + cc) / 5.0, (cc + aa) / 5.0, (aa + bb) / 5.0],
    }
}

/// Box with half sizes a, b, c.
fn cuboid([a, b, c]: [f64; 3], is_shell: bool) -> UnitInertia {
    let squares = [a * a, b * b, c * c];
    if !is_shell {
        let [aa, bb, cc] = squares;
        let moments = [(bb + cc) / 3.0, (cc + aa) / 3.0, (aa + bb) / 3.0];
        return UnitInertia { volume: 8.0 * a * b * c, moments };
    }
    // Pairs of faces normal to x, y and z.
    let areas = [8.0 * b * c, 8.0 * c * a, 8.0 * a * b];
    let area: f64 = areas.iter().sum();
    let moment = |axis: usize| {
        let of_faces = |normal: usize| {
            let distance = |along: usize| if along == normal { 1.0 } else { 1.0 / 3.0 };
            let others = (0..3).filter(|other| *other != axis);
            areas[normal] * others.map(|other| squares[other] * distance(other)).sum::<f64>()
        };
        (0..3).map(of_faces).sum::<f64>() / area
    };
    UnitInertia { volume: area, moments: [moment(0), moment(1), moment(2)] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Masses and moments of MuJoCo 4.0.0 at a density of 1000.
    #[test]
    fn moments_are_those_of_mujoco() {
        let cases = [
            (sphere(0.1, false), 4.188790204786391, [0.01675516, 0.01675516, 0.01675516]),
            (sphere(0.1, true), 125.66370614359174, [0.83775804, 0.83775804, 0.83775804]),
            (capsule(0.1, 0.2, false), 16.75516081914557, [0.44610616, 0.44610616, 0.07958701]),
            (capsule(0.1, 0.2, true), 376.9911184307752, [12.98524963, 12.98524963, 3.35103216]),
            (cylinder(0.1, 0.2, false), 12.566370614359174, [0.19896753, 0.19896753, 0.06283185]),
            (cylinder(0.1, 0.2, true), 314.1592653589793, [7.27802298, 7.27802298, 2.82743339]),
            (cuboid([0.1, 0.2, 0.3], false), 48.0, [2.08, 1.6, 0.8]),
            (cuboid([0.1, 0.2, 0.3], true), 880.0, [54.13333333, 42.13333333, 24.26666667]),
            (ellipsoid([0.1, 0.2, 0.3]), 25.132741228718345, [0.65345127, 0.50265482, 0.25132741]),
        ];
        for (unit, mass, moments) in cases {
            assert_relative_eq!(1000.0 * unit.volume, mass, max_relative = 1e-14);
            for (own, theirs) in unit.moments.iter().zip(moments) {
                assert_relative_eq!(own * mass, theirs, max_relative = 1e-6);
            }
        }
    }
}

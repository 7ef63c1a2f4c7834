//! Belted ellipsoid as a surface. The distance of the surface from the point is m̄ in that direction; 1 corresponds
//! to 1 kg.

use crate::terminal::number::number;
use percuss_render::{Skin, SkinFacet, SkinMark, SkinPiece};
use percuss_study::{DirectionMass, PointMapReport};
use std::f64::consts::{PI, TAU};

/// Number of facets around the axis, and from pole to pole.
const AZIMUTH_FACETS: usize = 96;
const POLAR_FACETS: usize = 48;

/// Cut-off distance if m̄ is infinite in some direction, as a multiple of the largest finite principal mass.
const CUTOFF: f64 = 4.0;

/// 1/m̄ = Σ (n · eᵢ)²/m̄ᵢ over the principal directions eᵢ, world axes (Khatib 1995).
struct Ellipsoid<'a> {
    principal: &'a [DirectionMass],
    cut: Option<f64>,
}

/// Surface of the ellipsoid, coloured by m̄.
///
/// # Errors
/// Reason for a missing surface: a principal direction without a result, or no finite m̄ other than zero.
pub fn skin(report: &PointMapReport) -> Result<Skin, &'static str> {
    if report.principal.len() < 3 {
        return Err(
            "a principal direction has no result, so there is no surface; .csv and .json contain the other results",
        );
    }
    let largest = report.principal.iter().filter_map(|d| d.effective_mass).fold(0.0, f64::max);
    if largest == 0.0 {
        return Err("no direction has a finite effective mass other than zero: there is no surface");
    }
    let is_infinite = report.principal.iter().any(|d| d.status == "immovable");
    let ellipsoid = Ellipsoid { principal: &report.principal, cut: is_infinite.then_some(CUTOFF * largest) };
    let marks = report.principal.iter().filter_map(|d| {
        let mass = d.effective_mass?;
        Some(SkinMark { at: d.direction_world.map(|e| e * mass), label: format!("{} kg", number(mass)) })
    });
    let cut = ellipsoid.cut.map_or_else(String::new, |cut| format!(", cut off at {} kg", number(cut)));
    let [x, y, z] = report.point_link.map(number);
    Ok(Skin {
        title: format!("Effective mass in all directions at ({x}, {y}, {z}) m of {}", report.link),
        subtitle: format!("distance from the point proportional to m̄{cut}"),
        quantity: "effective mass m̄ (kg)".into(),
        without_value: "cut off".into(),
        property: "effective_mass".into(),
        pieces: vec![SkinPiece { name: report.link.clone(), facets: ellipsoid.facets() }],
        marks: marks.collect(),
    })
}

impl Ellipsoid<'_> {
    /// m̄ in a direction; `None` beyond the cut-off.
    fn mass(&self, n: [f64; 3]) -> Option<f64> {
        let response: f64 = self
            .principal
            .iter()
            .map(|d| {
                let along = dot(n, d.direction_world);
                match (d.status, d.effective_mass) {
                    (_, Some(mass)) => along * along / mass,
                    ("massless", None) if along != 0.0 => f64::INFINITY,
                    _ => 0.0,
                }
            })
            .sum();
        let mass = 1.0 / response;
        (mass.is_finite() && self.cut.is_none_or(|cut| mass <= cut)).then_some(mass)
    }

    /// Point of the surface in a direction, at the distance m̄ or at the cut-off.
    fn point(&self, n: [f64; 3]) -> [f64; 3] {
        let far = self.mass(n).or(self.cut).unwrap_or(0.0);
        n.map(|e| e * far)
    }

    /// Direction at given parameters: a sphere stretched along the principal directions by √m̄ᵢ. The directions are
    /// dense near the heavy ones, where m̄ changes most.
    fn direction(&self, (polar, azimuth): (f64, f64)) -> [f64; 3] {
        let on_sphere = [polar.sin() * azimuth.cos(), polar.sin() * azimuth.sin(), polar.cos()];
        let [a, b, c] = [0, 1, 2].map(|i| self.principal[i].direction_world);
        let most = self.cut.unwrap_or(f64::MAX);
        let stretch = |i: usize| {
            let mass = match (self.principal[i].status, self.principal[i].effective_mass) {
                (_, Some(mass)) => mass.min(most),
                ("massless", None) => 0.0,
                _ => most,
            };
            mass.sqrt() * on_sphere[i]
        };
        // A right-handed basis keeps the outside of the surface outside.
        let last = if dot(cross(a, b), c) < 0.0 { -stretch(2) } else { stretch(2) };
        let (first, second) = (stretch(0), stretch(1));
        unit([0, 1, 2].map(|k| first * a[k] + second * b[k] + last * c[k]))
    }

    /// Facets of the whole surface.
    fn facets(&self) -> Vec<SkinFacet> {
        let mut facets = Vec::with_capacity(2 * AZIMUTH_FACETS * POLAR_FACETS);
        for polar in 0..POLAR_FACETS {
            for azimuth in 0..AZIMUTH_FACETS {
                let [a, b] =
                    [azimuth, azimuth + 1].map(|k| TAU * (k % AZIMUTH_FACETS) as f64 / AZIMUTH_FACETS as f64);
                let [top, low] = [polar, polar + 1].map(|k| PI * k as f64 / POLAR_FACETS as f64);
                let [one, two, three, four] =
                    [(top, a), (low, a), (low, b), (top, b)].map(|at| self.direction(at));
                // At the poles, one of the two triangles has no area.
                if polar + 1 < POLAR_FACETS {
                    facets.extend(self.facet([one, two, three]));
                }
                if polar > 0 {
                    facets.extend(self.facet([one, three, four]));
                }
            }
        }
        facets
    }

    /// Facet with the given corner directions; `None` if the area is zero (in a direction without mass).
    fn facet(&self, directions: [[f64; 3]; 3]) -> Option<SkinFacet> {
        let corners = directions.map(|n| self.point(n));
        let [a, b] = [corners[1], corners[2]].map(|c| minus(c, corners[0]));
        let across = cross(a, b);
        let length = dot(across, across).sqrt();
        let middle = unit([0, 1, 2].map(|k| directions.iter().map(|n| n[k]).sum()));
        let value = self.mass(middle);
        let status = if value.is_some() { 0 } else { 1 };
        (length > 0.0).then(|| SkinFacet { corners, normal: across.map(|x| x / length), value, status })
    }
}

/// Vector product.
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Scalar product.
fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Difference a − b.
fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Unit vector; a zero vector is returned unchanged, so that its facet has no area.
fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = dot(a, a).sqrt();
    if length > 0.0 { a.map(|x| x / length) } else { a }
}

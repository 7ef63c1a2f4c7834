//! Raster view of a skin in parallel projection.

use super::Skin;
use super::colour::Scale;
use crate::palette::Colour;
use crate::raster::Raster;

/// Square of RGB pixels.
pub(super) struct View {
    /// Unit vectors to the right, upwards and towards the viewer.
    axes: [[f64; 3]; 3],
    /// Point at the centre of the picture, and pixels per metre.
    middle: [f64; 3],
    per_metre: f64,
    size: usize,
    pub raster: Raster,
}

/// Scalar product.
fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl View {
    /// View from an azimuth (from x towards y) and an elevation, rad, scaled to contain the whole skin.
    pub fn new(skin: &Skin, azimuth: f64, elevation: f64, size: usize) -> Self {
        let ((sa, ca), (sh, ch)) = (azimuth.sin_cos(), elevation.sin_cos());
        let axes = [[-sa, ca, 0.0], [-sh * ca, -sh * sa, ch], [ch * ca, ch * sa, sh]];
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for corner in skin.facets().flat_map(|facet| &facet.corners) {
            for (k, axis) in axes.iter().enumerate() {
                let x = dot(axis, corner);
                (low[k], high[k]) = (low[k].min(x), high[k].max(x));
            }
        }
        if low[0] > high[0] {
            (low, high) = ([0.0; 3], [0.0; 3]);
        }
        let extent = (high[0] - low[0]).max(high[1] - low[1]);
        let per_metre = if extent > 0.0 { 0.94 * size as f64 / extent } else { 1.0 };
        let middle = std::array::from_fn(|k| 0.5 * (low[k] + high[k]));
        Self { axes, middle, per_metre, size, raster: Raster::new(size, size) }
    }

    /// Projects a point: pixels from the upper left, and depth.
    pub fn project(&self, p: &[f64; 3]) -> [f64; 3] {
        let half = 0.5 * self.size as f64;
        let projected = |k: usize| (dot(&self.axes[k], p) - self.middle[k]) * self.per_metre;
        [half + projected(0), half - projected(1), projected(2)]
    }

    /// True if no facet is in front of the point, within a tolerance of some pixels.
    pub fn is_visible(&self, p: &[f64; 3]) -> bool {
        let [x, y, z] = self.project(p);
        self.raster.depth_at(x, y).is_some_and(|depth| depth <= z + 3.0)
    }

    /// Draws all facets with the colours of a scale.
    pub fn draw(&mut self, skin: &Skin, scale: &Scale) {
        for facet in skin.facets() {
            let colour = scale.colour(facet.value);
            // Facets inclined to the view are slightly darker, to show the shape; the colour stays readable.
            let light = 0.80 + 0.20 * dot(&self.axes[2], &facet.normal).abs();
            let shade = |c: u8| (f64::from(c) * light).round() as u8;
            let projected = facet.corners.each_ref().map(|p| self.project(p));
            let colour = Colour(shade(colour.0), shade(colour.1), shade(colour.2));
            self.raster.triangle(&projected, colour);
        }
    }
}

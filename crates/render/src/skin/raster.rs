//! Triangles seen from one side, as pixels: parallel projection, the nearest wins.

use super::Skin;
use super::colour::Scale;
use crate::palette::PAPER;

/// A square of pixels, three bytes each.
pub(super) struct View {
    /// To the right, upwards and towards the eye; unit vectors.
    axes: [[f64; 3]; 3],
    /// What is in the middle, and pixels a metre.
    middle: [f64; 3],
    per_metre: f64,
    size: usize,
    pub pixels: Vec<u8>,
    depth: Vec<f32>,
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl View {
    /// From an azimuth (from x towards y) and a height, rad; fitted to the corners of a skin.
    pub fn new(skin: &Skin, azimuth: f64, height: f64, size: usize) -> Self {
        let ((sa, ca), (sh, ch)) = (azimuth.sin_cos(), height.sin_cos());
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
        let mut pixels = vec![0; 3 * size * size];
        pixels.chunks_exact_mut(3).for_each(|p| p.copy_from_slice(&[PAPER.0, PAPER.1, PAPER.2]));
        Self { axes, middle, per_metre, size, pixels, depth: vec![f32::NEG_INFINITY; size * size] }
    }

    /// A place in pixels, from the upper left, and how near it is.
    pub fn place(&self, p: &[f64; 3]) -> [f64; 3] {
        let half = 0.5 * self.size as f64;
        let seen = |k: usize| (dot(&self.axes[k], p) - self.middle[k]) * self.per_metre;
        [half + seen(0), half - seen(1), seen(2)]
    }

    /// Whether nothing is in front of a place, to a slack of some pixels.
    pub fn is_visible(&self, p: &[f64; 3]) -> bool {
        let [x, y, z] = self.place(p);
        let inside = |v: f64| v >= 0.0 && v < self.size as f64;
        inside(x) && inside(y) && f64::from(self.depth[y as usize * self.size + x as usize]) <= z + 3.0
    }

    pub fn draw(&mut self, skin: &Skin, scale: &Scale) {
        for facet in skin.facets() {
            let colour = scale.colour(facet.value);
            // Faces turned aside are a little darker, so that the form shows and the colour can still be read.
            let light = 0.80 + 0.20 * dot(&self.axes[2], &facet.normal).abs();
            let shade = |c: u8| (f64::from(c) * light).round() as u8;
            let places = facet.corners.each_ref().map(|p| self.place(p));
            self.triangle(&places, [shade(colour.0), shade(colour.1), shade(colour.2)]);
        }
    }

    fn triangle(&mut self, [a, b, c]: &[[f64; 3]; 3], colour: [u8; 3]) {
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        // NaN is no area.
        if area.is_nan() || area.abs() <= 1e-12 {
            return;
        }
        let last = (self.size - 1) as f64;
        let least = |k: usize| a[k].min(b[k]).min(c[k]).floor().clamp(0.0, last) as usize;
        let most = |k: usize| a[k].max(b[k]).max(c[k]).ceil().clamp(0.0, last) as usize;
        for row in least(1)..=most(1) {
            for column in least(0)..=most(0) {
                let (x, y) = (column as f64 + 0.5, row as f64 + 0.5);
                let part = |p: &[f64; 3], q: &[f64; 3]| {
                    ((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])) / area
                };
                let (wa, wb, wc) = (part(b, c), part(c, a), part(a, b));
                // Neighbours may both take the pixels of their edge: no gap is left.
                if wa < -1e-9 || wb < -1e-9 || wc < -1e-9 {
                    continue;
                }
                let depth = (wa * a[2] + wb * b[2] + wc * c[2]) as f32;
                let at = row * self.size + column;
                if depth > self.depth[at] {
                    self.depth[at] = depth;
                    self.pixels[3 * at..3 * at + 3].copy_from_slice(&colour);
                }
            }
        }
    }
}

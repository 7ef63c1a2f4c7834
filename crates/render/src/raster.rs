//! Rasteriser of triangles with a depth buffer.

use crate::palette::{Colour, PAPER};

/// Rectangle of RGB pixels with depth; a larger depth is nearer.
pub(crate) struct Raster {
    pub columns: usize,
    pub rows: usize,
    pub pixels: Vec<u8>,
    depth: Vec<f32>,
}

impl Raster {
    /// Creates a raster filled with the paper colour.
    pub fn new(columns: usize, rows: usize) -> Self {
        let mut pixels = vec![0; 3 * columns * rows];
        pixels.chunks_exact_mut(3).for_each(|p| p.copy_from_slice(&[PAPER.0, PAPER.1, PAPER.2]));
        Self { columns, rows, pixels, depth: vec![f32::NEG_INFINITY; columns * rows] }
    }

    /// Depth of the pixel at a point; `None` outside the picture.
    pub fn depth_at(&self, x: f64, y: f64) -> Option<f64> {
        let inside = |v: f64, size: usize| v >= 0.0 && v < size as f64;
        let at = || y as usize * self.columns + x as usize;
        (inside(x, self.columns) && inside(y, self.rows)).then(|| f64::from(self.depth[at()]))
    }

    /// Draws a triangle; corners are x and y in pixels from the upper left, and depth.
    pub fn triangle(&mut self, [a, b, c]: &[[f64; 3]; 3], colour: Colour) {
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        // A degenerate triangle has no area; NaN coordinates are treated the same.
        if area.is_nan() || area.abs() <= 1e-12 || self.pixels.is_empty() {
            return;
        }
        let last = [(self.columns - 1) as f64, (self.rows - 1) as f64];
        let least = |k: usize| a[k].min(b[k]).min(c[k]).floor().clamp(0.0, last[k]) as usize;
        let most = |k: usize| a[k].max(b[k]).max(c[k]).ceil().clamp(0.0, last[k]) as usize;
        for row in least(1)..=most(1) {
            for column in least(0)..=most(0) {
                let (x, y) = (column as f64 + 0.5, row as f64 + 0.5);
                let edge_function = |p: &[f64; 3], q: &[f64; 3]| {
                    ((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])) / area
                };
                let (wa, wb, wc) = (edge_function(b, c), edge_function(c, a), edge_function(a, b));
                // With the tolerance, neighbouring triangles share the pixels of their edge, so that no gap remains.
                if wa < -1e-9 || wb < -1e-9 || wc < -1e-9 {
                    continue;
                }
                let depth = (wa * a[2] + wb * b[2] + wc * c[2]) as f32;
                let at = row * self.columns + column;
                if depth > self.depth[at] {
                    self.depth[at] = depth;
                    self.pixels[3 * at..3 * at + 3].copy_from_slice(&[colour.0, colour.1, colour.2]);
                }
            }
        }
    }
}

//! Picture of a skin: two views from opposite sides, colour scale and labelled points.

use super::Skin;
use super::colour::{Scale, viridis};
use super::raster::View;
use crate::limits::MAX_MARKS;
use crate::palette::{INK, PAPER, SOFT_INK, ZERO};
use crate::picture::Laid;
use crate::scene::{Anchor, Item, Scene, solid};
use crate::text::{fit_to_width, medium, regular, width};

/// Width of the page, in page units.
const WIDTH: f64 = 1000.0;
const SIDE: f64 = 430.0;
const TOP: f64 = 84.0;
const MARGIN: f64 = 24.0;
/// Raster pixels per page unit.
const PIXELS_PER_UNIT: usize = 2;
/// Directions to the viewer, degrees: azimuths from x towards y of the two views, and elevation.
const AZIMUTHS: [f64; 2] = [35.0, 215.0];
const ELEVATION: f64 = 22.0;

impl Laid for Skin {
    /// Lays out title, both views and colour scale on one page.
    fn layout_scene(&self) -> Scene {
        let scale = Scale::of(self);
        let height = TOP + SIDE + 64.0;
        let caption = format!("{}: {}", self.title, self.quantity);
        let mut scene = Scene { width: WIDTH, height, caption, items: Vec::new() };
        let width_available = WIDTH - 2.0 * MARGIN;
        let title = fit_to_width(&self.title, medium(20.0), width_available);
        scene.text(title, (MARGIN, 34.0), Anchor::Start, medium(20.0), INK);
        let subtitle = fit_to_width(&self.subtitle, regular(13.0), width_available);
        scene.text(subtitle, (MARGIN, 56.0), Anchor::Start, regular(13.0), SOFT_INK);
        let size = PIXELS_PER_UNIT * SIDE as usize;
        let mut views =
            AZIMUTHS.map(|azimuth| View::new(self, azimuth.to_radians(), ELEVATION.to_radians(), size));
        views.iter_mut().for_each(|view| view.draw(self, &scale));
        for i in 0..views.len() {
            let left = MARGIN + (SIDE + 8.0) * i as f64;
            let pixels = std::mem::take(&mut views[i].raster.pixels);
            scene.items.push(Item::Image { at: (left, TOP), size: (SIDE, SIDE), pixels, columns: size });
            self.draw_labels(&views, i, left, &mut scene);
            let label = format!("seen from {}° about z, {ELEVATION}° above", AZIMUTHS[i]);
            let middle = left + 0.5 * SIDE;
            scene.text(label, (middle, TOP + SIDE + 20.0), Anchor::Middle, regular(12.0), SOFT_INK);
        }
        self.draw_colour_scale(&scale, &mut scene);
        scene
    }
}

impl Skin {
    /// Draws the labelled points visible in this view; points hidden in all views are drawn as rings in the first.
    fn draw_labels(&self, views: &[View], i: usize, left: f64, scene: &mut Scene) {
        for mark in self.marks.iter().take(MAX_MARKS) {
            let is_hidden = !views.iter().any(|view| view.is_visible(&mark.at));
            if !(views[i].is_visible(&mark.at) || is_hidden && i == 0) {
                continue;
            }
            let [x, y, _] = views[i].project(&mark.at);
            let (x, y) = (left + x / PIXELS_PER_UNIT as f64, TOP + y / PIXELS_PER_UNIT as f64);
            scene.dots(vec![(x, y)], 5.0, PAPER);
            scene.dots(vec![(x, y)], 3.5, INK);
            if is_hidden {
                scene.dots(vec![(x, y)], 2.0, PAPER);
            }
            let font = medium(12.0);
            let label = if is_hidden { format!("{} (hidden)", mark.label) } else { mark.label.clone() };
            let label = fit_to_width(&label, font, SIDE - 8.0);
            let half = 0.5 * width(&label, font) + 4.0;
            let at =
                (x.clamp(left + half, left + SIDE - half), if y < TOP + 30.0 { y + 20.0 } else { y - 11.0 });
            scene.text_with_halo(label, at, Anchor::Middle, font, INK);
        }
    }

    /// Draws the colour scale with its labels, and the colour of facets without a value.
    fn draw_colour_scale(&self, scale: &Scale, scene: &mut Scene) {
        let (left, top, bottom) = (WIDTH - 92.0, TOP + 44.0, TOP + SIDE - 40.0);
        let steps = 128;
        for i in (0..steps).rev() {
            let position = f64::from(i) / f64::from(steps);
            let y = bottom - (bottom - top) * position;
            let from = (left, y - (bottom - top) / f64::from(steps) - 1.0);
            let colour = viridis(position + 0.5 / f64::from(steps));
            scene.items.push(Item::Patch { from, to: (left + 18.0, y), colour });
        }
        for value in scale.ticks() {
            let y = bottom - (bottom - top) * scale.position(value);
            scene.lines(vec![vec![(left + 18.0, y), (left + 23.0, y)]], solid(INK, 1.0));
            let is_end = scale.is_capped && value == scale.high;
            let label = if is_end { format!("≥ {}", format_short(value)) } else { format_short(value) };
            scene.text(label, (left + 27.0, y + 4.0), Anchor::Start, regular(12.0), INK);
        }
        let label = fit_to_width(&self.quantity, medium(12.0), 2.0 * 88.0);
        scene.text(label, (WIDTH - 8.0, TOP - 14.0), Anchor::End, medium(12.0), INK);
        if scale.logarithmic {
            scene.text("logarithmic".into(), (WIDTH - 8.0, TOP + 2.0), Anchor::End, regular(11.0), SOFT_INK);
        }
        if !self.without_value.is_empty() && self.facets().any(|facet| facet.value.is_none()) {
            let y = bottom + 16.0;
            scene.items.push(Item::Patch { from: (left, y), to: (left + 18.0, y + 14.0), colour: ZERO });
            let label = fit_to_width(&self.without_value, regular(12.0), 64.0);
            scene.text(label, (left + 23.0, y + 11.0), Anchor::Start, regular(12.0), INK);
        }
    }
}

/// Formats a value with three significant digits.
fn format_short(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let magnitude = value.abs().log10().floor();
    if !(-3.0..6.0).contains(&magnitude) {
        return format!("{value:.1e}");
    }
    let decimals = (2.0 - magnitude).max(0.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

//! What is to be drawn, in the caller's own numbers.

use crate::png::RenderError;
use crate::{layout, png, svg};

/// A plot: panels one above the other, over one shared x axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// The heading; none where empty.
    pub title: String,
    /// A line below the heading, such as the contact and the model; none where empty.
    pub subtitle: String,
    /// What x is, with its unit: `Wheel travel (mm)`.
    pub x_label: String,
    /// From top to bottom.
    pub panels: Vec<Panel>,
    /// Places on the x axis worth naming. They run through all panels.
    pub marks: Vec<Mark>,
}

/// One pair of axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// What y is, with its unit: `Effective mass m̄ (kg)`.
    pub y_label: String,
    /// The first is drawn on top. Two or more get a legend.
    pub series: Vec<Series>,
}

/// Values to be drawn alike. Series of one name have one colour, in every panel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// What the legend calls it.
    pub name: String,
    /// How it is drawn.
    pub style: Style,
    /// (x, y), joined in this order; `None` is a gap in the line, which still counts towards the range of x.
    pub points: Vec<(f64, Option<f64>)>,
}

/// How the values of a series are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// A solid line; a value between two gaps is a dot.
    #[default]
    Line,
    /// A broken line, for an estimate or a reference.
    Dashed,
    /// Dots that nothing joins, for measurements.
    Dots,
}

/// A place on the x axis worth naming: a singular pose, a limit, the design position.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mark {
    /// Where. Outside the range of the points it is not drawn; where there are no points, marks make the range.
    pub x: f64,
    /// What; a line without words where empty. Where too many crowd together, later ones go without theirs.
    pub label: String,
}

impl Figure {
    /// The figure as an SVG document, 900 units wide and about 300 high for each panel.
    ///
    /// Cost: linear in the points. The document's length is bounded by the number of series, not of points.
    pub fn to_svg(&self) -> String {
        svg::write(&layout::arrange(self))
    }

    /// The same picture as a PNG, `scale` pixels for each unit of the SVG: 1 for a small screen, 2 for a sharp one or
    /// for print.
    ///
    /// # Errors
    /// `scale` not a positive number, or a picture of more than 2^25 pixels.
    pub fn to_png(&self, scale: f32) -> Result<Vec<u8>, RenderError> {
        png::draw(&layout::arrange(self), scale)
    }
}

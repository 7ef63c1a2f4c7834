//! Figure in the caller's data units.

pub(crate) mod axis;
mod colours;
mod curve;
mod ends;
pub(crate) mod layout;
pub(crate) mod legend;
mod marks;
pub(crate) mod sheet;
pub(crate) mod tornado;

/// Plot with panels one above the other over one shared x axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Title; no title if empty.
    pub title: String,
    /// Subtitle, such as the contact and the model; no subtitle if empty.
    pub subtitle: String,
    /// Label of the x axis with its unit: `Wheel travel (mm)`.
    pub x_label: String,
    /// Panels from top to bottom.
    pub panels: Vec<Panel>,
    /// Ends of the x axis; `None` takes the range of the points.
    pub x_limits: Option<(f64, f64)>,
    /// Labelled positions on the x axis; their lines cross all panels.
    pub marks: Vec<Mark>,
    /// True if all coordinates are logarithms to the base 10: the axes show their powers.
    pub is_logarithmic: bool,
    /// True for a figure beside text, on a page of half the width.
    pub is_half: bool,
}

/// Panel with its own y axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// Label of the y axis with its unit: `Effective mass m̄ (kg)`.
    pub y_label: String,
    /// Series; the first is drawn on top. Two or more lines have their names at their ends, or a legend. Lines with equal points are drawn
    /// once, with both names.
    pub series: Vec<Series>,
    /// Ends of the y axis; `None` takes the range of the points with a margin.
    pub y_limits: Option<(f64, f64)>,
    /// Values with a label, in the colour of the first series.
    pub values: Vec<LabelledPoint>,
}

/// Value of a curve with a label.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LabelledPoint {
    /// Position.
    pub x: f64,
    /// Value.
    pub y: f64,
    /// Uncertainty of the value, drawn as a bar to both sides.
    pub spread: Option<f64>,
    /// Label.
    pub label: String,
}

/// Data series. Series with the same name have the same colour in every panel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Line style.
    pub style: Style,
    /// Points (x, y), connected in this order. `None` is a gap in the line; its x still counts for the range.
    pub points: Vec<(f64, Option<f64>)>,
}

/// Style of a series.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// Solid line; a value between two gaps is a dot.
    #[default]
    Line,
    /// Dashed line, for an estimate or a reference.
    Dashed,
    /// Unconnected dots, for measurements.
    Dots,
    /// Filled area inside the polygon of the points, for a tolerance over a range: along one edge and back along the other.
    /// A gap ends a polygon. Drawn under the lines of the panel.
    Band,
    /// Filled bars from zero, for histograms: a value extends from its x to the x of the next point.
    Bars,
}

/// Labelled position on the x axis, such as a singular pose, a limit or the design position.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mark {
    /// Position. Marks outside the range of the points are not drawn; without points the marks define the range.
    pub x: f64,
    /// Label; only a line if empty. Labels that do not fit are left out, the last marks first.
    pub label: String,
}

//! What is to be drawn, in the caller's own numbers.

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
    /// The ends of the x axis; those of the points where none are given.
    pub x_limits: Option<(f64, f64)>,
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
    /// The ends of the y axis; those of the points, with some room, where none are given.
    pub y_limits: Option<(f64, f64)>,
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

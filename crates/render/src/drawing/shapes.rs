//! Content of a drawing in space.

/// Drawing of a mechanism; lengths in metres, x forward, y to the left, z up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Title; no title if empty.
    pub title: String,
    /// Subtitle; no subtitle if empty.
    pub subtitle: String,
    /// Description for readers without the picture; the views if empty.
    pub content: String,
    /// Quantity shown by the shading, and its largest value in percent; no legend if `None`.
    pub shading: Option<(String, f64)>,
    /// Facets of link shapes, drawn below the lines.
    pub facets: Vec<DrawnFacet>,
    /// Lines.
    pub lines: Vec<DrawnLine>,
    /// Circles, such as wheels.
    pub circles: Vec<DrawnCircle>,
    /// Arrows.
    pub arrows: Vec<DrawnArrow>,
    /// Arrows of forces or impulses, all in proportion to each other. Labelled arrows have the colour of the contact.
    pub loads: Vec<DrawnArrow>,
    /// Symbols of springs, dampers, stops and the ground.
    pub symbols: Vec<DrawnSymbol>,
    /// Labelled points.
    pub marks: Vec<crate::SkinMark>,
    /// Named points: a dot, with the name under the pointer.
    pub points: Vec<crate::SkinMark>,
    /// Names of parts, each beside its part.
    pub names: Vec<DrawnName>,
    /// Views.
    pub views: Views,
}

/// Views of a drawing. Views in which the drawing is only a line are left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Views {
    /// From the front and from the left.
    #[default]
    Two,
    /// From the front, from the left and from above.
    Three,
    /// The view in which the drawing covers the largest area, and in whose plane its arrows are; on a page of half the width.
    Best,
}

/// Name of a part with a leader line from the nearest of several points of the part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawnName {
    /// The name.
    pub text: String,
    /// Points of the part, m.
    pub points: Vec<[f64; 3]>,
    /// Shading value of the part from 0 to 1: names of small values are lighter.
    pub intensity: Option<f64>,
}

/// Triangle of a link shape.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DrawnFacet {
    /// Corners, m.
    pub corners: [[f64; 3]; 3],
    /// Shading value from 0 to 1; `None` is drawn as 0.
    pub intensity: Option<f64>,
}

/// A straight line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DrawnLine {
    /// End points, m.
    pub ends: [[f64; 3]; 2],
    /// Shading value from 0 to 1: colour and width; `None` is drawn in ink without shading.
    pub intensity: Option<f64>,
}

/// A circle in space, or the outline of a wheel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DrawnCircle {
    /// Centre, m.
    pub centre: [f64; 3],
    /// Unit normal of the circle's plane.
    pub axis: [f64; 3],
    /// Radius, m.
    pub radius: f64,
    /// Width along the axis, m; 0 for a circle.
    pub width: f64,
    /// Shading value from 0 to 1 of the colour.
    pub intensity: Option<f64>,
}

/// Arrow. Its length shows a magnitude, not a distance.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawnArrow {
    /// Start point, m.
    pub from: [f64; 3],
    /// Direction and relative magnitude; the longest arrow of a drawing has a fixed length on the page.
    pub vector: [f64; 3],
    /// Label; none if empty. Labelled arrows, except loads, are drawn thicker and as long as the longest.
    pub label: String,
}

/// Symbol between two points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnSymbol {
    /// Kind.
    pub kind: SymbolKind,
    /// Ends, m: the moving side first.
    pub ends: [[f64; 3]; 2],
    /// Unit normal of the pad of a stop, or of the ground.
    pub normal: [f64; 3],
}

/// Kind of a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SymbolKind {
    /// Coil spring between both ends.
    Spring,
    /// Damper between both ends: rod and cylinder.
    Damper,
    /// Stop: pad at the first end, hatched face at the second.
    Stop,
    /// Hatched ground at the first end.
    Ground,
}

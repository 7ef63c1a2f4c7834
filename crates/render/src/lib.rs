//! Line plots from plain numbers, as SVG, PNG and PDF; quantities over surfaces, as these, as PLY and as glTF.
//!
//! A [`Figure`] is a stack of [`Panel`]s over one shared x axis; each holds [`Series`] whose values may be missing.
//! `layout` turns the figure into a list of strokes, dots, patches and texts (`scene`), and `svg` writes it:
//! [`Figure::to_svg`]. [`Figure::to_png`] and [`Figure::to_pdf`] are made from that SVG by resvg and svg2pdf. SVG text stays text,
//! in Roboto where it is installed and the reader's sans-serif elsewhere; PNG and PDF have the embedded Roboto,
//! so that a machine without fonts will do.
//!
//! A [`Drawing`] shows a mechanism from two sides. A [`Sheet`] puts figures with x axes of their own below one another. A [`Skin`] is a quantity over facets in space: two views
//! with a scale of colours, [`Skin::write_ply`], [`Skin::to_glb`].
//!
//! What a figure cannot show is left out of it and never an error: a value that is missing, NaN, infinite or beyond
//! 1e300 is a gap, one below 1e-300 is zero, an empty panel has a note. Names too long for their room end in `…`.
//! The same figure gives the same SVG and PNG to the byte (fonts stand in a PDF in any order), and their number does not grow with the number of points beyond what a
//! picture of this size can show. Nothing here knows a mechanism, or where the numbers come from.
//!
//! ```
//! use percuss_render::{Figure, Panel, Series, Style};
//!
//! let points = (-8..=8).map(|i| (10.0 * f64::from(i), Some(205.0 - 0.1 * f64::from(i * i)))).collect();
//! let mass = Series { name: "formula".into(), style: Style::Line, points };
//! let figure = Figure {
//!     title: "Effective mass".into(),
//!     x_label: "Wheel travel (mm)".into(),
//!     panels: vec![Panel { y_label: "m̄ (kg)".into(), series: vec![mass], ..Panel::default() }],
//!     ..Figure::default()
//! };
//! assert!(figure.to_svg().starts_with("<svg"));
//! assert!(figure.to_png(2.0)?.starts_with(b"\x89PNG"));
//! # Ok::<(), percuss_render::RenderError>(())
//! ```

mod axis;
mod backend;
mod curve;
mod drawing;
mod figure;
mod font;
mod layout;
mod legend;
mod limits;
mod marks;
mod palette;
mod pdf;
mod raster;
mod scene;
mod sheet;
mod skin;
mod svg;
mod text;

pub use backend::{MADE_BY, RenderError};
pub use drawing::{Drawing, DrawnArrow, DrawnCircle, DrawnFacet, DrawnLine};
pub use figure::{Figure, Mark, Panel, Series, Style};
pub use sheet::Sheet;
pub use skin::{Skin, SkinFacet, SkinMark, SkinPiece};

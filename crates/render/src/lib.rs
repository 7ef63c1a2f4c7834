#![doc = include_str!("../README.md")]
//!
//! A [`Figure`] is a stack of [`Panel`]s over one shared x axis; each panel has [`Series`] with possibly
//! missing values. `layout` converts the figure to strokes, dots, patches and texts (`scene`), and `svg` writes
//! the scene: [`Picture::to_svg`]. [`Picture::to_png`] and [`Picture::to_pdf`] convert this SVG with resvg and
//! svg2pdf, if the crate has its feature `convert`. SVG text stays text, in Roboto if installed and otherwise in the reader's sans-serif; PNG and PDF
//! use the embedded Roboto, so no installed fonts are needed.
//!
//! A [`Drawing`] shows a mechanism in two or three views. A [`Sheet`] stacks figures with different x axes. A [`Tornado`]
//! compares the effects of many numbers as bars. A [`Skin`]
//! is a quantity over facets in space: two views with a colour scale, [`Skin::write_ply`], [`Skin::to_glb`].
//!
//! Undrawable data are left out and are never an error: missing values, NaN, infinities and magnitudes above
//! 1e300 are gaps, magnitudes below 1e-300 are zero, an empty panel shows a note. Names that are too long end
//! in `…`. The same figure gives the same SVG and PNG to the byte (in a PDF the order of the fonts varies). The
//! size of the file is bounded independently of the number of points. This crate depends on no other crate of
//! the workspace.

mod backend;
#[cfg(feature = "convert")]
mod convert;
#[cfg(not(feature = "convert"))]
#[path = "convert/not_built.rs"]
mod convert;
mod drawing;
mod figure;
mod font;
mod limits;
mod palette;
mod picture;
mod raster;
mod scene;
mod skin;
mod svg;
mod text;

pub use backend::{MADE_BY, RenderError};
pub use drawing::{
    Drawing, DrawnArrow, DrawnCircle, DrawnFacet, DrawnLine, DrawnName, DrawnSymbol, SymbolKind, Views,
};
pub use figure::sheet::Sheet;
pub use figure::tornado::{Tornado, TornadoBar};
pub use figure::{Figure, LabelledPoint, Mark, Panel, Series, Style};
pub use picture::Picture;
pub use skin::{Skin, SkinFacet, SkinMark, SkinPiece};

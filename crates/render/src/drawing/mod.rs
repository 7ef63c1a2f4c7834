//! Drawing of a mechanism in two or three orthographic views: lines, circles, symbols, arrows and named points in space.

mod items;
mod layout;
mod names;
mod shapes;
mod symbols;
mod vectors;

pub use self::shapes::{
    Drawing, DrawnArrow, DrawnCircle, DrawnFacet, DrawnLine, DrawnName, DrawnSymbol, SymbolKind, Views,
};

use crate::picture::Laid;
use crate::scene::Scene;

impl Laid for Drawing {
    fn layout_scene(&self) -> Scene {
        layout::layout_drawing(self)
    }
}

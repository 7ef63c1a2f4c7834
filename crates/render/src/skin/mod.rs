//! Quantity over surfaces in space: picture in two views, PLY and glTF.

mod colour;
mod gltf;
mod picture;
mod ply;
mod raster;

/// Small triangle with a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkinFacet {
    /// Corners, anticlockwise seen from outside; z is up.
    pub corners: [[f64; 3]; 3],
    /// Outward unit normal.
    pub normal: [f64; 3],
    /// Value; `None` is drawn grey.
    pub value: Option<f64>,
    /// Status code of the value or of its absence; written to the files unchanged.
    pub status: u8,
}

/// Named group of facets, such as a link.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SkinPiece {
    /// Name.
    pub name: String,
    /// Facets.
    pub facets: Vec<SkinFacet>,
}

/// Labelled point of the picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SkinMark {
    /// Position.
    pub at: [f64; 3],
    /// Label.
    pub label: String,
}

/// Quantity over surfaces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skin {
    /// Title; no title if empty.
    pub title: String,
    /// Subtitle; no subtitle if empty.
    pub subtitle: String,
    /// Quantity with its unit.
    pub quantity: String,
    /// Legend text of facets without value (grey).
    pub without_value: String,
    /// Name of the value in files, such as `effective_mass`.
    pub property: String,
    /// Pieces.
    pub pieces: Vec<SkinPiece>,
    /// Labelled points.
    pub marks: Vec<SkinMark>,
}

impl Skin {
    /// Facets of all pieces.
    fn facets(&self) -> impl Iterator<Item = &SkinFacet> {
        self.pieces.iter().flat_map(|piece| &piece.facets)
    }
}

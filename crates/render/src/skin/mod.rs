//! A quantity over surfaces in space: as a picture from two sides, as PLY and as glTF.

mod colour;
mod gltf;
mod picture;
mod ply;
mod raster;

/// A small triangle with the value on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkinFacet {
    /// Its corners, anticlockwise seen from outside; z is up.
    pub corners: [[f64; 3]; 3],
    /// Its outward normal, a unit vector.
    pub normal: [f64; 3],
    /// The value; none is grey.
    pub value: Option<f64>,
    /// A number that says what the value is, or why there is none; written as it is.
    pub status: u8,
}

/// Facets that belong together: a link.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SkinPiece {
    /// Its name.
    pub name: String,
    /// Its facets.
    pub facets: Vec<SkinFacet>,
}

/// A place that is named in the picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SkinMark {
    /// Where.
    pub at: [f64; 3],
    /// What.
    pub label: String,
}

/// A quantity over surfaces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skin {
    /// The heading; none where empty.
    pub title: String,
    /// A line below; none where empty.
    pub subtitle: String,
    /// What the values are, with their unit.
    pub quantity: String,
    /// What grey is.
    pub without_value: String,
    /// The name of the value in files, such as `effective_mass`.
    pub property: String,
    /// The pieces.
    pub pieces: Vec<SkinPiece>,
    /// Places worth naming.
    pub marks: Vec<SkinMark>,
}

impl Skin {
    fn facets(&self) -> impl Iterator<Item = &SkinFacet> {
        self.pieces.iter().flat_map(|piece| &piece.facets)
    }
}

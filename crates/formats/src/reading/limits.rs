//! Thresholds of the readers and the writer, with units and reasons.
//!
//! Files may be hostile: every count below bounds time or memory. Sizes are far above those of real models (the largest
//! robots have some hundred links), and small enough that a file at the limit is refused or read within seconds.

// URDF: the text.

/// Deepest nesting of elements, for the stack of recursive parsers: real files stay below 20.
pub(crate) const DEEPEST_NESTING: usize = 256;
/// Largest number of elements in a file.
pub(crate) const MOST_ELEMENTS: usize = 1_000_000;
/// Largest number of attributes in a file: 100,000 links and joints with all possible attributes have fewer.
pub(crate) const MOST_ATTRIBUTES_IN_ALL: usize = 3_000_000;
/// Largest number of nodes of the parsed tree: elements, comments and texts.
pub(crate) const MOST_NODES: u32 = 3_000_000;
/// Largest number of attributes of an element: the parser compares all pairs.
pub(crate) const MOST_ATTRIBUTES: usize = 256;
/// Largest number of namespace declarations: the parser searches all declarations at every element.
pub(crate) const MOST_NAMESPACES: usize = 128;
/// Largest number of entity declarations.
pub(crate) const MOST_ENTITIES: usize = 64;
/// Largest total size of expanded entity references, bytes.
pub(crate) const MOST_EXPANDED: usize = 64 << 20;
/// Deepest nesting of entity references that roxmltree follows.
pub(crate) const REFERENCES_IN_A_REFERENCE: usize = 256;
/// Largest number of characters shown of a message of the XML parser.
pub(crate) const LONGEST_PARSER_MESSAGE: usize = 200;

// URDF: the elements.

/// Largest number of links in a file, and of joints, loops and couplings.
pub(crate) const MOST_BODIES: usize = 100_000;
/// Longest name, bytes: a longer name would make messages unreadable.
pub const LONGEST_NAME: usize = 1024;
/// Largest number of unknown names for which similar names are searched.
pub(crate) const MOST_SUGGESTIONS: usize = 10;
/// Largest number of names compared with an unknown name: the comparison is quadratic in the length of the names.
pub(crate) const MOST_CANDIDATES: usize = 2_000;
/// Longest chain of mimic joints.
pub(crate) const LONGEST_MIMIC_CHAIN: usize = 100;
/// Largest number of joints on the paths from the coupled links to the root, all couplings together.
pub(crate) const MOST_COUPLING_STEPS: usize = 4_000_000;

// URDF: numbers.

/// Largest |norm − 1| of a rounded unit quaternion, dimensionless; a larger deviation is an error. Files have three decimals
/// or more.
pub(crate) const QUATERNION_NORM_SLACK: f64 = 1e-3;
/// Largest |cosine| of the angle between the pins of a Hooke's joint, which are perpendicular. Files have three decimals.
pub const OBLIQUE_PINS: f64 = 1e-3;
/// Least magnitude of the largest component of an axis, dimensionless. A shorter axis counts as zero, as in the builder of
/// mechanisms.
pub(crate) const SHORTEST_AXIS: f64 = 1e-100;
/// Largest dimension of a shape, m. A larger shape is a mistake and is ignored.
pub(crate) const LARGEST_SHAPE: f64 = 1e9;
/// Relative difference up to which two values of an armature are equal within rounding: files have nine digits.
pub(crate) const ARMATURE_SLACK: f64 = 1e-9;
/// Magnitudes of numbers in decimal notation. Other numbers are written in scientific notation, without long rows of zeros.
pub(crate) const DECIMAL_NUMBERS: std::ops::Range<f64> = 1e-5..1e16;

// Findings.

/// Largest number of findings shown per severity; further findings are only counted.
pub const MOST_FINDINGS: usize = 50;
/// Largest number of kinds of repeated findings with separate counts.
pub(crate) const MOST_KINDS: usize = 500;
/// Largest offset in a line, bytes, for which the column of a finding is computed.
pub(crate) const FARTHEST_COLUMN: usize = 1 << 16;
/// Largest number of characters of a file's text in a message.
pub(crate) const LONGEST_SHOWN: usize = 60;

// Meshes.

/// Largest number of vertices of a mesh: three per triangle.
pub(crate) const MOST_MESH_POSITIONS: usize = 3 * MOST_TRIANGLES;
/// Largest number of triangles of a mesh: 360 MB of corners. The finest robot meshes have some hundred thousand triangles.
pub(crate) const MOST_TRIANGLES: usize = 5_000_000;
/// Largest number of positions and indices in a COLLADA file: twelve per triangle.
pub(crate) const MOST_MESH_NUMBERS: usize = 12 * MOST_TRIANGLES;
/// Deepest nesting of nodes in a COLLADA scene.
pub(crate) const DEEPEST_NODES: usize = 64;
/// Largest number of visited nodes and instances of a COLLADA scene: instances may repeat nodes.
pub(crate) const MOST_SCENE_NODES: usize = 100_000;
/// Number of facets around a round shape.
pub(crate) const ROUND_FACETS: std::ops::RangeInclusive<usize> = 16..=720;
/// Least signed volume of a closed part of a mesh, relative to area times size. A part with less volume is open or flat and
/// has no interior.
pub(crate) const NO_VOLUME: f64 = 1e-9;

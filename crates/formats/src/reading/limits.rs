//! Thresholds of the readers and the writer, with units and reasons.
//!
//! Files may be hostile: every count below bounds time or memory. Sizes are far above those of real models (the largest
//! robots have some hundred links), and small enough that a file at the limit is refused or read within seconds.

// URDF: the text.

/// Largest part of a file that is searched for the name of a foreign root element, bytes.
pub(crate) const LONGEST_HEAD: usize = 4096;

/// Deepest nesting of elements, for the stack of recursive parsers: real files stay below 20.
pub(crate) const MAX_ELEMENT_DEPTH: usize = 256;
/// Largest number of joint positions in all keyframes of a model: 40 MB.
pub(crate) const MAX_POSITIONS: usize = 300_000;
/// Largest number of elements in a file.
pub(crate) const MAX_ELEMENTS: usize = 1_000_000;
/// Largest number of attributes in a file: 100,000 links and joints with all possible attributes have fewer.
pub(crate) const MAX_TOTAL_ATTRIBUTES: usize = 3_000_000;
/// Largest number of nodes of the parsed tree: elements, comments and texts.
pub(crate) const MAX_NODES: u32 = 3_000_000;
/// Largest number of attributes of an element: the parser compares all pairs.
pub(crate) const MAX_ATTRIBUTES_PER_ELEMENT: usize = 256;
/// Largest number of namespace declarations in a file: the parser searches all of them at every element.
pub(crate) const MAX_NAMESPACES: usize = 128;
/// Largest number of prefixes that are declared for a file that does not declare them.
pub(crate) const MAX_DECLARED_PREFIXES: usize = 32;
/// Largest number of entity declarations in a file.
pub(crate) const MAX_ENTITIES: usize = 64;
/// Largest total size of expanded entity references, bytes.
pub(crate) const MAX_EXPANDED_BYTES: usize = 64 << 20;
/// Largest number of entity references expanded within one reference: roxmltree stops at 255.
pub(crate) const MAX_NESTED_REFERENCES: usize = 256;
/// Largest length of a quoted message of the XML parser, characters.
pub(crate) const MAX_PARSER_MESSAGE: usize = 200;

// MJCF: the files and the bodies.

/// Largest number of included files: each is opened and parsed.
pub(crate) const MAX_INCLUDED_FILES: usize = 1_000;
/// Largest total size of the main file and all included files, bytes.
pub(crate) const MAX_INCLUDED_BYTES: u64 = 64 << 20;
/// Largest number of visits to elements of the kinematic tree: a `<replicate>` visits its contents for each copy.
pub(crate) const MAX_TREE_VISITS: usize = 1_000_000;
/// Largest total number of triangles in the meshes from which inertias are computed.
pub(crate) const MAX_INERTIA_TRIANGLES: usize = 20_000_000;

/// Largest total size of the mesh files from which the inertias of a model are computed, bytes: twice the largest file.
pub(crate) const MAX_MESH_BYTES: u64 = 512 << 20;
/// Largest number of distances computed for the convex hulls of a model, a face counted as 100: some 250,000 vertices on hulls, seconds.
pub(crate) const MAX_HULL_WORK: usize = 150_000_000;
/// Largest total size of the copies of attached models, bytes: their number is limited by [`MAX_ELEMENTS`], but not their attributes.
pub(crate) const MAX_COPIED_BYTES: usize = 256 << 20;
/// Largest number of elements that are searched for the names of attached models: seconds.
pub(crate) const MAX_ATTACH_STEPS: usize = 50_000_000;

// SDFormat: the files and the frames.

/// Deepest nesting of included files and of models within models.
pub(crate) const MAX_MODEL_DEPTH: usize = 32;
/// Longest chain of frames, each placed in the next one, that is multiplied without the poses in the world: the cost of a joint.
pub(crate) const MAX_FRAME_CHAIN: usize = 64;
/// Magnitude of a limit from which on SDFormat takes a joint for unlimited, rad or m.
pub(crate) const UNLIMITED: f64 = 1e16;

// URDF: the elements.

/// Largest number of links in a file; the same limit holds for joints, for loops and for couplings.
pub(crate) const MAX_ELEMENTS_PER_KIND: usize = 100_000;
/// Longest name, bytes: a longer name would make messages unreadable.
pub const LONGEST_NAME: usize = 1024;
/// Largest number of unknown names for which similar names are searched.
pub(crate) const MAX_SUGGESTIONS: usize = 10;
/// Largest number of names compared with an unknown name: the comparison is quadratic in the length of the names.
pub(crate) const MAX_CANDIDATES: usize = 2_000;
/// Longest name that is compared with others in MJCF, bytes.
pub(crate) const LONGEST_COMPARED_NAME: usize = 100;
/// Largest number of links, and of joints, that are listed for a plugin: those that join links name two.
pub(crate) const MAX_PLUGIN_NAMES: usize = 16;
/// Largest number of couplings in elements for simulators that are compared with the loops and couplings of the file.
pub(crate) const MAX_COUPLING_SEARCHES: usize = 1_000;
/// Largest number of joints from a link of a screw or gearbox to the root.
pub(crate) const MAX_RELATION_PATH: usize = 1_000;
/// Longest chain of mimic joints.
pub(crate) const MAX_MIMIC_CHAIN: usize = 100;
/// Largest number of joints on the paths from the coupled links to the root, summed over all couplings.
pub(crate) const MAX_COUPLING_STEPS: usize = 4_000_000;

// URDF: numbers.

/// Largest angle of a rotation without a warning, rad: one turn, rounded up. Larger numbers are degrees, as a rule.
pub(crate) const LARGEST_ANGLE: f64 = 6.3;

/// Largest |norm − 1| of a rounded unit quaternion, dimensionless; a larger deviation is an error. Files have three decimals
/// or more.
pub(crate) const QUATERNION_NORM_TOLERANCE: f64 = 1e-3;
/// Largest |cosine| of the angle between the pins of a universal joint, nominally 0. Files have three decimals.
pub const OBLIQUE_PINS: f64 = 1e-3;
/// Smallest magnitude of the largest component of an axis, dimensionless. A shorter axis counts as zero, as in the builder
/// of mechanisms.
pub(crate) const MIN_AXIS_COMPONENT: f64 = 1e-100;
/// Largest dimension of a shape, m. A larger shape is a mistake and is ignored.
pub(crate) const MAX_SHAPE_SIZE: f64 = 1e9;
/// Relative difference up to which two values of an armature are equal within rounding: files have nine digits.
pub(crate) const ARMATURE_TOLERANCE: f64 = 1e-9;
/// Difference up to which two statements of a mimic are equal, relative to the larger multiplier or offset, or rad or m: files have six
/// digits.
pub(crate) const MIMIC_TOLERANCE: f64 = 1e-5;
/// Magnitudes written in decimal notation. Smaller and larger numbers have an exponent instead of long rows of zeros.
pub(crate) const DECIMAL_NOTATION_RANGE: std::ops::Range<f64> = 1e-5..1e16;

// Findings.

/// Largest number of findings shown per severity; further findings are only counted.
pub const MOST_FINDINGS: usize = 50;
/// Largest number of kinds of repeated findings with separate counts.
pub(crate) const MAX_REPEATED_KINDS: usize = 500;
/// Largest offset in a line, bytes, for which the column of a finding is computed.
pub(crate) const MAX_COLUMN_OFFSET: usize = 1 << 16;
/// Largest length of a text from a file in a message, characters.
pub(crate) const MAX_QUOTED_CHARACTERS: usize = 60;

// Meshes.

/// Largest number of vertices of a mesh: three per triangle.
pub(crate) const MAX_MESH_VERTICES: usize = 3 * MAX_TRIANGLES;
/// Largest number of triangles of a mesh: 360 MB of corners. The finest robot meshes have some hundred thousand triangles.
pub(crate) const MAX_TRIANGLES: usize = 5_000_000;
/// Largest number of positions and indices in a COLLADA file: twelve per triangle.
pub(crate) const MAX_MESH_NUMBERS: usize = 12 * MAX_TRIANGLES;
/// Deepest nesting of the nodes of a COLLADA scene.
pub(crate) const MAX_SCENE_DEPTH: usize = 64;
/// Largest number of visits to nodes and geometries of a COLLADA scene: instances may repeat nodes.
pub(crate) const MAX_SCENE_NODES: usize = 100_000;
/// Smallest and largest number of facets around the circumference of a round shape.
pub(crate) const FACETS_PER_TURN: std::ops::RangeInclusive<usize> = 16..=720;
/// Smallest |volume| of a closed piece of a mesh, relative to (area)^(3/2). A piece with less volume is flat and has no
/// interior.
pub(crate) const MIN_RELATIVE_VOLUME: f64 = 1e-9;

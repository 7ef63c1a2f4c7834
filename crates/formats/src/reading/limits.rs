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
pub(crate) const LONGEST_NAME: usize = 1024;
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
pub(crate) const MOST_FINDINGS: usize = 50;
/// Largest number of kinds of repeated findings with separate counts.
pub(crate) const MOST_KINDS: usize = 500;
/// Largest offset in a line, bytes, for which the column of a finding is computed.
pub(crate) const FARTHEST_COLUMN: usize = 1 << 16;
/// Largest number of characters of a file's text in a message.
pub(crate) const LONGEST_SHOWN: usize = 60;

// Suspension files.

/// Deepest nesting of JSON objects and arrays.
pub(crate) const DEEPEST_JSON: usize = 256;
/// Largest number of keys of one object; the search among them is linear.
pub(crate) const MOST_KEYS: usize = 1000;
/// Upper bound of the largest hardpoint coordinate of a vehicle, m. Vehicles are shorter; a vehicle in millimetres that is
/// read in metres is far above this bound.
pub(crate) const FARTHEST_HARDPOINT: f64 = 20.0;
/// Lower bound of the largest hardpoint coordinate of a vehicle, m. A vehicle in metres that is read in millimetres is below
/// this bound; a soapbox car is above.
pub(crate) const NEAREST_HARDPOINT: f64 = 0.02;
/// Largest |cosine| of the angle between the pins of a Hooke's joint, which are perpendicular. Files have three decimals.
pub(crate) const OBLIQUE_PINS: f64 = 1e-3;
/// Sine of the largest angle between directions that count as parallel and span no plane: smaller than any angle that a
/// hardpoint file resolves.
pub(crate) const PARALLEL: f64 = 1e-9;
/// Tolerance of the triangle inequality of principal moments, relative: files have nine digits.
pub(crate) const MOMENT_SLACK: f64 = 1e-9;

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

// Sheets and tables of hardpoints.

/// Largest number of keys of a sheet, or rows of a table. The search is linear; templates have fewer than 100 keys.
pub(crate) const MOST_SHEET_KEYS: usize = 1000;
/// Largest sheet in TOML, bytes: templates have 5 kB. The parser takes some hundred bytes of memory per value.
pub(crate) const LARGEST_SHEET: usize = 4 << 20;
/// Largest number of columns read from a table: a key, three to six numbers, remarks.
pub(crate) const WIDEST_TABLE: usize = 64;
/// Largest workbook, bytes: a table of hardpoints has some 10 kB.
pub(crate) const LARGEST_WORKBOOK: usize = 512 << 10;
/// Largest total size of the unpacked parts of a workbook, bytes: workbooks are usually compressed five- to twentyfold.
pub(crate) const LARGEST_UNPACKED_WORKBOOK: usize = 16 << 20;
/// Largest number of parts of a workbook: a few per sheet, one per picture.
pub(crate) const MOST_WORKBOOK_PARTS: usize = 10_000;
/// Largest number of cell formats of a workbook, twice the limit of spreadsheet programs: the count is the number of
/// occurrences of `xf` in the text of the part.
pub(crate) const MOST_CELL_FORMATS: usize = 1 << 17;
/// Upper bound of the number of cell formats times the length of the longest element in their part, bytes.
pub(crate) const LARGEST_CELL_FORMATS: usize = 64 << 20;
/// Largest total size of the texts in the cells that are read, bytes: a name and remarks per row.
pub(crate) const MOST_TABLE_TEXT: usize = 16 << 20;
/// Largest number of visited cells of a worksheet.
pub(crate) const LARGEST_WORKSHEET: usize = 1_000_000;
/// Largest distance of a hardpoint beyond the vehicle's middle plane, m: tie rods and bars are close to this plane.
pub(crate) const WRONG_SIDE: f64 = 0.05;
/// Ratio of a link length to the median of its corner above which a typing error is probable. In real corners the largest
/// ratio (trailing arms with lateral links) is below 2.
pub(crate) const ASTRAY: f64 = 2.5;
/// Least length, m, of a link that is reported for this ratio: ratios between short links are no sign of an error.
pub(crate) const LEAST_ASTRAY: f64 = 0.6;
/// Longest plausible control arm or link of a corner, m.
pub(crate) const LONGEST_ARM: f64 = 1.8;
/// Largest plausible distance of a centre of mass or a spring mount from the box around the joints of its link, m. A larger
/// distance suggests a value from another vehicle or in other axes. For a joint the limit is twice as large: one end of a
/// trailing arm is 0.7 m away from all other joints.
pub(crate) const OFF_ITS_LINK: f64 = 0.5;

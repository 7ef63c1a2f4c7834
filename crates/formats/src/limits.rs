//! The thresholds of the readers and the writer, each with its unit and its reason.
//!
//! Files may be hostile: every count below bounds time or memory. Sizes are far above those of real models (the largest
//! robots have some hundred links), and small enough that a file at the limit is refused or read within seconds.

// URDF: the text.

/// Elements within elements: real files stay below 20; parsers recurse, and the stack must hold.
pub(crate) const DEEPEST_NESTING: usize = 256;
/// Elements of the whole file.
pub(crate) const MOST_ELEMENTS: usize = 1_000_000;
/// Attributes of the whole file: 100,000 links with all that can be said of each and of its joint have fewer.
pub(crate) const MOST_ATTRIBUTES_IN_ALL: usize = 3_000_000;
/// Nodes of the parsed tree: elements, comments, and the text between them.
pub(crate) const MOST_NODES: u32 = 3_000_000;
/// Attributes of one element: the parser compares all with all.
pub(crate) const MOST_ATTRIBUTES: usize = 256;
/// Declarations of namespaces: the parser searches them at every element.
pub(crate) const MOST_NAMESPACES: usize = 128;
/// Declarations of entities.
pub(crate) const MOST_ENTITIES: usize = 64;
/// Bytes to which the references to entities may expand.
pub(crate) const MOST_EXPANDED: usize = 64 << 20;
/// Deepest nesting of entity references that roxmltree follows.
pub(crate) const REFERENCES_IN_A_REFERENCE: usize = 256;
/// Characters of the XML parser's own message that are shown.
pub(crate) const LONGEST_PARSER_MESSAGE: usize = 200;

// URDF: the elements.

/// Links, joints, loops and couplings of one file: so many of each.
pub(crate) const MOST_BODIES: usize = 100_000;
/// Names longer than this (bytes) are not accepted as names; they would make messages unreadable.
pub(crate) const LONGEST_NAME: usize = 1024;
/// Unknown names for which similar names are searched.
pub(crate) const MOST_SUGGESTIONS: usize = 10;
/// Names compared with an unknown one: the comparison is quadratic in their length.
pub(crate) const MOST_CANDIDATES: usize = 2_000;
/// Longest chain of mimic joints.
pub(crate) const LONGEST_MIMIC_CHAIN: usize = 100;
/// Joints on the paths of all couplings together, from the links up to the root.
pub(crate) const MOST_COUPLING_STEPS: usize = 4_000_000;

// URDF: numbers.

/// |norm − 1| of a quaternion, dimensionless, above which it is an error and not a rounded unit quaternion (files
/// carry three decimals or more).
pub(crate) const QUATERNION_NORM_SLACK: f64 = 1e-3;
/// The largest component of an axis that counts as zero, dimensionless: the mechanism's builder refuses a smaller one.
pub(crate) const SHORTEST_AXIS: f64 = 1e-100;
/// A shape larger than this (m) is a mistake, and not used.
pub(crate) const LARGEST_SHAPE: f64 = 1e9;
/// Relative difference of two values of one armature that is rounding: files carry nine digits.
pub(crate) const ARMATURE_SLACK: f64 = 1e-9;
/// Numbers of this size are written in decimal notation, others in scientific, since zeros would fill the line.
pub(crate) const DECIMAL_NUMBERS: std::ops::Range<f64> = 1e-5..1e16;

// Findings.

/// Largest number of findings shown per severity; further findings are only counted.
pub(crate) const MOST_FINDINGS: usize = 50;
/// Kinds of repeated finding that are counted separately.
pub(crate) const MOST_KINDS: usize = 500;
/// Bytes of a line in which the column of a finding is counted in characters.
pub(crate) const FARTHEST_COLUMN: usize = 1 << 16;
/// Characters of a text from the file that are shown in a message.
pub(crate) const LONGEST_SHOWN: usize = 60;

// Suspension files.

/// Objects and arrays within one another.
pub(crate) const DEEPEST_JSON: usize = 256;
/// Largest number of keys of one object; the search among them is linear.
pub(crate) const MOST_KEYS: usize = 1000;
/// The largest coordinate of a vehicle's hardpoints, m: vehicles are shorter, and one in millimetres that is read in metres
/// exceeds it by far.
pub(crate) const FARTHEST_HARDPOINT: f64 = 20.0;
/// The least that the largest coordinate may be, m: one in metres that is read in millimetres falls below it, a soapbox
/// does not.
pub(crate) const NEAREST_HARDPOINT: f64 = 0.02;
/// Cosine of the angle between the pins of a Hooke's joint above which they are not at right angles: files carry three
/// decimals.
pub(crate) const OBLIQUE_PINS: f64 = 1e-3;
/// Sine of the angle below which two directions are parallel, and span no plane: below any angle that a hardpoint file resolves.
pub(crate) const PARALLEL: f64 = 1e-9;
/// Slack of the triangle inequality of principal moments, relative: files carry nine digits.
pub(crate) const MOMENT_SLACK: f64 = 1e-9;

// Meshes.

/// Vertices of one mesh: three for each triangle.
pub(crate) const MOST_MESH_POSITIONS: usize = 3 * MOST_TRIANGLES;
/// Triangles of one mesh: 360 MB of corners. The finest robot meshes have some hundred thousand.
pub(crate) const MOST_TRIANGLES: usize = 5_000_000;
/// Numbers of the lists in one COLLADA file, positions and indices: twelve for each triangle.
pub(crate) const MOST_MESH_NUMBERS: usize = 12 * MOST_TRIANGLES;
/// Nodes of a COLLADA scene within one another, and all that are visited: instances may repeat one another.
pub(crate) const DEEPEST_NODES: usize = 64;
pub(crate) const MOST_SCENE_NODES: usize = 100_000;
/// Facets around a round shape, fewest and most.
pub(crate) const ROUND_FACETS: std::ops::RangeInclusive<usize> = 16..=720;
/// A part of a mesh whose signed volume is below this part of its area times its size is open, or flat: it has no inside.
pub(crate) const NO_VOLUME: f64 = 1e-9;

// Sheets and tables of hardpoints.

/// Keys of a sheet, rows of a table: templates have below 100; keys are searched one after another.
pub(crate) const MOST_SHEET_KEYS: usize = 1000;
/// Bytes of a sheet in TOML: templates have 5 kB. The parser takes some hundred bytes of memory for each value.
pub(crate) const LARGEST_SHEET: usize = 4 << 20;
/// Columns of a table that are read: a key, three to six numbers, remarks.
pub(crate) const WIDEST_TABLE: usize = 64;
/// Bytes of a workbook. A table of hardpoints has some 10 kB.
pub(crate) const LARGEST_WORKBOOK: usize = 512 << 10;
/// Bytes of a workbook's parts, unpacked: usual workbooks are compressed five- to twentyfold.
pub(crate) const LARGEST_UNPACKED_WORKBOOK: usize = 16 << 20;
/// Parts of a workbook: a sheet has a few, and each picture one.
pub(crate) const MOST_WORKBOOK_PARTS: usize = 10_000;
/// Cell formats of a workbook, twice as many as spreadsheet programs allow: `xf` is counted in the text of the part.
pub(crate) const MOST_CELL_FORMATS: usize = 1 << 17;
/// Bytes of all cell formats, each as long as the longest element of their part.
pub(crate) const LARGEST_CELL_FORMATS: usize = 64 << 20;
/// Bytes of the texts in the cells that are read: a name and remarks in each row.
pub(crate) const MOST_TABLE_TEXT: usize = 16 << 20;
/// Cells of a worksheet that are looked at.
pub(crate) const LARGEST_WORKSHEET: usize = 1_000_000;
/// How far a hardpoint of one side may lie beyond the vehicle's middle plane, m: tie rods and bars come close to it.
pub(crate) const WRONG_SIDE: f64 = 0.05;
/// A link that is so many times as long as the median of its corner looks like a typing error. Of real corners the longest
/// (trailing arms beside lateral links) stay below 2.
pub(crate) const ASTRAY: f64 = 2.5;
/// And is longer than this, m: where all are short, a long one is none.
pub(crate) const LEAST_ASTRAY: f64 = 0.6;
/// No control arm or link of a corner is longer, m.
pub(crate) const LONGEST_ARM: f64 = 1.8;
/// A centre of mass or a seat so far outside of the box around its link's joints, m, looks like one that was left from another
/// vehicle, or stands in other axes; a joint twice as far: trailing arms have one end 0.7 m away from all others.
pub(crate) const OFF_ITS_LINK: f64 = 0.5;

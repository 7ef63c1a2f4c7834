//! Settings of the compiler and of the options. Several sections are merged: the last value of an attribute counts.

use crate::mjcf::values::attributes::Attributes;
use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::Findings;
use crate::reading::report::quoted;

/// Use of the geoms for the inertia of their body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum InertiaFromGeom {
    /// Never.
    Never,
    /// For every body whose geoms have a mass.
    Always,
    /// For bodies without `<inertial>`.
    WithoutInertial,
}

/// Settings that change the mechanism.
#[derive(Clone, Debug)]
pub(crate) struct Settings {
    pub auto_limits: bool,
    /// Radians per unit of an angle.
    pub angle_unit: f64,
    /// Axes of Euler angles: 0 to 2 for x to z; `true` for axes of the parent frame.
    pub euler_sequence: [(usize, bool); 3],
    pub inertia_from_geom: InertiaFromGeom,
    /// First and last group of the geoms whose mass counts.
    pub inertia_groups: [f64; 2],
    pub exact_mesh_inertia: bool,
    /// Least mass of a body, kg, and least principal moment, kg·m².
    pub bound_mass: f64,
    pub bound_inertia: f64,
    pub balance_inertia: bool,
    /// Total mass to which all bodies are scaled, kg.
    pub total_mass: Option<f64>,
    pub mesh_folder: String,
    pub strip_path: bool,
    /// False if an option disables all equality constraints.
    pub equalities: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            auto_limits: true,
            angle_unit: std::f64::consts::PI / 180.0,
            euler_sequence: [(0, false), (1, false), (2, false)],
            inertia_from_geom: InertiaFromGeom::WithoutInertial,
            inertia_groups: [0.0, 5.0],
            exact_mesh_inertia: false,
            bound_mass: 0.0,
            bound_inertia: 0.0,
            balance_inertia: false,
            total_mass: None,
            mesh_folder: String::new(),
            strip_path: false,
            equalities: true,
        }
    }
}

impl Settings {
    /// Reads the `<compiler>` and `<option>` sections below a root.
    pub fn read(root: ElementId, findings: &mut Findings<'_>) -> Self {
        let tree = findings.tree;
        let mut settings = Self::default();
        for element in tree.children_named(root, "compiler") {
            settings.merge_compiler(Attributes::new(tree, element), findings);
        }
        if root != tree.root() {
            // Options of attached models have no effect.
            return settings;
        }
        let flags = tree.in_sections("option").filter(|element| tree.tag(*element) == "flag");
        for element in flags {
            let words = [("enable", true), ("disable", false)];
            for name in ["equality", "constraint"] {
                let enabled = Attributes::new(tree, element).word(name, &words, findings);
                if enabled == Some(false) {
                    settings.equalities = false;
                    findings.warning("disabled-equalities", element, || {
                        format!(
                            "{name}=\"disable\": no equality constraint of the model counts, as in MuJoCo"
                        )
                    });
                }
            }
        }
        settings
    }

    /// Takes the attributes that a `<compiler>` has.
    fn merge_compiler(&mut self, compiler: Attributes<'_>, findings: &mut Findings<'_>) {
        let element = compiler.element;
        if compiler.word("coordinate", &[("local", false), ("global", true)], findings) == Some(true) {
            findings.attribute_error("unsupported", element, "coordinate", || {
                "global coordinates are not read (MuJoCo removed them in version 2.3.4); convert the file with MuJoCo 2.3.3"
                    .to_owned()
            });
        }
        let degrees = std::f64::consts::PI / 180.0;
        set(&mut self.angle_unit, compiler.word("angle", &[("radian", 1.0), ("degree", degrees)], findings));
        set(&mut self.auto_limits, compiler.flag("autolimits", findings));
        set(&mut self.balance_inertia, compiler.flag("balanceinertia", findings));
        set(&mut self.strip_path, compiler.flag("strippath", findings));
        set(&mut self.exact_mesh_inertia, compiler.flag("exactmeshinertia", findings));
        set(&mut self.bound_mass, compiler.number("boundmass", findings));
        set(&mut self.bound_inertia, compiler.number("boundinertia", findings));
        set(&mut self.inertia_groups, compiler.numbers::<2>("inertiagrouprange", findings));
        if let Some(total) = compiler.number("settotalmass", findings) {
            self.total_mass = Some(total).filter(|total| *total > 0.0);
        }
        let words = [
            ("false", InertiaFromGeom::Never),
            ("true", InertiaFromGeom::Always),
            ("auto", InertiaFromGeom::WithoutInertial),
        ];
        set(&mut self.inertia_from_geom, compiler.word("inertiafromgeom", &words, findings));
        for name in ["assetdir", "meshdir"] {
            set(&mut self.mesh_folder, compiler.text(name).map(str::to_owned));
        }
        if let Some(text) = compiler.text("eulerseq") {
            match euler_sequence(text) {
                Some(sequence) => self.euler_sequence = sequence,
                None => findings.attribute_error("bad-keyword", element, "eulerseq", || {
                    format!("eulerseq={}: three letters of x, y, z, X, Y and Z are expected", quoted(text))
                }),
            }
        }
    }
}

/// Replaces a value if another is given.
fn set<T>(value: &mut T, given: Option<T>) {
    if let Some(given) = given {
        *value = given;
    }
}

/// Axes of Euler angles; capital letters are axes of the parent frame.
fn euler_sequence(text: &str) -> Option<[(usize, bool); 3]> {
    let axis = |c: char| Some(("xyz".find(c.to_ascii_lowercase())?, c.is_ascii_uppercase()));
    let axes: Option<Vec<(usize, bool)>> = text.chars().take(4).map(axis).collect();
    axes?.try_into().ok()
}

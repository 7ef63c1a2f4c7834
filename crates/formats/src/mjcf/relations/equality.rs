//! Equality constraints. A `connect` is a spherical closure, a `weld` a fixed one, an equality of a straight tendon a distance;
//! equalities of joints and fixed tendons relate joint positions.

use crate::mjcf::bodies::body::Bodies;
use crate::mjcf::relations::joint_relations::{JointCurve, JointRelations, JointSum};
use crate::mjcf::relations::references::JointKey;
use crate::mjcf::relations::tendon::{Tendon, TendonPath};
use crate::mjcf::values::attributes::Attributes;
use crate::mjcf::values::classes::DefaultKind;
use crate::mjcf::values::models::Models;
use crate::mjcf::values::orientation::rotation_from_quat;
use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::{Findings, similar_name};
use crate::reading::report::quoted;
use percuss_mechanism::{ClosureKind, Severity};
use percuss_spatial::{Matrix3, Transform, Vector3};
use std::collections::HashMap;

/// Body and loop frame of the predecessor and of the successor.
type ClosureEnds = [(usize, Transform<f64>); 2];

/// Closure between two bodies.
#[derive(Clone, Debug)]
pub(crate) struct BodyClosure {
    pub element: ElementId,
    /// Empty if the constraint has no name.
    pub name: String,
    pub kind: ClosureKind,
    pub ends: ClosureEnds,
    /// Length of a distance closure, m.
    pub distance: Option<f64>,
}

/// Closures and relations of joints of a model.
#[derive(Debug, Default)]
pub(crate) struct Constraints {
    pub closures: Vec<BodyClosure>,
    pub joints: JointRelations,
}

/// Refusal of a tendon with copies.
pub(crate) const REPLICATED_TENDON: &str = "the tendon refers to an element of a <replicate>, of which MuJoCo makes copies of the tendon; \
    write one for each copy, with the full names, such as \"a0\"";

/// Source of the constraints of a model.
pub(crate) struct EqualityReader<'r, 't> {
    pub models: &'t Models<'t>,
    pub bodies: &'r Bodies,
    pub tendons: &'r HashMap<String, Tendon>,
}

impl EqualityReader<'_, '_> {
    /// Reads all active constraints.
    pub fn read(&self, findings: &mut Findings<'_>) -> Constraints {
        let mut constraints = Constraints::default();
        if !self.models.main().equalities {
            return constraints;
        }
        for element in findings.tree.in_sections("equality") {
            let attributes = self.models.attributes(element, DefaultKind::Equality, None, findings);
            if attributes.flag("active", findings) == Some(false) {
                findings.add_once(Severity::Warning, "inactive-equality", "inactive", element, || {
                    "the constraint is inactive and does not count".to_owned()
                });
                continue;
            }
            match findings.tree.tag(element) {
                "connect" => {
                    let ends = self.connect_ends(attributes, findings);
                    self.add_closure(attributes, ClosureKind::Spherical, ends, &mut constraints, findings);
                }
                "weld" => {
                    let ends = self.weld_ends(attributes, findings);
                    let scale = attributes.number("torquescale", findings).unwrap_or(1.0);
                    let kind = if scale == 0.0 { ClosureKind::Spherical } else { ClosureKind::Fixed };
                    self.add_closure(attributes, kind, ends, &mut constraints, findings);
                }
                "joint" => {
                    self.add_joint_equality(attributes, &mut constraints.joints, findings);
                }
                "tendon" => self.add_tendon_equality(attributes, &mut constraints, findings),
                // The grammar reports other elements.
                _ => {}
            }
        }
        constraints
    }

    /// Adds a closure, unless its bodies cannot move relative to each other.
    fn add_closure(
        &self,
        attributes: Attributes<'_>,
        kind: ClosureKind,
        ends: Option<ClosureEnds>,
        constraints: &mut Constraints,
        findings: &mut Findings<'_>,
    ) {
        let Some(ends) = ends else { return };
        let element = attributes.element;
        let [first, second] = ends.map(|(body, _)| self.bodies.bodies[body].moving_ancestor);
        if first == second {
            findings.add_once(Severity::Warning, "rigid-bodies", "closure", element, || {
                "the two bodies cannot move relative to each other; the constraint has no effect".to_owned()
            });
            return;
        }
        let name = findings.tree.attribute(element, "name").unwrap_or_default().to_owned();
        constraints.closures.push(BodyClosure { element, name, kind, ends, distance: None });
    }

    /// Two sites with their bodies; `None` if the constraint has none, or, with an error, if one is missing.
    fn sites(&self, attributes: Attributes<'_>, findings: &mut Findings<'_>) -> Option<Option<ClosureEnds>> {
        let names = ["site1", "site2"].map(|name| attributes.text(name));
        if names == [None, None] {
            return None;
        }
        let mut site = |name: Option<&str>, attribute| {
            let site = self.bodies.site_named(
                name.unwrap_or_default(),
                (attributes.element, attribute),
                findings,
            )?;
            Some((site.body, site.frame))
        };
        let sites = (site(names[0], "site1"), site(names[1], "site2"));
        if let Some(name) =
            ["body1", "body2", "anchor", "relpose"].into_iter().find(|n| attributes.text(n).is_some())
        {
            findings.attribute_error("two-notations", attributes.element, name, || {
                format!(
                    "{name} and sites are both given; a constraint is between two bodies or between two sites"
                )
            });
        }
        Some(match sites {
            (Some(first), Some(second)) => Some([first, second]),
            _ => None,
        })
    }

    /// Bodies of a constraint; a missing second body is the world.
    fn body_pair(&self, attributes: Attributes<'_>, findings: &mut Findings<'_>) -> Option<[usize; 2]> {
        let element = attributes.element;
        let Some(first) = attributes.text("body1") else {
            let tag = findings.tree.tag(element);
            findings.error("missing-attribute", element, || {
                format!("<{tag}> has neither body1 nor site1 and site2")
            });
            return None;
        };
        let first = self.bodies.body_named(first, (element, "body1"), findings)?;
        let second = match attributes.text("body2") {
            Some(name) => self.bodies.body_named(name, (element, "body2"), findings)?,
            None => 0,
        };
        Some([first, second])
    }

    /// Frame of the second body in the first, with all joints as drawn.
    fn drawn_pose(&self, [first, second]: [usize; 2]) -> Transform<f64> {
        let world_pose = |body: usize| self.bodies.bodies[body].world_pose;
        world_pose(first).inverse() * world_pose(second)
    }

    /// Points of a `connect`: the anchor belongs to the first body; the point of the second body coincides with it as drawn.
    fn connect_ends(&self, attributes: Attributes<'_>, findings: &mut Findings<'_>) -> Option<ClosureEnds> {
        if let Some(sites) = self.sites(attributes, findings) {
            return sites;
        }
        let bodies = self.body_pair(attributes, findings)?;
        if attributes.text("anchor").is_none() {
            findings.error("missing-attribute", attributes.element, || {
                "<connect> has no attribute \"anchor\", the point in the frame of body1".to_owned()
            });
        }
        let anchor = Vector3::from(attributes.numbers::<3>("anchor", findings)?);
        let other = self.drawn_pose(bodies).inverse_point(&anchor);
        Some([
            (bodies[0], Transform::from_translation(anchor)),
            (bodies[1], Transform::from_translation(other)),
        ])
    }

    /// Frames of a `weld`: the anchor belongs to the second body. Without a relative pose, the frames coincide as drawn.
    fn weld_ends(&self, attributes: Attributes<'_>, findings: &mut Findings<'_>) -> Option<ClosureEnds> {
        if let Some(sites) = self.sites(attributes, findings) {
            return sites;
        }
        let bodies = self.body_pair(attributes, findings)?;
        let anchor = Vector3::from(attributes.numbers::<3>("anchor", findings).unwrap_or_default());
        let declared = attributes.numbers::<7>("relpose", findings).and_then(|[x, y, z, quat @ ..]| {
            // A zero quaternion, the default, stands for no relative pose.
            Some(Transform::new(rotation_from_quat(quat)?, Vector3::new(x, y, z)))
        });
        let drawn = self.drawn_pose(bodies);
        let first = declared.unwrap_or_else(|| Transform::new(drawn.rotation, drawn.point(&anchor)));
        Some([(bodies[0], first), (bodies[1], Transform::new(Matrix3::identity(), anchor))])
    }

    /// Coefficients a₀ to a₄ of the polynomial; `None`, with an error, if they are invalid.
    fn coefficients(&self, attributes: Attributes<'_>, findings: &mut Findings<'_>) -> Option<[f64; 5]> {
        // Coefficients that are not given keep their defaults.
        let mut coefficients = [0.0, 1.0, 0.0, 0.0, 0.0];
        if attributes.text("polycoef").is_some() {
            let given = attributes.list("polycoef", 5, findings)?;
            coefficients[..given.len()].copy_from_slice(&given);
        }
        Some(coefficients)
    }

    /// Adds `<joint>`: q₁ = a₀ + a₁ q₂, or q₁ = a₀ without a second joint; positions are relative to the drawing.
    fn add_joint_equality(
        &self,
        attributes: Attributes<'_>,
        relations: &mut JointRelations,
        findings: &mut Findings<'_>,
    ) -> Option<()> {
        let element = attributes.element;
        let Some(name) = attributes.text("joint1") else {
            findings.error("missing-attribute", element, || "<joint> has no attribute \"joint1\"".to_owned());
            return None;
        };
        let dependent = self.bodies.scalar_joint_named(name, (element, "joint1"), findings)?;
        let coefficients = self.coefficients(attributes, findings);
        let driver = match attributes.text("joint2") {
            Some(name) => Some(self.bodies.scalar_joint_named(name, (element, "joint2"), findings)?),
            None => None,
        };
        if driver == Some(dependent) {
            findings.attribute_error("unsupported", element, "joint2", || {
                "joint1 and joint2 are the same joint; two joints are expected, or joint1 alone, which is locked"
                    .to_owned()
            });
        }
        let coefficients = coefficients?;
        let driver = driver.map(|joint| vec![(joint, 1.0)]);
        let sum = joint_sum(vec![(dependent, 1.0)], driver.as_deref(), coefficients);
        self.add_relation(element, sum, relations, findings);
        Some(())
    }

    /// Adds a relation of joint positions, with an error if it contradicts an earlier one.
    fn add_relation(
        &self,
        element: ElementId,
        sum: JointSum,
        relations: &mut JointRelations,
        findings: &mut Findings<'_>,
    ) {
        if relations.add(element, sum).is_err() {
            findings.error("contradiction", element, || {
                "earlier constraints determine these joints already, with other positions".to_owned()
            });
        }
    }

    fn add_tendon_equality(
        &self,
        attributes: Attributes<'_>,
        constraints: &mut Constraints,
        findings: &mut Findings<'_>,
    ) {
        let element = attributes.element;
        let mut tendon = |attribute: &'static str| {
            let name = attributes.text(attribute)?;
            let found = self.tendons.get(name);
            if found.is_none() {
                findings.attribute_error("unknown-reference", element, attribute, || {
                    let names =
                        self.tendons.keys().map(String::as_str).filter(|name| !name.starts_with('\u{0}'));
                    format!("the tendon {} does not exist{}", quoted(name), similar_name(name, names))
                });
            }
            Some(found)
        };
        let (first, second) = (tendon("tendon1"), tendon("tendon2"));
        let Some(first) = first else {
            findings
                .error("missing-attribute", element, || "<tendon> has no attribute \"tendon1\"".to_owned());
            return;
        };
        let (Some(first), second) = (first, second) else { return };
        let Some(coefficients) = self.coefficients(attributes, findings) else { return };
        match (&first.path, second.map(|second| second.map(|tendon| &tendon.path))) {
            (_, Some(None)) => {}
            (TendonPath::Fixed(terms), None) => {
                let sum = joint_sum(terms.clone(), None, coefficients);
                self.add_relation(element, sum, &mut constraints.joints, findings);
            }
            (TendonPath::Fixed(terms), Some(Some(TendonPath::Fixed(others)))) => {
                let sum = joint_sum(terms.clone(), Some(others), coefficients);
                self.add_relation(element, sum, &mut constraints.joints, findings);
            }
            (TendonPath::Line(sites), None) => {
                let ends = sites.each_ref().map(|site| (site.body, site.frame));
                let points =
                    ends.map(|(body, frame)| self.bodies.bodies[body].world_pose.point(&frame.translation));
                let before = constraints.closures.len();
                self.add_closure(attributes, ClosureKind::Distance, Some(ends), constraints, findings);
                if let Some(closure) = constraints.closures.get_mut(before) {
                    closure.distance = Some((points[1] - points[0]).norm() + coefficients[0]);
                }
            }
            (TendonPath::Replicated, _) | (_, Some(Some(TendonPath::Replicated))) => {
                findings.error("unsupported", element, || REPLICATED_TENDON.to_owned());
            }
            _ => findings.error("unsupported", element, || {
                "of spatial tendons, only the length of a straight line between two sites is kept constant here; other equalities of \
                 spatial tendons are not read, and the answer without them would be wrong"
                    .to_owned()
            }),
        }
    }
}

/// Relation Σ terms = a₀ + a₁ s + a₂ s² + a₃ s³ + a₄ s⁴ with s = Σ others; without others only a₀ counts.
fn joint_sum(
    mut terms: Vec<(JointKey, f64)>,
    others: Option<&[(JointKey, f64)]>,
    [constant, linear, higher @ ..]: [f64; 5],
) -> JointSum {
    let Some(others) = others else { return JointSum { terms, constant, curve: None } };
    terms.extend(others.iter().map(|(joint, coefficient)| (*joint, -linear * coefficient)));
    let curve = (higher != [0.0; 3]).then(|| JointCurve {
        terms: others.to_vec(),
        offset: 0.0,
        coefficients: higher,
    });
    JointSum { terms, constant, curve }
}

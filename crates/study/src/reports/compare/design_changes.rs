//! Differences between two designs: masses, inertias, hardpoints, contacts, links.

use crate::model::loading::Model;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::contact::{ConditionsTable, ContactTable, PoseTable};
use crate::thresholds::{EQUAL_VALUES, SLENDER_ROD};
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Serialize;

/// Difference of a design from its reference.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DesignChange {
    /// Kind of the difference.
    pub kind: ChangeKind,
    /// Name of the link, the hardpoint, or the contact of a gap; empty for the contact, the pose and the conditions of the question.
    pub name: String,
    /// Value of the reference, kg, kg·m² or m (hardpoints in the axes of the sheet, centres of mass in the link frame); null without a
    /// value.
    pub reference: Option<Vec<f64>>,
    /// Value of the design, in the same unit.
    pub value: Option<Vec<f64>>,
}

/// Kind of a difference between designs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ChangeKind {
    /// Hardpoint of a suspension, m, in the axes of the sheet.
    Point,
    /// Mass of a link, kg.
    Mass,
    /// Centre of mass of a link, m, in its frame; compared if no hardpoint differs.
    CentreOfMass,
    /// Principal moments of inertia of a link about its centre of mass, kg·m².
    Inertia,
    /// Gap of a named contact as drawn, m.
    Gap,
    /// Link of one of the designs only.
    Link,
    /// Contact of the question.
    Contact,
    /// Pose of the question.
    Pose,
    /// Conditions of the question: base, locks, armatures, held points, mass of the other side.
    Conditions,
}

/// Differences of a design from its reference: links of one design only, hardpoints, bodies, gaps, then the question.
pub(crate) fn design_changes(
    [reference, design]: [&Model; 2],
    [before, after]: [&MassQuestion; 2],
) -> Vec<DesignChange> {
    let mut changes = point_changes(reference, design);
    let has_moved = !changes.is_empty();
    changes.extend(link_changes(reference, design, has_moved));
    // Links of one design only come first: they explain most of the other differences.
    changes.sort_by_key(|change| change.kind != ChangeKind::Link);
    changes.extend(gap_changes(reference, design));
    let mut differs = |kind, is_different: bool| {
        if is_different {
            changes.push(DesignChange { kind, name: String::new(), reference: None, value: None });
        }
    };
    let contact = |q: &MassQuestion| ContactTable {
        name: None,
        against_mass: None,
        estimate: None,
        ratio_at: Vec::new(),
        ..q.contact.clone()
    };
    differs(ChangeKind::Contact, contact(before) != contact(after));
    let pose = |q: &MassQuestion| PoseTable { file: None, ..q.pose.clone() };
    let is_given = |q: &MassQuestion| q.positions.is_some();
    differs(ChangeKind::Pose, pose(before) != pose(after) || is_given(before) != is_given(after));
    let conditions = |q: &MassQuestion| {
        let base = Some(q.conditions.base.unwrap_or_default());
        (ConditionsTable { base, ..q.conditions.clone() }, q.hold.clone(), q.contact.against_mass)
    };
    differs(ChangeKind::Conditions, conditions(before) != conditions(after));
    changes
}

/// True if two lists of values are equal within the rounding of their conversion between units.
fn is_equal(one: &[f64], other: &[f64]) -> bool {
    let scale = one.iter().chain(other).fold(0.0f64, |most, x| most.max(x.abs()));
    one.len() == other.len() && one.iter().zip(other).all(|(a, b)| (a - b).abs() <= EQUAL_VALUES * scale)
}

/// Change of a value; `None` for equal values.
fn change(kind: ChangeKind, name: &str, reference: &[f64], value: &[f64]) -> Option<DesignChange> {
    (!is_equal(reference, value)).then(|| DesignChange {
        kind,
        name: name.to_owned(),
        reference: Some(reference.to_vec()),
        value: Some(value.to_vec()),
    })
}

/// Displaced hardpoints of two sheets; empty if their axes differ.
fn point_changes(reference: &Model, design: &Model) -> Vec<DesignChange> {
    let sheets = (reference.origin.sheet.as_deref(), design.origin.sheet.as_deref());
    let (Some(one), Some(other)) = sheets else { return Vec::new() };
    if one.understood.axes != other.understood.axes {
        return Vec::new();
    }
    let of_point = |(name, at): &(String, [f64; 3])| {
        let (_, there) = other.understood.coordinates.iter().find(|(known, _)| known == name)?;
        change(ChangeKind::Point, name, at, there)
    };
    one.understood.coordinates.iter().filter_map(of_point).collect()
}

/// Masses, centres of mass and inertias of the links of both designs, and the links of one design only.
fn link_changes(reference: &Model, design: &Model, has_moved: bool) -> Vec<DesignChange> {
    let (one, other) = (&reference.mechanism, &design.mechanism);
    let mut changes = Vec::new();
    let only = |name: &str, mass: f64| DesignChange {
        kind: ChangeKind::Link,
        name: name.to_owned(),
        reference: None,
        value: Some(vec![mass]),
    };
    for link in one.links() {
        let own = link.inertia();
        let Ok(found) = other.find_link(link.name()) else {
            let DesignChange { value, .. } = only(link.name(), own.mass);
            changes.push(DesignChange { reference: value, value: None, ..only(link.name(), own.mass) });
            continue;
        };
        let there = other.link(found).inertia();
        changes.extend(change(ChangeKind::Mass, link.name(), &[own.mass], &[there.mass]));
        if own.mass == 0.0 || there.mass == 0.0 {
            continue;
        }
        let coms = [own, there].map(|inertia| <[f64; 3]>::from(inertia.first_moment / inertia.mass));
        if !has_moved {
            changes.extend(change(ChangeKind::CentreOfMass, link.name(), &coms[0], &coms[1]));
        }
        // Moments per unit mass are compared: a change of the mass alone scales the inertia.
        let moments = [own, there].map(|inertia| {
            let com: Vector3<f64> = inertia.first_moment / inertia.mass;
            let about_com = inertia.rotational
                - (nalgebra::Matrix3::identity() * com.norm_squared() - com * com.transpose()) * inertia.mass;
            let mut moments: [f64; 3] = (about_com / inertia.mass).symmetric_eigenvalues().into();
            moments.sort_by(f64::total_cmp);
            moments
        });
        // The length of a slender rod follows from its hardpoints.
        let is_rod = moments.iter().all(|[least, _, most]| *least <= SLENDER_ROD * most);
        let follows_points = has_moved && is_rod;
        if !follows_points && !is_equal(&moments[0], &moments[1]) {
            let scaled = |moments: [f64; 3], mass: f64| moments.map(|moment| moment * mass);
            let [before, after] = [scaled(moments[0], own.mass), scaled(moments[1], there.mass)];
            changes.extend(change(ChangeKind::Inertia, link.name(), &before, &after));
        }
    }
    let new = other.links().iter().filter(|link| one.find_link(link.name()).is_err());
    changes.extend(new.map(|link| only(link.name(), link.inertia().mass)));
    changes
}

/// Gaps of the named contacts of both designs.
fn gap_changes(reference: &Model, design: &Model) -> Vec<DesignChange> {
    let of_contact = |contact: &percuss_mechanism::NamedContact| {
        let other = design.mechanism.find_contact(contact.name()).ok()?;
        change(ChangeKind::Gap, contact.name(), &[contact.gap()?], &[other.gap()?])
    };
    reference.mechanism.contacts().iter().filter_map(of_contact).collect()
}

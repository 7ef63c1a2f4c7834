//! Reflected inertia at a joint, and the mass of a point that is held in the tangent plane.

use crate::group_rows::GroupRows;
use crate::mobility::delassus::relative_jacobian;
use crate::motion::driver_rates::{kernel, lengths};
use crate::tolerances::DRIVES;
use nalgebra::{DMatrix, DVector, Vector3};
use percuss_dynamics::{EffectiveMass, LocatedContact, MatrixError, MatrixOptions, MatrixView, Pose};
use percuss_mechanism::JointId;
use percuss_spatial::{SpatialInertia, Transform, Twist, plane_basis};

/// Error of a reflected inertia.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReflectedError {
    /// The joint has no such velocity.
    #[error("joint \"{joint}\" has {count} velocities; number {index} (from 0) was requested")]
    Velocity {
        /// The joint.
        joint: String,
        /// Requested velocity.
        index: usize,
        /// Number of velocities.
        count: usize,
    },
    /// The matrices of the pose cannot be solved.
    #[error(transparent)]
    Matrices(#[from] MatrixError),
}

/// Inertia of the mechanism reflected to one velocity of a joint, kg·m² or kg.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReflectedInertia {
    /// Inertia with all other joints free: min { vᵀMv : Av = 0, q̇ = 1 }, as at a stop of a mechanism without drive torques.
    pub free: EffectiveMass,
    /// Inertia with the other drivers at rest, as at a motor of a servo-controlled mechanism. `None` if the joint is no driver.
    pub held: Option<EffectiveMass>,
}

/// Inertia reflected to velocity `index` of a joint, free and with the other drivers held.
///
/// The drivers are the drivers of the loops and all joints outside loops; the base of a floating mechanism stays free.
/// Both values are solutions of the definition of m̄ with a row that selects the velocity. Cost: O(n³). Source: Paul
/// 1979 (one degree of freedom).
///
/// # Errors
/// [`ReflectedError`]: a velocity that the joint does not have; a mass matrix that is not positive semi-definite.
pub fn reflected_inertia(
    pose: &Pose,
    joint: JointId,
    index: usize,
) -> Result<ReflectedInertia, ReflectedError> {
    reflected_inertia_with(pose, joint, index, &[])
}

/// As [`reflected_inertia`], with the drivers of [`driving_joints_with`].
///
/// # Errors
/// As for [`reflected_inertia`].
pub fn reflected_inertia_with(
    pose: &Pose,
    joint: JointId,
    index: usize,
    preferred: &[JointId],
) -> Result<ReflectedInertia, ReflectedError> {
    let declared = pose.mechanism().joint(joint);
    let count = declared.kind().dofs();
    if index >= count {
        return Err(ReflectedError::Velocity { joint: declared.name().to_owned(), index, count });
    }
    let system = PoseMatrices::new(pose);
    if pose.is_locked(joint) {
        return Ok(ReflectedInertia { free: EffectiveMass::Immovable, held: None });
    }
    let (master, multiplier) = declared.mimic().map_or((joint, 1.0), |m| (m.master, m.multiplier));
    let row = |joint: JointId, k: usize, factor: f64| {
        let entry = |c: &(Option<JointId>, usize)| if *c == (Some(joint), k) { factor } else { 0.0 };
        system.coordinates.iter().map(entry).collect::<Vec<f64>>()
    };
    let own = row(master, index, multiplier);
    let free = system.least_mass(&own, &[])?;
    let drivers = driving_velocities_with(pose, preferred);
    let held = if drivers.contains(&(master, index)) {
        let others: Vec<Vec<f64>> = drivers
            .iter()
            .filter(|driver| **driver != (master, index))
            .map(|&(joint, k)| row(joint, k, 1.0))
            .collect();
        Some(system.least_mass(&own, &others)?)
    } else {
        None
    };
    Ok(ReflectedInertia { free, held })
}

/// Effective mass at a contact whose point cannot slide: min { vᵀMv : Av = 0, jv = 1, J_t v = 0 }, the *sticking* mass
/// nᵀΛn. m̄ itself is the *sliding* mass, 1/(nᵀΛ⁻¹n), and is never larger. For a moment: without relative rotation about the axes
/// perpendicular to â.
///
/// # Errors
/// [`ReflectedError`]: a mass matrix that is not positive semi-definite.
pub fn held_point_mass(pose: &Pose, contact: &LocatedContact) -> Result<EffectiveMass, ReflectedError> {
    let system = PoseMatrices::new(pose);
    let own = pose.link_in_root(contact.link);
    let normal = own.vector(&contact.normal_link);
    let jacobian = relative_jacobian(pose, contact);
    let along = |direction: Vector3<f64>| (direction.transpose() * &jacobian).iter().copied().collect();
    let (t1, t2) = plane_basis(&normal);
    let row: Vec<f64> = along(normal);
    Ok(system.least_mass(&row, &[along(t1), along(t2)])?)
}

/// Masses of a contact if all moving links form one free rigid body (the composite rigid body), kg: sliding and sticking.
///
/// A contact point that can slide has the mass 1/(nᵀΛ⁻¹n), one that cannot slide nᵀΛn, with Λ⁻¹ = 1/m − `[r]× I⁻¹ [r]×`; m and I are the
/// mass and the central inertia of the body, r points from its centre of mass to the contact point. Links that fixed joints connect to a
/// fixed base are not part of the body. Rotors are ignored. Immovable for a contact between two moving links, and for a contact link that
/// does not move. For a moment: inertias about â; the first permits rotations about the axes perpendicular to â, the second does not.
/// Source: Wang, Dehio and Kheddar 2022.
///
/// # Errors
/// [`ReflectedError`]: inertias that are not positive semi-definite.
pub fn locked_body_masses(
    pose: &Pose,
    contact: &LocatedContact,
) -> Result<[EffectiveMass; 2], ReflectedError> {
    let mechanism = pose.mechanism();
    let own = pose.link_in_root(contact.link);
    let point = own.point(&contact.point_link);
    let is_floating = pose.coordinate_joints().first().is_some_and(|(joint, _)| joint.is_none());
    let mut rests = vec![false; mechanism.links().len()];
    let mut total = SpatialInertia::zero();
    for &link in mechanism.order() {
        rests[link.index()] = !is_floating
            && mechanism.parent_joint(link).is_none_or(|joint| {
                let joint = mechanism.joint(joint);
                joint.kind().dofs() == 0 && rests[joint.parent().index()]
            });
        if rests[link.index()] {
            continue;
        }
        let frame = pose.link_in_root(link);
        let own =
            Transform::new(frame.rotation, frame.translation - point).inertia(mechanism.link(link).inertia());
        total = SpatialInertia::about_origin(
            total.mass + own.mass,
            total.first_moment + own.first_moment,
            total.rotational + own.rotational,
        );
    }
    if contact.against.is_some_and(|against| !rests[against.index()]) || rests[contact.link.index()] {
        return Ok([EffectiveMass::Immovable; 2]);
    }
    let mut mass = DMatrix::zeros(6, 6);
    for k in 0..6 {
        let unit = |first: usize| Vector3::from_fn(|i, _| f64::from(u8::from(i + first == k)));
        let momentum = total.momentum(&Twist::new(unit(0), unit(3)));
        for i in 0..3 {
            (mass[(i, k)], mass[(i + 3, k)]) = (momentum.moment[i], momentum.force[i]);
        }
    }
    let size = mechanism.characteristic_length();
    let system = PoseMatrices {
        coordinates: Vec::new(),
        lengths: vec![size, size, size, 1.0, 1.0, 1.0],
        mass,
        constraints: Vec::new(),
    };
    let normal = own.vector(&contact.normal_link);
    let (t1, t2) = plane_basis(&normal);
    let row = |v: Vector3<f64>| match contact.is_moment {
        true => vec![v.x, v.y, v.z, 0.0, 0.0, 0.0],
        false => vec![0.0, 0.0, 0.0, v.x, v.y, v.z],
    };
    let sliding = system.least_mass(&row(normal), &[])?;
    Ok([sliding, system.least_mass(&row(normal), &[row(t1), row(t2)])?])
}

/// Velocities that drive at a pose: those of the drivers of the loops, and those outside loops.
pub(crate) fn driving_velocities(pose: &Pose) -> Vec<(JointId, usize)> {
    let coordinates = pose.coordinate_joints();
    let mut bound = vec![false; coordinates.len()];
    for group in pose.constraint_groups() {
        group.coordinates.iter().for_each(|&c| bound[c] = true);
    }
    let of_loops = pose.assembly().drivers();
    let drives = |(c, (joint, k)): (usize, &(Option<JointId>, usize))| {
        let joint = (*joint)?;
        (!bound[c] || of_loops.contains(&joint)).then_some((joint, *k))
    };
    coordinates.iter().enumerate().filter_map(drives).collect()
}

/// Velocities that drive at a pose if the velocities of the `preferred` joints drive where they can: the first independent ones of these
/// and of [`driving_velocities`], in the order of the coordinates.
fn driving_velocities_with(pose: &Pose, preferred: &[JointId]) -> Vec<(JointId, usize)> {
    let automatic = driving_velocities(pose);
    if preferred.iter().all(|joint| automatic.iter().any(|(driver, _)| driver == joint)) {
        return automatic;
    }
    let coordinates = pose.coordinate_joints();
    let groups: Vec<GroupRows> = pose.constraint_groups().into_iter().map(GroupRows::new).collect();
    let kernel = kernel(&groups, &lengths(pose, &coordinates));
    let index = |(joint, k): (JointId, usize)| coordinates.iter().position(|c| *c == (Some(joint), k));
    let of_joint = |joint: &JointId| coordinates.iter().position(|(own, _)| *own == Some(*joint));
    let first = preferred.iter().filter_map(of_joint);
    let mut drivers: Vec<usize> = Vec::new();
    let mut basis: Vec<DVector<f64>> = Vec::new();
    for c in first.chain(automatic.into_iter().filter_map(index)) {
        let mut row = DVector::from_fn(kernel.ncols(), |k, _| kernel[(c, k)]);
        basis.iter().for_each(|known| row -= known * known.dot(&row));
        if row.norm() > DRIVES {
            basis.push(row.normalize());
            drivers.push(c);
        }
    }
    drivers.sort_unstable();
    drivers.into_iter().filter_map(|c| Some((coordinates[c].0?, coordinates[c].1))).collect()
}

/// Joints that drive at a pose, in the order of the coordinates.
pub fn driving_joints(pose: &Pose) -> Vec<JointId> {
    driving_joints_with(pose, &[])
}

/// Joints that drive at a pose, in the order of the coordinates. A `preferred` joint with one velocity, such as one whose position is given,
/// drives instead of an automatic driver of its loop, unless it cannot move independently of the joints before it.
pub fn driving_joints_with(pose: &Pose, preferred: &[JointId]) -> Vec<JointId> {
    let velocities = driving_velocities_with(pose, preferred);
    let mut joints: Vec<JointId> = velocities.into_iter().map(|(joint, _)| joint).collect();
    joints.dedup();
    joints
}

/// M and independent rows of A at a pose.
pub(crate) struct PoseMatrices {
    coordinates: Vec<(Option<JointId>, usize)>,
    lengths: Vec<f64>,
    mass: DMatrix<f64>,
    constraints: Vec<Vec<f64>>,
}

impl PoseMatrices {
    pub(crate) fn new(pose: &Pose) -> Self {
        let coordinates = pose.coordinate_joints();
        let n = coordinates.len();
        let mut constraints = Vec::new();
        for group in pose.constraint_groups().into_iter().map(GroupRows::new) {
            let rows = group.independent_rows();
            for i in 0..rows.nrows() {
                let mut row = vec![0.0; n];
                group.coordinates().iter().enumerate().for_each(|(at, &c)| row[c] = rows[(i, at)]);
                constraints.push(row);
            }
        }
        Self { lengths: lengths(pose, &coordinates), mass: pose.mass_matrix(), coordinates, constraints }
    }

    /// min { vᵀMv : Av = 0, held v = 0, row v = 1 }.
    pub(crate) fn least_mass(&self, row: &[f64], held: &[Vec<f64>]) -> Result<EffectiveMass, MatrixError> {
        let n = row.len();
        let rows: Vec<&Vec<f64>> = self.constraints.iter().chain(held).collect();
        let options = MatrixOptions::new().lengths(&self.lengths);
        let stacked = DMatrix::from_fn(rows.len(), n, |r, c| rows[r][c]);
        let constraints = (!rows.is_empty()).then(|| MatrixView::from(&stacked));
        let response = percuss_dynamics::effective_mass(&self.mass, row, constraints, &options)?;
        Ok(response.effective_mass)
    }
}

//! Relative closing speed: |j restricted to ker A| relative to the size of its terms. Decides if any admissible
//! motion closes the gap. The result depends on lengths, not on masses.

use crate::kinematics::contact_row::{ContactRow, RowEntry};
use crate::linear::dense::dot;
use crate::mobility::GroupMobility;
use crate::model::{Cluster, Model, VelocityCoordinate};
use crate::recursion::Recursion;
use crate::tolerances::{DEPENDENT_RATES, IMMOVABLE, LEAST_SINGULAR, MOST_GROWTH, RATE_ROUNDINGS};

/// Relative closing speed: |projection of j on ker A| / |sizes of the terms of j|, dimensionless, over coordinates scaled
/// by the contact's length. 0: no admissible motion closes the gap.
///
/// ker A is the product of the kernels of the clusters, so the squared projections of j on these kernels are summed.
pub(crate) fn relative_closing_speed<const K: usize>(
    workspace: &mut ClosingWorkspace,
    model: &Model,
    groups: &[GroupMobility],
    recursion: &Recursion<K>,
    row: &ContactRow,
) -> f64 {
    let (mut along, mut size) = (0.0, 0.0);
    let mut members = std::mem::take(&mut workspace.members);
    fill_members(&mut members, model, recursion, row);
    for (number_of_entry, entry) in row.entries.iter().enumerate() {
        let length = if entry.turns { row.length } else { 1.0 };
        size += (entry.size / length).powi(2);
        let number = model.cluster_of[entry.body];
        match recursion.cluster_index[number] {
            None => along += (entry.value / length).powi(2),
            Some(place) => {
                let own = &members[members.partition_point(|&(cluster, _)| cluster < number)..];
                // The first entry of a cluster adds those of the whole cluster.
                if own[0].1 == number_of_entry {
                    let own = &own[..own.partition_point(|&(cluster, _)| cluster == number)];
                    let of = (&recursion.clusters[place].g[..], recursion.clusters[place].d);
                    along += projected(workspace, model, groups, &model.clusters[number], of, (row, own));
                }
            }
        }
    }
    workspace.members = members;
    if size > 0.0 { (along / size).sqrt() } else { 0.0 }
}

/// Threshold below which a relative closing speed may be only rounding, or only the misfit of loops moved by the
/// contact. The threshold is the largest rank threshold of these loops. A slower closing speed may still be real: the
/// exact mechanism may have the same speed.
pub(crate) fn closing_floor(model: &Model, groups: &[GroupMobility], row: &ContactRow) -> f64 {
    let mut floor = IMMOVABLE;
    for entry in &row.entries {
        for own in &model.clusters[model.cluster_of[entry.body]].groups {
            let higher = groups[own.group].floor > floor;
            let moves = |f: &VelocityCoordinate| model.groups[own.group].column(f.index).is_some();
            if higher && model.velocity_coordinates[entry.velocity].as_ref().is_some_and(moves) {
                floor = groups[own.group].floor;
            }
        }
    }
    floor
}

/// Fills in the clusters with constraints and the numbers of their entries of the row, in ascending order.
fn fill_members<const K: usize>(
    members: &mut Vec<(usize, usize)>,
    model: &Model,
    recursion: &Recursion<K>,
    row: &ContactRow,
) {
    let of_entry = |(entry, e): (usize, &RowEntry)| {
        let cluster = model.cluster_of[e.body];
        recursion.cluster_index[cluster].map(|_| (cluster, entry))
    };
    members.clear();
    members.extend(row.entries.iter().enumerate().filter_map(of_entry));
    members.sort_unstable();
}

/// Buffers for the projections; refilled in place.
#[derive(Clone, Debug, Default)]
pub(crate) struct ClosingWorkspace {
    j: Vec<f64>,
    /// Orthonormal vectors, one after another.
    basis: Vec<f64>,
    part: Vec<f64>,
    positions: Vec<usize>,
    /// Clusters with constraints, and the numbers of their entries of the row.
    members: Vec<(usize, usize)>,
}

/// Squared norm of the projection of j on the kernel within a cluster, without rounding. `of`: G of the cluster and
/// the number of its independent coordinates. `own`: the entries of the cluster in the row.
fn projected(
    workspace: &mut ClosingWorkspace,
    model: &Model,
    groups: &[GroupMobility],
    cluster: &Cluster,
    of: (&[f64], usize),
    (row, own): (&ContactRow, &[(usize, usize)]),
) -> f64 {
    let scale = |c: usize| if model.coordinates[cluster.coordinates[c]].turns { row.length } else { 1.0 };
    workspace.j.clear();
    workspace.j.resize(cluster.coordinates.len(), 0.0);
    for entry in own.iter().map(|&(_, entry)| &row.entries[entry]) {
        if let Ok(at) = cluster.velocities.binary_search_by_key(&entry.velocity, |v| v.index) {
            let v = &cluster.velocities[at];
            workspace.j[v.coordinate] += entry.value * v.multiplier / scale(v.coordinate);
        }
    }
    let rank: usize = cluster.groups.iter().map(|own| groups[own.group].pivots.rows.len()).sum();
    if rank < of.1 {
        row_complement_projection(workspace, model, groups, cluster, &scale)
    } else {
        kernel_projection(workspace, groups, cluster, of, &scale)
    }
}

/// Squared length of the projection of j (in `workspace`) on ker A of one cluster, the column space of G. The columns of G are
/// orthonormalised one after another; `d`: their number; `scale`: scale of each coordinate.
fn kernel_projection(
    workspace: &mut ClosingWorkspace,
    groups: &[GroupMobility],
    cluster: &Cluster,
    (g, d): (&[f64], usize),
    scale: &dyn Fn(usize) -> f64,
) -> f64 {
    let n = workspace.j.len();
    let largest = workspace.j.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
    let growth = largest_growth(groups, cluster);
    let mut sum = 0.0;
    workspace.basis.clear();
    for y in 0..d {
        let start = workspace.basis.len();
        workspace.basis.extend((0..n).map(|c| g[c * d + y] * scale(c)));
        let (known, column) = workspace.basis.split_at_mut(start);
        let norm = dot(column, column).sqrt();
        orthogonalise(known, column);
        let left = dot(column, column).sqrt();
        if left <= DEPENDENT_RATES * norm || left == 0.0 {
            workspace.basis.truncate(start);
            continue;
        }
        column.iter_mut().for_each(|c| *c /= left);
        let value = dot(&workspace.j, column);
        let terms = workspace.j.iter().zip(column.iter()).map(|(a, b)| (a * b).abs()).fold(0.0, f64::max);
        // Values within the rounding of cancelling terms, or of G, count as zero.
        let rounding = RATE_ROUNDINGS * f64::EPSILON * (terms + growth * largest * norm / left);
        if value.abs() > rounding {
            sum += value * value;
        }
    }
    sum
}

/// Subtracts the components along orthonormal vectors (one after another in `known`) from a vector. Two passes are
/// sufficient.
fn orthogonalise(known: &[f64], vector: &mut [f64]) {
    for _ in 0..2 {
        for other in known.chunks_exact(vector.len().max(1)) {
            let along = dot(other, vector);
            vector.iter_mut().zip(other).for_each(|(v, o)| *v -= along * o);
        }
    }
}

/// Projection of j on the complement of the independent rows, for clusters with fewer rows than independent
/// coordinates.
fn row_complement_projection(
    workspace: &mut ClosingWorkspace,
    model: &Model,
    groups: &[GroupMobility],
    cluster: &Cluster,
    scale: &dyn Fn(usize) -> f64,
) -> f64 {
    for own in &cluster.groups {
        if own.coordinates.iter().all(|&c| workspace.j[c] == 0.0) {
            continue;
        }
        let (group, known) = (&model.groups[own.group], &groups[own.group]);
        let (n, count) = (own.coordinates.len(), known.pivots.rows.len());
        let ClosingWorkspace { j, basis, part, positions: place, .. } = workspace;
        place.clear();
        place.resize(group.rows, usize::MAX);
        known.pivots.rows.iter().enumerate().for_each(|(i, r)| place[*r] = i);
        basis.clear();
        basis.resize(count * n, 0.0);
        known.rows.for_each(group, |r, c, a| {
            if place[r] != usize::MAX {
                basis[place[r] * n + c] += a / scale(own.coordinates[c]);
            }
        });
        for i in 0..count {
            let (before, row) = basis.split_at_mut(i * n);
            let row = &mut row[..n];
            orthogonalise(before, row);
            let norm = dot(row, row).sqrt();
            row.iter_mut().for_each(|r| *r /= norm);
        }
        part.clear();
        part.extend(own.coordinates.iter().map(|&c| j[c]));
        let before = dot(part, part).sqrt();
        orthogonalise(basis, part);
        let rounding = RATE_ROUNDINGS * f64::EPSILON * before * (count as f64 + 1.0)
            / known.rank.least.max(LEAST_SINGULAR);
        let nothing = dot(part, part).sqrt() <= rounding;
        for (&c, value) in own.coordinates.iter().zip(part.iter()) {
            j[c] = if nothing { 0.0 } else { *value };
        }
    }
    dot(&workspace.j, &workspace.j)
}

/// Largest entry of |K⁻¹||A| over the groups of a cluster.
fn largest_growth(groups: &[GroupMobility], cluster: &Cluster) -> f64 {
    let of_group = |known: &GroupMobility| match known.pivots.rows.is_empty() {
        true => 0.0,
        false => known.sizes.iter().fold(known.size(0, 0), |most, s| most.max(*s)),
    };
    cluster.groups.iter().map(|own| of_group(&groups[own.group])).fold(0.0, f64::max).min(MOST_GROWTH)
}

//! Linkages with neighbouring assembly modes, and the ends of their branches: in closed form, and for a platform by
//! numerical continuation along its curve of closed poses.

use super::Linkage;
use super::planar::{link, on_ground};
use crate::alter::build_with_loops;
use crate::closed_form::{Crossing, FourBar, PlanarBody};
use crate::parts::{frame, ground, joint, lump};
use nalgebra::{Matrix3, Quaternion, Rotation3, SMatrix, SVector, UnitQuaternion, Vector2, Vector3};
use percuss_mechanism::{ClosureDescription, ClosureKind, JointKind, MimicDescription};
use percuss_spatial::Transform;
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::f64::consts::{PI, TAU};

use JointKind::{Continuous, Spherical};

const Z: [f64; 3] = [0.0, 0.0, 1.0];
/// Transmission ratio from the crank to the hip.
const HIP_RATIO: f64 = 0.5;
/// Number of samples of a range in the search for its limits.
const SCAN_STEPS: i32 = 20_000;

/// Linkage with a branch of known extent.
pub struct Branching {
    /// Kind and dimensions, for failure messages.
    pub label: String,
    /// The linkage; its first driver moves it, and its start lies on the branch.
    pub linkage: Linkage,
    /// Driver values at the two ends of the branch, relative to the start; infinite without a limit.
    pub ends: [f64; 2],
    exact: PositionsOfDriver,
}

/// Positions of joints on the branch, by name.
type Positions = Vec<(&'static str, Vec<f64>)>;
/// Positions on the branch as a function of the driver; `None` without a closed pose.
type PositionsOfDriver = Box<dyn Fn(f64) -> Option<Positions> + Send + Sync>;

impl std::fmt::Debug for Branching {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Branching")
            .field("label", &self.label)
            .field("ends", &self.ends)
            .finish_non_exhaustive()
    }
}

impl Branching {
    /// Positions of some joints on the branch at a driver value; `None` beyond its ends, and if the continuation fails.
    pub fn at(&self, driver: f64) -> Option<Positions> {
        if driver <= self.ends[0] || driver >= self.ends[1] { None } else { (self.exact)(driver) }
    }
}

/// Number of kinds of linkages in the family.
pub const BRANCHING_KINDS: u64 = 6;

/// Random linkage of a seed; consecutive seeds alternate between the kinds.
pub fn branching(seed: u64) -> Branching {
    let mut rng = StdRng::seed_from_u64(seed);
    match seed % BRANCHING_KINDS {
        0 => four_bar_linkage(&mut rng, CouplerKind::Link),
        1 => four_bar_linkage(&mut rng, CouplerKind::Rod),
        2 => two_four_bars(&mut rng),
        3 => spatial_four_bar(&mut rng),
        4 => platform(&mut rng),
        _ => four_bar_linkage(&mut rng, CouplerKind::LinkOnThigh),
    }
}

/// Four-bar whose crank makes a full turn, with a smallest transmission angle of 2.9°: ground 1000.3, crank 300,
/// coupler 1000, rocker 300.6 mm, drawn at the crank angle 1 rad.
pub fn nearly_parallel_four_bar(crossing: Crossing) -> Branching {
    let bar = FourBar { ground: 1.0003, crank: 0.3, coupler: 1.0, rocker: 0.3006 };
    four_bar_on_branch(
        bar,
        crossing,
        1.0,
        CouplerKind::Link,
        format!("nearly parallel four-bar {crossing:?}"),
    )
}

/// Random four-bar, in most cases nearly a parallelogram, and its relative deviation from the parallelogram.
fn random_lengths(rng: &mut StdRng) -> (FourBar, f64) {
    let size = rng.random_range(0.2..2.0);
    let mut bar = FourBar::parallelogram(size, size * rng.random_range(0.2..0.8));
    if rng.random_range(0..8) == 0 {
        bar.coupler *= rng.random_range(0.6..1.4);
        bar.rocker *= rng.random_range(0.6..1.4);
        return (bar, 1.0);
    }
    let mismatch = 10f64.powf(rng.random_range(-6.0..-1.0));
    let mut off = || 1.0 + mismatch * rng.random_range(-1.0..1.0);
    let [g, b, c] = [off(), off(), off()];
    (bar.ground, bar.coupler, bar.rocker) = (bar.ground * g, bar.coupler * b, bar.rocker * c);
    (bar, mismatch)
}

/// Limits of the crank angle around `theta` within which a four-bar can be assembled.
fn crank_limits(bar: &FourBar, theta: f64) -> [f64; 2] {
    let cosine = |d: f64| (bar.ground.powi(2) + bar.crank.powi(2) - d * d) / (2.0 * bar.ground * bar.crank);
    let angles = [bar.coupler + bar.rocker, (bar.coupler - bar.rocker).abs()]
        .into_iter()
        .map(cosine)
        .filter(|c| c.abs() <= 1.0)
        .map(f64::acos);
    let all =
        angles.flat_map(|a| (-4..=4).flat_map(move |k| [TAU * f64::from(k) + a, TAU * f64::from(k) - a]));
    all.fold([f64::NEG_INFINITY, f64::INFINITY], |[low, high], end| {
        if end < theta { [low.max(end), high] } else { [low, high.min(end)] }
    })
}

/// Random four-bar that is assembled away from singular poses: lengths, deviation from the parallelogram, assembly and
/// crank angle.
fn random_four_bar(rng: &mut StdRng) -> (FourBar, f64, Crossing, f64) {
    loop {
        let (bar, mismatch) = random_lengths(rng);
        let theta = rng.random_range(0.6..2.4);
        let crossing = if rng.random_range(0..2) == 0 { Crossing::Left } else { Crossing::Right };
        if bar.poses(theta, crossing).is_some_and(|[_, c, r]| (r.angle - c.angle).sin().abs() > 0.1) {
            return (bar, mismatch, crossing, theta);
        }
    }
}

const BODIES: [PlanarBody; 3] = super::FOUR_BAR_BODIES;

/// Rotation about z. Linkages are drawn at their start, far from singular poses, with all joints at 0.
fn rotation_about_z(angle: f64) -> Transform<f64> {
    frame([0.0, 0.0, angle], [0.0; 3])
}

/// Part between crank and rocker, and parent link of their pivots.
#[derive(Clone, Copy, Debug, PartialEq)]
enum CouplerKind {
    /// Coupler link; pivots on the ground.
    Link,
    /// Rod as a distance closure; pivots on the ground.
    Rod,
    /// Coupler link; both pivots on a thigh whose hip mimics the crank with the ratio 0.5: robot leg with a knee driven
    /// from the hip.
    LinkOnThigh,
}

/// Random four-bar.
fn four_bar_linkage(rng: &mut StdRng, coupler_kind: CouplerKind) -> Branching {
    let (bar, mismatch, crossing, theta) = random_four_bar(rng);
    let label =
        format!("four-bar, {coupler_kind:?}, mismatch {mismatch:.1e}, {bar:?} {crossing:?} from {theta}");
    four_bar_on_branch(bar, crossing, theta, coupler_kind, label)
}

/// Four-bar on the branch of one assembly, drawn at the crank angle `theta`.
fn four_bar_on_branch(
    bar: FourBar,
    crossing: Crossing,
    theta: f64,
    coupler_kind: CouplerKind,
    label: String,
) -> Branching {
    let [phi, psi] = bar.poses(theta, crossing).map_or([0.0; 2], |[_, phi, psi]| [phi.angle, psi.angle]);
    let range = [-5.0, 5.0];
    let (mut links, mut joints) = (vec![ground(), link("crank", &BODIES[0])], Vec::new());
    let pivot = |x: f64| {
        if coupler_kind == CouplerKind::LinkOnThigh {
            Transform::from_translation(Vector3::new(x, 0.0, 0.0))
        } else {
            on_ground(x, 0.0)
        }
    };
    let carrier = if coupler_kind == CouplerKind::LinkOnThigh { "thigh" } else { "ground" };
    if coupler_kind == CouplerKind::LinkOnThigh {
        links.push(link("thigh", &BODIES[2]));
        let mut hip = joint("hip", Continuous, "ground", "thigh").origin(on_ground(0.0, 0.0)).axis(Z);
        hip.mimic =
            Some(MimicDescription { joint: "crank_hinge".into(), multiplier: HIP_RATIO, offset: 0.0 });
        joints.push(hip);
    }
    let crank =
        joint("crank_hinge", Continuous, carrier, "crank").origin(pivot(0.0) * rotation_about_z(theta));
    joints.push(crank.axis(Z));
    let closure = if coupler_kind == CouplerKind::Rod {
        ClosureDescription::new("coupler", ClosureKind::Distance, "crank", "rocker")
            .at([bar.crank, 0.0, 0.0], [bar.rocker, 0.0, 0.0])
            .distance(bar.coupler)
    } else {
        links.push(link("coupler", &BODIES[1]));
        let pin =
            Transform::from_translation(Vector3::new(bar.crank, 0.0, 0.0)) * rotation_about_z(phi - theta);
        joints.push(joint("crank_pin", Continuous, "crank", "coupler").origin(pin).axis(Z));
        rocker_pin(("coupler", [bar.coupler, 0.0]), ("rocker", [bar.rocker, 0.0]))
    };
    links.push(link("rocker", &BODIES[2]));
    let rocker = joint("rocker_hinge", Continuous, carrier, "rocker")
        .origin(pivot(bar.ground) * rotation_about_z(psi));
    joints.push(rocker.axis(Z));
    let mechanism = build_with_loops("four_bar", links, joints, vec![closure], Vec::new());
    let linkage = Linkage::new(mechanism, "four_bar", [("crank_hinge", range)], [("crank_hinge", 0.0)]);
    let exact: PositionsOfDriver = Box::new(move |turn| {
        let [_, _, rocker] = bar.poses(theta + turn, crossing)?;
        let mut positions = vec![("rocker_hinge", vec![rocker.angle - psi])];
        if coupler_kind == CouplerKind::LinkOnThigh {
            positions.push(("hip", vec![HIP_RATIO * turn]));
        }
        Some(positions)
    });
    Branching { label, linkage, ends: crank_limits(&bar, theta).map(|end| end - theta), exact }
}

/// Closure of the coupler at the rocker.
fn rocker_pin(before: (&str, [f64; 2]), after: (&str, [f64; 2])) -> ClosureDescription {
    super::planar::pin("rocker_pin", before, after)
}

/// Two random four-bars with rods; the rocker of the first is the crank of the second.
fn two_four_bars(rng: &mut StdRng) -> Branching {
    let (first, mismatch, crossing, theta) = random_four_bar(rng);
    let psi = move |theta: f64| first.poses(theta, crossing).map(|[_, _, rocker]| rocker.angle);
    let (second, second_mismatch, other, turn) = loop {
        let (second, second_mismatch, other, angle) = random_four_bar(rng);
        if let Some(psi) = psi(theta) {
            break (second, second_mismatch, other, angle - psi);
        }
    };
    let links = ["crank", "rocker", "output"];
    let links = links.iter().zip(&BODIES).map(|(name, body)| link(name, body));
    let links = std::iter::once(ground()).chain(links).collect();
    let pivots = [0.0, first.ground, first.ground + second.ground];
    let joints = [("crank_hinge", "crank"), ("rocker_hinge", "rocker"), ("output_hinge", "output")];
    let drawn = psi(theta).and_then(|psi| Some([theta, psi, second.poses(psi + turn, other)?[2].angle]));
    let drawn = drawn.unwrap_or_default();
    let joints = joints.into_iter().zip(pivots).zip(drawn);
    let joints = joints.map(|(((name, child), x), angle)| {
        joint(name, Continuous, "ground", child).origin(on_ground(x, 0.0) * rotation_about_z(angle)).axis(Z)
    });
    let arm = second.crank * Vector2::new(turn.cos(), turn.sin());
    let rod = |name: &str, before: (&str, [f64; 3]), after: (&str, [f64; 3]), length: f64| {
        ClosureDescription::new(name, ClosureKind::Distance, before.0, after.0)
            .at(before.1, after.1)
            .distance(length)
    };
    let closures = vec![
        rod(
            "first_rod",
            ("crank", [first.crank, 0.0, 0.0]),
            ("rocker", [first.rocker, 0.0, 0.0]),
            first.coupler,
        ),
        rod(
            "second_rod",
            ("rocker", [arm.x, arm.y, 0.0]),
            ("output", [second.rocker, 0.0, 0.0]),
            second.coupler,
        ),
    ];
    let mechanism = build_with_loops("two_four_bars", links, joints.collect(), closures, Vec::new());
    let positions = move |theta: f64| {
        let psi = psi(theta)?;
        let [_, _, output] = second.poses(psi + turn, other)?;
        Some([psi, output.angle])
    };
    let range = [theta - 4.0, theta + 4.0];
    let own = crank_limits(&first, theta);
    let ends = find_ends(theta, range, own, &|theta| positions(theta).is_some()).map(|end| end - theta);
    let (crank, range) = ([("crank_hinge", 0.0)], range.map(|end| end - theta));
    let linkage = Linkage::new(mechanism, "two_four_bars", [("crank_hinge", range)], crank);
    let exact: PositionsOfDriver = Box::new(move |crank| {
        let [psi, output] = positions(theta + crank)?;
        Some(vec![("rocker_hinge", vec![psi - drawn[1]]), ("output_hinge", vec![output - drawn[2]])])
    });
    let label = format!("six-bar with rods, mismatches {mismatch:.1e} {second_mismatch:.1e}, from {theta}");
    Branching { label, linkage, ends, exact }
}

/// Ends of the interval around `start` in which a condition is true, found by sampling and bisection within `range`;
/// `known` ends limit the interval too.
fn find_ends(start: f64, range: [f64; 2], known: [f64; 2], condition: &dyn Fn(f64) -> bool) -> [f64; 2] {
    let end = |to: f64, known: f64| {
        let mut last = start;
        for k in 1..=SCAN_STEPS {
            let next = start + (to - start) * f64::from(k) / f64::from(SCAN_STEPS);
            if (next - known) * (to - start) >= 0.0 {
                return known;
            }
            if !condition(next) {
                let (mut inside, mut outside) = (last, next);
                for _ in 0..60 {
                    let middle = 0.5 * (inside + outside);
                    if condition(middle) { inside = middle } else { outside = middle }
                }
                return inside;
            }
            last = next;
        }
        known
    };
    [end(range[0] - 0.1, known[0]), end(range[1] + 0.1, known[1])]
}

/// Random crank and rocker about skew axes, connected by a rod: p cos ψ + q sin ψ = r.
fn spatial_four_bar(rng: &mut StdRng) -> Branching {
    let mut number = |low: f64, high: f64| rng.random_range(low..high);
    loop {
        let [a, c] = [number(0.2, 0.5), number(0.4, 0.9)];
        let base = frame(
            [number(-1.0, 1.0), number(-1.0, 1.0), 0.0],
            [number(0.6, 1.2), number(-0.3, 0.3), number(-0.3, 0.3)],
        );
        let [theta, psi] = [number(0.3, 2.8), number(-3.0, 3.0)];
        let crank = move |theta: f64| Vector3::new(a * theta.cos(), a * theta.sin(), 0.0);
        let rocker = move |psi: f64| base.point(&Vector3::new(c * psi.cos(), c * psi.sin(), 0.0));
        let length = (crank(theta) - rocker(psi)).norm();
        // |A − B|² = |A'|² + c² − 2c (A'x cos ψ + A'y sin ψ), A' in the base frame of the rocker.
        let terms = move |theta: f64| {
            let own = base.inverse_point(&crank(theta));
            let r = (own.norm_squared() + c * c - length * length) / (2.0 * c);
            (own.x.hypot(own.y), own.y.atan2(own.x), r)
        };
        let (h, middle, r) = terms(theta);
        let side = (psi - middle).sin().signum();
        if (r / h).abs() > 0.95 {
            continue;
        }
        let rocker_angle = move |theta: f64| {
            let (h, middle, r) = terms(theta);
            let cosine = r / h;
            (cosine.abs() < 1.0).then(|| middle + side * cosine.acos())
        };
        let range = [theta - 5.0, theta + 5.0];
        let free = [f64::NEG_INFINITY, f64::INFINITY];
        let ends = find_ends(theta, range, free, &|theta| rocker_angle(theta).is_some());
        let links = vec![
            ground(),
            lump("crank", 1.2, [0.1, 0.0, 0.02], 0.3),
            lump("rocker", 2.0, [0.2, 0.1, 0.0], 0.4),
        ];
        let joints = vec![
            joint("crank_hinge", Continuous, "ground", "crank").axis(Z),
            joint("rocker_hinge", Continuous, "ground", "rocker").origin(base).axis(Z),
        ];
        let rod = ClosureDescription::new("rod", ClosureKind::Distance, "crank", "rocker")
            .at([a, 0.0, 0.0], [c, 0.0, 0.0])
            .distance(length);
        let mechanism = build_with_loops("spatial_four_bar", links, joints, vec![rod], Vec::new());
        let start = [("crank_hinge", theta), ("rocker_hinge", psi)];
        let linkage = Linkage::new(mechanism, "spatial_four_bar", [("crank_hinge", range)], start);
        let exact: PositionsOfDriver =
            Box::new(move |theta| Some(vec![("rocker_hinge", vec![rocker_angle(theta)?])]));
        let label = format!("spatial four-bar, crank {a}, rocker {c}, rod {length}, from {theta}");
        return Branching { label, linkage, ends, exact };
    }
}

/// Body on a ball joint at the end of an arm, connected to the ground by three rods.
#[derive(Clone, Copy)]
struct Platform {
    arm: f64,
    /// Ends of the rods on the body; `feet` are their ends on the ground.
    points: [Vector3<f64>; 3],
    feet: [Vector3<f64>; 3],
    rods: [f64; 3],
}

/// Angle of the arm, and orientation of the body in the arm.
type PlatformPose = (f64, UnitQuaternion<f64>);

impl Platform {
    /// Position of the end of rod `k` on the body, in the ground.
    fn rod_end(&self, (theta, turn): &PlatformPose, k: usize) -> Vector3<f64> {
        let arm = Rotation3::from_axis_angle(&Vector3::z_axis(), *theta);
        arm * (Vector3::new(self.arm, 0.0, 0.0) + turn * self.points[k])
    }

    /// Residuals of the rod lengths, and their derivatives with respect to the arm angle and a rotation of the body in
    /// its own axes.
    fn residuals_and_jacobian(&self, pose: &PlatformPose) -> (Vector3<f64>, SMatrix<f64, 3, 4>) {
        let arm = Rotation3::from_axis_angle(&Vector3::z_axis(), pose.0);
        let (mut residuals, mut rows) = (Vector3::zeros(), SMatrix::<f64, 3, 4>::zeros());
        for k in 0..3 {
            let rod_end = self.rod_end(pose, k);
            let rod_vector = rod_end - self.feet[k];
            let along = rod_vector / rod_vector.norm();
            residuals[k] = rod_vector.norm() - self.rods[k];
            rows[(k, 0)] = along.dot(&Vector3::z().cross(&rod_end));
            let spin = self.points[k].cross(&(pose.1.inverse() * (arm.inverse() * along)));
            (0..3).for_each(|c| rows[(k, 1 + c)] = spin[c]);
        }
        (residuals, rows)
    }

    /// Tangent of the solution curve by cofactors: its direction along a branch is continuous, without sign changes.
    fn tangent(rows: &SMatrix<f64, 3, 4>) -> SVector<f64, 4> {
        SVector::from_fn(|skipped, _| {
            let minor = Matrix3::from_fn(|r, c| rows[(r, if c < skipped { c } else { c + 1 })]);
            if skipped % 2 == 0 { minor.determinant() } else { -minor.determinant() }
        })
    }

    /// Pose after a step of the arm angle and a rotation of the body.
    fn advance(pose: &PlatformPose, by: &SVector<f64, 4>) -> PlatformPose {
        let spin = UnitQuaternion::from_scaled_axis(Vector3::new(by[1], by[2], by[3]));
        (pose.0 + by[0], pose.1 * spin)
    }

    /// Closes the rods at a constant arm angle by Newton's method.
    fn close_at_arm_angle(&self, mut pose: PlatformPose) -> Option<PlatformPose> {
        for _ in 0..30 {
            let (residuals, rows) = self.residuals_and_jacobian(&pose);
            if residuals.amax() < 1e-15 {
                return Some(pose);
            }
            let step = rows.fixed_view::<3, 3>(0, 1).clone_owned().lu().solve(&-residuals)?;
            if step.amax() < 1e-14 {
                return Some(pose);
            }
            pose = Self::advance(&pose, &SVector::from([0.0, step.x, step.y, step.z]));
        }
        None
    }

    /// Follows the branch until the arm reverses or its travel exceeds `max_travel`. Returns the poses and the arm angle at
    /// the reversal, infinite without one.
    fn follow_branch(&self, start: PlatformPose, sign: f64, max_travel: f64) -> (Vec<PlatformPose>, f64) {
        let mut poses = vec![start];
        let mut pose = start;
        let mut direction = None;
        loop {
            let (_, rows) = self.residuals_and_jacobian(&pose);
            let own = Self::tangent(&rows);
            let regularity = own.norm() / rows.norm().powi(3);
            let direction = *direction.get_or_insert(if own[0] * sign > 0.0 { 1.0 } else { -1.0 });
            let tangent = own * direction / own.norm();
            if tangent[0] * sign <= 0.0 {
                return (poses, pose.0);
            }
            let step = (0.3 * regularity).clamp(1e-5, 4e-3);
            let mut next = Self::advance(&pose, &(tangent * step));
            for _ in 0..6 {
                let (residuals, rows) = self.residuals_and_jacobian(&next);
                let Some(inverse) = (rows * rows.transpose()).try_inverse() else { break };
                next = Self::advance(&next, &-(rows.transpose() * (inverse * residuals)));
            }
            if (next.0 - pose.0) * sign <= 0.0 {
                return (poses, pose.0);
            }
            pose = next;
            poses.push(pose);
            if (pose.0 - start.0).abs() > max_travel {
                return (poses, sign * f64::INFINITY);
            }
            if poses.len() > 60_000 {
                return (poses, pose.0);
            }
        }
    }
}

/// Random platform.
fn platform(rng: &mut StdRng) -> Branching {
    loop {
        let mut vector = |size: f64| Vector3::from_fn(|_, _| rng.random_range(-size..size));
        let mut own = Platform {
            arm: 0.0,
            points: [vector(0.4), vector(0.4), vector(0.4)],
            feet: [vector(1.0), vector(1.0), vector(1.0)],
            rods: [0.0; 3],
        };
        let turn = UnitQuaternion::from_scaled_axis(vector(1.0));
        let theta = rng.random_range(-1.0..1.0);
        own.arm = rng.random_range(0.3..0.8);
        for k in 0..3 {
            own.rods[k] = (own.rod_end(&(theta, turn), k) - own.feet[k]).norm();
        }
        let (_, rows) = own.residuals_and_jacobian(&(theta, turn));
        let tangent = Platform::tangent(&rows);
        let least = own.points.iter().map(Vector3::norm).chain(own.rods).fold(f64::INFINITY, f64::min);
        if least < 0.15
            || (tangent[0] / tangent.norm()).abs() < 0.1
            || tangent.norm() < 0.02 * rows.norm().powi(3)
        {
            continue;
        }
        let max_travel = 2.0;
        let (before, low) = own.follow_branch((theta, turn), -1.0, max_travel);
        let (after, high) = own.follow_branch((theta, turn), 1.0, max_travel);
        let poses: Vec<PlatformPose> = before.into_iter().rev().chain(after.into_iter().skip(1)).collect();
        let links =
            vec![ground(), lump("arm", 1.5, [0.2, 0.0, 0.0], 0.4), lump("body", 3.0, [0.02, 0.05, 0.0], 0.4)];
        let joints = vec![
            joint("arm_hinge", Continuous, "ground", "arm").axis(Z),
            joint("ball", Spherical, "arm", "body")
                .origin(Transform::from_translation(Vector3::new(own.arm, 0.0, 0.0))),
        ];
        let rods = (0..3).map(|k| {
            ClosureDescription::new(format!("rod_{k}"), ClosureKind::Distance, "body", "ground")
                .at(own.points[k].into(), own.feet[k].into())
                .distance(own.rods[k])
        });
        let mechanism = build_with_loops("platform", links, joints, rods.collect(), Vec::new());
        let range = [theta - max_travel, theta + max_travel];
        let mut linkage = Linkage::new(mechanism, "platform", [("arm_hinge", range)], [("arm_hinge", theta)]);
        let numbers = |turn: &UnitQuaternion<f64>| vec![turn.w, turn.i, turn.j, turn.k];
        linkage.start.push(("ball".into(), numbers(&turn)));
        let exact: PositionsOfDriver = Box::new(move |theta| {
            let next = poses.partition_point(|pose| pose.0 < theta);
            let (before, after) = (poses.get(next.checked_sub(1)?)?, poses.get(next)?);
            let part = (theta - before.0) / (after.0 - before.0);
            let turn = before.1.slerp(&after.1, part);
            let closed = own.close_at_arm_angle((theta, turn))?;
            // Refuses a solution of Newton's method on another branch.
            (closed.1.angle_to(&turn) < 1e-3).then(|| vec![("ball", numbers(&closed.1))])
        });
        let label = format!("platform from {theta}, ends {low:.6} {high:.6}");
        return Branching { label, linkage, ends: [low, high], exact };
    }
}

/// Distance between two positions of a joint, rad: of angles modulo full turns, or the angle between two orientations.
pub fn position_distance(one: &[f64], other: &[f64]) -> f64 {
    if let ([a], [b]) = (one, other) {
        return ((a - b + PI).rem_euclid(TAU) - PI).abs();
    }
    let unit = |q: &[f64]| UnitQuaternion::from_quaternion(Quaternion::new(q[0], q[1], q[2], q[3]));
    unit(one).angle_to(&unit(other))
}

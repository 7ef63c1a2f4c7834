//! Extremes over the self-motion with kept points, and along paths: chains of point masses with closed forms.

use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use percuss_dynamics::{Conditions, Configuration, Contact, Direction, EffectiveMass, Frame, System};
use percuss_impact::{
    DriverPath, ExtremeKind, ExtremesError, JointRange, KeptPoint, SearchedPoses, SearchedQuantity,
    extreme_along_path, extreme_effective_mass, extreme_quantity,
};
use percuss_mechanism::{
    Inertial, JointDescription, JointId, JointKind, LinkDescription, Mechanism, MechanismBuilder,
};
use percuss_spatial::Transform;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::sync::Arc;

/// Planar chain of massless rods with point masses at their ends.
struct Chain {
    lengths: Vec<f64>,
    masses: Vec<f64>,
}

impl Chain {
    fn random(random: &mut StdRng, count: usize) -> Self {
        let lengths = (0..count).map(|_| random.random_range(0.4..1.2)).collect();
        Self { lengths, masses: (0..count).map(|_| random.random_range(0.3..4.0)).collect() }
    }

    fn mechanism(&self) -> Arc<Mechanism> {
        let inertial =
            |mass, length| Inertial { mass, com: Vector3::x() * length, about_com: Matrix3::zeros() };
        let mut builder =
            MechanismBuilder::new("chain").link(LinkDescription::new("link0", inertial(0.0, 0.0)));
        for (k, (&length, &mass)) in self.lengths.iter().zip(&self.masses).enumerate() {
            let (parent, child) = (format!("link{k}"), format!("link{}", k + 1));
            builder = builder.link(LinkDescription::new(&child, inertial(mass, length)));
            let mut hinge = JointDescription::new(format!("hinge{k}"), JointKind::Continuous, parent, child);
            hinge.axis = Vector3::z();
            let at = if k == 0 { 0.0 } else { self.lengths[k - 1] };
            hinge.origin = Transform::from_translation(Vector3::new(at, 0.0, 0.0));
            builder = builder.joint(hinge);
        }
        Arc::new(builder.build().expect("a mechanism").mechanism)
    }

    /// Place of the tip.
    fn tip(&self, q: &[f64]) -> Vector2<f64> {
        let (mut angle, mut tip) = (0.0_f64, Vector2::zeros());
        for (length, turn) in self.lengths.iter().zip(q) {
            angle += turn;
            tip += Vector2::new(angle.cos(), angle.sin()) * *length;
        }
        tip
    }

    /// 1/m̄ of the tip along `normal`. The mobility of point k on a rod along u is A = 1/m − u uᵀ/m² / (1/m + uᵀ A' u), with the mobility
    /// A' of the previous point: the tension of the rod keeps the speeds of its ends along u equal.
    fn inverse_mass(&self, q: &[f64], normal: &Vector2<f64>) -> f64 {
        let (mut angle, mut mobility) = (0.0_f64, Matrix2::zeros());
        for (k, turn) in q.iter().enumerate() {
            angle += turn;
            let (u, m) = (Vector2::new(angle.cos(), angle.sin()), self.masses[k]);
            mobility = Matrix2::identity() / m
                - u * u.transpose() / (m * m) / (1.0 / m + (u.transpose() * mobility * u)[0]);
        }
        (normal.transpose() * mobility * normal)[0]
    }

    fn contact(&self, mechanism: &Mechanism, normal: &Vector2<f64>) -> Contact {
        let count = self.lengths.len();
        Contact {
            link: mechanism.find_link(&format!("link{count}")).expect("the last link"),
            against: None,
            point: Vector3::x() * self.lengths[count - 1],
            normal: Direction::Along(Vector3::new(normal.x, normal.y, 0.0), Frame::World),
        }
    }
}

fn joints(mechanism: &Mechanism) -> Vec<JointId> {
    mechanism.joint_ids().collect()
}

fn configuration(mechanism: &Arc<Mechanism>, q: &[f64]) -> Configuration {
    Configuration::from_positions(mechanism, q).expect("positions")
}

/// Angle in (−π, π].
fn wrapped(angle: f64) -> f64 {
    angle.sin().atan2(angle.cos())
}

/// Angles of two rods from `from` to `to`, for both signs of the second hinge; absolute angle of the first, relative angle of the second.
fn two_rods(from: Vector2<f64>, to: Vector2<f64>, a: f64, b: f64) -> Vec<(f64, f64)> {
    let d = to - from;
    let cosine = (d.norm_squared() - a * a - b * b) / (2.0 * a * b);
    if cosine.abs() > 1.0 {
        return Vec::new();
    }
    [cosine.acos(), -cosine.acos()]
        .map(|q| (d.y.atan2(d.x) - (b * q.sin()).atan2(a + b * q.cos()), q))
        .to_vec()
}

/// Positions of a chain of three rods with the tip at `tip`: dense samples of the whole self-motion, over the angle of the last rod and
/// over the first hinge, since one angle alone has turning points.
fn self_motion(chain: &Chain, tip: Vector2<f64>, samples: usize) -> Vec<Vec<f64>> {
    let [a, b, c] = chain.lengths[..] else { panic!("three rods") };
    let mut found = Vec::new();
    for k in 0..samples {
        let angle = std::f64::consts::TAU * k as f64 / samples as f64 - std::f64::consts::PI;
        let u = Vector2::new(angle.cos(), angle.sin());
        for (first, second) in two_rods(Vector2::zeros(), tip - u * c, a, b) {
            found.push(vec![wrapped(first), second, wrapped(angle - first - second)]);
        }
        for (first, second) in two_rods(u * a, tip, b, c) {
            found.push(vec![angle, wrapped(first - angle), second]);
        }
    }
    found
}

/// Extremes over the self-motion of 40 random planar arms with three limited hinges, against a scan of their closed-form inverse
/// kinematics. At least 95 % of the 80 searches reach the best value of the scan. At every result the tip is in place and the mass equals
/// the closed form.
#[test]
fn extremes_over_a_self_motion_are_those_of_the_inverse_kinematics() {
    let (mut searches, mut found_all, mut agreeing, mut starts) = (0, 0, 0, 0);
    for seed in 0..40 {
        let mut random = StdRng::seed_from_u64(seed);
        let chain = Chain::random(&mut random, 3);
        let mechanism = chain.mechanism();
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let limits: Vec<(f64, f64)> =
            (0..3).map(|_| (random.random_range(-3.1..-1.0), random.random_range(1.0..3.1))).collect();
        let own: Vec<f64> = limits.iter().map(|(a, b)| random.random_range(*a..*b)).collect();
        let angle: f64 = random.random_range(0.0..3.0);
        let normal = Vector2::new(angle.cos(), angle.sin());
        let contact = chain.contact(&mechanism, &normal);
        let ranges: Vec<JointRange> = joints(&mechanism)
            .into_iter()
            .zip(&limits)
            .map(|(joint, &(lower, upper))| JointRange { joint, lower, upper })
            .collect();
        let kept = [KeptPoint { link: contact.link, point: contact.point, normal: None }];
        let tip = chain.tip(&own);
        // Positions at a limit have its rounding.
        let inside = |q: &[f64]| q.iter().zip(&limits).all(|(q, (a, b))| (a - 1e-12..=b + 1e-12).contains(q));
        let scan: Vec<f64> = self_motion(&chain, tip, 20_000)
            .into_iter()
            .filter(|q| inside(q))
            .map(|q| chain.inverse_mass(&q, &normal))
            .collect();
        assert!(!scan.is_empty(), "{seed}");
        for extreme in [ExtremeKind::Least, ExtremeKind::Most] {
            let poses = SearchedPoses { ranges: &ranges, kept: &kept };
            let start = configuration(&mechanism, &own);
            let found = extreme_effective_mass(&system, &start, (&contact).into(), poses, extreme, 8)
                .expect("an extreme");
            let at = &found.positions;
            assert!(found.kept_error < 1e-9 && (chain.tip(at) - tip).norm() < 1e-9, "{seed} {found:?}");
            assert!(inside(at), "{seed} {found:?}");
            let inverse = match found.effective_mass {
                EffectiveMass::Finite(mass) => 1.0 / mass,
                EffectiveMass::Immovable => 0.0,
                EffectiveMass::Massless => panic!("{found:?}"),
            };
            let largest = scan.iter().copied().fold(0.0, f64::max);
            let exact = chain.inverse_mass(at, &normal);
            assert!((inverse - exact).abs() < 1e-9 * largest, "{seed}: {inverse} {exact}");
            let best = scan.iter().copied().fold(f64::NAN, |best, value| {
                if best.is_nan() || (extreme == ExtremeKind::Least) == (value > best) { value } else { best }
            });
            // The scan has steps of 3e-4 rad and can miss the exact extreme, so the check is one-sided: how far is the scan better?
            let beyond = if extreme == ExtremeKind::Least { best - inverse } else { inverse - best };
            searches += 1;
            found_all += usize::from(beyond <= 1e-7 * largest);
            agreeing += found.agreeing;
            starts += found.starts;
        }
    }
    println!("{found_all} of {searches} searches; {agreeing} of {starts} starts agree");
    assert!(found_all * 100 >= searches * 95, "{found_all} of {searches}");
}

/// The smallest mass over the self-motion is the point mass of the tip, m₃. It occurs where the last rod is perpendicular to the normal, so
/// that its tension has no effect; these positions are isolated points of the self-motion.
#[test]
fn the_smallest_mass_of_a_self_motion_is_that_of_the_tip() {
    let (mut found_all, mut searches) = (0, 0);
    for seed in 100..300 {
        let mut random = StdRng::seed_from_u64(seed);
        let chain = Chain { lengths: vec![1.0, 0.9, 0.4], ..Chain::random(&mut random, 3) };
        let mechanism = chain.mechanism();
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let (bend, angle) = (random.random_range(0.6..2.0), random.random_range(0.0..3.0_f64));
        let own = [random.random_range(-1.0..1.0), bend, random.random_range(-1.0..1.0)];
        // With the last rod in any direction the other two reach its foot.
        let distance = chain.tip(&own).norm();
        if !(0.55..1.45).contains(&distance) {
            continue;
        }
        let normal = Vector2::new(angle.cos(), angle.sin());
        let contact = chain.contact(&mechanism, &normal);
        let range = |joint| JointRange { joint, lower: -7.0, upper: 7.0 };
        let ranges: Vec<JointRange> = joints(&mechanism).into_iter().map(range).collect();
        let kept = [KeptPoint { link: contact.link, point: contact.point, normal: None }];
        let poses = SearchedPoses { ranges: &ranges, kept: &kept };
        let start = configuration(&mechanism, &own);
        let found = extreme_effective_mass(&system, &start, (&contact).into(), poses, ExtremeKind::Least, 8)
            .expect("an extreme");
        let mass = found.effective_mass.kilograms().expect("a finite mass");
        let last: f64 = found.positions.iter().sum();
        searches += 1;
        // The mass locates the position to the square root of its rounding.
        let is_across = (Vector2::new(last.cos(), last.sin()).dot(&normal)).abs() < 1e-5;
        found_all += usize::from((mass / chain.masses[2] - 1.0).abs() < 1e-9 && is_across);
        assert!(found.residual < 1e-6, "{found:?}");
    }
    println!("{found_all} of {searches}");
    assert!(searches > 15 && found_all * 100 >= searches * 95, "{found_all} of {searches}");
}

/// Extremes of a spatial arm with seven hinges whose last link keeps its position and orientation. Small steps along the self-motion from
/// the found pose reach no better value. The nine conditions (three points of one link) are redundant.
#[test]
fn extremes_with_a_kept_link_of_a_spatial_arm() {
    for seed in 0..6 {
        let mut random = StdRng::seed_from_u64(200 + seed);
        let mut builder = MechanismBuilder::new("arm");
        let inertial = |random: &mut StdRng| Inertial {
            mass: random.random_range(0.5..3.0),
            com: Vector3::from_fn(|_, _| random.random_range(-0.1..0.1)),
            about_com: Matrix3::from_diagonal(&Vector3::new(0.02, 0.03, 0.025)),
        };
        builder = builder.link(LinkDescription::new("link0", inertial(&mut random)));
        for k in 0..7 {
            let child = format!("link{}", k + 1);
            builder = builder.link(LinkDescription::new(&child, inertial(&mut random)));
            let mut hinge =
                JointDescription::new(format!("hinge{k}"), JointKind::Continuous, format!("link{k}"), child);
            hinge.axis = Vector3::from_fn(|_, _| random.random_range(-1.0..1.0));
            let offset = Vector3::from_fn(|_, _| random.random_range(0.05..0.3));
            hinge.origin = Transform::from_translation(offset);
            builder = builder.joint(hinge);
        }
        let mechanism = Arc::new(builder.build().expect("a mechanism").mechanism);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let link = mechanism.find_link("link7").expect("the tool");
        let contact = Contact {
            link,
            against: None,
            point: Vector3::new(0.1, 0.0, 0.05),
            normal: Direction::Along(Vector3::new(0.3, -0.5, 0.8), Frame::World),
        };
        let own: Vec<f64> = (0..7).map(|_| random.random_range(-1.0..1.0)).collect();
        let start = configuration(&mechanism, &own);
        let range = |joint: JointId| {
            let q = own[joint.index()];
            JointRange { joint, lower: q - 0.8, upper: q + 0.6 }
        };
        let ranges: Vec<JointRange> = joints(&mechanism).into_iter().map(range).collect();
        let kept = KeptPoint::of_link(link, mechanism.characteristic_length());
        let drawn = system.pose(&start).expect("a pose").link(link);
        let inverse = |q: &[f64]| {
            let pose = system.pose(&configuration(&mechanism, q)).expect("a pose");
            1.0 / pose.respond(&contact).expect("a response").effective_mass.kilograms().expect("finite")
        };
        for extreme in [ExtremeKind::Least, ExtremeKind::Most] {
            let poses = SearchedPoses { ranges: &ranges, kept: &kept };
            let found = extreme_effective_mass(&system, &start, (&contact).into(), poses, extreme, 4)
                .expect("an extreme");
            let there = system.pose(&configuration(&mechanism, &found.positions)).expect("a pose").link(link);
            assert!((there.translation - drawn.translation).norm() < 1e-9, "{found:?}");
            assert!((there.rotation - drawn.rotation).norm() < 1e-9, "{found:?}");
            assert!(found.residual < 1e-6, "{seed}: {found:?}");
            let own_value = inverse(&own);
            let value = inverse(&found.positions);
            let is_better = |a: f64, b: f64| if extreme == ExtremeKind::Least { a >= b } else { a <= b };
            assert!(is_better(
                value * (1.0 + 1e-9 * if extreme == ExtremeKind::Least { 1.0 } else { -1.0 }),
                own_value
            ));
            // Small steps along ker J of the tool, in both directions, within the ranges.
            for direction in [1.0, -1.0] {
                let mut q = found.positions.clone();
                let mut last: Option<nalgebra::DVector<f64>> = None;
                for _ in 0..200 {
                    let pose = system.pose(&configuration(&mechanism, &q)).expect("a pose");
                    let rows = [Vector3::zeros(), Vector3::x(), Vector3::y()]
                        .map(|point| pose.point_jacobian(link, &point));
                    let stacked = nalgebra::DMatrix::from_fn(9, 7, |r, c| rows[r / 3][(r % 3, c)]);
                    let eigen = (stacked.transpose() * &stacked).symmetric_eigen();
                    let mut tangent = eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned();
                    match &last {
                        Some(last) if last.dot(&tangent) < 0.0 => tangent = -tangent,
                        None => tangent *= direction,
                        Some(_) => {}
                    }
                    q.iter_mut().zip(tangent.iter()).for_each(|(q, t)| *q += 2e-3 * t);
                    // Back to the place of the tool by Newton's method.
                    for _ in 0..3 {
                        let pose = system.pose(&configuration(&mechanism, &q)).expect("a pose");
                        let rows = [Vector3::zeros(), Vector3::x(), Vector3::y()];
                        let error = nalgebra::DVector::from_fn(9, |r, _| {
                            (pose.link(link).point(&rows[r / 3]) - drawn.point(&rows[r / 3]))[r % 3]
                        });
                        let jacobians = rows.map(|point| pose.point_jacobian(link, &point));
                        let stacked = nalgebra::DMatrix::from_fn(9, 7, |r, c| jacobians[r / 3][(r % 3, c)]);
                        // Least norm: Jᵀ (J Jᵀ)⁺ e, by the eigenvectors of J Jᵀ.
                        let eigen = (&stacked * stacked.transpose()).symmetric_eigen();
                        let weights = (0..9).map(|k| {
                            let (value, vector) = (eigen.eigenvalues[k], eigen.eigenvectors.column(k));
                            let part = if value > 1e-12 { vector.dot(&error) / value } else { 0.0 };
                            vector * part
                        });
                        let step = stacked.transpose() * weights.sum::<nalgebra::DVector<f64>>();
                        q.iter_mut().zip(step.iter()).for_each(|(q, s)| *q -= s);
                    }
                    if !q.iter().zip(&ranges).all(|(q, range)| (range.lower..=range.upper).contains(q)) {
                        break;
                    }
                    let other = inverse(&q);
                    let is_beyond = if extreme == ExtremeKind::Least {
                        other > value * (1.0 + 1e-9)
                    } else {
                        other < value * (1.0 - 1e-9)
                    };
                    assert!(!is_beyond, "{seed} {extreme:?}: {value} {other}");
                    last = Some(tangent);
                }
            }
        }
    }
}

/// Extremes along random paths of arms with two or three hinges. At least 95 % are not beaten by a scan of the closed form along the path.
#[test]
fn extremes_along_a_path_are_those_of_a_scan() {
    let (mut found_all, mut searches) = (0, 0);
    for seed in 300..340 {
        let mut random = StdRng::seed_from_u64(seed);
        let count = random.random_range(2..4);
        let chain = Chain::random(&mut random, count);
        let mechanism = chain.mechanism();
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let angle: f64 = random.random_range(0.0..3.0);
        let normal = Vector2::new(angle.cos(), angle.sin());
        let contact = chain.contact(&mechanism, &normal);
        let rows: Vec<Vec<f64>> = (0..random.random_range(1..9))
            .map(|_| (0..count).map(|_| random.random_range(-2.5..2.5)).collect())
            .collect();
        let joints = joints(&mechanism);
        let path = DriverPath { joints: &joints, rows: &rows };
        let at = |row: f64| -> Vec<f64> {
            let (first, part) = (row.floor() as usize, row.fract());
            let next = (first + 1).min(rows.len() - 1);
            rows[first].iter().zip(&rows[next]).map(|(a, b)| a + part * (b - a)).collect()
        };
        let samples = 20_000 * (rows.len() - 1);
        let scan: Vec<f64> =
            (0..=samples).map(|k| chain.inverse_mass(&at(k as f64 / 20_000.0), &normal)).collect();
        let largest = scan.iter().copied().fold(0.0, f64::max);
        for extreme in [ExtremeKind::Least, ExtremeKind::Most] {
            let start = system.configuration();
            let quantity = SearchedQuantity::EffectiveMass;
            let found = extreme_along_path(&system, &start, (&contact).into(), quantity, &path, extreme)
                .expect("an extreme");
            let inverse = match found.extreme.effective_mass {
                EffectiveMass::Finite(mass) => 1.0 / mass,
                EffectiveMass::Immovable => 0.0,
                EffectiveMass::Massless => panic!("{found:?}"),
            };
            let place = at(found.row);
            assert!(
                place.iter().zip(&found.extreme.positions).all(|(a, b)| (a - b).abs() < 1e-12),
                "{found:?}"
            );
            let exact = chain.inverse_mass(&place, &normal);
            assert!((inverse - exact).abs() < 1e-9 * largest, "{seed} {found:?}");
            let beyond = if extreme == ExtremeKind::Least {
                largest - inverse
            } else {
                inverse - scan.iter().copied().fold(f64::INFINITY, f64::min)
            };
            searches += 1;
            found_all += usize::from(beyond <= 1e-9 * largest);
        }
    }
    println!("{found_all} of {searches}");
    assert!(found_all * 100 >= searches * 95, "{found_all} of {searches}");
}

/// Errors of kept points and paths.
#[test]
fn invalid_kept_points_and_paths_are_refused() {
    let chain = Chain { lengths: vec![1.0, 0.8], masses: vec![2.0, 1.0] };
    let mechanism = chain.mechanism();
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
    let contact = chain.contact(&mechanism, &Vector2::new(0.0, 1.0));
    let joints = joints(&mechanism);
    let start = configuration(&mechanism, &[0.2, 0.7]);
    let range = |joint: &JointId| JointRange { joint: *joint, lower: -3.0, upper: 3.0 };
    let ranges: Vec<JointRange> = joints.iter().map(range).collect();
    let search = |kept: &[KeptPoint]| {
        let poses = SearchedPoses { ranges: &ranges, kept };
        extreme_effective_mass(&system, &start, (&contact).into(), poses, ExtremeKind::Least, 2)
    };
    let point = KeptPoint { link: contact.link, point: contact.point, normal: None };
    // Two hinges have no motion with a kept tip; with one kept direction they have one.
    assert!(matches!(search(&[point]), Err(ExtremesError::NoSelfMotion { .. })));
    let along = KeptPoint { normal: Some(Vector3::x() * 2.0), ..point };
    let found = search(&[along]).expect("an extreme");
    assert!(found.kept_error < 1e-9, "{found:?}");
    let zero = KeptPoint { normal: Some(Vector3::zeros()), ..point };
    assert!(matches!(search(&[along, zero]), Err(ExtremesError::NoKeptNormal { number: 2 })));
    let follow = |joints: &[JointId], rows: &[Vec<f64>]| {
        let path = DriverPath { joints, rows };
        let quantity = SearchedQuantity::EffectiveMass;
        extreme_along_path(&system, &start, (&contact).into(), quantity, &path, ExtremeKind::Most)
    };
    assert!(matches!(follow(&joints, &[]), Err(ExtremesError::NoRows)));
    assert!(matches!(follow(&[], &[vec![]]), Err(ExtremesError::NoJoint)));
    let short = [vec![0.1, 0.2], vec![0.3]];
    assert!(matches!(follow(&joints, &short), Err(ExtremesError::PathRow { row: 1, got: 1, expected: 2 })));
    assert!(matches!(follow(&joints, &[vec![0.1, f64::NAN]]), Err(ExtremesError::PathRow { row: 0, .. })));
    // At the stretched arm along the normal the contact is immovable, and the impulse in the bearing is unbounded.
    let half = std::f64::consts::FRAC_PI_2;
    let path = DriverPath { joints: &joints, rows: &[vec![half, -0.5], vec![half, 0.4]] };
    let quantity = SearchedQuantity::BearingImpulse { bearing: joints[0].into() };
    let most = extreme_along_path(&system, &start, (&contact).into(), quantity, &path, ExtremeKind::Most);
    let most = most.expect("an extreme");
    assert_eq!(most.extreme.effective_mass, EffectiveMass::Immovable, "{most:?}");
    assert!((most.row - 0.5 / 0.9).abs() < 1e-3, "{most:?}");
    // Kept points with another quantity: the inertia at the first hinge over the motions that keep the height of the tip.
    let quantity = SearchedQuantity::ReflectedInertia { joint: joints[0], held: true };
    let kept = [KeptPoint { normal: Some(Vector3::y()), ..point }];
    let poses = SearchedPoses { ranges: &ranges, kept: &kept };
    let most = extreme_quantity(&system, &start, (&contact).into(), quantity, poses, ExtremeKind::Most, 8);
    let most = most.expect("an extreme");
    // m₁ a² + m₂ (a² + b² + 2ab cos q₂) is largest for the stretched arm, which reaches the height.
    let expected = 2.0 + 1.8 * 1.8;
    let value = most.effective_mass.kilograms().expect("finite");
    assert!((value / expected - 1.0).abs() < 1e-9, "{most:?}");
}

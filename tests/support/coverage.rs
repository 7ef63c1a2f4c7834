//! Share of the configurations that the compiled kernels answer, without a second computation by the recursion.

use nalgebra::Vector3;
use percuss_dynamics::{
    Base, Batch, Conditions, Configuration, Contact, Direction, EffectiveMass, Frame, Pose, System,
};
use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions, Source, load};
use percuss_mechanism::{JointKind, LinkId, Mechanism};
use percuss_oracle::{linkage, random, zoo};
use percuss_suspension::{ImportOptions, import};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::f64::consts::PI;
use std::ops::AddAssign;
use std::sync::Arc;

/// Number of contacts per mechanism, and of configurations per contact.
const CONTACTS: usize = 6;
const CONFIGURATIONS: usize = 8;
/// Relative error stated by the recursion above which a configuration counts as ill-conditioned.
const ILL_CONDITIONED: f64 = 1e-11;
/// Largest motion of a driver from the pose as drawn, rad or m.
const LARGEST_MOTION: f64 = 0.4;

/// Counts of configurations with a finite effective mass.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coverage {
    /// Mechanisms with such configurations.
    pub mechanisms: usize,
    /// Regular configurations: the rank of the constraints is clear, and the largest possible.
    pub regular: usize,
    /// Regular configurations answered by a kernel.
    pub by_kernel: usize,
    /// Answers of a kernel that differ from that of the pose by more than the stated errors of both.
    pub wrong: usize,
    /// Regular configurations of mechanisms and contacts without a kernel.
    pub unsupported: usize,
    /// Regular configurations without an answer of a kernel, for which the recursion states a relative error above 1e-11.
    pub ill_conditioned: usize,
}

impl Coverage {
    /// Share of the regular configurations, per cent.
    pub fn per_cent(&self) -> f64 {
        100.0 * self.by_kernel as f64 / self.regular.max(1) as f64
    }
}

impl AddAssign for Coverage {
    fn add_assign(&mut self, other: Self) {
        self.mechanisms += other.mechanisms;
        self.regular += other.regular;
        self.by_kernel += other.by_kernel;
        self.wrong += other.wrong;
        self.unsupported += other.unsupported;
        self.ill_conditioned += other.ill_conditioned;
    }
}

/// Random positions of all joints of a tree, within the limits of slides or half a metre.
fn random_positions(rng: &mut StdRng, mechanism: &Mechanism) -> Vec<f64> {
    let mut positions = Vec::new();
    for joint in mechanism.joints() {
        let mut quaternion = || {
            let q = nalgebra::Vector4::from_fn(|_, _| rng.random_range(-1.0..1.0)).normalize();
            [q.x, q.y, q.z, q.w]
        };
        match joint.kind() {
            JointKind::Fixed => {}
            JointKind::Spherical => positions.extend(quaternion()),
            JointKind::Floating => {
                let q = quaternion();
                positions.extend([0; 3].map(|_| rng.random_range(-0.5..0.5)));
                positions.extend(q);
            }
            JointKind::Prismatic => {
                let range = joint.limits().map_or(-0.5..0.5, |limits| limits.lower..limits.upper);
                let finite = range.start.is_finite() && range.end.is_finite() && range.start < range.end;
                positions.push(rng.random_range(if finite { range } else { -0.5..0.5 }));
            }
            JointKind::Planar => {
                positions.extend([0; 2].map(|_| rng.random_range(-0.5..0.5)));
                positions.push(rng.random_range(-PI..PI));
            }
            JointKind::Revolute | JointKind::Continuous => positions.push(rng.random_range(-PI..PI)),
        }
    }
    positions
}

/// Poses at random positions of all joints of a tree, or at random positions of the drivers of a mechanism with loops.
fn poses(rng: &mut StdRng, system: &System, pose: &Pose) -> Vec<Pose> {
    let mechanism = pose.mechanism();
    if pose.loops().is_none() {
        let mut any = || {
            let positions = random_positions(rng, mechanism);
            system.pose(&Configuration::from_positions(mechanism, &positions).ok()?).ok()
        };
        return (0..CONFIGURATIONS).filter_map(|_| any()).collect();
    }
    let mut moved = || {
        let mut configuration = system.configuration();
        for joint in pose.assembly().drivers() {
            if let &[position] = pose.joint(joint) {
                let position = position + LARGEST_MOTION * rng.random_range(-1.0..1.0);
                configuration.set(mechanism.joint(joint).name(), &[position]).ok()?;
            }
        }
        let later = system.pose_from(pose, &configuration).ok()?;
        let regular = later.rank().clear && !later.rank().singular;
        regular.then_some(later)
    };
    (0..CONFIGURATIONS).filter_map(|_| moved()).collect()
}

/// Mechanism of a URDF file or of a suspension sheet.
///
/// # Errors
/// The first line of the message of the reader.
pub fn read(path: &str) -> Result<Arc<Mechanism>, String> {
    let read = Source::read(path, DEFAULT_MAX_SIZE).and_then(|source| match path.ends_with(".urdf") {
        true => load(&source, &LoadOptions::default()).map(|read| read.mechanism),
        false => import(&source, &ImportOptions::default()).map(|read| read.mechanism),
    });
    read.map(Arc::new).map_err(|error| error.to_string().lines().next().unwrap_or_default().to_owned())
}

/// True if the effective mass at the pose is the same within the stated errors of both.
fn agrees(pose: &Pose, contact: &Contact, mass: f64, error: f64) -> bool {
    let Ok(response) = pose.respond(contact) else { return false };
    let EffectiveMass::Finite(expected) = response.effective_mass else { return false };
    response.effective_mass_error().is_some_and(|of_pose| (mass - expected).abs() <= error + of_pose)
}

/// Other side of the random contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OtherSide {
    /// The ground.
    Ground,
    /// Another link; the normal is constant in either link, or in the world.
    Link,
    /// Another link; the normal is the line to a point of this link.
    Line,
    /// The ground or another link; a moment about an axis.
    Moment,
}

/// Mechanism under conditions, with a start pose.
#[derive(Clone, Debug)]
pub struct Subject {
    /// The mechanism.
    pub mechanism: Arc<Mechanism>,
    /// Base, held contacts.
    pub conditions: Conditions,
    /// Positions of all joints; `None` for the pose as drawn.
    pub start: Option<Vec<f64>>,
}

/// Families of generated mechanisms, `size` times as many as the smallest number, on both bases. Random trees have all kinds of joints
/// and mimics, random linkages all kinds of closures.
pub fn families(size: u64) -> Vec<(&'static str, Vec<Subject>)> {
    let bases = [Base::Fixed, Base::Floating];
    let on_bases = |made: Vec<(Mechanism, Option<Vec<f64>>)>| {
        let shared = made.into_iter().map(|(mechanism, start)| (Arc::new(mechanism), start));
        let subject = |(mechanism, start): (Arc<Mechanism>, Option<Vec<f64>>)| {
            bases.map(|base| Subject {
                mechanism: Arc::clone(&mechanism),
                conditions: Conditions::new().base(base),
                start: start.clone(),
            })
        };
        shared.flat_map(subject).collect::<Vec<_>>()
    };
    let seeds = |first: u64, count: u64| (0..count * size).map(move |k| first + k);
    let tree = |seed: u64| random::mechanism(&mut StdRng::seed_from_u64(seed), 3 + seed as usize % 20);
    let has_mimic = |tree: &Mechanism| tree.joints().iter().any(|joint| joint.mimic().is_some());
    let trees = |mimics: bool| {
        let made = seeds(100, 24).map(tree).filter(|tree| has_mimic(tree) == mimics);
        on_bases(made.map(|tree| (tree, None)).collect())
    };
    let closed = |seed: u64, relations: usize| {
        let mut rng = StdRng::seed_from_u64(seed);
        let (bodies, closures) = (4 + seed as usize % 7, 1 + seed as usize % 3);
        let (mechanism, start) = random::coupled_linkage(&mut rng, bodies, closures, relations);
        (mechanism, Some(start.concat()))
    };
    let linkages = |relations: usize| on_bases(seeds(500, 12).map(|seed| closed(seed, relations)).collect());
    let drawn = seeds(900, 8).map(|seed| (linkage::family::drawn(seed).mechanism, None)).collect();
    let chosen = linkage::all().into_iter().map(|linkage| {
        let start = linkage.closed_start().concat();
        (linkage.mechanism, Some(start))
    });
    let mut held = trees(false);
    for (number, subject) in held.iter_mut().enumerate() {
        let links = subject.mechanism.links();
        let link = links[number % links.len()].name().to_owned();
        let normal = [None, Some(Vector3::new(0.6, 0.0, 0.8))][number / 2 % 2];
        subject.conditions = subject.conditions.clone().hold(link, [0.1, -0.2, 0.3], normal);
    }
    vec![
        ("trees", trees(false)),
        ("trees with mimics", trees(true)),
        ("specimens of joints", on_bases(zoo::all().into_iter().map(|(_, tree)| (tree, None)).collect())),
        ("trees with a held point", held),
        ("linkages of all closures", linkages(0)),
        ("linkages with relations", linkages(2)),
        ("planar linkages", on_bases(drawn)),
        ("known linkages", on_bases(chosen.collect())),
    ]
}

/// Coverage of a mechanism under conditions, with random contacts, from the pose as drawn.
pub fn coverage(mechanism: &Arc<Mechanism>, conditions: &Conditions, other: OtherSide) -> Coverage {
    let mechanism = Arc::clone(mechanism);
    coverage_of(&Subject { mechanism, conditions: conditions.clone(), start: None }, other)
}

/// Calls `visit` with a batch of each of some random contacts of a subject, the contact, and poses.
pub fn for_each_contact(
    subject: &Subject,
    other: OtherSide,
    mut visit: impl FnMut(&mut Batch, &Contact, &[Pose]),
) {
    let Subject { mechanism, conditions, start } = subject;
    let mut rng = StdRng::seed_from_u64(1);
    let Ok(system) = System::new(Arc::clone(mechanism), conditions) else { return };
    let start = match start {
        Some(positions) => Configuration::from_positions(mechanism, positions),
        None => Ok(system.configuration()),
    };
    let Ok(Ok(pose)) = start.map(|start| system.pose(&start)) else { return };
    let links: Vec<LinkId> = mechanism.link_ids().collect();
    let size = mechanism.characteristic_length().max(0.1);
    for _ in 0..CONTACTS {
        let link = links[rng.random_range(0..links.len())];
        let mut vector = || Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0));
        let (point, normal) = (vector() * (0.2 * size), vector());
        let mut contact = Contact::new(link, point, normal);
        if other != OtherSide::Ground {
            let frame = [Frame::Link, Frame::Against, Frame::World][rng.random_range(0..3)];
            let against = links[rng.random_range(0..links.len())];
            contact = match other {
                OtherSide::Ground => contact,
                OtherSide::Link => contact.against(against).normal(Direction::Along(normal, frame)),
                OtherSide::Line => {
                    contact.against(against).normal(Direction::TurningToward(against, normal * size))
                }
                OtherSide::Moment => {
                    let on_ground = rng.random_bool(0.5);
                    let contact = if on_ground { contact } else { contact.against(against) };
                    contact.normal(Direction::About(normal, frame))
                }
            };
        }
        let rows = poses(&mut rng, &system, &pose);
        if let Ok(mut batch) = pose.assembly().batch(&contact) {
            visit(&mut batch, &contact, &rows);
        }
    }
}

/// Coverage of a subject, with random contacts.
pub fn coverage_of(subject: &Subject, other: OtherSide) -> Coverage {
    let mut counts = Coverage::default();
    for_each_contact(subject, other, |batch, contact, poses| {
        for pose in poses {
            let Ok(answer) = batch.effective_mass(pose.positions()) else { continue };
            let Some(EffectiveMass::Finite(expected)) = answer.mass else { continue };
            counts.regular += 1;
            match batch.kernel_mass(pose.positions()) {
                Ok(Some((mass, error))) => {
                    counts.by_kernel += 1;
                    counts.wrong += usize::from(!agrees(pose, contact, mass, error));
                }
                _ if !batch.has_lanes() => counts.unsupported += 1,
                _ => {
                    let is_ill = answer.error.is_none_or(|error| error > ILL_CONDITIONED * expected);
                    counts.ill_conditioned += usize::from(is_ill);
                }
            }
        }
    });
    counts.mechanisms = usize::from(counts.regular > 0);
    counts
}

//! Contacts by Φ agree with individual responses of the pose: the same status, and m̄ within the errors stated by both.

use nalgebra::Vector3;
use percuss_dynamics::{Contact, ContactColumns, ContactMap, ContactStatus, EffectiveMass, MapAnswers, Pose};
use percuss_mechanism::LinkId;
use percuss_spatial::lanes::Instructions;
use percuss_tests::judge::UNSTATED;
use percuss_tests::subjects::{Subject, of_linkages, of_trees};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::collections::BTreeMap;

/// Number of answers by kind.
type Counts = BTreeMap<&'static str, usize>;

/// Contacts by columns.
struct Columns {
    points: [Vec<f64>; 3],
    normals: [Vec<f64>; 3],
}

impl Columns {
    /// Random contacts in a box about a centre: half with random directions, half along the axes, for which planar
    /// mechanisms are immovable.
    fn about(rng: &mut StdRng, centre: Vector3<f64>, reach: f64, count: usize) -> Self {
        let mut columns = Self { points: Default::default(), normals: Default::default() };
        for i in 0..count {
            let mut side = || rng.random_range(-1.0..1.0);
            let aside = Vector3::new(side(), side(), side()) * (reach / 3.0_f64.sqrt());
            let mut normal = Vector3::new(side(), side(), side());
            if i % 2 == 1 {
                normal = Vector3::zeros();
                normal[i / 2 % 3] = 1.0;
            }
            for axis in 0..3 {
                columns.points[axis].push(centre[axis] + aside[axis]);
                columns.normals[axis].push(normal[axis]);
            }
        }
        columns
    }

    fn contacts(&self) -> ContactColumns<'_> {
        ContactColumns {
            points: self.points.each_ref().map(|c| &c[..]),
            normals: self.normals.each_ref().map(|c| &c[..]),
        }
    }

    fn at(&self, i: usize) -> (Vector3<f64>, Vector3<f64>) {
        let of = |c: &[Vec<f64>; 3]| Vector3::new(c[0][i], c[1][i], c[2][i]);
        (of(&self.points), of(&self.normals))
    }
}

struct Filled {
    masses: Vec<f64>,
    errors: Vec<f64>,
    statuses: Vec<ContactStatus>,
}

fn filled(map: &ContactMap<'_>, columns: &Columns) -> Filled {
    let count = columns.points[0].len();
    let mut filled = Filled {
        masses: vec![0.0; count],
        errors: vec![0.0; count],
        statuses: vec![ContactStatus::Finite; count],
    };
    let mut answers = MapAnswers {
        masses: &mut filled.masses,
        relative_errors: &mut filled.errors,
        statuses: &mut filled.statuses,
    };
    map.fill_answers(columns.contacts(), &mut answers).expect("columns of one length");
    filled
}

fn compare(
    name: &str,
    pose: &Pose,
    link: LinkId,
    against: Option<LinkId>,
    columns: &Columns,
    map: &ContactMap<'_>,
    counts: &mut Counts,
) {
    let Filled { masses, errors, statuses } = filled(map, columns);
    for i in 0..masses.len() {
        let (point, normal) = columns.at(i);
        let contact = Contact { against, ..Contact::new(link, point, normal) };
        let name =
            || format!("{name}: contact {i}, {point:?} {normal:?}, by inertia {}", map.is_by_inertia());
        let Ok(response) = pose.respond(&contact) else {
            assert_eq!(statuses[i], ContactStatus::Unanswered, "{}", name());
            continue;
        };
        let known = response.effective_mass_error();
        match response.effective_mass {
            EffectiveMass::Finite(m) => {
                assert_eq!(statuses[i], ContactStatus::Finite, "{}: {m} kg", name());
                if !errors[i].is_finite() || known.is_none() {
                    *counts.entry("without a stated error").or_default() += 1;
                }
                let own = if errors[i].is_finite() { errors[i] } else { UNSTATED };
                let allowed = own * masses[i] + known.unwrap_or(UNSTATED * m);
                assert!(
                    (masses[i] - m).abs() <= allowed,
                    "{}: {} {m}, allowed {allowed:e}",
                    name(),
                    masses[i]
                );
                let digits = if errors[i] < 1e-11 { "finite to 1e-11" } else { "finite" };
                *counts.entry(digits).or_default() += 1;
            }
            EffectiveMass::Immovable => {
                assert_eq!(statuses[i], ContactStatus::Immovable, "{}", name());
                assert!(masses[i].is_nan());
                *counts.entry("immovable").or_default() += 1;
            }
            EffectiveMass::Massless => {
                assert_eq!(statuses[i], ContactStatus::Massless, "{}", name());
                assert_eq!(masses[i], 0.0);
                *counts.entry("massless").or_default() += 1;
            }
        }
    }
}

/// All links of a subject against the ground, and some pairs of links.
fn of_subject(rng: &mut StdRng, subject: &Subject, counts: &mut Counts) {
    let links: Vec<LinkId> = subject.mechanism().link_ids().collect();
    let other = links[rng.random_range(0..links.len())];
    for &link in links.iter().take(8) {
        for against in [None, Some(other).filter(|o| *o != link)] {
            let centre = Vector3::new(rng.random_range(-0.2..0.2), rng.random_range(-0.2..0.2), 0.1);
            let reach = 10f64.powf(rng.random_range(-2.0..0.3));
            let columns = Columns::about(rng, centre, reach, 27);
            let map = subject.pose.contact_map(link, against, centre, reach).expect("a link and a region");
            let kind = if map.is_by_inertia() { "map by inertia" } else { "map one by one" };
            *counts.entry(kind).or_default() += 1;
            compare(&subject.name, &subject.pose, link, against, &columns, &map, counts);
        }
    }
}

#[track_caller]
fn assert_occurred(counts: &Counts, kinds: &[&str]) {
    println!("{counts:?}");
    for kind in kinds {
        assert!(counts.get(kind).is_some_and(|n| *n > 20), "{kind} hardly occurred: {counts:?}");
    }
}

#[test]
fn contacts_on_trees_are_those_of_the_pose() {
    let (mut counts, mut rng) = (Counts::new(), StdRng::seed_from_u64(70));
    for subject in of_trees(71, 2, 60) {
        of_subject(&mut rng, &subject, &mut counts);
    }
    assert_occurred(&counts, &["map by inertia", "finite to 1e-11", "immovable", "massless"]);
}

#[test]
fn contacts_on_linkages_are_those_of_the_pose() {
    let (mut counts, mut rng) = (Counts::new(), StdRng::seed_from_u64(72));
    for subject in of_linkages(900, 4) {
        of_subject(&mut rng, &subject, &mut counts);
    }
    assert_occurred(&counts, &["map by inertia", "finite to 1e-11", "immovable"]);
}

/// All instruction sets agree, and a group of contacts agrees with single contacts.
#[test]
fn sets_and_lengths_do_not_matter() {
    let mut rng = StdRng::seed_from_u64(73);
    let mut compared = 0;
    for subject in of_trees(74, 1, 6).into_iter().chain(of_linkages(901, 1)) {
        let link = subject.contact.link;
        let map = subject.pose.contact_map(link, None, [0.0; 3], 0.4).expect("a region");
        for count in [0, 1, 2, 3, 5, 8, 17, 700] {
            let columns = Columns::about(&mut rng, Vector3::zeros(), 0.4, count);
            let best = filled(&map, &columns);
            for set in [Instructions::Baseline, Instructions::Avx2, Instructions::Avx512] {
                let other = filled(&map.clone().with_instructions(set), &columns);
                for i in 0..count {
                    let (a, b) = (best.masses[i], other.masses[i]);
                    assert!(a == b || (a - b).abs() <= 2.0 * best.errors[i] * a || a.is_nan() && b.is_nan());
                    assert_eq!(best.statuses[i], other.statuses[i]);
                }
            }
            for i in 0..count.min(20) {
                let (point, normal) = columns.at(i);
                let one = map.effective_mass(&point, &normal);
                match one.mass {
                    Some(EffectiveMass::Finite(m)) => assert_eq!(m, best.masses[i]),
                    Some(EffectiveMass::Immovable) => assert_eq!(best.statuses[i], ContactStatus::Immovable),
                    Some(EffectiveMass::Massless) => assert_eq!(best.statuses[i], ContactStatus::Massless),
                    None => assert_eq!(best.statuses[i], ContactStatus::Unanswered),
                }
                compared += 1;
            }
        }
    }
    assert!(compared > 300, "{compared} compared");
}

/// Invalid contacts have no answer and do not affect other contacts.
#[test]
fn invalid_contacts_have_no_answer() {
    let subject = &of_trees(75, 1, 1)[0];
    let link = subject.contact.link;
    let map = subject.pose.contact_map(link, None, [0.0; 3], 0.4).expect("a region");
    let mut columns = Columns::about(&mut StdRng::seed_from_u64(76), Vector3::zeros(), 0.4, 40);
    let good = filled(&map, &columns);
    columns.points[1][7] = f64::NAN;
    columns.normals[0][12] = f64::INFINITY;
    (0..3).for_each(|axis| columns.normals[axis][20] = 0.0);
    let bad = filled(&map, &columns);
    for i in 0..40 {
        if [7, 12, 20].contains(&i) {
            assert_eq!(bad.statuses[i], ContactStatus::Unanswered, "{i}");
            assert!(bad.masses[i].is_nan());
        } else {
            assert_eq!(bad.statuses[i], good.statuses[i], "{i}");
            assert!(bad.masses[i] == good.masses[i] || good.masses[i].is_nan());
        }
    }
    for (centre, reach) in [([f64::NAN, 0.0, 0.0], 1.0), ([0.0; 3], f64::INFINITY), ([0.0; 3], -1.0)] {
        assert!(subject.pose.contact_map(link, None, centre, reach).is_err());
    }
    assert!(subject.pose.contact_map(link, Some(link), [0.0; 3], 1.0).is_err());
}

/// Belted ellipsoid: m̄ is stationary along the principal directions, and 1/m̄ in other directions is the quadratic
/// form of the principal values.
#[test]
fn principal_masses_make_the_mass_in_every_direction() {
    let mut rng = StdRng::seed_from_u64(77);
    let mut finite = 0;
    for subject in of_trees(78, 1, 40).into_iter().chain(of_linkages(902, 1)) {
        let map = subject.pose.contact_map(subject.contact.link, None, [0.0; 3], 0.3).expect("a region");
        let mut side = || rng.random_range(-0.2..0.2);
        let point = Vector3::new(side(), side(), side());
        let Some(principal) = map.principal_masses(&point) else { continue };
        let inverse = |mass| match mass {
            EffectiveMass::Finite(m) => Some(1.0 / m),
            EffectiveMass::Immovable => Some(0.0),
            EffectiveMass::Massless => None,
        };
        let alone = subject.pose.principal_masses(subject.contact.link, None, point).expect("a point");
        for (a, b) in principal.iter().zip(alone.expect("masses")) {
            match (inverse(a.mass), inverse(b.mass)) {
                (Some(a), Some(b)) => assert!((a - b).abs() <= 1e-7 * a.max(b), "{}: {a} {b}", subject.name),
                (a, b) => assert_eq!(a, b, "{}", subject.name),
            }
        }
        for (i, a) in principal.iter().enumerate() {
            for b in &principal[..i] {
                assert!(a.direction.dot(&b.direction).abs() < 1e-9, "{}", subject.name);
            }
        }
        let Some(inverses) = principal.iter().map(|p| inverse(p.mass)).collect::<Option<Vec<f64>>>() else {
            continue;
        };
        assert!(inverses.windows(2).all(|w| w[0] >= w[1] * (1.0 - 1e-9)), "{}: {inverses:?}", subject.name);
        for _ in 0..10 {
            let normal = Vector3::new(side(), side(), side()).normalize();
            let sum: f64 =
                principal.iter().zip(&inverses).map(|(p, i)| p.direction.dot(&normal).powi(2) * i).sum();
            if let Some(EffectiveMass::Finite(m)) = map.effective_mass(&point, &normal).mass {
                assert!((m * sum - 1.0).abs() < 1e-7, "{}: {m} {}", subject.name, 1.0 / sum);
                finite += 1;
            }
        }
    }
    assert!(finite > 200, "{finite} compared");
}

//! The normal along a line at random poses: refused if and only if the line has turned by more than 5° from the line as
//! drawn, or is shorter than a tenth of its drawn length; the same for a pose, a workspace, a batch and a driven path.

use nalgebra::Vector3;
use percuss_dynamics::{
    BatchPositions, Conditions, Contact, ContactError, Direction, EffectiveMass, Frame, Pose, ResponseError,
    System,
};
use percuss_formats::{LoadOptions, Source, load};
use percuss_mechanism::Mechanism;
use percuss_tests::answer::answers;
use std::sync::Arc;

/// Crank 0.3 m, coupler 1 m, rocker 0.8 m, ground 1 m, closed as drawn with the crank at 0.
fn four_bar() -> Mechanism {
    let (crank, coupler, rocker, ground) = (0.3, 1.0_f64, 0.8_f64, 1.0_f64);
    // The coupler's end relative to the crank's end; the rocker's bearing is 0.7 m from the crank's end.
    let along = (coupler.powi(2) - rocker.powi(2) + (ground - crank).powi(2)) / (2.0 * (ground - crank));
    let up = (coupler.powi(2) - along.powi(2)).sqrt();
    let turn = up.atan2(along);
    let lean = up.atan2(along + crank - ground);
    let bar = |name: &str, length: f64, mass: f64| {
        format!(
            "<link name=\"{name}\"><inertial><origin xyz=\"{} 0.01 0\"/><mass value=\"{mass}\"/><inertia ixx=\"0.01\" iyy=\"0.02\" \
             izz=\"0.02\"/></inertial></link>",
            length / 2.0
        )
    };
    let text = format!(
        "<robot name=\"four_bar\"><link name=\"ground\"/>{}{}{}\
         <joint name=\"drive\" type=\"continuous\"><parent link=\"ground\"/><child link=\"crank\"/><axis xyz=\"0 0 1\"/></joint>\
         <joint name=\"elbow\" type=\"continuous\"><origin xyz=\"{crank} 0 0\" rpy=\"0 0 {turn}\"/><parent link=\"crank\"/>\
         <child link=\"coupler\"/><axis xyz=\"0 0 1\"/></joint>\
         <joint name=\"swing\" type=\"continuous\"><origin xyz=\"{ground} 0 0\" rpy=\"0 0 {lean}\"/><parent link=\"ground\"/>\
         <child link=\"rocker\"/><axis xyz=\"0 0 1\"/></joint>\
         <loop name=\"pin\" type=\"revolute\"><predecessor link=\"coupler\"><origin xyz=\"{coupler} 0 0\"/></predecessor>\
         <successor link=\"rocker\"><origin xyz=\"{rocker} 0 0\"/></successor><axis xyz=\"0 0 1\"/></loop></robot>",
        bar("crank", crank, 0.4),
        bar("coupler", coupler, 1.3),
        bar("rocker", rocker, 0.9),
    );
    load(&Source::from_text("four_bar.urdf", text), &LoadOptions::default()).expect("a four-bar").mechanism
}

/// Angle of the line from the line as drawn (rad), and its length relative to the drawn length, from the poses alone.
fn turned(pose: &Pose, drawn: &Pose, contact: &Contact) -> (f64, f64) {
    let (end, to) = contact.normal.line().expect("a line");
    let line = |pose: &Pose| {
        let line = pose.link(end).point(&to) - pose.link(contact.link).point(&contact.point);
        contact.against.map_or(line, |against| pose.link(against).inverse_vector(&line))
    };
    let (now, then) = (line(pose), line(drawn));
    (now.angle(&then), now.norm() / then.norm())
}

#[test]
fn turned_lines_are_refused() {
    let mechanism = Arc::new(four_bar());
    let link = |name: &str| mechanism.find_link(name).expect("a link");
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
    let drawn = system.pose(&system.configuration()).expect("closed as drawn");
    let at_drive = |angle: f64| {
        let mut configuration = system.configuration();
        configuration.set("drive", &[angle]).expect("a driver");
        configuration
    };
    let mut counts = [0; 3];
    // Ends of lines on the ground and on the other bars; lines to near ends turn fully, lines to far ends keep their
    // direction.
    for (case, reach) in [0.02, 0.1, 0.5, 3.0, 20.0].into_iter().enumerate() {
        for against in [None, Some(link("rocker")), Some(link("crank"))] {
            let tip = Vector3::new(0.5, 0.1, 0.0);
            let at = drawn.link(link("coupler")).point(&tip);
            let passed =
                system.pose(&at_drive(3.0)).expect("it turns fully").link(link("coupler")).point(&tip);
            let angle = 0.7 + case as f64;
            let far = match case {
                // Close to a point on the path of the tip.
                0 => passed + Vector3::new(0.0, 0.0, 1e-3),
                _ => at + reach * Vector3::new(angle.cos(), angle.sin(), 0.1),
            };
            let other = against.unwrap_or(link("ground"));
            let to = drawn.link(other).inverse_point(&far);
            let base = Contact::new(link("coupler"), tip, Vector3::x());
            let base = against.map_or(base, |against| base.against(against));
            let stop = base.normal(Direction::Toward(other, to));
            let spring = base.normal(Direction::TurningToward(other, to));
            let mut workspace = drawn.assembly().workspace();
            let batch = drawn.assembly().batch(&stop).expect("a contact");
            let (mut rows, mut positions, mut expected) = (Vec::new(), Vec::new(), Vec::new());
            for step in 0..60 {
                let pose = system.pose(&at_drive(step as f64 / 60.0 * 6.0)).expect("it turns fully");
                let (angle, part) = turned(&pose, &drawn, &stop);
                // No case is decided by rounding.
                assert!((angle - 5f64.to_radians()).abs() > 1e-9 && (part - 0.1).abs() > 1e-9);
                let answer = pose.respond(&stop).map(|r| r.effective_mass);
                let turning = pose.respond(&spring).map(|r| r.effective_mass);
                if part < 0.1 {
                    counts[0] += 1;
                    for answer in [&answer, &turning] {
                        assert!(
                            matches!(answer, Err(ResponseError::Contact(ContactError::LineShort { .. }))),
                            "{answer:?} at {part} of the length"
                        );
                    }
                } else if angle > 5f64.to_radians() {
                    counts[1] += 1;
                    let Err(ResponseError::Contact(ContactError::LineTurned {
                        angle: stated,
                        normal,
                        frame,
                        ..
                    })) = &answer
                    else {
                        panic!("{answer:?} where the line has turned by {angle} rad")
                    };
                    assert!((stated - angle).abs() < 1e-9);
                    // The stated remedy, the normal as drawn, gives a result; at the drawn pose, it equals the result
                    // of the line.
                    let fixed = base.normal(Direction::Along(*normal, *frame));
                    assert_eq!(*frame, if against.is_some() { Frame::Against } else { Frame::World });
                    assert!(pose.respond(&fixed).is_ok());
                    let at_zero = |contact| drawn.respond(contact).expect("as drawn").effective_mass;
                    match (at_zero(&fixed), at_zero(&stop)) {
                        (EffectiveMass::Finite(a), EffectiveMass::Finite(b)) => {
                            assert!((a / b - 1.0).abs() < 1e-12, "{a} and {b}");
                        }
                        // The line as drawn may be normal to the motion.
                        (a, b) => assert_eq!(a, b),
                    }
                    assert!(turning.is_ok(), "{turning:?}");
                } else {
                    counts[2] += 1;
                    assert_eq!(answer, turning);
                    assert!(answer.is_ok(), "{answer:?}");
                }
                workspace.set_positions(pose.positions()).expect("as many");
                match (workspace.effective_mass(&stop), &answer) {
                    (Ok(EffectiveMass::Finite(a)), Ok(EffectiveMass::Finite(b))) => {
                        assert!((a / b - 1.0).abs() < 1e-10, "{a} and {b}");
                    }
                    (Ok(a), Ok(b)) => assert_eq!(a, *b),
                    (a, b) => assert!(a.is_err() && b.is_err(), "{a:?} and {b:?}"),
                }
                rows.push(step as f64 / 60.0 * 6.0);
                positions.extend_from_slice(pose.positions());
                expected.push(answer.ok());
            }
            let positions = BatchPositions::Rows { values: &positions, stride: drawn.positions().len() };
            let answers = answers(&batch, positions, expected.len(), usize::MAX).expect("as many");
            for (found, expected) in answers.iter().zip(&expected) {
                assert_eq!(found.mass.is_some(), expected.is_some(), "{found:?} for {expected:?}");
            }
            let drive = mechanism.find_joint("drive").expect("a joint");
            // Linkages with redundant rows have no SIMD path.
            let path = drawn.driven_path(&stop, &[drive]).expect("a contact");
            if let Some(mut path) = path {
                let (mut reached, mut at) = (Vec::new(), Vec::new());
                let count = path.follow(&rows[1..], &mut reached, &mut at);
                for (found, expected) in reached[..count].iter().zip(&expected[1..]) {
                    assert!(found.mass.is_none() || expected.is_some(), "{found:?} for {expected:?}");
                }
            }
        }
    }
    println!("{counts:?} short, turned, answered");
    assert!(counts[0] > 0 && counts[1] > 300 && counts[2] > 200, "{counts:?}");
}

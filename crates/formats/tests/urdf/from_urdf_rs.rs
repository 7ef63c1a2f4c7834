//! Robots of urdf-rs have the mechanism of their file.

use crate::support::load_text;
use approx::assert_relative_eq;
use percuss_formats::{LoadOptions, from_urdf_rs, load_file};
use std::path::{Path, PathBuf};

/// Shipped models in URDF.
fn models() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    files.filter(|path| path.extension().is_some_and(|ending| ending == "urdf")).collect()
}

/// Trees of the shipped models: links, inertias, joints, limits and mimics as from the file. Angles pass through three angles of urdf-rs.
#[test]
fn robots_are_those_of_their_files() {
    let mut compared = 0;
    for path in models() {
        let Ok(robot) = urdf_rs::read_file(&path) else { continue };
        let Ok(file) = load_file(&path.to_string_lossy()) else { continue };
        let file = file.mechanism;
        if !file.closures().is_empty() || !file.couplings().is_empty() {
            continue;
        }
        let found = from_urdf_rs(&robot, &LoadOptions::default()).unwrap_or_else(|e| panic!("{path:?}: {e}"));
        assert!(found.diagnostics[0].code == "not-in-urdf-rs", "{path:?}");
        let found = found.mechanism;
        assert_eq!(
            (found.links().len(), found.joints().len()),
            (file.links().len(), file.joints().len()),
            "{path:?}"
        );
        for (own, theirs) in found.links().iter().zip(file.links()) {
            assert_eq!((own.name(), own.inertial()), (theirs.name(), theirs.inertial()), "{path:?}");
        }
        for (own, theirs) in found.joints().iter().zip(file.joints()) {
            assert_eq!((own.name(), own.kind(), own.mimic()), (theirs.name(), theirs.kind(), theirs.mimic()));
            let limits = theirs.limits().filter(|limits| (limits.lower, limits.upper) != (0.0, 0.0));
            assert_eq!(own.limits(), limits, "{path:?} {}", own.name());
            assert_relative_eq!(own.origin().rotation, theirs.origin().rotation, epsilon = 1e-12);
        }
        compared += 1;
    }
    assert!(compared >= 5, "{compared} models");
}

#[test]
fn values_in_place_of_absent_ones() {
    let text = r#"<robot name="r"><link name="a"/><link name="b"><inertial><mass value="1"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
        <joint name="h" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
        <limit effort="1" velocity="0"/></joint></robot>"#;
    let mut robot = urdf_rs::read_from_string(text).unwrap();
    let found = from_urdf_rs(&robot, &LoadOptions::default()).unwrap();
    let read = load_text(text).unwrap_or_else(|e| panic!("{e}")).mechanism;
    assert!(
        found.mechanism.links()[0].inertial().is_none() && found.mechanism.joints()[0].limits().is_none()
    );
    assert_eq!(found.mechanism.joints()[0].rate_limit(), read.joints()[0].rate_limit());
    assert!(found.diagnostics[1].message.ends_with("\"h\""), "{:?}", found.diagnostics);
    (robot.joints[0].limit.lower, robot.joints[0].limit.upper) = (1.0, -1.0);
    let found = from_urdf_rs(&robot, &LoadOptions::default()).unwrap();
    assert!(
        found.diagnostics.iter().any(|finding| finding.code == "limits-reversed"),
        "{:?}",
        found.diagnostics
    );
    robot.joints[0].parent.link = "c".to_owned();
    let error = from_urdf_rs(&robot, &LoadOptions::default()).unwrap_err();
    assert!(error.to_string().contains("\"c\""), "{error}");
    robot.joints.clear();
    robot.links.clear();
    let error = from_urdf_rs(&robot, &LoadOptions::default()).unwrap_err();
    assert!(error.to_string().contains("no links"), "{error}");
}

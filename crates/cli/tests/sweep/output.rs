//! `percuss sweep`: columns, varied joints, unreachable rows, output files.

use crate::support;
use crate::support::{Scratch, Sweep, json, percuss};

const COUPLER: &str = "sweep models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0";
const STOP: &str = "sweep models/double_wishbone.urdf --link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 --turning-normal \
                    --against chassis --estimate wheel,spindle,upright";

fn swept(line: &str) -> Sweep {
    let outcome = percuss(line);
    assert_eq!(outcome.code, 0, "{line}\n{}", outcome.stderr);
    Sweep::read(&outcome.stdout)
}

#[test]
fn the_columns_are_those_that_scripts_rely_on() {
    let sweep = swept(&format!("{COUPLER} --vary crank_hinge=0:10deg:3"));
    let fixed =
        "status,effective_mass,closure_residual,singular_pose,motion_ratio,estimate,estimate_error_percent";
    assert_eq!(sweep.header.join(","), format!("row,crank_hinge,{fixed},crank_pin,rocker_hinge"));
    assert_eq!(
        (sweep.cell(2, "row"), sweep.cell(0, "motion_ratio"), sweep.cell(0, "estimate")),
        ("2", "", "")
    );
    assert_eq!(sweep.number(1, "crank_hinge"), Some(5f64.to_radians()));
    // Joints with several numbers have a column per number; the travelling link is named.
    let sweep = swept(&format!("{STOP} --vary travel:wheel_centre:0,0,0:0,0,1=0:1mm:2"));
    let ball = "lower_ball[0],lower_ball[1],lower_ball[2],lower_ball[3]";
    assert_eq!(
        sweep.header.join(","),
        format!("row,travel:wheel_centre,{fixed},lower_arm_hinge,{ball},spin,upper_arm_hinge")
    );
    assert_eq!(sweep.number(1, "travel:wheel_centre"), Some(0.001));
}

/// Every row equals the result of `percuss mass`.
#[test]
fn rows_are_the_answers_of_mass() {
    let sweep = swept(&format!("{COUPLER} --vary crank_hinge=-50deg:70deg:7 --estimate coupler"));
    for row in 0..7 {
        let mass = COUPLER.replace("sweep", "mass");
        let report = json(&format!(
            "{mass} --set crank_hinge={} --estimate coupler --format json",
            sweep.cell(row, "crank_hinge")
        ));
        for (column, value) in [
            ("effective_mass", &report["effective_mass"]),
            ("estimate", &report["estimate"]["estimate"]),
            ("motion_ratio", &report["estimate"]["motion_ratio"]),
            ("crank_pin", &report["pose"]["crank_pin"][0]),
            ("rocker_hinge", &report["pose"]["rocker_hinge"][0]),
        ] {
            let (got, wanted) = (sweep.number(row, column).unwrap(), value.as_f64().unwrap());
            assert!(
                (got - wanted).abs() < 1e-10 * wanted.abs().max(1.0),
                "row {row}, {column}: {got} {wanted}"
            );
        }
    }
    // A full turn ends at the first pose, on the same branch.
    let turn = swept(&format!("{COUPLER} --vary crank_hinge=0:360deg:5"));
    let (first, last) =
        (turn.number(0, "effective_mass").unwrap(), turn.number(4, "effective_mass").unwrap());
    assert!((first / last - 1.0).abs() < 1e-12, "{first} {last}");
    // A single value; a descending range.
    assert_eq!(swept(&format!("{COUPLER} --vary crank_hinge=20deg:20deg:1")).rows.len(), 1);
    let down = swept(&format!("{COUPLER} --vary crank_hinge=70deg:-50deg:7"));
    assert!(
        (down.number(6, "effective_mass").unwrap() / sweep.number(0, "effective_mass").unwrap() - 1.0).abs()
            < 1e-12
    );
}

/// The displacement equals the requested travel, measured at the pose of every row by another command.
#[test]
fn travel_is_the_requested_displacement() {
    let sweep = swept(&format!("{STOP} --vary travel:wheel_centre:0,0,0:0,0,3=-80mm:80mm:5"));
    let centre = |angle: &str| {
        let line = "mass models/double_wishbone.urdf --link wheel_centre --point 0,0,0 --normal 0,0,1";
        let report = json(&format!("{line} --set lower_arm_hinge={angle} --format json"));
        report["contact"]["point_world"][2].as_f64().unwrap()
    };
    let design = centre("0");
    for row in 0..5 {
        let asked = sweep.number(row, "travel:wheel_centre").unwrap();
        let gone = centre(sweep.cell(row, "lower_arm_hinge")) - design;
        assert!((gone - asked).abs() < 1e-11, "row {row}: {gone} instead of {asked}");
    }
    assert_eq!(sweep.number(2, "travel:wheel_centre"), Some(0.0));
    // Without an estimate, the motion ratio is that of the travelling point: at zero, the vertical speed of the
    // spindle per unit speed of the contact.
    let spring = "sweep models/double_wishbone.urdf --link spring_seat --point 0,0,0 --along-line spring_chassis_seat:0,0,0";
    let sweep = swept(&format!("{spring} --vary travel:spindle:0,0,0:0,0,1=0:10mm:2"));
    assert!((sweep.number(0, "motion_ratio").unwrap() * 2.21478924 - 1.0).abs() < 1e-8);
    // Travel starts at the set position.
    let from = swept(&format!("{spring} --set spin=0.3 --vary travel:spindle:0,0,0:0,0,1=0:10mm:2"));
    assert_eq!(from.number(1, "spin"), Some(0.3));
}

#[test]
fn travel_ends_at_the_end_of_its_range() {
    // The wheel centre is lowest at 183.4 mm droop; the arm itself could turn a little more.
    let droop = swept(&format!("{STOP} --vary travel:wheel_centre:0,0,0:0,0,1=-183mm:-184mm:3"));
    assert_eq!([0, 1, 2].map(|row| droop.cell(row, "status")), ["finite", "unreachable", "unreachable"]);
    // The crank's pin moves 0.3 m to both sides.
    let pin = swept(&format!("{COUPLER} --vary travel:coupler:0,0,0:1,0,0=-0.29999:0.29999:3"));
    for (row, wanted) in [(0, -0.29999), (2, 0.29999)] {
        let angle = pin.number(row, "crank_hinge").unwrap();
        assert!((-0.3 * angle.sin() - wanted).abs() < 1e-12, "row {row}: {angle}");
    }
    let beyond = percuss(&format!("{COUPLER} --vary travel:coupler:0,0,0:1,0,0=0:0.8:3"));
    assert_eq!(beyond.code, 0);
    let (_, told) = beyond
        .stderr
        .split_once("2 of 3 rows have no result; the first: a travel of 0.4 m")
        .expect("two rows");
    let nearest = told.rsplit("nearest reached: ").next().unwrap().trim().trim_end_matches(" m");
    assert!((0.28..=0.3).contains(&nearest.parse::<f64>().expect("a number")), "{told}");
}

#[test]
fn rows_out_of_reach_have_empty_cells_and_the_sweep_goes_on() {
    let line = format!("{STOP} --vary lower_arm_hinge=0.6:0.2:5");
    let outcome = percuss(&line);
    assert_eq!(outcome.code, 0);
    assert!(outcome.stderr.contains("warning: 2 of 5 rows have no result"), "{}", outcome.stderr);
    let sweep = Sweep::read(&outcome.stdout);
    for row in 0..2 {
        assert_eq!(sweep.cell(row, "status"), "unreachable");
        let filled: Vec<&str> =
            sweep.rows[row].iter().map(String::as_str).filter(|c| !c.is_empty()).collect();
        assert_eq!(filled.len(), 3, "{filled:?}");
    }
    assert!(
        (2..5).all(
            |row| sweep.cell(row, "status") == "finite" && !sweep.cell(row, "upper_arm_hinge").is_empty()
        )
    );
    // If all rows are unreachable, the header is still written, and the exit code is 1.
    let none = percuss(&format!("{STOP} --vary lower_arm_hinge=1:2:3"));
    assert_eq!(none.code, 1);
    assert!(none.stdout.starts_with("row,lower_arm_hinge,status,"), "{}", none.stdout);
    assert!(
        none.stderr.contains("3 of 3 rows have no result") && none.stderr.contains("upper_ball"),
        "{}",
        none.stderr
    );
}

#[test]
fn a_mimic_is_not_varied_but_its_master_is() {
    let model = r#"<robot name="r"><link name="g"/>
      <link name="a"><inertial><origin xyz="1 0 0"/><mass value="2"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
      <link name="b"><inertial><origin xyz="1 0 0"/><mass value="3"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
      <joint name="p" type="continuous"><parent link="g"/><child link="a"/><axis xyz="0 0 1"/></joint>
      <joint name="q" type="continuous"><parent link="g"/><child link="b"/><axis xyz="0 0 1"/><mimic joint="p" multiplier="-2"/></joint></robot>"#;
    let line = "sweep - --link a --point 1,0,0 --normal 0,1,0 --vary";
    let refused = support::percuss_with_stdin(&format!("{line} q=0:1:3"), model.as_bytes());
    assert_eq!(refused.code, 2);
    assert!(refused.stderr.contains("it mimics \"p\"; vary that joint"), "{}", refused.stderr);
    let rows = support::percuss_with_stdin(&format!("{line} p=0:1:3"), model.as_bytes());
    let sweep = Sweep::read(&rows.stdout);
    for row in 0..3 {
        // m₁ + 4 m₂.
        assert!((sweep.number(row, "effective_mass").unwrap() - 14.0).abs() < 1e-13);
        assert_eq!(sweep.number(row, "q").unwrap(), -2.0 * sweep.number(row, "p").unwrap());
    }
}

#[test]
fn positions_of_mimics_are_in_the_rows_of_trees_and_within_their_limits() {
    let model = r#"<robot name="r"><link name="g"/><link name="h"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
      <link name="a"><inertial><origin xyz="0.1 0 0"/><mass value="2"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
      <link name="b"><inertial><origin xyz="0.1 0 0"/><mass value="3"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
      <joint name="s" type="continuous"><parent link="g"/><child link="h"/><axis xyz="0 0 1"/></joint>
      <joint name="p" type="prismatic"><parent link="h"/><child link="a"/><axis xyz="0 1 0"/></joint>
      <joint name="q" type="prismatic"><parent link="h"/><child link="b"/><axis xyz="0 -1 0"/><limit lower="0" upper="0.05" effort="1" velocity="1"/><mimic joint="p" multiplier="2" offset="0.01"/></joint></robot>"#;
    let line = "sweep - --link a --point 0.2,0,0 --normal 0,1,0 --vary p=0:0.04:5";
    let rows = support::percuss_with_stdin(line, model.as_bytes());
    let sweep = Sweep::read(&rows.stdout);
    for row in 0..5 {
        let master = sweep.number(row, "p").unwrap();
        assert_eq!(sweep.number(row, "q").unwrap(), 2.0 * master + 0.01);
    }
    assert!(
        rows.stderr.contains("joint \"q\" is at 0.06999999999999999, outside its limits 0 to 0.05"),
        "{}",
        rows.stderr
    );
}

#[test]
fn json_svg_and_png_are_written() {
    let folder = Scratch::new("sweep-files");
    let run = |ending: &str| {
        let path = folder.path(&format!("travel.{ending}"));
        let outcome =
            percuss(&format!("{STOP} --vary travel:wheel_centre:0,0,0:0,0,1=-80mm:80mm:9 --output {path}"));
        assert_eq!((outcome.code, outcome.stdout.as_str()), (0, ""), "{}", outcome.stderr);
        std::fs::read(path).expect("it was written")
    };
    let sweep = Sweep::read(&String::from_utf8(run("csv")).unwrap());
    let report: serde_json::Value = serde_json::from_slice(&run("json")).expect("JSON");
    assert_eq!(report["schema"], "percuss.sweep/2");
    assert_eq!(report["varied"], serde_json::json!([{ "name": "travel:wheel_centre", "unit": "m" }]));
    let rows = report["rows"].as_array().expect("rows");
    assert_eq!((rows.len(), sweep.rows.len()), (9, 9));
    for (row, record) in rows.iter().enumerate() {
        for (value, column) in [
            (&record["effective_mass"], "effective_mass"),
            (&record["estimate_error_percent"], "estimate_error_percent"),
            (&record["pose"]["lower_arm_hinge"][0], "lower_arm_hinge"),
        ] {
            let (value, cell) = (value.as_f64().unwrap(), sweep.number(row, column).unwrap());
            // The digits are the same; serde_json may read them half an ulp off.
            assert!(
                (value - cell).abs() <= 2.0 * f64::EPSILON * cell.abs(),
                "row {row}, {column}: {value} {cell}"
            );
        }
        assert!(record["error"].is_null());
    }
    assert!(run("PNG").starts_with(b"\x89PNG\r\n\x1a\n") && run("png").ends_with(b"IEND\xaeB`\x82"));
    let svg = String::from_utf8(run("svg")).expect("text");
    assert!(
        svg.contains("effective mass") && svg.contains("wheel travel (mm)") && svg.contains("estimate"),
        "{svg}"
    );
    // The picture is valid XML: the loader reads it completely and rejects only the root element.
    let refused = percuss(&format!("check {}", folder.path("travel.svg")));
    assert_eq!(refused.code, 2);
    assert!(refused.stderr.contains("robot") && refused.stderr.contains("svg"), "{}", refused.stderr);
}

/// Numbers are read back unchanged, and no cell contains hundreds of zeros.
#[test]
fn small_numbers_are_short() {
    let sweep = swept(&format!("{COUPLER} --vary crank_hinge=1e-9:1e-7:4"));
    for row in &sweep.rows {
        assert!(row.iter().all(|cell| cell.len() <= 26), "{row:?}");
    }
    assert_eq!(sweep.number(0, "crank_hinge"), Some(1e-9));
}

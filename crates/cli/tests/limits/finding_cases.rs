//! Inputs that raise each finding, for the tests of the command, of the library and of the C interface.

/// Finding, and an input that raises it.
pub struct Case {
    pub code: &'static str,
    pub model: String,
    /// Flags of the contact and its conditions.
    pub contact: &'static str,
    /// Flags of the pose of a mass.
    pub pose: &'static str,
    /// Joint and first position of the rows of a sweep; empty if no row can be given.
    pub vary: &'static str,
}

impl Case {
    /// Flags as pairs of a study key, without its table, and its text.
    pub fn flags(&self) -> Vec<(String, &'static str)> {
        let words: Vec<&str> = self.contact.split_whitespace().chain(self.pose.split_whitespace()).collect();
        words.chunks(2).map(|pair| (pair[0].trim_start_matches('-').replace('-', "_"), pair[1])).collect()
    }

    /// Range of the rows of a sweep: two positions of a joint.
    pub fn range(&self) -> Option<String> {
        let (joint, position) = self.vary.split_once('=')?;
        let last = position.parse::<f64>().expect("a number") + 1e-3;
        Some(format!("{joint}={position}:{last}:2"))
    }

    /// Tables of a study, as JSON: the contact and its conditions, and the pose of the mass or the rows of the sweep.
    pub fn request(&self, is_sweep: bool) -> String {
        let [mut contact, mut pose, mut conditions, mut hold] = [(); 4].map(|()| Vec::new());
        for (key, value) in self.flags() {
            match key.as_str() {
                "point" | "normal" => contact.push(format!("\"{key}\": [{value}]")),
                "set" | "travel" if is_sweep => {}
                "set" | "guess" => {
                    let (joint, value) = value.split_once('=').expect("a joint");
                    pose.push(format!("\"{key}\": {{\"{joint}\": [{value}]}}"));
                }
                "travel" => pose.push(format!("\"{key}\": \"{value}\"")),
                "base" => conditions.push(format!("\"{key}\": \"{value}\"")),
                "hold" => {
                    let parts: Vec<&str> = value.split(':').collect();
                    let [link, point, normal] = parts[..] else { panic!("{value}") };
                    hold.push(format!(
                        "{{\"link\": \"{link}\", \"point\": [{point}], \"normal\": [{normal}]}}"
                    ));
                }
                _ => contact.push(format!("\"{key}\": \"{value}\"")),
            }
        }
        let [contact, pose, conditions, hold] = [contact, pose, conditions, hold].map(|keys| keys.join(", "));
        let sweep = match self.range().filter(|_| is_sweep) {
            Some(range) => format!(", \"sweep\": {{\"vary\": \"{range}\"}}"),
            None => String::new(),
        };
        format!(
            "{{\"contact\": {{{contact}}}, \"pose\": {{{pose}}}, \"conditions\": {{{conditions}}}, \"hold\": [{hold}]{sweep}}}"
        )
    }

    /// Findings about a file for which it must be accepted.
    pub fn accepted(&self) -> Option<&'static str> {
        (self.code == "indefinite-mass-matrix").then_some("indefinite-inertia")
    }
}

/// URDF of a model of the repository with one part replaced.
fn changed(model: &str, from: &str, to: &str) -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/");
    let text = std::fs::read_to_string(format!("{path}{model}")).expect("a model");
    assert!(from.is_empty() || text.contains(from), "{model}: {from}");
    text.replacen(from, to, 1)
}

/// Chain of a link on a slide and a link on a hinge, with the inertias of the ground and of the two links; a stop 0.5 m in front of the slide.
fn chain_on(ground: &str, rod: &str, tip: &str) -> String {
    format!(
        r#"<robot name="chain"><link name="ground">{ground}</link><link name="rod">{rod}</link><link name="tip">{tip}</link>
        <joint name="slide" type="prismatic"><parent link="ground"/><child link="rod"/><axis xyz="1 0 0"/>
        <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
        <joint name="turn" type="continuous"><parent link="rod"/><child link="tip"/><axis xyz="0 0 1"/></joint>
        <contact name="buffer" type="stop"><body link="rod" xyz="0 0 0"/><other link="ground"/><normal xyz="1 0 0"/>
        <gap value="0.5"/></contact></robot>"#
    )
}

fn chain(rod: &str, tip: &str) -> String {
    chain_on("", rod, tip)
}

fn inertial(mass: f64, izz: f64) -> String {
    format!(
        r#"<inertial><mass value="{mass}"/><inertia ixx="1" iyy="1" izz="{izz}" ixy="0" ixz="0" iyz="0"/></inertial>"#
    )
}

/// Bar on a ball, with a rod from its tip to the ground.
const TIED: &str = r#"<robot name="tied"><link name="ground"/><link name="bar"><inertial><origin xyz="0.5 0 0"/><mass value="2"/>
    <inertia ixx="0.01" iyy="0.2" izz="0.2" ixy="0" ixz="0" iyz="0"/></inertial></link>
    <joint name="ball" type="spherical"><parent link="ground"/><child link="bar"/></joint>
    <loop name="rod" type="distance"><predecessor link="ground"><origin xyz="0 0 1"/></predecessor>
    <successor link="bar"><origin xyz="1 0 0"/></successor><distance value="1.4142135623730951"/></loop></robot>"#;

/// Four-bar with all joints at 0 on one line: lengths of crank, coupler, rocker and ground. `turned`: angle of the crank, rad.
fn flat(turned: f64, [crank, coupler, rocker, ground]: [f64; 4]) -> String {
    let body = inertial(1.0, 0.5);
    format!(
        r#"<robot name="flat"><link name="ground"/><link name="crank">{body}</link><link name="coupler">{body}</link><link name="rocker">{body}</link>
        <joint name="crank_hinge" type="continuous" independent="true"><parent link="ground"/><child link="crank"/><origin rpy="0 0 {turned}"/>
        <axis xyz="0 0 1"/></joint>
        <joint name="pin" type="continuous"><parent link="crank"/><child link="coupler"/><origin xyz="{crank} 0 0"/><axis xyz="0 0 1"/></joint>
        <joint name="rocker_hinge" type="continuous"><parent link="ground"/><child link="rocker"/><origin xyz="{ground} 0 0"/><axis xyz="0 0 1"/></joint>
        <loop name="end" type="revolute"><predecessor link="coupler"><origin xyz="{coupler} 0 0"/></predecessor>
        <successor link="rocker"><origin xyz="{rocker} 0 0"/></successor><axis xyz="0 0 1"/></loop></robot>"#
    )
}

/// All cases.
pub fn cases() -> Vec<Case> {
    let case = |code, model, contact, pose, vary| Case { code, model, contact, pose, vary };
    let body = inertial(2.0, 1.0);
    let bodies = || chain(&body, &body);
    let on_rod =
        |code, model, pose, vary| case(code, model, "--link rod --point 0,0,0 --normal 1,0,0", pose, vary);
    let bar = |code, from: &str, to: &str| {
        let model = changed("four_bar.urdf", from, to);
        let contact = "--link coupler --point 0.35,0.1,0 --normal 0,1,0";
        case(code, model, contact, "--set crank_hinge=0.1", "crank_hinge=0.1")
    };
    let straight = |code, pose, vary| {
        let contact = "--link coupler --point 0.3,0,0 --normal 0,1,0";
        case(code, flat(0.0, [0.5, 1.0, 0.5, 1.0]), contact, pose, vary)
    };
    // A redundant loop off by a part of its length.
    let off = |code, length: &str| {
        let model =
            changed("parallelogram.urdf", "      <origin xyz=\"1", &format!("      <origin xyz=\"{length}"));
        case(code, model, "--link platform --point 0.3,0.1,0 --normal 1,0,0", "", "")
    };
    let on_tip = "--link tip --point 0.1,0,0 --normal 1,0,0";
    let rocker_pin = "<origin xyz=\"-0.25 0.6 0\"/>";
    vec![
        on_rod("outside-limits", bodies(), "--set slide=2", "slide=2"),
        Case { pose: "--set crank_hinge=100", vary: "crank_hinge=100", ..bar("many-turns", "", "") },
        Case { contact: "--link coupler --point 350,0.1,0 --normal 0,1,0", ..bar("far-point", "", "") },
        bar("drawn-open", "xyz=\"0.4 0.3 0\"", "xyz=\"0.42 0.3 0\""),
        bar("drivers-chosen", " independent=\"true\"", ""),
        bar(
            "joint-springs",
            "<axis xyz=\"0 0 1\"/>",
            "<axis xyz=\"0 0 1\"/><dynamics damping=\"0\" friction=\"0\" spring_stiffness=\"40\"/>",
        ),
        bar("inexact-loops", rocker_pin, "<origin xyz=\"-0.25 0.6 0\" rpy=\"1e-6 0 0\"/>"),
        bar("reversed-axis", rocker_pin, "<origin xyz=\"-0.25 0.6 0\" rpy=\"3.141592653589793 0 0\"/>"),
        Case {
            contact: "--link coupler --point 0.35,0.1,0 --normal 0,1,0 --guess rocker_hinge=3.5",
            ..bar("far-from-guess", "", "")
        },
        Case {
            contact: "--link coupler --point 0.35,0.4,0 --normal 0,1,0 --frame world",
            ..bar("point-converted", "", "")
        },
        case(
            "nearly-immovable",
            bodies(),
            "--link rod --point 0,0,0 --normal 1e-7,1,0",
            "--set slide=0.1",
            "slide=0.1",
        ),
        case(
            "uncertain-mass",
            bodies(),
            "--link rod --point 0,0,0 --normal 1e-9,1,0",
            "--set slide=0.1",
            "slide=0.1",
        ),
        on_rod("massless-motions", chain(&body, ""), "--set slide=0.1", "slide=0.1"),
        on_rod("undetermined-motion", chain(&body, ""), "--set slide=0.1", "slide=0.1"),
        straight("singular-pose", "--set crank_hinge=0", "crank_hinge=0"),
        straight("unclear-rank-here", "--set crank_hinge=1e-9", "crank_hinge=1e-9"),
        case(
            "driver-off-zero",
            flat(1.0, [1.0, 0.6, 0.5, 1.9]),
            "--link coupler --point 0.3,0,0 --normal 0,1,0",
            "",
            "",
        ),
        off("unclear-rank", "1.000000001"),
        off("weakly-constrained", "1.0000001"),
        off("rigid-loops", "1.001"),
        case(
            "off-target",
            TIED.to_owned(),
            "--link bar --point 1,0,0 --normal 0,1,0",
            "--set ball=0.9950041652780258,0,0.09983341664682815,0",
            "",
        ),
        case("open-gap", bodies(), "--at buffer", "--set slide=0.1", "slide=0.1"),
        case("stop-passed", bodies(), on_tip, "--travel rod:0,0,0:1,0,0=0.6", "slide=0.6"),
        case(
            "unused-guess",
            bodies(),
            "--link rod --point 0,0,0 --normal 1,0,0 --guess turn=1",
            "",
            "slide=0.1",
        ),
        case(
            "immovable-mechanism",
            bodies(),
            "--link rod --point 0,0,0 --normal 0,0,1 --against-mass 3",
            "",
            "slide=0.1",
        ),
        case(
            "point-mass-base",
            chain_on(&inertial(5.0, 0.0).replace("\"1\"", "\"0\""), &body, &body),
            "--link rod --point 0,0,0 --normal 1,0,0 --base floating",
            "",
            "slide=0.1",
        ),
        case(
            "hold-undetermined",
            chain(&body, ""),
            "--link tip --point 0.5,0,0 --normal 0,1,0 --hold rod:0,0,0:1,0,0",
            "",
            "turn=0.1",
        ),
        case(
            "hold-pulls",
            changed("rocker_bogie.urdf", "", ""),
            "--link right_middle --point 0,0,0 --normal 0,0,-1 --hold left_front:0,0,-0.1:0,0,-1",
            "",
            "left_rocker=0",
        ),
        on_rod("indefinite-mass-matrix", chain(&body, &inertial(2.0, -0.5)), "--set slide=0.1", "slide=0.1"),
    ]
}

/// Codes of the findings about a pose or a row.
pub fn codes() -> impl Iterator<Item = &'static str> {
    include_str!("../../../study/src/checks/finding_kind.rs").lines().filter_map(|line| {
        let (code, scope) = line.split_once(" = \"")?.1.split_once("\", ")?;
        (!scope.ends_with("Report;")).then_some(code)
    })
}

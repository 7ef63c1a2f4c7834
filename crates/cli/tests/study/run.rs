//! `percuss run`: a study acts like the flags; mistakes in a study are reported with their position.

use crate::support::{Scratch, Sweep, json, percuss, percuss_with_stdin, root};

/// Study of a model of the repository, with an absolute path.
fn study(model: &str, contact: &str, more: &str) -> String {
    let path = root().join(format!("models/{model}.urdf"));
    format!("{more}\n[model]\npath = {:?}\n[contact]\n{contact}\n", path.to_string_lossy())
}

const COUPLER: &str = "link = \"coupler\"\npoint = [0.35, 0.1, 0]\nnormal = [0, 1, 0]";

fn mass_of(stdout: &str) -> f64 {
    let report: serde_json::Value = serde_json::from_str(stdout).expect("JSON");
    report["effective_mass"].as_f64().unwrap_or_else(|| panic!("{report}"))
}

#[test]
fn a_study_without_a_sweep_answers_like_mass() {
    let folder = Scratch::new("run-mass");
    let cases = [
        (
            "four_bar",
            "link = \"coupler\"\npoint = [0.35, 0.1, 0]\nalong_line = { link = \"rocker\", point = [0, 0, 0] }\nturning_normal = true\nframe = \"link\"\n\
             against = \"crank\"\nestimate = { links = [\"coupler\"], point = [0.2, 0, 0], direction = [1, 0, 0] }",
            "[pose]\nset = { crank_hinge = \"20deg\" }\nguess = { rocker_hinge = \"150deg\" }\n[conditions]\n\
             armature = { crank_hinge = 0.3 }",
            "--link coupler --point 0.35,0.1,0 --frame link --against crank --set crank_hinge=20deg --guess rocker_hinge=150deg \
             --armature crank_hinge=0.3 --estimate coupler:0.2,0,0:1,0,0 --along-line rocker:0,0,0 --turning-normal",
        ),
        (
            "rocker_bogie",
            "link = \"right_middle\"\npoint = [0.5, 0, 0]\nnormal = [0, 0, -1]\nframe = \"world\"\nagainst_mass = 2",
            "[conditions]\nbase = \"floating\"\nlock = [\"left_bogie\"]\n[[hold]]\nlink = \"right_front\"\npoint = [0, 0, -0.1]\nnormal = [0, 0, -1]",
            "--link right_middle --point 0.5,0,0 --normal 0,0,-1 --frame world --against-mass 2 --lock left_bogie --base floating \
             --hold right_front:0,0,-0.1:0,0,-1",
        ),
    ];
    for (model, contact, more, flags) in cases {
        let path = folder.write("study.toml", &study(model, contact, more));
        let answer = |line: &str, format: &str| {
            let outcome = percuss(&format!("{line} --format {format}"));
            assert_eq!(outcome.code, 0, "{line}: {}", outcome.stderr);
            outcome.stdout
        };
        let flags = format!("mass {}/models/{model}.urdf {flags}", root().display());
        for format in ["text", "csv"] {
            assert_eq!(answer(&format!("run {path}"), format), answer(&flags, format), "{model}");
        }
        let json = |line: &str| {
            // Messages name keys for a study and flags otherwise.
            let mut text = answer(line, "json");
            for (key, flag) in [
                ("pose.guess", "--guess"),
                ("(hold)", "(--hold)"),
                ("contact.frame = \\\"world\\\"", "--frame world"),
            ] {
                text = text.replace(key, flag);
            }
            let mut report: serde_json::Value = serde_json::from_str(&text).expect("JSON");
            assert!(report["effective_mass"].is_f64(), "{report}");
            // The study is an additional input.
            report.as_object_mut().unwrap().remove("inputs").expect("inputs");
            report
        };
        assert_eq!(json(&format!("run {path}")), json(&flags), "{model}");
    }
    let path = folder.write("study.toml", &study("four_bar", COUPLER, ""));
    // Text is the default format; positions have several notations; stdin is read.
    assert!(percuss(&format!("run {path}")).stdout.contains("effective mass at "));
    for angle in ["0.5", "[0.5]", "\"0.5\"", "\"0.5rad\""] {
        let text = study("four_bar", COUPLER, &format!("[pose]\nset = {{ crank_hinge = {angle} }}"));
        let outcome = percuss_with_stdin("run - --format json", text.as_bytes());
        let flags = percuss(
            "mass models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --set crank_hinge=0.5 --format json",
        );
        assert_eq!(mass_of(&outcome.stdout), mass_of(&flags.stdout), "{angle}");
    }
}

#[test]
fn a_study_with_a_sweep_sweeps_and_with_a_format_does_not() {
    let rows = percuss("run models/four_bar.toml");
    let by_flags = percuss(
        "sweep models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --vary crank_hinge=0:360deg:73",
    );
    assert_eq!((rows.code, rows.stdout), (0, by_flags.stdout));
    let one = percuss("run models/four_bar.toml --format json");
    assert!((mass_of(&one.stdout) / 68.13126530612244 - 1.0).abs() < 1e-13);
    // Warnings of a model are errors with --strict, also those that the file marks as known.
    assert_eq!(percuss("run models/double_wishbone.toml --strict").code, 0);
    assert_eq!(percuss("run models/macpherson_strut.toml").code, 0);
    let strict = percuss("run models/macpherson_strut.toml --strict");
    assert_eq!((strict.code, strict.stdout.as_str()), (2, ""));
}

/// The paths of model and output are relative to the study, in any working directory.
#[test]
fn paths_are_relative_to_the_study() {
    let folder = Scratch::new("run-paths");
    std::fs::create_dir_all(folder.path("inner")).unwrap();
    std::fs::copy(root().join("models/four_bar.urdf"), folder.path("model.urdf")).unwrap();
    let text = |output: &str| {
        format!(
            "[model]\npath = \"../model.urdf\"\n[contact]\n{COUPLER}\n[sweep]\nvary = \"crank_hinge=0:90deg:4\"\noutput = \"{output}\"\n"
        )
    };
    let path = folder.write("inner/study.toml", &text("rows.csv"));
    let number_at_pose = percuss(&format!("run {path} --format text")).stdout;
    let outcome = percuss(&format!("run {path}"));
    // The rows are in the file; the main number is on stdout.
    let number = format!("{}, at the pose of the study\n", number_at_pose.lines().next().unwrap_or_default());
    let stdout = outcome.stdout.replace("\n  ", " ");
    assert_eq!((outcome.code, stdout), (0, number), "{}", outcome.stderr);
    assert_eq!(Sweep::read(&std::fs::read_to_string(folder.path("inner/rows.csv")).unwrap()).rows.len(), 4);
    for (output, words) in [
        ("rows.xls", ".csv, .xlsx, .json, .jsonl, .parquet, .svg, .png or .pdf"),
        ("none/rows.csv", "cannot be written"),
    ] {
        let path = folder.write("inner/study.toml", &text(output));
        let outcome = percuss(&format!("run {path}"));
        assert_eq!(outcome.code, 2);
        assert!(outcome.stderr.contains(words), "{}", outcome.stderr);
    }
    let path = folder.write("inner/study.toml", &text("rows.csv").replace("../model", "model"));
    let outcome = percuss(&format!("run {path}"));
    assert_eq!(outcome.code, 2);
    assert!(
        outcome.stderr.contains("model.urdf") && outcome.stderr.contains("no such file"),
        "{}",
        outcome.stderr
    );
}

/// Loops added to a plain URDF by a study equal the loops of the dialect.
#[test]
fn closures_of_a_study_are_those_of_the_model() {
    let folder = Scratch::new("run-closures");
    let cut = |name: &str| {
        let text = std::fs::read_to_string(root().join(format!("models/{name}.urdf"))).unwrap();
        let mut plain = text[text.find("<robot").unwrap()..].replace(" independent=\"true\"", "");
        while let Some(start) = plain.find("<loop ") {
            let end = start + plain[start..].find("</loop>").unwrap() + "</loop>".len();
            plain.replace_range(start..end, "");
        }
        folder.write(&format!("{name}.urdf"), &plain);
    };
    let compare = |name: &str, closures: &str, contact: &str| {
        cut(name);
        let text = format!("[model]\npath = \"{name}.urdf\"\n[contact]\n{contact}\n{closures}");
        let path = folder.write("study.toml", &text);
        let plain = percuss(&format!("run {path} --format json"));
        assert_eq!(plain.code, 0, "{}", plain.stderr);
        let report: serde_json::Value = serde_json::from_str(&plain.stdout).unwrap();
        let whole = percuss_with_stdin("run - --format json", study(name, contact, "").as_bytes());
        let expected: serde_json::Value = serde_json::from_str(&whole.stdout).unwrap();
        let (m, wanted) = (mass_of(&plain.stdout), mass_of(&whole.stdout));
        assert!((m / wanted - 1.0).abs() < 1e-12, "{name}: {m} {wanted}");
        for key in ["degrees_of_freedom", "redundant_constraints", "redundant_loops"] {
            assert_eq!(report[key], expected[key], "{name}: {key}");
        }
    };
    compare(
        "four_bar",
        "[[closure]]\nname = \"rocker_pin\"\ntype = \"continuous\"\npredecessor = \"coupler\"\npredecessor_xyz = [0.4, 0.3, 0]\n\
         successor = \"rocker\"\nsuccessor_xyz = [-0.25, 0.6, 0]\naxis = [0, 0, 1]\n",
        COUPLER,
    );
    compare(
        "double_wishbone",
        "[[closure]]\nname = \"upper_ball\"\ntype = \"spherical\"\npredecessor = \"upper_arm\"\n\
         predecessor_xyz = [-0.005, 0.27, -0.03]\nsuccessor = \"upright\"\nsuccessor_xyz = [-0.017, -0.071, 0.333]\n\
         [[closure]]\nname = \"tie_rod\"\ntype = \"distance\"\npredecessor = \"rack\"\npredecessor_xyz = [0, 0.448, 0]\n\
         successor = \"upright\"\nsuccessor_xyz = [-0.14, 0.034, 0.102]\n",
        "link = \"spring_seat\"\npoint = [0, 0, 0]\nalong_line = { link = \"spring_chassis_seat\", point = [0, 0, 0] }",
    );
    // Rotated frames: the axis is in the predecessor's frame.
    compare(
        "slider_crank",
        "[[closure]]\nname = \"wrist_pin\"\ntype = \"revolute\"\npredecessor = \"rod\"\npredecessor_xyz = [0.4, -0.3, 0]\n\
         predecessor_rpy = [1.5707963267948966, 0, 0]\nsuccessor = \"slider\"\nsuccessor_rpy = [1.5707963267948966, 0, 0]\naxis = [0, 1, 0]\n",
        "link = \"slider\"\npoint = [0, 0, 0]\nnormal = [1, 0, 0]",
    );
}

/// Two links that only mark a loop: alone an error, in a study with the loop a model.
#[test]
fn a_study_closes_a_pair_of_links_that_the_file_marks() {
    let folder = Scratch::new("run-closing-pair");
    let bar = |number: usize, at: &str, end: &str| {
        format!(
            "<link name=\"bar{number}\"><inertial><mass value=\"1\"/><inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>
             </inertial></link><link name=\"closing_pin_{number}\"/>
             <joint name=\"hinge{number}\" type=\"continuous\"><origin xyz=\"{at}\"/><parent link=\"base\"/><child link=\"bar{number}\"/>
             <axis xyz=\"0 0 1\"/></joint>
             <joint name=\"end{number}\" type=\"fixed\"><origin xyz=\"{end}\"/><parent link=\"bar{number}\"/><child link=\"closing_pin_{number}\"/></joint>"
        )
    };
    let urdf = format!(
        "<robot name=\"r\"><link name=\"base\"/>{}{}</robot>",
        bar(1, "0 0 0", "1 0 0"),
        bar(2, "1 2 0", "0 -2 0")
    );
    std::fs::write(folder.path("pair.urdf"), urdf).expect("a file");
    let alone = percuss(&format!("check {}", folder.path("pair.urdf")));
    assert_eq!(alone.code, 2, "{}", alone.stdout);
    assert!(alone.stderr.contains("[[closure]]"), "{}", alone.stderr);
    let text = "[model]\npath = \"pair.urdf\"\n[contact]\nlink = \"bar1\"\npoint = [0.5, 0, 0]\nnormal = [0, 1, 0]\n[[closure]]\n\
        name = \"pin\"\ntype = \"spherical\"\npredecessor = \"closing_pin_1\"\nsuccessor = \"closing_pin_2\"\n";
    let study = folder.path("pair.toml");
    std::fs::write(&study, text).expect("a file");
    let outcome = percuss(&format!("run {study} --format json"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    // The pin of bar 1 moves along y, that of bar 2 along x: both bars stand still.
    let report: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("JSON");
    assert_eq!(report["status"], "immovable", "{report}");
}

#[test]
fn a_study_takes_units_and_names_itself_in_errors() {
    let scratch = Scratch::new("run-units");
    let model = root().join("models/four_bar.urdf");
    let study = |contact: &str| {
        let text =
            format!("[model]\npath = {:?}\n[contact]\n{contact}\nnormal = [0, 1, 0]\n", model.display());
        scratch.write("units.toml", &text)
    };
    let plain = study("link = \"coupler\"\npoint = [0.35, 0.1, 0]\nagainst_mass = 80");
    let expected = percuss(&format!("run {plain}")).stdout;
    let typed = study("link = \"coupler\"\npoint = [\"350mm\", \"10 cm\", 0]\nagainst_mass = \"80 kg\"");
    assert_eq!(percuss(&format!("run {typed}")).stdout, expected);
    for (contact, word) in [
        ("link = \"coupler\"\npoint = [\"350mm\", \"10 kg\", 0]", "10 kg"),
        ("link = \"coupler\"\npoint = [\"350mm\", true, 0]", "a number, or text with a unit"),
        ("link = \"cupler\"\npoint = [0, 0, 0]", "did you mean \"coupler\""),
    ] {
        let outcome = percuss(&format!("run {}", study(contact)));
        assert_eq!(outcome.code, 2, "{contact}");
        assert!(outcome.stderr.starts_with(&plain) && outcome.stderr.contains(word), "{}", outcome.stderr);
    }
}

/// The JSON of a study and the JSON file of a report contain the same impact and extremes as `percuss impact` and `percuss extremes`.
#[test]
fn json_of_a_study_has_its_impact_and_its_extremes() {
    let folder = Scratch::new("run-additions");
    let model = root().join("models/planar_2r.urdf");
    let contact = "link = \"outer\"\npoint = [0.4, 0, 0]\nnormal = [0, 1, 0]\n";
    let base =
        format!("[model]\npath = '{}'\n[contact]\n{contact}[pose]\nset.elbow = \"40deg\"\n", model.display());
    let tables = "[impact]\nrestitution = 0.3\nspeed = 1\nfriction = 0.2\n[extremes]\nrange = \"shoulder=-1:1\"\nstarts = 4\n";
    let study = folder.write("study.toml", &format!("{base}{tables}"));
    let outcome = percuss(&format!("run {study} --format json"));
    assert!(outcome.code == 0 && !outcome.stderr.contains("without"), "{}", outcome.stderr);
    let mut report: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("JSON");
    assert_eq!(report["schema"], "percuss.mass/1");
    let printed = report.clone();
    let flags = format!(
        "{} --link outer --point 0.4,0,0 --normal 0,1,0 --set elbow=40deg --format json",
        model.display()
    );
    let command = json(&format!("impact {flags} --restitution 0.3 --speed 1 --friction 0.2"));
    // The study is an input file too.
    report["impact"]["mass"]["inputs"] = command["mass"]["inputs"].clone();
    assert_eq!(report["impact"], command);
    assert_eq!(report["extremes"], json(&format!("extremes {flags} --range shoulder=-1:1 --starts 4")));
    let page = folder.path("page.html");
    assert_eq!(percuss(&format!("run {study} --report {page}")).code, 0);
    let beside = std::fs::read_to_string(folder.path("page.json")).expect("the JSON beside the page");
    let beside: serde_json::Value = serde_json::from_str(&beside).expect("JSON");
    assert_eq!(beside, printed);
    let plain = folder.write("plain.toml", &base);
    let plain = json(&format!("run {plain} --format json"));
    assert!(plain.get("impact").is_none() && plain.get("extremes").is_none());
    let csv = percuss(&format!("run {study} --format csv"));
    assert!(csv.stderr.contains("without [impact], [extremes]"), "{}", csv.stderr);
}

#[test]
fn a_study_is_text() {
    let folder = Scratch::new("run-bytes");
    std::fs::write(folder.path("bytes.toml"), [0xff, 0xfe, 0x00]).unwrap();
    assert!(percuss(&format!("run {}", folder.path("bytes.toml"))).stderr.contains("not UTF-8"));
}

/// The first page of an impact in time has four quadrants; the last shows its forces. An impact in an instant has no course.
#[test]
fn the_first_page_of_an_impact_has_its_forces_over_time() {
    let folder = Scratch::new("run-quadrants");
    let model = root().join("models/suspensions/double-wishbone.toml");
    for (more, quadrants) in [("in_time = true", 4), ("", 3)] {
        let path = folder.write(
            "study.toml",
            &format!(
                "[model]\npath = {:?}\n[contact]\nat = \"bump_stop\"\n\
                 [impact]\nrestitution = 0.3\nspeed = 0.5\nstiffness = 2e5\n{more}\n",
                model.to_string_lossy()
            ),
        );
        let written = folder.path(&format!("{quadrants}.html"));
        assert_eq!(percuss(&format!("run {path} --report {written} --allow-outside")).code, 0);
        let page = std::fs::read_to_string(&written).expect("written");
        let first = page.split("class=\"quadrants\"").nth(1).and_then(|rest| rest.split("Holds for").next());
        let first = first.expect("a first page");
        assert_eq!(first.matches("<h3").count(), quadrants, "{more}");
        assert_eq!(first.contains("Over the time of the impact"), quadrants == 4, "{more}");
        assert_eq!(first.contains("time (ms)"), quadrants == 4, "{more}");
    }
}

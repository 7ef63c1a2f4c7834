//! A user's suspension from an empty folder to a report, with the messages for mistakes on the way.

use crate::support;
use crate::support::{Scratch, Sweep, done, run_in as run};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Flags of the contact between pad and bump stop, along the line between them.
fn drawn_line(side: &str) -> Vec<String> {
    let line = format!(
        "--link bump_stop_pad{side} --point 0,0,0 --along-line bump_stop{side}:0,0,0 --against chassis"
    );
    line.split(' ').map(str::to_owned).collect()
}

/// The same contact with a line that may turn.
fn stop(side: &str) -> Vec<String> {
    let mut flags = drawn_line(side);
    flags.push("--turning-normal".to_owned());
    flags
}

/// Words of a command followed by flags.
fn with<'w>(words: &[&'w str], more: &'w [String]) -> Vec<&'w str> {
    words.iter().copied().chain(more.iter().map(String::as_str)).collect()
}

const TEMPLATES: [&str; 21] = [
    "double-wishbone",
    "double-wishbone-rods",
    "macpherson-strut",
    "semi-trailing-arm",
    "three-link",
    "multi-link",
    "five-link",
    "pushrod-rocker",
    "pushrod-third-spring",
    "twist-beam",
    "swing-axle",
    "solid-axle-four-links",
    "solid-axle-panhard",
    "solid-axle-watt",
    "solid-axle-de-dion",
    "solid-axle-leaf-springs",
    "swing-arm",
    "telescopic-fork",
    "rear-four-bar",
    "rear-rocker-on-frame",
    "rear-rocker-on-arm",
];

fn side_of(template: &str) -> &'static str {
    if template.starts_with("solid") || template.ends_with("third-spring") { "_left" } else { "" }
}

/// Every template covers the travel of its wheel: the driving joint reaches no dead centre within it.
#[test]
fn wheels_of_all_templates_travel() {
    let folder = Scratch::new("own-travel");
    let listed = done(&folder, &["template", "--list"]);
    let names: Vec<&str> = listed
        .lines()
        .filter_map(|line| line.split_whitespace().next().filter(|_| !line.starts_with(' ')))
        .collect();
    assert_eq!(names, TEMPLATES);
    for template in TEMPLATES {
        let (sheet, side) = (format!("{template}.toml"), side_of(template));
        done(&folder, &["template", template, "-o", &sheet]);
        let vary = format!("travel:wheel_centre{side}:0,0,0:0,0,1=-50mm:50mm:21");
        let normal = stop(side);
        let words = with(&["sweep", &sheet, "--vary", &vary], &normal);
        let table = Sweep::read(&done(&folder, &words));
        for row in 0..table.rows.len() {
            assert_eq!(table.cell(row, "status"), "finite", "{template}, row {row}");
        }
    }
}

/// Both wheels of an axle, each with its own travel, in either order, and on a symmetric axle with exchanged sides.
#[test]
fn both_wheels_of_an_axle_travel_together() {
    let folder = Scratch::new("own-axle");
    let mass = |template: &str, side: &str, travels: [String; 2]| {
        let [first, second] = &travels;
        let contact = stop(side);
        let sheet = format!("{template}.toml");
        let words = ["mass", sheet.as_str(), "--travel", first, "--travel", second, "--format", "json"];
        let text = done(&folder, &with(&words, &contact));
        let answer: Value = serde_json::from_str(&text).expect("JSON");
        answer["effective_mass"].as_f64().expect("a number")
    };
    let mut asked = 0;
    for template in TEMPLATES.into_iter().filter(|name| name.starts_with("solid")) {
        done(&folder, &["template", template, "-o", &format!("{template}.toml")]);
        for [left, right] in
            [[20.0, -10.0], [40.0, 40.0], [-50.0, -50.0], [-40.0, 40.0], [0.0, 30.0], [60.0, 20.0]]
        {
            let travel = |side: &str, by: f64| format!("wheel_centre_{side}:0,0,0:0,0,1={by}mm");
            let one = mass(template, "_left", [travel("left", left), travel("right", right)]);
            let other = mass(template, "_left", [travel("right", right), travel("left", left)]);
            // Travels are met to 1e-12 of the size; the relative change of m̄ is at most some ten times as large.
            assert!((one / other - 1.0).abs() < 1e-9, "{template} {left} {right}: {one} and {other}");
            if ["solid-axle-four-links", "solid-axle-leaf-springs"].contains(&template) {
                let mirrored = mass(template, "_right", [travel("right", left), travel("left", right)]);
                assert!((one / mirrored - 1.0).abs() < 1e-9, "{left} {right}: {one} and {mirrored}");
            }
            asked += 1;
        }
    }
    assert_eq!(asked, 30);
}

/// Workflow of a new user: sheet, own values, model, m̄ over travel, two designs, study, report; in both conventions of axes.
#[test]
fn from_an_empty_folder_to_a_report() {
    let cars = [("double-wishbone", "iso"), ("pushrod-rocker", "adams"), ("solid-axle-panhard", "iso")];
    for (template, axes) in cars {
        // A name that needs quoting in a shell, in a URL and in a page.
        let folder = Scratch::new(&format!("own räder & {template} (1)"));
        let side = side_of(template);
        done(&folder, &["template", template, "--unit", "mm", "--axes", axes, "-o", "mine.toml"]);
        let sheet = fs::read_to_string(folder.path("mine.toml")).expect("written");
        folder.write("mine.toml", &sheet.replace("mass = 18.5", "mass = 16.25"));
        folder.write("lighter one.toml", &sheet.replace("mass = 18.5", "mass = 13.25"));
        let told = done(&folder, &["import", "mine.toml", "-o", "mine.urdf"]);
        assert!(told.contains("16.250"), "{told}");
        let contact = stop(side);
        let answer = |file: &str| {
            let words = with(&["mass", file, "--format", "json"], &contact);
            let text = done(&folder, &words);
            serde_json::from_str::<Value>(&text).expect("JSON")["effective_mass"].as_f64().expect("a number")
        };
        let mass = answer("mine.toml");
        // The file contains all digits, so model and sheet agree within rounding.
        assert!((answer("mine.urdf") / mass - 1.0).abs() < 1e-12, "{template}");
        let compared =
            done(&folder, &with(&["compare", "mine.toml", "lighter one.toml", "--format", "csv"], &contact));
        let lighter = answer("lighter one.toml");
        let words = done(&folder, &with(&["compare", "mine.toml", "lighter one.toml"], &contact));
        let words = words.split_whitespace().collect::<Vec<_>>().join(" ");
        let expected =
            format!("lighter one, compared with mine: mass of wheel{side} 13.25 kg instead of 16.25 kg");
        assert!(words.contains(&expected), "{template}: {words}");
        let percent: f64 =
            compared.lines().nth(2).unwrap().rsplit(',').next().unwrap().parse().expect("a number");
        assert!((percent - 100.0 * (lighter / mass - 1.0)).abs() < 1e-9 && percent < -1.0, "{compared}");
        done(&folder, &["init", "mine.toml", "-o", "mine study.toml"]);
        let study = fs::read_to_string(folder.path("mine study.toml")).expect("written");
        // All suggestions enabled.
        let is_key =
            |line: &str| line.starts_with("# [") || line.contains(" = ") && !line.starts_with("#   ");
        let taken: Vec<&str> = study
            .lines()
            .map(|line| match line.strip_prefix("# ") {
                Some(key) if is_key(line) => key,
                _ => line,
            })
            .collect();
        let taken = taken.join("\n").replace(":25\"", ":5\"");
        folder.write("mine study.toml", &taken);
        done(&folder, &["run", "mine study.toml", "--report", "r.html"]);
        let page = fs::read_to_string(folder.path("r.html")).expect("written");
        for words in [
            "The sweep",
            "Variants",
            "5 mm higher",
            "Sensitivities",
            "The damper",
            "The mechanism at this pose",
            "Kinematics",
            "roll centre height (mm)",
        ] {
            assert!(page.contains(words), "{template}: {words}");
        }
        // The page of all contacts: the stops first, each finding of the designs once.
        let all = taken.replace(&format!("at = \"bump_stop{side}\""), "at = \"all\"");
        // The sensitivities are those of the page of one contact.
        let all = all.replace("explain = true\n", "");
        folder.write("all contacts.toml", &all);
        done(&folder, &["run", "all contacts.toml", "--report", "all.html"]);
        let listed = fs::read_to_string(folder.path("all.html")).expect("written");
        assert!(listed.contains(&format!("those of the first contact, bump_stop{side}")), "{template}");
        let warnings: Vec<&str> = listed.split("<p class=\"warning\">").skip(1).collect();
        assert!(warnings.len() < 25, "{template}: {}", warnings.len());
        // The study is about the stop at the touch, not at the pose of the drawing.
        let words = ["mass", "mine.toml", "--at", &format!("bump_stop{side}"), "--format", "json"];
        let touch: Value = serde_json::from_str(&done(&folder, &words)).expect("JSON");
        let touch = touch["effective_mass"].as_f64().expect("a number");
        assert!(page.contains(&format!("{touch:.3}")[..5]), "{template}: {touch}");
        assert!(
            !page.contains(&*std::env::temp_dir().to_string_lossy()),
            "a page names no folder of this machine"
        );
    }
}

#[test]
fn leftover_example_values_are_reported() {
    let folder = Scratch::new("own-astray");
    let sheet = done(&folder, &["template", "double-wishbone"]);
    for (change, words) in [
        // Centimetres among millimetres; metres; a position from another vehicle.
        (
            ("com = [-5.0, 545.0, 188.0]", "com = [1345.0, 545.0, 188.0]"),
            ["centre of mass of lower_arm", "away from the joints"],
        ),
        (
            ("com = [-8.0, 705.0, 305.0]", "com = [-0.008, 0.705, 0.305]"),
            ["centre of mass of upright", "away from the joints"],
        ),
        (
            ("spring_seat = [0.0, 570.0", "spring_seat = [1350.0, 570.0"),
            ["spring_seat at", "away from the joints"],
        ),
        (("drop_link_end = [-50.0,", "drop_link_end = [1450.0,"), ["drop_link is 15", "Lengths in mm: "]),
    ] {
        let (from, to) = change;
        assert!(sheet.contains(from), "{from}");
        folder.write("my.toml", &sheet.replace(from, to));
        let outcome = run(&folder, &["import", "my.toml", "-o", "my.urdf", "--force"]);
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        for word in words.into_iter().chain(["warning"]) {
            assert!(outcome.stderr.contains(word), "{to}: {word} is not in {}", outcome.stderr);
        }
    }
    // A sheet without points gives a single error, not one per point.
    let bare: String = sheet.split("[points]\n").next().unwrap().to_owned();
    let rest = sheet.split("# Bodies:").nth(1).unwrap();
    folder.write("bare.toml", &format!("{bare}# Bodies:{rest}"));
    let outcome = run(&folder, &["import", "bare.toml", "-o", "bare.urdf"]);
    assert_eq!(outcome.code, 2);
    assert!(
        outcome.stderr.contains("points = \"FILE.csv\"") && outcome.stderr.matches("error:").count() == 1,
        "{}",
        outcome.stderr
    );
}

/// Points of a sheet in a table: columns may name a unit, the same as in the sheet or another; cells may as well.
#[test]
fn a_table_beside_a_sheet_has_its_own_unit() {
    let folder = Scratch::new("own-table");
    let sheet = done(&folder, &["template", "pushrod-rocker", "--unit", "mm"]);
    folder.write("whole.toml", &sheet);
    let (head, rest) = sheet.split_once("[points]\n").expect("points");
    let (points, bodies) = rest.split_once("# Bodies:").expect("bodies");
    let head = head.replace("build = \"left\"", "points = \"points.csv\"\nbuild = \"left\"");
    folder.write("my.toml", &format!("{head}# Bodies:{bodies}"));
    let rows: Vec<(String, Vec<f64>)> = points
        .lines()
        .filter_map(|line| line.split('#').next()?.split_once(" = "))
        .map(|(name, list)| {
            let numbers = list.trim().trim_matches(['[', ']']).split(", ");
            (name.to_owned(), numbers.map(|x| x.parse().expect("a number")).collect())
        })
        .collect();
    assert!(rows.len() > 20, "{rows:?}");
    let contact = stop("");
    let mass = |file: &str| {
        let answer = done(&folder, &with(&["mass", file, "--format", "json"], &contact));
        serde_json::from_str::<Value>(&answer).expect("JSON")["effective_mass"].as_f64().expect("a number")
    };
    let expected = mass("whole.toml");
    for (header, factor, comma) in [
        ("Punkt;x [mm];y [mm];z [mm];Bemerkung", 1.0, true),
        ("name;x [m];y [m];z [m]", 1e-3, true),
        ("name,x (cm),y (cm),z (cm),by", 0.1, false),
        ("name;x;y;z", 1.0, false),
    ] {
        let separator = if header.contains(';') { ";" } else { "," };
        let cell = |x: &f64| {
            let text = format!("{}", (x * factor * 1e9).round() / 1e9);
            if comma { text.replace('.', ",") } else { text }
        };
        let line = |(name, at): &(String, Vec<f64>)| {
            let cells: Vec<String> = [name.clone()].into_iter().chain(at.iter().map(cell)).collect();
            cells.join(separator)
        };
        let lines: Vec<String> = rows.iter().map(line).collect();
        // In the form of Excel: a byte order mark and CR LF.
        folder.write("points.csv", &format!("\u{feff}{header}\r\n{}\r\n", lines.join("\r\n")));
        // Coordinates have the same decimals; the factor of a unit rounds them.
        assert!((mass("my.toml") / expected - 1.0).abs() < 1e-12, "{header}");
    }
    folder.write("points.csv", "name;x [ell];y [ell];z [ell]\nwheel_centre;1;2;3\n");
    let outcome = run(&folder, &["import", "my.toml", "-o", "my.urdf"]);
    assert!(outcome.code == 2 && outcome.stderr.contains("\"x [ell]\""), "{}", outcome.stderr);
}

/// When the pad has passed its stop, the line between them reverses. Such a pose or row is refused, and the message
/// contains the direction of the stop.
#[test]
fn a_line_that_has_turned_is_refused() {
    let folder = Scratch::new("own-line");
    for template in ["double-wishbone", "pushrod-rocker"] {
        let sheet = format!("{template}.toml");
        done(&folder, &["template", template, "-o", &sheet]);
        let contact = drawn_line("");
        let vary = "travel:wheel_centre:0,0,0:0,0,1=0mm:100mm:26";
        let swept = run(&folder, &with(&["sweep", &sheet, "--vary", vary, "-o", "rows.json"], &contact));
        assert_eq!(swept.code, 0, "{}", swept.stderr);
        let by_line = masses_of(&folder, "rows.json");
        let row = by_line.iter().position(Option::is_none).expect("a refused row");
        let at = format!("wheel_centre:0,0,0:0,0,1={}mm", 4 * row);
        let refused = run(&folder, &with(&["mass", &sheet, "--travel", &at], &contact));
        assert_eq!(refused.code, 2, "{}", refused.stderr);
        let said = refused.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(said.contains("--along-line: the line towards \"bump_stop\""), "{said}");
        // Fixed direction from the message.
        let normal =
            said.split("--normal ").nth(1).expect("the remedy").split(' ').next().unwrap().to_owned();
        for command in [
            vec![
                "damp",
                "--mass-from",
                &sheet,
                "--stiffness",
                "2e5",
                "--restitution",
                "0.3",
                "--travel",
                &at,
            ],
            vec!["compare", &sheet, &sheet, "--travel", &at],
        ] {
            let refused = run(&folder, &with(&command, &contact));
            assert!(
                refused.code != 0 && refused.stderr.contains("--normal"),
                "{command:?}: {}",
                refused.stderr
            );
        }
        // With the fixed direction, this row has a result, and the first row agrees with the result along the line.
        let words = ["sweep", &sheet, "--link", "bump_stop_pad", "--point", "0,0,0", "--against", "chassis"];
        let fixed = ["--normal", &normal, "--normal-frame", "against", "--vary", vary, "-o", "kept.json"];
        let words: Vec<&str> = words.into_iter().chain(fixed).collect();
        let kept = run(&folder, &words);
        assert_eq!(kept.code, 0, "{}", kept.stderr);
        let kept = masses_of(&folder, "kept.json");
        assert!(kept[row].is_some(), "{kept:?}");
        // Six decimals of a unit vector.
        let ratio = kept[0].expect("as drawn") / by_line[0].expect("as drawn");
        assert!((ratio - 1.0).abs() < 1e-4, "{ratio}");
    }
}

/// m̄ of the rows of a sweep; `None` for a row with an error.
fn masses_of(folder: &Scratch, file: &str) -> Vec<Option<f64>> {
    let report = fs::read_to_string(folder.path(file)).expect("a file");
    let report: Value = serde_json::from_str(&report).expect("JSON");
    report["rows"].as_array().expect("rows").iter().map(|row| row["effective_mass"].as_f64()).collect()
}

/// Rows that a design does not reach are reported, and a comparison can be written as a workbook.
#[test]
fn comparisons_say_what_is_missing_and_are_workbooks() {
    let folder = Scratch::new("own-compared");
    for template in ["double-wishbone", "double-wishbone-rods"] {
        done(&folder, &["template", template, "-o", &format!("{template}.toml")]);
    }
    let contact = stop("");
    let words = ["compare", "double-wishbone.toml", "double-wishbone-rods.toml", "--unit", "mm"];
    let words = with(&words, &contact);
    let compare = |vary: &str, more: &[&str]| {
        let words: Vec<&str> =
            words.iter().copied().chain(["--vary", vary]).chain(more.iter().copied()).collect();
        run(&folder, &words)
    };
    let far = compare("travel:wheel_centre:0,0,0:0,0,1=0mm:900mm:4", &[]);
    assert!(far.stderr.contains("of 4 rows have no result; the first, row"), "{}", far.stderr);
    for design in ["\"double-wishbone\": ", "\"double-wishbone-rods\": "] {
        assert!(far.stderr.contains(design), "{}", far.stderr);
    }
    let near = "travel:wheel_centre:0,0,0:0,0,1=0mm:40mm:5";
    let book = compare(near, &["-o", "both.xlsx"]);
    assert!(book.code == 0 && !book.stderr.contains("no answer"), "{}", book.stderr);
    let table = Sweep::read(&compare(near, &["--format", "csv"]).stdout);
    // The file is not kept open, because Windows would not permit its replacement below.
    let bytes = fs::read(folder.path("both.xlsx")).unwrap();
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(bytes)).unwrap();
    let mut part = |name: &str| {
        let mut text = String::new();
        std::io::Read::read_to_string(&mut archive.by_name(name).unwrap(), &mut text).unwrap();
        text
    };
    let (cells, strings) = (part("xl/worksheets/sheet1.xml"), part("xl/sharedStrings.xml"));
    for (column, name) in table.header.iter().enumerate() {
        assert!(strings.contains(&format!("<t>{name}</t>")), "{name} is not in {strings}");
        for row in 0..table.rows.len() {
            let value = &table.rows[row][column];
            assert!(cells.contains(&format!("<v>{value}</v>")), "{name} of row {row}: {value}");
        }
    }
    // A table of designs alone is a workbook too, and may be replaced because percuss wrote it.
    let designs: Vec<&str> = words.iter().copied().chain(["-o", "both.xlsx"]).collect();
    done(&folder, &designs);
}

/// Invalid masses are refused with their names by every command; 0 is valid.
#[test]
fn masses_that_are_none_are_refused() {
    let folder = Scratch::new("own-masses");
    let sheet = done(&folder, &["template", "double-wishbone"]);
    folder.write("my.toml", &sheet);
    let contact = stop("");
    let mass =
        |link_mass: &str| run(&folder, &with(&["mass", "my.toml", "--link-mass", link_mass], &contact));
    for value in ["nan", "-1", "inf", "-0.001kg", "1e999", "two", "3mm", ""] {
        let outcome = mass(&format!("upright={value}"));
        assert_eq!(outcome.code, 2, "{value}: {}", outcome.stdout);
        assert!(outcome.stderr.contains("--link-mass"), "{value}: {}", outcome.stderr);
    }
    assert_eq!(mass("upright=0").code, 0);
    let head = "[model]\npath = \"my.toml\"\n[contact]\nlink = \"bump_stop_pad\"\npoint = [0, 0, 0]\n\
                along_line = { link = \"bump_stop\", point = [0, 0, 0] }\nagainst = \"chassis\"\n";
    for value in ["nan", "-1", "inf", "-inf", "\"-3 kg\"", "\"3 mm\"", "true"] {
        folder.write(
            "study.toml",
            &format!("{head}[[variant]]\nname = \"v\"\nlink_mass = {{ upright = {value} }}\n"),
        );
        let outcome = run(&folder, &["run", "study.toml"]);
        assert_eq!(outcome.code, 2, "{value}: {}", outcome.stdout);
        assert!(
            outcome.stderr.contains("study.toml:") && outcome.stderr.contains("link_mass"),
            "{value}: {}",
            outcome.stderr
        );
        folder.write("bad.toml", &sheet.replacen("mass = 5.6", &format!("mass = {value}"), 1));
        let outcome = run(&folder, &["import", "bad.toml", "-o", "bad.urdf"]);
        assert_eq!(outcome.code, 2, "{value}: {}", outcome.stdout);
        assert!(
            outcome.stderr.contains("upright") && !Path::new(&folder.path("bad.urdf")).exists(),
            "{value}: {}",
            outcome.stderr
        );
    }
}

/// Samples of hardpoints agree with the first order, even for a heavy arm: centres of mass remain in the vehicle
/// while link frames move with their points.
#[test]
fn samples_of_hardpoints_are_those_of_the_first_order() {
    let folder = Scratch::new("own-samples");
    done(&folder, &["template", "double-wishbone", "-o", "my.toml"]);
    let contact = stop("");
    for link in ["lower_arm", "upper_arm"] {
        let heavy = format!("{link}=300kg");
        let words = [
            "mass",
            "my.toml",
            "--link-mass",
            heavy.as_str(),
            "--tolerance",
            "point=0.05mm",
            "--samples",
            "500",
        ];
        let words: Vec<&str> = words.into_iter().chain(["--seed", "1", "--format", "json"]).collect();
        let answer: Value = serde_json::from_str(&done(&folder, &with(&words, &contact))).expect("JSON");
        let tolerance = &answer["tolerance"];
        let number = |value: &Value| value.as_f64().expect("a number");
        // Uniform between the limits: the root sum square divided by √3. The deviation of 500 samples has an
        // uncertainty of 3.2 %.
        let expected = number(&tolerance["root_sum_square"]) / 3f64.sqrt();
        let ratio = number(&tolerance["samples"]["standard_deviation"]) / expected;
        assert!((ratio - 1.0).abs() < 0.1, "{link}: {ratio}");
    }
}

/// An input of a study is never an output of the same study, in any part and through any link; two outputs need
/// different files.
#[cfg(unix)]
#[test]
fn no_part_of_a_study_writes_what_another_reads_or_writes() {
    let folder = Scratch::new("own-outputs");
    fs::copy(support::root().join("models/six_r_arm.urdf"), folder.path("arm.urdf")).expect("copied");
    let head = "[model]\npath = \"arm.urdf\"\n[contact]\nlink = \"tool\"\npoint = [0.08, 0, 0]\nnormal = [1, 0, 0]\n\
                [safe_speed]\nregion = \"chest\"\nforce = 280\ninput = \"rows.csv\"\nignore = [\"row\", \"status\", \"effective_mass\"]\n";
    let rows = "row,yaw,shoulder,elbow,wrist_roll,wrist_pitch,tool_roll\n0,0,0,0.5,0,0,0\n";
    // The rows look like earlier output of percuss, so their header does not protect the file.
    let rows = rows.replace("row,", "row,status,effective_mass,").replace("\n0,", "\n0,finite,1,");
    folder.write("rows.csv", &rows);
    std::os::unix::fs::symlink(folder.path("rows.csv"), folder.path("link.csv")).expect("a link");
    fs::hard_link(folder.path("rows.csv"), folder.path("hard.csv")).expect("a link");
    for output in ["rows.csv", "./rows.csv", "link.csv", "hard.csv"] {
        let study = format!("{head}[map]\ndirections = 20\noutput = \"{output}\"\n");
        folder.write("study.toml", &study);
        for force in [&["run", "study.toml"][..], &["run", "study.toml", "--force"]] {
            let outcome = run(&folder, force);
            assert_eq!(outcome.code, 2, "{output}: {}", outcome.stdout);
            assert!(outcome.stderr.contains("input file of the same run"), "{output}: {}", outcome.stderr);
        }
        assert_eq!(fs::read_to_string(folder.path("rows.csv")).expect("there"), rows, "{output}");
    }
    let study = head.split("[safe_speed]").next().unwrap();
    folder.write(
        "study.toml",
        &format!(
            "{study}[sweep]\nvary = \"elbow=0:1:5\"\noutput = \"a.svg\"\n[damping]\n\
        restitution = 0.3\nstiffness = 2e5\nspeed = 0.5\noutput = \"./a.svg\"\n"
        ),
    );
    let outcome = run(&folder, &["run", "study.toml"]);
    assert_eq!(outcome.code, 2, "{}", outcome.stdout);
    assert!(
        outcome.stderr.contains("damping.output") && outcome.stderr.contains("is sweep.output too"),
        "{}",
        outcome.stderr
    );
    assert!(!Path::new(&folder.path("a.svg")).exists());
}

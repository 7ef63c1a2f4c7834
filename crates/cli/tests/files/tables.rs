//! Tables and figures for further use: units, rounding, decimal commas, workbooks, PDF.

use crate::support;
use crate::support::{Scratch, Sweep, percuss};
use std::io::Read;

const LINE: &str = "sweep models/double_wishbone.urdf --link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 \
     --against chassis --vary travel:wheel_centre:0,0,0:0,0,1=-50mm:50mm:21";

#[test]
fn columns_name_their_units_and_numbers_are_rounded() {
    let si = Sweep::read(&percuss(LINE).stdout);
    let shown = percuss(&format!("{LINE} --unit mm,deg"));
    assert_eq!(shown.code, 0, "{}", shown.stderr);
    let table = Sweep::read(&shown.stdout);
    for name in ["travel_mm", "effective_mass_kg", "closure_residual_mm", "lower_arm_hinge [deg]"] {
        assert!(table.header.iter().any(|h| h == name), "{name} is not in {:?}", table.header);
    }
    for row in 0..21 {
        assert_eq!(table.cell(row, "travel_mm"), (-50 + 5 * row as i32).to_string());
        let (a, b) = (si.number(row, "effective_mass"), table.number(row, "effective_mass_kg"));
        assert!((a.unwrap() / b.unwrap() - 1.0).abs() < 1e-9);
        let (a, b) = (si.number(row, "lower_arm_hinge"), table.number(row, "lower_arm_hinge [deg]"));
        assert!((a.unwrap().to_degrees() - b.unwrap()).abs() < 1e-9);
    }
    // In SI, the cells have no extra digits from rounding.
    assert!(si.rows.iter().all(|row| row[1].len() <= 6), "{:?}", si.rows[9]);
    assert!(table.rows.iter().flatten().all(|cell| cell.len() <= 18), "{:?}", table.rows[3]);
}

#[test]
fn a_decimal_comma_goes_with_semicolons() {
    let comma = percuss(&format!("{LINE} --unit mm,deg --decimal comma")).stdout;
    let point = percuss(&format!("{LINE} --unit mm,deg")).stdout;
    assert_eq!(comma.lines().count(), 22);
    assert_eq!(
        comma.lines().nth(3).unwrap().replace(',', ".").replace(';', ","),
        point.lines().nth(3).unwrap()
    );
    assert_eq!(comma.lines().next().unwrap().replace(';', ","), point.lines().next().unwrap());
}

#[test]
fn a_workbook_has_the_same_table() {
    let folder = Scratch::new("workbook");
    let path = folder.path("rows.xlsx");
    let outcome = percuss(&format!("{LINE} --unit mm,deg -o {path}"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let table = Sweep::read(&percuss(&format!("{LINE} --unit mm,deg")).stdout);
    let mut archive = zip::ZipArchive::new(std::fs::File::open(&path).unwrap()).unwrap();
    let mut part = |name: &str| {
        let mut text = String::new();
        archive.by_name(name).unwrap().read_to_string(&mut text).unwrap();
        text
    };
    let (sheet, strings) = (part("xl/worksheets/sheet1.xml"), part("xl/sharedStrings.xml"));
    for name in &table.header {
        assert!(strings.contains(&format!("<t>{name}</t>")), "{name}");
    }
    for (row, column) in [(0, "travel_mm"), (7, "effective_mass_kg"), (20, "lower_arm_hinge [deg]")] {
        let value = table.cell(row, column);
        assert!(sheet.contains(&format!("<v>{value}</v>")), "{column} of row {row}: {value}");
    }
}

#[test]
fn a_figure_has_its_title_limits_series_and_names() {
    let folder = Scratch::new("figure");
    let path = folder.path("travel.svg");
    let outcome = command(&[
        LINE,
        "--estimate",
        "spindle,upright",
        "--x-limits",
        "-40:40",
        "--y-limits",
        "0:500",
        "-o",
        &path,
        "--title",
    ]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let svg = std::fs::read_to_string(&path).unwrap();
    for words in
        ["Our bump stop", "estimate: mass of spindle + upright / (motion ratio)²", ">−40<", ">500<", "(mm)"]
    {
        assert!(svg.contains(words), "{words} is not in the figure");
    }
    assert!(!svg.contains(">−50<"));
    let grid = folder.path("grid.pdf");
    let line = "sweep models/planar_2r.urdf --link forearm --point 0.5,0,0 --normal 0,0,1";
    let joints: Vec<String> = support::json("check models/planar_2r.urdf --format json")["joints"]
        .as_array()
        .unwrap()
        .iter()
        .map(|j| j["name"].as_str().unwrap().to_owned())
        .collect();
    let link = support::json("check models/planar_2r.urdf --format json")["links"][2]["name"]
        .as_str()
        .unwrap()
        .to_owned();
    let line = line.replace("forearm", &link);
    let grid_of = |count: usize, path: &str| {
        percuss(&format!(
            "{line} --vary {}=0:90deg:{count} --vary {}=10deg:80deg:15 -o {path}",
            joints[0], joints[1]
        ))
    };
    let outcome = grid_of(4, &grid);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert!(std::fs::read(&grid).unwrap().starts_with(b"%PDF"));
    let svg = folder.path("grid.svg");
    assert_eq!(grid_of(4, &svg).code, 0);
    assert!(std::fs::read_to_string(&svg).unwrap().contains(&format!("{} = 30 deg", joints[0])));
    let many = grid_of(8, &svg);
    assert!(many.code == 2 && many.stderr.contains("more than 7 values"), "{}", many.stderr);
}

fn command(words: &[&str]) -> support::Outcome {
    let split = words.iter().flat_map(|w| w.split_whitespace().collect::<Vec<_>>());
    support::run(split.chain(["Our bump stop"]))
}

#[test]
fn maps_and_comparisons_name_their_units_too() {
    let map = "map models/shaped_arm.urdf --link forearm --edge 60mm --format csv";
    let (si, mm) =
        (Sweep::read(&percuss(map).stdout), Sweep::read(&percuss(&format!("{map} --unit mm")).stdout));
    for name in ["x_mm", "world_z_mm", "normal_x", "area_mm2", "effective_mass_kg", "effective_mass_error_kg"]
    {
        assert!(mm.header.iter().any(|h| h == name), "{name} is not in {:?}", mm.header);
    }
    assert!(si.rows.len() > 20 && si.rows.len() == mm.rows.len());
    for row in 0..si.rows.len() {
        for (plain, named, factor) in [
            ("x", "x_mm", 1e3),
            ("world_y", "world_y_mm", 1e3),
            ("area", "area_mm2", 1e6),
            ("effective_mass", "effective_mass_kg", 1.0),
        ] {
            let (a, b) = (si.number(row, plain).expect("a number"), mm.number(row, named).expect("a number"));
            // Rounded to twelve digits, or to the stated error of the mass.
            assert!((a * factor - b).abs() <= 1e-9 * b.abs() + 1e-12, "{named} {row}: {a} {b}");
        }
    }
    let directions = "map models/shaped_arm.urdf --link forearm --point 0.3,0,0 --directions 20 --format csv --unit mm --decimal comma";
    let text = percuss(directions).stdout;
    assert!(text.starts_with("kind;x;y;z;world_x;world_y;world_z;status;effective_mass_kg;"), "{text}");
    let columns = |line: &str| line.split(';').count();
    assert!(
        text.lines().count() > 20 && text.lines().all(|line| columns(line) == 10 && !line.contains('.')),
        "{text}"
    );
    let compare = "compare models/suspensions/double-wishbone.toml models/suspensions/double-wishbone-rods.toml \
        --link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 --against chassis --format csv";
    let rows = format!("{compare} --vary travel:spindle:0,0,0:0,0,1=-20mm:20mm:5");
    let (si, mm) =
        (Sweep::read(&percuss(&rows).stdout), Sweep::read(&percuss(&format!("{rows} --unit mm")).stdout));
    assert_eq!(mm.header[..4], ["row", "travel_mm", "double-wishbone_kg", "double-wishbone-rods_kg"]);
    for row in 0..5 {
        assert_eq!(mm.cell(row, "travel_mm"), (-20 + 10 * row as i32).to_string());
        let (a, b) =
            (si.number(row, "double-wishbone").unwrap(), mm.number(row, "double-wishbone_kg").unwrap());
        assert!((a / b - 1.0).abs() < 1e-11, "{a} {b}");
    }
    let plain = percuss(&format!("{compare} --unit mm --decimal comma")).stdout;
    assert!(
        plain.starts_with(
            "design;status;effective_mass_kg;difference_percent\ndouble-wishbone;finite;137,8187"
        ),
        "{plain}"
    );
}

/// In the PDF of a map, the views are pixels and the words are text.
#[test]
fn a_map_as_a_pdf_has_its_views() {
    let folder = Scratch::new("map-pdf");
    let path = folder.path("map.pdf");
    let outcome = percuss(&format!("map models/shaped_arm.urdf --all --edge 50mm -o {path}"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let bytes = std::fs::read(&path).expect("written");
    let count = |word: &[u8]| bytes.windows(word.len()).filter(|window| *window == word).count();
    assert!(bytes.starts_with(b"%PDF-") && bytes.ends_with(b"made by percuss\n"));
    assert_eq!(count(b"/Subtype /Image"), 2);
    assert!(count(b"/Width 860") == 2 && count(b"/FontFile") >= 1);
    assert!(count(b"/I0 Do") == 1 && count(b"/I1 Do") == 1 && count(b"/S Do") == 1);
}

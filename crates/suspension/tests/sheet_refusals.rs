//! Errors of sheets and tables, with their positions.

use super::sheets::{Car, at_seat, sheet};
use percuss_formats::{Diagnostic, Source};
use percuss_mechanism::Severity;
use percuss_suspension::{ImportOptions, LengthUnit, VehicleAxes, import};

fn errors(name: &str, text: &str, options: &ImportOptions) -> Vec<Diagnostic> {
    match import(&Source::from_text(name, text), options) {
        Ok(imported) => panic!("read, with {:?}", imported.diagnostics),
        Err(error) => error.diagnostics.into_iter().filter(|d| d.severity == Severity::Error).collect(),
    }
}

#[track_caller]
fn refused(text: &str, code: &str, words: &[&str]) {
    let found = errors("my.toml", text, &ImportOptions::default());
    let told = found.iter().find(|d| d.code == code);
    let told = told.unwrap_or_else(|| panic!("no {code}: {found:?}"));
    for word in words {
        assert!(told.to_string().contains(word), "{word} is missing: {told}");
    }
}

/// Example with a line replaced; the old text must occur.
fn with(from: &str, to: &str) -> String {
    let text = sheet("double-wishbone");
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

#[test]
fn units_and_axes_are_said_or_refused() {
    refused(&with("unit = \"mm\"", ""), "missing-key", &["unit", "--unit", "mm"]);
    refused(&with("axes = \"iso\"", ""), "missing-key", &["axes", "--axes", "adams"]);
    refused(&with("unit = \"mm\"", "unit = \"furlong\""), "unknown-word", &["furlong", "mm"]);
    refused(&with("unit = \"mm\"", "unit = \"m\""), "wrong-unit", &["760 m", "--unit mm"]);
    refused(&with("axes = \"iso\"", "axes = \"sae\""), "unknown-word", &["sae", "adams"]);
    // The y axis of Adams points to the right: the left side has negative y.
    refused(&with("axes = \"iso\"", "axes = \"adams\""), "wrong-side", &["side", "axes"]);
    refused(&with("side = \"left\"", "side = \"right\""), "wrong-side", &["wheel"]);
    refused(&with("camber = \"0 deg\"", "camber = 0.5"), "wrong-type", &["wheel.camber", "deg"]);
    let no_unit = with("unit = \"mm\"", "");
    let flags = ImportOptions { unit: Some(LengthUnit::Millimetre), ..ImportOptions::default() };
    assert!(import(&Source::from_text("my.toml", no_unit), &flags).is_ok(), "by flag");
    let other = ImportOptions { axes: Some(VehicleAxes::Adams), ..ImportOptions::default() };
    let found = errors("my.toml", &sheet("double-wishbone"), &other);
    assert!(found.iter().any(|d| d.code == "conflict"), "{found:?}");
}

#[test]
fn a_wrong_key_or_value_is_named_with_its_line() {
    refused(&with("lower_ball =", "lower_bal ="), "missing-key", &["points.lower_ball", "lower_bal"]);
    refused(&with("# yours", "# yours\ncolour = \"red\""), "unknown-key", &["colour", "my.toml:"]);
    refused(&with("[upright]", "[upright]\nmas = 1"), "unknown-key", &["mas", "upright.mass"]);
    refused(&with("[upright]", "[uprigt]"), "missing-key", &["upright.mass", "uprigt"]);
    refused(&with("mass = 4.2", "mass = \"4.2 mm\""), "wrong-type", &["lower_arm.mass", "kg"]);
    refused(&with("mass = 4.2", "mass = nan"), "wrong-type", &["lower_arm.mass"]);
    refused(&with("mass = 4.2", "mass = -4.2"), "negative-mass", &["-4.2"]);
    refused(&with("mass = 4.2", "mass = 4.2\nmass = 4.3"), "not-toml", &["my.toml:"]);
    refused(&with("[5.0, 720.0, 180.0]", "[5.0, 720.0]"), "wrong-length", &["2 numbers", "3 expected"]);
    refused(&with("[5.0, 720.0, 180.0]", "[5.0, 720.0, inf]"), "wrong-type", &["lower_ball"]);
    refused(&with("[5.0, 720.0, 180.0]", "{ x = 5.0 }"), "wrong-type", &["lower_ball"]);
    refused(&with("\"double-wishbone\"", "\"triple\""), "unknown-template", &["triple", "swing-axle"]);
    refused(&with("on = \"lower_arm\"", "on = \"arm\""), "unknown-link", &["arm", "upright"]);
    refused(&with("spring_seat = [", "spring_set = ["), "missing-key", &["points.spring_seat"]);
    refused("unit = \"mm\"\naxes = \"iso\"\n", "missing-key", &["template", "double-wishbone"]);
    refused("x = [", "not-toml", &["my.toml:1"]);
    refused(&format!("x = {}", "[".repeat(100_000)), "not-toml", &[]);
    let many: String = (0..2000).map(|i| format!("k{i} = 1\n")).collect();
    refused(&many, "too-complex", &["1000"]);
    // The line is that of the key.
    let text = with("mass = 4.2", "mass = \"x\"");
    let line = 1 + text.lines().position(|l| l.starts_with("mass = \"x\"")).unwrap() as u32;
    let found = errors("my.toml", &text, &ImportOptions::default());
    assert_eq!(found[0].line, Some(line), "{}", found[0]);
}

#[test]
fn hardpoints_that_make_no_joint_are_refused() {
    for (point, at) in [
        ("lower_back", [180.0, 380.0, 190.0]),
        ("tie_rod_outer", [-130.0, 400.0, 240.0]),
        ("bump_stop", [5.0, 550.0, 230.0]),
        ("drop_link_end", [-70.0, 560.0, 335.0]),
    ] {
        let mut car = Car::example("double-wishbone");
        let found = errors("my.toml", &car.set(point, at).text(), &ImportOptions::default());
        assert!(found.iter().any(|d| d.code == "degenerate-geometry"), "{point}: {found:?}");
    }
}

#[test]
fn a_table_stands_beside_a_sheet_or_in_its_place() {
    let folder = std::env::temp_dir().join(format!("percuss-tables-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let car = Car::example("double-wishbone");
    let expected = at_seat(&car.mechanism(Default::default()), ["bump_stop_pad", "bump_stop"], "");
    let text = sheet("double-wishbone");
    let bodies = &text[text.find("# Bodies").unwrap()..];
    let head = text[..text.find("# Hardpoints").unwrap()].replace("# points = ", "points = ");
    let head = head.replace("   a table of names", " # a table of names");
    let rows = |separator: &str, comma: bool| -> String {
        let numbers = car.points.iter().map(|(name, at)| {
            let at = at.map(|x| format!("{x:.1}")).join(separator);
            format!("{name}{separator}{}\n", if comma { at.replace('.', ",") } else { at })
        });
        numbers.collect()
    };
    let remarked = rows(";", true).replace('\n', ";a remark\n");
    for table in [
        rows(",", false),
        format!("name,x,y,z\n{}", rows(",", false)),
        format!("Punkt;x [mm];y [mm];z [mm];Bemerkung\n# all of it\n\n{remarked}"),
        format!("\u{feff}name\tx\ty\tz\r\n{}", rows("\t", true).replace('\n', "\r\n")),
    ] {
        std::fs::write(folder.join("points.csv"), &table).unwrap();
        let with_unit = table.contains("[mm]");
        let head = if with_unit { head.replace("unit = \"mm\" ", "# ") } else { head.clone() };
        std::fs::write(folder.join("my.toml"), format!("{head}\n{bodies}")).unwrap();
        let path = folder.join("my.toml").to_string_lossy().into_owned();
        let imported = import(&Source::read(&path, 1 << 20).unwrap(), &ImportOptions::default());
        let imported = imported.unwrap_or_else(|e| panic!("{e}\n{table}"));
        let found = at_seat(&imported.mechanism, ["bump_stop_pad", "bump_stop"], "");
        // The example has a wheel with a camber of 0, like the car.
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} and {expected}");
    }
    // A finding in the table has the name and line of the table.
    std::fs::write(folder.join("points.csv"), rows(";", true).replace("5,0;720,0", "5,0;here")).unwrap();
    std::fs::write(folder.join("my.toml"), format!("{head}\n{bodies}")).unwrap();
    let path = folder.join("my.toml").to_string_lossy().into_owned();
    let error = import(&Source::read(&path, 1 << 20).unwrap(), &ImportOptions::default()).unwrap_err();
    let told = error.to_string();
    assert!(told.contains("points.csv:4") && told.contains("here"), "{told}");
    std::fs::remove_file(folder.join("points.csv")).unwrap();
    let error = import(&Source::read(&path, 1 << 20).unwrap(), &ImportOptions::default()).unwrap_err();
    assert!(error.to_string().contains("no such file"), "{error}");
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn tables_with_two_decimal_marks_or_other_defects_are_refused() {
    let head = "template;double-wishbone\nunit;mm\naxes;iso\n";
    for (rows, code) in [
        ("lower_ball;5,0;720,0;180,0\nupper_ball;1.5;2.5;3.5\n", "decimal-mark"),
        ("lower_ball;1.234,5;720,0;180,0\n", "wrong-type"),
        ("lower_ball;5;720\n", "wrong-length"),
        ("lower_ball;5;720;180\nlower_ball;5;720;180\n", "duplicate-key"),
        (";5;720;180\n", "wrong-type"),
    ] {
        let found = errors("my.csv", &format!("{head}{rows}"), &ImportOptions::default());
        assert!(found.iter().any(|d| d.code == code), "{rows}: {found:?}");
    }
    let wide = format!("{head}lower_ball{}\n", ";1".repeat(100_000));
    assert!(errors("my.csv", &wide, &ImportOptions::default()).iter().any(|d| d.code == "too-complex"));
    let long = format!("{head}{}", "a;1;2;3\n".repeat(100_000));
    assert!(!errors("my.csv", &long, &ImportOptions::default()).is_empty());
}

/// A build without the reader of workbooks names the remedy.
#[cfg(not(feature = "xlsx"))]
#[test]
fn a_workbook_is_refused_without_its_reader() {
    let source = Source { name: "my.xlsx".into(), bytes: b"PK\x03\x04".to_vec() };
    let error = import(&source, &ImportOptions::default()).unwrap_err();
    assert!(
        error.diagnostics.iter().any(|d| d.code == "not-built-in" && d.message.contains("feature")),
        "{error}"
    );
}

/// The workbook of the repository: intact, truncated, and with bytes changed.
#[cfg(feature = "xlsx")]
#[test]
fn a_workbook_is_read_and_a_broken_one_refused() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/suspensions/double-wishbone-points.xlsx");
    let bytes = std::fs::read(path).unwrap();
    let car = Car::example("double-wishbone");
    let expected = at_seat(&car.mechanism(Default::default()), ["bump_stop_pad", "bump_stop"], "");
    let toml = path.replace("-points.xlsx", "-with-table.toml");
    let imported = import(&Source::read(&toml, 1 << 20).unwrap(), &ImportOptions::default());
    let imported = imported.unwrap_or_else(|e| panic!("{e}"));
    let found = at_seat(&imported.mechanism, ["bump_stop_pad", "bump_stop"], "");
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} and {expected}");
    let options = ImportOptions {
        template: Some("double-wishbone".into()),
        axes: Some(VehicleAxes::Iso),
        ..ImportOptions::default()
    };
    let read = |bytes: Vec<u8>| import(&Source { name: "my.xlsx".into(), bytes }, &options);
    let error = read(bytes.clone()).unwrap_err();
    assert!(error.diagnostics.iter().any(|d| d.code == "missing-key"), "points without bodies: {error}");
    let mut refused = 0;
    for at in (4..bytes.len()).step_by(7) {
        refused += usize::from(read(bytes[..at].to_vec()).is_err());
        let mut changed = bytes.clone();
        changed[at] ^= 0x55;
        refused += usize::from(read(changed).is_err());
    }
    assert!(refused > 100, "{refused}");
    let huge: Vec<u8> = bytes.iter().copied().chain(std::iter::repeat_n(0, 1 << 20)).collect();
    assert!(read(huge).unwrap_err().diagnostics.iter().any(|d| d.code == "too-large-file"));
}

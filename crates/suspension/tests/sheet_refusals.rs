//! Errors of sheets and tables, with their positions.

use super::sheets::{Car, at_seat, sheet};
use percuss_formats::{Diagnostic, Source};
use percuss_mechanism::Severity;
use percuss_suspension::{ImportOptions, LengthUnit, VehicleAxes, import};

pub fn errors(name: &str, text: &str, options: &ImportOptions) -> Vec<Diagnostic> {
    match import(&Source::from_text(name, text), options) {
        Ok(imported) => panic!("read, with {:?}", imported.diagnostics),
        Err(error) => error.diagnostics.into_iter().filter(|d| d.severity == Severity::Error).collect(),
    }
}

#[track_caller]
pub fn refused(text: &str, code: &str, words: &[&str]) {
    let found = errors("my.toml", text, &ImportOptions::default());
    let told = found.iter().find(|d| d.code == code);
    let told = told.unwrap_or_else(|| panic!("no {code}: {found:?}"));
    for word in words {
        assert!(told.to_string().contains(word), "{word} is missing: {told}");
    }
}

/// Example with a line replaced; the old text must occur.
pub fn with(from: &str, to: &str) -> String {
    let text = sheet("double-wishbone");
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

#[test]
fn units_and_axes_are_said_or_refused() {
    refused(&with("unit = \"mm\"", ""), "missing-key", &["unit", "--unit", "mm"]);
    refused(&with("axes = \"iso\"", ""), "missing-key", &["axes", "--axes", "adams"]);
    refused(&with("unit = \"mm\"", "unit = \"furlong\""), "unknown-word", &["furlong", "mm"]);
    // A flag cannot override the sheet: the remedy is the key.
    refused(
        &with("unit = \"mm\"", "unit = \"m\""),
        "wrong-unit",
        &["760 m", "write unit = \"mm\" in the sheet"],
    );
    refused(&with("axes = \"iso\"", "axes = \"din\""), "unknown-word", &["din", "adams", "-x y -z"]);
    // The y axis of Adams points to the right: the left side has negative y.
    let found = with("axes = \"iso\"", "axes = \"adams\"");
    refused(&found, "wrong-side", &["y = 760 mm", "on the right", "write axes = \"iso\" (x forward"]);
    let found = with("side = \"left\"", "side = \"right\"");
    refused(&found, "wrong-side", &["y = 760 mm", "on the left", "write side = \"left\""]);
    let found = with("[0.0, 760.0, 300.0]", "[0.0, -760.0, 300.0]");
    refused(&found, "wrong-side", &["y = -760 mm", "only this point", "its y to 760"]);
    refused(&with("camber = \"0 deg\"", "camber = 0.5"), "wrong-type", &["wheel.camber", "deg"]);
    let no_unit = with("unit = \"mm\"", "");
    let flags = ImportOptions { unit: Some(LengthUnit::Millimetre), ..ImportOptions::default() };
    assert!(import(&Source::from_text("my.toml", no_unit), &flags).is_ok(), "by flag");
    let other = ImportOptions { axes: Some(VehicleAxes::ADAMS), ..ImportOptions::default() };
    let found = errors("my.toml", &sheet("double-wishbone"), &other);
    assert!(found.iter().any(|d| d.code == "conflict"), "{found:?}");
}

#[test]
fn a_wrong_key_or_value_is_named_with_its_line() {
    refused(&with("lower_ball =", "lower_bal ="), "missing-key", &["points.lower_ball", "lower_bal"]);
    // Only the misspelled key is suggested, none that the template has.
    let found = errors("my.toml", &with("lower_ball =", "lower_bal ="), &ImportOptions::default());
    assert!(found.iter().all(|d| !d.message.contains("points.upper_ball")), "{found:?}");
    let found = errors("my.toml", &with("[wheel]", "[[wheel]]"), &ImportOptions::default());
    assert!(found.iter().all(|d| !d.message.contains("did you mean \"wheel\"")), "{found:?}");
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
    let source = Source::new("my.xlsx", b"PK\x03\x04".to_vec());
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
        axes: Some(VehicleAxes::ISO),
        ..ImportOptions::default()
    };
    let read = |bytes: Vec<u8>| import(&Source::new("my.xlsx", bytes), &options);
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

/// Imports the double wishbone with this table of points, of the given file name.
fn with_table(
    file: &str,
    table: &[u8],
    keys: &str,
) -> Result<percuss_suspension::Imported, percuss_formats::LoadError> {
    static COUNT: std::sync::atomic::AtomicUsize = std::sync::atomic::AtomicUsize::new(0);
    let count = COUNT.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
    let folder = std::env::temp_dir().join(format!("percuss-table-{}-{count}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join(file), table).unwrap();
    let text = sheet("double-wishbone");
    let (head, rest) = (&text[..text.find("# Hardpoints").unwrap()], &text[text.find("# Bodies").unwrap()..]);
    let path = folder.join("my.toml");
    std::fs::write(&path, format!("{head}\npoints = \"{file}\"\n{keys}\n{rest}")).unwrap();
    let imported =
        import(&Source::read(&path.to_string_lossy(), 1 << 20).unwrap(), &ImportOptions::default());
    std::fs::remove_dir_all(folder).unwrap();
    imported
}

/// Rows of the example with the given texts for a row.
fn csv(row: impl Fn(&str, [f64; 3]) -> String) -> String {
    Car::example("double-wishbone").points.iter().map(|(name, at)| row(name, *at)).collect()
}

fn plain_row(name: &str, [x, y, z]: [f64; 3]) -> String {
    format!("{name};{x};{y};{z}\n")
}

#[track_caller]
fn at_the_stop(
    imported: Result<percuss_suspension::Imported, percuss_formats::LoadError>,
) -> Vec<Diagnostic> {
    let imported = imported.unwrap_or_else(|error| panic!("{error}"));
    let car = Car::example("double-wishbone");
    let seats = ["bump_stop_pad", "bump_stop"];
    let expected = at_seat(&car.mechanism(Default::default()), seats, "");
    let found = at_seat(&imported.mechanism, seats, "");
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} and {expected}");
    imported.diagnostics
}

#[track_caller]
fn has(found: &[Diagnostic], code: &str, words: &[&str]) {
    let told = found.iter().find(|d| d.code == code).unwrap_or_else(|| panic!("no {code}: {found:?}"));
    for word in words {
        assert!(told.message.contains(word), "{word} is missing: {told}");
    }
}

#[test]
fn titles_above_a_table_are_skipped() {
    for title in ["Front axle\n", "Front axle, state of May;;;\nlower and upper arm\n", "\"a; b\";c\n"] {
        let table = format!("{title}name;x [mm];y [mm];z [mm]\n{}", csv(plain_row));
        has(&at_the_stop(with_table("points.csv", table.as_bytes(), "")), "title-row", &["title"]);
        let table = format!("{title}{}", csv(plain_row));
        has(&at_the_stop(with_table("points.csv", table.as_bytes(), "")), "title-row", &["title"]);
    }
    // A misspelled point with numbers is no title.
    let table = format!("lower_bal;1;2;3\n{}", csv(plain_row));
    has(
        &with_table("points.csv", table.as_bytes(), "").unwrap_err().diagnostics,
        "unknown-key",
        &["lower_ball"],
    );
}

#[test]
fn windows_text_is_read_with_a_note() {
    let table = [b"# L\xe4nge in mm\n".as_slice(), csv(plain_row).as_bytes()].concat();
    has(&at_the_stop(with_table("points.csv", &table, "")), "windows-1252", &["line 1", "0xe4", "Save"]);
    let text = sheet("double-wishbone").replace("# yours", "# von J\u{f6}rg");
    let bytes: Vec<u8> = text.chars().map(|c| u8::try_from(u32::from(c)).unwrap_or(b'?')).collect();
    let found = import(&Source::new("my.toml", bytes), &ImportOptions::default());
    has(&at_the_stop(found), "windows-1252", &["0xf6"]);
}

/// A subsystem of Adams/Car: left points in its own axes and names.
#[test]
fn hardpoints_of_adams_are_read() {
    let names = [
        ("lower_front", "lca_front"),
        ("lower_back", "lca_rear"),
        ("lower_ball", "lca_outer"),
        ("upper_front", "uca_front"),
        ("upper_back", "uca_rear"),
        ("upper_ball", "uca_outer"),
        ("tie_rod_inner", "tierod_inner"),
        ("tie_rod_outer", "tierod_outer"),
        ("wheel_centre", "wheel_center"),
        ("damper_seat", "lwr_strut_mount"),
        ("damper_chassis_seat", "top_mount"),
    ];
    let adams = |name: &str| {
        names.iter().find(|(own, _)| *own == name).map_or(name.to_owned(), |(_, n)| (*n).to_owned())
    };
    let row = |name: &str, [x, y, z]: [f64; 3]| {
        format!(" '{:<28}'  'left/right'   {:.1}   {:.1}   {z:.1}\n", adams(name), 0.0 - x, 0.0 - y)
    };
    let file = format!(
        "$---MDI_HEADER\n[MDI_HEADER]\n FILE_TYPE = 'sub'\n[UNITS]\n LENGTH = 'mm'\n[HARDPOINT]\n\
         {{hardpoint_name symmetry x_value y_value z_value}}\n{} 'subframe_front' 'left/right' -1.0 -400.0 1.0\n\
         $---PARAMETER\n[PARAMETER]\n{{parameter_name symmetry}}\n 'kinematic' 'single' 1\n",
        csv(row)
    );
    let found = at_the_stop(with_table("front.sub", file.as_bytes(), ""));
    has(&found, "other-names", &["Adams/Car", "lca_front → lower_front"]);
    has(&found, "unused-points", &["subframe_front"]);
    has(&found, "adams-axes", &["x backward"]);
    let error = import(&Source::from_text("front.sub", file.clone()), &ImportOptions::default()).unwrap_err();
    has(&error.diagnostics, "missing-key", &["no masses", "points = \"front.sub\""]);
    let in_metres = file.replace("LENGTH = 'mm'", "LENGTH = 'meter'");
    assert!(with_table("front.sub", in_metres.as_bytes(), "").is_err(), "the file's unit counts");
    // The same names in a table, with prefixes and both sides.
    let row = |name: &str, [x, y, z]: [f64; 3]| {
        let name = adams(name);
        format!("hpl_{name};{x};{y};{z}\nhpr_{name};{x};{};{z}\n", -y)
    };
    let own = ["spring", "bump", "rebound", "anti_roll", "drop_link"];
    let table =
        csv(
            |name, at| {
                if own.iter().any(|o| name.starts_with(o)) { plain_row(name, at) } else { row(name, at) }
            },
        );
    let table = format!("name;loc_x;loc_y;loc_z\n{table}");
    let found = at_the_stop(with_table("points.csv", table.as_bytes(), ""));
    has(&found, "unused-points", &["right side", "hpr_lca_front"]);
}

#[test]
fn hardpoints_of_optimumk_are_read() {
    let names = [
        ("lower_front", "CHAS_LowFor_L"),
        ("lower_back", "CHAS_LowAft_L"),
        ("lower_ball", "UPRI_LowPnt_L"),
        ("upper_front", "CHAS_UppFor_L"),
        ("upper_back", "CHAS_UppAft_L"),
        ("upper_ball", "UPRI_UppPnt_L"),
        ("tie_rod_inner", "CHAS_TiePnt_L"),
        ("tie_rod_outer", "UPRI_TiePnt_L"),
    ];
    let row = |name: &str, at: [f64; 3]| {
        plain_row(names.iter().find(|(own, _)| *own == name).map_or(name, |(_, other)| other), at)
    };
    let found = at_the_stop(with_table("points.csv", csv(row).as_bytes(), ""));
    has(&found, "other-names", &["OptimumK", "UPRI_LowPnt_L → lower_ball"]);
}

/// A sheet in another unit than stated is refused, or questioned if it may be a model of a vehicle.
#[test]
fn a_sheet_in_another_unit_is_reported() {
    for unit in ["cm", "in"] {
        let found = with("unit = \"mm\"", &format!("unit = \"{unit}\""));
        refused(
            &found,
            "wrong-unit",
            &["track", "Is the file in mm (track 1520 mm)?", "write unit = \"mm\""],
        );
    }
    for unit in [LengthUnit::Centimetre, LengthUnit::Inch] {
        let options = percuss_suspension::TemplateOptions { unit, axes: VehicleAxes::ISO };
        let text = percuss_suspension::template_sheet("double-wishbone", &options).unwrap();
        let text = text.replace(&format!("unit = \"{}\"", unit.name()), "unit = \"mm\"");
        match import(&Source::from_text("my.toml", text), &ImportOptions::default()) {
            Ok(imported) => {
                has(&imported.diagnostics, "small-track", &[&format!("Is the file in {}", unit.name())])
            }
            Err(error) => panic!("{error}"),
        }
    }
}

/// The root link has the mass of the sheet, which a floating base needs.
#[test]
fn a_chassis_has_the_mass_of_the_sheet() {
    let text = with(
        "# the lower arm",
        "[chassis]\nmass = 1200\ncom = [-1200, 0, 500]\ninertia = [400, 1500, 1600]\n",
    );
    let imported = import(&Source::from_text("my.toml", text), &ImportOptions::default()).unwrap();
    let chassis = imported.mechanism.links().iter().find(|link| link.name() == "chassis").unwrap();
    let inertial = chassis.inertial().unwrap();
    assert_eq!((inertial.mass, inertial.com.x), (1200.0, -1.2));
    let text = with("# the lower arm", "[chassis]\nmass = 1200\n");
    refused(&text, "missing-key", &["chassis.com"]);
}

/// A workbook with these worksheets: name and rows in XML.
#[cfg(feature = "xlsx")]
fn workbook(sheets: &[(&str, String)]) -> Vec<u8> {
    use std::io::Write;
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let mut add = |name: &str, text: String| {
        archive.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
        archive.write_all(text.as_bytes()).unwrap();
    };
    let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
    let office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let package = "http://schemas.openxmlformats.org/package/2006";
    let list = |text: &dyn Fn(usize, &str) -> String| -> String {
        sheets.iter().enumerate().map(|(i, (name, _))| text(i + 1, name)).collect()
    };
    add("[Content_Types].xml", format!("<Types xmlns=\"{package}/content-types\"/>"));
    add(
        "_rels/.rels",
        format!(
            "<Relationships xmlns=\"{package}/relationships\"><Relationship Id=\"r\" Type=\"{office}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
        ),
    );
    let tags = list(&|i, name| format!("<sheet name=\"{name}\" sheetId=\"{i}\" r:id=\"r{i}\"/>"));
    add(
        "xl/workbook.xml",
        format!("<workbook xmlns=\"{main}\" xmlns:r=\"{office}\"><sheets>{tags}</sheets></workbook>"),
    );
    let tags = list(&|i, _| {
        format!("<Relationship Id=\"r{i}\" Type=\"{office}/worksheet\" Target=\"worksheets/sheet{i}.xml\"/>")
    });
    let styles = format!("<Relationship Id=\"s\" Type=\"{office}/styles\" Target=\"styles.xml\"/>");
    add(
        "xl/_rels/workbook.xml.rels",
        format!("<Relationships xmlns=\"{package}/relationships\">{tags}{styles}</Relationships>"),
    );
    // The cell format 1 is a date.
    add(
        "xl/styles.xml",
        format!(
            "<styleSheet xmlns=\"{main}\"><cellXfs><xf numFmtId=\"0\"/><xf numFmtId=\"14\" applyNumberFormat=\"1\"/></cellXfs></styleSheet>"
        ),
    );
    for (i, (_, rows)) in sheets.iter().enumerate() {
        add(
            &format!("xl/worksheets/sheet{}.xml", i + 1),
            format!("<worksheet xmlns=\"{main}\"><sheetData>{rows}</sheetData></worksheet>"),
        );
    }
    archive.finish().unwrap().into_inner()
}

/// Rows of a worksheet with the points of the example; the third row is lower_ball's, with `cell` in column C if given.
#[cfg(feature = "xlsx")]
fn xml_rows(cell: Option<&str>) -> String {
    let car = Car::example("double-wishbone");
    let rows = car.points.iter().enumerate().map(|(i, (name, at))| {
        let i = i + 1;
        let [x, y, z] = *at;
        let y = format!("<c r=\"C{i}\"><v>{y}</v></c>");
        let y = cell.filter(|_| name == "lower_ball").map_or(y, |cell| cell.replace("AT", &format!("C{i}")));
        format!(
            "<row r=\"{i}\"><c r=\"A{i}\" t=\"inlineStr\"><is><t>{name}</t></is></c><c r=\"B{i}\"><v>{x}</v></c>{y}\
             <c r=\"D{i}\"><v>{z}</v></c></row>"
        )
    });
    rows.collect()
}

#[cfg(feature = "xlsx")]
#[test]
fn a_worksheet_is_chosen_by_name() {
    let other =
        "<row r=\"1\"><c r=\"A1\" t=\"inlineStr\"><is><t>see the next sheet</t></is></c></row>".to_owned();
    let bytes = workbook(&[("Cover", other), ("Front", xml_rows(None)), ("Rear", xml_rows(None))]);
    for file in ["car.xlsx", "car.xlsm"] {
        at_the_stop(with_table(file, &bytes, "worksheet = \"Front\""));
    }
    let error = with_table("car.xlsx", &bytes, "worksheet = \"Fronr\"").unwrap_err();
    has(&error.diagnostics, "unknown-worksheet", &["\"Cover\", \"Front\", \"Rear\""]);
    // Without a name the first one is read, and the others are listed.
    let error = with_table("car.xlsx", &bytes, "").unwrap_err();
    has(
        &error.diagnostics,
        "first-worksheet",
        &["3 worksheets", "\"Cover\"", "\"Front\", \"Rear\"", "worksheet"],
    );
    let error = with_table("points.csv", csv(plain_row).as_bytes(), "worksheet = \"Front\"").unwrap_err();
    has(&error.diagnostics, "conflict", &["no workbook"]);
    // The option for a workbook without a sheet.
    let options = ImportOptions { worksheet: Some("Rear".into()), ..ImportOptions::default() };
    let error = import(&Source::new("car.xlsm", bytes), &options).unwrap_err();
    has(&error.diagnostics, "missing-key", &["no masses", "car.xlsm"]);
}

#[cfg(feature = "xlsx")]
#[test]
fn cells_without_a_number_are_named() {
    let row =
        1 + Car::example("double-wishbone").points.iter().position(|(name, _)| name == "lower_ball").unwrap();
    for (cell, words) in [
        ("<c r=\"AT\"><f>B1+1</f></c>", ["formula without a stored value", "save"]),
        ("<c r=\"AT\"><f>B1+1</f><v></v></c>", ["formula without a stored value", "save"]),
        ("<c r=\"AT\" s=\"1\"><v>45000</v></c>", ["date", "format the cell as a number"]),
        ("<c r=\"AT\" t=\"e\"><v>#REF!</v></c>", ["error", "#REF!"]),
    ] {
        let bytes = workbook(&[("Points", xml_rows(Some(cell)))]);
        let error = with_table("car.xlsx", &bytes, "").unwrap_err();
        has(&error.diagnostics, "wrong-type", &[&format!("cell C{row}"), words[0], words[1]]);
    }
    // A formula with a stored value is a number.
    let bytes = workbook(&[("Points", xml_rows(Some("<c r=\"AT\"><f>B1+1</f><v>720</v></c>")))]);
    at_the_stop(with_table("car.xlsx", &bytes, ""));
    // The library allocates for the largest index of a shared formula.
    let cell = "<c r=\"AT\"><f t=\"shared\" si=\"4000000000\" ref=\"A1:A2\">1</f><v>720</v></c>";
    let bytes = workbook(&[("Points", xml_rows(Some(cell)))]);
    has(&with_table("car.xlsx", &bytes, "").unwrap_err().diagnostics, "not-table", &["shared formula"]);
}

//! Units and axes of Chrono's files, and implausible points.

use super::mechanics::{place, respond};
use super::models::{all, changed, file, hmmwv};
use super::{import_text, imported, on};
use nalgebra::Vector3;
use percuss_formats::{LoadOptions, Source, load, write_urdf_with};
use percuss_mechanism::Severity;
use percuss_suspension::{ImportOptions, LengthUnit, Side, VehicleAxes};

/// Multiplies every coordinate of a file by a factor, and reverses x and y if `turned`.
fn restated(template: &str, keys: &[(&str, &str)], factor: f64, axes: VehicleAxes) -> String {
    let text = file(template, keys);
    let mut out = String::new();
    for line in text.lines() {
        let point = ["COM", "Location"].iter().any(|w| line.contains(w));
        let axis = line.contains("Universal Joint Axis");
        let Some((head, rest)) = line.split_once('[').filter(|_| point || axis) else {
            out += line;
            out.push('\n');
            continue;
        };
        let (numbers, tail) = rest.split_once(']').unwrap();
        let numbers: Vec<f64> = numbers.split(',').map(|x| x.trim().parse().unwrap()).collect();
        let at = axes.from_iso(Vector3::from_row_slice(&numbers)) * if point { factor } else { 1.0 };
        let numbers: Vec<String> = at.iter().map(|x| format!("{x:?}")).collect();
        out += &format!("{head}[{}]{tail}\n", numbers.join(", "));
    }
    out
}

#[test]
fn a_file_in_other_units_or_axes_is_refused_or_read() {
    for (template, keys) in all() {
        let mass = |text: &str, options: &ImportOptions| {
            let mechanism =
                import_text(text, options).unwrap_or_else(|e| panic!("{template}: {e}")).mechanism;
            let line = place(&mechanism, "shock_chassis_seat") - place(&mechanism, "shock_seat");
            respond(&mechanism, "shock_seat", line.normalize(), &[]).mass
        };
        // Products of inertia would change with the axes; these files give their inertias in the axes of the arms.
        let keys: Vec<_> = keys.into_iter().filter(|(key, _)| *key != "Vehicle-Frame Inertia").collect();
        let keys = if template == "DoubleWishbone" {
            changed(&keys, &[("Upright/Products of Inertia", "[0, 0, 0]")])
        } else {
            keys
        };
        let expected = mass(&file(template, &keys), &on(Side::Left));
        for (unit, factor) in [(LengthUnit::Millimetre, 1e3), (LengthUnit::Centimetre, 100.0)] {
            for axes in VehicleAxes::ALL.into_iter().filter(|axes| axes.is_in_order()) {
                let text = restated(template, &keys, factor, axes);
                let error =
                    import_text(&text, &on(Side::Left)).expect_err("a vehicle of some hundred metres");
                assert!(error.to_string().contains("--unit"), "{template}: {error}");
                let options =
                    ImportOptions { unit: Some(unit), axes: Some(axes), ..ImportOptions::default() };
                let found = mass(&text, &options);
                assert!((found / expected - 1.0).abs() < 1e-12, "{template}: {found} and {expected}");
            }
        }
        // A file in metres is refused in millimetres.
        let options = ImportOptions { unit: Some(LengthUnit::Millimetre), ..ImportOptions::default() };
        let error = import_text(&file(template, &keys), &options).expect_err("a vehicle of a millimetre");
        assert!(error.diagnostics.iter().any(|d| d.code == "wrong-unit"), "{template}: {error}");
        assert!(error.to_string().contains("--unit m"), "{template}: {error}");
    }
}

#[test]
fn a_mirrored_or_astray_ball_joint_is_doubted_with_the_lengths() {
    let codes = |keys: &[(&str, &str)]| {
        let found = imported("DoubleWishbone", keys, &on(Side::Left)).diagnostics;
        let doubts = found.into_iter().filter(|d| ["mirrored-point", "astray-point"].contains(&d.code));
        doubts.map(|d| (d.code, d.message)).collect::<Vec<_>>()
    };
    assert_eq!(codes(&hmmwv()), []);
    // Lower ball joint of the HMMWV, moved to the other side.
    let (key, value) = hmmwv().into_iter().find(|(k, _)| *k == "Lower Control Arm/Location Upright").unwrap();
    let mirrored: Vec<String> = value.split(',').map(str::to_owned).collect();
    let mirrored = format!("{}, -{}, {}", mirrored[0], mirrored[1].trim(), mirrored[2]);
    let mirrored: &'static str = mirrored.leak();
    let found = codes(&changed(&hmmwv(), &[(key, mirrored)]));
    assert!(found.iter().any(|(code, _)| *code == "mirrored-point"), "{found:?}");
    for (_, message) in &found {
        for arm in ["lower_arm", "upper_arm", "tie_rod"] {
            assert!(message.contains(arm), "{message}");
        }
    }
    let far: &'static str = value.replace("0.787", "2.787").leak();
    assert_ne!(far, value, "the figure stands in the file");
    let found = codes(&changed(&hmmwv(), &[(key, far)]));
    assert!(found.iter().any(|(code, _)| *code == "astray-point"), "{found:?}");
}

#[test]
fn what_was_imported_is_read_without_a_warning() {
    for (template, keys) in all().into_iter().chain([("DoubleWishbone", hmmwv())]) {
        for side in [Side::Left, Side::Both] {
            let imported = imported(template, &keys, &on(side));
            let urdf = write_urdf_with(&imported.mechanism, &imported.comments);
            let loaded = load(&Source::from_text("my.urdf", urdf.clone()), &LoadOptions::default()).unwrap();
            let loud: Vec<_> = loaded.diagnostics.iter().filter(|d| d.severity != Severity::Note).collect();
            assert!(loud.is_empty(), "{template}: {loud:?}");
            // Without the marks before the robot, a spindle that includes the axle gives the usual warning.
            let bare: Vec<&str> = urdf.lines().filter(|line| !line.starts_with("<?percuss-known")).collect();
            let loaded =
                load(&Source::from_text("my.urdf", bare.join("\n")), &LoadOptions::default()).unwrap();
            assert!(loaded.diagnostics.iter().any(|d| d.code == "triangle-inequality"), "{template}");
        }
    }
}

/// A hardpoint file and an equivalent sheet describe the same car.
#[test]
fn a_sheet_is_the_same_car_as_a_file_of_chrono() {
    let keys = changed(&hmmwv(), &[("Vehicle-Frame Inertia", "true")]);
    let value = |path: &str| keys.iter().find(|(key, _)| *key == path).expect(path).1;
    let mut text = String::from("template = \"double-wishbone\"\nunit = \"m\"\naxes = \"iso\"\n");
    for (point, key) in [
        ("wheel_centre", "Spindle/COM"),
        ("lower_front", "Lower Control Arm/Location Chassis Front"),
        ("lower_back", "Lower Control Arm/Location Chassis Back"),
        ("lower_ball", "Lower Control Arm/Location Upright"),
        ("upper_front", "Upper Control Arm/Location Chassis Front"),
        ("upper_back", "Upper Control Arm/Location Chassis Back"),
        ("upper_ball", "Upper Control Arm/Location Upright"),
        ("tie_rod_inner", "Tierod/Location Chassis"),
        ("tie_rod_outer", "Tierod/Location Upright"),
        ("spring_seat", "Spring/Location Arm"),
        ("spring_chassis_seat", "Spring/Location Chassis"),
    ] {
        text += &format!("points.{point} = {}\n", value(key));
    }
    for (link, section) in
        [("lower_arm", "Lower Control Arm"), ("upper_arm", "Upper Control Arm"), ("upright", "Upright")]
    {
        text += &format!("[{link}]\nmass = {}\n", value(&format!("{section}/Mass")));
        text += &format!("com = {}\n", value(&format!("{section}/COM")));
        text += &format!("inertia = {}\n", value(&format!("{section}/Moments of Inertia")));
    }
    text += &format!("[spindle]\nmass = {}\n", value("Spindle/Mass"));
    text += &format!("inertia = {}\naxle_inertia = {}\n", value("Spindle/Inertia"), value("Axle/Inertia"));
    let sheet = percuss_suspension::import(&Source::from_text("my.toml", text), &on(Side::Left))
        .unwrap_or_else(|e| panic!("{e}"))
        .mechanism;
    let chrono = imported("DoubleWishbone", &keys, &on(Side::Left)).mechanism;
    let mass = |m: &percuss_mechanism::Mechanism, locked: &[&str]| {
        let line = place(m, "spring_chassis_seat") - place(m, "spring_seat");
        respond(m, "spring_seat", line.normalize(), locked).mass
    };
    for locked in [&[][..], &["spin"]] {
        let (a, b) = (mass(&sheet, locked), mass(&chrono, locked));
        assert!((a / b - 1.0).abs() < 1e-13, "{a} and {b}");
    }
}

//! Values that another unit or another sign explains: one finding each, in the unit and the axes of the sheet.

use nalgebra::Vector3;
use percuss_formats::{Diagnostic, Source};
use percuss_mechanism::{Accept, Severity};
use percuss_suspension::{
    ImportOptions, LengthUnit, TemplateOptions, VehicleAxes, import, template_names, template_sheet,
};

/// Lines of a sheet whose key is `key`, with section and values.
fn lines_of(text: &str, key: &str) -> Vec<(usize, String, Vec<f64>)> {
    let mut section = String::new();
    let mut found = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or("").trim();
        if let Some(name) = line.strip_prefix('[') {
            section = name.trim_end_matches(']').to_owned();
        } else if let Some(value) = line.strip_prefix(key).and_then(|rest| rest.strip_prefix(" = ")) {
            let numbers = value.trim_matches(['[', ']']).split(',');
            let numbers: Vec<f64> = numbers.filter_map(|x| x.trim().parse().ok()).collect();
            found.push((i, section.clone(), numbers));
        }
    }
    found
}

/// Column of the axis along forward (0), left (1) or up (2).
fn column_of(axes: VehicleAxes, direction: usize) -> usize {
    (0..3).find(|k| axes.to_iso(Vector3::ith(*k, 1.0))[direction] != 0.0).expect("three directions")
}

/// Text with another line.
fn with_line(text: &str, at: usize, line: &str) -> String {
    let lines = text.lines().enumerate().map(|(i, old)| if i == at { line } else { old });
    lines.collect::<Vec<_>>().join("\n")
}

/// Findings about a sheet, apart from notes; an error of the import counts too.
fn findings(text: &str, options: &ImportOptions) -> Vec<Diagnostic> {
    let all = match import(&Source::from_text("my.toml", text), options) {
        Ok(imported) => imported.diagnostics,
        Err(error) => error.diagnostics,
    };
    all.into_iter().filter(|d| d.severity != Severity::Note).collect()
}

/// A centre of mass on the other side of the vehicle is one warning with the part, the key, its line and the stated value, for every
/// template in all units and axes.
#[test]
fn a_centre_of_mass_with_a_wrong_sign_is_named() {
    let mut count = 0;
    for (template, _) in template_names() {
        for unit in LengthUnit::ALL {
            for axes in VehicleAxes::ALL {
                let text = template_sheet(template, &TemplateOptions { unit, axes }).expect("a template");
                assert_eq!(findings(&text, &ImportOptions::default()).len(), 0, "{template}");
                for (at, section, com) in lines_of(&text, "com") {
                    // Parts common to both sides belong to no side.
                    let letters = ["x", "y", "z"];
                    let across = column_of(axes, 1);
                    if unit.to_metres(com[across].abs()) < 0.1 {
                        continue;
                    }
                    let mut changed = com.clone();
                    changed[across] = -com[across];
                    let line = format!("com = {changed:?}");
                    let found = findings(&with_line(&text, at, &line), &ImportOptions::default());
                    let [finding] = &found[..] else { panic!("{template} {section}: {found:?}") };
                    assert_eq!(
                        (finding.code, finding.line),
                        ("mirrored-com", Some(at as u32 + 1)),
                        "{finding}"
                    );
                    assert_eq!(finding.element, Some(format!("{section}.com")));
                    // Messages are rounded to a tenth of a millimetre.
                    let stated = finding
                        .message
                        .split(&format!("{} = ", letters[across]))
                        .nth(1)
                        .expect("the value of y");
                    let (number, rest) = stated.split_once(' ').expect("a unit");
                    let number: f64 = number.parse().expect("a number");
                    assert!(unit.to_metres((number + com[across]).abs()) < 1e-4, "{finding}");
                    assert!(rest.starts_with(&format!("{} is on the other side", unit.name())));
                    assert!(rest.contains(&format!("axes {}: {}", axes.name(), axes.words())), "{finding}");
                    count += 1;
                }
            }
        }
    }
    assert!(count > 300, "{count}");
}

/// Several parts with the same defect are one warning; other axes are named as such.
#[test]
fn wrong_signs_of_several_parts_are_one_warning() {
    let options = TemplateOptions { unit: LengthUnit::Millimetre, axes: VehicleAxes::ISO };
    let text = template_sheet("double-wishbone", &options).expect("a template");
    let mut changed = text.clone();
    for (at, _, com) in lines_of(&text, "com") {
        changed = with_line(&changed, at, &format!("com = [{}, {}, {}]", com[0], -com[1], com[2]));
    }
    let found = findings(&changed, &ImportOptions::default());
    let [finding] = &found[..] else { panic!("{found:?}") };
    for part in ["lower_arm.com (y = -545 mm)", "upright.com (y = -705 mm)", "upper_arm.com (y = -560 mm)"] {
        assert!(finding.message.contains(part), "{finding}");
    }
    let (at, ..) = lines_of(&text, "com")[0];
    let found = findings(&with_line(&text, at, "com = [-5, 545, -188]"), &ImportOptions::default());
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].message.contains("z = -188 mm has another sign"), "{found:?}");
}

/// Masses in grams are one finding, which is refused unless it is accepted; one wrong mass is a warning about its part.
#[test]
fn masses_in_grams_are_one_finding() {
    for (template, _) in template_names() {
        let text = template_sheet(template, &TemplateOptions::default()).expect("a template");
        let in_grams = |is_changed: &dyn Fn(&str) -> bool| {
            let masses = lines_of(&text, "mass").into_iter().filter(|(_, section, _)| is_changed(section));
            let changed = masses.map(|(at, _, mass)| (at, format!("mass = {}", 1000.0 * mass[0])));
            changed.fold(text.clone(), |text, (at, line)| with_line(&text, at, &line))
        };
        let found = findings(&in_grams(&|_| true), &ImportOptions::default());
        let [finding] = &found[..] else { panic!("{template}: {found:?}") };
        assert_eq!((finding.code, finding.severity), ("masses-in-grams", Severity::Error), "{template}");
        assert!(finding.message.contains(" g\"") && finding.line.is_some(), "{finding}");
        let accept = Accept { implausible_inertia: true, ..Accept::default() };
        let found = findings(&in_grams(&|_| true), &ImportOptions { accept, ..ImportOptions::default() });
        let [finding] = &found[..] else { panic!("{template}: {found:?}") };
        assert_eq!((finding.code, finding.severity), ("masses-in-grams", Severity::Warning), "{template}");
        // One part in grams.
        let found = findings(&in_grams(&|section| section == "upright"), &ImportOptions::default());
        assert!(
            found.iter().all(|d| d.code != "masses-in-grams" && d.severity == Severity::Warning),
            "{found:?}"
        );
        let has_upright = lines_of(&text, "mass").iter().any(|(_, section, _)| section == "upright");
        assert_eq!(found.iter().filter(|d| d.code == "implausible-mass").count(), usize::from(has_upright));
    }
}

/// The only finding about a sheet in which the line of a key in a section is replaced; `None` without a finding.
fn finding_with(text: &str, section: &str, key: &str, line: &str) -> Option<Diagnostic> {
    let lines = lines_of(text, key);
    let (at, ..) = lines.iter().find(|(_, of, _)| of == section).unwrap_or_else(|| panic!("{section}.{key}"));
    let mut found = findings(&with_line(text, *at, line), &ImportOptions::default());
    assert!(found.len() <= 1, "{line}: {found:?}");
    found.pop()
}

/// Values in another unit or of an impossible size are one finding with the key, the line and the value as written.
#[test]
fn values_in_other_units_are_one_finding() {
    let in_mm = TemplateOptions { unit: LengthUnit::Millimetre, axes: VehicleAxes::ADAMS };
    let text = template_sheet("double-wishbone", &in_mm).expect("a template");
    for (section, key, line, code, words) in [
        ("wheel", "camber", "camber = \"-1.5 rad\"", "implausible-angle", "\"-1.5 rad\" is -85.94°"),
        ("wheel", "camber", "camber = \"-12 deg\"", "implausible-angle", "at most 10° are usual"),
        ("wheel", "toe", "toe = \"0.2 rad\"", "implausible-angle", "\"0.2 rad\" is 11.46°"),
        ("points", "wheel_centre", "wheel_centre = [0, -76, 300]", "astray-wheel", "a track of 152 mm"),
        ("points", "wheel_centre", "wheel_centre = [0, -7600, 300]", "astray-wheel", "y = -7600 mm"),
        ("points", "wheel_centre", "wheel_centre = [0, 760, 300]", "wrong-side", "y = 760 mm"),
        ("bump_stop", "gap", "gap = 0.028", "implausible-gap", "the gap is 0.028 mm; 0.2 to 400 mm"),
        ("bump_stop", "gap", "gap = \"28 m\"", "implausible-gap", "the gap is 28000 mm"),
        ("bump_stop", "gap", "gap = -20", "overlapping-stop", "write bump_stop.gap as a positive number"),
        (
            "spring",
            "on",
            "on = \"lower_arm\"\nrate = \"85 kN/mm\"",
            "implausible-force",
            "\"85 kN/mm\"; a rate",
        ),
        ("spring", "on", "on = \"lower_arm\"\nrate = \"28 N/m\"", "implausible-force", "check its unit"),
        (
            "spring",
            "on",
            "on = \"lower_arm\"\nrate = \"28 N/mm\"\npreload = \"6100 kN\"",
            "implausible-force",
            "\"6100 kN\"; a preload",
        ),
        (
            "bump_stop",
            "on",
            "on = \"lower_arm\"\ndeflections = [0, 0.01, 0.03]\nforces = [0, 700, 5200]",
            "implausible-curve",
            "the last deflection is 0.03 mm",
        ),
        (
            "bump_stop",
            "on",
            "on = \"lower_arm\"\ndeflections = [0, 10, 30]\nforces = [0, 0.7, 5.2]",
            "implausible-curve",
            "the last force is 5.2 N",
        ),
    ] {
        let found = finding_with(&text, section, key, line).unwrap_or_else(|| panic!("{line}: no finding"));
        assert_eq!(found.code, code, "{found}");
        assert!(found.message.contains(words) && found.line.is_some(), "{line}: {found}");
    }
    for (section, key, line) in [
        ("wheel", "camber", "camber = \"-0.05 rad\""),
        ("wheel", "toe", "toe = \"-0.4 deg\""),
        ("bump_stop", "gap", "gap = 0.5"),
        ("spring", "on", "on = \"lower_arm\"\nrate = \"85 N/mm\"\npreload = 6100"),
        ("bump_stop", "on", "on = \"lower_arm\"\ndeflections = [0, 10, 30]\nforces = [0, 700, 5200]"),
    ] {
        assert_eq!(finding_with(&text, section, key, line), None, "{line}");
    }
}

/// Exchanged seats of springs and dampers, and joints far from the wheel, are one finding for every template, unit and convention of axes.
#[test]
fn astray_seats_and_joints_are_one_finding() {
    let (mut exchanged, mut arms, mut astray) = (0, 0, 0);
    for (template, _) in template_names() {
        for unit in LengthUnit::ALL {
            for axes in VehicleAxes::ALL {
                let text = template_sheet(template, &TemplateOptions { unit, axes }).expect("a template");
                let exchange = |pair: [&str; 2]| {
                    let changed = format!("\n{text}").replace(&format!("\n{} =", pair[1]), "\nOTHER =");
                    let changed = changed.replace(&format!("\n{} =", pair[0]), &format!("\n{} =", pair[1]));
                    findings(
                        &changed.replace("\nOTHER =", &format!("\n{} =", pair[0])),
                        &ImportOptions::default(),
                    )
                };
                for pair in [["spring_seat", "spring_chassis_seat"], ["damper_seat", "damper_chassis_seat"]] {
                    let found = exchange(pair);
                    let of_seats: Vec<_> = found.iter().filter(|d| d.code == "exchanged-seats").collect();
                    let [finding] = &of_seats[..] else { panic!("{template} {pair:?}: {found:?}") };
                    assert!(finding.message.contains(&format!("{} on ", pair[0])), "{finding}");
                    assert!(finding.message.contains(&format!(" {}", unit.name())), "{finding}");
                    exchanged += 1;
                }
                if ["lower_ball", "upper_ball"].iter().all(|point| text.contains(&format!("\n{point} ="))) {
                    let found = exchange(["lower_ball", "upper_ball"]);
                    assert!(found.iter().any(|d| d.code == "exchanged-arms"), "{template}: {found:?}");
                    arms += 1;
                }
                let of_ball = lines_of(&text, "lower_ball").into_iter().find(|(_, of, _)| of == "points");
                let Some((at, _, ball)) = of_ball.filter(|_| template.starts_with("double")) else {
                    continue;
                };
                let lower = unit.of_metres(0.67);
                let forward = column_of(axes, 0);
                let mut moved = ball;
                moved[forward] += lower * axes.to_iso(Vector3::ith(forward, 1.0)).x;
                let line = format!("lower_ball = {moved:?}");
                let found = findings(&with_line(&text, at, &line), &ImportOptions::default());
                assert_eq!(found.len(), 1, "{template}: {found:?}");
                assert!(
                    found[0].code == "astray-point"
                        && found[0].element.as_deref() == Some("points.lower_ball"),
                    "{found:?}"
                );
                astray += 1;
            }
        }
    }
    assert!(exchanged == 21 * 4 * 4 * 2 && arms > 0 && astray > 0, "{exchanged}, {arms}, {astray}");
}

/// A section without `on` is a warning with the assumed and the possible links, unless one body is usual.
#[test]
fn an_assumed_body_is_named() {
    for (template, _) in template_names() {
        let text = template_sheet(template, &TemplateOptions::default()).expect("a template");
        let without: String =
            text.lines().filter(|line| !line.starts_with("on = ")).map(|l| format!("{l}\n")).collect();
        let found = findings(&without, &ImportOptions::default());
        let is_usual = template.starts_with("solid")
            || template.starts_with("rear-")
            || ["swing-arm", "telescopic-fork"].contains(&template);
        if is_usual {
            assert_eq!(found.len(), 0, "{template}: {found:?}");
            continue;
        }
        assert!(found.iter().all(|d| d.code == "assumed-body") && found.len() <= 1, "{template}: {found:?}");
        if template == "double-wishbone-rods" {
            let message = &found[0].message;
            assert!(message.contains("bump_stop (upright is assumed)"), "{message}");
            assert!(message.contains("lower_back_rod"), "{message}");
        }
    }
}

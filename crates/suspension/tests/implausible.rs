//! Values that another unit or another sign explains: one finding each, in the unit and the axes of the sheet.

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
                    if unit.to_metres(com[1].abs()) < 0.1 {
                        continue;
                    }
                    let line = format!("com = [{}, {}, {}]", com[0], -com[1], com[2]);
                    let found = findings(&with_line(&text, at, &line), &ImportOptions::default());
                    let [finding] = &found[..] else { panic!("{template} {section}: {found:?}") };
                    assert_eq!(
                        (finding.code, finding.line),
                        ("mirrored-com", Some(at as u32 + 1)),
                        "{finding}"
                    );
                    assert_eq!(finding.element, Some(format!("{section}.com")));
                    // Messages are rounded to a tenth of a millimetre.
                    let stated = finding.message.split("y = ").nth(1).expect("the value of y");
                    let (number, rest) = stated.split_once(' ').expect("a unit");
                    let number: f64 = number.parse().expect("a number");
                    assert!(unit.to_metres((number + com[1]).abs()) < 1e-4, "{finding}");
                    assert!(rest.starts_with(&format!("{} has the sign of the other side", unit.name())));
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
    let options = TemplateOptions { unit: LengthUnit::Millimetre, axes: VehicleAxes::Iso };
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

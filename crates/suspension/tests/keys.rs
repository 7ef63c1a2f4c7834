//! Keys of sheets: unknown ones, and the link that a part is on.

use super::sheet_refusals::{errors, refused, with};
use super::sheets::{Car, at_seat, sheet};
use percuss_formats::Source;
use percuss_suspension::{ImportOptions, import, template_names};

/// The key `on` of a stop: with a gap and no points it names the damper or nothing; with points, a link.
#[test]
fn a_stop_is_on_a_link_with_points_or_on_the_damper_with_a_gap() {
    let text = sheet("double-wishbone");
    let without_points: Vec<&str> = text.lines().filter(|line| !line.starts_with("bump_stop")).collect();
    let without_points = without_points.join("\n");
    let with_on = |on: &str| {
        without_points.replacen("[bump_stop]\non = \"lower_arm\"", &format!("[bump_stop]\n{on}"), 1)
    };
    refused(
        &with_on("on = \"lower_arm\""),
        "missing-key",
        &["bump_stop.on", "bump_stop_pad", "on = \"damper\""],
    );
    refused(
        &with_on("on = \"dampr\""),
        "unknown-link",
        &["\"dampr\"", "did you mean \"damper\"?", "lower_arm"],
    );
    let no_gap = with_on("on = \"damper\"").replacen("gap = 30.0", "", 1);
    refused(&no_gap, "missing-key", &["bump_stop.gap", "the damper's length"]);
    refused(
        &with("[bump_stop]\non = \"lower_arm\"", "[bump_stop]\non = \"damper\""),
        "conflict",
        &["remove bump_stop_pad and bump_stop"],
    );
    refused(
        &with("[spring]\non = \"lower_arm\"", "[spring]\non = \"damper\""),
        "unknown-link",
        &["the spring", "tie_rod"],
    );
    let gap = |text: &str| {
        let imported =
            import(&Source::from_text("my.toml", text), &ImportOptions::default()).expect("a sheet");
        let contact =
            imported.mechanism.contacts().iter().find(|c| c.name() == "bump_stop").expect("the stop").clone();
        (imported.mechanism.link(contact.link()).name().to_owned(), contact.gap())
    };
    let on_damper = gap(&with_on("on = \"damper\""));
    assert_eq!(on_damper, ("damper_seat".to_owned(), Some(0.03)));
    assert_eq!(on_damper, gap(&with_on("")), "without the key");
}

/// An unknown key has its line, the nearest key, and the keys of its section with the nearest first; an unknown section, all sections.
#[test]
fn unknown_keys_list_the_known_ones() {
    let text = sheet("macpherson-strut");
    for (from, to, words) in [
        (
            "[bump_stop]\n",
            "[bump_stop]\ngapp = 20\n",
            [
                "did you mean \"bump_stop.gap\"?",
                "the keys of [bump_stop] are gap, on, direction, deflections, forces",
            ],
        ),
        (
            "[spring]\n",
            "[spring]\nstiffness = \"28 N/mm\"\n",
            ["\"spring.stiffness\"", "the keys of [spring] are on, rate, preload"],
        ),
        (
            "[spring]\n",
            "[sprung]\nmass = 300\n[spring]\n",
            ["did you mean [spring]?", "the sections are spring, points"],
        ),
        (
            "[bump_stop]\n",
            "[bumpstop]\ngap = 20\n[bump_stop]\n",
            ["did you mean [bump_stop]?", "bumpstop.gap"],
        ),
        (
            "[bump_stop]\n",
            "[contact.seat]\ngapp = 3\npoint = [0.0, 600.0, 200.0]\ndirection = [0.0, 0.0, 1.0]\non = \"lower_arm\"\n[bump_stop]\n",
            ["did you mean \"contact.seat.gap\"?", "the keys of [contact.seat] are gap"],
        ),
        ("unit = \"mm\" ", "mass_unit = \"g\"\nunit = \"mm\" ", ["the keys of the head are", "inertia_unit"]),
    ] {
        assert!(text.contains(from), "{from}");
        let changed = text.replacen(from, to, 1);
        let found = errors("my.toml", &changed, &ImportOptions::default());
        let [finding] = &found[..] else { panic!("{found:?}") };
        assert_eq!(finding.code, "unknown-key");
        let key = to.lines().find(|line| !from.contains(line) && !line.starts_with('[')).expect("a new line");
        let line = changed.lines().position(|line| line == key).expect("the line") as u32 + 1;
        assert_eq!(finding.line, Some(line), "{finding}");
        for word in words {
            assert!(finding.message.contains(word), "{word} is missing: {finding}");
        }
    }
}

/// Sections whose points are missing: a warning names the section, its keys and the points, for every part of every template.
#[test]
fn a_section_without_points_is_a_warning() {
    let bar = ["anti_roll_bar_outer", "anti_roll_bar_inner", "drop_link_bar", "drop_link_end"];
    let parts: [(&[&str], &[&str]); 5] = [
        (&["spring"], &["spring_seat", "spring_chassis_seat"]),
        (&["damper"], &["damper_seat", "damper_chassis_seat"]),
        (&["bump_stop"], &["bump_stop_pad", "bump_stop"]),
        (&["rebound_stop"], &["rebound_stop_pad", "rebound_stop"]),
        (&["anti_roll_bar", "drop_link"], &bar),
    ];
    let mut count = 0;
    for (template, _) in template_names() {
        let text = sheet(template);
        for (sections, points) in parts {
            let is_of_part = |line: &&str| {
                let key = line.split(" = ").next().unwrap_or_default();
                points.contains(&key) || key == "gap" && sections[0].ends_with("stop")
            };
            let lines: Vec<&str> = text.lines().filter(|line| !is_of_part(line)).collect();
            let cut = lines.join("\n").replacen("[spring]", "[spring]\nrate = \"35 N/mm\"", 1);
            if !sections.iter().all(|section| cut.contains(&format!("[{section}]"))) {
                continue;
            }
            let read = |text: &str| {
                let imported = import(&Source::from_text("my.toml", text), &ImportOptions::default());
                let found =
                    imported.unwrap_or_else(|error| panic!("{template} {sections:?}: {error}")).diagnostics;
                found.into_iter().find(|d| d.code == "section-without-points")
            };
            let told = read(&cut).unwrap_or_else(|| panic!("{template} {sections:?}: no warning"));
            let section = format!("[{}] (", sections[0]);
            for words in
                points.iter().copied().chain([&*section]).chain((sections[0] == "spring").then_some("rate"))
            {
                assert!(told.message.contains(words), "{template} {words}: {told}");
            }
            assert!(told.line.is_some(), "{told}");
            count += 1;
            // Without its sections the part is left out as a whole.
            let mut kept = Vec::new();
            let mut is_kept = true;
            for line in cut.lines() {
                if let Some(name) = line.strip_prefix('[') {
                    is_kept = !sections.contains(&name.trim_end_matches(']'));
                }
                kept.extend(is_kept.then_some(line));
            }
            assert!(read(&kept.join("\n")).is_none(), "{template} {sections:?}");
        }
        assert!(!import(&Source::from_text("my.toml", &*text), &ImportOptions::default()).is_ok_and(
            |imported| { imported.diagnostics.iter().any(|d| d.code == "section-without-points") }
        ));
    }
    assert!(count >= 5 * 15, "{count}");
}

/// Names of another program: one error with the nearest points by meaning, and the points that are missing.
#[test]
fn unknown_names_of_points_are_one_error() {
    let names = [
        ("lower_front", "lower_wishbone_inbord_front", "lower_front?"),
        ("lower_back", "LCA rear pivott", "lower_back?"),
        ("upper_front", "upper control arm strut, front", "upper_front?"),
        ("upper_back", "upper_wishbone_inbord_rear", "upper_back?"),
        ("upper_ball", "upper_wishbone_outboard_ears", "upper_ball?"),
        ("tie_rod_inner", "track_rod_inboard_eye", "tie_rod_inner?"),
        ("wheel_centre", "wheel center point of hub x", "wheel_centre?"),
        ("tie_rod_outer", "Q7", "\"Q7\""),
    ];
    let mut text = sheet("double-wishbone");
    for (own, other, _) in names {
        text = text.replacen(&format!("\n{own} ="), &format!("\n\"{other}\" ="), 1);
    }
    let found = errors("my.toml", &text, &ImportOptions::default());
    assert_eq!(found.len(), 1, "{found:?}");
    let told = &found[0].message;
    for (own, _, words) in names {
        assert!(told.contains(words) && told.contains(&format!("{own} (")), "{own}: {told}");
    }
    assert!(!told.contains("axle_inertia") && told.matches("lower_front").count() <= 3, "{told}");
}

/// Masses that are optional: all lengths are those of the sheet with masses, and the keys are listed.
#[test]
fn missing_masses_are_listed_if_they_are_optional() {
    let text = sheet("double-wishbone");
    let is_mass = |line: &&str| ["mass =", "com =", "inertia ="].iter().any(|key| line.starts_with(key));
    let cut: Vec<&str> = text.lines().filter(|line| !is_mass(line)).collect();
    let source = Source::from_text("my.toml", cut.join("\n"));
    let options = ImportOptions { masses_optional: true, ..ImportOptions::default() };
    let found = import(&source, &options).unwrap_or_else(|error| panic!("{error}")).understood;
    for key in ["lower_arm.mass", "upright.mass", "spindle.mass", "wheel.mass"] {
        assert!(found.missing_masses.iter().any(|missing| missing == key), "{key}");
    }
    let car = Car::example("double-wishbone");
    assert!(found.coordinates.iter().all(|(name, at)| (car.point(name).z - at[2]).abs() < 1e-15));
    assert_eq!((found.total_mass, found.wheel.and_then(|wheel| wheel.radius)), (0.0, Some(0.3)));
    assert!(
        errors("my.toml", &cut.join("\n"), &ImportOptions::default()).iter().all(|d| d.code == "missing-key")
    );
}

/// Half of the mass of a spring and of a damper moves with the moving seat.
#[test]
fn springs_and_dampers_have_masses() {
    let text = sheet("double-wishbone");
    let read = |text: &str| {
        import(&Source::from_text("my.toml", text), &ImportOptions::default())
            .unwrap_or_else(|error| panic!("{error}"))
    };
    let given = text.replacen("[spring]\n", "[spring]\nmass = \"2.4 kg\"\n", 1).replacen(
        "[damper]\n",
        "[damper]\nmass = 1.6\n",
        1,
    );
    let [without, with] = [read(&text), read(&given)];
    let seat = |name: &str| {
        let link = with.mechanism.find_link(name).expect(name);
        with.mechanism.link(link).inertial().copied().expect("a mass")
    };
    assert_eq!((seat("spring_seat").mass, seat("damper_seat").mass), (1.2, 0.8));
    let added = with.understood.total_mass - without.understood.total_mass;
    assert!((added - 2.0).abs() < 1e-12, "{added}");
    // At the seat of the spring: m̄ with the masses is at least that without, and the point mass is part of it.
    let seats = ["spring_seat", "spring_chassis_seat"];
    let [own, more] = [&without, &with].map(|imported| at_seat(&imported.mechanism, seats, ""));
    assert!(more - own > 1.2, "{own} {more}");
    let error =
        import(&Source::from_text("my.toml", given.replace("1.6", "-1.6")), &ImportOptions::default());
    assert!(error.is_err_and(|error| error.diagnostics.iter().any(|d| d.code == "bad-mass")));
}

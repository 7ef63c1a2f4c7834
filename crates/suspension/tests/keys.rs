//! Keys of sheets: unknown ones, and the link that a part is on.

use super::sheet_refusals::{errors, refused, with};
use super::sheets::sheet;
use percuss_formats::Source;
use percuss_suspension::{ImportOptions, import};

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

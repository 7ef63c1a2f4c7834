//! Studies with several contacts: one table, one figure, one report.

use crate::support::{Scratch, Sweep, json, percuss, root};
use serde_json::Value;
use std::fs;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Folder with a sheet and a study of it.
fn study(name: &str, text: &str) -> (Scratch, String) {
    let folder = Scratch::new(name);
    fs::copy(root().join("models/suspensions/double-wishbone.toml"), folder.path("car.toml"))
        .expect("copied");
    let study = folder.write("study.toml", &format!("[model]\npath = \"car.toml\"\n{text}"));
    (folder, study)
}

const TWO: &str = "[[contact]]\nat = \"bump_stop\"\n[[contact]]\nname = \"seat\"\nat = \"spring\"\n";

#[test]
fn all_contacts_of_a_model_are_those_of_the_command() {
    let (folder, study) = study("contacts-all", "[contact]\nat = \"all\"\n");
    let sheet = folder.path("car.toml");
    let of_study = json(&format!("run {study} --format json"));
    let of_command = json(&format!("mass {sheet} --at all --format json"));
    assert_eq!(of_study["schema"], "percuss.contacts/1");
    let masses = |report: &Value| -> Vec<(String, f64)> {
        let contacts = report["contacts"].as_array().expect("a list").iter();
        contacts
            .map(|contact| {
                let name = contact["name"].as_str().expect("a name").to_owned();
                (name, number(&contact["report"]["effective_mass"]))
            })
            .collect()
    };
    assert!(masses(&of_study).len() >= 5);
    // Stops are first: details and figures are about the first contact.
    let kinds: Vec<&str> = of_study["contacts"]
        .as_array()
        .expect("a list")
        .iter()
        .filter_map(|contact| contact["kind"].as_str())
        .collect();
    assert_eq!(kinds, ["stop", "stop", "spring", "damper", "patch"]);
    assert_eq!(masses(&of_study), masses(&of_command));
    let text = percuss(&format!("run {study}"));
    assert_eq!(text.code, 0, "{}", text.stderr);
    assert_eq!(text.stdout, percuss(&format!("mass {sheet} --at all")).stdout);
}

#[test]
fn contacts_sweeps_and_variants_are_one_table() {
    let variants = "[sweep]\nvary = [\"wheel-travel=-30mm:30mm:5\"]\noutput = \"all.csv\"\n\
                    [[variant]]\nname = \"light\"\nlink_mass = { lower_arm = 2.0 }\n";
    let (folder, study) = study("contacts-variants", &format!("{TWO}{variants}"));
    let sheet = folder.path("car.toml");
    let outcome = percuss(&format!("run {study}"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    for name in ["study: bump_stop", "study: seat", "light: bump_stop", "light: seat"] {
        assert!(outcome.stdout.contains(name), "{name}: {}", outcome.stdout);
    }
    let table = Sweep::read(&fs::read_to_string(folder.path("all.csv")).expect("a table"));
    for (name, flags) in [
        ("study: bump_stop", "--at bump_stop"),
        ("study: seat", "--at spring"),
        ("light: bump_stop", "--at bump_stop --link-mass lower_arm=2"),
        ("light: seat", "--at spring --link-mass lower_arm=2"),
    ] {
        let sweep =
            Sweep::read(&percuss(&format!("sweep {sheet} {flags} --wheel-travel -30mm:30mm:5")).stdout);
        for row in 0..5 {
            assert_eq!(table.number(row, name), sweep.number(row, "effective_mass"), "{name} {row}");
        }
    }
    // A design is compared with the same contact of the study.
    let expected =
        table.number(2, "light: seat").expect("finite") / table.number(2, "study: seat").expect("finite");
    let difference = table.number(2, "light: seat difference_percent").expect("finite");
    assert!((difference - 100.0 * (expected - 1.0)).abs() < 1e-9, "{difference}");
}

#[test]
fn a_report_has_a_table_and_a_figure_of_each_contact() {
    let text = format!(
        "{TWO}[damping]\nrestitution = 0.3\nstiffness = \"200 N/mm\"\n[sweep]\nvary = [\"wheel-travel=-30mm:30mm:7\"]\n"
    );
    let (folder, study) = study("contacts-report", &text);
    let outcome = percuss(&format!("run {study} --report {}", folder.path("r.html")));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let page = fs::read_to_string(folder.path("r.html")).expect("written");
    let summary = page.split("<nav>").next().expect("a summary");
    for words in [
        "m̄ at 2 contacts",
        "<td>bump_stop</td>",
        "<td>seat</td>",
        "damping, N·s/m",
        "first contact, bump_stop",
    ] {
        assert!(summary.contains(words), "{words}: {summary}");
    }
    for title in ["Effective mass at bump_stop", "Effective mass at spring"] {
        assert!(page.contains(&format!("<title>{title} — ")), "{title}");
    }
    let json = percuss(&format!("run {study} --format json"));
    assert_eq!(fs::read_to_string(folder.path("r.json")).expect("written"), json.stdout);
}

/// Both sides of a vehicle have the same curves: one figure and a sentence; a finding of all contacts is listed once.
#[test]
fn a_report_of_both_sides_has_each_figure_once() {
    let text = "[contact]\nat = \"all\"\n[sweep]\nvary = [\"heave=-20mm:20mm:5\"]\n";
    let (folder, study) = study("contacts-both", text);
    let sheet = fs::read_to_string(folder.path("car.toml")).expect("there");
    folder.write("car.toml", &sheet.replacen("build = \"left\"", "build = \"both\"", 1));
    let outcome = percuss(&format!("run {study} --report {}", folder.path("r.html")));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let page = fs::read_to_string(folder.path("r.html")).expect("written");
    for (left, right) in [("spring_left", "spring_right"), ("bump_stop_left", "bump_stop_right")] {
        assert!(page.contains(&format!("<title>Effective mass at {left} — ")), "{left}");
        assert!(!page.contains(&format!("<title>Effective mass at {right} — ")), "{right}");
        let same =
            format!("Effective mass at {right}: the same curves as in &quot;Effective mass at {left}&quot;.");
        assert!(page.contains(&same), "{same}");
    }
    let list = json(&format!("run {study} --format json"));
    let found = list["diagnostics"].as_array().expect("a list");
    // The driving joints of a suspension have no influence.
    assert!(found.iter().all(|d| d["code"] != "drivers-chosen"), "{found:?}");
}

/// Report of a study with several contacts over a sweep: one figure per contact, each finding once, no damper for a spring, and the stops
/// on the rod of the damper between its ends.
#[test]
fn the_report_of_several_contacts_has_each_figure_and_finding_once() {
    let folder = Scratch::new("contacts-report");
    let sheet = percuss("template macpherson-strut --axes adams").stdout;
    let is_kept = |line: &&str| !line.starts_with("bump_stop") && !line.starts_with("rebound_stop");
    let sheet: Vec<&str> = sheet.lines().filter(is_kept).collect();
    let mut sheet = sheet.join("\n");
    for stop in ["bump_stop", "rebound_stop"] {
        sheet = sheet.replace(&format!("[{stop}]\non = \"upright\""), &format!("[{stop}]\non = \"damper\""));
    }
    folder.write("car.toml", &sheet);
    let study = "[model]\npath = \"car.toml\"\n[contact]\nat = \"all\"\n[sweep]\nvary = \"wheel-travel=-40mm:50mm:7\"\n[damping]\n\
                 restitution = 0.3\nstiffness = 2e5\nspeed = 0.5\n";
    let study = folder.write("study.toml", study);
    let html = folder.path("page.html");
    let outcome = percuss(&format!("run {study} --report {html}"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let told = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
    for stop in ["touch of rebound_stop", "touch of bump_stop"] {
        assert_eq!(told.matches(stop).count(), 1, "{told}");
    }
    let page = std::fs::read_to_string(html).expect("a page");
    let mut warnings: Vec<&str> = page.split("<p class=\"warning\">").skip(1).collect();
    warnings.iter_mut().for_each(|text| *text = text.split("</p>").next().unwrap_or_default());
    let mut bare: Vec<&str> = warnings.iter().map(|text| text.trim_start_matches("warning: ")).collect();
    bare.iter_mut().for_each(|text| *text = text.split_once(": ").map_or(*text, |(_, message)| message));
    bare.sort_unstable();
    assert!(bare.windows(2).all(|pair| pair[0] != pair[1]), "{warnings:?}");
    assert!(page.contains("The sweep at bump_stop") && !page.contains("Effective mass of contacts"));
    for contact in ["bump_stop", "rebound_stop", "spring", "contact_patch"] {
        let title = format!(">Effective mass at {contact}<");
        assert_eq!(page.matches(&title).count(), 1, "{title}");
    }
    let dampers =
        page.split("damping, N·s/m").nth(1).and_then(|rest| rest.split("</table>").next()).expect("a table");
    assert!(
        dampers.contains("rebound_stop") && dampers.matches("none: its parts always touch").count() == 2,
        "{dampers}"
    );
    // The legend of the drawing has every name once.
    for name in ["strut_bottom on strut", "strut_bottom on upright", "strut_top"] {
        assert!(page.contains(name), "{name}");
    }
}

/// A stop that cannot be reached leaves the report of the other contacts, in both orders, and states how near it comes.
#[test]
fn an_unreachable_stop_leaves_the_report_of_the_others() {
    for order in [["rebound_stop", "bump_stop"], ["bump_stop", "rebound_stop"]] {
        let contacts: String = order.iter().map(|at| format!("[[contact]]\nat = \"{at}\"\n")).collect();
        let (folder, study) = study(
            "contacts-unreachable",
            &format!("{contacts}[sweep]\nvary = \"wheel-travel=-30mm:30mm:5\"\ntitle = \"My car\"\n"),
        );
        let sheet = fs::read_to_string(folder.path("car.toml")).expect("there");
        folder.write("car.toml", &sheet.replace("gap = 25.0", "gap = 125.0"));
        let html = folder.path("r.html");
        let outcome = percuss(&format!("run {study} --report {html}"));
        assert_eq!(outcome.code, 0, "{order:?}: {}", outcome.stderr);
        let told = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        for words in ["closes by", "mm remain"] {
            assert!(told.contains(words), "{order:?}: {words}: {told}");
        }
        let page = fs::read_to_string(html).expect("written");
        for words in [
            "cannot be reached: it closes by",
            "first contact with a result, bump_stop",
            "My car: bump_stop",
            "My car: rebound_stop",
        ] {
            assert!(page.contains(words), "{order:?}: {words}");
        }
    }
}

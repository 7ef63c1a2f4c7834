//! Measurements stated by the exports: within the stated bounds, equal to the documentation, and used for refusals.

use percuss_contact::CompliantContact;
use percuss_contact::exports::{Export, ExportError, Options, Request, Tool};

const STIFFNESS: f64 = 1e5;

fn request(restitution: f64) -> Request<'static> {
    Request::new(CompliantContact::new(2.0, STIFFNESS).unwrap(), restitution).at(0.4)
}

fn number_of(export: &Export, name: &str) -> f64 {
    export.number(name).unwrap_or_else(|| panic!("{}: no {name}", export.tool))
}

#[test]
fn measurements_are_within_the_stated_bound() {
    for tool in Tool::ALL {
        for (at, e) in [0.2, 0.5, 0.8].into_iter().enumerate() {
            for measured in tool.facts().measured {
                let Some(worst) = measured.worst[at] else { continue };
                let contact = CompliantContact::new(2.0, STIFFNESS).unwrap();
                let exponent = if tool == Tool::OPENSIM { 1.5 } else { 1.0 };
                let contact = contact.with_exponent(exponent).unwrap();
                let options = Options {
                    own_mass: Some(1.5),
                    other_own_mass: Some(3.0),
                    closed_loops: measured.scenes.starts_with("four-bar"),
                    ..Options::default()
                };
                let request = Request { options, ..Request::new(contact, e).at(0.3) };
                let bound = tool.export(&request).unwrap().error_bound.unwrap_or(1e-3);
                assert!(worst <= bound * 1.001, "{tool} {e}: {worst:e}, bound {bound:e}");
            }
        }
    }
}

/// The first table of docs/reference/SIMULATORS.md, generated from the facts of the exports.
#[test]
fn the_table_of_simulators_agrees_with_the_exports() {
    let mut table = String::from(
        "| simulator (`--for`) | run in | restitution within (e = 0.2, 0.5, 0.8) | of | watch for |\n|---|---|---|---|---|\n",
    );
    for tool in Tool::ALL {
        let facts = tool.facts();
        let name = format!("{} (`{}`)", facts.title, facts.name);
        if facts.measured.is_empty() {
            table += &format!("| {name} | not measured | | | {} |\n", facts.caution);
        }
        for (i, measured) in facts.measured.iter().enumerate() {
            let name = if i == 0 { name.as_str() } else { "" };
            let caution = if i == 0 { facts.caution } else { "" };
            let solver =
                if measured.solver.is_empty() { String::new() } else { format!(", {}", measured.solver) };
            let day = measured.by_hand.map_or_else(String::new, |day| format!(" (by hand, {day})"));
            let worst = measured.worst.map(|w| w.map_or_else(|| "refused".into(), |w| format!("{w:.1e}")));
            table += &format!(
                "| {name} | {}{solver}{day} | {} | {} | {caution} |\n",
                measured.engine,
                worst.join(", "),
                measured.scenes
            );
        }
    }
    let mut two_sides = String::from("| simulator | of the two sides' values it makes |\n|---|---|\n");
    for tool in Tool::ALL {
        two_sides += &format!("| {} | {} |\n", tool.facts().title, tool.facts().combines);
    }
    let page = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference/SIMULATORS.md");
    let text = std::fs::read_to_string(page).expect("the page");
    for table in [table, two_sides] {
        // Markdown would read an unescaped `<` as HTML.
        let table = table.replace('<', "\\<");
        assert!(text.contains(&table), "docs/reference/SIMULATORS.md should have this table:\n{table}");
    }
    for tool in Tool::ALL {
        assert!(!tool.facts().caution.is_empty() && !tool.facts().combines.is_empty(), "{tool}");
    }
}

#[test]
fn gazebo_sets_e_on_one_side_and_refuses_slow_rebounds() {
    let export = Tool::GAZEBO.export(&request(0.5)).unwrap();
    assert_eq!(number_of(&export, "restitution_coefficient"), 0.5);
    // DART multiplies the restitutions of the two sides.
    assert_eq!(number_of(&export, "other_restitution_coefficient"), 1.0);
    let text = &export.snippets[0].text;
    assert!(text.contains("<restitution_coefficient>0.5<") && text.contains("<restitution_coefficient>1.0<"));
    for (e, speed, is_supported) in [
        (0.2, 0.3, false),
        (0.2, 0.5, false),
        (0.2, 0.51, true),
        (0.0, 0.3, true),
        (1.0, 99.0, true),
        (1.0, 101.0, false),
    ] {
        match Tool::GAZEBO.export(&request(e).at(speed)) {
            Ok(_) => assert!(is_supported, "{e} at {speed}"),
            Err(error) => {
                assert!(
                    !is_supported && matches!(error, ExportError::Unreachable { .. }),
                    "{e} at {speed}: {error}"
                );
            }
        }
    }
    let export = Tool::GAZEBO.export(&Request { speed: None, ..request(0.5) }).unwrap();
    assert!(export.error_bound.is_none() && export.missing.len() == 1);
}

#[test]
fn closed_loops_are_refused_or_bounded_as_measured() {
    let with = |tool: Tool, closed_loops: bool| {
        let options = Options {
            own_mass: Some(1.5),
            free_mass: Some(2.0),
            constrained: true,
            closed_loops,
            ..Options::default()
        };
        let contact = CompliantContact::new(2.0, STIFFNESS).unwrap();
        let contact = contact.with_exponent(if tool == Tool::OPENSIM { 1.5 } else { 1.0 }).unwrap();
        tool.export(&Request { options, ..Request::new(contact, 0.5).at(0.4) })
    };
    for tool in [Tool::RAPIER, Tool::GAZEBO] {
        assert!(with(tool, false).is_ok());
        let error = with(tool, true).unwrap_err();
        assert!(matches!(error, ExportError::NoLoop { .. }), "{error}");
    }
    for tool in [Tool::DART, Tool::JOLT, Tool::NEWTON, Tool::PHYSX] {
        assert!(with(tool, false).unwrap().error_bound.is_some());
        assert!(with(tool, true).unwrap().error_bound.is_none(), "{tool}");
    }
    assert_eq!(number_of(&with(Tool::JOLT, false).unwrap(), "mNumVelocitySteps"), 50.0);
    assert_eq!(number_of(&with(Tool::JOLT, true).unwrap(), "mNumVelocitySteps"), 1000.0);
    for tool in [Tool::BULLET, Tool::CHRONO, Tool::OPENSIM, Tool::EXUDYN] {
        let (tree, loops) = (with(tool, false).unwrap(), with(tool, true).unwrap());
        assert_eq!((tree.error_bound, tree.parameters), (loops.error_bound, loops.parameters), "{tool}");
        assert!(loops.assumptions.iter().any(|text| text.starts_with("Closed loops: ")), "{tool}");
    }
}

//! Pages of the book and the README agree with the commands.

use crate::support::root;

crate::pages! {
    below "README.md" "crates/cli/README.md" "docs":
    readme "README.md",
    readme_of_the_package "crates/cli/README.md",
    introduction "docs/INTRODUCTION.md",
    explanation_assembly_modes "docs/explanation/ASSEMBLY_MODES.md",
    explanation_certificates "docs/explanation/CERTIFICATES.md",
    explanation_effective_mass "docs/explanation/EFFECTIVE_MASS.md",
    explanation_figure3 "docs/explanation/FIGURE3.md",
    howto_bushes "docs/howto/BUSHES.md",
    howto_code "docs/howto/CODE.md",
    howto_designs "docs/howto/DESIGNS.md",
    howto_impact "docs/howto/IMPACT.md",
    howto_impact_recipes "docs/howto/IMPACT_RECIPES.md",
    howto_kinematics "docs/howto/KINEMATICS.md",
    howto_loops "docs/howto/LOOPS.md",
    howto_maps "docs/howto/MAPS.md",
    howto_reports "docs/howto/REPORTS.md",
    howto_suspensions "docs/howto/SUSPENSIONS.md",
    reference_commands "docs/reference/COMMANDS.md",
    reference_outputs "docs/reference/OUTPUTS.md",
    reference_simulators "docs/reference/SIMULATORS.md",
    reference_studies "docs/reference/STUDIES.md",
    reference_suspensions "docs/reference/SUSPENSIONS.md",
    tutorials_robot_arm "docs/tutorials/ROBOT_ARM.md",
    tutorials_simulator "docs/tutorials/SIMULATOR.md",
    tutorials_suspension "docs/tutorials/SUSPENSION.md",
}

/// The XML on the page equals the model, except for white space.
#[test]
fn the_page_quotes_the_model() {
    let squeezed = |text: &str| text.split_whitespace().collect::<String>();
    let page = std::fs::read_to_string(root().join("docs/explanation/FIGURE3.md")).expect("the page");
    let model =
        std::fs::read_to_string(root().join("models/massless_arm_suspension.urdf")).expect("the model");
    let quoted = page.split("```xml\n").nth(1).and_then(|t| t.split("```").next()).expect("some XML");
    for element in quoted.split_inclusive('>').map(squeezed).filter(|e| !e.is_empty()) {
        assert!(squeezed(&model).contains(&element), "{element}");
    }
}

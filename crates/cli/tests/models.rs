//! The models we ship: every command in their heads gives the closed form that their comments state.

mod support;

use support::{percuss, root};

#[test]
fn every_model_answers_with_its_closed_form() {
    let mut commands = 0;
    let mut models = 0;
    for entry in std::fs::read_dir(root().join("models")).expect("models are shipped") {
        let path = entry.expect("a readable entry").path();
        let text = std::fs::read_to_string(&path).expect("a text file");
        assert!(text.contains("Closed form"), "{} states no closed form", path.display());
        let found: Vec<&str> =
            text.split("<?percuss ").skip(1).map(|rest| rest.split("?>").next().unwrap_or("")).collect();
        assert!(!found.is_empty(), "{} shows no command", path.display());
        for command in &found {
            assert!(command.contains("--expect"), "{command}");
            // 1e-12: a closed form of a few operations, and the digits it is typed with.
            let outcome = percuss(&format!("{command} --tolerance 1e-12 --strict"));
            assert_eq!(outcome.code, 0, "{command}\n{}", outcome.stderr);
        }
        commands += found.len();
        models += 1;
    }
    assert!(models >= 7 && commands >= 9, "{models} models, {commands} commands");
}

#[test]
fn a_wrong_expectation_is_noticed() {
    let pendulum = "mass models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 1,0,0";
    let off = percuss(&format!("{pendulum} --expect 0.78126"));
    assert_eq!(off.code, 1);
    assert!(off.stderr.contains("differs from the expected 0.78126 kg"), "{}", off.stderr);
    let immovable =
        percuss("mass models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 0,0,1 --expect 1");
    assert_eq!(immovable.code, 1);
    assert!(immovable.stderr.contains("the contact is immovable"), "{}", immovable.stderr);
}

//! Programs of generated functions and their results.

use percuss_dynamics::{Conditions, Configuration, Contact, EffectiveMass, Pose, System};
use percuss_generate::{Additions, Generated, HeldPoint, Language, Request, generate};
use percuss_mechanism::Mechanism;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

/// Folder of this crate's temporary files.
pub fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// Request without conditions.
pub fn request(name: &str, mechanism: &Arc<Mechanism>, pose: Pose, contact: Contact) -> Request {
    Request {
        system: System::new(Arc::clone(mechanism), &Conditions::new()).expect("a system"),
        pose,
        contact,
        wheel: None,
        other_mass: None,
        armatures: Vec::new(),
        holds: Vec::<HeldPoint>::new(),
        name: name.to_owned(),
        origin: Vec::new(),
        model_hash: String::new(),
        language: Language::C,
        additions: Additions::default(),
    }
}

/// Inputs of the generated function at a pose.
pub fn inputs(pose: &Pose) -> Vec<f64> {
    let mechanism = Arc::clone(pose.mechanism());
    let given = mechanism.joint_ids().filter(|&id| mechanism.joint(id).mimic().is_none());
    given.flat_map(|id| pose.joint(id).to_vec()).collect()
}

/// Configuration of a case, with the library's result.
#[derive(Debug)]
pub struct Checked {
    pub inputs: Vec<f64>,
    pub outcome: EffectiveMass,
    /// Stated relative error.
    pub error: f64,
}

/// Library's result at a pose; `None` at a singular pose or without a result.
pub fn checked(pose: &Pose, contact: &Contact) -> Option<Checked> {
    let response = pose.respond(contact).ok().filter(|r| !r.singular_pose)?;
    let error = match response.effective_mass {
        EffectiveMass::Finite(m) => response.effective_mass_error()? / m,
        _ => 0.0,
    };
    Some(Checked { inputs: inputs(pose), outcome: response.effective_mass, error })
}

/// Generated function with configurations.
pub struct Case {
    pub name: String,
    pub generated: Generated,
    pub checked: Vec<Checked>,
}

/// Generates the code of a case.
pub fn case(request: &Request, checked: Vec<Checked>) -> Result<Case, percuss_generate::GenerateError> {
    Ok(Case { name: request.name.clone(), generated: generate(request)?, checked })
}

/// Warnings that the generated code has to be free of.
pub const WARNINGS: [&str; 5] = ["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Werror"];

/// Compiles all cases as one program; returns status and m̄ of every configuration.
pub fn run(folder_name: &str, cases: &[Case]) -> Vec<Vec<(i32, f64)>> {
    let folder = folder(folder_name);
    let mut program = String::from("#include <stdio.h>\n");
    for case in cases {
        for file in &case.generated.files {
            std::fs::write(folder.join(&file.name), &file.text).expect("a file");
        }
        let _ = writeln!(program, "#include \"{}.c\"", case.name);
    }
    program += "int main(void)\n{\n    double mass;\n    int status;\n";
    for case in cases {
        for (k, checked) in case.checked.iter().enumerate() {
            let values: Vec<String> = checked.inputs.iter().map(|x| format!("{x:?}")).collect();
            let list = if values.is_empty() { "0.0".to_owned() } else { values.join(", ") };
            let _ = write!(
                program,
                "    {{\n        const double q[] = {{{list}}};\n        status = {}_mass(q, &mass);\n        printf(\"%d \
                 %.17g\\n\", status, mass); /* {k} */\n    }}\n",
                case.name
            );
        }
    }
    program += "    return 0;\n}\n";
    std::fs::write(folder.join("all.c"), program).expect("a file");
    let output = Command::new("cc")
        .args(WARNINGS)
        .args(["-O0", "all.c", "-o", "all", "-lm"])
        .current_dir(&folder)
        .output()
        .expect("a C compiler");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(folder.join("all")).output().expect("the program runs");
    let text = String::from_utf8(output.stdout).expect("text");
    let mut lines = text.lines();
    cases
        .iter()
        .map(|case| {
            let line = |_: &Checked| {
                let (status, mass) = lines.next().and_then(|l| l.split_once(' ')).expect("a line");
                (status.parse().expect("a status"), mass.parse().unwrap_or(f64::NAN))
            };
            case.checked.iter().map(line).collect()
        })
        .collect()
}

/// Compares all results with the library. Returns the number of finite results and of refusals.
pub fn compare(cases: &[Case], results: &[Vec<(i32, f64)>]) -> (usize, usize) {
    let (mut finite, mut refused) = (0, 0);
    for (case, results) in cases.iter().zip(results) {
        for (checked, &(status, found)) in case.checked.iter().zip(results) {
            match (status, checked.outcome) {
                (0, EffectiveMass::Finite(expected)) => {
                    finite += 1;
                    // Rounding of the plain elimination; more where the library states more.
                    let tolerance = 1e-12 + 30.0 * checked.error;
                    let difference = (found / expected - 1.0).abs();
                    assert!(
                        difference <= tolerance,
                        "{}: {found} {expected}: {difference:.1e}, stated {:.1e}",
                        case.name,
                        checked.error
                    );
                }
                (1, EffectiveMass::Immovable) => finite += 1,
                (3 | 4, _) => refused += 1,
                _ => panic!("{}: status {status}, {found}, library {:?}", case.name, checked.outcome),
            }
        }
    }
    (finite, refused)
}

/// Pose with the given positions of all joints.
pub fn pose(system: &System, positions: &[f64]) -> Option<Pose> {
    let configuration = Configuration::from_positions(system.mechanism(), positions).ok()?;
    system.pose(&configuration).ok()
}

//! Command `percuss generate`.

use crate::args::{GenerateArgs, LanguageName};
use crate::files::output::{check_writable, record_input, write_file};
use crate::terminal::escape::line;
use crate::terminal::failure::Failure;
use crate::terminal::report::{write_diagnostics, write_text};
use crate::terminal::text::shell_quoted;
use crate::terminal::wrap::fact_line;
use percuss_study::generated::Generated;
use percuss_study::{CodeError, generate_code};
use std::path::Path;

/// Runs the command.
pub fn run(args: &GenerateArgs) -> Result<(), Failure> {
    args.writing.apply();
    let name = args.identifier()?;
    let contact = &args.contact.contact;
    if contact.estimate.is_some() || !contact.ratio_at.is_empty() {
        return Err(Failure::bad_input(
            "--estimate, --ratio-at: not available in generated code; use percuss mass",
        ));
    }
    let question = args.contact.question()?;
    let model = args.model.load()?;
    model.inputs.iter().for_each(|input| record_input(&input.path));
    write_diagnostics(&model.diagnostics, args.model.reading.strict)?;
    let folder = Path::new(&args.output);
    if !folder.is_dir() {
        std::fs::create_dir_all(folder)
            .map_err(|error| Failure::bad_input(format!("--output {}: {error}", args.output)))?;
    }
    let generated = generate_code(&model, &question, &name, args.language(), args.additions())?;
    let path = |file: &str| folder.join(file).to_string_lossy().into_owned();
    for file in &generated.files {
        check_writable(&path(&file.name))?;
    }
    for file in &generated.files {
        write_file(&path(&file.name), file.text.as_bytes())?;
    }
    write_text(&summary(args, &name, &generated, &path))
}

/// Files, size of the function, and the command of the self-test.
fn summary(args: &GenerateArgs, name: &str, generated: &Generated, path: &dyn Fn(&str) -> String) -> String {
    let files: Vec<String> = generated.files.iter().map(|file| path(&file.name)).collect();
    let mut out = fact_line("written", &line(&files.join(", ")));
    out += &fact_line(
        "function",
        &format!(
            "{name}_mass: {} positions, {} operations, {} sines and cosines",
            generated.positions, generated.operations, generated.angles
        ),
    );
    let test = match args.language {
        LanguageName::C => format!(
            "cc -O2 {} {} -lm && ./a.out",
            shell_quoted(&path(&format!("{name}.c"))),
            shell_quoted(&path(&format!("{name}_test.c")))
        ),
        LanguageName::Rust => {
            let file = shell_quoted(&path(&format!("{name}.rs")));
            format!("rustc --edition 2021 --test -O {file} -o {name}_test && ./{name}_test")
        }
    };
    out += &fact_line("self-test", &format!("{} configurations: {}", generated.references, line(&test)));
    out
}

impl From<CodeError> for Failure {
    fn from(error: CodeError) -> Self {
        match error {
            CodeError::Question(error) => error.into(),
            CodeError::Generate(error) => Failure::bad_input(error.to_string()),
        }
    }
}

//! `percuss import`.

use crate::args::{ImportArgs, SideArg};
use crate::failure::Failure;
use crate::report::{write_diagnostics, write_out};
use percuss_formats::suspension::{ImportOptions, Rack, Side, Wheel, import};
use percuss_formats::{Source, write_urdf_with};
use percuss_study::DiagnosticRecord;

/// Runs the command.
pub fn run(args: &ImportArgs) -> Result<(), Failure> {
    let same = |a: &str, b: &str| {
        std::fs::canonicalize(a).ok().zip(std::fs::canonicalize(b).ok()).is_some_and(|(a, b)| a == b)
    };
    if args.output != "-" && same(&args.hardpoints, &args.output) {
        return Err(Failure::bad_input(format!("--output {} is the hardpoint file itself", args.output)));
    }
    let source = Source::read(&args.hardpoints, args.max_size)?;
    let imported = import(&source, &options(args))?;
    let diagnostics: Vec<DiagnosticRecord> = imported.diagnostics.into_iter().map(Into::into).collect();
    write_diagnostics(&diagnostics, args.strict)?;
    let text = write_urdf_with(&imported.mechanism, &imported.comments);
    match args.output.as_str() {
        "-" => write_out(&text),
        path => std::fs::write(path, text)
            .map_err(|e| Failure::bad_input(format!("{path} cannot be written: {e}"))),
    }
}

fn options(args: &ImportArgs) -> ImportOptions {
    ImportOptions {
        side: match args.side {
            SideArg::Left => Side::Left,
            SideArg::Right => Side::Right,
            SideArg::Both => Side::Both,
        },
        wheel: args.wheel_mass.map(|mass| Wheel {
            mass,
            inertia: args.wheel_inertia.unwrap_or_default(),
            radius: args.wheel_radius,
        }),
        rack: args.rack_mass.map_or(Rack::Fixed, |mass| Rack::Sliding { mass }),
        ..ImportOptions::default()
    }
}

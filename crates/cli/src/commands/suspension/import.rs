//! `percuss import`.

use crate::args::{ImportArgs, SideArg, UnitArg};
use crate::files::contents::{PICTURES, picture_bytes};
use crate::files::output::{check_writable, ending_of, record_input, write_file};
use crate::files::own_files::append_hash;
use crate::pictures::import_picture;
use crate::terminal::failure::Failure;
use crate::terminal::import_text::import_summary;
use crate::terminal::number::true_minus;
use crate::terminal::report::{note, write_diagnostics, write_text, write_unescaped};
use percuss_formats::{Source, write_urdf_with};
use percuss_study::DiagnosticRecord;
use percuss_suspension::{ImportOptions, LengthUnit, Rack, Side, Wheel, import};

/// Runs the command.
pub fn run(args: &ImportArgs) -> Result<(), Failure> {
    args.writing.apply();
    record_input(&args.hardpoints);
    if args.output != "-" {
        check_writable(&args.output)?;
    }
    let picture_ending = args.picture.as_deref().map(|path| {
        ending_of(path, &PICTURES).map_err(|_| {
            Failure::bad_input(format!("--picture {path}: its name must end in .svg, .png or .pdf"))
        })
    });
    let picture_ending = picture_ending.transpose()?;
    let source = Source::read(&args.hardpoints, args.max_size)?;
    let imported = import(&source, &options(args))?;
    imported.inputs.iter().for_each(|path| record_input(path));
    let diagnostics: Vec<DiagnosticRecord> = imported.diagnostics.into_iter().map(Into::into).collect();
    write_diagnostics(&diagnostics, args.strict)?;
    let is_ideal = |bush: &percuss_mechanism::Bush| bush.description().stiffness.contains(&f64::INFINITY);
    if imported.mechanism.bushes().iter().any(is_ideal) {
        note("bushes with ideal directions are not in the URDF, which has the ideal joints in their place");
    }
    let text = append_hash(write_urdf_with(&imported.mechanism, &imported.comments));
    if let (Some(path), Some(ending)) = (&args.picture, picture_ending) {
        let drawing = import_picture::picture(&imported.understood, &args.hardpoints);
        write_file(path, &picture_bytes(&drawing, ending)?)?;
    }
    if args.output == "-" {
        return write_unescaped(text.as_bytes());
    }
    write_file(&args.output, text.as_bytes())?;
    write_text(&true_minus(&import_summary(&imported.understood, &args.output)))
}

/// Import options of the flags.
fn options(args: &ImportArgs) -> ImportOptions {
    ImportOptions {
        unit: args.unit.map(unit),
        axes: args.axes,
        template: args.template.clone(),
        worksheet: args.worksheet.clone(),
        names: args.names.clone(),
        moves: args.moves.iter().map(|(name, shift)| (name.clone(), shift.0)).collect(),
        side: args.side.map(|side| match side {
            SideArg::Left => Side::Left,
            SideArg::Right => Side::Right,
            SideArg::Both => Side::Both,
        }),
        wheel: args.wheel_mass.map(|mass| Wheel {
            mass,
            inertia: args.wheel_inertia.unwrap_or_default(),
            radius: args.wheel_radius,
        }),
        rack: args.rack_mass.map(|mass| Rack::Sliding { mass }),
        allow_outside: args.allow_outside,
        ..ImportOptions::default()
    }
}

/// Unit of length for a flag value.
pub fn unit(unit: UnitArg) -> LengthUnit {
    match unit {
        UnitArg::M => LengthUnit::Metre,
        UnitArg::Cm => LengthUnit::Centimetre,
        UnitArg::Mm => LengthUnit::Millimetre,
        UnitArg::In => LengthUnit::Inch,
    }
}

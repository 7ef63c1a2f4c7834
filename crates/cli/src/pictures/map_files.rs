//! Files of a map: PLY, glTF, pictures, tables.

use crate::files::csv;
use crate::files::output::{Output, ending_of};
use crate::files::table_style::TableStyle;
use crate::pictures::ellipsoid;
use crate::terminal::failure::Failure;
use crate::terminal::number::number;
use percuss_dynamics::ContactStatus;
use percuss_render::{Picture, RenderError, Skin, SkinFacet, SkinMark, SkinPiece};
use percuss_study::{DirectionMass, Extreme, MapAnswer, PointMapReport};
use std::io::{self, Write};

/// File format of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapFormat {
    Ply,
    Glb,
    Gltf,
    Svg,
    Png,
    Pdf,
    Csv,
    Json,
}

impl MapFormat {
    /// Determines the format from the file extension.
    pub fn from_path(path: &str) -> Result<Self, Failure> {
        Ok(match ending_of(path, &["ply", "glb", "gltf", "png", "svg", "pdf", "csv", "json"])? {
            "ply" => MapFormat::Ply,
            "glb" => MapFormat::Glb,
            "gltf" => MapFormat::Gltf,
            "svg" => MapFormat::Svg,
            "png" => MapFormat::Png,
            "pdf" => MapFormat::Pdf,
            "csv" => MapFormat::Csv,
            _ => MapFormat::Json,
        })
    }
}

/// Reason for a file that is not written.
pub enum MapWriteError {
    /// Error of the operating system.
    Io(io::Error),
    /// Other reason: the map has no surface, or rendering failed.
    Other(String),
}

impl MapWriteError {
    /// Failure of the command for this reason.
    pub fn failure(self, path: &str, out: &Output) -> Failure {
        match self {
            MapWriteError::Io(error) => out.failure(error),
            MapWriteError::Other(message) => Failure::output(path, message),
        }
    }
}

impl From<io::Error> for MapWriteError {
    fn from(error: io::Error) -> Self {
        MapWriteError::Io(error)
    }
}

/// Writes a map.
pub fn write(
    answer: &MapAnswer,
    format: MapFormat,
    table: TableStyle,
    out: &mut Output,
) -> Result<(), MapWriteError> {
    match format {
        MapFormat::Csv => csv(answer, table, out)?,
        MapFormat::Json => json(answer, out)?,
        surface => write_skin(&skin(answer), surface, out)?,
    }
    Ok(())
}

/// Writes a surface; does nothing for table formats.
fn write_skin(skin: &Skin, format: MapFormat, out: &mut Output) -> Result<(), MapWriteError> {
    let failed = |error: RenderError| MapWriteError::Other(error.to_string());
    match format {
        MapFormat::Ply => skin.write_ply(out)?,
        MapFormat::Glb => out.write_all(&skin.to_glb())?,
        MapFormat::Gltf => out.write_all(skin.to_gltf().as_bytes())?,
        MapFormat::Svg => out.write_all(skin.to_svg().as_bytes())?,
        MapFormat::Png => out.write_all(&skin.to_png(2.0).map_err(failed)?)?,
        MapFormat::Pdf => out.write_all(&skin.to_pdf().map_err(failed)?)?,
        MapFormat::Csv | MapFormat::Json => {}
    }
    Ok(())
}

/// Writes a map at a point.
pub fn write_point(
    report: &PointMapReport,
    format: MapFormat,
    table: TableStyle,
    out: &mut Output,
) -> Result<(), MapWriteError> {
    match format {
        MapFormat::Csv => point_csv(report, table, out)?,
        MapFormat::Json => json(report, out)?,
        surface => {
            let skin = ellipsoid::skin(report).map_err(|why| MapWriteError::Other(why.into()))?;
            write_skin(&skin, surface, out)?;
        }
    }
    Ok(())
}

/// Writes a value as indented JSON.
fn json(value: &impl serde::Serialize, out: &mut Output) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, value)?;
    writeln!(out)
}

/// Writes the contacts as CSV, one row each.
pub fn csv(answer: &MapAnswer, style: TableStyle, out: &mut impl Write) -> io::Result<()> {
    let length = style.unit("m");
    let square = format!("{}2", length.name);
    let named = |name: &str| match name {
        "x" | "y" | "z" | "world_x" | "world_y" | "world_z" => style.name_with_unit(name, length.name),
        "area" => style.name_with_unit(name, &square),
        "effective_mass" | "effective_mass_error" => style.name_with_unit(name, "kg"),
        _ => name.to_owned(),
    };
    let names = "link,x,y,z,normal_x,normal_y,normal_z,world_x,world_y,world_z,area,status,effective_mass,effective_mass_error";
    out.write_all(csv::styled_line(&names.split(',').map(named).collect::<Vec<_>>(), style).as_bytes())?;
    for record in answer.skins.iter().flat_map(|skin| skin.records()) {
        let mut cells = vec![record.link.to_owned()];
        let vectors = [
            (record.point_link, length.factor),
            (record.normal_link, 1.0),
            (record.point_world, length.factor),
        ];
        let shown = |x: f64, factor: f64| csv::styled_number(style.number(x * factor, None), style);
        for (vector, factor) in vectors {
            cells.extend(vector.map(|x| shown(x, factor)));
        }
        cells.extend([
            shown(record.area, length.factor * length.factor),
            record.status.to_owned(),
            csv::styled_mass(record.effective_mass, record.effective_mass_error, style),
            csv::styled_error(record.effective_mass_error, style),
        ]);
        out.write_all(csv::styled_line(&cells, style).as_bytes())?;
    }
    Ok(())
}

/// Writes the principal directions as CSV, followed by the other directions.
pub fn point_csv(report: &PointMapReport, style: TableStyle, out: &mut impl Write) -> io::Result<()> {
    // Directions have no unit.
    let named = |name: &str| match name {
        "effective_mass" | "effective_mass_error" => style.name_with_unit(name, "kg"),
        _ => name.to_owned(),
    };
    let names = "kind,x,y,z,world_x,world_y,world_z,status,effective_mass,effective_mass_error";
    out.write_all(csv::styled_line(&names.split(',').map(named).collect::<Vec<_>>(), style).as_bytes())?;
    let principal = report.principal.iter().map(|d| ("principal", d));
    for (kind, d) in principal.chain(report.directions.iter().map(|d| ("direction", d))) {
        let DirectionMass { direction_link, direction_world, status, effective_mass, effective_mass_error } =
            d;
        let mut cells = vec![kind.to_owned()];
        let shown = |x: &f64| csv::styled_number(style.number(*x, None), style);
        cells.extend(direction_link.iter().chain(direction_world).map(shown));
        cells.extend([
            (*status).to_owned(),
            csv::styled_mass(*effective_mass, *effective_mass_error, style),
            csv::styled_error(*effective_mass_error, style),
        ]);
        out.write_all(csv::styled_line(&cells, style).as_bytes())?;
    }
    Ok(())
}

/// Map as a coloured surface, in world coordinates.
pub fn skin(answer: &MapAnswer) -> Skin {
    let report = &answer.report;
    let pieces = answer.skins.iter().map(|skin| {
        let facet = |(i, facet): (usize, &percuss_formats::Facet)| SkinFacet {
            corners: facet.corners.map(|p| skin.frame.point(&p).into()),
            normal: skin.frame.vector(&facet.normal).into(),
            value: match skin.statuses[i] {
                ContactStatus::Massless => Some(0.0),
                _ => skin.mass(i),
            },
            status: skin.statuses[i].into(),
        };
        SkinPiece { name: skin.link.clone(), facets: skin.facets.iter().enumerate().map(facet).collect() }
    });
    let title = match &report.links[..] {
        [one] => format!("Effective mass over {}", one.link),
        several => format!("Effective mass over {} links", several.len()),
    };
    let extreme = |of: fn(&percuss_study::LinkMap) -> Option<&Extreme>, sign: f64| {
        let all = report.links.iter().filter_map(of);
        all.min_by(|a, b| (sign * a.effective_mass).total_cmp(&(sign * b.effective_mass)))
    };
    let mark = |name: &str, e: &Extreme| SkinMark {
        at: e.point_world,
        label: format!("{name} {} kg", number(e.effective_mass)),
    };
    let smallest = extreme(|l| l.smallest.as_ref(), 1.0).map(|e| mark("smallest", e));
    let largest = extreme(|l| l.largest.as_ref(), -1.0).map(|e| mark("largest", e));
    Skin {
        title,
        subtitle: report.inputs.first().map_or_else(String::new, |input| input.path.clone()),
        quantity: "effective mass m̄ (kg)".into(),
        without_value: "immovable".into(),
        property: "effective_mass".into(),
        pieces: pieces.collect(),
        marks: smallest.into_iter().chain(largest).collect(),
    }
}

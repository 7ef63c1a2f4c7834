//! Recognition of files that percuss wrote: a mark in the head or at the end of the file, in a place that the format
//! provides. docs/reference/OUTPUTS.md lists the marks.

use percuss_formats::{DEFAULT_MAX_SIZE, Source};
use percuss_render::MADE_BY;
use percuss_study::Input;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;

/// Program in the description of a Parquet file.
pub const CREATED_BY: &str = concat!("percuss ", env!("CARGO_PKG_VERSION"));
/// Bytes of the head that are searched: marks are in the first lines.
const HEAD: usize = 1 << 12;
/// Bytes of the end that are searched: the description of a Parquet file is there, with an entry per column.
const END: i64 = 1 << 20;

/// True if a file may be replaced without `--force`: the file does not exist, is no regular file, is empty, or was
/// written by percuss.
pub fn is_own(path: &Path) -> io::Result<bool> {
    match fs::metadata(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(true),
        Err(error) => return Err(error),
        Ok(found) if !found.is_file() || found.len() == 0 => return Ok(true),
        Ok(_) => {}
    }
    let mut file = File::open(path)?;
    let mut head = Vec::new();
    file.by_ref().take(HEAD as u64).read_to_end(&mut head)?;
    let has = |bytes: &[u8], mark: &[u8]| bytes.windows(mark.len()).any(|window| window == mark);
    let has_any = |bytes: &[u8], marks: &[&str]| marks.iter().any(|mark| has(bytes, mark.as_bytes()));
    if let [b'P', b'K', 3, 4, ..] = head[..] {
        return Ok(is_own_workbook(file));
    }
    let mut end = || {
        let length = file.seek(SeekFrom::End(0))?;
        file.seek(SeekFrom::Start(length.saturating_sub(END as u64)))?;
        let mut end = Vec::new();
        file.by_ref().take(END as u64).read_to_end(&mut end)?;
        Ok::<_, io::Error>(end)
    };
    if has(&head, b"<!-- imported by percuss from ") {
        return has_valid_hash(file);
    }
    Ok(match &head[..] {
        [b'P', b'A', b'R', b'1', ..] => has_any(&end()?, &["percuss.heading", CREATED_BY]),
        [b'%', b'P', b'D', b'F', ..] => has(&end()?, MADE_BY.as_bytes()),
        _ => {
            has(&head, MADE_BY.as_bytes())
                || has_marked_head(&String::from_utf8_lossy(&head))
                || has(&end()?, KINEMATIC_AXES.as_bytes())
        }
    })
}

/// Start and end of the last line of an imported model.
const HASH_LINE: (&str, &str) = ("<!-- SHA-256 of the lines above, as percuss wrote them: ", " -->");

/// Imported model with the hash of its text in the last line, which reveals changes by hand.
pub fn append_hash(text: String) -> String {
    let hash = hash(&text);
    format!("{text}{}{hash}{}\n", HASH_LINE.0, HASH_LINE.1)
}

/// SHA-256 of a text, hexadecimal.
fn hash(text: &str) -> String {
    Input::from_source(&Source::from_text("", text)).sha256
}

/// True if an imported model is unchanged since percuss wrote it.
fn has_valid_hash(mut file: File) -> io::Result<bool> {
    let mut text = String::new();
    file.seek(SeekFrom::Start(0))?;
    if file.take(DEFAULT_MAX_SIZE).read_to_string(&mut text).is_err() {
        return Ok(false);
    }
    // Git may have changed the line ends.
    let text = text.replace("\r\n", "\n");
    let above =
        text.strip_suffix(&format!("{}\n", HASH_LINE.1)).and_then(|text| text.rsplit_once(HASH_LINE.0));
    Ok(above.is_some_and(|(above, found)| found == hash(above)))
}

/// True for a workbook with percuss in its properties.
#[cfg(feature = "tables")]
fn is_own_workbook(file: File) -> bool {
    let properties = |file| {
        let mut archive = zip::ZipArchive::new(file).ok()?;
        let mut text = String::new();
        // The properties that percuss writes are shorter than this limit.
        archive.by_name("docProps/core.xml").ok()?.take(HEAD as u64).read_to_string(&mut text).ok()?;
        Some(text)
    };
    properties(file).is_some_and(|text| text.contains(MADE_BY))
}

/// A build without workbooks recognises none.
#[cfg(not(feature = "tables"))]
fn is_own_workbook(_: File) -> bool {
    false
}

/// Line below the tables of kinematics as text.
pub const KINEMATIC_AXES: &str = "axes of the vehicle, ISO 8855: x forward, y left, z up";
/// Starts of the columns of kinematics, separated by blanks.
const KINEMATIC_COLUMNS: &str = "wheel_travel_ camber_ toe_ caster_ kingpin_inclination_ scrub_radius_ mechanical_trail_ \
    steering_ratio_ half_track_change_ forward_displacement_ instant_centre_ side_view_angle_ anti_ \
    motion_ratio_ ratio_gradient_ leverage_ratio_ wheel_centre_ contact_patch_ force_ moment_ wheel_rate_ \
    unsprung_mass_ body_frequency_ wheel_hop_frequency_ roll_centre_ compliance_ loads problem";

/// True for the first line of a table of kinematics: the travel, if there are several rows, and quantities.
fn is_kinematic(first: &str) -> bool {
    let is_travel = |cell: &str| {
        let unit = ["wheel-travel_", "heave_", "roll_"].iter().find_map(|name| cell.strip_prefix(name));
        unit.is_some_and(|unit| ["mm", "cm", "m", "in", "ft"].contains(&unit))
    };
    let mut cells = first.split(',').enumerate();
    cells.all(|(i, cell)| {
        i == 0 && is_travel(cell) || KINEMATIC_COLUMNS.split(' ').any(|name| cell.starts_with(name))
    })
}

/// True for texts whose first lines only percuss writes.
fn has_marked_head(head: &str) -> bool {
    let dense: String = head.chars().filter(|c| !c.is_whitespace()).collect();
    let first = head.lines().next().unwrap_or("").replace(';', ",");
    // JSON, JSON Lines, glTF as text and in its binary form, an imported model.
    dense.starts_with("{\"schema\":\"percuss.")
        || dense.starts_with("{\"row\":0,\"varied\":")
        || dense.contains("\"generator\":\"percuss\"")
        // Tables have no place for a mark; their columns identify them.
        || first.starts_with("row,") && [",status,effective_mass", " difference_percent"].iter().any(|name| first.contains(name))
        || is_kinematic(&first)
        || first == "design,status,effective_mass,difference_percent"
        || first == "design,status,effective_mass_kg,difference_percent"
        || ["link,x_m", "kind,x,"].iter().any(|begin| first.starts_with(begin)) && first.contains(",effective_mass_kg,")
        || ["link,x,y,z,normal_x,", "kind,x,y,z,world_x,", "joint,position,free,held,mimic_tree", "time,penetration,rate,force", "time_s,penetration_"]
            .iter()
            .any(|columns| first.starts_with(columns))
}

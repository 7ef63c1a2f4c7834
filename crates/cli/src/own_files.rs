//! How percuss knows a file that it wrote: a mark in the file's head or end, in a place that its format has for it.
//! docs/OUTPUTS.md lists them.

use percuss_formats::{DEFAULT_MAX_SIZE, Source};
use percuss_render::MADE_BY;
use percuss_study::Input;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;

/// How much of the head of a file is looked at, bytes: marks are in the first lines.
const HEAD: usize = 1 << 12;
/// How much of its end, bytes: Parquet has its description there, one entry for each column.
const END: i64 = 1 << 20;

/// Whether a file may be replaced without being asked for: it is not there, is no regular file, holds nothing, or percuss wrote
/// it.
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
        return is_sealed(file);
    }
    Ok(match &head[..] {
        [b'P', b'A', b'R', b'1', ..] => has(&end()?, b"percuss.heading"),
        [b'%', b'P', b'D', b'F', ..] => has(&end()?, MADE_BY.as_bytes()),
        _ => has(&head, MADE_BY.as_bytes()) || has_marked_head(&String::from_utf8_lossy(&head)),
    })
}

/// Begin and end of the last line of an imported model.
const SEAL: (&str, &str) = ("<!-- SHA-256 of the lines above, as percuss wrote them: ", " -->");

/// An imported model with the hash of its text in a last line, by which a change by hand is seen.
pub fn sealed(text: String) -> String {
    let hash = hash(&text);
    format!("{text}{}{hash}{}\n", SEAL.0, SEAL.1)
}

fn hash(text: &str) -> String {
    Input::of(&Source::from_text("", text)).sha256
}

/// True if an imported model is as percuss wrote it.
fn is_sealed(mut file: File) -> io::Result<bool> {
    let mut text = String::new();
    file.seek(SeekFrom::Start(0))?;
    if file.take(DEFAULT_MAX_SIZE).read_to_string(&mut text).is_err() {
        return Ok(false);
    }
    // Git may have changed the ends of lines.
    let text = text.replace("\r\n", "\n");
    let above = text.strip_suffix(&format!("{}\n", SEAL.1)).and_then(|text| text.rsplit_once(SEAL.0));
    Ok(above.is_some_and(|(above, found)| found == hash(above)))
}

/// A workbook whose properties say so.
fn is_own_workbook(file: File) -> bool {
    let properties = |file| {
        let mut archive = zip::ZipArchive::new(file).ok()?;
        let mut text = String::new();
        // No more is read than percuss writes there.
        archive.by_name("docProps/core.xml").ok()?.take(HEAD as u64).read_to_string(&mut text).ok()?;
        Some(text)
    };
    properties(file).is_some_and(|text| text.contains(MADE_BY))
}

/// Texts whose first lines only percuss writes.
fn has_marked_head(head: &str) -> bool {
    let dense: String = head.chars().filter(|c| !c.is_whitespace()).collect();
    let first = head.lines().next().unwrap_or("").replace(';', ",");
    // JSON; its rows one to a line; glTF, as it is and inside its binary form; an imported model.
    dense.starts_with("{\"schema\":\"percuss.")
        || dense.starts_with("{\"row\":0,\"varied\":")
        || dense.contains("\"generator\":\"percuss\"")
        // Tables have no place for a mark: their columns are it.
        || first.starts_with("row,") && [",status,effective_mass", " difference_percent"].iter().any(|name| first.contains(name))
        || first == "design,status,effective_mass,difference_percent"
        || first == "design,status,effective_mass_kg,difference_percent"
        || ["link,x_m", "kind,x,"].iter().any(|begin| first.starts_with(begin)) && first.contains(",effective_mass_kg,")
        || ["link,x,y,z,normal_x,", "kind,x,y,z,world_x,", "time,penetration,rate,force", "time_s,penetration_"]
            .iter()
            .any(|columns| first.starts_with(columns))
}

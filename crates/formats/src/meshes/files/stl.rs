//! Reader of STL files, binary or ASCII.

use super::error::excerpt;
use super::triangles::{Triangles, check_triangle_count};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Bytes before the first facet of a binary file.
const HEADER_SIZE: usize = 84;
/// Bytes of a facet in a binary file.
const FACET_SIZE: usize = 50;

/// Triangles of an STL file, binary or ASCII.
pub(super) fn read_stl(bytes: &[u8]) -> Result<Triangles, String> {
    // Binary files may also begin with "solid", so the length of the file decides.
    match stated_facet_count(bytes) {
        Some(count)
            if bytes.len() >= HEADER_SIZE + FACET_SIZE * count
                && (count > 0 || !begins_as_ascii_stl(bytes)) =>
        {
            check_triangle_count(count)?;
            let facets = bytes[HEADER_SIZE..].chunks_exact(FACET_SIZE).take(count);
            Ok(facets.map(binary_facet_corners).collect())
        }
        _ if begins_as_ascii_stl(bytes) => read_ascii_stl(bytes),
        Some(count) => Err(format!(
            "it announces {count} triangles and has bytes for {}; was it cut off?",
            (bytes.len() - HEADER_SIZE) / FACET_SIZE
        )),
        None => Err(format!("{} bytes are no STL", bytes.len())),
    }
}

/// Number of facets of a binary STL file; `None` if the file is not readable, or if its length is not that of the stated number.
pub fn binary_stl_facets(path: &Path) -> Option<usize> {
    let mut file = File::open(path).ok()?;
    let mut header = [0; HEADER_SIZE];
    file.read_exact(&mut header).ok()?;
    let count = stated_facet_count(&header)?;
    let length = u64::try_from(HEADER_SIZE.checked_add(FACET_SIZE.checked_mul(count)?)?).ok()?;
    (file.metadata().ok()?.len() == length).then_some(count)
}

/// Number of facets stated in the header of a binary file; `None` for a shorter file.
fn stated_facet_count(bytes: &[u8]) -> Option<usize> {
    let count: [u8; 4] = bytes.get(HEADER_SIZE - 4..HEADER_SIZE)?.try_into().ok()?;
    usize::try_from(u32::from_le_bytes(count)).ok()
}

/// True for text that begins with `solid`.
fn begins_as_ascii_stl(bytes: &[u8]) -> bool {
    let text = bytes.trim_ascii_start();
    text.len() >= 5 && text[..5].eq_ignore_ascii_case(b"solid") && !bytes.contains(&0)
}

/// Corners of a facet of a binary file.
fn binary_facet_corners(facet: &[u8]) -> [[f64; 3]; 3] {
    let number = |at: usize| {
        let bytes = [facet[at], facet[at + 1], facet[at + 2], facet[at + 3]];
        f64::from(f32::from_le_bytes(bytes))
    };
    // The normal before the corners is ignored: many writers leave the normal at zero.
    std::array::from_fn(|corner| std::array::from_fn(|axis| number(12 + 12 * corner + 4 * axis)))
}

/// Triangles of an ASCII file. Blank lines are ignored; keywords may be in upper or lower case.
fn read_ascii_stl(bytes: &[u8]) -> Result<Triangles, String> {
    let lines = (1_usize..).zip(bytes.split(|byte| *byte == b'\n'));
    let mut lines = lines.map(|(line, text)| (line, text.trim_ascii())).filter(|(_, text)| !text.is_empty());
    let mut next = |expected: &str| {
        lines.next().ok_or_else(|| format!("the file ends where {expected} is expected; was it cut off?"))
    };
    next("\"solid\"")?;
    let mut triangles = Triangles::new();
    loop {
        let (line, text) = next("a facet or \"endsolid\"")?;
        if words(text).next().is_some_and(|word| word.eq_ignore_ascii_case(b"endsolid")) {
            return Ok(triangles);
        }
        let mismatch = |line: usize, text: &[u8], expected: &str| {
            format!(
                "line {line}, facet {}: {expected} is expected, found {:?}",
                triangles.len() + 1,
                excerpt(text)
            )
        };
        let header = "\"facet normal\" with three finite numbers";
        parse_keyword_line::<3>(text, &["facet", "normal"]).ok_or_else(|| mismatch(line, text, header))?;
        let (line, text) = next("\"outer loop\"")?;
        parse_keyword_line::<0>(text, &["outer", "loop"])
            .ok_or_else(|| mismatch(line, text, "\"outer loop\""))?;
        let mut corners = [[0.0; 3]; 3];
        for corner in &mut corners {
            let (line, text) = next("\"vertex\"")?;
            *corner = parse_keyword_line(text, &["vertex"])
                .ok_or_else(|| mismatch(line, text, "\"vertex\" with three finite numbers"))?;
        }
        for end in ["endloop", "endfacet"] {
            let (line, text) = next(end)?;
            parse_keyword_line::<0>(text, &[end]).ok_or_else(|| mismatch(line, text, end))?;
        }
        check_triangle_count(triangles.len() + 1).map_err(|why| format!("line {line}: {why}"))?;
        triangles.push(corners);
    }
}

fn words(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

/// The `N` finite numbers after the keywords of a line; `None` for any other line. Numbers have single precision, as in
/// binary files.
fn parse_keyword_line<const N: usize>(text: &[u8], keywords: &[&str]) -> Option<[f64; N]> {
    let mut words = words(text);
    for keyword in keywords {
        words.next().filter(|word| word.eq_ignore_ascii_case(keyword.as_bytes()))?;
    }
    let mut numbers = [0.0; N];
    for number in &mut numbers {
        let read: f32 = std::str::from_utf8(words.next()?).ok()?.parse().ok()?;
        *number = f64::from(Some(read).filter(|x| x.is_finite())?);
    }
    words.next().is_none().then_some(numbers)
}

//! Pages of the book and files of cases: their blocks, and the commands in them.
//!
//! Every line under `$ percuss …` occurs in the standard output, in the same order. `...` in a line is any text, `~2.35` in a
//! complete line a number within one unit of its last digit, and `! text` a text that does not occur. A line `? 2 message` is the
//! exit code (0 without this line) and starts the lines of standard error, where each message is one line; a bare `? 0` means no
//! message. `< FILE` is standard input, `$ cat FILE` shows a file (exit code 1 if there is none), `$ cat FILE > NEW` copies it, and
//! `$ sed s|OLD|NEW| FILE > NEW` changes the copy. With `PERCUSS_UPDATE=1`, the test writes the output into the page.
//!
//! In files of cases, commands have six digits (`--digits 6`), and each section has a folder of its own. A block with a file name is written to this folder (`toml car.toml`).
//! A block `words` has lines `NAME = words` for the following commands.

use super::{Outcome, Scratch, percuss_with_stdin, root, run, workshop};
use std::path::Path;

/// Part of a page in Markdown.
pub enum Part<'t> {
    /// Lines outside blocks.
    Prose(&'t str),
    /// Lines between fences, and the text after the first fence.
    Block { info: &'t str, text: &'t str },
}

const FENCE: &str = "```";

/// Divides a page into its parts. Panics on a block without an end.
pub fn parts(page: &str) -> Vec<Part<'_>> {
    let mut parts = Vec::new();
    let mut rest = page;
    while let Some(prose) = before_fence(rest) {
        parts.push(Part::Prose(&rest[..prose]));
        let (info, block) = rest[prose + FENCE.len()..].split_once('\n').expect("a line after a fence");
        let end = before_fence(block).unwrap_or_else(|| panic!("a block has no end: {block}"));
        parts.push(Part::Block { info, text: &block[..end] });
        rest = block[end..].split_once('\n').map_or("", |(_, after)| after);
    }
    parts.push(Part::Prose(rest));
    parts
}

/// Number of bytes before the first line that begins with a fence.
fn before_fence(text: &str) -> Option<usize> {
    if text.starts_with(FENCE) { Some(0) } else { text.find("\n```").map(|end| end + 1) }
}

/// Commands of a `console` block: words without `$`, and the lines below. Panics on lines before the first command.
pub fn commands(block: &str) -> Vec<(&str, &str)> {
    let mut commands = Vec::new();
    let mut next = block.strip_prefix("$ ");
    assert!(next.is_some(), "a block starts without a command: {block}");
    while let Some(rest) = next {
        let (command, after) = rest.split_at(rest.find("\n$ ").map_or(rest.len(), |end| end + 1));
        // A backslash continues the line.
        let mut end = 0;
        let line_end = command.split_inclusive('\n').find_map(|line| {
            end += line.len();
            (!line.ends_with("\\\n")).then_some(end)
        });
        let (line, shown) = command.split_at(line_end.unwrap_or(command.len()));
        commands.push((line.trim_end_matches('\n'), shown));
        next = after.strip_prefix("$ ");
    }
    commands
}

/// Tests of pages, each with a name and a path, and a test that no page with a command below the paths is left out.
#[macro_export]
macro_rules! pages {
    (below $($below:literal)+: $($name:ident $page:literal,)+) => {
        $(#[test]
        fn $name() {
            $crate::support::blocks::check_page($page);
        })+

        #[test]
        fn every_page_is_in_the_list() {
            $crate::support::blocks::check_list(&[$($below),+], &[$($page),+]);
        }
    };
}

/// Asserts that the list has every page with commands in the folders or files.
pub fn check_list(below: &[&str], list: &[&str]) {
    for path in below {
        let full = root().join(path);
        if full.is_dir() {
            for entry in std::fs::read_dir(full).expect("a readable folder").flatten() {
                check_list(&[&format!("{path}/{}", entry.file_name().to_string_lossy())], list);
            }
        } else if path.ends_with(".md") {
            let text = std::fs::read_to_string(full).expect("the page");
            let is_listed = list.contains(path) || !text.contains("$ percuss ");
            assert!(is_listed, "{path} is not in a list of pages! in crates/cli/tests");
        }
    }
}

/// Runs the commands of a page and compares their output. With `PERCUSS_UPDATE`, writes the output into the page instead.
pub fn check_page(page: &str) {
    let path = root().join(page);
    let text = std::fs::read_to_string(&path).expect("the page");
    let has_sections = page.contains("/cases/");
    let mut names: Vec<(&str, &str)> = Vec::new();
    let (mut updated, mut differences, mut count) = (String::new(), String::new(), 0);
    let mut folder = Scratch::in_workshop();
    for part in parts(&text) {
        match part {
            Part::Prose(prose) => {
                assert!(!prose.contains("\n    percuss "), "{page}: a command is not in a console block");
                if has_sections && prose.contains("## ") {
                    folder = Scratch::in_workshop();
                }
                updated += prose;
            }
            Part::Block { info: "console", text } => {
                let digits = has_sections.then_some(CASE_DIGITS);
                let run = run_block(&folder, (&names, digits), text, &mut differences);
                updated += &format!("```console\n{run}```\n");
                count += text.matches("$ percuss ").count();
            }
            Part::Block { info, text } => {
                assert!(
                    !text.lines().any(|line| line.starts_with("percuss ")),
                    "{page}: a command is not in a console block"
                );
                match info.split_whitespace().collect::<Vec<_>>()[..] {
                    [_, name] => _ = folder.write(name, text),
                    ["words"] => names.extend(text.lines().filter_map(|line| line.split_once(" = "))),
                    _ => {}
                }
                updated += &format!("```{info}\n{text}```\n");
            }
        }
    }
    if std::env::var_os("PERCUSS_UPDATE").is_some() {
        if updated != text {
            std::fs::write(&path, &updated).expect("the page is written");
        }
        assert!(
            updated != text || differences.is_empty(),
            "{page}: correct these lines by hand:\n{differences}"
        );
    } else {
        assert!(
            differences.is_empty(),
            "{page}: commands print other lines (PERCUSS_UPDATE=1 writes them):\n{differences}"
        );
    }
    assert_eq!(count, text.matches("$ percuss ").count(), "{page}: commands are in console blocks");
}

/// Digits of the commands of cases: more than a text for people has, fewer than a search or an integration reproduces.
const CASE_DIGITS: &str = "--digits 6";

/// Runs the commands of a block. Returns the updated block, and adds the outcomes of commands that print other lines.
fn run_block(
    folder: &Scratch,
    (names, digits): (&[(&str, &str)], Option<&'static str>),
    block: &str,
    differences: &mut String,
) -> String {
    let mut updated = String::new();
    for (line, shown) in commands(block) {
        updated += &format!("$ {line}\n");
        let copied = line.strip_prefix("cat ").filter(|files| files.contains(" > "));
        if let Some(edit) = line.strip_prefix("sed ").or(copied) {
            write_edited(folder, edit);
            updated += shown;
            continue;
        }
        let words = line.replace("\\\n", " ");
        let words = words
            .split_whitespace()
            .map(|word| names.iter().find(|(name, _)| *name == word).map_or(word, |(_, words)| words));
        let mut words = words.flat_map(str::split_whitespace).collect::<Vec<_>>();
        if words[0] == "percuss" && words.len() > 1 && !line.contains("--digits") {
            words.splice(1..1, digits.into_iter().flat_map(str::split_whitespace));
        }
        let outcome = run_words(folder, &words);
        if digits.is_none() {
            check_words(&words, &outcome);
        }
        let new = updated_output(shown, &outcome);
        if new.as_deref() != Some(shown) {
            let Outcome { code, stdout, stderr, .. } = outcome;
            *differences += &format!("$ {line}\n{stdout}? {code} {stderr}\n");
        }
        updated += new.as_deref().unwrap_or(shown);
    }
    updated
}

/// Other names of the quantities in the list of `docs/reference/OUTPUTS.md`.
const OTHER_WORDS: [&str; 9] = [
    "penetration",
    "as drawn",
    "energy loss",
    "lost energy",
    "approach speed",
    "contact lasts",
    "contribution",
    "contact/wheel",
    "share of the kinetic",
];

/// Asserts that the text of a command has one name for each quantity and true minus signs. Text to copy and tables for programs are
/// excluded.
fn check_words(words: &[&str], outcome: &Outcome) {
    let commands = ["sweep", "init", "template", "schema", "completions", "check", "generate", "convert"];
    let flags = ["--format", "-h", "--help", "--list-tools", "--list-laws"];
    let is_copied = words.first() != Some(&"percuss")
        || words.get(1).is_none_or(|command| commands.contains(command))
        || words.iter().any(|word| flags.contains(word));
    let stdout = outcome.stdout.lines().filter(|line| !is_copied && !line.starts_with("    "));
    for line in stdout.chain(outcome.stderr.lines()) {
        let other = OTHER_WORDS.iter().find(|word| line.contains(**word));
        assert!(other.is_none(), "{words:?}: {} in {line}", other.unwrap_or(&""));
        let cells: Vec<&str> = line.split_whitespace().collect();
        let is_negative = |pair: &[&str]| {
            let number = pair[1].trim_start_matches('(').trim_end_matches([',', ')', ';', ':']);
            !pair[0].starts_with("--") && number.starts_with('-') && number.parse::<f64>().is_ok()
        };
        assert!(!cells.windows(2).any(is_negative), "{words:?}: a hyphen for a minus sign in {line}");
    }
}

/// Path of a word that names a file: of the repository, or of the folder of the page.
fn path_of(folder: &Scratch, word: &str) -> Option<String> {
    let kinds = [
        "toml", "urdf", "xml", "sdf", "json", "jsonl", "csv", "xlsx", "xlsm", "parquet", "svg", "png", "pdf",
        "html", "stl", "obj", "ply", "txt", "h", "c", "yaml", "pm", "adm",
    ];
    let kind = Path::new(word).extension().and_then(std::ffi::OsStr::to_str);
    let is_file = kind.is_some_and(|kind| kinds.contains(&kind)) || word.starts_with("./");
    let is_shared = word.starts_with("models/") || word.starts_with("tests/");
    (is_file && !is_shared).then(|| folder.path(word.strip_prefix("./").unwrap_or(word)))
}

/// Text of a file of the folder or of the repository.
fn file(folder: &Scratch, name: &str) -> std::io::Result<String> {
    std::fs::read_to_string(path_of(folder, name).map_or_else(|| workshop().join(name), Into::into))
}

/// Runs a command of a page.
fn run_words(folder: &Scratch, words: &[&str]) -> Outcome {
    let paths = |words: &[&str]| -> Vec<String> {
        words.iter().map(|word| path_of(folder, word).unwrap_or_else(|| (*word).to_owned())).collect()
    };
    let mut outcome = match words {
        ["cat", name] => {
            let (code, stdout) = file(folder, name).map_or((1, String::new()), |text| (0, text));
            Outcome { code, stdout, stderr: String::new(), shown: String::new() }
        }
        ["percuss", words @ .., "<", input] => {
            percuss_with_stdin(&paths(words).join(" "), file(folder, input).expect("the input").as_bytes())
        }
        ["percuss", words @ ..] => run(paths(words)),
        _ => panic!("no command of a page: {words:?}"),
    };
    let prefix = folder.path("");
    for text in [&mut outcome.stdout, &mut outcome.stderr] {
        *text = text.replace(&prefix, "").replace("\r\n", "\n");
    }
    outcome
}

/// Writes a file with replacements `s|OLD|NEW|`, each at the first place; `\n` is the end of a line. The rest is `FILE > NEW`.
fn write_edited(folder: &Scratch, edit: &str) {
    let pieces: Vec<&str> = edit.split('|').collect();
    let (files, replacements) = pieces.split_last().expect("a piece");
    let (old, new) =
        files.trim().split_once(" > ").unwrap_or_else(|| panic!("sed s|OLD|NEW| FILE > NEW: {edit}"));
    let text =
        replacements.chunks(3).fold(file(folder, old).expect("a file to change"), |text, replacement| {
            let [_, old, new] = replacement else { panic!("s|OLD|NEW|: {edit}") };
            let [old, new] = [old, new].map(|text| text.replace("\\n", "\n"));
            assert!(text.contains(&old), "{edit}: {old} is not in\n{text}");
            text.replacen(&old, &new, 1)
        });
    folder.write(new, &text);
}

/// Lines below a command after an update; equal to the old ones if these agree with the output. `None` if no update
/// can make them agree.
fn updated_output(shown: &str, outcome: &Outcome) -> Option<String> {
    let start = if shown.starts_with("? ") { Some(0) } else { shown.find("\n? ").map(|at| at + 1) };
    let (stdout, stderr) = shown.split_at(start.unwrap_or(shown.len()));
    let all = format!("{}{}", outcome.stdout, outcome.stderr);
    let mut new = updated_lines(stdout, &outcome.stdout, &all)?;
    if start.is_some() || outcome.code != 0 {
        let messages = stderr.get("? 0".len()..).unwrap_or_default();
        let messages = updated_lines(messages.strip_prefix(' ').unwrap_or(messages), &outcome.stderr, &all)?;
        let gap = if messages.starts_with('\n') || messages.is_empty() { "" } else { " " };
        new += &format!("? {}{gap}{messages}", outcome.code);
    }
    if !new.is_empty() && !new.ends_with('\n') {
        new.push('\n');
    }
    Some(new)
}

/// Lines that occur in the printed text in this order: the old ones, or for a missing one the printed line with the most common
/// words; without lines, the printed text.
fn updated_lines(lines: &str, printed: &str, all: &str) -> Option<String> {
    let mut rest = printed;
    let mut new = String::new();
    for line in lines.lines() {
        new += line;
        if let Some(absent) = line.strip_prefix("! ") {
            if all.contains(absent) {
                return None;
            }
        } else if !line.trim().is_empty() {
            let common = |other: &str| other.split_whitespace().filter(|word| line.contains(word)).count();
            let place = rest.lines().position(|other| agree(line.trim_end(), other.trim_end()));
            let nearest = || rest.lines().enumerate().max_by_key(|(_, other)| common(other));
            let taken = if let Some(place) = place {
                place
            } else {
                new.truncate(new.len() - line.len());
                let (place, other) = nearest()?;
                new += other;
                place
            };
            rest = rest.splitn(taken + 2, '\n').nth(taken + 1).unwrap_or_default();
        }
        new.push('\n');
    }
    if lines.trim().is_empty() && !printed.is_empty() {
        new = printed.to_owned() + &new;
    }
    Some(new)
}

/// True if a printed line has the expected text. Numbers of a whole line may differ by 1e-12 of their value, because the exponential
/// function depends on the system.
fn agree(line: &str, printed: &str) -> bool {
    let mut rest = Some(printed);
    for piece in line.split("...") {
        rest = rest.and_then(|rest| Some(&rest[rest.find(piece)? + piece.len()..]));
    }
    let is_digit = |c: char| c.is_ascii_digit() || c == '.';
    let words = |text: &str| text.replace('~', "").split(is_digit).collect::<String>();
    // Numbers, and the differences that are allowed.
    let numbers = |text: &str| {
        let (mut numbers, mut is_rounded) = (Vec::new(), false);
        for piece in text.split_inclusive(|c| !is_digit(c)) {
            let digits = piece.trim_end_matches(|c| !is_digit(c));
            if let Ok(value) = digits.parse::<f64>() {
                let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
                let unit = if is_rounded { 0.1f64.powi(decimals as i32) } else { 1e-12 * value.abs() };
                numbers.push((value, unit));
            }
            is_rounded = piece.ends_with('~');
        }
        numbers
    };
    let are_close = || {
        let (shown, found) = (numbers(line), numbers(printed));
        shown.len() == found.len()
            && shown.iter().zip(&found).all(|((a, error), (b, _))| (a - b).abs() <= *error)
    };
    rest.is_some() || words(line) == words(printed) && are_close()
}

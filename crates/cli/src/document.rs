//! Contents of the reports: facts, tables, bars, pictures and notes, once for the terminal and for a page.

use crate::files::html::Page;
use crate::terminal::console::{bold, dim};
use crate::terminal::escape::{line, lines};
use crate::terminal::number::true_minus;
use crate::terminal::report::{write_json, write_text};
use crate::terminal::text::Table;
use crate::terminal::wrap::{fact_lines, width, wrap_hanging, wrap_lines};
use crate::{args::CheckFormat, terminal::failure::Failure};
use std::borrow::Cow;

/// Name and value.
pub type Fact = (Cow<'static, str>, String);

/// Part of a document.
enum Block<'a> {
    /// Title of a section, which the contents of a page list.
    Section(&'static str),
    /// Title of the next parts.
    Heading(String),
    /// Main results, each with its meaning.
    Results(Vec<(String, String)>),
    Facts(Vec<Fact>),
    Table(Table),
    /// Picture for a page, and its content for readers without it.
    Picture {
        svg: Box<dyn Fn() -> String + 'a>,
        content: String,
        caption: String,
        is_large: bool,
    },
    /// Explanation of the part before it.
    Note(String),
    /// Remark about the whole result.
    Remark(String),
    /// Text of its own.
    Paragraph(String),
    /// Reason for a missing result.
    Problem(String),
    /// Title, and text to copy.
    Code(String, String),
}

/// Parts of a report in their order.
#[derive(Default)]
pub struct Document<'a> {
    blocks: Vec<Block<'a>>,
}

impl<'a> Document<'a> {
    pub fn section(&mut self, title: &'static str) {
        self.blocks.push(Block::Section(title));
    }

    pub fn heading(&mut self, title: impl Into<String>) {
        self.blocks.push(Block::Heading(title.into()));
    }

    /// Adds the main results: value, and its meaning; further lines of a meaning are below it.
    pub fn results(&mut self, results: impl IntoIterator<Item = (String, String)>) {
        self.blocks.push(Block::Results(results.into_iter().collect()));
    }

    /// Adds names with values; nothing for an empty list.
    pub fn facts<N: Into<Cow<'static, str>>>(&mut self, facts: impl IntoIterator<Item = (N, String)>) {
        let facts: Vec<Fact> = facts.into_iter().map(|(name, value)| (name.into(), value)).collect();
        if !facts.is_empty() {
            self.blocks.push(Block::Facts(facts));
        }
    }

    /// Adds a table; nothing for a table without rows.
    pub fn table(&mut self, table: Table) {
        if !table.is_empty() {
            self.blocks.push(Block::Table(table));
        }
    }

    /// Adds a picture, which only a page shows.
    pub fn picture(&mut self, svg: impl Fn() -> String + 'a, content: &str, caption: impl Into<String>) {
        let (svg, content, caption) = (Box::new(svg), content.to_owned(), caption.into());
        self.blocks.push(Block::Picture { svg, content, caption, is_large: false });
    }

    /// Adds a picture as [`picture`](Self::picture), in print over the width of the page.
    pub fn large_picture(
        &mut self,
        svg: impl Fn() -> String + 'a,
        content: &str,
        caption: impl Into<String>,
    ) {
        let (svg, content, caption) = (Box::new(svg), content.to_owned(), caption.into());
        self.blocks.push(Block::Picture { svg, content, caption, is_large: true });
    }

    /// Adds an explanation of the part before it; nothing for an empty text.
    pub fn note(&mut self, text: impl Into<String>) {
        let text = text.into();
        if !text.is_empty() {
            self.blocks.push(Block::Note(text));
        }
    }

    /// Adds a remark about the whole result; nothing for an empty text.
    pub fn remark(&mut self, text: impl Into<String>) {
        let text = text.into();
        if !text.is_empty() {
            self.blocks.push(Block::Remark(text));
        }
    }

    pub fn paragraph(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Paragraph(text.into()));
    }

    /// Adds the reason for a missing result.
    pub fn problem(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Problem(text.into()));
    }

    /// Adds text to copy.
    pub fn code(&mut self, title: impl Into<String>, text: impl Into<String>) {
        self.blocks.push(Block::Code(title.into(), text.into()));
    }

    /// Text for a terminal, with true minus signs except in text to copy. An empty line separates the parts; headings and notes belong to the part beside them.
    pub fn text(&self) -> String {
        let mut out = String::new();
        let mut joins = true;
        for block in self.blocks.iter().filter(|block| !matches!(block, Block::Picture { .. })) {
            if !joins && !matches!(block, Block::Note(_) | Block::Code(..)) {
                out.push('\n');
            }
            joins = matches!(block, Block::Heading(_) | Block::Section(_));
            match block {
                Block::Section(title) => out += &format!("{}\n", bold(title)),
                Block::Heading(title) => out += &format!("{}\n", bold(&line(title))),
                Block::Results(results) => out += &result_lines(results),
                Block::Facts(facts) => out += &true_minus(&fact_lines(facts)),
                Block::Table(table) => out += &table.to_string(),
                Block::Note(text) | Block::Remark(text) => {
                    out += &(dim(&wrap_lines(&lines(&true_minus(text)))) + "\n")
                }
                Block::Paragraph(text) => out += &(wrap_lines(&lines(&true_minus(text))) + "\n"),
                Block::Problem(text) => out += &(wrap_hanging(&line(&true_minus(text)), 2) + "\n"),
                Block::Code(title, text) => {
                    out += &format!("  {}:\n", line(title));
                    lines(text).lines().for_each(|text| out += &format!("    {text}\n"));
                }
                Block::Picture { .. } => {}
            }
        }
        out
    }

    /// Adds the parts to a page.
    pub fn show(&self, page: &mut Page) {
        for block in &self.blocks {
            match block {
                Block::Section(title) => page.section(title),
                Block::Heading(title) => page.heading(title),
                Block::Facts(facts) => {
                    page.facts(facts.iter().map(|(name, value)| (name.trim_start(), value.clone())));
                }
                Block::Results(results) => {
                    page.facts(results.iter().map(|(value, meaning)| (meaning.as_str(), value.clone())));
                }
                Block::Table(table) => page.table_with_bars(table),
                Block::Picture { svg, content, caption, is_large: false } => {
                    page.picture(&svg(), content, caption)
                }
                Block::Picture { svg, content, caption, is_large: true } => {
                    page.large_picture(&svg(), content);
                    page.paragraph("soft", caption);
                }
                Block::Note(text) | Block::Remark(text) | Block::Paragraph(text) => {
                    page.paragraph("soft", text)
                }
                Block::Problem(text) => page.warning(text),
                Block::Code(title, text) => {
                    page.paragraph("soft intro", &format!("{title}:"));
                    page.code(text.trim_end());
                }
            }
        }
    }
}

/// Writes a report as JSON or as text.
pub fn print<'d, R: serde::Serialize>(
    report: &R,
    format: CheckFormat,
    document: impl FnOnce() -> Document<'d>,
) -> Result<(), Failure> {
    match format {
        CheckFormat::Json => write_json(report),
        CheckFormat::Text => write_text(&document().text()),
    }
}

/// Values in bold in a column, and their meanings beside them.
fn result_lines(results: &[(String, String)]) -> String {
    let widest = results.iter().map(|(value, _)| width(value)).max().unwrap_or(0);
    let mut out = String::new();
    for (value, meaning) in results {
        for (i, text) in lines(&true_minus(meaning)).split('\n').enumerate() {
            let value = if i == 0 { line(value) } else { Cow::Borrowed("") };
            let text = wrap_hanging(&format!("{value:<widest$}  {text}"), widest + 2);
            // The style begins after the width is known.
            out += &match text.strip_prefix(&*value).filter(|_| !value.is_empty()) {
                Some(rest) => bold(&value) + rest,
                None => text,
            };
            out.push('\n');
        }
    }
    out
}

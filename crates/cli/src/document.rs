//! Contents of the reports: facts, tables, bars, pictures and notes, once for the terminal and for a page.

use crate::files::html::Page;
use crate::terminal::escape::{line, lines};
use crate::terminal::report::{write_json, write_out};
use crate::terminal::text::{Table, bars};
use crate::terminal::wrap::{fact_lines, wrap_hanging, wrap_lines};
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
    Facts(Vec<Fact>),
    Table(Table),
    /// Links with their shares of the kinetic energy.
    Shares(Vec<(String, f64)>),
    /// Picture for a page, and its content for readers without it.
    Picture {
        svg: Box<dyn Fn() -> String + 'a>,
        content: String,
        caption: String,
        is_large: bool,
    },
    /// Explanation of the part before it.
    Note(String),
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

    /// Adds bars of the shares of links in the kinetic energy.
    pub fn shares(&mut self, shares: Vec<(String, f64)>) {
        self.blocks.push(Block::Shares(shares));
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

    /// Text for a terminal. An empty line separates the parts; headings and notes belong to the part beside them.
    pub fn text(&self) -> String {
        let mut out = String::new();
        let mut joins = true;
        for block in self.blocks.iter().filter(|block| !matches!(block, Block::Picture { .. })) {
            if !joins && !matches!(block, Block::Note(_) | Block::Code(..)) {
                out.push('\n');
            }
            joins = matches!(block, Block::Heading(_) | Block::Section(_));
            match block {
                Block::Section(title) => out += &format!("{title}\n"),
                Block::Heading(title) => out += &format!("{}\n", line(title)),
                Block::Facts(facts) => out += &fact_lines(facts),
                Block::Table(table) => out += &table.to_string(),
                Block::Shares(shares) => out += &bars(shares),
                Block::Note(text) | Block::Paragraph(text) => out += &(wrap_lines(&lines(text)) + "\n"),
                Block::Problem(text) => out += &(wrap_hanging(&line(text), 2) + "\n"),
                Block::Code(title, text) => {
                    out += &format!("  {title}:\n");
                    text.lines().for_each(|text| out += &format!("    {text}\n"));
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
                Block::Table(table) => page.table(table.rows()),
                Block::Shares(shares) => page.table_of_shares(shares),
                Block::Picture { svg, content, caption, is_large: false } => {
                    page.picture(&svg(), content, caption)
                }
                Block::Picture { svg, content, caption, is_large: true } => {
                    page.large_picture(&svg(), content);
                    page.paragraph("soft", caption);
                }
                Block::Note(text) | Block::Paragraph(text) => page.paragraph("soft", text),
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
        CheckFormat::Text => write_out(&document().text()),
    }
}

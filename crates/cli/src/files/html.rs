//! HTML output: escaped text, tables, and a page without external files.

use crate::terminal::escape;
use percuss_render::MADE_BY;
use std::fmt::Write;

/// Largest number of rows of a table that is not split in print.
const SHORT: usize = 16;

/// Longest word of a cell that is not broken, in characters; longer words would widen the table beyond the page.
const LONGEST_WORD: usize = 24;

/// Style sheet for screens and for A4 paper.
const STYLE: &str = "\
:root{color-scheme:light}*{box-sizing:border-box}\
body{font:15px/1.5 Roboto,'Helvetica Neue',Arial,'Liberation Sans',sans-serif;color:#1c2026;max-width:60rem;margin:2rem auto;padding:0 1.2rem}\
h1{font-size:1.7rem;line-height:1.25;margin:0 0 .3rem;overflow-wrap:anywhere}\
h2{font-size:1.2rem;margin:2.2rem 0 .7rem;padding-bottom:.2rem;border-bottom:2px solid #dce0e6}h3{font-size:1rem;margin:1.3rem 0 .4rem}\
p{margin:.5rem 0;overflow-wrap:anywhere}p.soft,td.soft,figcaption{color:#5c636e}p.head{margin:.1rem 0;color:#5c636e}\
.result{border:1px solid #c9d3df;border-left:6px solid #0072b2;background:#f5f8fb;padding:.7rem 1.1rem .8rem;margin:1.2rem 0;break-inside:avoid}\
p.lead{font-size:1.9rem;font-weight:500;margin:.1rem 0 .3rem}.result td{border-bottom-color:#dfe6ee}\
.warning{border-left:5px solid #d55e00;background:#fdf3ec;padding:.45rem .9rem;margin:.6rem 0;overflow-wrap:anywhere}\
.note{border-left:5px solid #b0b7c1;background:#f6f7f9;padding:.3rem .9rem;margin:.6rem 0;font-size:.88rem;overflow-wrap:anywhere}\
nav{margin:1.2rem 0;columns:2;column-gap:2rem}nav p{margin:.12rem 0;break-inside:avoid}a{color:#0060a0;text-decoration:none}a:hover{text-decoration:underline}\
table{border-collapse:collapse;width:100%;margin:.4rem 0}td,th{padding:.22rem .9rem .22rem 0;text-align:left;vertical-align:top;\
border-bottom:1px solid #e6e9ee}th{font-weight:500;border-bottom-color:#b0b7c1}td.number,th.number{text-align:right;font-variant-numeric:tabular-nums}\
td.number{white-space:nowrap}td.name{width:13rem;color:#5c636e}td.bars{width:45%}td.wrap{white-space:pre-wrap}td.wrap,td.long,th.long,td.name,code{overflow-wrap:anywhere}\
.bar{display:inline-block;height:.7em;background:#d55e00;print-color-adjust:exact;-webkit-print-color-adjust:exact}\
pre{background:#f6f7f9;padding:.7rem;white-space:pre-wrap;overflow-wrap:anywhere;font-size:.82rem}\
table.data{font-size:.9rem;font-variant-numeric:tabular-nums}td.hash{font:.72rem/1.7 monospace}\
figure>svg{max-width:100%;height:auto;display:block}figure{margin:.8rem 0;break-inside:avoid}figcaption{font-size:.9rem;margin-top:.3rem}\
@media(max-width:46rem){nav{columns:1}td.name{width:9rem}}\
@page{size:A4;margin:16mm 16mm 18mm;@bottom-right{content:counter(page) ' / ' counter(pages);font:8pt sans-serif;color:#5c636e}}\
@media print{body{margin:0;padding:0;max-width:none;font-size:10pt}.result{padding:.3rem .8rem .4rem;margin:.6rem 0}p.lead{font-size:1.3rem}h2,h3,h2+p,p.intro,tr:nth-child(-n+3){break-after:avoid}nav{columns:2}a{color:inherit}\
.result,.warning,.note,pre{print-color-adjust:exact;-webkit-print-color-adjust:exact}\
tr,figure,table.short{break-inside:avoid}figure>svg{width:auto;max-height:165mm}figure.large>svg{max-height:150mm}pre{font-size:7.6pt}table.data{font-size:8.4pt}td.hash{font-size:6.4pt}td.name{width:36mm}p{orphans:3;widows:3}}";

/// Path as a relative reference: every byte except letters, digits and `-._~/` is written as `%XX` (RFC 3986, 2.1).
fn percent_encoded(path: &str) -> String {
    let mut out = String::with_capacity(path.len());
    for byte in path.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => {
                out.push(char::from(byte))
            }
            _ => {
                let _ = write!(out, "%{byte:02X}");
            }
        }
    }
    out
}

/// Escapes text between tags.
pub fn escape_text(content: &str) -> String {
    let mut out = String::with_capacity(content.len());
    for c in escape::lines(content).chars() {
        match c {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            c => out.push(c),
        }
    }
    out
}

/// Text at the head of a page.
#[derive(Clone, Debug, Default)]
pub struct Head {
    pub title: String,
    /// Lines below the title, such as object, author and date; empty lines are left out.
    pub lines: Vec<String>,
}

/// Page under construction: head, summary, contents, sections.
pub struct Page {
    head: String,
    /// Content before the first section.
    summary: String,
    /// Titles of the sections.
    sections: Vec<String>,
    out: String,
}

impl Page {
    pub fn new(head: &Head) -> Self {
        let title = escape_text(&head.title);
        // The security policy forbids loading external content and running scripts.
        let mut out = format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"generator\" content=\"{MADE_BY}\">\n\
             <meta name=\"viewport\" content=\"width=device-width\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src \
             'unsafe-inline'\">\n<link rel=\"icon\" href=\"data:,\">\n<title>{title}</title>\n<style>{STYLE}</style>\n\
             </head>\n<body>\n<h1>{title}</h1>\n"
        );
        for line in head.lines.iter().filter(|line| !line.trim().is_empty()) {
            let _ = writeln!(out, "<p class=\"head\">{}</p>", escape_text(line));
        }
        Self { head: out, summary: String::new(), sections: Vec::new(), out: String::new() }
    }

    /// Text to which content is added: the summary before the first section.
    fn body(&mut self) -> &mut String {
        if self.sections.is_empty() { &mut self.summary } else { &mut self.out }
    }

    /// Opens the box of the result, which [`Self::close_result`] closes.
    pub fn open_result(&mut self, value: &str) {
        let _ = writeln!(self.body(), "<div class=\"result\">\n<p class=\"lead\">{}</p>", escape_text(value));
    }

    /// Closes the box of the result.
    pub fn close_result(&mut self) {
        self.body().push_str("</div>\n");
    }

    /// Begins a section, which is listed in the contents.
    pub fn section(&mut self, title: &str) {
        self.sections.push(title.to_owned());
        let number = self.sections.len();
        let _ = writeln!(self.out, "<h2 id=\"s{number}\">{number}. {}</h2>", escape_text(title));
    }

    /// Adds a heading within a section.
    pub fn heading(&mut self, content: &str) {
        let _ = writeln!(self.body(), "<h3>{}</h3>", escape_text(content));
    }

    /// Adds a paragraph with a class of the style sheet.
    pub fn paragraph(&mut self, class: &str, content: &str) {
        let _ = writeln!(self.body(), "<p class=\"{class}\">{}</p>", escape_text(content));
    }

    /// Paragraph with a link to a file.
    pub fn link(&mut self, content: &str, path: &str) {
        let target = percent_encoded(path);
        let _ = writeln!(self.body(), "<p><a href=\"{target}\">{}</a></p>", escape_text(content));
    }

    /// Adds a warning.
    pub fn warning(&mut self, content: &str) {
        let _ = writeln!(self.body(), "<p class=\"warning\">{}</p>", escape_text(content));
    }

    /// Adds a note.
    pub fn note(&mut self, content: &str) {
        let _ = writeln!(self.body(), "<p class=\"note\">{}</p>", escape_text(content));
    }

    /// Adds preformatted text: commands and snippets of code.
    pub fn code(&mut self, content: &str) {
        let _ = writeln!(self.body(), "<pre>{}</pre>", escape_text(content));
    }

    /// Adds a table of names and values.
    pub fn facts<N: AsRef<str>>(&mut self, facts: impl IntoIterator<Item = (N, String)>) {
        self.name_table("wrap", facts);
    }

    /// Adds a table of names and hashes.
    pub fn hashes<N: AsRef<str>>(&mut self, facts: impl IntoIterator<Item = (N, String)>) {
        self.name_table("hash", facts);
    }

    /// Adds a table of names and values of a class.
    fn name_table<N: AsRef<str>>(&mut self, class: &str, facts: impl IntoIterator<Item = (N, String)>) {
        let out = self.body();
        out.push_str("<table>\n");
        for (name, value) in facts {
            let (name, value) = (escape_text(name.as_ref()), escape_text(&value));
            let _ =
                writeln!(out, "<tr><td class=\"name\">{name}</td><td class=\"{class}\">{value}</td></tr>");
        }
        out.push_str("</table>\n");
    }

    /// Adds a table; the first row is the header. Columns of numbers are aligned to the right.
    pub fn table<R: AsRef<[String]>>(&mut self, rows: &[R]) {
        let is_number = numeric_columns(rows);
        // A short table is not split between pages.
        let class = if rows.len() <= SHORT { "data short" } else { "data" };
        let out = self.body();
        let _ = writeln!(out, "<table class=\"{class}\">");
        for (i, row) in rows.iter().enumerate() {
            let tag = if i == 0 { "th" } else { "td" };
            let cell = |(cell, is_number): (&String, &bool)| {
                let has_long_word = cell.split_whitespace().any(|word| word.chars().count() > LONGEST_WORD);
                let class = match (is_number, has_long_word) {
                    (true, _) => " class=\"number\"",
                    (false, true) => " class=\"long\"",
                    (false, false) => "",
                };
                // A percent sign stays on the line of its number.
                format!("<{tag}{class}>{}</{tag}>", escape_text(cell).replace(" %", "\u{a0}%"))
            };
            let cells: String = row.as_ref().iter().zip(&is_number).map(cell).collect();
            let (begin, end) = if i == 0 { ("<thead>", "</thead>") } else { ("", "") };
            let _ = writeln!(out, "{begin}<tr>{cells}</tr>{end}");
        }
        out.push_str("</table>\n");
    }

    /// Adds a table of the shares of links in the kinetic energy, with bars.
    pub fn table_of_shares(&mut self, parts: &[(String, f64)]) {
        let class = if parts.len() <= SHORT { "short" } else { "long" };
        let out = self.body();
        let _ = writeln!(
            out,
            "<table class=\"{class}\">\n<thead><tr><th>link</th><th class=\"number\">share of the kinetic energy</th><th></th></tr></thead>"
        );
        for (name, part) in parts {
            let width = 100.0 * part.clamp(0.0, 1.0);
            let _ = writeln!(
                out,
                "<tr><td class=\"wrap\">{}</td><td class=\"number\">{:.2} %</td>\
                 <td class=\"bars\"><span class=\"bar\" style=\"width:{width:.2}%\"></span></td></tr>",
                escape_text(name),
                100.0 * part
            );
        }
        out.push_str("</table>\n");
    }

    /// Adds an SVG of the renderer, which escapes all its text, with a caption below. Inline elements show the names of points
    /// under the pointer.
    pub fn picture(&mut self, svg: &str, content: &str, caption: &str) {
        self.figure(svg, content, caption, "");
    }

    /// Adds an SVG as [`picture`](Self::picture), in print over the width of the page.
    pub fn large_picture(&mut self, svg: &str, content: &str) {
        self.figure(svg, content, "", " class=\"large\"");
    }

    /// Adds a figure with attributes.
    fn figure(&mut self, svg: &str, content: &str, caption: &str, attributes: &str) {
        let caption = match caption {
            "" => String::new(),
            caption => format!("<figcaption>{}</figcaption>", escape_text(caption)),
        };
        let content = escape_text(content);
        let _ = writeln!(
            self.body(),
            "<figure{attributes} aria-label=\"{content}\">{}{caption}</figure>",
            svg.trim_end().replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1)
        );
    }

    /// Text of the complete page: head, summary, contents, sections.
    pub fn finish(self) -> String {
        let link = |(i, title): (usize, &String)| {
            let number = i + 1;
            format!("<p><a href=\"#s{number}\">{number}. {}</a></p>\n", escape_text(title))
        };
        let contents: String = self.sections.iter().enumerate().map(link).collect();
        format!("{}{}<nav>\n{contents}</nav>\n{}</body>\n</html>\n", self.head, self.summary, self.out)
    }
}

/// True for each column with numbers only, apart from the header and empty cells. A percent sign may follow. The first
/// column names the rows and is never one.
fn numeric_columns<R: AsRef<[String]>>(rows: &[R]) -> Vec<bool> {
    let is_number = |cell: &str| cell.trim_end_matches(" %").replace('−', "-").parse::<f64>().is_ok();
    let is_numeric = |k: usize| {
        let cells = rows.iter().skip(1).filter_map(|row| row.as_ref().get(k)).map(String::as_str);
        let mut cells = cells.filter(|cell| !["", "–"].contains(cell));
        let any = cells.clone().next().is_some();
        k > 0 && any && cells.all(is_number)
    };
    (0..rows.first().map_or(0, |row| row.as_ref().len())).map(is_numeric).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contents_link_to_the_sections() {
        let mut page = Page::new(&Head { title: "<b>".into(), lines: vec!["of A & B".into(), " ".into()] });
        page.open_result("1 kg");
        page.close_result();
        page.section("One <i>");
        page.section("Two");
        let text = page.finish();
        assert!(
            text.contains("<h1>&lt;b&gt;</h1>\n<p class=\"head\">of A &amp; B</p>\n<div class=\"result\">")
        );
        assert!(text.contains("<a href=\"#s2\">2. Two</a>") && text.contains("<h2 id=\"s2\">2. Two</h2>"));
        assert!(!text.contains("<i>") && text.find("1 kg") < text.find("<nav>"));
    }

    #[test]
    fn columns_of_numbers_are_aligned() {
        let rows = [["a", "b", "c"], ["2", "-1.5", "2 %"], ["1", "", "–"]].map(|row| row.map(str::to_owned));
        assert_eq!(numeric_columns(&rows), [false, true, true]);
    }
}

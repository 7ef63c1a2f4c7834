//! HTML output: escaped text, tables, and a page without external files.

use crate::terminal::escape;
use crate::terminal::number::true_minus;
use crate::terminal::text::{Table, numeric_columns};
use percuss_render::MADE_BY;
use std::borrow::Cow;
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
td.number{white-space:nowrap}td.name{width:13rem;color:#5c636e}td.bars{width:30%;min-width:4.5rem}tr.sum td{border-top:1px solid #1c2026;border-bottom:0;font-weight:600}.scroll{overflow-x:auto}td.wrap{white-space:pre-wrap}td.wrap,td.long,th.long,td.name,code{overflow-wrap:anywhere}\
.bar{display:inline-block;height:.7em;background:#d55e00;print-color-adjust:exact;-webkit-print-color-adjust:exact}\
pre{background:#f6f7f9;padding:.7rem;white-space:pre-wrap;overflow-wrap:anywhere;font-size:.82rem}\
table.data{font-size:.9rem;font-variant-numeric:tabular-nums}td.hash{font:.72rem/1.7 monospace;overflow-wrap:anywhere}\
figure svg{max-width:100%;height:auto;display:block}figure .scroll svg{min-width:52.5rem}figure{margin:.8rem 0;break-inside:avoid}figcaption{font-size:.9rem;margin-top:.3rem}\
p.sentence{font-size:1.35rem;line-height:1.4;margin:1rem 0}p.sentence b{color:#9b3407}\
.numbers{display:grid;grid-template-columns:repeat(auto-fit,minmax(9.5rem,1fr));border:1px solid #cfd5dc;border-left:5px solid #be3c0a;margin:.8rem 0}\
.numbers div{padding:.5rem .9rem;border-left:1px solid #e2e6ea}.numbers div:first-child{border-left:0}.numbers small,.numbers em{display:block;font-style:normal;font-size:.8rem;color:#5c636e}\
.numbers b{font-size:1.5rem}.numbers b span{font-size:.95rem;font-weight:400}\
.quadrants{display:grid;grid-template-columns:1fr 1fr;gap:.6rem 1.8rem}.quadrants>div{min-width:0;break-inside:avoid}.quadrants h3{border-bottom:1px solid #cfd5dc;margin:.4rem 0 .2rem;padding-bottom:.15rem}\
.quadrants figure{margin:.2rem 0}.quadrants table.data{font-size:.85rem}.quadrants td,.quadrants th{padding:.14rem .5rem .14rem 0}.quadrants svg{width:100%}\
.foot{border-top:2px solid #1c2026;margin-top:.8rem;padding-top:.4rem;display:grid;grid-template-columns:1fr 1fr;gap:0 1.8rem;font-size:.82rem;color:#3b4450}.foot p{margin:.15rem 0}\
@media(max-width:46rem){nav{columns:1}td.name{width:9rem}.quadrants,.foot{grid-template-columns:1fr}body{margin:1rem auto;padding:0 .85rem}}\
@page{size:A4;margin:16mm 16mm 18mm;@bottom-right{content:counter(page) ' / ' counter(pages);font:8pt sans-serif;color:#5c636e}}\
@media print{body{margin:0;padding:0;max-width:none;font-size:10pt;line-height:1.35}.result{padding:.3rem .8rem .4rem;margin:.6rem 0}p.lead{font-size:1.3rem}h2,h3,h2+p,p.intro,tr:nth-child(-n+3){break-after:avoid}nav{columns:2}a{color:inherit}\
.result,.warning,.note,pre{print-color-adjust:exact;-webkit-print-color-adjust:exact}\
nav.next{break-before:page}p.sentence{font-size:13pt;line-height:1.3;margin:2mm 0}h1{font-size:16pt}.numbers b{font-size:14pt}.numbers div{padding:1.2mm 2.5mm}.numbers small,.numbers em,.foot{font-size:7.6pt}.quadrants table.data{font-size:8pt}.quadrants td,.quadrants th{padding:.35mm 1.5mm .35mm 0}\
.quadrants,.foot{grid-template-columns:1fr 1fr}.quadrants figure svg{max-height:60mm}.quadrants{gap:1mm 6mm}.quadrants h3{font-size:10pt;margin:1.5mm 0 .5mm}.quadrants p{margin:1mm 0;font-size:8pt}.note,.warning{padding:1mm 3mm;margin:1.5mm 0;font-size:8.5pt}.numbers{margin:2mm 0}p.head{font-size:8pt}.numbers,.bar{print-color-adjust:exact;-webkit-print-color-adjust:exact}tr,figure,table.short{break-inside:avoid}figure svg,figure .scroll svg{width:auto;min-width:0;max-height:165mm}figure.large svg,figure.large .scroll svg{max-height:150mm}pre{font-size:7.6pt}table.data{font-size:8.4pt}td.hash{font-size:6.4pt}td.name{width:36mm}p{orphans:3;widows:3}}";

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

/// Escapes text for people, with true minus signs and without remarks about flags: a reader of a page has no terminal.
fn prose(content: &str) -> String {
    escape_text(&true_minus(&without_flags(content)))
}

/// Text without the parts that name a flag: brackets, and clauses of a sentence.
fn without_flags(content: &str) -> Cow<'_, str> {
    if !content.contains("--") {
        return Cow::Borrowed(content);
    }
    let mut kept = String::new();
    let mut rest = content;
    // Brackets with a flag.
    while let Some((before, bracket)) = rest.split_once('(') {
        let Some((inside, after)) = bracket.split_once(')') else { break };
        if inside.contains("--") {
            kept += before.trim_end();
        } else {
            kept += &format!("{before}({inside})");
        }
        rest = after;
    }
    kept += rest;
    // Clauses with a flag; the last of a sentence takes the end of the sentence with it.
    let mut sentences: Vec<String> = Vec::new();
    for sentence in kept.split_inclusive(". ") {
        let clauses: Vec<&str> =
            sentence.split_inclusive("; ").filter(|clause| !clause.contains("--")).collect();
        if clauses.is_empty() {
            continue;
        }
        let text = clauses.concat();
        let end = if sentence.trim_end().ends_with('.') { ". " } else { "" };
        sentences.push(text.trim_end().trim_end_matches([';', '.', ',']).to_owned() + end);
    }
    Cow::Owned(sentences.concat().trim_end().to_owned())
}

/// Text at the head of a page.
#[derive(Clone, Debug, Default)]
pub struct Head {
    pub title: String,
    /// Lines below the title, such as object, author and date; empty lines are left out.
    pub lines: Vec<String>,
}

/// Main number of a page: what it is, value with unit, and a remark.
#[derive(Clone, Debug, Default)]
pub struct MainNumber {
    pub label: String,
    pub value: String,
    pub note: String,
}

/// Page under construction: head, summary, contents, sections.
pub struct Page {
    head: String,
    /// Content before the first section.
    summary: String,
    /// Titles of the sections.
    sections: Vec<String>,
    out: String,
    /// True if the summary is a page of its own.
    has_first_page: bool,
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
        let lines: Vec<&str> =
            head.lines.iter().map(String::as_str).filter(|line| !line.trim().is_empty()).collect();
        if !lines.is_empty() {
            let _ = writeln!(out, "<p class=\"head\">{}</p>", escape_text(&lines.join(" · ")));
        }
        Self {
            head: out,
            summary: String::new(),
            sections: Vec::new(),
            out: String::new(),
            has_first_page: false,
        }
    }

    /// Text to which content is added: the summary before the first section.
    fn body(&mut self) -> &mut String {
        if self.sections.is_empty() { &mut self.summary } else { &mut self.out }
    }

    /// Opens the box of the result, which [`Self::close_result`] closes.
    pub fn open_result(&mut self, value: &str) {
        let _ = writeln!(self.body(), "<div class=\"result\">\n<p class=\"lead\">{}</p>", prose(value));
    }

    /// Closes the box of the result.
    pub fn close_result(&mut self) {
        self.body().push_str("</div>\n");
    }

    /// Adds the result as a sentence, with the words between `**` in bold.
    pub fn sentence(&mut self, content: &str) {
        let parts = content.split("**").enumerate();
        let text: String = parts
            .map(|(i, part)| if i % 2 == 1 { format!("<b>{}</b>", prose(part)) } else { prose(part) })
            .collect();
        let _ = writeln!(self.body(), "<p class=\"sentence\">{text}</p>");
    }

    /// Adds the main numbers side by side.
    pub fn numbers(&mut self, numbers: &[MainNumber]) {
        let cell = |number: &MainNumber| {
            let [label, value, note] = [&number.label, &number.value, &number.note].map(|text| prose(text));
            // The unit is smaller than the number.
            let (figure, unit) = value.split_once(' ').unwrap_or((&value, ""));
            format!("<div><small>{label}</small><b>{figure} <span>{unit}</span></b><em>{note}</em></div>")
        };
        let cells: String = numbers.iter().map(cell).collect();
        let _ = writeln!(self.body(), "<div class=\"numbers\">{cells}</div>");
    }

    /// Opens the quadrants of the first page, which [`Self::close_quadrants`] closes.
    pub fn open_quadrants(&mut self) {
        self.body().push_str("<div class=\"quadrants\">\n");
    }

    /// Closes the quadrants, and ends the first page with its foot: names in bold with their texts.
    pub fn close_quadrants(&mut self, foot: &[(&str, String)]) {
        let part = |(name, text): &(&str, String)| format!("<p><b>{name}</b> {}</p>", escape_text(text));
        let parts: String = foot.iter().map(part).collect();
        let _ = writeln!(self.body(), "</div>\n<div class=\"foot\">{parts}</div>");
        self.has_first_page = true;
    }

    /// Opens a quadrant with its title.
    pub fn open_quadrant(&mut self, title: &str) {
        let _ = writeln!(self.body(), "<div><h3>{}</h3>", prose(title));
    }

    /// Closes a quadrant.
    pub fn close_quadrant(&mut self) {
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
        let _ = writeln!(self.body(), "<h3>{}</h3>", prose(content));
    }

    /// Adds a paragraph with a class of the style sheet.
    pub fn paragraph(&mut self, class: &str, content: &str) {
        let _ = writeln!(self.body(), "<p class=\"{class}\">{}</p>", prose(content));
    }

    /// Paragraph with a link to a file.
    pub fn link(&mut self, content: &str, path: &str) {
        let target = percent_encoded(path);
        let _ = writeln!(self.body(), "<p><a href=\"{target}\">{}</a></p>", escape_text(content));
    }

    /// Adds a warning.
    pub fn warning(&mut self, content: &str) {
        let _ = writeln!(self.body(), "<p class=\"warning\">{}</p>", prose(content));
    }

    /// Adds a note.
    pub fn note(&mut self, content: &str) {
        let _ = writeln!(self.body(), "<p class=\"note\">{}</p>", prose(content));
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
            let (name, value) = (prose(name.as_ref()), prose(&value));
            let _ =
                writeln!(out, "<tr><td class=\"name\">{name}</td><td class=\"{class}\">{value}</td></tr>");
        }
        out.push_str("</table>\n");
    }

    /// Adds a table; the first row is the header. Columns of numbers are aligned to the right.
    pub fn table<R: AsRef<[String]>>(&mut self, rows: &[R]) {
        self.rows(rows, &[], false);
    }

    /// Adds a table with its bars and its sum.
    pub fn table_with_bars(&mut self, table: &Table) {
        self.rows(&table.rows(), table.bars(), table.has_sum());
    }

    /// Adds the rows of a table, in a box of its own that scrolls on a narrow screen.
    fn rows<R: AsRef<[String]>>(&mut self, rows: &[R], bars: &[f64], has_sum: bool) {
        let is_number = numeric_columns(rows);
        // A short table is not split between pages.
        let class = if rows.len() <= SHORT { "data short" } else { "data" };
        let out = self.body();
        let _ = writeln!(out, "<div class=\"scroll\"><table class=\"{class}\">");
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
                format!("<{tag}{class}>{}</{tag}>", prose(cell).replace(" %", "\u{a0}%"))
            };
            let mut cells: String = row.as_ref().iter().zip(&is_number).map(cell).collect();
            if !bars.is_empty() {
                let bar = i.checked_sub(1).and_then(|at| bars.get(at)).map_or_else(String::new, |length| {
                    format!("<span class=\"bar\" style=\"width:{:.1}%\"></span>", 100.0 * length)
                });
                cells += &format!("<{tag} class=\"bars\">{bar}</{tag}>");
            }
            let (begin, end) = match i {
                0 => ("<thead><tr>", "</tr></thead>"),
                _ if has_sum && i + 1 == rows.len() => ("<tr class=\"sum\">", "</tr>"),
                _ => ("<tr>", "</tr>"),
            };
            let _ = writeln!(out, "{begin}{cells}{end}");
        }
        out.push_str("</table></div>\n");
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
            caption => format!("<figcaption>{}</figcaption>", prose(caption)),
        };
        let content = escape_text(content);
        // A picture of the width of a page scrolls on a narrow screen, so that its text stays readable.
        let class = if svg.contains(" width=\"360\"") { "" } else { " class=\"scroll\"" };
        let _ = writeln!(
            self.body(),
            "<figure{attributes} aria-label=\"{content}\"><div{class}>{}</div>{caption}</figure>",
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
        let nav = if self.has_first_page { "<nav class=\"next\">" } else { "<nav>" };
        format!("{}{}{nav}\n{contents}</nav>\n{}</body>\n</html>\n", self.head, self.summary, self.out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_name_no_flags() {
        for (text, shown) in [
            ("none in the model (--armature JOINT=1)", "none in the model"),
            ("Needs 0.3; give --friction to check it. One more.", "Needs 0.3. One more."),
            ("All axes (left). --format json contains all axes.", "All axes (left)."),
            ("a; b -- c", "a"),
        ] {
            assert_eq!(without_flags(text), shown);
        }
    }

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
}

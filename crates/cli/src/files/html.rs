//! HTML output: escaped text, tables, and a page without external files.

use crate::terminal::escape;
use base64::Engine;
use percuss_render::MADE_BY;
use std::fmt::Write;

/// Largest number of rows of a table that is not split in print.
const SHORT: usize = 16;

/// Style sheet for screens and for A4 paper.
const STYLE: &str = "\
:root{color-scheme:light}\
body{font:15px/1.5 Roboto,'Helvetica Neue',Arial,sans-serif;color:#1c2026;max-width:60rem;margin:2rem auto;padding:0 1.2rem}\
h1{font-size:1.6rem;margin:0 0 .2rem}h2{font-size:1.15rem;margin:2rem 0 .6rem;border-bottom:1px solid #dce0e6}\
p.lead{font-size:1.4rem;margin:.8rem 0}p.soft,td.soft{color:#5c636e}\
table{border-collapse:collapse;width:100%}td,th{padding:.22rem .8rem .22rem 0;text-align:left;vertical-align:top;\
border-bottom:1px solid #eef0f3}th{font-weight:500}td.number{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}\
td.name{width:13rem;color:#5c636e}td.wrap{white-space:pre-wrap}td.wrap,code{overflow-wrap:anywhere}\
.bar{display:inline-block;height:.7em;background:#d55e00;print-color-adjust:exact;-webkit-print-color-adjust:exact}\
pre{background:#f6f7f9;padding:.7rem;white-space:pre-wrap;overflow-wrap:anywhere;font-size:.82rem}\
table.data{font-size:.9rem;font-variant-numeric:tabular-nums}\
img{max-width:100%;height:auto}figure{margin:.6rem 0;break-inside:avoid}\
@page{size:A4;margin:16mm}@media print{body{margin:0;max-width:none;font-size:10.5pt}h2{break-after:avoid}\
tr,figure,table.short{break-inside:avoid}pre{font-size:7.6pt}table.data{font-size:8.4pt}}";

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

/// Page under construction.
pub struct Page {
    out: String,
}

impl Page {
    pub fn new(title: &str) -> Self {
        let title = escape_text(title);
        // The security policy forbids loading external content and running scripts.
        let out = format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"generator\" content=\"{MADE_BY}\">\n\
             <meta name=\"viewport\" content=\"width=device-width\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src \
             'unsafe-inline'\">\n<link rel=\"icon\" href=\"data:,\">\n<title>{title}</title>\n<style>{STYLE}</style>\n\
             </head>\n<body>\n<h1>{title}</h1>\n"
        );
        Self { out }
    }

    /// Adds a heading.
    pub fn heading(&mut self, content: &str) {
        let _ = writeln!(self.out, "<h2>{}</h2>", escape_text(content));
    }

    /// Adds a paragraph with a class of the style sheet.
    pub fn paragraph(&mut self, class: &str, content: &str) {
        let _ = writeln!(self.out, "<p class=\"{class}\">{}</p>", escape_text(content));
    }

    /// Adds preformatted text.
    pub fn code(&mut self, content: &str) {
        let _ = writeln!(self.out, "<pre>{}</pre>", escape_text(content));
    }

    /// Adds a table of names and values.
    pub fn facts<'f>(&mut self, facts: impl IntoIterator<Item = (&'f str, String)>) {
        self.out += "<table>\n";
        for (name, value) in facts {
            let _ = writeln!(
                self.out,
                "<tr><td class=\"name\">{}</td><td class=\"wrap\">{}</td></tr>",
                escape_text(name),
                escape_text(&value)
            );
        }
        self.out += "</table>\n";
    }

    /// Adds a table; the first row is the header.
    pub fn table<const N: usize>(&mut self, rows: &[[String; N]]) {
        self.out += "<table class=\"data\">\n";
        for (i, row) in rows.iter().enumerate() {
            let tag = if i == 0 { "th" } else { "td" };
            let cells: String =
                row.iter().map(|cell| format!("<{tag}>{}</{tag}>", escape_text(cell))).collect();
            let (begin, end) = if i == 0 { ("<thead>", "</thead>") } else { ("", "") };
            let _ = writeln!(self.out, "{begin}<tr>{cells}</tr>{end}");
        }
        self.out += "</table>\n";
    }

    /// Adds a table of shares of a whole, with bars.
    pub fn table_of_shares(&mut self, names: &str, parts: &[(String, f64)]) {
        // A short table is not split between pages.
        let class = if parts.len() <= SHORT { "short" } else { "long" };
        let _ = writeln!(
            self.out,
            "<table class=\"{class}\">\n<tr><th>{}</th><th></th><th></th></tr>",
            escape_text(names)
        );
        for (name, part) in parts {
            let width = 16.0 * part.clamp(0.0, 1.0);
            let _ = writeln!(
                self.out,
                "<tr><td class=\"wrap\">{}</td><td class=\"number\">{:.2} %</td>\
                 <td><span class=\"bar\" style=\"width:{width:.2}rem\"></span></td></tr>",
                escape_text(name),
                100.0 * part
            );
        }
        self.out += "</table>\n";
    }

    /// Adds an SVG as an image, which isolates its contents from the page.
    pub fn picture(&mut self, svg: &str, content: &str) {
        let data = base64::engine::general_purpose::STANDARD.encode(svg);
        let _ = writeln!(
            self.out,
            "<figure><img alt=\"{}\" src=\"data:image/svg+xml;base64,{data}\"></figure>",
            escape_text(content)
        );
    }

    /// Text of the complete page.
    pub fn finish(mut self) -> String {
        self.out += "</body>\n</html>\n";
        self.out
    }
}

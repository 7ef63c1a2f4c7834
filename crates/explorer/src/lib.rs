//! Page of `percuss explore`: one HTML file without requests, with the engine as WebAssembly.
//!
//! The folder `page` has the sources in TypeScript and the bundle made of them by `page/build.mjs`, `page/dist`, which this crate
//! contains. The feature `engine` adds the WebAssembly module, which the build script builds.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::Value;
use sha2::{Digest, Sha256};

const SCRIPT: &str = include_str!("../page/dist/page.js");
const STYLE: &str = include_str!("../page/dist/page.css");

/// WebAssembly module of `percuss-web`, compressed as an .lzma file; `None` in a build without the feature `engine`.
#[cfg(feature = "engine")]
pub const ENGINE: Option<&[u8]> = Some(include_bytes!(concat!(env!("OUT_DIR"), "/percuss.wasm.lzma")));
/// WebAssembly module of `percuss-web`, compressed as an .lzma file; `None` in a build without the feature `engine`.
#[cfg(not(feature = "engine"))]
pub const ENGINE: Option<&[u8]> = None;

/// Content of a page.
#[derive(Clone, Debug)]
pub struct PageContent<'a> {
    /// Title of the page.
    pub title: &'a str,
    /// Mark of the program in the head of the page.
    pub generator: &'a str,
    /// Model files and the question at first sight, as the script reads them.
    pub start: &'a Value,
    /// WebAssembly module, compressed as an .lzma file.
    pub engine: &'a [u8],
}

/// Page as HTML. The content security policy permits the script and the style of the page by their hashes, WebAssembly, and a
/// worker made by the script; no request is permitted.
pub fn page(content: &PageContent) -> String {
    let hash = |text: &str| format!("'sha256-{}'", STANDARD.encode(Sha256::digest(text.as_bytes())));
    let policy = format!(
        "default-src 'none'; script-src {} 'wasm-unsafe-eval'; worker-src blob:; style-src {}; img-src data: blob:; \
         base-uri 'none'; form-action 'none'",
        hash(SCRIPT),
        hash(STYLE)
    );
    let title = escape_text(content.title);
    let engine = STANDARD.encode(content.engine);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"generator\" content=\"{generator}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">\n\
         <link rel=\"icon\" href=\"data:,\">\n<title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n\
         <div id=\"app\"><p class=\"boot\">The page needs JavaScript: it computes the effective mass in this browser.</p></div>\n\
         <script type=\"application/json\" id=\"start\">{start}</script>\n\
         <script type=\"application/octet-stream\" id=\"engine\">{engine}</script>\n\
         <script>{SCRIPT}</script>\n</body>\n</html>\n",
        generator = escape_text(content.generator),
        start = script_data(content.start),
    )
}

/// JSON for a script element: `<` is escaped, so that no text of a model ends the element.
fn script_data(value: &Value) -> String {
    value.to_string().replace('<', "\\u003c")
}

fn escape_text(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

//! Parts of HTML pages. Each page is one file that needs no other file and no scripts, for light, dark and print.

use std::fmt::Write as _;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::diagnostics::Language;
use crate::trace::film::{Packing, write_rgb8};

/// Colours as CSS variables, for light, dark and print: Okabe and Ito's palette, darker or lighter where text uses it.
pub const VARIABLES: &str = "\
:root{--bg:#fff;--fg:#1b1f24;--mut:#5b6470;--line:#d7dce2;--card:#f5f7f9;--acc:#0072b2;--c1:#0072b2;--c2:#d55e00;\
--c3:#00795a;--c4:#a8578a;--c5:#0072b2;--c6:#7a5c00;--goal:#b00020;--floor:#e4e0d2;--bar:#7fb2d6}
@media (prefers-color-scheme:dark){:root{--bg:#14181d;--fg:#e8ebee;--mut:#9aa5b1;--line:#343c46;--card:#1d232a;\
--acc:#6cb8ee;--c1:#6cb8ee;--c2:#ff9a4d;--c3:#43c59e;--c4:#e29cc8;--c5:#6cb8ee;--c6:#e6c65c;--goal:#ff7d7d;\
--floor:#33301f;--bar:#3c6d92}}
@media print{:root{--bg:#fff;--fg:#000;--mut:#444;--line:#bbb;--card:#fff;--acc:#0072b2;--c1:#0072b2;--c2:#d55e00;\
--c3:#00795a;--c4:#a8578a;--c5:#0072b2;--c6:#7a5c00;--goal:#b00020;--floor:#eee;--bar:#9cc3df}}
";

/// The style that all pages share.
const STYLE: &str = "\
*{box-sizing:border-box;min-width:0}
body{margin:0;background:var(--bg);color:var(--fg);font:15px/1.5 system-ui,'DejaVu Sans',sans-serif}
.mut{color:var(--mut)}.small{font-size:13px}
";

/// The beginning of a page, up to where its content starts. `title` is escaped already; `style` is CSS of this page.
pub fn head(language: Language, title: &str, style: &str) -> String {
    let tag = language.tag();
    format!(
        "<!doctype html>\n<html lang=\"{tag}\"><head><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width\"><meta name=\"color-scheme\" content=\"light dark\">\
         <title>{title}</title>\n<style>\n{VARIABLES}{STYLE}{style}</style></head><body><main>"
    )
}

/// Escapes text for XML.
pub fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;").replace('"', "&quot;")
}

/// Escapes text for HTML; parts in backquotes, as `--depth 16`, become `<code>`.
pub fn prose(text: &str) -> String {
    let mut out = String::new();
    for (i, part) in text.split('`').enumerate() {
        match i % 2 {
            0 => out.push_str(&escaped(part)),
            _ => {
                let _ = write!(out, "<code>{}</code>", escaped(part));
            }
        }
    }
    out
}

/// A picture of 8-bit RGB, row by row, as a `data:` address of a PNG.
pub fn address(width: u32, height: u32, rgb: &[u8]) -> String {
    let mut bytes = Vec::new();
    // Writing to memory cannot fail.
    let _ = write_rgb8(&mut bytes, [width, height], rgb, Packing::Small);
    format!("data:image/png;base64,{}", STANDARD.encode(&bytes))
}

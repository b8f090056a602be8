//! A page as one HTML file: no scripts, nothing from elsewhere, fit for paper.

use assemcad_model::report::Verdict;
use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::blocks::{Block, Page, Table, word};

/// Forbids the browser everything but the page's own style.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'";

const STYLE: &str = "
:root{color-scheme:light dark}
body{font:15px/1.5 system-ui,sans-serif;max-width:75em;margin:2em auto;padding:0 1em}
h2{margin-top:2em;border-bottom:1px solid #8886}
table{border-collapse:collapse;font-variant-numeric:tabular-nums}
.scroll{overflow-x:auto}
th,td{border:1px solid #8886;padding:.25em .6em;text-align:left;vertical-align:top;overflow-wrap:anywhere}
th{white-space:nowrap}
dl{display:grid;grid-template-columns:max-content 1fr;gap:.1em 1em}
dt{opacity:.7}
dd{margin:0;overflow-wrap:anywhere}
pre{padding:.6em;border:1px solid #8886;white-space:pre-wrap;overflow-wrap:anywhere}
.verdict{font-size:1.2em}
b.pass,b.indeterminate,b.fail{color:#fff;padding:.1em .5em;border-radius:.3em}
b.pass{background:#2e7d32}
b.indeterminate{background:#8a6100}
b.fail{background:#b3261e}
@media print{body{max-width:none;margin:0}h2{break-after:avoid}tr{break-inside:avoid}}
";

/// Renders a page. All texts are escaped.
#[must_use]
pub fn render(page: &Page) -> String {
    let markup = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                title { (page.title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { (page.title) }
                @for block in &page.blocks { (rendered(block)) "\n" }
            }
        }
    };
    let mut text = markup.into_string();
    text.push('\n');
    text
}

fn badge(verdict: Verdict) -> Markup {
    html! { b class=(word(verdict)) { (word(verdict)) } }
}

fn rendered(block: &Block) -> Markup {
    match block {
        Block::Verdict(verdict, told) => {
            html! { p class="verdict" { (badge(*verdict)) " " (told) "." } }
        }
        Block::Heading(2, title) => html! { h2 { (title) } },
        Block::Heading(_, title) => html! { h3 { (title) } },
        Block::Finding(verdict, title) => html! { h3 { (badge(*verdict)) " " (title) } },
        Block::Text(told) => html! { p { (told) } },
        Block::List(items) => html! { ul { @for item in items { li { (item) } } } },
        Block::Pairs(pairs) => html! {
            dl { @for (name, value) in pairs { dt { (name) } dd { (value) } } }
        },
        Block::Table(table) => rows(table),
        Block::Code(code) => html! { pre { code { (code) } } },
    }
}

fn rows(table: &Table) -> Markup {
    html! {
        div class="scroll" {
            table {
                thead { tr { @for head in &table.heads { th { (head) } } } }
                tbody {
                    @for row in &table.rows {
                        tr { @for cell in row { td { (cell) } } }
                    }
                }
            }
        }
    }
}

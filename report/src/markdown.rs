//! A page as Markdown (CommonMark with GitHub's tables).

use crate::blocks::{Block, Page, Table, word};

/// Renders a page.
#[must_use]
pub fn render(page: &Page) -> String {
    let mut out = format!("# {}\n", text(&page.title));
    for block in &page.blocks {
        out.push('\n');
        out.push_str(&rendered(block));
    }
    out
}

fn rendered(block: &Block) -> String {
    match block {
        Block::Verdict(verdict, told) => {
            format!("**Verdict: {}**. {}.\n", word(*verdict), text(told))
        }
        Block::Heading(level, title) => {
            format!("{} {}\n", "#".repeat(usize::from(*level)), text(title))
        }
        Block::Finding(verdict, title) => format!("### {} ({})\n", text(title), word(*verdict)),
        Block::Text(told) => format!("{}\n", text(told)),
        Block::List(items) => items.iter().map(|i| format!("- {}\n", text(i))).collect(),
        Block::Pairs(pairs) => pairs
            .iter()
            .map(|(name, value)| format!("- {}: {}\n", text(name), text(value)))
            .collect(),
        Block::Table(table) => rows(table),
        Block::Code(code) => fenced(code),
    }
}

fn rows(table: &Table) -> String {
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut out = line(table.heads.iter().map(|h| text(h)).collect());
    out.push_str(&line(
        table.heads.iter().map(|_| "---".to_owned()).collect(),
    ));
    for row in &table.rows {
        out.push_str(&line(row.iter().map(|cell| text(cell)).collect()));
    }
    out
}

/// A block of code, its fence longer than any run of backticks in it.
fn fenced(code: &str) -> String {
    let longest = code
        .split(|c| c != '`')
        .map(str::len)
        .max()
        .unwrap_or_default();
    let fence = "`".repeat(longest.max(2) + 1);
    // A line break or another control character would end what is to be copied.
    let code: String = code
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    format!("{fence}\n{code}\n{fence}\n")
}

/// A text that means nothing to Markdown or HTML, on one line.
fn text(plain: &str) -> String {
    let mut out = String::with_capacity(plain.len());
    let mut start = true;
    let mut chars = plain.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\\' | '`' | '*' | '_' | '[' | ']' | '|' | '~' | '$' => {
                out.push('\\');
                out.push(c);
            }
            // Only at the beginning of a line do these begin a heading or a list. A number with a full
            // stop stands there in titles of findings alone, where it begins nothing.
            '#' | '-' | '+' | '=' if start => {
                out.push('\\');
                out.push(c);
            }
            // An address is not to become a link.
            ':' if chars.peek() == Some(&'/') => out.push_str("&#58;"),
            '@' => out.push_str("&#64;"),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
        start = false;
    }
    out.replace("www.", "www&#46;")
}

//! What a user may have written stands on the page and does nothing there.

use crate::blocks::{Block, Page, Table};
use crate::{html, markdown};
use assemcad_model::report::Verdict;

/// A text that would be markup in either form.
const EVIL: &str = "<script>alert(1)</script> | `x` *y* _z_ [a](http://b.c) & \"q\" \n# h ![i](j)";

fn page() -> Page {
    let evil = || EVIL.to_owned();
    Page {
        title: evil(),
        blocks: vec![
            Block::Verdict(Verdict::Fail, evil()),
            Block::Heading(2, evil()),
            Block::Finding(Verdict::Pass, evil()),
            Block::Text(evil()),
            Block::List(vec![evil()]),
            Block::Pairs(vec![(evil(), evil())]),
            Block::Table(Table {
                heads: vec!["a", "b"],
                rows: vec![vec![evil(), evil()]],
            }),
            Block::Code(evil()),
            Block::Code("```\n<b>".to_owned()),
        ],
    }
}

#[test]
fn no_text_is_markup_in_html() {
    let text = html::render(&page());
    assert!(
        !text.contains("<script") && !text.contains("alert(1)</script"),
        "{text}"
    );
    // The title twice, six blocks of one text, the pairs and the table of two each.
    assert_eq!(text.matches("&lt;script&gt;").count(), 2 + 6 + 2 + 2);
    for foreign in [
        "src=", "href=", "url(", "@import", "<link", "<iframe", "<img",
    ] {
        assert!(!text.contains(foreign), "{foreign}");
    }
    assert!(text.contains("default-src 'none'"));
}

#[test]
fn no_text_is_markup_in_markdown() {
    let text = markdown::render(&page());
    let mut fence = None;
    for line in text.lines() {
        if line.starts_with("```") {
            fence = match fence {
                None => Some(line),
                Some(open) if open == line => None,
                other => other,
            };
            continue;
        }
        if fence.is_some() {
            continue;
        }
        assert!(
            !line.contains("<script") && !line.contains("http:"),
            "{line}"
        );
        // Every mark that means something is taken back.
        let bare = line
            .replace("\\`", "")
            .replace("\\*", "")
            .replace("\\_", "")
            .replace("\\[", "");
        let own = bare.strip_prefix("**Verdict: fail**").unwrap_or(&bare);
        assert!(!own.contains(['`', '*', '_', '[']), "{line}");
        assert!(!line.starts_with("# h"), "{line}");
    }
    assert_eq!(fence, None, "a fence was left open");
    // A row of the table keeps its two cells.
    let row = text
        .lines()
        .filter(|l| l.starts_with("| &lt;"))
        .collect::<Vec<_>>();
    assert_eq!(row.len(), 1);
    assert_eq!(row[0].replace("\\|", "").matches('|').count(), 3);
}

#[test]
fn a_fence_is_longer_than_what_it_holds() {
    let text = markdown::render(&page());
    assert!(text.contains("````\n``` <b>\n````\n"), "{text}");
}

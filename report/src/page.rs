//! A report for people: what stands on the page, in which order. How it looks is a matter of
//! [`crate::markdown`] and [`crate::html`].
//!
//! A page is made of a report alone, so that it is as reproducible as the report.

use assemcad_model::report::{AxiomRole, AxiomStatus, Finding, Report, Verdict};

use crate::blocks::{Block, Page, shown};
use crate::tables;

/// The page of a report.
#[must_use]
pub fn of(report: &Report) -> Page {
    let mut blocks = vec![summary(report)];
    findings(report, &mut blocks);
    heading(&mut blocks, "What was checked");
    blocks.push(Block::Table(tables::checks(report)));
    heading(&mut blocks, "What was not checked");
    blocks.push(Block::List(report.not_checked.clone()));
    heading(&mut blocks, "Parts and mass");
    blocks.push(Block::Text(mass(report)));
    blocks.push(Block::Table(tables::parts(report)));
    heading(&mut blocks, "Bill of materials");
    blocks.push(Block::Table(tables::bill(report)));
    if !report.mates.is_empty() {
        heading(&mut blocks, "Mates");
        blocks.push(Block::Table(tables::mates(report)));
    }
    if !report.pairs.is_empty() {
        heading(&mut blocks, "Pairs of parts whose boxes meet");
        blocks.push(Block::Table(tables::pairs(report)));
    }
    axioms(report, &mut blocks);
    heading(&mut blocks, "What this report is about");
    blocks.push(Block::Pairs(tables::hashes(report)));
    Page {
        title: format!("Verification of {}", report.assembly),
        blocks,
    }
}

fn heading(blocks: &mut Vec<Block>, text: &str) {
    blocks.push(Block::Heading(2, text.to_owned()));
}

fn summary(report: &Report) -> Block {
    let count = |v: Verdict| report.findings.iter().filter(|f| f.verdict == v).count();
    let told = format!(
        "{} parts, {} mates; {} faults, {} open questions, {} warnings",
        report.parts.len(),
        report.mates.len(),
        count(Verdict::Fail),
        count(Verdict::Indeterminate),
        count(Verdict::Pass)
    );
    Block::Verdict(report.verdict, told)
}

fn findings(report: &Report, blocks: &mut Vec<Block>) {
    heading(blocks, "Findings");
    if report.findings.is_empty() {
        blocks.push(Block::Text("None.".to_owned()));
    }
    for (i, f) in report.findings.iter().enumerate() {
        let d = &f.diagnostic;
        blocks.push(Block::Finding(
            f.verdict,
            format!("{}. {}", i + 1, d.message),
        ));
        blocks.push(Block::Pairs(facts(f)));
        let stated: Vec<String> = f
            .axioms
            .iter()
            .map(|a| format!("{} ({}): {}", a.axiom, role(a.role), a.statement))
            .collect();
        if !stated.is_empty() {
            blocks.push(Block::List(stated));
        }
        if let Some(hint) = &d.hint {
            blocks.push(Block::Text(format!("To mend it: {hint}.")));
        }
        if let Some(next) = &d.next {
            blocks.push(Block::Code(format!("{} {}", next.tool, next.arguments)));
        }
    }
}

fn facts(f: &Finding) -> Vec<(String, String)> {
    let d = &f.diagnostic;
    let code = serde_json::to_value(d.code).unwrap_or_default();
    let mut out = vec![
        ("code".to_owned(), shown(&code)),
        ("check".to_owned(), f.check.clone()),
        ("where".to_owned(), d.place.clone()),
        ("parts".to_owned(), f.parts.join(", ")),
        ("mates".to_owned(), f.mates.join(", ")),
        (
            "found".to_owned(),
            d.found.as_ref().map(shown).unwrap_or_default(),
        ),
        (
            "expected".to_owned(),
            d.expected.as_ref().map(shown).unwrap_or_default(),
        ),
    ];
    out.extend(f.values.iter().map(|(name, v)| (name.clone(), shown(v))));
    out.retain(|(_, value)| !value.is_empty());
    out
}

fn role(role: AxiomRole) -> &'static str {
    match role {
        AxiomRole::Broken => "broken",
        AxiomRole::Open => "left open",
        AxiomRole::Cited => "cited by a mate between these parts",
    }
}

fn mass(report: &Report) -> String {
    let m = &report.mass;
    let density = if m.density_assumed {
        format!(
            "{} kg/m3, that of steel, taken for all parts because none was stated",
            m.density_kg_m3
        )
    } else {
        format!("{} kg/m3 for all parts, as stated", m.density_kg_m3)
    };
    let total = match m.total_kg {
        Some(kg) => format!("Total mass {kg} kg"),
        None => "The total mass is not known: a part could not be made".to_owned(),
    };
    let centre = match m.centre_mm {
        Some([x, y, z]) => format!("centre of mass at ({x}, {y}, {z}) mm in the assembly's frame"),
        None => {
            "the centre of mass is not known: a part has no place or could not be made".to_owned()
        }
    };
    format!("{total}; {centre}. Density {density}.")
}

fn axioms(report: &Report, blocks: &mut Vec<Block>) {
    let a = &report.axioms;
    heading(blocks, "Engineering axioms");
    blocks.push(Block::Text(format!(
        "Of {} axioms {} held, {} are broken, {} warn, {} are open, {} apply to nothing here, {} were not \
         checked.",
        a.total, a.passed, a.failed, a.warned, a.indeterminate, a.not_applicable, a.not_checked
    )));
    let told: Vec<_> = a
        .each
        .iter()
        .filter(|f| {
            !matches!(
                f.status,
                AxiomStatus::NotApplicable | AxiomStatus::NotChecked
            )
        })
        .collect();
    if !told.is_empty() {
        blocks.push(Block::Table(tables::axioms(&told)));
    }
    let assumed: Vec<String> = told
        .iter()
        .flat_map(|f| {
            f.assumptions
                .iter()
                .map(|why| format!("{}: {why}", f.axiom))
        })
        .collect();
    if !assumed.is_empty() {
        blocks.push(Block::Text("Taken for granted:".to_owned()));
        blocks.push(Block::List(assumed));
    }
}

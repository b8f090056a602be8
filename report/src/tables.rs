//! The tables of a report's page.

use assemcad_model::report::{AxiomFacts, Report};
use serde::Serialize;
use serde_json::Value;

use crate::blocks::{Table, shown, word};

/// A value as it is written in the report, without quotation marks.
fn as_written(value: &impl Serialize) -> String {
    serde_json::to_value(value)
        .map(|v| shown(&v))
        .unwrap_or_default()
}

/// A number, or a dash where it is not known.
fn number(value: Option<f64>) -> String {
    value.map_or_else(|| "–".to_owned(), |v| v.to_string())
}

fn point(value: Option<[f64; 3]>) -> String {
    value.map_or_else(|| "–".to_owned(), |[x, y, z]| format!("{x}, {y}, {z}"))
}

pub(crate) fn checks(report: &Report) -> Table {
    Table {
        heads: vec!["check", "verdict", "cases", "how"],
        rows: report
            .checks
            .iter()
            .map(|c| {
                vec![
                    c.check.clone(),
                    word(c.verdict).to_owned(),
                    c.cases.to_string(),
                    c.how.clone(),
                ]
            })
            .collect(),
    }
}

pub(crate) fn parts(report: &Report) -> Table {
    Table {
        heads: vec![
            "part",
            "factory",
            "volume mm3",
            "mass kg",
            "centre of mass mm",
        ],
        rows: report
            .parts
            .iter()
            .map(|p| {
                vec![
                    p.part.clone(),
                    p.factory.clone(),
                    number(p.volume_mm3),
                    number(p.mass_kg),
                    point(p.centre_mm),
                ]
            })
            .collect(),
    }
}

pub(crate) fn bill(report: &Report) -> Table {
    let params = |line: &serde_json::Map<String, Value>| {
        let all: Vec<String> = line
            .iter()
            .map(|(name, value)| format!("{name} {}", shown(value)))
            .collect();
        all.join(", ")
    };
    Table {
        heads: vec![
            "count",
            "designation",
            "factory",
            "parameters",
            "mass kg each",
            "parts",
        ],
        rows: report
            .bill_of_materials
            .iter()
            .map(|l| {
                vec![
                    l.count.to_string(),
                    l.designation.clone().unwrap_or_else(|| "–".to_owned()),
                    l.factory.clone(),
                    params(&l.params),
                    number(l.mass_kg),
                    l.parts.join(", "),
                ]
            })
            .collect(),
    }
}

pub(crate) fn mates(report: &Report) -> Table {
    Table {
        heads: vec![
            "mate", "type", "base", "incoming", "holds", "contact", "area mm2", "play mm", "axioms",
        ],
        rows: report
            .mates
            .iter()
            .map(|m| {
                vec![
                    m.mate.clone(),
                    as_written(&m.mate_type),
                    m.base.clone(),
                    m.incoming.clone(),
                    word(m.verdict).to_owned(),
                    m.contact.map_or("–", word).to_owned(),
                    number(m.contact_area_mm2),
                    number(m.radial_play_mm),
                    m.axioms.join(", "),
                ]
            })
            .collect(),
    }
}

pub(crate) fn pairs(report: &Report) -> Table {
    Table {
        heads: vec![
            "first",
            "second",
            "verdict",
            "overlap",
            "common mm3",
            "allowed mm3",
        ],
        rows: report
            .pairs
            .iter()
            .map(|p| {
                vec![
                    p.a.clone(),
                    p.b.clone(),
                    word(p.verdict).to_owned(),
                    as_written(&p.class),
                    number(p.common_volume_mm3),
                    number(p.allowed_mm3),
                ]
            })
            .collect(),
    }
}

pub(crate) fn axioms(facts: &[&AxiomFacts]) -> Table {
    Table {
        heads: vec!["axiom", "came to", "cases", "cited by", "statement"],
        rows: facts
            .iter()
            .map(|f| {
                vec![
                    f.axiom.clone(),
                    as_written(&f.status),
                    f.cases.to_string(),
                    f.cited_by.join(", "),
                    f.statement.clone(),
                ]
            })
            .collect(),
    }
}

pub(crate) fn hashes(report: &Report) -> Vec<(String, String)> {
    let mut out = vec![
        ("assembly".to_owned(), report.assembly.clone()),
        (
            "specification sha256".to_owned(),
            report.specification_sha256.clone(),
        ),
    ];
    match &report.step {
        Some(step) => {
            out.push((
                "STEP file".to_owned(),
                format!("{} ({} bytes)", step.file, step.bytes),
            ));
            out.push(("STEP sha256".to_owned(), step.sha256.clone()));
        }
        None => out.push((
            "STEP file".to_owned(),
            "none of this specification".to_owned(),
        )),
    }
    for line in &report.bill_of_materials {
        let of = format!("recipe sha256 of {}", line.parts.first().map_or("", |p| p));
        out.push((of, line.recipe_sha256.clone()));
    }
    out.push(("kernel".to_owned(), report.kernel.clone()));
    out.push(("clash above".to_owned(), format!("{} mm3", report.tau_mm3)));
    if let Some(mm) = report.clearance_mm {
        out.push(("clearance asked for".to_owned(), format!("{mm} mm")));
    }
    out
}

//! A report on disk: for programs, for readers of text, and for browsers.

use assemcad_model::diagnostic::Diagnostic;
use assemcad_model::report::{Report, StepFile};
use assemcad_report::{html, markdown, page};

use crate::Workshop;
use crate::step_header::names_specification;
use assemcad_store::{file_of, json_bytes};

/// The file of an assembly's report, below the root.
#[must_use]
pub fn report_file(id: &str) -> String {
    file_of(id, "report.json")
}

/// The report as a page of Markdown, below the root.
#[must_use]
pub fn report_markdown(id: &str) -> String {
    file_of(id, "report.md")
}

/// The report as a page for browsers, below the root.
#[must_use]
pub fn report_html(id: &str) -> String {
    file_of(id, "report.html")
}

/// The files of a report: path below the root, and bytes.
pub(crate) fn files(report: &Report) -> Result<[(String, Vec<u8>); 3], Diagnostic> {
    let id = report.assembly.as_str();
    let page = page::of(report);
    let json = report_file(id);
    let bytes = json_bytes(&json, report)?;
    Ok([
        (json, bytes),
        (report_markdown(id), markdown::render(&page).into_bytes()),
        (report_html(id), html::render(&page).into_bytes()),
    ])
}

impl Workshop {
    /// Writes the files of a report as one step.
    pub(crate) fn write_report(&self, report: &Report) -> Result<(), Diagnostic> {
        let files = files(report)?;
        let all: Vec<(&str, &[u8])> = files
            .iter()
            .map(|(p, b)| (p.as_str(), b.as_slice()))
            .collect();
        self.store.write_all(&all)
    }

    /// The STEP file of the specification that a report is about, where there is one: the one that the
    /// last report names, or the one beside it. Its own header says of which specification it is.
    pub(crate) fn known_step(&self, report: &Report) -> Option<StepFile> {
        let id = report.assembly.as_str();
        let last: Option<Report> = self.store.read_json(&report_file(id));
        let named = last.and_then(|r| r.step).map(|s| s.file);
        let beside = file_of(id, &format!("{id}.step"));
        named.into_iter().chain([beside]).find_map(|file| {
            let bytes = self.store.read_bytes(&file)?;
            names_specification(&bytes, &report.specification_sha256).then(|| StepFile {
                bytes: bytes.len(),
                sha256: assemcad_model::canonical::sha256(&bytes),
                file,
            })
        })
    }
}

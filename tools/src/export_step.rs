//! `export_step`.

use assemcad_assembly::{Faults, Workshop};
use assemcad_model::report::Verdict;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Effect, Tool};

pub(crate) struct ExportStep;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Name of the assembly.
    assembly: String,
    /// Where to: a path that ends in .step or .stp, below exports/ASSEMBLY in the server's root folder.
    /// Beside the assembly's specification where it is left out.
    #[serde(default)]
    file: Option<String>,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// The file, below the server's root folder.
    file: String,
    /// Its length in bytes.
    bytes: usize,
    /// Its SHA-256.
    sha256: String,
    /// SHA-256 of the specification, as in the file's header.
    specification_sha256: String,
    /// How many distinct solids it holds.
    products: usize,
    /// How many parts it holds.
    instances: usize,
    /// What the last verification of this very specification came to; absent where there was none.
    #[serde(skip_serializing_if = "Option::is_none")]
    verified: Option<Verdict>,
}

impl Tool for ExportStep {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "export_step";
    const TITLE: &'static str = "Export STEP";
    const DESCRIPTION: &'static str = "Writes an assembly as a STEP file (AP242, millimetres, part \
        names, colours, equal parts stored once) below the server's root folder. The same assembly \
        gives the same bytes every time. Every part needs a place first. It does not verify: \
        'verified' in the answer repeats what verify last said about this very specification.";
    const EFFECT: Effect = Effect::Adds;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let done = workshop.export_step(&a.assembly, a.file.as_deref()).await?;
        Ok(Answer {
            file: done.file,
            bytes: done.bytes,
            sha256: done.sha256,
            specification_sha256: done.specification_sha256,
            products: done.products,
            instances: done.instances,
            verified: done.verdict,
        })
    }
}

//! The one shape of everything that can be wrong.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Everything that is wrong with a request: never empty.
pub type Faults = Vec<Diagnostic>;

/// Something that is wrong, where, and what would mend it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Diagnostic {
    /// Stable code.
    // The schema says no more: the list of all codes, in every answer's schema, would be most of it.
    #[schemars(with = "String")]
    pub code: Code,
    /// How bad it is.
    pub severity: Severity,
    /// The place: a path into the arguments or the specification, or a tool or part name.
    #[serde(rename = "where")]
    pub place: String,
    /// What is wrong, in one sentence.
    pub message: String,
    /// The offending value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub found: Option<Value>,
    /// The valid values.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected: Option<Value>,
    /// What to do about it, in plain words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hint: Option<String>,
    /// The call that would mend it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub next: Option<NextCall>,
}

/// A tool call, ready to be made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NextCall {
    /// Name of the tool.
    pub tool: String,
    /// Its arguments.
    pub arguments: Value,
}

/// How bad a diagnostic is.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Severity {
    /// Nothing was done.
    Error,
    /// Done, but look at this.
    Warning,
    /// For information.
    Note,
}

/// The stable codes of diagnostics.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Code {
    /// An argument is missing, unknown, or of the wrong type or range.
    ArgumentInvalid,
    /// There is no tool of this name.
    ToolUnknown,
    /// A name breaks the rule for names.
    NameInvalid,
    /// The name is taken by something else.
    NameTaken,
    /// A text is no YAML, or holds what has no meaning in it.
    YamlInvalid,
    /// A comment that is not kept.
    CommentLost,
    /// Something in a specification is missing, unknown or of the wrong type.
    SpecificationInvalid,
    /// A mate that cites no axiom.
    AxiomMissing,
    /// There is no axiom of this id.
    AxiomUnknown,
    /// An axiom that does not apply to the mate that cites it.
    AxiomInapplicable,
    /// The assembly breaks an axiom.
    AxiomBroken,
    /// Two parts that land in the same place.
    Coincident,
    /// A part that nothing holds but its teeth, or a hole in line with a hole.
    Unsupported,
    /// A factory's source that was still wrong after as many rounds as there are.
    SynthesisFailed,
    /// A draft that was still wrong after as many rounds as there are.
    DecompositionFailed,
    /// There is no assembly of this name.
    AssemblyUnknown,
    /// There is no part of this name in the assembly.
    PartUnknown,
    /// There is no mate of this name in the assembly.
    MateUnknown,
    /// The part has no port of this name.
    PortUnknown,
    /// There is no factory of this name.
    FactoryUnknown,
    /// The factory has no parameter of this name.
    ParamUnknown,
    /// A parameter has the wrong type or lies out of its range.
    ParamInvalid,
    /// The factory's source is at fault.
    FactoryFailed,
    /// The mate type does not join these port types.
    MateIncompatible,
    /// A mate between a part and itself.
    MateSelf,
    /// A mate does not hold at the parts' places.
    MateResidual,
    /// The kernel refused an operation or made nothing valid of it.
    KernelFailed,
    /// A worker died in the middle of a request.
    WorkerCrashed,
    /// A request took longer than its limit.
    WorkerTimeout,
    /// A request used more processor time than its limit.
    WorkerCpuLimit,
    /// A request needed more memory than its limit.
    WorkerMemoryLimit,
    /// A worker could not be started or spoke nonsense.
    WorkerFailed,
    /// The solid does not show what a port promises.
    PortEvidence,
    /// Mated parts do not touch where their mate promises it.
    ContactMissing,
    /// Two parts overlap.
    Clash,
    /// The same part twice in one place.
    Duplicate,
    /// Two parts that do not touch are nearer to each other than was asked for.
    NearMiss,
    /// A port joined more often than it can serve.
    PortOverused,
    /// A part is not joined to the root.
    Unconnected,
    /// More or fewer motions are free than the specification intends.
    MobilityDiffers,
    /// Holes of parts that lie on each other are not in line.
    HolesOutOfLine,
    /// A part that nothing holds where a mate says that it is held.
    NotHeld,
    /// A part that should move and cannot.
    PartHeld,
    /// A check could not be carried out.
    Indeterminate,
    /// The assembly has no parts.
    AssemblyEmpty,
    /// A path leads outside the root folder or names no file.
    PathInvalid,
    /// A file could not be read or written.
    FileFailed,
    /// A stored file is not what was written.
    FileDamaged,
    /// Something depends on what is to be removed.
    InUse,
    /// The client took the call back, or reads no more.
    Cancelled,
    /// Too many calls are waiting.
    Busy,
    /// More was found than is told.
    NotShown,
    /// A fault of the server itself.
    Internal,
}

impl Diagnostic {
    /// An error.
    #[must_use]
    pub fn error(code: Code, place: impl Into<String>, message: impl Into<String>) -> Self {
        Self {
            code,
            severity: Severity::Error,
            place: place.into(),
            message: message.into(),
            found: None,
            expected: None,
            hint: None,
            next: None,
        }
    }

    /// A warning.
    #[must_use]
    pub fn warning(code: Code, place: impl Into<String>, message: impl Into<String>) -> Self {
        Self {
            severity: Severity::Warning,
            ..Self::error(code, place, message)
        }
    }

    /// With the offending value; long texts are cut.
    #[must_use]
    pub fn found(mut self, value: impl Into<Value>) -> Self {
        self.found = Some(match value.into() {
            Value::String(s) => Value::String(crate::param::clip(&s)),
            other => {
                let text = other.to_string();
                if text.len() > 400 {
                    Value::String(crate::param::clip(&text))
                } else {
                    other
                }
            }
        });
        self
    }

    /// With the valid values.
    #[must_use]
    pub fn expected(mut self, value: impl Into<Value>) -> Self {
        self.expected = Some(value.into());
        self
    }

    /// With advice.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    /// With the call that would mend it.
    #[must_use]
    pub fn next(mut self, tool: &str, arguments: Value) -> Self {
        self.next = Some(NextCall {
            tool: tool.to_owned(),
            arguments,
        });
        self
    }

    /// At another place.
    #[must_use]
    pub fn at(mut self, place: impl Into<String>) -> Self {
        self.place = place.into();
        self
    }
}

impl core::fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{}: {}", self.place, self.message)
    }
}

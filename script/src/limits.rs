//! What an evaluation may use.

use core::time::Duration;

/// What one evaluation of a source may use; each limit exceeded is a diagnostic that names it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Limits {
    /// Longest source in bytes. Looked at before anything is read.
    pub source_bytes: usize,
    /// Deepest nesting of brackets, operators and blocks. Looked at before the source is parsed,
    /// because parser and compiler walk the tree by recursion.
    pub nesting: usize,
    /// Most statements that are carried out.
    pub statements: u64,
    /// Most function calls and turns of loops.
    pub ticks: u64,
    /// Deepest chain of calls.
    pub call_depth: usize,
    /// Most memory for values in bytes. Looked at before every statement and in every operator that
    /// makes a text or a list longer.
    pub heap_bytes: usize,
    /// Longest text in bytes.
    pub text_bytes: usize,
    /// Longest list or range that one operation may make.
    pub list_items: usize,
    /// Most operations recorded, used ones and unused ones.
    pub operations: usize,
    /// Most pieces (points of outlines, ports carried along) that recorded values hold together.
    pub pieces: usize,
    /// Longest time. An evaluation that does not end by itself is left behind after twice this time.
    pub time: Duration,
    /// Stack of the evaluation's thread in bytes; reserved, and used only as deep as it is needed.
    pub stack_bytes: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            source_bytes: 64 << 10,
            nesting: 300,
            statements: 300_000,
            ticks: 1_000_000,
            call_depth: 100,
            heap_bytes: 16 << 20,
            text_bytes: 64 << 10,
            list_items: 20_000,
            operations: 20_000,
            pieces: 200_000,
            time: Duration::from_secs(10),
            stack_bytes: 512 << 20,
        }
    }
}

//! The list of operations that a script records, and the recipe made of it.

use std::sync::Arc;

use assemcad_model::ports::Port;
use assemcad_model::recipe::{FORMAT, Op, Recipe};

use crate::fault::Fault;
use crate::limits::Limits;

/// Operations in the order of their recording, each with its line.
#[derive(Debug)]
pub(crate) struct Recorder {
    ops: Vec<Op>,
    lines: Vec<u32>,
    pieces: usize,
    most_ops: usize,
    most_pieces: usize,
}

impl Recorder {
    pub(crate) fn new(limits: &Limits) -> Self {
        Self {
            ops: Vec::new(),
            lines: Vec::new(),
            pieces: 0,
            most_ops: limits.operations,
            most_pieces: limits.pieces,
        }
    }

    /// Records an operation and gives its index.
    pub(crate) fn record(&mut self, op: Op, line: u32) -> Result<u32, Fault> {
        let index = self.ops.len();
        if index >= self.most_ops {
            return Err(Fault::new(format!(
                "more than {} operations are recorded (limit operations)",
                self.most_ops
            ))
            .hint("make solids once and use them again; use fewer of them"));
        }
        self.ops.push(op);
        self.lines.push(line);
        u32::try_from(index).map_err(|_| Fault::new("too many operations"))
    }

    /// Counts pieces that values outside the interpreter's heap hold.
    pub(crate) fn charge(&mut self, pieces: usize) -> Result<(), Fault> {
        self.pieces = self.pieces.saturating_add(pieces);
        if self.pieces > self.most_pieces {
            return Err(Fault::new(format!(
                "outlines and ports hold more than {} pieces (limit pieces)",
                self.most_pieces
            ))
            .hint("make outlines once and use them again; declare ports last"));
        }
        Ok(())
    }

    /// The recipe of the solid that operation `result` made: what it needs and nothing else,
    /// renumbered, with the line of each operation.
    ///
    /// Operations only refer to earlier ones, so keeping the order of recording puts `result` last.
    pub(crate) fn recipe(&self, result: u32, ports: &Arc<Vec<Port>>) -> (Recipe, Vec<u32>) {
        let mut needed = vec![false; self.ops.len()];
        let mut stack = vec![result];
        while let Some(index) = stack.pop() {
            if let Some(seen) = needed.get_mut(index as usize)
                && !*seen
            {
                *seen = true;
                stack.extend(
                    self.ops
                        .get(index as usize)
                        .map(Op::inputs)
                        .unwrap_or_default(),
                );
            }
        }
        let mut new_index = vec![0_u32; self.ops.len()];
        let mut next = 0;
        for (slot, needed) in new_index.iter_mut().zip(&needed) {
            *slot = next;
            next += u32::from(*needed);
        }
        let rename = |old: u32| new_index.get(old as usize).copied().unwrap_or_default();
        let kept = || {
            self.ops
                .iter()
                .zip(&self.lines)
                .zip(&needed)
                .filter(|(_, needed)| **needed)
        };
        let ops = kept()
            .map(|((op, _), _)| op.clone().with_inputs(rename))
            .collect();
        let lines = kept().map(|((_, line), _)| *line).collect();
        (
            Recipe {
                format: FORMAT,
                ops,
                ports: ports.as_ref().clone(),
            },
            lines,
        )
    }
}

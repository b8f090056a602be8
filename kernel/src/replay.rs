//! From a recipe to its solid and ports.

use assemcad_model::ports::Port;
use assemcad_model::recipe::{Call, FORMAT, Recipe};

use crate::error::{KernelError, Result};
use crate::shape::Shape;
use crate::workplane::{Failed, Made, carry_out};

/// Which call of a recipe failed, and how.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error, serde::Serialize, serde::Deserialize)]
#[error("call {step} ({call}): {error}")]
pub struct ReplayError {
    /// Position in the recipe, from 0.
    pub step: usize,
    /// Name of the call.
    pub call: String,
    /// What is wrong.
    pub error: KernelError,
}

/// A part's solid and its ports.
#[derive(Debug)]
pub struct Part {
    /// One valid closed solid, gone through bytes: a fresh one and one from a cache are the same.
    pub solid: Shape,
    /// The ports, in the part's frame.
    pub ports: Vec<Port>,
}

/// The solid of a recipe and its ports.
///
/// `on_call` is called before each call is carried out, so that a crash can be laid at one's door.
///
/// # Errors
/// The first call that is refused, or the last one where no single valid solid comes out.
pub fn replay(
    recipe: &Recipe,
    on_call: &mut dyn FnMut(usize, &Call),
) -> core::result::Result<Part, ReplayError> {
    let Made {
        shape,
        solids,
        ports,
    } = make(recipe, on_call)?;
    let one = match solids {
        1 => settle(&shape),
        several => Err(KernelError::refused(format!(
            "the part would be {several} separate solids: a part is one solid; join them by union, \
             or let them overlap"
        ))),
    };
    one.map(|solid| Part { solid, ports })
        .map_err(|error| failed_at_result(recipe, error))
}

/// What the calls of a recipe make, be it one solid or several.
///
/// # Errors
/// The first call that is refused.
pub fn make(
    recipe: &Recipe,
    on_call: &mut dyn FnMut(usize, &Call),
) -> core::result::Result<Made, ReplayError> {
    if recipe.format != FORMAT {
        let text = format!(
            "the recipe has format {}, and only {FORMAT} is known",
            recipe.format
        );
        return Err(failed_at_result(recipe, KernelError::refused(text)));
    }
    carry_out(recipe, on_call).map_err(|Failed { step, error }| failed(recipe, step, error))
}

fn failed(recipe: &Recipe, step: usize, error: KernelError) -> ReplayError {
    let call = recipe.calls.get(step);
    ReplayError {
        step,
        call: call.map_or_else(|| "recipe".to_owned(), |call| call.call.clone()),
        error,
    }
}

fn failed_at_result(recipe: &Recipe, error: KernelError) -> ReplayError {
    failed(recipe, usize::try_from(recipe.result).unwrap_or(0), error)
}

/// The solid as it comes back from its bytes, checked there: that is what everybody else gets.
fn settle(shape: &Shape) -> Result<Shape> {
    Shape::from_bytes(&shape.baked()?.to_bytes()?)?.checked("the part")
}

//! From a recipe to its solid.

use assemcad_model::frame::Placement;
use assemcad_model::recipe::{FORMAT, Op, Recipe, Ref};

use crate::error::{KernelError, Result};
use crate::limits::coordinates;
use crate::select::select;
use crate::shape::Shape;

/// Which operation of a recipe failed, and how.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error, serde::Serialize, serde::Deserialize)]
#[error("operation {step} ({op}): {error}")]
pub struct ReplayError {
    /// Position in the recipe, from 0.
    pub step: usize,
    /// Name of the operation.
    pub op: String,
    /// What is wrong.
    pub error: KernelError,
}

/// The solid of a recipe.
///
/// `on_step` is called before each operation, so that a crash can be laid at one's door. The solid
/// has gone through bytes: a fresh one and one from a cache are the same.
///
/// # Errors
/// The first operation that is refused or makes no single valid solid.
pub fn replay(
    recipe: &Recipe,
    on_step: &mut dyn FnMut(usize, &Op),
) -> core::result::Result<Shape, ReplayError> {
    let failed = |step: usize, op: &str, error: KernelError| ReplayError {
        step,
        op: op.to_owned(),
        error,
    };
    if recipe.format != FORMAT {
        let text = format!(
            "the recipe has format {}, and only {FORMAT} is known",
            recipe.format
        );
        return Err(failed(0, "recipe", KernelError::refused(text)));
    }
    for (step, op) in recipe.ops.iter().enumerate() {
        references(step, op).map_err(|e| failed(step, op.name(), e))?;
    }
    let mut made: Vec<Shape> = Vec::with_capacity(recipe.ops.len());
    for (step, op) in recipe.ops.iter().enumerate() {
        on_step(step, op);
        let shape = perform(op, &made).map_err(|e| failed(step, op.name(), e))?;
        made.push(shape);
    }
    let Some((op, last)) = recipe.ops.last().zip(made.last()) else {
        return Err(failed(
            0,
            "recipe",
            KernelError::refused("the recipe has no operations"),
        ));
    };
    let step = recipe.ops.len() - 1;
    settle(last).map_err(|e| failed(step, op.name(), e))
}

/// The solid as it comes back from its bytes, checked there: that is what everybody else gets.
fn settle(shape: &Shape) -> Result<Shape> {
    Shape::from_bytes(&shape.to_bytes()?)?.checked("the part")
}

fn references(step: usize, op: &Op) -> Result<()> {
    for input in op.inputs() {
        if usize::try_from(input).map_or(true, |i| i >= step) {
            return Err(KernelError::refused(format!(
                "it refers to operation {input}, which is not an earlier one"
            )));
        }
    }
    Ok(())
}

fn perform(op: &Op, made: &[Shape]) -> Result<Shape> {
    let get = |input: &Ref| {
        usize::try_from(*input)
            .ok()
            .and_then(|i| made.get(i))
            .ok_or_else(|| KernelError::internal("an operation's input is missing"))
    };
    match op {
        Op::Box { at, size } => Shape::cuboid(at, *size),
        Op::Cylinder { at, radius, height } => Shape::cylinder(at, *radius, *height),
        Op::Cone {
            at,
            radius_base,
            radius_top,
            height,
        } => Shape::cone(at, *radius_base, *radius_top, *height),
        Op::Sphere { at, radius } => Shape::sphere(at, *radius),
        Op::Prism { profile, length } => Shape::prism(profile, *length),
        Op::Revolve {
            profile,
            axis_point,
            axis_direction,
            angle_deg,
        } => Shape::revolve(profile, *axis_point, *axis_direction, *angle_deg),
        Op::Fuse { a, b } => get(a)?.fuse(get(b)?),
        Op::Cut { a, b } => get(a)?.cut(get(b)?),
        Op::Common { a, b } => get(a)?.common(get(b)?),
        Op::Fillet { of, edges, radius } => {
            let solid = get(of)?;
            solid.fillet(&select(edges, &solid.edges()?)?, *radius)
        }
        Op::Chamfer {
            of,
            edges,
            distance,
        } => {
            let solid = get(of)?;
            solid.chamfer(&select(edges, &solid.edges()?)?, *distance)
        }
        Op::Place { of, placement } => {
            let at = Placement::from(*placement);
            coordinates("placement", at.origin().as_slice())?;
            get(of)?.placed(&at)
        }
    }
}

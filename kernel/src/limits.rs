//! What numbers the kernel takes.

use crate::error::{KernelError, Result};

/// The largest magnitude of any coordinate or length, in mm.
pub const LARGEST: f64 = 1e5;

/// The smallest length, in mm: ten times the distance at which the kernel takes points for one.
pub const SMALLEST: f64 = 1e-6;

pub(crate) fn length(what: &str, value: f64) -> Result<()> {
    if !value.is_finite() {
        return Err(KernelError::refused(format!(
            "the {what} is not a finite number"
        )));
    }
    if value <= 0.0 {
        return Err(KernelError::refused(format!(
            "the {what} is {value} mm, and must be more than 0"
        )));
    }
    if !(SMALLEST..=LARGEST).contains(&value) {
        return Err(KernelError::refused(format!(
            "the {what} is {value} mm, and must lie between {SMALLEST} and {LARGEST}"
        )));
    }
    Ok(())
}

pub(crate) fn coordinates(what: &str, values: &[f64]) -> Result<()> {
    for value in values {
        if !value.is_finite() {
            return Err(KernelError::refused(format!(
                "a coordinate of the {what} is not finite"
            )));
        }
        if value.abs() > LARGEST {
            return Err(KernelError::refused(format!(
                "a coordinate of the {what} is {value} mm, beyond {LARGEST}"
            )));
        }
    }
    Ok(())
}

pub(crate) fn direction(what: &str, values: &[f64]) -> Result<()> {
    if values.iter().any(|n| !n.is_finite()) {
        return Err(KernelError::refused(format!("the {what} is not finite")));
    }
    let largest = values.iter().fold(0.0_f64, |m, n| m.max(n.abs()));
    if largest == 0.0 {
        return Err(KernelError::refused(format!("the {what} has no length")));
    }
    Ok(())
}

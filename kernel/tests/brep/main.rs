//! The verbs on shapes of any kind against closed forms: no expected value was copied from the kernel.

#[cfg(test)]
mod common;
#[cfg(test)]
mod curves;
#[cfg(test)]
mod look;
#[cfg(test)]
mod nonsense;
#[cfg(test)]
mod solids;
#[cfg(test)]
mod sweeps;

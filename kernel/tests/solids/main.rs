//! Solids against closed forms: every expected value is a formula, none was copied from the kernel.

#[cfg(test)]
mod booleans;
#[cfg(test)]
mod common;
#[cfg(test)]
mod contacts;
#[cfg(test)]
mod dress;
#[cfg(test)]
mod evidence;
#[cfg(test)]
mod facts;
#[cfg(test)]
mod mesh;
#[cfg(test)]
mod pairs;
#[cfg(test)]
mod primitives;
#[cfg(test)]
mod profiles;
#[cfg(test)]
mod revolution;
#[cfg(test)]
mod sides;

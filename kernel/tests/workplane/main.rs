//! Recipes carried out: what comes out is held against closed forms and hand-computed frames.

#[cfg(test)]
mod common;
#[cfg(test)]
mod functions;
#[cfg(test)]
mod holes;
#[cfg(test)]
mod moves;
#[cfg(test)]
mod places;
#[cfg(test)]
mod refusals;
#[cfg(test)]
mod replaying;
#[cfg(test)]
mod unions;

//! The engineering axioms that mates cite: data, their order, queries and checks.
//!
//! The data are one YAML file per category under `axioms/data/`, embedded in the crate, read with the
//! workspace's own YAML reader and validated as a whole. A check is one file under `src/checks/`: it reads
//! [`facts::Facts`] and yields [`ruling::Ruling`]s. Nothing here knows a kernel, files or a protocol.

pub mod apart;
pub mod asked;
pub mod axiom;
pub mod checks;
pub mod class;
pub mod decision;
pub mod docs;
pub mod entry;
pub mod facts;
mod gearing;
mod geometry;
mod hinges;
pub mod indexed;
mod joints;
pub mod knowledge;
mod left;
pub mod load;
mod measured;
pub mod query;
pub mod reasons;
pub mod ruling;
mod tables;
mod validate;

pub use axiom::Axiom;
pub use class::Class;
pub use decision::Decision;
pub use facts::Facts;
pub use indexed::Indexed;
pub use knowledge::{KnowledgeBase, axioms};
pub use query::{Applicability, Query};
pub use ruling::{Ruling, Status};

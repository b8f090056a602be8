//! What can be asked: one kind of question, one file.

pub mod beyond;
pub mod built;
pub mod contact;
pub mod distance;
pub mod enters;
pub mod measured;
pub mod meetings;
pub mod mesh;
pub mod overlap;
pub mod probes;
pub mod revolution;
pub mod skin;

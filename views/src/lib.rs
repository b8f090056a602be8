//! What is looked at and measured on an assembly: pictures, and distances, angles, boxes and masses.

pub mod measure;
pub mod picture;

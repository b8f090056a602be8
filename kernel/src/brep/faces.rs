//! Flat faces from their outlines, and outlines from faces.

use super::ffi::bridge;
use super::{bundle, made, unbundle};
use crate::error::Result;
use crate::shape::Shape;

impl Shape {
    /// A flat face within a closed wire and outside of others.
    ///
    /// Wires that lie beside the outer one bound faces of their own: what comes out is then a group
    /// of faces, as in CadQuery. [`Shape::faces_from_wires`] takes it apart.
    ///
    /// # Errors
    /// When a wire is open or they do not lie in one plane.
    pub fn face(outer: &Self, holes: &[&Self]) -> Result<Self> {
        let wires: Vec<&Self> = core::iter::once(outer)
            .chain(holes.iter().copied())
            .collect();
        made(bridge::face_of_wires(&*bundle(&wires)?), || {
            "the face could not be built".into()
        })
    }

    /// The flat faces that closed wires of one plane bound; how they nest tells outlines from holes.
    ///
    /// # Errors
    /// When there is no wire, one is open or they do not lie in one plane.
    pub fn faces_from_wires(wires: &[&Self]) -> Result<Vec<Self>> {
        unbundle(bridge::faces_of_wires(&*bundle(wires)?), || {
            "the faces could not be built".into()
        })
    }

    /// The outer wire of a face.
    ///
    /// # Errors
    /// When it is no face or has no border.
    pub fn outer_wire(&self) -> Result<Self> {
        made(bridge::outer_wire_of(self.solid()?), || {
            "the outer wire could not be found".into()
        })
    }

    /// The wires about the holes of a face.
    ///
    /// # Errors
    /// When it is no face or has no border.
    pub fn inner_wires(&self) -> Result<Vec<Self>> {
        unbundle(bridge::inner_wires_of(self.solid()?), || {
            "the inner wires could not be found".into()
        })
    }
}

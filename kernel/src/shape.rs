//! The solid, its bytes, and how frames and placements go to C++.

use std::cell::OnceCell;
use std::sync::OnceLock;

use assemcad_model::frame::{Frame, Placement};
use cxx::UniquePtr;

use crate::error::{Context, KernelError, Result};
use crate::ffi::bridge;
use crate::query::Mass;

/// A solid. Lengths in mm. It never changes: every verb makes a new one.
///
/// Not to be sent between threads: the kernel is used by one thread of a worker process.
pub struct Shape {
    solid: UniquePtr<bridge::Solid>,
    // Every boolean compares volumes, and a solid never changes.
    pub(crate) mass: OnceCell<Mass>,
    // Reading brings slanted directions to unit length anew, so that writing what was read may
    // differ in the last digit, and never settles: a solid keeps the bytes it came from.
    bytes: OnceCell<Vec<u8>>,
}

impl core::fmt::Debug for Shape {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Shape")
    }
}

impl Shape {
    pub(crate) fn wrap(solid: UniquePtr<bridge::Solid>) -> Result<Self> {
        if solid.is_null() {
            return Err(KernelError::internal("the kernel returned no shape"));
        }
        Ok(Self {
            solid,
            mass: OnceCell::new(),
            bytes: OnceCell::new(),
        })
    }

    pub(crate) fn solid(&self) -> Result<&bridge::Solid> {
        self.solid
            .as_ref()
            .ok_or_else(|| KernelError::internal("the shape is empty"))
    }

    /// The solid as bytes: OCCT's binary BREP, version 4, without triangulation.
    ///
    /// A solid from bytes gives back those very bytes. One made by a verb is written now, and
    /// reading it may change the last digit of a slanted direction: [`crate::replay()`] hands out
    /// solids that have been read already.
    ///
    /// # Errors
    /// When the kernel cannot write it or memory runs out.
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        if let Some(known) = self.bytes.get() {
            return Ok(known.clone());
        }
        bridge::to_bytes(self.solid()?).context(|| "the solid could not be stored".into())
    }

    /// A solid from [`Shape::to_bytes`].
    ///
    /// # Errors
    /// When the bytes hold no shape. Damaged bytes may crash the kernel: check their hash before.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self> {
        start()?;
        if !bytes.trim_ascii_start().starts_with(BREP) {
            return Err(KernelError::refused(
                "the stored solid could not be read: the bytes are no binary BREP of version 4",
            ));
        }
        let solid = bridge::from_bytes(bytes)
            .context(|| "the stored solid could not be read".to_owned())?;
        let shape = Self::wrap(solid)?;
        shape.bytes.get_or_init(|| bytes.to_vec());
        Ok(shape)
    }

    /// The solid moved, its geometry written anew: no location stays on it.
    ///
    /// # Errors
    /// When the placement is not rigid or a number is out of range.
    pub fn placed(&self, at: &Placement) -> Result<Self> {
        self.moved(at)?.baked()
    }

    /// Whether a location is left anywhere on the shape; for tests.
    #[doc(hidden)]
    pub fn has_locations(&self) -> Result<bool> {
        bridge::has_locations(self.solid()?).context(|| "the solid could not be walked".into())
    }
}

/// How the bytes of a solid begin.
const BREP: &[u8] = b"Open CASCADE Topology V4";

/// Makes the kernel silent: OCCT prints to stdout, which may carry a protocol.
pub(crate) fn start() -> Result<()> {
    // What came of it holds for every later call too: a kernel that could not be started is not there.
    static START: OnceLock<Result<()>> = OnceLock::new();
    let begin = || bridge::quiet().context(|| "the kernel could not be started".into());
    START.get_or_init(begin).clone()
}

/// How far a placement may be from a rotation.
const RIGID: f64 = 1e-9;

pub(crate) fn pose(at: &Placement) -> Result<bridge::Pose> {
    let assemcad_model::frame::Rows([a, b, c]) = (*at).into();
    let [a0, a1, a2, a3] = a;
    let [b0, b1, b2, b3] = b;
    let [c0, c1, c2, c3] = c;
    let rows = [a0, a1, a2, a3, b0, b1, b2, b3, c0, c1, c2, c3];
    if rows.iter().any(|n| !n.is_finite()) {
        return Err(KernelError::refused(
            "a number of the placement is not finite",
        ));
    }
    // Written so that NaN fails too.
    if !(at.orthonormality_error() <= RIGID && at.rotation().determinant() > 0.0) {
        return Err(KernelError::refused(
            "the placement is no rigid motion: its rotation must be orthonormal and not mirror",
        ));
    }
    Ok(bridge::Pose { rows })
}

pub(crate) fn frame(at: &Frame) -> Result<bridge::At> {
    let placement = at
        .placement()
        .map_err(|e| KernelError::refused(e.to_string()))?;
    let [x, _, z] = placement.axes();
    Ok(bridge::At {
        origin: placement.origin().into(),
        x: x.into(),
        z: z.into(),
    })
}

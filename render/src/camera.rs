//! Cameras: parallel projection, so that equal lengths look equal.

use nalgebra::Vector3;

use crate::RenderError;
use crate::scene::Body;

/// The views that have a name. In `front` x points to the right and z up; the others stand around it
/// as on a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum View {
    /// From between +x, -y and +z.
    Isometric,
    /// From -y.
    Front,
    /// From +y.
    Back,
    /// From -x.
    Left,
    /// From +x.
    Right,
    /// From +z, y up.
    Top,
    /// From -z, y down.
    Bottom,
}

impl View {
    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Isometric => "isometric",
            Self::Front => "front",
            Self::Back => "back",
            Self::Left => "left",
            Self::Right => "right",
            Self::Top => "top",
            Self::Bottom => "bottom",
        }
    }

    /// From where it is seen.
    #[must_use]
    pub fn eye(self) -> Eye {
        let (toward, up) = match self {
            Self::Isometric => ([1.0, -1.0, 1.0], [0.0, 0.0, 1.0]),
            Self::Front => ([0.0, -1.0, 0.0], [0.0, 0.0, 1.0]),
            Self::Back => ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
            Self::Left => ([-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
            Self::Right => ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
            Self::Top => ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]),
            Self::Bottom => ([0.0, 0.0, -1.0], [0.0, -1.0, 0.0]),
        };
        Eye {
            toward,
            up,
            aim: None,
        }
    }
}

/// From where something is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eye {
    /// From the scene towards the viewer, of any length.
    pub toward: [f64; 3],
    /// What is up in the picture, of any length; it need not be square to `toward`.
    pub up: [f64; 3],
    /// The point in the middle of the picture and how much of the height is seen, in mm; the whole scene
    /// where it is left out.
    pub aim: Option<([f64; 3], f64)>,
}

/// A camera over a panel: three directions, the scale and the point in the middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// What points to the right in the picture.
    pub right: [f64; 3],
    /// What points up.
    pub up: [f64; 3],
    /// What points to the viewer.
    pub toward: [f64; 3],
    /// Pixels for a millimetre.
    pub px_per_mm: f64,
    /// The point of the scene that is in the middle of what the panel has for it.
    pub middle: [f64; 3],
    /// That middle, in pixels from the panel's left and top.
    pub centre: [f64; 2],
    /// Width and height of the panel in pixels.
    pub size: [f64; 2],
}

/// The free border at the sides of a panel, in pixels, at most this share of its width.
const SIDE: (f64, f64) = (28.0, 0.08);

/// The same at the top, where the title stands, of the height.
const ABOVE: (f64, f64) = (30.0, 0.12);

/// The same at the bottom, where axes and scale are.
const BELOW: (f64, f64) = (60.0, 0.18);

fn border((px, share): (f64, f64), side: f64) -> f64 {
    px.min(share * side)
}

impl Camera {
    /// A camera over a panel of so many pixels that sees all bodies that want room.
    ///
    /// # Errors
    /// [`RenderError::Camera`] when the eye's directions are none.
    pub fn over(eye: &Eye, bodies: &[Body], size: [f64; 2]) -> Result<Self, RenderError> {
        let (toward, up) = (unit(eye.toward)?, unit(eye.up)?);
        let across = up.cross(&toward);
        // Nearer than a thousandth of a right angle the picture would turn with every digit.
        if across.norm() < 1e-3 {
            return Err(RenderError::Camera);
        }
        let right = across.normalize();
        let [width, height] = size;
        let (above, below) = (border(ABOVE, height), border(BELOW, height));
        let room = [width - 2.0 * border(SIDE, width), height - above - below];
        let mut camera = Self {
            right: right.into(),
            up: toward.cross(&right).into(),
            toward: toward.into(),
            px_per_mm: 1.0,
            middle: [0.0; 3],
            centre: [width / 2.0, above + room[1] / 2.0],
            size,
        };
        if let Some((middle, seen_mm)) = eye.aim {
            camera.middle = middle;
            camera.px_per_mm = height / seen_mm;
        } else if let Some((low, high)) = camera.extent(bodies) {
            let spans = (high - low).map(|s| s.max(1e-6));
            camera.px_per_mm = (room[0] / spans.x).min(room[1] / spans.y);
            let middle = (low + high) / 2.0;
            let up = Vector3::from(camera.up);
            camera.middle = (right * middle.x + up * middle.y + toward * middle.z).into();
        }
        Ok(camera)
    }

    /// The box of the bodies along the camera's directions, in mm.
    fn extent(&self, bodies: &[Body]) -> Option<(Vector3<f64>, Vector3<f64>)> {
        let mut found: Option<(Vector3<f64>, Vector3<f64>)> = None;
        for body in bodies.iter().filter(|b| b.fit) {
            for p in &body.surface.positions {
                let p = self.along(body.placement.point(*p));
                found = Some(found.map_or((p, p), |(low, high)| (low.inf(&p), high.sup(&p))));
            }
        }
        found
    }

    /// A point's components along right, up and toward, in mm.
    fn along(&self, p: [f64; 3]) -> Vector3<f64> {
        let p = Vector3::from(p);
        Vector3::new(
            p.dot(&Vector3::from(self.right)),
            p.dot(&Vector3::from(self.up)),
            p.dot(&Vector3::from(self.toward)),
        )
    }

    /// Where a point is in the panel: pixels from its left and from its top, and how much nearer to the
    /// viewer than the middle, in pixels too.
    #[must_use]
    pub fn project(&self, p: [f64; 3]) -> [f64; 3] {
        let off = (self.along(p) - self.along(self.middle)) * self.px_per_mm;
        let [x, y] = self.centre;
        [x + off.x, y - off.y, off.z]
    }

    /// A direction's components to the right, up and towards the viewer.
    #[must_use]
    pub fn turn(&self, d: [f64; 3]) -> [f64; 3] {
        self.along(d).into()
    }
}

fn unit(v: [f64; 3]) -> Result<Vector3<f64>, RenderError> {
    let v = Vector3::from(v);
    let norm = v.norm();
    if norm.is_finite() && norm > 1e-9 {
        Ok(v / norm)
    } else {
        Err(RenderError::Camera)
    }
}

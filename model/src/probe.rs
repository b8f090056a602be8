//! Probes: questions to a solid whose answers are the geometric evidence of a port.
//!
//! A probe is data, in the part's frame; the kernel answers it. The tolerances are the strict ones of
//! the paper's two sets: 1e-3 rad for directions, coincidence for positions.

use serde::{Deserialize, Serialize};

use crate::frame::Placement;

/// How far a face's normal or axis may be from the stated one, in radians.
pub const DIRECTION_RAD: f64 = 1e-3;

/// How far a face may be from where it is stated, and a radius from its stated value, in mm.
pub const COINCIDENCE_MM: f64 = 1e-4;

/// How far from a stated surface the points lie that must be on one side of it, in mm: far above
/// [`COINCIDENCE_MM`], and thinner than any wall.
pub const NEAR_MM: f64 = 0.005;

/// How much of a cylinder's area must be there: half a turn (a split bearing seat), less what grooves,
/// keyways and cross holes take.
pub const LEAST_AREA: f64 = 0.4;

/// How much of a cylinder's length chamfers and grooves may take: a quarter, or 2 mm where that is
/// more, but never more than half.
#[must_use]
pub fn gap_allowed_mm(length: f64) -> f64 {
    (0.25 * length).max(2.0).min(0.5 * length)
}

/// One question, and what its answer shows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Probe {
    /// What it shows about the port, in plain words.
    pub shows: String,
    /// The question.
    pub test: Test,
}

/// What is asked of a solid. Points in mm, in the part's frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Test {
    /// The point is inside the material, not on its surface.
    In {
        /// The point.
        point: [f64; 3],
    },
    /// The point is outside of the material, not on its surface.
    Out {
        /// The point.
        point: [f64; 3],
    },
    /// The point is on a plane face with this normal out of the material.
    Plane {
        /// The point.
        point: [f64; 3],
        /// Unit normal.
        normal: [f64; 3],
    },
    /// There are cylinder faces of this radius about this axis, along it from the point on.
    Cylinder {
        /// Where the cylinder begins, on its axis.
        point: [f64; 3],
        /// Unit direction of the axis, from the point along the cylinder.
        axis: [f64; 3],
        /// Radius in mm.
        radius: f64,
        /// Length in mm.
        length: f64,
        /// Whether it is the wall of a hole.
        inward: bool,
    },
    /// At least one of these holds.
    AnyOf {
        /// The questions.
        of: Vec<Test>,
    },
}

/// What the kernel answered to a probe.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// Whether it is as the probe has it.
    pub held: bool,
    /// Where it was asked, in mm in the part's frame.
    pub at: [f64; 3],
    /// What was found there, in plain words.
    pub found: String,
}

/// Where a port sits: makes probes from coordinates in the port's frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Site {
    at: Placement,
}

/// Angles of a ring of points, in degrees. Off the axes, where seams and keyways like to be.
const RING_DEG: [f64; 8] = [15.0, 60.0, 105.0, 150.0, 195.0, 240.0, 285.0, 330.0];

impl Site {
    pub(crate) fn new(at: Placement) -> Self {
        Self { at }
    }

    /// A point of the port's frame in the part's frame.
    pub(crate) fn point(&self, x: f64, y: f64, z: f64) -> [f64; 3] {
        // Adding 0.0 turns -0.0 into 0.0.
        self.at.point([x, y, z]).map(|v| v + 0.0)
    }

    /// A point at a radius, an angle and a height about the port's z.
    pub(crate) fn polar(&self, radius: f64, deg: f64, z: f64) -> [f64; 3] {
        let (s, c) = crate::angle::sin_cos_deg(deg);
        self.point(radius * c, radius * s, z)
    }

    /// A direction along the port's z, times a sign.
    fn along(&self, sign: f64) -> [f64; 3] {
        self.at.direction([0.0, 0.0, sign]).map(|v| v + 0.0)
    }

    /// The plane face of the port at a point of its frame.
    pub(crate) fn plane(&self, x: f64, y: f64, z: f64) -> Test {
        Test::Plane {
            point: self.point(x, y, z),
            normal: self.along(1.0),
        }
    }

    /// Plane face, material close behind and none close before it, at a point of the frame.
    pub(crate) fn surface(&self, x: f64, y: f64, z: f64, shows: &str, out: &mut Vec<Probe>) {
        out.push(probe(shows, self.plane(x, y, z)));
        let point = self.point(x, y, z - NEAR_MM);
        out.push(probe("material behind the face", Test::In { point }));
        let point = self.point(x, y, z + NEAR_MM);
        out.push(probe("nothing before the face", Test::Out { point }));
    }

    /// [`Site::surface`] at points of a ring between two radii.
    pub(crate) fn ring_surface(&self, inner: f64, outer: f64, shows: &str, out: &mut Vec<Probe>) {
        for (deg, share) in RING_DEG.iter().zip([0.5, 0.02, 0.9].into_iter().cycle()) {
            let (s, c) = crate::angle::sin_cos_deg(*deg);
            let r = inner + share * (outer - inner);
            self.surface(r * c, r * s, 0.0, shows, out);
        }
    }

    /// A hole of a radius, from height `from` down to `to` of the frame.
    pub(crate) fn hole(&self, radius: f64, from: f64, to: f64, out: &mut Vec<Probe>) {
        let length = from - to;
        let wall = Test::Cylinder {
            point: self.point(0.0, 0.0, from),
            axis: self.along(-1.0),
            radius,
            length,
            inward: true,
        };
        out.push(probe("the wall of the hole", wall));
        for share in [0.05, 0.25, 0.5, 0.75, 0.95] {
            let z = from - share * length;
            let point = self.point(0.0, 0.0, z);
            out.push(probe("the hole is empty on its axis", Test::Out { point }));
            for deg in RING_DEG {
                let point = self.polar(0.95 * radius, deg, z);
                let shows = "the hole is empty up to its wall";
                out.push(probe(shows, Test::Out { point }));
            }
        }
        out.push(self.somewhere_in(radius + NEAR_MM, (from, to), "material around the hole"));
        let point = self.point(0.0, 0.0, from + NEAR_MM);
        out.push(probe("the hole is open at its mouth", Test::Out { point }));
        let point = self.point(0.0, 0.0, to + NEAR_MM);
        out.push(probe(
            "the hole is empty down to its end",
            Test::Out { point },
        ));
    }

    /// A solid or hollow cylinder of a radius, from height `from` down to `to` of the frame.
    pub(crate) fn cylinder(&self, radius: f64, from: f64, to: f64, out: &mut Vec<Probe>) {
        let length = from - to;
        let wall = Test::Cylinder {
            point: self.point(0.0, 0.0, from),
            axis: self.along(-1.0),
            radius,
            length,
            inward: false,
        };
        out.push(probe("the outer surface of the cylinder", wall));
        let step = NEAR_MM.min(0.1 * radius);
        out.push(self.somewhere_in(
            radius - step,
            (from, to),
            "material under the cylinder's surface",
        ));
        for share in [0.05, 0.25, 0.5, 0.75, 0.95] {
            for deg in RING_DEG {
                let point = self.polar(radius + NEAR_MM, deg, from - share * length);
                let shows = "nothing around the cylinder";
                out.push(probe(shows, Test::Out { point }));
            }
        }
    }

    /// Material on a ring, at each of three heights somewhere around.
    fn somewhere_in(&self, radius: f64, (from, to): (f64, f64), shows: &str) -> Probe {
        let mut of = Vec::new();
        for share in [0.5, 0.3, 0.7] {
            for deg in RING_DEG {
                let point = self.polar(radius, deg, from + share * (to - from));
                of.push(Test::In { point });
            }
        }
        probe(shows, Test::AnyOf { of })
    }

    /// A plane mouth at the origin: a face somewhere close around a hole of a radius.
    pub(crate) fn mouth(&self, radius: f64) -> Probe {
        let mut of = Vec::new();
        for share in [1.25, 1.1, 1.5] {
            for deg in RING_DEG {
                let (s, c) = crate::angle::sin_cos_deg(deg);
                of.push(self.plane(share * radius * c, share * radius * s, 0.0));
            }
        }
        probe("a plane face around the mouth", Test::AnyOf { of })
    }
}

/// A probe.
pub(crate) fn probe(shows: &str, test: Test) -> Probe {
    Probe {
        shows: shows.to_owned(),
        test,
    }
}

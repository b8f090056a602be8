//! Driving one part through a range, everything coupled to it following.
//!
//! The part moves by the block of links that carries it, or by the nearest block towards the ground that moves it;
//! all other blocks stand still in themselves. Where the block has several motions, the driver coordinates of the
//! others are held. What is left is a curve of poses, which is followed by its tangent and brought back onto the
//! constraints by Newton's method (Allgower and Georg, *Numerical Continuation Methods*, 1990), the coordinate of
//! the driven part being prescribed. A pose from which no one curve goes on ends the drive.

mod choose;
mod follow;

use nalgebra::{DVector, Vector3};

use self::choose::{Choice, Held, choose, locked, movable};
use super::blocks::{Block, Blocks};
use super::island::split;
use super::linear::RANK_TOLERANCE;
use super::model::{Model, moved};
use super::rigid::{Rigid, angular, linear};
use super::words::{BodyMotion, body_motions, words};
use super::{Axis, System};
use crate::frame::{Placement, Rows};

/// Turning or sliding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DriveKind {
    /// The part turns: its coordinate is an angle in radians.
    Rotate,
    /// The part slides: its coordinate is a travel in mm.
    Slide,
}

/// Why a part cannot be driven.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoDrive {
    /// Nothing holds it to the root.
    Floats,
    /// It cannot move so; the bodies that can.
    Held(Vec<usize>),
    /// How the links go on away from the pose is not known, or the number of motions cannot be told.
    Unknown,
}

/// Why a drive went no further.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stuck {
    /// The part has come to an end of its travel: a dead centre.
    Limit,
    /// More than one motion starts here.
    Branches,
    /// Whether it goes on could not be told.
    Unclear,
}

/// A part and how it is driven.
#[derive(Debug)]
pub struct Drive {
    /// What moves how at the start, in words.
    pub name: String,
    /// The part's own motion at the start; the direction is that of the positive coordinate.
    pub part: BodyMotion,
    /// Turning or sliding.
    pub kind: DriveKind,
    /// The other motions of the same links, which are held: in words.
    pub still: Vec<String>,
    model: Model,
    /// For each unit the first one that it is locked to; none for what is locked to the ground.
    groups: Vec<Option<usize>>,
    /// Motions that are held by their rates, since their joints cannot be locked alone.
    held: Vec<Held>,
    unit: usize,
    direction: Vector3<f64>,
    point: Vector3<f64>,
    /// For each body the unit that it goes with; none for what stands still.
    carried: Vec<Option<usize>>,
}

/// A pose of a drive.
#[derive(Debug, Clone)]
pub struct Pose {
    /// The driven coordinate from the start, in radians or mm.
    pub value: f64,
    at: Vec<Rigid>,
    /// The motion here, at a rate of 1; none where it was not asked for yet.
    along: Option<DVector<f64>>,
    /// How clearly there is one motion only: the constraints' smallest singular value.
    strength: f64,
    strongest: f64,
}

impl Drive {
    /// A drive of a body.
    ///
    /// # Errors
    /// Why it cannot be driven.
    pub fn new(system: &System, body: usize, kind: Option<DriveKind>) -> Result<Self, NoDrive> {
        let islands = split(system);
        let island = islands.iter().find(|i| i.bodies.contains(&body));
        let island = island.ok_or(NoDrive::Unknown)?;
        if island.floating {
            return Err(NoDrive::Floats);
        }
        let model = Model::new(island, system, true);
        let blocks = Blocks::new(&model);
        let chosen = choose(&model, &blocks, body, kind)?;
        let chosen = chosen.ok_or_else(|| NoDrive::Held(movable(island, &model, &blocks)))?;
        let block = blocks.blocks.get(chosen.block).ok_or(NoDrive::Unknown)?;
        Self::of(system, &model, &blocks, block, &chosen).ok_or(NoDrive::Unknown)
    }

    fn of(
        system: &System,
        model: &Model,
        blocks: &Blocks,
        block: &Block,
        chosen: &Choice,
    ) -> Option<Self> {
        let (own, held) = locked(&block.model, &chosen.basis, chosen.motion);
        if !own.ties.iter().all(|t| t.scaled.is_group()) {
            return None;
        }
        let each = chosen.basis.motions.iter();
        let lifted: Vec<_> = each.map(|m| blocks.lifted(chosen.block, m)).collect();
        let said = |k: usize| {
            let driver = chosen.basis.drivers.get(k);
            let travels = driver.is_some_and(|d| d.travels(&block.model));
            lifted
                .get(k)
                .map_or_else(Vec::new, |m| body_motions(model, system, m, travels))
        };
        let bodies = said(chosen.motion);
        let body = system.bodies.get(chosen.body)?;
        let part = bodies.iter().find(|b| b.body == body.name)?;
        let motion = chosen.basis.motions.get(chosen.motion)?;
        let twist = motion.twist(Some(chosen.unit));
        let along = match chosen.kind {
            DriveKind::Rotate => angular(&twist),
            DriveKind::Slide => linear(&twist),
        };
        let groups = groups(&own);
        let unit_of = |b: usize| {
            let (_, unit) = model.members.iter().find(|(m, _)| *m == b)?;
            let unit = blocks.carried(chosen.block, *unit)?;
            groups.get(unit).copied().flatten()
        };
        let others = (0..lifted.len()).filter(|k| *k != chosen.motion);
        Some(Self {
            name: words(&bodies, false),
            part: part.clone(),
            kind: chosen.kind,
            still: others
                .map(|k| words(&said(k), k < chosen.basis.idle))
                .collect(),
            // As the part's direction, without its rounding.
            direction: along.normalize() * along.dot(&Vector3::from(part.direction)).signum(),
            point: (Vector3::from(body.at) - model.middle) / model.length,
            unit: chosen.unit,
            carried: (0..system.bodies.len()).map(unit_of).collect(),
            groups,
            model: own,
            held,
        })
    }

    /// Which bodies move as one: equal numbers; none for those that stand still.
    #[must_use]
    pub fn carried(&self, body: usize) -> Option<usize> {
        self.carried.get(body).copied().flatten()
    }

    /// The pose in which the drive was set up.
    #[must_use]
    pub fn start(&self) -> Pose {
        let mut start = Pose {
            value: 0.0,
            at: vec![Rigid::IDENTITY; self.model.units],
            along: None,
            strength: 0.0,
            strongest: 0.0,
        };
        // Where there is no one motion the first step says so.
        if let Ok((along, strength)) = self.tangent(&self.model) {
            start.along = Some(along);
            (start.strength, start.strongest) = (strength, strength);
        }
        start
    }

    /// How a body has moved in the world since the start.
    #[must_use]
    pub fn moved(&self, pose: &Pose, body: usize) -> Placement {
        let r = moved(&pose.at, self.carried(body));
        let (m, middle) = (r.rotation, self.model.middle);
        let t = middle + r.translation * self.model.length - m * middle;
        Placement::from(Rows([
            [m.m11, m.m12, m.m13, t.x],
            [m.m21, m.m22, m.m23, t.y],
            [m.m31, m.m32, m.m33, t.z],
        ]))
    }

    /// The axis in the world, at the start, about which two bodies turn against each other in every pose, and
    /// nothing else: they or what carries them are joined by hinges on one line.
    #[must_use]
    pub fn hinge(&self, a: usize, b: usize) -> Option<Axis> {
        let (a, b) = (self.carried(a), self.carried(b));
        let group = |unit: Option<usize>| self.groups.get(unit?).copied().flatten();
        let joined = |x: Option<usize>, y: Option<usize>| {
            let ties = self.model.ties.iter().filter(move |t| {
                let ends = (group(t.base), group(t.incoming));
                ends == (x, y) || ends == (y, x)
            });
            ties.filter_map(|t| t.scaled.hinge())
        };
        let others = || (0..self.model.units).map(Some).chain([None]);
        let over = |c: Option<usize>| {
            joined(a, c).find(|one| joined(c, b).any(|other| same_line(one, &other)))
        };
        let found = joined(a, b).next().or_else(|| others().find_map(over));
        found.map(|(point, direction)| Axis {
            point: (self.model.middle + point * self.model.length).into(),
            direction: direction.into(),
        })
    }
}

/// For each unit the first one of those that locked joints make one with it; none where that is the ground.
fn groups(model: &Model) -> Vec<Option<usize>> {
    let mut out: Vec<Option<usize>> = (0..model.units).map(Some).collect();
    let of = |out: &[Option<usize>], unit: Option<usize>| out.get(unit?).copied().flatten();
    for tie in model.ties.iter().filter(|t| t.scaled.rows() == 6) {
        let (a, b) = (of(&out, tie.base), of(&out, tie.incoming));
        // The ground comes before all units.
        let (keep, gone) = (a.min(b), a.max(b));
        out.iter_mut()
            .filter(|g| **g == gone)
            .for_each(|g| *g = keep);
    }
    out
}

/// Whether two lines, each a point and a unit direction, are one, up to the rounding of placements.
fn same_line(one: &(Vector3<f64>, Vector3<f64>), other: &(Vector3<f64>, Vector3<f64>)) -> bool {
    one.1.cross(&other.1).norm() <= RANK_TOLERANCE
        && (one.0 - other.0).cross(&one.1).norm() <= RANK_TOLERANCE
}

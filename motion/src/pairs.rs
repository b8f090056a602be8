//! The pairs of parts that move against each other, and which of them are proven apart.

use std::collections::BTreeMap;

use assemcad_geometry::questions::revolution::Line;
use assemcad_model::freedom::Axis;
use futures::future::join_all;

use crate::answer::Proof;
use crate::hulls::Ring;
use crate::mechanism::Mechanism;

/// Two parts that move against each other, by their places in the specification.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pair {
    pub(crate) a: usize,
    pub(crate) b: usize,
    /// What proves them, given that they are apart in one pose.
    pub(crate) proof: Option<Proof>,
}

impl Mechanism<'_> {
    /// All pairs that move against each other, and how often the kernel was asked for it.
    pub(crate) async fn pairs(&self) -> (Vec<Pair>, usize) {
        let mut pairs = Vec::new();
        let mut axes = Vec::new();
        for a in 0..self.assembled.resolved.parts.len() {
            for b in a + 1..self.assembled.resolved.parts.len() {
                // Parts without a place are in no pair; verify reports them.
                let places = (
                    self.assembled.placements.of(a),
                    self.assembled.placements.of(b),
                );
                let ((Some(_), Some(_)), true) =
                    (places, self.drive.carried(a) != self.drive.carried(b))
                else {
                    continue;
                };
                let axis = self.drive.hinge(a, b);
                let rings = axis.and_then(|x| Some((self.ring(a, &x)?, self.ring(b, &x)?)));
                let apart = rings.is_some_and(|(one, other)| one.apart(&other));
                pairs.push(Pair {
                    a,
                    b,
                    proof: apart.then_some(Proof::Rings),
                });
                axes.push(axis);
            }
        }
        let mut wanted: BTreeMap<usize, Vec<Line>> = BTreeMap::new();
        for (pair, axis) in pairs.iter().zip(&axes).filter(|(p, _)| p.proof.is_none()) {
            for part in [pair.a, pair.b] {
                if let Some(line) = axis.and_then(|x| self.line(part, &x)) {
                    wanted.entry(part).or_default().push(line);
                }
            }
        }
        let asked = wanted.len();
        let round: BTreeMap<usize, Vec<bool>> = join_all(
            wanted
                .iter()
                .map(|(part, lines)| async move { (*part, self.round(*part, lines).await) }),
        )
        .await
        .into_iter()
        .collect();
        // The answers come in the order of the questions.
        let mut answers: BTreeMap<usize, _> = round
            .into_iter()
            .map(|(part, all)| (part, all.into_iter()))
            .collect();
        for (pair, axis) in pairs
            .iter_mut()
            .zip(&axes)
            .filter(|(p, _)| p.proof.is_none())
        {
            if axis.is_none() {
                continue;
            }
            let mut one =
                |part: usize| answers.get_mut(&part).and_then(Iterator::next) == Some(true);
            let (a, b) = (one(pair.a), one(pair.b));
            pair.proof = (a || b).then_some(Proof::Revolution);
        }
        (pairs, asked)
    }

    fn ring(&self, part: usize, axis: &Axis) -> Option<Ring> {
        let built = self.assembled.built(part)?;
        Some(Ring::of(built, &self.assembled.placements.of(part)?, axis))
    }

    /// An axis in a part's frame.
    fn line(&self, part: usize, axis: &Axis) -> Option<Line> {
        let back = self.assembled.placements.of(part)?.inverse();
        Some((back.point(axis.point), back.direction(axis.direction)))
    }

    /// Whether a part is a solid of revolution about each of some lines; what cannot be told is taken for no.
    async fn round(&self, part: usize, lines: &[Line]) -> Vec<bool> {
        let no = vec![false; lines.len()];
        let Some(part) = self.assembled.resolved.parts.get(part) else {
            return no;
        };
        let found = self.door.revolution(&part.made.solid, lines).await;
        found.unwrap_or(no)
    }
}

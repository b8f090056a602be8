//! The pairs of parts that move against each other, and which of them are proven apart.

use std::collections::BTreeMap;

use assemcad_kernel::protocol::{Job, Reply};
use assemcad_model::freedom::Axis;
use futures::future::join_all;

use super::answer::Proof;
use super::hulls::Ring;
use super::walk::Walk;

/// Two parts that move against each other, by their places in the specification.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair {
    pub(super) a: usize,
    pub(super) b: usize,
    /// What proves them, given that they are apart in one pose.
    pub(super) proof: Option<Proof>,
}

/// A line in a part's frame: a point and a direction.
type Line = ([f64; 3], [f64; 3]);

impl Walk<'_> {
    /// All pairs that move against each other, and how often the kernel was asked for it.
    pub(super) async fn pairs(&self) -> (Vec<Pair>, usize) {
        let mut pairs = Vec::new();
        let mut axes = Vec::new();
        for a in 0..self.resolved.parts.len() {
            for b in a + 1..self.resolved.parts.len() {
                // Parts without a place are in no pair; verify reports them.
                let places = (self.placed.of(a), self.placed.of(b));
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
        let built = self.built.get(part)?.as_ref()?;
        Some(Ring::of(built, &self.placed.of(part)?, axis))
    }

    /// An axis in a part's frame.
    fn line(&self, part: usize, axis: &Axis) -> Option<Line> {
        let back = self.placed.of(part)?.inverse();
        Some((back.point(axis.point), back.direction(axis.direction)))
    }

    /// Whether a part is a solid of revolution about each of some lines; what cannot be told is taken for no.
    async fn round(&self, part: usize, lines: &[Line]) -> Vec<bool> {
        let no = vec![false; lines.len()];
        let Some(part) = self.resolved.parts.get(part) else {
            return no;
        };
        let job = Job::Revolution {
            recipe: part.made.recipe.clone(),
            axes: lines.to_vec(),
        };
        match self.workshop.pool.run(&job).await {
            Ok((Reply::Revolution(found), _)) if found.len() == lines.len() => found,
            _ => no,
        }
    }
}

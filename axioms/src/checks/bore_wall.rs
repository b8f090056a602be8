//! N-02: wall around a bore.

use std::collections::BTreeMap;

use super::Check;
use crate::asked::bores;
use crate::facts::Wall;
use crate::indexed::Indexed;
use crate::ruling::{About, Ruling, Status};

/// The wall of a bore is a tenth of its diameter at least, wherever the bore has a wall.
pub struct BoreWall;

/// How much thinner a wall may seem than it is, in mm: it is measured on triangles that deviate from the
/// surface.
const MEASURED_MM: f64 = 0.05;

impl Check for BoreWall {
    fn id(&self) -> &'static str {
        "bore_wall"
    }

    fn axiom(&self) -> &'static str {
        "N-02"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut walls: BTreeMap<(&str, &str), &Wall> = BTreeMap::new();
        for w in facts.measured.walls.iter().flatten() {
            walls.entry((&w.part, &w.port)).or_insert(w);
        }
        bores(facts)
            .into_iter()
            .map(|bore| {
                let (part, port) = (&bore.hole.part.id, &bore.hole.port.name);
                let about = About::parts([part]);
                let wall = walls.get(&(part.as_str(), port.as_str()));
                let Some((wall, least)) = wall.and_then(|w| Some((w, w.least_mm?))) else {
                    let message = format!("the wall around '{port}' of '{part}' was not measured");
                    return Ruling::new(self.axiom(), Status::Indeterminate, about, message);
                };
                let wanted = bore.least_mm;
                let message = format!(
                    "'{port}' of '{part}' has {least:.3} mm of wall where it is thinnest; {wanted:.3} mm is \
                     the least"
                );
                Ruling::held(self.axiom(), least >= wanted - MEASURED_MM, about, message)
                    .value("wall_mm", least)
                    .value("least_mm", wanted)
                    .value("rays", f64::from(wall.rays))
                    .value("rays_that_met_the_wall", f64::from(wall.met))
                    .assuming(
                        "the least wall is a tenth of the bore's diameter, a rule of ours; where a keyway, slot \
                         or cross hole opens the bore there is no wall to measure",
                    )
            })
            .collect()
    }
}

//! N-05: the machine stands.

use super::Check;
use crate::facts::{Material, PartFacts};
use crate::indexed::Indexed;
use crate::ruling::{About, Ruling, Status};

/// The centre of mass is above the box of the ground.
pub struct StableFooting;

/// Density in kg/dm3, of which only the proportions count here: round values of the families.
fn density(part: &PartFacts) -> f64 {
    match part.material {
        Some(Material::Aluminium) => 2.7,
        Some(Material::CastIron) => 7.2,
        Some(Material::Steel) | None => 7.85,
    }
}

impl Check for StableFooting {
    fn id(&self) -> &'static str {
        "stable_footing"
    }

    fn axiom(&self) -> &'static str {
        "N-05"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let ground = facts.root().and_then(|r| facts.part(r));
        let Some(ground) = ground.and_then(|g| g.geometry.as_ref()) else {
            return Vec::new();
        };
        let (mut mass, mut x, mut y) = (0.0, 0.0, 0.0);
        let mut stated = true;
        for part in &facts.parts {
            let Some(g) = &part.geometry else {
                let message = format!("'{}' was not measured", part.id);
                let about = About::parts([&part.id]);
                return vec![Ruling::new(
                    self.axiom(),
                    Status::Indeterminate,
                    about,
                    message,
                )];
            };
            let weight = density(part) * g.volume_mm3;
            stated &= part.material.is_some();
            let [cx, cy, _] = g.centre_mm;
            mass += weight;
            x += weight * cx;
            y += weight * cy;
        }
        let (x, y) = (x / mass, y / mass);
        let [[x0, y0, _], [x1, y1, _]] = ground.box_mm;
        let inside = (x - x0).min(x1 - x).min(y - y0).min(y1 - y);
        let message = format!(
            "the centre of mass, at x = {x:.3} and y = {y:.3} mm, is {inside:.3} mm within the ground's outline"
        );
        let mut assumed =
            "gravity against z; the ground stands on the whole rectangle about it".to_owned();
        if !stated {
            assumed.push_str("; steel where no material is stated");
        }
        vec![
            Ruling::held(self.axiom(), inside >= 0.0, About::assembly(), message)
                .value("inside_mm", inside)
                .value("x_mm", x)
                .value("y_mm", y)
                .assuming(assumed),
        ]
    }
}

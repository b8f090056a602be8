//! Parts made and measured by the kernel's workers.

pub use assemcad_factories::failure::{diagnostic, failed_in};
use assemcad_kernel::protocol::{Built, Failure, Job, Reply};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::frame::Placement;
use assemcad_model::recipe::Recipe;
use assemcad_model::report::rounded;

use crate::Workshop;
use crate::resolve::ResolvedPart;

impl Workshop {
    /// Makes a part's solid and measures it. The kernel answers only for one valid closed solid of
    /// positive volume.
    ///
    /// # Errors
    /// Why there is no such solid, with the operation and its line in the factory's source.
    pub async fn build(&self, part: &ResolvedPart) -> Result<Built, Diagnostic> {
        self.solid(&part.made.recipe, |failure| part_failure(failure, part))
            .await
    }

    /// Makes the solid of a recipe; `failed` tells whose it was when the kernel fails.
    pub(crate) async fn solid(
        &self,
        recipe: &Recipe,
        failed: impl FnOnce(&Failure) -> Diagnostic,
    ) -> Result<Built, Diagnostic> {
        let job = Job::Build {
            recipe: recipe.clone(),
        };
        match self.pool.run(&job).await {
            Ok((Reply::Built(built), _)) => Ok(built),
            Ok(_) => Err(unexpected(&job)),
            Err(failure) => Err(failed(&failure)),
        }
    }
}

/// Smallest and largest corner of a box, in mm.
pub type Box3 = ([f64; 3], [f64; 3]);

/// A box in the world around a placed part: the box of its own box's corners.
#[must_use]
pub fn box_of(b: &Built, at: &Placement) -> Box3 {
    let (mut min, mut max) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for x in [b.min[0], b.max[0]] {
        for y in [b.min[1], b.max[1]] {
            for z in [b.min[2], b.max[2]] {
                for (k, v) in at.point([x, y, z]).into_iter().enumerate() {
                    if let (Some(lo), Some(hi)) = (min.get_mut(k), max.get_mut(k)) {
                        *lo = lo.min(v);
                        *hi = hi.max(v);
                    }
                }
            }
        }
    }
    (min, max)
}

/// A box as it is reported.
#[must_use]
pub fn reported((min, max): &Box3) -> [[f64; 3]; 2] {
    [min.map(rounded), max.map(rounded)]
}

/// A failure in making a part.
#[must_use]
pub fn part_failure(failure: &Failure, part: &ResolvedPart) -> Diagnostic {
    failed_in(failure, Some(&part.id), &part.factory, &part.made.lines)
}

/// A worker's answer to another question: a fault of the server.
#[must_use]
pub(crate) fn unexpected(job: &Job) -> Diagnostic {
    Diagnostic::error(
        Code::Internal,
        job.name(),
        "the worker answered another question",
    )
}

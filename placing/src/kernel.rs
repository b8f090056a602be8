//! The one door to the kernel: a typed answer to every question about solids, or why there is none.

use assemcad_factories::evidence::{self, Asked, Unasked};
use assemcad_kernel::asked::{Body, Chosen, Measured};
use assemcad_kernel::contact::{Touch, Where};
use assemcad_kernel::mesh::Mesh;
use assemcad_kernel::pair::Distance;
use assemcad_kernel::pool::Pool;
use assemcad_kernel::protocol::{
    Built, CommonVolume, Failure, FailureKind, Instance, Job, Product, Reply, StepFacts,
};
use assemcad_model::ports::Port;
use assemcad_model::probe::{Answer, Probe};
use assemcad_model::recipe::Recipe;

pub use assemcad_kernel::protocol::Placed as PlacedSolid;

/// A line in a part's frame: a point in mm and a unit direction.
pub type Line = ([f64; 3], [f64; 3]);

/// The kernel, in worker processes. Every failure is that of one question.
#[derive(Debug)]
pub struct Kernel {
    pool: Pool,
}

impl Kernel {
    /// The kernel behind some workers.
    #[must_use]
    pub fn new(pool: Pool) -> Self {
        Self { pool }
    }

    /// The workers, for the gate of users' factories, which asks them itself.
    #[must_use]
    pub fn pool(&self) -> &Pool {
        &self.pool
    }

    /// Makes a solid and measures it. The kernel answers only for one valid closed solid of positive
    /// volume.
    ///
    /// # Errors
    /// Why there is no such solid.
    pub async fn build(&self, recipe: &Recipe) -> Result<Built, Failure> {
        let job = Job::Build {
            recipe: recipe.clone(),
        };
        match self.pool.run(&job).await? {
            (Reply::Built(built), _) => Ok(built),
            _ => Err(unexpected()),
        }
    }

    /// The volume that two placed solids have in common, and an estimate of it from so many points.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn common_volume(
        &self,
        a: PlacedSolid,
        b: PlacedSolid,
        samples: u32,
    ) -> Result<CommonVolume, Failure> {
        let job = Job::CommonVolume {
            a: Box::new(a),
            b: Box::new(b),
            samples,
        };
        match self.pool.run(&job).await? {
            (Reply::CommonVolume(volume), _) => Ok(volume),
            _ => Err(unexpected()),
        }
    }

    /// The area over which two placed solids touch in a stated surface.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn contact(
        &self,
        a: PlacedSolid,
        b: PlacedSolid,
        place: Where,
    ) -> Result<Touch, Failure> {
        let job = Job::Contact {
            a: Box::new(a),
            b: Box::new(b),
            place,
        };
        match self.pool.run(&job).await? {
            (Reply::Contact(touch), _) => Ok(touch),
            _ => Err(unexpected()),
        }
    }

    /// What a solid has at some places: an answer to each probe, in order.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn probe(&self, recipe: &Recipe, probes: Vec<Probe>) -> Result<Vec<Answer>, Failure> {
        let asked = probes.len();
        let job = Job::Probe {
            recipe: recipe.clone(),
            probes,
        };
        match self.pool.run(&job).await? {
            (Reply::Probed(answers), _) if answers.len() == asked => Ok(answers),
            _ => Err(unexpected()),
        }
    }

    /// The probes that prove some ports, and the solid's answers.
    ///
    /// # Errors
    /// When a port is not well formed, or the kernel does not answer.
    pub async fn evidence<'a>(
        &self,
        recipe: &Recipe,
        ports: &'a [Port],
    ) -> Result<Vec<Asked<'a>>, Unasked> {
        evidence::ask(&self.pool, recipe, ports).await
    }

    /// Whether a solid is one of revolution about each of some axes in its frame, in order.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn revolution(&self, recipe: &Recipe, axes: Vec<Line>) -> Result<Vec<bool>, Failure> {
        let asked = axes.len();
        let job = Job::Revolution {
            recipe: recipe.clone(),
            axes,
        };
        match self.pool.run(&job).await? {
            (Reply::Revolution(found), _) if found.len() == asked => Ok(found),
            _ => Err(unexpected()),
        }
    }

    /// The triangles of a body, within a distance in mm and an angle of its surface; none where the body
    /// is empty.
    ///
    /// # Errors
    /// Why there are none.
    pub async fn tessellate(
        &self,
        body: Body,
        deflection_mm: f64,
        angle_deg: f64,
    ) -> Result<Option<Mesh>, Failure> {
        let job = Job::Tessellate {
            body,
            deflection: deflection_mm,
            angle_deg,
        };
        match self.pool.run(&job).await? {
            (Reply::Mesh { some: false }, _) => Ok(None),
            (Reply::Mesh { some: true }, bytes) => Mesh::from_bytes(&bytes)
                .map(Some)
                .ok_or_else(|| nonsense("the worker sent no mesh")),
            _ => Err(unexpected()),
        }
    }

    /// Extent and centre of a placed part or of faces of it.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn measure(&self, of: Chosen) -> Result<Measured, Failure> {
        let job = Job::Measure { of: Box::new(of) };
        match self.pool.run(&job).await? {
            (Reply::Measured(measured), _) => Ok(measured),
            _ => Err(unexpected()),
        }
    }

    /// The smallest distance of two placed parts, or of faces of them.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn distance(&self, a: Chosen, b: Chosen) -> Result<Distance, Failure> {
        let job = Job::Distance {
            a: Box::new(a),
            b: Box::new(b),
        };
        match self.pool.run(&job).await? {
            (Reply::Distance(distance), _) => Ok(distance),
            _ => Err(unexpected()),
        }
    }

    /// The STEP file of an assembly and what it holds when it is read back: by a fresh process, so that
    /// its bytes depend on nothing else. `description` are the lines of the file's description.
    ///
    /// # Errors
    /// Why there is no file.
    pub async fn step(
        &self,
        name: &str,
        description: Vec<String>,
        solids: Vec<Product>,
        instances: Vec<Instance>,
    ) -> Result<(StepFacts, Vec<u8>), Failure> {
        let job = Job::Step {
            name: name.to_owned(),
            description,
            solids,
            instances,
        };
        match self.pool.run_fresh(&job).await? {
            (Reply::Step(facts), bytes) => Ok((facts, bytes)),
            _ => Err(unexpected()),
        }
    }
}

/// A worker's answer to another question: a fault of the server.
fn unexpected() -> Failure {
    nonsense("the worker answered another question")
}

fn nonsense(message: &str) -> Failure {
    Failure {
        kind: FailureKind::Worker,
        doing: None,
        message: message.to_owned(),
    }
}

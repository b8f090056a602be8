//! What the server asks of the kernel's workers and what they answer.

use assemcad_model::frame::Rows;
use assemcad_model::ports::Port;
use assemcad_model::probe::{Answer, Probe};
use assemcad_workers::Work;
pub use assemcad_workers::{Doing, Failure, FailureKind};
use serde::{Deserialize, Serialize};

use crate::asked::{Body, Chosen, Measured};
use crate::contact::{Touch, Where};
pub use crate::named::Named;
use crate::pair::Distance;

/// The kernel's kind of work.
#[derive(Debug)]
pub struct KernelWork;

impl Work for KernelWork {
    type Job = Job;
    type Reply = Reply;
    const SUBCOMMAND: &'static str = "worker";
    fn name(job: &Job) -> &'static str {
        job.name()
    }
}

/// A solid in its place.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Placed {
    /// How to make it.
    pub recipe: Named,
    /// Where it is.
    pub placement: Rows,
}

/// A piece of work for a worker.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Job {
    /// Make a solid and measure it.
    Build {
        /// How to make it.
        recipe: Named,
    },
    /// The volume that two placed solids have in common, and an independent estimate of it.
    CommonVolume {
        /// First solid.
        a: Box<Placed>,
        /// Second solid.
        b: Box<Placed>,
        /// How many points the estimate takes.
        samples: u32,
    },
    /// What a solid has where its ports are.
    Probe {
        /// How to make it.
        recipe: Named,
        /// What is asked.
        probes: Vec<Probe>,
    },
    /// The area over which two placed solids touch in a stated surface.
    Contact {
        /// First solid.
        a: Box<Placed>,
        /// Second solid.
        b: Box<Placed>,
        /// The surface, in the world.
        place: Where,
    },
    /// Whether a solid is one of revolution about each of some axes.
    Revolution {
        /// How to make it.
        recipe: Named,
        /// The axes in the part's frame: a point in mm and a unit direction.
        axes: Vec<([f64; 3], [f64; 3])>,
    },
    /// A STEP file of an assembly, read back after writing.
    Step {
        /// The distinct solids.
        solids: Vec<Product>,
        /// The parts, each an instance of a solid.
        instances: Vec<Instance>,
        /// Name of the assembly.
        name: String,
        /// The lines of the file's description.
        description: Vec<String>,
    },
    /// Triangles and edges of a body.
    Tessellate {
        /// The body.
        body: Body,
        /// How far a triangle may be from the surface, in mm.
        deflection: f64,
        /// How far a triangle may be turned from the surface, in degrees.
        angle_deg: f64,
    },
    /// The skin of a solid.
    Skin {
        /// How to make it.
        recipe: Named,
        /// How far a triangle may be from the surface, in mm.
        deflection: f64,
        /// How far a triangle may be turned from the surface, in degrees.
        angle_deg: f64,
    },
    /// Extent and centre of a placed part or of faces of it.
    Measure {
        /// What is measured.
        of: Box<Chosen>,
    },
    /// The smallest distance of two placed parts, or of faces of them.
    Distance {
        /// First.
        a: Box<Chosen>,
        /// Second.
        b: Box<Chosen>,
    },
}

impl Job {
    /// The job's name, for diagnostics.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Build { .. } => "build",
            Self::CommonVolume { .. } => "common volume",
            Self::Probe { .. } => "probes of ports",
            Self::Contact { .. } => "contact",
            Self::Revolution { .. } => "surfaces of revolution",
            Self::Step { .. } => "STEP export",
            Self::Tessellate { .. } => "triangles",
            Self::Skin { .. } => "skin",
            Self::Measure { .. } => "measurement",
            Self::Distance { .. } => "smallest distance",
        }
    }
}

impl Job {
    /// The same job with the names of its solids alone.
    #[must_use]
    pub fn without_recipes(&self) -> Self {
        let mut job = self.clone();
        let bare = |solid: &mut Named| *solid = solid.alone();
        match &mut job {
            Self::Build { recipe }
            | Self::Probe { recipe, .. }
            | Self::Revolution { recipe, .. }
            | Self::Skin { recipe, .. } => bare(recipe),
            Self::CommonVolume { a, b, .. } | Self::Contact { a, b, .. } => {
                bare(&mut a.recipe);
                bare(&mut b.recipe);
            }
            Self::Tessellate { body, .. } => match body {
                Body::Whole { recipe } | Body::Behind { recipe, .. } => bare(recipe),
                Body::Shared { a, b } => {
                    bare(&mut a.recipe);
                    bare(&mut b.recipe);
                }
            },
            Self::Measure { of } => bare(&mut of.part.recipe),
            Self::Distance { a, b } => {
                bare(&mut a.part.recipe);
                bare(&mut b.part.recipe);
            }
            // Sent once, to a fresh process.
            Self::Step { .. } => {}
        }
        job
    }
}

/// A distinct solid in a STEP file.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Product {
    /// Product name.
    pub name: String,
    /// How to make it.
    pub recipe: Named,
    /// Colour: red, green, blue from 0 to 1.
    pub color: [f64; 3],
}

/// An instance of a solid in a STEP file.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Instance {
    /// Instance name.
    pub name: String,
    /// Index of its solid.
    pub solid: usize,
    /// Where it is.
    pub placement: Rows,
}

/// The result of a job.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Reply {
    /// Of [`Job::Build`].
    Built(Built),
    /// Of [`Job::CommonVolume`].
    CommonVolume(CommonVolume),
    /// Of [`Job::Probe`]: an answer to each probe, in order.
    Probed(Vec<Answer>),
    /// Of [`Job::Contact`].
    Contact(Touch),
    /// Of [`Job::Revolution`]: an answer for each axis, in order.
    Revolution(Vec<bool>),
    /// Of [`Job::Step`]; the file is the message's block.
    Step(StepFacts),
    /// Of [`Job::Tessellate`]: whether there is anything to draw; the mesh is the message's block.
    Mesh {
        /// False where the body is empty.
        some: bool,
    },
    /// Of [`Job::Skin`]; the skin is the message's block.
    Skin,
    /// Of any: the worker does not know one of the solids, and its recipe did not come with it.
    Unknown,
    /// Of [`Job::Measure`].
    Measured(Measured),
    /// Of [`Job::Distance`].
    Distance(Distance),
}

/// What was measured of a solid, in the part's frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Built {
    /// SHA-256 of the recipe.
    pub recipe: String,
    /// Where the solid came from.
    pub source: Source,
    /// Volume in mm3.
    pub volume: f64,
    /// Surface in mm2.
    pub area: f64,
    /// Centre of mass in mm.
    pub centre: [f64; 3],
    /// Smallest corner of the bounding box in mm.
    pub min: [f64; 3],
    /// Largest corner of the bounding box in mm.
    pub max: [f64; 3],
    /// SHA-256 of the solid's BREP bytes.
    pub brep: String,
    /// The ports, in the part's frame.
    pub ports: Vec<Port>,
}

/// Where a solid came from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Source {
    /// From the worker's memory.
    Memory,
    /// From the cache on disk.
    Disk,
    /// Replayed from its recipe.
    Replayed,
    /// Replayed, because its cache entry was damaged.
    Repaired,
}

/// The common volume of two solids.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CommonVolume {
    /// By the kernel's boolean, in mm3.
    pub volume: f64,
    /// Smallest and largest corner of the common part's box and its centre, in mm, where there is one.
    pub place: Option<([f64; 3], [f64; 3], [f64; 3])>,
    /// What the boolean warned of.
    pub warnings: Vec<String>,
    /// Points of the estimate: tried, and found inside both solids.
    pub samples: u32,
    /// Points found strictly inside both solids.
    pub inside: u32,
    /// The volume in mm3 that the points were spread over.
    pub sampled_volume: f64,
}

/// What a STEP file holds, read back from its own bytes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StepFacts {
    /// Every instance, in the file's order.
    pub instances: Vec<StepLeaf>,
}

/// An instance in a STEP file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StepLeaf {
    /// Name of the instance.
    pub name: String,
    /// Name of its product.
    pub product: String,
    /// Volume in mm3.
    pub volume: f64,
    /// Centre of mass in the world, in mm.
    pub centre: [f64; 3],
}

//! The jobs themselves.

use std::cell::RefCell;
use std::rc::Rc;

use assemcad_cache::{Cache, Entry};
use assemcad_model::canonical::sha256;
use assemcad_model::frame::Placement;
use assemcad_model::ports::Port;
use assemcad_model::recipe::{Call, Recipe};
use assemcad_workers::Tell;
use lru::LruCache;

use super::kept;
use crate::error::{KernelError, Result};
use crate::mesh::Mesh;
use crate::protocol::{
    Built, CommonVolume, Doing, Instance, Job, Named, Placed, Product, Reply, Source, StepFacts,
    StepLeaf,
};
use crate::replay::Part;
use crate::shape::Shape;
use crate::{contact, pair, replay, revolution, step};

/// What stands in a STEP header where it asks for persons.
const UNSTATED: &str = "not stated";

pub(super) fn doing(operation: &str, recipe: Option<String>) -> Doing {
    Doing {
        operation: operation.to_owned(),
        step: None,
        recipe,
    }
}

/// A solid, the SHA-256 of its bytes, and its ports.
#[derive(Debug)]
pub(super) struct Solid {
    pub(super) shape: Shape,
    brep: String,
    ports: Vec<Port>,
    /// The triangles that were asked for last, and how fine.
    pub(super) mesh: RefCell<Option<(Fineness, Rc<Mesh>)>>,
}

/// Deflection in mm and angle in degrees.
pub(super) type Fineness = (f64, f64);

/// A solid as a job gets it: the hash of its recipe, itself, and where it came from.
pub(super) type Found = (String, Rc<Solid>, Source);

/// What a worker keeps between jobs.
#[derive(Debug)]
pub(super) struct Bench {
    memory: LruCache<String, Rc<Solid>>,
    disk: Option<Cache>,
    /// Whether the job at hand names a solid that is neither known here nor said how to make.
    unknown: bool,
}

impl Bench {
    pub(super) fn new(disk: Option<Cache>) -> Self {
        Self {
            memory: kept::in_memory(),
            disk,
            unknown: false,
        }
    }

    pub(super) fn work(&mut self, job: &Job, tell: Tell<'_>) -> Result<(Reply, Vec<u8>)> {
        self.unknown = false;
        let done = self.do_job(job, tell);
        match self.unknown {
            true => Ok((Reply::Unknown, Vec::new())),
            false => done,
        }
    }

    fn do_job(&mut self, job: &Job, tell: Tell<'_>) -> Result<(Reply, Vec<u8>)> {
        match job {
            Job::Build { recipe } => Ok((Reply::Built(self.build(recipe, tell)?), Vec::new())),
            Job::CommonVolume { a, b, samples } => {
                let common = self.common_volume(a, b, *samples, tell)?;
                Ok((Reply::CommonVolume(common), Vec::new()))
            }
            Job::Probe { recipe, probes } => {
                let (hash, solid, _) = self.solid(recipe, tell)?;
                tell(doing("probes of ports", Some(hash)));
                let answers = solid.shape.probe(probes)?;
                Ok((Reply::Probed(answers), Vec::new()))
            }
            Job::Contact { a, b, place } => {
                let (_, solid_a, _) = self.solid(&a.recipe, tell)?;
                let (_, solid_b, _) = self.solid(&b.recipe, tell)?;
                tell(doing("contact", None));
                let (at_a, at_b) = (Placement::from(a.placement), Placement::from(b.placement));
                let touch = contact::touch(&solid_a.shape, &at_a, &solid_b.shape, &at_b, place)?;
                Ok((Reply::Contact(touch), Vec::new()))
            }
            Job::Revolution { recipe, axes } => {
                let (hash, solid, _) = self.solid(recipe, tell)?;
                tell(doing("surfaces of revolution", Some(hash)));
                let faces = solid.shape.faces()?;
                let found = axes
                    .iter()
                    .map(|(p, d)| revolution::is_about(&faces, *p, *d));
                Ok((Reply::Revolution(found.collect()), Vec::new()))
            }
            Job::Step {
                solids,
                instances,
                name,
                description,
            } => self.step(solids, instances, name, description, tell),
            Job::Tessellate {
                body,
                deflection,
                angle_deg,
            } => self.tessellate(body, *deflection, *angle_deg, tell),
            Job::Skin {
                recipe,
                deflection,
                angle_deg,
            } => {
                let (hash, solid, _) = self.solid(recipe, tell)?;
                tell(doing("skin", Some(hash)));
                let skin = solid.shape.skin(*deflection, *angle_deg)?;
                Ok((Reply::Skin, skin.to_bytes()?))
            }
            Job::Measure { of } => Ok((Reply::Measured(self.measure(of, tell)?), Vec::new())),
            Job::Distance { a, b } => Ok((Reply::Distance(self.distance(a, b, tell)?), Vec::new())),
        }
    }

    fn build(&mut self, recipe: &Named, tell: Tell<'_>) -> Result<Built> {
        let (hash, solid, source) = self.solid(recipe, tell)?;
        tell(Doing {
            operation: "measure".to_owned(),
            step: None,
            recipe: Some(hash.clone()),
        });
        let (mass, bounds) = (solid.shape.mass()?, solid.shape.bounds()?);
        Ok(Built {
            recipe: hash,
            source,
            volume: mass.volume,
            area: mass.area,
            centre: mass.center,
            inertia: mass.inertia,
            min: bounds.min,
            max: bounds.max,
            brep: solid.brep.clone(),
            ports: solid.ports.clone(),
        })
    }

    fn common_volume(
        &mut self,
        a: &Placed,
        b: &Placed,
        samples: u32,
        tell: Tell<'_>,
    ) -> Result<CommonVolume> {
        let (_, solid_a, _) = self.solid(&a.recipe, tell)?;
        let (_, solid_b, _) = self.solid(&b.recipe, tell)?;
        let (at_a, at_b) = (Placement::from(a.placement), Placement::from(b.placement));
        tell(Doing {
            operation: "common volume".to_owned(),
            step: None,
            recipe: None,
        });
        let common = pair::common(&solid_a.shape, &at_a, &solid_b.shape, &at_b)?;
        tell(Doing {
            operation: "sampling of the common volume".to_owned(),
            step: None,
            recipe: None,
        });
        let sampled = pair::sampled_common(&solid_a.shape, &at_a, &solid_b.shape, &at_b, samples)?;
        let place = common
            .place
            .map(|(bounds, centre)| (bounds.min, bounds.max, centre));
        Ok(CommonVolume {
            volume: common.volume,
            place,
            warnings: common.warnings,
            samples: sampled.tried,
            inside: sampled.inside,
            sampled_volume: sampled.box_volume,
        })
    }

    fn step(
        &mut self,
        products: &[Product],
        instances: &[Instance],
        name: &str,
        description: &[String],
        tell: Tell<'_>,
    ) -> Result<(Reply, Vec<u8>)> {
        let mut solids = Vec::new();
        for product in products {
            solids.push(self.solid(&product.recipe, tell)?.1);
        }
        tell(Doing {
            operation: "STEP export".to_owned(),
            step: None,
            recipe: None,
        });
        let parts = products
            .iter()
            .zip(&solids)
            .map(|(product, solid)| step::Part {
                name: &product.name,
                shape: &solid.shape,
                color: Some(product.color),
            })
            .collect();
        let instances = instances
            .iter()
            .map(|i| step::Instance {
                name: &i.name,
                of: step::Product::Part(i.solid),
                placement: i.placement.into(),
            })
            .collect();
        let tree = step::Tree {
            parts,
            assemblies: vec![step::Assembly { name, instances }],
        };
        let program = format!("assemcad {}", env!("CARGO_PKG_VERSION"));
        let header = step::Header {
            file_name: format!("{name}.step"),
            description: description.to_vec(),
            author: vec![UNSTATED.to_owned()],
            organization: vec![UNSTATED.to_owned()],
            preprocessor: program.clone(),
            originating_system: program,
            authorisation: UNSTATED.to_owned(),
        };
        let bytes = step::write(&tree, &header)?;
        tell(Doing {
            operation: "reading the STEP file back".to_owned(),
            step: None,
            recipe: None,
        });
        let leaf = |leaf: step::Leaf| StepLeaf {
            name: leaf.path.last().cloned().unwrap_or_default(),
            product: leaf.product,
            volume: leaf.volume,
            centre: leaf.own_center,
            inertia: leaf.inertia,
            bounds: (leaf.bounds.min, leaf.bounds.max),
            placement: leaf.placement,
        };
        let instances = step::read(&bytes)?.into_iter().map(leaf).collect();
        Ok((Reply::Step(StepFacts { instances }), bytes))
    }

    /// The solid of a recipe: from memory, from disk, or made.
    pub(super) fn solid(&mut self, named: &Named, tell: Tell<'_>) -> Result<Found> {
        if named.hash().is_empty() {
            return Err(KernelError::refused(
                "the recipe holds a number that is not finite",
            ));
        }
        let hash = named.hash().to_owned();
        if let Some(known) = self.memory.get(&hash) {
            return Ok((hash, Rc::clone(known), Source::Memory));
        }
        let entry = self.disk.as_ref().map_or(Entry::Missing, |d| d.get(&hash));
        let on_disk = match &entry {
            Entry::Sound(payload) => Solid::from_payload(payload),
            Entry::Missing | Entry::Damaged => None,
        };
        let (solid, source) = match (on_disk, named.recipe(), entry) {
            (Some(solid), ..) => (solid, Source::Disk),
            (None, None, _) => {
                self.unknown = true;
                return Err(KernelError::refused("the solid is not known here"));
            }
            (None, Some(recipe), Entry::Missing) => {
                (self.make(recipe, &hash, tell)?, Source::Replayed)
            }
            (None, Some(recipe), _) => (self.make(recipe, &hash, tell)?, Source::Repaired),
        };
        let solid = Rc::new(solid);
        self.memory.put(hash.clone(), Rc::clone(&solid));
        Ok((hash, solid, source))
    }

    fn make(&mut self, recipe: &Recipe, hash: &str, tell: Tell<'_>) -> Result<Solid> {
        let mut on_call = |step: usize, call: &Call| {
            tell(Doing {
                operation: call.call.clone(),
                step: Some(step),
                recipe: Some(hash.to_owned()),
            });
        };
        let Part { solid, ports } = replay(recipe, &mut on_call).map_err(|e| {
            // What failed is the call, which may lie before the one that was told last.
            on_call(e.step, &named(&e.call));
            e.error
        })?;
        let bytes = solid.to_bytes()?;
        let made = Solid {
            brep: sha256(&bytes),
            shape: solid,
            ports,
            mesh: RefCell::default(),
        };
        if let Some(disk) = &self.disk {
            disk.put(hash, &made.payload(&bytes)?);
        }
        Ok(made)
    }
}

fn named(call: &str) -> Call {
    Call {
        call: call.to_owned(),
        on: None,
        args: std::collections::BTreeMap::new(),
    }
}

impl Solid {
    /// What is kept on disk: the length of the ports' JSON (32 bits, little-endian), the JSON, the
    /// bytes of the solid.
    fn payload(&self, bytes: &[u8]) -> Result<Vec<u8>> {
        let ports = serde_json::to_vec(&self.ports)
            .map_err(|_| KernelError::internal("the ports could not be written"))?;
        let length = u32::try_from(ports.len())
            .map_err(|_| KernelError::refused("the part has too many ports"))?;
        Ok([&length.to_le_bytes(), ports.as_slice(), bytes].concat())
    }

    fn from_payload(payload: &[u8]) -> Option<Self> {
        let (length, rest) = payload.split_first_chunk::<4>()?;
        let length = usize::try_from(u32::from_le_bytes(*length)).ok()?;
        let (ports, bytes) = rest.split_at_checked(length)?;
        Some(Self {
            shape: Shape::from_bytes(bytes).ok()?,
            brep: sha256(bytes),
            ports: serde_json::from_slice(ports).ok()?,
            mesh: RefCell::default(),
        })
    }
}

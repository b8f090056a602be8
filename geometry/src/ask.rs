//! The questions in the words of those who ask.

use std::sync::Arc;

use assemcad_kernel::asked::{Body, Chosen, Measured};
use assemcad_kernel::contact::{Touch, Where};
use assemcad_kernel::mesh::Mesh as Triangles;
use assemcad_kernel::pair::Distance as Gap;
use assemcad_kernel::protocol::{
    Built, CommonVolume, Failure, Instance, Job, Named, Product, Reply, StepFacts,
};
use assemcad_model::probe::{Answer, Probe};

use crate::door::{Asker, nonsense};
use crate::narrow::meet::Meeting;
use crate::narrow::{Boundary, Sleeve};
use crate::pair::{Pair, PlacedSolid};
use crate::pose::{rounded_direction, rounded_point};
use crate::questions::beyond::{Beyond, Stray};
use crate::questions::built::Build;
use crate::questions::contact::Contact;
use crate::questions::distance::Distance;
use crate::questions::enters::Enters;
use crate::questions::measured::Measure;
use crate::questions::meetings::Meetings;
use crate::questions::mesh::Mesh;
use crate::questions::overlap::{Overlap, into_world};
use crate::questions::probes::Probes;
use crate::questions::revolution::{Line, Revolution};
use crate::questions::skin::Skin;

impl Asker<'_> {
    /// Makes a solid and measures it. The kernel answers only for one valid closed solid of positive volume.
    ///
    /// # Errors
    /// Why there is no such solid.
    pub async fn build(&self, solid: &Named) -> Result<Built, Failure> {
        self.ask(&Build(solid)).await
    }

    /// The skin of a solid.
    ///
    /// # Errors
    /// Why there is none.
    pub async fn skin(&self, solid: &Named) -> Result<Arc<Boundary>, Failure> {
        self.ask(&Skin(solid)).await
    }

    /// The volume that two placed solids have in common, in the world. Where the kernel has to be asked, it is held
    /// against so many points.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn common_volume(
        &self,
        a: &PlacedSolid,
        b: &PlacedSolid,
        samples: u32,
    ) -> Result<CommonVolume, Failure> {
        let (pair, exchanged) = Pair::of(a, b);
        let found = self.ask(&Overlap::new(pair, samples)).await?;
        Ok(into_world(found, if exchanged { &b.at } else { &a.at }))
    }

    /// Whether two placed solids have anything in common outside of some sleeves, all in the world.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn beyond(
        &self,
        a: &PlacedSolid,
        b: &PlacedSolid,
        sleeves: &[Sleeve],
    ) -> Result<Stray, Failure> {
        let (pair, exchanged) = Pair::of(a, b);
        let first = if exchanged { &b.at } else { &a.at };
        let back = first.inverse();
        let own = sleeves.iter().map(|s| Sleeve {
            point: rounded_point(back.point(s.point)),
            direction: rounded_direction(back.direction(s.direction)),
            radius: s.radius,
        });
        let found = self.ask(&Beyond::new(pair, own.collect())).await?;
        Ok(match found {
            Stray::At(point) => Stray::At(first.point(point)),
            known => known,
        })
    }

    /// Whether a point of one placed solid's skin is shown to lie within the other. That it is not shows nothing.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn enters(&self, a: &PlacedSolid, b: &PlacedSolid) -> Result<bool, Failure> {
        self.ask(&Enters(Pair::of(a, b).0)).await
    }

    /// The area over which two placed solids touch in a surface, stated in the world.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn contact(
        &self,
        a: &PlacedSolid,
        b: &PlacedSolid,
        place: &Where,
    ) -> Result<Touch, Failure> {
        let (pair, exchanged) = Pair::of(a, b);
        let first = if exchanged { &b.at } else { &a.at };
        let touch = self.ask(&Contact::new(pair, first, place)).await?;
        Ok(match exchanged {
            false => touch,
            true => Touch {
                faces_a: touch.faces_b,
                faces_b: touch.faces_a,
                ..touch
            },
        })
    }

    /// Where two placed solids meet face to face, in the world and seen from the first.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn meetings(
        &self,
        a: &PlacedSolid,
        b: &PlacedSolid,
    ) -> Result<Vec<Meeting>, Failure> {
        let (pair, exchanged) = Pair::of(a, b);
        let first = if exchanged { &b.at } else { &a.at };
        let found = self.ask(&Meetings(pair)).await?;
        let each = found.iter().cloned();
        Ok(each.map(|m| m.placed(first, exchanged)).collect())
    }

    /// What a solid has at some places: an answer to each probe, in order.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn probe(&self, solid: &Named, probes: &[Probe]) -> Result<Vec<Answer>, Failure> {
        self.ask(&Probes { solid, probes }).await
    }

    /// Whether a solid is one of revolution about each of some axes in its frame, in order.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn revolution(&self, solid: &Named, axes: &[Line]) -> Result<Vec<bool>, Failure> {
        self.ask(&Revolution { solid, axes }).await
    }

    /// Triangles of a body, at most `deflection` mm and `angle_deg` degrees off its surface; none where it is empty.
    ///
    /// # Errors
    /// Why there are none.
    pub async fn mesh(
        &self,
        body: &Body,
        deflection: f64,
        angle_deg: f64,
    ) -> Result<Option<Arc<Triangles>>, Failure> {
        self.ask(&Mesh {
            body,
            deflection,
            angle_deg,
        })
        .await
    }

    /// Extent and centre of a placed part or of faces of it.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn measure(&self, of: &Chosen) -> Result<Measured, Failure> {
        self.ask(&Measure(of)).await
    }

    /// The smallest distance of two placed parts, or of faces of them.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn distance(&self, a: &Chosen, b: &Chosen) -> Result<Gap, Failure> {
        self.ask(&Distance { a, b }).await
    }

    /// A STEP file of an assembly and what is in it, read back from its own bytes. Made anew each time, by a process
    /// that did nothing before: the writer numbers instances by a counter of its process.
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
            solids,
            instances,
            name: name.to_owned(),
            description,
        };
        match self.fresh(&job).await? {
            (Reply::Step(facts), bytes) => Ok((facts, bytes)),
            _ => Err(nonsense()),
        }
    }
}

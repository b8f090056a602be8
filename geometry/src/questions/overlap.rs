//! What two placed solids have in common.

use assemcad_kernel::protocol::{CommonVolume, Failure, Job, Named, Placed, Reply};
use assemcad_model::frame::Placement;

use super::skin::Skin;
use crate::door::{Asker, Key, Question, nonsense};
use crate::narrow::{Common, common};
use crate::pair::Pair;
use crate::pose;

/// The volume that two solids have in common, and an estimate of it from so many points where the kernel has to
/// be asked. What the skins show to be nothing needs neither.
#[derive(Debug)]
pub struct Overlap {
    pair: Pair,
    samples: u32,
}

impl Overlap {
    pub(crate) fn new(pair: Pair, samples: u32) -> Self {
        Self { pair, samples }
    }
}

impl Question for Overlap {
    /// In the frame of the pair's first solid.
    type Answer = CommonVolume;
    const KIND: &'static str = "overlap";

    fn key(&self, into: &mut Key) {
        self.pair.key(into);
        into.numbers([f64::from(self.samples)]);
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<CommonVolume, Failure> {
        let (first, second, at) = self.pair.parts();
        if nothing_in_common(door, first, second, at).await? {
            return Ok(CommonVolume {
                volume: 0.0,
                place: None,
                warnings: Vec::new(),
                samples: 0,
                inside: 0,
                sampled_volume: 0.0,
            });
        }
        let job = Job::CommonVolume {
            a: Box::new(Placed {
                recipe: first.clone(),
                placement: Placement::IDENTITY.into(),
            }),
            b: Box::new(Placed {
                recipe: second.clone(),
                placement: (*at).into(),
            }),
            samples: self.samples,
        };
        match door.kernel(&job).await? {
            (Reply::CommonVolume(volume), _) => Ok(volume),
            _ => Err(nonsense()),
        }
    }
}

/// Whether the skins show that there is nothing in common. A solid whose skin cannot be had shows nothing.
async fn nothing_in_common(
    door: &Asker<'_>,
    first: &Named,
    second: &Named,
    at: &Placement,
) -> Result<bool, Failure> {
    let (one, two) = (Skin(first), Skin(second));
    let (Ok(one), Ok(two)) = futures::join!(door.ask(&one), door.ask(&two)) else {
        return Ok(false);
    };
    let at = *at;
    let found = door.work(move || common(&one, &two, &at)).await?;
    Ok(found == Common::Nothing)
}

/// Puts where something is from the frame of a pair's first solid into the world.
pub(crate) fn into_world(mut found: CommonVolume, first: &Placement) -> CommonVolume {
    found.place = found.place.map(|(min, max, centre)| {
        let (min, max) = pose::moved_box((min, max), first);
        (min, max, first.point(centre))
    });
    found
}

//! What two placed solids have in common.

use assemcad_kernel::protocol::{CommonVolume, Failure, Job, Reply};
use assemcad_model::frame::Placement;

use crate::door::{Asker, Key, Question, nonsense};
use crate::kept::kept_as_json;
use crate::narrow::{Common, common, enter};
use crate::pair::Pair;
use crate::pose;

/// What is said of a boolean that finds nothing against points that lie within both.
pub const ENTERS: &str = "points of one solid's skin lie within the other, where it finds nothing";

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

    kept_as_json!();

    fn key(&self, into: &mut Key) {
        self.pair.key(into);
        into.numbers([f64::from(self.samples)]);
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<CommonVolume, Failure> {
        let shown = shown(door, &self.pair).await?;
        if shown == Shown::Apart {
            return Ok(CommonVolume {
                volume: 0.0,
                place: None,
                warnings: Vec::new(),
                samples: 0,
                inside: 0,
                sampled_volume: 0.0,
            });
        }
        let [a, b] = self.pair.placed();
        let job = Job::CommonVolume {
            a,
            b,
            samples: self.samples,
        };
        match door.kernel(&job).await? {
            (Reply::CommonVolume(mut found), _) => {
                // A boolean may be wrong and say nothing.
                if shown == Shown::Within && found.volume <= 0.0 {
                    found.warnings.push(ENTERS.to_owned());
                }
                Ok(found)
            }
            _ => Err(nonsense()),
        }
    }
}

/// What two skins show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shown {
    /// That there is nothing in common.
    Apart,
    /// That there is something, however small.
    Within,
    /// Neither.
    Nothing,
}

/// What the skins show. A solid whose skin cannot be had shows nothing.
async fn shown(door: &Asker<'_>, pair: &Pair) -> Result<Shown, Failure> {
    let Ok((one, two)) = pair.skins(door).await else {
        return Ok(Shown::Nothing);
    };
    let at = pair.at();
    door.work(move || match common(&one, &two, &at) {
        Common::Nothing => Shown::Apart,
        Common::Open if enter(&one, &two, &at) => Shown::Within,
        Common::Open => Shown::Nothing,
    })
    .await
}

/// Puts where something is from the frame of a pair's first solid into the world.
pub(crate) fn into_world(mut found: CommonVolume, first: &Placement) -> CommonVolume {
    found.place = found.place.map(|(min, max, centre)| {
        let (min, max) = pose::moved_box((min, max), first);
        (min, max, first.point(centre))
    });
    found
}

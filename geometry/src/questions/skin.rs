//! A solid's skin, made ready to be held against others.

use std::sync::Arc;

use assemcad_kernel::protocol::{Failure, Job, Named, Reply};
use assemcad_kernel::skin::Skin as KernelSkin;

use super::built::Build;
use crate::door::{Asker, Key, Question, nonsense};
use crate::narrow::Boundary;

/// How far triangles may be off a surface: this share of the solid's diagonal, between these limits in mm.
const SHARE: f64 = 1e-4;
const LIMITS_MM: (f64, f64) = (0.002, 0.02);

/// How far they may be turned from it, in degrees. The proof in [`crate::narrow`] rests on it.
const TURNED_DEG: f64 = 10.0;

/// The skin of a solid.
#[derive(Debug)]
pub struct Skin<'a>(pub &'a Named);

impl Question for Skin<'_> {
    type Answer = Arc<Boundary>;
    const KIND: &'static str = "skin";

    fn key(&self, into: &mut Key) {
        into.text(self.0.hash());
    }

    fn bytes(skin: &Arc<Boundary>) -> usize {
        skin.bytes()
    }

    fn is_kept(&self) -> bool {
        true
    }

    fn to_bytes(skin: &Arc<Boundary>) -> Option<Vec<u8>> {
        skin.skin().to_bytes().ok()
    }

    fn from_bytes(bytes: &[u8]) -> Option<Arc<Boundary>> {
        made_ready(bytes)
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<Arc<Boundary>, Failure> {
        let built = door.ask(&Build(self.0)).await?;
        let size = built
            .min
            .iter()
            .zip(built.max)
            .map(|(a, b)| (b - a) * (b - a));
        let (least, most) = LIMITS_MM;
        let job = Job::Skin {
            recipe: self.0.clone(),
            deflection: (SHARE * libm::sqrt(size.sum())).clamp(least, most),
            angle_deg: TURNED_DEG,
        };
        let (Reply::Skin, bytes) = door.kernel(&job).await? else {
            return Err(nonsense());
        };
        let skin = door.work(move || made_ready(&bytes)).await?;
        skin.ok_or_else(nonsense)
    }
}

fn made_ready(bytes: &[u8]) -> Option<Arc<Boundary>> {
    KernelSkin::from_bytes(bytes)
        .and_then(Boundary::new)
        .map(Arc::new)
}

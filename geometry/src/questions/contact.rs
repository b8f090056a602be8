//! Over how much area two placed solids touch in a stated surface.

use assemcad_kernel::contact::{Touch, Where};
use assemcad_kernel::protocol::{Failure, Job, Reply};
use assemcad_model::frame::Placement;

use crate::door::{Asker, Key, Question, nonsense};
use crate::kept::kept_as_json;
use crate::narrow::touch;
use crate::pair::Pair;
use crate::pose::{rounded_direction, rounded_point};

/// The area over which two solids touch in a surface, stated in the frame of the first.
#[derive(Debug)]
pub struct Contact {
    pair: Pair,
    place: Where,
}

impl Contact {
    /// The surface is stated in the world, where the first solid of the pair stands at `first`.
    pub(crate) fn new(pair: Pair, first: &Placement, place: &Where) -> Self {
        let back = first.inverse();
        let point = |p: &[f64; 3]| rounded_point(back.point(*p));
        let direction = |d: &[f64; 3]| rounded_direction(back.direction(*d));
        let place = match place {
            Where::Plane { point: p, normal } => Where::Plane {
                point: point(p),
                normal: direction(normal),
            },
            Where::Axis {
                point: p,
                direction: d,
            } => Where::Axis {
                point: point(p),
                direction: direction(d),
            },
        };
        Self { pair, place }
    }
}

impl Question for Contact {
    type Answer = Touch;
    const KIND: &'static str = "contact";

    kept_as_json!();

    fn key(&self, into: &mut Key) {
        self.pair.key(into);
        let (kind, point, direction) = match self.place {
            Where::Plane { point, normal } => ("plane", point, normal),
            Where::Axis { point, direction } => ("axis", point, direction),
        };
        into.text(kind);
        into.numbers(point.into_iter().chain(direction));
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<Touch, Failure> {
        if let Ok((one, two)) = self.pair.skins(door).await {
            let (at, place) = (self.pair.at(), self.place);
            if let Some(found) = door.work(move || touch(&one, &two, &at, &place)).await? {
                return Ok(found);
            }
        }
        let [a, b] = self.pair.placed();
        let place = self.place;
        let job = Job::Contact { a, b, place };
        match door.kernel(&job).await? {
            (Reply::Contact(touch), _) => Ok(touch),
            _ => Err(nonsense()),
        }
    }
}

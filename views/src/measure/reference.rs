//! What is measured: a part, a port of one, or faces of one.

use assemcad_kernel::asked::Chosen;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::frame::Frame;
use assemcad_model::param::clip;
use assemcad_model::selector::Selector;
use assemcad_model::spec::End;
use assemcad_placing::Partial;
use assemcad_placing::partial::nowhere;
use assemcad_placing::resolved::{part_unknown, port};

/// Something that was named, found.
#[derive(Debug)]
pub(super) struct Reference {
    /// As it was named.
    pub(super) text: String,
    pub(super) target: Target,
}

/// What was found.
#[derive(Debug)]
pub(super) enum Target {
    /// A port's frame in the assembly.
    Port(Frame),
    /// A part or faces of one.
    Solid(Box<Chosen>),
}

impl Reference {
    /// Finds `part`, `part:port` or `part@selector`; `place` names the argument.
    ///
    /// # Errors
    /// When there is no such thing, or it has no place.
    pub(super) fn find(part: &Partial, text: &str, place: &str) -> Result<Self, Diagnostic> {
        // Neither sign can be in a part's name; both can be in a selector.
        let end = text.find([':', '@']).unwrap_or(text.len());
        let (name, rest) = text.split_at(end);
        let parts = &part.resolved.parts;
        let Some(i) = parts.iter().position(|p| p.id == name) else {
            return Err(part_unknown(parts, name, place));
        };
        let Some(at) = part.placements.of(i) else {
            return Err(nowhere(name, place));
        };
        let mut rest = rest.chars();
        let target = match rest.next() {
            Some(':') => {
                let end = End {
                    part: name.to_owned(),
                    port: rest.as_str().to_owned(),
                };
                let (_, port) = port(parts, &end, place)?;
                Target::Port(at.frame(&port.frame))
            }
            sign => {
                let faces = match sign {
                    Some(_) => Some(selector(rest.as_str(), place)?),
                    None => None,
                };
                let part = parts.get(i).map(|p| p.solid_at(&at));
                let part = part.ok_or_else(|| part_unknown(parts, name, place))?;
                Target::Solid(Box::new(Chosen {
                    part: part.into(),
                    faces,
                }))
            }
        };
        Ok(Self {
            text: clip(text),
            target,
        })
    }
}

fn selector(text: &str, place: &str) -> Result<Selector, Diagnostic> {
    Selector::parse(text).map_err(|why| {
        Diagnostic::error(Code::ArgumentInvalid, place, why)
            .found(text)
            .hint(
                "faces are named as in factories, in the part's own frame: >Z, <X, |Y, %CYLINDER, \
                 '>Z and %PLANE'",
            )
    })
}

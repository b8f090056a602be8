//! Profiles as C++ takes them: lines, arcs by centre and sweep, circles, all oriented.

use core::f64::consts::{PI, TAU};

use assemcad_model::frame::Frame;
use assemcad_model::recipe::{Outline, Profile, Segment};

use crate::error::{KernelError, Result};
use crate::ffi::bridge::{At, Piece};
use crate::limits::{SMALLEST, coordinates, direction, length};
use crate::shape::frame;

const LINE: u8 = 0;
const ARC: u8 = 1;
const CIRCLE: u8 = 2;

type Point = [f64; 2];

fn minus([ax, ay]: Point, [bx, by]: Point) -> Point {
    [ax - bx, ay - by]
}

fn cross([ax, ay]: Point, [bx, by]: Point) -> f64 {
    ax * by - ay * bx
}

fn norm([x, y]: Point) -> f64 {
    libm::hypot(x, y)
}

/// The pieces of all outlines: the outer one counter-clockwise, the holes clockwise.
///
/// Whether outlines cross themselves or each other is left to the kernel's own check.
pub(crate) fn pieces(profile: &Profile) -> Result<Vec<Piece>> {
    let mut all = Vec::new();
    for (index, outline) in core::iter::once(&profile.outer)
        .chain(&profile.holes)
        .enumerate()
    {
        let what = if index == 0 {
            "outer outline".to_owned()
        } else {
            format!("outline of hole {index}")
        };
        let number = u32::try_from(index)
            .map_err(|_| KernelError::refused("the profile has too many holes"))?;
        let mut own = outline_pieces(outline, number, &what)?;
        let area = signed_area(&own);
        // An outline thinner than the kernel's own resolution bounds nothing.
        if area.abs() < SMALLEST * SMALLEST {
            return Err(KernelError::refused(format!("the {what} encloses no area")));
        }
        if (area > 0.0) != (index == 0) {
            reverse(&mut own);
        }
        all.append(&mut own);
    }
    Ok(all)
}

fn outline_pieces(outline: &Outline, number: u32, what: &str) -> Result<Vec<Piece>> {
    match outline {
        Outline::Circle { center, radius } => {
            coordinates(what, center)?;
            length(&format!("radius of the {what}"), *radius)?;
            Ok(vec![Piece {
                outline: number,
                kind: CIRCLE,
                start: *center,
                center: *center,
                radius: *radius,
                sweep: TAU,
            }])
        }
        Outline::Path { start, segments } => {
            coordinates(what, start)?;
            let mut own = Vec::new();
            let mut at = *start;
            for segment in segments {
                let (piece, to) = match segment {
                    Segment::Line { to } => {
                        coordinates(what, to)?;
                        (line(number, at, *to, what)?, *to)
                    }
                    Segment::Arc { via, to } => {
                        coordinates(what, via)?;
                        coordinates(what, to)?;
                        (arc(number, at, *via, *to, what)?, *to)
                    }
                };
                own.push(piece);
                at = to;
            }
            if at != *start {
                own.push(line(number, at, *start, what)?);
            }
            if own.len() < 2 {
                return Err(KernelError::refused(format!("the {what} encloses no area")));
            }
            Ok(own)
        }
    }
}

fn line(outline: u32, start: Point, end: Point, what: &str) -> Result<Piece> {
    if norm(minus(end, start)) < SMALLEST {
        return Err(KernelError::refused(format!(
            "a line of the {what} at ({}, {}) has no length",
            start[0], start[1]
        )));
    }
    Ok(Piece {
        outline,
        kind: LINE,
        start,
        center: start,
        radius: 0.0,
        sweep: 0.0,
    })
}

/// The arc from `start` through `via` to `end`, by the circumcentre of the three.
fn arc(outline: u32, start: Point, via: Point, end: Point, what: &str) -> Result<Piece> {
    let (b, c) = (minus(via, start), minus(end, start));
    let shortest = norm(b).min(norm(c)).min(norm(minus(end, via)));
    let at = format!("the arc of the {what} from ({}, {})", start[0], start[1]);
    if shortest < SMALLEST {
        return Err(KernelError::refused(format!(
            "{at} needs three points that differ"
        )));
    }
    let twice_area = cross(b, c);
    // The height of the triangle over its longest side.
    if twice_area.abs() < SMALLEST * norm(c).max(norm(b)) {
        return Err(KernelError::refused(format!(
            "{at} goes through three points of one line"
        )));
    }
    let (bb, cc) = (b[0] * b[0] + b[1] * b[1], c[0] * c[0] + c[1] * c[1]);
    let offset = [
        (c[1] * bb - b[1] * cc) / (2.0 * twice_area),
        (b[0] * cc - c[0] * bb) / (2.0 * twice_area),
    ];
    let center = [start[0] + offset[0], start[1] + offset[1]];
    let radius = norm(offset);
    coordinates(what, &center)?;
    length(&format!("radius of {at}"), radius)?;
    let angle = |p: Point| libm::atan2(p[1] - center[1], p[0] - center[0]);
    let mut sweep = angle(end) - angle(start);
    if twice_area > 0.0 {
        while sweep <= 0.0 {
            sweep += TAU;
        }
    } else {
        while sweep >= 0.0 {
            sweep -= TAU;
        }
    }
    Ok(Piece {
        outline,
        kind: ARC,
        start,
        center,
        radius,
        sweep,
    })
}

fn end_of(pieces: &[Piece], index: usize) -> Point {
    let next = if index + 1 < pieces.len() {
        index + 1
    } else {
        0
    };
    pieces.get(next).map_or([0.0; 2], |p| p.start)
}

/// The area to the left of the outline.
fn signed_area(pieces: &[Piece]) -> f64 {
    // About the first point, so that an outline far from the origin loses no digits.
    let Some(base) = pieces.first().map(|p| p.start) else {
        return 0.0;
    };
    let mut twice = 0.0;
    for (i, piece) in pieces.iter().enumerate() {
        let rr = piece.radius * piece.radius;
        if piece.kind == CIRCLE {
            twice += 2.0 * PI * rr * piece.sweep.signum();
            continue;
        }
        twice += cross(minus(piece.start, base), minus(end_of(pieces, i), base));
        if piece.kind == ARC {
            twice += rr * (piece.sweep - libm::sin(piece.sweep));
        }
    }
    twice / 2.0
}

fn reverse(pieces: &mut [Piece]) {
    let ends: Vec<Point> = (0..pieces.len()).map(|i| end_of(pieces, i)).collect();
    for (piece, end) in pieces.iter_mut().zip(ends) {
        if piece.kind != CIRCLE {
            piece.start = end;
        }
        piece.sweep = -piece.sweep;
    }
    pieces.reverse();
}

/// That the whole profile lies on one side of an axis in its plane; touching is allowed.
pub(crate) fn beside_axis(pieces: &[Piece], point: Point, along: Point) -> Result<()> {
    coordinates("axis of the revolution", &point)?;
    direction("direction of the revolution's axis", &along)?;
    let size = norm(along);
    let side = |p: Point| cross(along, minus(p, point)) / size;
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut see = |s: f64| {
        low = low.min(s);
        high = high.max(s);
    };
    for (i, piece) in pieces.iter().enumerate() {
        if piece.kind == LINE {
            see(side(piece.start));
            continue;
        }
        let center = side(piece.center);
        // The points of the circle farthest to both sides of the axis.
        for sign in [1.0, -1.0] {
            let away = [-along[1] / size * sign, along[0] / size * sign];
            if piece.kind == CIRCLE || on_arc(piece, away) {
                see(center + sign * piece.radius);
            }
        }
        if piece.kind == ARC {
            see(side(piece.start));
            see(side(end_of(pieces, i)));
        }
    }
    if low < -SMALLEST && high > SMALLEST {
        return Err(KernelError::refused(format!(
            "the profile crosses the axis of the revolution: it reaches {} mm to one side and {} mm \
             to the other",
            -low, high
        )));
    }
    Ok(())
}

/// Whether the direction from the centre hits the arc.
fn on_arc(piece: &Piece, away: Point) -> bool {
    let from = minus(piece.start, piece.center);
    let mut turned = libm::atan2(away[1], away[0]) - libm::atan2(from[1], from[0]);
    if piece.sweep > 0.0 {
        while turned < 0.0 {
            turned += TAU;
        }
        turned <= piece.sweep
    } else {
        while turned > 0.0 {
            turned -= TAU;
        }
        turned >= piece.sweep
    }
}

/// The axis in space: its z is the direction.
pub(crate) fn axis(at: &Frame, point: Point, along: Point) -> Result<At> {
    let placement = at
        .placement()
        .map_err(|e| KernelError::refused(e.to_string()))?;
    let size = norm(along);
    let z = placement.direction([along[0] / size, along[1] / size, 0.0]);
    let x = placement.direction([0.0, 0.0, 1.0]);
    frame(&Frame {
        origin: placement.point([point[0], point[1], 0.0]),
        x,
        z,
    })
}

//! A tree of boxes: which of many things may be where.
//!
//! Boxes are halved at the median of their middles, along the longest side (Kay and Kajiya, *Ray tracing complex
//! scenes*, SIGGRAPH 1986).

/// A box along the axes: its smallest and its largest corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Box3 {
    pub(super) low: [f64; 3],
    pub(super) high: [f64; 3],
}

impl Box3 {
    /// The box of nothing.
    pub(super) const NONE: Self = Self {
        low: [f64::INFINITY; 3],
        high: [f64::NEG_INFINITY; 3],
    };

    pub(super) fn with(self, [x, y, z]: [f64; 3]) -> Self {
        let ([a, b, c], [d, e, f]) = (self.low, self.high);
        Self {
            low: [a.min(x), b.min(y), c.min(z)],
            high: [d.max(x), e.max(y), f.max(z)],
        }
    }

    fn and(self, other: &Self) -> Self {
        self.with(other.low).with(other.high)
    }

    fn middle(&self) -> [f64; 3] {
        let ([a, b, c], [d, e, f]) = (self.low, self.high);
        [(a + d) / 2.0, (b + e) / 2.0, (c + f) / 2.0]
    }

    /// Between which values a direction's coordinate lies in the box, moved by so much.
    pub(super) fn span(&self, direction: &[f64; 3], by: f64) -> (f64, f64) {
        let (mut low, mut high) = (by, by);
        for ((a, b), d) in self.low.iter().zip(&self.high).zip(direction) {
            let (p, q) = (a * d, b * d);
            low += p.min(q);
            high += p.max(q);
        }
        (low, high)
    }

    /// How far the box reaches along a direction, from a point.
    pub(super) fn ahead(&self, from: &[f64; 3], direction: &[f64; 3]) -> f64 {
        let start: f64 = from.iter().zip(direction).map(|(a, d)| a * d).sum();
        self.span(direction, -start).1
    }

    /// Whether two boxes meet.
    pub(super) fn meets(&self, other: &Self) -> bool {
        let below = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).all(|(a, b)| a <= b);
        below(&self.low, &other.high) && below(&other.low, &self.high)
    }

    /// Whether a ray comes through the box, widened by so much.
    pub(super) fn meets_ray(&self, from: &[f64; 3], way: &[f64; 3], wider: f64) -> bool {
        let (mut near, mut far) = (-wider, f64::INFINITY);
        for (((low, high), o), d) in self.low.iter().zip(&self.high).zip(from).zip(way) {
            let (low, high) = (low - wider - o, high + wider - o);
            if d.abs() < 1e-12 {
                // Along the sides it stays where it is, up to less than it is widened by.
                if low > 0.0 || high < 0.0 {
                    return false;
                }
                continue;
            }
            let (a, b) = (low / d, high / d);
            near = near.max(a.min(b));
            far = far.min(a.max(b));
        }
        near <= far
    }
}

/// Boxes in a tree, by their indices.
#[derive(Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    order: Vec<usize>,
}

#[derive(Debug)]
struct Node {
    bounds: Box3,
    /// The other half; the one half is the next node. None for a leaf.
    other: Option<usize>,
    /// What is in it, as a range of the order.
    from: usize,
    to: usize,
}

/// How many boxes are in a leaf.
const LEAF: usize = 4;

impl Tree {
    pub(super) fn new(boxes: &[Box3]) -> Self {
        let mut out = Self {
            nodes: Vec::new(),
            order: (0..boxes.len()).collect(),
        };
        out.split(boxes, 0, boxes.len());
        out
    }

    fn split(&mut self, boxes: &[Box3], from: usize, to: usize) {
        let Some(part) = self.order.get_mut(from..to).filter(|p| !p.is_empty()) else {
            return;
        };
        let of = |i: &usize| boxes.get(*i).copied().unwrap_or(Box3::NONE);
        let bounds = part.iter().fold(Box3::NONE, |b, i| b.and(&of(i)));
        let here = self.nodes.len();
        self.nodes.push(Node {
            bounds,
            other: None,
            from,
            to,
        });
        if part.len() <= LEAF {
            return;
        }
        let side = |k: usize| {
            let at = |c: &[f64; 3]| c.get(k).copied().unwrap_or_default();
            at(&bounds.high) - at(&bounds.low)
        };
        let longest = (0..3).fold(0, |a, b| if side(b) > side(a) { b } else { a });
        let at = |i: &usize| of(i).middle().get(longest).copied().unwrap_or_default();
        let half = part.len() / 2;
        part.select_nth_unstable_by(half, |a, b| at(a).total_cmp(&at(b)).then(a.cmp(b)));
        self.split(boxes, from, from + half);
        let other = self.nodes.len();
        self.split(boxes, from + half, to);
        if let Some(node) = self.nodes.get_mut(here) {
            node.other = Some(other);
        }
    }

    /// Calls for everything whose node's box is wanted.
    pub(super) fn visit(&self, wanted: impl Fn(&Box3) -> bool, mut found: impl FnMut(usize)) {
        self.visit_from(0, &wanted, &mut found);
    }

    /// No deeper than the tree, which is as deep as the number of its leaves has digits.
    fn visit_from(
        &self,
        at: usize,
        wanted: &impl Fn(&Box3) -> bool,
        found: &mut impl FnMut(usize),
    ) {
        let Some(node) = self.nodes.get(at).filter(|n| wanted(&n.bounds)) else {
            return;
        };
        match node.other {
            Some(other) => {
                self.visit_from(at + 1, wanted, found);
                self.visit_from(other, wanted, found);
            }
            None => {
                let all = self.order.get(node.from..node.to).into_iter().flatten();
                all.for_each(|i| found(*i));
            }
        }
    }

    /// The greatest value of anything, where no value is above the bound of a box that it is in.
    pub(super) fn greatest(
        &self,
        bound: impl Fn(&Box3) -> f64,
        value: impl Fn(usize) -> f64,
    ) -> f64 {
        let of = |at: usize| self.nodes.get(at).map(|n| (bound(&n.bounds), at));
        let mut most = f64::NEG_INFINITY;
        let mut open: Vec<(f64, usize)> = of(0).into_iter().collect();
        while let Some((bound, at)) = open.pop() {
            let Some(node) = self.nodes.get(at).filter(|_| bound > most) else {
                continue;
            };
            match node.other {
                Some(other) => {
                    let mut two: Vec<(f64, usize)> =
                        [of(at + 1), of(other)].into_iter().flatten().collect();
                    // The better half is next.
                    two.sort_by(|a, b| a.0.total_cmp(&b.0));
                    open.extend(two);
                }
                None => {
                    let all = self.order.get(node.from..node.to).into_iter().flatten();
                    most = all.fold(most, |most, i| most.max(value(*i)));
                }
            }
        }
        most
    }
}

#[cfg(test)]
mod tests {
    use super::{Box3, Tree};
    use proptest::prelude::*;

    fn boxes() -> impl Strategy<Value = Vec<Box3>> {
        let one = (
            prop::array::uniform3(-9.0..9.0f64),
            prop::array::uniform3(0.0..2.0f64),
        );
        let of = |([x, y, z], [a, b, c]): ([f64; 3], [f64; 3])| {
            Box3::NONE.with([x, y, z]).with([x + a, y + b, z + c])
        };
        prop::collection::vec(one.prop_map(of), 0..60)
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn a_tree_finds_what_a_list_has(all in boxes(), p in prop::array::uniform3(-9.0..9.0f64)) {
            let tree = Tree::new(&all);
            let about = Box3::NONE.with(p).with(p.map(|x| x + 1.0));
            let mut found = Vec::new();
            tree.visit(|b| b.meets(&about), |i| if all[i].meets(&about) { found.push(i) });
            found.sort_unstable();
            let wanted: Vec<usize> = (0..all.len()).filter(|i| all[*i].meets(&about)).collect();
            prop_assert_eq!(found, wanted);
            // The farthest along a direction.
            let ahead = |b: &Box3| b.ahead(&p, &[0.6, 0.0, 0.8]);
            let most = tree.greatest(ahead, |i| ahead(&all[i]));
            let wanted = all.iter().map(ahead).fold(f64::NEG_INFINITY, f64::max);
            prop_assert_eq!(most, wanted);
        }
    }
}

//! Selectors: which of the sub-shapes of a solid are meant.
//!
//! The text form is that of CadQuery's `StringSyntaxSelector`. One deviation, on purpose: where it
//! joins results in the order of a hash table, ours keep the order in which the kernel lists them.

use serde::{Deserialize, Serialize};

/// A choice among faces, edges, vertices and so on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Selector {
    /// Plane faces by their normal and straight edges by their direction, either way: `|Z`.
    Parallel(Direction),
    /// The same with the sense of the direction: `+Z`, `-Z`.
    Along(Direction),
    /// Plane faces whose normal, and straight edges whose direction, is square to it: `#Z`.
    Perpendicular(Direction),
    /// By the name of the surface or curve, upper case: `%PLANE`.
    Form(String),
    /// The `index`-th place along a direction, counted from its low end; negative from its high end.
    Nth {
        /// What is compared.
        key: Key,
        /// Which of the ordered groups: 0 the first, -1 the last.
        index: i32,
        /// Whether the order begins at the low end.
        ascending: bool,
    },
    /// The one whose centre is nearest to a point.
    Nearest([f64; 3]),
    /// Those inside a box given by two opposite corners.
    Box {
        /// One corner.
        from: [f64; 3],
        /// The opposite one.
        to: [f64; 3],
        /// Whether the whole bounding box must be inside, and not only the centre.
        whole: bool,
    },
    /// What both choose.
    And(Box<Selector>, Box<Selector>),
    /// What either chooses.
    Or(Box<Selector>, Box<Selector>),
    /// What the first chooses and the second does not.
    Except(Box<Selector>, Box<Selector>),
    /// What the selector does not choose.
    Not(Box<Selector>),
}

/// A direction of any length.
pub type Direction = [f64; 3];

/// What sub-shapes are ordered by; those that have none are left out.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Key {
    /// The centre's place along a direction: `>>Z[1]`, and `>Z` without an index.
    Center(Direction),
    /// The same among plane faces and straight edges parallel to the direction only: `>Z[1]`.
    ParallelCenter(Direction),
    /// Radius of an edge or wire.
    Radius,
    /// Length of an edge or wire.
    Length,
    /// Area of a face, shell, solid or closed plane wire.
    Area,
}

/// The names of surfaces and curves that `%` takes.
pub const FORMS: [&str; 15] = [
    "BEZIER",
    "BSPLINE",
    "CIRCLE",
    "CONE",
    "CYLINDER",
    "ELLIPSE",
    "EXTRUSION",
    "HYPERBOLA",
    "LINE",
    "OFFSET",
    "PARABOLA",
    "PLANE",
    "REVOLUTION",
    "SPHERE",
    "TORUS",
];

/// Deepest nesting of a selector: readers walk it by recursion.
const DEEPEST: usize = 32;

impl Selector {
    /// Reads the text form, such as `|Z and >X`.
    ///
    /// # Errors
    /// What was expected where, in one sentence.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut reader = Reader { text, at: 0 };
        let selector = reader.except(0)?;
        reader.space();
        if reader.rest().is_empty() {
            Ok(selector)
        } else {
            Err(reader.wrong("nothing more, or 'and', 'or', 'exc'"))
        }
    }
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl Reader<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn space(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
    }

    fn wrong(&self, expected: &str) -> String {
        let shown = crate::param::clip(self.text);
        let place = self
            .text
            .get(..self.at)
            .map_or(0, |before| before.chars().count());
        format!("the selector '{shown}' has no meaning at place {place}: {expected} is expected")
    }

    /// Takes a sign or bracket.
    fn takes(&mut self, sign: &str) -> bool {
        self.space();
        let found = self.rest().starts_with(sign);
        if found {
            self.at += sign.len();
        }
        found
    }

    /// Takes a whole word.
    fn word(&mut self, word: &str) -> bool {
        self.space();
        let Some(after) = self.rest().strip_prefix(word) else {
            return false;
        };
        let whole = !after
            .chars()
            .next()
            .is_some_and(|c| c.is_alphanumeric() || c == '_');
        if whole {
            self.at += word.len();
        }
        whole
    }

    fn except(&mut self, depth: usize) -> Result<Selector, String> {
        if depth > DEEPEST {
            return Err(self.wrong("no deeper nesting"));
        }
        let mut left = self.or(depth)?;
        while self.word("except") || self.word("exc") {
            left = Selector::Except(Box::new(left), Box::new(self.or(depth)?));
        }
        Ok(left)
    }

    fn or(&mut self, depth: usize) -> Result<Selector, String> {
        let mut left = self.and(depth)?;
        while self.word("or") {
            left = Selector::Or(Box::new(left), Box::new(self.and(depth)?));
        }
        Ok(left)
    }

    fn and(&mut self, depth: usize) -> Result<Selector, String> {
        let mut left = self.not(depth)?;
        while self.word("and") {
            left = Selector::And(Box::new(left), Box::new(self.not(depth)?));
        }
        Ok(left)
    }

    /// `not` takes all that follows it, as in CadQuery, where it binds least of all:
    /// `not |Z and >X` leaves out what is both.
    fn not(&mut self, depth: usize) -> Result<Selector, String> {
        if self.word("not") {
            return Ok(Selector::Not(Box::new(self.except(depth + 1)?)));
        }
        // `(1, 0, 0)` is a direction, any other bracket holds a selector.
        let start = self.at;
        if self.takes("(") {
            let is_number = |c: char| c.is_ascii_digit() || c == '-' || c == '+' || c == '.';
            self.space();
            let mut after = self.rest().chars();
            let number = after.next().is_some_and(is_number)
                && after
                    .find(|c| !c.is_whitespace() && !is_number(*c))
                    .is_some_and(|c| c == ',');
            if !number {
                let inner = self.except(depth + 1)?;
                return if self.takes(")") {
                    Ok(inner)
                } else {
                    Err(self.wrong("')'"))
                };
            }
            self.at = start;
        }
        self.simple()
    }

    fn simple(&mut self) -> Result<Selector, String> {
        for (sign, ascending) in [(">>", true), ("<<", false)] {
            if self.takes(sign) {
                let along = self.direction()?;
                let index = self.index()?.unwrap_or(-1);
                let key = Key::Center(along);
                return Ok(Selector::Nth {
                    key,
                    index,
                    ascending,
                });
            }
        }
        for (sign, ascending) in [(">", true), ("<", false)] {
            if self.takes(sign) {
                let along = self.direction()?;
                let (key, index) = match self.index()? {
                    Some(index) => (Key::ParallelCenter(along), index),
                    None => (Key::Center(along), -1),
                };
                return Ok(Selector::Nth {
                    key,
                    index,
                    ascending,
                });
            }
        }
        if self.takes("|") {
            return Ok(Selector::Parallel(self.direction()?));
        }
        if self.takes("#") {
            return Ok(Selector::Perpendicular(self.direction()?));
        }
        if self.takes("+") {
            return Ok(Selector::Along(self.direction()?));
        }
        if self.takes("-") {
            return Ok(Selector::Along(self.direction()?.map(|n| 0.0 - n)));
        }
        if self.takes("%") {
            return self.form();
        }
        for (view, along, ascending) in [
            ("front", [0.0, 0.0, 1.0], true),
            ("back", [0.0, 0.0, 1.0], false),
            ("left", [1.0, 0.0, 0.0], false),
            ("right", [1.0, 0.0, 0.0], true),
            ("top", [0.0, 1.0, 0.0], true),
            ("bottom", [0.0, 1.0, 0.0], false),
        ] {
            if self.word(view) {
                let key = Key::Center(along);
                return Ok(Selector::Nth {
                    key,
                    index: -1,
                    ascending,
                });
            }
        }
        self.direction().map(Selector::Along).map_err(|_| {
            self.wrong("one of > < >> << | # + - % before a direction, or front, back, left, right, top, bottom")
        })
    }

    fn form(&mut self) -> Result<Selector, String> {
        self.space();
        let word: String = self
            .rest()
            .chars()
            .take_while(char::is_ascii_alphabetic)
            .collect();
        let upper = word.to_ascii_uppercase();
        if FORMS.contains(&upper.as_str()) || upper == "OTHER" {
            self.at += word.len();
            Ok(Selector::Form(upper))
        } else {
            Err(self.wrong(&format!("one of {} or OTHER", FORMS.join(", "))))
        }
    }

    fn direction(&mut self) -> Result<Direction, String> {
        for (word, direction) in [
            ("XY", [1.0, 1.0, 0.0]),
            ("XZ", [1.0, 0.0, 1.0]),
            ("YZ", [0.0, 1.0, 1.0]),
            ("X", [1.0, 0.0, 0.0]),
            ("Y", [0.0, 1.0, 0.0]),
            ("Z", [0.0, 0.0, 1.0]),
        ] {
            if self.word(word) {
                return Ok(direction);
            }
        }
        if !self.takes("(") {
            return Err(self.wrong("a direction: X, Y, Z, XY, XZ, YZ or (x, y, z)"));
        }
        let x = self.number(",")?;
        let y = self.number(",")?;
        let z = self.number(")")?;
        if [x, y, z] == [0.0; 3] {
            return Err(self.wrong("a direction that is not (0, 0, 0)"));
        }
        Ok([x, y, z])
    }

    /// A number and the sign after it.
    fn number(&mut self, after: &str) -> Result<f64, String> {
        self.space();
        let digits: String = self
            .rest()
            .chars()
            .take_while(|c| c.is_ascii_digit() || matches!(c, '+' | '-' | '.'))
            .collect();
        let number = digits.parse::<f64>().ok().filter(|n| n.is_finite());
        let Some(number) = number else {
            return Err(self.wrong("a number"));
        };
        self.at += digits.len();
        if self.takes(after) {
            Ok(number)
        } else {
            Err(self.wrong(&format!("'{after}'")))
        }
    }

    fn index(&mut self) -> Result<Option<i32>, String> {
        if !self.takes("[") {
            return Ok(None);
        }
        self.space();
        let digits: String = self
            .rest()
            .chars()
            .take_while(|c| c.is_ascii_digit() || *c == '-')
            .collect();
        let Ok(index) = digits.parse::<i32>() else {
            return Err(self.wrong("a whole number"));
        };
        self.at += digits.len();
        if self.takes("]") {
            Ok(Some(index))
        } else {
            Err(self.wrong("']'"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Key, Selector};

    fn nth(key: Key, index: i32, ascending: bool) -> Selector {
        Selector::Nth {
            key,
            index,
            ascending,
        }
    }

    const Z: [f64; 3] = [0.0, 0.0, 1.0];
    const X: [f64; 3] = [1.0, 0.0, 0.0];

    #[test]
    fn simple_forms() {
        for (text, expected) in [
            (">Z", nth(Key::Center(Z), -1, true)),
            ("<Z", nth(Key::Center(Z), -1, false)),
            (">Z[-2]", nth(Key::ParallelCenter(Z), -2, true)),
            (" > Z [ 1 ] ", nth(Key::ParallelCenter(Z), 1, true)),
            (">>X", nth(Key::Center(X), -1, true)),
            ("<<X[0]", nth(Key::Center(X), 0, false)),
            ("|Z", Selector::Parallel(Z)),
            ("#(0,0,1)", Selector::Perpendicular(Z)),
            ("+Z", Selector::Along(Z)),
            ("-(0, 0, -1.0)", Selector::Along(Z)),
            ("Z", Selector::Along(Z)),
            ("(0,0,1)", Selector::Along(Z)),
            ("%plane", Selector::Form("PLANE".into())),
            ("front", nth(Key::Center(Z), -1, true)),
            ("left", nth(Key::Center(X), -1, false)),
            (">XY", nth(Key::Center([1.0, 1.0, 0.0]), -1, true)),
        ] {
            assert_eq!(Selector::parse(text), Ok(expected), "{text}");
        }
    }

    #[test]
    fn words_bind_as_in_cadquery() {
        let (z, x) = (
            || Box::new(Selector::Parallel(Z)),
            || Box::new(Selector::Parallel(X)),
        );
        let both = || Box::new(Selector::And(z(), x()));
        for (text, expected) in [
            ("|Z and |X", *both()),
            ("|Z or |Z and |X", Selector::Or(z(), both())),
            ("(|Z or |X) and |X", {
                Selector::And(Box::new(Selector::Or(z(), x())), x())
            }),
            ("|Z exc |Z or |X", {
                Selector::Except(z(), Box::new(Selector::Or(z(), x())))
            }),
            ("|Z except |X", Selector::Except(z(), x())),
            ("not |Z and |X", Selector::Not(both())),
            ("not(|Z)", Selector::Not(z())),
            ("|Z and not |X", {
                Selector::And(z(), Box::new(Selector::Not(x())))
            }),
        ] {
            assert_eq!(Selector::parse(text), Ok(expected), "{text}");
        }
    }

    #[test]
    fn nonsense_is_answered_with_its_place() {
        for (text, place) in [
            ("", 0),
            (">Q", 1),
            (">Z[a]", 3),
            ("%SQUARE", 1),
            (">Z and", 6),
            ("(>Z", 3),
            (">Z >X", 3),
            (">(0,0,0)", 8),
            (">Z[99999999999]", 3),
        ] {
            let message = Selector::parse(text).unwrap_err();
            assert!(
                message.contains(&format!("at place {place}:")),
                "{text}: {message}"
            );
        }
        assert!(Selector::parse(&"(".repeat(10_000)).is_err());
        assert!(Selector::parse(&"not ".repeat(10_000)).is_err());
    }
}

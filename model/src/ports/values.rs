//! Parameters of ports: what may be written, and what the port types share.

use super::Port;

/// The largest length of a port, in mm.
pub const MOST_MM: f64 = 1e5;

/// The smallest length of a port, in mm.
const LEAST_MM: f64 = 1e-2;

/// A parameter that a port carries.
#[derive(Debug, Clone, Copy)]
pub struct PortParam {
    /// Name.
    pub name: &'static str,
    /// `mm`, `deg`, or empty for a number without a unit.
    pub unit: &'static str,
    /// Which values it takes.
    pub allowed: Allowed,
    /// The value where none is stated; none where one must be.
    pub optional: Option<f64>,
    /// What it means, in one line.
    pub doc: &'static str,
}

/// Which values a parameter takes.
#[derive(Debug, Clone, Copy)]
pub enum Allowed {
    /// A number from the one to the other.
    Between(f64, f64),
    /// A whole number from the one to the other.
    Whole(f64, f64),
    /// One of these.
    OneOf(&'static [f64]),
}

impl Allowed {
    /// Whether a value is one of them. What is no number is none.
    #[must_use]
    pub fn allows(&self, value: f64) -> bool {
        match self {
            Self::Between(min, max) => value >= *min && value <= *max,
            Self::Whole(min, max) => value >= *min && value <= *max && libm::trunc(value) == value,
            Self::OneOf(list) => list.contains(&value),
        }
    }
}

impl PortParam {
    /// What is accepted, in plain words.
    #[must_use]
    pub fn expected(&self) -> String {
        let unit = if self.unit.is_empty() { "" } else { " " };
        match self.allowed {
            Allowed::Between(min, max) => {
                format!("a number from {min} to {max}{unit}{}", self.unit)
            }
            Allowed::Whole(min, max) => format!("a whole number from {min} to {max}"),
            Allowed::OneOf(list) => {
                let list: Vec<String> = list.iter().map(ToString::to_string).collect();
                format!("one of: {}", list.join(", "))
            }
        }
    }
}

/// The parameters of a port by name.
#[derive(Debug, Clone, Copy)]
pub struct Values<'a> {
    port: &'a Port,
}

impl<'a> Values<'a> {
    pub(super) fn of(port: &'a Port) -> Self {
        Self { port }
    }

    /// The value of a parameter, or its default; NaN where there is neither.
    #[must_use]
    pub fn get(&self, name: &str) -> f64 {
        let default = || {
            let params = self.port.port_type.kind().params;
            params.iter().find(|p| p.name == name)?.optional
        };
        self.port
            .params
            .get(name)
            .copied()
            .or_else(default)
            .unwrap_or(f64::NAN)
    }

    /// A fault where the first is not less than the second.
    pub(super) fn less(&self, small: &str, large: &str) -> Vec<String> {
        let (a, b) = (self.get(small), self.get(large));
        if a < b {
            return Vec::new();
        }
        vec![format!(
            "'{small}' ({a}) of a {} port is less than '{large}' ({b})",
            self.port.port_type
        )]
    }
}

/// A length called `diameter`.
pub(super) const fn diameter(doc: &'static str) -> PortParam {
    named("diameter", doc)
}

/// A length called `depth`.
pub(super) const fn depth(doc: &'static str) -> PortParam {
    named("depth", doc)
}

/// A length called `length`.
pub(super) const fn length(doc: &'static str) -> PortParam {
    named("length", doc)
}

const fn named(name: &'static str, doc: &'static str) -> PortParam {
    PortParam {
        name,
        unit: "mm",
        allowed: Allowed::Between(LEAST_MM, MOST_MM),
        optional: None,
        doc,
    }
}

pub(super) const PITCH: PortParam = PortParam {
    name: "pitch",
    unit: "mm",
    allowed: Allowed::Between(0.05, 100.0),
    optional: None,
    doc: "pitch of the thread",
};

pub(super) const HAND: PortParam = PortParam {
    name: "hand",
    unit: "",
    allowed: Allowed::OneOf(&[1.0, -1.0]),
    optional: None,
    doc: "1 for a right-hand thread, -1 for a left-hand one",
};

pub(super) const MODELLED: PortParam = PortParam {
    name: "modelled_diameter",
    ..diameter(
        "diameter of the plain cylinder that stands for the thread: nominal outside, minor (tap drill) inside",
    )
};

/// No rule between the parameters.
pub(super) fn no_rule(_: &Values<'_>) -> Vec<String> {
    Vec::new()
}

/// The modelled cylinder lies between the thread's nominal and its minor diameter. The latter is
/// `d - 1.2269 P` for a bolt (d3) and `D - 1.0825 P` for a nut (D1) by ISO 68-1 and ISO 724; 1.3 P leaves
/// room for other profiles.
pub(super) fn thread_rule(v: &Values<'_>) -> Vec<String> {
    let (nominal, pitch) = (v.get("diameter"), v.get("pitch"));
    let (least, modelled) = (nominal - 1.3 * pitch, v.get("modelled_diameter"));
    if modelled >= least && modelled <= nominal {
        return Vec::new();
    }
    vec![format!(
        "'modelled_diameter' ({modelled}) of a {} port is from {least} to its nominal diameter {nominal}",
        v.port.port_type
    )]
}

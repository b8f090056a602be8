//! Component classes: what a part is for, as far as its factory tells.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A component class, as `family/kind`.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema,
)]
pub enum Class {
    /// A rolling bearing with balls.
    #[serde(rename = "bearing/ball")]
    BallBearing,
    /// A part of which nothing is known: a user's factory. It may be of any class.
    #[serde(rename = "custom")]
    Custom,
    /// A screw or bolt with a head.
    #[serde(rename = "fastener/bolt")]
    Bolt,
    /// A nut.
    #[serde(rename = "fastener/nut")]
    Nut,
    /// A screw without a head that presses with its end.
    #[serde(rename = "fastener/set_screw")]
    SetScrew,
    /// A washer.
    #[serde(rename = "fastener/washer")]
    Washer,
    /// A cylindrical gear.
    #[serde(rename = "gear/spur")]
    SpurGear,
    /// A leaf of a hinge.
    #[serde(rename = "joint/hinge_leaf")]
    HingeLeaf,
    /// A pin about which parts turn.
    #[serde(rename = "joint/pin")]
    Pin,
    /// A coupling's hub.
    #[serde(rename = "rotary/coupling")]
    Coupling,
    /// A key between shaft and hub.
    #[serde(rename = "rotary/key")]
    Key,
    /// A shaft.
    #[serde(rename = "rotary/shaft")]
    Shaft,
    /// A boss.
    #[serde(rename = "structure/boss")]
    Boss,
    /// An angle bracket.
    #[serde(rename = "structure/bracket")]
    Bracket,
    /// A channel.
    #[serde(rename = "structure/channel")]
    Channel,
    /// A flange.
    #[serde(rename = "structure/flange")]
    Flange,
    /// A housing or bearing block.
    #[serde(rename = "structure/housing")]
    Housing,
    /// A plate.
    #[serde(rename = "structure/plate")]
    Plate,
}

/// Every class with its name, sorted by name.
pub static ALL: [(Class, &str); 18] = [
    (Class::BallBearing, "bearing/ball"),
    (Class::Custom, "custom"),
    (Class::Bolt, "fastener/bolt"),
    (Class::Nut, "fastener/nut"),
    (Class::SetScrew, "fastener/set_screw"),
    (Class::Washer, "fastener/washer"),
    (Class::SpurGear, "gear/spur"),
    (Class::HingeLeaf, "joint/hinge_leaf"),
    (Class::Pin, "joint/pin"),
    (Class::Coupling, "rotary/coupling"),
    (Class::Key, "rotary/key"),
    (Class::Shaft, "rotary/shaft"),
    (Class::Boss, "structure/boss"),
    (Class::Bracket, "structure/bracket"),
    (Class::Channel, "structure/channel"),
    (Class::Flange, "structure/flange"),
    (Class::Housing, "structure/housing"),
    (Class::Plate, "structure/plate"),
];

/// The classes of the built-in factories, sorted by the factory's name.
pub static BUILT_IN: [(&str, Class); 13] = [
    ("base_frame.bolt_circle_flange", Class::Flange),
    ("base_frame.boss", Class::Boss),
    ("base_frame.coupling_hub", Class::Coupling),
    ("base_frame.housing_block", Class::Housing),
    ("base_frame.l_bracket", Class::Bracket),
    ("base_frame.rect_plate", Class::Plate),
    ("base_frame.stepped_shaft", Class::Shaft),
    ("base_frame.u_channel", Class::Channel),
    ("bearing.ball", Class::BallBearing),
    ("fastener.bolt", Class::Bolt),
    ("fastener.nut", Class::Nut),
    ("fastener.washer", Class::Washer),
    ("gear.spur", Class::SpurGear),
];

impl Class {
    /// The name as it is written.
    #[must_use]
    pub fn name(self) -> &'static str {
        ALL.iter()
            .find(|(class, _)| *class == self)
            .map_or("custom", |(_, name)| *name)
    }

    /// The class of a factory, by its full or short name. What is no built-in factory is custom: its name
    /// is the user's word and says nothing that could be relied on.
    #[must_use]
    pub fn of_factory(factory: &str) -> Self {
        BUILT_IN
            .iter()
            .find(|(name, _)| {
                let short = name.strip_suffix(factory);
                short.is_some_and(|s| s.is_empty() || s.find('.') == s.len().checked_sub(1))
            })
            .map_or(Self::Custom, |(_, class)| *class)
    }

    /// Whether it is a fastener or what lies under one.
    #[must_use]
    pub fn is_fastener(self) -> bool {
        matches!(self, Self::Bolt | Self::Nut | Self::SetScrew | Self::Washer)
    }

    /// Whether it is a part of structure, which carries others.
    #[must_use]
    pub fn is_structure(self) -> bool {
        matches!(
            self,
            Self::Boss | Self::Bracket | Self::Channel | Self::Flange | Self::Housing | Self::Plate
        )
    }
}

impl core::fmt::Display for Class {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::{ALL, BUILT_IN, Class};

    #[test]
    fn names_are_sorted_and_those_of_the_format() {
        assert!(ALL.is_sorted_by(|a, b| a.1 < b.1));
        assert!(BUILT_IN.is_sorted_by(|a, b| a.0 < b.0));
        for (class, name) in ALL {
            assert_eq!(serde_json::to_value(class).unwrap(), name);
        }
    }

    #[test]
    fn factories_have_their_classes() {
        assert_eq!(Class::of_factory("base_frame.rect_plate"), Class::Plate);
        assert_eq!(Class::of_factory("rect_plate"), Class::Plate);
        assert_eq!(Class::of_factory("gear.spur"), Class::SpurGear);
        assert_eq!(Class::of_factory("user.gear"), Class::Custom);
    }
}

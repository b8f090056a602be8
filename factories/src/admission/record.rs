//! What is kept of an admitted factory, beside its source.

use std::collections::BTreeMap;

use assemcad_model::name;
use assemcad_model::param::ParamSpec;
use assemcad_script::Factory;
use serde::{Deserialize, Serialize};

use super::report::Evidence;
use super::request::Request;

/// The namespace of factories that users write.
pub const NAMESPACE: &str = "user";

/// An admitted factory's record.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// [`Record::FORMAT`].
    pub format: u32,
    /// Name without the version: `user.clevis`.
    pub factory: String,
    /// Version, from 1.
    pub version: u32,
    /// SHA-256 of the source beside it.
    pub source_sha256: String,
    /// SHA-256 of the request.
    pub request_sha256: String,
    /// The request.
    pub request: Request,
    /// Ranges that replace the declared ones, where the factory was admitted for less: smallest and
    /// largest value by parameter.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub ranges: BTreeMap<String, [f64; 2]>,
    /// On what it was admitted.
    pub evidence: Evidence,
}

impl Record {
    /// The version of the record's format.
    pub const FORMAT: u32 = 1;

    /// The full name: `user.clevis@2`.
    #[must_use]
    pub fn name(&self) -> String {
        versioned(&self.factory, self.version)
    }

    /// The factory within the ranges for which it was admitted.
    #[must_use]
    pub fn within(&self, factory: Factory) -> Factory {
        if self.ranges.is_empty() {
            return factory;
        }
        let mut specs = factory.params().to_vec();
        for spec in &mut specs {
            if let Some(range) = self.ranges.get(&spec.name) {
                spec.set_range(*range);
            }
        }
        factory.within(specs)
    }
}

/// The ranges in which narrowed parameters differ from the declared ones.
pub(super) fn ranges(declared: &[ParamSpec], narrowed: &[ParamSpec]) -> BTreeMap<String, [f64; 2]> {
    let pairs = declared.iter().zip(narrowed);
    pairs
        .filter(|(a, b)| a.range() != b.range())
        .filter_map(|(_, b)| Some((b.name.clone(), b.range()?)))
        .collect()
}

/// `NAME@VERSION`.
#[must_use]
pub fn versioned(factory: &str, version: u32) -> String {
    format!("{factory}@{version}")
}

/// A name and its version, where it has one that is written as [`versioned`] writes it.
#[must_use]
pub fn split_version(text: &str) -> Option<(&str, u32)> {
    let (factory, digits) = text.rsplit_once('@')?;
    let version = digits.parse().ok().filter(|v| *v > 0)?;
    (versioned(factory, version) == text).then_some((factory, version))
}

/// Whether a text may name a user's factory, without a version: `user.NAME`.
#[must_use]
pub fn is_valid_user_name(text: &str) -> bool {
    text.split_once('.')
        .is_some_and(|(space, rest)| space == NAMESPACE && name::is_valid(rest))
}

/// The file of a version's source or record.
#[must_use]
pub fn file_name(factory: &str, version: u32, extension: &str) -> String {
    format!("{}.{extension}", versioned(factory, version))
}

#[cfg(test)]
mod tests {
    use super::{is_valid_user_name, split_version};

    #[test]
    fn a_version_is_read_as_it_is_written() {
        assert_eq!(split_version("user.arm@12"), Some(("user.arm", 12)));
        for none in [
            "user.arm",
            "user.arm@",
            "user.arm@0",
            "user.arm@01",
            "user.arm@+1",
            "@",
            "user.arm@x",
        ] {
            assert_eq!(split_version(none), None, "{none}");
        }
    }

    #[test]
    fn names_that_look_like_paths_are_none() {
        assert!(is_valid_user_name("user.arm_2"));
        for bad in [
            "arm",
            "user.",
            "user.a/b",
            "user.../x",
            "user.a.b",
            "gear.arm",
            "user.a@1",
            "user.a\0",
            "User.a",
        ] {
            assert!(!is_valid_user_name(bad), "{bad}");
        }
    }
}

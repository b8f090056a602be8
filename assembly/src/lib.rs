//! Realisation of specifications.

//! The report for people: one page, as Markdown and as HTML.
//!
//! A page is made of a report alone, so that it is as reproducible as the report.

mod blocks;
pub mod html;
pub mod markdown;
pub mod page;
mod tables;

pub use blocks::{Block, Page, Table, word};

#[cfg(test)]
mod tests;

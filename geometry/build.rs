//! Tells the sources that answers depend on.

use std::error::Error;
use std::fs;
use std::path::PathBuf;

include!("../kernel/sources.rs");

fn main() -> Result<(), Box<dyn Error>> {
    // The kernel's own are told by itself. The lock file names the versions of all libraries.
    let sources = sources(&["src", "../model/src", "../Cargo.lock"])?;
    println!("cargo:rustc-env=ASSEMCAD_GEOMETRY_SOURCES={sources:016x}");
    println!("cargo:rerun-if-changed=../kernel/sources.rs");
    Ok(())
}

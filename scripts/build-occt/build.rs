//! Builds OCCT from the sources that `occt-sys` carries (static libraries, release profile).
//!
//! `occt-sys` takes its places from the variables that cargo sets for build scripts: hence here.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    occt_sys::build_occt();
    println!("cargo:rustc-env=OCCT_PATH={}", occt_sys::occt_path().display());
}

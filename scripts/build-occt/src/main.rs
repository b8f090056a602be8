//! Builds OCCT from the sources that `occt-sys` carries and prints where it is.
//!
//! `occt-sys` is made for build scripts and takes its places from the variables that cargo sets there.

fn main() {
    occt_sys::build_occt();
    println!("{}", occt_sys::occt_path().display());
}

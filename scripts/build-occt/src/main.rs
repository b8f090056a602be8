//! Prints where the OCCT is that the build script built.

fn main() {
    println!("{}", env!("OCCT_PATH"));
}

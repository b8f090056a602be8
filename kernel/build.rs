//! Compiles the C++ side and links the libraries of OCCT that it uses.

use std::env;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

include!("sources.rs");

/// What the verbs use, beyond what comes along with `opencascade-sys`.
const LIBRARIES: [&str; 23] = [
    "TKDESTEP",
    "TKXSBase",
    "TKXCAF",
    "TKVCAF",
    "TKCAF",
    "TKLCAF",
    "TKCDF",
    "TKFeat",
    "TKOffset",
    "TKFillet",
    "TKBool",
    "TKBO",
    "TKMesh",
    "TKPrim",
    "TKShHealing",
    "TKTopAlgo",
    "TKGeomAlgo",
    "TKBRep",
    "TKGeomBase",
    "TKG3d",
    "TKG2d",
    "TKMath",
    "TKernel",
];

const SOURCES: [&str; 25] = [
    "along",
    "areas",
    "canonical",
    "combine",
    "common",
    "curves",
    "facts",
    "flat",
    "integrals",
    "io",
    "look",
    "mesh",
    "pair",
    "place",
    "primitives",
    "query",
    "sides",
    "skin",
    "solids",
    "start",
    "step_read",
    "step_write",
    "sweeps",
    "topology",
    "wires",
];

fn place_of(variable: &str) -> Result<String, Box<dyn Error>> {
    println!("cargo:rerun-if-env-changed={variable}");
    let value = env::var(variable)
        .map_err(|_| format!("{variable} does not say where OpenCASCADE is: run scripts/setup"))?;
    if Path::new(&value).is_dir() {
        Ok(value)
    } else {
        Err(format!("{variable} names {value}, which is no folder: run scripts/setup").into())
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let include = place_of("ASSEMCAD_OCCT_INCLUDE")?;
    let lib = place_of("ASSEMCAD_OCCT_LIB")?;

    let mut build = cxx_build::bridges(["src/ffi.rs", "src/brep/ffi.rs"]);
    for source in SOURCES {
        build.file(format!("cpp/{source}.cpp"));
    }
    build
        .std("c++17")
        .opt_level(2)
        .debug(false)
        // As a system folder: OCCT's headers are not ours to be warned about.
        .flag_if_supported(format!("-isystem{include}"))
        .compile("assemcad-kernel-shim");

    println!("cargo:rustc-link-search=native={lib}");
    // A build from source makes static libraries, all other ways shared ones.
    let shared = ["libTKernel.so", "libTKernel.dylib"]
        .iter()
        .any(|name| Path::new(&lib).join(name).exists());
    let kind = if shared { "dylib" } else { "static" };
    for library in LIBRARIES {
        println!("cargo:rustc-link-lib={kind}={library}");
    }
    println!(
        "cargo:rustc-env=ASSEMCAD_OCCT_VERSION={}",
        occt_version(&include)?
    );
    println!(
        "cargo:rustc-env=ASSEMCAD_KERNEL_SOURCES={:016x}",
        sources(&["src", "cpp"])?
    );
    println!("cargo:rerun-if-changed=sources.rs");
    Ok(())
}

/// The version that OCCT's headers state.
fn occt_version(include: &str) -> Result<String, Box<dyn Error>> {
    let header = fs::read_to_string(Path::new(include).join("Standard_Version.hxx"))?;
    let line = header
        .lines()
        .find(|l| l.contains("define OCC_VERSION_COMPLETE"));
    let version = line
        .and_then(|l| l.split('"').nth(1))
        .ok_or("OCCT's headers state no version")?;
    Ok(version.to_owned())
}

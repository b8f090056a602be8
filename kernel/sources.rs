// Included by build scripts: a number that changes with sources.

/// A number that changes with the files in some folders, and below them, and with some files (FNV-1a, 64 bits). What
/// another version of them made is not taken from what is kept on disk.
fn sources(of: &[&str]) -> Result<u64, Box<dyn Error>> {
    let mut files = Vec::new();
    let mut left: Vec<PathBuf> = of.iter().map(PathBuf::from).collect();
    while let Some(path) = left.pop() {
        if path.is_dir() {
            for entry in fs::read_dir(path)? {
                left.push(entry?.path());
            }
        } else {
            files.push(path);
        }
    }
    files.sort();
    let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
    for file in files {
        for byte in fs::read(file)? {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
    for path in of {
        println!("cargo:rerun-if-changed={path}");
    }
    Ok(hash)
}

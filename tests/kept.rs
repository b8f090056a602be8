//! What is kept on disk beside the state: solids and answers about them. All of it can be lost, damaged or planted at
//! any time, and nothing is told that is not so.

use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde_json::json;
use tempfile::TempDir;

use crate::kit::Kit;

/// The files of what is kept that end so, sorted.
fn kept(root: &Path, ending: &str) -> Vec<PathBuf> {
    let Ok(all) = std::fs::read_dir(root.join(".assemcad/cache")) else {
        return Vec::new();
    };
    let mut paths: Vec<PathBuf> = all
        .map(|e| e.unwrap().path())
        .filter(|p| p.to_str().unwrap().ends_with(ending))
        .collect();
    paths.sort();
    paths
}

/// A root in which a stand was verified, and its report.
fn verified() -> (TempDir, Vec<u8>) {
    let mut kit = Kit::new();
    kit.whole_stand("stand");
    kit.ok("verify", json!({"assembly": "stand", "clearance_mm": 5}));
    let report = std::fs::read(kit.file("assemblies/stand/report.json")).unwrap();
    (kit.closed(), report)
}

/// Verifies the stand by another server; its folder, its report where it could be written, what it logged last of
/// geometry, and all it logged.
fn again(root: TempDir, options: &[&str]) -> (TempDir, Vec<u8>, String, String) {
    let logs = tempfile::tempdir().unwrap();
    let log = logs.path().join("log");
    std::fs::remove_file(root.path().join("assemblies/stand/report.json")).unwrap();
    let mut kit = Kit::logging(root, &log, options);
    kit.ok("verify", json!({"assembly": "stand", "clearance_mm": 5}));
    let report = std::fs::read(kit.file("assemblies/stand/report.json")).unwrap_or_default();
    let root = kit.closed();
    let told = std::fs::read_to_string(log).unwrap();
    let last = told.lines().rfind(|line| line.contains("geometry: "));
    let last = last.unwrap().split_once("geometry: ").unwrap().1.to_owned();
    (root, report, last, told)
}

/// How large what is kept is on disk, in bytes.
fn size(root: &Path) -> u64 {
    use std::os::unix::fs::MetadataExt;
    let all = kept(root, "");
    all.iter()
        .map(|p| p.metadata().unwrap().blocks() * 512)
        .sum()
}

#[test]
fn a_server_that_is_started_again_needs_no_kernel_for_what_was_verified() {
    let (root, before) = verified();
    let (_root, report, counts, _) = again(root, &[]);
    assert_eq!(report, before);
    assert!(counts.contains(" computed=0 kernel_calls=0 "), "{counts}");
    assert!(!counts.contains("recalled=0"), "{counts}");
}

#[test]
fn damaged_and_planted_answers_are_asked_anew_and_nothing_waits_for_them() {
    let (root, before) = verified();
    let answers = kept(root.path(), ".answer");
    assert!(answers.len() > 15, "{}", answers.len());
    let victim = root.path().join("victim");
    std::fs::write(&victim, "safe").unwrap();
    for (i, path) in answers.iter().enumerate() {
        let mut bytes = std::fs::read(path).unwrap();
        std::fs::remove_file(path).unwrap();
        match i % 6 {
            0 => {
                bytes.truncate(bytes.len() - 1);
                std::fs::write(path, bytes).unwrap();
            }
            1 => {
                let last = bytes.len() - 2;
                bytes[last] ^= 1;
                std::fs::write(path, bytes).unwrap();
            }
            2 => symlink(&victim, path).unwrap(),
            3 => {
                let (kind, mode) = (rustix::fs::FileType::Fifo, rustix::fs::Mode::RWXU);
                rustix::fs::mknodat(rustix::fs::CWD, path, kind, mode, 0).unwrap();
            }
            4 => std::fs::create_dir(path).unwrap(),
            _ => {
                // Another answer, in its own name.
                let other = answers.iter().rfind(|p| p.is_file()).unwrap();
                std::fs::copy(other, path).unwrap();
            }
        }
    }
    let begun = Instant::now();
    let (root, report, counts, _) = again(root, &[]);
    assert!(begun.elapsed() < Duration::from_secs(60));
    assert_eq!(report, before);
    assert!(counts.contains("recalled=0"), "{counts}");
    assert_eq!(std::fs::read_to_string(&victim).unwrap(), "safe");
    // All but where a folder is in the way was mended.
    let (_root, report, counts, _) = again(root, &[]);
    assert_eq!(report, before);
    let computed = counts.split("computed=").nth(1).unwrap();
    let computed: usize = computed.split(' ').next().unwrap().parse().unwrap();
    assert_eq!(
        computed,
        answers.len() / 6 + usize::from(answers.len() % 6 > 4)
    );
}

#[test]
fn nothing_is_kept_where_a_link_leads() {
    for planted in [".assemcad", ".assemcad/cache"] {
        let (root, before) = verified();
        let elsewhere = tempfile::tempdir().unwrap();
        let place = root.path().join(planted);
        std::fs::remove_dir_all(&place).unwrap();
        symlink(elsewhere.path(), &place).unwrap();
        let (_root, report, _, told) = again(root, &[]);
        // A report that takes part in a step needs the folder, too.
        let written = planted == ".assemcad/cache";
        assert_eq!(report, if written { before } else { Vec::new() });
        assert_eq!(
            std::fs::read_dir(elsewhere.path()).unwrap().count(),
            0,
            "{planted}"
        );
        let said = told.matches(" WARN ").count();
        let of_it = told.matches("cannot be kept on disk").count();
        assert!(said == 1 && of_it >= 1, "{told}");
    }
}

#[test]
fn what_is_kept_has_a_limit_and_leftovers_go_at_the_start() {
    let (root, _) = verified();
    let all = kept(root.path(), "");
    let before = size(root.path());
    let cache = root.path().join(".assemcad/cache");
    let left: Vec<PathBuf> = ["solid", "answer"]
        .iter()
        .flat_map(|kind| {
            let name = format!("{:064x}", 7);
            [
                format!("{name}.0123456789abcdef.{kind}"),
                format!(".{name}.0123456789abcdef.{kind}.123456-7"),
            ]
        })
        .map(|name| cache.join(name))
        .collect();
    for path in &left {
        std::fs::write(path, "of another kernel").unwrap();
    }
    let root = Kit::logging(root, &cache.join("../log"), &[]).closed();
    assert!(left.iter().all(|path| !path.exists()));
    assert_eq!(kept(root.path(), ""), all);
    // A good MiB of other values that were used long ago go before those of today.
    let old = std::time::SystemTime::now() - Duration::from_secs(100 * 86_400);
    let tag = all[0].to_str().unwrap().split('.').rev().nth(1).unwrap();
    let kind = all[0].extension().unwrap().to_str().unwrap();
    for n in 0..40 {
        let path = cache.join(format!("{n:064x}.{tag}.{kind}"));
        std::fs::write(&path, vec![b'x'; 50_000]).unwrap();
        let file = std::fs::File::open(&path).unwrap();
        file.set_times(std::fs::FileTimes::new().set_modified(old))
            .unwrap();
    }
    let most = before.div_ceil(1 << 20) + 1;
    let root = Kit::logging(
        root,
        &cache.join("../log"),
        &["--cache-mb", &most.to_string()],
    )
    .closed();
    assert!(size(root.path()) <= most << 20);
    let left = kept(root.path(), "");
    assert!(all.iter().all(|path| left.contains(path)));
    assert!(left.len() < all.len() + 40);
}

//! What a worker takes from itself before it does anything for anybody, for good.
//!
//! A worker carries out what strangers wrote, partly in code that is not memory-safe. It has no business with the
//! user's files, with the network or with other processes, and so the system is told to refuse them: files by
//! Landlock, the rest by a filter of system calls. Where the system has neither, a worker does without, and the
//! server says so when it starts.

use std::io;
use std::os::fd::OwnedFd;
use std::path::PathBuf;

use rustix::process::{Resource, Rlimit, setrlimit};

/// What a worker keeps.
#[derive(Debug, Default)]
pub struct Keeps {
    /// Open folders in which it may read and write files; none may be opened elsewhere. Open ones, since what a path
    /// means may change meanwhile.
    pub folders: Vec<OwnedFd>,
    /// Files and folders that it may read.
    pub read: Vec<PathBuf>,
}

/// Means of seclusion that this system does not have, in words for a log.
#[must_use]
pub fn missing() -> Vec<&'static str> {
    system::missing()
}

/// Takes from this process what it does not keep. Threads that are started afterwards have no more; those that are
/// there already keep the files.
///
/// # Errors
/// When the system has the means and refuses them: a worker that is not secluded where it could be serves nobody.
pub(crate) fn seclude(keeps: &Keeps) -> io::Result<()> {
    system::seclude(keeps)?;
    if keeps.folders.is_empty() && keeps.read.is_empty() {
        // The second lock, which every system has. One open file stays possible in number: that is standard
        // input, the socket, and waiting for it counts as much.
        limit(Resource::Nofile, 1)?;
        limit(Resource::Fsize, 0)?;
    }
    Ok(())
}

fn limit(what: Resource, most: u64) -> io::Result<()> {
    setrlimit(
        what,
        Rlimit {
            current: Some(most),
            maximum: Some(most),
        },
    )?;
    Ok(())
}

#[cfg(not(target_os = "linux"))]
mod system {
    use super::Keeps;
    use std::io;

    pub(super) fn missing() -> Vec<&'static str> {
        vec!["Landlock (files)", "seccomp (network, processes)"]
    }

    #[expect(clippy::unnecessary_wraps, reason = "elsewhere it may fail")]
    pub(super) fn seclude(_keeps: &Keeps) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(target_os = "linux")]
mod system {
    use std::collections::BTreeMap;
    use std::io;

    use landlock::{
        ABI, Access, AccessFs, AccessNet, BitFlags, CompatLevel, Compatible, PathBeneath, PathFd,
        Ruleset, RulesetAttr, RulesetCreatedAttr, Scope,
    };
    use seccompiler::{
        BpfProgram, SeccompAction, SeccompCmpArgLen, SeccompCmpOp, SeccompCondition, SeccompFilter,
        SeccompRule, TargetArch, apply_filter_all_threads,
    };

    use super::Keeps;

    /// The newest revision of Landlock that is used; of older ones, what they have.
    const LANDLOCK: ABI = ABI::V6;

    pub(super) fn missing() -> Vec<&'static str> {
        let mut missing = Vec::new();
        let ruleset = Ruleset::default().set_compatibility(CompatLevel::HardRequirement);
        let landlock = ruleset.handle_access(AccessFs::from_all(ABI::V1));
        if landlock.and_then(Ruleset::create).is_err() {
            missing.push("Landlock (files)");
        }
        if !has_seccomp() {
            missing.push("seccomp (network, processes)");
        }
        missing
    }

    fn has_seccomp() -> bool {
        arch().is_some()
            && std::fs::read_to_string("/proc/self/status").is_ok_and(|s| s.contains("\nSeccomp:"))
    }

    fn arch() -> Option<TargetArch> {
        TargetArch::try_from(std::env::consts::ARCH).ok()
    }

    pub(super) fn seclude(keeps: &Keeps) -> io::Result<()> {
        // Asked while files can be opened.
        let filtered = has_seccomp();
        files(keeps).map_err(|e| io::Error::other(format!("Landlock: {e}")))?;
        if let Some(arch) = arch().filter(|_| filtered) {
            for program in filters(arch).map_err(|e| io::Error::other(format!("seccomp: {e}")))? {
                apply_filter_all_threads(&program)
                    .map_err(|e| io::Error::other(format!("seccomp: {e}")))?;
            }
        }
        Ok(())
    }

    fn files(keeps: &Keeps) -> Result<(), landlock::RulesetError> {
        let reading: BitFlags<AccessFs> = AccessFs::ReadFile | AccessFs::ReadDir;
        let writing = reading
            | AccessFs::WriteFile
            | AccessFs::Truncate
            | AccessFs::MakeReg
            | AccessFs::MakeDir
            | AccessFs::RemoveFile;
        let mut rules = Ruleset::default()
            .handle_access(AccessFs::from_all(LANDLOCK))?
            .handle_access(AccessNet::from_all(LANDLOCK))?
            .scope(Scope::from_all(LANDLOCK))?
            .create()?;
        for folder in &keeps.folders {
            rules = rules.add_rule(PathBeneath::new(folder, writing))?;
        }
        for path in &keeps.read {
            // What is not there cannot be opened, with or without a rule.
            let Ok(opened) = PathFd::new(path) else {
                continue;
            };
            let file = !path.is_dir();
            let access = if file {
                reading & AccessFs::from_file(LANDLOCK)
            } else {
                reading
            };
            rules = rules.add_rule(PathBeneath::new(opened, access))?;
        }
        // Sets "no new privileges" too.
        rules.restrict_self().map(drop)
    }

    /// Calls that a worker has no use for, whatever it computes.
    const REFUSED: &[libc::c_long] = &[
        libc::SYS_execve,
        libc::SYS_execveat,
        #[cfg(target_arch = "x86_64")]
        libc::SYS_fork,
        #[cfg(target_arch = "x86_64")]
        libc::SYS_vfork,
        libc::SYS_socket,
        libc::SYS_socketpair,
        libc::SYS_connect,
        libc::SYS_bind,
        libc::SYS_listen,
        libc::SYS_accept,
        libc::SYS_accept4,
        libc::SYS_kill,
        libc::SYS_ptrace,
        libc::SYS_process_vm_readv,
        libc::SYS_process_vm_writev,
        libc::SYS_pidfd_open,
        libc::SYS_pidfd_getfd,
        libc::SYS_pidfd_send_signal,
        libc::SYS_io_uring_setup,
        libc::SYS_bpf,
        libc::SYS_perf_event_open,
        libc::SYS_userfaultfd,
        libc::SYS_open_by_handle_at,
        libc::SYS_mount,
        libc::SYS_umount2,
        libc::SYS_pivot_root,
        libc::SYS_chroot,
        libc::SYS_unshare,
        libc::SYS_setns,
        libc::SYS_keyctl,
        libc::SYS_add_key,
        libc::SYS_request_key,
        libc::SYS_init_module,
        libc::SYS_finit_module,
        libc::SYS_kexec_load,
        libc::SYS_shmget,
        libc::SYS_msgget,
    ];

    fn filters(arch: TargetArch) -> Result<Vec<BpfProgram>, seccompiler::BackendError> {
        let mut refused: BTreeMap<i64, Vec<SeccompRule>> =
            REFUSED.iter().map(|n| (*n, Vec::new())).collect();
        // A thread is begun by the call that begins a process; a flag tells them apart.
        let thread = u64::from(libc::CLONE_THREAD.unsigned_abs());
        let process = SeccompCondition::new(
            0,
            SeccompCmpArgLen::Qword,
            SeccompCmpOp::MaskedEq(thread),
            0,
        )?;
        refused.insert(libc::SYS_clone, vec![SeccompRule::new(vec![process])?]);
        // Letters that a terminal would take for typed ones.
        let typed =
            SeccompCondition::new(1, SeccompCmpArgLen::Dword, SeccompCmpOp::Eq, libc::TIOCSTI)?;
        refused.insert(libc::SYS_ioctl, vec![SeccompRule::new(vec![typed])?]);
        let denied = filter(refused, libc::EPERM, arch)?;
        // Its flags lie in memory, where no filter sees them: whoever tries it is told to use the older call.
        let newer = BTreeMap::from([(libc::SYS_clone3, Vec::new())]);
        Ok(vec![denied, filter(newer, libc::ENOSYS, arch)?])
    }

    fn filter(
        refused: BTreeMap<i64, Vec<SeccompRule>>,
        answer: i32,
        arch: TargetArch,
    ) -> Result<BpfProgram, seccompiler::BackendError> {
        let answer = SeccompAction::Errno(answer.unsigned_abs());
        SeccompFilter::new(refused, SeccompAction::Allow, answer, arch)?.try_into()
    }
}

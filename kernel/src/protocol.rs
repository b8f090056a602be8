//! What the server and its workers say to each other, over a private socket.
//!
//! A message is two little-endian 32-bit lengths, a JSON header of the first length and a block of
//! plain bytes of the second (the STEP file; empty otherwise).

use std::io::{self, Read, Write};

use assemcad_model::frame::Rows;
use assemcad_model::ports::Port;
use assemcad_model::probe::{Answer, Probe};
use assemcad_model::recipe::Recipe;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::contact::{Touch, Where};

/// The longest header or block that is accepted, in bytes.
pub const MAX_LENGTH: u32 = 1 << 30;

/// A solid in its place.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Placed {
    /// How to make it.
    pub recipe: Recipe,
    /// Where it is.
    pub placement: Rows,
}

/// A piece of work for a worker.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Job {
    /// Make a solid and measure it.
    Build {
        /// How to make it.
        recipe: Recipe,
    },
    /// The volume that two placed solids have in common, and an independent estimate of it.
    CommonVolume {
        /// First solid.
        a: Box<Placed>,
        /// Second solid.
        b: Box<Placed>,
        /// How many points the estimate takes.
        samples: u32,
    },
    /// What a solid has where its ports are.
    Probe {
        /// How to make it.
        recipe: Recipe,
        /// What is asked.
        probes: Vec<Probe>,
    },
    /// The area over which two placed solids touch in a stated surface.
    Contact {
        /// First solid.
        a: Box<Placed>,
        /// Second solid.
        b: Box<Placed>,
        /// The surface, in the world.
        place: Where,
    },
    /// The surface of a solid as triangles.
    Mesh {
        /// How to make it.
        recipe: Recipe,
        /// How far the triangles may deviate from the surface, in mm.
        deflection_mm: f64,
        /// How far they may deviate in direction, in degrees.
        angle_deg: f64,
    },
    /// A STEP file of an assembly, read back after writing.
    Step {
        /// The distinct solids.
        solids: Vec<Product>,
        /// The parts, each an instance of a solid.
        instances: Vec<Instance>,
        /// Name of the assembly.
        name: String,
        /// The lines of the file's description.
        description: Vec<String>,
    },
}

impl Job {
    /// The job's name, for diagnostics.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Build { .. } => "build",
            Self::CommonVolume { .. } => "common volume",
            Self::Probe { .. } => "probes of ports",
            Self::Contact { .. } => "contact",
            Self::Mesh { .. } => "triangles",
            Self::Step { .. } => "STEP export",
        }
    }
}

/// A distinct solid in a STEP file.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Product {
    /// Product name.
    pub name: String,
    /// How to make it.
    pub recipe: Recipe,
    /// Colour: red, green, blue from 0 to 1.
    pub color: [f64; 3],
}

/// An instance of a solid in a STEP file.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Instance {
    /// Instance name.
    pub name: String,
    /// Index of its solid.
    pub solid: usize,
    /// Where it is.
    pub placement: Rows,
}

/// What a worker answers.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Message {
    /// What the worker is about to do, said before it does it: the last of these names the culprit
    /// when the worker dies.
    Doing(Doing),
    /// The work is done.
    Done(Reply),
    /// The work failed.
    Failed(Failure),
}

/// What a worker is doing.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Doing {
    /// The operation's name.
    pub operation: String,
    /// Its index in the recipe, where it is a recipe's operation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub step: Option<usize>,
    /// The SHA-256 of the recipe, where there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub recipe: Option<String>,
}

impl core::fmt::Display for Doing {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self.step {
            Some(step) => write!(f, "operation {} ({})", step + 1, self.operation),
            None => f.write_str(&self.operation),
        }
    }
}

/// The result of a job.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Reply {
    /// Of [`Job::Build`].
    Built(Built),
    /// Of [`Job::CommonVolume`].
    CommonVolume(CommonVolume),
    /// Of [`Job::Probe`]: an answer to each probe, in order.
    Probed(Vec<Answer>),
    /// Of [`Job::Contact`].
    Contact(Touch),
    /// Of [`Job::Mesh`]; the triangles are the message's block, see [`crate::mesh::Mesh::to_bytes`].
    Meshed,
    /// Of [`Job::Step`]; the file is the message's block.
    Step(StepFacts),
}

/// What was measured of a solid, in the part's frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Built {
    /// SHA-256 of the recipe.
    pub recipe: String,
    /// Where the solid came from.
    pub source: Source,
    /// Volume in mm3.
    pub volume: f64,
    /// Surface in mm2.
    pub area: f64,
    /// Centre of mass in mm.
    pub centre: [f64; 3],
    /// Smallest corner of the bounding box in mm.
    pub min: [f64; 3],
    /// Largest corner of the bounding box in mm.
    pub max: [f64; 3],
    /// SHA-256 of the solid's BREP bytes.
    pub brep: String,
    /// The ports, in the part's frame.
    pub ports: Vec<Port>,
}

/// Where a solid came from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Source {
    /// From the worker's memory.
    Memory,
    /// From the cache on disk.
    Disk,
    /// Replayed from its recipe.
    Replayed,
    /// Replayed, because its cache entry was damaged.
    Repaired,
}

/// The common volume of two solids.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CommonVolume {
    /// By the kernel's boolean, in mm3.
    pub volume: f64,
    /// Smallest and largest corner of the common part's box and its centre, in mm, where there is one.
    pub place: Option<([f64; 3], [f64; 3], [f64; 3])>,
    /// What the boolean warned of.
    pub warnings: Vec<String>,
    /// Points of the estimate: tried, and found inside both solids.
    pub samples: u32,
    /// Points found strictly inside both solids.
    pub inside: u32,
    /// The volume in mm3 that the points were spread over.
    pub sampled_volume: f64,
}

/// What a STEP file holds, read back from its own bytes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StepFacts {
    /// Every instance, in the file's order.
    pub instances: Vec<StepLeaf>,
}

/// An instance in a STEP file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StepLeaf {
    /// Name of the instance.
    pub name: String,
    /// Name of its product.
    pub product: String,
    /// Volume in mm3.
    pub volume: f64,
    /// Centre of mass in the world, in mm.
    pub centre: [f64; 3],
}

/// Why a job was not done.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Failure {
    /// The kind of failure.
    pub kind: FailureKind,
    /// What was being done.
    pub doing: Option<Doing>,
    /// What happened, in one sentence.
    pub message: String,
}

/// The kinds of failure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FailureKind {
    /// The kernel refused the operation or made nothing valid of it.
    Kernel,
    /// The memory limit was reached.
    Memory,
    /// The limit on processor time was reached.
    Cpu,
    /// The limit on elapsed time was reached.
    Wall,
    /// The worker died.
    Crash,
    /// The worker could not be started or spoke nonsense.
    Worker,
}

/// Writes one message.
///
/// # Errors
/// When the socket does not take it, or the header is no JSON.
pub fn write<T: Serialize>(to: &mut impl Write, header: &T, block: &[u8]) -> io::Result<()> {
    to.write_all(&encode(header, block)?)?;
    to.flush()
}

/// The bytes of one message.
///
/// # Errors
/// When the header is no JSON or a length exceeds [`MAX_LENGTH`].
pub fn encode<T: Serialize>(header: &T, block: &[u8]) -> io::Result<Vec<u8>> {
    let header = serde_json::to_vec(header)?;
    let length = |n: usize| {
        u32::try_from(n)
            .ok()
            .filter(|n| *n <= MAX_LENGTH)
            .ok_or_else(|| io::Error::new(io::ErrorKind::InvalidData, "message too long"))
    };
    let mut bytes = Vec::with_capacity(8 + header.len() + block.len());
    bytes.extend(length(header.len())?.to_le_bytes());
    bytes.extend(length(block.len())?.to_le_bytes());
    bytes.extend(header);
    bytes.extend(block);
    Ok(bytes)
}

/// The two lengths at the head of a message.
///
/// # Errors
/// When one exceeds [`MAX_LENGTH`].
pub fn lengths(head: [u8; 8]) -> io::Result<(usize, usize)> {
    let [a, b, c, d, e, f, g, h] = head;
    let (header, block) = (
        u32::from_le_bytes([a, b, c, d]),
        u32::from_le_bytes([e, f, g, h]),
    );
    if header > MAX_LENGTH || block > MAX_LENGTH {
        return Err(io::Error::new(
            io::ErrorKind::InvalidData,
            "message too long",
        ));
    }
    Ok((header as usize, block as usize))
}

/// Reads one message; `None` at the end of the stream.
///
/// # Errors
/// When the stream breaks off within a message or the header is not what was expected.
pub fn read<T: DeserializeOwned>(from: &mut impl Read) -> io::Result<Option<(T, Vec<u8>)>> {
    let mut head = [0; 8];
    match from.read_exact(&mut head) {
        Err(e) if e.kind() == io::ErrorKind::UnexpectedEof => return Ok(None),
        other => other?,
    }
    let (header, block) = lengths(head)?;
    let mut header = vec![0; header];
    from.read_exact(&mut header)?;
    let mut bytes = vec![0; block];
    from.read_exact(&mut bytes)?;
    Ok(Some((serde_json::from_slice(&header)?, bytes)))
}

#[cfg(test)]
mod tests {
    use super::{Doing, Message, read, write};

    #[test]
    fn messages_come_back_as_they_went() {
        let doing = |operation: &str| {
            Message::Doing(Doing {
                operation: operation.to_owned(),
                step: Some(2),
                recipe: None,
            })
        };
        let mut bytes = Vec::new();
        write(&mut bytes, &doing("fuse"), b"").unwrap();
        write(&mut bytes, &doing("cut"), b"\x00\xff").unwrap();
        let mut from = bytes.as_slice();
        for (operation, block) in [("fuse", &b""[..]), ("cut", b"\x00\xff")] {
            let (message, bytes) = read::<Message>(&mut from).unwrap().unwrap();
            let Message::Doing(doing) = message else {
                panic!("{message:?}")
            };
            assert_eq!(
                (doing.operation.as_str(), bytes.as_slice()),
                (operation, block)
            );
            assert_eq!(doing.to_string(), format!("operation 3 ({operation})"));
        }
        assert!(read::<Message>(&mut from).unwrap().is_none());
    }

    #[test]
    fn a_message_cut_short_is_an_error() {
        let mut bytes = Vec::new();
        write(&mut bytes, &"x", b"block").unwrap();
        assert!(read::<String>(&mut &bytes[..bytes.len() - 1]).is_err());
        assert!(read::<String>(&mut &[0xff; 8][..]).is_err());
    }
}

//! What the server and its workers say to each other, over a private socket.
//!
//! A message is two little-endian 32-bit lengths, a JSON header of the first length and a block of
//! plain bytes of the second (a file; empty otherwise).

use std::io::{self, Read, Write};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

/// The longest header that is accepted, in bytes.
pub const MAX_HEADER: u32 = 64 << 20;

/// The longest block that is accepted, in bytes: the STEP file of a large assembly.
pub const MAX_BLOCK: u32 = 256 << 20;

/// What a worker answers.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Message<R> {
    /// What the worker is about to do, said before it does it: the last of these names the culprit
    /// when the worker dies.
    Doing(Doing),
    /// The work is done.
    Done(R),
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
    /// The work itself cannot be done; the message says why.
    Refused,
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
/// When the header is no JSON or one of the two is too long.
pub fn encode<T: Serialize>(header: &T, block: &[u8]) -> io::Result<Vec<u8>> {
    let header = serde_json::to_vec(header)?;
    let length = |n: usize, most: u32| {
        u32::try_from(n)
            .ok()
            .filter(|n| *n <= most)
            .ok_or_else(too_long)
    };
    let mut bytes = Vec::with_capacity(8 + header.len() + block.len());
    bytes.extend(length(header.len(), MAX_HEADER)?.to_le_bytes());
    bytes.extend(length(block.len(), MAX_BLOCK)?.to_le_bytes());
    bytes.extend(header);
    bytes.extend(block);
    Ok(bytes)
}

/// The two lengths at the head of a message.
///
/// # Errors
/// When one exceeds what is accepted.
pub fn lengths(head: [u8; 8]) -> io::Result<(usize, usize)> {
    let [a, b, c, d, e, f, g, h] = head;
    let (header, block) = (
        u32::from_le_bytes([a, b, c, d]),
        u32::from_le_bytes([e, f, g, h]),
    );
    if header > MAX_HEADER || block > MAX_BLOCK {
        return Err(too_long());
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
    let header = exactly(from, header)?;
    let bytes = exactly(from, block)?;
    Ok(Some((serde_json::from_slice(&header)?, bytes)))
}

/// So many bytes, which take memory as they come: a length is a claim.
fn exactly(from: &mut impl Read, length: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(length as u64).read_to_end(&mut bytes)?;
    if bytes.len() < length {
        return Err(io::ErrorKind::UnexpectedEof.into());
    }
    Ok(bytes)
}

fn too_long() -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, "message too long")
}

#[cfg(test)]
mod tests {
    use super::{Doing, Message, read, write};

    #[test]
    fn messages_come_back_as_they_went() {
        let doing = |operation: &str| {
            Message::<()>::Doing(Doing {
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
            let (message, bytes) = read::<Message<()>>(&mut from).unwrap().unwrap();
            let Message::Doing(doing) = message else {
                panic!("{message:?}")
            };
            assert_eq!(
                (doing.operation.as_str(), bytes.as_slice()),
                (operation, block)
            );
            assert_eq!(doing.to_string(), format!("operation 3 ({operation})"));
        }
        assert!(read::<Message<()>>(&mut from).unwrap().is_none());
    }

    #[test]
    fn a_message_cut_short_is_an_error() {
        let mut bytes = Vec::new();
        write(&mut bytes, &"x", b"block").unwrap();
        assert!(read::<String>(&mut &bytes[..bytes.len() - 1]).is_err());
        assert!(read::<String>(&mut &[0xff; 8][..]).is_err());
    }
}

//! The lines of standard input and output, around the protocol's library.
//!
//! Two things that the library leaves undone are done here. A line that is no message is answered instead
//! of passed over, with its id where that can be read, so that no client waits for ever. And the end of the input is passed on only when no
//! call is running: the library gives running requests five seconds then, but a session piped in from a
//! file ends at once, while its last call may well verify for a minute. Where nobody reads the output any more
//! either, as when a client was killed, the calls end with it.

use std::io;
use std::time::Duration;

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use tokio::io::{
    AsyncBufRead, AsyncBufReadExt, AsyncRead, AsyncWrite, AsyncWriteExt, BufReader, DuplexStream,
    duplex, split,
};
use tokio::sync::mpsc::{Receiver, Sender, channel};
use tokio::task::JoinHandle;

use crate::message::{self, Refusal};
use crate::running::Running;

/// The longest line that is taken, in bytes; the library's own limit.
const MOST: usize = 16 << 20;

/// So much is kept of a line that is longer: enough for the id of a request.
const HEAD: usize = 4 << 10;

/// Bytes on their way between the streams and the library.
const BUFFER: usize = 64 << 10;

/// Between two looks at the running calls; also the time in which a call read last is sure to start.
const PAUSE: Duration = Duration::from_millis(100);

/// What the library reads from and writes to.
pub(crate) type Inner = DuplexStream;

/// Puts the lines of two streams through; gives the library's end, and the task that writes the output,
/// which ends when the library drops its end.
pub(crate) fn around<R, W>(
    input: R,
    output: W,
    running: Running,
    is_read: impl Fn() -> bool + Send + 'static,
) -> (Inner, JoinHandle<io::Result<()>>)
where
    R: AsyncRead + Unpin + Send + 'static,
    W: AsyncWrite + Unpin + Send + 'static,
{
    let (theirs, ours) = duplex(BUFFER);
    let (from_library, to_library) = split(ours);
    let (answers, refusals) = channel(16);
    tokio::spawn(feed(
        BufReader::new(input),
        to_library,
        answers,
        running,
        is_read,
    ));
    let writing = tokio::spawn(drain(BufReader::new(from_library), output, refusals));
    (theirs, writing)
}

/// Whether somebody may still read the standard output: a pipe or a socket whose other end is closed has no
/// reader, and a file always has one.
pub(crate) fn is_read() -> bool {
    let output = rustix::stdio::stdout();
    let mut asked = [PollFd::new(&output, PollFlags::empty())];
    let now = Timespec {
        tv_sec: 0,
        tv_nsec: 0,
    };
    let gone = PollFlags::ERR | PollFlags::HUP | PollFlags::NVAL;
    match poll(&mut asked, Some(&now)) {
        Ok(_) => asked.iter().all(|fd| !fd.revents().intersects(gone)),
        Err(_) => true,
    }
}

/// Passes lines of JSON on and has the others answered.
async fn feed<R, W>(
    mut input: R,
    mut library: W,
    refusals: Sender<String>,
    running: Running,
    is_read: impl Fn() -> bool + Send,
) where
    R: AsyncBufRead + Unpin,
    W: AsyncWrite + Unpin,
{
    loop {
        let refusal = match line(&mut input).await {
            Ok(Line::End) | Err(_) => break,
            Ok(Line::TooLong(head)) => Refusal::too_long(&head, MOST),
            Ok(Line::Whole(bytes)) => {
                if bytes.iter().all(u8::is_ascii_whitespace) {
                    continue;
                }
                match message::check(&bytes) {
                    Err(refusal) => refusal,
                    Ok(()) if library.write_all(&bytes).await.is_err() => break,
                    Ok(()) => continue,
                }
            }
        };
        if refusals.send(refusal.answer()).await.is_err() {
            break;
        }
    }
    loop {
        tokio::time::sleep(PAUSE).await;
        if running.none() {
            break;
        }
        if !is_read() {
            running.stop();
        }
    }
    let _ = library.shutdown().await;
}

/// Writes whole lines, those of the library and the refusals, one after the other.
async fn drain<R, W>(library: R, mut output: W, mut refusals: Receiver<String>) -> io::Result<()>
where
    R: AsyncBufRead + Unpin,
    W: AsyncWrite + Unpin,
{
    let mut lines = library.lines();
    loop {
        let line = tokio::select! {
            line = lines.next_line() => match line? {
                Some(line) => line,
                None => return output.flush().await,
            },
            Some(line) = refusals.recv() => line,
        };
        output.write_all(line.as_bytes()).await?;
        output.write_all(b"\n").await?;
        output.flush().await?;
    }
}

enum Line {
    /// With its end.
    Whole(Vec<u8>),
    /// How it began.
    TooLong(Vec<u8>),
    End,
}

/// The next line; one that is too long is read over, and only its beginning is kept.
async fn line<R: AsyncBufRead + Unpin>(input: &mut R) -> io::Result<Line> {
    let mut bytes = Vec::new();
    let mut too_long = false;
    loop {
        let chunk = input.fill_buf().await?;
        if chunk.is_empty() {
            return Ok(match (too_long, bytes.is_empty()) {
                (true, _) => Line::TooLong(bytes),
                (false, true) => Line::End,
                (false, false) => {
                    bytes.push(b'\n');
                    Line::Whole(bytes)
                }
            });
        }
        let end = chunk.iter().position(|b| *b == b'\n');
        let taken = end.map_or(chunk.len(), |i| i + 1);
        too_long = too_long || bytes.len() + taken > MOST;
        if too_long {
            bytes.truncate(HEAD);
        } else {
            bytes.extend(chunk.iter().take(taken));
        }
        input.consume(taken);
        if end.is_some() {
            return Ok(if too_long {
                Line::TooLong(bytes)
            } else {
                Line::Whole(bytes)
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::around;
    use crate::running::Running;
    use tokio::io::{AsyncBufReadExt, AsyncReadExt, AsyncWriteExt, BufReader, duplex};

    #[tokio::test]
    async fn what_is_no_json_is_answered_and_the_rest_passed_on() {
        let long = vec![b'1'; super::MOST + 1];
        let mut input =
            b"{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"m\"}\n\nnonsense\n{\"b\": NaN}\n".to_vec();
        input.extend(&long);
        input.extend(b"\n{\"jsonrpc\":\"2.0\",\"method\":\"n\"}");
        let (theirs, ours) = duplex(1 << 16);
        let (library, writing) =
            around(std::io::Cursor::new(input), theirs, Running::new(1), || {
                true
            });
        let mut library = BufReader::new(library).lines();
        assert_eq!(
            library.next_line().await.unwrap().unwrap(),
            "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"m\"}"
        );
        let mut answers = BufReader::new(ours).lines();
        for told in ["column 2", "column 7", "longer than"] {
            let answer = answers.next_line().await.unwrap().unwrap();
            let answer: serde_json::Value = serde_json::from_str(&answer).unwrap();
            assert_eq!(answer["error"]["code"], -32700);
            assert!(
                answer["error"]["message"].as_str().unwrap().contains(told),
                "{answer}"
            );
        }
        assert_eq!(
            library.next_line().await.unwrap().unwrap(),
            "{\"jsonrpc\":\"2.0\",\"method\":\"n\"}"
        );
        assert_eq!(library.next_line().await.unwrap(), None);
        drop(library);
        writing.await.unwrap().unwrap();
    }

    #[tokio::test(start_paused = true)]
    async fn the_end_waits_for_the_last_call() {
        let running = Running::new(1);
        let call = running.start();
        let (theirs, _ours) = duplex(64);
        let line = &b"{\"jsonrpc\":\"2.0\",\"method\":\"n\"}\n"[..];
        let (mut library, _writing) = around(line, theirs, running, || true);
        let mut bytes = [0; 64];
        assert_eq!(library.read(&mut bytes).await.unwrap(), line.len());
        let end = tokio::spawn(async move { library.read(&mut bytes).await.unwrap() });
        tokio::time::sleep(std::time::Duration::from_secs(60)).await;
        assert!(!end.is_finished());
        drop(call);
        assert_eq!(end.await.unwrap(), 0);
    }

    #[tokio::test(start_paused = true)]
    async fn where_nobody_reads_the_calls_end_with_the_input() {
        let running = Running::new(1);
        let call = running.start();
        let (theirs, _ours) = duplex(64);
        let (_library, _writing) = around(&b""[..], theirs, running.clone(), || false);
        let minute = std::time::Duration::from_secs(60);
        tokio::time::timeout(minute, running.stopped())
            .await
            .unwrap();
        drop(call);
    }

    #[tokio::test]
    async fn answers_come_out_as_they_went_in() {
        let (theirs, ours) = duplex(1 << 16);
        let (mut library, writing) = around(&b""[..], theirs, Running::new(1), || true);
        library.write_all(b"{\"x\":1}\n{\"y\":2}\n").await.unwrap();
        drop(library);
        writing.await.unwrap().unwrap();
        let mut text = String::new();
        BufReader::new(ours)
            .read_to_string(&mut text)
            .await
            .unwrap();
        assert_eq!(text, "{\"x\":1}\n{\"y\":2}\n");
    }
}

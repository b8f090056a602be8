//! Standard input whose end waits for the answers.
//!
//! The protocol library gives running requests five seconds after the end of its input. A session
//! that is piped in from a file ends at once, while its last call may well verify for a minute: so
//! the end is passed on only when no call is running.

use std::io;
use std::pin::Pin;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::task::{Context, Poll};
use std::time::Duration;

use tokio::io::{AsyncRead, ReadBuf};
use tokio::time::{Sleep, sleep};

/// How many calls are running.
#[derive(Debug, Clone, Default)]
pub(crate) struct Running(Arc<AtomicUsize>);

/// A running call, until dropped.
#[derive(Debug)]
pub(crate) struct Call(Running);

impl Running {
    pub(crate) fn start(&self) -> Call {
        self.0.fetch_add(1, Ordering::SeqCst);
        Call(self.clone())
    }
}

impl Drop for Call {
    fn drop(&mut self) {
        self.0.0.fetch_sub(1, Ordering::SeqCst);
    }
}

/// A reader that holds back its end while calls are running.
#[derive(Debug)]
pub(crate) struct PatientReader<R> {
    inner: R,
    running: Running,
    waiting: Option<Pin<Box<Sleep>>>,
}

/// Between two looks at the running calls; also the time in which a call read last is sure to start.
const PAUSE: Duration = Duration::from_millis(100);

impl<R> PatientReader<R> {
    pub(crate) fn new(inner: R, running: Running) -> Self {
        Self {
            inner,
            running,
            waiting: None,
        }
    }
}

impl<R: AsyncRead + Unpin> AsyncRead for PatientReader<R> {
    fn poll_read(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        buf: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        if self.waiting.is_none() {
            let before = buf.filled().len();
            match Pin::new(&mut self.inner).poll_read(cx, buf) {
                Poll::Ready(Ok(())) if buf.filled().len() == before => {
                    self.waiting = Some(Box::pin(sleep(PAUSE)));
                }
                other => return other,
            }
        }
        loop {
            let Some(pause) = self.waiting.as_mut() else {
                return Poll::Ready(Ok(()));
            };
            if pause.as_mut().poll(cx).is_pending() {
                return Poll::Pending;
            }
            if self.running.0.load(Ordering::SeqCst) == 0 {
                return Poll::Ready(Ok(()));
            }
            self.waiting = Some(Box::pin(sleep(PAUSE)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{PatientReader, Running};
    use tokio::io::AsyncReadExt;

    #[tokio::test(start_paused = true)]
    async fn the_end_waits_for_the_last_call() {
        let running = Running::default();
        let call = running.start();
        let mut reader = PatientReader::new(&b"abc"[..], running);
        let mut bytes = [0; 8];
        assert_eq!(reader.read(&mut bytes).await.unwrap(), 3);
        let end = tokio::spawn(async move { reader.read(&mut bytes).await.unwrap() });
        tokio::time::sleep(std::time::Duration::from_secs(60)).await;
        assert!(!end.is_finished());
        drop(call);
        assert_eq!(end.await.unwrap(), 0);
    }
}

//! Whose turn it is at the kernel processes.

use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};

use tokio::sync::oneshot;

/// How soon a job has its turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Urgency {
    /// Before all that are in no hurry.
    First,
    /// In the order of arrival.
    Usual,
}

/// As many turns at once as there are processes; who is in a hurry goes first.
#[derive(Debug)]
pub(crate) struct Gate {
    line: Mutex<Line>,
}

#[derive(Debug)]
struct Line {
    free: usize,
    first: VecDeque<oneshot::Sender<()>>,
    usual: VecDeque<oneshot::Sender<()>>,
}

/// A turn; the next one's begins where it is dropped.
#[derive(Debug)]
pub(crate) struct Turn<'a>(&'a Gate);

/// A place in the line, which gives back the turn that came to it after nobody waited any more.
struct Waiting<'a> {
    gate: &'a Gate,
    turn: oneshot::Receiver<()>,
}

impl Gate {
    pub(crate) fn new(turns: usize) -> Self {
        Self {
            line: Mutex::new(Line {
                free: turns.max(1),
                first: VecDeque::new(),
                usual: VecDeque::new(),
            }),
        }
    }

    /// Waits for a turn. Whoever stops waiting leaves the line.
    pub(crate) async fn turn(&self, urgency: Urgency) -> Turn<'_> {
        let waiting = {
            let mut line = self.lock();
            if line.free > 0 {
                line.free -= 1;
                return Turn(self);
            }
            let (give, turn) = oneshot::channel();
            match urgency {
                Urgency::First => line.first.push_back(give),
                Urgency::Usual => line.usual.push_back(give),
            }
            Waiting { gate: self, turn }
        };
        waiting.come().await
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Line> {
        self.line.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn next(&self) {
        let mut line = self.lock();
        while let Some(next) = line.first.pop_front().or_else(|| line.usual.pop_front()) {
            // Who has left the line takes no turn.
            if next.send(()).is_ok() {
                return;
            }
        }
        line.free += 1;
    }
}

impl<'a> Waiting<'a> {
    async fn come(mut self) -> Turn<'a> {
        // The sender is dropped only with the gate, which is still borrowed.
        let _ = (&mut self.turn).await;
        Turn(self.gate)
    }
}

impl Drop for Waiting<'_> {
    fn drop(&mut self) {
        // Closed first, so that no turn comes afterwards.
        self.turn.close();
        if self.turn.try_recv().is_ok() {
            self.gate.next();
        }
    }
}

impl Drop for Turn<'_> {
    fn drop(&mut self) {
        self.0.next();
    }
}

#[cfg(test)]
mod tests {
    use super::{Gate, Urgency};
    use std::sync::Arc;
    use std::sync::Mutex;

    #[tokio::test]
    async fn who_is_in_a_hurry_goes_first_and_who_leaves_takes_no_turn() {
        let gate = Arc::new(Gate::new(1));
        let order = Arc::new(Mutex::new(Vec::new()));
        let held = gate.turn(Urgency::Usual).await;
        let mut waiting = Vec::new();
        for (name, urgency) in [
            ("leaves", Urgency::First),
            ("usual", Urgency::Usual),
            ("second", Urgency::Usual),
            ("first", Urgency::First),
        ] {
            let (gate, order) = (Arc::clone(&gate), Arc::clone(&order));
            waiting.push(tokio::spawn(async move {
                let _turn = gate.turn(urgency).await;
                order.lock().unwrap().push(name);
            }));
            tokio::task::yield_now().await;
        }
        waiting.remove(0).abort();
        tokio::task::yield_now().await;
        drop(held);
        for task in waiting {
            task.await.unwrap();
        }
        assert_eq!(*order.lock().unwrap(), ["first", "usual", "second"]);
        // All turns were given back.
        let again =
            tokio::time::timeout(std::time::Duration::from_secs(5), gate.turn(Urgency::Usual));
        assert!(again.await.is_ok());
    }
}

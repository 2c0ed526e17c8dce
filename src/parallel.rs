//! Work that all threads share.
//!
//! The iterators of rayon are compiled anew for each use, about 10 kB of code each time. The functions here ask rayon
//! for one thing alone: to run a function on each thread.
//!
//! A thread that waits here for other threads may meanwhile be given any other piece of work. So call no function of
//! this module while holding a lock, or filling a `OnceLock`, that another piece of work may want: the thread would
//! wait for itself.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

/// The results of `work` for each of `0..count`, in order.
pub fn map<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    map_with(count, || (), |(), i| work(i))
}

/// Starts a pool of `threads` threads for the rest of the process; 0 is one for each processor. The calling thread is
/// one of them. It works while it waits and begins at once, whereas threads that must be woken may share a core for
/// some milliseconds. A thread can do this only once. Fails if the system cannot start the threads; the calling thread
/// then does all the work.
pub fn take_part(threads: usize) -> Result<(), rayon::ThreadPoolBuildError> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    // Dropping the pool would end its threads.
    pool.use_current_thread().build().map(std::mem::forget)
}

/// The number of threads. Unless [`take_part`] has started them, they start when this function is first called, which
/// takes longer than reading a short scene.
pub fn threads() -> usize {
    rayon::current_num_threads()
}

/// The number of parts into which to split a text: one per thread, but none shorter than [`PART_MIN`].
pub fn parts(bytes: usize) -> usize {
    at_most(bytes / PART_MIN)
}

/// The number of threads that work on this many pieces: at least one, and no more than there are pieces. For one piece
/// the number of available threads is not asked for, since asking may start the threads.
fn at_most(pieces: usize) -> usize {
    match pieces {
        0 | 1 => 1,
        _ => threads().min(pieces),
    }
}

/// The least length of a part of a text, in bytes. A shorter part takes less time than waking up a thread for it.
const PART_MIN: usize = 1 << 18;

/// The results of two pieces of work, done at the same time where a thread is free.
pub fn both<A: Send, B: Send>(
    a: impl FnOnce() -> A + Send,
    b: impl FnOnce() -> B + Send,
) -> (A, B) {
    rayon::join(a, b)
}

/// [`map`], with a state that `work` may change. Each thread that takes part makes one.
pub fn map_with<S, T: Send>(
    count: usize,
    state: impl Fn() -> S + Sync,
    work: impl Fn(&mut S, usize) -> T + Sync,
) -> Vec<T> {
    let threads = at_most(count);
    if threads == 1 {
        let mut state = state();
        return (0..count).map(|i| work(&mut state, i)).collect();
    }
    // A thread that is free takes the next share. There are so few shares that taking one costs nothing, and so many
    // that no thread waits long for the last one.
    let size = (count / (512 * threads)).max(1);
    let shares: Vec<Mutex<Vec<T>>> = (0..count.div_ceil(size))
        .map(|_| Mutex::default())
        .collect();
    let next = AtomicUsize::new(0);
    on_each_thread(threads, &|| {
        let mut state = state();
        loop {
            let share = next.fetch_add(1, Ordering::Relaxed);
            let Some(slot) = shares.get(share) else {
                return;
            };
            let range = share * size..count.min((share + 1) * size);
            let done = range.map(|i| work(&mut state, i)).collect();
            *slot.lock().unwrap_or_else(|e| e.into_inner()) = done;
        }
    });
    let mut all = Vec::with_capacity(count);
    for share in shares {
        all.append(&mut share.into_inner().unwrap_or_else(|e| e.into_inner()));
    }
    all
}

/// The results of `work` for each of the items, in order.
pub fn map_each<I: Send, T: Send>(items: Vec<I>, work: impl Fn(I) -> T + Sync) -> Vec<T> {
    map_each_with(items, || (), |(), item| work(item))
}

/// [`map_each`], with a state that `work` may change. Each thread that takes part makes one.
pub fn map_each_with<S, I: Send, T: Send>(
    items: Vec<I>,
    state: impl Fn() -> S + Sync,
    work: impl Fn(&mut S, I) -> T + Sync,
) -> Vec<T> {
    let items: Vec<Mutex<Option<I>>> = items.into_iter().map(|i| Mutex::new(Some(i))).collect();
    let take = |i: usize| items[i].lock().ok().and_then(|mut item| item.take());
    // Each item is taken once.
    let made = map_with(items.len(), state, |state, i| {
        take(i).map(|item| work(state, item))
    });
    made.into_iter().flatten().collect()
}

/// Runs `work` `threads` times, at the same time as far as threads are free.
fn on_each_thread(threads: usize, work: &(dyn Fn() + Sync)) {
    let each = (0..threads).into_par_iter().with_max_len(1);
    each.for_each(|_| work());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_order() {
        for count in [0, 1, 2, 3, 1000, 5000, 100_001] {
            let squares = map(count, |i| i * i);
            assert!(squares.into_iter().eq((0..count).map(|i| i * i)));
        }
    }

    #[test]
    fn a_state_belongs_to_one_thread() {
        let states = AtomicUsize::new(0);
        let new = || states.fetch_add(1, Ordering::Relaxed);
        let calls = map_with(
            10_000,
            || (new(), 0),
            |state, _| {
                state.1 += 1;
                *state
            },
        );
        // Each state counts its calls without a gap.
        for state in 0..states.into_inner() {
            let of = calls.iter().filter(|(s, _)| *s == state);
            assert!(
                of.map(|(_, n)| *n)
                    .eq(1..=calls.iter().filter(|(s, _)| *s == state).count())
            );
        }
    }

    #[test]
    #[should_panic(expected = "the seventh")]
    fn a_panic_reaches_the_caller() {
        map(100, |i| assert_ne!(i, 7, "the seventh"));
    }
}

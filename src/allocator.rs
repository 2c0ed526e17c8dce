//! What the allocator does with memory that is freed.

/// Has the allocator keep freed pieces of up to so many bytes for whoever asks next. New memory from the system takes up to
/// a quarter of the time of reading a scene.
///
/// The allocator of glibc gives memory back above a threshold. Freeing a large piece, of at most 32 MiB, raises the
/// threshold to twice the size of the piece (mallopt(3), `M_MMAP_THRESHOLD`). The piece is never written to, so it takes
/// no memory itself. Nothing changes with other allocators.
pub fn keep(bytes: usize) {
    drop(std::hint::black_box(Vec::<u8>::with_capacity(bytes)));
}

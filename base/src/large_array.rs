//! Memory for large arrays, in huge pages where the system offers them.
//!
//! A fresh array of hundreds of megabytes costs more in page faults than in
//! writing: with pages of 2 MiB instead of 4 KiB the red split takes a half to
//! a third of the time.

use bytemuck::Zeroable;

/// Arrays below this size stay in ordinary pages.
const LARGE: usize = 4 << 20;

/// `len` default values, for types whose default is all zeros in memory
/// untouched until they are first written; so threads that fill their parts
/// also place them.
pub fn zeroed<T: Copy + Default>(len: usize) -> Vec<T> {
    filled(T::default(), len)
}

/// `len` copies of a value; as [`zeroed`] if it is all zeros in memory.
pub fn filled<T: Copy>(value: T, len: usize) -> Vec<T> {
    let array = vec![value; len];
    advise(&array);
    array
}

/// `len` default values of a type that cannot be copied.
pub fn defaults<T: Default>(len: usize) -> Vec<T> {
    let mut array = Vec::with_capacity(len);
    advise(array.spare_capacity_mut());
    array.resize_with(len, T::default);
    array
}

/// `len` values of all zero bits, as [`zeroed`], of a type that cannot be copied.
pub fn zeros<T: Zeroable>(len: usize) -> Vec<T> {
    let array = bytemuck::zeroed_vec(len);
    advise(&array);
    array
}

#[cfg(target_os = "linux")]
fn advise<T>(array: &[T]) {
    // The kernel takes huge pages inside the range only; its start must be the
    // start of a page.
    const PAGE: usize = 4096;
    let bytes = size_of_val(array);
    if bytes < LARGE {
        return;
    }
    let start = array.as_ptr() as usize;
    let aligned = start.next_multiple_of(PAGE);
    let length = (start + bytes - aligned) / PAGE * PAGE;
    // SAFETY: the range lies inside the array, which outlives the call, and this
    // advice changes neither contents nor access rights, only the size of the
    // pages behind it. A refusal (old kernel, feature off) is harmless: ignored.
    unsafe {
        libc::madvise(aligned as *mut libc::c_void, length, libc::MADV_HUGEPAGE);
    }
}

#[cfg(not(target_os = "linux"))]
fn advise<T>(_array: &[T]) {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_of_any_size_are_zero_and_writable() {
        for len in [0, 1, LARGE / 16 - 1, LARGE / 16, LARGE / 4 + 3] {
            let mut array: Vec<[u32; 4]> = zeroed(len);
            assert!(array.len() == len && array.iter().all(|v| *v == [0; 4]));
            array.iter_mut().for_each(|v| *v = [1, 2, 3, 4]);
            array.push([5; 4]);
            assert!(array[..len].iter().all(|v| *v == [1, 2, 3, 4]));
            let mut array: Vec<[std::sync::atomic::AtomicU32; 4]> = zeros(len);
            assert!(array.len() == len && array.iter_mut().flatten().all(|v| *v.get_mut() == 0));
        }
    }
}

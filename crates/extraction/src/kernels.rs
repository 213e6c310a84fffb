//! The facing of 64 faces in one word, for each instruction set, and the choice between them at run time.
//!
//! All kernels do the same arithmetic on integers, so their answers are the same bits.

use crate::patches::planes::{GROUP, PlaneBlock, PlaneTest};
use pulp::{Arch, NullaryFnOnce};
use wide::{i16x8, i32x4};

/// What differs between instruction sets. Methods are inlined into [`KernelTask::run`], which is compiled for each set.
pub(crate) trait Kernel: Copy {
    /// Bits of the faces whose value exceeds `bound`, and bits of those whose value is below `-bound`.
    fn front_and_back(self, test: &PlaneTest, planes: &PlaneBlock) -> [u64; 2];

    /// Asks for the cache line of something that will be read soon, without waiting for it.
    fn prefetch<T>(self, place: &T);
}

/// Work that is compiled for each instruction set.
pub(crate) trait KernelTask {
    fn run<K: Kernel>(self, kernel: K);
}

/// Runs `task` with the widest instructions of this processor.
#[inline(always)]
pub(crate) fn dispatch(arch: Arch, task: impl KernelTask) {
    match arch {
        #[cfg(target_arch = "x86_64")]
        Arch::V4(v4) => v4.vectorize(Compiled { kernel: v4, task }),
        #[cfg(target_arch = "x86_64")]
        Arch::V3(v3) => v3.vectorize(Compiled { kernel: v3, task }),
        _ => task.run(Baseline),
    }
}

/// A task with its kernel. A value, not a closure: closures of this size are not inlined into the function that `pulp`
/// compiles for an instruction set, and would run at the baseline.
struct Compiled<K, T> {
    kernel: K,
    task: T,
}

impl<K: Kernel, T: KernelTask> NullaryFnOnce for Compiled<K, T> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.task.run(self.kernel);
    }
}

/// What the compiler may use on every processor of the target: SSE2 on `x86_64`, NEON on `aarch64`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Baseline;

impl Kernel for Baseline {
    #[inline(always)]
    fn front_and_back(self, test: &PlaneTest, planes: &PlaneBlock) -> [u64; 2] {
        let [first, second] = [&test.first, &test.second].map(|pairs| i16x8::from_slice_unaligned(&pairs[..8]));
        let (high, low) = (i32x4::splat(test.bound), i32x4::splat(-test.bound));
        let (mut front, mut back) = (0, 0);
        for (group, [xy, zd]) in planes.groups().iter().enumerate() {
            for (quad, (xy, zd)) in xy.chunks_exact(8).zip(zd.chunks_exact(8)).enumerate() {
                let value = i16x8::from_slice_unaligned(xy).dot(first) + i16x8::from_slice_unaligned(zd).dot(second);
                front |= u64::from(value.simd_gt(high).to_bitmask()) << (GROUP * group + 4 * quad);
                back |= u64::from(value.simd_lt(low).to_bitmask()) << (GROUP * group + 4 * quad);
            }
        }
        [front, back]
    }

    #[inline(always)]
    fn prefetch<T>(self, _place: &T) {}
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::*;
    use pulp::bytemuck::cast;
    use pulp::x86::{V3, V4};
    use std::arch::x86_64::_MM_HINT_T0;

    impl Kernel for V3 {
        #[inline(always)]
        fn front_and_back(self, test: &PlaneTest, planes: &PlaneBlock) -> [u64; 2] {
            let half = |pairs: &[i16; 2 * GROUP], half: usize| -> pulp::i16x16 {
                let [low, high]: [[i16; GROUP]; 2] = cast(*pairs);
                cast(if half == 0 { low } else { high })
            };
            let (first, second) = (half(&test.first, 0), half(&test.second, 0));
            let (high, low) = (self.splat_i32x8(test.bound), self.splat_i32x8(-test.bound));
            let mask = |lanes: pulp::m32x8| u64::from(self.avx._mm256_movemask_ps(cast(lanes)) as u8);
            let (mut front, mut back) = (0, 0);
            for (group, [xy, zd]) in planes.groups().iter().enumerate() {
                for part in 0..2 {
                    let value = self.wrapping_add_i32x8(
                        self.multiply_wrapping_add_adjacent_i16x16(half(xy, part), first),
                        self.multiply_wrapping_add_adjacent_i16x16(half(zd, part), second),
                    );
                    front |= mask(self.cmp_gt_i32x8(value, high)) << (GROUP * group + 8 * part);
                    back |= mask(self.cmp_lt_i32x8(value, low)) << (GROUP * group + 8 * part);
                }
            }
            [front, back]
        }

        #[inline(always)]
        fn prefetch<T>(self, place: &T) {
            self.sse._mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(place).cast());
        }
    }

    impl Kernel for V4 {
        #[inline(always)]
        fn front_and_back(self, test: &PlaneTest, planes: &PlaneBlock) -> [u64; 2] {
            let (first, second) = (cast(test.first), cast(test.second));
            let (high, low) = (self.splat_i32x16(test.bound), self.splat_i32x16(-test.bound));
            let (mut front, mut back) = (0, 0);
            for (group, &[xy, zd]) in planes.groups().iter().enumerate() {
                let value = self.wrapping_add_i32x16(
                    self.multiply_wrapping_add_adjacent_i16x32(cast(xy), first),
                    self.multiply_wrapping_add_adjacent_i16x32(cast(zd), second),
                );
                front |= u64::from(self.cmp_gt_i32x16(value, high).0) << (GROUP * group);
                back |= u64::from(self.cmp_lt_i32x16(value, low).0) << (GROUP * group);
            }
            [front, back]
        }

        #[inline(always)]
        fn prefetch<T>(self, place: &T) {
            self.sse._mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(place).cast());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::patches::planes::{Frame, LANES};
    use proptest::prelude::*;
    use silhouette_core::Viewpoint;
    use silhouette_core::glam::Vec3;

    struct Answer<'a> {
        test: &'a PlaneTest,
        planes: &'a PlaneBlock,
        into: &'a mut Vec<[u64; 2]>,
    }

    impl KernelTask for Answer<'_> {
        fn run<K: Kernel>(self, kernel: K) {
            self.into.push(kernel.front_and_back(self.test, self.planes));
        }
    }

    /// What every kernel that this processor can run answers, the baseline last.
    fn answers(test: &PlaneTest, planes: &PlaneBlock) -> Vec<[u64; 2]> {
        let mut answers = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            let sets = [pulp::x86::V4::try_new().map(Arch::V4), pulp::x86::V3::try_new().map(Arch::V3)];
            for arch in sets.into_iter().flatten() {
                dispatch(arch, Answer { test, planes, into: &mut answers });
            }
        }
        answers.push(Baseline.front_and_back(test, planes));
        answers
    }

    proptest! {
        #[test]
        fn all_instruction_sets_agree_with_plain_sums(
            numbers in prop::collection::vec(prop::array::uniform4(-23_000_i16..=23_000), LANES),
            eye in prop::array::uniform3(-3.0_f32..3.0),
        ) {
            let viewpoint = Viewpoint::Perspective { eye: Vec3::from(eye) };
            let frame = Frame::of(Vec3::splat(-1.0), Vec3::splat(1.0));
            let test = PlaneTest::new(&viewpoint, &frame);
            let mut planes = PlaneBlock::default();
            let mut expected = [0_u64; 2];
            for (lane, &plane) in numbers.iter().enumerate() {
                planes.set(lane, plane);
                let eye = [test.first[0], test.first[1], test.second[0], test.second[1]];
                let value: i32 = plane.iter().zip(eye).map(|(&n, x)| i32::from(n) * i32::from(x)).sum();
                expected[0] |= u64::from(value > test.bound) << lane;
                expected[1] |= u64::from(value < -test.bound) << lane;
            }
            for answer in answers(&test, &planes) {
                prop_assert_eq!(answer, expected);
            }
        }
    }
}

//! The hierarchy of `cluster-cones`: bounds over the planes of patches, of 8 patches, of 64, and so on.
//!
//! - [`bound`]: one bound, and the proof that it holds.
//! - [`ConeTree`]: eight bounds side by side, tested by one pass of vector instructions, level by level.

mod bound;

use crate::kernels::{Kernel, KernelTask, dispatch};
use crate::patches::order::FAN_OUT;
use crate::patches::planes::{Frame, homogeneous, unit_normal};
use crate::patches::{PatchLayout, PatchPlanes};
use bound::{EVALUATION_ERROR, PlaneBound, Side};
use pulp::Arch;
use rayon::prelude::*;
use silhouette_core::{Cancelled, Progress, TriangleMesh, Viewpoint};
use wide::f32x8;

/// Patches between two checks for cancellation: about 5 ms.
const PATCHES_PER_CHECK: usize = 1024;

/// Bounds of up to eight siblings.
#[derive(Debug, Clone)]
struct Siblings {
    anchor: [f32x8; 3],
    normal: [f32x8; 3],
    radius: f32x8,
    low: f32x8,
    high: f32x8,
    /// A bit for each sibling that exists.
    exist: u32,
}

impl Siblings {
    fn new(bounds: &[PlaneBound]) -> Self {
        let lane = |value: fn(&PlaneBound) -> f32| {
            f32x8::new(std::array::from_fn(|index| bounds.get(index).map_or(0.0, value)))
        };
        Self {
            anchor: [lane(|b| b.anchor[0]), lane(|b| b.anchor[1]), lane(|b| b.anchor[2])],
            normal: [lane(|b| b.normal[0]), lane(|b| b.normal[1]), lane(|b| b.normal[2])],
            radius: lane(|b| b.radius),
            low: lane(|b| b.low),
            high: lane(|b| b.high),
            exist: (1 << bounds.len()) - 1,
        }
    }

    /// Asks for all cache lines of these bounds.
    #[inline(always)]
    fn prefetch<K: Kernel>(&self, kernel: K) {
        for numbers in [&self.anchor[0], &self.anchor[2], &self.normal[1], &self.radius, &self.high] {
            kernel.prefetch(numbers);
        }
    }

    /// A bit for each sibling that `view` may see faces of both facings in. A comparison with NaN (an infinite offset
    /// from infinitely far) is false and so leaves the sibling in.
    #[inline(always)]
    fn mixed(&self, view: &View) -> u32 {
        let [x, y, z] = [0, 1, 2].map(|axis| view.direction[axis] - view.weight * self.anchor[axis]);
        let along = self.normal[0] * x + self.normal[1] * y + self.normal[2] * z;
        let reach = self.radius * (x * x + y * y + z * z).sqrt();
        let front = (along + view.weight * self.low - reach).simd_gt(f32x8::splat(EVALUATION_ERROR));
        let back = (along + view.weight * self.high + reach).simd_lt(f32x8::splat(-EVALUATION_ERROR));
        self.exist & !(front | back).to_bitmask()
    }
}

/// The homogeneous viewpoint, in every lane.
struct View {
    direction: [f32x8; 3],
    weight: f32x8,
}

/// Bounds of all patches and of aligned runs of 8, 64 ... of them.
#[derive(Debug)]
pub(crate) struct ConeTree {
    /// From the leaves up; the last level is one group.
    levels: Vec<Vec<Siblings>>,
    patches: usize,
}

impl ConeTree {
    /// Bounds all patches. O(F), parallel; the same bits for any number of threads.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub(crate) fn new(
        mesh: &TriangleMesh,
        layout: &PatchLayout,
        planes: &PatchPlanes,
        progress: &dyn Progress,
    ) -> Result<Self, Cancelled> {
        let mut bounds: Vec<PlaneBound> = (0..layout.len())
            .into_par_iter()
            .map(|patch| {
                if patch % PATCHES_PER_CHECK == 0 {
                    progress.check()?;
                }
                let sides: Vec<Side> = (0..64_usize)
                    .filter(|lane| layout.head(patch).used >> lane & 1 == 1)
                    .map(|lane| match planes.open[patch] >> lane & 1 {
                        0 => Side::AlwaysBack,
                        _ => side(mesh, layout.lanes(patch)[lane], planes.frame()),
                    })
                    .collect();
                Ok(PlaneBound::of(&sides))
            })
            .collect::<Result<_, _>>()?;
        let mut levels = Vec::new();
        while !bounds.is_empty() {
            levels.push(bounds.par_chunks(FAN_OUT).map(Siblings::new).collect());
            if bounds.len() <= FAN_OUT {
                break;
            }
            bounds = bounds.par_chunks(FAN_OUT).map(PlaneBound::union).collect();
        }
        Ok(Self { levels, patches: layout.len() })
    }

    /// Replaces `mixed` by the patches, ascending, that may have faces of both facings; yields the number of nodes
    /// looked at. O(result log P), no allocation once memory has grown.
    pub(crate) fn mixed_patches(
        &self,
        viewpoint: &Viewpoint,
        frame: &Frame,
        queue: &mut Vec<u32>,
        mixed: &mut Vec<u32>,
    ) -> u64 {
        mixed.clear();
        let Some(point) = homogeneous(viewpoint, frame) else {
            mixed.extend(0..self.patches as u32);
            return 0;
        };
        let point = point.as_vec4();
        let view = View { direction: [point.x, point.y, point.z].map(f32x8::splat), weight: f32x8::splat(point.w) };
        let mut descent = Descent { tree: self, view, queue, mixed, nodes: 0 };
        dispatch(Arch::new(), &mut descent);
        descent.nodes
    }

    pub(crate) fn bytes(&self) -> usize {
        self.levels.iter().map(|level| size_of_val(level.as_slice())).sum()
    }
}

/// One view's way down the tree.
struct Descent<'a> {
    tree: &'a ConeTree,
    view: View,
    queue: &'a mut Vec<u32>,
    mixed: &'a mut Vec<u32>,
    nodes: u64,
}

/// How many groups before its own turn a group is asked for.
const GROUPS_AHEAD: usize = 8;

impl KernelTask for &mut Descent<'_> {
    #[inline(always)]
    fn run<K: Kernel>(self, kernel: K) {
        let Descent { tree, view, queue, mixed, nodes } = self;
        // `mixed` holds the groups to look at on this level; at the top there is one.
        mixed.extend((!tree.levels.is_empty()).then_some(0));
        for level in tree.levels.iter().rev() {
            std::mem::swap(*queue, *mixed);
            mixed.clear();
            for (index, &group) in queue.iter().enumerate() {
                if let Some(&ahead) = queue.get(index + GROUPS_AHEAD) {
                    level[ahead as usize].prefetch(kernel);
                }
                let siblings = &level[group as usize];
                *nodes += u64::from(siblings.exist.count_ones());
                let mut bits = siblings.mixed(view);
                while bits != 0 {
                    mixed.push(group * FAN_OUT as u32 + bits.trailing_zeros());
                    bits &= bits - 1;
                }
            }
        }
    }
}

/// What is known of a face's plane.
fn side(mesh: &TriangleMesh, face: u32, frame: &Frame) -> Side {
    let corners = mesh.triangles()[face as usize].map(|vertex| mesh.positions()[vertex as usize]);
    unit_normal(corners).map_or(Side::Unknown, |normal| Side::Plane { normal, point: frame.local(corners[0]) })
}

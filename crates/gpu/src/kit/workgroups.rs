//! [`workgroups`]: how many to dispatch. Twin of `shaders/shared/invocation.wgsl`.

/// Invocations per workgroup of the stages that import `shared/invocation.wgsl`.
pub const WORKGROUP: u32 = 64;

/// Most workgroups per row; WebGPU guarantees 65 535 along each axis.
const LONGEST_ROW: u32 = 32_768;

/// Workgroups along x and y with at least one invocation per element, as few rows as possible. Rows are full, so that the last one
/// may exceed the elements by up to a row: stages compare their element with the count.
pub fn workgroups(elements: u32) -> [u32; 2] {
    let all = elements.div_ceil(WORKGROUP);
    [all.min(LONGEST_ROW), all.div_ceil(LONGEST_ROW)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn workgroups_cover_every_element() {
        for elements in [0, 1, 64, 65, 2_097_152, 2_097_153, u32::MAX] {
            let [x, y] = workgroups(elements);
            assert!(u64::from(x) * u64::from(y) * u64::from(WORKGROUP) >= u64::from(elements));
            assert!(x <= LONGEST_ROW && y <= LONGEST_ROW);
            assert!(u64::from(x) * u64::from(y.saturating_sub(1)) * u64::from(WORKGROUP) <= u64::from(elements));
        }
    }
}

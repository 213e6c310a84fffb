//! Struct layouts as naga computes them, to compare with the Rust structs that are uploaded.

use naga::{AddressSpace, Handle, Module, Type, TypeInner};

/// Size and member offsets of one WGSL struct, in bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StructLayout {
    /// Size of the struct.
    pub size: u32,
    /// Name and offset of every member, in order.
    pub members: Vec<(String, u32)>,
    /// Whether a uniform or storage variable holds the struct, itself or as a member, so that its offsets matter.
    pub is_bound: bool,
}

/// Layout of the struct `name` in `wgsl`; `None` where the text does not parse or holds no such struct.
pub fn struct_layout(wgsl: &str, name: &str) -> Option<StructLayout> {
    let module = naga::front::wgsl::parse_str(wgsl).ok()?;
    let (handle, found) = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(name))?;
    let TypeInner::Struct { members, span } = &found.inner else { return None };
    let is_bound = module.global_variables.iter().any(|(_, variable)| {
        matches!(variable.space, AddressSpace::Uniform | AddressSpace::Storage { .. })
            && holds(&module, variable.ty, handle)
    });
    let members = members.iter().map(|member| (member.name.clone().unwrap_or_default(), member.offset)).collect();
    Some(StructLayout { size: *span, members, is_bound })
}

/// Whether a value of type `ty` is or contains a `wanted`.
fn holds(module: &Module, ty: Handle<Type>, wanted: Handle<Type>) -> bool {
    ty == wanted
        || match &module.types[ty].inner {
            TypeInner::Struct { members, .. } => members.iter().any(|member| holds(module, member.ty, wanted)),
            TypeInner::Array { base, .. } => holds(module, *base, wanted),
            _ => false,
        }
}

/// Whether the struct `name` in `wgsl` is bound and has this size and these members, in this order.
pub fn matches(wgsl: &str, name: &str, size: usize, members: &[(&str, usize)]) -> bool {
    struct_layout(wgsl, name).is_some_and(|layout| {
        layout.is_bound
            && layout.size as usize == size
            && layout.members.len() == members.len()
            && layout
                .members
                .iter()
                .zip(members)
                .all(|(ours, theirs)| ours.0 == theirs.0 && ours.1 as usize == theirs.1)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const WGSL: &str = "struct S { a: f32, b: vec3<f32>, c: u32 } @group(0) @binding(0) var<uniform> s: S;
        struct Unbound { a: f32 }
        struct Inner { a: f32 }
        struct Outer { inner: Inner }
        @group(0) @binding(1) var<storage> all: array<Outer>;";

    #[test]
    fn layouts_follow_the_alignment_rules() {
        assert!(matches(WGSL, "S", 32, &[("a", 0), ("b", 16), ("c", 28)]));
        assert!(matches(WGSL, "Inner", 4, &[("a", 0)]), "a struct within a struct that is bound");
    }

    #[test]
    fn a_twin_that_differs_is_caught() {
        assert!(!matches(WGSL, "S", 32, &[("a", 0), ("b", 4), ("c", 28)]), "an offset");
        assert!(!matches(WGSL, "S", 20, &[("a", 0), ("b", 16), ("c", 28)]), "the size");
        assert!(!matches(WGSL, "S", 32, &[("a", 0), ("c", 16), ("b", 28)]), "the names");
        assert!(!matches(WGSL, "S", 32, &[("a", 0), ("b", 16)]), "the number of members");
        assert!(!matches(WGSL, "Unbound", 4, &[("a", 0)]), "a struct that nothing binds");
        assert!(!matches(WGSL, "Missing", 4, &[("a", 0)]), "a name that does not exist");
    }
}

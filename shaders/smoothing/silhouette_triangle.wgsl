// A face that the silhouette divides into the part of its lone corner and that of the two others.
// Twin: crates/smoothing/src/remeshing.rs

// The silhouette segment's vertices: its ends, and the first of those inside.
struct Chain {
    start: u32,
    end: u32,
    inner_at: u32,
    pieces: u32,
}

fn chain_vertex(chain: Chain, index: u32) -> u32 {
    if index == 0u {
        return chain.start;
    }
    return select(chain.inner_at + index - 1u, chain.end, index == chain.pieces);
}

fn written_chain(face: u32, leaving: Side, returning: Side, pieces: u32) -> Chain {
    let curve = load_segment(face, lone_of(state[settings.segments_at + face]));
    let n0 = normal_of(point_vertex(leaving.point));
    let n1 = normal_of(point_vertex(returning.point));
    let chain = Chain(
        side_vertex(leaving, leaving.silhouette_at),
        side_vertex(returning, returning.silhouette_at),
        vertex,
        pieces,
    );
    for (var i = 1u; i < pieces; i++) {
        let t = f32(i) / f32(pieces);
        push_vertex(hermite_point(curve, t), mix(n0, n1, t));
    }
    return chain;
}

// The middle of one or two corners and both ends of the chain.
fn written_middle(chain: Chain, a: u32, b: u32) -> u32 {
    var position = position_of(a) + position_of(chain.start) + position_of(chain.end);
    var normal = normal_of(a) + normal_of(chain.start) + normal_of(chain.end);
    if b == NONE {
        return push_vertex(position / 3.0, normal);
    }
    position += position_of(b);
    normal += normal_of(b);
    return push_vertex(position / 4.0, normal);
}

fn write_silhouette(face: u32, lone_slot: u32, pieces: u32, coarse: bool) {
    let leaving = written_side(3u * face + lone_slot, true, coarse);
    let opposite = written_side(3u * face + (lone_slot + 1u) % 3u, false, coarse);
    let returning = written_side(3u * face + (lone_slot + 2u) % 3u, true, coarse);
    let lone = leaving.begin;
    let next = opposite.begin;
    let previous = returning.begin;
    let chain = written_chain(face, leaving, returning, pieces);
    begin_part(lone);
    if is_plain_fan(leaving, returning) {
        for (var i = 0u; i < pieces; i++) {
            push_triangle(lone, chain_vertex(chain, i), chain_vertex(chain, i + 1u));
        }
    } else {
        begin_fan(written_middle(chain, lone, NONE), lone);
        extend_fan_by_side(leaving, 0u, leaving.silhouette_at + 1u);
        for (var i = 1u; i < pieces; i++) {
            extend_fan(chain_vertex(chain, i));
        }
        extend_fan_by_side(returning, returning.silhouette_at, side_length(returning));
        extend_fan(lone);
    }
    begin_part(next);
    if is_plain_strip(leaving, opposite, returning) {
        let half = (pieces + 1u) / 2u;
        for (var i = 0u; i < half; i++) {
            push_triangle(next, chain_vertex(chain, i + 1u), chain_vertex(chain, i));
        }
        push_triangle(next, previous, chain_vertex(chain, half));
        for (var i = half; i < pieces; i++) {
            push_triangle(previous, chain_vertex(chain, i + 1u), chain_vertex(chain, i));
        }
    } else {
        begin_fan(written_middle(chain, next, previous), chain.start);
        extend_fan_by_side(leaving, leaving.silhouette_at + 1u, side_length(leaving));
        extend_fan(next);
        extend_fan_by_side(opposite, 0u, side_length(opposite));
        extend_fan(previous);
        extend_fan_by_side(returning, 0u, returning.silhouette_at + 1u);
        for (var i = pieces - 1u; i > 0u; i--) {
            extend_fan(chain_vertex(chain, i));
        }
        extend_fan(chain.start);
    }
}

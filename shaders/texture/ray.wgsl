// Where a ray meets a mesh, through its hierarchy. Twin: crates/rays/src/ray.rs
//
// Departures from the twin:
//
// 1. There is no f64 here. The side of an edge on which a ray passes is found by comparing the two products, which faces on both
//    sides of the edge do alike; where the products are equal, the ray counts as inside both faces. No ray slips through.
// 2. An invocation may visit `most_steps` nodes and faces; after that, and where the stack is full, `is_lost`.

const NEVER: f32 = 3.0e38;
const STACK: u32 = 64u;
// Smaller components of a direction are replaced by this in tests of boxes.
const LEAST_COMPONENT: f32 = 1.1920929e-7;

struct Ray {
    origin: vec3<f32>,
    inverse: vec3<f32>,
    axes: vec3<u32>,
    // The origin along the axes.
    start: vec3<f32>,
    shear: vec3<f32>,
}

var<private> stack: array<u32, STACK>;
var<private> steps: u32;
var<private> is_lost: bool;

fn ray_of(origin: vec3<f32>, direction: vec3<f32>) -> Ray {
    let size = abs(direction);
    var z = 2u;
    if size.x >= size.y && size.x >= size.z {
        z = 0u;
    } else if size.y >= size.z {
        z = 1u;
    }
    var x = (z + 1u) % 3u;
    var y = (z + 2u) % 3u;
    if direction[z] < 0.0 {
        x = (z + 2u) % 3u;
        y = (z + 1u) % 3u;
    }
    let least = select(vec3<f32>(-LEAST_COMPONENT), vec3<f32>(LEAST_COMPONENT), direction >= vec3<f32>(0.0));
    let inverse = 1.0 / select(direction, least, size < vec3<f32>(LEAST_COMPONENT));
    let start = vec3<f32>(origin[x], origin[y], origin[z]);
    let shear = vec3<f32>(direction[x], direction[y], 1.0) / direction[z];
    return Ray(origin, inverse, vec3<u32>(x, y, z), start, shear);
}

// Where a ray enters a node's box, or `NEVER`.
fn entry(ray: Ray, node: u32) -> f32 {
    let to_low = (nodes[node].low - ray.origin) * ray.inverse;
    let to_high = (nodes[node].high - ray.origin) * ray.inverse;
    let near = min(to_low, to_high);
    let far = max(to_low, to_high);
    let enters = max(max(near.x, near.y), near.z);
    let leaves = min(min(far.x, far.y), far.z);
    return select(NEVER, enters, leaves >= max(enters, 0.0));
}

fn sheared(ray: Ray, corner: u32) -> vec3<f32> {
    let along = corners[corner + ray.axes.z] - ray.start.z;
    let across = vec2<f32>(corners[corner + ray.axes.x] - ray.start.x, corners[corner + ray.axes.y] - ray.start.y);
    return vec3<f32>(across - ray.shear.xy * along, along);
}

// The distance to a face, negative where the ray misses it, and the determinant, negative where the ray leaves by it.
fn crossing(ray: Ray, face: u32) -> vec2<f32> {
    let a = sheared(ray, 9u * face);
    let b = sheared(ray, 9u * face + 3u);
    let c = sheared(ray, 9u * face + 6u);
    let left = vec3<f32>(c.x * b.y, a.x * c.y, b.x * a.y);
    let right = vec3<f32>(c.y * b.x, a.y * c.x, b.y * a.x);
    let edges = left - right;
    let determinant = edges.x + edges.y + edges.z;
    if (any(left < right) && any(left > right)) || determinant == 0.0 {
        return vec2<f32>(HIDDEN, 0.0);
    }
    return vec2<f32>(ray.shear.z * dot(edges, vec3<f32>(a.z, b.z, c.z)) / determinant, determinant);
}

// The distance to the nearest face between `beyond` and `within`, or `within`; with `leaves`, to any by which the ray leaves.
fn nearest_crossing(ray: Ray, root: u32, beyond: f32, within: f32, leaves: bool) -> f32 {
    var nearest = within;
    var top = 1u;
    stack[0] = root;
    while top > 0u && !is_lost {
        top -= 1u;
        let at = stack[top];
        let node = nodes[at];
        steps += 1u + node.faces;
        if node.faces > 0u {
            for (var face = node.first; face < node.first + node.faces; face += 1u) {
                let met = crossing(ray, face);
                let counts = met.x >= 0.0 && met.x > beyond && met.x < nearest && (!leaves || met.y < 0.0);
                nearest = select(nearest, met.x, counts);
            }
            if leaves && nearest < within {
                break;
            }
        } else {
            let first = entry(ray, node.first);
            let second = entry(ray, node.first + 1u);
            let is_swapped = second < first;
            // The nearer one on top.
            if max(first, second) < nearest {
                stack[top] = select(node.first + 1u, node.first, is_swapped);
                top += 1u;
            }
            if min(first, second) < nearest {
                stack[top] = select(node.first, node.first + 1u, is_swapped);
                top += 1u;
            }
        }
        is_lost = steps > settings.most_steps || top + 2u > STACK;
    }
    return nearest;
}

// Where a straight border runs through a square.

// The point of a border nearest to the middle of a square, from there, in sides of the square: `inward` points to the covered side,
// and `coverage` of the square lies there. Stefan Gustavson and Robin Strand, "Anti-aliased Euclidean distance transform", Pattern
// Recognition Letters 2011.
fn border_place(inward: vec2<f32>, coverage: f32) -> vec2<f32> {
    let size = length(inward);
    if size < 1e-4 {
        return vec2<f32>(0.0);
    }
    let direction = inward / size;
    let more = max(abs(direction.x), abs(direction.y));
    let less = min(abs(direction.x), abs(direction.y));
    // Up to this coverage the border cuts off a corner.
    let corner = 0.5 * less / more;
    let outside = min(coverage, 1.0 - coverage);
    var away = (0.5 - outside) * more;
    if outside < corner {
        away = 0.5 * (more + less) - sqrt(2.0 * more * less * outside);
    }
    return direction * select(-away, away, coverage < 0.5);
}

//! What people type.

use super::{Seed, seed};

const SCENE: &str = r#"tmeshes = ["builtin:torus:24,16", { mesh = "fine.obj", simplify = 500 }]
[path]
kind = "orbit"
projection = "perspective"
fov-deg = 45
first-azimuth-deg = 23.9
elevation-deg = 17.8
swing-deg = 13.2
step-deg = 2
warm-up = 3
frames = 30
scored = 6
[picture]
width = 512
height = 384
samples = 1
[pen]
width-px = 2
[[methods]]
name = "tracking"
options = { concavity = [0, 0.5, 1], mesh = "cut" }
"#;

pub fn seeds() -> Vec<Seed> {
    let command = |name: &str, line: &str| seed(name, format!("c{}", line.replace(' ', "\n")));
    vec![
        command("extract", "extract builtin:torus --view iso --eye 1,2,3 --target 0,0,-1 --fov 30 -o a.svg"),
        command("lines", "lines part.stl --ortho fit --view front --hidden dashed --page a4 --creases 30 --heal auto"),
        command("lines-pens", "lines a.obj --section 0,0,0,1,0,0 --views front,top --scale 1:10 --margin 5mm --curves"),
        command("render", "render a.obj b.obj --method texture --size 640x480 --up-axis z -o a.png"),
        command(
            "compare",
            "compare a.obj builtin:cube --methods tracking,brute-force --set tracking.concavity=0.5 -o report",
        ),
        command("bake", "bake builtin:blob:600 --set hull-vertices=24 --set size=64 -o a.siltex"),
        seed("scene", SCENE),
        seed("options", "mconcavity=0.25\nmesh=cut"),
        seed("number", "mprobes=0.5"),
        seed("length", "l0.35mm"),
        seed("page", "l11x17in"),
        seed("colour", "l#20a0ff"),
        seed("plane", "l0,0,1.5,0,0,-1"),
        seed("shape", "btorus:24,16"),
        seed("shape-wrong", "bgear:3,1e9"),
    ]
}

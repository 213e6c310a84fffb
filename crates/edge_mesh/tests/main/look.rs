use crate::scene::*;
use silhouette_testing::*;
#[test]
fn look() {
    let Some(gpu) = gpu_or_skip("look") else { return };
    for (name, mesh) in [
        ("cube", builtin("cube")),
        ("gear", builtin("gear")),
        ("bunny", real_mesh("look", "stanford-bunny.obj").unwrap()),
    ] {
        for path in PATHS {
            let img = picture(
                gpu,
                &mesh,
                &framed(&mesh, 512),
                &[path, "width=3", "ridge-angle=30", "valley-angle=30", "ridge-red=1", "valley-blue=1"],
            );
            img.save_png(std::path::Path::new(&format!("/tmp/em-{name}-{}.png", &path[5..]))).unwrap();
            eprintln!("{name} {path} {}", ink(&img));
        }
    }
}

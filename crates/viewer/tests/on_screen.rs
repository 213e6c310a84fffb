//! The program itself, in a window of a virtual display: it opens a mesh, another method is chosen by keys, and the screen shows it.
//!
//! It needs `Xvfb`, and `xdotool` and `import` for the keys and the screenshot; where one is missing the test says so, and what to install.

use silhouette_testing::{gpu_or_skip, skipped};
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const TEST: &str = "the_program_opens_a_mesh_on_a_display";

/// A process that ends with the test.
struct Ends(Child);

impl Drop for Ends {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn is_there(program: &str) -> bool {
    let folders = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&folders).any(|folder| folder.join(program).is_file())
}

/// How many dark pixels the right half of a screenshot has, where the picture is.
fn ink(display: &str, file: &Path) -> usize {
    let taken = Command::new("import").args(["-display", display, "-window", "root"]).arg(file).status();
    assert!(taken.unwrap().success());
    let screen = image::open(file).unwrap().to_rgb8();
    let is_ink =
        |(x, _, pixel): &(u32, u32, &image::Rgb<u8>)| *x > screen.width() / 2 && pixel.0.iter().all(|&c| c < 64);
    screen.enumerate_pixels().filter(is_ink).count()
}

#[test]
fn the_program_opens_a_mesh_on_a_display() {
    if let Some(missing) = ["Xvfb", "xdotool", "import"].into_iter().find(|program| !is_there(program)) {
        let mend = "Debian and Ubuntu have it in one of the packages xvfb, xdotool and imagemagick";
        return skipped(TEST, &format!("there is no {missing}; {mend}"));
    }
    if gpu_or_skip(TEST).is_none() {
        return;
    }
    // It takes a display that is free, says which once programs can connect to it, and stays when the first of them has left: a
    // server that resets itself refuses the next one meanwhile.
    let screen = ["-displayfd", "1", "-noreset", "-screen", "0", "1100x760x24", "-wr", "-nolisten", "tcp"];
    let server = Command::new("Xvfb").args(screen).stdout(Stdio::piped()).stderr(Stdio::null()).spawn();
    let mut server = Ends(server.unwrap());
    let mut number = String::new();
    BufReader::new(server.0.stdout.take().unwrap()).read_line(&mut number).unwrap();
    let display = format!(":{}", number.trim());
    let program = Command::new(env!("CARGO_BIN_EXE_silhouettes-viewer"))
        .args(["builtin:gear", "--method", "brute-force", "--size", "700x600"])
        .env("DISPLAY", &display)
        .env_remove("WAYLAND_DISPLAY")
        .spawn();
    let mut program = Ends(program.unwrap());
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("screen.png");
    let begin = Instant::now();
    // The ground of the display is white (-wr), as the paper of the picture is.
    let wait_for = |program: &mut Ends, what: &str, is_so: &dyn Fn(usize) -> bool| loop {
        assert!(program.0.try_wait().unwrap().is_none(), "the program ended before {what}");
        let seen = ink(&display, &file);
        if is_so(seen) {
            return seen;
        }
        assert!(begin.elapsed() < Duration::from_secs(60), "{what}: {seen}");
        std::thread::sleep(Duration::from_millis(500));
    };
    let lines = wait_for(&mut program, "the lines of a gear", &|ink| (200..40_000).contains(&ink));
    // The choice of a method is the first control behind the menu bar; a letter is not enough there, arrows are.
    let xdotool = |words: &[&str]| {
        assert!(Command::new("xdotool").args(words).env("DISPLAY", &display).status().unwrap().success());
        std::thread::sleep(Duration::from_millis(400));
    };
    xdotool(&["search", "--onlyvisible", "--name", "silhouettes", "windowfocus"]);
    let is_another = |ink: usize| ink != lines && (200..500_000).contains(&ink);
    // On a busy machine the list may not be open yet when its row is pressed, so that it is pressed again.
    wait_for(&mut program, "a picture of another method", &|ink| {
        if !is_another(ink) {
            xdotool(&["mousemove", "80", "36", "click", "1"]);
            std::thread::sleep(Duration::from_millis(600));
            xdotool(&["mousemove", "80", "250", "click", "1"]);
            std::thread::sleep(Duration::from_secs(2));
        }
        is_another(ink)
    });
    if let Some(kept) = std::env::var_os("SILHOUETTES_SCREENSHOTS") {
        std::fs::copy(&file, Path::new(&kept).join("on_screen.png")).unwrap();
    }
}

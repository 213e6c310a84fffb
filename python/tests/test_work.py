"""Long calls: other threads run, callbacks hear of it, Ctrl-C and exceptions stop it. And the command line."""

import os
import signal
import subprocess
import sys
import threading
import time

import pytest
import silhouettes

# What takes a minute or more.
LONG = "silhouettes.bake(silhouettes.load('builtin:blob:200000'), size=512, hull_vertices=2000)"


def test_a_callback_hears_of_stages_and_stops_the_work() -> None:
    heard = []

    class Enough(Exception):
        pass

    def progress(stage: str, done: int, total: int) -> None:
        heard.append((stage, done, total))
        if len(heard) == 3:
            raise Enough

    mesh = silhouettes.load("builtin:blob:200000")
    with pytest.raises(Enough):
        silhouettes.bake(mesh, size=512, hull_vertices=2000, progress=progress)
    assert len(heard) == 3


def test_other_threads_run_meanwhile() -> None:
    ticks = []
    is_over = threading.Event()

    def tick() -> None:
        while not is_over.wait(0.005):
            ticks.append(time.monotonic())

    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.monotonic()
    silhouettes.load("builtin:blob:1000000").inspect()
    end = time.monotonic()
    is_over.set()
    thread.join()
    during = [tick for tick in ticks if begin < tick < end]
    assert len(during) >= 5


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_ctrl_c_raises_and_leaves_a_working_interpreter() -> None:
    # A shell that starts this in the background has SIGINT ignored, which Python then leaves so.
    code = f"""
import signal
import silhouettes
signal.signal(signal.SIGINT, signal.default_int_handler)
print("begun", flush=True)
try:
    {LONG}
except KeyboardInterrupt:
    print(len(silhouettes.edges(silhouettes.load("builtin:cube"))), flush=True)
"""
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "begun\n"
    time.sleep(1)
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=120)
    assert (process.returncode, output) == (0, "6\n")


def program(*words: str, **environment: str) -> "subprocess.CompletedProcess[str]":
    """The console script, beside the interpreter."""
    path = os.path.join(os.path.dirname(sys.executable), "silhouettes")
    return subprocess.run([path, *words], capture_output=True, text=True, env={**os.environ, **environment})


def test_the_command_line_comes_along() -> None:
    assert program("--version").stdout.startswith("silhouettes ")
    refused = program("inspect", "missing.obj")
    with pytest.raises(silhouettes.Error) as raised:
        silhouettes.load("missing.obj")
    assert (refused.returncode, refused.stderr) == (2, f"silhouettes: {raised.value}\n")


def test_what_draws_nothing_needs_no_vulkan() -> None:
    code = """
import silhouettes
mesh = silhouettes.load("builtin:torus")
assert len(silhouettes.edges(mesh)) and silhouettes.visible_lines(mesh) and silhouettes.outline(mesh)
silhouettes.smooth(mesh)
silhouettes.recommend(mesh, goal="loops", seconds=0.1, no_cache=True)
try:
    silhouettes.render(mesh)
except RuntimeError as error:
    print(error)
"""
    nowhere = {"VK_DRIVER_FILES": "/nowhere.json", "VK_ICD_FILENAMES": "/nowhere.json"}
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env={**os.environ, **nowhere}, check=True
    )
    assert len(done.stdout.splitlines()) == 1 and "adapter" in done.stdout

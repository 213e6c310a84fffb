"""The console script ``silhouettes``."""

import os
import signal
import sys

from ._silhouettes import run_program


def main() -> int:
    """Runs the command line with the process's arguments."""
    # Python's own handler would only take note of Ctrl-C; the program installs one that stops the work.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    # Mesa's drivers otherwise look for a display server, and complain on stderr where there is none.
    os.environ.setdefault("NODEVICE_SELECT", "1")
    sys.stdout.flush()
    return run_program(["silhouettes", *sys.argv[1:]])

"""The program ``exact-ccd``."""

from __future__ import annotations

import signal
import sys

from . import _native


def main() -> None:
    """Run the program with the arguments of the process, and end with its exit status."""
    # The program has no state to save: Ctrl-C ends it at once.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(_native.main(["exact-ccd", *sys.argv[1:]]))


if __name__ == "__main__":
    main()

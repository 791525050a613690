"""The program ``exact-ccd``, which is a package of its own, ``exact-ccd-cli``."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import sysconfig

MISSING = """\
exact-ccd: error: the program is not installed; it is the package exact-ccd-cli, which
`pip install ./crates/exact-ccd-cli` in a checkout of the repository builds
"""


def main() -> None:
    """Run the program with the arguments of the process, in its place where the system can replace a process."""
    folders = [sysconfig.get_path("scripts"), os.environ.get("PATH", os.defpath)]
    program = shutil.which("exact-ccd", path=os.pathsep.join(folders))
    if program is None:
        sys.stderr.write(MISSING)
        sys.exit(2)
    command = [program, *sys.argv[1:]]
    if sys.platform == "win32":
        sys.exit(subprocess.call(command))
    # The handler of Python for Ctrl-C ends with Python, so the program has its own one.
    os.execv(program, command)


if __name__ == "__main__":
    main()

"""The Python programs in the documentation."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

PACKAGE = Path(__file__).parents[1]
REPOSITORY = PACKAGE.parents[1]
DOCUMENTS = [REPOSITORY / "README.md", PACKAGE / "README.md", REPOSITORY / "docs" / "python.md"]
DOCUMENTS.append(REPOSITORY / "docs" / "recordings.md")

PROGRAMS = {
    f"{document.relative_to(REPOSITORY).as_posix()} {number}": code
    for document in DOCUMENTS
    for number, code in enumerate(re.findall(r"```python\n(.*?)```", document.read_text("utf-8"), re.S), 1)
}
"""The programs by the names of their documents and their numbers there."""


def needs_ray(code: str) -> bool:
    """Return True if a program starts or joins a cluster."""
    return "exact_ccd.ray" in code


def libraries(code: str) -> list[str]:
    """The libraries that a program imports besides this package."""
    names = re.findall(r"^(?:import|from) (\w+)", code, re.M)
    return sorted({*names} - {"exact_ccd"})


def run(code: str, folder: Path, **environment: str) -> None:
    """Run a program in a folder. A comment after `print` is the line that it prints."""
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=folder, env={**os.environ, **environment}, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == re.findall(r"^print\(.*\) +# (.*)$", code, re.M)

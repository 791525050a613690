"""The examples run, and are typed strictly."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

import exact_ccd

PACKAGE = Path(__file__).parents[1]
EXAMPLES = sorted((PACKAGE / "examples").glob("*.py"))


@pytest.mark.parametrize("file", EXAMPLES, ids=lambda file: file.stem)
def test_example(file: Path) -> None:
    done = subprocess.run([sys.executable, file], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_readme() -> None:
    (code,) = re.findall(r"```python\n(.*?)```", (PACKAGE / "README.md").read_text(), re.S)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    # The comments have the output.
    expected = re.findall(r"print\(.*?\)  +# (.*)", code) or re.findall(r"# (\[.*\]|[0-9.]+ [0-9.]+)$", code, re.M)
    assert done.stdout.splitlines() == expected


def mypy(*arguments: object) -> None:
    """Run mypy, or a module of it, where it finds the package: installed, or in its folder."""
    if importlib.util.find_spec("mypy") is None:
        pytest.skip("mypy is not installed: pip install mypy")
    folder = Path(exact_ccd.__file__).parents[1].resolve()
    # In the folder of installed packages, mypy takes all of them for the user's own.
    if folder == Path(sysconfig.get_path("platlib")).resolve():
        folder = PACKAGE
    done = subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True, cwd=folder)
    assert done.returncode == 0, done.stdout + done.stderr


def test_types() -> None:
    strict = ["mypy", "--strict", "--config-file", PACKAGE / "pyproject.toml"]
    mypy(*strict, "-p", "exact_ccd")
    mypy(*strict, *EXAMPLES)


def test_stubs() -> None:
    if not hasattr(exact_ccd._native, "main"):
        pytest.skip("the extension was built without the program")
    config = ["--mypy-config-file", PACKAGE / "pyproject.toml"]
    mypy("mypy.stubtest", "exact_ccd._native", *config)

"""The examples run, and are typed strictly."""

from __future__ import annotations

import importlib.util
import json
import os
import re
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

import exact_ccd

PACKAGE = Path(__file__).parents[1]
EXAMPLES = sorted((PACKAGE / "examples").glob("*.py"))
LIBRARIES = {"trimesh_scene": "trimesh", "blender_audit": "bpy", "draw_contacts": "pyvista"}
TYPED = [file for file in EXAMPLES if file.stem not in LIBRARIES]
"""The examples whose libraries have types, or that need none."""


def needs(library: str) -> None:
    """Skip a test whose library is missing."""
    if importlib.util.find_spec(library) is None:
        pytest.skip(f"{library} is not installed: pip install {library}")


@pytest.mark.parametrize("file", EXAMPLES, ids=lambda file: file.stem)
def test_example(file: Path) -> None:
    if file.stem in LIBRARIES:
        needs(LIBRARIES[file.stem])
    done = subprocess.run([sys.executable, file], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    if file.stem == "blender_audit":
        # Blender goes on after an error in a script.
        assert "contact at frame 4.46" in done.stdout, done.stdout + done.stderr


def test_notebook() -> None:
    needs("matplotlib")
    notebook = json.loads((PACKAGE / "examples" / "first_contact.ipynb").read_text())
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    code = "\n".join("".join(cell["source"]) for cell in cells)
    environment = {**os.environ, "MPLBACKEND": "agg"}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment)
    assert done.returncode == 0, done.stderr
    outputs = [output for cell in cells for output in cell["outputs"]]
    # The printed numbers are those in the notebook, which also has the pictures.
    printed = "".join("".join(output.get("text", "")) for output in outputs)
    assert done.stdout == printed
    assert sum("image/png" in output.get("data", {}) for output in outputs) == 3


def test_readme() -> None:
    (code,) = re.findall(r"```python\n(.*?)```", (PACKAGE / "README.md").read_text(), re.S)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    # The comments have the output.
    expected = re.findall(r"print\(.*?\)  +# (.*)", code) or re.findall(r"# (\[.*\]|[0-9.]+ [0-9.]+)$", code, re.M)
    assert done.stdout.splitlines() == expected


def mypy(*arguments: object) -> None:
    """Run mypy, or a module of it, where it finds the package: installed, or in its folder."""
    needs("mypy")
    folder = Path(exact_ccd.__file__).parents[1].resolve()
    # In the folder of installed packages, mypy takes all of them for the user's own.
    if folder == Path(sysconfig.get_path("platlib")).resolve():
        folder = PACKAGE
    done = subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True, cwd=folder)
    assert done.returncode == 0, done.stdout + done.stderr


def test_types() -> None:
    strict = ["mypy", "--strict", "--config-file", PACKAGE / "pyproject.toml"]
    mypy(*strict, "-p", "exact_ccd")
    mypy(*strict, *TYPED)


def test_pyright() -> None:
    needs("pyright")
    command = [sys.executable, "-m", "pyright", "--pythonpath", sys.executable, *TYPED]
    done = subprocess.run(command, capture_output=True, text=True, cwd=PACKAGE)
    if "error" in done.stderr and not done.stdout:
        pytest.skip(f"pyright does not run without its own download: {done.stderr.splitlines()[-1]}")
    assert done.returncode == 0, done.stdout + done.stderr


def test_stubs() -> None:
    if not hasattr(exact_ccd._native, "main"):
        pytest.skip("the extension was built without the program")
    config = ["--mypy-config-file", PACKAGE / "pyproject.toml"]
    mypy("mypy.stubtest", "exact_ccd._native", *config)

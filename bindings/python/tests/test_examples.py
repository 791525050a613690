"""The examples run, and are typed strictly."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

import exact_ccd
from documents import PACKAGE, PROGRAMS, libraries, needs_ray, run
from generated import write_queries

EXAMPLES = sorted((PACKAGE / "examples").glob("*.py"))
LIBRARIES = {"trimesh_scene": "trimesh", "draw_contacts": "pyvista"}
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


def test_notebook() -> None:
    needs("matplotlib")
    notebook = json.loads((PACKAGE / "examples" / "first_contact.ipynb").read_text())
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    code = "\n".join("".join(cell["source"]) for cell in cells)
    environment = {**os.environ, "MPLBACKEND": "agg"}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment)
    assert done.returncode == 0, done.stderr
    outputs = [output for cell in cells for output in cell["outputs"]]
    # The printed numbers are the same as in the notebook, which also has the pictures.
    printed = "".join("".join(output.get("text", "")) for output in outputs)
    assert done.stdout == printed
    assert sum("image/png" in output.get("data", {}) for output in outputs) == 3


@pytest.mark.parametrize("name", PROGRAMS)
def test_programs_of_the_documentation(name: str, tmp_path: Path) -> None:
    code = PROGRAMS[name]
    if needs_ray(code):
        pytest.skip("the test of Ray runs this program on its cluster")
    for library in libraries(code):
        needs(library)
    if "queries.parquet" in code:
        write_queries(tmp_path / "queries.parquet")
    run(code, tmp_path)


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

    def pyright(*arguments: object) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", "pyright", *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, cwd=PACKAGE)

    started = pyright("--version")
    if started.returncode != 0:
        pytest.skip(f"pyright needs node, or a network to install it: {started.stderr.splitlines()[-1]}")
    done = pyright("--pythonpath", sys.executable, *TYPED)
    assert done.returncode == 0, done.stdout + done.stderr


def test_stubs() -> None:
    if not hasattr(exact_ccd._native, "repair"):
        pytest.skip("the extension was built without repair")
    config = ["--mypy-config-file", PACKAGE / "pyproject.toml"]
    mypy("mypy.stubtest", "exact_ccd._native", *config)

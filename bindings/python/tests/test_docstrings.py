"""The documentation of all public items has the form of numpydoc."""

from __future__ import annotations

import importlib
import inspect

import pytest

MODULES = ["exact_ccd", "exact_ccd.ipc"]
LEFT_OUT = {
    "GL01": "the summary begins in the first line, as PEP 257 has it",
    "ES01": "many items need no more than a summary",
    "SA01": "few items need a section See Also",
    "PR01": "checked below: several parameters may have one entry",
    "PR02": "the same",
}


def items() -> list[str]:
    """The names of all public functions and classes, and of the methods of these."""
    names = []
    for module in map(importlib.import_module, MODULES):
        for name in module.__all__:
            item = getattr(module, name)
            if inspect.isfunction(item) or inspect.isclass(item):
                names.append(f"{module.__name__}.{name}")
            if inspect.isclass(item):
                own = [key for key, value in vars(item).items() if inspect.isfunction(value) and key[0] != "_"]
                names += [f"{module.__name__}.{name}.{key}" for key in own]
    return names


@pytest.mark.parametrize("name", items())
def test_docstring(name: str) -> None:
    validate = pytest.importorskip("numpydoc.validate", reason="numpydoc is not installed: pip install numpydoc")
    errors = validate.validate(name)["errors"]
    assert [error for error in errors if error[0] not in LEFT_OUT] == []

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
    "EX01": "the example of a class shows its methods and its records",
}


def items() -> dict[str, object]:
    """The public functions and classes by their names, and the methods of the classes."""
    found = {}
    for module in map(importlib.import_module, MODULES):
        for name in module.__all__:
            item = getattr(module, name)
            if inspect.isfunction(item) or inspect.isclass(item):
                found[f"{module.__name__}.{name}"] = item
            if inspect.isclass(item):
                methods = {key: value for key, value in vars(item).items() if inspect.isfunction(value) and key[0] != "_"}
                found.update({f"{module.__name__}.{name}.{key}": value for key, value in methods.items()})
    return found


@pytest.mark.parametrize("name", items())
def test_docstring(name: str) -> None:
    pytest.importorskip("numpydoc", reason="numpydoc is not installed: pip install numpydoc")
    from numpydoc.docscrape import get_doc_object
    from numpydoc.validate import validate

    item, codes = items()[name], {*LEFT_OUT}
    if inspect.isclass(item) and issubclass(item, tuple):
        # A record is made by this package: its attributes take the place of the parameters.
        codes.add("PR01")
        documented = [one for entry in get_doc_object(item)["Attributes"] for one in entry.name.split(", ")]
        assert documented == list(item._fields)
    if getattr(item, "_is_protocol", False):
        # A protocol has no constructor.
        codes.add("PR01")
    assert [error for error in validate(name)["errors"] if error[0] not in codes] == []

"""The documentation site: the Markdown files of the repository as they are, by `scripts/check site`.

The source folder is the repository, so that every link between files is the one that a reader of the repository follows.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MANIFEST = (ROOT / "Cargo.toml").read_text()

project = "exact-ccd"
author = re.search(r'^authors = \["(.*)"\]', MANIFEST, re.M)[1]
copyright = author
release = re.search(r'^version = "(.*)"', MANIFEST, re.M)[1]
address = re.search(r'^repository = "(.*)"', MANIFEST, re.M)[1]

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "breathe"]
root_doc = "docs/site/index"
include_patterns = [
    "*.md",
    "docs/*.md",
    "docs/benchmark/*.md",
    "docs/performance/*.md",
    "docs/proof/*.md",
    "docs/simulation/*.md",
    "docs/site/*.md",
    "bindings/python/README.md",
    "fuzz/README.md",
    "mutations/README.md",
    "packaging/README.md",
    "integrations/*/README.md",
]
exclude_patterns = ["target", "**/target", "**/node_modules", "build", "result"]

# Markdown as GitHub reads it.
myst_heading_anchors = 4
myst_enable_extensions = ["strikethrough"]
# A struct of the C header and the type of the same name are two declarations.
suppress_warnings = ["myst.header", "myst.strikethrough", "duplicate_declaration.c"]

# The Python package, without its extension module: nothing has to be compiled.
sys.path.insert(0, str(ROOT / "bindings/python/python"))
autodoc_mock_imports = ["exact_ccd._native", "pyarrow", "ray"]
autodoc_typehints = "none"
autodoc_member_order = "bysource"
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_use_ivar = True

# The C header, from the XML of Doxygen, whose folder scripts/check names.
breathe_default_project = project
breathe_domain_by_extension = {"h": "c"}
breathe_show_include = False

html_theme = "furo"
html_title = f"exact-ccd {release}"
html_logo = "../figures/logo.svg"
html_favicon = "../figures/logo.svg"
html_copy_source = False
html_show_sourcelink = False
# Links to the sources, unless the address of the repository is a placeholder.
sources = {} if "//example." in address else {
    "source_view_link": address + "/blob/main/{filename}",
    "source_edit_link": address + "/edit/main/{filename}",
}
html_theme_options = {
    **sources,
    "sidebar_hide_name": False,
    "light_css_variables": {"color-brand-primary": "#0072b2", "color-brand-content": "#0072b2"},
    "dark_css_variables": {"color-brand-primary": "#56b4e9", "color-brand-content": "#56b4e9"},
}
html_static_path = ["static"]
html_extra_path = ["root"]
html_css_files = ["site.css"]


def is_alias(app, what, name, item, skip, options):
    """True for the fields of records, which the text of their class describes."""
    return skip or (getattr(item, "__doc__", None) or "").startswith("Alias for field number")


def without_diagrams(app, name, source):
    """Diagrams of Mermaid as lists: the program that draws them would be loaded from another host, and the site works offline."""
    source[0] = re.sub(r"```mermaid\n(.*?)```", lambda found: as_list(found[1]), source[0], flags=re.S)


def as_list(diagram):
    """A flowchart as a list: each node with the nodes to which it has arrows."""
    arrows = re.findall(r"^ *(\w+)(?:\[.*\])? --> (.*)$", diagram, re.M)
    labels = dict(re.findall(r"(\w+)\[(.*?)\]", diagram))
    return "".join(f"- {labels.get(node, node)} → {', '.join(to.split(' & '))}\n" for node, to in arrows)


def setup(app):
    """Leaves these fields out, and diagrams."""
    app.connect("autodoc-skip-member", is_alias)
    app.connect("source-read", without_diagrams)

"""Pages in notebooks."""

from __future__ import annotations

import html
from os import PathLike, fspath
from pathlib import Path
from typing import Union


class NotebookPage:
    """The page in a file, for a notebook: it is shown where it is the value of a cell.

    The notebook holds the page itself, not a reference to the file.

    Parameters
    ----------
    file : path
        A page that `view` has written, as of :meth:`Detector.step` or :func:`audit`.
    height : int
        Its height in pixels.

    Raises
    ------
    OSError
        If the file cannot be read.

    Examples
    --------
    >>> detector.step(x0, x1, view="step.html")  # doctest: +SKIP
    >>> NotebookPage("step.html")  # doctest: +SKIP
    """

    def __init__(self, file: Union[str, PathLike[str]], *, height: int = 560) -> None:
        self._name, self._height = fspath(file), int(height)
        self._page = Path(file).read_text("utf-8")

    def _repr_html_(self) -> str:
        page = html.escape(self._page, quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: {self._height}px; border: 0"></iframe>'

    def __repr__(self) -> str:
        return f"<exact_ccd.NotebookPage: {self._name}>"

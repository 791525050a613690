"""Chunks of a sequence of frames, and the results of those that are finished."""

from __future__ import annotations

import hashlib
import json
import os
import uuid
from collections.abc import Iterator
from os import PathLike, fspath
from typing import Any, NamedTuple, Optional, Union

import numpy as np
import pyarrow.fs

from .._native import __version__
from ..contacts import Contact
from ..groups import Place
from ..violations import AuditReport, Violation


class Chunk(NamedTuple):
    """The frames from `first` to `last`, both included. The last one is the first of the next chunk."""

    first: int
    last: int


def chunks(frames: int, steps: int) -> Iterator[Chunk]:
    """Chunks of at most so many steps, in order."""
    yield from (Chunk(first, min(first + steps, frames - 1)) for first in range(0, max(frames - 1, 1), steps))


class Finished(NamedTuple):
    """The report of a chunk, and its part of the certificate, if one is wanted."""

    report: AuditReport
    part: Optional[bytes]


class Results:
    """The results of finished chunks, in a folder: a file for each report, and one for each part of a certificate.

    A file is written under another name and then renamed, so every file of a result is whole. Its name
    contains a digest of all that the answer depends on, so that audits of different recordings share a folder.
    """

    def __init__(self, folder: str, digest: str, filesystem: pyarrow.fs.FileSystem) -> None:
        self._folder, self._digest, self._filesystem = folder.rstrip("/"), digest, filesystem
        filesystem.create_dir(folder, recursive=True)

    def _path(self, chunk: Chunk, ending: str) -> str:
        return f"{self._folder}/{self._digest}-{chunk.first}-{chunk.last}.{ending}"

    def read(self, chunk: Chunk, has_part: bool) -> Optional[Finished]:
        """The report of a chunk, and its part if that is wanted; None if it is not finished."""
        report = self._read(self._path(chunk, "json"))
        part = self._read(self._path(chunk, "certificate")) if has_part else None
        if report is None or has_part and part is None:
            return None
        return Finished(from_json(report), part)

    def _read(self, path: str) -> Optional[bytes]:
        if self._filesystem.get_file_info(path).type != pyarrow.fs.FileType.File:
            return None
        with self._filesystem.open_input_file(path) as stream:
            contents: bytes = stream.read()
            return contents

    def write(self, chunk: Chunk, finished: Finished) -> None:
        """Keep the result of a finished chunk."""
        if finished.part is not None:
            self._write(self._path(chunk, "certificate"), finished.part)
        self._write(self._path(chunk, "json"), to_json(finished.report).encode())

    def _write(self, path: str, contents: bytes) -> None:
        unfinished = f"{path}.{uuid.uuid4().hex}"
        with self._filesystem.open_output_stream(unfinished) as stream:
            stream.write(contents)
        self._filesystem.move(unfinished, path)


def digest(*parts: Any) -> str:
    """A digest of arrays and of anything else by its text, and of the version of this package."""
    total = hashlib.sha256(__version__.encode())
    for part in parts:
        if isinstance(part, np.ndarray):
            total.update(f"{part.dtype.str}{part.shape}".encode())
            total.update(np.ascontiguousarray(part).data)
        else:
            total.update(repr(part).encode())
    return total.hexdigest()[:32]


def to_json(report: AuditReport) -> str:
    """A report as JSON, in which every float64 keeps its value, and a normal that does not exist is null."""
    table: dict[str, Any] = {"frames": report.frames, "violation": None}
    violation = report.violation
    if violation is not None:
        table["violation"] = {**violation._asdict(), "contact": _fields(violation.contact)}
    return json.dumps(table, allow_nan=False)


def _fields(contact: Optional[Contact]) -> Optional[dict[str, Any]]:
    """The fields of a contact as values of JSON."""
    if contact is None:
        return None
    fields = contact._asdict()
    if np.isnan(contact.normal).any():
        fields["normal"] = None
    return {name: value.tolist() if isinstance(value, np.ndarray) else value for name, value in fields.items()}


def from_json(text: Union[str, bytes]) -> AuditReport:
    """The report that :func:`to_json` has written. Reports of earlier versions have no half space."""
    value = json.loads(text)
    found = value["violation"]
    if found is None:
        return AuditReport(value["frames"], None)
    contact: Optional[Contact] = None
    if found["contact"] is not None:
        fields = {**found["contact"]}
        fields["normal"] = fields["normal"] or [np.nan] * 3
        fields["places"] = _places(fields.get("places", (None, None)))
        types = {"vertices": np.int64, "normal": np.float64, "points": np.float64, "distance": np.float64}
        contact = Contact(**{**fields, **{name: np.array(fields[name], type) for name, type in types.items()}})
    pairs = (found.get(name) for name in ("intersection", "half_space"))
    intersection, half_space = (None if pair is None else (pair[0], pair[1]) for pair in pairs)
    places = _places(found.get("places", ()))
    return AuditReport(value["frames"], Violation(found["frame"], contact, intersection, half_space, places))


def _places(values: Any) -> Any:
    """The places of primitives; reports of earlier versions have none."""
    return tuple(None if value is None else Place(*value) for value in values)


def absolute(path: Union[str, PathLike[str]]) -> str:
    """The absolute path, as tasks have other working directories; an address as it is."""
    return fspath(path) if "://" in fspath(path) else os.path.abspath(path)


def file_system(
    path: Union[str, PathLike[str]], filesystem: Optional[pyarrow.fs.FileSystem]
) -> tuple[pyarrow.fs.FileSystem, str]:
    """The file system of a path or address, and the path in it."""
    if filesystem is not None:
        return filesystem, fspath(path)
    if "://" in fspath(path):
        found, inside = pyarrow.fs.FileSystem.from_uri(fspath(path))
        return found, inside
    return pyarrow.fs.LocalFileSystem(), fspath(path)

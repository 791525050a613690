"""Pages for a browser."""

from __future__ import annotations

import numpy as np
import pytest

from exact_ccd import Detector, Mesh, audit
from test_audits import frames
from test_meshes import FACES, two_triangles


def contacts_of(page) -> str:
    text = page.read_text("utf-8")
    assert text.startswith("<!doctype html>")
    return text


def test_the_page_of_a_step(tmp_path) -> None:
    file = tmp_path / "step.html"
    detector = Detector(Mesh(6, FACES))
    x0, x1 = two_triangles(1.0), two_triangles(-1.0)
    assert detector.step(x0, x1, view=file) == detector.step(x0, x1)
    text = contacts_of(file)
    assert "contact at t = 0.5: vertex 3 and face 0" in text and '"time":0.5' in text
    detector.step(x0, two_triangles(0.5), view=str(file))
    text = contacts_of(file)
    assert "free of contact" in text and '"contacts":[]' in text
    # An edge that meets a face at the start, which is no contact.
    detector.step(two_triangles(-1.0), two_triangles(-1.0), view=file)
    assert '"kind":"edge"' in contacts_of(file)


def test_the_page_of_an_audit(tmp_path) -> None:
    file = tmp_path / "audit.html"
    report = audit(frames(3, 1, -3, 1), FACES, view=file)
    assert report == audit(frames(3, 1, -3, 1), FACES)
    text = contacts_of(file)
    assert "step 1: contact at t = 0.25: vertex 3 and face 0" in text and '"time":0.25' in text
    assert "frame 2" in text and "frame 3" not in text
    audit(frames(3, 1), FACES, view=file)
    text = contacts_of(file)
    assert "free of contact" in text and "examined: 2 frames, and the straight motion between them" in text
    audit(frames(-1, 1), FACES, view=file)
    assert "frame 0: edge" in contacts_of(file)


def test_named_groups_are_the_bodies_of_a_page(tmp_path) -> None:
    file = tmp_path / "step.html"
    x0, x1 = two_triangles(1.0), two_triangles(-1.0)
    named = {"groups": [1, 1, 1, 0, 0, 0], "names": ["leaf", "floor"]}
    Detector(Mesh(6, FACES, **named)).step(x0, x1, view=file)
    text = contacts_of(file)
    assert '{"name":"floor","kind":"","vertices":{"start":0,"end":3}}' in text
    assert '{"name":"leaf","kind":"","vertices":{"start":3,"end":6}}' in text
    # The ids of the contact are those in its bodies, as in the line above it.
    assert "leaf: vertex 0 and floor: face 0" in text
    assert '{"kind":"vertex","id":0,"vertices":[3],"labels":[0]}' in text
    # A body whose vertices are not consecutive: the bodies of the page are the connected parts.
    mixed = {"groups": [1, 0, 1, 0, 0, 0], "names": ["leaf", "floor"]}
    Detector(Mesh(6, FACES, **mixed)).step(x0, x1, view=file)
    assert '"name":"leaf"' not in contacts_of(file)


def test_pages_of_files_and_errors(tmp_path) -> None:
    np.savez(tmp_path / "recording.npz", positions=frames(3, 1, -3), faces=FACES)
    audit(tmp_path / "recording.npz", view=tmp_path / "page.html")
    assert "recording.npz 2" in contacts_of(tmp_path / "page.html")
    with pytest.raises(OSError, match="nowhere"):
        audit(frames(3, 1), FACES, view=tmp_path / "nowhere" / "page.html")
    bad = frames(3, 2, 1)
    bad[1, 4, 2] = np.inf
    with pytest.raises(ValueError, match="frame 1: .*vertex 4 has z = inf"):
        audit(bad, FACES, view=tmp_path / "page.html")

"""Single candidates, by the names of ipctk."""

from __future__ import annotations

from typing import Any, NamedTuple, Union


class VertexVertexCandidate(NamedTuple):
    """Two vertices of no edge."""

    vertex0_id: int
    vertex1_id: int

    def vertex_ids(self, edges: Any, faces: Any) -> list[int]:
        """The vertices of both primitives."""
        return [self.vertex0_id, self.vertex1_id]


class EdgeVertexCandidate(NamedTuple):
    """An edge and a vertex."""

    edge_id: int
    vertex_id: int

    def vertex_ids(self, edges: Any, faces: Any) -> list[int]:
        """The vertex, then those of the edge."""
        return [self.vertex_id, *map(int, edges[self.edge_id])]


class EdgeEdgeCandidate(NamedTuple):
    """Two edges."""

    edge0_id: int
    edge1_id: int

    def vertex_ids(self, edges: Any, faces: Any) -> list[int]:
        """The vertices of both edges."""
        return [*map(int, edges[self.edge0_id]), *map(int, edges[self.edge1_id])]


class FaceVertexCandidate(NamedTuple):
    """A face and a vertex."""

    face_id: int
    vertex_id: int

    def vertex_ids(self, edges: Any, faces: Any) -> list[int]:
        """The vertex, then those of the face."""
        return [self.vertex_id, *map(int, faces[self.face_id])]


Candidate = Union[VertexVertexCandidate, EdgeVertexCandidate, EdgeEdgeCandidate, FaceVertexCandidate]
"""Two primitives that come near each other."""

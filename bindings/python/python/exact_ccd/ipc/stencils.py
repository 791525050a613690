"""Single candidates, by the names of ipctk."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Union


@dataclass(frozen=True)
class VertexVertexCandidate:
    """Two vertices of no edge.

    Parameters
    ----------
    vertex0_id, vertex1_id : int
        The indices of both primitives.
    """

    vertex0_id: int
    vertex1_id: int

    def vertex_ids(self, edges: Any, faces: Any) -> list[int]:
        """List the vertices of both primitives.

        Parameters
        ----------
        edges, faces : int arrays of shape (E, 2) and (F, 3)
            The edges and the faces of the mesh.

        Returns
        -------
        list of int
            The vertices of both primitives.
        """
        return [self.vertex0_id, self.vertex1_id]


@dataclass(frozen=True)
class EdgeVertexCandidate:
    """An edge and a vertex.

    Parameters
    ----------
    edge_id, vertex_id : int
        The indices of both primitives.
    """

    edge_id: int
    vertex_id: int

    def vertex_ids(self, edges: Any, faces: Any) -> list[int]:
        """List the vertices of both primitives.

        Parameters
        ----------
        edges, faces : int arrays of shape (E, 2) and (F, 3)
            The edges and the faces of the mesh.

        Returns
        -------
        list of int
            The vertex, then the vertices of the edge.
        """
        return [self.vertex_id, *map(int, edges[self.edge_id])]


@dataclass(frozen=True)
class EdgeEdgeCandidate:
    """Two edges.

    Parameters
    ----------
    edge0_id, edge1_id : int
        The indices of both primitives.
    """

    edge0_id: int
    edge1_id: int

    def vertex_ids(self, edges: Any, faces: Any) -> list[int]:
        """List the vertices of both primitives.

        Parameters
        ----------
        edges, faces : int arrays of shape (E, 2) and (F, 3)
            The edges and the faces of the mesh.

        Returns
        -------
        list of int
            The vertices of both edges.
        """
        return [*map(int, edges[self.edge0_id]), *map(int, edges[self.edge1_id])]


@dataclass(frozen=True)
class FaceVertexCandidate:
    """A face and a vertex.

    Parameters
    ----------
    face_id, vertex_id : int
        The indices of both primitives.
    """

    face_id: int
    vertex_id: int

    def vertex_ids(self, edges: Any, faces: Any) -> list[int]:
        """List the vertices of both primitives.

        Parameters
        ----------
        edges, faces : int arrays of shape (E, 2) and (F, 3)
            The edges and the faces of the mesh.

        Returns
        -------
        list of int
            The vertex, then the vertices of the face.
        """
        return [self.vertex_id, *map(int, faces[self.face_id])]


Candidate = Union[VertexVertexCandidate, EdgeVertexCandidate, EdgeEdgeCandidate, FaceVertexCandidate]
"""Two primitives that come near each other."""

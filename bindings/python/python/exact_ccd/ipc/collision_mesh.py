"""The collision mesh, by the names of ipctk."""

from __future__ import annotations

from collections.abc import Callable
from typing import Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._arrays import Floats, Indices, floats, frozen, indices
from .pairs import coordinates
from .primitives import edges as edges_of, primitives


class CollisionMesh:
    """A mesh in two or three dimensions, with the constructor of ``ipctk.CollisionMesh`` and some of its attributes.

    The attributes are those that collision detection needs.

    Parameters
    ----------
    rest_positions : array of shape (V, 2) or (V, 3)
        The positions of the vertices. Only their number and dimension are used.
    edges : int array of shape (E, 2), optional
        All edges, including the edges of faces; by default the edges of faces. An edge of no face is codimensional:
        a rod.
    faces : int array of shape (F, 3), optional
        The faces. A vertex of no edge is codimensional: a point.
    displacement_map : None
        Not supported: give positions to which the map has been applied.

    Attributes
    ----------
    can_collide : callable or None
        ``can_collide(i, j) -> bool`` for two vertices; may be replaced at any time. None for all pairs.

    Examples
    --------
    >>> mesh = CollisionMesh(np.zeros((5, 3)), faces=[[0, 1, 2]])
    >>> mesh.num_edges, mesh.codim_vertices.tolist()
    (3, [3, 4])
    """

    can_collide: Optional[Callable[[int, int], object]]

    def __init__(
        self,
        rest_positions: ArrayLike,
        edges: Optional[ArrayLike] = None,
        faces: Optional[ArrayLike] = None,
        displacement_map: object = None,
    ) -> None:
        if displacement_map is not None:
            raise ValueError("displacement_map is not supported: give positions to which it has been applied")
        self._rest: Floats = frozen(coordinates("rest_positions", rest_positions))
        self._faces: Indices = frozen(indices("faces", [] if faces is None else faces, (None, 3)))
        own = edges_of(self._faces) if edges is None else edges
        self._edges: Indices = frozen(indices("edges", own, (None, 2)))
        self.can_collide = None
        every = primitives(self)
        self._loose_vertices = frozen(every.loose_vertices)
        self._loose_edges = frozen(every.loose_edges)
        self._full = np.arange(len(self._rest))
        self._full_count = len(self._rest)

    @staticmethod
    def build_from_full_mesh(
        full_rest_positions: ArrayLike,
        edges: Optional[ArrayLike] = None,
        faces: Optional[ArrayLike] = None,
    ) -> CollisionMesh:
        """Build the mesh without the vertices of no edge and no face.

        Parameters
        ----------
        full_rest_positions, edges, faces : arrays
            As for the constructor.

        Returns
        -------
        CollisionMesh
            The mesh, whose vertices are numbered anew.

        Examples
        --------
        >>> mesh = CollisionMesh.build_from_full_mesh(np.zeros((4, 2)), edges=[[3, 1]])
        >>> mesh.num_vertices, mesh.edges.tolist(), mesh.to_full_vertex_id(1)
        (2, [[1, 0]], 3)
        """
        full = CollisionMesh(full_rest_positions, edges, faces)
        kept = np.setdiff1d(full._full, full._loose_vertices)
        number = np.zeros(full.num_vertices, np.int64)
        number[kept] = np.arange(len(kept))
        mesh = CollisionMesh(full._rest[kept], number[full._edges], number[full._faces])
        mesh._full, mesh._full_count = kept, full.num_vertices
        return mesh

    def __repr__(self) -> str:
        return (
            f"<exact_ccd.ipc.CollisionMesh: dimension {self.dim}, {self.num_vertices} vertices, "
            f"{self.num_edges} edges, {self.num_faces} faces>"
        )

    @property
    def rest_positions(self) -> NDArray[np.float64]:
        """The positions of the vertices at rest."""
        return self._rest

    @property
    def edges(self) -> NDArray[np.uint32]:
        """The edges, an array of shape (E, 2)."""
        return self._edges

    @property
    def faces(self) -> NDArray[np.uint32]:
        """The faces, an array of shape (F, 3)."""
        return self._faces

    @property
    def codim_vertices(self) -> NDArray[np.uint32]:
        """The vertices of no edge."""
        return self._loose_vertices

    @property
    def codim_edges(self) -> NDArray[np.uint32]:
        """The indices of the edges of no face."""
        return self._loose_edges

    @property
    def num_vertices(self) -> int:
        """The number of vertices."""
        return len(self._rest)

    @property
    def num_edges(self) -> int:
        """The number of edges."""
        return len(self._edges)

    @property
    def num_faces(self) -> int:
        """The number of faces."""
        return len(self._faces)

    @property
    def num_codim_vertices(self) -> int:
        """The number of vertices of no edge."""
        return len(self._loose_vertices)

    @property
    def num_codim_edges(self) -> int:
        """The number of edges of no face."""
        return len(self._loose_edges)

    @property
    def dim(self) -> int:
        """The dimension, 2 or 3."""
        return int(self._rest.shape[1])

    @property
    def ndof(self) -> int:
        """The number of coordinates."""
        return self._rest.size

    @property
    def full_num_vertices(self) -> int:
        """The number of vertices of the full mesh."""
        return self._full_count

    @property
    def full_ndof(self) -> int:
        """The number of coordinates of the full mesh."""
        return self._full_count * self.dim

    def to_full_vertex_id(self, id: int) -> int:
        """Find a vertex in the full mesh.

        Parameters
        ----------
        id : int
            The index of the vertex.

        Returns
        -------
        int
            Its index in the full mesh.
        """
        return int(self._full[id])

    def vertices(self, full_positions: ArrayLike) -> NDArray[np.float64]:
        """Take the positions of the vertices of this mesh from the positions of the full mesh.

        Parameters
        ----------
        full_positions : array of shape (F, 2) or (F, 3)
            The positions of all vertices of the full mesh.

        Returns
        -------
        float64 array of shape (V, 2) or (V, 3)
            The positions of the vertices of this mesh.
        """
        return floats("full_positions", full_positions, (self._full_count, self.dim))[self._full]

    def displace_vertices(self, full_displacements: ArrayLike) -> NDArray[np.float64]:
        """Add displacements to the positions at rest.

        Parameters
        ----------
        full_displacements : array of shape (F, 2) or (F, 3)
            The displacements of all vertices of the full mesh.

        Returns
        -------
        float64 array of shape (V, 2) or (V, 3)
            The positions of the vertices of this mesh.
        """
        return self._rest + floats("full_displacements", full_displacements, (self._full_count, self.dim))[self._full]

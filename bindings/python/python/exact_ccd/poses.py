"""Poses of rigid bodies."""

from __future__ import annotations

from typing import NamedTuple, Protocol, Union, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Floats, floats
from ._records import by_value


class Rotation(Protocol):
    """Rotations of ``scipy.spatial.transform``."""

    def as_quat(self) -> NDArray[np.float64]:
        """The quaternions x, y, z, w."""
        ...


Poses = Union[ArrayLike, tuple[ArrayLike, Rotation]]
"""An array (B, 7) of places and quaternions, scalar first; or the places (B, 3) and their rotations."""


def poses(name: str, given: Poses, count: int) -> Floats:
    """The poses of so many bodies as a contiguous array of shape (B, 7)."""
    if isinstance(given, tuple) and len(given) == 2 and hasattr(given[1], "as_quat"):
        places, rotation = given
        x, y, z, w = floats(f"the rotations of {name}", rotation.as_quat(), (count, 4)).T
        return np.column_stack([floats(f"the places of {name}", places, (count, 3)), w, x, y, z])
    return floats(name, cast(ArrayLike, given), (count, 7))


@by_value
class NearestPoses(NamedTuple):
    """The poses next to matrices, see :func:`nearest_poses`.

    Attributes
    ----------
    poses : float64 array of shape (B, 7)
        The poses.
    deviations : float64 array of shape (B,)
        For each matrix, the largest difference of its numbers from the matrix of the pose, in rounded numbers.
    """

    poses: NDArray[np.float64]
    deviations: NDArray[np.float64]


def nearest_poses(matrices: ArrayLike) -> NearestPoses:
    """Compute the poses next to matrices of rigid motion.

    Parameters
    ----------
    matrices : array of shape (B, 4, 4)
        For each body, the matrix that takes a point of the body to the world, with the last row 0, 0, 0, 1. A
        reflection or a scaling has no pose: it shows in the deviation.

    Returns
    -------
    NearestPoses
        The poses with the places and the nearest rotations, and the deviations of their matrices.

    Raises
    ------
    ValueError
        If the shape differs, a number is not finite, or a last row is another one: the message has the index of
        the body.

    Examples
    --------
    >>> from exact_ccd import nearest_poses
    >>> turn = [[0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]]
    >>> poses, deviations = nearest_poses([turn])
    >>> (poses.round(6) + 0.0).tolist(), bool(deviations[0] < 1e-15)
    ([[5.0, 6.0, 7.0, 0.707107, 0.0, 0.0, 0.707107]], True)
    """
    given = floats("matrices", matrices, (None, 4, 4))
    wrong = ~np.isfinite(given).all(axis=(1, 2))
    if wrong.any():
        raise ValueError(f"matrices: body {np.argmax(wrong)}: a number is not finite")
    wrong = (given[:, 3] != [0, 0, 0, 1]).any(axis=1)
    if wrong.any():
        raise ValueError(f"matrices: body {np.argmax(wrong)}: the last row is not 0, 0, 0, 1: is it transposed?")
    poses = np.concatenate([given[:, :3, 3], _quaternions(given[:, :3, :3])], axis=1)
    deviations = np.abs(_matrices(poses[:, 3:]) - given[:, :3, :3]).max(axis=(1, 2), initial=0.0)
    return NearestPoses(poses, deviations)


def _quaternions(matrices: Floats) -> Floats:
    """The unit quaternions, scalar first and not negative, of the nearest rotations.

    For a rotation R with the unit quaternion q, the trace of Rᵀ M is a quadratic form of q. Its eigenvector with the
    largest eigenvalue has the largest trace, hence the least sum of squares of M − R.
    """
    (a, b, c), (d, e, f), (g, h, i) = np.moveaxis(matrices, 0, -1)
    form = np.array(
        [
            [a + e + i, h - f, c - g, d - b],
            [h - f, a - e - i, b + d, c + g],
            [c - g, b + d, e - a - i, f + h],
            [d - b, c + g, f + h, i - a - e],
        ]
    )
    quaternions: Floats = np.linalg.eigh(np.moveaxis(form, -1, 0))[1][:, :, -1]
    return np.where(quaternions[:, :1] < 0, -quaternions, quaternions)


def _matrices(quaternions: Floats) -> Floats:
    """The matrices of unit quaternions, scalar first."""
    w, x, y, z = quaternions.T
    rows = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
    return np.moveaxis(np.array(rows), -1, 0)

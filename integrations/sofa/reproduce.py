"""The order of arguments in CCDTightInclusionIntersection of SOFA, for two lines: which contacts it loses and invents.

Needs numpy, ipctk (the same Tight Inclusion) and exact_ccd: python integrations/sofa/reproduce.py
"""

import ipctk
import numpy as np

from exact_ccd import Queries

COUNT = 10_000

random = np.random.default_rng(7)
# Edges of about length 1 around the origin, and motion of about length 1.
x0 = random.uniform(-1, 1, (COUNT, 4, 3))
x1 = x0 + random.uniform(-1, 1, (COUNT, 4, 3))

exact = Queries("ee", x0, x1).collides()

# Tight Inclusion takes both ends of one edge, then both ends of the other; SOFA passes the first ends of both, then the
# second ends of both.
in_order, crosswise = [0, 1, 2, 3], [0, 2, 1, 3]
tight_inclusion = ipctk.TightInclusionCCD()


def answers(order: list[int]) -> np.ndarray:
    """For each pair of edges, true if it collides, with the arguments in this order."""
    calls = (tight_inclusion.edge_edge_ccd(*a[order], *b[order])[0] for a, b in zip(x0, x1))
    return np.fromiter(calls, bool, COUNT)


print(f"{COUNT} pairs of edges, {exact.sum()} in contact")
for name, order in ("in order", in_order), ("as in SOFA", crosswise):
    found = answers(order)
    print(f"{name}: {(exact & ~found).sum()} contacts lost, {(found & ~exact).sum()} invented")

"""Large sets of queries and long recordings, on one machine or many, by Ray.

``pip install 'ray[data]' pyarrow`` installs what is needed. Without a cluster, the work runs on the cores of this
machine; ``ray.init`` with an address, or the variable ``RAY_ADDRESS``, connects to a cluster. All its
machines need this package.

- :func:`answer_files` answers for the queries in Parquet files.
- :func:`audit` certifies a recording, in chunks of frames.
- The program ``exact-ccd-ray`` does both with files.
"""

from .audits import audit
from .queries import answer_files

__all__ = ["answer_files", "audit"]

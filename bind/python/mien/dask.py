"""A plan's files on a Dask cluster (docs/scale.md). Queue, retries and places are Dask's.

    import dask.distributed, mien.dask
    client = dask.distributed.Client("scheduler:8786")
    client.gather(mien.dask.submit("crowd.json", client, "/shared/crowd"))
    mien.dask.join("crowd.json", "/shared/crowd")

Workers need this package and the command `mien`, and see plan and folder under the same names.
"""
from __future__ import annotations

import os
from typing import Any, Optional

from . import _command
from ._errors import Error, Path
from ._kinds import said
from ._library import hinted

__all__ = ["join", "submit"]


def _draw(plan: str, folder: str, part: int, of: int) -> str:
    """What a worker does: a part that was begun elsewhere goes on where that one ended."""
    return _command.run("mien.dask", "batch", plan, "-o", folder, "--part", f"{part}/{of}").strip()


@hinted
def submit(plan: Path, client: Any, folder: Path, parts: Optional[int] = None, retries: int = 3) -> "list[Any]":
    """A future for each part of a plan, which `mien batch` draws into the folder; its result is the sentence that the command prints.
    `parts`: four for each thread of the cluster, unless it is said. A worker that is lost is Dask's to replace."""
    if not hasattr(client, "nthreads") or not hasattr(client, "submit"):
        raise TypeError(f"client: expected a dask.distributed.Client, got {said(client)}")
    if parts is None:
        parts = max(4 * sum(client.nthreads().values()), 1)
    if parts < 1:
        raise Error("parts", f"expected 1 or more, got {parts}")
    words = os.path.abspath(plan), os.path.abspath(folder)
    return [client.submit(_draw, *words, part, parts, retries=retries, pure=False) for part in range(1, parts + 1)]


@hinted
def join(plan: Path, folder: Path) -> str:
    """Here: whether every file of the plan is there and whole, and pictures and films of pieces, as `mien join` makes them."""
    return _command.run("mien.dask", "join", os.path.abspath(plan), os.path.abspath(folder)).strip()

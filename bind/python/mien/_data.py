"""Tables as faces, and the pictures of experiments: by the command, which has them (docs/data.md)."""
from __future__ import annotations

import contextlib
import csv
import json
import math
import numbers
import os
import pathlib
import tempfile
from typing import Any, Iterable, Iterator, Mapping, Optional, Sequence, Union

import numpy
import numpy.typing

from . import _command
from ._errors import Error, Path, reading
from ._library import hinted, said
from ._picture import whole
from ._png import pixels as unpacked
from ._saved import Picture

Plan = Union[Path, Mapping[str, Any]]
_DATA = 'a data frame, {"column": [values]}, a list of records, or a path of a CSV file'


class Chernoff(Picture):
    """A table as faces, a face a row. A notebook shows it."""

    def __init__(self, pixels: numpy.typing.NDArray[numpy.uint8], legend: numpy.typing.NDArray[numpy.uint8],
                 manifest: "tuple[dict[str, str], ...]") -> None:
        super().__init__(pixels)
        self.legend = Picture(legend)  # what each column moves: its least, middle and largest value
        self.manifest = manifest       # a record for each row: its values, what they became, and the face's SHA-256


class Stimuli:
    """The pictures of an experiment, in a folder."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.folder = folder
        self.manifest: Mapping[str, Any] = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))

    @property
    def records(self) -> "list[dict[str, Any]]":
        """What the manifest tells of each picture: its file and levels, the face in full, its controls."""
        return list(self.manifest["stimuli"])

    @property
    def table(self) -> "list[dict[str, Any]]":
        """A row for each picture, for pandas.DataFrame or csv.DictWriter: its file, its levels, numbers as numbers, how far the pose
        moves the face."""
        return [{"file": one["file"], **{name: _number_or_word(level) for name, level in one["levels"].items()},
                 "displacement": one["displacement"]} for one in self.records]

    @property
    def files(self) -> "tuple[pathlib.Path, ...]":
        """The pictures' files, in the manifest's order."""
        return tuple(self.folder / one["file"] for one in self.records)

    def __len__(self) -> int:
        return len(self.records)

    def __repr__(self) -> str:
        return f"<mien.Stimuli {str(self.folder)!r}: {len(self)} pictures>"


@hinted
def chernoff(data: Any, map: Union[Plan, Sequence[Mapping[str, Any]], None] = None, *, label: Optional[str] = None, style: Optional[str] = None, cell: int = 160, columns: int = 10,
             gap: int = 0) -> Chernoff:
    """Draws each row of a table as a face.

    data     a data frame of pandas or polars, {"column": [values]}, a list of records, or a path of a CSV file
    map      which column moves what: a list such as [{"column": "GDP", "emotion": "joy"}], a whole map as docs/data.md has it, or a
             path of one; without it columns of numbers move, in their order, what people read most exactly
    label    the column that names the faces, beside a map that is no file; without a map it is the first that is not of numbers
    style    how faces are painted
    cell     pixels of a face's longer side
    columns  faces in a row

    What is odd, such as a column that is left out since a value is missing, is a `mien.Warned`.
    """
    if label is not None and (map is None or isinstance(map, (str, os.PathLike))):
        raise Error("label", "goes with a map, as a list or a mapping; a map's file says it itself")
    with tempfile.TemporaryDirectory(prefix="mien-") as folder:
        place = pathlib.Path(folder)
        words = ["chernoff", _table_file(data, place), "-o", place / "faces.png", "--legend", place / "legend.png", "--manifest", place / "all.csv",
                 "--cell", str(whole(cell, "cell")), "--columns", str(whole(columns, "columns")), "--gap", str(whole(gap, "gap"))]
        if map is not None:
            rules: Any = {"map": list(map)} if isinstance(map, (list, tuple)) else map
            if label is not None and isinstance(rules, Mapping):
                rules = {**rules, "label": label}
            words += ["--map", _plan_file(rules, place / "map.json", "mien-chernoff", "map")]
        if style is not None:
            words += ["--style", style]
        with _reading(data, map):
            _command.run("chernoff", *words, instead={str(place / "table.csv"): "data", str(place / "map.json"): "map"})
        with open(place / "all.csv", encoding="utf-8", newline="") as file:
            records = tuple(csv.DictReader(file))
        return Chernoff(unpacked((place / "faces.png").read_bytes()), unpacked((place / "legend.png").read_bytes()), records)


@hinted
def stimuli(plan: Plan, folder: Path) -> Stimuli:
    """Draws the pictures of an experiment into a folder, and manifest.json, which can draw them again.

    `plan` is what docs/data.md says, as a mapping or a path: {"size": 256, "factors": [{"name": "joy", "emotion": "joy", "steps": 5}]};
    or a manifest, whose pictures must become the same bytes. What is odd is a `mien.Warned`.
    """
    with tempfile.TemporaryDirectory(prefix="mien-") as scratch:
        file = _plan_file(plan, pathlib.Path(scratch, "plan.json"), "mien-stimuli", "plan")
        with _reading(plan):
            _command.run("stimuli", "stimuli", file, "-o", folder, instead={str(pathlib.Path(scratch, "plan.json")): "plan"})
    return Stimuli(pathlib.Path(folder))


def _number_or_word(level: Any) -> Any:
    try:
        return float(level)
    except (TypeError, ValueError):
        return level


def _is_list(map: Any) -> bool:
    return isinstance(map, Sequence) and not isinstance(map, (str, bytes))


def _plan_file(plan: Any, made: pathlib.Path, format: str, name: str) -> Path:
    """A path as it is; of a mapping a file, whose format need not be said."""
    if isinstance(plan, (str, os.PathLike)):
        return plan
    if not isinstance(plan, Mapping):
        raise TypeError(f"{name}: expected a mapping or a path, got {said(plan)}")
    try:
        made.write_text(json.dumps({"format": format, "format_version": 1, **plan}, default=_plain), encoding="utf-8")
    except (TypeError, ValueError) as failure:
        raise TypeError(f"{name}: cannot be JSON: {failure}") from None
    return made


def _plain(value: Any) -> Any:
    if isinstance(value, (numpy.generic, numpy.ndarray)):
        return value.tolist()
    raise TypeError(f"{said(value)} is of no kind that JSON has")


@contextlib.contextmanager
def _reading(*given: Any) -> Iterator[None]:
    """What is wrong with a file among what was given is an OSError, as of all files."""
    with contextlib.ExitStack() as files:
        for one in given:
            if isinstance(one, (str, os.PathLike)):
                files.enter_context(reading(one))
        yield


def _table_file(data: Any, folder: pathlib.Path) -> Path:
    if isinstance(data, (str, os.PathLike)):
        return data
    heading, rows = _rows(data)
    made = folder / "table.csv"
    with open(made, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(heading)
        writer.writerows([_cell(one) for one in row] for row in rows)
    return made


def _rows(data: Any) -> "tuple[list[str], Iterable[Sequence[Any]]]":
    """A table's heading and rows, whatever holds it."""
    if hasattr(data, "itertuples") and hasattr(data, "columns"):  # pandas
        return [str(one) for one in data.columns], data.itertuples(index=False, name=None)
    if hasattr(data, "iter_rows") and hasattr(data, "columns"):   # polars
        return [str(one) for one in data.columns], data.iter_rows()
    if isinstance(data, numpy.ndarray) and data.dtype.names:
        return list(data.dtype.names), data.tolist()
    if isinstance(data, Mapping):
        return _rows_of_columns({str(name): list(values) if hasattr(values, "__iter__") and not isinstance(values, str) else values
                                 for name, values in data.items()})
    if _is_list(data) or isinstance(data, Iterator):
        records = list(data)
        if records and all(isinstance(one, Mapping) for one in records):
            heading = list(dict.fromkeys(str(name) for one in records for name in one))
            return heading, ([one.get(name) for name in heading] for one in records)
    raise TypeError(f"data: expected {_DATA}, got {said(data)}")


def _rows_of_columns(table: "dict[str, Any]") -> "tuple[list[str], Iterable[Sequence[Any]]]":
    for name, values in table.items():
        if not isinstance(values, list):
            raise TypeError(f"data[{name!r}]: expected a list of values, got {said(values)}")
    lengths = {len(values) for values in table.values()}
    if len(lengths) > 1:
        told = ", ".join(f"{name!r} has {len(values)}" for name, values in table.items())
        raise Error("data", f"expected columns of one length: {told}")
    return list(table), zip(*table.values())


def _cell(value: Any) -> str:
    """A value as CSV has it: what is missing is empty, as of None, NaN and pandas.NA."""
    if value is None or isinstance(value, float) and math.isnan(value) or type(value).__name__ in ("NAType", "NaTType"):
        return ""
    if isinstance(value, bool) or isinstance(value, numpy.bool_):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value)) if not isinstance(value, numbers.Integral) else str(int(value))
    return str(value)

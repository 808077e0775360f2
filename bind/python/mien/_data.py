"""Tables as faces, and the pictures of experiments: by the command, which has them (docs/data.md)."""
from __future__ import annotations

import contextlib
import csv
import io
import json
import math
import numbers
import os
import pathlib
import tempfile
import warnings
from typing import Any, Iterable, Iterator, Mapping, Optional, Sequence, Union

import numpy
import numpy.typing

from . import _command
from ._errors import Error, Path, Warned, reading
from ._kinds import path as path_of
from ._kinds import said, whole, word
from ._library import hinted, unknown_name
from ._png import pixels as unpacked
from ._saved import File, Picture, save, write_whole
from .people import styles

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

    @hinted
    def __init__(self, folder: Path) -> None:
        """Those that `stimuli` drew there, now or earlier."""
        self.folder = pathlib.Path(folder)
        with reading(self.folder / "manifest.json"):
            self.manifest: Mapping[str, Any] = _manifest(self.folder / "manifest.json")

    @property
    def records(self) -> "list[dict[str, Any]]":
        """What the manifest tells of each picture: its file and levels, the face in full, its controls."""
        return list(self.manifest["stimuli"])

    @property
    def table(self) -> "list[dict[str, Any]]":
        """A row for each picture, for pandas.DataFrame or csv.DictWriter: its file, its levels, numbers as numbers, how far the pose
        moves the face, and the file's SHA-256. A factor with the name of another column is "factor.NAME"."""
        return [{"file": one["file"], **{_column(name): _number_or_word(level) for name, level in one["levels"].items()},
                 "displacement": one["displacement"], "sha256": one["sha256"]} for one in self.records]

    @hinted
    def save(self, file: File) -> None:
        """Writes the table as CSV, a row for each picture, into a path or a file object. It appears whole or not at all."""
        def run(path: Path, kind: str) -> None:
            if kind != "csv":
                raise Error(os.fspath(path), "expected a name that ends with .csv: a table is written as CSV")
            rows, words = self.table, io.StringIO()
            writer = csv.DictWriter(words, list(dict.fromkeys(name for row in rows for name in row)), lineterminator="\n")
            writer.writeheader()
            writer.writerows({name: _cell(value) for name, value in row.items()} for row in rows)
            write_whole(path, words.getvalue().encode())

        save(file, "csv" if hasattr(file, "write") else None, run)

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
    label    the column that names the faces; without a map it then moves nothing, and without a label it is the first that is not of
             numbers. A map that is a file says its label itself
    style    how faces are painted
    cell     pixels of a face's longer side
    columns  faces in a row

    What is odd, such as a column that is left out since a value is missing, is a `mien.Warned`.
    """
    if label is not None and isinstance(map, (str, os.PathLike)):
        raise Error("label", "goes with no map that is a file, which says it itself")
    if style is not None and style not in styles():
        raise Error("style", unknown_name("style", style, styles()))
    with tempfile.TemporaryDirectory(prefix="mien-") as folder:
        place = pathlib.Path(folder)
        table = _table_file(data, place)
        words = ["chernoff", table, "-o", place / "faces.png", "--legend", place / "legend.png", "--manifest", place / "all.csv",
                 "--cell", str(whole(cell, "cell")), "--columns", str(whole(columns, "columns")), "--gap", str(whole(gap, "gap"))]
        if label is not None and map is None:
            with _reading(data):
                map, odd = _automatic_map(table, label, place)
            for line in odd:
                warnings.warn(line, Warned, stacklevel=3)  # who called mien.chernoff
        words += [*_map_words(map, label, place), *([] if style is None else ["--style", style])]
        with _reading(data, map), _labelled(label):
            _command.run("chernoff", *words, instead={str(place / "table.csv"): "data", str(place / "map.json"): "map"})
        with open(place / "all.csv", encoding="utf-8", newline="") as file:
            records = tuple(csv.DictReader(file))
        return Chernoff(unpacked((place / "faces.png").read_bytes()), unpacked((place / "legend.png").read_bytes()), records)


def _map_words(map: Any, label: Optional[str], place: pathlib.Path) -> "list[Path]":
    """The map and its label in the command's words."""
    if map is None:
        return []
    rules: Any = {"map": list(map)} if isinstance(map, (list, tuple)) else map
    if label is not None and isinstance(rules, Mapping):
        rules = {**rules, "label": label}
    return ["--map", _plan_file(rules, place / "map.json", "mien-chernoff", "map")]


@contextlib.contextmanager
def _labelled(label: Optional[str]) -> Iterator[None]:
    """What is wrong with a label that was an argument is told of the argument."""
    try:
        yield
    except Error as error:
        _, found, sentence = str(error).partition("/label: ")
        if label is None or not found:
            raise
        raise Error("label", sentence) from None


def _automatic_map(table: Path, label: str, place: pathlib.Path) -> "tuple[list[dict[str, str]], list[str]]":
    """What the command moves by itself, without the label's column, and what it tells of columns that are not shown."""
    instead = {str(place / "table.csv"): "data"}
    _, told = _command.ran("chernoff", "chernoff", table, "-o", place / "first.png", "--manifest", place / "first.csv", "--cell", "16", instead=instead)
    with open(place / "first.csv", encoding="utf-8", newline="") as file:
        heading = next(csv.reader(file))[1:-1]  # between the face and its hash, each column beside what it moves
    columns = [one for one in heading[::2] if one != label]
    if not columns:
        raise Error("label", f"{said(label)} is the one column of numbers, and nothing is left to move a face")
    return ([{"column": column, "number": number} for column, number in zip(columns, heading[1::2])],
            [line for line in told if line.endswith("not shown") and f'column "{label}": ' not in line])


@hinted
def stimuli(plan: Plan, folder: Path) -> Stimuli:
    """Draws the pictures of an experiment into a folder, and manifest.json, which can draw them again.

    `plan` is what docs/data.md says, as a mapping or a path: {"size": 256, "factors": [{"name": "joy", "emotion": "joy", "steps": 5}]};
    or a manifest, whose pictures must become the same bytes. What is odd is a `mien.Warned`.
    """
    with tempfile.TemporaryDirectory(prefix="mien-") as scratch:
        file = _plan_file(_with_words(plan), pathlib.Path(scratch, "plan.json"), "mien-stimuli", "plan")
        with _reading(plan):
            _command.run("stimuli", "stimuli", file, "-o", folder, instead={str(pathlib.Path(scratch, "plan.json")): "plan"})
    return Stimuli(pathlib.Path(folder))


def _manifest(file: pathlib.Path) -> Any:
    try:
        found = json.loads(file.read_bytes())
    except ValueError as failure:
        raise Error(str(file), f"is no JSON: {failure}") from None
    if not isinstance(found, dict) or not isinstance(found.get("stimuli"), list):
        raise Error(str(file), "is no manifest of stimuli")
    return found


def _column(name: str) -> str:
    """What a factor's column is called."""
    return f"factor.{name}" if name in ("file", "displacement", "sha256") else name


def _with_words(plan: Any) -> Any:
    """The plan, whose seeds may be whole numbers: they are words to the command."""
    if not isinstance(plan, Mapping):
        return plan
    made = dict(plan)
    if isinstance(made.get("factors"), (list, tuple)):
        made["factors"] = [_seeded(one, f"plan: factors[{i}].seed") for i, one in enumerate(made["factors"])]
    return _seeded(made, "plan: seed")


def _seeded(of: Any, name: str) -> Any:
    return {**of, "seed": word(of["seed"], name)} if isinstance(of, Mapping) and "seed" in of else of


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
        return path_of(plan, name)
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
        return path_of(data, "data")
    heading, rows = _rows(data)
    made = folder / "table.csv"
    with open(made, "w", encoding="utf-8", errors="surrogatepass", newline="") as file:  # of which the command tells where it is
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

"""What a face tells of itself."""
from __future__ import annotations

from typing import NamedTuple, Union


class Canvas(NamedTuple):
    """What a picture of a face shows [face units]."""

    box: tuple[float, float, float, float]  # x0, y0, x1, y1
    y_up: bool
    mirror_x: float
    unit: str

    @property
    def aspect(self) -> float:
        return (self.box[2] - self.box[0]) / (self.box[3] - self.box[1])


class Name(NamedTuple):
    """Something that can be set."""

    name: str
    unit: str
    range: tuple[float, float]
    value: Union[float, tuple[float, ...]]  # at rest
    is_control: bool  # else a slice of the face's numbers
    is_pose: bool     # a control that is the weight of a pose
    begin: int        # a slice: where its numbers begin in the vector; a control: -1

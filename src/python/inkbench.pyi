"""Draws outlines, traces exact ones and scores one against the other.

Images are arrays of uint8, (height, width), row 0 the top.
"""

from os import PathLike
from typing import Any, Callable, Final, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray
from typing_extensions import TypedDict, Unpack

class Error(ValueError):
    """Bad input, with the sentence that the program would print."""

class TooLarge(MemoryError):
    """A view has too many lines to trace."""

_Point = Union[str, Sequence[float], NDArray[Any]]
_Size = Union[str, tuple[int, int]]
_Scene = Union[str, PathLike[str]]
_Settings = Mapping[str, Any]

class _Views(TypedDict, total=False):
    size: _Size  # "1280x720"
    views: Union[int, str]
    up: str  # "x", "y" or "z", of views by name
    projection: Union[str, Sequence[str]]
    fit: str
    margin: Optional[float]
    objects: Sequence[str]
    time_s: Optional[float]
    frame: Optional[int]
    animation: Union[int, str]
    seams: str  # "objects"

class Camera:
    def __init__(
        self,
        eye: _Point,
        target: Optional[_Point] = None,
        up: _Point = (0, 1, 0),
        fov_deg: float = 40.0,
        size: _Size = (1280, 720),
        parallel_height: Optional[float] = None,
    ) -> None: ...

class Buffers:
    depth: Final[NDArray[np.float32]]
    normal: Final[NDArray[np.float32]]
    object: Final[NDArray[np.uint32]]
    patch: Final[NDArray[np.uint32]]
    triangle: Final[NDArray[np.uint32]]
    material: Final[NDArray[np.uint32]]
    view: Final[dict[str, Any]]

class Truth:
    labels: Final[NDArray[np.uint8]]
    below_crease: Final[NDArray[np.uint8]]
    sampled: Final[NDArray[np.uint8]]
    exact_corner: Final[NDArray[np.uint8]]
    curves: Final[NDArray[Any]]
    crowded_share: Final[float]
    trace_s: Final[float]

class ClassScore:
    name: Final[str]
    label: Final[int]
    k: Final[int]
    n_truth: Final[int]

class Score:
    f: Final[Optional[float]]
    precision: Final[Optional[float]]
    recall: Final[Optional[float]]
    k: Final[int]
    n_pred: Final[int]
    n_truth: Final[int]
    unmatched_duplicates: Final[int]
    false_positives: Final[int]
    unmatched_truth: Final[int]
    false_negatives: Final[int]
    mean_width_px: Final[float]
    classes: Final[list[ClassScore]]

def methods() -> list[dict[str, Any]]: ...
def truth(
    scene: _Scene,
    view: Union[str, Camera] = "",
    *,
    crease_deg: float = 40,
    creases: str = "angle",
    weld_epsilon: float = 0,
    intersections: str = "above_crease",
    threads: int = ...,
    **views: Unpack[_Views],
) -> Truth: ...
def draw(
    method: str,
    scene: _Scene,
    view: Union[str, Camera] = "",
    *,
    settings: _Settings = {},
    threads: int = 1,
    skips_off: Sequence[str] = (),
    **views: Unpack[_Views],
) -> NDArray[np.uint8]: ...
def layers(
    method: str,
    scene: _Scene,
    view: Union[str, Camera] = "",
    *,
    settings: _Settings = {},
    threads: int = 1,
    skips_off: Sequence[str] = (),
    **views: Unpack[_Views],
) -> dict[str, NDArray[Any]]: ...
def buffers(
    scene: _Scene,
    view: Union[str, Camera] = "",
    *,
    crease_deg: float = 40,
    **views: Unpack[_Views],
) -> Buffers: ...
def compare(
    scenes: Union[_Scene, Sequence[_Scene]],
    functions: Mapping[str, Callable[[Buffers], NDArray[np.uint8]]] = {},
    cameras: Union[Camera, Sequence[Camera]] = (),
    *,
    methods: Union[str, Sequence[str]] = (),
    presets: Sequence[str] = (),
    entrants: Sequence[str] = (),
    settings: _Settings = {},
    threads: int = 1,
    crease_deg: float = 40,
    creases: str = "angle",
    weld_epsilon: float = 0,
    intersections: str = "above_crease",
    repetitions: int = 60,
    budget_ms: float = 20,
    times: bool = True,
    crosscheck: bool = True,
    full_scores: bool = True,
    skips_off: Sequence[str] = (),
    antialias: Union[str, Sequence[str]] = "none",
    coverage: bool = False,
    line_width_px: float = 1.5,
    seed: int = 0,
    **views: Unpack[_Views],
) -> list[dict[str, Any]]: ...
def score(
    edges: NDArray[np.uint8],
    truth: Union[Truth, NDArray[np.uint8]],
    *,
    tolerance_px: float = 2.0,
    threshold: int = 128,
    thin: bool = True,
    band_px: Optional[int] = None,
    ignore: Optional[int] = None,
) -> Score: ...

"""Draws outlines, traces exact ones and scores one against the other.

Images are arrays of uint8, (height, width), row 0 the top.
"""

from os import PathLike
from typing import Any, Callable, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

class Error(ValueError):
    """Bad input, with the sentence that the program would print."""

class TooLarge(MemoryError):
    """A view has too many lines to trace."""

_Point = Union[str, Sequence[float], NDArray[Any]]
_Size = Union[str, tuple[int, int]]
_Scene = Union[str, PathLike[str]]
_Settings = Mapping[str, Any]

class Camera:
    def __init__(
        self,
        eye: _Point,
        target: Optional[_Point] = None,
        up: _Point = (0, 1, 0),
        fov_deg: float = 40.0,
        size: _Size = (1280, 720),
    ) -> None: ...
    @property
    def eye(self) -> _Point: ...
    @property
    def target(self) -> Optional[_Point]: ...
    @property
    def up(self) -> _Point: ...
    @property
    def fov_deg(self) -> float: ...
    @property
    def size(self) -> _Size: ...

class Buffers:
    @property
    def depth(self) -> NDArray[np.float32]: ...
    @property
    def normal(self) -> NDArray[np.float32]: ...
    @property
    def object(self) -> NDArray[np.uint32]: ...
    @property
    def patch(self) -> NDArray[np.uint32]: ...
    @property
    def triangle(self) -> NDArray[np.uint32]: ...
    @property
    def material(self) -> NDArray[np.uint32]: ...
    @property
    def view(self) -> dict[str, Any]: ...

class Truth:
    @property
    def labels(self) -> NDArray[np.uint8]: ...
    @property
    def below_crease(self) -> NDArray[np.uint8]: ...
    @property
    def sampled(self) -> NDArray[np.uint8]: ...
    @property
    def exact_corner(self) -> NDArray[np.uint8]: ...
    @property
    def curves(self) -> NDArray[Any]: ...
    @property
    def crowded_share(self) -> float: ...
    @property
    def trace_s(self) -> float: ...

class ClassScore:
    @property
    def name(self) -> str: ...
    @property
    def label(self) -> int: ...
    @property
    def k(self) -> int: ...
    @property
    def n_truth(self) -> int: ...

class Score:
    @property
    def f(self) -> Optional[float]: ...
    @property
    def precision(self) -> Optional[float]: ...
    @property
    def recall(self) -> Optional[float]: ...
    @property
    def k(self) -> int: ...
    @property
    def n_pred(self) -> int: ...
    @property
    def n_truth(self) -> int: ...
    @property
    def unmatched_duplicates(self) -> int: ...
    @property
    def false_positives(self) -> int: ...
    @property
    def unmatched_truth(self) -> int: ...
    @property
    def false_negatives(self) -> int: ...
    @property
    def mean_width_px(self) -> float: ...
    @property
    def classes(self) -> list[ClassScore]: ...

def scenes() -> list[dict[str, Any]]: ...
def methods() -> list[dict[str, Any]]: ...
def truth(
    scene: _Scene,
    view: Union[str, Camera] = "",
    *,
    crease_deg: float = 40,
    weld_epsilon: float = 0,
    intersections: str = "above_crease",
    threads: int = ...,
    size: _Size = "1280x720",
    views: Union[int, str] = "",
    fit: str = "",
    margin: Optional[float] = None,
    objects: Sequence[str] = (),
    time_s: Optional[float] = None,
    frame: Optional[int] = None,
    animation: Union[int, str] = "",
    seams: str = "objects",
) -> Truth: ...
def draw(
    method: str,
    scene: _Scene,
    view: Union[str, Camera] = "",
    *,
    settings: _Settings = {},
    threads: int = 1,
    skips_off: Sequence[str] = (),
    size: _Size = "1280x720",
    views: Union[int, str] = "",
    fit: str = "",
    margin: Optional[float] = None,
    objects: Sequence[str] = (),
    time_s: Optional[float] = None,
    frame: Optional[int] = None,
    animation: Union[int, str] = "",
    seams: str = "objects",
) -> NDArray[np.uint8]: ...
def layers(
    method: str,
    scene: _Scene,
    view: Union[str, Camera] = "",
    *,
    settings: _Settings = {},
    threads: int = 1,
    skips_off: Sequence[str] = (),
    size: _Size = "1280x720",
    views: Union[int, str] = "",
    fit: str = "",
    margin: Optional[float] = None,
    objects: Sequence[str] = (),
    time_s: Optional[float] = None,
    frame: Optional[int] = None,
    animation: Union[int, str] = "",
    seams: str = "objects",
) -> dict[str, NDArray[Any]]: ...
def buffers(
    scene: _Scene,
    view: Union[str, Camera] = "",
    *,
    crease_deg: float = 40,
    size: _Size = "1280x720",
    views: Union[int, str] = "",
    fit: str = "",
    margin: Optional[float] = None,
    objects: Sequence[str] = (),
    time_s: Optional[float] = None,
    frame: Optional[int] = None,
    animation: Union[int, str] = "",
    seams: str = "objects",
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
    weld_epsilon: float = 0,
    intersections: str = "above_crease",
    repetitions: int = 15,
    budget_ms: float = 30,
    times: bool = True,
    crosscheck: bool = True,
    full_scores: bool = True,
    skips_off: Sequence[str] = (),
    seed: int = 0,
    size: _Size = "1280x720",
    views: Union[int, str] = "",
    fit: str = "",
    margin: Optional[float] = None,
    objects: Sequence[str] = (),
    time_s: Optional[float] = None,
    frame: Optional[int] = None,
    animation: Union[int, str] = "",
    seams: str = "objects",
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
def score_curve(
    edges: NDArray[np.uint8],
    truth: Union[Truth, NDArray[np.uint8]],
    *,
    tolerance_px: float = 2.0,
    thin: bool = True,
    band_px: Optional[int] = None,
    ignore: Optional[int] = None,
) -> NDArray[np.int64]: ...

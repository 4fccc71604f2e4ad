"""Draws outlines, traces exact ones and scores one against the other.

Images are arrays of uint8, (height, width), row 0 the top. Experiments are the program's.
"""

from typing import Any, Mapping, Optional, Union

import numpy as np
from numpy.typing import NDArray

class Error(ValueError):
    """Bad input, with the sentence that the program would print."""

class TooLarge(MemoryError):
    """A view has too many lines to trace."""

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
    scene: str,
    view: str = "",
    *,
    width_px: int = 1280,
    height_px: int = 720,
    crease_deg: float = 40.0,
    intersections: str = "above_crease",
    threads: int = 0,
) -> Truth: ...
def draw(
    method: str,
    scene: str,
    view: str = "",
    *,
    width_px: int = 1280,
    height_px: int = 720,
    settings: Mapping[str, str] = {},
    threads: int = 1,
) -> NDArray[np.uint8]: ...
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

"""What a chart function returns, and what it raises where there is nothing to draw."""

from dataclasses import dataclass, field

from matplotlib.figure import Figure


class Nothing(Exception):
    """There is nothing to draw; the message says why and, if anything helps, what would."""


@dataclass
class Chart:
    """A figure with what must stand beside it in a paper.

    caption: what it shows and where the numbers are from, in whole sentences.
    facts: numbers worth a sentence in the text, one a line.
    part: where one function draws several figures, what is added to the file's name.
    """

    figure: Figure
    caption: str
    facts: list[str] = field(default_factory=list)
    part: str = ""


@dataclass
class Table:
    """A table as LaTeX source; `caption` and `facts` as of a chart."""

    latex: str
    caption: str
    facts: list[str] = field(default_factory=list)
    part: str = ""

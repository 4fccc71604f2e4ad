"""All figures, by the name of their files: what draws them, and in which order they stand."""

from paper import axes, cost, latex, methods, strips

FIGURES = {
    "strips": strips.strips,
    "error_time": cost.error_time,
    "classes": methods.classes,
    "verdict": latex.verdict,
    "stress": axes.curves,
    "stress_losses": axes.losses,
}


def draw(name, runs, style):
    """The charts or tables of one figure as a list; raises chart.Nothing if there are none."""
    made = FIGURES[name](runs, style)
    return made if isinstance(made, list) else [made]

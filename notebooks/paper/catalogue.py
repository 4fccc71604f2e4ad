"""All figures, by the name of their files: what draws them, and in which order they stand."""

from paper import (axes, buffers, cost, latex, methods, motion, prediction, scenes, strips,
                   tuning)

FIGURES = {
    "strips": strips.strips,
    "buffers": buffers.buffers,
    "error_time": cost.error_time,
    "f": methods.f_by_method,
    "classes": methods.classes,
    "causes": methods.causes,
    "heat_map": methods.scenes_by_methods,
    "differences": methods.differences,
    "tolerances": methods.tolerances,
    "settings": cost.settings,
    "verdict": latex.verdict,
    "scenes": scenes.classes,
    "contours": scenes.contours,
    "trust": scenes.trust,
    "misses": prediction.misses,
    "misses_by_angle": prediction.misses_by_angle,
    "grid": tuning.grids,
    "sweep": tuning.sweep_lines,
    "tuning": tuning.search,
    "tuned": tuning.tuned,
    "bound": tuning.bound,
    "scaling": axes.scaling,
    "sizes": cost.sizes,
    "stress": axes.curves,
    "stress_losses": axes.losses,
    "stress_apart": axes.apart,
    "flicker": motion.flicker,
    "lives": motion.lives,
    "roll": motion.roll,
    "roll_least": motion.roll_least,
}


def draw(name, runs, style):
    """The charts or tables of one figure as a list; raises chart.Nothing if there are none."""
    made = FIGURES[name](runs, style)
    return made if isinstance(made, list) else [made]

"""Figures for papers, drawn from run folders with pandas and matplotlib.

`runs` reads folders, `style` says how figures look, `layout` places labels and legends, `output`
writes files; every other module draws charts: functions that take `Runs` and a `Style` and return a
`Chart`. `notebooks/figures.py` lists them all and is the program.
"""

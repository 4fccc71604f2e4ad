"""The verdict as a LaTeX table (package booktabs)."""

import pandas as pd

from paper.chart import Nothing, Table
from paper.runs import BASELINES, CLASS_PARTS, RECALL_GROUPS, Judged, answer_of, counted, ms
from paper.style import MM_PER_IN

_WIDE_MM = 120


def _escaped(text):
    for char in "\\&%$#_{}":
        text = text.replace(char, "\\" + char if char != "\\" else r"\textbackslash{}")
    return text


def _group(name):
    """What a recall group is called at the head of a column."""
    title = CLASS_PARTS[name]["short"] if name in CLASS_PARTS else name
    return title.replace(". ", r".\ ").replace("\u2265", r"$\ge$").replace("<", "$<$")


def _numbers(values, digits):
    """The values as text, the best (largest) bold unless another shows the same digits."""
    texts = ["--" if pd.isna(v) else f"{v:.{digits}f}" for v in values]
    shown = [text for text in texts if text != "--"]
    if not shown:
        return texts
    best = max(shown, key=float)
    if shown.count(best) == 1 and len(shown) > 1:
        texts[texts.index(best)] = rf"\textbf{{{best}}}"
    return texts


def _scores(lines, column):
    """An F with three digits, the best of the methods bold."""
    are_baselines = lines.index.isin(BASELINES)
    return [f"{own:.3f}" if is_baseline and not pd.isna(own) else text for text, own, is_baseline in zip(
        _numbers(lines[column].where(~are_baselines), 3), lines[column], are_baselines)]


def verdict(runs, style):
    """F, or soft F before it, with its interval, time, bytes and, on a wide page, recall by class, a line a method.

    The method that the program answers with has its name in bold.
    """
    summary = runs.summary()
    methods = style.by_family(summary.index)
    if not methods:
        raise Nothing("the run has no method beside the baselines")
    order = methods + [b for b in BASELINES if b in summary.index]
    lines = summary.loc[order]
    is_wide = style.width_in * MM_PER_IN >= _WIDE_MM
    answer, facts = answer_of(lines)
    by = Judged(lines)
    columns = {"method": [rf"\textbf{{{_escaped(m)}}}" if m == answer else _escaped(m)
                          for m in order],
               by.name.replace("F", "$F$"): _scores(lines, by.f),
               r"95\,\%": ["--" if pd.isna(a) else f"{a:.3f}--{b:.3f}"
                           for a, b in zip(lines[by.low], lines[by.high])],
               "$F$": _scores(lines, "f_2px")}
    if lines["draw_ms"].notna().any():
        columns["ms"] = ["--" if pd.isna(v) else ms(v) for v in lines["draw_ms"]]
    columns["B/px"] = ["--" if pd.isna(v) else f"{v:g}" for v in lines["bytes_per_px"]]
    there = [c for c in RECALL_GROUPS if lines[f"recall_{c}"].notna().any()] if is_wide else []
    for name in there:
        columns[_group(name)] = _numbers(lines[f"recall_{name}"].where(~lines.index.isin(BASELINES)), 3)
    out = ["% Made by inkbench figures; needs \\usepackage{booktabs}.",
           r"\begin{tabular}{l" + "r" * (len(columns) - 1) + "}", r"\toprule"]
    if there:
        out.append(rf"& \multicolumn{{{len(columns) - 1 - len(there)}}}{{c}}{{}} & "
                   rf"\multicolumn{{{len(there)}}}{{c}}{{recall by class of line}} \\")
        out.append(rf"\cmidrule(l){{{len(columns) - len(there) + 1}-{len(columns)}}}")
    out += [" & ".join(columns) + r" \\", r"\midrule"]
    cells = list(zip(*columns.values()))
    for i, line in enumerate(cells):
        is_first_of_family = 0 < i < len(methods) and \
            style.family(order[i]) != style.family(order[i - 1])
        if i == len(methods):
            out.append(r"\midrule")
        elif is_first_of_family:
            out.append(r"\addlinespace")
        out.append(" & ".join(line) + r" \\")
    out += [r"\bottomrule", r"\end{tabular}", ""]
    return Table("\n".join(out), f"{by.title} of {counted(len(methods), 'method')} with its 95 % interval, "
                 + ("F at 2 px, " if by.name != "F" else "") + "the time of a frame and the bytes of its buffers"
                 + (", and recall by class of line" if there else "")
                 + "; bold is best where no other shows the same digits, and the name of the method "
                 "that is the cheapest of those with nearly the best F; below the baselines. "
                 + runs.source("summary.csv"), facts)

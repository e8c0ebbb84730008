"""Keys of readings, tables of pandas and tables of HTML."""

from html import escape
from pathlib import Path
from typing import Any, Dict, Iterable, List, Sequence, Tuple, Union

import numpy as np

Array = np.ndarray[Any, Any]
Vector = Union[Sequence[float], Array]

#: Key of a reading, everywhere the same: its file, relative to the study's folder, and its step
#: within the file, counted from 1. Rows of a table of readings count as steps. Means of several
#: readings have the numbers -1, -2, ..., which no reading has.
Key = Tuple[str, int]


def reading_keys(files: Sequence[str], steps: Sequence[int], lines: Sequence[int],
                 folder: str) -> List[Key]:
    """Returns the key of each reading."""
    names = [_relative(file, folder) for file in files]
    in_file: Dict[str, List[int]] = {}
    for name, line in zip(names, lines):
        in_file.setdefault(name, []).append(line)
    ranks = {name: {line: k + 1 for k, line in enumerate(sorted(set(of)))}
             for name, of in in_file.items()}
    return [(name, step or ranks[name][line]) for name, step, line in zip(names, steps, lines)]


def _relative(file: str, folder: str) -> str:
    try:
        return Path(file).relative_to(folder).as_posix()
    except ValueError:
        return file


def frame(columns: Dict[str, Any], keys: Sequence[Key]) -> Any:
    """Returns a pandas.DataFrame of readings with the index (file, step)."""
    import pandas

    index = pandas.MultiIndex.from_tuples(list(keys), names=["file", "step"])
    return pandas.DataFrame(columns, index=index)


def html_table(headings: Sequence[str], rows: Iterable[Sequence[Any]], caption: str = "") -> str:
    """Returns a table of HTML. Numbers have four digits."""
    head = "".join(f"<th>{escape(each)}</th>" for each in headings)
    body = "".join(
        "<tr>" + "".join(f"<td>{escape(_cell(each))}</td>" for each in row) + "</tr>"
        for row in rows
    )
    title = f"<caption>{escape(caption)}</caption>" if caption else ""
    return f"<table>{title}<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _cell(value: Any) -> str:
    if value is None:
        return ""
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def with_error(value: float, stderr: float) -> str:
    """Returns a number with two digits of its standard error, such as "0.0912 ± 0.0014"."""
    import math

    if not (math.isfinite(stderr) and stderr > 0 and math.isfinite(value)):
        return f"{value:.4g}"
    digits = max(0, 1 - math.floor(math.log10(stderr)))
    if digits <= 6 and abs(value) < 1e5:
        return f"{value:.{digits}f} ± {stderr:.{digits}f}"
    power = math.floor(math.log10(max(abs(value), stderr)))
    return f"({value / 10**power:.3g} ± {stderr / 10**power:.2g})e{power}"

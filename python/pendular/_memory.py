"""Studies from memory: a folder with study.toml and tables, which is read as any other."""

from __future__ import annotations

import glob
import json
import os
import re
import shutil
from pathlib import Path
from typing import Any, Dict, List, Mapping, Sequence

import numpy as np

from pendular._core import InputError
from pendular._tables import Array

#: Units of the columns of a table of readings where its headings state none.
_UNITS = {
    "normal_stress": "Pa",
    "shear_stress": "Pa",
    "stress_ratio": "1",
    "solid_fraction": "1",
    "inertial_number": "1",
    "shear_rate": "1/s",
    "liquid_content": "1",
    "height": "m",
    "time": "s",
}
#: Standard errors are named NAME_se in tables of readings, and NAME_stderr in tables of this module.
_ERROR, _ERRORS = "_stderr", ("_sd", "_se", "_u95")

_UNITS_OF_RECORDINGS = {
    "time": "s",
    "torque": "N m",
    "normal_force": "N",
    "height": "m",
    "angular_velocity": "rad/s",
    "interval": "1",
    "shear_stress": "Pa",
    "normal_stress": "Pa",
}


def write_study(folder: Path, tables: Mapping[str, Any], readings: Any,
                recordings: Sequence[Mapping[str, Any]]) -> None:
    """Writes study.toml with its tables, the recordings and the readings to a folder."""
    sources: List[str] = []
    for k, each in enumerate(recordings):
        for name in _put_recordings(folder, each["file"], k + 1):
            sources.append("[[recording]]\n" + _lines({**each, "file": name}))
    if readings is not None:
        file = _free(folder, "readings.csv")
        _write_csv(file, _columns(readings), _UNITS)
        sources.append("[[readings]]\n" + _lines({"file": file.name}))
    text = "".join(_table(name, value) for name, value in tables.items() if value is not None)
    (folder / "study.toml").write_text(text + "\n".join(sources), encoding="utf-8")


def with_stated(text: str, tables: Mapping[str, Any]) -> str:
    """Returns the text of a study.toml with the keys of `tables` in place of the guesses there."""
    for name, entries in tables.items():
        heading = f"[{name}]\n"
        if entries and heading not in text:
            text = heading + "\n" + text
        for key, value in (entries or {}).items():
            begin = text.index(heading) + len(heading)
            end = text.find("\n[", begin)
            section = text[begin:] if end < 0 else text[begin:end]
            line = _lines({key: value})
            changed, found = re.subn(rf"(?m)^{re.escape(_key(key))}\s*=.*\n?", lambda _: line, section)
            text = text[:begin] + (changed if found else line + section) + text[begin + len(section):]
    return text


def _put_recordings(folder: Path, file: Any, number: int) -> List[str]:
    """Writes a table, or copies the files that a path or pattern names, and returns the names."""
    if not isinstance(file, (str, os.PathLike)):
        put = _free(folder, f"recording_{number}.csv")
        _write_csv(put, _columns(file), _UNITS_OF_RECORDINGS)
        return [put.name]
    path = os.fspath(file)
    found = [path] if os.path.exists(path) else sorted(glob.glob(path))
    if not found:
        raise InputError(f"recordings: there is no file '{path}'")
    return [shutil.copy(each, _free(folder, Path(each).name)).name for each in map(Path, found)]


def _free(folder: Path, name: str) -> Path:
    """File of a new name in a folder: a number follows a name that another file has. Characters
    of patterns, which a name in study.toml cannot have, are replaced."""
    plain = Path(re.sub(r"[*?\[\]\\]", "_", name))
    file, number = folder / plain, 1
    while file.exists() or file.name == "study.toml":
        number += 1
        file = folder / f"{plain.stem}_{number}{plain.suffix}"
    return file


def _columns(table: Any) -> Dict[str, Array]:
    """Columns of a pandas.DataFrame or a mapping of arrays. Levels of an index are left out."""
    return {str(name): np.asarray(table[name]) for name in table}


def _heading(name: str, units: Mapping[str, str]) -> str:
    if "[" in name:
        return name
    name = name[: -len(_ERROR)] + "_se" if name.endswith(_ERROR) else name
    plain = name
    for ending in _ERRORS:
        plain = plain[: -len(ending)] if plain.endswith(ending) else plain
    return f"{name} [{units[plain]}]" if plain in units else name


def _write_csv(file: Path, columns: Mapping[str, Array], units: Mapping[str, str]) -> None:
    rows = zip(*(column.tolist() for column in columns.values()))
    lines = [",".join(_heading(name, units) for name in columns)]
    lines += [",".join(_cell(value) for value in row) for row in rows]
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _cell(value: Any) -> str:
    return "" if value is None or value != value else str(value)


def _table(name: str, value: Any) -> str:
    if isinstance(value, Mapping):
        return f"[{name}]\n{_lines(value)}\n"
    return "".join(f"[[{name}]]\n{_lines(each)}\n" for each in value)


def _lines(entries: Mapping[str, Any]) -> str:
    return "".join(f"{_key(key)} = {_value(value)}\n" for key, value in entries.items()
                   if value is not None)


def _key(key: str) -> str:
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else json.dumps(key)


def _value(value: Any) -> str:
    """Value of TOML, whose texts, lists and numbers are written as those of JSON."""
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(k)} = {_value(v)}" for k, v in value.items()) + " }"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(_value(each) for each in value) + "]"
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not np.isfinite(value):
        return str(value)  # nan, inf and -inf of TOML
    return json.dumps(os.fspath(value) if isinstance(value, os.PathLike) else value,
                      ensure_ascii=False)

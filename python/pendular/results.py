"""What all results share: a result is what a command writes as JSON, with tables and figures.

A result is a read-only mapping of the command's JSON (docs/reference/json.md), so that
`fit["chi2"]` and `fit.chi2` are the same number. Results hold numbers alone: they can be pickled
and copied, and need neither the study nor its files.
"""

from __future__ import annotations

import copy
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Sequence

import numpy as np

from pendular._tables import Array, with_error


class Estimate(NamedTuple):
    """Number with its standard error; both have the unit `unit` ("1": dimensionless)."""

    value: float
    stderr: float
    unit: str = "1"

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        return with_error(self.value, self.stderr) + unit


class Result(Mapping[str, Any]):
    """Result of a command: a read-only mapping of its JSON."""

    def __init__(self, json: Dict[str, Any]) -> None:
        self._json = json

    def __getitem__(self, key: str) -> Any:
        return self._json[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._json)

    def __len__(self) -> int:
        return len(self._json)

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self._json == other._json  # type: ignore[attr-defined]

    __hash__ = None  # type: ignore[assignment]

    def to_dict(self) -> Dict[str, Any]:
        """Returns a copy of the JSON."""
        return copy.deepcopy(self._json)


def uncertain(entries: Sequence[Mapping[str, Any]], *path: str) -> Dict[str, Array]:
    """Columns of numbers with standard errors, {"value": .., "stderr": ..} at `path`."""
    found: List[Any] = list(entries)
    for name in path:
        found = [each[name] for each in found]
    return {
        "value": np.array([each["value"] for each in found], dtype=float),
        "stderr": np.array([each["stderr"] for each in found], dtype=float),
    }


def column(entries: Sequence[Mapping[str, Any]], name: str, kind: Any = float) -> Array:
    return np.array([each[name] for each in entries], dtype=kind)

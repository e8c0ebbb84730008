"""What a long call tells while it works: progress through tqdm, notes as warnings."""

import sys
import warnings
from typing import Any, Callable, Optional, Union

#: Called with (kind, text, done, total): kind is "runs", "refits", "round", "stage" or "note".
Listener = Callable[[str, str, int, int], None]
Progress = Union[bool, Listener, None]


class Note(UserWarning):
    """Note on a result, such as on the choice of the simulations that were used."""


class _Bars:
    """Shows one bar at a time, for the piece of work that was told of last."""

    def __init__(self, bar: Any) -> None:
        self._make = bar
        self._bar: Any = None
        self._text = ""

    def __call__(self, kind: str, text: str, done: int, total: int) -> None:
        if kind == "note":
            warnings.warn(text, Note, stacklevel=3)
        if self._make is None or kind not in ("runs", "refits") or total < 2:
            return
        if self._bar is None or text != self._text or total != self._bar.total:
            self.close()
            self._bar, self._text = self._make(total=total, desc=text, leave=False), text
        self._bar.update(done - self._bar.n)

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()
            self._bar = None


def _bar_of_tqdm(progress: Progress) -> Any:
    """Returns tqdm's bar: always if `progress` is true, else where somebody looks at it; None
    without tqdm."""
    if progress is False or (progress is None and not sys.stderr.isatty()):
        return None
    try:
        from tqdm import tqdm
    except ImportError:
        return None
    return tqdm


class told:
    """Context of a long call. Its value is the listener to hand to the call.

    progress: True shows tqdm's bars, False none, None (the default) shows them on a terminal; a
    function is called with (kind, text, done, total) instead.
    """

    def __init__(self, progress: Progress) -> None:
        self._bars: Optional[_Bars] = None
        self._progress = progress

    def __enter__(self) -> Listener:
        if callable(self._progress):
            return self._progress
        self._bars = _Bars(_bar_of_tqdm(self._progress))
        return self._bars

    def __exit__(self, *_: object) -> None:
        if self._bars is not None:
            self._bars.close()

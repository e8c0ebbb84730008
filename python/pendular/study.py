"""A study on disk: its readings, and the work on it."""

from __future__ import annotations

import math
import os
import shutil
import tempfile
import warnings
from pathlib import Path
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, Union

import numpy as np

from pendular import _core
from pendular._core import InputError
from pendular._memory import with_stated, write_study
from pendular._notify import Note, Progress, told
from pendular._forward import Forward
from pendular.fits import Comparison, Fit, Prediction, Readings, Recording
from pendular.states import Numbers, States, Store, cores, predict, store_file
from pendular.verdicts import Change, Diagnosis, NextMeasurement

PathLike = Union[str, "os.PathLike[str]"]
#: Time for simulations that check a result: minutes, True for no limit, False for none.
Confirm = Union[bool, float]
Table = Mapping[str, Any]


def _seconds(confirm: Confirm) -> Optional[float]:
    if confirm is True:
        return math.inf
    if confirm is False:
        return None
    if not confirm >= 0:
        raise InputError(f"confirm={confirm}: minutes, a number of 0 or more, are needed")
    return 60.0 * confirm


class Recordings(Mapping[str, Recording]):
    """Recordings of a study by file, relative to its folder; each is read when it is asked for."""

    def __init__(self, opened: Any) -> None:
        self._opened = opened
        folder = str(opened.folder)
        self._files = {_relative(file, folder): file for file in opened.recordings()}

    def __getitem__(self, file: str) -> Recording:
        return Recording(self._opened.recording(self._files[file]), file)

    def __iter__(self) -> Iterator[str]:
        return iter(self._files)

    def __len__(self) -> int:
        return len(self._files)

    def __repr__(self) -> str:
        return f"<{len(self)} recordings: {', '.join(self)}>"


def _relative(file: PathLike, folder: str) -> str:
    try:
        return Path(file).relative_to(folder).as_posix()
    except ValueError:
        return str(file)


class Study:
    """Session on a study: reads the study's files once, then fits, compares, predicts, diagnoses,
    plans measurements and changes effects.

    Long calls release the interpreter's lock, so that other threads go on. Ctrl-C stops them; the
    simulations that had ended stay in the store, and the same call continues with them.
    """

    _folder: Any = None  #: of a study from memory
    _kept: Any = None  #: whose folders this study uses

    def __init__(self, study: Optional[PathLike] = None, *, grains: Optional[Table] = None,
                 cell: Optional[Table] = None, liquid: Optional[Table] = None,
                 model: Optional[Table] = None, instrument: Optional[Table] = None,
                 rig: Optional[Table] = None, import_: Optional[Table] = None,
                 scatter: Optional[Table] = None, direct: Optional[Sequence[Table]] = None,
                 effect: Optional[Sequence[Table]] = None,
                 readings: Any = None, recordings: Sequence[Table] = (),
                 fidelity: Optional[str] = None, seed: int = 1, threads: Optional[int] = None,
                 store: Store = None, results: Optional[PathLike] = None,
                 progress: Progress = None, _functions: Sequence[Any] = ()) -> None:
        """Opens a study on disk (see `open`), or makes one from memory, in a folder that is removed
        with the object (`save` keeps it):

            pendular.Study(grains={"diameter": "500 um", "density": "1050 kg/m^3"},
                           readings=table)

        grains, cell, liquid, model, instrument, rig, scatter: tables of study.toml
        import_: the table [import]
        effect: effects by formulas, tables [[effect]] of study.toml
        direct: direct measurements, tables [[direct]] of study.toml
        readings: pandas.DataFrame or mapping of arrays; columns normal_stress [Pa], shear_stress
            [Pa] or stress_ratio, solid_fraction, inertial_number or shear_rate [1/s],
            liquid_content, each with its standard error NAME_sd or NAME_stderr; other units in
            brackets, "normal_stress [kPa]"
        recordings: tables [[recording]]: `file`, a path, a pattern such as "dry_*.csv" or a
            pandas.DataFrame of the columns of `Recording`, and further keys such as
            liquid_content. Files are copied; of two with one name, the second has a number
        """
        if study is None:
            study = self._written({"grains": grains, "cell": cell, "liquid": liquid,
                                   "model": model, "instrument": instrument, "rig": rig,
                                   "import": import_, "scatter": scatter, "direct": direct,
                                   "effect": effect}, readings, recordings)
        self._path, self._progress = Path(study), progress
        self._settings: Dict[str, Any] = {
            "fidelity": fidelity,
            "seed": seed,
            "threads": cores() if threads is None else threads,
            "store": store,
            "results": results,
        }
        self._functions = tuple(_functions)
        self._opened = _core.open_study(
            str(study), fidelity, seed, self._settings["threads"], store_file(store),
            "" if results is None else os.fspath(results), self._functions,
        )
        #: Fits before and after the change that led to this study; None without one.
        self.change: Optional[Change] = None

    def _written(self, tables: Dict[str, Any], readings: Any,
                 recordings: Sequence[Table]) -> str:
        self._folder = tempfile.TemporaryDirectory(prefix="pendular-")
        write_study(Path(self._folder.name), tables, readings, recordings)
        return self._folder.name

    def save(self, folder: PathLike) -> Study:
        """Copies study.toml and the files beside it to a new folder, and returns the study there.

        Raises InputError for a study with effects by functions, which no file can hold."""
        self._demand_no_functions("save")
        shutil.copytree(self.folder, folder)
        return Study(folder, **self._settings)

    def with_effects(self, *effects: Any) -> Study:
        """Returns the study with effects by functions of Python (`instrument_effect`) in its model.
        study.toml stays as it is; results go to a folder that is removed with the object. Such a
        study can be neither saved nor changed by `add` and `drop`."""
        folder = tempfile.TemporaryDirectory(prefix="pendular-")
        settings: Dict[str, Any] = {**self._settings, "results": folder.name}
        study = Study(self._path, **settings, progress=self._progress,
                      _functions=[*self._functions, *effects])
        study._kept = (folder, self)
        return study

    def _demand_no_functions(self, what: str) -> None:
        if self._functions:
            names = ", ".join(each.name for each in self._functions)
            raise InputError(
                f"{what}: study.toml cannot hold an effect by a function of Python ({names}); use "
                "the study without it, or write the effect as formulas in a table [[effect]]")

    def forward(self) -> Forward:
        """Returns the model as a plain function of its parameters."""
        return Forward(self._opened)

    def __repr__(self) -> str:
        return f"<Study {self.folder}: {self.readings!r}, effects {self.effects}>"

    def _repr_html_(self) -> str:
        return self.readings._repr_html_()

    @property
    def folder(self) -> Path:
        """Folder of the study."""
        return Path(self._opened.folder)

    @property
    def results(self) -> Path:
        """Folder for results, such as fit.json."""
        return Path(self._opened.results)

    @property
    def effects(self) -> List[str]:
        """Names of the effects that study.toml lists, then those by functions."""
        return list(self._opened.effects)

    @property
    def readings(self) -> Readings:
        """Measured readings, in the order of study.toml."""
        return Readings(self._opened.readings(), str(self._opened.folder))

    @property
    def recordings(self) -> Recordings:
        """Raw recordings by file, relative to the study's folder."""
        return Recordings(self._opened)

    def calibrate(self, confirm: Confirm = False, cold: bool = False, profile: bool = False,
                  progress: Progress = None) -> Fit:
        """Fits the model's parameters to the readings, and writes fit.json to the results folder.

        confirm: minutes for new simulations that check the fit; True: no limit (as `pendular
        calibrate` does), False: none (`--no-confirm`)
        cold: simulate all states anew, without earlier simulations
        profile: also compute profile-likelihood intervals
        """
        with told(self._chosen(progress)) as listener:
            result = self._opened.calibrate(listener, _seconds(confirm), cold, profile)
        return Fit(result, str(self._opened.folder))

    def compare(self, progress: Progress = None) -> Comparison:
        """Compares the readings with the fit in fit.json of the results folder."""
        with told(self._chosen(progress)) as listener:
            json, fit = self._opened.compare(listener)
        return Comparison(json, Fit(fit, str(self._opened.folder)))

    def diagnose(self, confirm: Confirm = False, progress: Progress = None) -> Diagnosis:
        """Tests which physical effect, if any, is missing from the model.

        confirm: minutes for new simulations that check the verdict; False: none
        """
        with told(self._chosen(progress)) as listener:
            return Diagnosis(self._opened.diagnose(listener, _seconds(confirm)))

    def next(self, progress: Progress = None) -> NextMeasurement:
        """Diagnoses the study and plans the measurement that would tell most."""
        with told(self._chosen(progress)) as listener:
            return NextMeasurement(self._opened.next(listener))

    def add(self, effect: str, confirm: Confirm = False, progress: Progress = None) -> Study:
        """Adds an effect to study.toml, and returns the changed study, whose `change` holds the
        fits before and after. study.toml stays as it is where the new fit does not converge.

        The fits have the fidelity of the fit in the results folder, unless the study was opened
        with another. The effects that explain the readings as well are those of the last
        `diagnose` or, without one, of diagnosis.json in the results folder."""
        return self._changed(True, effect, confirm, progress)

    def drop(self, effect: str, confirm: Confirm = False, progress: Progress = None) -> Study:
        """Removes an effect from study.toml, in the same way as `add` adds one."""
        return self._changed(False, effect, confirm, progress)

    def predict(self, **state: Any) -> States:
        """Predicts states of steady shear with the study's store and fidelity (see
        `pendular.predict` for the arguments)."""
        defaults = {name: self._settings[name] for name in ("fidelity", "threads")
                    if self._settings[name] is not None}
        return predict(**{**defaults, "store": self._settings["store"], **state})

    def predict_readings(self, normal_stress: Numbers, inertial_number: Numbers = 0.0,
                         liquid_content: Numbers = 0.0,
                         progress: Progress = None) -> Prediction:
        """Predicts the readings that the instrument would show, from the fit in fit.json.

        normal_stress [Pa], inertial_number [1] (0: quasi-static limit), liquid_content [1]
        (0: dry): numbers or arrays, broadcast against each other, flattened to (n,)
        """
        arrays = np.broadcast_arrays(
            *(np.asarray(each, dtype=float)
              for each in (normal_stress, inertial_number, liquid_content))
        )
        at = dict(zip(("normal_stress", "inertial_number", "liquid_content"),
                      (each.ravel() for each in arrays)))
        with told(self._chosen(progress)) as listener:
            return Prediction(self._opened.predict(listener, **at), at)

    def _chosen(self, progress: Progress) -> Progress:
        return self._progress if progress is None else progress

    def _changed(self, add: bool, effect: str, confirm: Confirm, progress: Progress) -> Study:
        self._demand_no_functions("add" if add else "drop")
        with told(self._chosen(progress)) as listener:
            json = self._opened.change(listener, add, effect, _seconds(confirm))
        study = Study(self._path, **self._settings, progress=self._progress)
        study.change, study._kept = Change(json), self
        return study


def begin(files: Union[PathLike, Sequence[PathLike]], folder: PathLike, *, sheet: str = "",
          grains: Optional[Table] = None, cell: Optional[Table] = None,
          liquid: Optional[Table] = None, **settings: Any) -> Study:
    """Begins a study with files of measurements, and opens it: writes study.toml and copies of the
    files to a folder. What neither the files nor the arguments state, such as the density of the
    grains, is guessed and marked GUESS in study.toml: correct it there, and `open` the study again.

    files: recording or export of a rheometer, as `import_file` reads it; several of them, each of
        which must be readable; or a folder, whose files are taken in the order of their names, and
        where those with which no study can begin are left out, with a warning
    folder: of the study, made where it is missing
    sheet: sheet of a workbook
    grains, cell, liquid: tables of study.toml, such as cell={"bead_mass": "60 g"}
    settings: as of `open`

    Raises InputError, and writes nothing, where the folder has a file of one of the names.
    """
    of_folder = isinstance(files, (str, os.PathLike)) and os.path.isdir(files)
    written, not_read = _core.begin_study(_paths(files), sheet, of_folder)
    into = Path(folder)
    for name in written:
        if (into / name).exists():
            raise InputError(f"{into / name} is there already; nothing was written: name another "
                             "folder")
    for each in not_read:
        warnings.warn(each, Note, stacklevel=2)
    written["study.toml"] = with_stated(
        written["study.toml"].decode(), {"grains": grains, "cell": cell, "liquid": liquid}).encode()
    into.mkdir(parents=True, exist_ok=True)
    for name, content in written.items():
        (into / name).write_bytes(content)
    return Study(into, **settings)


def _paths(files: Union[PathLike, Sequence[PathLike]]) -> List[str]:
    """Paths of files, or of the files of a folder."""
    if not isinstance(files, (str, os.PathLike)):
        return [os.fspath(each) for each in files]
    if not os.path.isdir(files):
        return [os.fspath(files)]
    found = sorted(each for each in Path(files).iterdir()
                   if each.is_file() and not each.name.startswith("."))
    if not found:
        raise InputError(f"{os.fspath(files)} has no file to begin a study with")
    return [str(each) for each in found]


def open(study: PathLike, *, fidelity: Optional[str] = None, seed: int = 1,
         threads: Optional[int] = None, store: Store = None, results: Optional[PathLike] = None,
         progress: Progress = None) -> Study:
    """Reads a study and all its recordings.

    study: folder of the study, or its study.toml
    fidelity: "quick", "standard" or "paper", the size of simulations (default: "standard"; `add`
        and `drop` then take that of the fit in the results folder)
    seed: of simulations and of random draws of errors
    threads: number of simulations or refits at a time (default: one per core)
    store: SQLite file with simulations (default: that of the command line); False: none
    results: folder for fit.json and other results (default: STUDY/out)
    progress: see `Study.calibrate`; True shows bars of tqdm, a function receives events

    Raises InputError for a mistake in a file of the study.
    """
    return Study(study, fidelity=fidelity, seed=seed, threads=threads, store=store,
                 results=results, progress=progress)

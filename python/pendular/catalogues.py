"""Simulations, the catalogue of effects, and files of measurements."""

from __future__ import annotations

from typing import Any, Dict, List

from pendular._tables import Array, html_table, with_error
from pendular.results import Estimate, Result


class Run(Result):
    """One simulation (`pendular simulate`): observables as {"value", "stderr"}, and what repeats
    it."""

    def __repr__(self) -> str:
        return f"<Run: stress ratio {self['stress_ratio']['value']:.4g}>"

    def observable(self, name: str) -> Estimate:
        """Returns an observable, such as "stress_ratio", with its standard error."""
        return Estimate(self[name]["value"], self[name]["stderr"])

    def _repr_html_(self) -> str:
        rows = [
            (name, with_error(each["value"], each["stderr"]))
            for name, each in self.items()
            if isinstance(each, dict) and set(each) == {"value", "stderr"}
        ]
        return html_table(("observable", "value"), rows)


class Runs(Result):
    """Stored simulations (`pendular runs list`)."""

    def __repr__(self) -> str:
        return f"<{len(self['runs'])} runs>"

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each run, indexed by its number in the store.
        Observables have columns NAME and NAME_stderr."""
        import pandas

        rows = []
        for run in self["runs"]:
            row: Dict[str, Any] = {}
            for name, each in run.items():
                if isinstance(each, dict) and set(each) == {"value", "stderr"}:
                    row[name], row[name + "_stderr"] = each["value"], each["stderr"]
                else:
                    row[name] = each
            rows.append(row)
        return pandas.DataFrame(rows).set_index("id") if rows else pandas.DataFrame(rows)

    def _repr_html_(self) -> str:
        names = ("friction", "inertial_number", "reduced_pressure", "stress_ratio",
                 "solid_fraction")
        rows = [
            [run["id"]] + [run[name]["value"] if isinstance(run[name], dict) else run[name]
                           for name in names]
            for run in self["runs"][:50]
        ]
        more = len(self["runs"]) - len(rows)
        return html_table(("run", *names), rows, f"and {more} more" if more else "")


class Effects(Result):
    """Catalogue of the effects that a model may lack (`pendular effects`), by name."""

    def __init__(self, json: Dict[str, Any]) -> None:
        super().__init__({each["name"]: each for each in json["effects"]})

    def __repr__(self) -> str:
        return f"<{len(self)} effects: {', '.join(self)}>"

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each parameter of an effect."""
        import pandas

        rows = [
            {"effect": name, "acts_on": each["acts_on"], **parameter}
            for name, each in self.items()
            for parameter in each["parameters"]
        ]
        return pandas.DataFrame(rows).set_index("effect")

    def _repr_html_(self) -> str:
        rows = [
            (name, each["acts_on"], ", ".join(f"{p['name']} [{p['unit']}]"
                                              for p in each["parameters"]), each["summary"])
            for name, each in self.items()
        ]
        return html_table(("effect", "acts on", "parameters", "summary"), rows)


class FileView(Result):
    """What one file of measurements is understood as (`pendular import FILE`)."""

    def __init__(self, json: Dict[str, Any], series: List[Dict[str, Array]]) -> None:
        super().__init__(json)
        #: Columns of each interval in SI units, with `line` in the file.
        self.series = series

    def __repr__(self) -> str:
        return f"<FileView {self['file']}: {self['layout']}, {len(self.series)} intervals>"

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame of all rows in SI units, with the index (interval, line)."""
        import pandas

        parts = [
            pandas.DataFrame(series).assign(number=interval["number"], role=interval["role"])
            for interval, series in zip(self["intervals"], self.series)
        ]
        return pandas.concat(parts).set_index(["number", "line"])

    def _repr_html_(self) -> str:
        rows = [(each["number"], each["name"], each["role"], each["rows"], each["why"])
                for each in self["intervals"]]
        caption = f"{self['file']}: layout {self['layout']}"
        return html_table(("interval", "name", "role", "rows", "why"), rows, caption)

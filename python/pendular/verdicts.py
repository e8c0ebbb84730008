"""What follows from the readings: which effect is missing, what to measure next, what a change gives."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence

from pendular._tables import html_table, with_error
from pendular.results import Result


class Diagnosis(Result):
    """Which physical effect a study's model lacks (`pendular diagnose`), without the sentences
    that the command prints."""

    def __repr__(self) -> str:
        return f"<Diagnosis: {self.verdict}{': ' if self.effects else ''}{', '.join(self.effects)}>"

    @property
    def verdict(self) -> str:
        """Result in one word: "missing" (all of `effects` are needed), "indistinguishable"
        (several models fit that have none of `effects` in common: alternatives, which the
        measurement of `Study.next` tells apart), "nothing-missing", "inconclusive" (the readings could not show
        some effects), "unknown" (no known effect explains the misfit, or none as well as a proposed
        change) or "suspect-measurement"."""
        return str(self["verdict"])

    @property
    def effects(self) -> List[str]:
        """Names of the effects at which the verdict points."""
        return list(self["effects"])

    @property
    def complete(self) -> bool:
        """Whether what is named explains the readings."""
        return bool(self["complete"])

    @property
    def odd_file(self) -> Optional[Dict[str, Any]]:
        """Recording that deviates most from the model that explains the readings, in another way
        than all others: `file`, `observable`, mean `deviation` (measured/model - 1 [1]), that of
        the `others`, `p` and whether it `stands_out` (p < 0.05). None where fewer than three files
        have two readings each."""
        odd: Optional[Dict[str, Any]] = self["odd_file"]
        return odd

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each tested effect, indexed by its name."""
        import pandas

        rows = [
            {
                "effect": each["effect"],
                "parameter": each["parameter"],
                "unit": each["unit"],
                "estimate": each["estimate"]["value"],
                "estimate_stderr": each["estimate"]["stderr"],
                "predicted_reduction": each["predicted_reduction"],
                "refitted_reduction": each["refitted_reduction"],
                "p": each["p"],
                "decision": each["decision"],
            }
            for each in self["scan"]
        ]
        return pandas.DataFrame(rows).set_index("effect")

    def plot(self, axes: Optional[Sequence[Any]] = None) -> List[Any]:
        """Draws by how much chi2 would fall with each effect, the largest first."""
        from pendular import _figures

        panels = _figures.axes_of(axes, 1, self.verdict)
        scan = sorted(self["scan"], key=lambda each: -(each["predicted_reduction"] or 0))[:12]
        _figures.bars_across(
            panels[0],
            [each["effect"] for each in scan],
            [each["predicted_reduction"] or 0 for each in scan],
            r"predicted reduction of $\chi^2$",
        )
        return panels

    def _repr_html_(self) -> str:
        rows = [
            (each["effect"], each["parameter"],
             with_error(each["estimate"]["value"], each["estimate"]["stderr"]), each["unit"],
             each["p"], each["decision"])
            for each in self["scan"]
        ]
        caption = f"{self.verdict}: {', '.join(self.effects)}" if self.effects else self.verdict
        return html_table(("effect", "parameter", "estimate", "unit", "p", "decision"), rows, caption)


class NextMeasurement(Result):
    """Measurement that would tell most (`pendular next`)."""

    def __repr__(self) -> str:
        return f"<NextMeasurement between {', '.join(self.rivals)}>"

    @property
    def rivals(self) -> List[str]:
        """Models to tell apart; one: its parameters are to become more precise."""
        return list(self["rivals"])

    @property
    def steps(self) -> List[Dict[str, Any]]:
        """Points to measure: each with `point` (SI units) and the number `readings`."""
        if "series" in self and self["series"]["steps"]:
            return list(self["series"]["steps"])
        return [{"point": self["point"], "readings": self["repeats"]}] if "point" in self else []

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each point to measure."""
        import pandas

        return pandas.DataFrame([{**each["point"], "readings": each["readings"]}
                                 for each in self.steps])

    def _repr_html_(self) -> str:
        columns = ["readings", *dict.fromkeys(key for each in self.steps for key in each["point"])]
        rows = [[{**each["point"], "readings": each["readings"]}.get(name) for name in columns]
                for each in self.steps]
        return html_table(columns, rows, "between " + ", ".join(self.rivals))


class Change(Result):
    """Fits before and after an effect was added or dropped (`pendular add`, `pendular drop`)."""

    def __repr__(self) -> str:
        return f"<Change: {'written' if self.written else 'not written'}>"

    @property
    def written(self) -> bool:
        """Whether study.toml was changed; it is not where the new fit does not converge."""
        return bool(self["written"])

    def _repr_html_(self) -> str:
        sides = (self["before"], self["after"])
        rows: List[List[Any]] = [["chi2/dof", *(each["chi2"] / each["dof"] for each in sides)]]
        for name in ("shear_stress", "solid_fraction"):
            rows.append([f"RMS error of {name.replace('_', ' ')} [%]",
                         *(each["rms_percent"][name] for each in sides)])
        what = f"{self['effect']}: {self['change']}"
        return html_table(("", "before", "after"), rows, what if self.written else
                          what + ", not written")

"""The page of the module is right: its examples run, one after the other."""

import re
import shutil
import warnings
from pathlib import Path

import pytest

import pendular

ROOT = Path(__file__).parents[2]


def test_examples_of_the_page_run(tmp_path, monkeypatch):
    pytest.importorskip("emcee")
    shutil.copytree(ROOT / "examples/hidden-effect", tmp_path / "examples/hidden-effect",
                    ignore=shutil.ignore_patterns("out"))
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PENDULAR_STORE", str(tmp_path / "store.sqlite"))
    text = (ROOT / "docs/how-to/python.md").read_text()
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert len(blocks) == 5
    names = {}
    warnings.simplefilter("ignore", pendular.Note)
    for block in blocks:
        exec(block, names)
    # What the comments say.
    assert names["diagnosis"].effects == ["wall-friction"]
    assert str(names["fit"].parameters["friction"]) == "0.322 ± 0.012"
    assert names["states"]["stress_ratio"].shape == (100, 100)
    assert (tmp_path / "my-study/study.toml").exists()
    assert "speed-drag" not in (tmp_path / "examples/hidden-effect/study.toml").read_text()

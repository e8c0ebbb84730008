"""Studies to work on: copies of the examples, so that no test changes another's."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import matplotlib
import pytest

import pendular

matplotlib.use("Agg")
ROOT = Path(__file__).parents[2]
EXAMPLES = ["dry-recordings", "hidden-effect", "polystyrene", "rumpf-to-full", "straight-line",
            "water-glass", "wet"]


@pytest.fixture
def example(tmp_path):
    """Copies an example by its name and returns its folder."""

    def copied(name):
        folder = tmp_path / name
        shutil.copytree(ROOT / "examples" / name, folder, ignore=shutil.ignore_patterns("out"))
        return folder

    return copied


@pytest.fixture
def study(example):
    return pendular.open(example("hidden-effect"), store=False)


@pytest.fixture
def command(tmp_path):
    """Runs the command line and returns its JSON."""

    def run(*words):
        done = subprocess.run(
            [os.environ["PENDULAR_PROGRAM"], *map(str, words), "--json", "-"],
            capture_output=True, text=True, check=False,
            env={**os.environ, "PENDULAR_STORE": str(tmp_path / "store.sqlite")},
        )
        assert done.returncode in (0, 3), done.stderr
        return json.loads(done.stdout)

    return run

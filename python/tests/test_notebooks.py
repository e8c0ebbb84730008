"""The notebooks of docs/notebooks run, and print what is stored in them.

PENDULAR_ACCEPT_NOTEBOOKS=1 stores what they print now.
"""

import copy
import os
import re
from pathlib import Path

import pytest

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")

FOLDER = Path(__file__).parents[2] / "docs" / "notebooks"


def texts_of(notebook):
    """What the cells print: texts, without the addresses of objects and without pictures."""
    texts = []
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            text = output.get("text") or output.get("data", {}).get("text/plain", "")
            texts.append(re.sub(r"0x[0-9a-f]+|<Figure size .*>", "", text))
    return texts


def without_time(notebook):
    """The notebook without what differs from one run to the next."""
    for cell in notebook.cells:
        cell.get("metadata", {}).pop("execution", None)
    notebook.metadata.pop("language_info", None)
    return notebook


@pytest.mark.parametrize("file", sorted(FOLDER.glob("*.ipynb")), ids=lambda file: file.stem)
def test_notebook_runs_and_prints_what_is_stored(file):
    stored = nbformat.read(file, as_version=4)
    run = copy.deepcopy(stored)
    nbclient.NotebookClient(run, timeout=120, kernel_name="python3",
                            resources={"metadata": {"path": str(FOLDER)}}).execute()
    if os.environ.get("PENDULAR_ACCEPT_NOTEBOOKS"):
        nbformat.write(without_time(run), file)
    else:
        assert texts_of(run) == texts_of(stored)

"""The stubs are those of the module, and the package satisfies them."""

import subprocess
import sys
from pathlib import Path

import pytest

import pendular
from pendular import _core

ROOT = Path(__file__).parents[2]


def test_package_satisfies_mypy(tmp_path):
    pytest.importorskip("mypy")
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--cache-dir", str(tmp_path)], cwd=ROOT,
        capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_stubs_name_what_the_module_has():
    import ast

    tree = ast.parse((ROOT / "python/pendular/_core.pyi").read_text())
    for node in tree.body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            found = getattr(_core, node.name)
            for member in getattr(node, "body", []):
                if isinstance(node, ast.ClassDef) and isinstance(member, ast.FunctionDef):
                    assert hasattr(found, member.name), (node.name, member.name)
    stubbed = {getattr(node, "name", "") for node in tree.body}
    public = {name for name in vars(_core) if not name.startswith("_")}
    assert public <= stubbed


def test_everything_public_is_documented():
    for name in pendular.__all__:
        each = getattr(pendular, name)
        assert not callable(each) or each.__doc__, name

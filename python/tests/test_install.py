"""pip builds a package that runs anywhere, with its atlas, and without an index."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_pip_installs_the_package(tmp_path):
    build = Path(os.environ["PENDULAR_PROGRAM"]).parent
    # Setuptools writes beside setup.py: into a copy of what it reads, not into the sources.
    source = tmp_path / "source"
    source.mkdir()
    for name in ("pyproject.toml", "setup.py", "CMakeLists.txt", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, source)
    subprocess.run(
        [sys.executable, "-m", "pip", "install", "--quiet", "--no-build-isolation", "--no-deps",
         "--no-index", "--target", tmp_path / "packages", source],
        check=True, env={**os.environ, "PENDULAR_BUILD": str(build)},
    )
    clean = {key: value for key, value in os.environ.items() if not key.startswith("PENDULAR")}
    code = ("import pendular; print(pendular.__file__); "
            "print(float(pendular.predict(0.09, store=False)['stress_ratio'])); "
            "print(pendular.runs('1', atlas=True)['runs'][0]['physics_version'])")
    printed = subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True, cwd=tmp_path,
        env={**clean, "PYTHONPATH": str(tmp_path / "packages")},
    ).stdout.split()
    assert printed[0].startswith(str(tmp_path))
    assert 0.2 < float(printed[1]) < 0.4  # published: 0.25 +- 0.02 measured
    assert (tmp_path / "packages/pendular/atlas/atlas.csv").exists()
    assert (tmp_path / "packages/pendular/py.typed").exists()

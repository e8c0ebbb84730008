"""What the Python module costs, and what it gains over calls of the command line.

    PYTHONPATH=build/release/python python3 bench/python/measure.py build/release/pendular

Prints the figures of bench/results/python.txt.
"""

import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

import pendular
from pendular import _core

ROOT = Path(__file__).parents[2]


def resident_megabytes():
    return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize() / 1e6


def processor_seconds(*command):
    """Processor time of a command: of what it costs, the part that other work does not change."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def import_time():
    bare = min(processor_seconds(sys.executable, "-c", "pass") for _ in range(5))
    whole = min(processor_seconds(sys.executable, "-c", "import pendular") for _ in range(5))
    numpy = min(processor_seconds(sys.executable, "-c", "import numpy") for _ in range(5))
    print(f"import pendular: {whole - bare:.3f} s of processor time, {numpy - bare:.3f} s of it numpy")
    print(f"module: {os.path.getsize(_core.__file__) / 1e6:.1f} MB, stripped")


def states(program, count, threads):
    """Wet states with errors, on several threads, against as many calls of the command."""
    random = np.random.default_rng(1)
    friction, pressure, content = (random.uniform(*range_, count) for range_ in
                                   ((0.05, 0.3), (0.8, 10.0), (0.005, 0.05)))
    begin, used = time.perf_counter(), time.process_time()
    found = pendular.predict(friction, 0.0, pressure, liquid_content=content, store=False,
                             threads=threads)
    seconds, used = time.perf_counter() - begin, time.process_time() - used
    calls, of_calls = [], []
    for k in range(20):
        begin = time.perf_counter()
        of_calls.append(processor_seconds(
            program, "predict", "--friction", str(friction[k]), "--reduced-pressure",
            str(pressure[k]), "--liquid-content", str(content[k])))
        calls.append(time.perf_counter() - begin)
    one, one_used = statistics.median(calls), statistics.median(of_calls)
    print(f"{count} states ({found.supported.mean():.1%} covered) on {threads} threads: "
          f"{seconds:.1f} s, {used:.1f} s of processor time")
    print(f"one call of the command: {one:.3f} s, {one_used:.3f} s of processor time (median of 20)")
    print(f"{count} calls one by one take {one * count / seconds:.0f} times as long, and "
          f"{one_used * count / used:.0f} times the processor time")


def memory(count):
    """Resident memory over many calibrations, four at once."""
    with tempfile.TemporaryDirectory() as folder:
        studies = [pendular.open(ROOT / "examples/hidden-effect", store=False, threads=1,
                                 results=f"{folder}/{k}") for k in range(4)]
        marks = []
        begin = time.perf_counter()
        with ThreadPoolExecutor(4) as pool:
            for k, _ in enumerate(pool.map(lambda k: studies[k % 4].calibrate(), range(count))):
                if k + 1 in (count // 10, count // 4, count // 2, count):
                    marks.append(f"{resident_megabytes():.1f} MB after {k + 1}")
        seconds = time.perf_counter() - begin
    print(f"{count} calibrations, four at once, in {seconds:.0f} s: {', '.join(marks)}")


if __name__ == "__main__":
    import_time()
    states(sys.argv[1], 100_000, 2)
    memory(1000)

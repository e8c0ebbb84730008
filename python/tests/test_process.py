"""What the module costs: time to import, size, memory, threads."""

import ctypes
import gc
import multiprocessing
import os
import resource
import subprocess
import sys
import threading
import time
import weakref
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

import pendular
from pendular import _core


def processor_seconds(code):
    """Least processor time [s] of five interpreters that run the code."""
    times = []
    for _ in range(5):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([sys.executable, "-c", code], check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        times.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return min(times)


def test_import_takes_less_than_a_fifth_of_a_second():
    assert processor_seconds("import pendular") - processor_seconds("pass") < 0.2


def test_import_loads_no_libraries_of_tables_and_figures():
    code = "import sys, pendular; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True,
                            text=True).stdout.split()
    assert not {"pandas", "xarray", "matplotlib", "scipy", "tqdm", "emcee"} & set(loaded)


def test_module_is_smaller_than_15_megabytes():
    assert os.path.getsize(_core.__file__) < 15e6


def test_states_together_are_a_hundred_times_faster_than_calls_of_the_program():
    """On two threads, which need half of the processor time at best: 50 times less of that, which
    other programs beside the test do not change."""
    pendular.predict([0.1], store=False)  # trains the emulator, as each call of the program does
    calls = []
    for _ in range(3):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([os.environ["PENDULAR_PROGRAM"], "predict", "--friction", "0.1"], check=True,
                       capture_output=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        calls.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    begin = time.process_time()
    pendular.predict(np.linspace(0.02, 0.4, 4000), store=False, threads=2)
    assert 50 * (time.process_time() - begin) < 4000 * min(calls)


def allocated_bytes():
    """Bytes that C and C++ hold from the allocator of glibc. What the system counts as resident
    jumps by more than all results of a test together."""

    class Counts(ctypes.Structure):
        _fields_ = [(name, ctypes.c_size_t) for name in (
            "arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks",
            "fordblks", "keepcost")]

    mallinfo2 = ctypes.CDLL(None).mallinfo2
    mallinfo2.restype = Counts
    gc.collect()
    counts = mallinfo2()
    return counts.uordblks + counts.hblkhd


def test_threads_calibrate_at_once_and_alike(study):
    """Four threads, each with its own results, find what one finds, and the lock is free
    meanwhile."""
    expected = study.calibrate().to_dict()
    ticks, over = [0], threading.Event()

    def tick():
        while not over.wait(0.001):
            ticks[0] += 1

    ticker = threading.Thread(target=tick)
    ticker.start()
    folder = study.folder
    results = [folder / f"results_{k}" for k in range(4)]

    def calibrate(k):
        own = pendular.open(folder, store=False, results=results[k % 4], threads=1)
        return own.calibrate().to_dict() == expected

    with ThreadPoolExecutor(4) as pool:
        assert all(pool.map(calibrate, range(24)))
    over.set()
    ticker.join()
    assert ticks[0] > 20


def test_memory_does_not_grow_with_calibrations(study):
    with ThreadPoolExecutor(4) as pool:
        for _ in pool.map(lambda _: study.calibrate(), range(20)):
            pass
        before = allocated_bytes()
        for _ in pool.map(lambda _: study.calibrate(), range(40)):
            pass
    # Results that stay add 48 kB each, measured with a list that keeps them.
    assert allocated_bytes() - before < 40 * 10e3


def test_arrays_of_a_result_end_with_it(study):
    fit = study.calibrate()
    held = weakref.ref(fit.measured_covariance)
    assert held() is not None
    del fit
    gc.collect()
    assert held() is None


def test_a_forked_process_does_not_use_the_store_of_its_parent(example, tmp_path):
    study = pendular.open(example("hidden-effect"), store=tmp_path / "store.sqlite")
    context = multiprocessing.get_context("fork")
    told = context.SimpleQueue()

    def calibrate():
        try:
            study.calibrate()
            told.put("no error")
        except pendular.InputError as error:
            told.put(str(error))

    child = context.Process(target=calibrate)
    child.start()
    child.join(60)
    assert child.exitcode == 0
    assert "before this process was forked" in told.get()
    assert study.calibrate().converged  # the parent's store is as it was


def test_one_study_serves_several_threads(study):
    """Diagnoses and predictions on one object at once."""
    study.calibrate()
    with ThreadPoolExecutor(4) as pool:
        work = [pool.submit(study.diagnose) for _ in range(2)]
        work += [pool.submit(study.predict_readings, [500.0, 1000.0], 0.01) for _ in range(4)]
        results = [each.result() for each in work]
    assert results[0] == results[1]
    assert all(np.array_equal(each["value"], results[2]["value"]) for each in results[2:])

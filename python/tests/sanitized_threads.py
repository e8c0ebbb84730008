"""Four threads work at once on one study and on studies of their own: what the thread sanitizer looks at
(preset tsan, `ctest --preset tsan -R python`). It reports races itself; this script says whether the
threads found what one thread finds.
"""

import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import pendular

EXAMPLE = sys.argv[1]


def work(k: int, shared: pendular.Study, folder: str) -> object:
    """One of the calls that release the interpreter's lock, by turns."""
    if k % 4 == 0:
        return shared.diagnose().effects
    if k % 4 == 1:
        own = pendular.open(EXAMPLE, store=False, threads=2, results=f"{folder}/{k}")
        return own.calibrate().chi2
    if k % 4 == 2:
        states = pendular.predict([0.05 + 0.001 * i for i in range(200)], store=False, threads=2)
        return float(states["stress_ratio"].sum())
    f = shared.forward()
    return float(f(f.start).sum())


with tempfile.TemporaryDirectory() as folder:
    study = pendular.open(EXAMPLE, store=f"{folder}/runs.sqlite", threads=2,
                          results=f"{folder}/shared")
    alone = [work(k, study, folder) for k in range(4)]
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda k: work(k, study, folder), range(16)))
    assert together == 4 * alone, (alone, together)
print("four threads found what one finds")

"""Run the benchmarks: ``python benchmarks/run.py --help``."""

import os
import sys
from pathlib import Path

# Every baseline computes with one thread. The libraries read this when they are imported, hence before all else.
_ONE_THREAD = (
    "OMP_NUM_THREADS",
    "OPENBLAS_NUM_THREADS",
    "MKL_NUM_THREADS",
    "BLIS_NUM_THREADS",
    "VECLIB_MAXIMUM_THREADS",
    "NUMEXPR_NUM_THREADS",
    "NUMBA_NUM_THREADS",
    "DUCC0_NUM_THREADS",
)

if __name__ == "__main__":
    for name in _ONE_THREAD:
        os.environ[name] = "1"
    os.environ["XLA_FLAGS"] = "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1"
    os.environ["JAX_PLATFORMS"] = "cpu"
    root = Path(__file__).resolve().parent.parent
    sys.path[0] = str(root)
    # Where make peers puts other packages; last, so that all they share with .venv is that of .venv.
    sys.path.append(str(root / ".tools" / "peers"))
    from benchmarks.cli import main

    sys.exit(main())

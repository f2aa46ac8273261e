"""Solve a system by PyAMG's conjugate gradients with smoothed aggregation; print a line of JSON.

Usage: python3 pyamg_peer.py FOLDER

One thread: PyAMG has no more. Blocks of size 3 and the six rigid-body modes for elasticity.
"""

import json
import sys
import time

import numpy as np
import pyamg
from measure import System, forget_peak, peak, resident
from scipy import sparse

# The fastest that we found: the defaults take up to 2.6 times as long.
SETTINGS = {
    "strength": ("symmetric", {"theta": 0.02}),
    "improve_candidates": None,
    "presmoother": "chebyshev",
    "postsmoother": "chebyshev",
}


def main():
    system = System(sys.argv[1])
    before = resident()
    indices, offsets, b = (np.array(a) for a in (system.indices, system.offsets, system.rhs))
    if system.block == 1:
        A, modes = sparse.csr_matrix((np.array(system.values), indices, offsets)), None
    else:
        blocks = np.array(system.values).reshape(-1, 3, 3)
        A, modes = sparse.bsr_matrix((blocks, indices, offsets)), system.rigid_modes()
    del system
    forget_peak()

    start = time.perf_counter()
    levels = pyamg.smoothed_aggregation_solver(A, B=modes, **SETTINGS)
    ready = time.perf_counter()
    history = []
    x = levels.solve(b, tol=1e-8, maxiter=1000, accel="cg", residuals=history)
    end = time.perf_counter()
    memory = peak() - before
    figures = {
        "unknowns": len(b),
        "setup_seconds": ready - start,
        "solve_seconds": end - ready,
        "iterations": len(history) - 1,
        "relative_residual": np.linalg.norm(b - A @ x) / np.linalg.norm(b),
        "solution_norm": np.linalg.norm(x),
        "peak_bytes": memory,
        "version": f"PyAMG {pyamg.__version__}",
    }
    print(json.dumps(figures))


if __name__ == "__main__":
    main()

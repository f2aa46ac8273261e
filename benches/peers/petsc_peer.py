"""Solve a system by PETSc's conjugate gradients with BoomerAMG or GAMG; print a line of JSON.

Usage: mpirun -n 2 python3 petsc_peer.py FOLDER boomeramg|gamg [further options of PETSc]
       mpirun -n 2 python3 petsc_peer.py --check

The matrix is scalar (AIJ), with blocks of size 3 declared for elasticity; rows are divided
evenly. GAMG gets the six rigid-body modes.
"""

import json
import sys
import time

import petsc4py
from measure import System, forget_peak, peak, resident

COMMON = {
    "-ksp_type": "cg",
    "-ksp_norm_type": "unpreconditioned",
    "-ksp_rtol": "1e-8",
    "-ksp_max_it": "1000",
}
# The fastest that we found among the settings that the manuals name for three dimensions:
# BoomerAMG's own defaults take five to nine times as long; for GAMG nothing beat them throughout.
BOOMERAMG = {
    "-pc_type": "hypre",
    "-pc_hypre_type": "boomeramg",
    "-pc_hypre_boomeramg_coarsen_type": "PMIS",
    "-pc_hypre_boomeramg_agg_nl": "1",
    "-pc_hypre_boomeramg_interp_type": "ext+i",
    "-pc_hypre_boomeramg_P_max": "4",
    "-pc_hypre_boomeramg_relax_type_all": "Chebyshev",
}
SETTINGS = {
    ("boomeramg", 1): BOOMERAMG,
    ("boomeramg", 3): {**BOOMERAMG, "-pc_hypre_boomeramg_nodal_coarsen": "4"},
    ("gamg", 1): {"-pc_type": "gamg"},
    ("gamg", 3): {"-pc_type": "gamg"},
}


def matrix(PETSc, system, first, last):
    """The rows of this rank."""
    begin, end = system.offsets[first], system.offsets[last]
    size = system.block * (last - first), system.block * system.rows
    entries = slice(begin * system.block**2, end * system.block**2)
    rows = (system.offsets[first : last + 1] - begin, system.indices[begin:end], system.values[entries])
    if system.block == 1:
        return PETSc.Mat().createAIJ((size, size), csr=rows)
    blocks = PETSc.Mat().createBAIJ((size, size), system.block, csr=rows)
    return blocks.convert("aij")


def vector(PETSc, numbers, block):
    """The numbers of this rank as a distributed vector."""
    made = PETSc.Vec().createMPI((len(numbers), None), bsize=block)
    made.array[:] = numbers
    return made


def main():
    if sys.argv[1:] == ["--check"]:
        from petsc4py import PETSc

        PETSc.Sys.hasExternalPackage("hypre") or sys.exit("PETSc is built without hypre")
        return
    folder, method, *further = sys.argv[1:]
    system = System(folder)
    settings = {**COMMON, **SETTINGS[method, system.block]}
    petsc4py.init([word for option in settings.items() for word in option] + further)
    from petsc4py import PETSc

    world = PETSc.COMM_WORLD
    before = resident()
    first, last = (system.rows * (world.rank + k) // world.size for k in (0, 1))
    A = matrix(PETSc, system, first, last)
    b = vector(PETSc, system.rhs[system.block * first : system.block * last], system.block)
    if system.block == 3:
        places = vector(PETSc, system.points[first:last].ravel(), 3)
        A.setNearNullSpace(PETSc.NullSpace().createRigidBody(places))
    del system
    forget_peak()

    x = b.duplicate()
    solver = PETSc.KSP().create()
    solver.setOperators(A)
    solver.setFromOptions()
    world.barrier()
    start = time.perf_counter()
    solver.setUp()
    world.barrier()
    ready = time.perf_counter()
    solver.solve(b, x)
    world.barrier()
    end = time.perf_counter()
    memory = vector(PETSc, [peak() - before], 1)
    residual = (b - A * x).norm() / b.norm()
    figures = {
        "unknowns": b.size,
        "setup_seconds": ready - start,
        "solve_seconds": end - ready,
        "iterations": solver.getIterationNumber(),
        "relative_residual": residual,
        "solution_norm": x.norm(),
        "peak_bytes": int(memory.sum()),
        "version": "PETSc " + ".".join(map(str, PETSc.Sys.getVersion())),
    }
    if world.rank == 0:
        print(json.dumps(figures))


if __name__ == "__main__":
    main()

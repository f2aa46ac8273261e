#!/usr/bin/env python3
"""Solve the same systems by Octruss, BoomerAMG, GAMG and PyAMG; print a table in Markdown.

Usage: python3 benches/peers/solvers.py [--size small|large|unrefined|all] [--repeats N]

Every solver reads the same files (matrix, right-hand side, positions; ours its prolongations,
too) in a process of its own, and solves by preconditioned conjugate gradients from zero until
the residual itself, not the preconditioned one, is 1e-8 of the right-hand side. Two threads or
two MPI ranks; PyAMG has one thread. Repeats take turns, medians count. Python, MPI and reading
are not timed. Memory is the most that setting up and solving held, the fine matrix included,
less what the process held before it read a byte; of ranks the sum. Our set-up includes making
the prolongations from the refined meshes; their memory counts as well.

The size `unrefined` is a mesh as a mesher makes it, which no level lies below: all solvers have
the matrix alone (and positions, for the rigid-body modes). Gmsh makes that mesh once.

Figures go to target/peers/solvers.json. Large systems need 12 GB of memory, 6 GB of disk and
about a quarter of an hour. A peer that is missing is left out with a message. On Debian:

    apt-get install python3-petsc4py python3-petsc4py-real openmpi-bin
    python3 -m venv target/peers/venv && target/peers/venv/bin/pip install pyamg gmsh

PETSC_PYTHON and PYAMG_PYTHON name other interpreters than /usr/bin/python3 and that of the venv.
"""

import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
OUTPUT = ROOT / "target" / "peers"
OURS = ROOT / "target" / "release" / "examples" / "octruss-peer"
BRACKET = ROOT / "examples" / "meshes" / "bracket.msh"
# Of the sizes that the geometry asks for, 0.055 gives 104,008 vertices and 552,307 tets.
UNREFINED_GEOMETRY, UNREFINED_FACTOR = ROOT / "examples" / "meshes" / "l-bracket.geo", 0.055
UNREFINED = OUTPUT / "l-bracket.msh"
PETSC_PYTHON = os.environ.get("PETSC_PYTHON", "/usr/bin/python3")
PYAMG_PYTHON = os.environ.get("PYAMG_PYTHON", str(OUTPUT / "venv" / "bin" / "python"))
THREADS = 2
# Where Debian keeps the build for real numbers; the link to it is in a package for developers.
PETSC_BUILDS = sorted(Path("/usr/lib/petscdir").glob("petsc*/*-real"))
ENVIRONMENT = {
    **({"PETSC_DIR": str(PETSC_BUILDS[-1])} if PETSC_BUILDS else {}),
    **os.environ,
    "RAYON_NUM_THREADS": str(THREADS),
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
}

# Body, problem, and for each size the coarsest mesh and how often it is refined.
CASES = [
    ("cube", "poisson", {"small": ("cube:6", 3), "large": ("cube:6", 4)}),
    ("bracket", "poisson", {"small": (BRACKET, 3), "large": (BRACKET, 4)}),
    ("cube", "elasticity", {"small": ("cube:4", 3), "large": ("cube:9", 3)}),
    ("bracket", "elasticity", {"small": (BRACKET, 2), "large": (BRACKET, 3)}),
    ("l-bracket", "poisson", {"unrefined": (UNREFINED, 0)}),
    ("l-bracket", "elasticity", {"unrefined": (UNREFINED, 0)}),
]
SIZES = ["small", "large", "unrefined"]
LINEAR, BOX_SPLINE, WITHOUT_LEVELS = "Octruss, linear", "Octruss, box-spline", "Octruss"
# Ours: the scheme that prolongs. Without levels there is nothing to prolong between.
OURS_BY_LEVELS = {LINEAR: "linear", BOX_SPLINE: "box-spline"}
OURS_WITHOUT_LEVELS = {WITHOUT_LEVELS: "linear"}
# Each peer: what is called, how to see whether it is there, and how to get it.
MPI = ["mpirun", "-n", str(THREADS), "--use-hwthread-cpus", PETSC_PYTHON, HERE / "petsc_peer.py"]
PETSC_HINT = "apt-get install python3-petsc4py python3-petsc4py-real openmpi-bin"
PYAMG_HINT = f"python3 -m venv {OUTPUT / 'venv'} && {PYAMG_PYTHON} -m pip install pyamg gmsh"
PEERS = {
    "BoomerAMG": (lambda folder: [*MPI, folder, "boomeramg"], [*MPI, "--check"], PETSC_HINT),
    "GAMG": (lambda folder: [*MPI, folder, "gamg"], [*MPI, "--check"], PETSC_HINT),
    "PyAMG": (
        lambda folder: [PYAMG_PYTHON, HERE / "pyamg_peer.py", folder],
        [PYAMG_PYTHON, "-c", "import pyamg"],
        PYAMG_HINT,
    ),
}
# For the large systems, linear prolongation: the largest share of the faster of BoomerAMG and
# GAMG that set-up and solve may take.
TARGETS = {
    ("cube", "poisson"): 0.09,
    ("bracket", "poisson"): 0.22,
    ("cube", "elasticity"): 0.10,
    ("bracket", "elasticity"): 0.16,
}
MOST_MEMORY = 0.6  # of the smallest peer's
MOST_SETUP = 6  # iterations
SAME = 1e-5  # relative difference of the norms of two solutions


def works(command):
    try:
        return subprocess.run(command, capture_output=True, env=ENVIRONMENT).returncode == 0
    except FileNotFoundError:
        return False


# So that builds and editors in the background do not count.
REAL_TIME = ["chrt", "-f", "1"] if works(["chrt", "-f", "1", "true"]) else []


def figures(command):
    """The line of JSON that a solver prints."""
    command = [*REAL_TIME, *map(str, command)]
    done = subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return json.loads(done.stdout.splitlines()[-1])


def peers():
    """The command of each peer that is there, for a folder."""
    found = {}
    for name, (command, check, hint) in PEERS.items():
        if works(check):
            found[name] = command
        else:
            print(f"WITHOUT {name}, which is not there. Get it by\n    {hint}", file=sys.stderr)
    return found


def make_unrefined():
    """Let Gmsh make the mesh that is not refined, unless it is there."""
    if not UNREFINED.exists():
        program = HERE / "unrefined_mesh.py"
        subprocess.run([PYAMG_PYTHON, program, UNREFINED_GEOMETRY, str(UNREFINED_FACTOR), UNREFINED], check=True)


def measure(case, commands, repeats):
    """The medians of ours and the peers on one system, written to a folder for the while."""
    body, problem, mesh, levels = case
    folder = OUTPUT / "system"
    ours = OURS_BY_LEVELS if levels else OURS_WITHOUT_LEVELS
    if mesh == UNREFINED:
        make_unrefined()
    subprocess.run([*REAL_TIME, OURS, "write", str(mesh), problem, str(levels), folder], check=True)
    commands = {name: [OURS, "solve", folder, scheme] for name, scheme in ours.items()} | {
        name: command(folder) for name, command in commands.items()
    }
    runs = {name: [] for name in commands}
    for _ in range(repeats):
        for name, command in commands.items():
            runs[name].append(figures(command))
    made = {p["name"]: p for p in json.loads((folder / "system.json").read_text())["prolongations"]}
    shutil.rmtree(folder)
    result = {name: medians(all_runs) for name, all_runs in runs.items()}
    for name, scheme in ours.items():
        result[name]["setup_seconds"] += made[scheme]["seconds"]
        result[name]["affine_defect"] = made[scheme]["affine_defect"]
    check_same(result, f"{body}, {problem}")
    return result


def medians(runs):
    """Of numbers the median, of words the last."""

    def middle(key):
        values = [run[key] for run in runs]
        return values[-1] if isinstance(values[-1], str) else statistics.median(values)

    return {key: middle(key) for key in runs[-1]}


def check_same(result, case):
    """All must have reached the goal, and the same solution."""
    norm = reference(result)["solution_norm"]
    for name, got in result.items():
        if not got["relative_residual"] <= 1.01e-8:
            print(f"{case}: {name} ended at a residual of {got['relative_residual']:.1e}", file=sys.stderr)
        if abs(got["solution_norm"] / norm - 1) > SAME:
            raise SystemExit(f"{case}: {name} solved another system than Octruss")


def reference(result):
    """Our first column."""
    return next(iter(result.values()))


def total(got):
    return got["setup_seconds"] + got["solve_seconds"]


def print_tables(results):
    """One table of the refined systems, one of those that are not, where there are any."""
    for unrefined in (False, True):
        chosen = {case: result for case, result in results.items() if (WITHOUT_LEVELS in result) == unrefined}
        if chosen:
            print_table(chosen)
            print()


def print_table(results):
    """A row for each system, a column for each solver."""
    names = list(reference(results))
    print("| set-up + solve in s, iterations, peak in MB |", " | ".join(names), "|")
    print("|", " | ".join(["---"] * (len(names) + 1)), "|")
    for (body, problem, _), result in results.items():
        cells = [f"{problem.capitalize()}, {body}, {reference(result)['unknowns']:,} unknowns"]
        for got in result.values():
            seconds = f"{got['setup_seconds']:.2f} + {got['solve_seconds']:.2f}"
            cells.append(f"{seconds}, {got['iterations']:.0f}, {got['peak_bytes'] / 1e6:,.0f}")
        print("|", " | ".join(cells), "|")


def print_targets(results):
    """Linear prolongation against the peers: shares of time and memory, set-up in iterations."""
    heads = ["large system", "time over that of the faster of BoomerAMG and GAMG"]
    heads += ["memory over the least of a peer", "set-up, iterations"]
    print("|", " | ".join(heads), "|")
    print("| --- | --- | --- | --- |")
    for (body, problem, size), result in results.items():
        peers = [got for name, got in result.items() if name in PEERS]
        rivals = [result[name] for name in ("BoomerAMG", "GAMG") if name in result]
        if size != "large" or not rivals:
            continue
        ours = result[LINEAR]
        time = total(ours) / min(map(total, rivals))
        memory = ours["peak_bytes"] / min(got["peak_bytes"] for got in peers)
        setup = ours["setup_seconds"] * ours["iterations"] / ours["solve_seconds"]
        cells = [
            f"{problem.capitalize()}, {body}",
            f"{time:.3f} ({verdict(time, TARGETS[body, problem])})",
            f"{memory:.3f} ({verdict(memory, MOST_MEMORY)})",
            f"{setup:.1f} ({verdict(setup, MOST_SETUP)})",
        ]
        print("|", " | ".join(cells), "|")


def verdict(found, most):
    return f"{'hit' if found <= most else 'miss'}, at most {most}"


def main():
    summary, _, description = __doc__.partition("\n\n")
    parser = argparse.ArgumentParser(
        description=summary, epilog=description, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--size", choices=[*SIZES, "all"], default="small")
    parser.add_argument("--repeats", type=int, default=3)
    arguments = parser.parse_args()
    sizes = SIZES if arguments.size == "all" else [arguments.size]
    OUTPUT.mkdir(parents=True, exist_ok=True)
    build = ["cargo", "build", "--release", "--locked", "--example", OURS.name]
    subprocess.run(build, cwd=ROOT, check=True)
    commands = peers()
    results = {}
    for size in sizes:
        for body, problem, meshes in (case for case in CASES if size in case[2]):
            print(f"{body}, {problem}, {size} ...", file=sys.stderr)
            results[body, problem, size] = measure((body, problem, *meshes[size]), commands, arguments.repeats)
    named = {", ".join(case): result for case, result in results.items()}
    (OUTPUT / "solvers.json").write_text(json.dumps(named, indent=1))
    copies = [reference(result)["copy_bytes_per_second"] for result in results.values()]
    versions = {got["version"] for result in results.values() for got in result.values() if "version" in got}
    print(f"Medians of {arguments.repeats}; memory copied at {statistics.median(copies) / 1e9:.1f} GB/s.", end=" ")
    print(f"{'Real-time' if REAL_TIME else 'Ordinary'} priority. {', '.join(sorted(versions))}.\n")
    print_tables(results)
    print_targets(results)


if __name__ == "__main__":
    main()

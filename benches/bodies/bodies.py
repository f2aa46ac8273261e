#!/usr/bin/env python3
"""Refine round bodies of known size in three ways; print what becomes of them, in Markdown.

Usage: python3 benches/bodies/bodies.py [--levels N] [BODY...]

Gmsh meshes each body coarsely. Octruss refines it by linear and plain box-spline subdivision, and
by box splines that pass through the input's vertices. Volumes are relative to that of the exact
body; "input to limit" is the largest distance of an input's boundary vertex from the limit; η is
the smallest mean ratio of any level; "bore" the mean radius of the bore's vertices over the exact one.

Needs the release binary and Gmsh's Python module (pip install gmsh).
"""

import argparse
import json
import math
import random
import subprocess
import tempfile
from pathlib import Path

import gmsh

ROOT = Path(__file__).resolve().parents[2]
OCTRUSS = ROOT / "target" / "release" / "octruss"
WAYS = {
    "linear": ["scheme = \"linear\""],
    "plain": ["scheme = \"box-spline\"", "interpolate = false"],
    "through": ["scheme = \"box-spline\""],
}


def bush(segments, fillet=0.0):
    """A sleeve with a flange, of two materials: the bore has radius 3.5."""
    occ = gmsh.model.occ
    lower = occ.addCylinder(0, 0, 0, 0, 0, 6, 5.5)
    flange = occ.addCylinder(0, 0, 0, 0, 0, 3, 8)
    upper = occ.addCylinder(0, 0, 6, 0, 0, 6, 5.5)
    whole, _ = occ.fuse([(3, lower)], [(3, flange)])
    if fillet:
        occ.synchronize()
        is_rim = lambda tag: abs(occ.getMass(1, tag) - 2 * math.pi * 5.5) < 1e-6
        middle = lambda tag: occ.getCenterOfMass(1, tag)[2]
        edges = [tag for _, tag in gmsh.model.getEntities(1)]
        rims = [tag for tag in edges if is_rim(tag) and abs(middle(tag) - 3) < 1e-6]
        whole = occ.fillet([whole[0][1]], rims, [fillet])
    bores = [occ.addCylinder(0, 0, z, 0, 0, 7, 3.5) for z in (-1, 6)]
    lower, _ = occ.cut(whole, [(3, bores[0])])
    upper, _ = occ.cut([(3, upper)], [(3, bores[1])])
    occ.fragment(lower, upper)
    return 3.5, segments, 2.5


def plate(segments):
    occ = gmsh.model.occ
    box = occ.addBox(-10, -10, 0, 20, 20, 4)
    hole = occ.addCylinder(0, 0, -1, 0, 0, 6, 4)
    occ.cut([(3, box)], [(3, hole)])
    return 4.0, segments, 4.0


def pipe(segments):
    occ = gmsh.model.occ
    outer = occ.addCylinder(0, 0, 0, 0, 0, 10, 5)
    inner = occ.addCylinder(0, 0, -1, 0, 0, 12, 4)
    occ.cut([(3, outer)], [(3, inner)])
    return 4.0, segments, 2.0


def given(name, radius=None):
    def build():
        gmsh.open(str(ROOT / "examples" / "meshes" / f"{name}.geo"))
        return radius, None, None

    return build


BODIES = {
    "bush": lambda: bush(16),
    "bush, 12 segments": lambda: bush(12),
    "bush with fillet": lambda: bush(16, 1.0),
    "plate, 12 segments": lambda: plate(12),
    "plate, 16 segments": lambda: plate(16),
    "plate, 24 segments": lambda: plate(24),
    "pipe, 12 segments": lambda: pipe(12),
    "pipe, 16 segments": lambda: pipe(16),
    "pipe, 24 segments": lambda: pipe(24),
    "ball": given("ball"),
    "ball, jittered": given("ball"),
    "thick-sphere": given("thick-sphere"),
    "bracket": given("bracket"),
    "l-bracket": given("l-bracket"),
    "holed-plate": given("holed-plate"),
    "torus": given("torus"),
}


def make(name, path):
    """The mesh, or the given one; the radius of the bore and the exact volume."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    radius, segments, size = BODIES[name]()
    gmsh.model.occ.synchronize()
    occ = gmsh.model.occ
    volume = sum(occ.getMass(*v) for v in gmsh.model.getEntities(3))
    if segments:
        gmsh.option.setNumber("Mesh.MeshSizeFromCurvature", segments)
        gmsh.option.setNumber("Mesh.MeshSizeMax", size)
        gmsh.option.setNumber("Mesh.RandomSeed", 1)
        for number, (_, tag) in enumerate(gmsh.model.getEntities(3)):
            gmsh.model.addPhysicalGroup(3, [tag], number + 1)
        gmsh.model.mesh.generate(3)
        gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
        gmsh.write(str(path))
    gmsh.finalize()
    if not segments:
        source = ROOT / "examples" / "meshes" / f"{name.split(',')[0]}.msh"
        path.write_bytes(source.read_bytes())
        if "jittered" in name:
            jitter(path)
    return radius, volume


def jitter(path):
    """Moves the vertices inside a ball, and turns those on it, by a fifth of an edge."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(str(path))
    random.seed(1)
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    for number, tag in enumerate(tags):
        point = coordinates[3 * number : 3 * number + 3]
        moved = [x + 0.08 * random.uniform(-1, 1) for x in point]
        if math.hypot(*point) > 1 - 1e-6:
            moved = [x / math.hypot(*moved) for x in moved]
        gmsh.model.mesh.setNode(tag, moved, [])
    gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
    gmsh.write(str(path))
    gmsh.finalize()


def refined(mesh, way, levels, folder):
    """The levels of the report, and the path of the finest mesh."""
    config = folder / "body.toml"
    stage = "\n".join([*WAYS[way], f"levels = {levels}"])
    config.write_text(
        f'name = "body"\n[[stage]]\nkind = "import"\npath = "{mesh}"\n[[stage]]\nkind = "check"\n'
        f'[[stage]]\nkind = "subdivide"\n{stage}\n[[stage]]\nkind = "write"\nlevels = false\n'
    )
    command = [OCTRUSS, "run", config, "--out", folder / "out"]
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode != 0:
        return None
    report = json.loads((folder / "out" / "report.json").read_text())
    return next(stage for stage in report["stages"] if "levels" in stage)["levels"]


def bore(mesh, levels, radius, folder):
    """The mean distance from the axis of the boundary vertices of a bore, over its radius."""
    fine = folder / "fine.mesh"
    command = [OCTRUSS, "refine", mesh, fine, "--scheme", "box-spline", "--levels", levels, "--quiet"]
    subprocess.run(list(map(str, command)), capture_output=True, check=True)
    words = fine.read_text().split()

    def table(keyword, kind, width):
        at = words.index(keyword)
        count = int(words[at + 1])
        numbers = list(map(kind, words[at + 2 : at + 2 + count * width]))
        return [numbers[i : i + width] for i in range(0, len(numbers), width)]

    points = table("Vertices", float, 4)
    faces = {}
    for a, b, c, d, _ in table("Tetrahedra", int, 5):
        for face in ((a, b, c), (a, b, d), (a, c, d), (b, c, d)):
            key = tuple(sorted(face))
            faces[key] = faces.get(key, 0) + 1
    boundary = {v for face, count in faces.items() if count == 1 for v in face}
    heights = [point[2] for point in points]
    low, high = min(heights), max(heights)
    radii = [math.hypot(*points[v - 1][:2]) for v in boundary if low + 1e-6 < points[v - 1][2] < high - 1e-6]
    radii = [r for r in radii if abs(r - radius) < 0.12 * radius]
    return sum(radii) / len(radii) / radius


def row(name, levels):
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        mesh = folder / "body.msh"
        radius, exact = make(name, mesh)
        cells = [name]
        for way in WAYS:
            made = refined(mesh, way, levels, folder)
            if made is None:
                cells.append("refused")
                continue
            first, last = made[0], made[-1]
            share = last["volume"] / exact
            if way == "linear":
                cells += [f"{first['eta_min']:.3f}", f"{share:.4f}"]
            else:
                pulled = (last.get("guard") or {}).get("pulled_back", 0)
                worst = min(level["eta_min"] for level in made)
                note = f", {pulled} pulled" if pulled else ""
                placed = (last.get("interpolation") or {}).get("placement", "")
                note += ", at limit" if placed == "at-limit" else ""
                away = made[-1]["limit"]["input_largest"]
                cells.append(f"{share:.4f}, {away:.1e}, {worst:.3f}{note}")
        cells.append(f"{bore(mesh, levels, radius, folder):.5f}" if radius else "")
        print("| " + " | ".join(cells) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--levels", type=int, default=2)
    parser.add_argument("bodies", nargs="*")
    arguments = parser.parse_args()
    print("| body | η, input | volume, linear | plain: volume, input to limit, η | through the input | its bore |")
    print("| --- | --- | --- | --- | --- | --- |")
    for name in arguments.bodies or BODIES:
        row(name, arguments.levels)


if __name__ == "__main__":
    main()

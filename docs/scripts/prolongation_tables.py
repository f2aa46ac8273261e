"""Puts the figures of `octruss compare` into docs/prolongation.md.

    for study in cube fichera jumps bracket torus; do
        cargo run --release -- compare configs/prolongation-study-$study.toml
    done
    python3 docs/scripts/prolongation_tables.py

Each table stands between `<!-- table: STUDY GEOMETRY -->` and `<!-- end -->`: the finest level
of `out/prolongation-study-STUDY/compare.json` on that geometry. `<!-- carried -->` is Chang's
test of all studies, `<!-- verdicts -->` what each comparison says. The pictures are copied to
docs/pictures.
"""

import json
import re
import shutil
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/prolongation.md"
STUDIES = ["cube", "fichera", "jumps", "bracket", "torus"]
COLUMNS = (
    "prolongation | coarse | cycle | iterations | mean reduction | complexity | work a digit "
    "| MB a digit | set-up + solve, s"
).split(" | ")


def comparison(study):
    path = ROOT / f"out/prolongation-study-{study}/compare.json"
    return json.loads(path.read_text())


def markdown(head, lines):
    rows = [head, ["---"] * len(head), *lines]
    return "\n".join("| " + " | ".join(row) + " |" for row in rows)


def name(row):
    words = [row["prolongation"]]
    if row["affine_defect"] < row["affine_defect_before"]:
        words.append("corrected")
    if row["interface_rows"] == "linear":
        words.append("linear on interfaces")
    return ", ".join(words)


def is_told(row):
    """Linear rows on interfaces do not change linear interpolation."""
    return not (row["interface_rows"] == "linear" and row["prolongation"].endswith("linear"))


def figures(row):
    if row["iterations"] is None:
        return [name(row), row["coarse_operator"], row["cycle"], "no convergence"] + ["–"] * 5
    return [
        name(row),
        row["coarse_operator"],
        row["cycle"],
        str(row["iterations"]),
        f"{row['mean_reduction']:.3f}",
        f"{row['operator_complexity']:.2f}",
        f"{row['work_per_digit']:.1f}",
        f"{row['bytes_per_digit'] / 1e6:.0f}",
        f"{row['setup_seconds']:.2f} + {row['solve_seconds']:.2f}",
    ]


def table(study, geometry):
    rows = [row for row in comparison(study)["rows"] if row["geometry"] == geometry]
    rows = [row for row in rows if is_told(row)]
    finest = max(row["level"] for row in rows)
    return markdown(COLUMNS, [figures(row) for row in rows if row["level"] == finest])


def carried():
    lines = []
    for study in STUDIES:
        cases = comparison(study)["carried"]
        for geometry in ["flat", "subdivided"]:
            same = [case for case in cases if case["geometry"] == geometry]
            finest = [case for case in same if case["level"] == max(c["level"] for c in same)]
            by = {case["prolongation"]: case for case in finest}
            linear, scheme = by["linear"], by["box-spline"]
            lines.append(
                [f"{study}, {geometry}"]
                + [f"{case[key]:.2e}" for key in ["difference", "energy_difference"]
                   for case in [linear, scheme]]
            )
    head = ["body", "linear", "box-spline", "linear, energy", "box-spline, energy"]
    return markdown(head, lines)


def verdicts():
    sentences = [s for study in STUDIES for s in comparison(study)["verdict"]]
    return "\n".join(f"* {sentence}" for sentence in sentences)


def main():
    page = PAGE.read_text()
    makers = {f"table: {s} {g}": (lambda s=s, g=g: table(s, g))
              for s in STUDIES for g in ["flat", "subdivided"]}
    makers |= {"carried": carried, "verdicts": verdicts}
    for marker, make in makers.items():
        pattern = re.compile(rf"(<!-- {re.escape(marker)} -->\n).*?(<!-- end -->)", re.S)
        page = pattern.sub(lambda found: f"{found[1]}\n{make()}\n\n{found[2]}", page)
    PAGE.write_text(page)
    for study in ["bracket", "torus"]:
        source = ROOT / f"out/prolongation-study-{study}/compare.svg"
        shutil.copy(source, ROOT / f"docs/pictures/prolongation-{study}.svg")


if __name__ == "__main__":
    main()

#!/usr/bin/env bash
# Make every picture of docs/schemes: `bash docs/scripts/make_scheme_pictures.sh`, from anywhere.
#
# It calls `octruss`, which must be on the PATH (or its name in OCTRUSS), and
# Python 3.11 (or the one in PYTHON) with
#   pip install matplotlib==3.11.2 numpy==2.4.6 pillow==13.0.0 vtk==9.7.2
# No display is needed. It takes about two minutes and 2 GiB.
set -euo pipefail

scripts=$(dirname "$(readlink -f "$0")")
pictures=$scripts/../pictures/schemes
python=${PYTHON:-python3}
mkdir -p "$pictures"

"$python" "$scripts/draw_split.py" "$pictures/split.png"
"$python" "$scripts/draw_surfaces.py" "$pictures/surfaces.png"
"$python" "$scripts/draw_shapes.py" "$pictures/shapes.png"
for scheme in linear box-spline averaged interpolatory interpolatory-literal loop-solid; do
    "$python" "$scripts/draw_masks.py" "$scheme" "$pictures/$scheme-masks.png"
    "$python" "$scripts/draw_basis.py" "$scheme" "$pictures/$scheme-basis.png"
done

#!/usr/bin/env bash
# Makes the pictures of the examples in Documentation/Images anew, with the programs of build/test.
set -euo pipefail
[ "${1:-}" != --help ] || { sed -n '2,2s/^# \?//p' "${BASH_SOURCE[0]}"; exit 0; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bin=build/test/bin
images=Documentation/Images
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

$bin/OptimizerAndObserver "$work/convergence.csv" >/dev/null 2>&1
/usr/bin/python3 Examples/OptimizerAndObserver/plot.py "$work/convergence.csv" $images/convergence.png

$bin/ConvergencePlot "$work/paper.csv" "$work/robust.csv" >/dev/null
/usr/bin/python3 Examples/ConvergencePlot/plot.py paper="$work/paper.csv" robust="$work/robust.csv" $images/convergence-robust.png

$bin/dentalscr phantom --level typical --seed 101 --output "$work/case" >/dev/null
mkdir "$work/segmentation" "$work/steps"
$bin/Segmentation "$work/case/case.json" "$work/segmentation" >/dev/null
$bin/StepByStep "$work/case/case.json" "$work/steps" >/dev/null
/usr/bin/python3 - "$work" $images <<'PYTHON'
import pathlib, sys
from PIL import Image

work, images = map(pathlib.Path, sys.argv[1:])
Image.open(work / "segmentation/overlay.png").convert("RGB").resize((1000, 643), Image.LANCZOS).save(
    images / "segmentation.jpg", quality=85
)
page = Image.new("RGB", (1000, 660), (255, 255, 255))
for name, box in (("1-axes", (0, 0, 260, 330)), ("2-radiograph", (270, 60, 530, 270)),
                  ("3-contour", (0, 340, 495, 660)), ("4-registration", (505, 340, 1000, 660))):
    picture = Image.open(work / f"steps/{name}.png").convert("RGB")
    picture.thumbnail((box[2] - box[0], box[3] - box[1]), Image.LANCZOS)
    page.paste(picture, box[:2])
page.save(images / "steps.jpg", quality=85)
PYTHON

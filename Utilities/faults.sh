#!/usr/bin/env bash
# Ends register, render, experiment and batch at random moments, by SIGKILL and by the signals that ask a program to end, and
# has them run out of space at random places; after each it looks at all that is there. Before a release.
#
#     Utilities/faults.sh [KILLS [FULL-DISKS [BUILD-DIR]]]
#
# KILLS, FULL-DISKS: of each of the four verbs; 50 and 13, which are 200 and 52 in all and take ten minutes.
# As root disks are small file systems in memory; others have files that may not grow, and no full disks.
# Exit code: 1 where something was lost, half written, of two runs, or left lying about.
set -euo pipefail
[ "${1:-}" != --help ] || { sed -n '2,9s/^# \?//p' "${BASH_SOURCE[0]}"; exit 0; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."

exec /usr/bin/python3 -m pytest -q -s -p no:cacheprovider Testing/CommandLine/test_interrupted_verbs.py \
  Testing/CommandLine/test_interruptions.py --kills "${1:-50}" --full-disks "${2:-13}" --build-dir "${3:-build/test}"

#!/usr/bin/env bash
# Tests Examples/Cohort at length: on this machine, and on a Slurm of one machine that the test starts and stops. It installs Slurm's
# packages and takes a quarter of an hour; Utilities/test.sh runs one of these tests, without a queue. The log, with the numbers of Slurm's jobs, or the reason why there are none, is build/test-cohort.log.
set -euo pipefail
[ "${1:-}" != --help ] || { sed -n '2,3s/^# \?//p' "${BASH_SOURCE[0]}"; exit 0; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."

Utilities/install-dependencies.sh slurm
Utilities/python-venv.sh
build=${1:-build/test}
/usr/bin/python3 -m pytest -v -s -rs -p no:cacheprovider Testing/Cohort --at-length --build-dir "$build" 2>&1 | tee build/test-cohort.log

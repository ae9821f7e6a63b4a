"""Landmark errors of the segmentation example on phantoms: measure.py build/test/bin [first last]."""
import pathlib
import statistics
import subprocess
import sys
import tempfile


def main(programs, first, last):
    for level in ("typical", "ideal"):
        errors, flagged = [], []
        for seed in range(first, last + 1):
            with tempfile.TemporaryDirectory() as folder:
                case = pathlib.Path(folder) / "case"
                subprocess.run(
                    [programs / "dentalscr", "phantom", "--level", level, "--seed", str(seed), "--output", case],
                    check=True, stdout=subprocess.DEVNULL,
                )
                done = subprocess.run(
                    [programs / "Segmentation", case / "case.json", folder], check=True, capture_output=True, text=True
                )
            values = dict(line.split(": ") for line in done.stdout.splitlines())
            mine = [float(values[f"{jaw} landmark error px"]) for jaw in ("upper", "lower")]
            verdicts = {values[f"{jaw} verdict"] for jaw in ("upper", "lower")}
            print(level, seed, *(f"{error:.2f}" for error in mine), *sorted(verdicts), flush=True)
            errors.append(max(mine))
            flagged.append("failed" in verdicts)
        kept = [error for error, failed in zip(errors, flagged) if not failed]
        print(
            f"{level}: {len(errors)} cases, the worse jaw: median {statistics.median(errors):.2f} px, "
            f"{sum(error < 5 for error in errors)} below 5 px, worst {max(errors):.1f}; "
            f"{sum(flagged)} failed, worst of the others {max(kept):.1f}"
        )


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), *map(int, sys.argv[2:4] or (101, 112)))

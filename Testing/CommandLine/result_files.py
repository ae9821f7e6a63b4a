"""What the tests of batches and of faults read of what the program has written."""
import csv
import json


def rows_of(folder, *without):
    """The rows of a batch's table, without columns that differ from run to run."""
    with open(folder / "summary.csv", newline="", encoding="utf-8") as file:
        return [{key: value for key, value in row.items() if key not in without} for row in csv.DictReader(file)]


def poses_in(result):
    """By jaw the projection that a result says; the text of its file, whose times are of no run alone."""
    return {jaw: found["projection_3x4"] for jaw, found in json.loads(result)["jaws"].items()}


def poses_of(folder):
    return poses_in((folder / "result.json").read_text())

"""Many cases from a table, one row of results a case: batch_folder.py cases.csv folder."""
import csv
import pathlib
import sys

import dentalscr as ds


def make_case(row, folder):
    """The columns that are known make a case; files are relative to the table."""

    def file(column):
        return folder / row[column] if row.get(column) else None

    geometry = {}
    if row.get("Spacing"):
        geometry["pixelSpacing"] = (float(row["Spacing"]),) * 2
    if row.get("PrincipalU") and row.get("PrincipalV"):
        geometry["principalPoint"] = (float(row["PrincipalU"]), float(row["PrincipalV"]))
    return ds.Case(
        upper=file("Upper"),
        lower=file("Lower"),
        contours=file("Contour"),
        image=file("Cephalogram"),
        geometry=geometry or None,
        landmarks3D=file("Landmarks3D"),
        landmarks2D=file("Landmarks2D"),
    )


def main(table, output):
    output.mkdir(parents=True, exist_ok=True)
    with open(table, newline="") as file:
        reader = csv.DictReader(file)
        rows, columns = list(reader), reader.fieldnames
    registered = 0
    with open(output / "results.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, [*columns, "Status", "UpperError_px", "LowerError_px", "Error"])
        writer.writeheader()
        for row in rows:
            # Every column of the input comes back, whatever it means.
            try:
                result = ds.register(make_case(row, table.parent))
                result.Write(output / row["CaseID"])
                jaws = result.to_dict()["jaws"]
                errors = {name: jaws.get(name, {}).get("error", {}).get("mean_px", "") for name in ("upper", "lower")}
                row.update(Status=result.status, UpperError_px=errors["upper"], LowerError_px=errors["lower"])
                registered += 1
            except (ds.Error, ValueError) as error:
                row.update(Status="error", Error=str(error))
            writer.writerow(row)
            file.flush()
            print(row["CaseID"], row["Status"], row.get("Error", ""), file=sys.stderr)
    print(f"cases: {len(rows)}")
    print(f"registered: {registered}")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))

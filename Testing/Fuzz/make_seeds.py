#!/usr/bin/env python3
"""Makes what dentalscr-fuzz begins with: in FOLDER/seeds/TARGET small files of every format that is read, and in
FOLDER/corpus/TARGET every input that once failed, each of which has to be read or refused.

    make_seeds.py FOLDER --program build/test/bin/dentalscr
"""
import argparse
import base64
import io
import json
import pathlib
import struct
import subprocess
import sys
import zipfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "Testing" / "CommandLine"))

import test_hostile_images as hostile  # noqa: E402  (the files that the tests make)

# The readers that dentalscr-fuzz knows.
TARGETS = [
    "archive", "batch", "case", "cephalometric", "contours", "drawing", "folder", "image", "labelmap", "landmarks2d", "landmarks3d", "level",
    "mask", "report", "result", "scan", "session", "start", "summary", "toothlabels", "transform",
]
CORNERS = [(x, y, z) for x in (0, 9) for y in (0, 9) for z in (0, 9)]
FACES = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]


def scans():
    stl = bytes(80) + struct.pack("<I", len(FACES))
    for face in FACES:
        stl += struct.pack("<12fH", *[0] * 3, *[c for corner in face for c in CORNERS[corner]], 0)
    text = "solid cube\n"
    for face in FACES:
        text += "facet normal 0 0 0\nouter loop\n"
        text += "".join("vertex %g %g %g\n" % CORNERS[corner] for corner in face) + "endloop\nendfacet\n"
    points = "".join("%g %g %g\n" % corner for corner in CORNERS)
    faces = "".join("3 %d %d %d\n" % face for face in FACES)
    ply = "ply\nformat {} 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
    ply += "element face 12\nproperty list uchar int vertex_indices\nend_header\n"
    binary = b"".join(struct.pack("<3f", *corner) for corner in CORNERS)
    binary += b"".join(struct.pack("<B3i", 3, *face) for face in FACES)
    flat = " ".join(str(corner) for face in FACES for corner in face)
    offsets = " ".join(str(3 * (k + 1)) for k in range(len(FACES)))
    raw = struct.pack("<24f", *[c for corner in CORNERS for c in corner])
    packed = zlib.compress(raw)
    packed = base64.b64encode(struct.pack("<4I", 1, len(raw), 0, len(packed))) + base64.b64encode(packed)
    vtp = (
        '<?xml version="1.0"?><VTKFile type="PolyData" version="0.1" byte_order="LittleEndian" header_type="UInt32"{}>'
        '<PolyData><Piece NumberOfPoints="8" NumberOfPolys="12"><Points><DataArray type="Float32" NumberOfComponents="3" format="{}">'
        '{}</DataArray></Points><Polys><DataArray type="Int32" Name="connectivity" format="ascii">' + flat +
        '</DataArray><DataArray type="Int32" Name="offsets" format="ascii">' + offsets +
        "</DataArray></Polys></Piece></PolyData></VTKFile>"
    )
    vtk = "# vtk DataFile Version 3.0\ncube\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n" + points + "POLYGONS 12 48\n" + faces
    vtk += "POINT_DATA 8\nSCALARS Label int 1\nLOOKUP_TABLE default\n11 11 12 12 0 0 21 21\n"
    def array(kind, name, components, data):
        return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="appended" offset="{data}"/>'

    connectivity = struct.pack("<36i", *[corner for face in FACES for corner in face])
    ends = struct.pack("<12i", *[3 * (k + 1) for k in range(len(FACES))])
    appended = b""
    offsets_at = []
    for block in (raw, connectivity, ends):
        offsets_at.append(len(appended))
        appended += struct.pack("<I", len(block)) + block
    vtp_raw = (
        '<?xml version="1.0"?><VTKFile type="PolyData" version="0.1" byte_order="LittleEndian" header_type="UInt32">'
        '<PolyData><Piece NumberOfPoints="8" NumberOfPolys="12"><Points>' + array("Float32", "Points", 3, offsets_at[0]) +
        "</Points><Polys>" + array("Int32", "connectivity", 1, offsets_at[1]) + array("Int32", "offsets", 1, offsets_at[2]) +
        '</Polys></Piece></PolyData><AppendedData encoding="raw">_'
    ).encode() + appended + b"</AppendedData></VTKFile>"
    return {
        "binary.stl": stl,
        "text.stl": text + "endsolid cube\n",
        "text.ply": ply.format("ascii") + points + faces,
        "binary.ply": ply.format("binary_little_endian").encode() + binary,
        "a.obj": "".join("v %g %g %g\n" % c for c in CORNERS) + "".join("f %d %d %d\n" % tuple(i + 1 for i in f) for f in FACES),
        "a.off": "OFF\n8 12 0\n" + points + faces,
        "a.vtk": vtk,
        "ascii.vtp": vtp.format("", "ascii", points),
        "raw.vtp": vtp_raw,
        # A header may have words before its format, and colours and labels beside its points.
        "comment.ply": ply.format("ascii").replace("ply\n", "ply\ncomment made by hand\nobj_info num_cols 8\n", 1) + points + faces,
        "colours.ply": ply.format("binary_big_endian").replace("property float z\n", "property float z\nproperty uchar red\nproperty double quality\n", 1).encode()
        + b"".join(struct.pack(">3fBd", *corner, 7, 0.5) for corner in CORNERS) + b"".join(struct.pack(">B3i", 3, *face) for face in FACES),
        # Its first word is another one: no reader of PLY files knows it, and what else could is asked.
        "other-word.ply": ("plx" + (ply.format("ascii") + points + faces)[3:]),
        "zlib.vtp": vtp.format(' compressor="vtkZLibDataCompressor"', "binary", packed.decode()),
    }


LINE = [[10, 10], [40, 12], [38, 44], [12, 40]]


def contours():
    return {
        "own.json": json.dumps({"image_size": [50, 50], "contours": {"upper": [{"code": "UR1", "closed": True, "sigma_px": 1.5, "points": LINE}]}}),
        "labelme.json": json.dumps({"imagePath": "a.png", "imageWidth": 50, "imageHeight": 50, "shapes": [{"label": "11", "shape_type": "polygon", "points": LINE}]}),
        "coco.json": json.dumps({
            "images": [{"id": 1, "file_name": "a.png", "width": 50, "height": 50}], "categories": [{"id": 1, "name": "11"}],
            "annotations": [{"id": 1, "image_id": 1, "category_id": 1, "segmentation": [[c for p in LINE for c in p]]},
                            {"id": 2, "image_id": 1, "category_id": 1, "segmentation": {"size": [50, 50], "counts": [510, 30, 20, 30, 1910]}}]}),
        "via.json": json.dumps({"a.png1": {"filename": "a.png", "size": 1, "regions": [
            {"shape_attributes": {"name": "polygon", "all_points_x": [p[0] for p in LINE], "all_points_y": [p[1] for p in LINE]}, "region_attributes": {"tooth": "11"}}]}}),
        "supervisely.json": json.dumps({"size": {"height": 50, "width": 50}, "objects": [{"classTitle": "11", "geometryType": "polygon", "points": {"exterior": LINE, "interior": []}}]}),
        "labelstudio.json": json.dumps([{"data": {"image": "a.png"}, "annotations": [{"result": [
            {"type": "polygonlabels", "original_width": 50, "original_height": 50, "value": {"points": [[20, 20], [80, 24], [76, 88]], "polygonlabels": ["11"]}}]}]}]),
        "cvat.xml": '<annotations><version>1.1</version><image id="0" name="a.png" width="50" height="50"><polygon label="11" points="10,10;40,12;38,44"/>'
                    '<mask label="12" rle="3, 4, 3" left="2" top="2" width="5" height="2"/></image></annotations>',
        "table.csv": "label,x,y\n" + "".join("UR1,%d,%d\n" % tuple(p) for p in LINE),
    }


def landmarks(dimension):
    names = ["UR1_tip", "UL1_tip", "UR6_MB", "LR1_tip"]
    points = {name: [float(10 * k + d) for d in range(dimension)] for k, name in enumerate(names)}
    slicer = {"markups": [{"type": "Fiducial", "coordinateSystem": "LPS", "controlPoints": [{"label": n, "position": (p + [0.0])[:3]} for n, p in points.items()]}]}
    return {
        "own.json": json.dumps(points),
        "list.json": json.dumps({"landmarks": points}),
        "slicer.mrk.json": json.dumps(slicer),
        "table.csv": "label," + ",".join("xyz"[:dimension]) + "\n" + "".join(n + "," + ",".join(map(str, p)) + "\n" for n, p in points.items()),
    }


def images():
    made = hostile.seeds()
    made["a.png"] = hostile.png(20, 20)
    made["detached.mhd"] = b"ObjectType = Image\nNDims = 2\nDimSize = 8 8\nElementType = MET_UCHAR\nElementDataFile = a.raw\n"
    strip = bytes(range(256)) * 4
    entries = [(256, 3, 32), (257, 3, 32), (258, 3, 8), (259, 3, 1), (262, 3, 1), (273, 4, 8), (277, 3, 1), (278, 3, 32), (279, 4, len(strip))]
    tiff = b"II*\0" + struct.pack("<I", 8 + len(strip)) + strip + struct.pack("<H", len(entries))
    tiff += b"".join(struct.pack("<HHII", tag, kind, 1, value) for tag, kind, value in entries) + bytes(4)
    made["a.tif"] = tiff
    return made


def webceph():
    """The index of an archive of WebCeph with two pictures, one of which is no cephalogram."""
    marks = {"U1": {"x": 20.5, "y": 30.5}, "L1": {"x": 22.5, "y": 33.5}, "U6": {"x": 8.5, "y": 31.5}, "S": {"x": 4.5, "y": 4.5}}
    picture = {"name": "ceph.png", "type": "ceph_lateral", "flipX": False, "flipY": None,
               "tracing": {"mode": "assisted", "scaleFactor": None, "manualLandmarks": marks, "skippedSteps": {"N": True}}}
    return json.dumps({"version": 1, "refs": {"images": {}}, "data": {"image_1": picture, "image_2": {"name": "smile.jpg", "type": "photo_frontal", "tracing": {"manualLandmarks": {}}}}})


def archive(index, packing=zipfile.ZIP_DEFLATED):
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", packing) as written:
        # With a time of its own each archive would be another one.
        written.writestr(zipfile.ZipInfo("images/image_1"), bytes(range(256)))
        written.writestr(zipfile.ZipInfo("index.json"), index, packing)
    return content.getvalue()


def nested(before="", after="", depth=100000):
    """JSON of as many arrays in each other: what follows them by recursion ends with the stack."""
    return before + "[" * depth + "]" * depth + after


TRANSFORM = "#Insight Transform File V1.0\n#Transform 0\nTransform: VersorRigid3DTransform_double_3_3\nParameters: 0 0 0 1 2 3\nFixedParameters: 0 0 0\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", default=str(ROOT / "build" / "test" / "bin" / "dentalscr"))
    options = parser.parse_args()
    drawn = {"contours": json.loads(contours()["own.json"]), "landmarks": {"U1_tip": [20, 30], "L1_tip": {"position": [22, 33], "sigma_px": 2}}}
    init = {"similarity": {"scale": 1.02, "rotation_rad": 0.1, "translation_px": [3, -4]}, "lower": {"similarity": {"translation_px": [1, 2]}},
            "pose": [[1, 0, 0, 5], [0, 1, 0, -3], [0, 0, 1, 2]]}
    row = {"case": "a", "folder": "a", "columns": {"age": "12"}, "jaw": "upper", "status": "ok", "findings": ["spacing"], "matched_px": 0.9,
           "expected_error_px": None, "message": "", "seconds": 0.5}
    seeds = {
        "archive": {"index.json": webceph()},
        "drawing": {name: contours()[name] for name in ("own.json", "labelme.json", "cvat.xml", "table.csv")} | {"landmarks.json": json.dumps(drawn["landmarks"])},
        "session": {"both.json": json.dumps(drawn), "tracing.json": json.dumps({"contours": drawn["contours"], "landmarks": None})},
        "start": {"init.json": json.dumps(init), "rotation.json": json.dumps({"upper": init["lower"]})},
        "summary": {"summary.json": json.dumps({"schema": "dentalscr-batch/1", "rows": [row, dict(row, jaw="lower"), dict(row, case="b", jaw="", status="unusable")]})},
        "folder": {"upper.stl": scans()["binary.stl"], "tracing.json": contours()["own.json"], "labelme.json": contours()["labelme.json"],
                   "marks.json": landmarks(2)["own.json"], "marks.csv": landmarks(3)["table.csv"], "ceph.png": hostile.png(20, 20), "a.wceph": archive(webceph())},
        "scan": scans(),
        "contours": contours(),
        "landmarks2d": landmarks(2),
        "landmarks3d": landmarks(3),
        "cephalometric": landmarks(2) | {"packed.wceph": archive(webceph()), "stored.wceph": archive(webceph(), zipfile.ZIP_STORED)},
        "image": images(),
        "labelmap": images(),
        "mask": images(),
        "toothlabels": {"own.json": json.dumps({"jaw": "upper", "labels": [11, 11, 12, 12, 0, 0, 21, 21, 0, 0, 0, 0]}), "a.vtk": scans()["a.vtk"]},
        "batch": {
            "cases.csv": "id;case;age\nfirst;a.json;12\nsecond;b.json;-1\n",
            "options.csv": 'id,upper,lower,contours,spacing\na,"u.stl",l.stl,c.json,0.1 0.1\n',
        },
        "transform": {"a.tfm": TRANSFORM, "b.txt": TRANSFORM.replace("VersorRigid3DTransform_double_3_3\nParameters: 0 0 0 1 2 3\nFixedParameters: 0 0 0", "Similarity2DTransform_double_2_2\nParameters: 1 0 2 3\nFixedParameters: 0 0")},
    }
    case = options.folder / "case"
    result = case / "result"
    options.folder.mkdir(parents=True, exist_ok=True)
    if not (case / "case.json").exists():
        subprocess.run([options.program, "phantom", "--triangles", "3000", "--no-radiograph", "--seed", "3", "--output", str(case), "--quiet"], check=True)
    if not (result / "report.json").exists():
        subprocess.run([options.program, "register", str(case / "case.json"), "--output", str(result), "--quiet"])
    # With whole paths: mutants lie elsewhere, and without its files a case isn't read far.
    content = json.loads((case / "case.json").read_text())
    for field in ("upper", "lower", "contours", "landmarks_3d", "landmarks_2d", "cephalometric_landmarks"):
        if field in content:
            content[field] = str((case / content[field]).resolve())
    content.get("cephalogram", {}).pop("image", None)
    seeds["case"] = {"case.json": json.dumps(content)}
    level = subprocess.run([options.program, "phantom", "--show-parameters"], check=True, capture_output=True, text=True).stdout
    seeds["level"] = {"whole.json": level, "short.json": '{"level": "hard"}'}
    if not (result / "report.json").exists():
        sys.exit(f"{options.program} has made no result of {case}")
    seeds["result"] = {"result.json": (result / "result.json").read_bytes()}
    seeds["start"]["result.json"] = seeds["result"]["result.json"]
    lines = [json.dumps(json.loads((result / name).read_text())) for name in ("result.json", "report.json")]
    seeds["report"] = {"lines.txt": "\n".join(lines)}
    corpus = {target: {} for target in seeds}
    for name, (file_name, make) in hostile.HOSTILE.items():
        plain = "".join(letter if letter.isalnum() else "-" for letter in name)
        if "gigabytes" in name or "larger than it says" in name:
            try:
                from PIL import Image  # noqa: F401  (JPEG 2000 is made by it)
            except ImportError:
                continue
        for target in ("image", "labelmap", "mask"):
            corpus[target][plain + pathlib.Path(file_name).suffix] = make()
    # A row that names nothing, with the id of another one: its last argument was asked for.
    corpus["batch"]["row.csv"] = "id,upper\na,u.stl\na,\n"
    # A column's name that ends where its unit should begin; transforms that ITK's reader ran past the end of.
    corpus["contours"]["header.csv"] = "label,x [[,y\nUR1,1,2\n"
    corpus["transform"]["no-colon.tfm"] = TRANSFORM.replace("Parameters: 0", "Parameters 0")
    corpus["transform"]["type.tfm"] = TRANSFORM.replace("_double_", "_dou99ble_")
    corpus["transform"]["no-end.tfm"] = TRANSFORM.rstrip("\n")
    corpus["transform"]["few.tfm"] = TRANSFORM.replace("0 0 0 1 2 3", "0 0")
    corpus["transform"]["order.tfm"] = "#Insight Transform File V1.0\nParameters: 0 0\nFixedParameters: 0 0\n"
    # Of JSON that is nested deeper than a stack: five readers ended by it.
    for target in ("archive", "case", "cephalometric", "contours", "drawing", "landmarks2d", "landmarks3d", "level", "result", "start", "summary", "toothlabels"):
        corpus[target]["deep.json"] = nested('{"contours": {"upper": ', "}}")
        corpus[target]["deep-list.json"] = nested()
    corpus["drawing"]["deep-landmarks.json"] = nested('{"landmarks": {"U1_tip": ', "}}")
    for name in ("contours", "landmarks"):
        corpus["session"][f"deep-{name}.json"] = nested('{"%s": {"contours": ' % name, "}}")
    corpus["report"]["deep-result.txt"] = nested('{"schema": "dentalscr-result/1", "jaws": ', "}")
    corpus["report"]["deep-details.txt"] = seeds["report"]["lines.txt"].split("\n")[0] + "\n" + nested('{"schema": "dentalscr-report/1", "jaws": ', "}")
    for value in ("4e9", "-4e9", "1e300"):
        corpus["contours"][f"far-{value}.json"] = contours()["own.json"].replace("[40, 12]", f"[40, {value}]")
        corpus["landmarks2d"][f"far-{value}.json"] = landmarks(2)["own.json"].replace("11.0", value)
        corpus["landmarks3d"][f"far-{value}.json"] = landmarks(3)["own.json"].replace("11.0", value)
    for kind, targets in (("seeds", seeds), ("corpus", corpus)):
        for target, files in targets.items():
            folder = options.folder / kind / target
            folder.mkdir(parents=True, exist_ok=True)
            for name, content in files.items():
                (folder / name).write_bytes(content.encode() if isinstance(content, str) else content)
    print(sum(len(files) for files in seeds.values()), "seeds,", sum(len(files) for files in corpus.values()), "files that once failed, in", options.folder)


if __name__ == "__main__":
    main()

"""Files that are damaged or mistaken in one way each, of every format that is read, with what has to come of each: that it
is read, or the words of its error, which name what is wrong in it. test_damaged_files.py has them read."""
import json
import struct

import make_seeds as seeds
from dicom_file import dicom


def edit(content, *changes):
    """The content with each first piece replaced by what follows it, which has to be there."""
    pieces = iter(changes)
    for old, new in zip(pieces, pieces):
        is_bytes = isinstance(content, bytes)
        old, new = (part.encode("latin-1") if is_bytes and isinstance(part, str) else part for part in (old, new))
        assert old in content, old
        content = content.replace(old, new, 1)
    return content


def put(data, at, kind, *values):
    """The bytes with numbers of a struct's kind from a place on."""
    new = struct.pack(kind, *values)
    return data[:at] + new + data[at + len(new) :]


def cut(data, share):
    return data[: int(len(data) * share)]


SCANS = seeds.scans()
CONTOURS = seeds.contours()
POINTS2 = seeds.landmarks(2)
POINTS3 = seeds.landmarks(3)
IMAGES = seeds.images()
READ = None
NAN, INFINITY = float("nan"), float("inf")


def scans():
    stl, text = SCANS["binary.stl"], SCANS["text.stl"]
    yield "cut in a facet", "a.stl", cut(stl, 0.7), "x"
    yield "its count of facets is too large", "a.stl", put(stl, 80, "<I", 13), "x"
    yield "its count of facets is 2^32 - 1", "a.stl", put(stl, 80, "<I", 2**32 - 1), "x"
    yield "its count of facets is too small", "a.stl", put(stl, 80, "<I", 11), "x"
    yield "it has no facet", "a.stl", put(stl, 80, "<I", 0)[:84], "x"
    yield "a header alone", "a.stl", stl[:80], "x"
    yield "a corner is not a number", "a.stl", put(stl, 96, "<f", NAN), "x"
    yield "a corner is infinite", "a.stl", put(stl, 100, "<f", -INFINITY), "x"
    yield "a corner is 1e38", "a.stl", put(stl, 100, "<f", 1e38), "x"
    yield "all corners are one", "a.stl", stl[:84] + bytes(50 * 12), "x"
    yield "a facet's normal is not a number", "a.stl", put(stl, 84, "<f", NAN), READ
    yield "a facet's attribute is any", "a.stl", put(stl, 132, "<H", 65535), READ
    yield "its header says solid", "a.stl", b"solid made by a scanner".ljust(80) + stl[80:], READ
    yield "bytes follow it", "a.stl", stl + b"\n\n", "x"
    yield "text: a number is a word", "a.stl", edit(text, "vertex 0 0 9", "vertex 0 zero 9"), "x"
    yield "text: a number is not one", "a.stl", edit(text, "vertex 0 0 9", "vertex 0 nan 9"), "x"
    yield "text: a number has a comma", "a.stl", edit(text, "vertex 0 0 9", "vertex 0,5 0 9"), "x"
    yield "text: a corner has two numbers", "a.stl", edit(text, "vertex 0 0 9\n", "vertex 0 9\n"), "x"
    yield "text: a facet has two corners", "a.stl", edit(text, "vertex 0 0 9\n", ""), "x"
    yield "text: cut in a facet", "a.stl", cut(text, 0.5), "x"
    yield "text: it has no facet", "a.stl", "solid cube\nendsolid cube\n", "x"
    yield "text: lines end as on Windows", "a.stl", text.replace("\n", "\r\n"), READ
    yield "text: words are in capitals", "a.stl", text.upper(), READ

    ply, binary = SCANS["text.ply"], SCANS["binary.ply"]
    yield "no end of its header", "a.ply", edit(ply, "end_header\n", ""), "x"
    yield "its format is none", "a.ply", edit(ply, "format ascii 1.0", "format utf8 1.0"), "x"
    yield "its format is missing", "a.ply", edit(ply, "format ascii 1.0\n", ""), "x"
    yield "a count is negative", "a.ply", edit(ply, "element vertex 8", "element vertex -8"), "x"
    yield "a count is a word", "a.ply", edit(ply, "element vertex 8", "element vertex many"), "x"
    yield "a count is beyond all memory", "a.ply", edit(ply, "element vertex 8", "element vertex 99999999999"), "x"
    yield "a count of faces is beyond all memory", "a.ply", edit(binary, "element face 12", "element face 4000000000"), "x"
    yield "a type is none", "a.ply", edit(ply, "property float x", "property quaternion x"), "x"
    yield "a coordinate is missing", "a.ply", edit(ply, "property float z\n", ""), "x"
    yield "no vertices", "a.ply", edit(ply, "element vertex 8", "element corner 8"), "x"
    yield "no faces", "a.ply", edit(ply, "element face 12", "element edge 12"), "x"
    yield "an index is too large", "a.ply", edit(ply, "3 0 1 3\n", "3 0 1 8\n"), "x"
    yield "an index is negative", "a.ply", edit(ply, "3 0 1 3\n", "3 0 1 -1\n"), "x"
    yield "a face has one corner", "a.ply", edit(ply, "3 0 1 3\n", "1 0\n"), "x"
    yield "a coordinate is not a number", "a.ply", edit(ply, "0 0 9\n", "0 nan 9\n"), "x"
    yield "a coordinate is a word", "a.ply", edit(ply, "0 0 9\n", "0 oops 9\n"), "x"
    yield "cut in its faces", "a.ply", cut(ply, 0.9), "x"
    yield "cut in its points", "a.ply", binary[: binary.index(b"end_header\n") + 40], "x"
    yield "binary: cut in its faces", "a.ply", binary[:-5], "x"
    yield "binary: a face of 255 corners", "a.ply", put(binary, binary.index(b"end_header\n") + 11 + 96, "<B", 255), "x"
    yield "binary: an index is too large", "a.ply", put(binary, len(binary) - 4, "<i", 8), "x"
    yield "binary: a coordinate is infinite", "a.ply", put(binary, binary.index(b"end_header\n") + 11, "<f", INFINITY), "x"
    yield "its first word is another one", "a.ply", SCANS["other-word.ply"], "x"
    yield "comments in its header", "a.ply", SCANS["comment.ply"], READ
    yield "more properties", "a.ply", SCANS["colours.ply"], READ
    yield "lines end as on Windows", "a.ply", ply.replace("\n", "\r\n"), READ

    obj = SCANS["a.obj"]
    yield "an index is too large", "a.obj", edit(obj, "f 1 2 4", "f 1 2 9"), "x"
    yield "an index is 0", "a.obj", edit(obj, "f 1 2 4", "f 0 2 4"), "x"
    yield "an index is a word", "a.obj", edit(obj, "f 1 2 4", "f one 2 4"), "x"
    yield "an index is beyond 64 bits", "a.obj", edit(obj, "f 1 2 4", "f 1 2 99999999999999999999"), "x"
    yield "indices from behind", "a.obj", edit(obj, "f 1 2 4", "f -8 -7 -5"), READ
    yield "an index from before the first", "a.obj", edit(obj, "f 1 2 4", "f -9 -7 -5"), "x"
    yield "a face has two corners", "a.obj", edit(obj, "f 1 2 4", "f 1 2"), "x"
    yield "corners with textures and normals", "a.obj", edit(obj, "f 1 2 4", "vt 0 0\nvn 0 0 1\nf 1/1/1 2//1 4/1"), READ
    yield "a coordinate is a word", "a.obj", edit(obj, "v 0 0 9", "v 0 x 9"), "x"
    yield "a coordinate is not a number", "a.obj", edit(obj, "v 0 0 9", "v 0 nan 9"), "x"
    yield "two coordinates", "a.obj", edit(obj, "v 0 0 9", "v 0 9"), "x"
    yield "no faces", "a.obj", obj[: obj.index("f ")], "x"
    yield "no points", "a.obj", obj[obj.index("f ") :], "x"
    yield "a number as large as a galaxy", "a.obj", edit(obj, "v 0 0 9", "v 0 1e39 9"), "x"

    off = SCANS["a.off"]
    yield "its word is missing", "a.off", edit(off, "OFF\n", ""), "x"
    yield "its counts are missing", "a.off", edit(off, "8 12 0\n", ""), "x"
    yield "a count is negative", "a.off", edit(off, "8 12 0", "-8 12 0"), "x"
    yield "a count is beyond all memory", "a.off", edit(off, "8 12 0", "8 9999999999 0"), "x"
    yield "an index is too large", "a.off", edit(off, "3 0 1 3\n", "3 0 1 8\n"), "x"
    yield "an index is negative", "a.off", edit(off, "3 0 1 3\n", "3 0 1 -3\n"), "x"
    yield "a face has two corners", "a.off", edit(off, "3 0 1 3\n", "2 0 1\n"), "x"
    yield "a coordinate is a word", "a.off", edit(off, "0 0 9\n", "0 nine 9\n"), "x"
    yield "a line of faces is missing", "a.off", off[: off.rindex("3 ")], "x"
    yield "comments", "a.off", edit(off, "8 12 0", "# by hand\n8 12 0"), READ

    vtk = SCANS["a.vtk"]
    yield "its first line is another", "a.vtk", edit(vtk, "# vtk DataFile", "# itk DataFile"), "x"
    yield "an encoding that is none", "a.vtk", edit(vtk, "ASCII", "UNICODE"), "x"
    yield "a grid", "a.vtk", edit(vtk, "DATASET POLYDATA", "DATASET STRUCTURED_GRID"), "x"
    yield "a count of points is a word", "a.vtk", edit(vtk, "POINTS 8", "POINTS eight"), "x"
    yield "a count of points is negative", "a.vtk", edit(vtk, "POINTS 8", "POINTS -8"), "x"
    yield "a count of points is beyond all memory", "a.vtk", edit(vtk, "POINTS 8", "POINTS 88888888888"), "x"
    yield "a type that is none", "a.vtk", edit(vtk, "POINTS 8 float", "POINTS 8 real"), "x"
    yield "a point is not a number", "a.vtk", edit(vtk, "0 0 9\n", "0 nan 9\n"), "x"
    yield "a point is a word", "a.vtk", edit(vtk, "0 0 9\n", "0 nix 9\n"), "x"
    yield "an index is too large", "a.vtk", edit(vtk, "3 0 1 3\n", "3 0 1 8\n"), "x"
    yield "an index is negative", "a.vtk", edit(vtk, "3 0 1 3\n", "3 0 1 -1\n"), "x"
    yield "an index is broken", "a.vtk", edit(vtk, "3 0 1 3\n", "3 0 1.5 3\n"), "x"
    yield "cells are longer than they say", "a.vtk", edit(vtk, "POLYGONS 12 48", "POLYGONS 12 40"), "x"
    yield "cells are fewer than they say", "a.vtk", edit(vtk, "POLYGONS 12 48", "POLYGONS 13 52"), "x"
    yield "labels are fewer than points", "a.vtk", edit(vtk, "POINT_DATA 8", "POINT_DATA 9"), "x"
    yield "cut in its points", "a.vtk", cut(vtk, 0.3), "x"
    yield "no polygons", "a.vtk", vtk[: vtk.index("POLYGONS")], "x"
    yield "binary, as it says, with text", "a.vtk", edit(vtk, "ASCII", "BINARY"), "x"

    vtp, packed, raw = SCANS["ascii.vtp"], SCANS["zlib.vtp"], SCANS["raw.vtp"]
    yield "a tag is not closed", "a.vtp", edit(vtp, "</Points>", ""), "x"
    yield "cut in its points", "a.vtp", cut(vtp, 0.4), "x"
    yield "a kind of data that is no surface", "a.vtp", edit(vtp, 'type="PolyData"', 'type="ImageData"'), "x"
    yield "an order of bytes that is none", "a.vtp", edit(packed, "LittleEndian", "MiddleEndian"), "x"
    yield "a compressor that is not known", "a.vtp", edit(packed, "vtkZLibDataCompressor", "vtkLZMADataCompressor"), "x"
    yield "a format that is none", "a.vtp", edit(vtp, 'format="ascii"', 'format="verse"'), "x"
    yield "a type that is none", "a.vtp", edit(vtp, 'type="Float32"', 'type="Float24"'), "x"
    yield "points are fewer than it says", "a.vtp", edit(vtp, 'NumberOfPoints="8"', 'NumberOfPoints="9"'), "x"
    yield "points are beyond all memory", "a.vtp", edit(vtp, 'NumberOfPoints="8"', 'NumberOfPoints="999999999999"'), "x"
    yield "points are a word", "a.vtp", edit(vtp, 'NumberOfPoints="8"', 'NumberOfPoints="eight"'), "x"
    yield "faces are more than it says", "a.vtp", edit(vtp, 'NumberOfPolys="12"', 'NumberOfPolys="11"'), "x"
    yield "two numbers a point", "a.vtp", edit(vtp, 'NumberOfComponents="3"', 'NumberOfComponents="2"'), "x"
    yield "an index is too large", "a.vtp", edit(vtp, ">0 1 3 ", ">0 1 8 "), "x"
    yield "an index is negative", "a.vtp", edit(vtp, ">0 1 3 ", ">0 1 -3 "), "x"
    yield "ends go back", "a.vtp", edit(vtp, ">3 6 9 ", ">3 9 6 "), "x"
    yield "base64 has other letters", "a.vtp", edit(packed, "AQAAAGAAAAA", "AQ*AAGAAAAA"), "x"
    yield "a packed block is damaged", "a.vtp", edit(packed, "eJx", "eJz"), "x"
    yield "a packed block is longer than it says", "a.vtp", edit(packed, "AQAAAGAAAAA", "AQAAAFAAAAA"), "x"
    yield "an entity that bursts", "a.vtp", '<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;">]>' + edit(vtp, '<?xml version="1.0"?>', "", ">0 1 3", ">&b;"), "x"
    yield "raw: an offset behind the end", "a.vtp", edit(raw, 'offset="0"', 'offset="99999"'), "x"
    yield "raw: a negative offset", "a.vtp", edit(raw, 'offset="0"', 'offset="-1"'), "x"
    yield "raw: a length that is another", "a.vtp", edit(raw, b"_" + struct.pack("<I", 96), b"_" + struct.pack("<I", 92)), "x"
    yield "raw: a length behind the end", "a.vtp", edit(raw, b"_" + struct.pack("<I", 96), b"_" + struct.pack("<I", 2**31)), "x"
    yield "raw: its data are missing", "a.vtp", raw[: raw.index(b"<AppendedData")] + b"</VTKFile>", "x"
    yield "raw: an encoding that is none", "a.vtp", edit(raw, 'encoding="raw"', 'encoding="cooked"'), "x"
    yield "an extension that no reader has", "a.xyz", "1 2 3\n", "x"
    yield "a ZIP archive with a scan's name", "a.stl", b"PK\x03\x04" + stl, "x"
    yield "a web page with a scan's name", "a.ply", "<!DOCTYPE html><html></html>", "x"
    yield "an empty file", "a.obj", "", "x"


def contours():
    own = CONTOURS["own.json"]
    yield "a comma is missing", "a.json", edit(own, '"closed": true, ', '"closed": true '), "x"
    yield "cut", "a.json", cut(own, 0.6), "x"
    yield "bytes that are no UTF-8", "a.json", edit(own.encode(), "UR1", b"UR\xff"), "x"
    yield "a number that is none", "a.json", edit(own, "[40, 12]", "[40, NaN]"), "x"
    yield "a number that overflows", "a.json", edit(own, "[40, 12]", "[40, 1e999]"), "x"
    yield "a field twice", "a.json", edit(own, '"closed": true', '"closed": true, "closed": false'), "x"
    yield "no contours", "a.json", '{"image_size": [50, 50]}', "x"
    yield "contours are a list", "a.json", '{"image_size": [50, 50], "contours": []}', "x"
    yield "nothing in them", "a.json", '{"image_size": [50, 50], "contours": {}}', "x"
    yield "an image of two sizes", "a.json", edit(own, "[50, 50]", "[50, 50, 50]"), "x"
    yield "an image of no size", "a.json", edit(own, "[50, 50]", "[50, 0]"), "x"
    yield "an image of half a pixel", "a.json", edit(own, "[50, 50]", "[50, 49.5]"), "x"
    yield "an image of 2^40 pixels", "a.json", edit(own, "[50, 50]", "[1048576, 1048576]"), "x"
    yield "no image's size", "a.json", edit(own, '"image_size": [50, 50], ', ""), "x"
    yield "a code of the other jaw", "a.json", edit(own, "UR1", "LR1"), "x"
    yield "a code that is none", "a.json", edit(own, "UR1", "UR9"), "x"
    yield "a code that FDI has not", "a.json", edit(own, '"UR1"', "19"), "x"
    yield "a code that is a list", "a.json", edit(own, '"UR1"', '["UR1"]'), "x"
    yield "a code that is not known", "a.json", edit(own, '"UR1"', "null"), READ
    yield "a point of one number", "a.json", edit(own, "[40, 12]", "[40]"), "x"
    yield "a point of three numbers", "a.json", edit(own, "[40, 12]", "[40, 12, 0]"), "x"
    yield "a point of words", "a.json", edit(own, "[40, 12]", '["40", "12"]'), "x"
    yield "a point is null", "a.json", edit(own, "[40, 12]", "null"), "x"
    yield "points are an object", "a.json", edit(own, str(seeds.LINE), "{}"), "x"
    yield "points are missing", "a.json", edit(own, ', "points": ' + str(seeds.LINE), ""), "x"
    yield "most points outside", "a.json", edit(own, "[40, 12]", "[400, 12]", "[38, 44]", "[380, 44]"), "x"
    yield "closed is a word", "a.json", edit(own, '"closed": true', '"closed": "yes"'), "x"
    yield "closed with two points", "a.json", edit(own, str(seeds.LINE), "[[10, 10], [40, 12]]"), "x"
    yield "closed with three times the same point", "a.json", edit(own, str(seeds.LINE), "[[10, 10], [10, 10], [10, 10]]"), "x"
    yield "a sigma of 0", "a.json", edit(own, '"sigma_px": 1.5', '"sigma_px": 0'), "x"
    yield "a negative sigma", "a.json", edit(own, '"sigma_px": 1.5', '"sigma_px": -1.5'), "x"
    yield "fewer sigmas than points", "a.json", edit(own, '"sigma_px": 1.5', '"sigma_px": [1, 2]'), "x"
    yield "a sigma that is a word", "a.json", edit(own, '"sigma_px": 1.5', '"sigma_px": "small"'), "x"
    yield "fewer weights than points", "a.json", edit(own, '"sigma_px": 1.5', '"weights": [1, 1]'), "x"
    yield "a weight above 1", "a.json", edit(own, '"sigma_px": 1.5', '"weights": [1, 1, 1, 2]'), "x"
    yield "a negative weight", "a.json", edit(own, '"sigma_px": 1.5', '"weights": [1, 1, 1, -0.1]'), "x"
    yield "an outline that is none", "a.json", edit(own, '"closed": true', '"outline": "gum"'), "x"
    yield "a numbering that is none", "a.json", edit(own, '{"image_size"', '{"numbering": "palmer", "image_size"'), "x"
    yield "deeper than anybody writes", "a.json", "[" * 1000 + "]" * 1000, "x"
    yield "a number alone", "a.json", "17", "x"
    yield "a byte order mark before it", "a.json", b"\xef\xbb\xbf" + own.encode(), READ
    yield "UTF-16", "a.json", own.encode("utf-16"), "x"
    labelme = CONTOURS["labelme.json"]
    yield "labelme: a label of no tooth", "a.json", edit(labelme, '"label": "11"', '"label": "chin"'), "x"
    yield "labelme: a code that is none", "a.json", edit(labelme, '"label": "11"', '"label": "19"'), "x"
    yield "labelme: a circle", "a.json", edit(labelme, '"polygon"', '"circle"'), "x"
    yield "labelme: no points", "a.json", edit(labelme, str(seeds.LINE), "[]"), "x"
    yield "labelme: points of words", "a.json", edit(labelme, "[40, 12]", '["a", "b"]'), "x"
    yield "labelme: a size of words", "a.json", edit(labelme, '"imageWidth": 50', '"imageWidth": "50"'), "x"
    coco = CONTOURS["coco.json"]
    yield "COCO: an odd number of coordinates", "a.json", edit(coco, "[10, 10, 40, 12", "[10, 40, 12"), "x"
    yield "COCO: a category that is none", "a.json", edit(coco, '"category_id": 1', '"category_id": 7'), "x"
    yield "COCO: an image that is none", "a.json", edit(coco, '"image_id": 1', '"image_id": 9'), "x"
    yield "COCO: runs longer than the image", "a.json", edit(coco, "[510, 30, 20, 30, 1910]", "[510, 30, 20, 30, 191000]"), "x"
    yield "COCO: a negative run", "a.json", edit(coco, "[510, 30, 20, 30, 1910]", "[510, -30, 20, 90, 1910]"), "x"
    yield "COCO: no categories", "a.json", edit(coco, '"categories": [{"id": 1, "name": "11"}], ', ""), "x"
    via = CONTOURS["via.json"]
    yield "VIA: more x than y", "a.json", edit(via, "[10, 40, 38, 12]", "[10, 40, 38]"), "x"
    yield "VIA: no shape", "a.json", edit(via, '"name": "polygon"', '"name": "ellipse"'), "x"
    yield "Supervisely: no exterior", "a.json", edit(CONTOURS["supervisely.json"], '"exterior": ' + str(seeds.LINE) + ", ", ""), "x"
    yield "Supervisely: a size of one number", "a.json", edit(CONTOURS["supervisely.json"], '{"height": 50, "width": 50}', '{"height": 50}'), "x"
    yield "Label Studio: a size of none", "a.json", edit(CONTOURS["labelstudio.json"], '"original_width": 50, ', ""), "x"
    yield "Label Studio: no result", "a.json", '[{"data": {"image": "a.png"}, "annotations": [{"result": []}]}]', "x"
    cvat = CONTOURS["cvat.xml"]
    yield "CVAT: a point of one number", "a.xml", edit(cvat, "40,12;", "40;"), "x"
    yield "CVAT: a point of words", "a.xml", edit(cvat, "40,12;", "a,b;"), "x"
    yield "CVAT: no width", "a.xml", edit(cvat, ' width="50"', ""), "x"
    yield "CVAT: a tag is not closed", "a.xml", edit(cvat, "</image>", ""), "x"
    yield "CVAT: runs that are too many", "a.xml", edit(cvat, "3, 4, 3", "3, 4, 3000"), "x"
    yield "CVAT: a mask outside", "a.xml", edit(cvat, 'left="2"', 'left="48"'), "x"
    yield "CVAT: cut", "a.xml", cut(cvat, 0.7), "x"
    table = CONTOURS["table.csv"]
    yield "CSV: a cell is a word", "a.csv", edit(table, "UR1,40,12", "UR1,forty,12"), "x"
    yield "CSV: a cell too many", "a.csv", edit(table, "UR1,40,12", "UR1,40,12,7"), "x"
    yield "CSV: a cell too few", "a.csv", edit(table, "UR1,40,12", "UR1,40"), "x"
    yield "CSV: no column y", "a.csv", edit(table, "label,x,y", "label,x,z"), "x"
    yield "CSV: a header alone", "a.csv", "label,x,y\n", "x"
    yield "CSV: a quote is not closed", "a.csv", edit(table, "UR1,40", '"UR1,40'), "x"
    yield "CSV: a coordinate is not a number", "a.csv", edit(table, "UR1,40,12", "UR1,nan,12"), "x"
    yield "CSV: a tooth that is none", "a.csv", table.replace("UR1", "UR9"), "x"


def landmarks(target, points, is_space):
    own = points["own.json"]
    first = '"UR1_tip": [' + ("0.0, 1.0, 2.0" if is_space else "0.0, 1.0") + "]"
    number = '"UR1_tip": '
    yield "a landmark of one number", "a.json", edit(own, first, number + "[1]"), "x"
    yield "a landmark of four numbers", "a.json", edit(own, first, number + "[1, 2, 3, 4]"), "x"
    yield "a landmark of words", "a.json", edit(own, first, number + '["a", "b", "c"]'), "x"
    yield "a landmark is null", "a.json", edit(own, first, number + "null"), "x"
    yield "a landmark overflows", "a.json", edit(own, first, number + ("[1e999, 0, 0]" if is_space else "[1e999, 0]")), "x"
    yield "a landmark is further than any", "a.json", edit(own, first, number + ("[3e7, 0, 0]" if is_space else "[3e7, 0]")), "x"
    yield "a landmark twice", "a.json", edit(own, "{", "{" + first + ", "), "x"
    yield "no landmark", "a.json", "{}", "x"
    yield "a list", "a.json", "[1, 2, 3]", "x"
    yield "cut", "a.json", cut(own, 0.5), "x"
    yield "names of no tooth alone", "a.json", '{"Sella": [' + ("1, 2, 3" if is_space else "1, 2") + "]}", "x"
    slicer = points["slicer.mrk.json"]
    yield "Slicer: a position of words", "a.mrk.json", edit(slicer, '"position": [0.0, 1.0, ', '"position": ["0", 1.0, '), "x"
    yield "Slicer: a position of two numbers", "a.mrk.json", edit(slicer, '"position": [0.0, 1.0, ', '"position": [1.0, '), "x"
    yield "Slicer: a frame that is none", "a.mrk.json", edit(slicer, '"LPS"', '"XYZ"'), "x"
    yield "Slicer: no points", "a.mrk.json", '{"markups": [{"type": "Fiducial", "coordinateSystem": "LPS", "controlPoints": []}]}', "x"
    table = points["table.csv"]
    yield "CSV: a cell is a word", "a.csv", edit(table, "UR1_tip,0.0", "UR1_tip,here"), "x"
    yield "CSV: a cell is missing", "a.csv", edit(table, "UR1_tip,0.0,1.0", "UR1_tip,0.0"), "x"
    yield "CSV: a column is missing", "a.csv", edit(table, "label,x,y", "label,x,w"), "x"


def cephalometric():
    yield from landmarks("cephalometric", POINTS2, False)
    yield "two names of one point", "a.json", '{"Is": [1, 2], "U1_tip": [1, 2]}', "x"
    yield "a sigma of 0", "a.json", '{"U1_tip": {"position": [1, 2], "sigma_px": 0}}', "x"
    yield "a confidence of 2", "a.json", '{"U1_tip": {"position": [1, 2], "confidence": 2}}', "x"
    yield "no position", "a.json", '{"U1_tip": {"sigma_px": 2}}', "x"
    yield "Aariz: no value", "a.json", '{"ceph_id": "a", "landmarks": [{"title": "t", "symbol": "UIT"}]}', "x"
    yield "Aariz: x is a word", "a.json", '{"ceph_id": "a", "landmarks": [{"title": "t", "symbol": "UIT", "value": {"x": "a", "y": 1}}]}', "x"
    yield "a detector: nothing was found", "a.json", '{"landmarks": [{"name": "U1_tip", "x": null, "y": null}]}', "x"
    yield "a detector: a confidence that is no word of its own", "a.json", '{"landmarks": [{"name": "U1_tip", "x": 1, "y": 2, "confidence": "huge"}]}', "x"
    isbi = "".join(f"{10 * k},{20 + k}\n" for k in range(1, 20)) + "1\n" * 8
    yield "ISBI: as it is", "a.txt", isbi, READ
    yield "ISBI: 18 lines", "a.txt", "".join(isbi.splitlines(True)[:18]), "x"
    yield "ISBI: a word", "a.txt", edit(isbi, "110,31", "110,x"), "x"
    head = "file,scale," + ",".join(f"p{k}{a}" for k in range(1, 39) for a in "xy")
    row = "a.bmp,0.1," + ",".join(str(10 + k) for k in range(76))
    yield "CL-Detection: as it is", "a.csv", head + "\n" + row + "\n", READ
    yield "CL-Detection: a cell too few", "a.csv", head + "\n" + row.rsplit(",", 1)[0] + "\n", "x"
    yield "CL-Detection: a word", "a.csv", head + "\n" + edit(row, ",30,", ",thirty,") + "\n", "x"


def images():
    png = IMAGES["a.png"]
    yield "PNG: cut in its pixels", "a.png", png[:-20], "x"
    yield "PNG: a checksum is another", "a.png", put(png, 29, ">I", 1), "x"
    yield "PNG: a width of 0", "a.png", put(png, 16, ">I", 0), "x"
    yield "PNG: a chunk beyond the end", "a.png", put(png, 33, ">I", 2**31 - 1), "x"
    yield "PNG: nothing but its signature", "a.png", png[:8], "x"
    yield "PNG: bytes follow it", "a.png", png + b"more", READ
    yield "PNG: sent as text", "a.png", png.replace(b"\r\n", b"\n"), "x"
    yield "JPEG: its beginning alone", "a.jpg", b"\xff\xd8\xff\xe0\x00\x10JFIF\x00\x01\x01\x00\x00\x01\x00\x01\x00\x00", "x"
    yield "JPEG: a segment beyond the end", "a.jpg", b"\xff\xd8\xff\xdb\xff\xff\x00", "x"
    yield "JPEG: an end without a picture", "a.jpg", b"\xff\xd8\xff\xd9", "x"
    bmp = IMAGES["b.bmp"]
    yield "BMP: cut in its pixels", "a.bmp", bmp[:-700], "x"
    yield "BMP: a width of 0", "a.bmp", put(bmp, 18, "<i", 0), "x"
    yield "BMP: a negative width", "a.bmp", put(bmp, 18, "<i", -32), "x"
    yield "BMP: 7 bits a pixel", "a.bmp", put(bmp, 28, "<H", 7), "x"
    yield "BMP: pixels behind the end", "a.bmp", put(bmp, 10, "<I", 10**9), "x"
    yield "BMP: a header of 3 bytes", "a.bmp", put(bmp, 14, "<I", 3), "x"
    tif = IMAGES["a.tif"]
    yield "TIFF: cut before its directory", "a.tif", tif[:-60], "x"
    yield "TIFF: a directory behind the end", "a.tif", put(tif, 4, "<I", 10**9), "x"
    yield "TIFF: a strip behind the end", "a.tif", edit(tif, struct.pack("<HHII", 273, 4, 1, 8), struct.pack("<HHII", 273, 4, 1, 10**6)), "x"
    yield "TIFF: a width of 0", "a.tif", edit(tif, struct.pack("<HHII", 256, 3, 1, 32), struct.pack("<HHII", 256, 3, 1, 0)), "x"
    yield "TIFF: 77 bits", "a.tif", edit(tif, struct.pack("<HHII", 258, 3, 1, 8), struct.pack("<HHII", 258, 3, 1, 77)), "x"
    yield "TIFF: a compression that is none", "a.tif", edit(tif, struct.pack("<HHII", 259, 3, 1, 1), struct.pack("<HHII", 259, 3, 1, 999)), "x"
    nrrd = IMAGES["a.nrrd"]
    yield "NRRD: cut in its pixels", "a.nrrd", nrrd[:-100], "x"
    yield "NRRD: a type that is none", "a.nrrd", edit(nrrd, "type: uint8", "type: uint9"), "x"
    yield "NRRD: a negative size", "a.nrrd", edit(nrrd, "sizes: 32 32", "sizes: 32 -32"), "x"
    yield "NRRD: one size of two", "a.nrrd", edit(nrrd, "sizes: 32 32", "sizes: 32"), "x"
    yield "NRRD: an encoding that is none", "a.nrrd", edit(nrrd, "encoding: raw", "encoding: rar"), "x"
    yield "NRRD: no dimension", "a.nrrd", edit(nrrd, "dimension: 2\n", ""), "x"
    yield "NRRD: 17 dimensions", "a.nrrd", edit(nrrd, "dimension: 2\nsizes: 32 32", "dimension: 17\nsizes:" + " 2" * 17), "x"
    mha = IMAGES["a.mha"]
    yield "MetaImage: cut in its pixels", "a.mha", mha[:-100], "x"
    yield "MetaImage: a type that is none", "a.mha", edit(mha, "MET_UCHAR", "MET_BYTES"), "x"
    yield "MetaImage: a size of 0", "a.mha", edit(mha, "DimSize = 32 32", "DimSize = 32 0"), "x"
    yield "MetaImage: a size of words", "a.mha", edit(mha, "DimSize = 32 32", "DimSize = a b"), "x"
    yield "MetaImage: no pixels are named", "a.mha", mha[: mha.index(b"ElementDataFile")], "x"
    yield "MetaImage: its pixels are missing", "a.mhd", IMAGES["detached.mhd"], "x"
    pixels = bytes(range(256)) * 4
    whole = dicom(32, 32, pixels)
    yield "DICOM: as it is", "a.dcm", whole, READ
    yield "DICOM: cut in its pixels", "a.dcm", whole[:-300], "x"
    yield "DICOM: cut in its header", "a.dcm", whole[:200], "x"
    yield "DICOM: its word is another", "a.dcm", edit(whole, "DICM", "DICN"), "x"
    yield "DICOM: more rows than pixels", "a.dcm", dicom(64, 32, pixels), "x"
    yield "DICOM: no rows", "a.dcm", dicom(0, 32, b""), "x"
    yield "DICOM: a transfer syntax that is none", "a.dcm", dicom(32, 32, pixels, b"1.2.840.10008.1.2.4.999"), "x"
    yield "DICOM: JPEG that is none", "a.dcm", dicom(32, 32, b"no picture", b"1.2.840.10008.1.2.4.50"), "x"
    yield "DICOM: JPEG 2000 that is none", "a.dcm", dicom(32, 32, b"no picture", b"1.2.840.10008.1.2.4.90"), "x"
    yield "no image at all", "a.png", b"this is no picture", "x"
    yield "an image of another format than its name", "a.jpg", png, READ


def labelmaps():
    yield "no label in it", "a.png", IMAGES["a.png"], "x"
    yield "cut", "a.png", IMAGES["a.png"][:-20], "x"
    yield "no image", "a.nrrd", "no image", "x"
    yield "labels that are no teeth", "a.mha", IMAGES["a.mha"], "x"


def masks():
    yield "nothing in it", "a.png", IMAGES["a.png"], "x"
    yield "cut", "a.mha", IMAGES["a.mha"][:-100], "x"
    yield "no image", "a.bmp", "BM", "x"


def toothlabels():
    own = json.dumps({"jaw": "upper", "labels": [11, 11, 12, 12, 0, 0, 21, 21, 0, 0, 0, 0]})
    yield "as they are", "a.json", own, READ
    yield "fewer than points", "a.json", edit(own, "[11, 11, ", "[11, "), "x"
    yield "more than points", "a.json", edit(own, "[11, 11, ", "[11, 11, 11, "), "x"
    yield "a label that is no tooth", "a.json", edit(own, "[11, ", "[19, "), "x"
    yield "a negative label", "a.json", edit(own, "[11, ", "[-11, "), "x"
    yield "half a label", "a.json", edit(own, "[11, ", "[11.5, "), "x"
    yield "a label is a word", "a.json", edit(own, "[11, ", '["tooth", '), "x"
    yield "no labels", "a.json", '{"jaw": "upper"}', "x"
    yield "labels are an object", "a.json", '{"labels": {}}', "x"
    yield "a jaw that is none", "a.json", edit(own, '"upper"', '"middle"'), "x"
    yield "cut", "a.json", cut(own, 0.5), "x"
    yield "of a scan of other points", "a.vtk", SCANS["a.vtk"], "x"
    yield "a scan without labels", "a.vtk", SCANS["a.vtk"][: SCANS["a.vtk"].index("POINT_DATA")], "x"
    yield "a scan without labels as PLY", "a.ply", SCANS["text.ply"], "x"


def transforms():
    whole = seeds.TRANSFORM
    yield "as it is", "a.tfm", whole, READ
    yield "its first line is missing", "a.tfm", edit(whole, "#Insight Transform File V1.0\n", ""), "x"
    yield "a type that is none", "a.tfm", edit(whole, "VersorRigid3DTransform", "FlexibleTransform"), "x"
    yield "no type", "a.tfm", edit(whole, "Transform: VersorRigid3DTransform_double_3_3\n", ""), "x"
    yield "numbers of single precision", "a.tfm", edit(whole, "_double_", "_float_"), "x"
    yield "a parameter too few", "a.tfm", edit(whole, "0 0 0 1 2 3", "0 0 0 1 2"), "x"
    yield "a parameter too many", "a.tfm", edit(whole, "0 0 0 1 2 3", "0 0 0 1 2 3 4"), "x"
    yield "a parameter is a word", "a.tfm", edit(whole, "0 0 0 1 2 3", "0 0 zero 1 2 3"), "x"
    yield "a parameter is not a number", "a.tfm", edit(whole, "0 0 0 1 2 3", "0 0 nan 1 2 3"), "x"
    yield "no parameters", "a.tfm", edit(whole, "Parameters: 0 0 0 1 2 3\n", ""), "x"
    yield "no fixed parameters", "a.tfm", edit(whole, "FixedParameters: 0 0 0\n", ""), "x"
    yield "cut", "a.tfm", cut(whole, 0.7), "x"
    yield "empty", "a.tfm", "", "x"
    yield "no text", "a.tfm", bytes(range(256)), "x"


def cases(folder):
    """folder: of a case, whose files are there."""
    names = {field: str(folder / file) for field, file in (("upper", "upper.stl"), ("lower", "lower.stl"), ("contours", "contours.json"))}
    whole = json.dumps({**names, "cephalogram": {"image_size": [700, 900], "pixel_spacing_mm": [0.25, 0.25]},
                        "geometry": {"source_to_midsagittal_mm": 1524, "source_to_detector_mm": 1674}})

    def more(text):
        return edit(whole, '{"upper"', "{" + text + ', "upper"')

    yield "no case", "case.json", "{}", "x"
    yield "no scan", "case.json", edit(whole, json.dumps({k: names[k] for k in ("upper", "lower")})[1:-1] + ", ", ""), "x"
    yield "no tracing", "case.json", edit(whole, json.dumps({"contours": names["contours"]})[1:-1] + ", ", ""), "x"
    yield "a scan is a number", "case.json", edit(whole, json.dumps(names["upper"]), "3"), "x"
    yield "as it is", "case.json", whole, READ
    yield "a scan is not there", "case.json", edit(whole, "upper.stl", "upper.slt"), "x"
    yield "a scan is a folder", "case.json", edit(whole, names["upper"], str(folder)), "x"
    yield "a list", "case.json", "[" + whole + "]", "x"
    yield "cut", "case.json", cut(whole, 0.5), "x"
    yield "a spacing of 0", "case.json", edit(whole, "[0.25, 0.25]", "[0, 0.25]"), "x"
    yield "a negative spacing", "case.json", edit(whole, "[0.25, 0.25]", "[0.25, -0.25]"), "x"
    yield "one spacing", "case.json", edit(whole, "[0.25, 0.25]", "0.25"), "x"
    yield "a spacing of metres", "case.json", edit(whole, "[0.25, 0.25]", "[250, 250]"), "x"
    yield "a detector before the patient", "case.json", edit(whole, "1674", "1000"), "x"
    yield "a negative distance", "case.json", edit(whole, "1524", "-1524"), "x"
    yield "a distance of words", "case.json", edit(whole, "1524", '"1524 mm"'), "x"
    yield "a unit that is none", "case.json", more('"mesh_unit": "foot"'), "x"
    yield "a side that is none", "case.json", more('"traced_side": "top"'), "x"
    yield "a numbering that is none", "case.json", more('"numbering": "palmer"'), "x"
    yield "an occlusion that is none", "case.json", more('"occlusion": "maybe"'), "x"
    yield "a tooth to leave out that is none", "case.json", more('"exclude": ["UR9"]'), "x"
    yield "something to hold that is none", "case.json", more('"fix": ["everything"]'), "x"
    yield "crowns that are none", "case.json", more('"crowns": "most"'), "x"
    yield "a start that is no rotation", "case.json", more('"init": {"pose": [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0]]}'), "x"
    yield "a start of two rows", "case.json", more('"init": {"pose": [[1, 0, 0, 0], [0, 1, 0, 0]]}'), "x"
    yield "a start with a negative scale", "case.json", more('"init": {"similarity": {"scale": -1, "translation_px": [0, 0]}}'), "x"
    yield "views that are an object", "case.json", more('"views": {}'), "x"
    yield "a view without a direction", "case.json", more('"views": [{"name": "a", "contours": "c.json"}]'), "x"
    yield "a view with a direction that is none", "case.json", more('"views": [{"direction": "oblique", "contours": "c.json"}]'), "x"
    yield "a view with the name of a path", "case.json", more('"views": [{"name": "../x", "direction": "frontal", "contours": "c.json"}]'), "x"
    yield "a view with nothing drawn", "case.json", more('"views": [{"direction": "frontal", "cephalogram": {"image_size": [9, 9]}}]'), "x"
    yield "an image's size that is none", "case.json", edit(whole, "[700, 900]", "[700, -900]"), "x"
    yield "facing up", "case.json", edit(whole, '"image_size"', '"facing": "up", "image_size"'), "x"
    yield "a source in front", "case.json", edit(whole, '"source_to_detector_mm"', '"source_side": "front", "source_to_detector_mm"'), "x"
    yield "a principal point of words", "case.json", edit(whole, '"source_to_detector_mm"', '"principal_point_px": ["a", 2], "source_to_detector_mm"'), "x"


def results(whole):
    """whole: what the program has written."""
    root = json.loads(whole)

    def changed(function):
        copy = json.loads(whole)
        function(copy)
        return json.dumps(copy)

    def matrix(value):
        def change(copy):
            copy["jaws"]["upper"]["projection_3x4"] = value
        return change

    yield "as it is", "result.json", whole, READ
    yield "cut", "result.json", cut(whole, 0.5), "x"
    yield "another schema", "result.json", whole.replace('"dentalscr-result/1"', '"dentalscr-result/9"', 1), "x"
    yield "no schema", "result.json", changed(lambda copy: copy.pop("schema")), "x"
    yield "no jaws", "result.json", changed(lambda copy: copy.pop("jaws")), "x"
    yield "jaws are a list", "result.json", changed(lambda copy: copy.update(jaws=[])), "x"
    yield "a status that is none", "result.json", changed(lambda copy: copy["jaws"]["upper"].update(status="splendid")), "x"
    yield "no matrix", "result.json", changed(lambda copy: copy["jaws"]["upper"].pop("projection_3x4")), "x"
    yield "a matrix of two rows", "result.json", changed(matrix(root["jaws"]["upper"]["projection_3x4"][:2])), "x"
    yield "a matrix of words", "result.json", changed(matrix([["a"] * 4] * 3)), "x"
    yield "a matrix of nulls", "result.json", changed(matrix([[None] * 4] * 3)), "x"
    yield "a number alone", "result.json", "1", "x"
    yield "another file of the toolkit", "result.json", CONTOURS["own.json"], "x"


def batches():
    yield "empty", "a.csv", "", "x"
    yield "a header alone", "a.csv", "id,case\n", "x"
    yield "no column of a case", "a.csv", "name,age\na,1\n", "x"
    yield "a cell too many", "a.csv", "id,case\na,b.json,c\n", "x"
    yield "a case without a file", "a.csv", "id,case\na,\n", "x"
    yield "a name twice", "a.csv", "id,case\na,b.json\na,c.json\n", "x"
    yield "a name that is a path", "a.csv", "id,case\n../a,b.json\n", "x"
    yield "a name that is a folder's own", "a.csv", "id,case\n..,b.json\n", "x"
    yield "a name of 300 letters", "a.csv", "id,case\n" + "a" * 300 + ",b.json\n", "x"
    yield "a column twice", "a.csv", "case,case\na.json,b.json\n", "x"
    yield "a quote is not closed", "a.csv", 'id,case\n"a,b.json\n', "x"
    yield "bytes of no text", "a.csv", bytes(range(256)), "x"
    yield "no names", "a.csv", "case\na.json\nb.json\n", READ
    yield "lines end as on Windows", "a.csv", "id;case\r\na;b.json\r\n", READ


def damaged(result, folder):
    """result: text of a result.json; folder: of a whole case. \\return of each reader its files: (what is wrong, name of the file, content, words of the error or READ)."""
    return {
        "batch": list(batches()),
        "case": list(cases(folder)),
        "cephalometric": list(cephalometric()),
        "contours": list(contours()),
        "image": list(images()),
        "labelmap": list(labelmaps()),
        "landmarks2d": list(landmarks("landmarks2d", POINTS2, False)),
        "landmarks3d": list(landmarks("landmarks3d", POINTS3, True)),
        "mask": list(masks()),
        "result": list(results(result)),
        "scan": list(scans()),
        "toothlabels": list(toothlabels()),
        "transform": list(transforms()),
    }

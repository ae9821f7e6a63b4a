"""Files that are damaged or mistaken in one way each, of every format that is read, with what has to come of each: that it
is read, or the words of its error, which name what is wrong in it. test_damage.py has them read."""
import gzip
import json
import struct
import zipfile

import make_seeds as seeds
from dicom_file import dicom
from nifti_file import nifti


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
    yield "cut in a facet", "a.stl", cut(stl, 0.7), ("is truncated: 12 facets need 684 bytes, the file has 478",)
    yield "its count of facets is too large", "a.stl", put(stl, 80, "<I", 13), ("is truncated: 13 facets need 734 bytes, the file has 684",)
    yield "its count of facets is 2^32 - 1", "a.stl", put(stl, 80, "<I", 2**32 - 1), ("is truncated: 4294967295 facets need 214748364834",)
    yield "its count of facets is too small", "a.stl", put(stl, 80, "<I", 11), ("is too long: 11 facets need 634 bytes, the file has 684",)
    yield "it has no facet", "a.stl", put(stl, 80, "<I", 0)[:84], ("has no triangles",)
    yield "a header alone", "a.stl", stl[:80], ("has 80 bytes; a binary STL has at least 84",)
    yield "a corner is not a number", "a.stl", put(stl, 96, "<f", NAN), ("facet 1", "corner 1 has a coordinate that is not a number")
    yield "a corner is infinite", "a.stl", put(stl, 100, "<f", -INFINITY), ("facet 1", "corner 1 has a coordinate that is infinite")
    yield "a corner is 1e38", "a.stl", put(stl, 100, "<f", 1e38), READ
    yield "all corners are one", "a.stl", stl[:84] + bytes(50 * 12), ("all of its 12 facets have two corners in one point",)
    yield "a facet's normal is not a number", "a.stl", put(stl, 84, "<f", NAN), READ
    yield "a facet's attribute is any", "a.stl", put(stl, 132, "<H", 65535), READ
    yield "its header says solid", "a.stl", b"solid made by a scanner".ljust(80) + stl[80:], READ
    yield "bytes follow it", "a.stl", stl + b"\n\n", READ
    yield "text: a number is a word", "a.stl", edit(text, "vertex 0 0 9", "vertex 0 zero 9"), ("line 5", '"zero" is no number for a coordinate')
    yield "text: a number is not one", "a.stl", edit(text, "vertex 0 0 9", "vertex 0 nan 9"), ("line 5", "a coordinate is not a number")
    yield "text: a number has a comma", "a.stl", edit(text, "vertex 0 0 9", "vertex 0,5 0 9"), ("line 5", '"0,5" is no number for a coordinate')
    yield "text: a corner has two numbers", "a.stl", edit(text, "vertex 0 0 9\n", "vertex 0 9\n"), ("line 6", '"vertex" is no number for a coordinate')
    yield "text: a facet has two corners", "a.stl", edit(text, "vertex 0 0 9\n", ""), ("line 6", '"endloop" where "vertex" is expected')
    yield "text: cut in a facet", "a.stl", cut(text, 0.5), ("line 44", '"f" where "facet" or "endsolid" is expected')
    yield "text: it has no facet", "a.stl", "solid cube\nendsolid cube\n", ("has no triangles",)
    yield "text: lines end as on Windows", "a.stl", text.replace("\n", "\r\n"), READ
    yield "text: words are in capitals", "a.stl", text.upper(), READ

    ply, binary = SCANS["text.ply"], SCANS["binary.ply"]
    yield "no end of its header", "a.ply", edit(ply, "end_header\n", ""), ("line 9", '"0" is no word of a PLY header')
    yield "its format is none", "a.ply", edit(ply, "format ascii 1.0", "format utf8 1.0"), ("line 2", '"utf8" is no PLY format (ascii, binary_little_endian')
    yield "its format is missing", "a.ply", edit(ply, "format ascii 1.0\n", ""), ("line 8", 'the header has no "format" line')
    yield "a count is negative", "a.ply", edit(ply, "element vertex 8", "element vertex -8"), ("line 3", "the count -8 is negative")
    yield "a count is a word", "a.ply", edit(ply, "element vertex 8", "element vertex many"), ("line 3", "\"many\" is no whole number for the element's count")
    yield "a count is beyond all memory", "a.ply", edit(ply, "element vertex 8", "element vertex 99999999999"), ("header", 'promises 99999999999 records of "vertex", more than the')
    yield "a count of faces is beyond all memory", "a.ply", edit(binary, "element face 12", "element face 4000000000"), ("header", 'promises 4000000000 records of "face", more than the')
    yield "a type is none", "a.ply", edit(ply, "property float x", "property quaternion x"), ("line 4", '"quaternion" is no PLY type')
    yield "a coordinate is missing", "a.ply", edit(ply, "property float z\n", ""), ("element vertex", 'has no property "z"')
    yield "no vertices", "a.ply", edit(ply, "element vertex 8", "element corner 8"), ("header", 'there is no element "vertex"')
    yield "no faces", "a.ply", edit(ply, "element face 12", "element edge 12"), ("header", 'there is no element "face"')
    yield "an index is too large", "a.ply", edit(ply, "3 0 1 3\n", "3 0 1 8\n"), ("line 18", "a face names point 8 of 8 (counted from 0)")
    yield "an index is negative", "a.ply", edit(ply, "3 0 1 3\n", "3 0 1 -1\n"), ("line 18", "a face names point -1 of 8 (counted from 0)")
    yield "a face has one corner", "a.ply", edit(ply, "3 0 1 3\n", "1 0\n"), ("line 18", "a face has 1 corners, at least 3 are needed")
    yield "a coordinate is not a number", "a.ply", edit(ply, "0 0 9\n", "0 nan 9\n"), ("line 11", "a coordinate is not a number")
    yield "a coordinate is a word", "a.ply", edit(ply, "0 0 9\n", "0 oops 9\n"), ("line 11", '"oops" is no number for a coordinate')
    yield "cut in its faces", "a.ply", cut(ply, 0.9), ("line 26", "the file is truncated: it has fewer values than the")
    yield "cut in its points", "a.ply", binary[: binary.index(b"end_header\n") + 40], ("header", 'promises 8 records of "vertex", more than the file can')
    yield "binary: cut in its faces", "a.ply", binary[:-5], ("face 12", "the file is truncated: it has fewer bytes than the")
    yield "binary: a face of 255 corners", "a.ply", put(binary, binary.index(b"end_header\n") + 11 + 96, "<B", 255), ("face 1", "a face names point 768 of 8 (counted from 0)")
    yield "binary: an index is too large", "a.ply", put(binary, len(binary) - 4, "<i", 8), ("face 12", "a face names point 8 of 8 (counted from 0)")
    yield "binary: a coordinate is infinite", "a.ply", put(binary, binary.index(b"end_header\n") + 11, "<f", INFINITY), ("vertex 1", "a coordinate is infinite in single precision")
    yield "its first word is another one", "a.ply", SCANS["other-word.ply"], ("line 1", 'does not begin with "ply"')
    yield "comments in its header", "a.ply", SCANS["comment.ply"], READ
    yield "more properties", "a.ply", SCANS["colours.ply"], READ
    yield "lines end as on Windows", "a.ply", ply.replace("\n", "\r\n"), READ

    obj = SCANS["a.obj"]
    yield "an index is too large", "a.obj", edit(obj, "f 1 2 4", "f 1 2 9"), ("line 9", "a face names point 9, the file has 8")
    yield "an index is 0", "a.obj", edit(obj, "f 1 2 4", "f 0 2 4"), ("line 9", "a face names point 0 of 8 (counted from 1, or backwards")
    yield "an index is a word", "a.obj", edit(obj, "f 1 2 4", "f one 2 4"), ("line 9", "\"one\" is no whole number for a point's index")
    yield "an index is beyond 64 bits", "a.obj", edit(obj, "f 1 2 4", "f 1 2 99999999999999999999"), ("line 9", "\"99999999999999999999\" is no whole number for a point's")
    yield "indices from behind", "a.obj", edit(obj, "f 1 2 4", "f -8 -7 -5"), READ
    yield "an index from before the first", "a.obj", edit(obj, "f 1 2 4", "f -9 -7 -5"), ("line 9", "a face names point -9 of 8 (counted from 1, or")
    yield "a face has two corners", "a.obj", edit(obj, "f 1 2 4", "f 1 2"), ("line 9", "a face has 2 corners, at least 3 are needed")
    yield "corners with textures and normals", "a.obj", edit(obj, "f 1 2 4", "vt 0 0\nvn 0 0 1\nf 1/1/1 2//1 4/1"), READ
    yield "a coordinate is a word", "a.obj", edit(obj, "v 0 0 9", "v 0 x 9"), ("line 2", '"x" is no number for a coordinate')
    yield "a coordinate is not a number", "a.obj", edit(obj, "v 0 0 9", "v 0 nan 9"), ("line 2", "a coordinate is not a number")
    yield "two coordinates", "a.obj", edit(obj, "v 0 0 9", "v 0 9"), ("line 2", "lacks a coordinate")
    yield "no faces", "a.obj", obj[: obj.index("f ")], ("has no triangles",)
    yield "no points", "a.obj", obj[obj.index("f ") :], ("line 3", "a face names point 8, the file has 0")
    yield "a number as large as a galaxy", "a.obj", edit(obj, "v 0 0 9", "v 0 1e39 9"), ("line 2", 'a coordinate "1e39" is infinite in single precision')

    off = SCANS["a.off"]
    yield "its word is missing", "a.off", edit(off, "OFF\n", ""), ("line 1", '"8" where "OFF" is expected')
    yield "its counts are missing", "a.off", edit(off, "8 12 0\n", ""), ("line 3", "there is more after the 0 points and 0 faces that the")
    yield "a count is negative", "a.off", edit(off, "8 12 0", "-8 12 0"), ("line 2", "the header promises -8 points and 12 faces, more than")
    yield "a count is beyond all memory", "a.off", edit(off, "8 12 0", "8 9999999999 0"), ("line 2", "the header promises 8 points and 9999999999 faces, more")
    yield "an index is too large", "a.off", edit(off, "3 0 1 3\n", "3 0 1 8\n"), ("line 11", "a face names point 8 of 8 (counted from 0)")
    yield "an index is negative", "a.off", edit(off, "3 0 1 3\n", "3 0 1 -3\n"), ("line 11", "a face names point -3 of 8 (counted from 0)")
    yield "a face has two corners", "a.off", edit(off, "3 0 1 3\n", "2 0 1\n"), ("line 11", "a face has 2 corners, at least 3 are needed")
    yield "a coordinate is a word", "a.off", edit(off, "0 0 9\n", "0 nine 9\n"), ("line 4", '"nine" is no number for a coordinate')
    yield "a line of faces is missing", "a.off", off[: off.rindex("3 ")], ("line 22", "the file ends before face 12 of 12")
    yield "comments", "a.off", edit(off, "8 12 0", "# by hand\n8 12 0"), READ

    vtk = SCANS["a.vtk"]
    yield "its first line is another", "a.vtk", edit(vtk, "# vtk DataFile", "# itk DataFile"), ("its content is neither a legacy nor an XML file of VTK",)
    yield "an encoding that is none", "a.vtk", edit(vtk, "ASCII", "UNICODE"), ("line 3", "says neither ASCII nor BINARY")
    yield "a grid", "a.vtk", edit(vtk, "DATASET POLYDATA", "DATASET STRUCTURED_GRID"), ("DATASET", "is not POLYDATA")
    yield "a count of points is a word", "a.vtk", edit(vtk, "POINTS 8", "POINTS eight"), ("POINTS", "has something that is no number where one should be")
    yield "a count of points is negative", "a.vtk", edit(vtk, "POINTS 8", "POINTS -8"), ("POINTS", "has no count where one should be")
    yield "a count of points is beyond all memory", "a.vtk", edit(vtk, "POINTS 8", "POINTS 88888888888"), ("POINTS", "promises 88888888888 x 3 values, more than the file")
    yield "a type that is none", "a.vtk", edit(vtk, "POINTS 8 float", "POINTS 8 real"), ("POINTS", "is of an unknown type")
    yield "a point is not a number", "a.vtk", edit(vtk, "0 0 9\n", "0 nan 9\n"), ("point 2", "a coordinate is not finite")
    yield "a point is a word", "a.vtk", edit(vtk, "0 0 9\n", "0 nix 9\n"), ("POINTS", "has something that is no number where one should be")
    yield "an index is too large", "a.vtk", edit(vtk, "3 0 1 3\n", "3 0 1 8\n"), ("polygon 1", "names a point that is not there; there are 8, counted")
    yield "an index is negative", "a.vtk", edit(vtk, "3 0 1 3\n", "3 0 1 -1\n"), ("polygon 1", "names a point that is not there; there are 8, counted")
    yield "an index is broken", "a.vtk", edit(vtk, "3 0 1 3\n", "3 0 1.5 3\n"), ("POLYGONS", "has a number that is no index or count")
    yield "cells are longer than they say", "a.vtk", edit(vtk, "POLYGONS 12 48", "POLYGONS 12 40"), ("POLYGONS", "has fewer numbers than its cells need")
    yield "cells are fewer than they say", "a.vtk", edit(vtk, "POLYGONS 12 48", "POLYGONS 13 52"), ("POLYGONS", "has something that is no number where one should be")
    yield "labels are fewer than points", "a.vtk", edit(vtk, "POINT_DATA 8", "POINT_DATA 9"), ("SCALARS", "ends too early: the file is truncated")
    yield "cut in its points", "a.vtk", cut(vtk, 0.3), ("POINTS", "promises 8 x 3 values, more than the file holds")
    yield "no polygons", "a.vtk", vtk[: vtk.index("POLYGONS")], ("has no triangles",)
    yield "binary, as it says, with text", "a.vtk", edit(vtk, "ASCII", "BINARY"), ("holds something that is no section of a PolyData file",)

    vtp, packed, raw = SCANS["ascii.vtp"], SCANS["zlib.vtp"], SCANS["raw.vtp"]
    yield "a tag is not closed", "a.vtp", edit(vtp, "</Points>", ""), ("line 9", "is no well-formed XML (mismatched tag)")
    yield "elements within elements", "a.vtp", edit(vtp, "</Points>", "<a>" * 100), ("line 9", "is nested deeper than 64 elements")
    yield "more elements than there are arrays", "a.vtp", edit(vtp, "</Points>", "</Points>" + "<a/>" * 100000), ("line 9", "has more than 100000 elements")
    yield "a tag of megabytes", "a.vtp", edit(vtp, "</Points>", "</Points><a " + " ".join(f'a{i}="1"' for i in range(600000)) + "/>"), ("line 9", "holds a tag of megabytes")
    yield "a document type", "a.vtp", edit(vtp, "<VTKFile", "<!DOCTYPE a><VTKFile"), ("DOCTYPE", "is there, which no VTK file has")
    yield "cut in its points", "a.vtp", cut(vtp, 0.4), ("line 1", "is no well-formed XML (no element found)")
    yield "a kind of data that is no surface", "a.vtp", edit(vtp, 'type="PolyData"', 'type="ImageData"'), ("VTKFile", "is not of type PolyData")
    yield "an order of bytes that is none", "a.vtp", edit(packed, "LittleEndian", "MiddleEndian"), ("byte_order", "is neither LittleEndian nor BigEndian")
    yield "a compressor that is not known", "a.vtp", edit(packed, "vtkZLibDataCompressor", "vtkLZMADataCompressor"), ("compressor", "is vtkLZMADataCompressor")
    yield "a format that is none", "a.vtp", edit(vtp, 'format="ascii"', 'format="verse"'), ("Points", "has a format that is neither ascii, binary nor appended")
    yield "a type that is none", "a.vtp", edit(vtp, 'type="Float32"', 'type="Float24"'), ("Points", "is of an unknown type")
    yield "points are fewer than it says", "a.vtp", edit(vtp, 'NumberOfPoints="8"', 'NumberOfPoints="9"'), ("Points", "has 24 values, 27 are expected")
    yield "points are beyond all memory", "a.vtp", edit(vtp, 'NumberOfPoints="8"', 'NumberOfPoints="999999999999"'), ("NumberOfPoints", "promises 999999999999, which the file cannot hold")
    yield "points are a word", "a.vtp", edit(vtp, 'NumberOfPoints="8"', 'NumberOfPoints="eight"'), ("NumberOfPoints", "has something that is no number where one should be")
    yield "faces are more than it says", "a.vtp", edit(vtp, 'NumberOfPolys="12"', 'NumberOfPolys="11"'), ("Polys.offsets", "has 12 values, 11 are expected")
    yield "two numbers a point", "a.vtp", edit(vtp, 'NumberOfComponents="3"', 'NumberOfComponents="2"'), ("Points", "has 2 components")
    yield "an index is too large", "a.vtp", edit(vtp, ">0 1 3 ", ">0 1 8 "), ("polygon 1", "names a point that is not there; there are 8, counted")
    yield "an index is negative", "a.vtp", edit(vtp, ">0 1 3 ", ">0 1 -3 "), ("polygon 1", "names a point that is not there; there are 8, counted")
    yield "ends go back", "a.vtp", edit(vtp, ">3 6 9 ", ">3 9 6 "), ("polygon 3", "its corners are not within the list of corners")
    yield "base64 has other letters", "a.vtp", edit(packed, "AQAAAGAAAAA", "AQ*AAGAAAAA"), ("Points", "holds something that is no base64")
    yield "a packed block is damaged", "a.vtp", edit(packed, "eJx", "eJz"), ("Points", "cannot be decompressed")
    yield "a packed block is longer than it says", "a.vtp", edit(packed, "AQAAAGAAAAA", "AQAAAFAAAAA"), ("Points", "cannot be decompressed")
    yield "an entity that bursts", "a.vtp", '<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;">]>' + edit(vtp, '<?xml version="1.0"?>', "", ">0 1 3", ">&b;"), ("DOCTYPE", "is there, which no VTK file has")
    yield "raw: an offset behind the end", "a.vtp", edit(raw, 'offset="0"', 'offset="99999"'), ("Points.Points", "begins behind the end of the file: it is truncated")
    yield "raw: a negative offset", "a.vtp", edit(raw, 'offset="0"', 'offset="-1"'), ("offset", "promises -1, which the file cannot hold")
    yield "raw: a length that is another", "a.vtp", edit(raw, b"_" + struct.pack("<I", 96), b"_" + struct.pack("<I", 92)), ("Points.Points", "has 23 values, 24 are expected")
    yield "raw: a length behind the end", "a.vtp", edit(raw, b"_" + struct.pack("<I", 96), b"_" + struct.pack("<I", 2**31)), ("Points.Points", "promises 2147483648 bytes, which the file cannot hold")
    yield "raw: its data are missing", "a.vtp", raw[: raw.index(b"<AppendedData")] + b"</VTKFile>", ("Points.Points", "has a format that is neither ascii, binary nor appended")
    yield "raw: an encoding that is none", "a.vtp", edit(raw, 'encoding="raw"', 'encoding="cooked"'), ("Points.Points", "holds something that is no base64")
    yield "an extension that no reader has", "a.xyz", "1 2 3\n", ("neither its content nor its extension is of a known",)
    yield "a ZIP archive with a scan's name", "a.stl", b"PK\x03\x04" + stl, ("is a ZIP archive, no scan",)
    yield "a web page with a scan's name", "a.ply", "<!DOCTYPE html><html></html>", ("is a web page, no scan",)
    yield "an empty file", "a.obj", "", ("the file is empty (0 bytes)",)


def contours():
    own = CONTOURS["own.json"]
    yield "a comma is missing", "a.json", edit(own, '"closed": true, ', '"closed": true '), ("line 1, column 89", "JSON syntax error: while parsing object - unexpected")
    yield "cut", "a.json", cut(own, 0.6), ("line 1, column 91", "JSON syntax error: while parsing object separator -")
    yield "bytes that are no UTF-8", "a.json", edit(own.encode(), "UR1", b"UR\xff"), ("line 1, column 61", "JSON syntax error: while parsing value - invalid")
    yield "a number that is none", "a.json", edit(own, "[40, 12]", "[40, NaN]"), ("line 1, column 124", "JSON syntax error: while parsing value - invalid literal")
    yield "a number that overflows", "a.json", edit(own, "[40, 12]", "[40, 1e999]"), ("line 1, column 128", "JSON syntax error: number overflow parsing '1e999'")
    yield "a field twice", "a.json", edit(own, '"closed": true', '"closed": true, "closed": false'), ("contours.upper[0].closed", "is there twice")
    yield "no contours", "a.json", '{"image_size": [50, 50]}', ("contours", "JSON in no form that is known", "image_size")
    yield "contours are a list", "a.json", '{"image_size": [50, 50], "contours": []}', ("contours", "is an array of 0, expected an object")
    yield "nothing in them", "a.json", '{"image_size": [50, 50], "contours": {}}', READ
    yield "an image of two sizes", "a.json", edit(own, "[50, 50]", "[50, 50, 50]"), ("image_size", "is an array of 3, expected 2 numbers [width, height]")
    yield "an image of no size", "a.json", edit(own, "[50, 50]", "[50, 0]"), ("image_size[1]", "is 0.0, expected a whole number from 1 to 1000000")
    yield "an image of half a pixel", "a.json", edit(own, "[50, 50]", "[50, 49.5]"), ("image_size[1]", "is 49.5, expected a whole number from 1 to 1000000")
    yield "an image of 2^40 pixels", "a.json", edit(own, "[50, 50]", "[1048576, 1048576]"), ("image_size[0]", "is 1048576.0, expected a whole number from 1 to 1000000")
    yield "a code of the other jaw", "a.json", edit(own, "UR1", "LR1"), ("contours.upper[0].code", '"LR1" (LR1) is no tooth of the upper jaw')
    yield "a code that is none", "a.json", edit(own, "UR1", "UR9"), ("contours.upper[0].code", '"UR9" is no tooth code (UR1-UR8, UL, LL, LR, or digits')
    yield "a code that FDI has not", "a.json", edit(own, '"UR1"', "19"), ("contours.upper[0].code", 'FDI has no tooth "19" (11-18, 21-28, 31-38, 41-48')
    yield "a code that is a list", "a.json", edit(own, '"UR1"', '["UR1"]'), ("contours.upper[0].code", "is an array of 1, expected a string")
    yield "a code that is not known", "a.json", edit(own, '"UR1"', "null"), READ
    yield "a point of one number", "a.json", edit(own, "[40, 12]", "[40]"), ("contours.upper[0].points[1]", "is an array of 1, expected 2 numbers [u, v]")
    yield "a point of three numbers", "a.json", edit(own, "[40, 12]", "[40, 12, 0]"), ("contours.upper[0].points[1]", "is an array of 3, expected 2 numbers [u, v]")
    yield "a point of words", "a.json", edit(own, "[40, 12]", '["40", "12"]'), ("contours.upper[0].points[1][0]", 'is "40", expected a number')
    yield "a point is null", "a.json", edit(own, "[40, 12]", "null"), ("contours.upper[0].points[1]", "is null, expected 2 numbers [u, v]")
    yield "points are an object", "a.json", edit(own, str(seeds.LINE), "{}"), ("contours.upper[0].points", "is an object, expected an array")
    yield "points are missing", "a.json", edit(own, ', "points": ' + str(seeds.LINE), ""), ("contours.upper[0].points", "missing field")
    yield "most points outside", "a.json", edit(own, "[40, 12]", "[400, 12]", "[38, 44]", "[380, 44]"), ("contours.upper[0]", "2 of 4 points lie outside the image of 50 x 50 pixels")
    yield "closed is a word", "a.json", edit(own, '"closed": true', '"closed": "yes"'), ("contours.upper[0].closed", 'is "yes", expected true or false')
    yield "closed with two points", "a.json", edit(own, str(seeds.LINE), "[[10, 10], [40, 12]]"), ("contours.upper[0]", "is closed but has 2 different points")
    yield "closed with three times the same point", "a.json", edit(own, str(seeds.LINE), "[[10, 10], [10, 10], [10, 10]]"), ("contours.upper[0]", "is closed but has 2 different points")
    yield "a sigma of 0", "a.json", edit(own, '"sigma_px": 1.5', '"sigma_px": 0'), ("contours.upper[0].sigma_px", "is 0, no standard deviation")
    yield "a negative sigma", "a.json", edit(own, '"sigma_px": 1.5', '"sigma_px": -1.5'), ("contours.upper[0].sigma_px", "is -1.5, no standard deviation")
    yield "fewer sigmas than points", "a.json", edit(own, '"sigma_px": 1.5', '"sigma_px": [1, 2]'), ("contours.upper[0].sigma_px", "has 2 values, expected 4 (one a point)")
    yield "a sigma that is a word", "a.json", edit(own, '"sigma_px": 1.5', '"sigma_px": "small"'), ("contours.upper[0].sigma_px", 'is "small", expected a number')
    yield "fewer weights than points", "a.json", edit(own, '"sigma_px": 1.5', '"weights": [1, 1]'), ("contours.upper[0].weights", "is an array of 2, expected 4 numbers (one a point)")
    yield "a weight above 1", "a.json", edit(own, '"sigma_px": 1.5', '"weights": [1, 1, 1, 2]'), ("contours.upper[0].weights[3]", "is 2, not in [0, 1]")
    yield "a negative weight", "a.json", edit(own, '"sigma_px": 1.5', '"weights": [1, 1, 1, -0.1]'), ("contours.upper[0].weights[3]", "is -0.1, not in [0, 1]")
    yield "an outline that is none", "a.json", edit(own, '"closed": true', '"outline": "gum"'), ("contours.upper[0].outline", '"gum" is no outline ("crown", "tooth" or "labial")')
    yield "a numbering that is none", "a.json", edit(own, '{"image_size"', '{"numbering": "palmer", "image_size"'), ("numbering", '"palmer" is no numbering ("UR", "FDI" or "universal")')
    yield "deeper than anybody writes", "a.json", "[" * 1000 + "]" * 1000, ("[0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0]", "is nested deeper than 64 levels")
    yield "a number alone", "a.json", "17", ("no JSON: it begins with",)
    yield "a byte order mark before it", "a.json", b"\xef\xbb\xbf" + own.encode(), READ
    yield "UTF-16", "a.json", own.encode("utf-16"), ("is text in UTF-16, no tracing",)
    labelme = CONTOURS["labelme.json"]
    yield "labelme: a label of no tooth", "a.json", edit(labelme, '"label": "11"', '"label": "chin"'), ("shapes[0].label", '"chin" is no tooth')
    yield "labelme: a code that is none", "a.json", edit(labelme, '"label": "11"', '"label": "19"'), ("shapes[0].label", 'FDI has no tooth "19" (11-18, 21-28, 31-38, 41-48')
    yield "labelme: a circle", "a.json", edit(labelme, '"polygon"', '"circle"'), ("has no outline", "a shape of type circle is no contour", "draw or export polygons")
    yield "labelme: no points", "a.json", edit(labelme, str(seeds.LINE), "[]"), READ
    yield "labelme: points of words", "a.json", edit(labelme, "[40, 12]", '["a", "b"]'), ("shapes[0].points[1][0]", 'is "a", expected a number')
    yield "labelme: a size of words", "a.json", edit(labelme, '"imageWidth": 50', '"imageWidth": "50"'), ("imageWidth", 'is "50", expected a number')
    coco = CONTOURS["coco.json"]
    yield "COCO: an odd number of coordinates", "a.json", edit(coco, "[10, 10, 40, 12", "[10, 40, 12"), ("annotations[0].segmentation[0]", "has an odd number of coordinates")
    yield "COCO: a category that is none", "a.json", edit(coco, '"category_id": 1', '"category_id": 7'), ("annotations[0].category_id", "names no category of the file")
    yield "COCO: an image that is none", "a.json", edit(coco, '"image_id": 1', '"image_id": 9'), READ
    yield "COCO: runs longer than the image", "a.json", edit(coco, "[510, 30, 20, 30, 1910]", "[510, 30, 20, 30, 191000]"), ("annotations[1].segmentation.counts", "has runs of 191590 pixels, and the picture has 2500")
    yield "COCO: a negative run", "a.json", edit(coco, "[510, 30, 20, 30, 1910]", "[510, -30, 20, 90, 1910]"), ("annotations[1].segmentation.counts[1]", "is -30.0, expected a whole number from 0 to 134217728")
    yield "COCO: no categories", "a.json", edit(coco, '"categories": [{"id": 1, "name": "11"}], ', ""), ("contours", "JSON in no form that is known")
    via = CONTOURS["via.json"]
    yield "VIA: more x than y", "a.json", edit(via, "[10, 40, 38, 12]", "[10, 40, 38]"), ("a.png1.regions[0].shape_attributes.all_points_y", "has another number of values than all_points_x")
    yield "VIA: no shape", "a.json", edit(via, '"name": "polygon"', '"name": "ellipse"'), ("has no outline", "the shape ellipse is no contour", "draw or export polygons")
    yield "Supervisely: no exterior", "a.json", edit(CONTOURS["supervisely.json"], '"exterior": ' + str(seeds.LINE) + ", ", ""), ("objects[0].points.exterior", "missing field")
    yield "Supervisely: a size of one number", "a.json", edit(CONTOURS["supervisely.json"], '{"height": 50, "width": 50}', '{"height": 50}'), ("size.width", "missing field")
    yield "Label Studio: a size of none", "a.json", edit(CONTOURS["labelstudio.json"], '"original_width": 50, ', ""), ("[0].annotations[0].result[0].original_width", "missing field")
    yield "Label Studio: no result", "a.json", '[{"data": {"image": "a.png"}, "annotations": [{"result": []}]}]', ("has no outline: nothing is drawn in it", "draw or export polygons")
    cvat = CONTOURS["cvat.xml"]
    yield "CVAT: a point of one number", "a.xml", edit(cvat, "40,12;", "40;"), ("line 1", 'has the point "40", expected x,y')
    yield "CVAT: a point of words", "a.xml", edit(cvat, "40,12;", "a,b;"), ("line 1", 'has the point "a,b", expected x,y')
    yield "CVAT: no width", "a.xml", edit(cvat, ' width="50"', ""), ("line 1", "the picture's width \"\" is no number of pixels")
    yield "CVAT: a tag is not closed", "a.xml", edit(cvat, "</image>", ""), ("line 1", "is no well-formed XML (mismatched tag)")
    yield "CVAT: runs that are too many", "a.xml", edit(cvat, "3, 4, 3", "3, 4, 3000"), ("line 1", "the mask has runs of more pixels than its box", "export the masks again")
    yield "CVAT: a mask outside", "a.xml", edit(cvat, 'left="2"', 'left="48"'), ("line 1", "the mask does not lie in the picture", "export the masks again")
    yield "CVAT: cut", "a.xml", cut(cvat, 0.7), ("line 1", "is no well-formed XML (unclosed token)")
    table = CONTOURS["table.csv"]
    yield "CSV: a cell is a word", "a.csv", edit(table, "UR1,40,12", "UR1,forty,12"), ("line 3", '"forty" is no number')
    yield "CSV: a cell too many", "a.csv", edit(table, "UR1,40,12", "UR1,40,12,7"), READ
    yield "CSV: a cell too few", "a.csv", edit(table, "UR1,40,12", "UR1,40"), ("line 3", "has 2 columns, expected those of the header")
    yield "CSV: no column y", "a.csv", edit(table, "label,x,y", "label,x,z"), ("line 1", 'the column "z" is not known to be the coordinate "y" in pixels', 'call it "y"')
    yield "CSV: a header alone", "a.csv", "label,x,y\n", ("has no outline: nothing is drawn in it", "draw or export polygons")
    yield "CSV: a quote is not closed", "a.csv", edit(table, "UR1,40", '"UR1,40'), READ
    yield "CSV: a coordinate is not a number", "a.csv", edit(table, "UR1,40,12", "UR1,nan,12"), ("line 3", '"nan" is no number')
    yield "CSV: a tooth that is none", "a.csv", table.replace("UR1", "UR9"), ("line 2", '"UR9" is no tooth code (UR1-UR8, UL, LL, LR, or digits')


def landmarks(target, points, is_space):
    # Those to register with are needed; of the others there may be none.
    nothing = ("has no dental landmark",) if target == "cephalometric" else READ
    own = points["own.json"]
    first = '"UR1_tip": [' + ("0.0, 1.0, 2.0" if is_space else "0.0, 1.0") + "]"
    number = '"UR1_tip": '
    yield "a landmark of one number", "a.json", edit(own, first, number + "[1]"), ("UR1_tip", "is an array of 1, expected")
    yield "a landmark of four numbers", "a.json", edit(own, first, number + "[1, 2, 3, 4]"), ("UR1_tip", "is an array of 4, expected")
    yield "a landmark of words", "a.json", edit(own, first, number + '["a", "b", "c"]'), ("expected",)
    yield "a landmark is null", "a.json", edit(own, first, number + "null"), READ
    yield "a landmark overflows", "a.json", edit(own, first, number + ("[1e999, 0, 0]" if is_space else "[1e999, 0]")), ("line 1, column 18", "JSON syntax error: number overflow parsing '1e999'")
    yield "a landmark is further than any", "a.json", edit(own, first, number + ("[3e7, 0, 0]" if is_space else "[3e7, 0]")), ("UR1_tip", "has a coordinate of 3e+07, where no pixel of a")
    yield "a landmark twice", "a.json", edit(own, "{", "{" + first + ", "), ("UR1_tip", "is there twice")
    yield "no landmark", "a.json", "{}", nothing
    yield "a list", "a.json", "[1, 2, 3]", ("object",)
    yield "cut", "a.json", cut(own, 0.5), ("JSON syntax error: while parsing object key -",)
    yield "names of no tooth alone", "a.json", '{"Sella": [' + ("1, 2, 3" if is_space else "1, 2") + "]}", nothing
    slicer = points["slicer.mrk.json"]
    yield "Slicer: a position of words", "a.mrk.json", edit(slicer, '"position": [0.0, 1.0, ', '"position": ["0", 1.0, '), ("markups[0].controlPoints[0].position[0]", 'is "0", expected a number')
    yield "Slicer: a position of two numbers", "a.mrk.json", edit(slicer, '"position": [0.0, 1.0, ', '"position": [1.0, '), ("markups[0].controlPoints[0].position", "is an array of 2, expected 3 numbers [x, y, z]")
    yield "Slicer: a frame that is none", "a.mrk.json", edit(slicer, '"LPS"', '"XYZ"'), ("markups[0].coordinateSystem", 'is "XYZ", expected "LPS" or "RAS"')
    yield "Slicer: no points", "a.mrk.json", '{"markups": [{"type": "Fiducial", "coordinateSystem": "LPS", "controlPoints": []}]}', nothing
    table = points["table.csv"]
    yield "CSV: a cell is a word", "a.csv", edit(table, "UR1_tip,0.0", "UR1_tip,here"), ("line 2", '"here" is no number')
    yield "CSV: a cell is missing", "a.csv", edit(table, "UR1_tip,0.0,1.0", "UR1_tip,0.0"), ("line 2", "columns, expected those of the header")
    yield "CSV: a column is missing", "a.csv", edit(table, "label,x,y", "label,x,w"), READ


def cephalometric():
    yield from landmarks("cephalometric", POINTS2, False)
    yield "two names of one point", "a.json", '{"Is": [1, 2], "U1_tip": [1, 2]}', ("U1_tip", 'landmark "U1_tip" is the same point as "Is"')
    yield "a sigma of 0", "a.json", '{"U1_tip": {"position": [1, 2], "sigma_px": 0}}', ("U1_tip.sigma_px", "0 is no standard deviation")
    yield "a confidence of 2", "a.json", '{"U1_tip": {"position": [1, 2], "confidence": 2}}', ("U1_tip.confidence", "2 is not from 0 to 1")
    yield "no position", "a.json", '{"U1_tip": {"sigma_px": 2}}', ("U1_tip.position", "missing field")
    yield "Aariz: no value", "a.json", '{"ceph_id": "a", "landmarks": [{"title": "t", "symbol": "UIT"}]}', ("landmarks[0].x", "missing field")
    yield "Aariz: x is a word", "a.json", '{"ceph_id": "a", "landmarks": [{"title": "t", "symbol": "UIT", "value": {"x": "a", "y": 1}}]}', ("landmarks[0].value.x", 'is "a", expected a number')
    yield "a detector: nothing was found", "a.json", '{"landmarks": [{"name": "U1_tip", "x": null, "y": null}]}', ("has no dental landmark",)
    yield "a detector: a confidence that is no word of its own", "a.json", '{"landmarks": [{"name": "U1_tip", "x": 1, "y": 2, "confidence": "huge"}]}', ("landmarks[0].confidence", '"huge" is no confidence')
    isbi = "".join(f"{10 * k},{20 + k}\n" for k in range(1, 20)) + "1\n" * 8
    yield "ISBI: as it is", "a.txt", isbi, READ
    yield "ISBI: 18 lines", "a.txt", "".join(isbi.splitlines(True)[:18]), ("has 18 lines x,y; a file of ISBI 2015 has 19",)
    yield "ISBI: a word", "a.txt", edit(isbi, "110,31", "110,x"), ("line 11", '"x" is no number')
    head = "file,scale," + ",".join(f"p{k}{a}" for k in range(1, 39) for a in "xy")
    row = "a.bmp,0.1," + ",".join(str(10 + k) for k in range(76))
    yield "CL-Detection: as it is", "a.csv", head + "\n" + row + "\n", READ
    yield "CL-Detection: a cell too few", "a.csv", head + "\n" + row.rsplit(",", 1)[0] + "\n", ("line 2", "has 77 columns; file,scale,p1x,p1y,..,p38x,p38y are 78")
    yield "CL-Detection: a word", "a.csv", head + "\n" + edit(row, ",30,", ",thirty,") + "\n", ("line 2, p11", '"thirty" is no number')


def images():
    png = IMAGES["a.png"]
    yield "PNG: cut in its pixels", "a.png", png[:-20], ("the PNG file of 51 bytes is truncated or damaged",)
    yield "PNG: a checksum is another", "a.png", put(png, 29, ">I", 1), ("the PNG file of 71 bytes is truncated or damaged",)
    yield "PNG: a width of 0", "a.png", put(png, 16, ">I", 0), ("the PNG file of 71 bytes is truncated or damaged",)
    yield "PNG: a chunk beyond the end", "a.png", put(png, 33, ">I", 2**31 - 1), ("the PNG file of 71 bytes is truncated or damaged",)
    yield "PNG: nothing but its signature", "a.png", png[:8], ("the PNG file of 8 bytes is truncated or damaged",)
    yield "PNG: bytes follow it", "a.png", png + b"more", READ
    yield "PNG: sent as text", "a.png", png.replace(b"\r\n", b"\n"), ("is no image of a known format",)
    yield "JPEG: its beginning alone", "a.jpg", b"\xff\xd8\xff\xe0\x00\x10JFIF\x00\x01\x01\x00\x00\x01\x00\x01\x00\x00", ("the JPEG file of 20 bytes is truncated or damaged",)
    yield "JPEG: a segment beyond the end", "a.jpg", b"\xff\xd8\xff\xdb\xff\xff\x00", ("the JPEG file of 7 bytes is truncated or damaged",)
    yield "JPEG: an end without a picture", "a.jpg", b"\xff\xd8\xff\xd9", ("the JPEG file is damaged: JPEG datastream contains no",)
    bmp = IMAGES["b.bmp"]
    yield "BMP: cut in its pixels", "a.bmp", bmp[:-700], ("the BMP file of 1402 bytes is truncated or damaged",)
    yield "BMP: a width of 0", "a.bmp", put(bmp, 18, "<i", 0), ("is an image of 0 x 32 pixels",)
    yield "BMP: a negative width", "a.bmp", put(bmp, 18, "<i", -32), ("the BMP file of 2102 bytes is truncated or damaged",)
    yield "BMP: 7 bits a pixel", "a.bmp", put(bmp, 28, "<H", 7), ("cannot be read as BMP: BMPImageIO: Only BMP depths of",)
    yield "BMP: pixels behind the end", "a.bmp", put(bmp, 10, "<I", 10**9), ("the BMP file of 2102 bytes is truncated or damaged",)
    yield "BMP: a header of 3 bytes", "a.bmp", put(bmp, 14, "<I", 3), ("cannot be read as BMP: BMPImageIO: Unknown file type!",)
    tif = IMAGES["a.tif"]
    yield "TIFF: cut before its directory", "a.tif", tif[:-60], ("the TIFF file of 1086 bytes is truncated or damaged",)
    yield "TIFF: a directory behind the end", "a.tif", put(tif, 4, "<I", 10**9), ("the TIFF file of 1146 bytes is truncated or damaged",)
    yield "TIFF: a strip behind the end", "a.tif", edit(tif, struct.pack("<HHII", 273, 4, 1, 8), struct.pack("<HHII", 273, 4, 1, 10**6)), ("the TIFF file of 1146 bytes is truncated or damaged",)
    yield "TIFF: a width of 0", "a.tif", edit(tif, struct.pack("<HHII", 256, 3, 1, 32), struct.pack("<HHII", 256, 3, 1, 0)), ("cannot be read as TIFF: TIFFImageIO: Cannot open file",)
    yield "TIFF: 77 bits", "a.tif", edit(tif, struct.pack("<HHII", 258, 3, 1, 8), struct.pack("<HHII", 258, 3, 1, 77)), ("BitsPerSample", "is 77, and whole numbers of up to 32 bits are read", "save it with 8, 16 or 32 bits")
    yield "TIFF: a compression that is none", "a.tif", edit(tif, struct.pack("<HHII", 259, 3, 1, 1), struct.pack("<HHII", 259, 3, 1, 999)), ("cannot be read as TIFF: row 0 cannot be read",)
    nrrd = IMAGES["a.nrrd"]
    yield "NRRD: cut in its pixels", "a.nrrd", nrrd[:-100], ("cannot be read as NRRD: NrrdImageIO: Read: Error",)
    yield "NRRD: a type that is none", "a.nrrd", edit(nrrd, "type: uint8", "type: uint9"), ("cannot be read as NRRD: NrrdImageIO",)
    yield "NRRD: a negative size", "a.nrrd", edit(nrrd, "sizes: 32 32", "sizes: 32 -32"), ("cannot be read as NRRD: NrrdImageIO",)
    yield "NRRD: one size of two", "a.nrrd", edit(nrrd, "sizes: 32 32", "sizes: 32"), ("cannot be read as NRRD: NrrdImageIO",)
    yield "NRRD: an encoding that is none", "a.nrrd", edit(nrrd, "encoding: raw", "encoding: rar"), ("cannot be read as NRRD: NrrdImageIO",)
    yield "NRRD: no dimension", "a.nrrd", edit(nrrd, "dimension: 2\n", ""), ("cannot be read as NRRD: NrrdImageIO",)
    yield "NRRD: 17 dimensions", "a.nrrd", edit(nrrd, "dimension: 2\nsizes: 32 32", "dimension: 17\nsizes:" + " 2" * 17), ("cannot be read as NRRD: NrrdImageIO",)
    mha = IMAGES["a.mha"]
    yield "MetaImage: cut in its pixels", "a.mha", mha[:-100], ("the pixels are truncated: 924 of 1024 bytes are there",)
    yield "MetaImage: a type that is none", "a.mha", edit(mha, "MET_UCHAR", "MET_BYTES"), ("ElementType", '"MET_BYTES" is no type of a grey or RGB pixel')
    yield "MetaImage: a size of 0", "a.mha", edit(mha, "DimSize = 32 32", "DimSize = 32 0"), ("DimSize", '"32 0" is no image size')
    yield "MetaImage: a size of words", "a.mha", edit(mha, "DimSize = 32 32", "DimSize = a b"), ("DimSize", '"a b" is no list of numbers')
    yield "MetaImage: no pixels are named", "a.mha", mha[: mha.index(b"ElementDataFile")], ("ElementDataFile", "missing field")
    yield "MetaImage: its pixels are missing", "a.mhd", IMAGES["detached.mhd"], ("ElementDataFile", '"a.raw": there is no such file')
    nii, packed = IMAGES["a.nii"], IMAGES["a.nii.gz"]
    yield "NIfTI: as it is", "a.nii", nii, READ
    yield "NIfTI: as it is, compressed", "a.nii.gz", packed, READ
    yield "NIfTI: its name is another", "a.png", nii, READ
    yield "NIfTI: compressed twice, one behind the other", "a.nii.gz", gzip.compress(nii[:400]) + gzip.compress(nii[400:]), READ
    yield "NIfTI: a few bytes follow it", "a.nii", nii + bytes(100), READ
    yield "NIfTI: cut in its pixels", "a.nii", nii[:-100], ("the NIfTI file is truncated or damaged: 1276 of 1376 bytes are there",)
    yield "NIfTI: cut in its header", "a.nii", nii[:300], ("is no image of a known format",)
    yield "NIfTI: cut where it is compressed", "a.nii.gz", packed[:-20], ("is truncated or damaged:", "its compressed bytes end too early")
    yield "NIfTI: cut in its checksum", "a.nii.gz", packed[:-2], ("is truncated or damaged: 2400 of 2400 bytes are there, and its compressed bytes end too early",)
    yield "NIfTI: its checksum is another", "a.nii.gz", put(packed, len(packed) - 8, "<I", 1), ("is truncated or damaged:", "its compressed bytes are damaged")
    yield "NIfTI: more pixels than it says", "a.nii.gz", gzip.compress(nii + bytes(100000)), ("dim", "the file has more pixels than its header says")
    yield "NIfTI: a size of 0", "a.nii", put(nii, 44, "<h", 0), ("dim", '"32 x 0 x 1" is no image size')
    yield "NIfTI: a negative size", "a.nii", put(nii, 42, "<h", -32), ("dim", '"-32 x 32 x 1" is no image size')
    yield "NIfTI: one dimension", "a.nii", put(nii, 40, "<h", 1), ("dim", "is no picture: it has 1 dimensions")
    yield "NIfTI: 900 dimensions", "a.nii", put(nii, 40, "<h", 900), ("dim", "is no picture: it has 900 dimensions")
    yield "NIfTI: slices", "a.nii", put(nii, 46, "<h", 4), ("has 4 frames, pages or slices",)
    yield "NIfTI: a picture across the slices", "a.nii", put(nii, 42, "<3h", 1, 32, 32), ("dim", '"1 x 32 x 32" is a picture across the slices')
    yield "NIfTI: vectors", "a.nii", put(nii, 40, "<6h", 5, 32, 32, 1, 1, 3), ("dim", "has 3 values a pixel (32 x 32 x 1 x 1 x 3), not one")
    yield "NIfTI: colours", "a.nii", put(nii, 70, "<2h", 128, 24), ("datatype", "128 is no type of a grey pixel")
    yield "NIfTI: bits of another type", "a.nii", put(nii, 72, "<h", 16), ("bitpix", "is 16, and 8 of its datatype 2")
    yield "NIfTI: pixels at no place", "a.nii", put(nii, 108, "<f", NAN), ("vox_offset", "is not where pixels can begin")
    yield "NIfTI: pixels in its header", "a.nii", put(nii, 108, "<f", 0), ("vox_offset", "is not where pixels can begin")
    yield "NIfTI: pixels behind its end", "a.nii", put(nii, 108, "<f", 1e6), ("is truncated or damaged: 1376 of 1001024 bytes are there",)
    yield "NIfTI: turned over by what nobody knows", "a.nii", put(nii, 280, "<f", 1), ("srow_x, srow_y", "columns run to R and rows to P")
    yield "NIfTI: seen from the front", "a.nii", put(nii, 296, "<12f", 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0), ("srow_x, srow_y", "which is no picture from left to right")
    yield "NIfTI: an affine of no numbers", "a.nii", put(nii, 280, "<f", NAN), ("srow_x, srow_y", "which is no picture from left to right")
    yield "NIfTI: an affine of noughts", "a.nii", put(nii, 280, "<8f", *[0] * 8), ("srow_x, srow_y", "which is no picture from left to right")
    yield "NIfTI: a slope that is no number", "a.nii", put(nii, 112, "<f", NAN), READ
    yield "NIfTI: pixels in another file", "a.hdr", put(nii, 344, "3s", b"ni1")[:348], ("is a NIfTI header, whose pixels are in another file (.img)",)
    two = struct.pack("<i", 540) + b"n+2\0" + bytes(700)
    yield "NIfTI: version 2", "a.nii", two, ("is a NIfTI-2 image",)
    yield "NIfTI: version 2, compressed", "a.nii.gz", gzip.compress(two), ("unpacked it doesn't begin as NIfTI-1 in one file",)
    yield "NIfTI: another thing by that name", "a.nii.gz", gzip.compress(b"labels"), ("unpacked it doesn't begin as NIfTI-1 in one file",)
    pixels = bytes(range(256)) * 4
    whole = dicom(32, 32, pixels)
    yield "DICOM: as it is", "a.dcm", whole, READ
    yield "DICOM: cut in its pixels", "a.dcm", whole[:-300], ("(7fe0,0010)", "damaged or unsupported DICOM: is of 1024 bytes, of")
    yield "DICOM: cut in its header", "a.dcm", whole[:200], ("(0002,0010)", "damaged or unsupported DICOM: is of 20 bytes, of which")
    yield "DICOM: its word is another", "a.dcm", edit(whole, "DICM", "DICN"), ("is no image of a known format",)
    yield "DICOM: more rows than pixels", "a.dcm", dicom(64, 32, pixels), ("(7fe0,0010)", "damaged or unsupported DICOM: 1024 bytes of pixels, of")
    yield "DICOM: no rows", "a.dcm", dicom(0, 32, b""), ("(0028,0010)", "damaged or unsupported DICOM: no rows")
    yield "DICOM: a transfer syntax that is none", "a.dcm", dicom(32, 32, pixels, b"1.2.840.10008.1.2.4.999"), ("TransferSyntaxUID (0002,0010)", 'damaged or unsupported DICOM: "1.2.840.10008.1.2.4.999"')
    yield "DICOM: JPEG that is none", "a.dcm", dicom(32, 32, b"no picture", b"1.2.840.10008.1.2.4.50"), ("cannot be read as DICOM: GDCMImageIO: Failed to change",)
    yield "DICOM: JPEG 2000 that is none", "a.dcm", dicom(32, 32, b"no picture", b"1.2.840.10008.1.2.4.90"), ("cannot be read as DICOM: GDCMImageIO: Failed to change",)
    yield "no image at all", "a.png", b"this is no picture", ("is no image of a known format",)
    yield "an image of another format than its name", "a.jpg", png, READ


def labelmaps():
    yield "no label in it", "a.png", IMAGES["a.png"], READ
    yield "cut", "a.png", IMAGES["a.png"][:-20], ("the PNG file of 51 bytes is truncated or damaged",)
    yield "no image", "a.nrrd", "no image", ("is no image of a known format",)
    yield "labels that are no teeth", "a.mha", IMAGES["a.mha"], READ


    yield "NIfTI: turned over by what nobody knows", "a.nii", put(IMAGES["a.nii"], 280, "<f", 1), ("srow_x, srow_y", "columns run to R and rows to P")
    yield "NIfTI: colours", "a.nii", put(IMAGES["a.nii"], 70, "<2h", 128, 24), ("datatype", "128 is no type of a grey pixel")
    yield "NIfTI: half a label", "a.nii", nifti([[0, 0.5]], "f"), ("has a pixel of value 0.5, which is no label",)


def masks():
    yield "nothing in it", "a.png", IMAGES["a.png"], ("has nothing drawn: all its pixels are alike",)
    yield "cut", "a.mha", IMAGES["a.mha"][:-100], ("the pixels are truncated: 924 of 1024 bytes are there",)
    yield "no image", "a.bmp", "BM", ("the BMP file of 2 bytes is truncated or damaged",)


def toothlabels():
    own = json.dumps({"jaw": "upper", "labels": [11, 11, 12, 12, 0, 0, 21, 21, 0, 0, 0, 0]})
    yield "as they are", "a.json", own, READ
    yield "fewer than points", "a.json", edit(own, "[11, 11, ", "[11, "), ("labels", "has 11 labels, the mesh 12 points")
    yield "more than points", "a.json", edit(own, "[11, 11, ", "[11, 11, 11, "), ("labels", "has 13 labels, the mesh 12 points")
    yield "a label that is no tooth", "a.json", edit(own, "[11, ", "[19, "), ("labels[0]", "is 19, which is no tooth's FDI number")
    yield "a negative label", "a.json", edit(own, "[11, ", "[-11, "), ("labels[0]", "is -11.0, expected a whole number from 0 to 255")
    yield "half a label", "a.json", edit(own, "[11, ", "[11.5, "), ("labels[0]", "is 11.5, expected a whole number from 0 to 255")
    yield "a label is a word", "a.json", edit(own, "[11, ", '["tooth", '), ("labels[0]", 'is "tooth", expected a number')
    yield "no labels", "a.json", '{"jaw": "upper"}', ("labels", "missing field")
    yield "labels are an object", "a.json", '{"labels": {}}', ("labels", "is an object, expected an array")
    yield "a jaw that is none", "a.json", edit(own, '"upper"', '"middle"'), ("jaw", 'is "middle"')
    yield "cut", "a.json", cut(own, 0.5), ("line 1, column 36", "JSON syntax error: while parsing value - unexpected end")
    yield "of a scan of other points", "a.vtk", SCANS["a.vtk"], ("has no tooth labels: no point array Universal_ID",)
    yield "a scan without labels", "a.vtk", SCANS["a.vtk"][: SCANS["a.vtk"].index("POINT_DATA")], ("has no tooth labels: no point array Universal_ID",)
    yield "a scan without labels as PLY", "a.ply", SCANS["text.ply"], ("has no tooth labels: no point array Universal_ID",)


def transforms():
    whole = seeds.TRANSFORM
    yield "as it is", "a.tfm", whole, READ
    yield "its first line is missing", "a.tfm", edit(whole, "#Insight Transform File V1.0\n", ""), READ
    yield "a type that is none", "a.tfm", edit(whole, "VersorRigid3DTransform", "FlexibleTransform"), ("holds a FlexibleTransform_double_3_3",)
    yield "no type", "a.tfm", edit(whole, "Transform: VersorRigid3DTransform_double_3_3\n", ""), ('is no transform: there is no line "Transform: " where',)
    yield "numbers of single precision", "a.tfm", edit(whole, "_double_", "_float_"), READ
    yield "a parameter too few", "a.tfm", edit(whole, "0 0 0 1 2 3", "0 0 0 1 2"), ("Parameters", "has 5 numbers, and such a transform 6")
    yield "a parameter too many", "a.tfm", edit(whole, "0 0 0 1 2 3", "0 0 0 1 2 3 4"), ("Parameters", "has 7 numbers, and such a transform 6")
    yield "a parameter is a word", "a.tfm", edit(whole, "0 0 0 1 2 3", "0 0 zero 1 2 3"), ("Parameters", '"zero" is no finite number')
    yield "a parameter is not a number", "a.tfm", edit(whole, "0 0 0 1 2 3", "0 0 nan 1 2 3"), ("Parameters", '"nan" is no finite number')
    yield "no parameters", "a.tfm", edit(whole, "Parameters: 0 0 0 1 2 3\n", ""), ('is no transform: there is no line "Parameters:" where',)
    yield "no fixed parameters", "a.tfm", edit(whole, "FixedParameters: 0 0 0\n", ""), ("is no whole transform",)
    yield "cut", "a.tfm", cut(whole, 0.7), ('is no transform: there is no line "Parameters:" where',)
    yield "empty", "a.tfm", "", ("the file is empty (0 bytes)",)
    yield "no text", "a.tfm", bytes(range(256)), ('is no transform: there is no line "Transform: " where',)


def cases(folder):
    """folder: of a case, whose files are there."""
    names = {field: str(folder / file) for field, file in (("upper", "upper.stl"), ("lower", "lower.stl"), ("contours", "contours.json"))}
    whole = json.dumps({**names, "cephalogram": {"image_size": [700, 900], "pixel_spacing_mm": [0.25, 0.25]},
                        "geometry": {"source_to_midsagittal_mm": 1524, "source_to_detector_mm": 1674}})

    def more(text):
        return edit(whole, '{"upper"', "{" + text + ', "upper"')

    yield "no case", "case.json", "{}", ("upper", 'neither "upper" nor "lower" is given')
    yield "no scan", "case.json", edit(whole, json.dumps({k: names[k] for k in ("upper", "lower")})[1:-1] + ", ", ""), ("upper", 'neither "upper" nor "lower" is given')
    yield "no tracing", "case.json", edit(whole, json.dumps({"contours": names["contours"]})[1:-1] + ", ", ""), ("contours", "missing, and so are cephalometric_landmarks")
    yield "a scan is a number", "case.json", edit(whole, json.dumps(names["upper"]), "3"), ("upper", "is 3.0, expected a string")
    yield "as it is", "case.json", whole, READ
    yield "a scan is not there", "case.json", edit(whole, "upper.stl", "upper.slt"), ("upper", 'there is no file "')
    yield "a scan is a folder", "case.json", edit(whole, names["upper"], str(folder)), ("upper", "is a folder")
    yield "a list", "case.json", "[" + whole + "]", ("is no JSON object",)
    yield "cut", "case.json", cut(whole, 0.5), ("line ", "JSON syntax error")
    yield "a spacing of 0", "case.json", edit(whole, "[0.25, 0.25]", "[0, 0.25]"), ("cephalogram.pixel_spacing_mm", "0 mm a pixel is not possible")
    yield "a negative spacing", "case.json", edit(whole, "[0.25, 0.25]", "[0.25, -0.25]"), ("cephalogram.pixel_spacing_mm", "-0.25 mm a pixel is not possible")
    yield "one spacing", "case.json", edit(whole, "[0.25, 0.25]", "0.25"), ("cephalogram.pixel_spacing_mm", "is 0.25, expected 2 numbers [u, v]")
    yield "a spacing of 300 digits", "case.json", edit(whole, "[0.25, 0.25]", "[0.25, 1e300]"), ("cephalogram.pixel_spacing_mm", "1e+300 mm a pixel is not possible")
    yield "a spacing of metres", "case.json", edit(whole, "[0.25, 0.25]", "[250, 250]"), ("cephalogram.pixel_spacing_mm", "250 mm a pixel is not possible")
    yield "a detector before the patient", "case.json", edit(whole, "1674", "1000"), ("geometry.source_to_detector_mm", "the detector is not behind the midsagittal plane")
    yield "a negative distance", "case.json", edit(whole, "1524", "-1524"), ("geometry.source_to_midsagittal_mm", "-1524 mm is not possible")
    yield "a distance of words", "case.json", edit(whole, "1524", '"1524 mm"'), ("geometry.source_to_midsagittal_mm", 'is "1524 mm", expected a number')
    yield "a unit that is none", "case.json", more('"mesh_unit": "foot"'), ("mesh_unit", '"foot" is no mesh unit ("mm", "cm", "inch", "m" or "um")')
    yield "a side that is none", "case.json", more('"traced_side": "top"'), ("traced_side", '"top" is no traced side ("right", "left", "mean"')
    yield "a numbering that is none", "case.json", more('"numbering": "palmer"'), ("numbering", '"palmer" is no numbering ("UR", "FDI" or "universal")')
    yield "an occlusion that is none", "case.json", more('"occlusion": "maybe"'), ("occlusion", '"maybe" does not say whether the jaws are in occlusion')
    yield "a tooth to leave out that is none", "case.json", more('"exclude": ["UR9"]'), ("exclude[0]", '"UR9" is no tooth code (UR1-UR8, UL, LL, LR, or digits')
    yield "something to hold that is none", "case.json", more('"fix": ["everything"]'), ("fix[0]", "\"everything\" can't be fixed (\"scale\", \"rotation\" or")
    yield "crowns that are none", "case.json", more('"crowns": "most"'), ("crowns", '"most" does not say how to find crowns ("off", "labels"')
    yield "a start that is no rotation", "case.json", more('"init": {"pose": [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0]]}'), ("init.pose", "its rotation is not orthonormal")
    yield "a start of two rows", "case.json", more('"init": {"pose": [[1, 0, 0, 0], [0, 1, 0, 0]]}'), ("init.pose", "is no 3x4 matrix")
    yield "a start with a negative scale", "case.json", more('"init": {"similarity": {"scale": -1, "translation_px": [0, 0]}}'), ("init.similarity.scale", "-1 is not positive")
    yield "views that are an object", "case.json", more('"views": {}'), ("views", "is no list")
    yield "a view without a direction", "case.json", more('"views": [{"name": "a", "contours": "c.json"}]'), ("views[0].direction", "missing field")
    yield "a view with a direction that is none", "case.json", more('"views": [{"direction": "oblique", "contours": "c.json"}]'), ("views[0].direction", '"oblique" is neither "lateral" nor "frontal"')
    yield "a view with the name of a path", "case.json", more('"views": [{"name": "../x", "direction": "frontal", "contours": "c.json"}]'), ("views[0].name", "is no short name")
    yield "a view with nothing drawn", "case.json", more('"views": [{"direction": "frontal", "cephalogram": {"image_size": [9, 9]}}]'), ("views[0]", "has neither contours nor cephalometric_landmarks")
    yield "an image's size that is none", "case.json", edit(whole, "[700, 900]", "[700, -900]"), ("cephalogram.image_size[1]", "is -900.0, expected a whole number from 1 to 1000000")
    yield "facing up", "case.json", edit(whole, '"image_size"', '"facing": "up", "image_size"'), ("cephalogram.facing", '"up" is neither "right" nor "left"')
    yield "a source in front", "case.json", edit(whole, '"source_to_detector_mm"', '"source_side": "front", "source_to_detector_mm"'), ("geometry.source_side", '"front" is neither "right" nor "left"')
    yield "a principal point of words", "case.json", edit(whole, '"source_to_detector_mm"', '"principal_point_px": ["a", 2], "source_to_detector_mm"'), ("geometry.principal_point_px[0]", 'is "a", expected a number')


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
    yield "cut", "result.json", cut(whole, 0.5), ("line ", "JSON syntax error")
    yield "another schema", "result.json", whole.replace('"dentalscr-result/1"', '"dentalscr-result/9"', 1), ("schema", 'is "dentalscr-result/9", and this version reads')
    yield "no schema", "result.json", changed(lambda copy: copy.pop("schema")), ("schema", "missing: this is no result of dentalscr")
    yield "no jaws", "result.json", changed(lambda copy: copy.pop("jaws")), ("jaws", "missing field")
    yield "jaws are a list", "result.json", changed(lambda copy: copy.update(jaws=[])), ("jaws", "is an array of 0, expected an object")
    yield "a status that is none", "result.json", changed(lambda copy: copy["jaws"]["upper"].update(status="splendid")), ("jaws.upper.status", '"splendid" is no status')
    yield "no matrix", "result.json", changed(lambda copy: copy["jaws"]["upper"].pop("projection_3x4")), READ
    yield "a matrix of two rows", "result.json", changed(matrix(root["jaws"]["upper"]["projection_3x4"][:2])), ("jaws.upper.projection_3x4", "has 2 rows, not 3")
    yield "a matrix of words", "result.json", changed(matrix([["a"] * 4] * 3)), ("jaws.upper.projection_3x4[0][0]", 'is "a", expected a number')
    yield "a matrix of nulls", "result.json", changed(matrix([[None] * 4] * 3)), ("jaws.upper.projection_3x4[0][0]", "is null, expected a number")
    yield "a number alone", "result.json", "1", ("schema", "missing: this is no result of dentalscr")
    yield "another file of the toolkit", "result.json", CONTOURS["own.json"], ("schema", "missing: this is no result of dentalscr")


def batches():
    yield "empty", "a.csv", "", ("the file is empty (0 bytes)",)
    yield "a header alone", "a.csv", "id,case\n", ("has no row of a case",)
    yield "no column of a case", "a.csv", "name,age\na,1\n", ('has neither a column "case" nor columns of options',)
    yield "a cell too many", "a.csv", "id,case\na,b.json,c\n", ("row 2", "has 3 cells under 2 names")
    yield "a case without a file", "a.csv", "id,case\na,\n", ("row 2", "has no case")
    yield "a row of options that are empty", "a.csv", "id,upper\na,u.stl\na,\n", ("row 3", "names nothing of a case")
    yield "a name twice", "a.csv", "id,case\na,b.json\na,c.json\n", ("a", "is the name of two cases")
    yield "a name that is a path", "a.csv", "id,case\n../a,b.json\n", ("row 2", "the id \"../a\" can't be a folder's name")
    yield "a name that is a folder's own", "a.csv", "id,case\n..,b.json\n", ("row 2", "the id \"..\" can't be a folder's name")
    yield "a name of 300 letters", "a.csv", "id,case\n" + "a" * 300 + ",b.json\n", ("row 2", "the id")
    yield "a column twice", "a.csv", "case,case\na.json,b.json\n", ("row 1", 'has two columns "case"')
    yield "a quote is not closed", "a.csv", 'id,case\n"a,b.json\n', ("row 2", "a quotation mark that is never closed")
    yield "a quote that swallows rows", "a.csv", 'id,case,note\na,a.json,"x\nb,b.json,\n', ("row 2", "never closed")
    yield "bytes of no text", "a.csv", bytes(range(256)), ("is no text: it has bytes of zero",)
    yield "UTF-16", "a.csv", "id,case\na,b.json\n".encode("utf-16"), ("is UTF-16",)
    yield "Latin-1", "a.csv", "id,case\nMüller,b.json\n".encode("latin-1"), ("row 2", "not UTF-8")
    yield "a name of a table", "a.csv", "id,case\nsummary.csv,b.json\n", ("row 2", "the id")
    yield "no names", "a.csv", "case\na.json\nb.json\n", READ
    yield "lines end as on Windows", "a.csv", "id;case\r\na;b.json\r\n", READ


def archives():
    """Of the index in an archive of WebCeph."""
    whole = seeds.webceph()
    yield "as it is", "index.json", whole, READ
    yield "another version", "index.json", edit(whole, '"version": 1', '"version": 2'), ("version", "is not 1, the version of WebCeph's files")
    yield "no version", "index.json", edit(whole, '"version": 1, ', ""), ("version", "missing field")
    yield "a version that is a word", "index.json", edit(whole, '"version": 1', '"version": "1"'), ("version", 'is "1", expected a number')
    yield "no pictures", "index.json", '{"version": 1, "data": {}}', ("data", "has no landmarks on a cephalogram")
    yield "pictures are a list", "index.json", '{"version": 1, "data": []}', ("data", "is an array of 0, expected an object")
    yield "a picture without a tracing", "index.json", '{"version": 1, "data": {"a": {}}}', ("data.a.tracing", "missing field")
    yield "a coordinate is a word", "index.json", edit(whole, '"x": 20.5', '"x": "20"'), ("data.image_1.tracing.manualLandmarks.U1.x", 'is "20", expected a number')
    yield "a coordinate is null", "index.json", edit(whole, '"x": 20.5', '"x": null'), ("data.image_1.tracing.manualLandmarks.U1.x", "is null, expected a number")
    yield "a coordinate is beyond all radiographs", "index.json", edit(whole, '"x": 20.5', '"x": 4e9'), ("U1", "4e+09")
    yield "mirrored is a number", "index.json", edit(whole, '"flipX": false', '"flipX": 1'), ("data.image_1.flipX", "is 1.0, expected")
    yield "cut", "index.json", cut(whole, 0.5), ("JSON syntax error",)
    yield "deeper than a stack", "index.json", seeds.nested('{"version": 1, "data": ', "}"), ("data", "is nested deeper than 64 levels")


def packed():
    """The archives themselves."""
    for name, content in (("packed", seeds.archive(seeds.webceph())), ("stored", seeds.archive(seeds.webceph(), zipfile.ZIP_STORED))):
        yield f"{name}: as it is", "a.wceph", content, READ
        yield f"{name}: cut in its directory", "a.wceph", content[:-30], ("index.json", "cannot be found: the archive is damaged or not complete")
        at = content.index(b"index.json") + 30
        yield f"{name}: a byte of its index is another one", "a.wceph", content[:at] + bytes([content[at] ^ 0x55]) + content[at + 1 :], ("index.json", "cannot be unpacked: the archive is damaged")
        entry = content.rindex(b"PK\x01\x02")
        yield f"{name}: its index is said to have 4 GB", "a.wceph", put(content, entry + 24, "<I", 4294967294), ("index.json", "has 4294967294 bytes, more than any has")
        yield f"{name}: its index is said to be encrypted", "a.wceph", put(content, entry + 8, "<H", 1), ("index.json", "is encrypted")
        yield f"{name}: its packing is none", "a.wceph", put(content, entry + 10, "<H", 99), ("index.json", "cannot be unpacked: the archive is damaged")
        yield f"{name}: its index begins behind the end", "a.wceph", put(content, entry + 42, "<I", 10**6), ("index.json", "cannot be unpacked: the archive is damaged")
    content = seeds.archive(seeds.webceph())
    yield "its index has another name", "a.wceph", content[: content.rindex(b"index.json")] + b"index.jsom" + content[content.rindex(b"index.json") + 10 :], ("index.json", "is missing in the archive")


def levels():
    yield "short", "a.json", '{"level": "hard", "head": {"turn_deg": 3}}', READ
    yield "a level that is none", "a.json", '{"level": "impossible"}', ("level", '"impossible" is no level of the phantom')
    yield "a level that is a number", "a.json", '{"level": 3}', ("level", "is 3.0, expected a string")
    yield "a section that is none", "a.json", '{"feet": {}}', ("feet", "is no section of the phantom's parameters")
    yield "a section that is a number", "a.json", '{"head": 3}', ("head", "is 3.0, expected an object")
    yield "a parameter that is none", "a.json", '{"head": {"hat": 1}}', ("head.hat", "is no parameter of the phantom")
    yield "a parameter out of its range", "a.json", '{"head": {"turn_deg": 1e6}}', ("head.turn_deg", "1e+06 is out of range")
    yield "a parameter that is a word", "a.json", '{"head": {"turn_deg": "much"}}', ("head.turn_deg", 'is "much", expected a number')
    yield "a flag that is a number", "a.json", '{"machine": {"known": 1}}', ("machine.known", "is 1.0, expected")
    yield "a word that is none", "a.json", '{"radiograph": {"style": "cubist"}}', ("radiograph.style", '"cubist" is no value of it')
    yield "no object", "a.json", "[]", ("is no JSON object",)
    yield "deeper than a stack", "a.json", seeds.nested('{"head": ', "}"), ("head", "is nested deeper than 64 levels")


def drawings():
    own = CONTOURS["own.json"]
    yield "as it is", "a.json", own, READ
    yield "of another program", "a.json", CONTOURS["labelme.json"], READ
    # The toolkit's own file is told as it is, and the page says what register would refuse.
    yield "of a tooth that is none", "a.json", edit(own, '"UR1"', '"UR19"'), READ
    yield "deeper than a stack", "a.json", seeds.nested('{"contours": {"upper": ', "}}"), ("contours.upper", "is nested deeper than 64 levels")
    yield "no drawing", "a.json", '{"a": 1}', ("contours", "JSON in no form that is known")
    yield "cut", "a.json", cut(own, 0.5), ("JSON syntax error",)
    yield "a table cut", "a.csv", "label,x\n", ("line 1", "has 2 columns, expected label,x,y")


def sessions():
    drawn = '{"contours": ' + CONTOURS["own.json"] + ', "landmarks": {"U1_tip": [20, 30]}}'
    yield "as it is", "a.json", drawn, READ
    yield "nothing drawn", "a.json", "{}", READ
    yield "no object", "a.json", "[]", ("is no JSON object",)
    yield "no JSON", "a.json", "drawing", ("JSON syntax error",)
    yield "a tooth that is none", "a.json", edit(drawn, '"UR1"', '"UR19"'), ("contours.upper[0].code", '"UR19" is no tooth')
    yield "a landmark far outside", "a.json", edit(drawn, "[20, 30]", "[2000, 30]"), ("U1_tip", "lies far outside the image of 50 x 50 pixels")
    yield "a landmark that is a word", "a.json", edit(drawn, "[20, 30]", '"here"'), ("U1_tip", 'is "here"')
    yield "of another picture", "a.json", edit(drawn, '"image_size": [50, 50]', '"image_size": [60, 50]'), ("image_size", "is 60 x 50, but the image is 50 x 50")
    yield "deeper than a stack", "a.json", seeds.nested('{"contours": {"contours": ', "}}"), ("contours.contours", "is nested deeper than 64 levels")


def starts(result):
    yield "a similarity", "a.json", '{"similarity": {"translation_px": [3, 4]}}', READ
    yield "a result", "result.json", result, READ
    yield "no translation", "a.json", '{"similarity": {"scale": 1}}', ("similarity.translation_px", "missing field")
    yield "a scale of 0", "a.json", '{"similarity": {"scale": 0, "translation_px": [3, 4]}}', ("similarity.scale", "is not positive")
    yield "a translation of three", "a.json", '{"similarity": {"translation_px": [3, 4, 5]}}', ("similarity.translation_px", "is an array of 3, expected 2 numbers")
    yield "a pose of two rows", "a.json", '{"pose": [[1, 0, 0, 0], [0, 1, 0, 0]]}', ("pose", "is no 3x4 matrix")
    yield "a pose that stretches", "a.json", '{"pose": [[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}', ("pose", "its rotation is not orthonormal")
    yield "a pose that mirrors", "a.json", '{"pose": [[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}', ("pose", "mirrors the mesh")
    yield "no object", "a.json", "[]", ("is an array of 0, expected an object",)
    yield "a result of another version", "result.json", result.replace('"dentalscr-result/1"', '"dentalscr-result/9"', 1), ("schema", 'is "dentalscr-result/9"')
    yield "deeper than a stack", "a.json", seeds.nested('{"pose": ', "}"), ("pose", "is nested deeper than 64 levels")


def summaries():
    row = '{"case": "a", "jaw": "upper", "status": "ok", "findings": [], "matched_px": 1, "expected_error_px": null, "message": "", "seconds": 1}'
    whole = '{"schema": "dentalscr-batch/1", "rows": [%s]}' % row
    yield "as it is", "summary.json", whole, READ
    yield "another schema", "summary.json", edit(whole, "batch/1", "batch/2"), ("schema", 'is not "dentalscr-batch/1"')
    yield "no rows", "summary.json", '{"schema": "dentalscr-batch/1"}', ("rows", "missing field")
    yield "rows are an object", "summary.json", '{"schema": "dentalscr-batch/1", "rows": {}}', ("rows", "is an object, expected an array")
    yield "a row without a case", "summary.json", edit(whole, '"case": "a", ', ""), ("rows[0].case", "missing field")
    yield "a row without a status", "summary.json", edit(whole, '"status": "ok", ', ""), ("rows[0].status", "missing field")
    yield "a time that is a word", "summary.json", edit(whole, '"seconds": 1', '"seconds": "1"'), ("rows[0].seconds", 'is "1", expected a number')
    yield "an error that is a word", "summary.json", edit(whole, '"expected_error_px": null', '"expected_error_px": "?"'), ("rows[0].expected_error_px", 'is "?", expected a number')
    yield "a finding that is a number", "summary.json", edit(whole, '"findings": []', '"findings": [1]'), ("rows[0].findings[0]", "is 1.0, expected a string")
    yield "cut", "summary.json", cut(whole, 0.5), ("JSON syntax error",)
    yield "deeper than a stack", "summary.json", seeds.nested('{"schema": ', "}"), ("schema", "is nested deeper than 64 levels")


def reports(result, details):
    """In two lines: a result and what a report draws of it."""
    result, details = (json.dumps(json.loads(text)) for text in (result, details))
    yield "as they are", "a.txt", result + "\n" + details, READ
    yield "without details", "a.txt", result, READ
    yield "another result's schema", "a.txt", edit(result, "dentalscr-result/1", "dentalscr-result/9"), ("schema", 'is not "dentalscr-result/1"')
    yield "another schema of details", "a.txt", result + "\n" + edit(details, "dentalscr-report/1", "dentalscr-report/9"), ("schema", 'is not "dentalscr-report/1"')
    yield "no details", "a.txt", result + "\nnone", ("JSON syntax error",)
    yield "no views in the details", "a.txt", result + '\n{"schema": "dentalscr-report/1"}', ("is not as this version writes it",)
    yield "a view that is a number", "a.txt", result + '\n{"schema": "dentalscr-report/1", "views": [1]}', ("is not as this version writes it",)
    yield "a result without jaws", "a.txt", '{"schema": "dentalscr-result/1"}', ("is not as this version writes it",)
    yield "deeper than a stack", "a.txt", result + "\n" + seeds.nested('{"schema": "dentalscr-report/1", "views": ', "}"), ("views", "is nested deeper than 64 levels")


def folders():
    """Each in a folder of its own, where it is told what it is, or that it is nothing."""
    for name, content in (("upper.stl", SCANS["binary.stl"]), ("a.json", CONTOURS["own.json"]), ("a.wceph", seeds.archive(seeds.webceph())), ("cut.wceph", cut(seeds.archive(seeds.webceph()), 0.5)),
                          ("a.dcm", dicom(32, 32, bytes(1024))[:200]), ("cut.json", cut(CONTOURS["own.json"], 0.5)), ("deep.json", seeds.nested()), ("a.png", "no picture"), ("a", bytes(range(256)))):
        yield name, name, content, READ


def damaged(result, folder):
    """result: text of a result.json; folder: of a whole case. \\return of each reader its files: (what is wrong, name of the file, content, words of the error or READ)."""
    details = (folder.parent / "result" / "report.json").read_text()
    return {
        "archive": list(archives()),
        "drawing": list(drawings()),
        "folder": list(folders()),
        "level": list(levels()),
        "report": list(reports(result, details)),
        "session": list(sessions()),
        "start": list(starts(result)),
        "summary": list(summaries()),
        "batch": list(batches()),
        "case": list(cases(folder)),
        "cephalometric": [*cephalometric(), *packed()],
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

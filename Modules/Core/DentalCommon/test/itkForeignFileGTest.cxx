/*=========================================================================
 *
 *  Copyright The DentalSCR authors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#include "itkForeignFile.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

using Purpose = itk::FilePurposeEnum;

namespace
{
/** The refusal in words, or "" where the file is let through. */
std::string
Refusal(const std::string & name, const std::string & content, Purpose purpose)
{
  const std::string path = itk::WriteTestFile(name, content);
  try
  {
    itk::RefuseForeignFile(path, purpose);
  }
  catch (const itk::DentalInputError & error)
  {
    return error.GetProblem() + "; " + error.GetRemedy();
  }
  return "";
}

const std::string Hps =
  "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- 3Shape -->\n<HPS version=\"1.1\"><Packed_geometry>"
  "<Schema>CE</Schema></Packed_geometry></HPS>";
const std::string Workbook =
  std::string("PK\x03\x04\x14\0\x06\0", 8) + "[Content_Types].xml" + std::string(20, '\0') + "xl/workbook.xml";

/** A header that begins with its length. */
std::string
NIfTI(unsigned int length, std::size_t place, const char * magic, bool bigEndian)
{
  std::string header(length, '\0');
  header[bigEndian ? 3 : 0] = static_cast<char>(length & 0xffu);
  header[bigEndian ? 2 : 1] = static_cast<char>(length >> 8);
  return header.replace(place, 3, magic);
}
} // namespace

TEST(ForeignFile, IsNamedForWhatItIsWithWhatToExportInstead)
{
  struct Row
  {
    const char * name;
    std::string  content;
    const char * is;
    const char * remedy;
  };
  const Row rows[] = {
    { "upper.dcm", Hps, "3Shape", "STL or PLY" },
    { "points.xlsx", Workbook, "Excel", "CSV" },
    { "scan.zip", std::string("PK\x03\x04\x14\0\0\0", 8) + "upper.stl", "ZIP", "unpack" },
    { "case.wceph", std::string("PK\x03\x04\x14\0\0\0", 8) + "index.json", "WebCeph", "cephalometric_landmarks" },
    // Its pictures come first, and the directory is at the end.
    { "big.wceph", "PK\x03\x04" + std::string(9000, 'x') + "index.json", "WebCeph", "cephalometric_landmarks" },
    { "old.xls", "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "Excel", "CSV" },
    { "trace.svg", "<?xml version='1.0'?>\n<!DOCTYPE svg>\n<svg width='10'>", "SVG", "labelme" },
    { "report.pdf", "%PDF-1.7\n", "PDF", "name the" },
    { "page.html", "\n<!DOCTYPE HTML>\n<html>", "web page", "download" },
    { "drawing.dxf", "  0\r\nSECTION\r\n  2\r\nENTITIES\r\n", "DXF", "name the" },
    { "tooth.roi", std::string("Iout\0\xe4", 6), "ImageJ", "CSV" },
    { "points.npy", "\x93NUMPY\x01", "NumPy", "name the" },
    { "points.mat", "MATLAB 5.0 MAT-file, Platform: PCWIN64", "MATLAB", "CSV" },
    { "ceph.webp", std::string("RIFF\x10\0\0\0WEBPVP8L", 16), "WebP", "PNG" },
    { "ceph.heic", std::string("\0\0\0\x18", 4) + "ftypheic", "HEIC", "PNG" },
    { "phone.heic", std::string("\0\0\0\x18", 4) + "ftypmif1", "HEIC", "PNG" },
    { "ceph.avif", std::string("\0\0\0\x20", 4) + "ftypavif", "AVIF", "PNG" },
    { "ceph.jp2", std::string("\0\0\0\x0c", 4) + "jP  \r\n", "JPEG 2000", "PNG" },
    { "ceph.psd", std::string("8BPS\0\1", 6), "Photoshop", "PNG" },
    { "ceph.xcf", "gimp xcf v011", "GIMP", "PNG" },
    { "upper.stl", "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\n", "not downloaded", "git lfs" },
    { "F.fcsv", "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n", ".fcsv", ".mrk.json" },
    { "upper.ctm", std::string("OCTM\5\0\0\0MG2\0", 12), "OpenCTM", "STL, PLY or OBJ" },
    { "upper.stp", "ISO-10303-21;\nHEADER;\n", "STEP", "STL, PLY or OBJ" },
    { "upper.fbx", std::string("Kaydara FBX Binary  \0\x1a\0", 23), "FBX", "STL, PLY or OBJ" },
    { "ascii.fbx", "; FBX 7.4.0 project file\n", "FBX", "STL, PLY or OBJ" },
    { "upper.dae", "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"x\" version=\"1.4.1\">", "Collada", "STL, PLY or OBJ" },
    { "upper.x3d", "<?xml version=\"1.0\"?><X3D version='3.3'>", "X3D", "STL, PLY or OBJ" },
    { "upper.amf", "<?xml version=\"1.0\"?><amf unit=\"millimeter\">", "AMF", "STL, PLY or OBJ" },
    { "upper.wrl", "#VRML V2.0 utf8\n", "VRML", "STL, PLY or OBJ" },
    { "scene.blend", "BLENDER-v300", "Blender", "STL, PLY or OBJ" },
    { "export.ndjson", "{\"data_row\":{\"id\":\"c\"},\"projects\":{}}", "Labelbox", "COCO" },
    { "more.ndjson", "{\"id\":1,\"data_row\":{}}\n{\"id\":2,\"data_row\":{}}\n", "Labelbox", "COCO" },
    { "lines.jsonl", "{\"a\": 1}\r\n\r\n{\"a\": 2}\r\n", "NDJSON", "COCO" },
    { "pair.hdr", NIfTI(348, 344, "ni1", false), "another file (.img)", "in one file (.nii" },
    { "big.hdr", NIfTI(348, 344, "ni1", true), "another file (.img)", "in one file (.nii" },
    { "two.nii", NIfTI(540, 4, "n+2", false), "a NIfTI-2 image", "NIfTI-1" },
    { "two.hdr", NIfTI(540, 4, "ni2", true), "a NIfTI-2 header", "NIfTI-1" },
    { "scan.stl.gz", std::string("\x1f\x8b\x08\x08\0\0\0\0\2\xffscan.stl\0\xab", 20), "gzip", "unpack" },
  };
  for (const Row & row : rows)
  {
    for (const Purpose purpose : { Purpose::Scan, Purpose::Tracing, Purpose::Landmarks, Purpose::Radiograph })
    {
      const std::string refusal = Refusal(row.name, row.content, purpose);
      EXPECT_TRUE(itk::Contains(refusal, row.is)) << row.name << ": " << refusal;
      EXPECT_TRUE(itk::Contains(refusal, row.remedy)) << row.name << ": " << refusal;
    }
  }
}

TEST(ForeignFile, WhatServesThePurposeIsLetThrough)
{
  EXPECT_EQ(Refusal("contours.json", "{\"contours\": {}}", Purpose::Tracing), "");
  EXPECT_EQ(Refusal("labels.png", "\x89PNG\r\n\x1a\n", Purpose::Tracing), "");
  EXPECT_EQ(Refusal("upper.ply", "ply\nformat ascii 1.0\n", Purpose::Scan), "");
  EXPECT_EQ(Refusal("upper.vtp", "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\">", Purpose::Scan), "");
  EXPECT_EQ(Refusal("cvat.xml", "<?xml version=\"1.0\"?>\n<annotations>", Purpose::Landmarks), "");
  EXPECT_EQ(Refusal("upper.stl", std::string(84, '\0'), Purpose::Scan), "");
  EXPECT_EQ(Refusal("empty", "", Purpose::Scan), "");
  // JSON in many lines, and a document in one.
  EXPECT_EQ(Refusal("pretty.json", "{\n  \"contours\": {}\n}\n", Purpose::Tracing), "");
  EXPECT_EQ(Refusal("one.json", "{\"contours\": {}}\n", Purpose::Tracing), "");
  EXPECT_EQ(Refusal("inner.json", "{\"contours\": {},\n{", Purpose::Tracing), "");
  for (const Purpose purpose : { Purpose::Tracing, Purpose::Radiograph })
  {
    EXPECT_EQ(Refusal("labels.nii", NIfTI(348, 344, "n+1", false), purpose), "");
    EXPECT_EQ(Refusal("Labels.NII.gz", std::string("\x1f\x8b\x08\0\0\0\0\0\2\xff\xab", 11), purpose), "");
  }
  // A length alone makes no NIfTI.
  EXPECT_EQ(Refusal("few.stl", NIfTI(348, 344, "abc", false), Purpose::Scan), "");
  // No WebP, though it begins as one.
  EXPECT_EQ(Refusal("sound.wav", std::string("RIFF\x10\0\0\0WAVE", 12), Purpose::Scan), "");
  // What is missing is for the reader to say.
  EXPECT_NO_THROW(itk::RefuseForeignFile(itk::TestFolder() + "/no_such_file", Purpose::Scan));
}

TEST(ForeignFile, WhatServesAnotherPurposeIsNamed)
{
  EXPECT_TRUE(itk::Contains(Refusal("a", "\x89PNG\r\n\x1a\n", Purpose::Scan), "a PNG picture, no scan"));
  EXPECT_TRUE(itk::Contains(Refusal("b", "{\"contours\": {}}", Purpose::Radiograph), "a JSON file, no radiograph"));
  EXPECT_TRUE(itk::Contains(Refusal("c", "ply\nformat ascii 1.0\n", Purpose::Tracing), "a PLY mesh, no tracing"));
  for (const Purpose purpose : { Purpose::Scan, Purpose::Landmarks })
  {
    EXPECT_TRUE(itk::Contains(Refusal("labels.nii", NIfTI(348, 344, "n+1", true), purpose), "a NIfTI image, no "));
    EXPECT_TRUE(itk::Contains(Refusal("L.NII.gz", std::string("\x1f\x8b\x08\0\0\0\0\0\2\xff\xab", 11), purpose),
                              "a NIfTI image (.nii.gz), no "));
    // The name that gzip notes inside.
    EXPECT_TRUE(
      itk::Contains(Refusal("renamed.gz", std::string("\x1f\x8b\x08\x08\0\0\0\0\2\xfflabels.nii\0\xab", 22), purpose),
                    "a NIfTI image"));
  }
  EXPECT_TRUE(itk::Contains(Refusal("d", std::string(128, '\0') + "DICM" + std::string(10, '\0'), Purpose::Scan),
                            "a DICOM image"));
}

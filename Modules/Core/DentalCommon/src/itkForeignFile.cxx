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

#include "itkDentalInputError.h"
#include "itkInputFile.h"
#include "itkLowerCase.h"
#include "itkReadFileTail.h"


namespace itk
{
namespace
{
/** Where a kind's signature stands. */
enum class PlaceEnum : uint8_t
{
  /** The file's first bytes. */
  Start,
  /** Behind four bytes, which say how long the first part is. */
  BehindLength,
  /** Behind eight bytes: four of RIFF, and the file's length. */
  InRIFF,
  /** The first bytes behind blanks and a byte order mark, in lower case. */
  Text,
  /** The first element of XML, whatever its prolog, in lower case. */
  Element,
  /** Anywhere in the first bytes of a ZIP archive, or in its directory, which is at its end. */
  Archive,
  /** At the end of the name of a file that is compressed by gzip, with ".gz" or without it as gzip notes it inside. */
  Compressed,
  /** Anywhere in the first bytes of a text of JSON objects, one a line. */
  JsonLines,
  /** Where NIfTI of that version has its signature, which also tells whether its pixels are in the same file. */
  NIfTI
};

/** Bits of purposes that a kind cannot serve. */
constexpr unsigned int Scan = 1;
constexpr unsigned int Radiograph = 2;
constexpr unsigned int Tracing = 4;
constexpr unsigned int Landmarks = 8;
constexpr unsigned int Drawn = Tracing | Landmarks;
constexpr unsigned int Any = 15;

struct Kind
{
  PlaceEnum    place;
  std::string  signature;
  unsigned int refused;
  const char * name;
  /** What to do about it; null: what the purpose wants. */
  const char * remedy;
};

const std::string Nul(1, '\0');

/** What to do about meshes of other kinds. */
constexpr const char * ExportMesh = "export STL, PLY or OBJ";
/** And about images of NIfTI that are not read. */
constexpr const char * SaveImage =
  "save it as NIfTI-1 in one file (.nii, .nii.gz), as NRRD or PNG, in the radiograph's pixel grid";

/** In the order in which they are tried. */
const Kind Kinds[] = {
  { PlaceEnum::Element,
    "hps",
    Any,
    "a 3Shape scan (HPS; no DICOM in spite of its name)",
    "export the scan from the 3Shape software as STL or PLY: HPS is closed and often encrypted" },
  { PlaceEnum::Archive, "xl/", Any, "an Excel workbook", "save the sheet as CSV with the columns label,x,y" },
  { PlaceEnum::Archive, "[content_types].xml", Any, "an Office document", "save a table as CSV (label,x,y)" },
  { PlaceEnum::Archive, "3d/3dmodel.model", Any, "a 3MF model", "export STL or PLY" },
  { PlaceEnum::Archive,
    "index.json",
    Any,
    "a ZIP archive with an index.json, such as WebCeph's .wceph",
    "a .wceph has landmarks of an analysis: name it as cephalometric_landmarks; else unpack it and name the file in "
    "it" },
  { PlaceEnum::Start, "PK\x03\x04", Any, "a ZIP archive", "unpack it and name the file in it" },
  { PlaceEnum::Start, "Rar!", Any, "a RAR archive", "unpack it and name the file in it" },
  { PlaceEnum::Start, "7z\xbc\xaf\x27\x1c", Any, "a 7-Zip archive", "unpack it and name the file in it" },
  { PlaceEnum::Compressed, ".nii", Scan | Landmarks, "a NIfTI image (.nii.gz)", nullptr },
  { PlaceEnum::NIfTI, "n+1", Scan | Landmarks, "a NIfTI image", nullptr },
  { PlaceEnum::NIfTI, "ni1", Any, "a NIfTI header, whose pixels are in another file (.img)", SaveImage },
  { PlaceEnum::NIfTI, "n+2", Any, "a NIfTI-2 image", SaveImage },
  { PlaceEnum::NIfTI, "ni2", Any, "a NIfTI-2 header, whose pixels are in another file (.img)", SaveImage },
  { PlaceEnum::Start, "\x1f\x8b", Any, "a gzip archive", "unpack it and name the file in it" },
  { PlaceEnum::Start, "\xd0\xcf\x11\xe0", Any, "an old Excel or Office document", "save the table as CSV (label,x,y)" },
  { PlaceEnum::Start, "%PDF", Any, "a PDF document", nullptr },
  { PlaceEnum::Element,
    "svg",
    Any,
    "an SVG drawing",
    "trace in labelme, CVAT or 3D Slicer, or save one mask image a tooth (PNG)" },
  { PlaceEnum::Element, "html", Any, "a web page", "download the file itself" },
  { PlaceEnum::Text, "<!doctype html", Any, "a web page", "download the file itself" },
  { PlaceEnum::Text, "# markups fiducial file", Any, "Slicer's old .fcsv table", "save the markups as .mrk.json" },
  { PlaceEnum::Text,
    "lm=",
    Drawn,
    "a TPS file (tpsDig)",
    "write lines label,x,y (CSV), with y from the picture's upper edge: tpsDig counts from the lower one" },
  { PlaceEnum::Text, "0\nsection", Any, "a DXF drawing", nullptr },
  { PlaceEnum::Text, "0\r\nsection", Any, "a DXF drawing", nullptr },
  { PlaceEnum::Start, "Iout", Any, "an ImageJ region (.roi)", "save its points as CSV with the columns label,x,y" },
  { PlaceEnum::Start, "\x93NUMPY", Any, "a NumPy array", nullptr },
  { PlaceEnum::Start,
    "MATLAB 5.0",
    Any,
    "a MATLAB file",
    "write a table as CSV (writetable), scans as STL (stlwrite)" },
  { PlaceEnum::Start, "\xff\xfe", Drawn, "text in UTF-16", "save it as UTF-8" },
  { PlaceEnum::Start, "\xfe\xff", Drawn, "text in UTF-16", "save it as UTF-8" },
  { PlaceEnum::Start, "\x89HDF", Any, "an HDF5 file", nullptr },
  { PlaceEnum::Start, "glTF", Any, "a glTF model", "export STL or PLY" },
  { PlaceEnum::Start, "OCTM", Any, "an OpenCTM mesh (.ctm)", ExportMesh },
  { PlaceEnum::Text, "iso-10303-21", Any, "a STEP model of CAD", ExportMesh },
  { PlaceEnum::Start, "Kaydara FBX", Any, "an FBX model", ExportMesh },
  { PlaceEnum::Text, "; fbx ", Any, "an FBX model", ExportMesh },
  { PlaceEnum::Element, "collada", Any, "a Collada model (.dae)", ExportMesh },
  { PlaceEnum::Element, "x3d", Any, "an X3D model", ExportMesh },
  { PlaceEnum::Element, "amf", Any, "an AMF model", ExportMesh },
  { PlaceEnum::Text, "#vrml", Any, "a VRML model", ExportMesh },
  { PlaceEnum::Text, "#x3d", Any, "an X3D model", ExportMesh },
  { PlaceEnum::Start, "BLENDER", Any, "a Blender scene", ExportMesh },
  { PlaceEnum::Start, "\x89PNG", Scan | Landmarks, "a PNG picture", nullptr },
  { PlaceEnum::Start, "\xff\xd8\xff", Scan | Landmarks, "a JPEG picture", nullptr },
  { PlaceEnum::Start, "II*" + Nul, Scan | Landmarks, "a TIFF picture", nullptr },
  { PlaceEnum::Start, "MM" + Nul + "*", Scan | Landmarks, "a TIFF picture", nullptr },
  { PlaceEnum::Start, "GIF8", Any, "a GIF picture", "save it as PNG" },
  { PlaceEnum::InRIFF, "WEBP", Any, "a WebP picture", "save it as PNG" },
  { PlaceEnum::BehindLength, "ftypavif", Any, "an AVIF picture", "save it as PNG" },
  { PlaceEnum::BehindLength, "ftyphei", Any, "an HEIC picture", "save it as PNG" },
  { PlaceEnum::BehindLength, "ftypmif1", Any, "an HEIC picture", "save it as PNG" },
  { PlaceEnum::BehindLength, "jP  ", Any, "a JPEG 2000 picture", "save it as PNG" },
  { PlaceEnum::Start, "8BPS", Any, "a Photoshop document", "save it as PNG" },
  { PlaceEnum::Start, "gimp xcf", Any, "a GIMP document", "export it as PNG" },
  { PlaceEnum::Text,
    "version https://git-lfs",
    Any,
    "a Git LFS pointer: the file itself was not downloaded",
    "fetch it (git lfs pull)" },
  { PlaceEnum::Start, "NRRD000", Scan | Landmarks, "a NRRD image", nullptr },
  { PlaceEnum::Text, "ply", Radiograph | Drawn, "a PLY mesh", nullptr },
  { PlaceEnum::Text, "solid ", Radiograph | Drawn, "an STL mesh", nullptr },
  { PlaceEnum::Text, "# vtk datafile", Radiograph | Drawn, "a VTK file", nullptr },
  { PlaceEnum::Element, "annotations", Scan | Radiograph, "a tracing (CVAT)", nullptr },
  { PlaceEnum::Element, "vtkfile", Radiograph | Drawn, "a VTK mesh", nullptr },
  { PlaceEnum::Text,
    "{\"data_row\"",
    Any,
    "a Labelbox export (NDJSON, one JSON object a line)",
    "convert it to COCO, or write a table .csv with label,x,y" },
  { PlaceEnum::JsonLines,
    "\"data_row\"",
    Any,
    "a Labelbox export (NDJSON, one JSON object a line)",
    "convert it to COCO, or write a table .csv with label,x,y" },
  { PlaceEnum::JsonLines,
    "",
    Any,
    "NDJSON, one JSON object a line",
    "export one JSON document (labelme, COCO, VIA, Label Studio, Supervisely, 3D Slicer), or a table .csv with "
    "label,x,y" },
  { PlaceEnum::Text, "{", Scan | Radiograph, "a JSON file", nullptr },
  { PlaceEnum::Text, "[{", Scan | Radiograph, "a JSON file", nullptr },
};

unsigned int
BitOf(FilePurposeEnum purpose)
{
  switch (purpose)
  {
    case FilePurposeEnum::Scan:
      return Scan;
    case FilePurposeEnum::Radiograph:
      return Radiograph;
    case FilePurposeEnum::Tracing:
      return Tracing;
    default:
      return Landmarks;
  }
}

const char *
NameOf(FilePurposeEnum purpose)
{
  switch (purpose)
  {
    case FilePurposeEnum::Scan:
      return "no scan";
    case FilePurposeEnum::Radiograph:
      return "no radiograph";
    case FilePurposeEnum::Tracing:
      return "no tracing";
    default:
      return "no table of landmarks";
  }
}

const char *
RemedyOf(FilePurposeEnum purpose)
{
  switch (purpose)
  {
    case FilePurposeEnum::Scan:
      return "name the scan as STL, PLY, OBJ, OFF, VTK or VTP";
    case FilePurposeEnum::Radiograph:
      return "name the radiograph as PNG, JPEG, TIFF, BMP, NRRD, MetaImage, NIfTI or DICOM";
    case FilePurposeEnum::Tracing:
      return "name the tracing: JSON (own, labelme, COCO, VIA, Label Studio, Supervisely, 3D Slicer), CVAT XML, CSV "
             "with "
             "label,x,y, or a label map";
    default:
      return "name the landmarks: JSON or CSV with label,x,y";
  }
}

/** Name of the first element of what may be XML; "" where there is none. */
std::string
FindElement(const std::string & text)
{
  std::size_t place = 0;
  while ((place = text.find('<', place)) != std::string::npos && place + 1 < text.size())
  {
    if (text[place + 1] != '?' && text[place + 1] != '!')
    {
      const std::size_t end = text.find_first_of(" \t\r\n/>", place + 1);
      return text.substr(place + 1, end == std::string::npos ? end : end - place - 1);
    }
    const bool comment = text.compare(place, 4, "<!--") == 0;
    place = text.find(comment ? "-->" : ">", place);
    if (place == std::string::npos)
    {
      break;
    }
  }
  return std::string();
}

/** Whether a text begins with a JSON object in one line and another one below it. */
bool
IsJsonLines(const std::string & text)
{
  const std::size_t end = text.find('\n');
  if (text.empty() || text[0] != '{' || end == std::string::npos)
  {
    return false;
  }
  const std::size_t last = text.find_last_not_of(" \t\r\n", end);
  const std::size_t next = text.find_first_not_of(" \t\r\n", end);
  return last > 0 && text[last] == '}' && next != std::string::npos && text[next] == '{';
}

/** In either byte order. */
bool
IsNIfTI(const std::string & head, const std::string & magic)
{
  const bool        isSecond = magic.back() == '2';
  const std::string length = (isSecond ? "\x1c\x02" : "\x5c\x01") + Nul + Nul;
  const std::size_t place = isSecond ? 4 : 344;
  return (head.compare(0, 4, length) == 0 || head.compare(0, 4, std::string(length.rbegin(), length.rend())) == 0) &&
         head.size() > place && head.compare(place, magic.size() + 1, magic + Nul) == 0;
}

bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** Whether a file that is compressed by gzip had a name with that end. */
bool
IsCompressed(const std::string & fileName, const std::string & head, const std::string & end)
{
  if (head.compare(0, 2, "\x1f\x8b") != 0)
  {
    return false;
  }
  // Behind a header of ten bytes and no further field, as programs write it, stands the name.
  const bool hasName = head.size() > 10 && (static_cast<unsigned char>(head[3]) & 0x0c) == 0x08;
  return EndsWith(LowerCase(fileName), end + ".gz") || (hasName && EndsWith(LowerCase(head.c_str() + 10), end));
}
} // namespace

void
RefuseForeignFile(const std::string & fileName, FilePurposeEnum purpose)
{
  const std::string head = ReadFileHead(fileName, 4096);

  std::string       text = LowerCase(head.compare(0, 3, "\xef\xbb\xbf") == 0 ? head.substr(3) : head);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  text.erase(0, first == std::string::npos ? text.size() : first);
  const std::string element = !text.empty() && text[0] == '<' ? FindElement(text) : std::string();
  const bool        archive = head.compare(0, 4, "PK\x03\x04") == 0;
  const std::string names = archive ? text + LowerCase(ReadFileTail(fileName, 65536)) : std::string();
  const bool        jsonLines = IsJsonLines(text);
  const auto        fits = [&](const Kind & kind) {
    switch (kind.place)
    {
      case PlaceEnum::Start:
        return head.compare(0, kind.signature.size(), kind.signature) == 0;
      case PlaceEnum::BehindLength:
        return head.size() > 4 && head.compare(4, kind.signature.size(), kind.signature) == 0;
      case PlaceEnum::InRIFF:
        return head.size() > 8 && head.compare(0, 4, "RIFF") == 0 &&
               head.compare(8, kind.signature.size(), kind.signature) == 0;
      case PlaceEnum::Text:
        return text.compare(0, kind.signature.size(), kind.signature) == 0;
      case PlaceEnum::Element:
        return element == kind.signature;
      case PlaceEnum::Compressed:
        return IsCompressed(fileName, head, kind.signature);
      case PlaceEnum::JsonLines:
        return jsonLines && text.find(kind.signature) != std::string::npos;
      case PlaceEnum::NIfTI:
        return IsNIfTI(head, kind.signature);
      default:
        return archive && names.find(kind.signature) != std::string::npos;
    }
  };
  const auto refuse = [&](const char * name, const char * remedy) {
    itkDentalInputErrorMacro(
      fileName, "", std::string("is ") + name + ", " + NameOf(purpose), remedy != nullptr ? remedy : RemedyOf(purpose));
  };
  for (const Kind & kind : Kinds)
  {
    if (fits(kind))
    {
      if ((kind.refused & BitOf(purpose)) != 0)
      {
        refuse(kind.name, kind.remedy);
      }
      return;
    }
  }
  if ((BitOf(purpose) & (Scan | Landmarks)) != 0 && head.size() > 132 && head.compare(128, 4, "DICM") == 0)
  {
    refuse("a DICOM image", nullptr);
  }
}
} // namespace itk

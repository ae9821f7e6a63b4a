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
#include "itkCVATRecords.h"

#include "itkAppendWarning.h"
#include "itkAnnotationText.h"
#include "itkDentalInputError.h"
#include "itkForeignAnnotationRecords.h"
#include "itkLabelImageRecords.h"
#include "itkRunLengthMask.h"
#include "itkTextFile.h"

#include <expat.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <map>
#include <memory>
#include <stdexcept>
#include <type_traits>

namespace itk
{
namespace
{
/** As deep as JSON may be nested; CVAT nests four elements. */
constexpr int MaximumElementDepth = 64;

using AttributesType = std::map<std::string, std::string>;

struct Shape
{
  std::string              kind;
  std::string              field;
  std::string              points;
  std::vector<std::string> labels;
  AttributesType           attributes;
};

struct Picture
{
  std::string        name;
  std::string        field;
  std::string        width;
  std::string        height;
  std::vector<Shape> shapes;
};

/** Walks the elements; what it throws passes expat's C code as a pointer. */
class Parser
{
public:
  Parser(const std::string & fileName, const std::string & text)
    : m_FileName(fileName)
    , m_Text(text)
  {}

  std::vector<Picture>
  Run()
  {
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr),
                                                                                          XML_ParserFree);
    if (!parser)
    {
      throw std::bad_alloc();
    }
    m_Parser = parser.get();
    XML_SetUserData(m_Parser, this);
    XML_SetElementHandler(m_Parser, &Parser::Start, &Parser::End);
    XML_SetCharacterDataHandler(m_Parser, &Parser::Text);
    XML_SetEntityDeclHandler(m_Parser, &Parser::Entity);
    bool                  good = true;
    constexpr std::size_t piece = std::size_t{ 1 } << 20;
    for (std::size_t at = 0; good && at < m_Text.size(); at += piece)
    {
      const std::size_t size = std::min(piece, m_Text.size() - at);
      good =
        XML_Parse(m_Parser, m_Text.data() + at, static_cast<int>(size), at + size == m_Text.size()) == XML_STATUS_OK;
    }
    if (m_Error)
    {
      std::rethrow_exception(m_Error);
    }
    if (!good)
    {
      itkDentalInputErrorMacro(m_FileName,
                               "line " + std::to_string(XML_GetCurrentLineNumber(m_Parser)),
                               std::string("is no well-formed XML (") + XML_ErrorString(XML_GetErrorCode(m_Parser)) +
                                 ")",
                               "export it again");
    }
    return m_Pictures;
  }

private:
  template <typename TFunction>
  void
  Guard(TFunction && function)
  {
    if (m_Error)
    {
      return;
    }
    try
    {
      function();
    }
    catch (...)
    {
      m_Error = std::current_exception();
      XML_StopParser(m_Parser, XML_FALSE);
    }
  }

  static void
  Start(void * self, const XML_Char * name, const XML_Char ** attributes)
  {
    auto * parser = static_cast<Parser *>(self);
    parser->Guard([&] { parser->StartElement(name, attributes); });
  }
  static void
  End(void * self, const XML_Char * name)
  {
    auto * parser = static_cast<Parser *>(self);
    parser->Guard([&] { parser->EndElement(name); });
  }
  static void
  Text(void * self, const XML_Char * text, int length)
  {
    auto * parser = static_cast<Parser *>(self);
    parser->Guard([&] {
      if (parser->m_InAttribute)
      {
        parser->m_Value.append(text, static_cast<std::size_t>(length));
      }
    });
  }
  static void
  Entity(void * self,
         const XML_Char *,
         int,
         const XML_Char *,
         int,
         const XML_Char *,
         const XML_Char *,
         const XML_Char *,
         const XML_Char *)
  {
    auto * parser = static_cast<Parser *>(self);
    parser->Guard([&] { parser->Fail("declares entities, which no annotation needs", "export it again"); });
  }

  std::string
  GetField() const
  {
    return "line " + std::to_string(XML_GetCurrentLineNumber(m_Parser));
  }

  [[noreturn]] void
  Fail(const std::string & problem, const std::string & remedy) const
  {
    itkDentalInputErrorMacro(m_FileName, this->GetField(), problem, remedy);
  }

  void
  StartElement(const std::string & name, const XML_Char ** list)
  {
    if (++m_Depth > MaximumElementDepth)
    {
      this->Fail("is nested deeper than " + std::to_string(MaximumElementDepth) + " elements", "export it again");
    }
    AttributesType attributes;
    for (; list[0] != nullptr; list += 2)
    {
      attributes[list[0]] = list[1];
    }
    if (m_Depth == 1)
    {
      if (name != "annotations")
      {
        this->Fail("is XML with the root <" + name.substr(0, 40) + ">, no annotations of CVAT",
                   "export as \"CVAT for images 1.1\"");
      }
    }
    else if (name == "track")
    {
      this->Fail("has tracks, which CVAT writes for videos", "export as \"CVAT for images 1.1\"");
    }
    else if (name == "image" && m_Depth == 2)
    {
      m_Pictures.push_back({ attributes["name"], this->GetField(), attributes["width"], attributes["height"], {} });
      m_InPicture = true;
    }
    else if (m_InPicture && m_Depth == 3)
    {
      // A tag is of the whole picture, and so are its attributes.
      m_InSkeleton = name == "skeleton";
      m_InShape = name != "tag" && !m_InSkeleton;
      if (m_InShape)
      {
        this->AddShape(name, attributes);
      }
    }
    else if (m_InSkeleton && m_Depth == 4 && name == "points")
    {
      // One that lies outside the picture is CVAT's for a point that was not marked.
      m_InShape = attributes["outside"] != "1";
      if (m_InShape)
      {
        this->AddShape(name, attributes);
      }
    }
    else if (m_InShape && m_Depth == (m_InSkeleton ? 5 : 4) && name == "attribute")
    {
      m_InAttribute = true;
      m_Value.clear();
    }
  }

  void
  AddShape(const std::string & name, AttributesType & attributes)
  {
    m_Pictures.back().shapes.push_back(
      { name, this->GetField(), attributes["points"], { attributes["label"] }, attributes });
  }

  void
  EndElement(const std::string & name)
  {
    const int shapeDepth = m_InSkeleton ? 4 : 3;
    if (m_InAttribute && m_Depth == shapeDepth + 1)
    {
      m_Pictures.back().shapes.back().labels.push_back(Trim(m_Value));
      m_InAttribute = false;
    }
    m_InShape = m_InShape && m_Depth != shapeDepth;
    m_InSkeleton = m_InSkeleton && m_Depth != 3;
    if (m_Depth == 2 && name == "image")
    {
      m_InPicture = false;
    }
    --m_Depth;
  }

  const std::string &  m_FileName;
  const std::string &  m_Text;
  XML_Parser           m_Parser{ nullptr };
  std::exception_ptr   m_Error;
  std::vector<Picture> m_Pictures;
  std::string          m_Value;
  int                  m_Depth{ 0 };
  bool                 m_InPicture{ false };
  bool                 m_InShape{ false };
  /** A shape whose points are elements of their own. */
  bool m_InSkeleton{ false };
  bool m_InAttribute{ false };
};

std::vector<std::array<double, 3>>
ReadPoints(const std::string & fileName, const Shape & shape)
{
  std::vector<std::array<double, 3>> points;
  for (const std::string & pair : Split(shape.points, ';'))
  {
    const std::vector<std::string> cells = Split(pair, ',');
    std::array<double, 3>          point{ { 0.0, 0.0, 0.0 } };
    if (cells.size() != 2 || !ParseNumber(cells[0], point[0]) || !ParseNumber(cells[1], point[1]))
    {
      itkDentalInputErrorMacro(fileName,
                               shape.field,
                               "has the point \"" + pair.substr(0, 40) + "\", expected x,y",
                               "export it again: points are \"x,y;x,y\"");
    }
    points.push_back(point);
  }
  return points;
}

int64_t
ReadWholeNumber(const std::string & text)
{
  double value = 0.0;
  if (!ParseNumber(text, value) || value != std::floor(value) ||
      std::abs(value) > static_cast<double>(MaximumImageSize) * static_cast<double>(MaximumImageSize))
  {
    throw std::invalid_argument("\"" + text.substr(0, 40) + "\" is no number of pixels");
  }
  return static_cast<int64_t>(value);
}

/** The outline of what was painted with a brush. */
void
ReadMask(const std::string & fileName, const Shape & shape, const std::string & label, AnnotationRecords & records)
{
  try
  {
    const auto attribute = [&shape](const char * name) {
      const auto found = shape.attributes.find(name);
      return found == shape.attributes.end() ? std::string() : found->second;
    };
    std::vector<int64_t> runs;
    for (const std::string & run : Split(attribute("rle"), ','))
    {
      runs.push_back(ReadWholeNumber(run));
    }
    const std::array<int64_t, 4> box{ { ReadWholeNumber(attribute("left")),
                                        ReadWholeNumber(attribute("top")),
                                        ReadWholeNumber(attribute("width")),
                                        ReadWholeNumber(attribute("height")) } };
    const RunLengthMask          mask(runs, box, *records.imageSize);
    if (AppendMaskOutlines(mask.GetImage(), mask.GetOffset(), shape.field, label, records))
    {
      AppendWarning(records.warnings, fileName, shape.field + ": specks are left out beside the mask");
    }
  }
  catch (const std::invalid_argument & error)
  {
    itkDentalInputErrorMacro(fileName, shape.field, error.what(), "export the masks again, or draw polygons");
  }
}

std::size_t
ReadSize(const std::string & fileName, const Picture & picture, const char * name, const std::string & text)
{
  double value = 0.0;
  if (!ParseNumber(text, value) || !(value >= 1.0 && value <= static_cast<double>(MaximumImageSize)))
  {
    itkDentalInputErrorMacro(fileName,
                             picture.field,
                             "the picture's " + std::string(name) + " \"" + text.substr(0, 40) +
                               "\" is no number of pixels",
                             "export it again");
  }
  return static_cast<std::size_t>(value);
}
} // namespace

AnnotationRecords
ReadCVATRecords(const std::string & fileName, const std::string & imageName)
{
  const std::string          text = ReadTextFile(fileName, "an XML file");
  const std::vector<Picture> pictures = Parser(fileName, text).Run();
  std::vector<std::string>   names;
  names.reserve(pictures.size());
  for (const Picture & picture : pictures)
  {
    names.push_back(picture.name);
  }
  const Picture &   picture = pictures[ChooseImage(fileName, "image", names, imageName)];
  AnnotationRecords records;
  records.format = AnnotationFileFormatEnum::CVAT;
  records.imageSizeField = picture.field + ", width and height";
  records.imageSize = { ReadSize(fileName, picture, "width", picture.width),
                        ReadSize(fileName, picture, "height", picture.height) };
  for (const Shape & shape : picture.shapes)
  {
    const std::string label = ChooseLabel(shape.labels);
    if (shape.kind == "polygon" || shape.kind == "polyline")
    {
      AnnotationPolyline polyline;
      polyline.field = shape.field;
      polyline.codeField = shape.field;
      polyline.label = label;
      polyline.closed = shape.kind == "polygon";
      polyline.points = ReadPoints(fileName, shape);
      records.polylines.push_back(std::move(polyline));
    }
    else if (shape.kind == "points")
    {
      const auto        points = ReadPoints(fileName, shape);
      const std::string name = ChoosePointLabel(shape.labels);
      if (points.size() > 1)
      {
        AppendWarning(records.warnings,
                      fileName,
                      shape.field + ": \"" + name + "\" is " + std::to_string(points.size()) +
                        " points, the first is taken");
      }
      records.landmarks.push_back({ shape.field, name, points.front() });
    }
    else if (shape.kind == "mask")
    {
      ReadMask(fileName, shape, label, records);
    }
    else
    {
      AppendWarning(records.warnings,
                    fileName,
                    shape.field + ": a shape <" + shape.kind.substr(0, 40) + "> is no contour, ignored");
    }
  }
  return records;
}
} // namespace itk

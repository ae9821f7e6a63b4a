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
#include "itkReportPageWriter.h"

#include "itkDentalInputError.h"
#include "itkMakeTriangleSurface.h"
#include "itkParallelFor.h"
#include "itkReportModel.h"
#include "itkReportParts.h"
#include "itkReportPicture.h"
#include "itkScanForPage.h"
#include "itkTextFile.h"

#include <nlohmann/json.hpp>

// Debian's 4.1 compares a character with a constant of another sign.
#if defined(__GNUC__)
#  pragma GCC diagnostic push
#  pragma GCC diagnostic ignored "-Wconversion"
#  pragma GCC diagnostic ignored "-Wshadow"
#endif
#include <kainjow/mustache.hpp>
#if defined(__GNUC__)
#  pragma GCC diagnostic pop
#endif

#include <array>

namespace itk
{
namespace
{
using Json = nlohmann::ordered_json;
namespace mustache = kainjow::mustache;

mustache::data
ToMustache(const Json & json)
{
  if (json.is_object())
  {
    mustache::data object{ mustache::data::type::object };
    for (const auto & member : json.items())
    {
      object.set(member.key(), ToMustache(member.value()));
    }
    return object;
  }
  if (json.is_array())
  {
    mustache::data list{ mustache::data::type::list };
    for (const Json & item : json)
    {
      list.push_back(ToMustache(item));
    }
    return list;
  }
  if (json.is_boolean())
  {
    return json.get<bool>() ? mustache::data::type::bool_true : mustache::data::type::bool_false;
  }
  return json.is_string() ? mustache::data(json.get<std::string>()) : mustache::data(json.dump());
}

/** As it can stand in a script element of any type: no "<" ends it, or begins a comment in it. */
std::string
ToScriptText(const Json & json)
{
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string       safe;
  safe.reserve(text.size());
  for (const char c : text)
  {
    if (c == '<')
    {
      safe += "\\u003c";
    }
    else
    {
      safe += c;
    }
  }
  return safe;
}

Json
ParseDocument(const std::string & text, const char * name, const std::string & schema)
{
  const Json document = Json::parse(text, nullptr, false);
  if (!document.is_object() || document.value("schema", Json()) != Json(schema))
  {
    itkDentalInputErrorMacro(
      name, "schema", "is not \"" + schema + '"', "register the case again with this version of the toolkit");
  }
  return document;
}

/** Bytes that are not UTF-8 are replaced: names of files may be anything. */
std::string
CleanUTF8(const std::string & text)
{
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}
} // namespace

ReportPageWriter::ReportPageWriter()
{
  this->SetNumberOfRequiredInputs(0);
}

bool
ReportPageWriter::HasBundle()
{
  return !ReportParts::Bundle().empty();
}

void
ReportPageWriter::VerifyPreconditions() ITKv5_CONST
{
  if (m_Result.empty())
  {
    itkExceptionMacro("There is no result: call SetResult() with the text of a result.json.");
  }
  Superclass::VerifyPreconditions();
}

void
ReportPageWriter::SetViewRadiograph(const std::string & view, const RadiographType * radiograph)
{
  RadiographType::ConstPointer & own = m_ViewRadiographs[view];
  if (own != radiograph)
  {
    own = radiograph;
    this->Modified();
  }
}

std::string
ReportPageWriter::MakePage()
{
  this->VerifyPreconditions();
  const Json result = ParseDocument(m_Result, "result.json", "dentalscr-result/1");
  const Json details = m_Details.empty() ? Json() : ParseDocument(m_Details, "report.json", "dentalscr-report/1");

  RadiographForPage                     radiograph;
  std::array<Json, 2>                   scans;
  const std::array<const MeshType *, 2> meshes{ { this->GetUpperScan(), this->GetLowerScan() } };
  // The page's only work that takes time, and its parts do not need each other.
  std::map<std::string, RadiographForPage> viewRadiographs;
  std::vector<std::string>                 viewNames;
  for (const auto & entry : m_ViewRadiographs)
  {
    viewRadiographs[entry.first] = RadiographForPage();
    viewNames.push_back(entry.first);
  }
  ParallelFor(3 + viewNames.size(), this->GetNumberOfWorkUnits(), [&](std::size_t part) {
    if (part > 2)
    {
      const auto & given = m_ViewRadiographs.at(viewNames[part - 3]);
      if (given.IsNotNull())
      {
        viewRadiographs.at(viewNames[part - 3]) = MakeRadiographForPage(given, m_MaximumRadiographSide);
      }
    }
    else if (part == 2)
    {
      if (this->GetRadiograph() != nullptr)
      {
        radiograph = MakeRadiographForPage(this->GetRadiograph(), m_MaximumRadiographSide);
      }
    }
    else if (meshes[part] != nullptr)
    {
      scans[part] = MakeScanForPage(MakeTriangleSurface(meshes[part]), m_TrianglesPerScan);
    }
  });
  try
  {
    Json model = MakeReportModel(result, details);
    model["title"] = CleanUTF8(m_Title);
    model["views"] = Json::array();
    const Json views = details.is_null() ? Json::array() : details.at("views");
    for (const Json & view : views)
    {
      const bool              isFirst = model["views"].empty();
      const std::string       name = view.value("name", "");
      const auto              found = viewRadiographs.find(name);
      const RadiographForPage own = isFirst                          ? radiograph
                                    : found != viewRadiographs.end() ? found->second
                                                                     : RadiographForPage();
      // What the result says of a further view has the form of what it says of the first.
      const ReportPicture picture(isFirst ? result : result.at("views").at(name), view, own);
      Json                item = { { "name", name },
                                   { "svg", picture.GetSVG() },
                                   { "has_radiograph", !own.uri.empty() },
                                   { "layers", Json::array() },
                                   { "stages", Json::array() } };
      for (const auto & layer : picture.GetLayers())
      {
        item["layers"].push_back({ { "key", layer.key }, { "label", layer.label }, { "shown", layer.shown } });
      }
      for (const auto & stage : picture.GetStages())
      {
        item["stages"].push_back({ { "key", stage.first }, { "label", stage.second } });
      }
      item["has_stages"] = !item["stages"].empty();
      model["views"].push_back(item);
    }
    model["has_views"] = !model["views"].empty();
    model["has_several_views"] = model["views"].size() > 1;
    model["has_bundle"] = HasBundle();
    model["has_scans"] = !scans[0].is_null() || !scans[1].is_null();
    model["has_scene"] = HasBundle() && model["has_scans"].get<bool>();
    model["style"] = std::string(ReportParts::Style());
    model["script"] = std::string(HasBundle() ? ReportParts::Bundle() : ReportParts::PictureScript());
    model["licences"] = Json::parse(ReportParts::Licences());
    Json data = { { "result", result }, { "details", details }, { "scans", Json::object() } };
    for (std::size_t jaw = 0; jaw < 2; ++jaw)
    {
      if (!scans[jaw].is_null())
      {
        data["scans"][jaw == 0 ? "upper" : "lower"] = std::move(scans[jaw]);
      }
    }
    model["data"] = ToScriptText(data);
    mustache::mustache page{ std::string(ReportParts::Template()) };
    const std::string  text = page.render(ToMustache(model));
    if (!page.is_valid())
    {
      itkExceptionMacro("The page's template is wrong: " << page.error_message());
    }
    return text;
  }
  catch (const Json::exception & error)
  {
    itkDentalInputErrorMacro("result.json",
                             "",
                             std::string("is not as this version writes it: ") + error.what(),
                             "register the case again with this version of the toolkit");
  }
}

void
ReportPageWriter::Update()
{
  for (const auto & name : this->GetInputNames())
  {
    if (this->GetInput(name) != nullptr)
    {
      this->GetInput(name)->Update();
    }
  }
  this->InvokeEvent(StartEvent());
  this->GenerateData();
  this->UpdateProgress(1.0F);
  this->InvokeEvent(EndEvent());
}

void
ReportPageWriter::GenerateData()
{
  if (m_FileName.empty())
  {
    itkExceptionMacro("The page's file has no name: call SetFileName().");
  }
  WriteFileAtomically(m_FileName, this->MakePage());
}

void
ReportPageWriter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Result: " << m_Result.size() << " bytes" << std::endl;
  os << indent << "Details: " << m_Details.size() << " bytes" << std::endl;
  os << indent << "Title: " << m_Title << std::endl;
  os << indent << "ViewRadiographs: " << m_ViewRadiographs.size() << std::endl;
  os << indent << "FileName: " << m_FileName << std::endl;
  os << indent << "TrianglesPerScan: " << m_TrianglesPerScan << std::endl;
  os << indent << "MaximumRadiographSide: " << m_MaximumRadiographSide << std::endl;
}
} // namespace itk

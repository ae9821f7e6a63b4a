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
#include "itkDescribePlainly.h"
#include "itkEscapeForScript.h"
#include "itkJsonDocument.h"
#include "itkMakeTriangleSurface.h"
#include "itkParallelFor.h"
#include "itkReportModel.h"
#include "itkReportParts.h"
#include "itkReportPicture.h"
#include "itkScanForPage.h"
#include "itkTextFile.h"
#include "itkViewForPage.h"

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
#include <exception>
#include <functional>
#include <stdexcept>
#include <vector>

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

Json
ParseDocument(const std::string & text, const char * name, const std::string & schema)
{
  JsonDocument::Verify(text, name);
  const Json document = Json::parse(text, nullptr, false);
  if (!document.is_object() || document.value("schema", Json()) != Json(schema))
  {
    itkDentalInputErrorMacro(
      name, "schema", "is not \"" + schema + '"', "register the case again with this version of the toolkit");
  }
  return document;
}

[[noreturn]] void
RefuseResult(const std::exception & why)
{
  itkDentalInputErrorMacro("result.json",
                           "",
                           std::string("is not as this version writes it: ") + why.what(),
                           "register the case again with this version of the toolkit");
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

  const std::array<const MeshType *, 2> meshes{ { this->GetUpperScan(), this->GetLowerScan() } };
  std::array<Json, 2>                   scans;
  try
  {
    const Json views = details.is_null() ? Json::array() : details.at("views");
    // What the result says of a further view has the form of what it says of the first.
    const auto findOwn = [&](std::size_t number) -> const Json & {
      return number == 0 ? result : result.at("views").at(views[number].value("name", ""));
    };
    struct PictureType
    {
      RadiographForPage radiograph;
      RadiographForPage drr;
      std::string       drrProblem;
      Json              space;
    };
    std::vector<PictureType> pictures(views.size());
    // The page's only work that takes time, and its parts do not need each other.
    std::vector<std::function<void()>> parts;
    for (std::size_t jaw = 0; jaw < 2; ++jaw)
    {
      if (meshes[jaw] != nullptr)
      {
        parts.emplace_back(
          [&, jaw]() { scans[jaw] = MakeScanForPage(MakeTriangleSurface(meshes[jaw]), m_TrianglesPerScan); });
      }
    }
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      parts.emplace_back([&, i]() {
        const ViewForPage view(result, findOwn(i), views[i]);
        pictures[i].space = view.GetSpace();
        try
        {
          pictures[i].drr = view.MakeDRR({ { "upper", meshes[0] }, { "lower", meshes[1] } }, m_MaximumRadiographSide);
        }
        catch (const ExceptionObject & problem)
        {
          // A scan that has a vertex behind the source, say, was registered all the same: its layer alone is missing,
          // and the page says why.
          pictures[i].drrProblem = DescribePlainly(problem);
        }
      });
      const auto             found = m_ViewRadiographs.find(views[i].value("name", ""));
      const RadiographType * image = i == 0                             ? this->GetRadiograph()
                                     : found != m_ViewRadiographs.end() ? found->second.GetPointer()
                                                                        : nullptr;
      if (image != nullptr)
      {
        parts.emplace_back(
          [&, i, image]() { pictures[i].radiograph = MakeRadiographForPage(image, m_MaximumRadiographSide); });
      }
    }
    ParallelFor(parts.size(), this->GetNumberOfWorkUnits(), [&](std::size_t part) { parts[part](); });

    Json model = MakeReportModel(result, details);
    model["title"] = CleanUTF8(m_Title);
    model["views"] = Json::array();
    Json spaces = Json::array();
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      const ReportPicture picture(findOwn(i), views[i], pictures[i].radiograph, pictures[i].drr);
      Json                item = { { "name", views[i].value("name", "") },
                                   { "svg", picture.GetSVG() },
                                   { "has_radiograph", !pictures[i].radiograph.uri.empty() },
                                   { "has_drr", !pictures[i].drr.uri.empty() },
                                   { "has_drr_problem", !pictures[i].drrProblem.empty() },
                                   { "drr_problem", pictures[i].drrProblem },
                                   { "layers", Json::array() },
                                   { "stages", Json::array() } };
      spaces.push_back(pictures[i].space);
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
    model["sources"] = Json::array();
    for (std::size_t i = 0; i < spaces.size(); ++i)
    {
      if (!spaces[i].is_null())
      {
        model["sources"].push_back(
          { { "key", "source-" + std::to_string(i) },
            { "label",
              spaces.size() == 1 ? std::string("X-ray source") : "X-ray source: " + views[i].value("name", "") } });
      }
    }
    model["has_views"] = !model["views"].empty();
    model["has_several_views"] = model["views"].size() > 1;
    model["has_bundle"] = HasBundle();
    model["has_scans"] = !scans[0].is_null() || !scans[1].is_null();
    model["has_scene"] = HasBundle() && model["has_scans"].get<bool>();
    model["style"] = std::string(ReportParts::Style());
    model["script"] = std::string(HasBundle() ? ReportParts::Bundle() : ReportParts::PictureScript());
    model["licences"] = Json::parse(ReportParts::Licences());
    Json data = { { "result", result }, { "details", details }, { "scans", Json::object() }, { "spaces", spaces } };
    for (std::size_t jaw = 0; jaw < 2; ++jaw)
    {
      if (!scans[jaw].is_null())
      {
        data["scans"][jaw == 0 ? "upper" : "lower"] = std::move(scans[jaw]);
      }
    }
    model["data"] = EscapeForScript(data.dump(-1, ' ', false, Json::error_handler_t::replace));
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
    RefuseResult(error);
  }
  catch (const std::invalid_argument & error)
  {
    RefuseResult(error);
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

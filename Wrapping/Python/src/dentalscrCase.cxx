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
#include "dentalscrLandmarks.h"

#include "itkBatchCaseList.h"
#include "itkCaseContinuation.h"
#include "itkCaseOverlay.h"
#include "itkCaseRegistration.h"
#include "itkCaseLandmarkErrorFilter.h"
#include "itkCaseResultFolderWriter.h"
#include "itkWriteReportPage.h"
#include "itkCaseResultToJson.h"
#include "itkCaseResultWriter.h"
#include "itkMeasureLandmarkErrors.h"
#include "itkCaseScene.h"
#include "itkCephalometricLandmarkFileReader.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalCaseReader.h"
#include "itkDentalInputError.h"
#include "itkFirstViewName.h"

#include <sstream>
#include <utility>

namespace dentalscr
{
namespace
{
using itk::CaseRegistration;
using itk::CaseResult;
using itk::DentalCaseData;
using itk::JawResult;
using JawEnum = itk::ToothCode::JawEnum;

/** A case in memory, and apart from it, for no eye of what registers, the landmarks that were marked. */
struct Case
{
  std::shared_ptr<DentalCaseData>    data;
  itk::DentalLandmarkSet<2>::Pointer marked;
};

std::vector<itk::ToothCode>
ParseCodes(const std::vector<std::string> & codes, itk::ToothCode::NumberingEnum numbering)
{
  itk::DentalCase excluding;
  excluding.numbering = numbering;
  for (const std::string & code : codes)
  {
    itk::ExcludeTooth(excluding, code);
  }
  return excluding.excludedTeeth;
}

/** Where a case starts: a file of an alignment, or the text of a result that lies in none; neither: it searches. */
void
StartFrom(itk::DentalCase & description, const std::string & init, const std::string & text)
{
  if (!text.empty())
  {
    itk::ParseResultAsStart(text, init, description);
  }
  else if (!init.empty())
  {
    itk::ReadInitialAlignment(init, description);
  }
}

std::shared_ptr<Case>
LoadCase(itk::DentalCase                  description,
         const std::vector<std::string> & exclude,
         const std::vector<std::string> & fix,
         const std::string &              init,
         const std::string &              initText)
{
  StartFrom(description, init, initText);
  for (const std::string & code : exclude)
  {
    if (code == "none")
    {
      description.excludedTeeth.clear();
      continue;
    }
    itk::ExcludeTooth(description, code);
  }
  for (const std::string & what : fix)
  {
    if (what == "none")
    {
      description.fixScale = description.fixRotation = description.fixTranslation = false;
      continue;
    }
    itk::FixParameter(description, what);
  }
  auto result = std::make_shared<Case>();
  result->data = itk::LoadDentalCase(description);
  return result;
}

std::shared_ptr<Case>
ReadCase(const std::string &              fileName,
         const std::vector<std::string> & exclude,
         const std::vector<std::string> & fix,
         const std::string &              init,
         const std::string &              initText,
         const std::string &              landmarks)
{
  itk::DentalCase       description = itk::ReadDentalCase(fileName);
  itk::CaseContinuation continuation;
  continuation.cephalometricLandmarksFile = landmarks;
  continuation.SetLandmarks(description);
  return LoadCase(std::move(description), exclude, fix, init, initText);
}

/** The case of an earlier result that options of the program made. */
std::shared_ptr<Case>
ReadCaseOfResult(const std::string &              resultFile,
                 const std::vector<std::string> & exclude,
                 const std::vector<std::string> & fix,
                 const std::string &              init,
                 const std::string &              initText)
{
  const itk::CaseContinuation found = itk::ReadCaseContinuation(resultFile, true);
  if (!found.description)
  {
    itkDentalInputErrorMacro(
      found.resultFile, "inputs.case", "a case file stands here now", "was the result replaced? Read it again");
  }
  return LoadCase(*found.description, exclude, fix, init, initText);
}

/** The landmarks of a dict or of a file, which are checked against the radiograph; null for None. */
itk::CephalometricLandmarkSet::Pointer
ToCephalometricLandmarks(const py::object &                  landmarks,
                         const std::array<unsigned int, 2> & imageSize,
                         std::vector<std::string> &          warnings)
{
  if (landmarks.is_none())
  {
    return nullptr;
  }
  std::string                            name = "case in memory";
  itk::CephalometricLandmarkSet::Pointer result;
  if (py::isinstance<py::str>(landmarks))
  {
    name = landmarks.cast<std::string>();
    auto reader = itk::CephalometricLandmarkFileReader::New();
    reader->SetFileName(name);
    reader->Update();
    warnings.insert(warnings.end(), reader->GetWarnings().begin(), reader->GetWarnings().end());
    result = reader->GetOutput();
    result->DisconnectPipeline();
  }
  else
  {
    result = FromCephalometricDict(landmarks.cast<py::dict>());
  }
  itk::CheckLandmarksInImage(*result, imageSize, name, "");
  return result;
}

/** A further radiograph of a case in memory. */
void
AddView(Case &                       self,
        const std::string &          name,
        itk::CephalometricGeometry * geometry,
        itk::DentalContour *         upperContour,
        itk::DentalContour *         lowerContour,
        const py::object &           cephalometricLandmarks,
        ImageType *                  image,
        const itk::Size<2> &         imageSize,
        bool                         sameHeadPosition,
        double                       principalPointSigma)
{
  if (!itk::IsViewName(name) || name == itk::FirstViewName)
  {
    throw std::invalid_argument('"' + name +
                                "\" is no name of a further view: use letters, digits, - and _, as in \"frontal\"; the "
                                "case itself is \"" +
                                itk::FirstViewName + '"');
  }
  for (const auto & other : self.data->views)
  {
    if (other.description.name == name)
    {
      throw std::invalid_argument("two views are called \"" + name + "\"; give each a name of its own");
    }
  }
  itk::DentalViewData view;
  view.description.name = name;
  view.description.direction = geometry->GetDirection();
  view.description.sameHeadPosition = sameHeadPosition;
  view.geometry = itk::CephalometricGeometry::New();
  view.geometry->CopyParameters(geometry);
  view.geometry->SetPoseToIdentity();
  for (itk::ValueSourceEnum * source : { &view.sources.sourceToMidsagittal,
                                         &view.sources.sourceToDetector,
                                         &view.sources.facing,
                                         &view.sources.sourceSide })
  {
    *source = itk::ValueSourceEnum::Given;
  }
  if (geometry->HasPixelSpacing())
  {
    view.sources.pixelSpacing = itk::ValueSourceEnum::Given;
    view.spacingVerdict = itk::PixelSpacingVerdictEnum::UserGiven;
    view.spacingProvenance = "given, detector plane";
  }
  // As of the case itself: nobody puts the ear rods into a picture's corner.
  const auto & principal = geometry->GetPrincipalPoint();
  if (principal[0] != 0.0 || principal[1] != 0.0)
  {
    view.sources.principalPoint = itk::ValueSourceEnum::Given;
    view.description.principalPointSigma = principalPointSigma;
  }
  view.image = image;
  view.imageSize = { { static_cast<unsigned int>(imageSize[0]), static_cast<unsigned int>(imageSize[1]) } };
  if (image != nullptr)
  {
    const auto size = image->GetLargestPossibleRegion().GetSize();
    view.imageSize = { { static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]) } };
  }
  if (view.imageSize[0] == 0 || view.imageSize[1] == 0)
  {
    throw std::invalid_argument("the size of the radiograph of the view \"" + name +
                                "\" is not known; give image or imageSize");
  }
  const auto &                              excluded = self.data->description.excludedTeeth;
  const std::array<itk::DentalContour *, 2> drawn{ { upperContour, lowerContour } };
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    if (drawn[i] != nullptr && drawn[i]->GetNumberOfPoints() > 0)
    {
      view.contours[i] = itk::WithoutTeeth(*drawn[i], excluded);
    }
  }
  view.cephalometricLandmarks = ToCephalometricLandmarks(cephalometricLandmarks, view.imageSize, self.data->warnings);
  if (upperContour == nullptr && lowerContour == nullptr && view.cephalometricLandmarks.IsNull())
  {
    throw std::invalid_argument("nothing was drawn on the view \"" + name +
                                "\"; give upperContour, lowerContour or cephalometricLandmarks");
  }
  itk::CompleteViewGeometry(*self.data, view, self.data->warnings);
  view.geometry->VerifyComplete();
  self.data->views.push_back(view);
}

std::shared_ptr<Case>
MakeCase(MeshType *                                upper,
         MeshType *                                lower,
         itk::DentalContour *                      upperContour,
         itk::DentalContour *                      lowerContour,
         itk::CephalometricGeometry *              geometry,
         ImageType *                               image,
         const itk::Size<2> &                      imageSize,
         bool                                      principalPointKnown,
         const std::optional<std::string> &        tracedSide,
         const std::string &                       occlusion,
         const py::object &                        cephalometricLandmarks,
         const std::vector<itk::DentalContour *> & stockOutlines,
         const py::object &                        landmarks3D,
         const py::object &                        landmarks2D,
         const std::vector<std::string> &          exclude,
         const std::vector<std::string> &          fix)
{
  auto result = std::make_shared<Case>();
  result->data = std::make_shared<DentalCaseData>();
  DentalCaseData & data = *result->data;
  data.description.fileName = "case in memory";
  data.description.tracedSideIsGiven = tracedSide.has_value();
  data.description.tracedSide = itk::TracedSideFromString(tracedSide.value_or("right"));
  data.description.occlusion = itk::OcclusionFromString(occlusion);
  data.description.excludedTeeth = ParseCodes(exclude, itk::ToothCode::NumberingEnum::Quadrant);
  for (const std::string & what : fix)
  {
    itk::FixParameter(data.description, what);
  }
  data.image = image;
  data.imageSize = { { static_cast<unsigned int>(imageSize[0]), static_cast<unsigned int>(imageSize[1]) } };
  if (image != nullptr)
  {
    const auto size = image->GetLargestPossibleRegion().GetSize();
    data.imageSize = { { static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]) } };
  }
  if (data.imageSize[0] == 0 || data.imageSize[1] == 0)
  {
    throw std::invalid_argument("the size of the radiograph is not known; give image or imageSize");
  }
  data.geometry = itk::CephalometricGeometry::New();
  if (geometry != nullptr)
  {
    data.geometry->CopyParameters(geometry);
    data.geometry->SetPoseToIdentity();
    data.sources.sourceToMidsagittal = itk::ValueSourceEnum::Given;
    data.sources.sourceToDetector = itk::ValueSourceEnum::Given;
    data.sources.sourceSide = itk::ValueSourceEnum::Given;
    data.sources.facing = itk::ValueSourceEnum::Given;
    if (geometry->HasPixelSpacing())
    {
      data.sources.pixelSpacing = itk::ValueSourceEnum::Given;
      data.spacingVerdict = itk::PixelSpacingVerdictEnum::UserGiven;
    }
    if (principalPointKnown)
    {
      data.sources.principalPoint = itk::ValueSourceEnum::Given;
    }
  }
  data.spacingProvenance = data.geometry->HasPixelSpacing() ? "given, detector plane" : "none given";
  const auto takeJaw = [&](JawEnum name, MeshType * mesh, itk::DentalContour * contour) {
    DentalCaseData::JawType & jaw = data.GetJaw(name);
    jaw.mesh = mesh;
    if (contour == nullptr || contour->GetNumberOfPoints() == 0)
    {
      return;
    }
    jaw.contour = itk::WithoutTeeth(*contour, data.description.excludedTeeth);
  };
  takeJaw(JawEnum::Upper, upper, upperContour);
  takeJaw(JawEnum::Lower, lower, lowerContour);
  data.cephalometricLandmarks = ToCephalometricLandmarks(cephalometricLandmarks, data.imageSize, data.warnings);
  itk::SettleTracedSide(data);
  if (!stockOutlines.empty())
  {
    data.stockOutlines = itk::DentalContour::New();
    for (const itk::DentalContour * outlines : stockOutlines)
    {
      for (const auto & polyline : outlines->GetPolylines())
      {
        data.stockOutlines->AddPolyline(polyline);
      }
    }
  }
  if (!landmarks3D.is_none())
  {
    data.landmarks3D = FromDict<3>(landmarks3D.cast<py::dict>());
  }
  if (!landmarks2D.is_none())
  {
    result->marked = FromDict<2>(landmarks2D.cast<py::dict>());
  }
  return result;
}

/** The scene as arrays: Python's VTK is another than the C++ library's, and nothing of either may meet the other's. */
py::dict
GetScene(const CaseResult & result)
{
  auto scene = [&]() {
    const py::gil_scoped_release release;
    const auto                   source = itk::MakeCaseScene(result);
    source->Update();
    itk::SmartPointer<itk::RegistrationScene> output = source->GetOutput();
    output->DisconnectPipeline();
    return output;
  }();
  py::list parts;
  for (const itk::ScenePart & part : scene->GetParts())
  {
    const auto &              mesh = *part.mesh;
    std::vector<float>        points;
    std::vector<std::int64_t> lines;
    std::vector<std::int64_t> triangles;
    points.reserve(3 * mesh.GetNumberOfPoints());
    for (auto it = mesh.GetPoints()->Begin(); it != mesh.GetPoints()->End(); ++it)
    {
      points.insert(points.end(), it.Value().Begin(), it.Value().End());
    }
    for (auto it = mesh.GetCells()->Begin(); it != mesh.GetCells()->End(); ++it)
    {
      const auto * cell = it.Value();
      auto &       corners = cell->GetNumberOfPoints() == 2 ? lines : triangles;
      corners.insert(corners.end(), cell->PointIdsBegin(), cell->PointIdsEnd());
    }
    const auto rows = [](std::size_t size, std::size_t columns) {
      return std::vector<py::ssize_t>{ static_cast<py::ssize_t>(size / columns), static_cast<py::ssize_t>(columns) };
    };
    std::ostringstream kind;
    kind << part.kind;
    py::dict entry;
    entry["name"] = part.name;
    entry["kind"] = kind.str();
    entry["points"] = MakeArray<float>(points, rows(points.size(), 3));
    entry["lines"] = MakeArray<std::int64_t>(lines, rows(lines.size(), 2));
    entry["triangles"] = MakeArray<std::int64_t>(triangles, rows(triangles.size(), 3));
    entry["color"] = py::make_tuple(part.color[0], part.color[1], part.color[2]);
    entry["opacity"] = part.opacity;
    entry["lineWidth"] = part.lineWidth;
    if (part.HasTeeth())
    {
      std::vector<std::uint8_t> teeth(mesh.GetNumberOfPoints());
      for (std::size_t i = 0; i < teeth.size(); ++i)
      {
        float code = 0.0F;
        mesh.GetPointData()->GetElementIfIndexExists(i, &code);
        teeth[i] = static_cast<std::uint8_t>(code);
      }
      entry["teeth"] = MakeArray<std::uint8_t>(teeth);
    }
    if (part.picture.IsNotNull())
    {
      const auto                      size = part.picture->GetBufferedRegion().GetSize();
      const unsigned char *           pixels = part.picture->GetBufferPointer();
      const std::vector<std::uint8_t> values(pixels, pixels + size[0] * size[1]);
      entry["picture"] = MakeArray<std::uint8_t>(values, rows(values.size(), size[0]));
      std::vector<float> coordinates;
      for (const auto & place : part.pictureCoordinates)
      {
        coordinates.insert(coordinates.end(), place.begin(), place.end());
      }
      entry["pictureCoordinates"] = MakeArray<float>(coordinates, rows(coordinates.size(), 2));
    }
    parts.append(entry);
  }
  py::dict sources;
  for (const auto & detector : scene->GetDetectors())
  {
    const auto & source = detector.second.GetSource();
    sources[py::str(detector.first)] = py::make_tuple(source[0], source[1], source[2]);
  }
  py::dict value;
  value["parts"] = parts;
  value["sources"] = sources;
  return value;
}

/** What a run leaves; the landmark errors are added here, when nothing can be registered with them any more. */
std::shared_ptr<CaseResult>
TakeResult(const CaseRegistration & registration, const Case & input)
{
  if (input.marked.IsNull())
  {
    // Those that the case file names, if any.
    auto registered = itk::CaseResultObject::New();
    registered->Set(registration.GetResult());
    auto errors = itk::CaseLandmarkErrorFilter::New();
    errors->SetInput(registered);
    errors->Update();
    return std::make_shared<CaseResult>(errors->GetOutput()->Get());
  }
  auto result = std::make_shared<CaseResult>(registration.GetResult());
  itk::MeasureLandmarkErrors(*result, input.marked);
  result->markedLandmarks = input.marked.GetPointer();
  return result;
}

const JawResult &
GetJaw(const CaseResult & result, const std::string & name)
{
  const auto found = result.jaws.find(name == "lower" ? JawEnum::Lower : JawEnum::Upper);
  if ((name != "upper" && name != "lower") || found == result.jaws.end())
  {
    throw std::invalid_argument("the result has no jaw \"" + name + "\"");
  }
  return found->second;
}
} // namespace

void
WrapCase(py::module_ & module)
{
  using PresetEnum = itk::CasePresetEnum;
  BindEnum<PresetEnum>(module,
                       "Preset",
                       { { "Robust", PresetEnum::Robust },
                         { "Paper", PresetEnum::Paper },
                         { "BoundingBox", PresetEnum::BoundingBox },
                         { "SingleStage", PresetEnum::SingleStage } },
                       "How a case is registered.");

  py::class_<Case, std::shared_ptr<Case>>(module, "_Case")
    .def(py::init(&MakeCase),
         py::arg("upper"),
         py::arg("lower"),
         py::arg("upperContour"),
         py::arg("lowerContour"),
         py::arg("geometry"),
         py::arg("image"),
         py::arg("imageSize"),
         py::arg("principalPointKnown"),
         py::arg("tracedSide"),
         py::arg("occlusion"),
         py::arg("cephalometricLandmarks"),
         py::arg("stockOutlines"),
         py::arg("landmarks3D"),
         py::arg("landmarks2D"),
         py::arg("exclude"),
         py::arg("fix"))
    .def("_AddView",
         &AddView,
         py::arg("name"),
         py::arg("geometry"),
         py::arg("upperContour"),
         py::arg("lowerContour"),
         py::arg("cephalometricLandmarks"),
         py::arg("image"),
         py::arg("imageSize"),
         py::arg("sameHeadPosition"),
         py::arg("principalPointSigma"))
    .def_static("_Read",
                &ReadCase,
                py::arg("fileName"),
                py::arg("exclude"),
                py::arg("fix"),
                py::arg("init"),
                py::arg("initText"),
                py::arg("landmarks") = "",
                py::call_guard<py::gil_scoped_release>())
    .def_static("_ReadOfResult",
                &ReadCaseOfResult,
                py::arg("result"),
                py::arg("exclude"),
                py::arg("fix"),
                py::arg("init"),
                py::arg("initText"),
                py::call_guard<py::gil_scoped_release>())
    .def(
      "_StartFrom",
      [](Case & self, const std::string & init, const std::string & text) {
        const std::size_t before = self.data->description.warnings.size();
        StartFrom(self.data->description, init, text);
        const auto & warnings = self.data->description.warnings;
        self.data->warnings.insert(
          self.data->warnings.end(), warnings.begin() + static_cast<std::ptrdiff_t>(before), warnings.end());
      },
      py::arg("init"),
      py::arg("initText"))
    .def(
      "_GetMesh", [](const Case & self, JawEnum jaw) { return self.data->GetJaw(jaw).mesh; }, py::arg("jaw"))
    .def(
      "_GetContour", [](const Case & self, JawEnum jaw) { return self.data->GetJaw(jaw).contour; }, py::arg("jaw"))
    .def("_GetImage", [](const Case & self) { return self.data->image; })
    .def("_GetImageSize",
         [](const Case & self) { return std::make_pair(self.data->imageSize[0], self.data->imageSize[1]); })
    .def("_GetGeometry", [](const Case & self) { return self.data->geometry; })
    .def("_GetLandmarks3D", [](const Case & self) { return ToDict<3>(self.data->landmarks3D); })
    .def("_GetCephalometricLandmarks",
         [](const Case & self) { return ToDict(self.data->cephalometricLandmarks.GetPointer()); })
    .def("_GetInputs",
         [](const Case & self) {
           std::vector<std::pair<std::string, std::string>> inputs;
           for (const itk::CaseInputFile & file : self.data->inputs)
           {
             inputs.emplace_back(file.path, file.sha256);
           }
           return inputs;
         })
    .def("_GetFileName", [](const Case & self) { return self.data->description.fileName; })
    .def("_GetWarnings", [](const Case & self) { return self.data->warnings; })
    .def("_HasPrincipalPoint", [](const Case & self) { return self.data->HasPrincipalPoint(); })
    .def("_GetTracedSide", [](const Case & self) { return itk::ToString(self.data->description.tracedSide); });

  module.def(
    "_ReadContinuation",
    [](const std::string & result, bool needsCase) {
      const itk::CaseContinuation found = itk::ReadCaseContinuation(result, needsCase);
      py::dict                    values;
      values["case"] = found.caseFile;
      values["result"] = found.resultFile;
      values["exclude"] = found.excludedTeeth;
      values["fix"] = found.fixed;
      values["options"] = found.options;
      values["landmarks"] = found.cephalometricLandmarksFile;
      return values;
    },
    py::arg("result"),
    py::arg("needsCase"),
    "What an earlier result was registered with; see register_from().");

  module.def(
    "_FindBatchCases",
    [](const std::string & input) {
      itk::BatchCaseList                               list;
      std::vector<std::pair<std::string, std::string>> found;
      for (const itk::BatchCase & one : list.Find({ input }))
      {
        // Without names of options a table's rows name case files, and nothing else comes of the list.
        found.emplace_back(one.id, one.arguments.front());
      }
      return found;
    },
    py::arg("input"),
    "Names and files of the cases of a folder, a table of case files, a case file or a pattern.");

  py::class_<CaseResult, std::shared_ptr<CaseResult>>(module, "_CaseResult")
    .def("_ToJson", &itk::CaseResultToJson)
    .def(
      "_Write",
      [](const CaseResult & self, const std::string & folder, bool report, bool page, bool anonymous) {
        itk::CaseOutputOptions options;
        options.report = report;
        options.page = page;
        options.anonymous = anonymous;
        options.between = []() {
          const py::gil_scoped_acquire interpreter;
          if (PyErr_CheckSignals() != 0)
          {
            throw py::error_already_set();
          }
        };
        itk::WriteCaseResult(self, folder, options);
      },
      py::arg("folder"),
      py::arg("report"),
      py::arg("page"),
      py::arg("anonymous"),
      py::call_guard<py::gil_scoped_release>())
    .def("_GetJaws",
         [](const CaseResult & self) {
           std::vector<std::string> names;
           for (const auto & entry : self.jaws)
           {
             names.push_back(itk::ToString(entry.first));
           }
           return names;
         })
    .def(
      "_GetOverlay",
      [](const CaseResult & self, const std::string & jaw) {
        GetJaw(self, jaw);
        const auto overlay = itk::MakeCaseOverlay(self, jaw == "lower" ? JawEnum::Lower : JawEnum::Upper);
        overlay->Update();
        itk::SmartPointer<PictureType> picture = overlay->GetOutput();
        picture->DisconnectPipeline();
        return picture;
      },
      py::arg("jaw"),
      py::call_guard<py::gil_scoped_release>())
    .def("_GetScene", &GetScene)
    .def("_GetGeometry", [](const CaseResult & self) { return self.geometry; })
    .def("_GetJaw", [](const CaseResult & self, const std::string & name) {
      const JawResult & jaw = GetJaw(self, name);
      py::dict          result;
      result["registered"] = jaw.registered;
      result["projection"] = MakeMatrix34(jaw.projection);
      result["meshToUMDA"] = MakeMatrix44(jaw.meshToUMDA);
      result["meshToCephalostat"] = MakeMatrix44(jaw.meshToCephalostat);
      py::dict contours;
      for (const auto & contour : jaw.contours)
      {
        contours[py::str(contour.first)] = contour.second;
      }
      result["contours"] = contours;
      py::dict covariances;
      for (const auto & landmark : jaw.landmarks)
      {
        if (landmark.covariance)
        {
          covariances[py::str(landmark.name)] =
            MakeArray<double>(std::vector<double>(landmark.covariance->begin(), landmark.covariance->end()), { 2, 2 });
        }
      }
      result["covariances"] = covariances;
      return result;
    });

  ProcessClass<CaseRegistration>(module, "CaseRegistration", "A case through the whole chain; see register().")
    .def(New<CaseRegistration>())
    .def("SetPreset",
         &CaseRegistration::SetPreset,
         py::arg("preset"),
         "Sets the chain that runs: Robust (the default) or one of the paper's.")
    .def("GetPreset",
         &CaseRegistration::GetPreset,
         "Returns the chain that runs: Robust (the default) or one of the paper's.")
    .dentalscrProperty(CaseRegistration,
                       NumberOfUpperContourPoints,
                       "the number of points that the upper silhouette is resampled to, in the paper's presets: 441 "
                       "by default.")
    .dentalscrProperty(CaseRegistration,
                       NumberOfLowerContourPoints,
                       "the number of points that the lower silhouette is resampled to, in the paper's presets: 439 "
                       "by default.")
    .dentalscrBoolean(CaseRegistration,
                      UseSurfaceDRR,
                      "whether the paper's presets take the silhouette from the surface DRR (the default) or "
                      "exactly from the mesh.")
    .dentalscrBoolean(CaseRegistration,
                      RefineMidline,
                      "whether preset Robust moves the midline plane of the dental axis to the scan's mirror "
                      "plane. On by default.")
    .def("SetPoseOptions", &CaseRegistration::SetPoseOptions, py::arg("options"), "Ingredients of preset Robust.")
    .def(
      "GetPoseOptions", [](const CaseRegistration & self) { return self.GetPoseOptions(); }, "A copy.")
    .def("SetOption",
         &CaseRegistration::SetOption,
         py::arg("assignment"),
         "One ingredient of preset Robust, \"NAME=VALUE\" (Documentation/Robust.md).")
    .def(
      "GetCurrentStage",
      [](const CaseRegistration & self) { return self.GetCurrentStage(); },
      "What runs now, in words: \"upper: registration\".")
    .def(
      "_SetData", [](CaseRegistration & self, const Case & input) { self.SetData(input.data); }, py::arg("case"))
    .def("_TakeResult", &TakeResult, py::arg("case"));

  using ReaderType = itk::DentalCaseReader;
  ProcessClass<ReaderType>(module, "DentalCaseReader", "Reads a case; see ReadCase().")
    .def(New<ReaderType>())
    .def(
      "SetFileName",
      [](ReaderType & self, const std::string & fileName) { self.SetFileName(fileName); },
      py::arg("fileName"),
      "Sets the name of the case file.")
    .def(
      "GetFileName",
      [](const ReaderType & self) { return std::string(self.GetFileName()); },
      "Returns the name of the case file.")
    .def("_TakeOutput", [](ReaderType & self) {
      auto result = std::make_shared<Case>();
      // Nobody changes it: Python has no setters of it.
      result->data = std::const_pointer_cast<DentalCaseData>(self.GetOutput()->Get());
      return result;
    });

  using ErrorType = itk::CaseLandmarkErrorFilter;
  ProcessClass<ErrorType>(
    module, "CaseLandmarkErrorFilter", "Measures a result against the landmarks that its case has marked.")
    .def(New<ErrorType>())
    .def(
      "_SetInput",
      [](ErrorType & self, const CaseResult & result) {
        auto input = itk::CaseResultObject::New();
        input->Set(result);
        self.SetInput(input);
      },
      py::arg("result"))
    .def("_TakeOutput", [](ErrorType & self) { return std::make_shared<CaseResult>(self.GetOutput()->Get()); });

  using WriterType = itk::CaseResultFolderWriter;
  ProcessClass<WriterType>(module, "CaseResultFolderWriter", "Writes a result into a folder; see WriteCaseResult().")
    .def(New<WriterType>())
    .def(
      "_SetInput",
      [](WriterType & self, const CaseResult & result) {
        auto input = itk::CaseResultObject::New();
        input->Set(result);
        self.SetInput(input);
      },
      py::arg("result"))
    .def(
      "SetFolderName",
      [](WriterType & self, const std::string & folderName) { self.SetFolderName(folderName); },
      py::arg("folderName"),
      "Sets the folder that is written to. It is made where it is not there, and files of an "
      "earlier result in it are replaced.")
    .def(
      "GetFolderName",
      [](const WriterType & self) { return std::string(self.GetFolderName()); },
      "Returns the folder that is written to. It is made where it is not there, and files of an "
      "earlier result in it are replaced.")
    .dentalscrBoolean(WriterType,
                      WriteReport,
                      "whether what is for people is written as well: overlays, the scans in the cephalostat "
                      "frame, the page. On by default.")
    .dentalscrBoolean(
      WriterType, WritePage, "whether report.html is written where what is for people is. On by default.")
    .dentalscrBoolean(WriterType, Anonymous, "whether paths and names are left out of all files. Off by default.");

  module.def(
    "_WriteReportPage",
    [](const std::string & result, const std::string & fileName, const std::string & imageFile, bool anonymous) {
      return itk::WriteReportPage(result, { fileName, imageFile, anonymous });
    },
    py::arg("result"),
    py::arg("fileName"),
    py::arg("imageFile"),
    py::arg("anonymous"),
    py::call_guard<py::gil_scoped_release>());
}
} // namespace dentalscr

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
#include "itkDentalCaseFileReader.h"

#include "itkCaseFileFields.h"
#include "itkCaseInputFile.h"
#include "itkCaseResultFileReader.h"
#include "itkDentalInputError.h"
#include "itkDentalViewReader.h"
#include "itkJsonDocument.h"
#include "itkPoseGeometryConversion.h"
#include "itkRegistrationFinding.h"
#include "itkRigidTransformRows.h"
#include "itkTextFile.h"
#include "itkShortNumber.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace itk
{
namespace
{
namespace fs = std::filesystem;

double
PositiveNumber(const JsonNode & node, const char * remedy)
{
  const double value = node.AsNumber();
  if (!(value > 0.0))
  {
    node.Fail(ShortNumber(value) + " is not positive", remedy);
  }
  return value;
}

/** A file's name, or an object of a file a tooth or jaw. */
void
ReadContourFiles(const JsonNode & root, const fs::path & directory, DentalCase & dentalCase)
{
  const auto node = root.Find("contours");
  if (!node || !node->IsObject())
  {
    dentalCase.contoursFile = FindFile(root, "contours", directory);
    return;
  }
  for (const auto & [code, file] : node->GetMembers())
  {
    if (!file.IsString())
    {
      node->Fail("is no file's name, nor an object of a file a tooth",
                 R"(name the tracing, or masks of one tooth or jaw each: {"UR1": "mask.png"})");
    }
    if (ToothCode::JawFromString(code) == ToothCode::JawEnum::Unknown && !ToothCode::FromSidelessString(code).IsKnown())
    {
      try
      {
        ToothCode::FromString(code, dentalCase.numbering.value_or(ToothCode::NumberingEnum::Quadrant));
      }
      catch (const std::invalid_argument & error)
      {
        file.Fail(error.what(), "name a tooth, \"upper\" or \"lower\" before the file");
      }
    }
    dentalCase.contourClassFiles.emplace_back(code, FindFile(*node, code, directory));
  }
  if (dentalCase.contourClassFiles.empty())
  {
    node->Fail("names no file", R"(name masks of one tooth or jaw each: {"UR1": "mask.png"})");
  }
}

SimilarityParameters
ReadSimilarity(const JsonNode & node)
{
  node.WarnAboutUnknownFields({ "scale", "rotation_rad", "translation_px" });
  SimilarityParameters similarity;
  if (const auto scale = node.Find("scale"))
  {
    similarity.scale = PositiveNumber(*scale, "1 is the geometry's own scale");
  }
  if (const auto rotation = node.Find("rotation_rad"))
  {
    similarity.rotation = rotation->AsNumber();
  }
  const std::vector<double> translation = node.Get("translation_px").AsNumbers(2, "[u, v]");
  similarity.translation = { { translation[0], translation[1] } };
  return similarity;
}

void
ReadInit(const JsonNode & init, DentalCase & dentalCase)
{
  init.WarnAboutUnknownFields({ "upper", "lower", "similarity", "pose" });
  const std::pair<const char *, ToothCode::JawEnum> jaws[] = { { "upper", ToothCode::JawEnum::Upper },
                                                               { "lower", ToothCode::JawEnum::Lower } };
  if (const auto similarity = init.Find("similarity"))
  {
    for (const auto & jaw : jaws)
    {
      dentalCase.initialSimilarity[jaw.second] = ReadSimilarity(*similarity);
    }
  }
  for (const auto & jaw : jaws)
  {
    if (const auto node = init.Find(jaw.first))
    {
      node->WarnAboutUnknownFields({ "similarity" });
      dentalCase.initialSimilarity[jaw.second] = ReadSimilarity(node->Get("similarity"));
    }
  }
  if (const auto pose = init.Find("pose"))
  {
    if (!pose->IsArray() || pose->GetSize() < 3)
    {
      pose->Fail("is no 3x4 matrix", "write three rows [r, r, r, t] from mesh (mm) to cephalostat frame");
    }
    std::array<double, 12> matrix{};
    for (std::size_t row = 0; row < 3; ++row)
    {
      const std::vector<double> numbers = pose->At(row).AsNumbers(4, "[r, r, r, t]");
      std::copy(numbers.begin(), numbers.end(), matrix.begin() + 4 * row);
    }
    for (unsigned int a = 0; a < 3; ++a)
    {
      for (unsigned int b = 0; b < 3; ++b)
      {
        double product = 0.0;
        for (unsigned int d = 0; d < 3; ++d)
        {
          product += matrix[4 * a + d] * matrix[4 * b + d];
        }
        if (std::abs(product - (a == b ? 1.0 : 0.0)) > 1e-6)
        {
          pose->Fail("its rotation is not orthonormal", "give a rigid pose; the mesh's unit belongs in \"mesh_unit\"");
        }
      }
    }
    const auto & m = matrix;
    if (m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]) <
        0.0)
    {
      pose->Fail("mirrors the mesh", "the side that the patient faces belongs in \"facing\"");
    }
    dentalCase.initialPose = matrix;
  }
}

void
ReadCephalogram(const JsonNode & node, const fs::path & directory, DentalCase & dentalCase)
{
  node.WarnAboutUnknownFields({ "image", "image_size", "pixel_spacing_mm", "spacing_plane", "facing" });
  dentalCase.imageFile = FindFile(node, "image", directory);
  dentalCase.imageSize = ReadImageSize(node);
  dentalCase.pixelSpacing = ReadPixelSpacing(node);
  if (const auto plane = node.Find("spacing_plane"))
  {
    const std::string & text = plane->AsString();
    if (text != "detector" && text != "midsagittal")
    {
      plane->Fail("\"" + text + "\" is neither \"detector\" nor \"midsagittal\"", "write one of them");
    }
    dentalCase.spacingAtMidsagittalPlane = text == "midsagittal";
    dentalCase.spacingPlaneIsGiven = true;
  }
  if (const auto facing = node.Find("facing"))
  {
    dentalCase.facing =
      IsLeft(*facing) ? CephalometricGeometry::FacingEnum::Left : CephalometricGeometry::FacingEnum::Right;
  }
}

void
ReadGeometry(const JsonNode & node, DentalCase & dentalCase)
{
  node.WarnAboutUnknownFields(
    { "source_to_midsagittal_mm", "source_to_detector_mm", "source_side", "principal_point_px" });
  if (const auto distance = node.Find("source_to_midsagittal_mm"))
  {
    dentalCase.sourceToMidsagittal = MachineDistance(*distance);
  }
  if (const auto distance = node.Find("source_to_detector_mm"))
  {
    dentalCase.sourceToDetector = MachineDistance(*distance);
  }
  if (dentalCase.sourceToMidsagittal && dentalCase.sourceToDetector &&
      *dentalCase.sourceToDetector <= *dentalCase.sourceToMidsagittal)
  {
    node.Get("source_to_detector_mm")
      .Fail("the detector is not behind the midsagittal plane",
            "source_to_detector_mm is larger than source_to_midsagittal_mm; were they exchanged?");
  }
  if (const auto side = node.Find("source_side"))
  {
    dentalCase.sourceSide =
      IsLeft(*side) ? CephalometricGeometry::SourceSideEnum::Left : CephalometricGeometry::SourceSideEnum::Right;
  }
  dentalCase.principalPoint = ReadPrincipalPoint(node);
}

} // namespace

CrownsEnum
CrownsFromString(const std::string & text)
{
  for (const CrownsEnum crowns : { CrownsEnum::Off, CrownsEnum::Labels, CrownsEnum::Shape })
  {
    if (text == ToString(crowns))
    {
      return crowns;
    }
  }
  throw std::invalid_argument("\"" + text + "\" does not say how to find crowns (\"off\", \"labels\" or \"shape\")");
}

DentalFrameEnums::JawsShareFrame
ToJawsShareFrame(OcclusionEnum occlusion)
{
  switch (occlusion)
  {
    case OcclusionEnum::Yes:
      return DentalFrameEnums::JawsShareFrame::On;
    case OcclusionEnum::No:
      return DentalFrameEnums::JawsShareFrame::Off;
    default:
      return DentalFrameEnums::JawsShareFrame::Check;
  }
}

OcclusionEnum
OcclusionFromString(const std::string & text)
{
  for (const OcclusionEnum occlusion : { OcclusionEnum::Yes, OcclusionEnum::No, OcclusionEnum::Check })
  {
    if (text == ToString(occlusion))
    {
      return occlusion;
    }
  }
  throw std::invalid_argument("\"" + text +
                              "\" does not say whether the jaws are in occlusion (true, false or \"check\")");
}

void
ExcludeTooth(DentalCase & dentalCase, const std::string & text)
{
  const auto exclude = [&](const ToothCode & tooth) {
    auto & excluded = dentalCase.excludedTeeth;
    if (std::find(excluded.begin(), excluded.end(), tooth) == excluded.end())
    {
      excluded.push_back(tooth);
    }
  };
  const ToothCode sideless = ToothCode::FromSidelessString(text);
  if (sideless.IsKnown())
  {
    exclude(sideless);
    exclude(sideless.GetContralateral());
    return;
  }
  // UR3 is UR3 in any numbering: a result names its teeth so.
  const ToothCode tooth =
    ToothCode::FromString(text, dentalCase.numbering.value_or(ToothCode::NumberingEnum::Quadrant));
  if (!tooth.IsKnown())
  {
    throw std::invalid_argument("\"" + text + "\" names no tooth: write UR3, 13 or U1, or leave it out");
  }
  exclude(tooth);
}

void
FixParameter(DentalCase & dentalCase, const std::string & text)
{
  if (text == "scale")
  {
    dentalCase.fixScale = true;
  }
  else if (text == "rotation")
  {
    dentalCase.fixRotation = true;
  }
  else if (text == "translation")
  {
    dentalCase.fixTranslation = true;
  }
  else
  {
    throw std::invalid_argument("\"" + text + "\" can't be fixed (\"scale\", \"rotation\" or \"translation\")");
  }
}

const char *
ToString(CrownsEnum crowns)
{
  switch (crowns)
  {
    case CrownsEnum::Labels:
      return "labels";
    case CrownsEnum::Shape:
      return "shape";
    default:
      return "off";
  }
}

const char *
ToString(OcclusionEnum occlusion)
{
  switch (occlusion)
  {
    case OcclusionEnum::Yes:
      return "true";
    case OcclusionEnum::No:
      return "false";
    default:
      return "check";
  }
}

namespace
{
/** Where a result has its jaws is where they start. */
void
TakeResultAsStart(CaseResultFileReader * reader, const std::string & name, DentalCase & dentalCase)
{
  reader->Update();
  const PoseSolution * solution = reader->GetOutput();
  std::string          failed;
  for (const ToothCode::JawEnum jaw : { ToothCode::JawEnum::Upper, ToothCode::JawEnum::Lower })
  {
    if (!solution->IsRegistered(jaw))
    {
      continue;
    }
    if (reader->GetStatus(jaw) == ToString(RegistrationStatusEnum::Failed))
    {
      failed = ToString(jaw);
      continue;
    }
    DentalCase::PlacementType placement;
    const PoseJawResult &     own = solution->GetJaw(jaw);
    placement.meshToCephalostat = MakeRigidTransformRows(own.rotation, own.translation);
    placement.scale = std::exp(solution->GetGroup(jaw).parameters[PoseKappa]);
    dentalCase.initialPlacements[jaw] = placement;
  }
  if (!failed.empty())
  {
    // From a wrong place the right one is not found: what has failed is searched for again.
    dentalCase.warnings.push_back(name + ": jaws." + failed + ": failed, and is no start");
  }
  else if (dentalCase.initialPlacements.empty())
  {
    itkDentalInputErrorMacro(name, "jaws", "none of them was registered", "start from a result that has a jaw");
  }
  const auto geometry = CephalometricGeometry::New();
  CopyToGeometry(solution->GetResult().geometry, 1.0, *geometry);
  dentalCase.initialGeometry = geometry.GetPointer();
}
} // namespace

void
ReadInitialAlignment(const std::string & fileName, DentalCase & dentalCase)
{
  std::error_code error;
  auto            reader = CaseResultFileReader::New();
  reader->SetFileName(fileName);
  if (fs::is_directory(fileName, error))
  {
    TakeResultAsStart(reader, fileName, dentalCase);
    return;
  }
  const JsonDocument document = JsonDocument::ReadFile(fileName);
  if (document.GetRoot().IsObject() && document.GetRoot().Find("schema"))
  {
    TakeResultAsStart(reader, fileName, dentalCase);
    return;
  }
  ReadInit(document.GetRoot(), dentalCase);
  const auto & warnings = document.GetWarnings();
  dentalCase.warnings.insert(dentalCase.warnings.end(), warnings.begin(), warnings.end());
}

void
ParseResultAsStart(const std::string & text, const std::string & sourceName, DentalCase & dentalCase)
{
  auto reader = CaseResultFileReader::New();
  reader->SetFileName(sourceName);
  reader->SetText(text);
  TakeResultAsStart(reader, sourceName, dentalCase);
}

namespace
{
/** A file that a case yet to be drawn names may be the one that the drawing is to be written to. */
bool
IsYetToBeWritten(const JsonNode & root, const char * key, const fs::path & directory)
{
  const auto      node = root.Find(key);
  std::error_code ignored;
  return node && node->IsString() && !node->AsString().empty() &&
         !fs::exists(directory / fs::u8path(node->AsString()), ignored);
}

DentalCase
InterpretDentalCase(const JsonDocument & document,
                    const std::string &  fileName,
                    const fs::path &     directory,
                    bool                 isDrawn = true)
{
  const JsonNode root = document.GetRoot();
  if (!root.IsObject())
  {
    root.Fail("is no JSON object", "a case file is { \"upper\": ..., \"contours\": ... }");
  }
  root.WarnAboutUnknownFields({ "upper",
                                "lower",
                                "upper_labels",
                                "lower_labels",
                                "crowns",
                                "mesh_unit",
                                "occlusion",
                                "cephalogram",
                                "geometry",
                                "contours",
                                "cephalometric_landmarks",
                                "markups_spacing_mm",
                                "views",
                                "traced_side",
                                "numbering",
                                "landmarks_3d",
                                "landmarks_2d",
                                "stock_outlines",
                                "init",
                                "exclude",
                                "fix" });
  DentalCase dentalCase;
  dentalCase.fileName = fileName;

  dentalCase.upperFile = FindFile(root, "upper", directory);
  dentalCase.lowerFile = FindFile(root, "lower", directory);
  // Who draws needs the radiograph alone.
  if (isDrawn && dentalCase.upperFile.empty() && dentalCase.lowerFile.empty())
  {
    itkDentalInputErrorMacro(fileName, "upper", "neither \"upper\" nor \"lower\" is given", "name at least one scan");
  }
  for (const bool upper : { true, false })
  {
    const std::string key = upper ? "upper_labels" : "lower_labels";
    const std::string labels = FindFile(root, key, directory);
    if (!labels.empty() && (upper ? dentalCase.upperFile : dentalCase.lowerFile).empty())
    {
      root.Get(key).Fail("there is no scan of that jaw to label", "name the scan too, or leave the labels out");
    }
    (upper ? dentalCase.upperLabelsFile : dentalCase.lowerLabelsFile) = labels;
  }
  if (const auto crowns = root.Find("crowns"))
  {
    dentalCase.crowns = Interpret(*crowns, CrownsFromString);
  }
  if (isDrawn && !root.Find("contours") && !root.Find("cephalometric_landmarks") && !root.Find("views"))
  {
    itkDentalInputErrorMacro(fileName,
                             "contours",
                             "missing, and so are cephalometric_landmarks",
                             "name the file with the tracing or the one with the landmarks");
  }
  dentalCase.landmarks3DFile = FindFile(root, "landmarks_3d", directory);
  dentalCase.landmarks2DFile = FindFile(root, "landmarks_2d", directory);
  dentalCase.stockOutlinesFile = FindFile(root, "stock_outlines", directory);

  if (const auto unit = root.Find("mesh_unit"))
  {
    dentalCase.millimetresPerUnit = Interpret(*unit, MillimetresPerUnitFromString);
    dentalCase.meshUnit = unit->AsString();
  }
  if (const auto occlusion = root.Find("occlusion"))
  {
    if (occlusion->GetKind() == JsonNode::KindEnum::Boolean)
    {
      dentalCase.occlusion = occlusion->AsBoolean() ? OcclusionEnum::Yes : OcclusionEnum::No;
    }
    else
    {
      dentalCase.occlusion = Interpret(*occlusion, OcclusionFromString);
    }
  }
  if (const auto side = root.Find("traced_side"))
  {
    dentalCase.tracedSide = Interpret(*side, TracedSideFromString);
    dentalCase.tracedSideIsGiven = true;
  }
  if (const auto numbering = root.Find("numbering"))
  {
    dentalCase.numbering = Interpret(*numbering, ToothCode::NumberingFromString);
  }
  if (isDrawn || !IsYetToBeWritten(root, "contours", directory))
  {
    ReadContourFiles(root, directory, dentalCase);
  }
  dentalCase.markupsSpacing = ReadMarkupsSpacing(root);
  std::vector<std::string> landmarkWarnings;
  if (isDrawn || !IsYetToBeWritten(root, "cephalometric_landmarks", directory))
  {
    const CaseLandmarkField landmarks = ReadCephalometricLandmarks(root, directory, dentalCase.numbering);
    dentalCase.cephalometricLandmarksFile = landmarks.fileName;
    dentalCase.cephalometricLandmarks = landmarks.landmarks;
    landmarkWarnings = landmarks.warnings;
  }
  if (const auto cephalogram = root.Find("cephalogram"))
  {
    ReadCephalogram(*cephalogram, directory, dentalCase);
  }
  if (const auto geometry = root.Find("geometry"))
  {
    ReadGeometry(*geometry, dentalCase);
  }
  if (const auto views = root.Find("views"))
  {
    ReadDentalViews(*views, directory, dentalCase, landmarkWarnings);
  }
  if (const auto init = root.Find("init"))
  {
    ReadInit(*init, dentalCase);
  }
  if (const auto exclude = root.Find("exclude"))
  {
    for (std::size_t i = 0; i < exclude->GetSize(); ++i)
    {
      const JsonNode code = exclude->At(i);
      try
      {
        ExcludeTooth(dentalCase, code.IsNumber() ? std::to_string(code.AsInteger(0, 99)) : code.AsString());
      }
      catch (const std::invalid_argument & error)
      {
        code.Fail(error.what(), "correct the code or the numbering");
      }
    }
  }
  if (const auto fix = root.Find("fix"))
  {
    for (std::size_t i = 0; i < fix->GetSize(); ++i)
    {
      Interpret(fix->At(i), [&dentalCase](const std::string & text) {
        FixParameter(dentalCase, text);
        return 0;
      });
    }
  }
  dentalCase.warnings = document.GetWarnings();
  dentalCase.warnings.insert(dentalCase.warnings.end(), landmarkWarnings.begin(), landmarkWarnings.end());
  return dentalCase;
}
} // namespace

namespace
{
/** Its sum is that of the bytes that are interpreted: by its name another file may be found later. */
DentalCase
ReadDentalCaseFile(const std::string & fileName, bool isDrawn)
{
  const std::string text = ReadTextFile(fileName, "a JSON file");
  DentalCase        dentalCase =
    InterpretDentalCase(JsonDocument::Parse(text, fileName), fileName, fs::path(fileName).parent_path(), isDrawn);
  dentalCase.fileSHA256 = ComputeSHA256(text);
  return dentalCase;
}
} // namespace

DentalCase
ReadDentalCase(const std::string & fileName)
{
  return ReadDentalCaseFile(fileName, true);
}

DentalCase
ReadDentalCaseToDraw(const std::string & fileName)
{
  return ReadDentalCaseFile(fileName, false);
}

bool
IsDentalCaseFile(const std::string & fileName)
{
  try
  {
    const auto root = JsonDocument::ReadFile(fileName).GetRoot();
    const auto names = [&](const char * field) {
      const auto node = root.Find(field);
      return node && node->IsString();
    };
    // A result has a schema. A file of contours or of landmarks has lists by jaw, not the names of scans.
    return root.IsObject() && !root.Find("schema") && (names("upper") || names("lower")) &&
           (root.Find("contours") || root.Find("cephalometric_landmarks") || root.Find("cephalogram"));
  }
  catch (const DentalInputError &)
  {
    return false;
  }
}

DentalCase
ParseDentalCase(const std::string & text, const std::string & sourceName, const std::string & folder)
{
  return InterpretDentalCase(JsonDocument::Parse(text, sourceName), sourceName, fs::path(folder));
}

DentalCase
ParseDentalCaseToDraw(const std::string & text, const std::string & sourceName, const std::string & folder)
{
  return InterpretDentalCase(JsonDocument::Parse(text, sourceName), sourceName, fs::path(folder), false);
}
} // namespace itk

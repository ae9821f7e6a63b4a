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
#include "itkDentalViewReader.h"

#include "itkASCIICharacter.h"
#include "itkCaseFileFields.h"
#include "itkCephalogramFileReader.h"
#include "itkFirstViewName.h"
#include "itkShortNumber.h"

#include <algorithm>

namespace itk
{
namespace
{
namespace fs = std::filesystem;
using GeometryType = CephalometricGeometry;
using DirectionEnum = GeometryType::DirectionEnum;

/** One of two words. */
bool
IsSecond(const JsonNode & node, const char * first, const char * second)
{
  const std::string & text = node.AsString();
  if (text != first && text != second)
  {
    node.Fail("\"" + text + "\" is neither \"" + first + "\" nor \"" + second + "\"", "write one of them");
  }
  return text == second;
}

/** As the case says it, else as the picture's DICOM tags do. */
DirectionEnum
FindDirection(const JsonNode & view, const fs::path & directory)
{
  const auto cephalogram = view.Find("cephalogram");
  if (!view.Find("direction") && cephalogram && cephalogram->Find("image"))
  {
    auto image = CephalogramFileReader::New();
    image->SetFileName(FindFile(*cephalogram, "image", directory));
    image->UpdateOutputInformation();
    if (image->HasRadiographDirection())
    {
      return image->GetRadiographDirection();
    }
  }
  return IsSecond(view.Get("direction"), "lateral", "frontal") ? DirectionEnum::Frontal : DirectionEnum::Lateral;
}

/** A name stands in results, messages and file names. */
std::string
ReadName(const JsonNode & node, const DentalCase & dentalCase)
{
  const std::string & name = node.AsString();
  if (!IsViewName(name))
  {
    node.Fail("is no short name", "use letters, digits, - and _, as in \"frontal\"");
  }
  if (name == FirstViewName || std::any_of(dentalCase.views.begin(),
                                           dentalCase.views.end(),
                                           [&](const DentalView & view) { return view.name == name; }))
  {
    node.Fail("there is a view \"" + name + "\" already",
              std::string("give each its own name; the case itself is \"") + FirstViewName + '"');
  }
  return name;
}

void
ReadViewCephalogram(const JsonNode & node, const fs::path & directory, DentalView & view)
{
  node.WarnAboutUnknownFields({ "image", "image_size", "pixel_spacing_mm", "spacing_plane", "patient_left", "facing" });
  view.imageFile = FindFile(node, "image", directory);
  view.imageSize = ReadImageSize(node);
  view.pixelSpacing = ReadPixelSpacing(node);
  const bool isLateral = view.direction == DirectionEnum::Lateral;
  if (const auto plane = node.Find("spacing_plane"))
  {
    view.spacingPlaneIsGiven = true;
    view.spacingAtMidsagittalPlane = IsSecond(*plane, "detector", isLateral ? "midsagittal" : "midcoronal");
  }
  const char * const other = isLateral ? "patient_left" : "facing";
  if (const auto side = node.Find(other))
  {
    side->Fail(isLateral ? "is of a frontal view" : "is of a lateral view",
               isLateral ? "say where the patient faces: \"facing\""
                         : "say where the patient's left is: \"patient_left\"");
  }
  if (const auto side = node.Find("patient_left"))
  {
    view.patientLeft = IsLeft(*side) ? GeometryType::PatientLeftEnum::Left : GeometryType::PatientLeftEnum::Right;
  }
  if (const auto side = node.Find("facing"))
  {
    view.facing = IsLeft(*side) ? GeometryType::FacingEnum::Left : GeometryType::FacingEnum::Right;
  }
}

void
ReadViewGeometry(const JsonNode & node, DentalView & view)
{
  const bool         isLateral = view.direction == DirectionEnum::Lateral;
  const char * const distance = isLateral ? "source_to_midsagittal_mm" : "source_to_midcoronal_mm";
  node.WarnAboutUnknownFields({ distance,
                                "source_to_detector_mm",
                                isLateral ? "source_side" : "source",
                                "principal_point_px",
                                "principal_point_sigma_px" });
  if (const auto value = node.Find(distance))
  {
    view.sourceToMidsagittal = MachineDistance(*value);
  }
  if (const auto value = node.Find("source_to_detector_mm"))
  {
    view.sourceToDetector = MachineDistance(*value);
  }
  if (view.sourceToMidsagittal && view.sourceToDetector && *view.sourceToDetector <= *view.sourceToMidsagittal)
  {
    node.Get("source_to_detector_mm")
      .Fail("the detector is not behind the head",
            std::string("source_to_detector_mm is larger than ") + distance + "; were they exchanged?");
  }
  if (const auto side = node.Find("source_side"); side && isLateral)
  {
    view.sourceSide = IsLeft(*side) ? GeometryType::SourceSideEnum::Left : GeometryType::SourceSideEnum::Right;
  }
  if (const auto source = node.Find("source"); source && !isLateral)
  {
    view.frontalSource = IsSecond(*source, "behind", "front") ? GeometryType::FrontalSourceEnum::InFront
                                                              : GeometryType::FrontalSourceEnum::Behind;
  }
  view.principalPoint = ReadPrincipalPoint(node);
  if (const auto sigma = node.Find("principal_point_sigma_px"))
  {
    const double value = sigma->AsNumber();
    if (!(value >= 0.0 && value < 10000.0))
    {
      sigma->Fail(ShortNumber(value) + " px is not possible", "give pixels, 1 sd an axis: 4 where nothing is known");
    }
    view.principalPointSigma = value;
  }
}
} // namespace

void
ReadDentalViews(const JsonNode &           node,
                const fs::path &           directory,
                DentalCase &               dentalCase,
                std::vector<std::string> & warnings)
{
  if (!node.IsArray())
  {
    node.Fail("is no list", R"(write [{"name": "frontal", "direction": "frontal", ...}])");
  }
  // More than any machine takes; each costs a pass over the scans.
  constexpr std::size_t limit = 8;
  if (node.GetSize() > limit)
  {
    node.Fail("has " + std::to_string(node.GetSize()) + " views", "give at most 8");
  }
  for (std::size_t i = 0; i < node.GetSize(); ++i)
  {
    const JsonNode own = node.At(i);
    own.WarnAboutUnknownFields({ "name",
                                 "direction",
                                 "cephalogram",
                                 "geometry",
                                 "contours",
                                 "cephalometric_landmarks",
                                 "markups_spacing_mm",
                                 "landmarks_2d",
                                 "same_head_position" });
    DentalView view;
    view.direction = FindDirection(own, directory);
    view.name = own.Find("name") ? ReadName(own.Get("name"), dentalCase) : "frontal";
    if (!own.Find("name") && (view.direction == DirectionEnum::Lateral || !dentalCase.views.empty()))
    {
      own.Get("name");
    }
    if (const auto cephalogram = own.Find("cephalogram"))
    {
      ReadViewCephalogram(*cephalogram, directory, view);
    }
    if (const auto geometry = own.Find("geometry"))
    {
      ReadViewGeometry(*geometry, view);
    }
    view.contoursFile = FindFile(own, "contours", directory);
    view.markupsSpacing = ReadMarkupsSpacing(own);
    const CaseLandmarkField landmarks = ReadCephalometricLandmarks(own, directory, dentalCase.numbering);
    view.cephalometricLandmarksFile = landmarks.fileName;
    view.cephalometricLandmarks = landmarks.landmarks;
    warnings.insert(warnings.end(), landmarks.warnings.begin(), landmarks.warnings.end());
    view.landmarks2DFile = FindFile(own, "landmarks_2d", directory);
    if (view.contoursFile.empty() && view.cephalometricLandmarksFile.empty() && view.cephalometricLandmarks.IsNull())
    {
      own.Fail("has neither contours nor cephalometric_landmarks", "name what was drawn on it, or leave the view out");
    }
    if (const auto same = own.Find("same_head_position"))
    {
      view.sameHeadPosition = same->AsBoolean();
    }
    dentalCase.views.push_back(view);
  }
}

bool
IsViewName(const std::string & name)
{
  return !name.empty() && name.size() <= 40 &&
         std::all_of(name.begin(), name.end(), [](char c) { return IsASCIIAlphanumeric(c) || c == '-' || c == '_'; });
}
} // namespace itk

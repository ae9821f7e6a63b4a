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
#include "itkDentalViewLoader.h"

#include "itkCephalogramFileReader.h"
#include "itkCephalometricLandmarkFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalInputError.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace itk
{
namespace
{
using GeometryType = CephalometricGeometry;
using DirectionEnum = GeometryType::DirectionEnum;

/** px: of a principal point of which nothing is known. */
constexpr double UsualPrincipalPointSigma = 4.0;
/** Share of the picture's width: where the case does not name the ear rods, they are near its middle. */
constexpr double GuessedPrincipalPointShare = 0.1;

std::string
FieldOf(const DentalView & view, const std::string & field)
{
  return "views." + view.name + '.' + field;
}

void
Warn(DentalCaseData & data, const DentalView & view, const std::string & field, const std::string & text)
{
  data.warnings.push_back(data.description.fileName + ": " + FieldOf(view, field) + ": " + text);
}

/** The picture's where there is one, else as the case states it, else as a file of drawings does. */
void
SettleSize(const DentalCaseData & data, DentalViewData & view)
{
  const auto & stated = view.description.imageSize;
  if (view.image.IsNull())
  {
    view.imageSize = stated.value_or(view.imageSize);
    return;
  }
  const auto size = view.image->GetLargestPossibleRegion().GetSize();
  view.imageSize = { { static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]) } };
  if (stated && *stated != view.imageSize)
  {
    std::ostringstream problem;
    problem << "is " << (*stated)[0] << " x " << (*stated)[1] << ", but the image is " << size[0] << " x " << size[1];
    itkDentalInputErrorMacro(data.description.fileName,
                             FieldOf(view.description, "cephalogram.image_size"),
                             problem.str(),
                             "name the right image or leave the field out");
  }
}

/** Tells a reader of drawings which picture they are of. */
void
PrepareViewReader(const DentalCaseData &        data,
                  const DentalViewData &        view,
                  const CephalogramFileReader * image,
                  AnnotationFileReaderBase &    reader)
{
  reader.SetImageFileName(view.description.imageFile);
  const bool header = image != nullptr && image->HasHeaderSpacing();
  if (header || data.description.markupsSpacing)
  {
    AnnotationFileReaderBase::VectorType spacing, origin;
    for (unsigned int d = 0; d < 2; ++d)
    {
      spacing[d] =
        data.description.markupsSpacing ? (*data.description.markupsSpacing)[d] : image->GetHeaderSpacing()[d];
      origin[d] = header ? image->GetHeaderOrigin()[d] : 0.0;
    }
    reader.SetMarkupsSpacing(spacing);
    reader.SetMarkupsOrigin(origin);
  }
}

void
LoadViewContours(DentalCaseData & data, const CephalogramFileReader * image, DentalViewData & view)
{
  if (view.description.contoursFile.empty())
  {
    return;
  }
  auto reader = DentalContourFileReader::New();
  reader->SetFileName(view.description.contoursFile);
  PrepareViewReader(data, view, image, *reader);
  if (data.description.numbering)
  {
    reader->SetNumbering(*data.description.numbering);
  }
  if (view.imageSize[0] > 0)
  {
    reader->SetImageSize({ { view.imageSize[0], view.imageSize[1] } });
  }
  reader->Update();
  data.warnings.insert(data.warnings.end(), reader->GetWarnings().begin(), reader->GetWarnings().end());
  view.imageSize = { { static_cast<unsigned int>(reader->GetReadImageSize()[0]),
                       static_cast<unsigned int>(reader->GetReadImageSize()[1]) } };
  const auto & excluded = data.description.excludedTeeth;
  for (const ToothCode::JawEnum jaw : { ToothCode::JawEnum::Upper, ToothCode::JawEnum::Lower })
  {
    auto kept = DentalContour::New();
    for (const auto & polyline : reader->GetOutput(jaw)->GetPolylines())
    {
      if (!polyline.code.IsKnown() || std::find(excluded.begin(), excluded.end(), polyline.code) == excluded.end())
      {
        kept->AddPolyline(polyline);
      }
    }
    if (kept->GetNumberOfPoints() > 0)
    {
      view.contours[jaw == ToothCode::JawEnum::Upper ? 0 : 1] = kept;
    }
  }
}

void
LoadViewLandmarks(DentalCaseData & data, const CephalogramFileReader * image, DentalViewData & view)
{
  const DentalView & description = view.description;
  const bool         own = description.cephalometricLandmarksFile.empty();
  if (own && description.cephalometricLandmarks.IsNull())
  {
    return;
  }
  if (own)
  {
    view.landmarks = CephalometricLandmarkSet::New();
    view.landmarks->Graft(description.cephalometricLandmarks);
  }
  else
  {
    auto reader = CephalometricLandmarkFileReader::New();
    reader->SetFileName(description.cephalometricLandmarksFile);
    reader->SetNumbering(data.description.numbering.value_or(ToothCode::NumberingEnum::Quadrant));
    PrepareViewReader(data, view, image, *reader);
    reader->Update();
    data.warnings.insert(data.warnings.end(), reader->GetWarnings().begin(), reader->GetWarnings().end());
    view.landmarks = reader->GetOutput();
    view.landmarks->DisconnectPipeline();
  }
  if (view.imageSize[0] == 0)
  {
    itkDentalInputErrorMacro(data.description.fileName,
                             FieldOf(description, "cephalogram.image_size"),
                             "missing: landmarks without a tracing do not say how large the radiograph is",
                             "name the image, or add \"image_size\": [width, height] to the view's \"cephalogram\"");
  }
  CheckLandmarksInImage(*view.landmarks,
                        view.imageSize,
                        own ? data.description.fileName : description.cephalometricLandmarksFile,
                        own ? FieldOf(description, "cephalometric_landmarks.") : "");
}

/** Where the source and the patient stood: the case before DICOM before the default. */
void
SettleDirection(DentalCaseData & data, const CephalogramFileReader * image, DentalViewData & view)
{
  const DentalView & description = view.description;
  GeometryType &     geometry = *view.geometry;
  geometry.SetDirection(description.direction);
  view.directionProvenance = "case file";
  if (image != nullptr && image->HasRadiographDirection())
  {
    const auto & provenance = image->GetProvenance().at("direction");
    if (image->GetRadiographDirection() == description.direction)
    {
      view.directionProvenance += ", as " + provenance;
    }
    else
    {
      Warn(data, description, "direction", "the DICOM file says otherwise (" + provenance + "); the case's is used");
    }
  }
  const auto settle =
    [&](const auto & given, const auto & dicom, ValueSourceEnum & source, const char * field, auto && apply) {
      if (given && dicom && *given != *dicom)
      {
        Warn(data, description, field, "the case and the DICOM file contradict each other; the case's is used");
      }
      if (given || dicom)
      {
        apply(given ? *given : *dicom);
        source = given ? ValueSourceEnum::Given : ValueSourceEnum::DICOM;
      }
    };
  if (description.direction == DirectionEnum::Lateral)
  {
    std::optional<GeometryType::FacingEnum> facing;
    if (image != nullptr && image->HasFacing())
    {
      facing = image->GetFacing();
    }
    settle(description.facing, facing, view.side, "cephalogram.facing", [&](auto value) { geometry.SetFacing(value); });
    settle(description.sourceSide,
           std::optional<GeometryType::SourceSideEnum>(),
           view.source,
           "geometry.source_side",
           [&](auto value) { geometry.SetSourceSide(value); });
    return;
  }
  std::optional<GeometryType::PatientLeftEnum>   patientLeft;
  std::optional<GeometryType::FrontalSourceEnum> source;
  if (image != nullptr && image->HasPatientLeft())
  {
    patientLeft = image->GetPatientLeft();
  }
  if (image != nullptr && image->HasFrontalSource())
  {
    source = image->GetFrontalSource();
  }
  settle(description.patientLeft, patientLeft, view.side, "cephalogram.patient_left", [&](auto value) {
    geometry.SetPatientLeft(value);
  });
  settle(description.frontalSource, source, view.source, "geometry.source", [&](auto value) {
    geometry.SetFrontalSource(value);
  });
}

void
SettleViewGeometry(DentalCaseData & data, const CephalogramFileReader * image, DentalViewData & view)
{
  const DentalView & description = view.description;
  GeometryType &     geometry = *view.geometry;
  if (description.sourceToDetector || (image != nullptr && image->HasSourceToDetectorDistance()))
  {
    geometry.SetSourceToDetectorDistance(description.sourceToDetector ? *description.sourceToDetector
                                                                      : image->GetSourceToDetectorDistance());
    view.sourceToDetector = description.sourceToDetector ? ValueSourceEnum::Given : ValueSourceEnum::DICOM;
  }
  if (description.sourceToEarRods || (image != nullptr && image->HasSourceToMidsagittalDistance()))
  {
    geometry.SetSourceToMidsagittalDistance(description.sourceToEarRods ? *description.sourceToEarRods
                                                                        : image->GetSourceToMidsagittalDistance());
    view.sourceToEarRods = description.sourceToEarRods ? ValueSourceEnum::Given : ValueSourceEnum::DICOM;
  }
  if (geometry.GetSourceToDetectorDistance() <= geometry.GetSourceToMidsagittalDistance())
  {
    std::ostringstream problem;
    problem << "the source-to-detector distance " << geometry.GetSourceToDetectorDistance()
            << " mm is not larger than the distance to the ear rods " << geometry.GetSourceToMidsagittalDistance()
            << " mm";
    itkDentalInputErrorMacro(
      data.description.fileName, FieldOf(description, "geometry"), problem.str(), "give both distances");
  }
  SettleDirection(data, image, view);

  const double magnification = geometry.GetSourceToDetectorDistance() / geometry.GetSourceToMidsagittalDistance();
  GeometryType::PixelSpacingType spacing;
  if (description.pixelSpacing)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      spacing[d] = (*description.pixelSpacing)[d] * (description.spacingAtEarRods ? magnification : 1.0);
    }
    view.pixelSpacing = ValueSourceEnum::Given;
    view.spacingProvenance = description.spacingAtEarRods ? "case file, at the ear rods, converted to the detector's"
                                                          : "case file, detector plane";
  }
  else if (image != nullptr && image->HasPixelSpacing())
  {
    spacing =
      image->GetDetectorPixelSpacing(geometry.GetSourceToDetectorDistance(), geometry.GetSourceToMidsagittalDistance());
    const bool isDicom = std::string(image->GetFileFormat()) == "DICOM";
    view.pixelSpacing = isDicom ? ValueSourceEnum::DICOM : ValueSourceEnum::Given;
    view.spacingSource = isDicom ? ScalePrior::SpacingSource::Dicom : ScalePrior::SpacingSource::Given;
    view.spacingProvenance = image->GetProvenance().at("pixel_spacing");
  }
  else
  {
    // Radiographs of one machine are alike; how far it is off is estimated.
    const bool known = data.geometry->HasPixelSpacing();
    spacing = known ? data.geometry->GetPixelSpacing() : GeometryType::PixelSpacingType(0.25);
    view.pixelSpacing = ValueSourceEnum::Estimated;
    view.spacingSource = ScalePrior::SpacingSource::Default;
    view.spacingProvenance = known ? "unknown: begun with the first radiograph's" : "unknown: begun with 0.25 mm";
    Warn(data, description, "cephalogram.pixel_spacing_mm", "is not known and estimated along");
  }
  geometry.SetPixelSpacing(spacing);

  GeometryType::PixelIndexType principal;
  if (description.principalPoint)
  {
    principal[0] = (*description.principalPoint)[0];
    principal[1] = (*description.principalPoint)[1];
    view.principalPoint = ValueSourceEnum::Given;
    view.principalPointSigma = description.principalPointSigma.value_or(UsualPrincipalPointSigma);
  }
  else
  {
    principal[0] = 0.5 * (view.imageSize[0] - 1.0);
    principal[1] = 0.5 * (view.imageSize[1] - 1.0);
    view.principalPoint = ValueSourceEnum::Estimated;
    view.principalPointSigma = description.principalPointSigma.value_or(GuessedPrincipalPointShare * view.imageSize[0]);
    Warn(data,
         description,
         "geometry.principal_point_px",
         "is not given: the picture's middle is begun with, and the view tells little of shifts");
  }
  geometry.SetPrincipalPoint(principal);
}
} // namespace

void
LoadDentalViews(DentalCaseData & data)
{
  for (const DentalView & description : data.description.views)
  {
    DentalViewData view;
    view.description = description;
    view.geometry = GeometryType::New();
    CephalogramFileReader::Pointer image;
    if (!description.imageFile.empty())
    {
      image = CephalogramFileReader::New();
      image->SetFileName(description.imageFile);
      image->Update();
      view.image = image->GetOutput();
      data.warnings.insert(data.warnings.end(), image->GetWarnings().begin(), image->GetWarnings().end());
    }
    SettleSize(data, view);
    LoadViewContours(data, image, view);
    LoadViewLandmarks(data, image, view);
    SettleViewGeometry(data, image, view);
    data.views.push_back(view);
  }
}
} // namespace itk

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

#include "itkDentalCaseLoader.h"
#include "itkDentalInputError.h"
#include "itkDentalRadiographLoader.h"

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

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

/** Where a frontal view's patient's left and source are: the case before DICOM before the default. */
void
SettleFrontal(DentalRadiographLoader & loader, DentalViewData & view)
{
  const CephalogramFileReader *                  image = loader.GetImageReader();
  const DentalView &                             description = view.description;
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
  const auto settle =
    [&](const auto & given, const auto & dicom, ValueSourceEnum & from, const char * field, auto && apply) {
      if (given && dicom && *given != *dicom)
      {
        loader.Warn(field, "the case and the DICOM file contradict each other; the case's is used");
      }
      if (given || dicom)
      {
        apply(given ? *given : *dicom);
        from = given ? ValueSourceEnum::Given : ValueSourceEnum::DICOM;
      }
    };
  settle(description.patientLeft, patientLeft, view.sources.facing, "cephalogram.patient_left", [&](auto value) {
    view.geometry->SetPatientLeft(value);
  });
  settle(description.frontalSource, source, view.sources.sourceSide, "geometry.source", [&](auto value) {
    view.geometry->SetFrontalSource(value);
  });
}
} // namespace

void
CompleteViewGeometry(const DentalCaseData & data, DentalViewData & view, std::vector<std::string> & warnings)
{
  const auto warn = [&](const char * field, const char * text) {
    warnings.push_back(data.description.fileName + (data.description.fileName.empty() ? "" : ": ") + "views." +
                       view.description.name + '.' + field + ": " + text);
  };
  CephalometricGeometry & geometry = *view.geometry;
  if (!geometry.HasPixelSpacing())
  {
    // Radiographs of one machine are alike; how far it is off is estimated.
    const bool known = data.geometry->HasPixelSpacing();
    geometry.SetPixelSpacing(known ? data.geometry->GetPixelSpacing() : GeometryType::PixelSpacingType(0.25));
    view.spacingProvenance = known ? "unknown: begun with the first radiograph's" : "unknown: begun with 0.25 mm";
    warn("cephalogram.pixel_spacing_mm", "is not known and estimated along");
  }
  const auto & sigma = view.description.principalPointSigma;
  if (view.HasPrincipalPoint())
  {
    view.principalPointSigma = sigma.value_or(UsualPrincipalPointSigma);
    return;
  }
  GeometryType::PixelIndexType principal;
  principal[0] = 0.5 * (view.imageSize[0] - 1.0);
  principal[1] = 0.5 * (view.imageSize[1] - 1.0);
  geometry.SetPrincipalPoint(principal);
  view.principalPointSigma = sigma.value_or(GuessedPrincipalPointShare * view.imageSize[0]);
  warn("geometry.principal_point_px",
       "is not given: the picture's middle is begun with, and the view tells little of shifts");
}

void
LoadDentalViews(DentalCaseData & data)
{
  const DentalCase & dentalCase = data.description;
  for (const DentalView & description : dentalCase.views)
  {
    DentalViewData view;
    view.description = description;
    DentalRadiographLoader loader(
      dentalCase, description, description.direction, "views." + description.name + '.', view, data.warnings);
    loader.LoadImage();
    std::error_code error;
    if (!description.imageFile.empty() && !dentalCase.imageFile.empty() &&
        std::filesystem::equivalent(
          std::filesystem::u8path(description.imageFile), std::filesystem::u8path(dentalCase.imageFile), error))
    {
      loader.Warn("cephalogram.image", "is the file of the first radiograph: name the one of this view");
    }
    loader.SettleGeometry();
    const bool isFrontal = description.direction == DirectionEnum::Frontal;
    view.contours = loader.LoadContours(
      {}, !isFrontal && dentalCase.tracedSideIsGiven && dentalCase.tracedSide == TracedSideEnum::Left);
    if (isFrontal)
    {
      SettleFrontal(loader, view);
      if (view.sidelessContours > 0)
      {
        itkDentalInputErrorMacro(description.contoursFile,
                                 loader.Field("contours"),
                                 std::to_string(view.sidelessContours) +
                                   " contours have codes without a side (U1, L6), and a frontal radiograph shows both",
                                 "give each contour the code of its side: UR1, LL6");
      }
    }
    loader.LoadLandmarks();
    CompleteViewGeometry(data, view, data.warnings);
    data.views.push_back(view);
  }
}
} // namespace itk

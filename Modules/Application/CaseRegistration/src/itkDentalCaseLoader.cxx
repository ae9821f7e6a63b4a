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
#include "itkDentalCaseLoader.h"

#include "itkCephalogramFileReader.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalInputError.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkParallelFor.h"
#include "itkReadDentalMesh.h"
#include "itkReadVTKMesh.h"
#include "itkToothLabelFileReader.h"

#include "itkMultiThreaderBase.h"
#include "itkTimeProbe.h"

#include <algorithm>
#include <array>
#include <exception>
#include <sstream>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;

void
Append(std::vector<std::string> & to, const std::vector<std::string> & from)
{
  to.insert(to.end(), from.begin(), from.end());
}

std::string
Print(PixelSpacingVerdictEnum verdict)
{
  std::ostringstream text;
  text << verdict;
  return text.str();
}

DentalCaseData::MeshType::Pointer
LoadMesh(const std::string & fileName, double millimetresPerUnit)
{
  if (fileName.empty())
  {
    return nullptr;
  }
  auto mesh = IsVTKSurfaceFileName(fileName) ? ReadVTKMesh<DentalCaseData::MeshType>(fileName)
                                             : ReadDentalMesh<DentalCaseData::MeshType>(fileName);
  if (millimetresPerUnit != 1.0)
  {
    for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        it.Value()[d] = static_cast<float>(it.Value()[d] * millimetresPerUnit);
      }
    }
  }
  return mesh;
}

/** Of a file of their own, or of the scan itself where the case wants them. */
void
LoadLabels(DentalCaseData & data)
{
  const DentalCase & description = data.description;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const bool          upper = jaw == JawEnum::Upper;
    const std::string & own = upper ? description.upperLabelsFile : description.lowerLabelsFile;
    const std::string & scan = upper ? description.upperFile : description.lowerFile;
    if (data.GetJaw(jaw).mesh.IsNull() || (own.empty() && description.crowns != CrownsEnum::Labels))
    {
      continue;
    }
    auto reader = ToothLabelFileReader::New();
    reader->SetFileName(own.empty() ? scan : own);
    reader->SetNumberOfPoints(data.GetJaw(jaw).mesh->GetNumberOfPoints());
    reader->Update();
    if (reader->GetJaw() != JawEnum::Unknown && reader->GetJaw() != jaw)
    {
      itkDentalInputErrorMacro(reader->GetFileName(),
                               "",
                               std::string("labels teeth of the ") + (upper ? "lower" : "upper") +
                                 " jaw, but belongs to the " + (upper ? "upper" : "lower") + " one",
                               "exchange the files");
    }
    data.GetJaw(jaw).labels = reader->GetLabels();
  }
}

/** Spacing, distances and facing: the case file before DICOM before the default. */
void
SettleGeometry(const CephalogramFileReader * reader, DentalCaseData & data)
{
  const DentalCase & description = data.description;
  data.geometry = CephalometricGeometry::New();
  const auto settle = [](const auto & given, const auto & fromDicom, auto & source, auto && apply) {
    if (given)
    {
      apply(*given);
      source = ValueSourceEnum::Given;
    }
    else if (fromDicom)
    {
      apply(*fromDicom);
      source = ValueSourceEnum::DICOM;
    }
  };
  std::optional<double>                            dicomDetector;
  std::optional<double>                            dicomMidsagittal;
  std::optional<CephalometricGeometry::FacingEnum> dicomFacing;
  if (reader != nullptr)
  {
    if (reader->HasSourceToDetectorDistance())
    {
      dicomDetector = reader->GetSourceToDetectorDistance();
    }
    if (reader->HasSourceToMidsagittalDistance())
    {
      dicomMidsagittal = reader->GetSourceToMidsagittalDistance();
    }
    if (reader->HasFacing())
    {
      dicomFacing = reader->GetFacing();
    }
  }
  settle(description.sourceToDetector, dicomDetector, data.sources.sourceToDetector, [&](double distance) {
    data.geometry->SetSourceToDetectorDistance(distance);
  });
  settle(description.sourceToMidsagittal, dicomMidsagittal, data.sources.sourceToMidsagittal, [&](double distance) {
    data.geometry->SetSourceToMidsagittalDistance(distance);
  });
  settle(description.facing, dicomFacing, data.sources.facing, [&](CephalometricGeometry::FacingEnum facing) {
    data.geometry->SetFacing(facing);
  });
  if (data.geometry->GetSourceToDetectorDistance() <= data.geometry->GetSourceToMidsagittalDistance())
  {
    std::ostringstream problem;
    problem << "the source-to-detector distance " << data.geometry->GetSourceToDetectorDistance()
            << " mm is not larger than the source-to-midsagittal distance "
            << data.geometry->GetSourceToMidsagittalDistance() << " mm";
    itkDentalInputErrorMacro(description.fileName, "geometry", problem.str(), "give both distances");
  }
  if (description.sourceSide)
  {
    data.geometry->SetSourceSide(*description.sourceSide);
    data.sources.sourceSide = ValueSourceEnum::Given;
  }
  if (description.principalPoint)
  {
    CephalometricGeometry::PixelIndexType principal;
    principal[0] = (*description.principalPoint)[0];
    principal[1] = (*description.principalPoint)[1];
    data.geometry->SetPrincipalPoint(principal);
    data.sources.principalPoint = ValueSourceEnum::Given;
  }
  CephalometricGeometry::PixelSpacingType spacing;
  if (description.pixelSpacing)
  {
    // At the midsagittal plane a pixel shows less than it measures on the detector.
    const double factor = description.spacingAtMidsagittalPlane ? data.geometry->GetSourceToDetectorDistance() /
                                                                    data.geometry->GetSourceToMidsagittalDistance()
                                                                : 1.0;
    spacing[0] = (*description.pixelSpacing)[0] * factor;
    spacing[1] = (*description.pixelSpacing)[1] * factor;
    data.geometry->SetPixelSpacing(spacing);
    data.sources.pixelSpacing = ValueSourceEnum::Given;
    data.spacingProvenance = description.spacingAtMidsagittalPlane
                               ? "case file, midsagittal plane, converted to the detector's"
                               : "case file, detector plane";
    data.spacingVerdict = Print(PixelSpacingVerdictEnum::UserGiven);
  }
  else if (reader != nullptr && reader->HasPixelSpacing())
  {
    data.geometry->SetPixelSpacing(reader->GetDetectorPixelSpacing(data.geometry->GetSourceToDetectorDistance(),
                                                                   data.geometry->GetSourceToMidsagittalDistance()));
    data.sources.pixelSpacing =
      std::string(reader->GetFileFormat()) == "DICOM" ? ValueSourceEnum::DICOM : ValueSourceEnum::Given;
    data.spacingVerdict = Print(reader->GetPixelSpacingVerdict());
    data.spacingProvenance = reader->GetProvenance().at("pixel_spacing");
  }
  else
  {
    data.spacingProvenance =
      reader != nullptr ? reader->GetProvenance().at("pixel_spacing") : "no radiograph and no spacing given";
  }
}
void
LoadContours(DentalCaseData & data)
{
  const DentalCase & description = data.description;
  auto               contourReader = DentalContourFileReader::New();
  contourReader->SetFileName(description.contoursFile);
  if (description.numbering)
  {
    contourReader->SetNumbering(*description.numbering);
  }
  if (data.image.IsNotNull())
  {
    contourReader->SetImageSize(data.image->GetLargestPossibleRegion().GetSize());
  }
  contourReader->Update();
  Append(data.warnings, contourReader->GetWarnings());
  data.imageSize = { { static_cast<unsigned int>(contourReader->GetReadImageSize()[0]),
                       static_cast<unsigned int>(contourReader->GetReadImageSize()[1]) } };
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    DentalContour * contour = contourReader->GetOutput(jaw);
    if (contour->GetNumberOfPoints() > 0)
    {
      data.GetJaw(jaw).contour = DentalContour::New();
      for (const auto & polyline : contour->GetPolylines())
      {
        const auto & excluded = description.excludedTeeth;
        if (!polyline.code.IsKnown() || std::find(excluded.begin(), excluded.end(), polyline.code) == excluded.end())
        {
          data.GetJaw(jaw).contour->AddPolyline(polyline);
        }
      }
    }
  }
}

} // namespace

std::shared_ptr<DentalCaseData>
LoadDentalCase(const DentalCase & description)
{
  TimeProbe probe;
  probe.Start();
  auto data = std::make_shared<DentalCaseData>();
  data->description = description;
  data->warnings = description.warnings;

  // The small files first: a mistake in them should not cost the time of reading the scans.
  CephalogramFileReader::Pointer imageReader;
  if (!description.imageFile.empty())
  {
    imageReader = CephalogramFileReader::New();
    imageReader->SetFileName(description.imageFile);
    imageReader->Update();
    data->image = imageReader->GetOutput();
    const auto size = data->image->GetLargestPossibleRegion().GetSize();
    data->imageSize = { { static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]) } };
    Append(data->warnings, imageReader->GetWarnings());
  }
  SettleGeometry(imageReader, *data);

  if (!description.contoursFile.empty())
  {
    LoadContours(*data);
  }
  if (!description.landmarks3DFile.empty())
  {
    auto landmarkReader = DentalLandmarkFileReader<3>::New();
    landmarkReader->SetFileName(description.landmarks3DFile);
    if (description.numbering)
    {
      landmarkReader->SetNumbering(*description.numbering);
    }
    landmarkReader->Update();
    Append(data->warnings, landmarkReader->GetWarnings());
    data->landmarks3D = landmarkReader->GetOutput();
    data->landmarks3D->DisconnectPipeline();
  }
  // Both at once; of two errors the upper jaw's is told.
  std::array<std::exception_ptr, 2> errors;
  ParallelFor(2, MultiThreaderBase::GetGlobalDefaultNumberOfThreads(), [&](std::size_t jaw) {
    try
    {
      (jaw == 0 ? data->upper : data->lower).mesh =
        LoadMesh(jaw == 0 ? description.upperFile : description.lowerFile, description.millimetresPerUnit);
    }
    catch (...)
    {
      errors[jaw] = std::current_exception();
    }
  });
  for (const std::exception_ptr & error : errors)
  {
    if (error)
    {
      std::rethrow_exception(error);
    }
  }
  LoadLabels(*data);
  probe.Stop();
  data->readSeconds = probe.GetTotal();
  return data;
}
} // namespace itk

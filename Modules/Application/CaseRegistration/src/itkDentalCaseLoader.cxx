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

#include "itkAppendTexts.h"
#include "itkDentalInputError.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkDentalRadiographLoader.h"
#include "itkDentalViewLoader.h"
#include "itkParallelFor.h"
#include "itkReadDentalMesh.h"
#include "itkReadVTKMesh.h"
#include "itkRecordCaseInputs.h"
#include "itkToothLabelFileReader.h"

#include "itkMultiThreaderBase.h"
#include "itkTimeProbe.h"

#include <algorithm>
#include <array>
#include <exception>
#include <sstream>
#include <utility>
#include <vector>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;

DentalCaseData::MeshType::Pointer
LoadMesh(const std::string & fileName, double millimetresPerUnit, std::vector<std::string> & warnings)
{
  if (fileName.empty())
  {
    return nullptr;
  }
  auto mesh = IsVTKSurfaceFileName(fileName) ? ReadVTKMesh<DentalCaseData::MeshType>(fileName)
                                             : ReadDentalMesh<DentalCaseData::MeshType>(fileName, &warnings);
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
                               std::string("labels teeth of the ") + ToString(OtherJaw(jaw)) +
                                 " jaw, but belongs to the " + ToString(jaw) + " one",
                               "exchange the files");
    }
    data.GetJaw(jaw).labels = reader->GetLabels();
  }
}

/** The tracing and the landmarks to register with. */
void
LoadDrawings(DentalRadiographLoader & loader, DentalCaseData & data)
{
  const DentalCase & description = data.description;
  const auto         contours = loader.LoadContours(
    description.contourClassFiles, description.tracedSideIsGiven && description.tracedSide == TracedSideEnum::Left);
  data.upper.contour = contours[0];
  data.lower.contour = contours[1];
  if (data.sidelessContours > 0 && description.tracedSide == TracedSideEnum::Both)
  {
    itkDentalInputErrorMacro(description.fileName,
                             "traced_side",
                             "is \"both\", but " + std::to_string(data.sidelessContours) +
                               " contours have codes without a side (U1, L6)",
                             "give each contour the code of its side, or write \"standard\"");
  }
  loader.LoadLandmarks();
  SettleTracedSide(data);
}

} // namespace

void
PrepareReader(const DentalRadiograph &     description,
              const DentalRadiographData & data,
              AnnotationFileReaderBase &   reader)
{
  reader.SetImageFileName(description.imageFile);
  if (data.markupsGrid)
  {
    AnnotationFileReaderBase::VectorType spacing, origin;
    for (unsigned int i = 0; i < 2; ++i)
    {
      spacing[i] = (*data.markupsGrid)[i];
      origin[i] = (*data.markupsGrid)[2 + i];
    }
    reader.SetMarkupsSpacing(spacing);
    reader.SetMarkupsOrigin(origin);
  }
}

DentalContour::Pointer
WithoutTeeth(const DentalContour & contour, const std::vector<ToothCode> & teeth)
{
  auto kept = DentalContour::New();
  for (const auto & polyline : contour.GetPolylines())
  {
    if (!polyline.code.IsKnown() || std::find(teeth.begin(), teeth.end(), polyline.code) == teeth.end())
    {
      kept->AddPolyline(polyline);
    }
  }
  return kept;
}

void
CheckLandmarksInImage(const CephalometricLandmarkSet &    landmarks,
                      const std::array<unsigned int, 2> & imageSize,
                      const std::string &                 fileName,
                      const std::string &                 prefix)
{
  constexpr double margin = 0.1;
  for (const auto & landmark : landmarks.GetLandmarks())
  {
    for (unsigned int i = 0; i < 2; ++i)
    {
      const double size = imageSize[i];
      if (!(landmark.point[i] >= -0.5 - margin * size && landmark.point[i] <= size - 0.5 + margin * size))
      {
        std::ostringstream problem;
        problem << "(" << landmark.point[0] << ", " << landmark.point[1] << ") lies far outside the image of "
                << imageSize[0] << " x " << imageSize[1] << " pixels";
        itkDentalInputErrorMacro(fileName,
                                 prefix + landmark.name,
                                 problem.str(),
                                 "give pixels of this image: were they in mm, or marked on another copy of it?");
      }
    }
  }
}

void
LoadCaseDrawings(DentalCaseData & data)
{
  DentalRadiographLoader loader(
    data.description, data.description, CephalometricGeometry::DirectionEnum::Lateral, "", data, data.warnings);
  LoadDrawings(loader, data);
}

/** Of both jaws, and of any picture: of a stock only the shapes are compared. */
static DentalContour::Pointer
LoadStockOutlines(const DentalCase & description)
{
  if (description.stockOutlinesFile.empty())
  {
    return nullptr;
  }
  auto reader = DentalContourFileReader::New();
  reader->SetFileName(description.stockOutlinesFile);
  if (description.numbering)
  {
    reader->SetNumbering(*description.numbering);
  }
  reader->Update();
  auto stock = DentalContour::New();
  for (const auto jaw : { ToothCode::JawEnum::Upper, ToothCode::JawEnum::Lower })
  {
    for (const auto & polyline : reader->GetOutput(jaw)->GetPolylines())
    {
      if (polyline.closed)
      {
        stock->AddPolyline(polyline);
      }
    }
  }
  if (stock->GetNumberOfPoints() == 0)
  {
    itkDentalInputErrorMacro(description.stockOutlinesFile,
                             "contours",
                             "none of its outlines is closed",
                             "a stock outline is that of a whole tooth, as a standard tracing has it");
  }
  return stock;
}

std::shared_ptr<DentalCaseData>
LoadDentalCase(const DentalCase & description)
{
  TimeProbe probe;
  probe.Start();
  auto data = std::make_shared<DentalCaseData>();
  data->description = description;
  const std::vector<CaseInputState> before = LookAtCaseInputs(description);
  data->warnings = description.warnings;

  // The small files first: a mistake in them should not cost the time of reading the scans.
  DentalRadiographLoader loader(
    description, description, CephalometricGeometry::DirectionEnum::Lateral, "", *data, data->warnings);
  loader.LoadImage();
  loader.SettleGeometry();
  LoadDrawings(loader, *data);
  LoadDentalViews(*data);
  if (!description.landmarks3DFile.empty())
  {
    auto landmarkReader = DentalLandmarkFileReader<3>::New();
    landmarkReader->SetFileName(description.landmarks3DFile);
    if (description.numbering)
    {
      landmarkReader->SetNumbering(*description.numbering);
    }
    landmarkReader->Update();
    AppendTexts(data->warnings, landmarkReader->GetWarnings());
    data->landmarks3D = landmarkReader->GetOutput();
    data->landmarks3D->DisconnectPipeline();
  }
  data->stockOutlines = LoadStockOutlines(description);
  // Both at once; of two errors the upper jaw's is told.
  std::array<std::exception_ptr, 2>       errors;
  std::array<std::vector<std::string>, 2> meshWarnings;
  ParallelFor(2, MultiThreaderBase::GetGlobalDefaultNumberOfThreads(), [&](std::size_t jaw) {
    try
    {
      (jaw == 0 ? data->upper : data->lower).mesh = LoadMesh(
        jaw == 0 ? description.upperFile : description.lowerFile, description.millimetresPerUnit, meshWarnings[jaw]);
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
  for (const auto & warnings : meshWarnings)
  {
    AppendTexts(data->warnings, warnings);
  }
  LoadLabels(*data);
  RecordCaseInputs(*data, before);
  probe.Stop();
  data->readSeconds = probe.GetTotal();
  return data;
}
} // namespace itk

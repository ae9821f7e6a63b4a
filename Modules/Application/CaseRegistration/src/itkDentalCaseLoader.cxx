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
#include "itkCephalometricLandmarkFileReader.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalInputError.h"
#include "itkDentalLandmarkFileReader.h"
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
#include <cmath>
#include <exception>
#include <filesystem>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

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
                               std::string("labels teeth of the ") + (upper ? "lower" : "upper") +
                                 " jaw, but belongs to the " + (upper ? "upper" : "lower") + " one",
                               "exchange the files");
    }
    data.GetJaw(jaw).labels = reader->GetLabels();
  }
}

/** From the midsagittal plane to the detector, mm: half a head and the cassette's distance from it. The usual one is
 * that of the default geometry. */
constexpr double SmallestHeadToDetector = 90.0;
constexpr double UsualHeadToDetector = 150.0;
constexpr double LargestHeadToDetector = 400.0;

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
  const auto compare = [&data](const char * field, double given, double fromDicom) {
    // Rounded figures of one machine agree better.
    constexpr double tolerance = 0.02;
    if (std::abs(given - fromDicom) > tolerance * fromDicom)
    {
      std::ostringstream warning;
      warning << field << ": the case says " << given << ", the DICOM file " << fromDicom << "; the case's is used";
      data.warnings.push_back(warning.str());
    }
  };
  if (description.sourceToDetector && dicomDetector)
  {
    compare("source_to_detector_mm", *description.sourceToDetector, *dicomDetector);
  }
  if (description.sourceToMidsagittal && dicomMidsagittal)
  {
    compare("source_to_midsagittal_mm", *description.sourceToMidsagittal, *dicomMidsagittal);
  }
  if (description.facing && dicomFacing && *description.facing != *dicomFacing)
  {
    data.warnings.emplace_back("facing: the case and the DICOM file's patient orientation contradict each other; the "
                               "case's is used");
  }
  settle(description.sourceToDetector, dicomDetector, data.sources.sourceToDetector, [&](double distance) {
    data.geometry->SetSourceToDetectorDistance(distance);
  });
  settle(description.sourceToMidsagittal, dicomMidsagittal, data.sources.sourceToMidsagittal, [&](double distance) {
    data.geometry->SetSourceToMidsagittalDistance(distance);
  });
  // The detector's distance alone was given: of the head that lies before it only the default tells, and by its
  // distance from the detector, which is nearly the same in all machines, rather than by that from the source.
  const double gap = data.geometry->GetSourceToDetectorDistance() - data.geometry->GetSourceToMidsagittalDistance();
  if (data.sources.sourceToDetector != ValueSourceEnum::Default &&
      data.sources.sourceToMidsagittal == ValueSourceEnum::Default &&
      !(gap >= SmallestHeadToDetector && gap <= LargestHeadToDetector) &&
      data.geometry->GetSourceToDetectorDistance() > UsualHeadToDetector)
  {
    std::ostringstream warning;
    warning << "source_to_midsagittal_mm is not known, and the default does not go with a detector "
            << data.geometry->GetSourceToDetectorDistance()
            << " mm from the source: " << data.geometry->GetSourceToDetectorDistance() - UsualHeadToDetector
            << " is taken, " << UsualHeadToDetector << " mm before the detector";
    data.warnings.push_back(warning.str());
    data.geometry->SetSourceToMidsagittalDistance(data.geometry->GetSourceToDetectorDistance() - UsualHeadToDetector);
  }
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
    if (reader != nullptr && reader->HasPixelSpacing() && std::string(reader->GetFileFormat()) == "DICOM")
    {
      const auto own = reader->GetDetectorPixelSpacing(data.geometry->GetSourceToDetectorDistance(),
                                                       data.geometry->GetSourceToMidsagittalDistance());
      // One warning, of the direction in which they differ more.
      const auto ratio = [&](unsigned int i) { return std::abs(std::log(spacing[i] / own[i])); };
      const bool isAcross = ratio(0) >= ratio(1);
      compare(
        isAcross ? "pixel_spacing_mm[0]" : "pixel_spacing_mm[1]", spacing[isAcross ? 0 : 1], own[isAcross ? 0 : 1]);
    }
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
/** In what grid markups in mm lie: as the case says, else as the radiograph's header does. */
void
SettleMarkupsGrid(const CephalogramFileReader * reader, DentalCaseData & data)
{
  std::array<double, 4> grid{ { 0.0, 0.0, 0.0, 0.0 } };
  const bool            header = reader != nullptr && reader->HasHeaderSpacing();
  if (!header && !data.description.markupsSpacing)
  {
    return;
  }
  for (unsigned int i = 0; i < 2; ++i)
  {
    grid[i] = data.description.markupsSpacing ? (*data.description.markupsSpacing)[i] : reader->GetHeaderSpacing()[i];
    grid[2 + i] = header ? reader->GetHeaderOrigin()[i] : 0.0;
  }
  data.markupsGrid = grid;
}

/** Throws where a file of markups, in mm, was read and nobody knows how many mm a pixel has. */
void
RequireMarkupsGrid(const DentalCaseData & data, const AnnotationFileReaderBase & reader)
{
  if (reader.GetReadFileFormat() == AnnotationFileFormatEnum::SlicerMarkups && !data.markupsGrid)
  {
    itkDentalInputErrorMacro(
      data.description.fileName,
      "markups_spacing_mm",
      std::string("missing: the markups of \"") + reader.GetFileName() + "\" are in mm",
      "add the spacing [u, v] that the radiograph had in Slicer: [1, 1] where its Volumes module "
      "shows none, as of PNG and JPEG");
  }
}

/** A line along a ruler is the spacing where nobody gave one. */
void
SettleCalibration(const DentalContourFileReader & contourReader, DentalCaseData & data)
{
  const DentalContourFileReader::CalibrationType * longest = nullptr;
  for (const auto & calibration : contourReader.GetCalibrations())
  {
    if (calibration.pixels > 0.0 && (longest == nullptr || calibration.pixels > longest->pixels))
    {
      longest = &calibration;
    }
  }
  if (longest == nullptr)
  {
    return;
  }
  // A ruler hangs or is held where the patient's midline is, unless the case says that it lay on the detector.
  const DentalCase & description = data.description;
  const bool         midsagittal = !description.spacingPlaneIsGiven || description.spacingAtMidsagittalPlane;
  const double       factor =
    midsagittal ? data.geometry->GetSourceToDetectorDistance() / data.geometry->GetSourceToMidsagittalDistance() : 1.0;
  const double       found = factor * longest->millimetres / longest->pixels;
  std::ostringstream text;
  text << "line \"" << longest->label << "\" of the tracing: " << longest->millimetres << " mm on " << longest->pixels
       << " px"
       << (midsagittal ? ", taken for the midsagittal plane, converted to the detector's" : ", detector plane");
  if (data.geometry->HasPixelSpacing())
  {
    // Beyond what a ruler's plane and two ends leave open.
    constexpr double tolerance = 0.15;
    const double     given = 0.5 * (data.geometry->GetPixelSpacing()[0] + data.geometry->GetPixelSpacing()[1]);
    if (std::abs(found / given - 1.0) > tolerance)
    {
      std::ostringstream warning;
      warning << description.fileName << ": cephalogram.pixel_spacing_mm: " << given
              << " mm a pixel on the detector, but " << text.str() << " makes it " << found;
      data.warnings.push_back(warning.str());
    }
    return;
  }
  if (!(found > 0.001 && found < 5.0))
  {
    itkDentalInputErrorMacro(contourReader.GetFileName(),
                             longest->label,
                             "makes a pixel " + std::to_string(found) + " mm, which is not possible",
                             "draw the line from end to end of the ruler that its label names");
  }
  CephalometricGeometry::PixelSpacingType spacing;
  spacing.Fill(found);
  data.geometry->SetPixelSpacing(spacing);
  data.sources.pixelSpacing = ValueSourceEnum::Given;
  data.spacingVerdict = Print(PixelSpacingVerdictEnum::Calibrated);
  data.spacingProvenance = text.str();
}

void
LoadContours(DentalCaseData & data)
{
  const DentalCase & description = data.description;
  auto               contourReader = DentalContourFileReader::New();
  contourReader->SetFileName(description.contourClassFiles.empty() ? description.contoursFile : description.fileName);
  contourReader->SetClassFiles(description.contourClassFiles);
  contourReader->SetSidelessCodesAreLeft(description.tracedSideIsGiven &&
                                         description.tracedSide == TracedSideEnum::Left);
  PrepareReader(data, *contourReader);
  if (description.numbering)
  {
    contourReader->SetNumbering(*description.numbering);
  }
  if (data.imageSize[0] > 0)
  {
    contourReader->SetImageSize({ { data.imageSize[0], data.imageSize[1] } });
  }
  contourReader->Update();
  RequireMarkupsGrid(data, *contourReader);
  Append(data.warnings, contourReader->GetWarnings());
  data.sidelessContours = contourReader->GetNumberOfSidelessCodes();
  if (data.sidelessContours > 0 && description.tracedSide == TracedSideEnum::Both)
  {
    itkDentalInputErrorMacro(description.fileName,
                             "traced_side",
                             "is \"both\", but " + std::to_string(data.sidelessContours) +
                               " contours have codes without a side (U1, L6)",
                             "give each contour the code of its side, or write \"standard\"");
  }
  SettleCalibration(*contourReader, data);
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

/** The radiograph's where there is one, else as the case states it. */
void
SettleImageSize(DentalCaseData & data)
{
  const auto & stated = data.description.imageSize;
  if (data.image.IsNull())
  {
    data.imageSize = stated.value_or(data.imageSize);
    return;
  }
  const auto size = data.image->GetLargestPossibleRegion().GetSize();
  data.imageSize = { { static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]) } };
  if (stated && *stated != data.imageSize)
  {
    std::ostringstream problem;
    problem << "is " << (*stated)[0] << " x " << (*stated)[1] << ", but the image is " << size[0] << " x " << size[1];
    itkDentalInputErrorMacro(data.description.fileName,
                             "cephalogram.image_size",
                             problem.str(),
                             "name the right image or leave the field out");
  }
}

void
LoadCephalometricLandmarks(DentalCaseData & data)
{
  const DentalCase & description = data.description;
  const bool         own = description.cephalometricLandmarksFile.empty();
  if (own && description.cephalometricLandmarks.IsNull())
  {
    return;
  }
  if (own)
  {
    data.cephalometricLandmarks = CephalometricLandmarkSet::New();
    data.cephalometricLandmarks->Graft(description.cephalometricLandmarks);
  }
  else
  {
    auto reader = CephalometricLandmarkFileReader::New();
    reader->SetFileName(description.cephalometricLandmarksFile);
    reader->SetNumbering(description.numbering.value_or(ToothCode::NumberingEnum::Quadrant));
    PrepareReader(data, *reader);
    reader->Update();
    RequireMarkupsGrid(data, *reader);
    Append(data.warnings, reader->GetWarnings());
    data.cephalometricLandmarks = reader->GetOutput();
    data.cephalometricLandmarks->DisconnectPipeline();
  }
  if (data.imageSize[0] == 0)
  {
    itkDentalInputErrorMacro(description.fileName,
                             "cephalogram.image_size",
                             "missing: landmarks without a tracing do not say how large the radiograph is",
                             "name the image, or add \"image_size\": [width, height] to \"cephalogram\"");
  }
  CheckLandmarksInImage(*data.cephalometricLandmarks,
                        data.imageSize,
                        own ? description.fileName : description.cephalometricLandmarksFile,
                        own ? "cephalometric_landmarks." : "");
}

} // namespace

void
PrepareReader(const DentalCaseData & data, AnnotationFileReaderBase & reader)
{
  reader.SetImageFileName(data.description.imageFile);
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
  const DentalCase & description = data.description;
  if (!description.contoursFile.empty() || !description.contourClassFiles.empty())
  {
    LoadContours(data);
  }
  LoadCephalometricLandmarks(data);
  SettleTracedSide(data);
}

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
    Append(data->warnings, imageReader->GetWarnings());
  }
  SettleImageSize(*data);
  SettleGeometry(imageReader, *data);
  SettleMarkupsGrid(imageReader, *data);

  LoadCaseDrawings(*data);
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
    Append(data->warnings, landmarkReader->GetWarnings());
    data->landmarks3D = landmarkReader->GetOutput();
    data->landmarks3D->DisconnectPipeline();
  }
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
    Append(data->warnings, warnings);
  }
  LoadLabels(*data);
  RecordCaseInputs(*data);
  probe.Stop();
  data->readSeconds = probe.GetTotal();
  return data;
}
} // namespace itk

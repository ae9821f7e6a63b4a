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
#include "itkDentalRadiographLoader.h"

#include "itkAppendTexts.h"
#include "itkCephalometricLandmarkFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalInputError.h"
#include "itkShortNumber.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

namespace itk
{
namespace
{
/** From the plane through the ear rods to the detector, mm: half a head and the cassette's distance from it. The usual
 * one is that of the default geometry. */
constexpr double SmallestHeadToDetector = 90.0;
constexpr double UsualHeadToDetector = 150.0;
constexpr double LargestHeadToDetector = 400.0;

/** The given value before the DICOM file's; what there is of them, and where from. */
template <typename TValue, typename TApply>
void
Settle(const std::optional<TValue> & given,
       const std::optional<TValue> & fromDicom,
       ValueSourceEnum &             source,
       TApply &&                     apply)
{
  if (given || fromDicom)
  {
    apply(given ? *given : *fromDicom);
    source = given ? ValueSourceEnum::Given : ValueSourceEnum::DICOM;
  }
}
} // namespace

DentalRadiographLoader::DentalRadiographLoader(const DentalCase &         dentalCase,
                                               const DentalRadiograph &   description,
                                               DirectionEnum              direction,
                                               std::string                prefix,
                                               DentalRadiographData &     data,
                                               std::vector<std::string> & warnings)
  : m_Case(dentalCase)
  , m_Description(description)
  , m_Direction(direction)
  , m_Prefix(std::move(prefix))
  , m_Data(data)
  , m_Warnings(warnings)
{}

std::string
DentalRadiographLoader::Plane() const
{
  return m_Direction == DirectionEnum::Lateral ? "midsagittal" : "midcoronal";
}

void
DentalRadiographLoader::Warn(const std::string & field, const std::string & text)
{
  m_Warnings.push_back(m_Case.fileName + ": " + this->Field(field) + ": " + text);
}

bool
DentalRadiographLoader::Compare(const std::string & field, double given, double fromDicom)
{
  // Rounded figures of one machine agree better.
  constexpr double tolerance = 0.02;
  const bool       contradicts = std::abs(given - fromDicom) > tolerance * fromDicom;
  if (contradicts)
  {
    std::ostringstream warning;
    warning << this->Field(field) << ": the case says " << given << ", the DICOM file " << fromDicom
            << "; the case's is used";
    m_Warnings.push_back(warning.str());
  }
  return contradicts;
}

void
DentalRadiographLoader::LoadImage()
{
  const auto & stated = m_Description.imageSize;
  if (m_Description.imageFile.empty())
  {
    m_Data.imageSize = stated.value_or(m_Data.imageSize);
    return;
  }
  m_Image = CephalogramFileReader::New();
  m_Image->SetFileName(m_Description.imageFile);
  m_Image->Update();
  m_Data.image = m_Image->GetOutput();
  AppendTexts(m_Warnings, m_Image->GetWarnings());
  if (m_Image->HasRadiographDirection() && m_Image->GetRadiographDirection() != m_Direction)
  {
    const std::string said = m_Image->GetProvenance().at("direction");
    const bool        isView = !m_Prefix.empty();
    this->Warn(isView ? "direction" : "cephalogram.image",
               isView ? "the DICOM file says otherwise (" + said + "); the case's is used"
                      : "the DICOM file says that it was taken from the front (" + said +
                          "), and this is the place of the lateral radiograph: name a frontal one in \"views\"");
  }
  const auto size = m_Data.image->GetLargestPossibleRegion().GetSize();
  m_Data.imageSize = { { static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]) } };
  if (stated && *stated != m_Data.imageSize)
  {
    std::ostringstream problem;
    problem << "is " << (*stated)[0] << " x " << (*stated)[1] << ", but the image is " << size[0] << " x " << size[1];
    itkDentalInputErrorMacro(m_Case.fileName,
                             this->Field("cephalogram.image_size"),
                             problem.str(),
                             "name the right image or leave the field out");
  }
}

void
DentalRadiographLoader::SettleDistances()
{
  CephalometricGeometry & geometry = *m_Data.geometry;
  const std::string       head = "source_to_" + this->Plane() + "_mm";
  std::optional<double>   dicomDetector;
  std::optional<double>   dicomMidsagittal;
  if (m_Image != nullptr && m_Image->HasSourceToDetectorDistance())
  {
    dicomDetector = m_Image->GetSourceToDetectorDistance();
  }
  if (m_Image != nullptr && m_Image->HasSourceToMidsagittalDistance())
  {
    dicomMidsagittal = m_Image->GetSourceToMidsagittalDistance();
  }
  if (m_Description.sourceToDetector && dicomDetector)
  {
    this->Compare("source_to_detector_mm", *m_Description.sourceToDetector, *dicomDetector);
  }
  // The file's distance of the head is made with its factor, and says the same.
  const bool factorIsCompared = m_Description.sourceToMidsagittal && dicomMidsagittal &&
                                this->Compare(head, *m_Description.sourceToMidsagittal, *dicomMidsagittal);
  Settle(m_Description.sourceToDetector, dicomDetector, m_Data.sources.sourceToDetector, [&](double distance) {
    geometry.SetSourceToDetectorDistance(distance);
  });
  Settle(m_Description.sourceToMidsagittal, dicomMidsagittal, m_Data.sources.sourceToMidsagittal, [&](double distance) {
    geometry.SetSourceToMidsagittalDistance(distance);
  });
  // The detector's distance alone was given: of the head that lies before it only the default tells, and by its
  // distance from the detector, which is nearly the same in all machines, rather than by that from the source.
  const double detector = geometry.GetSourceToDetectorDistance();
  const double gap = detector - geometry.GetSourceToMidsagittalDistance();
  if (m_Data.sources.sourceToDetector != ValueSourceEnum::Default &&
      m_Data.sources.sourceToMidsagittal == ValueSourceEnum::Default &&
      !(gap >= SmallestHeadToDetector && gap <= LargestHeadToDetector) && detector > UsualHeadToDetector)
  {
    std::ostringstream warning;
    warning << this->Field(head) << " is not known, and the default does not go with a detector " << detector
            << " mm from the source: " << detector - UsualHeadToDetector << " is taken, " << UsualHeadToDetector
            << " mm before the detector";
    m_Warnings.push_back(warning.str());
    geometry.SetSourceToMidsagittalDistance(detector - UsualHeadToDetector);
  }
  if (detector <= geometry.GetSourceToMidsagittalDistance())
  {
    std::ostringstream problem;
    problem << "the source-to-detector distance " << detector << " mm is not larger than the source-to-"
            << this->Plane() << " distance " << geometry.GetSourceToMidsagittalDistance() << " mm";
    itkDentalInputErrorMacro(m_Case.fileName, this->Field("geometry"), problem.str(), "give both distances");
  }
  if (!factorIsCompared)
  {
    this->CompareMagnification();
  }
}

void
DentalRadiographLoader::CompareMagnification()
{
  if (m_Image == nullptr || !m_Image->HasMagnificationFactor())
  {
    return;
  }
  constexpr double tolerance = 0.02;
  const double     detector = m_Data.geometry->GetSourceToDetectorDistance();
  const double     head = m_Data.geometry->GetSourceToMidsagittalDistance();
  const double     factor = m_Image->GetMagnificationFactor();
  const auto &     sources = m_Data.sources;
  const bool       isDefault =
    sources.sourceToDetector == ValueSourceEnum::Default || sources.sourceToMidsagittal == ValueSourceEnum::Default;
  std::ostringstream text;
  text << "distances of " << detector << " and " << head << " mm" << (isDefault ? " (by default)" : "")
       << " magnify by " << detector / head
       << ", and the DICOM file's EstimatedRadiographicMagnificationFactor (0018,1114) is " << factor
       << "; the distances are used"
       << (isDefault ? ": give source_to_detector_mm and source_to_" + this->Plane() + "_mm" : "");
  if (std::abs(detector / head - factor) > tolerance * factor)
  {
    this->Warn("geometry", text.str());
  }
}

void
DentalRadiographLoader::SettlePixelSpacing()
{
  CephalometricGeometry & geometry = *m_Data.geometry;
  const double            detector = geometry.GetSourceToDetectorDistance();
  const double            head = geometry.GetSourceToMidsagittalDistance();
  const bool              isDicom = m_Image != nullptr && std::string(m_Image->GetFileFormat()) == "DICOM";
  if (m_Description.pixelSpacing)
  {
    // At the plane through the ear rods a pixel shows less than it measures on the detector.
    const double                            factor = m_Description.spacingAtMidsagittalPlane ? detector / head : 1.0;
    CephalometricGeometry::PixelSpacingType spacing;
    spacing[0] = (*m_Description.pixelSpacing)[0] * factor;
    spacing[1] = (*m_Description.pixelSpacing)[1] * factor;
    geometry.SetPixelSpacing(spacing);
    m_Data.sources.pixelSpacing = ValueSourceEnum::Given;
    if (isDicom && m_Image->HasPixelSpacing())
    {
      // In the plane of which the case speaks: what the file says of it, else of the detector.
      const auto & given = *m_Description.pixelSpacing;
      const bool   inSamePlane =
        m_Description.spacingAtMidsagittalPlane && m_Image->GetSpacingPlane() == SpacingPlaneEnum::Midsagittal;
      const auto own =
        inSamePlane ? m_Image->GetPixelSpacing() : m_Image->GetDetectorPixelSpacing(detector, head) / factor;
      // One warning, of the direction in which they differ more.
      const auto         ratio = [&](unsigned int i) { return std::abs(std::log(given[i] / own[i])); };
      const unsigned int d = ratio(0) >= ratio(1) ? 0 : 1;
      this->Compare(d == 0 ? "pixel_spacing_mm[0]" : "pixel_spacing_mm[1]", given[d], own[d]);
    }
    m_Data.spacingProvenance = m_Description.spacingAtMidsagittalPlane
                                 ? "case file, " + this->Plane() + " plane, converted to the detector's"
                                 : "case file, detector plane";
    m_Data.spacingVerdict = PixelSpacingVerdictEnum::UserGiven;
  }
  else if (m_Image != nullptr && m_Image->HasPixelSpacing())
  {
    geometry.SetPixelSpacing(m_Image->GetDetectorPixelSpacing(detector, head));
    m_Data.sources.pixelSpacing = isDicom ? ValueSourceEnum::DICOM : ValueSourceEnum::Given;
    m_Data.spacingVerdict = m_Image->GetPixelSpacingVerdict();
    m_Data.spacingProvenance = m_Image->GetProvenance().at("pixel_spacing");
    if (m_Data.spacingVerdict == PixelSpacingVerdictEnum::EstimatedMagnification)
    {
      m_Data.spacingProvenance += " at the " + this->Plane() + " plane; on the detector the ImagerPixelSpacing itself";
    }
  }
  else
  {
    m_Data.spacingProvenance = m_Image != nullptr ? m_Image->GetProvenance().at("pixel_spacing")
                                                  : std::string("no radiograph and no spacing given");
  }
}

void
DentalRadiographLoader::CheckPixelShape()
{
  // A picture that has a spacing of its own bears the case's out, or contradicts it, which is told already.
  if (!m_Data.geometry->HasPixelSpacing() || (m_Image != nullptr && m_Image->HasPixelSpacing()))
  {
    return;
  }
  // Detectors and scanners of films have square pixels; those of a few differ in the last digits that a header has.
  constexpr double tolerance = 0.02;
  const auto &     spacing = m_Data.geometry->GetPixelSpacing();
  if (std::abs(spacing[0] / spacing[1] - 1.0) > tolerance)
  {
    std::ostringstream text;
    text << '[' << spacing[0] << ", " << spacing[1]
         << "] mm are no squares, as the pixels of nearly all radiographs are: is one of the numbers wrong, or was the "
            "picture stretched?";
    this->Warn("cephalogram.pixel_spacing_mm", text.str());
  }
}

void
DentalRadiographLoader::SettleGeometry()
{
  m_Data.geometry = CephalometricGeometry::New();
  m_Data.geometry->SetDirection(m_Direction);
  this->SettleDistances();
  if (m_Direction == DirectionEnum::Lateral)
  {
    std::optional<CephalometricGeometry::FacingEnum> dicomFacing;
    if (m_Image != nullptr && m_Image->HasFacing())
    {
      dicomFacing = m_Image->GetFacing();
    }
    if (m_Description.facing && dicomFacing && *m_Description.facing != *dicomFacing)
    {
      m_Warnings.push_back(this->Field("facing") +
                           ": the case and the DICOM file's patient orientation contradict each other; the case's is "
                           "used");
    }
    Settle(m_Description.facing, dicomFacing, m_Data.sources.facing, [&](CephalometricGeometry::FacingEnum facing) {
      m_Data.geometry->SetFacing(facing);
    });
    if (m_Description.sourceSide)
    {
      m_Data.geometry->SetSourceSide(*m_Description.sourceSide);
      m_Data.sources.sourceSide = ValueSourceEnum::Given;
    }
  }
  if (m_Description.principalPoint)
  {
    CephalometricGeometry::PixelIndexType principal;
    principal[0] = (*m_Description.principalPoint)[0];
    principal[1] = (*m_Description.principalPoint)[1];
    m_Data.geometry->SetPrincipalPoint(principal);
    m_Data.sources.principalPoint = ValueSourceEnum::Given;
    const auto & size = m_Data.imageSize;
    for (unsigned int d = 0; d < 2; ++d)
    {
      if (size[d] > 0 && (principal[d] < -0.5 || principal[d] > size[d] - 0.5))
      {
        std::ostringstream text;
        text << '[' << principal[0] << ", " << principal[1] << "] lies outside the radiograph of " << size[0] << " x "
             << size[1] << " pixels: the ear rods are on it, unless the picture was cut";
        this->Warn("geometry.principal_point_px", text.str());
        break;
      }
    }
  }
  this->SettlePixelSpacing();
  this->CheckPixelShape();
  this->SettleMarkupsGrid();
}

/** In what grid markups in mm lie: as the case says, else as the radiograph's header does. */
void
DentalRadiographLoader::SettleMarkupsGrid()
{
  std::array<double, 4> grid{ { 0.0, 0.0, 0.0, 0.0 } };
  const bool            header = m_Image != nullptr && m_Image->HasHeaderSpacing();
  if (!header && !m_Description.markupsSpacing)
  {
    return;
  }
  for (unsigned int i = 0; i < 2; ++i)
  {
    grid[i] = m_Description.markupsSpacing ? (*m_Description.markupsSpacing)[i] : m_Image->GetHeaderSpacing()[i];
    grid[2 + i] = header ? m_Image->GetHeaderOrigin()[i] : 0.0;
  }
  m_Data.markupsGrid = grid;
}

/** Throws where a file of markups, in mm, was read and nobody knows how many mm a pixel has. */
void
DentalRadiographLoader::RequireMarkupsGrid(const AnnotationFileReaderBase & reader) const
{
  if (reader.GetReadFileFormat() == AnnotationFileFormatEnum::SlicerMarkups && !m_Data.markupsGrid)
  {
    itkDentalInputErrorMacro(
      m_Case.fileName,
      this->Field("markups_spacing_mm"),
      std::string("missing: the markups of \"") + reader.GetFileName() + "\" are in mm",
      "add the spacing [u, v] that the radiograph had in Slicer: [1, 1] where its Volumes module "
      "shows none, as of PNG and JPEG");
  }
}

/** A line along a ruler is the spacing where nobody gave one. */
void
DentalRadiographLoader::SettleCalibration(const DentalContourFileReader & contourReader)
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
  const bool   midsagittal = !m_Description.spacingPlaneIsGiven || m_Description.spacingAtMidsagittalPlane;
  const double factor =
    midsagittal ? m_Data.geometry->GetSourceToDetectorDistance() / m_Data.geometry->GetSourceToMidsagittalDistance()
                : 1.0;
  const double       found = factor * longest->millimetres / longest->pixels;
  std::ostringstream text;
  text << "line \"" << longest->label << "\" of the tracing: " << longest->millimetres << " mm on " << longest->pixels
       << " px"
       << (midsagittal ? ", taken for the " + this->Plane() + " plane, converted to the detector's"
                       : std::string(", detector plane"));
  if (m_Data.geometry->HasPixelSpacing())
  {
    // Beyond what a ruler's plane and two ends leave open.
    constexpr double tolerance = 0.15;
    const double     given = 0.5 * (m_Data.geometry->GetPixelSpacing()[0] + m_Data.geometry->GetPixelSpacing()[1]);
    if (std::abs(found / given - 1.0) > tolerance)
    {
      std::ostringstream warning;
      warning << given << " mm a pixel on the detector, but " << text.str() << " makes it " << found;
      this->Warn("cephalogram.pixel_spacing_mm", warning.str());
    }
    return;
  }
  if (!(found > 0.001 && found < 5.0))
  {
    itkDentalInputErrorMacro(contourReader.GetFileName(),
                             longest->label,
                             "makes a pixel " + ShortNumber(found) + " mm, which is not possible",
                             "draw the line from end to end of the ruler that its label names");
  }
  CephalometricGeometry::PixelSpacingType spacing;
  spacing.Fill(found);
  m_Data.geometry->SetPixelSpacing(spacing);
  m_Data.sources.pixelSpacing = ValueSourceEnum::Given;
  m_Data.spacingVerdict = PixelSpacingVerdictEnum::Calibrated;
  m_Data.spacingProvenance = text.str();
}

DentalRadiographLoader::ContoursType
DentalRadiographLoader::LoadContours(const std::vector<std::pair<std::string, std::string>> & classFiles,
                                     bool                                                     sidelessCodesAreLeft)
{
  ContoursType contours;
  if (m_Description.contoursFile.empty() && classFiles.empty())
  {
    return contours;
  }
  auto reader = DentalContourFileReader::New();
  reader->SetFileName(classFiles.empty() ? m_Description.contoursFile : m_Case.fileName);
  reader->SetClassFiles(classFiles);
  reader->SetSidelessCodesAreLeft(sidelessCodesAreLeft);
  PrepareReader(m_Description, m_Data, *reader);
  if (m_Case.numbering)
  {
    reader->SetNumbering(*m_Case.numbering);
  }
  if (m_Data.imageSize[0] > 0)
  {
    reader->SetImageSize({ { m_Data.imageSize[0], m_Data.imageSize[1] } });
  }
  reader->Update();
  this->RequireMarkupsGrid(*reader);
  AppendTexts(m_Warnings, reader->GetWarnings());
  m_Data.sidelessContours = reader->GetNumberOfSidelessCodes();
  this->SettleCalibration(*reader);
  m_Data.imageSize = { { static_cast<unsigned int>(reader->GetReadImageSize()[0]),
                         static_cast<unsigned int>(reader->GetReadImageSize()[1]) } };
  for (const auto jaw : { ToothCode::JawEnum::Upper, ToothCode::JawEnum::Lower })
  {
    if (reader->GetOutput(jaw)->GetNumberOfPoints() > 0)
    {
      contours[jaw == ToothCode::JawEnum::Upper ? 0 : 1] = WithoutTeeth(*reader->GetOutput(jaw), m_Case.excludedTeeth);
    }
  }
  return contours;
}

void
DentalRadiographLoader::LoadLandmarks()
{
  const bool own = m_Description.cephalometricLandmarksFile.empty();
  if (own && m_Description.cephalometricLandmarks.IsNull())
  {
    return;
  }
  if (own)
  {
    m_Data.cephalometricLandmarks = CephalometricLandmarkSet::New();
    m_Data.cephalometricLandmarks->Graft(m_Description.cephalometricLandmarks);
  }
  else
  {
    auto reader = CephalometricLandmarkFileReader::New();
    reader->SetFileName(m_Description.cephalometricLandmarksFile);
    reader->SetNumbering(m_Case.numbering.value_or(ToothCode::NumberingEnum::Quadrant));
    PrepareReader(m_Description, m_Data, *reader);
    reader->Update();
    this->RequireMarkupsGrid(*reader);
    AppendTexts(m_Warnings, reader->GetWarnings());
    m_Data.cephalometricLandmarks = reader->GetOutput();
    m_Data.cephalometricLandmarks->DisconnectPipeline();
  }
  if (m_Data.imageSize[0] == 0)
  {
    itkDentalInputErrorMacro(m_Case.fileName,
                             this->Field("cephalogram.image_size"),
                             "missing: landmarks without a tracing do not say how large the radiograph is",
                             "name the image, or add \"image_size\": [width, height] to \"" +
                               this->Field("cephalogram") + '"');
  }
  CheckLandmarksInImage(*m_Data.cephalometricLandmarks,
                        m_Data.imageSize,
                        own ? m_Case.fileName : m_Description.cephalometricLandmarksFile,
                        own ? this->Field("cephalometric_landmarks.") : "");
  // Teeth are nowhere within 100 px of a corner of a whole radiograph.
  constexpr unsigned int smallest = 400;
  const auto &           marked = m_Data.cephalometricLandmarks->GetLandmarks();
  const bool             areWithin = std::all_of(marked.begin(), marked.end(), [](const auto & landmark) {
    constexpr double whole = 100.0;
    return landmark.point[0] >= 0.0 && landmark.point[0] <= whole && landmark.point[1] >= 0.0 &&
           landmark.point[1] <= whole;
  });
  if (marked.size() > 1 && areWithin && std::min(m_Data.imageSize[0], m_Data.imageSize[1]) >= smallest)
  {
    m_Warnings.push_back((own ? m_Case.fileName : m_Description.cephalometricLandmarksFile) +
                         ": all landmarks are from 0 to 100: are they per cent of the picture's size? Then multiply u "
                         "by a hundredth of its width and v by one of its height");
  }
}
} // namespace itk

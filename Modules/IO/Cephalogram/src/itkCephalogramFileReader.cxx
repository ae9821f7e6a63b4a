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
#include "itkCephalogramFileReader.h"

#include "itkDentalInputError.h"
#include "itkRadiographFile.h"
#include "itkRadiographText.h"

#include "itkMetaDataObject.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace itk
{
namespace
{
using Format = RadiographFileFormatEnum;
using RadiographText::ToString;

/** Bits of a value up to which the type's largest is what a picture has for white. */
constexpr unsigned int LargestPictureDepth = 16;

/** Grey from the values of a pixel: colours by their luminance, and what is transparent black.
 *
 * \param full The value of white and of an opaque pixel's opacity. */
double
ComputeGrey(const double * values, unsigned int components, double full, bool isNegative)
{
  double value = isNegative ? full - values[0] : values[0];
  if (components >= 3)
  {
    value = 0.2126 * value + 0.7152 * values[1] + 0.0722 * values[2];
  }
  if (components == 2 || components == 4)
  {
    value *= values[components - 1] / full;
  }
  return value;
}
} // namespace

void
CephalogramFileReader::SetUserPixelSpacing(const PixelSpacingType & spacing, SpacingPlaneEnum plane)
{
  for (unsigned int i = 0; i < 2; ++i)
  {
    if (!(spacing[i] > 0.0) || !std::isfinite(spacing[i]))
    {
      itkExceptionMacro("A pixel spacing of " << spacing << " mm is not above 0.");
    }
  }
  if (plane == SpacingPlaneEnum::Unknown)
  {
    itkExceptionMacro("The plane of a given pixel spacing has to be Detector or Midsagittal.");
  }
  if (!m_UserPixelSpacing || *m_UserPixelSpacing != spacing || m_UserSpacingPlane != plane)
  {
    m_UserPixelSpacing = spacing;
    m_UserSpacingPlane = plane;
    this->Modified();
  }
}

void
CephalogramFileReader::ClearUserPixelSpacing()
{
  if (m_UserPixelSpacing)
  {
    m_UserPixelSpacing.reset();
    this->Modified();
  }
}

auto
CephalogramFileReader::GetPixelSpacing() const -> PixelSpacingType
{
  if (!m_PixelSpacing)
  {
    itkExceptionMacro("The pixel spacing of \"" << m_FileName
                                                << "\" is unknown. Call SetUserPixelSpacing() with the millimetres a "
                                                   "pixel, or UpdateOutputInformation() if the file was not read yet.");
  }
  return *m_PixelSpacing;
}

auto
CephalogramFileReader::GetHeaderSpacing() const -> PixelSpacingType
{
  if (!m_HeaderSpacing)
  {
    itkExceptionMacro("The header of \"" << m_FileName << "\" tells no spacing: see HasHeaderSpacing().");
  }
  return *m_HeaderSpacing;
}

auto
CephalogramFileReader::GetHeaderOrigin() const -> PixelSpacingType
{
  this->GetHeaderSpacing();
  return m_HeaderOrigin;
}

void
CephalogramFileReader::ReadHeaderGrid()
{
  const ImageIOBase & imageIO = *m_File->GetImageIO();
  PixelSpacingType    spacing;
  for (unsigned int i = 0; i < 2; ++i)
  {
    spacing[i] = imageIO.GetSpacing(i);
    m_HeaderOrigin[i] = imageIO.GetOrigin(i);
    const std::vector<double> direction = imageIO.GetDirection(i);
    // Negated so that what is not finite is refused.
    if (!(spacing[i] > 0.0) || !std::isfinite(spacing[i]) || !std::isfinite(m_HeaderOrigin[i]) ||
        direction.size() < 2 || direction[i] != 1.0)
    {
      return;
    }
  }
  m_HeaderSpacing = spacing;
}

auto
CephalogramFileReader::GetDetectorPixelSpacing(double sourceToDetector, double sourceToMidsagittal) const
  -> PixelSpacingType
{
  const PixelSpacingType spacing = this->GetPixelSpacing();
  if (m_SpacingPlane == SpacingPlaneEnum::Detector)
  {
    return spacing;
  }
  const double magnification = sourceToDetector / sourceToMidsagittal;
  if (!(sourceToMidsagittal > 0.0 && magnification > 1.0 && std::isfinite(magnification)))
  {
    itkExceptionMacro("A source-to-detector distance of "
                      << sourceToDetector << " mm does not lie beyond a source-to-midsagittal distance of "
                      << sourceToMidsagittal << " mm; give both, in mm.");
  }
  return m_PixelSpacingVerdict == PixelSpacingVerdictEnum::EstimatedMagnification ? m_ImagerPixelSpacing.value()
                                                                                  : spacing * magnification;
}

double
CephalogramFileReader::GetSourceToDetectorDistance() const
{
  if (!m_SourceToDetectorDistance)
  {
    itkExceptionMacro("\"" << m_FileName
                           << "\" has no source-to-detector distance; ask HasSourceToDetectorDistance().");
  }
  return *m_SourceToDetectorDistance;
}

double
CephalogramFileReader::GetSourceToMidsagittalDistance() const
{
  if (!m_SourceToMidsagittalDistance)
  {
    itkExceptionMacro("\"" << m_FileName
                           << "\" has no source-to-midsagittal distance; ask HasSourceToMidsagittalDistance().");
  }
  return *m_SourceToMidsagittalDistance;
}

double
CephalogramFileReader::GetMagnificationFactor() const
{
  if (!m_MagnificationFactor)
  {
    itkExceptionMacro("\"" << m_FileName << "\" has no magnification factor; ask HasMagnificationFactor().");
  }
  return *m_MagnificationFactor;
}

auto
CephalogramFileReader::GetFacing() const -> FacingEnum
{
  if (!m_Facing)
  {
    itkExceptionMacro("\"" << m_FileName << "\" does not say where the patient faces; ask HasFacing().");
  }
  return *m_Facing;
}

auto
CephalogramFileReader::GetPatientLeft() const -> PatientLeftEnum
{
  if (!m_PatientLeft)
  {
    itkExceptionMacro("\"" << m_FileName << "\" does not say where the patient's left is; ask HasPatientLeft().");
  }
  return *m_PatientLeft;
}

auto
CephalogramFileReader::GetFrontalSource() const -> FrontalSourceEnum
{
  if (!m_FrontalSource)
  {
    itkExceptionMacro("\"" << m_FileName << "\" does not say where the source stood; ask HasFrontalSource().");
  }
  return *m_FrontalSource;
}

auto
CephalogramFileReader::GetRadiographDirection() const -> DirectionEnum
{
  if (!m_RadiographDirection)
  {
    itkExceptionMacro("\"" << m_FileName << "\" does not say its direction; ask HasRadiographDirection().");
  }
  return *m_RadiographDirection;
}

void
CephalogramFileReader::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_FileName.empty())
  {
    itkExceptionMacro("No file to read. Call SetFileName() first.");
  }
}

void
CephalogramFileReader::Warn(const std::string & field, const std::string & text)
{
  m_Warnings.push_back(m_FileName + ": " + field + ": " + text);
}

void
CephalogramFileReader::ReadHeaderSpacing()
{
  const ImageIOBase &         imageIO = *m_File->GetImageIO();
  const std::string           header = m_File->GetTextHeader();
  const std::array<double, 2> spacing{ { imageIO.GetSpacing(0), imageIO.GetSpacing(1) } };
  const std::string           text = "header spacing " + ToString(spacing[0]) + ' ' + ToString(spacing[1]);
  std::string &               provenance = m_Provenance["pixel_spacing"];

  const auto isBoth = [&spacing](double value) {
    return std::abs(spacing[0] - value) <= 1e-3 * value && std::abs(spacing[1] - value) <= 1e-3 * value;
  };
  // What a header without a spacing turns into cannot be told from a spacing of 1.
  if (isBoth(1.0))
  {
    provenance = "no spacing in the header, or 1, which stands for none";
    return;
  }
  for (const double value : spacing)
  {
    if (!(value > 0.0) || !std::isfinite(value))
    {
      provenance = text + " is not above 0";
      return;
    }
  }
  for (const double dotsPerInch : { 72.0, 96.0 })
  {
    if (isBoth(25.4 / dotsPerInch))
    {
      provenance = text + " is a screen's " + ToString(dotsPerInch) + " dots per inch, not a detector's";
      return;
    }
  }
  for (std::size_t begin = 0; begin < header.size();)
  {
    const std::size_t end = header.find('\n', begin);
    const std::string line = header.substr(begin, end - begin);
    begin = end + 1;
    if ((line.compare(0, 6, "units:") == 0 || line.compare(0, 12, "space units:") == 0) &&
        line.find("\"mm\"") == std::string::npos && line.find("\"millimet") == std::string::npos)
    {
      provenance = text + " with " + line.substr(0, 60) + ", not mm";
      return;
    }
  }
  m_PixelSpacingVerdict = PixelSpacingVerdictEnum::Detector;
  m_SpacingPlane = SpacingPlaneEnum::Detector;
  m_PixelSpacing = PixelSpacingType(spacing.data());
  provenance = text + " mm, taken for the detector plane's as the format does not name a plane";
}

void
CephalogramFileReader::GenerateOutputInformation()
{
  m_PixelSpacingVerdict = PixelSpacingVerdictEnum::Unknown;
  m_SpacingPlane = SpacingPlaneEnum::Unknown;
  m_PixelSpacing.reset();
  m_ImagerPixelSpacing.reset();
  m_HeaderSpacing.reset();
  m_SourceToDetectorDistance.reset();
  m_SourceToMidsagittalDistance.reset();
  m_MagnificationFactor.reset();
  m_Facing.reset();
  m_PatientLeft.reset();
  m_FrontalSource.reset();
  m_RadiographDirection.reset();
  m_Provenance.clear();
  m_Warnings.clear();

  m_File = std::make_shared<const RadiographFile>(m_FileName, RadiographFile::PaletteEnum::Colours);
  m_FileFormat = itk::ToString(m_File->GetFormat());
  switch (m_File->GetFormat())
  {
    case Format::DICOM:
      this->ReadDicomTags();
      this->ReadHeaderGrid();
      break;
    case Format::NRRD:
    case Format::MetaImage:
    case Format::NIfTI:
      this->ReadHeaderSpacing();
      this->ReadHeaderGrid();
      break;
    default:
      m_Provenance["pixel_spacing"] = m_FileFormat + " has no pixel spacing; a resolution in dots per inch is not one";
  }
  if (m_File->GetOrientation() != 1)
  {
    const std::string orientation = std::to_string(m_File->GetOrientation());
    m_Provenance["orientation"] =
      "orientation " + orientation + " of the file (1 is upright), turned upright on reading";
    this->Warn("orientation",
               orientation +
                 " in the file turns the picture upright, as viewers show it; pixels of the file as it is stored are "
                 "elsewhere");
  }
  if (m_File->IsOfPlainArray())
  {
    this->Warn(
      "srow_x, srow_y",
      "say nothing of how the picture lies (the affine of numpy.eye(4)); taken for an array [column, row] from "
      "the picture's upper left corner");
  }
  if (m_File->IsWhiteIsZero())
  {
    m_Provenance["photometric"] = "TIFF PhotometricInterpretation WhiteIsZero, inverted on reading";
  }
  if (m_UserPixelSpacing)
  {
    m_Provenance["pixel_spacing"] = "given by the user; the file: " + m_Provenance["pixel_spacing"];
    m_PixelSpacingVerdict = PixelSpacingVerdictEnum::UserGiven;
    m_SpacingPlane = m_UserSpacingPlane;
    m_PixelSpacing = m_UserPixelSpacing;
  }

  OutputImageType * const output = this->GetOutput();
  output->SetLargestPossibleRegion(OutputImageType::RegionType(m_File->GetSize()));
  OutputImageType::SpacingType spacing;
  spacing.Fill(1.0);
  output->SetSpacing(m_PixelSpacing ? *m_PixelSpacing : spacing);
  OutputImageType::PointType origin;
  origin.Fill(0.0);
  output->SetOrigin(origin);
  OutputImageType::DirectionType direction;
  direction.SetIdentity();
  output->SetDirection(direction);

  // Not the file's own dictionary: that of a DICOM file has the patient's name.
  MetaDataDictionary dictionary;
  std::ostringstream verdict;
  verdict << m_PixelSpacingVerdict;
  EncapsulateMetaData<std::string>(dictionary, VerdictKey, verdict.str());
  std::ostringstream plane;
  plane << m_SpacingPlane;
  EncapsulateMetaData<std::string>(dictionary, PlaneKey, plane.str());
  output->SetMetaDataDictionary(dictionary);
}

void
CephalogramFileReader::EnlargeOutputRequestedRegion(DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

void
CephalogramFileReader::GenerateData()
{
  this->AllocateOutputs();
  this->UpdateProgress(0.0f);
  if (!m_File)
  {
    // Asked for its pixels again: they were released.
    m_File = std::make_shared<const RadiographFile>(m_FileName, RadiographFile::PaletteEnum::Colours);
    if (m_File->GetSize() != this->GetOutput()->GetLargestPossibleRegion().GetSize())
    {
      m_File.reset();
      itkDentalInputErrorMacro(m_FileName, "", "was changed since its header was read", "read it again");
    }
  }
  const std::vector<char> pixels = m_File->Decode();
  const unsigned int      components = m_File->GetNumberOfComponents();
  const double            full = m_File->GetLargestValue();
  // Against the largest of 2^32 values, a float would have no bits left for those of the picture.
  const bool    fullIsWhite = m_File->GetDepth() <= LargestPictureDepth;
  float * const grey = this->GetOutput()->GetBufferPointer();
  float *       end = grey;
  bool          finite = true;
  m_File->ForEachRow(pixels, [&](const double * values) {
    for (SizeValueType u = 0; u < m_File->GetSize()[0]; ++u, ++end)
    {
      *end =
        static_cast<float>(ComputeGrey(values + u * components, components, full, m_File->IsNegative() && fullIsWhite));
      finite = finite && std::isfinite(*end);
    }
  });
  if (!finite)
  {
    itkDentalInputErrorMacro(m_FileName, "", "has pixels that are not finite (NaN or Inf)", "export it again");
  }
  if (m_File->IsNegative() && !fullIsWhite)
  {
    const float white = *std::max_element(grey, end);
    std::transform(grey, end, grey, [white](float value) { return white - value; });
  }
  // It holds the file's bytes.
  m_File.reset();
  this->UpdateProgress(1.0f);
}

void
CephalogramFileReader::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  const auto print = [&os, indent](const char * name, const auto & value) {
    os << indent << name << ": ";
    if (value)
    {
      os << *value << std::endl;
    }
    else
    {
      os << "(none)" << std::endl;
    }
  };
  os << indent << "FileName: " << m_FileName << std::endl;
  print("UserPixelSpacing", m_UserPixelSpacing);
  os << indent << "UserSpacingPlane: " << m_UserSpacingPlane << std::endl;
  os << indent << "FileFormat: " << m_FileFormat << std::endl;
  os << indent << "PixelSpacingVerdict: " << m_PixelSpacingVerdict << std::endl;
  os << indent << "SpacingPlane: " << m_SpacingPlane << std::endl;
  print("PixelSpacing", m_PixelSpacing);
  print("ImagerPixelSpacing", m_ImagerPixelSpacing);
  print("HeaderSpacing", m_HeaderSpacing);
  os << indent << "HeaderOrigin: " << m_HeaderOrigin << std::endl;
  print("SourceToDetectorDistance", m_SourceToDetectorDistance);
  print("SourceToMidsagittalDistance", m_SourceToMidsagittalDistance);
  print("MagnificationFactor", m_MagnificationFactor);
  os << indent << "Facing: " << (!m_Facing ? "(none)" : *m_Facing == FacingEnum::Right ? "right" : "left") << std::endl;
  os << indent << "PatientLeft: ";
  m_PatientLeft ? os << *m_PatientLeft : os << "(none)";
  os << std::endl << indent << "FrontalSource: ";
  m_FrontalSource ? os << *m_FrontalSource : os << "(none)";
  os << std::endl << indent << "RadiographDirection: ";
  m_RadiographDirection ? os << *m_RadiographDirection : os << "(none)";
  os << std::endl;
  for (const auto & [name, source] : m_Provenance)
  {
    os << indent << "Provenance of " << name << ": " << source << std::endl;
  }
  os << indent << "Warnings: " << m_Warnings.size() << std::endl;
}
} // namespace itk

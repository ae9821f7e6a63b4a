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
#include "itkIntegerTIFF.h"
#include "itkRadiographFileFormat.h"
#include "itkRadiographImageIO.h"
#include "itkRadiographText.h"

#include "itkMetaDataObject.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <type_traits>

namespace itk
{
namespace
{
using Format = RadiographFileFormatEnum;
using RadiographText::ToString;

/** The grey level that a white-is-zero TIFF's 0 stands for; ITK's reader leaves such a file a negative. */
float
GetWhite(IOComponentEnum type)
{
  return type == IOComponentEnum::UCHAR ? std::numeric_limits<unsigned char>::max()
                                        : std::numeric_limits<unsigned short>::max();
}

/** Grey from interleaved components. */
template <typename TComponent>
bool
ConvertToGrey(const void * buffer, std::size_t pixels, unsigned int components, float * grey)
{
  const auto * source = static_cast<const TComponent *>(buffer);
  const double full =
    std::is_floating_point<TComponent>::value ? 1.0 : static_cast<double>(std::numeric_limits<TComponent>::max());
  bool finite = true;
  for (std::size_t i = 0; i < pixels; ++i, source += components)
  {
    double value = static_cast<double>(source[0]);
    if (components >= 3)
    {
      value = 0.2126 * value + 0.7152 * static_cast<double>(source[1]) + 0.0722 * static_cast<double>(source[2]);
    }
    if (components == 2 || components == 4)
    {
      value *= static_cast<double>(source[components - 1]) / full;
    }
    grey[i] = static_cast<float>(value);
    finite = finite && std::isfinite(grey[i]);
  }
  return finite;
}

bool
ConvertToGrey(IOComponentEnum type, const void * buffer, std::size_t pixels, unsigned int components, float * grey)
{
  switch (type)
  {
    case IOComponentEnum::UCHAR:
      return ConvertToGrey<unsigned char>(buffer, pixels, components, grey);
    case IOComponentEnum::CHAR:
      return ConvertToGrey<signed char>(buffer, pixels, components, grey);
    case IOComponentEnum::USHORT:
      return ConvertToGrey<unsigned short>(buffer, pixels, components, grey);
    case IOComponentEnum::SHORT:
      return ConvertToGrey<short>(buffer, pixels, components, grey);
    case IOComponentEnum::UINT:
      return ConvertToGrey<unsigned int>(buffer, pixels, components, grey);
    case IOComponentEnum::INT:
      return ConvertToGrey<int>(buffer, pixels, components, grey);
    case IOComponentEnum::ULONG:
      return ConvertToGrey<unsigned long>(buffer, pixels, components, grey);
    case IOComponentEnum::LONG:
      return ConvertToGrey<long>(buffer, pixels, components, grey);
    case IOComponentEnum::ULONGLONG:
      return ConvertToGrey<unsigned long long>(buffer, pixels, components, grey);
    case IOComponentEnum::LONGLONG:
      return ConvertToGrey<long long>(buffer, pixels, components, grey);
    case IOComponentEnum::FLOAT:
      return ConvertToGrey<float>(buffer, pixels, components, grey);
    case IOComponentEnum::DOUBLE:
      return ConvertToGrey<double>(buffer, pixels, components, grey);
    default:
      throw std::invalid_argument("unknown pixel type");
  }
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
  PixelSpacingType spacing;
  for (unsigned int i = 0; i < 2; ++i)
  {
    spacing[i] = m_ImageIO->GetSpacing(i);
    m_HeaderOrigin[i] = m_ImageIO->GetOrigin(i);
    const std::vector<double> direction = m_ImageIO->GetDirection(i);
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
  return spacing * magnification;
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
  const std::string           header = ReadRadiographTextHeader(m_FileName);
  const std::array<double, 2> spacing{ { m_ImageIO->GetSpacing(0), m_ImageIO->GetSpacing(1) } };
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
  m_HeaderSpacing.reset();
  m_SourceToDetectorDistance.reset();
  m_SourceToMidsagittalDistance.reset();
  m_MagnificationFactor.reset();
  m_Facing.reset();
  m_Provenance.clear();
  m_Warnings.clear();

  const Format format = DetectRadiographFileFormat(m_FileName);
  m_FileFormat = itk::ToString(format);
  VerifyRadiographFileIsComplete(m_FileName, format, MaximumNumberOfPixels);
  m_ImageIO = MakeRadiographImageIO(format);
  m_ImageIO->SetFileName(m_FileName);
  CallRadiographImageIO(m_FileName, m_FileFormat, [this] { m_ImageIO->ReadImageInformation(); });

  const unsigned int        dimensions = m_ImageIO->GetNumberOfDimensions();
  OutputImageType::SizeType size{ { 0, 0 } };
  for (unsigned int i = 0; i < dimensions; ++i)
  {
    const SizeValueType count = m_ImageIO->GetDimensions(i);
    if (i < 2)
    {
      size[i] = count;
    }
    else if (count > 1)
    {
      itkDentalInputErrorMacro(
        m_FileName, "", "has " + std::to_string(count) + " frames, pages or slices", "export the one radiograph");
    }
  }
  if (size[0] == 0 || size[1] == 0)
  {
    itkDentalInputErrorMacro(m_FileName,
                             "",
                             "is an image of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " pixels",
                             "export it again");
  }
  if (size[0] > MaximumNumberOfPixels / size[1] || size[0] > MaximumWidthAndHeight || size[1] > MaximumWidthAndHeight)
  {
    itkDentalInputErrorMacro(m_FileName,
                             "",
                             "claims to have " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
                               " pixels, which no cephalogram has",
                             "export it again");
  }
  const unsigned int components = m_ImageIO->GetNumberOfComponents();
  const bool         mayHaveAlphaAlone = format == Format::PNG || format == Format::TIFF;
  if (components != 1 && components != 3 && components != 4 && !(components == 2 && mayHaveAlphaAlone))
  {
    itkDentalInputErrorMacro(
      m_FileName, "", "has " + std::to_string(components) + " values a pixel", "export it in grey or in RGB");
  }

  switch (format)
  {
    case Format::DICOM:
      this->ReadDicomTags();
      this->ReadHeaderGrid();
      break;
    case Format::NRRD:
    case Format::MetaImage:
      this->ReadHeaderSpacing();
      this->ReadHeaderGrid();
      break;
    default:
      m_Provenance["pixel_spacing"] = m_FileFormat + " has no pixel spacing; a resolution in dots per inch is not one";
  }
  if (IsWhiteIsZeroTIFF(m_FileName))
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
  output->SetLargestPossibleRegion(OutputImageType::RegionType(size));
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
  OutputImageType * const output = this->GetOutput();
  const auto              size = output->GetLargestPossibleRegion().GetSize();
  const unsigned int      dimensions = m_ImageIO->GetNumberOfDimensions();
  ImageIORegion           region(dimensions);
  for (unsigned int i = 0; i < dimensions; ++i)
  {
    region.SetIndex(i, 0);
    region.SetSize(i, m_ImageIO->GetDimensions(i));
  }
  bool finite = true;
  CallRadiographImageIO(m_FileName, m_FileFormat, [&] {
    m_ImageIO->SetIORegion(region);
    // Zeros, so that a reader that leaves a part out leaves no memory of others.
    std::vector<char> buffer(static_cast<std::size_t>(m_ImageIO->GetImageSizeInBytes()), 0);
    if (IsIntegerTIFF(m_FileName))
    {
      const std::vector<double> values = ReadIntegerTIFF(m_FileName, size[0], size[1]);
      std::transform(values.begin(), values.end(), output->GetBufferPointer(), [](double value) {
        return static_cast<float>(value);
      });
      return;
    }
    m_ImageIO->Read(buffer.data());
    finite = ConvertToGrey(m_ImageIO->GetComponentType(),
                           buffer.data(),
                           size[0] * size[1],
                           m_ImageIO->GetNumberOfComponents(),
                           output->GetBufferPointer());
  });
  const IOComponentEnum type = m_ImageIO->GetComponentType();
  if (m_ImageIO->GetNumberOfComponents() == 1 && (type == IOComponentEnum::UCHAR || type == IOComponentEnum::USHORT) &&
      IsWhiteIsZeroTIFF(m_FileName))
  {
    const float white = GetWhite(type);
    for (std::size_t i = 0; i < size[0] * size[1]; ++i)
    {
      output->GetBufferPointer()[i] = white - output->GetBufferPointer()[i];
    }
  }
  if (!finite)
  {
    itkDentalInputErrorMacro(m_FileName, "", "has pixels that are not finite (NaN or Inf)", "export it again");
  }
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
  print("HeaderSpacing", m_HeaderSpacing);
  os << indent << "HeaderOrigin: " << m_HeaderOrigin << std::endl;
  print("SourceToDetectorDistance", m_SourceToDetectorDistance);
  print("SourceToMidsagittalDistance", m_SourceToMidsagittalDistance);
  print("MagnificationFactor", m_MagnificationFactor);
  os << indent << "Facing: " << (!m_Facing ? "(none)" : *m_Facing == FacingEnum::Right ? "right" : "left") << std::endl;
  for (const auto & [name, source] : m_Provenance)
  {
    os << indent << "Provenance of " << name << ": " << source << std::endl;
  }
  os << indent << "Warnings: " << m_Warnings.size() << std::endl;
  itkPrintSelfObjectMacro(ImageIO);
}
} // namespace itk

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
#include "itkAnnotationFileReaderBase.h"

#include "itkAppendWarning.h"
#include "itkMakeUTF8.h"

#include <algorithm>
#include <utility>

namespace itk
{
namespace
{
/** On a canvas (0, 0) is the picture's corner. */
bool
DrawsOnCanvas(AnnotationFileFormatEnum format)
{
  switch (format)
  {
    case AnnotationFileFormatEnum::Labelme:
    case AnnotationFileFormatEnum::CVAT:
    case AnnotationFileFormatEnum::COCO:
    case AnnotationFileFormatEnum::VIA:
    case AnnotationFileFormatEnum::LabelStudio:
    case AnnotationFileFormatEnum::Supervisely:
    case AnnotationFileFormatEnum::WebCeph:
      return true;
    default:
      return false;
  }
}
} // namespace

AnnotationFileReaderBase::AnnotationFileReaderBase()
{
  m_MarkupsSpacing.Fill(1.0);
  m_MarkupsOrigin.Fill(0.0);
}

void
AnnotationFileReaderBase::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_FileName.empty())
  {
    itkExceptionMacro("No file to read. Call SetFileName() first.");
  }
  for (unsigned int i = 0; i < 2; ++i)
  {
    if (!(m_MarkupsSpacing[i] > 0.0))
    {
      itkExceptionMacro("MarkupsSpacing is " << m_MarkupsSpacing << "; give SetMarkupsSpacing() mm above 0.");
    }
  }
}

void
AnnotationFileReaderBase::StartReading(FileFormatEnum readFormat, std::vector<std::string> warnings)
{
  m_ReadFileFormat = readFormat;
  m_Warnings = std::move(warnings);
  // They repeat what stands in files.
  std::transform(m_Warnings.begin(), m_Warnings.end(), m_Warnings.begin(), MakeUTF8);
}

void
AnnotationFileReaderBase::Warn(const std::string & field, const std::string & text)
{
  AppendWarning(m_Warnings, m_FileName, MakeUTF8(field + ": " + text));
}

double
AnnotationFileReaderBase::ToPixelIndex(double coordinate, unsigned int axis) const
{
  const bool fromCorner = m_ReadFileFormat != FileFormatEnum::DentalSCR &&
                          m_ReadFileFormat != FileFormatEnum::LabelImage &&
                          (m_PixelOrigin == PixelOriginEnum::Corner ||
                           (m_PixelOrigin == PixelOriginEnum::FormatDefault && DrawsOnCanvas(m_ReadFileFormat)));
  const double shift = fromCorner ? -0.5 : 0.0;
  const bool   inMillimetres = m_ReadFileFormat == FileFormatEnum::SlicerMarkups;
  return (inMillimetres ? (coordinate - m_MarkupsOrigin[axis]) / m_MarkupsSpacing[axis] : coordinate) + shift;
}

void
AnnotationFileReaderBase::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << m_FileName << std::endl;
  os << indent << "ImageFileName: " << m_ImageFileName << std::endl;
  os << indent << "FileFormat: " << m_FileFormat << std::endl;
  os << indent << "Numbering: " << m_Numbering << std::endl;
  os << indent << "PixelOrigin: " << m_PixelOrigin << std::endl;
  os << indent << "MarkupsSpacing: " << m_MarkupsSpacing << std::endl;
  os << indent << "MarkupsOrigin: " << m_MarkupsOrigin << std::endl;
  os << indent << "ReadFileFormat: " << m_ReadFileFormat << std::endl;
  os << indent << "Warnings: " << m_Warnings.size() << std::endl;
}
} // namespace itk

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
#include "itkRadiographImageIO.h"

#include "itkDentalInputError.h"
#include "itkDicomImageIO.h"

#include "itkBMPImageIO.h"
#include "itkJPEGImageIO.h"
#include "itkMetaImageIO.h"
#include "itkNrrdImageIO.h"
#include "itkPNGImageIO.h"
#include "itkTIFFImageIO.h"

#include <cstdarg>
#include <new>

// Of the libtiff inside ITK, whose header is not installed; weak, as an ITK on the system's libtiff has not these
// names.
extern "C" {
using TIFFHandler = void (*)(const char *, const char *, va_list);
__attribute__((weak)) TIFFHandler
itk_TIFFSetWarningHandler(TIFFHandler handler);
__attribute__((weak)) TIFFHandler
itk_TIFFSetErrorHandler(TIFFHandler handler);
}

namespace itk
{
namespace
{
using Format = RadiographFileFormatEnum;

/** ITK's readers warn on stderr, of MONOCHROME1 for one, and so do GDCM and libtiff; a library does not print. */
class SilencedWarnings
{
public:
  SilencedWarnings()
    : m_Before(Object::GetGlobalWarningDisplay())
    , m_Dicom(GetLoadedDicomImageIO())
  {
    Object::SetGlobalWarningDisplay(false);
    if (m_Dicom != nullptr)
    {
      m_GDCMWarning = m_Dicom->setWarnings(false);
      m_GDCMError = m_Dicom->setErrors(false);
    }
    if (itk_TIFFSetWarningHandler != nullptr && itk_TIFFSetErrorHandler != nullptr)
    {
      m_TIFFWarning = itk_TIFFSetWarningHandler(nullptr);
      m_TIFFError = itk_TIFFSetErrorHandler(nullptr);
    }
  }
  ~SilencedWarnings()
  {
    Object::SetGlobalWarningDisplay(m_Before);
    if (m_Dicom != nullptr)
    {
      m_Dicom->setWarnings(m_GDCMWarning);
      m_Dicom->setErrors(m_GDCMError);
    }
    if (itk_TIFFSetWarningHandler != nullptr && itk_TIFFSetErrorHandler != nullptr)
    {
      itk_TIFFSetWarningHandler(m_TIFFWarning);
      itk_TIFFSetErrorHandler(m_TIFFError);
    }
  }
  SilencedWarnings(const SilencedWarnings &) = delete;
  SilencedWarnings &
  operator=(const SilencedWarnings &) = delete;

private:
  bool                 m_Before;
  const DicomImageIO * m_Dicom;
  bool                 m_GDCMWarning{ false };
  bool                 m_GDCMError{ false };
  TIFFHandler          m_TIFFWarning{ nullptr };
  TIFFHandler          m_TIFFError{ nullptr };
};
} // namespace

ImageIOBase::Pointer
MakeRadiographImageIO(RadiographFileFormatEnum format)
{
  switch (format)
  {
    case Format::PNG:
      return PNGImageIO::New().GetPointer();
    case Format::JPEG:
      return JPEGImageIO::New().GetPointer();
    case Format::TIFF:
      return TIFFImageIO::New().GetPointer();
    case Format::BMP:
      return BMPImageIO::New().GetPointer();
    case Format::NRRD:
      return NrrdImageIO::New().GetPointer();
    case Format::MetaImage:
      return MetaImageIO::New().GetPointer();
    default: {
      const ImageIOBase::Pointer io = LoadDicomImageIO().create();
      // The pointer holds a reference too.
      io->UnRegister();
      return io;
    }
  }
}

void
CallRadiographImageIO(const std::string & fileName, const std::string & format, const std::function<void()> & function)
{
  const std::string problem = "cannot be read as " + format;
  const char *      remedy = "the file may be truncated or damaged: copy or export it again";
  try
  {
    const SilencedWarnings silenced;
    function();
  }
  catch (const DentalInputError &)
  {
    throw;
  }
  catch (const std::bad_alloc &)
  {
    itkDentalInputErrorMacro(fileName, "", problem + ": not enough memory", remedy);
  }
  catch (const ExceptionObject & error)
  {
    itkDentalInputErrorMacro(fileName, "", problem + ": " + std::string(error.GetDescription()).substr(0, 200), remedy);
  }
  catch (const std::exception & error)
  {
    itkDentalInputErrorMacro(fileName, "", problem + ": " + std::string(error.what()).substr(0, 200), remedy);
  }
}
} // namespace itk

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

#include "itkDecodedImageIO.h"
#include "itkDentalInputError.h"

#include "itkJPEGImageIO.h"
#include "itkPNGImageIO.h"

#include <new>

namespace itk
{
namespace
{
using Format = RadiographFileFormatEnum;

/** ITK's readers warn on stderr; a library does not print. */
class SilencedWarnings
{
public:
  SilencedWarnings()
    : m_Before(Object::GetGlobalWarningDisplay())
  {
    Object::SetGlobalWarningDisplay(false);
  }
  ~SilencedWarnings() { Object::SetGlobalWarningDisplay(m_Before); }
  SilencedWarnings(const SilencedWarnings &) = delete;
  SilencedWarnings &
  operator=(const SilencedWarnings &) = delete;

private:
  bool m_Before;
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
    default: {
      const auto io = DecodedImageIO::New();
      io->SetFormat(format);
      return io.GetPointer();
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

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
#include "itkNiftiPictureIO.h"
#include "itkTrimText.h"

#include "itkJPEGImageIO.h"
#include "itkPNGImageIO.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <string>

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

/** What a decoder says, without what is of this process alone: names of files in memory, and where its object lies. */
std::string
HideMemory(std::string text)
{
  for (const char * const word : { "itk::ERROR: ", "ITK ERROR: " })
  {
    const std::size_t at = text.find(word);
    text.erase(at == std::string::npos ? text.size() : at, std::strlen(word));
  }
  for (std::size_t at = text.find("(0x"); at != std::string::npos; at = text.find("(0x"))
  {
    text.erase(at, std::min(text.find(')', at), text.size() - 1) - at + 1);
  }
  const std::string folder = "/proc/self/fd/";
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at))
  {
    const std::size_t end = text.find_first_not_of("0123456789", at + folder.size());
    text.replace(at, std::min(end, text.size()) - at, "it");
  }
  return TrimText(text);
}
} // namespace

ImageIOBase::Pointer
MakeRadiographImageIO(RadiographFileFormatEnum format, const MemoryFile & file)
{
  ImageIOBase::Pointer io;
  switch (format)
  {
    case Format::PNG:
      io = PNGImageIO::New().GetPointer();
      break;
    case Format::JPEG:
      io = JPEGImageIO::New().GetPointer();
      break;
    case Format::NIfTI:
      io = NiftiPictureIO::New().GetPointer();
      break;
    default: {
      const auto decoded = DecodedImageIO::New();
      decoded->SetFormat(format);
      decoded->SetFile(file.GetDescriptor());
      io = decoded.GetPointer();
    }
  }
  io->SetFileName(file.GetName());
  return io;
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
    itkDentalInputErrorMacro(fileName, "", problem + ": " + HideMemory(error.GetDescription()).substr(0, 200), remedy);
  }
  catch (const std::exception & error)
  {
    itkDentalInputErrorMacro(fileName, "", problem + ": " + HideMemory(error.what()).substr(0, 200), remedy);
  }
}
} // namespace itk

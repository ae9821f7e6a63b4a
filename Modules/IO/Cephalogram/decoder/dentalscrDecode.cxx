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
// The program that decodes images for DentalSCR, one a process: DecodedImageIO starts it and says why. Its arguments
// are a format, "colours" or "numbers" for palettes, and a file; it speaks itk::DecoderProtocol on its standard
// streams.

#include "itkDecoderProtocol.h"
#include "itkDicomImageIO.h"
#include "itkTIFFPictureIO.h"

#include "itkBMPImageIO.h"
#include "itkMetaDataObject.h"
#include "itkMetaImageIO.h"
#include "itkNrrdImageIO.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace
{
using itk::DecoderProtocol::Head;
using itk::DecoderProtocol::OutcomeEnum;

/** Lowers a limit; a host may have set a lower one, which stays: to raise it would fail, and leave no limit of ours. */
void
Limit(int what, ::rlim_t soft, ::rlim_t hard)
{
  const auto resource = static_cast<__rlimit_resource>(what);
  ::rlimit   limit{ RLIM_INFINITY, RLIM_INFINITY };
  ::getrlimit(resource, &limit);
  limit.rlim_max = std::min(hard, limit.rlim_max);
  limit.rlim_cur = std::min(soft, std::min(limit.rlim_cur, limit.rlim_max));
  ::setrlimit(resource, &limit);
}

void
Limit(int what, ::rlim_t value)
{
  Limit(what, value, value);
}

void
LimitYourself()
{
  // No PR_SET_PDEATHSIG: it fires when the thread that has started this process ends, which may be long before the
  // program does. Of a program that has ended the socket is closed: waiting ends, and so does writing.
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
#if !defined(__SANITIZE_ADDRESS__)
  // The sanitizer keeps its books in terabytes of addresses.
  Limit(RLIMIT_AS, itk::DecoderProtocol::MemoryLimit);
#endif
  // At the soft limit SIGXCPU ends this process, by which its end is told from others, and at the hard one SIGKILL:
  // were they the same, SIGKILL would come first. Who has started it may ignore or block the signal, and both are
  // inherited.
  ::signal(SIGXCPU, SIG_DFL);
  ::sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  Limit(RLIMIT_CPU, itk::DecoderProtocol::SecondsLimit, itk::DecoderProtocol::SecondsLimit + 1);
  // No file of any length is written: sockets are not counted.
  Limit(RLIMIT_FSIZE, 0);
  Limit(RLIMIT_CORE, 0);
  Limit(RLIMIT_NPROC, 0);
  for (int file = itk::DecoderProtocol::FileDescriptor + 1; file < 1024; ++file)
  {
    ::close(file);
  }
  Limit(RLIMIT_NOFILE, 32);
}

void
Send(const void * data, std::size_t size)
{
  const auto * bytes = static_cast<const char *>(data);
  while (size > 0)
  {
    const ::ssize_t count = ::write(STDOUT_FILENO, bytes, size);
    if (count < 0 && errno == EINTR)
    {
      continue;
    }
    if (count <= 0)
    {
      ::_exit(1);
    }
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
}

template <typename TValue>
void
Send(const TValue & value)
{
  Send(&value, sizeof(value));
}

void
SendText(const std::string & text)
{
  Send(std::uint64_t{ text.size() });
  Send(text.data(), text.size());
}

itk::ImageIOBase::Pointer
MakeDecoder(const std::string & format)
{
  if (format == "TIFF")
  {
    return itk::TIFFPictureIO::New().GetPointer();
  }
  if (format == "BMP")
  {
    return itk::BMPImageIO::New().GetPointer();
  }
  if (format == "NRRD")
  {
    return itk::NrrdImageIO::New().GetPointer();
  }
  if (format == "MetaImage")
  {
    return itk::MetaImageIO::New().GetPointer();
  }
  const itk::ImageIOBase::Pointer io = itk::LoadDicomImageIO().create();
  // The pointer holds a reference too.
  io->UnRegister();
  return io;
}

void
SendInformation(const itk::ImageIOBase & io)
{
  std::vector<std::pair<std::string, std::string>> entries;
  const itk::MetaDataDictionary &                  dictionary = io.GetMetaDataDictionary();
  for (const std::string & key : dictionary.GetKeys())
  {
    std::string value;
    if (itk::ExposeMetaData<std::string>(dictionary, key, value))
    {
      entries.emplace_back(key, value);
    }
  }
  const unsigned int dimensions = io.GetNumberOfDimensions();
  Head               head{};
  head.outcome = OutcomeEnum::Image;
  head.dimensions = dimensions;
  head.components = io.GetNumberOfComponents();
  head.componentType = static_cast<std::uint32_t>(io.GetComponentType());
  head.pixelType = static_cast<std::uint32_t>(io.GetPixelType());
  head.entries = static_cast<std::uint32_t>(entries.size());
  head.bytes = static_cast<std::uint64_t>(io.GetImageSizeInBytes());
  Send(head);
  for (unsigned int i = 0; i < dimensions; ++i)
  {
    Send(std::uint64_t{ io.GetDimensions(i) });
    Send(io.GetSpacing(i));
    Send(io.GetOrigin(i));
    std::vector<double> direction = io.GetDirection(i);
    direction.resize(dimensions);
    Send(direction.data(), direction.size() * sizeof(double));
  }
  for (const auto & entry : entries)
  {
    SendText(entry.first);
    SendText(entry.second);
  }
}

/** The failure of what begins with as much of a head. */
template <typename THead, typename TFunction>
bool
Try(const TFunction & function)
{
  THead head{};
  auto  fail = [&head](OutcomeEnum outcome) {
    reinterpret_cast<OutcomeEnum &>(head) = outcome;
    Send(head);
  };
  try
  {
    function();
    return true;
  }
  catch (const std::bad_alloc &)
  {
    fail(OutcomeEnum::OutOfMemory);
  }
  catch (const itk::MemoryAllocationError &)
  {
    fail(OutcomeEnum::OutOfMemory);
  }
  catch (const itk::ExceptionObject & error)
  {
    fail(OutcomeEnum::Failure);
    SendText(std::string(error.GetDescription()).substr(0, 1000));
  }
  catch (const std::exception & error)
  {
    fail(OutcomeEnum::Failure);
    SendText(std::string(error.what()).substr(0, 1000));
  }
  return false;
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 4)
  {
    return 2;
  }
  LimitYourself();
  itk::Object::SetGlobalWarningDisplay(false);
  itk::ImageIOBase::Pointer io;
  if (!Try<Head>([&] {
        io = MakeDecoder(argv[1]);
        io->SetFileName(argv[3]);
        io->SetExpandRGBPalette(std::string(argv[2]) == "colours");
        io->ReadImageInformation();
      }))
  {
    return 1;
  }
  SendInformation(*io);
  // Who asks for the header alone ends this process here.
  char byte = 0;
  if (::read(STDIN_FILENO, &byte, 1) != 1)
  {
    return 0;
  }
  // Zeros, so that a reader that leaves a part out leaves no memory of others.
  std::vector<char> pixels;
  if (!Try<OutcomeEnum>([&] {
        itk::ImageIORegion region(io->GetNumberOfDimensions());
        for (unsigned int i = 0; i < io->GetNumberOfDimensions(); ++i)
        {
          region.SetIndex(i, 0);
          region.SetSize(i, io->GetDimensions(i));
        }
        io->SetIORegion(region);
        pixels.assign(static_cast<std::size_t>(io->GetImageSizeInBytes()), 0);
        io->Read(pixels.data());
      }))
  {
    return 1;
  }
  Send(OutcomeEnum::Image);
  Send(pixels.data(), pixels.size());
  // Without destructors, which may crash on what the decoder has spoilt, and which the system does faster.
  ::_exit(0);
}

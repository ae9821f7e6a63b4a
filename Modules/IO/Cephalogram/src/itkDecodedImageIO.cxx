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
#include "itkDecodedImageIO.h"

#include "itkDecoderProtocol.h"

#include "itkMetaDataObject.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

// Also where unistd.h doesn't declare it.
extern char ** environ;

namespace itk
{
namespace
{
namespace fs = std::filesystem;
using DecoderProtocol::Head;
using DecoderProtocol::OutcomeEnum;

constexpr char ProgramName[] = "dentalscr-decode";

/** The program that stands with the library or the program that this code is in, as they are built, installed and
 * packed into a wheel; never one of the search path, which may be another version's or another's. */
std::string
FindProgram()
{
  std::vector<fs::path> folders;
  std::error_code       error;
  Dl_info               information;
  if (dladdr(reinterpret_cast<const void *>(&ProgramName), &information) != 0 && information.dli_fname != nullptr)
  {
    folders.push_back(fs::canonical(information.dli_fname, error).parent_path());
  }
  folders.push_back(fs::read_symlink("/proc/self/exe", error).parent_path());
  for (const fs::path & folder : folders)
  {
    for (const char * place : { ".", "../bin", "../../bin" })
    {
      const fs::path program = folder / place / ProgramName;
      if (folder.is_absolute() && ::access(program.c_str(), X_OK) == 0)
      {
        return program.string();
      }
    }
  }
  throw std::runtime_error(std::string("the program ") + ProgramName +
                           ", which decodes such files, is missing: install it beside the libraries of DentalSCR or in "
                           "their ../bin");
}

std::string
NeedsMemory()
{
  return "its decoder needs more than " + std::to_string(DecoderProtocol::MemoryLimit >> 20) + " MiB of memory";
}
} // namespace

/** The program as it runs, and the socket to it. */
class DecodedImageIO::Process
{
public:
  Process(int file, RadiographFileFormatEnum format, bool expandsPalette);
  ~Process() { this->End(); }
  Process(const Process &) = delete;
  Process &
  operator=(const Process &) = delete;

  /** Throws where it sends less, or says nothing for as long as it may take. */
  void
  Receive(void * data, std::size_t size);
  template <typename TValue>
  TValue
  Receive()
  {
    TValue value;
    this->Receive(&value, sizeof(value));
    return value;
  }
  std::string
  ReceiveText();
  /** That it may go on. */
  void
  Send();

private:
  /** Ends it, however far it is. \return its status as waitpid() has it; 0 where that is not known any more */
  int
  End();
  [[noreturn]] void
  Fail();

  int                                   m_Socket{ -1 };
  ::pid_t                               m_Process{ -1 };
  std::chrono::steady_clock::time_point m_Deadline;
};

DecodedImageIO::Process::Process(int file, RadiographFileFormatEnum format, bool expandsPalette)
{
  const std::string program = FindProgram();
  int               sockets[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
  {
    throw std::runtime_error(std::string("no decoder can be started: ") + std::strerror(errno));
  }
  // Never fork(): what another thread holds at that moment, a lock of malloc() for one, it would hold for ever there.
  // Above those that they become there, which each step would close; a host may have closed its own standard streams.
  const int                    theirs = ::fcntl(sockets[1], F_DUPFD_CLOEXEC, DecoderProtocol::FileDescriptor + 1);
  const int                    image = ::fcntl(file, F_DUPFD_CLOEXEC, DecoderProtocol::FileDescriptor + 1);
  ::posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, theirs, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, theirs, STDOUT_FILENO);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, image, DecoderProtocol::FileDescriptor);
  std::string words[] = { program,
                          ToString(format),
                          expandsPalette ? "colours" : "numbers",
                          "/proc/self/fd/" + std::to_string(DecoderProtocol::FileDescriptor) };
  char *      arguments[] = { &words[0][0], &words[1][0], &words[2][0], &words[3][0], nullptr };
  const int   error = ::posix_spawn(&m_Process, program.c_str(), &actions, nullptr, arguments, environ);
  ::posix_spawn_file_actions_destroy(&actions);
  for (const int descriptor : { sockets[1], theirs, image })
  {
    if (descriptor >= 0)
    {
      ::close(descriptor);
    }
  }
  m_Socket = sockets[0];
  if (error != 0)
  {
    m_Process = -1;
    this->End();
    throw std::runtime_error(std::string("no decoder can be started: ") + std::strerror(error));
  }
  // Its own limit is of the time that it computes; it may wait for a disk, too.
  m_Deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2 * DecoderProtocol::SecondsLimit);
}

int
DecodedImageIO::Process::End()
{
  int status = 0;
  if (m_Socket >= 0)
  {
    ::close(m_Socket);
    m_Socket = -1;
  }
  if (m_Process > 0)
  {
    // Of one that has ended by itself nothing is left to be killed, and its status stays what it is.
    ::kill(m_Process, SIGKILL);
    while (::waitpid(m_Process, &status, 0) < 0)
    {
      if (errno != EINTR)
      {
        // The host has told the system not to keep the status of its children.
        status = 0;
        break;
      }
    }
    m_Process = -1;
  }
  return status;
}

void
DecodedImageIO::Process::Fail()
{
  const int status = this->End();
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
  {
    throw std::runtime_error("decoding it takes more than " + std::to_string(DecoderProtocol::SecondsLimit) +
                             " seconds");
  }
  if (WIFSIGNALED(status) && WTERMSIG(status) != SIGKILL)
  {
    throw std::runtime_error("its decoder was ended by signal " + std::to_string(WTERMSIG(status)) +
                             ", which damaged files do to it");
  }
  throw std::runtime_error("its decoder gave no image");
}

void
DecodedImageIO::Process::Receive(void * data, std::size_t size)
{
  auto * bytes = static_cast<char *>(data);
  while (size > 0)
  {
    const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(m_Deadline - std::chrono::steady_clock::now()).count();
    ::pollfd  what{ m_Socket, POLLIN, 0 };
    const int ready = left > 0 ? ::poll(&what, 1, static_cast<int>(left)) : 0;
    if (ready == 0)
    {
      this->End();
      throw std::runtime_error("decoding it takes more than " + std::to_string(2 * DecoderProtocol::SecondsLimit) +
                               " seconds");
    }
    const ::ssize_t count = ready < 0 ? -1 : ::read(m_Socket, bytes, size);
    if (count < 0 && errno == EINTR)
    {
      continue;
    }
    if (count <= 0)
    {
      this->Fail();
    }
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
}

std::string
DecodedImageIO::Process::ReceiveText()
{
  // The longest text of a header that means something is far shorter.
  constexpr std::uint64_t longest = std::uint64_t{ 1 } << 24;
  const auto              length = this->Receive<std::uint64_t>();
  if (length > longest)
  {
    this->Fail();
  }
  std::string text(static_cast<std::size_t>(length), '\0');
  this->Receive(&text[0], text.size());
  return text;
}

void
DecodedImageIO::Process::Send()
{
  const char byte = 1;
  if (::send(m_Socket, &byte, 1, MSG_NOSIGNAL) != 1)
  {
    this->Fail();
  }
  m_Deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2 * DecoderProtocol::SecondsLimit);
}

DecodedImageIO::DecodedImageIO() = default;
DecodedImageIO::~DecodedImageIO() = default;

void
DecodedImageIO::ReadImageInformation()
{
  m_Process = nullptr;
  auto       process = std::make_unique<Process>(m_File, m_Format, this->GetExpandRGBPalette());
  const Head head = process->Receive<Head>();
  if (head.outcome == OutcomeEnum::OutOfMemory)
  {
    throw std::runtime_error(NeedsMemory());
  }
  if (head.outcome == OutcomeEnum::Failure)
  {
    throw std::runtime_error(process->ReceiveText());
  }
  // What comes from a process that decodes what others have made is believed as little as the file is.
  constexpr std::uint32_t mostDimensions = 8;
  constexpr std::uint32_t mostEntries = 100000;
  if (head.outcome != OutcomeEnum::Image || head.dimensions < 2 || head.dimensions > mostDimensions ||
      head.components > 65535 || head.entries > mostEntries ||
      head.componentType > static_cast<std::uint32_t>(IOComponentEnum::LDOUBLE))
  {
    throw std::runtime_error("its decoder gave no image");
  }
  this->SetNumberOfDimensions(head.dimensions);
  for (std::uint32_t i = 0; i < head.dimensions; ++i)
  {
    this->SetDimensions(i, process->Receive<std::uint64_t>());
    this->SetSpacing(i, process->Receive<double>());
    this->SetOrigin(i, process->Receive<double>());
    std::vector<double> direction(head.dimensions);
    process->Receive(direction.data(), direction.size() * sizeof(double));
    this->SetDirection(i, direction);
  }
  this->SetNumberOfComponents(head.components);
  this->SetComponentType(static_cast<IOComponentEnum>(head.componentType));
  this->SetPixelType(static_cast<IOPixelEnum>(head.pixelType));
  MetaDataDictionary & dictionary = this->GetMetaDataDictionary();
  for (std::uint32_t i = 0; i < head.entries; ++i)
  {
    const std::string name = process->ReceiveText();
    EncapsulateMetaData<std::string>(dictionary, name, process->ReceiveText());
  }
  m_Bytes = head.bytes;
  m_Process = std::move(process);
}

void
DecodedImageIO::Read(void * buffer)
{
  if (m_Process == nullptr)
  {
    this->ReadImageInformation();
  }
  const std::unique_ptr<Process> process = std::move(m_Process);
  if (m_Bytes != static_cast<std::uint64_t>(this->GetImageSizeInBytes()))
  {
    throw std::runtime_error("its decoder gave no image");
  }
  process->Send();
  const auto outcome = process->Receive<OutcomeEnum>();
  if (outcome == OutcomeEnum::OutOfMemory)
  {
    throw std::runtime_error(NeedsMemory());
  }
  if (outcome != OutcomeEnum::Image)
  {
    throw std::runtime_error(process->ReceiveText());
  }
  process->Receive(buffer, static_cast<std::size_t>(m_Bytes));
}

void
DecodedImageIO::Write(const void *)
{
  itkExceptionMacro("This class reads only.");
}

void
DecodedImageIO::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Format: " << ToString(m_Format) << std::endl;
  os << indent << "File: " << m_File << std::endl;
  os << indent << "Bytes: " << m_Bytes << std::endl;
  os << indent << "Process: " << (m_Process == nullptr ? "none" : "waiting") << std::endl;
}
} // namespace itk

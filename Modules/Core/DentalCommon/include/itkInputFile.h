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
#ifndef itkInputFile_h
#define itkInputFile_h

#include "DentalCommonExport.h"

#include <sys/stat.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace itk
{
/** \class InputFileError
 * \brief Why a file can't be read, and what to do about it; whoever named the file puts its name to it.
 *
 * \ingroup DentalCommon
 */
class DentalCommon_EXPORT InputFileError : public std::runtime_error
{
public:
  InputFileError(const std::string & problem, const std::string & remedy); /**< In words. */
  ~InputFileError() override;
  /** What to do about it. */
  const std::string &
  GetRemedy() const
  {
    return m_Remedy;
  }

private:
  std::string m_Remedy;
};

/** \class InputFile
 * \brief A regular file that is open for reading: the one door through which the toolkit reads files.
 *
 * Opening never waits: a named pipe, a device, a socket or a folder is none, and neither is what the kernel makes up
 * (/proc has files of no length that never end). Reading doesn't map: a file that is cut short meanwhile is an error
 * and no signal. DescribeProblem() puts what is wrong into words.
 *
 * \ingroup DentalCommon
 */
class DentalCommon_EXPORT InputFile
{
public:
  enum class ProblemEnum
  {
    None,
    Missing,
    Forbidden,
    Folder,
    NotRegular,
    Empty,
    Unopenable
  };
  /** Opens the file; where it can't be, GetProblem() says why, and nothing is thrown. */
  explicit InputFile(const std::string & fileName);
  ~InputFile();
  InputFile(const InputFile &) = delete;
  InputFile &
  operator=(const InputFile &) = delete;
  /** None where it was opened. */
  ProblemEnum
  GetProblem() const
  {
    return m_Problem;
  }
  /** Why it can't be opened, as errno has it. */
  int
  GetSystemError() const
  {
    return m_Error;
  }
  /** When it was opened. */
  std::size_t
  GetSize() const
  {
    return m_Problem == ProblemEnum::None ? static_cast<std::size_t>(m_Status.st_size) : 0;
  }

  /** The next bytes. \return how many there were: fewer than were asked for at the end or after an error */
  std::size_t
  Read(void * data, std::size_t size);

  /** Whether it has another length or another time than when it was opened: what was read may be a mix. */
  bool
  HasChanged() const;

private:
  int         m_File{ -1 };
  int         m_Error{ 0 };
  ProblemEnum m_Problem{ ProblemEnum::None };
  struct stat m_Status
  {};
};

/** Why a file that was opened holds nothing to be read; none where it does.
 *
 * \param what What it should have been, with its article: "a scan", "a JSON file". \ingroup DentalCommon */
DentalCommon_EXPORT std::optional<InputFileError>
                    DescribeProblem(const InputFile & file, const std::string & what);

/** All of its bytes, as many as GetSize() says. Throws an InputFileError where it can't be read or is another one after
 * than before. For who has memory of another kind than a string's; DescribeProblem() comes first. \ingroup DentalCommon
 */
DentalCommon_EXPORT void
ReadWhole(InputFile & file, void * data);

/** All of its bytes. Throws an InputFileError for what DescribeProblem() says, for a file of more bytes than given, and
 * for one that is another one after than before. \ingroup DentalCommon */
DentalCommon_EXPORT std::string
                    ReadWhole(InputFile & file, const std::string & what, std::size_t maximumSize);

/** The first bytes of a file, to tell its format by; nothing of what is no regular file. \ingroup DentalCommon */
DentalCommon_EXPORT std::string
                    ReadFileHead(const std::string & fileName, std::size_t size);
} // namespace itk

#endif

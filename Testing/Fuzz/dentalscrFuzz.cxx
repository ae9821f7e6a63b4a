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
// Mutants for every reader of the toolkit. Utilities/fuzz.sh runs it; `dentalscr-fuzz --help` says how.
//
// Mutants are read by child processes, some hundreds each, that have a limit of memory and of time; of a child that
// ends, the mutant that it was reading is found again by its number and kept. This process reads nothing and has one
// thread, so that it may fork. libFuzzer would need clang, which refuses the headers of ITK 5.2.

#include "itkBatchCaseList.h"
#include "itkBatchRecord.h"
#include "itkBatchSummary.h"
#include "itkCaseResultFileReader.h"
#include "itkCephalogramFileReader.h"
#include "itkCephalometricLandmarkFileReader.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalInputError.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkDentalPhantomLevel.h"
#include "itkMakeAnonymous.h"
#include "itkMemoryFile.h"
#include "itkMutate.h"
#include "itkReadDentalMesh.h"
#include "itkReadDrawings.h"
#include "itkReadLabelImage.h"
#include "itkReadPlacedGeometry.h"
#include "itkReadTransformText.h"
#include "itkRecogniseCaseFolder.h"
#include "itkReportPageWriter.h"
#include "itkReproducibleRandom.h"
#include "itkTextFile.h"
#include "itkToothLabelFileReader.h"
#include "itkTracingSession.h"
#include "itkVTKSurfaceFile.h"

#include "itkTransformFileReader.h"
#include "itkTransformFactory.h"
#include "itkTxtTransformIOFactory.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <minizip/zip.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using ReadFunction = std::function<void(const std::string &)>;

/** Of the processor, which a busy machine doesn't make more of; and by the clock, for what only waits. */
constexpr int         SecondsPerMutant = 10;
constexpr int         SecondsOfWaiting = 300;
constexpr std::size_t BytesPerMutant = std::size_t{ 1 } << 30;
constexpr int         MutantsPerChild = 300;
/** Of a child, for an exception that a reader must not let out. */
constexpr int Escaped = 66;

template <typename TReader>
void
Update(const std::string & fileName)
{
  const auto reader = TReader::New();
  reader->SetFileName(fileName);
  reader->Update();
}

void
ReadScan(const std::string & fileName)
{
  const std::string extension = fs::path(fileName).extension().string();
  if (extension == ".vtk" || extension == ".vtp")
  {
    itk::ReadVTKSurfaceFile(fileName);
    return;
  }
  const auto mesh = itk::ReadDentalMesh<itk::Mesh<float, 3>>(fileName, nullptr);
  for (auto point = mesh->GetPoints()->Begin(); point != mesh->GetPoints()->End(); ++point)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      if (!std::isfinite(point.Value()[d]))
      {
        throw std::logic_error("a point that is not finite was read");
      }
    }
  }
}

void
ReadToothLabels(const std::string & fileName)
{
  const auto reader = itk::ToothLabelFileReader::New();
  reader->SetFileName(fileName);
  reader->SetNumberOfPoints(12);
  reader->Update();
}

void
ReadBatchTable(const std::string & fileName)
{
  itk::BatchCaseList list;
  list.SetOptionNames({ "upper", "lower", "contours", "spacing" }, { "upper", "lower", "contours" });
  list.Find({ fileName });
}

void
ReadTransform(const std::string & fileName)
{
  const auto reader = itk::TransformFileReaderTemplate<double>::New();
  // As the Python package does it.
  const std::string     text = itk::ReadTransformText(fileName);
  const itk::MemoryFile memory(".tfm");
  std::ofstream(memory.GetName(), std::ios::binary) << text;
  reader->SetFileName(memory.GetName());
  try
  {
    reader->Update();
  }
  catch (const itk::ExceptionObject & error)
  {
    // ITK's own reader, and its own words: an exception of Python.
    itkDentalInputErrorMacro(fileName, "", error.GetDescription(), "");
  }
}

void
ReadContours(const std::string & fileName)
{
  const auto reader = itk::DentalContourFileReader::New();
  reader->SetFileName(fileName);
  try
  {
    reader->Update();
  }
  catch (const itk::DentalInputError & error)
  {
    // Some formats don't know how large the picture is.
    if (error.GetField() != "image_size" || error.GetProblem() != "missing field")
    {
      throw;
    }
    reader->SetImageSize({ { 50, 50 } });
    reader->Update();
  }
}

/** The last of several readers of a file says whether it is refused. */
void
ReadByAll(const std::string & fileName, const std::vector<ReadFunction> & readers)
{
  for (const ReadFunction & read : readers)
  {
    try
    {
      read(fileName);
    }
    catch (const itk::DentalInputError & error)
    {
      if (error.GetProblem().empty() || &read == &readers.back())
      {
        throw;
      }
    }
  }
}

/** Also a case that is yet to be drawn. */
void
ReadCase(const std::string & fileName)
{
  ReadByAll(fileName,
            { [](const std::string & name) { itk::ReadDentalCaseToDraw(name); },
              [](const std::string & name) { itk::ReadDentalCase(name); } });
}

/** For who goes on from it, for who draws in it, and for the table of a batch. */
void
ReadResult(const std::string & fileName)
{
  ReadByAll(
    fileName,
    { [](const std::string & name) { itk::ReadPlacedGeometry(name, itk::ToothCode::JawEnum::Upper); },
      [](const std::string & name) { itk::ReadPlacedGeometry(name, itk::ToothCode::JawEnum::Lower, "frontal"); },
      [](const std::string & name) {
        // It has a name of its own there.
        const fs::path folder = fs::temp_directory_path() / ("dentalscr-fuzz-record-" + std::to_string(::getpid()));
        fs::create_directories(folder);
        const fs::path link = folder / "result.json";
        fs::remove(link);
        fs::create_symlink(fs::absolute(name), link);
        itk::BatchRecord record;
        try
        {
          record.ReadResult(folder.string());
        }
        catch (...)
        {
          fs::remove_all(folder);
          throw;
        }
        fs::remove_all(folder);
      },
      Update<itk::CaseResultFileReader> });
}

/** Two lines: a result and what a report draws of it. The page is made of both, once as they are and once without
 * names.
 */
void
ReadReport(const std::string & fileName)
{
  const std::string text = itk::ReadTextFile(fileName, "a report");
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string result = text.substr(0, end);
  const std::string details = text.substr(std::min(end + 1, text.size()));
  // A text is set up to its first zero.
  if (result.empty() || result.front() == '\0')
  {
    itkDentalInputErrorMacro(fileName, "", "has no result in its first line", "write one there");
  }
  const auto page = itk::ReportPageWriter::New();
  page->SetResult(result);
  page->SetDetails(details);
  page->MakePage();
  page->SetResult(itk::MakeResultFileAnonymous(result));
  page->SetDetails(details.empty() ? details : itk::MakeReportDetailsAnonymous(details));
  page->MakePage();
}

/** What is saved by the page on which somebody draws. */
void
ReadSession(const std::string & fileName)
{
  itk::TracingSession::Verify(itk::ReadTextFile(fileName, "what is drawn"), { { 50, 50 } });
}

/** Of a drawing that is gone on with: the tracing and the landmarks. */
void
ReadDrawing(const std::string & fileName)
{
  const auto read = [](bool isTracing) {
    return [isTracing](const std::string & name) {
      itk::DentalCaseData data;
      data.imageSize = { { 50, 50 } };
      itk::DentalCase description;
      description.fileName = name;
      (isTracing ? description.contoursFile : description.cephalometricLandmarksFile) = name;
      itk::ReadDrawings(data, description);
    };
  };
  ReadByAll(fileName, { read(false), read(true) });
}

/** The index of an archive, packed anew: a mutant of the archive itself mostly fails at a check sum. */
void
ReadArchive(const std::string & fileName)
{
  const std::string     index = itk::ReadTextFile(fileName, "an index");
  const itk::MemoryFile memory(".wceph");
  const zipFile         archive = ::zipOpen64(memory.GetName().c_str(), APPEND_STATUS_CREATE);
  if (archive == nullptr ||
      ::zipOpenNewFileInZip(archive, "index.json", nullptr, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED, 1) != ZIP_OK ||
      ::zipWriteInFileInZip(archive, index.data(), static_cast<unsigned int>(index.size())) != ZIP_OK ||
      ::zipCloseFileInZip(archive) != ZIP_OK || ::zipClose(archive, nullptr) != ZIP_OK)
  {
    throw std::logic_error("no archive can be made");
  }
  Update<itk::CephalometricLandmarkFileReader>(memory.GetName());
}

const std::map<std::string, ReadFunction> Targets = {
  { "archive", ReadArchive },
  { "batch", ReadBatchTable },
  { "case", ReadCase },
  { "drawing", ReadDrawing },
  { "folder", [](const std::string & name) { itk::RecogniseCaseFolder(fs::path(name).parent_path().string()); } },
  { "level", [](const std::string & name) { itk::DentalPhantomLevel().ReadJson(name); } },
  { "report", ReadReport },
  { "result", ReadResult },
  { "session", ReadSession },
  { "start",
    [](const std::string & name) {
      itk::DentalCase                     description;
      itk::ReadInitialAlignment(name, description);
    } },
  { "summary", [](const std::string & name) { itk::BatchSummary::ReadFile(name); } },
  { "transform", ReadTransform },
  { "cephalometric", Update<itk::CephalometricLandmarkFileReader> },
  { "contours", ReadContours },
  { "image", Update<itk::CephalogramFileReader> },
  { "labelmap", [](const std::string & name) { itk::ReadLabelImage(name); } },
  { "landmarks2d", Update<itk::DentalLandmarkFileReader<2>> },
  { "landmarks3d", Update<itk::DentalLandmarkFileReader<3>> },
  { "mask", [](const std::string & name) { itk::ReadMaskImage(name); } },
  { "scan", ReadScan },
  { "toothlabels", ReadToothLabels },
};

std::string
ReadAll(const std::string & fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

void
WriteAll(const std::string & fileName, const std::string & bytes)
{
  std::ofstream(fileName, std::ios::binary | std::ios::trunc) << bytes;
}

/** That are in no file, or mean what a reader doesn't expect. */
const std::vector<std::string> Words = { "nan",
                                         "inf",
                                         "-1",
                                         "0",
                                         "1e999",
                                         "-1e30",
                                         "4294967295",
                                         "2147483648",
                                         "99999999999999999999",
                                         "\n",
                                         "\"",
                                         "{",
                                         "[",
                                         "]",
                                         "}",
                                         "null",
                                         "true",
                                         "\xff",
                                         std::string(1, '\0'),
                                         std::string("\xff\xff\xff\xff", 4),
                                         std::string("\x00\x00\x00\x80", 4),
                                         std::string("\xff\xff\xff\x7f", 4),
                                         std::string(300, 'x'),
                                         "\\u0000",
                                         "<",
                                         "</",
                                         "&",
                                         ";" };

/** What a child and this process share. */
struct Board
{
  volatile std::uint64_t current;
  volatile std::uint64_t read;
  volatile std::uint64_t refused;
  char                   words[512];
  /** Why a file was refused: file, field, problem and remedy, with tabulators between them. */
  char refusal[4096];
};

void
LimitYourself()
{
  // The sanitizer keeps its books in terabytes of addresses, also where the libraries alone have it.
  if (::dlsym(RTLD_DEFAULT, "__asan_init") == nullptr)
  {
    // Above what the libraries take.
    std::ifstream pages("/proc/self/statm");
    std::size_t   used = 0;
    pages >> used;
    const std::size_t limit = used * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + BytesPerMutant;
    const ::rlimit    memory{ limit, limit };
    ::setrlimit(RLIMIT_AS, &memory);
  }
  const ::rlimit none{ 0, 0 };
  ::setrlimit(RLIMIT_CORE, &none);
}

/** Reads a file; for a child. \return whether it was read and not refused */
bool
ReadOne(const ReadFunction & read, const std::string & fileName, Board & board)
{
  const ::itimerval computing{ { 0, 0 }, { SecondsPerMutant, 0 } };
  const ::itimerval waiting{ { 0, 0 }, { SecondsOfWaiting, 0 } };
  ::setitimer(ITIMER_PROF, &computing, nullptr);
  ::setitimer(ITIMER_REAL, &waiting, nullptr);
  const auto escape = [&board](const std::string & what) {
    std::strncpy(board.words, what.c_str(), sizeof(board.words) - 1);
    ::_exit(Escaped);
  };
  try
  {
    read(fileName);
    return true;
  }
  catch (const itk::DentalInputError & error)
  {
    if (error.GetProblem().empty())
    {
      escape("refused without words");
    }
    const std::string refusal =
      error.GetInputFile() + '\t' + error.GetField() + '\t' + error.GetProblem() + '\t' + error.GetRemedy();
    std::strncpy(board.refusal, refusal.c_str(), sizeof(board.refusal) - 1);
    return false;
  }
  catch (const std::exception & error)
  {
    escape(error.what());
  }
  catch (...)
  {
    escape("no std::exception");
  }
  return false;
}

/** What became of a child, in words; empty where all is well. */
std::string
Describe(int status, const Board & board)
{
  if (WIFSIGNALED(status))
  {
    return WTERMSIG(status) == SIGPROF   ? "takes more than " + std::to_string(SecondsPerMutant) + " seconds"
           : WTERMSIG(status) == SIGALRM ? "waits for more than " + std::to_string(SecondsOfWaiting) + " seconds"
                                         : "ended by signal " + std::to_string(WTERMSIG(status));
  }
  if (WEXITSTATUS(status) == Escaped)
  {
    return std::string("exception: ") + board.words;
  }
  return WEXITSTATUS(status) == 0 ? std::string() : "ended with " + std::to_string(WEXITSTATUS(status));
}

/** Reads one file in a child. */
std::string
Try(const ReadFunction & read, const std::string & fileName, Board & board)
{
  board.words[0] = '\0';
  board.refusal[0] = '\0';
  const pid_t child = ::fork();
  if (child == 0)
  {
    LimitYourself();
    ++(ReadOne(read, fileName, board) ? board.read : board.refused);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return Describe(status, board);
}

/** Takes away what isn't needed for it to fail as it does. */
void
Minimise(const ReadFunction & read, const std::string & fileName, Board & board)
{
  const std::string how = Try(read, fileName, board);
  if (how.empty())
  {
    std::cout << fileName << ": fails in no way" << std::endl;
    return;
  }
  const std::string trial = fileName + ".trial" + fs::path(fileName).extension().string();
  std::string       bytes = ReadAll(fileName);
  for (std::size_t piece = std::max<std::size_t>(1, bytes.size() / 2); piece > 0; piece /= 2)
  {
    for (std::size_t at = 0; at + piece <= bytes.size();)
    {
      std::string less = bytes;
      less.erase(at, piece);
      WriteAll(trial, less);
      if (Try(read, trial, board) == how)
      {
        bytes = less;
      }
      else
      {
        at += piece;
      }
    }
  }
  fs::remove(trial);
  WriteAll(fileName, bytes);
  std::cout << fileName << ": " << bytes.size() << " bytes, " << how << std::endl;
}

int
Help()
{
  std::cout
    << "dentalscr-fuzz TARGET --seconds N --seed S --findings FOLDER SEED...   mutants of the seeds\n"
       "dentalscr-fuzz TARGET --mutants N --seed S --findings FOLDER SEED...   as many, however long that takes\n"
       "dentalscr-fuzz TARGET --replay FILE...                                reads files as they are\n"
       "dentalscr-fuzz TARGET --tell FILE...                                  the same, and says of each file what "
       "came of it\n"
       "dentalscr-fuzz TARGET --minimise FILE...                              makes files smaller that fail\n"
       "Ends with 1 where a file ends its reader, takes more than "
    << SecondsPerMutant << " s or " << (BytesPerMutant >> 20) << " MiB, or lets an exception out.\nTargets:";
  for (const auto & target : Targets)
  {
    std::cout << ' ' << target.first;
  }
  std::cout << std::endl;
  return 0;
}
} // namespace

int
main(int argc, char * argv[])
{
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty() || words[0] == "--help" || Targets.count(words[0]) == 0)
  {
    return words.empty() || words[0] == "--help" ? Help() : (std::cerr << "no target " << words[0] << std::endl, 2);
  }
  const ReadFunction &     read = Targets.at(words[0]);
  std::string              mode = "mutants";
  std::string              findings = "findings";
  double                   seconds = 5.0;
  std::uint64_t            mutants = 0;
  std::uint64_t            seed = 1;
  std::vector<std::string> files;
  for (std::size_t i = 1; i < words.size(); ++i)
  {
    if (words[i] == "--replay" || words[i] == "--tell" || words[i] == "--minimise")
    {
      mode = words[i];
    }
    else if (words[i] == "--seconds" && i + 1 < words.size())
    {
      seconds = std::stod(words[++i]);
    }
    else if (words[i] == "--mutants" && i + 1 < words.size())
    {
      mutants = std::stoull(words[++i]);
    }
    else if (words[i] == "--seed" && i + 1 < words.size())
    {
      seed = std::stoull(words[++i]);
    }
    else if (words[i] == "--findings" && i + 1 < words.size())
    {
      findings = words[++i];
    }
    else
    {
      files.push_back(words[i]);
    }
  }
  if (files.empty())
  {
    std::cerr << "no file is named" << std::endl;
    return 2;
  }
  itk::TransformFactoryBase::RegisterDefaultTransforms();
  itk::TxtTransformIOFactory::RegisterOneFactory();
  auto & board =
    *static_cast<Board *>(::mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  unsigned int failures = 0;
  if (mode == "--tell")
  {
    // A line a file: the file, what came of it, and of one that was refused what its error says.
    for (const std::string & file : files)
    {
      const std::string how = Try(read, file, board);
      std::string       refusal = board.refusal;
      std::replace(refusal.begin(), refusal.end(), '\n', ' ');
      failures += how.empty() ? 0 : 1;
      std::cout << file << '\t'
                << (!how.empty()      ? "failed\t" + how
                    : refusal.empty() ? "read"
                                      : "refused\t" + refusal)
                << std::endl;
    }
    return failures > 0 ? 1 : 0;
  }
  if (mode == "--replay")
  {
    for (const std::string & file : files)
    {
      const std::string how = Try(read, file, board);
      failures += how.empty() ? 0 : 1;
      std::cout << (how.empty() ? "" : words[0] + ": " + file + ": " + how + '\n');
    }
    std::cout << words[0] << ": " << board.read << " read, " << board.refused << " refused, " << failures << " failed"
              << std::endl;
    return failures > 0 ? 1 : 0;
  }
  if (mode == "--minimise")
  {
    for (const std::string & file : files)
    {
      Minimise(read, file, board);
    }
    return 0;
  }

  std::vector<std::string> seeds;
  std::vector<std::string> extensions;
  for (const std::string & file : files)
  {
    seeds.push_back(ReadAll(file));
    extensions.push_back(fs::path(file).extension().string());
  }
  std::string folder = (fs::temp_directory_path() / "dentalscr-fuzz-XXXXXX").string();
  if (::mkdtemp(&folder[0]) == nullptr)
  {
    std::cerr << "no folder for mutants: set TMPDIR" << std::endl;
    return 2;
  }
  // By its number alone a mutant is made again.
  const auto make = [&](std::uint64_t number, std::string & extension) {
    itk::ReproducibleRandom random(seed, number);
    const std::size_t       which = number % seeds.size();
    extension = extensions[which];
    return itk::Mutate(seeds[which], Words, seeds, random);
  };
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  const auto goesOn = [&](std::uint64_t number) { return mutants > 0 ? number < mutants : Clock::now() < end; };
  std::uint64_t         next = 0;
  std::set<std::string> told;
  while (goesOn(next))
  {
    board.words[0] = '\0';
    const pid_t child = ::fork();
    if (child == 0)
    {
      LimitYourself();
      for (std::uint64_t number = next; number < next + MutantsPerChild && goesOn(number); ++number)
      {
        board.current = number;
        std::string       extension;
        const std::string bytes = make(board.current, extension);
        const std::string file = folder + "/mutant" + extension;
        WriteAll(file, bytes);
        ++(ReadOne(read, file, board) ? board.read : board.refused);
      }
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    const std::string how = Describe(status, board);
    if (!how.empty())
    {
      ++failures;
      std::string       extension;
      const std::string bytes = make(board.current, extension);
      fs::create_directories(findings);
      const std::string file =
        (fs::path(findings) / (words[0] + '-' + std::to_string(seed) + '-' + std::to_string(board.current) + extension))
          .string();
      // One file a way to fail: hundreds of one kind say no more.
      std::string kind = how;
      kind.erase(std::remove_if(kind.begin(), kind.end(), [](char letter) { return letter >= '0' && letter <= '9'; }),
                 kind.end());
      kind += WIFSIGNALED(status) ? std::to_string(WTERMSIG(status)) : std::string();
      if (told.insert(kind).second)
      {
        WriteAll(file, bytes);
        std::cout << words[0] << ": " << file << ": " << how << std::endl;
      }
    }
    next = board.current + 1;
  }
  fs::remove_all(folder);
  std::cout << words[0] << ": " << next << " mutants, " << board.read << " read, " << board.refused << " refused, "
            << failures << " failed" << std::endl;
  return failures > 0 ? 1 : 0;
}

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
#include "itkBenchmark.h"

#include "itkDentalPhantomModel.h"
#include "itkSurfaceMeshFile.h"

#include "itkMultiThreaderBase.h"
#include "vtkSMPTools.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#if defined(__GLIBC__)
#  include <malloc.h>
#endif
#include <unistd.h>

namespace itk
{
namespace
{
struct ScriptPeer
{
  std::string                              kernel;
  std::string                              work;
  std::string                              peer;
  double                                   target;
  std::function<void(const std::string &)> writeArrays;
};

std::vector<void (*)()> &
Files()
{
  static std::vector<void (*)()> files;
  return files;
}

std::vector<ScriptPeer> &
ScriptPeers()
{
  static std::vector<ScriptPeer> peers;
  return peers;
}

bool smokeTest = false;

benchmark::internal::Benchmark *
Register(const std::string & kernel, const std::string & work, const std::string & who, BenchmarkFunction function)
{
  for (const std::string * name : { &kernel, &work, &who })
  {
    if (name->find('/') != std::string::npos)
    {
      throw std::invalid_argument("The name \"" + *name + "\" of a benchmark has a slash");
    }
  }
  auto * registered = benchmark::RegisterBenchmark((kernel + "/" + work + "/" + who).c_str(), std::move(function));
  return registered->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
}

BenchmarkFunction
WithCounter(BenchmarkFunction function, const char * name, double value)
{
  return [function = std::move(function), name, value](benchmark::State & state) {
    function(state);
    state.counters[name] = value;
  };
}
} // namespace

BenchmarkFile::BenchmarkFile(void (*registerAll)())
{
  Files().push_back(registerAll);
}

void
RegisterKernel(const std::string & kernel, const std::string & work, BenchmarkFunction function, double milliseconds)
{
  Register(kernel,
           work,
           "DentalSCR",
           milliseconds > 0.0 ? WithCounter(std::move(function), "limit_ms", milliseconds) : std::move(function));
}

void
RegisterPeer(const std::string & kernel,
             const std::string & work,
             const std::string & peer,
             double              target,
             BenchmarkFunction   function)
{
  Register(kernel, work, peer, WithCounter(std::move(function), "target", target));
}

void
RegisterThreaded(const std::string & kernel, const std::string & work, double target, BenchmarkFunction function)
{
  Register(kernel, work, "DentalSCR on two threads", WithCounter(std::move(function), "threaded_target", target));
}

void
RegisterScriptPeer(const std::string &                      kernel,
                   const std::string &                      work,
                   const std::string &                      peer,
                   double                                   target,
                   std::function<void(const std::string &)> writeArrays)
{
  ScriptPeers().push_back({ kernel, work, peer, target, std::move(writeArrays) });
}

void
RegisterAtMost(const std::string & kernel,
               const std::string & work,
               const std::string & figure,
               double              limit,
               BenchmarkFunction   function)
{
  Register(kernel, work, figure, WithCounter(std::move(function), "at_most", limit))->Iterations(1);
}

void
RegisterAtLeast(const std::string & kernel,
                const std::string & work,
                const std::string & figure,
                double              limit,
                BenchmarkFunction   function)
{
  Register(kernel, work, figure, WithCounter(std::move(function), "at_least", limit))->Iterations(1);
}

void
RegisterGrowth(const std::string & kernel, const std::string & curve, double size, BenchmarkFunction function)
{
  std::ostringstream number;
  number << static_cast<long long>(size);
  Register("growth " + kernel, curve, number.str(), WithCounter(std::move(function), "size", size));
}

std::size_t
BenchmarkSize(std::size_t size)
{
  return smokeTest ? std::min<std::size_t>(size, 3000) : size;
}

bool
IsBenchmarkSmokeTest()
{
  return smokeTest;
}

const TriangleSurface &
PhantomSurface(std::size_t triangles)
{
  static std::map<std::size_t, TriangleSurface> surfaces;
  const auto                                    found = surfaces.find(triangles);
  if (found != surfaces.end())
  {
    return found->second;
  }
  DentalPhantomParameters parameters;
  parameters.numberOfTriangles = static_cast<std::uint32_t>(BenchmarkSize(triangles));
  return surfaces[triangles] = DentalPhantomModel(parameters).MakeJaw(0).surface;
}

const TriangleSurface &
CastSurface()
{
  static const TriangleSurface cast = []() {
    TriangleSurface   surface;
    const std::string name = std::string(DENTALSCR_SHARED_DIR) + "/cases/casts/upper.obj";
    if (std::filesystem::exists(name))
    {
      SurfaceMeshFile file = ReadSurfaceMeshFile(name);
      surface.points = std::move(file.doublePoints);
      // The file is in metres.
      for (auto & point : surface.points)
      {
        for (double & x : point)
        {
          x *= 1000.0;
        }
      }
      surface.triangles = std::move(file.triangles);
    }
    return surface;
  }();
  return cast;
}

void
WriteArray(const std::string & fileName, const double * values, std::size_t rows, std::size_t columns)
{
  std::ostringstream description;
  description << "{'descr': '<f8', 'fortran_order': False, 'shape': (" << rows << ", " << columns << "), }";
  std::string header = description.str();
  header.append(63 - (10 + header.size()) % 64, ' ');
  header += '\n';
  const auto    length = static_cast<std::uint16_t>(header.size());
  std::ofstream file(fileName, std::ios::binary);
  file.write("\x93NUMPY\x01\x00", 8);
  file.put(static_cast<char>(length & 255));
  file.put(static_cast<char>(length >> 8));
  file << header;
  file.write(reinterpret_cast<const char *>(values), static_cast<std::streamsize>(rows * columns * sizeof(double)));
  if (!file.flush())
  {
    throw std::runtime_error(fileName + " could not be written");
  }
}

void
WriteBinarySTL(const std::string & fileName, const TriangleSurface & surface)
{
  std::vector<char> bytes(84 + 50 * surface.triangles.size(), 0);
  const auto        count = static_cast<std::uint32_t>(surface.triangles.size());
  std::memcpy(bytes.data() + 80, &count, 4);
  char * facet = bytes.data() + 84;
  for (const auto & triangle : surface.triangles)
  {
    for (unsigned int corner = 0; corner < 3; ++corner)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        const auto value = static_cast<float>(surface.points[triangle[corner]][d]);
        std::memcpy(facet + 12 + 12 * corner + 4 * d, &value, 4);
      }
    }
    facet += 50;
  }
  std::ofstream file(fileName, std::ios::binary);
  if (!file.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush())
  {
    throw std::runtime_error(fileName + " could not be written");
  }
}

const std::string &
BenchmarkFolder()
{
  struct Folder
  {
    std::string name;
    Folder()
      : name((std::filesystem::temp_directory_path() / "dentalscr-benchmark-XXXXXX").string())
    {
      if (::mkdtemp(name.data()) == nullptr)
      {
        throw std::runtime_error("No folder could be made in the folder for temporary files");
      }
    }
    ~Folder()
    {
      std::error_code ignored;
      std::filesystem::remove_all(name, ignored);
    }
  };
  static const Folder folder;
  return folder.name;
}

double
PeakMemory(const std::function<void()> & function)
{
  const auto read = [](const char * field) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
    {
      double kilobytes = 0.0;
      if (word == field && status >> kilobytes)
      {
        return 1024.0 * kilobytes;
      }
    }
    return 0.0;
  };
#if defined(__GLIBC__)
  // What earlier benchmarks freed would hide what this one takes.
  ::malloc_trim(0);
#endif
  // Resets the peak.
  const bool reset = static_cast<bool>(std::ofstream("/proc/self/clear_refs") << 5 << std::flush);
  const auto before = read("VmRSS:");
  function();
  return reset ? std::max(0.0, read("VmHWM:") - before) : 0.0;
}
} // namespace itk

int
main(int argc, char ** argv)
{
  // Peers run on one thread, as ours do unless a benchmark says otherwise.
  itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(1);
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(1);
  vtkSMPTools::Initialize(1);

  std::string         exportFolder;
  std::string         exportFilter;
  std::vector<char *> rest;
  for (int i = 0; i < argc; ++i)
  {
    if (std::strcmp(argv[i], "--smoke") == 0)
    {
      itk::smokeTest = true;
    }
    else if (std::strncmp(argv[i], "--export=", 9) == 0)
    {
      exportFolder = argv[i] + 9;
    }
    else
    {
      rest.push_back(argv[i]);
    }
  }
  int count = static_cast<int>(rest.size());
  benchmark::Initialize(&count, rest.data());
  if (benchmark::ReportUnrecognizedArguments(count, rest.data()))
  {
    return 1;
  }
  try
  {
    for (const auto registerAll : itk::Files())
    {
      registerAll();
    }
    if (!exportFolder.empty())
    {
      nlohmann::json list = nlohmann::json::array();
      std::size_t    number = 0;
      for (const auto & peer : itk::ScriptPeers())
      {
        const std::string folder = exportFolder + "/" + std::to_string(number++);
        std::filesystem::create_directories(folder);
        peer.writeArrays(folder);
        list.push_back({ { "kernel", peer.kernel },
                         { "work", peer.work },
                         { "peer", peer.peer },
                         { "target", peer.target },
                         { "folder", folder } });
      }
      std::ofstream(exportFolder + "/peers.json") << list.dump(1) << std::endl;
      return 0;
    }
    benchmark::RunSpecifiedBenchmarks();
  }
  catch (const std::exception & error)
  {
    std::cerr << "dentalscr-benchmarks: " << error.what() << std::endl;
    return 1;
  }
  return 0;
}

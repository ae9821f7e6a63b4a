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
#ifndef itkBenchmark_h
#define itkBenchmark_h

#include "itkTriangleSurface.h"

#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <string>

/** What the benchmark files share. Each file registers, in a function that a static BenchmarkFile names, its kernel's
 * own benchmark and its peers' on the same work; `compare` runs them in turns and makes the ratios. */
namespace itk
{
using BenchmarkFunction = std::function<void(benchmark::State &)>;

/** Our implementation of a kernel on some work. Names hold no slash.
 * \param milliseconds what an iteration may take at most, where that is a target */
void
RegisterKernel(const std::string & kernel,
               const std::string & work,
               BenchmarkFunction   function,
               double              milliseconds = 0.0);

/** A peer on the same work; the target is its CPU time over ours. */
void
RegisterPeer(const std::string & kernel,
             const std::string & work,
             const std::string & peer,
             double              target,
             BenchmarkFunction   function);

/** Ours on two threads against ours on one, by wall time. */
void
RegisterThreaded(const std::string & kernel, const std::string & work, double target, BenchmarkFunction function);

/** A peer in peers.py, which reads the arrays that the function writes into a folder. */
void
RegisterScriptPeer(const std::string &                      kernel,
                   const std::string &                      work,
                   const std::string &                      peer,
                   double                                   target,
                   std::function<void(const std::string &)> writeArrays);

/** A figure that is no time, such as memory or a number of successes: the function puts it into
 * state.counters["figure"]; it runs once. */
void
RegisterAtMost(const std::string & kernel,
               const std::string & work,
               const std::string & figure,
               double              limit,
               BenchmarkFunction   function);
void
RegisterAtLeast(const std::string & kernel,
                const std::string & work,
                const std::string & figure,
                double              limit,
                BenchmarkFunction   function);

/** A point of a growth curve. */
void
RegisterGrowth(const std::string & kernel, const std::string & curve, double size, BenchmarkFunction function);

/** Registers what is in a file, once the command line is known. */
struct BenchmarkFile
{
  explicit BenchmarkFile(void (*registerAll)());
};

/** The size to use for a size asked for: small ones in the smoke test. */
std::size_t
BenchmarkSize(std::size_t size);
bool
IsBenchmarkSmokeTest();

/** The upper jaw of the average phantom in the anatomical frame, about so many triangles; made once. */
const TriangleSurface &
PhantomSurface(std::size_t triangles);

/** The upper jaw of a patient, from the shared sample cases; without points where they are not there. */
const TriangleSurface &
CastSurface();

/** Writes rows x columns doubles, row-major, as a NumPy file. */
void
WriteArray(const std::string & fileName, const double * values, std::size_t rows, std::size_t columns);

/** Writes a binary STL. */
void
WriteBinarySTL(const std::string & fileName, const TriangleSurface & surface);

/** A folder for files of this run, removed at its end. */
const std::string &
BenchmarkFolder();

/** Bytes by which memory rose above its level at the start while the function ran; 0 where the system does not tell. */
double
PeakMemory(const std::function<void()> & function);
} // namespace itk

#endif

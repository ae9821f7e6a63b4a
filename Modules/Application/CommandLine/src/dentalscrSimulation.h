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
#ifndef dentalscrSimulation_h
#define dentalscrSimulation_h

#include "dentalscrCommandTools.h"

#include "itkProcessObject.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

// What the verbs phantom and experiment do, in a library of its own: the phantom, the baselines and the studies have a
// fifth of what the program's other verbs would look up when they start. The verbs themselves say what may be asked
// for, and load it when they are chosen. Not installed.
namespace dentalscr
{
/** What the verb phantom is asked for. */
struct PhantomOptions
{
  std::string   output;
  std::string   level{ "typical" };
  std::string   parameters;
  bool          showParameters{ false };
  unsigned int  preview{ 0 };
  std::string   tracedSide;
  std::uint64_t seed{ 1 };
  unsigned int  count{ 1 };
  unsigned int  triangles{ 0 };
  bool          buccal{ false };
  bool          stoneBase{ false };
  bool          noRadiograph{ false };
  double        toothBias{ 0.0 };
  double        dropOut{ 0.0 };
  std::string   facing{ "right" };
  std::string   sourceSide{ "right" };
  std::string   frame;
};

/** What the verb experiment is asked for. */
struct ExperimentOptions
{
  unsigned int             cases{ 34 };
  std::uint64_t            seed{ 1 };
  std::string              level{ "typical" };
  std::string              parameters;
  std::string              output;
  std::vector<std::string> methods{ "default" };
  std::string              from;
  std::string              study;
  unsigned int             starts{ 100 };
  bool                     noFigures{ false };
  /** An option about the phantom was given to a study that has levels of its own. */
  std::string refused;
};

/** Updates the process object, shows its progress with the stage that the function tells and ends it when the user
 * interrupts the program. */
using UpdateFunction = std::function<void(itk::ProcessObject *, const std::function<std::string()> & stage)>;

/** Makes the cases; returns the program's exit code. */
int
MakePhantoms(const PhantomOptions & options, const CommonOptions & common);

/** Runs the experiment; returns the program's exit code. */
int
RunExperiment(const ExperimentOptions & options, const CommonOptions & common, const UpdateFunction & update);
} // namespace dentalscr

/** MakePhantoms() of the part that links the phantom. */
extern "C" __attribute__((visibility("default"))) int
DentalSCRMakePhantoms(const dentalscr::PhantomOptions & options, const dentalscr::CommonOptions & common);

/** RunExperiment() of the part that links the experiment. */
extern "C" __attribute__((visibility("default"))) int
DentalSCRRunExperiment(const dentalscr::ExperimentOptions & options,
                       const dentalscr::CommonOptions &     common,
                       const dentalscr::UpdateFunction &    update);

#endif

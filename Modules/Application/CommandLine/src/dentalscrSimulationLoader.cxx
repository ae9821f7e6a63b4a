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
#include "dentalscrSimulation.h"

#ifdef DENTALSCR_SIMULATION_LIBRARY
#  include "itkLoadLibraryFunction.h"
#endif

namespace dentalscr
{
#ifdef DENTALSCR_SIMULATION_LIBRARY
namespace
{
template <typename TFunction>
TFunction
Load(const char * function, const char * failure)
{
  return itk::LoadLibraryFunction<TFunction>(
    DENTALSCR_SIMULATION_LIBRARY, function, failure, DENTALSCR_SIMULATION_LIBRARY);
}
} // namespace
#endif

int
MakePhantoms(const PhantomOptions & options, const CommonOptions & common)
{
#ifdef DENTALSCR_SIMULATION_LIBRARY
  return Load<decltype(&DentalSCRMakePhantoms)>("DentalSCRMakePhantoms", "Cases cannot be simulated")(options, common);
#else
  return DentalSCRMakePhantoms(options, common);
#endif
}

int
RunExperiment(const ExperimentOptions & options, const CommonOptions & common, const UpdateFunction & update)
{
#ifdef DENTALSCR_SIMULATION_LIBRARY
  return Load<decltype(&DentalSCRRunExperiment)>("DentalSCRRunExperiment",
                                                 "The experiment cannot be run")(options, common, update);
#else
  return DentalSCRRunExperiment(options, common, update);
#endif
}
} // namespace dentalscr

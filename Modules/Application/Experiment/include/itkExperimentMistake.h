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
#ifndef itkExperimentMistake_h
#define itkExperimentMistake_h

#include "ExperimentExport.h"

#include <cstdint>
#include <vector>

namespace itk
{
/** \class ExperimentMistakeEnums
 * \brief What people do wrong with a case; the verdict should notice.
 * \ingroup Experiment
 */
class ExperimentMistakeEnums
{
public:
  enum class Mistake : std::uint8_t
  {
    None,
    /** The files of the two scans. */
    ScansExchanged,
    /** The tracings of the two jaws, with the codes of the jaw they are given for. */
    TracingsExchanged,
    /** Scans in cm that are said to be in mm. */
    WrongUnit,
    WrongFacing,
    /** The left side, with the codes of the right one, which is said to be traced. */
    OtherSideTraced,
    /** The same with the codes of the left side. */
    OtherSideTracedAndCoded,
    /** The scans, wound outward again. */
    MirroredScans,
    /** The same with the triangles as they come: wound inward. */
    MirroredScansInward,
    /** A pixel spacing 1.3 times too large. */
    WrongSpacing,
    /** Incisors and canines. */
    FrontTeethOnly,
    /** The tracings of the next seed. */
    OtherPatient
  };
};

/** All but None. */
Experiment_EXPORT const std::vector<ExperimentMistakeEnums::Mistake> &
                        GetExperimentMistakes();

/** In words. */
Experiment_EXPORT const char *
Describe(ExperimentMistakeEnums::Mistake mistake);
} // namespace itk

#endif

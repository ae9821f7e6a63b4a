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
#ifndef itkSilhouetteToContourPresets_h
#define itkSilhouetteToContourPresets_h

#include "itkSilhouetteToContourLevel.h"

#include <cstdint>
#include <vector>

// The presets of SilhouetteToContourRegistrationMethod as a table: their numbers can be compared at a glance, and
// another preset is another row or two. Private to this module.
namespace itk
{
enum class SilhouetteToContourPresetEnum : uint8_t
{
  Paper,
  SingleStage,
  Global
};

/** The levels of a preset, coarse to fine. */
std::vector<SilhouetteToContourLevel>
MakePresetLevels(SilhouetteToContourPresetEnum preset);
} // namespace itk

#endif

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
#include "itkPoseStateBlocks.h"

namespace itk
{
RegistrationState::BlockType
PoseStateBlocks::MakePose(const std::string & name)
{
  return { name,
           { { "pitch", 0.0, Arm, 0.1, true },
             { "roll", 0.0, Arm, 0.07, true },
             { "yaw", 0.0, Arm, 0.07, true },
             { "tx", 0.0, 1.0, 6.0, true },
             { "ty", 0.0, 1.0, 6.0, true },
             { "tz", 0.0, 1.0, 6.0, true } } };
}

RegistrationState::BlockType
PoseStateBlocks::MakeScale(const std::string & name)
{
  return { name, { { "kappa", 0.0, Arm, 0.03, true } } };
}

std::string
PoseStateBlocks::MakeMoveName(const std::string & view)
{
  return view + " move";
}

std::string
PoseStateBlocks::MakeScaleName(const std::string & view)
{
  return view + " scale";
}
} // namespace itk

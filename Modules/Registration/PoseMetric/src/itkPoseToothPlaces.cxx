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
#include "itkPoseToothPlaces.h"

#include "itkPoseArch.h"

namespace itk
{
namespace
{
constexpr unsigned int Canine = 3;
constexpr unsigned int FirstPremolar = 4;
} // namespace

PoseToothPlaces::PoseToothPlaces(const PoseTracing & tracing)
{
  for (const std::uint8_t tooth : tracing.tooth)
  {
    const double arc = PoseArch::ExpectedArc(tooth);
    if (arc > 0.0)
    {
      m_Arc[tooth % 10] = PoseArch::CurveShare * arc;
    }
  }
  bool hasPlace = false;
  for (unsigned int position = Canine; position < m_Arc.size(); ++position)
  {
    if (position > FirstPremolar && hasPlace)
    {
      m_Arc[position] = 0.0;
    }
    hasPlace = hasPlace || m_Arc[position] > 0.0;
  }
}
} // namespace itk

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
#include "itkContourMetricEnums.h"

#include <ostream>

namespace itk
{
std::ostream &
operator<<(std::ostream & os, ContourMetricEnums::Direction value)
{
  switch (value)
  {
    case ContourMetricEnums::Direction::Symmetric:
      return os << "itk::ContourMetricEnums::Direction::Symmetric";
    case ContourMetricEnums::Direction::MovingToFixed:
      return os << "itk::ContourMetricEnums::Direction::MovingToFixed";
    case ContourMetricEnums::Direction::FixedToMoving:
      return os << "itk::ContourMetricEnums::Direction::FixedToMoving";
  }
  return os << "INVALID VALUE FOR itk::ContourMetricEnums::Direction";
}

std::ostream &
operator<<(std::ostream & os, ContourMetricEnums::Distance value)
{
  switch (value)
  {
    case ContourMetricEnums::Distance::PointToPoint:
      return os << "itk::ContourMetricEnums::Distance::PointToPoint";
    case ContourMetricEnums::Distance::PointToSegment:
      return os << "itk::ContourMetricEnums::Distance::PointToSegment";
  }
  return os << "INVALID VALUE FOR itk::ContourMetricEnums::Distance";
}
} // namespace itk

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
#include "itkTracedSide.h"

#include <array>
#include <ostream>
#include <stdexcept>

namespace itk
{
namespace
{
constexpr std::array<const char *, 5> Names{ { "right", "left", "mean", "both", "standard" } };
} // namespace

std::string
ToString(TracedSideEnum side)
{
  return Names.at(static_cast<std::size_t>(side));
}

TracedSideEnum
TracedSideFromString(const std::string & text)
{
  for (std::size_t k = 0; k < Names.size(); ++k)
  {
    if (text == Names[k])
    {
      return static_cast<TracedSideEnum>(k);
    }
  }
  throw std::invalid_argument("\"" + text +
                              "\" is no traced side (\"right\", \"left\", \"mean\", \"both\" or \"standard\")");
}

std::ostream &
operator<<(std::ostream & os, TracedSideEnum side)
{
  return os << ToString(side);
}
} // namespace itk

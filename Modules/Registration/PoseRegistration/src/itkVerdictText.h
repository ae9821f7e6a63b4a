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
#ifndef itkVerdictText_h
#define itkVerdictText_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace itk
{
/** Not installed. A number for a sentence, the same in every locale. */
std::string
FormatNumber(double value, int digits);

/** Not installed. Landmarks that lie where they are expected, and those that stand apart; distances in standard
 * deviations. */
class LandmarkTally
{
public:
  explicit LandmarkTally(double limit)
    : m_Limit(limit)
  {}

  void
  Add(const std::string & name, double distance)
  {
    if (distance > m_Limit)
    {
      m_Apart.push_back(name);
      m_Largest = std::max(m_Largest, distance);
    }
    else
    {
      m_Sum += distance * distance;
      ++m_Kept;
    }
  }

  /** Beyond the limit. */
  const std::vector<std::string> &
  GetApart() const
  {
    return m_Apart;
  }
  /** Of those apart; 0 without any. */
  double
  GetLargest() const
  {
    return m_Largest;
  }
  std::size_t
  GetKept() const
  {
    return m_Kept;
  }
  /** Root mean square of the others an axis, two axes a landmark: 1 where errors are what they are said to be. */
  double
  GetRatio() const
  {
    return m_Kept > 0 ? std::sqrt(m_Sum / (2.0 * static_cast<double>(m_Kept))) : 0.0;
  }

private:
  double                   m_Limit;
  std::vector<std::string> m_Apart;
  double                   m_Largest{ 0.0 };
  double                   m_Sum{ 0.0 };
  std::size_t              m_Kept{ 0 };
};
} // namespace itk

#endif

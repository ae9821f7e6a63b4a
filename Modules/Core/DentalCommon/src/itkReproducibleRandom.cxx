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
#include "itkReproducibleRandom.h"

#include <cmath>

namespace itk
{
namespace
{
std::uint64_t
Mix(std::uint64_t z)
{
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}
} // namespace

ReproducibleRandom::ReproducibleRandom(std::uint64_t seed, std::uint64_t stream)
  : m_State(Mix(seed + 0x9e3779b97f4a7c15ULL) ^ Mix(stream * 0xd1342543de82ef95ULL + 0x632be59bd9b4e019ULL))
{}

std::uint64_t
ReproducibleRandom::NextBits()
{
  m_State += 0x9e3779b97f4a7c15ULL;
  return Mix(m_State);
}

double
ReproducibleRandom::Uniform()
{
  return static_cast<double>(NextBits() >> 11) * 0x1.0p-53;
}

std::uint32_t
ReproducibleRandom::Integer(std::uint32_t count)
{
  return static_cast<std::uint32_t>(((NextBits() >> 32) * count) >> 32);
}

double
ReproducibleRandom::Normal()
{
  if (m_HasSpare)
  {
    m_HasSpare = false;
    return m_Spare;
  }
  double x = 0.0;
  double y = 0.0;
  double squared = 0.0;
  do
  {
    x = 2.0 * Uniform() - 1.0;
    y = 2.0 * Uniform() - 1.0;
    squared = x * x + y * y;
  } while (squared >= 1.0 || squared == 0.0);
  const double factor = std::sqrt(-2.0 * std::log(squared) / squared);
  m_Spare = y * factor;
  m_HasSpare = true;
  return x * factor;
}
} // namespace itk

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
#ifndef itkReproducibleRandom_h
#define itkReproducibleRandom_h

#include "DentalCommonExport.h"

#include <cstdint>

namespace itk
{
/** \class ReproducibleRandom
 * \brief Seeded random numbers with the same bits from every compiler.
 *
 * The generator is SplitMix64 (Steele, Lea, Flood 2014). The standard library's distributions differ between
 * implementations, hence samplers of our own. A stream number gives independent sequences for one seed, one a case or a
 * jaw, so that adding a draw in one does not move the others.
 *
 * \ingroup DentalCommon
 */
class DentalCommon_EXPORT ReproducibleRandom
{
public:
  explicit ReproducibleRandom(std::uint64_t seed, std::uint64_t stream = 0); /**< Streams are independent. */
  /** Sixty-four random bits. */
  std::uint64_t
  NextBits();

  /** Uniform in [0, 1). */
  double
  Uniform();
  /** From low (included) to high (not included), or about a mean with a standard deviation. */
  double
  Uniform(double low, double high)
  {
    return low + (high - low) * Uniform();
  }

  /** Uniform in {0, ..., count - 1}; count > 0. */
  std::uint32_t
  Integer(std::uint32_t count);

  /** Standard normal by the polar method (Marsaglia, Bray 1964). */
  double
  Normal();
  /** About a mean, with a standard deviation. */
  double
  Normal(double mean, double sigma)
  {
    return mean + sigma * Normal();
  }

private:
  std::uint64_t m_State;
  double        m_Spare{ 0.0 };
  bool          m_HasSpare{ false };
};
} // namespace itk

#endif

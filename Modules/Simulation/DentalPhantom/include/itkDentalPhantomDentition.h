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
#ifndef itkDentalPhantomDentition_h
#define itkDentalPhantomDentition_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomArch.h"
#include "itkDentalPhantomParameters.h"
#include "itkDentalPhantomToothBody.h"

#include <array>
#include <cstdint>

namespace itk
{
/** \class DentalPhantomDentition
 * \brief The teeth of both jaws as solids on their arches, in the frame of a jaw whose occlusal side is up.
 *
 * Frame: x anterior, y patient's left, o occlusal (the upper jaw is turned over), mm.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomDentition
{
public:
  using PointType = std::array<double, 3>;

  static constexpr unsigned int NumberOfTeeth = DentalPhantomJaw::NumberOfTeeth; /**< A jaw. */
  /** Stands the teeth of the parameters on their arches. */
  explicit DentalPhantomDentition(const DentalPhantomParameters & parameters);
  /** What it was made of: the parameters, and the arches. */
  const DentalPhantomParameters &
  GetParameters() const
  {
    return m_Parameters;
  }
  const DentalPhantomArch &
  GetArch() const
  {
    return m_Arch;
  }
  /** Index as in DentalPhantomJaw::GetTooth(). */
  const DentalPhantomToothBody &
  GetBody(unsigned int jaw, unsigned int tooth) const
  {
    return m_Bodies[jaw][tooth];
  }
  const std::array<DentalPhantomToothBody, NumberOfTeeth> &
  GetBodies(unsigned int jaw) const
  {
    return m_Bodies[jaw];
  }
  /** The last tooth of a side that the arch has a place for: 0 right, 1 left. */
  const DentalPhantomToothBody &
  GetLastBody(unsigned int jaw, unsigned int side) const;

  /** Moves a tooth occlusally. */
  void
  Move(unsigned int jaw, unsigned int tooth, double shift);

  /** FDI number of a tooth by its index. */
  static std::uint8_t
  ToothFDI(unsigned int jaw, unsigned int tooth);

private:
  void
  PlaceTeeth(unsigned int jaw);

  DentalPhantomParameters                                          m_Parameters;
  DentalPhantomArch                                                m_Arch;
  std::array<std::array<DentalPhantomToothBody, NumberOfTeeth>, 2> m_Bodies;
};
} // namespace itk

#endif

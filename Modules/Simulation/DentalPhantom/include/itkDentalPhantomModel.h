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
#ifndef itkDentalPhantomModel_h
#define itkDentalPhantomModel_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomDentition.h"
#include "itkDentalPhantomJawSurface.h"
#include "itkDentalPhantomMesher.h"
#include "itkDentalPhantomParameters.h"

#include <array>
#include <cstdint>

namespace itk
{
/** \class DentalPhantomModel
 * \brief The solid crowns and the gingiva behind a phantom, and the meshes that a scanner would make of them.
 *
 * DentalPhantomDentition holds the solids, DentalPhantomMesher makes a mesh of each jaw. The lower crowns are moved
 * vertically until each touches the upper jaw. All results are in the anatomical frame: x anterior, y patient's left,
 * z superior, mm. Free of ITK headers; the same bits for any number of threads.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomModel
{
public:
  using PointType = std::array<double, 3>;

  using ProgressType = DentalPhantomMesher::ProgressType;
  using Landmark = DentalPhantomJawSurface::Landmark;
  using JawSurface = DentalPhantomJawSurface;

  /** Throws std::invalid_argument where DentalPhantomParameters::Validate() does. */
  explicit DentalPhantomModel(const DentalPhantomParameters & parameters, unsigned int threads = 0);

  /** The mesh of a jaw: 0 upper, 1 lower. */
  JawSurface
  MakeJaw(unsigned int jaw, unsigned int threads = 0, const ProgressType & progress = {}) const;

  /** The same as a scanner's software hands it over: decimated, with flaps, crumbs, specks and holes where the
   * parameters ask for them; else MakeJaw(). */
  JawSurface
  MakeScan(unsigned int jaw, unsigned int threads = 0, const ProgressType & progress = {}) const;

  /** The jaw itself: neither brackets nor noise nor anything of the scan, at a resolution of its own. */
  JawSurface
  MakeCleanJaw(unsigned int jaw, std::uint32_t numberOfTriangles, unsigned int threads = 0) const;
  /** What it was made of. */
  const DentalPhantomParameters &
  GetParameters() const
  {
    return m_Dentition.GetParameters();
  }

  /** How far a tooth of the lower jaw was moved upward to touch the upper jaw, mm; index as in DentalPhantomJaw. */
  double
  GetSettlement(unsigned int tooth) const
  {
    return m_Settlement[tooth];
  }

  /** Whether the tooth exists. */
  bool
  HasTooth(unsigned int jaw, unsigned int tooth) const
  {
    return m_Dentition.GetBody(jaw, tooth).present;
  }

  /** Where a ray runs through a tooth, root included: lengths in mm of enamel-covered crown and of root. */
  std::array<double, 2>
  RayThroughTooth(unsigned int jaw, unsigned int tooth, const PointType & origin, const PointType & direction) const;

  /** Centre and radius of a sphere around a tooth with its root. */
  PointType
  GetToothCentre(unsigned int jaw, unsigned int tooth) const;
  double
  GetToothRadius(unsigned int jaw, unsigned int tooth) const;

  /** Unit vector of the tooth's buccal direction in the anatomical frame. */
  PointType
  GetBuccalDirection(unsigned int jaw, unsigned int tooth) const;

  /** A point of the anatomical frame in the tooth's own: mesial, buccal, occlusal from the cervix, mm. */
  PointType
  TransformToTooth(unsigned int jaw, unsigned int tooth, const PointType & point) const;

  /** FDI number of a tooth by its index in DentalPhantomJaw. */
  static std::uint8_t
  ToothFDI(unsigned int jaw, unsigned int tooth)
  {
    return DentalPhantomDentition::ToothFDI(jaw, tooth);
  }

  /** The solids themselves. */
  const DentalPhantomDentition &
  GetDentition() const
  {
    return m_Dentition;
  }

private:
  DentalPhantomDentition                                    m_Dentition;
  std::array<double, DentalPhantomDentition::NumberOfTeeth> m_Settlement{};
};
} // namespace itk

#endif

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
#ifndef itkDentalPhantomMesher_h
#define itkDentalPhantomMesher_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomDentition.h"
#include "itkDentalPhantomJawSurface.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace itk
{
struct DentalPhantomGrid;

/** \class DentalPhantomMesher
 * \brief What a scanner would make of a jaw: a mesh of its teeth and gingiva.
 *
 * The gingiva is a ridge along the arch. The mesh is a grid of rays that fan out from a curve inside the ridge and stop
 * where they leave the solid, so that it is a manifold open shell by construction and shows undercuts that the curve
 * can see. The same bits for any number of threads.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomMesher
{
public:
  using PointType = DentalPhantomDentition::PointType;
  using JawSurface = DentalPhantomJawSurface;
  /** Called from one thread with the fraction done; may throw to abort. */
  using ProgressType = std::function<void(double)>;

  /** Keeps a reference: the dentition must outlive the mesher. */
  explicit DentalPhantomMesher(const DentalPhantomDentition & dentition)
    : m_Dentition(dentition)
  {}

  /** A jaw (0 upper, 1 lower) of about that many triangles in the anatomical frame. `finish` adds brackets and the
   * scanner's noise.
   */
  JawSurface
  MakeJaw(unsigned int         jaw,
          std::uint32_t        numberOfTriangles,
          bool                 finish,
          unsigned int         threads,
          const ProgressType & progress) const;

private:
  /** The plane across the arch at one column. */
  struct Station
  {
    PointType origin;
    double    normal[2];
    double    buccalExtent;
    double    lingualExtent;
    double    crest;
    double    buccalFlange;
    double    lingualFlange;
    int       near[6];
    int       numberOfNear;
  };

  DentalPhantomGrid
  MakeLayout(unsigned int jaw, std::uint32_t numberOfTriangles) const;
  Station
  MakeStation(unsigned int jaw, double s) const;
  double
  Gingiva(unsigned int jaw, const Station & station, double q, double o) const;
  void
  ShootRays(unsigned int                jaw,
            const DentalPhantomGrid &   layout,
            bool                        brackets,
            unsigned int                threads,
            const ProgressType &        progress,
            std::vector<PointType> &    rays,
            std::vector<std::uint8_t> & rayLabels) const;
  /** From the lingual border to the midline. */
  void
  AddPalate(unsigned int jaw, DentalPhantomGrid & layout, JawSurface & result) const;

  const DentalPhantomDentition & m_Dentition;
};
} // namespace itk

#endif

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
#ifndef itkSceneDetector_h
#define itkSceneDetector_h

#include "RegistrationSceneExport.h"

#include "itkContinuousIndex.h"
#include "itkPoint.h"
#include "itkVector.h"

#include <array>

namespace itk
{
/** \class SceneDetector
 * \brief Where the source of a radiograph and each of its pixels are in space.
 *
 * All is taken from a projection matrix and the distance between source and detector, and nothing from the way in which
 * a view is described: a lateral and a frontal radiograph, any side of the source, any facing, and a scale that was
 * estimated are all only matrices here. The source is where the projection is not defined, the detector the plane at
 * its distance on which depth is constant, and a pixel lies where its ray meets that plane. A point of space, the
 * source and the point's pixel are therefore on one line by construction.
 *
 * \ingroup RegistrationScene
 */
class RegistrationScene_EXPORT SceneDetector
{
public:
  using PointType = Point<double, 3>;
  using VectorType = Vector<double, 3>;
  using PixelType = ContinuousIndex<double, 2>;
  /** Row-major 3x4: frame of the scene (mm) to homogeneous continuous pixel index. */
  using ProjectionType = std::array<double, 12>;

  /** Throws std::invalid_argument where the matrix has no source, where the scene's origin is not in front of it, or
   * where the distance is not above 0. */
  SceneDetector(const ProjectionType & projection, double sourceToDetector);

  /** Scaled so that the third row gives the distance from the source along the central ray, mm. */
  const ProjectionType &
  GetProjection() const
  {
    return m_Projection;
  }
  double
  GetSourceToDetectorDistance() const
  {
    return m_Distance;
  }
  /** Where the rays come from, mm, frame of the scene. */
  const PointType &
  GetSource() const
  {
    return m_Source;
  }
  /** Unit vector from the source at a right angle to the detector. */
  const VectorType &
  GetAxis() const
  {
    return m_Axis;
  }
  /** Where the central ray meets the detector. */
  PointType
  GetCentralPoint() const;
  PixelType
  GetCentralPixel() const;

  /** A continuous pixel index on the detector. */
  PointType
  GetPoint(double u, double v) const;
  /** Where a point of space is seen. It must not be in the plane of the source. */
  PixelType
  GetPixel(const PointType & point) const;

private:
  ProjectionType        m_Projection;
  double                m_Distance;
  PointType             m_Source;
  VectorType            m_Axis;
  std::array<double, 9> m_Inverse;
};
} // namespace itk

#endif

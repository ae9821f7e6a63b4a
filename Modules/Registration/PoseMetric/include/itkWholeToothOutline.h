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
#ifndef itkWholeToothOutline_h
#define itkWholeToothOutline_h

#include "PoseMetricExport.h"

#include "itkDentalContour.h"
#include "itkPoseTypes.h"
#include "itkToothCode.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace itk
{
/** \class WholeToothOutline
 * \brief The closed outline of a whole tooth, crown and root, as a cephalometric analysis draws it, and the part of it
 * that a scan can show.
 *
 * The tooth's axis is the outline's long one, its occlusal end the one toward the other jaw. The crown ends at the
 * neck, which is put at a textbook's share of the tooth's length; a tenth of the crown before it is left out, as
 * gingiva covers it on a scan. Points lie at equal distances on what is left, from one side over the occlusal end to
 * the other, with outward normals. Coordinates are those of the working plane (PoseModel::ToWorkingPlane()): u
 * anterior, v inferior.
 *
 * Sources of the shares: Wheeler's dental anatomy, table of measurements (crown 10.5 of 23.5 mm in an upper central
 * incisor, 9 of 21.5 in a lower one, 7.5 of 20 and of 21.5 in first molars).
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT WholeToothOutline
{
public:
  using PointType = std::array<double, 2>;

  /** Distance of the points, px of 0.25 mm. */
  static constexpr double Spacing = 2.5;

  /** \param polyline  continuous pixel indices; an open one whose ends meet within a tenth of its length is closed. */
  WholeToothOutline(const PoseGeometry &                geometry,
                    const DentalContour::PolylineType & polyline,
                    ToothCode::JawEnum                  jaw);

  /** Why it is no outline of a whole tooth; empty where it is one. */
  const std::string &
  GetFailure() const
  {
    return m_Failure;
  }
  /** 1 central incisor .. 8 third molar. */
  unsigned int
  GetPosition() const
  {
    return m_Position;
  }
  /** Of all of the outline, about which a hand turns it and makes it larger or smaller. */
  const PointType &
  GetCentroid() const
  {
    return m_Centroid;
  }
  /** Where an analysis puts the tooth: the incisal edge of a front tooth, the middle of the crown of one behind it. */
  const PointType &
  GetReference() const
  {
    return m_Reference;
  }
  /** Along the axis, px. */
  double
  GetLength() const
  {
    return m_Length;
  }
  /** Unit vector from the root to the crown. */
  const PointType &
  GetAxis() const
  {
    return m_Axis;
  }

  // The crown's points, one an element.
  const std::vector<PointType> &
  GetPoints() const
  {
    return m_Points;
  }
  const std::vector<PointType> &
  GetNormals() const
  {
    return m_Normals;
  }
  /** Length of the line up to each point, px. */
  const std::vector<double> &
  GetArc() const
  {
    return m_Arc;
  }
  /** 1 on the palatal or lingual side of a front tooth, which other structures hide on a radiograph, rising from 0 at
   * the incisal edge. */
  const std::vector<double> &
  GetLingual() const
  {
    return m_Lingual;
  }

private:
  std::string            m_Failure;
  unsigned int           m_Position{ 0 };
  PointType              m_Centroid{};
  PointType              m_Reference{};
  PointType              m_Axis{};
  double                 m_Length{ 0.0 };
  std::vector<PointType> m_Points;
  std::vector<PointType> m_Normals;
  std::vector<double>    m_Arc;
  std::vector<double>    m_Lingual;
};
} // namespace itk

#endif

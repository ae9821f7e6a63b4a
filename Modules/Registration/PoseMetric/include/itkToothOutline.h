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
#ifndef itkToothOutline_h
#define itkToothOutline_h

#include "PoseMetricExport.h"

#include <array>
#include <string>
#include <vector>

namespace itk
{
/** \class ToothOutline
 * \brief What was drawn of one tooth, and the part of it that a scan can show: points at equal distances with outward
 * normals.
 *
 * Coordinates are those of the working plane (PoseModel::ToWorkingPlane()), px of 0.25 mm: v inferior, u anterior on a
 * lateral radiograph and toward the patient's left on a frontal one. What a drawing has to be is for the classes that
 * are made of one: WholeToothOutline, FrontalToothOutline.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT ToothOutline
{
public:
  using PointType = std::array<double, 2>;

  /** Distance of the points, px of 0.25 mm. */
  static constexpr double Spacing = 2.5;
  /** Why it cannot be used; empty where it can. */
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
  /** Where an analysis puts the tooth; what a template that stands in its place leaves where it is. */
  const PointType &
  GetReference() const
  {
    return m_Reference;
  }

  /** The crown's points, px of 0.25 mm, and their outward normals, one an element. */
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

protected:
  ToothOutline() = default;
  ToothOutline(const ToothOutline &) = default;
  ToothOutline(ToothOutline &&) = default;
  ToothOutline &
  operator=(const ToothOutline &) = default;
  ToothOutline &
  operator=(ToothOutline &&) = default;
  ~ToothOutline() = default;

  /** Points at equal distances on a line in the working plane; of a closed one at least as many as a chord's normal
   * needs. None where all points are one. */
  static std::vector<PointType>
  Resample(const std::vector<PointType> & drawn, bool closed);
  /** The normal (dv, -du) of the chord between a point's neighbours, over which a tracing's directions are taken: on
   * the right of the line's direction where v points down, hence outward where a closed line's area is positive. */
  static PointType
  ComputeNormal(const std::vector<PointType> & points, std::size_t i, bool closed);
  /** Appends a point of the crown's part. */
  void
  AddPoint(const PointType & point, const PointType & normal, double lingual);

  std::string            m_Failure;       /**< Why it cannot be used; empty where it can. */
  unsigned int           m_Position{ 0 }; /**< 1 central incisor .. 8 third molar. */
  PointType              m_Centroid{};    /**< Of all of the outline, px of 0.25 mm. */
  PointType              m_Reference{};   /**< Where an analysis puts the tooth, px of 0.25 mm. */
  std::vector<PointType> m_Points;        /**< The crown's part, px of 0.25 mm. */
  std::vector<PointType> m_Normals;       /**< Outward, of length 1; one a point. */
  std::vector<double>    m_Arc;           /**< Length of the line up to each point, px. */
  std::vector<double>    m_Lingual;       /**< 0 to 1, one a point: GetLingual(). */
};
} // namespace itk

#endif

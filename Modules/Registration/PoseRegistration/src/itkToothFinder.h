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
#ifndef itkToothFinder_h
#define itkToothFinder_h

#include "itkCephalometricLandmarkSet.h"
#include "itkDentalLandmarkSet.h"
#include "itkLandmarkCounterpartSet.h"
#include "itkPoseArch.h"
#include "itkToothCode.h"
#include "itkToothCrownSet.h"
#include "itkTriangleSurface.h"

#include "itkMesh.h"
#include "itkVersorRigid3DTransform.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** Finds teeth and their points on one jaw's scan: by landmarks of the scan, by labels, by their places along the arch.
 * The scan is brought into its dental frame and its arch is made when they are first needed. What
 * LandmarkCounterpartFilter and ToothCrownFilter share; private to this module. */
class ToothFinder
{
public:
  using JawEnum = ToothCode::JawEnum;
  using FeatureEnum = CephalometricLandmarkSet::FeatureEnum;
  using PointType = LandmarkCounterpartSet::PointType;
  using MeshType = Mesh<float, 3>;
  using LabelsType = std::vector<std::uint8_t>;
  using ScanLandmarksType = DentalLandmarkSet<3>;
  using FrameType = VersorRigid3DTransform<double>;

  /** Where a landmark is on the scan, and how far it may be from there. */
  struct PlaceType
  {
    PointType    point;
    double       sigmaAlong;
    double       sigmaAcross;
    const char * source;
  };

  /** Mesh, frame and landmarks may be null, labels empty; all must outlive this. */
  ToothFinder(const MeshType *          mesh,
              const FrameType *         frame,
              const LabelsType &        labels,
              const ScanLandmarksType * landmarks,
              double                    millimetresPerUnit,
              JawEnum                   jaw);

  /** Names of landmarks that are at another tooth's place, or nowhere: they are used for none, and their teeth are
   * there all the same. */
  void
  SetUnusableLandmarks(const std::vector<std::string> & names)
  {
    m_UnusableLandmarks = names;
  }

  /** A point of a tooth, mesh frame, mm. */
  std::optional<PlaceType>
  Find(const ToothCode & tooth, FeatureEnum feature);

  /** A tooth's crown, mesh frame, mm. */
  std::optional<ToothCrownSet::CrownType>
  FindCrown(const ToothCode & tooth);

private:
  std::optional<PointType>
  FindClicked(const ToothCode & tooth, FeatureEnum feature) const;
  /** Whether the scan passes by a point, mesh frame, mm: a landmark elsewhere is none of it, whatever its name is. */
  bool
  IsOnScan(const PointType & point) const;
  /** Whether those who named the scan's teeth did not find this one: labels of other teeth, or landmarks of both its
   * neighbours and none of its own. Whatever stands at its place along the arch is another tooth. */
  bool
  IsAbsent(const ToothCode & tooth) const;
  /** A point below a place, away from the occlusal side. */
  PointType
  Below(const PointType & point, double distance) const;
  std::optional<PlaceType>
  FindDerived(const ToothCode & tooth, FeatureEnum feature);
  void
  Prepare();
  double
  Height(std::size_t i) const;
  double
  Arc(const PointType & meshPoint) const;
  PointType
  ToMesh(std::size_t i) const;
  std::optional<PlaceType>
  FindLabelled(const ToothCode & tooth, FeatureEnum feature);
  std::optional<PlaceType>
  FindAlongArch(const ToothCode & tooth, FeatureEnum feature);
  /** The cusp or edge near a place along the arch: of the points that are the highest around themselves the nearest;
   * a buccal cusp is outside the arch's curve, a lingual one inside. */
  std::optional<PlaceType>
  FindPeak(const std::vector<std::size_t> & points,
           const std::vector<double> &      arcs,
           double                           target,
           FeatureEnum                      feature,
           double                           sigmaAlong,
           double                           sigmaAcross,
           const char *                     source) const;
  /** The marked triangles, mesh frame. */
  std::shared_ptr<const TriangleSurface>
  CutOut(const std::vector<std::uint8_t> & pointMarks) const;
  std::optional<ToothCrownSet::CrownType>
  CutAlongArch(const ToothCode & tooth);

  const MeshType *                 m_Mesh;
  const FrameType *                m_Frame;
  const LabelsType &               m_Labels;
  const ScanLandmarksType *        m_Landmarks;
  double                           m_MillimetresPerUnit;
  JawEnum                          m_Jaw;
  std::vector<std::string>         m_UnusableLandmarks;
  std::unique_ptr<TriangleSurface> m_Surface;
  PoseArch                         m_Arch;
};
} // namespace itk

#endif

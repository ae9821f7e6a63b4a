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
#include "itkTracedToothRow.h"
#include "itkTriangleSurface.h"

#include "itkMesh.h"
#include "itkVersorRigid3DTransform.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
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

  /** Where the teeth of a jaw were traced, and where a point of the mesh (mm) is on the same radiograph. */
  struct TracingType
  {
    TracedToothRow                                          row;
    std::function<std::array<double, 2>(const PointType &)> project;
    /** Whether its lines are the middle between both sides' images, whatever side their codes name. */
    bool bisected{ false };
  };
  /** A tracing of the jaw, beside a pose that was found: it says where a posterior tooth is that neither landmarks nor
   * labels name. */
  void
  SetTracing(TracingType tracing)
  {
    m_Tracing = std::move(tracing);
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
  /** By the tracing of the tooth; where the other side's tooth was traced alone, as far along the arch as that one. */
  std::optional<PlaceType>
  FindTraced(const ToothCode & tooth, FeatureEnum feature);
  /** On the traced line of the tooth itself. */
  std::optional<PlaceType>
  FindOnLine(const ToothCode & tooth, FeatureEnum feature) const;
  /** As far along the arch as the other side's tooth is, which was traced. */
  std::optional<PlaceType>
  FindBesideFellow(const ToothCode & tooth, FeatureEnum feature) const;
  /** Of a line in the middle between both sides: the two points that stand equally far along the arch and have their
   * middle there; that of this tooth. */
  std::optional<PlaceType>
  FindOnBisectedLine(const ToothCode & tooth, FeatureEnum feature) const;
  /** Where a point of the surface is along the traced row, pixels. */
  double
  ToRow(std::size_t i) const;
  /** The points of a tooth's side of the mouth whose place, by a function of the index, lies between two. */
  template <typename TFunction>
  std::vector<std::size_t>
  CollectPoints(const ToothCode & tooth, double low, double high, const TFunction & placeOf) const;
  /** Of these the points no further from the arch's curve than crowns are wide. */
  template <typename TFunction>
  std::vector<std::size_t>
  CollectRowPoints(const ToothCode & tooth, double low, double high, const TFunction & placeOf) const;
  /** What is looked for among the cusps of a row of teeth. */
  struct RowPatternType
  {
    /** Where the point of the tooth is expected, mm along the row, and standard deviation of all places together. */
    double target{ 0.0 };
    double sigma{ 1.0 };
    /** Where cusps are expected, that of the tooth among them. */
    std::vector<double> cusps;
    /** Pixels of a traced row, 1 mm each along the arch. */
    double pixelsPerMillimetre{ 1.0 };

    /** How badly places match the cusps where all of them are moved by so much, in squared standard deviations. */
    double
    Match(const std::vector<double> & places, double shift) const;
  };
  /** The pattern of the traced lines of a tooth and its neighbours; none where it has no line. */
  std::optional<RowPatternType>
  MakeLinePattern(const ToothCode & tooth, FeatureEnum feature) const;
  /** The traced line of a tooth, or of a bisected tracing that of its position. */
  std::optional<TracedToothRow::SpanType>
  FindLine(const ToothCode & tooth) const;
  /** The cusp that is where a pattern has it, moved along the row as a whole: of points and their places by a function
   * of the index, mm. Where two cusps will do nearly as well the error says so; where there is none (worn, turned), the
   * highest point at the place itself is taken. */
  template <typename TFunction>
  std::optional<PlaceType>
  FindByPattern(const std::vector<std::size_t> & points,
                const RowPatternType &           pattern,
                FeatureEnum                      feature,
                const TFunction &                placeOf,
                double                           sigmaAlong,
                const char *                     source) const;
  std::optional<PlaceType>
  FindAlongArch(const ToothCode & tooth, FeatureEnum feature);
  /** Edges and cusps: the points that are the highest around themselves, the highest first; a buccal cusp is outside
   * the arch's curve, a lingual one inside. Of an incisor's edge the highest alone is meant. */
  std::vector<std::size_t>
  CollectPeaks(const std::vector<std::size_t> & points, FeatureEnum feature) const;
  /** The cusp or edge near a place along the arch: of the peaks the nearest. */
  std::optional<PlaceType>
  FindPeak(const std::vector<std::size_t> & points,
           double                           target,
           FeatureEnum                      feature,
           double                           sigmaAlong,
           double                           sigmaAcross,
           const char *                     source) const;
  /** How far along the arch a point of the surface is from the midline, mm, on either side. */
  double
  ArcOf(std::size_t i) const;
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
  std::optional<TracingType>       m_Tracing;
  std::unique_ptr<TriangleSurface> m_Surface;
  PoseArch                         m_Arch;
};
} // namespace itk

#endif

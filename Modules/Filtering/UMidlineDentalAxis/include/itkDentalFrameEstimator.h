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
#ifndef itkDentalFrameEstimator_h
#define itkDentalFrameEstimator_h

#include "UMidlineDentalAxisExport.h"
#include "itkMidsagittalPlaneEstimator.h"
#include "itkToothCode.h"
#include "itkTriangleSurface.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>

namespace itk
{
/** \class DentalFrameEnums
 * \brief Choices of the frame estimation, free of ITK headers.
 * \ingroup UMidlineDentalAxis
 */
class UMidlineDentalAxis_EXPORT DentalFrameEnums
{
public:
  /** Whether upper and lower mesh share one coordinate frame in occlusion: taken as said, or tested by contact. */
  enum class JawsShareFrame : std::uint8_t
  {
    Off,
    On,
    Check
  };

  /** What the occlusion test found. Both jaws must look at each other, one arch must lie over the other within a few
   * mm, and neither may lie inside the other. */
  enum class OcclusionFinding : std::uint8_t
  {
    /** There are no two jaws with a frame. */
    NotTested,
    /** All that two jaws in one frame show was seen. */
    InOcclusion,
    /** The occlusal sides do not face each other. */
    NotOpposed,
    /** The crowns are farther from the other jaw than any open bite or spacer. */
    FarApart,
    /** The upper jaw is not above the lower, or the crowns overlap by more than any overbite. */
    NotOverEachOther,
    /** Seen along the vertical, one arch lies beside the other. */
    ArchesBesideEachOther,
    /** The jaws lie inside each other. */
    Interpenetrating
  };
};

/** \struct DentalFrameOptions
 * \brief Parameters of EstimateDentalFrame().
 * \ingroup UMidlineDentalAxis
 */
struct UMidlineDentalAxis_EXPORT DentalFrameOptions
{
  DentalFrameEnums::JawsShareFrame jawsShareFrame{ DentalFrameEnums::JawsShareFrame::Check }; /**< Whether they do. */
  /** The paper's p: share of the surface, best aligned with the occlusal direction, that are crown candidates. */
  double crownFraction{ 0.15 };
  /** Crown candidates lie within this distance (mm) below the local occlusal envelope. */
  double crownBandHeight{ 3.0 };
  /** The mirror plane is found on what lies within this distance (mm) below the envelope: whole crowns. */
  double mirrorBandHeight{ 6.0 };
  /** Rounds of crown candidates -> PCA -> occlusal direction. */
  unsigned int maximumIterations{ 20 };
  /** Surface samples a jaw (systematic by area in the order of the triangles). */
  unsigned int samples{ 5000 };
  /** Replace the U-shape's lateral axis by the mirror plane's normal and move the origins onto the plane. */
  bool                    refineMidline{ false };
  MidsagittalPlaneOptions midline;
  /** Jaws are worked on at the same time on up to this many threads (0: all); no bit of the result depends on it. */
  unsigned int threads{ 1 };
  /** Polled between steps, from one thread at a time; true ends the estimation with an invalid result. */
  std::function<bool()> abort;
};

/** \struct DentalJawFrame
 * \brief One jaw's frame and what it was built from. Points and directions are in the mesh's own frame, mm.
 * \ingroup UMidlineDentalAxis
 */
struct UMidlineDentalAxis_EXPORT DentalJawFrame
{
  using VectorType = std::array<double, 3>;

  /** Openness up to which a scan counts as a closed body, whose winding says nothing. */
  static constexpr double OpennessOfClosedCast = 0.2;
  /** Whether a frame was found; where not, nothing of the rest is to be read. */
  bool valid{ false };
  /** Rows x anterior, y patient's left, z superior: q = axes (p - origin). Right-handed. */
  std::array<VectorType, 3> axes{ { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, { { 0.0, 0.0, 1.0 } } } };
  /** Area-weighted centroid; with refineMidline its foot on the mirror plane. */
  VectorType origin{ { 0.0, 0.0, 0.0 } };
  VectorType centroid{ { 0.0, 0.0, 0.0 } };
  /** Molar baseline: its ends on the patient's right and left, and their midpoint. */
  VectorType baselineRight{ { 0.0, 0.0, 0.0 } };
  VectorType baselineLeft{ { 0.0, 0.0, 0.0 } };
  VectorType midpoint{ { 0.0, 0.0, 0.0 } };
  VectorType incisalEdge{ { 0.0, 0.0, 0.0 } };
  /** Length of the baseline, and from its midpoint to the incisal edge along x. */
  double archWidth{ 0.0 };
  double archDepth{ 0.0 };
  /** Across the arch between the buccal cusps at the first molars, 25 to 33 mm behind the incisal edge; mm. 0 where
   * there are no crowns on one side. Unlike archWidth it does not depend on where the scan's crowns end. */
  double molarWidth{ 0.0 };
  /** [0, 1]; Documentation/UMDA.md says what it is made of. Below 0.5 a person should look. */
  double confidence{ 0.0 };
  /** The factors of the confidence: vertical sign, flatness of the crowns, U-shape, symmetry. */
  double signConfidence{ 0.0 };
  double planeConfidence{ 0.0 };
  double archConfidence{ 0.0 };
  double symmetryConfidence{ 0.0 };
  /** |sum of area normals| / area: 0 for a closed cast, 0.3 to 0.6 for an open shell. */
  double openness{ 0.0 };
  /** Cosine between net area normal and occlusal direction, 0 for a closed body; clearly negative: inward winding (only
   * seen where both jaws are in occlusion). */
  double windingAgreement{ 0.0 };
  /** y of the mirror plane (or of the U's axis) in the jaw's frame about the centroid, mm. */
  double midlineOffset{ 0.0 };
};

/** \struct DentalFrameResult
 * \brief What EstimateDentalFrame() returns.
 * \ingroup UMidlineDentalAxis
 */
struct UMidlineDentalAxis_EXPORT DentalFrameResult
{
  DentalJawFrame upper; /**< Not valid where there is no upper scan. */
  DentalJawFrame lower; /**< Not valid where there is no lower scan. */
  /** Upper or lower. Throws std::invalid_argument of an unknown jaw, which has no frame. */
  const DentalJawFrame &
  GetJaw(ToothCode::JawEnum jaw) const;
  /** Whether the jaws were treated as in one frame. */
  bool jawsShareFrame{ false };
  /** Of the occlusion test, made whenever both jaws are there: its outcome and what it saw. */
  bool                               occlusionPlausible{ false };
  DentalFrameEnums::OcclusionFinding occlusionFinding{ DentalFrameEnums::OcclusionFinding::NotTested };
  /** 12th percentile of the distances between samples of one jaw and the other jaw, mm: the closeness of contact. */
  double contactDistance{ 0.0 };
  /** Lower to upper centroid along z, mm. */
  double verticalSeparation{ 0.0 };
  /** 12th percentile of the distances between the crowns of one jaw and the other jaw, mm. */
  double crownDistance{ 0.0 };
  /** Upper above lower crown plane along z, and between the U's centres across it; mm. */
  double crownPlaneGap{ 0.0 };
  double archCentreDistance{ 0.0 };
  /** Median distance between the two rings of crowns, seen along z; mm. */
  double archDistance{ 0.0 };
  /** Share of the samples near the other jaw that lie more than 1 mm inside it. */
  double interpenetration{ 0.0 };
  /** Between the jaws' own estimates of z, and of x; degrees. */
  double verticalDisagreement{ 0.0 };
  double anteriorDisagreement{ 0.0 };
  /** Upper incisal edge before, and below, the lower one; mm along x and z. Meaningful where jawsShareFrame. */
  double overjet{ 0.0 };
  double overbite{ 0.0 };
  /** One frame for both jaws, where jawsShareFrame: shared y, z between the jaws' own, origin the centroid of both
   * (with refineMidline its foot on the mirror plane). With one jaw: that jaw's frame. */
  DentalJawFrame joint;
  /** With refineMidline: the mirror plane in the mesh's frame (one for both jaws in `upper` where they share it). */
  MidsagittalPlaneResult midsagittalUpper;
  MidsagittalPlaneResult midsagittalLower;
};

/** The U-midline dental axis frame of one or two jaws (paper, section "U-Midline Dental Axis Construction"; decisions
 * in Documentation/UMDA.md). Either pointer may be null. Surfaces in mm with outward winding, any orientation. Repeated
 * points are welded, specks are ignored. The result does not depend on the number of threads, and on the orientation of
 * the input only by rounding.
 *
 * A jaw without a usable surface comes back with valid == false; nothing is thrown. */
UMidlineDentalAxis_EXPORT DentalFrameResult
EstimateDentalFrame(const TriangleSurface * upper, const TriangleSurface * lower, const DentalFrameOptions & options);

/** What the occlusion test found, as a sentence for a person, with the figures that decided. */
UMidlineDentalAxis_EXPORT std::string
                          DescribeOcclusion(const DentalFrameResult & result);
} // namespace itk

#endif

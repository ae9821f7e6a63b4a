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
#ifndef itkPoseSilhouetteKernel_h
#define itkPoseSilhouetteKernel_h

#include "PoseMetricExport.h"
#include "itkPoseArch.h"
#include "itkPoseContourModel.h"
#include "itkPoseFitStatistics.h"
#include "itkDentalContour.h"
#include "itkPoseReverseDirection.h"
#include "itkPoseToothPlaces.h"
#include "itkPoseTracing.h"
#include "itkTracedSide.h"
#include "itkTriangleSurface.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace itk
{
/** \struct PoseSilhouetteSettings
 * \brief What the residuals of a scan's silhouette against a tracing depend on; lengths in px of 0.25 mm.
 * \ingroup PoseMetric
 */
struct PoseSilhouetteSettings
{
  /** Of a frontal radiograph the side that was traced and the cut at the midline do not matter: all of the jaw's outer
   * outline is compared with. */
  PoseGeometry       geometry;
  ToothCode::JawEnum jaw{ ToothCode::JawEnum::Upper };
  TracedSideEnum     tracedSide{ TracedSideEnum::Right };
  /** Cut at the midline plane, or take the whole mesh's outline. */
  bool useSideSelection{ true };
  /** Triangles of the right side: y < midlineMargin mm. Half a millimetre short of the plane, since the other side's
   * incisor often stands in front there (1-2 px of outline that was never traced). */
  double midlineMargin{ -0.5 };
  /** Keep only the occlusal and anterior part of the outline. */
  bool useFacingFilter{ true };
  /** Match position and normal, or position only. Weight of a unit normal, px. */
  bool   useOrientation{ true };
  double orientationWeight{ 8.0 };
  /** FDI numbers of teeth to leave out. */
  std::vector<std::uint8_t> excludedTeeth;
  /** Points a jaw above which a tracing is thinned. */
  unsigned int maximumTracingPoints{ 200 };
  /** Match coded points with the same tooth or one up to toothRange positions away. A scan's teeth are told by their
   * place along the arch. */
  bool         gateByTooth{ false };
  unsigned int toothRange{ 1 };
  /** What the reverse direction, from the moving contour to the tracing, counts beside the forward one; 0: nothing. */
  double reverseWeight{ 0.0 };
  /** It fades in over this length from an end of the tracing. */
  double taperLength{ 6.0 };
  /** Polylines of a tracing with a shorter gap between them are one. */
  double gapLength{ 8.0 };
};

/** \class PoseSilhouetteKernel
 * \brief Residuals of a tracing against the moving contour of one jaw, on flat arrays: the engine of
 * SilhouettePoseMetricv4. Free of ITK headers.
 *
 * What moves is a PoseContourModel: the outline of a scan, or an outline that was drawn once.
 *
 * Residual of tracing point x with the oriented nearest contour point q and its normal n: r = n.(x - q(theta)). The
 * silhouette moves along its normal as its surface points do, so that -n.dq/dtheta of the matched surface point is the
 * derivative also where the contour is made anew. Documentation/Robust.md has the formulas.
 *
 * A tracing of both sides has a strand a side; points without a code of theirs may lie on either contour. Const methods
 * may be called from several threads; metrics that are clones of each other share one kernel.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PoseSilhouetteKernel
{
public:
  /** Width of the Geman-McClure kernel that fits are judged with, px. */
  static constexpr double FitWidth = 4.0;

  /** A strand of tracing and the contour models that it may lie on. */
  struct Strand
  {
    PoseTracing                           tracing; /**< What was drawn. */
    PoseToothPlaces                       places;  /**< Where along the arch its teeth are to be expected. */
    std::vector<const PoseContourModel *> models;  /**< The jaw's contours that may explain it; not owned. */
    /** Counts nothing unless it is asked for. */
    PoseReverseDirection reverse;
  };

  /** Residuals of one strand, their derivatives and what weights are made of. */
  struct Linearization
  {
    std::vector<double> residual; /**< One a point of the strand, along the normal, px. */
    /** Squared distance that the robust kernel sees: of the residual and, past the end of the contour, of the distance
     * along it. */
    std::vector<double> squaredDistance;
    /** Normal of the matched contour sample. */
    std::vector<double> nu;
    std::vector<double> nv;
    /** d residual / d theta, 7 a point; empty where not asked for. */
    std::vector<double> jacobian;
    /** d squaredDistance / d theta, 7 a point. */
    std::vector<double> distanceJacobian;
    /** 1 where contour and tracing face the same way, 0 where they do not. */
    std::vector<double> facing;
    /** Index of the matched sample in the strand's contour; NoMatch where there is none. */
    std::vector<std::size_t> match;
  };
  static constexpr std::size_t NoMatch = std::numeric_limits<std::size_t>::max(); /**< No sample is near. */

  /** \param surface  all triangles of the jaw, dental frame, mm. Not kept.
   *  \param polylines  the tracing, continuous pixel indices. */
  PoseSilhouetteKernel(const TriangleSurface &              surface,
                       const DentalContour::PolylinesType & polylines,
                       const PoseSilhouetteSettings &       settings);
  /** The moving contour is an outline as it is seen at a pose (PosePlanarContourModel), continuous pixel indices. Which
   * side was traced, and the cut at the midline, do not matter. */
  PoseSilhouetteKernel(const DentalContour::PolylinesType & outline,
                       const PoseParameters &               pose,
                       const DentalContour::PolylinesType & polylines,
                       const PoseSilhouetteSettings &       settings);
  ~PoseSilhouetteKernel();
  PoseSilhouetteKernel(const PoseSilhouetteKernel &) = delete;
  PoseSilhouetteKernel &
  operator=(const PoseSilhouetteKernel &) = delete;

  /** Why nothing can be matched; empty where something can. */
  const std::string &
  GetFailure() const
  {
    return m_Failure;
  }
  /** What it was made with. */
  const PoseSilhouetteSettings &
  GetSettings() const
  {
    return m_Settings;
  }
  const std::vector<Strand> &
  GetStrands() const
  {
    return m_Strands;
  }

  /** The moving contour of each strand. */
  std::vector<PoseContour>
  ComputeContours(const PoseParameters & parameters) const;

  /** Contours made at one pose, moved to another as the points of the scan are. */
  std::vector<PoseContour>
  MoveContours(const std::vector<PoseContour> & contours, const PoseParameters & from, const PoseParameters & to) const;

  /** Matches a strand with its contour. */
  Linearization
  Linearize(std::size_t            strand,
            const PoseParameters & parameters,
            const PoseContour &    contour,
            bool                   withJacobian) const;

  /** The same with the matches, normals and facing of a linearisation made before. */
  Linearization
  LinearizeHeld(std::size_t            strand,
                const PoseParameters & parameters,
                const PoseContour &    contour,
                const Linearization &  held,
                bool                   withJacobian) const;

  /** From the contour to the tracing of a strand; with the matches of `held` where it is given. */
  PoseReverseDirection::Linearization
  LinearizeReverse(std::size_t                                 strand,
                   const PoseParameters &                      parameters,
                   const PoseContour &                         contour,
                   const PoseReverseDirection::Linearization * held = nullptr) const;

  /** How well a strand is explained, with a kernel width of 4 px. */
  PoseFitStatistics
  ComputeStatistics(std::size_t strand, const PoseContour & contour) const;

  /** Share of a strand's contour that has a tracing point within 4 px. */
  double
  ComputeOverlap(std::size_t strand, const PoseContour & contour) const;

  /** Adds the squared distances that samples of contours move by between two poses, px^2, and their number. */
  void
  AddSquaredMotion(const std::vector<PoseContour> & contours,
                   const PoseParameters &           from,
                   const PoseParameters &           to,
                   double &                         sum,
                   double &                         count) const;

private:
  /** The polylines that are used; empty, with the failure set, where they are too few. */
  DentalContour::PolylinesType
  SelectPolylines(const DentalContour::PolylinesType & polylines);
  void
  AddStrand(const DentalContour::PolylinesType & polylines, std::vector<const PoseContourModel *> models);
  void
  Fill(const PoseModel &   model,
       const PoseContour & contour,
       std::size_t         strand,
       std::size_t         point,
       std::size_t         sample,
       Linearization &     lin,
       bool                withJacobian) const;

  PoseSilhouetteSettings                         m_Settings;
  std::string                                    m_Failure;
  PoseArch                                       m_Arch;
  std::vector<std::unique_ptr<PoseContourModel>> m_Models;
  std::vector<Strand>                            m_Strands;
};
} // namespace itk

#endif

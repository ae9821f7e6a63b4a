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
#include "itkPoseSilhouetteKernel.h"

#include "itkGemanMcClureKernel.h"
#include "itkKeepTriangles.h"
#include "itkMidlineSide.h"
#include "itkPoseContourIndex.h"
#include "itkPoseMatching.h"
#include "itkPoseMeshContourModel.h"
#include "itkPosePlanarContourModel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace itk
{
using namespace PoseMatching;

namespace
{
std::size_t
CountDifferentPoints(const DentalContour::PolylinesType & polylines)
{
  std::set<std::array<double, 2>> points;
  for (const DentalContour::PolylineType & polyline : polylines)
  {
    for (const auto & point : polyline.points)
    {
      points.insert({ { point[0], point[1] } });
    }
  }
  return points.size();
}

/** Appends a contour's samples to another's. */
void
Append(PoseContour & all, PoseContour && more)
{
  if (all.Size() == 0)
  {
    all = std::move(more);
    return;
  }
  for (const std::size_t run : more.runs)
  {
    all.runs.push_back(run + all.u.size());
  }
  all.u.insert(all.u.end(), more.u.begin(), more.u.end());
  all.v.insert(all.v.end(), more.v.begin(), more.v.end());
  all.nu.insert(all.nu.end(), more.nu.begin(), more.nu.end());
  all.nv.insert(all.nv.end(), more.nv.begin(), more.nv.end());
  all.rim.insert(all.rim.end(), more.rim.begin(), more.rim.end());
  all.rimOther.insert(all.rimOther.end(), more.rimOther.begin(), more.rimOther.end());
  all.position.insert(all.position.end(), more.position.begin(), more.position.end());
}

} // namespace

PoseSilhouetteKernel::~PoseSilhouetteKernel() = default;

DentalContour::PolylinesType
PoseSilhouetteKernel::SelectPolylines(const DentalContour::PolylinesType & polylines)
{
  DentalContour::PolylinesType selected;
  for (const DentalContour::PolylineType & polyline : polylines)
  {
    const auto & excluded = m_Settings.excludedTeeth;
    if (!polyline.code.IsKnown() ||
        std::find(excluded.begin(), excluded.end(), polyline.code.GetFDI()) == excluded.end())
    {
      selected.push_back(polyline);
    }
  }
  const std::size_t points = CountDifferentPoints(selected);
  if (points < 5)
  {
    m_Failure = "the tracing has " + std::to_string(points) + " different points, at least 5 are needed";
    selected.clear();
  }
  return selected;
}

PoseSilhouetteKernel::PoseSilhouetteKernel(const TriangleSurface &              surface,
                                           const DentalContour::PolylinesType & polylines,
                                           const PoseSilhouetteSettings &       settings)
  : m_Settings(settings)
{
  if (surface.triangles.empty())
  {
    m_Failure = "there is no surface";
    return;
  }
  if (settings.tracedSide == TracedSideEnum::Standard)
  {
    m_Failure =
      "a standard tracing, of whole teeth, is none of the crowns' outline; ToothOutlinePoseMetricv4 registers with it";
    return;
  }
  const DentalContour::PolylinesType selected = this->SelectPolylines(polylines);
  if (selected.empty())
  {
    return;
  }
  m_Arch = PoseArch(surface, settings.jaw);
  const auto side = [&](double sign) {
    return settings.useSideSelection
             ? KeepTriangles(
                 surface,
                 SelectMidlineSide(surface, { { 0.0, 1.0, 0.0 } }, { { 0.0, 0.0, 0.0 } }, sign, settings.midlineMargin))
             : surface;
  };
  const bool filter = settings.useFacingFilter;
  if (settings.geometry.direction == CephalometricDirectionEnum::Frontal)
  {
    // From the front both sides are seen beside each other: one outline of all of the jaw, and a strand a side.
    m_Models.push_back(std::make_unique<PoseMeshContourModel>(surface, settings.jaw, filter));
    DentalContour::PolylinesType right, left, unknown;
    for (const DentalContour::PolylineType & polyline : selected)
    {
      (!polyline.code.IsKnown() ? unknown : polyline.code.IsLeft() ? left : right).push_back(polyline);
    }
    for (const DentalContour::PolylinesType & strand : { right, left, unknown })
    {
      this->AddStrand(strand, { m_Models.back().get() });
    }
    if (m_Strands.empty())
    {
      m_Failure = "no part of the tracing can lie on the occlusal or lateral outline";
    }
    return;
  }
  const auto addModel = [&](double sign) {
    m_Models.push_back(std::make_unique<PoseMeshContourModel>(side(sign), settings.jaw, filter));
    return m_Models.back().get();
  };
  switch (settings.tracedSide)
  {
    case TracedSideEnum::Mean:
      m_Models.push_back(std::make_unique<PoseMeshContourModel>(side(1.0), side(-1.0), settings.jaw, filter));
      this->AddStrand(selected, { m_Models.back().get() });
      break;
    case TracedSideEnum::Both: {
      DentalContour::PolylinesType right, left, unknown;
      for (const DentalContour::PolylineType & polyline : selected)
      {
        (!polyline.code.IsKnown() ? unknown : polyline.code.IsLeft() ? left : right).push_back(polyline);
      }
      const PoseContourModel * rightModel = addModel(1.0);
      const PoseContourModel * leftModel = addModel(-1.0);
      this->AddStrand(right, { rightModel });
      this->AddStrand(left, { leftModel });
      this->AddStrand(unknown, { rightModel, leftModel });
      break;
    }
    default:
      this->AddStrand(selected, { addModel(settings.tracedSide == TracedSideEnum::Right ? 1.0 : -1.0) });
  }
  if (m_Strands.empty())
  {
    m_Failure = "no part of the tracing can lie on the occlusal or anterior outline";
  }
}

PoseSilhouetteKernel::PoseSilhouetteKernel(const DentalContour::PolylinesType & outline,
                                           const PoseParameters &               pose,
                                           const DentalContour::PolylinesType & polylines,
                                           const PoseSilhouetteSettings &       settings)
  : m_Settings(settings)
{
  if (CountDifferentPoints(outline) < 2)
  {
    m_Failure = "the moving contour has fewer than 2 different points";
    return;
  }
  const DentalContour::PolylinesType selected = this->SelectPolylines(polylines);
  if (selected.empty())
  {
    return;
  }
  m_Models.push_back(
    std::make_unique<PosePlanarContourModel>(settings.geometry, outline, pose, settings.jaw, settings.useFacingFilter));
  this->AddStrand(selected, { m_Models.back().get() });
  if (m_Strands.empty())
  {
    m_Failure = "no part of the tracing can lie on the occlusal or anterior outline";
  }
}

void
PoseSilhouetteKernel::AddStrand(const DentalContour::PolylinesType &  polylines,
                                std::vector<const PoseContourModel *> models)
{
  Strand strand;
  strand.tracing = PoseTracing(m_Settings.geometry, polylines, m_Settings.jaw, m_Settings.maximumTracingPoints);
  strand.places = PoseToothPlaces(strand.tracing);
  strand.models = std::move(models);
  if (strand.tracing.Size() > 0)
  {
    if (m_Settings.reverseWeight > 0.0)
    {
      PoseReverseDirection::Settings reverse;
      reverse.weight = m_Settings.reverseWeight;
      reverse.taperLength = m_Settings.taperLength;
      reverse.gapLength = m_Settings.gapLength;
      reverse.orientationWeight = m_Settings.useOrientation ? m_Settings.orientationWeight : 0.0;
      reverse.gateByTooth = m_Settings.gateByTooth;
      reverse.toothRange = m_Settings.toothRange;
      strand.reverse = PoseReverseDirection(strand.tracing, reverse);
    }
    m_Strands.push_back(std::move(strand));
  }
}

std::vector<PoseContour>
PoseSilhouetteKernel::ComputeContours(const PoseParameters & parameters) const
{
  const PoseModel          model(m_Settings.geometry, parameters);
  std::vector<PoseContour> contours(m_Strands.size());
  for (std::size_t s = 0; s < m_Strands.size(); ++s)
  {
    for (const PoseContourModel * contourModel : m_Strands[s].models)
    {
      Append(contours[s], contourModel->Compute(model));
    }
    if (m_Settings.gateByTooth && contours[s].position.empty() && m_Arch.IsValid())
    {
      for (const auto & rim : contours[s].rim)
      {
        contours[s].position.push_back(PoseArch::ExpectedPosition(m_Arch.Arc(rim[0], rim[1]), m_Settings.jaw));
      }
    }
  }
  return contours;
}

std::vector<PoseContour>
PoseSilhouetteKernel::MoveContours(const std::vector<PoseContour> & contours,
                                   const PoseParameters &           from,
                                   const PoseParameters &           to) const
{
  std::vector<PoseContour> moved = contours;
  const PoseModel          fromModel(m_Settings.geometry, from);
  const PoseModel          toModel(m_Settings.geometry, to);
  for (PoseContour & contour : moved)
  {
    PoseContourModel::Reproject(contour, fromModel, toModel);
  }
  return moved;
}

void
PoseSilhouetteKernel::Fill(const PoseModel &   model,
                           const PoseContour & contour,
                           std::size_t         s,
                           std::size_t         i,
                           std::size_t         j,
                           Linearization &     lin,
                           bool                withJacobian) const
{
  const PoseTracing & tracing = m_Strands[s].tracing;
  const double        nu = lin.nu[i];
  const double        nv = lin.nv[i];
  const double        du = tracing.u[i] - contour.u[j];
  const double        dv = tracing.v[i] - contour.v[j];
  const double        r = nu * du + nv * dv;
  const double        t = nu * dv - nv * du;
  const double        beyond = BeyondEnd(t);
  lin.residual[i] = r;
  lin.squaredDistance[i] = r * r + beyond * beyond;
  if (!withJacobian)
  {
    return;
  }
  double jacobian[14];
  ComputeSampleJacobian(model, contour, j, jacobian);
  const double along = 2.0 * std::copysign(beyond, t);
  for (int a = 0; a < 7; ++a)
  {
    lin.jacobian[7 * i + a] = -(nu * jacobian[a] + nv * jacobian[7 + a]);
    lin.distanceJacobian[7 * i + a] =
      2.0 * r * lin.jacobian[7 * i + a] + along * (nv * jacobian[a] - nu * jacobian[7 + a]);
  }
}

PoseSilhouetteKernel::Linearization
PoseSilhouetteKernel::Linearize(std::size_t            s,
                                const PoseParameters & parameters,
                                const PoseContour &    contour,
                                bool                   withJacobian) const
{
  const PoseModel     model(m_Settings.geometry, parameters);
  const PoseTracing & tracing = m_Strands[s].tracing;
  const std::size_t   n = tracing.Size();
  Linearization       lin;
  lin.residual.resize(n);
  lin.squaredDistance.resize(n);
  lin.nu.resize(n);
  lin.nv.resize(n);
  lin.facing.resize(n);
  lin.match.assign(n, NoMatch);
  lin.jacobian.assign(withJacobian ? 7 * n : 0, 0.0);
  lin.distanceJacobian.assign(withJacobian ? 7 * n : 0, 0.0);
  const double normalWeight2 =
    m_Settings.useOrientation ? m_Settings.orientationWeight * m_Settings.orientationWeight : 0.0;
  const PoseContourIndex index(contour);
  for (std::size_t i = 0; i < n; ++i)
  {
    std::size_t j = PoseContourIndex::None;
    if (!index.Empty())
    {
      j = m_Settings.gateByTooth
            ? index.NearestAllowed(tracing.u[i],
                                   tracing.v[i],
                                   tracing.nu[i],
                                   tracing.nv[i],
                                   normalWeight2,
                                   GetAllowedPositions(tracing.tooth[i], m_Settings.toothRange))
            : index.Nearest(tracing.u[i], tracing.v[i], tracing.nu[i], tracing.nv[i], normalWeight2);
    }
    if (j == PoseContourIndex::None)
    {
      // Nothing to match: a residual that no pose can change, without weight.
      lin.residual[i] = 1e3;
      lin.squaredDistance[i] = 1e6;
      lin.nv[i] = 1.0;
      lin.facing[i] = 0.0;
      continue;
    }
    lin.match[i] = j;
    lin.nu[i] = contour.nu[j];
    lin.nv[i] = contour.nv[j];
    const auto & direction = index.GetDirection(j);
    lin.facing[i] =
      m_Settings.useOrientation ? FacingWeight(direction[0] * tracing.nu[i] + direction[1] * tracing.nv[i]) : 1.0;
    this->Fill(model, contour, s, i, j, lin, withJacobian);
  }
  return lin;
}

PoseSilhouetteKernel::Linearization
PoseSilhouetteKernel::LinearizeHeld(std::size_t            s,
                                    const PoseParameters & parameters,
                                    const PoseContour &    contour,
                                    const Linearization &  held,
                                    bool                   withJacobian) const
{
  const PoseModel   model(m_Settings.geometry, parameters);
  const std::size_t n = m_Strands[s].tracing.Size();
  Linearization     lin = held;
  lin.jacobian.assign(withJacobian ? 7 * n : 0, 0.0);
  lin.distanceJacobian.assign(withJacobian ? 7 * n : 0, 0.0);
  for (std::size_t i = 0; i < n; ++i)
  {
    if (held.match[i] != NoMatch)
    {
      this->Fill(model, contour, s, i, held.match[i], lin, withJacobian);
    }
  }
  return lin;
}

PoseReverseDirection::Linearization
PoseSilhouetteKernel::LinearizeReverse(std::size_t                                 s,
                                       const PoseParameters &                      parameters,
                                       const PoseContour &                         contour,
                                       const PoseReverseDirection::Linearization * held) const
{
  const Strand & strand = m_Strands[s];
  return strand.reverse.Linearize(strand.tracing, PoseModel(m_Settings.geometry, parameters), contour, held);
}

PoseFitStatistics
PoseSilhouetteKernel::ComputeStatistics(std::size_t s, const PoseContour & contour) const
{
  const PoseTracing & tracing = m_Strands[s].tracing;
  PoseFitStatistics   fit;
  fit.numberOfPoints = tracing.Size();
  fit.tracingLength = tracing.length;
  fit.contourLength = PoseContourModel::Spacing * static_cast<double>(contour.Size());
  if (contour.Size() == 0 || tracing.Size() == 0)
  {
    fit.inlierShare = 0.0;
    return fit;
  }
  const PoseParameters  anywhere{ {} };
  const Linearization   lin = this->Linearize(s, anywhere, contour, false);
  std::vector<double>   distances;
  double                weights = 0.0, cost = 0.0, squares = 0.0, inliers = 0.0;
  std::array<double, 9> arcSum{}, arcCount{}, arcExpected{};
  for (std::size_t i = 0; i < tracing.Size(); ++i)
  {
    const double d = std::sqrt(lin.squaredDistance[i]);
    const double w = lin.facing[i] * GemanMcClureKernel::Weight(lin.squaredDistance[i], FitWidth);
    weights += tracing.weight[i];
    cost += tracing.weight[i] * (1.0 - std::sqrt(w));
    inliers += lin.facing[i] > 0.5 && d < FitWidth ? tracing.weight[i] : 0.0;
    squares += lin.squaredDistance[i];
    distances.push_back(d);
    const unsigned int position = tracing.tooth[i] % 10;
    const double       expected = m_Strands[s].places.GetArc(position);
    if (expected > 0.0 && m_Arch.IsValid() && lin.match[i] != NoMatch)
    {
      const auto & rim = contour.rim[lin.match[i]];
      arcSum[position] += std::abs(m_Arch.Arc(rim[0], rim[1]));
      arcCount[position] += 1.0;
      arcExpected[position] = expected;
    }
  }
  double teeth = 0.0;
  for (int k = 1; k < 9; ++k)
  {
    if (arcCount[k] > 0.0)
    {
      fit.codeOffset += arcSum[k] / arcCount[k] - arcExpected[k];
      teeth += 1.0;
    }
  }
  if (teeth > 0.0)
  {
    fit.codeOffset /= teeth;
    fit.hasCodes = true;
  }
  fit.cost = weights > 0.0 ? cost / weights : 1.0;
  fit.inlierShare = weights > 0.0 ? inliers / weights : 0.0;
  fit.rmsResidual = std::sqrt(squares / static_cast<double>(distances.size()));
  std::sort(distances.begin(), distances.end());
  const auto quantile = [&](double q) {
    const double      x = q * static_cast<double>(distances.size() - 1);
    const std::size_t k = static_cast<std::size_t>(x);
    const std::size_t l = std::min(k + 1, distances.size() - 1);
    return distances[k] + (x - static_cast<double>(k)) * (distances[l] - distances[k]);
  };
  fit.medianResidual = quantile(0.5);
  fit.p90Residual = quantile(0.9);
  return fit;
}

double
PoseSilhouetteKernel::ComputeOverlap(std::size_t s, const PoseContour & contour) const
{
  const PoseTracing & tracing = m_Strands[s].tracing;
  std::size_t         near = 0;
  for (std::size_t j = 0; j < contour.Size(); ++j)
  {
    bool found = false;
    for (std::size_t i = 0; i < tracing.Size() && !found; ++i)
    {
      const double du = tracing.u[i] - contour.u[j];
      const double dv = tracing.v[i] - contour.v[j];
      found = du * du + dv * dv < FitWidth * FitWidth;
    }
    near += found ? 1 : 0;
  }
  return contour.Size() > 0 ? static_cast<double>(near) / static_cast<double>(contour.Size()) : 0.0;
}

void
PoseSilhouetteKernel::AddSquaredMotion(const std::vector<PoseContour> & contours,
                                       const PoseParameters &           from,
                                       const PoseParameters &           to,
                                       double &                         sum,
                                       double &                         count) const
{
  const PoseModel fromModel(m_Settings.geometry, from);
  const PoseModel toModel(m_Settings.geometry, to);
  for (const PoseContour & contour : contours)
  {
    // Every fifth sample: 2.5 px apart.
    for (std::size_t i = 0; i < contour.Size(); i += 5)
    {
      double a[2], b[2];
      fromModel.Project(contour.rim[i].data(), a);
      toModel.Project(contour.rim[i].data(), b);
      sum += (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
      count += 1.0;
    }
  }
}
} // namespace itk

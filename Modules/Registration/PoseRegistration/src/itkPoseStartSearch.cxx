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
#include "itkPoseStartSearch.h"

#include "itkFindSilhouettes.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
// These say how finely the search sees, not what it looks for; each is a trade of its accuracy, which the refinement
// makes good, for its time.
/** px: beyond it a point has no match. One and a half steps of the shifts, so that the best step sees the contour. */
constexpr double Truncation = 12.0;
/** px of the field of distances: a quarter of a step of the shifts. */
constexpr double Cell = 2.0;
/** Normals are told apart to 22.5 degrees, at most 1.6 px with NormalWeight. */
constexpr int Directions = 16;
/** A byte holds the distance: up to 240, the rest is for rounding. */
constexpr double Quantum = Truncation / 240.0;
/** px a unit normal, as orientationWeight is by default. The search always matches normals, which tell the sides of a
 * cusp apart from far away; useOrientation is about the refinement. */
constexpr double NormalWeight = 8.0;
/** Every third point of a tracing is compared: points are some px apart, fields of distances smooth over 2 px. */
constexpr std::size_t ProbeStride = 3;
/** Starts that are nearer to a better one than all of these are the same: a step of the rotation (5 degrees), and of
 * the shift (10 px), and of the scale (8 %). */
constexpr double SameRotation = 0.0873;
constexpr double SameShift = 10.0;
constexpr double SameKappa = 0.08;

/** Truncated distance in (u, v, weight * normal) to the contour, a byte a cell. */
class OrientedField
{
public:
  OrientedField(const PoseContour & contour, double normalWeight)
  {
    if (contour.Size() == 0)
    {
      return;
    }
    double high[2];
    m_Low[0] = high[0] = contour.u[0];
    m_Low[1] = high[1] = contour.v[0];
    for (std::size_t i = 0; i < contour.Size(); ++i)
    {
      m_Low[0] = std::min(m_Low[0], contour.u[i]);
      high[0] = std::max(high[0], contour.u[i]);
      m_Low[1] = std::min(m_Low[1], contour.v[i]);
      high[1] = std::max(high[1], contour.v[i]);
    }
    for (int k = 0; k < 2; ++k)
    {
      m_Low[k] -= Truncation + Cell;
      m_Size[k] = static_cast<int>((high[k] + Truncation + Cell - m_Low[k]) / Cell) + 1;
    }
    m_Field.assign(static_cast<std::size_t>(m_Size[0]) * m_Size[1] * Directions, 240);
    const int reach = static_cast<int>(Truncation / Cell);
    for (std::size_t i = 0; i < contour.Size(); i += 2)
    {
      const int cu = static_cast<int>((contour.u[i] - m_Low[0]) / Cell);
      const int cv = static_cast<int>((contour.v[i] - m_Low[1]) / Cell);
      double    turn[Directions];
      for (int d = 0; d < Directions; ++d)
      {
        const double a = 2.0 * M_PI * d / Directions;
        turn[d] =
          normalWeight * normalWeight * (2.0 - 2.0 * (std::cos(a) * contour.nu[i] + std::sin(a) * contour.nv[i]));
      }
      for (int y = std::max(0, cv - reach); y <= std::min(m_Size[1] - 1, cv + reach); ++y)
      {
        for (int x = std::max(0, cu - reach); x <= std::min(m_Size[0] - 1, cu + reach); ++x)
        {
          const double du = m_Low[0] + (x + 0.5) * Cell - contour.u[i];
          const double dv = m_Low[1] + (y + 0.5) * Cell - contour.v[i];
          const double d2 = du * du + dv * dv;
          if (d2 >= Truncation * Truncation)
          {
            continue;
          }
          std::uint8_t * cell = &m_Field[(static_cast<std::size_t>(y) * m_Size[0] + x) * Directions];
          for (int d = 0; d < Directions; ++d)
          {
            const double q = d2 + turn[d];
            // Compared squared: the root only where it lowers the value.
            const double old = cell[d] * Quantum;
            if (q < old * old)
            {
              cell[d] = static_cast<std::uint8_t>(std::sqrt(q) / Quantum);
            }
          }
        }
      }
    }
  }

  std::uint8_t
  At(double u, double v, int direction) const
  {
    const double x = (u - m_Low[0]) / Cell;
    const double y = (v - m_Low[1]) / Cell;
    if (!(x >= 0.0 && y >= 0.0 && x < m_Size[0] && y < m_Size[1]))
    {
      return 240;
    }
    return m_Field[(static_cast<std::size_t>(y) * m_Size[0] + static_cast<std::size_t>(x)) * Directions + direction];
  }

private:
  double                    m_Low[2]{ 0, 0 };
  int                       m_Size[2]{ 0, 0 };
  std::vector<std::uint8_t> m_Field;
};

struct GridPoint
{
  unsigned int cost;
  unsigned int kappa;
  int          rotation;
  int          u;
  int          v;
};
} // namespace

void
PoseStartSearch::SetKappas(const std::vector<double> & kappas)
{
  if (kappas.empty())
  {
    itkExceptionMacro("SetKappas() wants at least one; 0 is the scale of the geometry.");
  }
  if (kappas != m_Kappas)
  {
    m_Kappas = kappas;
    this->Modified();
  }
}

std::vector<PoseStartSearch::StartType>
PoseStartSearch::Search(const LeastSquaresMetricv4 & metric, const RequestType & request) const
{
  const PoseParameters &    pose = request.pose;
  const std::vector<double> kappas = request.searchScale ? m_Kappas : std::vector<double>{ 0.0 };
  struct StrandType
  {
    const PoseTracing & tracing;
    const PoseContour & contour;
  };
  std::vector<StrandType> strands;
  PoseGeometry            geometry;
  for (const FoundSilhouette & found : FindSilhouettesOfStart(metric))
  {
    const auto & kernel = found.metric->GetKernel();
    const auto & contours = found.metric->GetContours(found.position);
    geometry = kernel.GetSettings().geometry;
    for (std::size_t s = 0; s < contours.size(); ++s)
    {
      strands.push_back({ kernel.GetStrands()[s].tracing, contours[s] });
    }
  }
  // Centroids of all tracing and all contours: the grid's origin.
  double                     tracingCentre[2] = { 0, 0 }, contourCentre[2] = { 0, 0 };
  std::array<double, 3>      rimCentre{ { 0, 0, 0 } };
  std::size_t                points = 0, samples = 0;
  std::vector<OrientedField> fields;
  for (std::size_t s = 0; s < strands.size(); ++s)
  {
    const PoseTracing & tracing = strands[s].tracing;
    const PoseContour & contour = strands[s].contour;
    points += tracing.Size();
    for (int k = 0; k < 2; ++k)
    {
      tracingCentre[k] += tracing.centroid[k] * static_cast<double>(tracing.Size());
    }
    samples += contour.Size();
    for (std::size_t i = 0; i < contour.Size(); ++i)
    {
      contourCentre[0] += contour.u[i];
      contourCentre[1] += contour.v[i];
      for (int k = 0; k < 3; ++k)
      {
        rimCentre[k] += contour.rim[i][k];
      }
    }
    fields.emplace_back(contour, NormalWeight);
  }
  std::vector<StartType> starts;
  if (points == 0 || samples == 0)
  {
    return starts;
  }
  for (int k = 0; k < 2; ++k)
  {
    tracingCentre[k] /= static_cast<double>(points);
    contourCentre[k] /= static_cast<double>(samples);
  }
  for (double & x : rimCentre)
  {
    x /= static_cast<double>(samples);
  }

  struct Probe
  {
    double      u, v, angle;
    std::size_t strand;
    double      ru{ 0 }, rv{ 0 };
    int         direction{ 0 };
  };
  std::vector<Probe> probes;
  for (std::size_t s = 0; s < strands.size(); ++s)
  {
    const PoseTracing & tracing = strands[s].tracing;
    for (std::size_t i = 1 % std::max<std::size_t>(1, tracing.Size()); i < tracing.Size(); i += ProbeStride)
    {
      probes.push_back({ tracing.u[i] - tracingCentre[0],
                         tracing.v[i] - tracingCentre[1],
                         std::atan2(tracing.nv[i], tracing.nu[i]),
                         s });
    }
  }
  const int rotations = request.holdRotation ? 0 : static_cast<int>(m_RotationRange / m_RotationStep + 0.5);
  const int us = static_cast<int>(m_HorizontalRange / m_ShiftStep + 0.5);
  const int vs = static_cast<int>(m_VerticalRange / m_ShiftStep + 0.5);
  std::vector<GridPoint> grid;
  grid.reserve(kappas.size() * (2 * rotations + 1) * (2 * us + 1) * (2 * vs + 1));
  for (unsigned int k = 0; k < kappas.size(); ++k)
  {
    const double shrink = std::exp(pose[PoseKappa] - kappas[k]);
    for (int r = -rotations; r <= rotations; ++r)
    {
      // The tracing is turned back onto the contour.
      const double angle = r * m_RotationStep;
      const double c = shrink * std::cos(angle);
      const double s = shrink * std::sin(angle);
      for (Probe & probe : probes)
      {
        probe.ru = c * probe.u + s * probe.v + contourCentre[0];
        probe.rv = -s * probe.u + c * probe.v + contourCentre[1];
        const double turns = (probe.angle - angle) / (2.0 * M_PI);
        probe.direction = static_cast<int>(std::lround((turns - std::floor(turns)) * Directions)) % Directions;
      }
      for (int v = -vs; v <= vs; ++v)
      {
        for (int u = -us; u <= us; ++u)
        {
          // The contour's shift, seen from the turned tracing.
          const double du = u * m_ShiftStep;
          const double dv = v * m_ShiftStep;
          const double ou = -(c * du + s * dv);
          const double ov = -(-s * du + c * dv);
          unsigned int cost = 0;
          for (const Probe & probe : probes)
          {
            cost += fields[probe.strand].At(probe.ru + ou, probe.rv + ov, probe.direction);
          }
          grid.push_back({ cost, k, r, u, v });
        }
      }
    }
  }
  std::stable_sort(grid.begin(), grid.end(), [](const GridPoint & a, const GridPoint & b) { return a.cost < b.cost; });
  std::vector<GridPoint> kept;
  for (const GridPoint & point : grid)
  {
    const bool near = std::any_of(kept.begin(), kept.end(), [&](const GridPoint & other) {
      return std::abs(point.rotation - other.rotation) * m_RotationStep < SameRotation &&
             std::hypot(point.u - other.u, point.v - other.v) * m_ShiftStep < SameShift &&
             std::abs(kappas[point.kappa] - kappas[other.kappa]) < SameKappa;
    });
    if (near)
    {
      continue;
    }
    kept.push_back(point);
    StartType start;
    start.cost = Quantum * point.cost / static_cast<double>(probes.size());
    start.parameters = pose;
    start.parameters[PosePitch] += point.rotation * m_RotationStep;
    start.parameters[PoseKappa] = kappas[point.kappa];
    const double target[2] = { tracingCentre[0] + point.u * m_ShiftStep, tracingCentre[1] + point.v * m_ShiftStep };
    PoseModel(geometry, start.parameters)
      .SolveTranslation(rimCentre.data(), target, start.parameters[PoseTx], start.parameters[PoseTz]);
    starts.push_back(start);
    if (starts.size() >= request.maximumNumberOfStarts)
    {
      break;
    }
  }
  return starts;
}

void
PoseStartSearch::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "RotationRange: " << m_RotationRange << std::endl;
  os << indent << "RotationStep: " << m_RotationStep << std::endl;
  os << indent << "HorizontalRange: " << m_HorizontalRange << std::endl;
  os << indent << "VerticalRange: " << m_VerticalRange << std::endl;
  os << indent << "ShiftStep: " << m_ShiftStep << std::endl;
  os << indent << "Kappas:";
  for (const double kappa : m_Kappas)
  {
    os << ' ' << kappa;
  }
  os << std::endl;
}
} // namespace itk

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
#include "itkDentalFrameJaw.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace DentalFrameKernel
{
namespace
{
/** mm behind the incisal edge where first molars are, in either jaw: their mesiobuccal cusps at 25 to 30. */
constexpr double MolarsFrom = 25.0;
constexpr double MolarsTo = 33.0;
/** Samples of a side from which on its width is measured: the occlusal surface of half a molar has some thirty. */
constexpr std::size_t FewestMolarSamples = 8;
} // namespace

OrientedPointSet
MirrorSet(const Jaw & jaw, const DentalFrameOptions & options)
{
  OrientedPointSet set;
  for (const std::uint32_t i :
       CrownBand(jaw.samples, jaw.vertical.direction, jaw.samples.centroid, options.mirrorBandHeight))
  {
    set.points.push_back(jaw.samples.points[i]);
    set.normals.push_back(jaw.samples.normals[i]);
  }
  return set;
}

MidsagittalPlaneResult
CoarseMirror(const std::vector<OrientedPointSet> & sets, const Vector3 & vertical, const DentalFrameOptions & options)
{
  return EstimateMidsagittalPlane(sets, vertical, Vector3{ 0.0, 0.0, 0.0 }, options.midline);
}

void
SetMirror(Jaw & jaw, const MidsagittalPlaneResult & mirror)
{
  if (mirror.valid && std::abs(Dot(mirror.normal, jaw.vertical.direction)) < 0.17)
  {
    jaw.vertical.direction = UnitRejection(jaw.vertical.direction, mirror.normal);
  }
  jaw.arch = FitArch(jaw.samples, jaw.vertical, jaw.jaw, mirror);
}

void
TurnSamples(Jaw & jaw)
{
  jaw.turned = !jaw.turned;
  jaw.samples.netNormal = -1.0 * jaw.samples.netNormal;
  for (Vector3 & normal : jaw.samples.normals)
  {
    normal = -1.0 * normal;
  }
}

void
FindArch(Jaw & jaw, const DentalFrameOptions & options)
{
  SetMirror(jaw, CoarseMirror({ MirrorSet(jaw, options) }, jaw.Superior(), options));
  jaw.valid = jaw.arch.valid;
}

double
Ramp(double value, double zero, double one)
{
  return std::clamp((value - zero) / (one - zero), 0.0, 1.0);
}

void
Describe(const Jaw & jaw, DentalJawFrame & frame)
{
  const Arch & arch = jaw.arch;
  const auto   onArch = [&](double phi) {
    const double  radius = ArchRadius(arch.terms, phi);
    const Vector3 p = arch.centre + (radius * std::cos(phi)) * arch.anterior + (radius * std::sin(phi)) * arch.lateral;
    // The U lies in the plane of the crowns.
    return p - Dot(p - jaw.vertical.centre, jaw.vertical.direction) * jaw.vertical.direction;
  };
  // At the molars: where the crowns end, but not behind the U's widest place (the ridge behind a cast's last molar).
  double widest = arch.reach;
  double width = 0.0;
  for (double phi = 0.35 * Pi; phi <= arch.reach; phi += Degree)
  {
    const double across = ArchRadius(arch.terms, phi) * std::sin(phi);
    if (across > width)
    {
      width = across;
      widest = phi;
    }
  }
  frame.baselineLeft = onArch(widest);
  frame.baselineRight = onArch(-widest);
  frame.midpoint = 0.5 * (frame.baselineLeft + frame.baselineRight);

  // The edge: the highest points where the U crosses its axis. Samples first, so that a speck above cannot be it.
  const Vector3 front = onArch(0.0);
  const auto    nearFront = [&](const Vector3 & p) {
    const Vector3 d = p - front;
    return std::abs(Dot(d, arch.lateral)) < 4.0 && std::abs(Dot(d, arch.anterior)) < 6.0;
  };
  double highest = -std::numeric_limits<double>::infinity();
  for (const Vector3 & p : jaw.samples.points)
  {
    if (nearFront(p))
    {
      highest = std::max(highest, Dot(p - front, jaw.vertical.direction));
    }
  }
  frame.incisalEdge = front;
  if (std::isfinite(highest))
  {
    std::vector<double>  heights;
    std::vector<Vector3> edge;
    for (const Vector3 & p : jaw.surface->points)
    {
      const double height = Dot(p - front, jaw.vertical.direction);
      if (height > highest - 1.5 && height < highest + 0.7 && nearFront(p))
      {
        heights.push_back(height);
        edge.push_back(p);
      }
    }
    if (!edge.empty())
    {
      const double crest = Quantile(heights, 0.98) - 0.4;
      Vector3      sum{ 0.0, 0.0, 0.0 };
      double       count = 0.0;
      double       height = 0.0;
      for (std::size_t i = 0; i < edge.size(); ++i)
      {
        if (heights[i] >= crest)
        {
          sum = sum + edge[i];
          height = std::max(height, heights[i]);
          count += 1.0;
        }
      }
      frame.incisalEdge = (1.0 / count) * sum;
    }
  }
  frame.archWidth = Norm(frame.baselineLeft - frame.baselineRight);
  frame.archDepth = Dot(frame.incisalEdge - frame.midpoint, frame.axes[0]);
  std::vector<double> left;
  std::vector<double> right;
  for (const std::uint32_t i : jaw.vertical.crowns)
  {
    const Vector3 d = jaw.samples.points[i] - frame.incisalEdge;
    const double  behind = -Dot(d, frame.axes[0]);
    if (behind > MolarsFrom && behind < MolarsTo)
    {
      const double across = Dot(jaw.samples.points[i] - arch.centre, frame.axes[1]);
      (across > 0.0 ? left : right).push_back(std::abs(across));
    }
  }
  frame.molarWidth = left.size() < FewestMolarSamples || right.size() < FewestMolarSamples
                       ? 0.0
                       : Quantile(left, 0.95) + Quantile(right, 0.95);
  frame.openness = Norm(jaw.samples.netNormal);
  frame.windingAgreement = frame.openness > 0.0 ? (jaw.turned ? -1.0 : 1.0) *
                                                    Dot(jaw.samples.netNormal, jaw.vertical.direction) / frame.openness
                                                : 0.0;

  // Roughness alone, all that a closed body has, is a weaker sign than normals or contact.
  const double surest = frame.openness > 0.15 ? 1.0 : 0.7;
  frame.signConfidence = std::max(frame.signConfidence, surest * Ramp(jaw.margin, 0.0, 0.8));
  frame.planeConfidence = Ramp(jaw.vertical.thickness, 6.0, 3.0) * Ramp(jaw.vertical.inlierShare, 0.4, 0.75);
  frame.archConfidence = Ramp(arch.spread, 9.0, 4.5) * Ramp(arch.reach, 30.0 * Degree, 75.0 * Degree) *
                         Ramp(arch.radius, 12.0, 18.0) * Ramp(arch.radius, 60.0, 48.0) * Ramp(arch.resultant, 0.0, 0.5);
}
} // namespace DentalFrameKernel
} // namespace itk

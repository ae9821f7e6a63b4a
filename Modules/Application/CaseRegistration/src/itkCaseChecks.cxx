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
#include "itkCaseChecks.h"

#include "itkJawExchangeEvidence.h"
#include "itkRegistrationVerdict.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using PointType = std::array<double, 3>;

/** Width of a dental arch, mm, as the verdict judges it too: no arch is narrower, no cast with its base wider. */
constexpr double NarrowestArch = RegistrationVerdict::Thresholds().minimumArchWidth;
constexpr double WidestArch = RegistrationVerdict::Thresholds().maximumArchWidth;
/** A landmark belongs to a scan that passes within this distance, mm: a marked tip may lie off the surface by a
 * vertex's distance or a click, and half a tooth is the next landmark's. */
constexpr double LandmarkDistance = 3.0;
/** Landmarks whose median distance from their own scan is below this lie on it, mm: they are vertices of it or beside
 * one, whatever the other scan, which may touch it in occlusion, is near to. */
constexpr double OnTheScan = 0.5;
/** Landmarks are the other scan's where they are nearer to it by this factor. */
constexpr double NearerByFactor = 0.5;
/** windingAgreement (a cosine, 1 for an open shell that faces outward) below which a shell faces inward. Its sign
 * tells; this far from 0 a hole or a fold does not turn it. */
constexpr double InwardWinding = -0.2;
/** Mean distance of one side's landmarks from the midline on the wrong side, mm, from which on the sides are exchanged:
 * they lie 15 mm or more to their own side, and the midline is found to a millimetre or two. */
constexpr double WrongSideOffset = 5.0;
/** Probability from which on the shapes say that the scans are exchanged: more likely than not. */
constexpr double ProbablyExchanged = 0.5;
/** Confidence in a dental axis below which it is doubted: the middle of its range from 0 to 1 (Documentation/UMDA.md).
 */
constexpr double UnsureAxis = 0.5;

const DentalJawFrame &
FrameOf(const DentalFrameResult & frames, JawEnum jaw)
{
  return jaw == JawEnum::Upper ? frames.upper : frames.lower;
}

/** Extent along the frame's lateral axis; along the longest diagonal where there is no frame. */
double
LateralExtent(const DentalCaseData::MeshType * mesh, const DentalJawFrame & frame)
{
  if (!frame.valid)
  {
    const auto * box = mesh->GetBoundingBox();
    return std::sqrt(static_cast<double>(box->GetDiagonalLength2()));
  }
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
  {
    double y = 0.0;
    for (unsigned int d = 0; d < 3; ++d)
    {
      y += frame.axes[1][d] * it.Value()[d];
    }
    low = std::min(low, y);
    high = std::max(high, y);
  }
  return high - low;
}

void
CheckUnit(const DentalCaseData & data, JawEnum jaw, const DentalJawFrame & frame, JawResult & result)
{
  const double extent = LateralExtent(data.GetJaw(jaw).mesh, frame);
  if (extent >= NarrowestArch && extent <= WidestArch)
  {
    return;
  }
  std::ostringstream reason;
  reason << "the arch is " << std::setprecision(3) << extent << " mm wide, not " << NarrowestArch << " to "
         << WidestArch;
  const double                                             inFile = extent / data.description.millimetresPerUnit;
  constexpr std::array<std::pair<const char *, double>, 4> units{
    { { "mm", 1.0 }, { "cm", 10.0 }, { "m", 1000.0 }, { "um", 0.001 } }
  };
  for (const auto & unit : units)
  {
    if (inFile * unit.second >= NarrowestArch && inFile * unit.second <= WidestArch)
    {
      reason << "; \"mesh_unit\": \"" << unit.first << "\" would fit";
    }
  }
  result.AddReason(CaseStatusEnum::Suspect, reason.str());
}

/** Distances from points (mm) to their nearest vertex of a scan, in one pass over it. */
std::vector<double>
DistancesToScan(const std::vector<std::pair<ToothCode, PointType>> & points, const DentalCaseData::MeshType * mesh)
{
  const std::size_t                 count = points.size();
  std::array<std::vector<float>, 3> from;
  for (const auto & point : points)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      from[d].push_back(static_cast<float>(point.second[d]));
    }
  }
  std::vector<float> best(count, std::numeric_limits<float>::max());
  for (const auto & vertex : mesh->GetPoints()->CastToSTLConstContainer())
  {
    const float p[3] = { vertex[0], vertex[1], vertex[2] };
    for (std::size_t i = 0; i < count; ++i)
    {
      const float x = from[0][i] - p[0];
      const float y = from[1][i] - p[1];
      const float z = from[2][i] - p[2];
      const float squared = x * x + y * y + z * z;
      best[i] = squared < best[i] ? squared : best[i];
    }
  }
  std::vector<double> distances;
  for (const float squared : best)
  {
    distances.push_back(std::sqrt(static_cast<double>(squared)));
  }
  return distances;
}

double
Median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/** Landmarks (mm) of a jaw by their names. */
std::vector<std::pair<ToothCode, PointType>>
LandmarksOf(const DentalCaseData & data, JawEnum jaw)
{
  std::vector<std::pair<ToothCode, PointType>> landmarks;
  if (data.landmarks3D.IsNotNull())
  {
    for (const auto & landmark : data.landmarks3D->GetLandmarks())
    {
      if (landmark.tooth.GetJaw() == jaw)
      {
        PointType point;
        for (unsigned int d = 0; d < 3; ++d)
        {
          point[d] = landmark.point[d] * data.description.millimetresPerUnit;
        }
        landmarks.emplace_back(landmark.tooth, point);
      }
    }
  }
  return landmarks;
}

/** \return whether the names could tell. */
bool
CheckNamesAgainstScans(const DentalCaseData & data, CaseResult & result)
{
  bool told = false;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const JawEnum other = jaw == JawEnum::Upper ? JawEnum::Lower : JawEnum::Upper;
    const auto    landmarks = LandmarksOf(data, jaw);
    const auto *  own = data.GetJaw(jaw).mesh.GetPointer();
    if (landmarks.empty() || own == nullptr)
    {
      continue;
    }
    const auto *              opposite = data.GetJaw(other).mesh.GetPointer();
    const std::vector<double> toOwn = DistancesToScan(landmarks, own);
    const std::vector<double> toOther =
      opposite != nullptr ? DistancesToScan(landmarks, opposite) : std::vector<double>();
    told = true;
    const double ownMedian = Median(toOwn);
    const char * name = jaw == JawEnum::Upper ? "upper" : "lower";
    if (opposite != nullptr && ownMedian > OnTheScan && Median(toOther) < NearerByFactor * ownMedian)
    {
      for (auto & entry : result.jaws)
      {
        entry.second.AddReason(CaseStatusEnum::Suspect,
                               std::string("upper and lower scan seem exchanged: the ") + name +
                                 " landmarks lie on the other scan");
      }
    }
    else if (ownMedian > LandmarkDistance && result.jaws.count(jaw) != 0)
    {
      std::ostringstream reason;
      reason << "the 3-D landmarks are " << std::setprecision(3) << ownMedian
             << " mm away from the scan; are they in the scan's unit and frame, and is it the right scan?";
      result.jaws[jaw].AddReason(CaseStatusEnum::Suspect, reason.str());
    }
  }
  return told;
}

void
CheckMirroring(const DentalCaseData & data, JawEnum jaw, const DentalJawFrame & frame, CaseResult & result)
{
  JawResult & jawResult = result.jaws[jaw];
  // A closed cast has no net normal: its winding says nothing.
  if (frame.openness > OpennessOfClosedCast && frame.windingAgreement < InwardWinding)
  {
    jawResult.AddReason(CaseStatusEnum::Suspect, "the surface is wound inward: the scan may be mirrored");
  }
  double right = 0.0;
  double left = 0.0;
  int    rights = 0;
  int    lefts = 0;
  for (const auto & landmark : LandmarksOf(data, jaw))
  {
    double y = 0.0;
    for (unsigned int d = 0; d < 3; ++d)
    {
      y += frame.axes[1][d] * (landmark.second[d] - frame.origin[d]);
    }
    if (landmark.first.IsRight())
    {
      right += y;
      ++rights;
    }
    else
    {
      left += y;
      ++lefts;
    }
  }
  const bool rightOnLeft = rights > 0 && right / rights > WrongSideOffset;
  const bool leftOnRight = lefts > 0 && left / lefts < -WrongSideOffset;
  if (rightOnLeft || leftOnRight)
  {
    jawResult.AddReason(
      CaseStatusEnum::Suspect,
      "the landmarks named for one side lie on the other: the scan may be mirrored, or the names exchanged");
  }
}

/** One file named twice. */
void
CheckSameScan(const DentalCaseData & data, CaseResult & result)
{
  const auto * upper = data.upper.mesh.GetPointer();
  const auto * lower = data.lower.mesh.GetPointer();
  if (upper == nullptr || lower == nullptr || upper->GetNumberOfPoints() != lower->GetNumberOfPoints())
  {
    return;
  }
  for (auto a = upper->GetPoints()->Begin(), b = lower->GetPoints()->Begin(); a != upper->GetPoints()->End(); ++a, ++b)
  {
    if (a.Value() != b.Value())
    {
      return;
    }
  }
  for (auto & entry : result.jaws)
  {
    entry.second.AddReason(CaseStatusEnum::Failed, "upper and lower scan are the same; name the scan of each jaw");
  }
}

/** By shape alone. \return whether the shapes could tell. */
bool
CheckShapesForExchange(const DentalFrameResult & frames, CaseResult & result)
{
  const JawExchangeEvidence evidence(frames);
  // One measure alone never tells.
  const bool told = evidence.GetMolarWidthDifference().has_value() && evidence.GetOverjet().has_value();
  if (told && evidence.GetProbability() > ProbablyExchanged)
  {
    std::ostringstream reason;
    reason << "upper and lower scan may be exchanged (probability " << std::setprecision(2) << evidence.GetProbability()
           << "): the upper arch is " << -*evidence.GetMolarWidthDifference()
           << " mm narrower than the lower at the first molars and lies " << -*evidence.GetOverjet()
           << " mm behind it in front";
    for (auto & entry : result.jaws)
    {
      entry.second.AddReason(CaseStatusEnum::Suspect, reason.str());
    }
  }
  return told;
}
} // namespace

void
CheckCase(const DentalCaseData & data, const DentalFrameResult & frames, CaseResult & result)
{
  CheckSameScan(data, result);
  const bool namesTold = CheckNamesAgainstScans(data, result);
  const bool shapesTold = CheckShapesForExchange(frames, result);
  if (!namesTold && !shapesTold)
  {
    result.notCheckable.push_back(
      "whether upper and lower scan were exchanged: there are no 3-D landmarks, and no two jaws in one frame");
  }
  for (auto & entry : result.jaws)
  {
    const DentalJawFrame & frame = FrameOf(frames, entry.first);
    CheckUnit(data, entry.first, frame, entry.second);
    if (!frame.valid)
    {
      continue;
    }
    CheckMirroring(data, entry.first, frame, result);
    if (frame.confidence < UnsureAxis)
    {
      std::ostringstream reason;
      reason << "the dental axis is unsure (confidence " << std::setprecision(2) << frame.confidence << ")";
      entry.second.AddReason(CaseStatusEnum::Suspect, reason.str());
    }
    if (frame.openness <= OpennessOfClosedCast)
    {
      result.notCheckable.push_back(std::string("whether the ") + (entry.first == JawEnum::Upper ? "upper" : "lower") +
                                    " cast was mirrored: a closed body's winding looks the same either way");
    }
  }
}
} // namespace itk

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
#include "itkDentalFrameEstimator.h"

#include "itkDentalFrameJaw.h"
#include "itkDentalFrameOcclusion.h"
#include "itkParallelFor.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <sstream>
#include <stdexcept>

namespace itk
{
namespace
{
/** An arch of fewer triangles has no crowns: the coarsest scan in use has some thousand. The samples are drawn from the
 * area and would be as many of a single triangle, on whose flat face a U can be found as well as anywhere. */
constexpr std::size_t MinimumTriangles = 100;
/** Specks and degenerate triangles give none. */
constexpr std::size_t MinimumSamples = 100;
/** Length of the net area normal over the area from which on a body is open and can show that it is wound inward. */
constexpr double LeastNetNormal = 0.1;
/** Lead of OcclusalLook() for the other direction from which on a shell counts as wound inward. Phantoms of level real
 * lead by 0.4 or more for the right one. */
constexpr double LeastLead = 0.2;
} // namespace

const DentalJawFrame &
DentalFrameResult::GetJaw(ToothCode::JawEnum jaw) const
{
  switch (jaw)
  {
    case ToothCode::JawEnum::Upper:
      return upper;
    case ToothCode::JawEnum::Lower:
      return lower;
    default:
      throw std::invalid_argument("A dental frame is of the upper or the lower jaw, not of an unknown one.");
  }
}

DentalFrameResult
EstimateDentalFrame(const TriangleSurface * upper, const TriangleSurface * lower, const DentalFrameOptions & options)
{
  using namespace DentalFrameKernel;

  DentalFrameResult  result;
  std::array<Jaw, 2> jaws;
  std::mutex         abortMutex;
  const auto         aborted = [&]() {
    const std::lock_guard<std::mutex> lock(abortMutex);
    return options.abort && options.abort();
  };
  ParallelFor(2, options.threads == 0 ? 2 : options.threads, [&](std::size_t j) {
    Jaw & jaw = jaws[j];
    jaw.jaw = j == 0 ? ToothCode::JawEnum::Upper : ToothCode::JawEnum::Lower;
    jaw.surface = j == 0 ? upper : lower;
    if (jaw.surface == nullptr || aborted())
    {
      return;
    }
    jaw.samples = TakeSamples(*jaw.surface, options.samples);
    if (jaw.surface->triangles.size() >= MinimumTriangles && jaw.samples.points.size() >= MinimumSamples && !aborted())
    {
      jaw.vertical = ChooseVertical(jaw.samples, Vector3{ 0.0, 0.0, 0.0 }, 0.0, options, jaw.margin);
      FindArch(jaw, options);
    }
  });
  if (aborted())
  {
    return result;
  }

  const bool both = jaws[0].valid && jaws[1].valid;
  if (both)
  {
    const Contact contact = FindContact(jaws[0].samples, jaws[1].samples);
    result.occlusionPlausible = TestOcclusion(jaws[0], jaws[1], contact, result);
    if (!result.occlusionPlausible && options.jawsShareFrame != DentalFrameEnums::JawsShareFrame::Off)
    {
      // One jaw's own estimate may have the wrong sign: a closed cast has no net normal, an inward winding a reversed
      // one. Contact decides, if everything fits then. But only a shell that by its own shape looks wound inward is
      // turned: two scans that were each moved to the origin touch in any orientation.
      std::array<std::array<Jaw, 2>, 2> trials{ { { { jaws[0], jaws[0] } }, { { jaws[1], jaws[1] } } } };
      for (unsigned int j = 0; j < 2; ++j)
      {
        TurnSamples(trials[j][1]);
        for (Jaw & trial : trials[j])
        {
          trial.vertical = ChooseVertical(
            trial.samples, j == 0 ? -1.0 * contact.direction : contact.direction, 2.0, options, trial.margin);
        }
      }
      std::array<bool, 2> mayTurn{ { false, false } };
      for (unsigned int j = 0; j < 2; ++j)
      {
        if (Norm(jaws[j].samples.netNormal) >= LeastNetNormal)
        {
          const std::vector<Vector3> rim = FindRim(*jaws[j].surface);
          mayTurn[j] = OcclusalLook(trials[j][1], rim) > OcclusalLook(jaws[j], rim) + LeastLead;
        }
      }
      for (unsigned int variant = 0; variant < 4 && !result.occlusionPlausible && !aborted(); ++variant)
      {
        Jaw &             first = trials[0][variant & 1u];
        Jaw &             second = trials[1][variant >> 1];
        DentalFrameResult tested = result;
        if ((first.turned && !mayTurn[0]) || (second.turned && !mayTurn[1]) ||
            !VerticalsFit(first, second, contact, tested))
        {
          continue;
        }
        FindArch(first, options);
        FindArch(second, options);
        if (first.valid && second.valid && TestOcclusion(first, second, contact, tested))
        {
          result = tested;
          result.occlusionPlausible = true;
          jaws = { first, second };
        }
      }
      if (aborted())
      {
        return DentalFrameResult();
      }
    }
    result.jawsShareFrame =
      options.jawsShareFrame == DentalFrameEnums::JawsShareFrame::On ||
      (options.jawsShareFrame == DentalFrameEnums::JawsShareFrame::Check && result.occlusionPlausible);
  }

  if (result.jawsShareFrame && result.anteriorDisagreement > 4.0)
  {
    // One jaw's plane is wrong, as in an arch that lacks one side. The pair's common plane decides.
    const MidsagittalPlaneResult common = CoarseMirror({ MirrorSet(jaws[0], options), MirrorSet(jaws[1], options) },
                                                       Unit(jaws[0].Superior() + jaws[1].Superior()),
                                                       options);
    for (Jaw & jaw : jaws)
    {
      SetMirror(jaw, common);
    }
  }

  if (result.jawsShareFrame && Dot(jaws[0].arch.lateral, jaws[1].arch.lateral) < 0.0)
  {
    // Contradicting fronts: the clearer U has its way, and neither is surer of it than by what it is clearer.
    const unsigned int clearer = jaws[0].arch.resultant >= jaws[1].arch.resultant ? 0 : 1;
    Jaw &              other = jaws[1 - clearer];
    const double       lead = std::abs(jaws[0].arch.resultant - jaws[1].arch.resultant);
    other.arch = FitArch(other.samples, other.vertical, other.jaw, other.arch.mirror, &jaws[clearer].arch.lateral);
    for (Jaw & jaw : jaws)
    {
      jaw.arch.resultant = std::min(jaw.arch.resultant, lead);
    }
  }

  // The shared lateral axis.
  std::array<Vector3, 2> laterals{ { jaws[0].arch.lateral, jaws[1].arch.lateral } };
  if (result.jawsShareFrame)
  {
    laterals[0] = laterals[1] = Unit(laterals[0] + laterals[1]);
  }

  if (options.refineMidline)
  {
    MidsagittalPlaneOptions fine = options.midline;
    fine.startRange = std::min(fine.startRange, 10.0);
    if (result.jawsShareFrame)
    {
      result.midsagittalUpper = EstimateMidsagittalPlane({ MirrorSet(jaws[0], options), MirrorSet(jaws[1], options) },
                                                         Unit(jaws[0].Superior() + jaws[1].Superior()),
                                                         laterals[0],
                                                         fine);
      result.midsagittalLower = result.midsagittalUpper;
    }
    else
    {
      // Its own plane is known already; its normal shall point to the left.
      for (unsigned int j = 0; j < 2; ++j)
      {
        if (jaws[j].valid)
        {
          MidsagittalPlaneResult & plane = j == 0 ? result.midsagittalUpper : result.midsagittalLower;
          plane = jaws[j].arch.mirror;
          if (Dot(plane.normal, laterals[j]) < 0.0)
          {
            plane.normal = -1.0 * plane.normal;
            plane.offset = -plane.offset;
          }
        }
      }
    }
  }
  if (aborted())
  {
    return DentalFrameResult();
  }

  for (unsigned int j = 0; j < 2; ++j)
  {
    const Jaw &                    jaw = jaws[j];
    DentalJawFrame &               frame = j == 0 ? result.upper : result.lower;
    const MidsagittalPlaneResult & plane = j == 0 ? result.midsagittalUpper : result.midsagittalLower;
    frame.centroid = frame.origin = jaw.samples.centroid;
    if (!jaw.valid)
    {
      continue;
    }
    const bool refined = plane.valid;
    // The paper's last step: keep y and x, and z follows, since y is not across the jaw's own z.
    frame.axes[1] = refined ? plane.normal : laterals[j];
    frame.axes[0] = Unit(Cross(frame.axes[1], jaw.Superior()));
    frame.axes[2] = Cross(frame.axes[0], frame.axes[1]);
    frame.midlineOffset =
      refined ? plane.offset - Dot(plane.normal, frame.centroid) : Dot(frame.axes[1], jaw.arch.centre - frame.centroid);
    if (refined)
    {
      frame.origin = frame.centroid + frame.midlineOffset * frame.axes[1];
    }
    if (result.jawsShareFrame && result.occlusionPlausible)
    {
      frame.signConfidence = 1.0;
    }
    Describe(jaw, frame);
    std::size_t left = 0;
    for (const std::uint32_t i : jaw.vertical.crowns)
    {
      left += Dot(jaw.samples.points[i] - jaw.arch.centre, jaw.arch.lateral) > 0.0 ? 1 : 0;
    }
    const double share = static_cast<double>(std::min(left, jaw.vertical.crowns.size() - left)) /
                         static_cast<double>(jaw.vertical.crowns.size());
    frame.symmetryConfidence = Ramp(share, 0.1, 0.3);
    const MidsagittalPlaneResult & mirror = refined ? plane : jaw.arch.mirror;
    frame.symmetryConfidence *= Ramp(mirror.inlierFraction, 0.5, 0.8) * (0.4 + 0.6 * Ramp(mirror.margin, 0.0, 0.1));
    // Sides that differ all along have a mirror plane too, that of neither of them. Of two jaws each tells where the
    // other one's sides differ.
    if (!result.jawsShareFrame)
    {
      frame.symmetryConfidence *= Ramp(mirror.residual, 1.35, 1.05);
    }
    frame.confidence = frame.signConfidence * frame.planeConfidence * frame.archConfidence * frame.symmetryConfidence;
    frame.valid = true;
  }

  if (result.jawsShareFrame)
  {
    DentalJawFrame & joint = result.joint;
    const double     upperArea = jaws[0].samples.area;
    const double     lowerArea = jaws[1].samples.area;
    joint = result.upper;
    joint.axes[0] = Unit(Cross(joint.axes[1], Unit(result.upper.axes[2] + result.lower.axes[2])));
    joint.axes[2] = Cross(joint.axes[0], joint.axes[1]);
    joint.centroid =
      (1.0 / (upperArea + lowerArea)) * (upperArea * result.upper.centroid + lowerArea * result.lower.centroid);
    joint.origin = joint.centroid;
    joint.midlineOffset =
      0.5 * (result.upper.midlineOffset + Dot(joint.axes[1], result.upper.centroid - joint.centroid) +
             result.lower.midlineOffset + Dot(joint.axes[1], result.lower.centroid - joint.centroid));
    if (result.midsagittalUpper.valid)
    {
      joint.midlineOffset = result.midsagittalUpper.offset - Dot(joint.axes[1], joint.centroid);
      joint.origin = joint.centroid + joint.midlineOffset * joint.axes[1];
    }
    joint.confidence = std::min(result.upper.confidence, result.lower.confidence);
    result.overjet = Dot(result.upper.incisalEdge - result.lower.incisalEdge, joint.axes[0]);
    result.overbite = Dot(result.lower.incisalEdge - result.upper.incisalEdge, joint.axes[2]);
  }
  else if (result.upper.valid != result.lower.valid)
  {
    result.joint = result.upper.valid ? result.upper : result.lower;
  }
  return result;
}

std::string
DescribeOcclusion(const DentalFrameResult & result)
{
  using FindingEnum = DentalFrameEnums::OcclusionFinding;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.setf(std::ios::fixed);
  text.precision(1);
  switch (result.occlusionFinding)
  {
    case FindingEnum::InOcclusion:
      text << "the jaws face each other, their crowns " << result.crownDistance << " mm apart, one arch over the other";
      break;
    case FindingEnum::NotOpposed:
      text << "the occlusal sides do not face each other: they are " << result.verticalDisagreement
           << " degrees off that";
      break;
    case FindingEnum::FarApart:
      text << "the jaws are too far apart: their crowns by " << result.crownDistance << " mm";
      break;
    case FindingEnum::NotOverEachOther:
      text << "the upper jaw is not above the lower: its crowns lie " << -result.crownPlaneGap << " mm below those";
      break;
    case FindingEnum::ArchesBesideEachOther:
      text << "one arch lies beside the other: by " << result.archDistance << " mm";
      break;
    case FindingEnum::Interpenetrating:
      text.precision(0);
      text << "the jaws lie inside each other: " << 100.0 * result.interpenetration
           << " % of what is near the other one";
      break;
    default:
      text << "there are no two jaws to compare";
  }
  return text.str();
}
} // namespace itk

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
#include "itkScanCheckFilter.h"

#include "itkJawIndex.h"
#include "itkJawExchangeEvidence.h"
#include "itkLandmarkOrder.h"
#include "itkMakeTriangleSurface.h"
#include "itkMillimetresPerUnit.h"
#include "itkRegistrationVerdict.h"
#include "itkSortFindings.h"
#include "itkSurfaceParts.h"
#include "itkSurfaceSpikes.h"

#include "vnl/algo/vnl_symmetric_eigensystem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iomanip>
#include <limits>
#include <locale>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using MeshType = ScanCheckFilter::MeshType;
using PointType = TriangleSurface::PointType;
using FindingsType = ScanCheckFilter::FindingsType;
constexpr auto Suspect = RegistrationStatusEnum::Suspect;
constexpr auto Failed = RegistrationStatusEnum::Failed;

/** Width of a dental arch, mm, as the verdict judges it too: no arch is narrower, no cast with its base wider. */
constexpr double NarrowestArch = RegistrationVerdict::Thresholds().minimumArchWidth;
constexpr double WidestArch = RegistrationVerdict::Thresholds().maximumArchWidth;
/** What an arch with its gingiva is wide, mm, give or take a third: of several units that could be meant the one that
 * comes nearest is named first. */
constexpr double UsualArch = 68.0;
/** Second longest side of a scan, mm, and its share of the longest, below which it shows no whole arch. The arch of
 * milk teeth is 28 mm deep without gingiva and half as deep as wide or more; a quadrant with its gingiva, cut past the
 * midline, is up to 28 mm across and 65 mm long. */
constexpr double DepthOfPart = 30.0;
constexpr double DepthShareOfPart = 0.5;
/** Share of the area that each of two jaws in one file has at least, cosine between their mean normals, and share of a
 * part's area that its mean normal has where the part is an open shell: jaws face each other, a cast and its base or a
 * palate scanned apart do not. */
constexpr double ShareOfJaw = 0.25;
constexpr double OpposedCosine = -0.5;
constexpr double OpennessOfShell = 0.2;
/** Landmarks whose median distance from their own scan is below this lie on it, mm: they are vertices of it or beside
 * one, whatever the other scan, which may touch it in occlusion, is near to. */
constexpr double OnTheScan = 0.5;
/** Landmarks are the other scan's where they are nearer to it by this factor. */
constexpr double NearerByFactor = 0.5;
/** Share of a jaw's landmarks that may lie on its scan by chance where the scans are exchanged. */
constexpr double ShareOnOwnScan = 0.25;
/** windingAgreement (a cosine, 1 for an open shell that faces outward) below which a shell faces inward. Its sign
 * tells; this far from 0 a hole or a fold does not turn it. */
constexpr double InwardWinding = -0.2;
/** Mean distance of one side's landmarks from the midline on the wrong side, mm, from which on the sides are exchanged:
 * they lie 15 mm or more to their own side, and the midline is found to a millimetre or two. */
constexpr double WrongSideOffset = 5.0;
/** The same of a single one, which a crossed or crowded incisor may have some millimetres of. */
constexpr double OneOnTheWrongSide = 8.0;
/** Probability from which on the shapes say that the scans are exchanged: more likely than not. */
constexpr double ProbablyExchanged = 0.5;
/** Confidence in a dental axis below which it is doubted: the middle of its range from 0 to 1 (Documentation/UMDA.md).
 */
constexpr double UnsureAxis = 0.5;

/** A point that stands by itself this far out of a scan, mm, is none of a jaw: no cusp, bracket or wire ends in a point
 * that is so far from the next one. At three times this length it shifts landmarks by a pixel. */
constexpr double LongestSpike = 5.0;

/** Three digits: what a person reads. */
std::string
Number(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(3) << value;
  return text.str();
}

/** One jaw's scan as it is looked at. */
struct Scan
{
  JawEnum                                        jaw{ JawEnum::Upper };
  const MeshType *                               mesh{ nullptr };
  const DentalJawFrame *                         frame{ nullptr };
  std::unique_ptr<SurfaceParts>                  parts;
  TriangleSurface                                surface;
  std::vector<std::pair<std::string, PointType>> landmarks;
  FindingsType                                   findings;
  /** Names of landmarks that are none of the scan. */
  std::vector<std::string> unusable;

  bool
  IsThere() const
  {
    return mesh != nullptr;
  }
  void
  Add(RegistrationStatusEnum severity, const char * code, const std::string & text)
  {
    findings.push_back({ severity, code, text, std::nullopt, std::nullopt, "" });
  }
  void
  Add(RegistrationStatusEnum severity,
      const char *           code,
      const std::string &    text,
      double                 value,
      double                 limit,
      const char *           unit)
  {
    findings.push_back({ severity, code, text, value, limit, unit });
  }
};

/** Lengths of a scan along its principal axes, longest first; mm. */
std::array<double, 3>
PrincipalLengths(const Scan & scan)
{
  const PointType centroid = scan.surface.AreaCentroid();
  // vnl's elements are function calls.
  std::array<std::array<double, 3>, 3> sums{};
  vnl_matrix<double>                   covariance(3, 3, 0.0);
  vnl_matrix<double>                   axes(3, 3, 0.0);
  vnl_vector<double>                   values(3, 0.0);
  for (std::size_t t = 0; t < scan.surface.triangles.size(); ++t)
  {
    if (!scan.parts->IsKept(t))
    {
      continue;
    }
    const PointType normal = scan.surface.AreaNormal(t);
    const double    area = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    for (const std::uint32_t corner : scan.surface.triangles[t])
    {
      const PointType & p = scan.surface.points[corner];
      const PointType   x{ p[0] - centroid[0], p[1] - centroid[1], p[2] - centroid[2] };
      for (unsigned int row = 0; row < 3; ++row)
      {
        for (unsigned int column = 0; column < 3; ++column)
        {
          sums[row][column] += area * x[row] * x[column];
        }
      }
    }
  }
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      covariance(row, column) = sums[row][column];
    }
  }
  vnl_symmetric_eigensystem_compute(covariance, axes, values);
  std::array<double, 3> lengths;
  for (unsigned int k = 0; k < 3; ++k)
  {
    const auto extent = scan.parts->ComputeExtent(scan.surface, { { axes(0, k), axes(1, k), axes(2, k) } });
    lengths[k] = extent.second - extent.first;
  }
  std::sort(lengths.begin(), lengths.end(), std::greater<double>());
  return lengths;
}

void
CheckBothJaws(Scan & scan)
{
  // Shells that face each other cancel out.
  std::vector<const SurfaceParts::PartType *> shells;
  for (const auto & part : scan.parts->GetParts())
  {
    const double length =
      std::sqrt(part.normal[0] * part.normal[0] + part.normal[1] * part.normal[1] + part.normal[2] * part.normal[2]);
    if (part.area >= ShareOfJaw * scan.parts->GetArea() && length >= OpennessOfShell * part.area)
    {
      shells.push_back(&part);
    }
  }
  if (shells.size() != 2)
  {
    return;
  }
  double dot = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (unsigned int d = 0; d < 3; ++d)
  {
    dot += shells[0]->normal[d] * shells[1]->normal[d];
    first += shells[0]->normal[d] * shells[0]->normal[d];
    second += shells[1]->normal[d] * shells[1]->normal[d];
  }
  if (dot < OpposedCosine * std::sqrt(first * second))
  {
    scan.Add(Suspect,
             "both-jaws",
             "the scan seems to hold both jaws, two shells that face each other: export each jaw by itself");
  }
}

/** Points that stand out of the scan, each by itself: the outline runs to their ends, and so do boxes and lengths.
 * `excess`: how much wider than any arch the scan is, mm. */
void
CheckSpikes(Scan & scan, double excess)
{
  const auto spikes = FindSurfaceSpikes(scan.surface, scan.parts->GetWeldedPoints(), LongestSpike);
  if (spikes.empty())
  {
    return;
  }
  const auto longest = std::max_element(
    spikes.begin(), spikes.end(), [](const SurfaceSpike & a, const SurfaceSpike & b) { return a.length < b.length; });
  // Two of them, on either side, do not make it so wide: it is in another unit, and what seem to be mm are none.
  if (2.0 * longest->length < excess)
  {
    return;
  }
  const bool isOne = spikes.size() == 1;
  scan.Add(Suspect,
           "spikes",
           (isOne ? "a point stands " : std::to_string(spikes.size()) + " points stand up to ") +
             Number(longest->length) + " mm out of the scan, " + (isOne ? "by itself" : "each by itself") +
             ": a wrong number in the file, or what the scanner saw beside the teeth? Delete " +
             (isOne ? "it" : "them"),
           longest->length,
           LongestSpike,
           "mm");
}

/** Whether the scan is as large as a whole arch; returns how much wider than any it is, mm. */
double
CheckSize(Scan & scan, double millimetresPerUnit)
{
  const std::array<double, 3> lengths = PrincipalLengths(scan);
  if (lengths[0] >= NarrowestArch && lengths[0] <= WidestArch && lengths[1] < DepthOfPart &&
      lengths[1] < DepthShareOfPart * lengths[0])
  {
    scan.Add(Suspect,
             "partial-arch",
             "the scan is " + Number(lengths[0]) + " mm long and " + Number(lengths[1]) +
               " mm across: it shows a part of an arch, a quadrant perhaps; scan the whole arch",
             lengths[1],
             DepthOfPart,
             "mm");
    return 0.0;
  }
  double width = std::sqrt(lengths[0] * lengths[0] + lengths[1] * lengths[1] + lengths[2] * lengths[2]);
  if (scan.frame->valid)
  {
    const auto extent = scan.parts->ComputeExtent(scan.surface, scan.frame->axes[1]);
    width = extent.second - extent.first;
  }
  if (width >= NarrowestArch && width <= WidestArch)
  {
    return 0.0;
  }
  std::string text =
    "the arch is " + Number(width) + " mm wide, not " + Number(NarrowestArch) + " to " + Number(WidestArch);
  const double                                inFile = width / millimetresPerUnit;
  std::vector<std::pair<double, std::string>> fitting;
  for (const MeshUnit & unit : MeshUnits)
  {
    const double fitted = inFile * unit.millimetres;
    if (fitted >= NarrowestArch && fitted <= WidestArch)
    {
      fitting.emplace_back(std::abs(std::log(fitted / UsualArch)), unit.name);
    }
  }
  std::sort(fitting.begin(), fitting.end());
  for (std::size_t i = 0; i < fitting.size(); ++i)
  {
    text += (i == 0 ? "; \"mesh_unit\": \"" : ", or \"") + fitting[i].second + (i == 0 ? "\" would fit" : "\"");
  }
  scan.Add(Suspect, "arch-width", text, width, width < NarrowestArch ? NarrowestArch : WidestArch, "mm");
  return std::max(0.0, width - WidestArch);
}

/** Distances from points to the nearest vertex of a scan, mm, in one pass over it. */
std::vector<double>
DistancesToScan(const std::vector<std::pair<std::string, PointType>> & points, const MeshType * mesh)
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
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/** As many names as a sentence bears. */
constexpr std::size_t NamesSaid = 4;

/** Landmarks that lie away from their scan, one by one. */
void
CheckLandmarkDistances(Scan & scan, const std::vector<double> & distances)
{
  const double limit = ScanCheckFilter::MaximumLandmarkDistance;
  std::string  names;
  std::size_t  count = 0;
  double       largest = 0.0;
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    if (distances[i] > limit)
    {
      ++count;
      names += count > NamesSaid ? "" : (count == 1 ? "" : ", ") + scan.landmarks[i].first;
      largest = std::max(largest, distances[i]);
    }
  }
  if (count == 0)
  {
    return;
  }
  const double median = Median(distances);
  if (2 * count > distances.size() && median > limit)
  {
    scan.Add(Suspect,
             "landmarks-off-scan",
             "the 3-D landmarks are " + Number(median) +
               " mm away from the scan; are they in the scan's unit and frame, and is it the right scan?",
             median,
             limit,
             "mm");
    return;
  }
  names += count > NamesSaid ? " and " + std::to_string(count - NamesSaid) + " more" : "";
  scan.Add(Suspect,
           "landmarks-off-scan",
           "of the 3-D landmarks " + names + (count == 1 ? " lies " : " lie up to ") + Number(largest) +
             " mm off the scan and cannot be used: left at (0, 0, 0), or of another tooth or scan?",
           largest,
           limit,
           "mm");
}

/** What the names of landmarks say of the scans. */
enum class NamesEnum : uint8_t
{
  Nothing,
  InPlace,
  Exchanged
};

/** Whether a jaw's landmarks are vertices of the other's scan. Of a scan that lacks its other half half of them lie
 * off it, near to the jaw that it bites on: those that lie on it tell that it is theirs. */
bool
LieOnOtherScan(const Scan & scan, const std::vector<double> & toOwn, const Scan & other)
{
  const double ownMedian = Median(toOwn);
  if (!other.IsThere() || ownMedian <= OnTheScan)
  {
    return false;
  }
  const auto onOwn = std::count_if(toOwn.begin(), toOwn.end(), [](double distance) { return distance <= OnTheScan; });
  return Median(DistancesToScan(scan.landmarks, other.mesh)) < NearerByFactor * ownMedian &&
         static_cast<double>(onOwn) <= ShareOnOwnScan * static_cast<double>(toOwn.size());
}

NamesEnum
CheckNamesAgainstScans(std::array<Scan, 2> & scans)
{
  NamesEnum            told = NamesEnum::Nothing;
  std::vector<JawEnum> exchanged;
  double               otherMedian = 0.0;
  double               limit = 0.0;
  for (const Scan & scan : scans)
  {
    if (!scan.IsThere() || scan.landmarks.empty())
    {
      continue;
    }
    told = NamesEnum::InPlace;
    const Scan &              other = scans[ToIndex(OtherJaw(scan.jaw))];
    const std::vector<double> toOwn = DistancesToScan(scan.landmarks, scan.mesh);
    if (LieOnOtherScan(scan, toOwn, other))
    {
      exchanged.push_back(scan.jaw);
      otherMedian = Median(DistancesToScan(scan.landmarks, other.mesh));
      limit = NearerByFactor * Median(toOwn);
    }
  }
  if (!exchanged.empty())
  {
    const std::string text =
      std::string("upper and lower scan seem exchanged: the ") +
      (exchanged.size() == 2 ? "landmarks of each lie" : ToString(exchanged.front()) + std::string(" landmarks lie")) +
      " on the other scan";
    for (Scan & scan : scans)
    {
      scan.Add(Suspect, "jaws-exchanged", text, otherMedian, limit, "mm");
      // In the frame of a scan that is taken for the other jaw right is left: they say nothing of the sides.
      scan.landmarks.clear();
    }
    return NamesEnum::Exchanged;
  }
  for (Scan & scan : scans)
  {
    if (!scan.IsThere() || scan.landmarks.empty())
    {
      continue;
    }
    const std::vector<double> toOwn = DistancesToScan(scan.landmarks, scan.mesh);
    CheckLandmarkDistances(scan, toOwn);
    // What lies elsewhere says nothing of the sides.
    for (std::size_t i = toOwn.size(); i-- > 0;)
    {
      if (toOwn[i] > ScanCheckFilter::MaximumLandmarkDistance)
      {
        scan.unusable.push_back(scan.landmarks[i].first);
        scan.landmarks.erase(scan.landmarks.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }
  return told;
}

/** How far a landmark lies on the other side than its name says, mm. */
double
ComputeWrongSideOffset(const DentalJawFrame & frame, const std::pair<std::string, PointType> & landmark)
{
  double y = 0.0;
  for (unsigned int d = 0; d < 3; ++d)
  {
    y += frame.axes[1][d] * (landmark.second[d] - frame.origin[d]);
  }
  return DentalLandmarkSet<3>::ParseName(landmark.first).IsRight() ? y : -y;
}

/** Where the landmarks as a whole are on their sides, those that are not: they lie on the scan, but on another tooth.
 */
void
CheckSidesOneByOne(Scan & scan)
{
  if (scan.frame->confidence < UnsureAxis)
  {
    return;
  }
  std::string names;
  double      largest = 0.0;
  std::size_t count = 0;
  for (std::size_t i = scan.landmarks.size(); i-- > 0;)
  {
    const double offset = ComputeWrongSideOffset(*scan.frame, scan.landmarks[i]);
    if (offset > OneOnTheWrongSide)
    {
      ++count;
      names = scan.landmarks[i].first + (names.empty() ? "" : ", ") + names;
      largest = std::max(largest, offset);
      scan.unusable.push_back(scan.landmarks[i].first);
      scan.landmarks.erase(scan.landmarks.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  if (count > 0)
  {
    scan.Add(Suspect,
             "sides-exchanged",
             "of the 3-D landmarks " + names + (count == 1 ? " lies" : " lie") +
               " on the other side of the arch and cannot be used: of the other side's tooth?",
             largest,
             OneOnTheWrongSide,
             "mm");
  }
}

/** What lies on the scan and on its side, but at another tooth's place. */
void
CheckOrder(Scan & scan)
{
  if (scan.frame->confidence < UnsureAxis)
  {
    return;
  }
  LandmarkOrder::LandmarksType landmarks;
  for (const auto & landmark : scan.landmarks)
  {
    landmarks.emplace_back(landmark.first, landmark.second);
  }
  const LandmarkOrder order(*scan.frame, landmarks);
  const auto &        misplaced = order.GetMisplaced();
  if (misplaced.empty())
  {
    return;
  }
  std::string names;
  for (std::size_t i = 0; i < misplaced.size(); ++i)
  {
    names += i < NamesSaid ? (i == 0 ? "" : ", ") + landmarks[misplaced[i]].first : "";
    scan.unusable.push_back(landmarks[misplaced[i]].first);
  }
  names += misplaced.size() > NamesSaid ? " and " + std::to_string(misplaced.size() - NamesSaid) + " more" : "";
  for (std::size_t i = misplaced.size(); i-- > 0;)
  {
    scan.landmarks.erase(scan.landmarks.begin() + static_cast<std::ptrdiff_t>(misplaced[i]));
  }
  scan.Add(Suspect,
           "landmarks-order",
           "of the 3-D landmarks " + names + (misplaced.size() == 1 ? " does" : " do") +
             " not stand along the arch as the teeth do and cannot be used: of another tooth, or names exchanged?",
           order.GetLargest(),
           LandmarkOrder::MaximumOverlap,
           "mm");
}

void
CheckMirroring(Scan & scan)
{
  const DentalJawFrame & frame = *scan.frame;
  // A closed cast has no net normal: its winding says nothing.
  if (frame.openness > DentalJawFrame::OpennessOfClosedCast && frame.windingAgreement < InwardWinding)
  {
    scan.Add(Suspect,
             "inward-winding",
             "the surface is wound inward: the scan may be mirrored",
             frame.windingAgreement,
             InwardWinding,
             "");
  }
  double right = 0.0;
  double left = 0.0;
  int    rights = 0;
  int    lefts = 0;
  for (const auto & landmark : scan.landmarks)
  {
    const bool isRight = DentalLandmarkSet<3>::ParseName(landmark.first).IsRight();
    (isRight ? right : left) += ComputeWrongSideOffset(frame, landmark);
    ++(isRight ? rights : lefts);
  }
  const double rightOffset = rights > 0 ? right / rights : 0.0;
  const double leftOffset = lefts > 0 ? left / lefts : 0.0;
  const double wrong = std::max(rightOffset, leftOffset);
  if (wrong > WrongSideOffset)
  {
    scan.Add(Suspect,
             "sides-exchanged",
             "the landmarks named for one side lie on the other: the scan may be mirrored, or the names exchanged",
             wrong,
             WrongSideOffset,
             "mm");
    return;
  }
  CheckSidesOneByOne(scan);
  CheckOrder(scan);
}

/** One file named twice. */
bool
AreSame(const MeshType & a, const MeshType & b)
{
  if (a.GetNumberOfPoints() != b.GetNumberOfPoints())
  {
    return false;
  }
  for (auto i = a.GetPoints()->Begin(), j = b.GetPoints()->Begin(); i != a.GetPoints()->End(); ++i, ++j)
  {
    if (i.Value() != j.Value())
    {
      return false;
    }
  }
  return true;
}

/** What of two jaws' shapes is as if they were exchanged, for a person. */
std::string
SayWhatIsReversed(const JawExchangeEvidence & evidence)
{
  std::vector<std::string> parts;
  const auto               millimetres = [](double value) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::setprecision(2) << value << " mm ";
    return text.str();
  };
  if (evidence.GetMolarWidthDifference() && *evidence.GetMolarWidthDifference() < 0.0)
  {
    parts.push_back("is " + millimetres(-*evidence.GetMolarWidthDifference()) +
                    "narrower than the lower at the first molars");
  }
  if (evidence.GetOverjet() && *evidence.GetOverjet() < 0.0)
  {
    parts.push_back("lies " + millimetres(-*evidence.GetOverjet()) + "behind it in front");
  }
  if (evidence.GetIncisorContrastDifference() && *evidence.GetIncisorContrastDifference() < 0.0)
  {
    parts.emplace_back("has the narrower incisors");
  }
  std::string text = "the upper arch";
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    text += (i == 0 ? " " : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  }
  return text;
}

/** By shape alone. \return what of it could not be told; empty where the shapes said that the scans are exchanged, or
 * spoke for the names. */
std::string
CheckShapesForExchange(const DentalFrameResult & frames, std::array<Scan, 2> & scans)
{
  const JawExchangeEvidence evidence(frames, &scans[0].surface, &scans[1].surface);
  // One measure alone never tells.
  if (evidence.GetNumberOfMeasures() < 2)
  {
    return "no two jaws whose shapes could be compared";
  }
  if (evidence.GetProbability() <= ProbablyExchanged)
  {
    return evidence.GetLogLikelihoodRatio() < 0.0 ? "" : "the shapes of the jaws leave it open";
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "upper and lower scan may be exchanged (probability " << std::setprecision(2) << evidence.GetProbability()
       << "): " << SayWhatIsReversed(evidence);
  for (Scan & scan : scans)
  {
    scan.Add(Suspect, "jaws-exchanged", text.str(), evidence.GetProbability(), ProbablyExchanged, "");
  }
  return "";
}
} // namespace

bool
ScanCheckFilter::IsAlone(const LandmarksType & landmarks, const LandmarksType::LandmarkType & landmark)
{
  const auto & all = landmarks.GetLandmarks();
  return std::none_of(all.begin(), all.end(), [&](const LandmarksType::LandmarkType & other) {
    return other.name != landmark.name && other.tooth.GetJaw() == landmark.tooth.GetJaw() &&
           landmark.point.EuclideanDistanceTo(other.point) <= SamePlace;
  });
}

ScanCheckFilter::ScanCheckFilter()
{
  this->AddOptionalInputName("UpperMesh", 0);
  this->AddOptionalInputName("LowerMesh", 1);
  this->AddRequiredInputName("Frames", 2);
  this->AddOptionalInputName("Landmarks", 3);
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(0, this->MakeOutput(0));
  this->SetNthOutput(1, this->MakeOutput(1));
}

ScanCheckFilter::DataObjectPointer
ScanCheckFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return DecoratedFindingsType::New().GetPointer();
}

ScanCheckFilter::DecoratedFindingsType *
ScanCheckFilter::GetFindingsOutput(JawEnum jaw)
{
  return dynamic_cast<DecoratedFindingsType *>(this->ProcessObject::GetOutput(ToIndex(jaw)));
}

const ScanCheckFilter::FindingsType &
ScanCheckFilter::GetFindings(JawEnum jaw)
{
  return this->GetFindingsOutput(jaw)->Get();
}

void
ScanCheckFilter::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (this->GetUpperMesh() == nullptr && this->GetLowerMesh() == nullptr)
  {
    itkExceptionMacro("There is no scan. Call SetUpperMesh() or SetLowerMesh().");
  }
  if (!(m_MillimetresPerUnit > 0.0))
  {
    itkExceptionMacro("MillimetresPerUnit is " << m_MillimetresPerUnit
                                               << "; it must be positive. Call SetMillimetresPerUnit().");
  }
}

void
ScanCheckFilter::GenerateData()
{
  const DentalFrameResult & frames = this->GetFrames()->Get();
  std::array<Scan, 2>       scans;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    Scan & scan = scans[ToIndex(jaw)];
    scan.jaw = jaw;
    scan.mesh = jaw == JawEnum::Upper ? this->GetUpperMesh() : this->GetLowerMesh();
    scan.frame = &frames.GetJaw(jaw);
    if (!scan.IsThere())
    {
      continue;
    }
    scan.surface = MakeTriangleSurface(scan.mesh);
    scan.parts = std::make_unique<SurfaceParts>(scan.surface);
    if (!scan.frame->valid)
    {
      scan.Add(Failed, "no-arch", "the scan has no recognisable dental arch");
    }
    if (this->GetLandmarks() != nullptr)
    {
      std::string names;
      std::size_t count = 0;
      for (const auto & landmark : this->GetLandmarks()->GetLandmarks())
      {
        if (landmark.tooth.GetJaw() != jaw)
        {
          continue;
        }
        if (!IsAlone(*this->GetLandmarks(), landmark))
        {
          ++count;
          names += count > NamesSaid ? "" : (count == 1 ? "" : ", ") + landmark.name;
          scan.unusable.push_back(landmark.name);
        }
        else
        {
          scan.landmarks.emplace_back(landmark.name,
                                      PointType{ { landmark.point[0] * m_MillimetresPerUnit,
                                                   landmark.point[1] * m_MillimetresPerUnit,
                                                   landmark.point[2] * m_MillimetresPerUnit } });
        }
      }
      if (count > 0)
      {
        names += count > NamesSaid ? " and " + std::to_string(count - NamesSaid) + " more" : "";
        scan.Add(Suspect,
                 "landmarks-coincide",
                 "the 3-D landmarks " + names +
                   " lie at one and the same place and cannot be used: were they left at (0, 0, 0)?");
      }
    }
  }
  m_NotCheckable.clear();
  m_UnusableLandmarks.clear();
  if (scans[0].IsThere() && scans[1].IsThere() && AreSame(*scans[0].mesh, *scans[1].mesh))
  {
    for (Scan & scan : scans)
    {
      scan.Add(Failed, "same-scan", "upper and lower scan are the same; name the scan of each jaw");
    }
  }
  const NamesEnum names = CheckNamesAgainstScans(scans);
  // Names that say so need no shapes beside them.
  const std::string open = names != NamesEnum::Exchanged ? CheckShapesForExchange(frames, scans) : "";
  if (names == NamesEnum::Nothing && !open.empty())
  {
    m_NotCheckable.push_back("whether upper and lower scan were exchanged: there are no 3-D landmarks, and " + open);
  }
  for (Scan & scan : scans)
  {
    if (scan.IsThere())
    {
      CheckBothJaws(scan);
      CheckSpikes(scan, CheckSize(scan, m_MillimetresPerUnit));
    }
    if (scan.IsThere() && scan.frame->valid)
    {
      CheckMirroring(scan);
      if (scan.frame->confidence < UnsureAxis)
      {
        std::ostringstream text;
        text.imbue(std::locale::classic());
        text << "the dental axis is unsure (confidence " << std::setprecision(2) << scan.frame->confidence << ")";
        scan.Add(Suspect, "unsure-axis", text.str(), scan.frame->confidence, UnsureAxis, "");
      }
      if (scan.frame->openness <= DentalJawFrame::OpennessOfClosedCast)
      {
        m_NotCheckable.push_back(std::string("whether the ") + ToString(scan.jaw) +
                                 " cast was mirrored: a closed body's winding looks the same either way");
      }
    }
    m_UnusableLandmarks.insert(m_UnusableLandmarks.end(), scan.unusable.begin(), scan.unusable.end());
    SortFindings(scan.findings);
    this->GetFindingsOutput(scan.jaw)->Set(scan.IsThere() ? scan.findings : FindingsType());
  }
}

void
ScanCheckFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MillimetresPerUnit: " << m_MillimetresPerUnit << std::endl;
  os << indent << "UnusableLandmarks: " << m_UnusableLandmarks.size() << std::endl;
  os << indent << "NotCheckable: " << m_NotCheckable.size() << std::endl;
}
} // namespace itk

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
#include "itkToothFinder.h"

#include "itkKeepTriangles.h"
#include "itkMakeTriangleSurface.h"
#include "itkScanCheckFilter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace itk
{
namespace
{
using FeatureEnum = ToothFinder::FeatureEnum;

// Errors of counterparts, mm, along the occlusal plane and across it.
/** A scan's landmark is a click on a cusp. */
constexpr double ClickSigma = 0.2;
/** The highest labelled point of a tooth's part is its cusp or near it; worn ones have none. */
constexpr double LabelSigmaAlong = 0.6;
constexpr double LabelSigmaAcross = 0.4;
/** The arch's front is an incisal edge whose middle may be another tooth's; canines and premolars stand in between. */
constexpr double EdgeSigmaAlong = 0.6;
constexpr double EdgeSigmaAcross = 0.5;
/** Teeth are some 7 % wider or narrower than the textbook's, all of a mouth alike: 2 mm at the first molar; gaps and
 * crowding move it as well. */
constexpr double ArchSigmaAlong = 2.2;
constexpr double ArchSigmaAcross = 0.7;
// A tooth that was traced is the right one.
/** mm along the row: how far all cusps of a traced row may be from where they are expected on their lines, by the pose
 * and by the hand. */
constexpr double LineSigma = 1.5;
/** Of one cusp beside the others, and how far off one counts as missing. */
constexpr double CuspSigma = 1.0;
constexpr double MissingCusp = 2.0;
/** Against a tooth without the cusp that was marked, in squared standard deviations. */
constexpr double WithoutCusp = 4.0;
/** What is left of the place along the row. */
constexpr double TracedSigmaAlong = 0.6;
/** Teeth of the other side stand as far along the arch, but for what arches are asymmetric, and midlines off. */
constexpr double OtherSideSigma = 1.5;
/** Half the distance of the two sides' images along a bisected row: a degree and a half of yaw are 0.6 mm of it, and
 * the rest is asymmetry. */
constexpr double HalfDistanceOfSidesSigma = 2.5;
/** No cusp is further from its place than so many standard deviations. */
constexpr double ReachInSigmas = 4.0;
/** mm to either side within which cusps are looked for: half a molar and its neighbours' nearest cusps. */
constexpr double PatternReach = 12.0;
/** As a share of a bisected line's extent: a middle is no further from its place. */
constexpr double       ReachShare = 0.3;
constexpr unsigned int FirstPremolar = 4;
/** Edges and cusps are not lower than this below the highest point near them, mm; gingiva and palate are. */
constexpr double CuspRange = 2.5;
/** A contact derived from the cusps, and the middle of an occlusal surface. */
constexpr double DerivedSigmaAlong = 0.6;
constexpr double DerivedSigmaAcross = 0.8;
/** A molar's point of which nobody said which lies between the mesial contact and the middle of the surface. */
constexpr double UnspecifiedSigmaAlong = 2.0;
constexpr double UnspecifiedSigmaAcross = 0.8;
/** Distances of a first molar's points, mm: mesiobuccal cusp to the mesial contact, along and down; cusps to the floor
 * of the occlusal surface. */
constexpr double CuspToContact = 2.4;
constexpr double ContactBelowCusp = 2.5;
constexpr double FloorBelowCusps = 1.5;

// How a crown is cut out of a scan without labels.
/** Triangles below which it is no crown but a scrap. */
constexpr std::size_t MinimumCrownTriangles = 20;
/** mm along the arch: labels end within a point of the contact. */
constexpr double LabelledCrownSigma = 0.2;
/** mm at either end: teeth are 7 % wider or narrower than the textbook's, and crowded or spaced. */
constexpr double CutWidthSigma = 0.8;
/** mm along the arch, of the cut itself: a tooth's cusps are not quite where a textbook has them on it. */
constexpr double CutSigma = 0.4;
/** mm from the arch's curve across it: half a crown. Palate and cheek lie further off. */
constexpr double FrontCutReach = 8.0;
constexpr double MolarCutReach = 7.0;
/** Of an incisor's width to either side: seen from the side its profile is that of its middle, while a wider cut has
 * its neighbours' edges before and below it. */
constexpr double ProfileShare = 0.3;
/** mm from its highest point: about as much of a crown as gingiva leaves free. */
constexpr double FrontCutHeight = 7.0;
constexpr double BackCutHeight = 5.0;
/** A lower first molar has a third buccal cusp, the distal one, behind the other two, whose middle lies this share of
 * the width before the tooth's (Wheeler's dental anatomy: tips some 2.8, 6.7 and 9.5 mm from the mesial end of 11). */
constexpr double FiveCuspShare = 0.08;
/** On the error of a place after textbook widths: teeth of a mouth are wide or narrow in both jaws alike, and a
 * landmark of the same tooth is looked for at the same place, so that four measurements tell no more than one: each
 * counts a quarter.
 */
constexpr double TextbookFactor = 2.0;
/** Buccal cusps lie this share of a molar's width before and behind its middle. */
constexpr double BuccalCuspShare = 0.24;

const char *
SuffixOf(FeatureEnum feature, unsigned int position)
{
  switch (feature)
  {
    case FeatureEnum::Tip:
      return "tip";
    case FeatureEnum::Cusp:
      return position == 3 ? "cusp" : "B";
    case FeatureEnum::MesiobuccalCusp:
      return "MB";
    case FeatureEnum::DistobuccalCusp:
      return "DB";
    case FeatureEnum::MesiolingualCusp:
      return "ML";
    default:
      return "DL";
  }
}

void
Widen(std::optional<ToothFinder::PlaceType> & place, double along, double across)
{
  if (place)
  {
    place->sigmaAlong = std::hypot(place->sigmaAlong, along);
    place->sigmaAcross = std::hypot(place->sigmaAcross, across);
  }
}

/** How far a feature lies from the tooth's middle toward the back, in widths of the tooth. */
double
ShareBehindMiddle(FeatureEnum feature)
{
  return feature == FeatureEnum::MesiobuccalCusp || feature == FeatureEnum::MesiolingualCusp   ? -BuccalCuspShare
         : feature == FeatureEnum::DistobuccalCusp || feature == FeatureEnum::DistolingualCusp ? BuccalCuspShare
                                                                                               : 0.0;
}

bool
IsBuccal(FeatureEnum feature)
{
  return feature == FeatureEnum::MesiobuccalCusp || feature == FeatureEnum::DistobuccalCusp ||
         feature == FeatureEnum::Cusp;
}

/** Where the buccal cusps of a premolar or molar are, in widths from its middle toward the back. */
std::vector<double>
BuccalCuspShares(const ToothCode & tooth)
{
  if (tooth.GetPosition() < 6)
  {
    return { 0.0 };
  }
  const bool five = tooth.GetJaw() == ToothCode::JawEnum::Lower && tooth.GetPosition() == 6;
  return { -BuccalCuspShare, five ? BuccalCuspShare - 2.0 * FiveCuspShare : BuccalCuspShare };
}
} // namespace

ToothFinder::ToothFinder(const MeshType *          mesh,
                         const FrameType *         frame,
                         const LabelsType &        labels,
                         const ScanLandmarksType * landmarks,
                         double                    millimetresPerUnit,
                         JawEnum                   jaw)
  : m_Mesh(mesh)
  , m_Frame(frame)
  , m_Labels(labels)
  , m_Landmarks(landmarks)
  , m_MillimetresPerUnit(millimetresPerUnit)
  , m_Jaw(jaw)
{}

std::optional<ToothFinder::PlaceType>
ToothFinder::Find(const ToothCode & tooth, FeatureEnum feature)
{
  if (feature == FeatureEnum::Unspecified)
  {
    std::optional<PlaceType> place = this->Find(tooth, FeatureEnum::MesiobuccalCusp);
    Widen(place, UnspecifiedSigmaAlong, UnspecifiedSigmaAcross);
    return place;
  }
  if (feature == FeatureEnum::MesialContact || feature == FeatureEnum::OcclusalMiddle)
  {
    return this->FindDerived(tooth, feature);
  }
  if (const auto clicked = this->FindClicked(tooth, feature))
  {
    return PlaceType{ *clicked, ClickSigma, ClickSigma, "landmarks_3d" };
  }
  if (auto labelled = this->FindLabelled(tooth, feature))
  {
    return labelled;
  }
  if (this->IsAbsent(tooth))
  {
    return {};
  }
  if (auto traced = this->FindTraced(tooth, feature))
  {
    return traced;
  }
  return this->FindAlongArch(tooth, feature);
}

bool
ToothFinder::IsAbsent(const ToothCode & tooth) const
{
  // Of the whole scan: one of other points has labels that are not used.
  const bool labelled = m_Mesh != nullptr && m_Labels.size() == m_Mesh->GetNumberOfPoints() &&
                        std::any_of(m_Labels.begin(), m_Labels.end(), [](std::uint8_t label) { return label != 0; });
  if (labelled && std::find(m_Labels.begin(), m_Labels.end(), tooth.GetFDI()) == m_Labels.end())
  {
    return true;
  }
  // Behind the last tooth there is no neighbour, nor behind a milk molar one of its kind.
  if (m_Landmarks == nullptr || tooth.IsPrimary() || tooth.GetPosition() > 7)
  {
    return false;
  }
  const auto isNamed = [this](const ToothCode & other) {
    const auto & all = m_Landmarks->GetLandmarks();
    return std::any_of(all.begin(), all.end(), [&](const auto & landmark) { return landmark.tooth == other; });
  };
  const ToothCode mesial = tooth.GetPosition() > 1 ? ToothCode(tooth.GetFDI() - 1) : tooth.GetContralateral();
  const ToothCode distal(tooth.GetFDI() + 1u);
  return !isNamed(tooth) && isNamed(mesial) && isNamed(distal);
}

std::optional<ToothFinder::PointType>
ToothFinder::FindClicked(const ToothCode & tooth, FeatureEnum feature) const
{
  if (m_Landmarks == nullptr)
  {
    return {};
  }
  const auto * landmark = m_Landmarks->Find(tooth.GetName() + '_' + SuffixOf(feature, tooth.GetPosition()));
  if (landmark == nullptr || !ScanCheckFilter::IsAlone(*m_Landmarks, *landmark) ||
      std::find(m_UnusableLandmarks.begin(), m_UnusableLandmarks.end(), landmark->name) != m_UnusableLandmarks.end())
  {
    return {};
  }
  PointType point;
  for (unsigned int d = 0; d < 3; ++d)
  {
    point[d] = landmark->point[d] * m_MillimetresPerUnit;
  }
  return this->IsOnScan(point) ? std::optional<PointType>(point) : std::nullopt;
}

bool
ToothFinder::IsOnScan(const PointType & point) const
{
  // Without a scan there is nothing to be off.
  if (m_Mesh == nullptr || m_Mesh->GetNumberOfPoints() == 0)
  {
    return true;
  }
  constexpr double limit = ScanCheckFilter::MaximumLandmarkDistance * ScanCheckFilter::MaximumLandmarkDistance;
  for (const auto & vertex : m_Mesh->GetPoints()->CastToSTLConstContainer())
  {
    double squared = 0.0;
    for (unsigned int d = 0; d < 3; ++d)
    {
      squared += (point[d] - vertex[d]) * (point[d] - vertex[d]);
    }
    if (squared <= limit)
    {
      return true;
    }
  }
  return false;
}

ToothFinder::PointType
ToothFinder::Below(const PointType & point, double distance) const
{
  if (m_Frame == nullptr)
  {
    return point;
  }
  PointType place = m_Frame->TransformPoint(point);
  place[2] += m_Jaw == JawEnum::Upper ? distance : -distance;
  return m_Frame->GetInverseTransform()->TransformPoint(place);
}

std::optional<ToothFinder::PlaceType>
ToothFinder::FindDerived(const ToothCode & tooth, FeatureEnum feature)
{
  std::optional<PlaceType> front = this->Find(tooth, FeatureEnum::MesiobuccalCusp);
  if (!front || tooth.GetPosition() < 6)
  {
    return {};
  }
  const std::optional<PlaceType> back = this->Find(tooth, FeatureEnum::DistobuccalCusp);
  const auto                     along = back ? front->point - back->point : PointType::VectorType();
  const double                   length = back ? along.GetNorm() : 0.0;
  if (feature == FeatureEnum::MesialContact)
  {
    if (length > 1.0)
    {
      front->point += along * (CuspToContact / length);
    }
    front->point = this->Below(front->point, ContactBelowCusp);
    Widen(front, length > 1.0 ? DerivedSigmaAlong : CuspToContact, DerivedSigmaAcross);
    return front;
  }
  if (length > 1.0)
  {
    front->point -= along * 0.5;
  }
  front->point = this->Below(front->point, FloorBelowCusps);
  Widen(front, length > 1.0 ? DerivedSigmaAlong : UnspecifiedSigmaAlong, DerivedSigmaAcross);
  return front;
}

void
ToothFinder::Prepare()
{
  if (m_Surface || m_Mesh == nullptr || m_Frame == nullptr)
  {
    return;
  }
  m_Surface = std::make_unique<TriangleSurface>(MakeTriangleSurface(m_Mesh));
  for (auto & p : m_Surface->points)
  {
    PointType point;
    for (unsigned int d = 0; d < 3; ++d)
    {
      point[d] = p[d];
    }
    point = m_Frame->TransformPoint(point);
    for (unsigned int d = 0; d < 3; ++d)
    {
      p[d] = static_cast<float>(point[d]);
    }
  }
  m_Arch = PoseArch(*m_Surface, m_Jaw);
}

double
ToothFinder::Height(std::size_t i) const
{
  return m_Jaw == JawEnum::Upper ? -m_Surface->points[i][2] : m_Surface->points[i][2];
}

ToothFinder::PointType
ToothFinder::ToMesh(std::size_t i) const
{
  PointType point;
  for (unsigned int d = 0; d < 3; ++d)
  {
    point[d] = m_Surface->points[i][d];
  }
  return m_Frame->GetInverseTransform()->TransformPoint(point);
}

std::optional<ToothFinder::PlaceType>
ToothFinder::FindLabelled(const ToothCode & tooth, FeatureEnum feature)
{
  if (m_Labels.empty())
  {
    return {};
  }
  this->Prepare();
  if (!m_Surface || !m_Arch.IsValid() || m_Labels.size() != m_Surface->points.size())
  {
    return {};
  }
  std::vector<std::size_t> points;
  std::vector<double>      arcs;
  for (std::size_t i = 0; i < m_Labels.size(); ++i)
  {
    if (m_Labels[i] == tooth.GetFDI())
    {
      points.push_back(i);
      arcs.push_back(this->ArcOf(i));
    }
  }
  if (points.size() < 10)
  {
    return {};
  }
  const auto   range = std::minmax_element(arcs.begin(), arcs.end());
  const double middle = 0.5 * (*range.first + *range.second);
  const double width = *range.second - *range.first;
  const double share = ShareBehindMiddle(feature);
  return this->FindPeak(points, middle + share * width, feature, LabelSigmaAlong, LabelSigmaAcross, "tooth labels");
}

double
ToothFinder::ToRow(std::size_t i) const
{
  const auto pixel = m_Tracing->project(this->ToMesh(i));
  return m_Tracing->row.ToRow(pixel[0], pixel[1]);
}

template <typename TFunction>
std::vector<std::size_t>
ToothFinder::CollectPoints(const ToothCode & tooth, double low, double high, const TFunction & placeOf) const
{
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < m_Surface->points.size(); ++i)
  {
    // Right is the side of negative y.
    if ((m_Surface->points[i][1] < 0.0F) == tooth.IsRight())
    {
      const double place = placeOf(i);
      if (place > low && place < high)
      {
        points.push_back(i);
      }
    }
  }
  return points;
}

template <typename TFunction>
std::vector<std::size_t>
ToothFinder::CollectRowPoints(const ToothCode & tooth, double low, double high, const TFunction & placeOf) const
{
  auto points = this->CollectPoints(tooth, low, high, placeOf);
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [this](std::size_t i) {
                                const auto & p = m_Surface->points[i];
                                return std::abs(m_Arch.Offset(p[0], p[1])) > MolarCutReach;
                              }),
               points.end());
  return points;
}

double
ToothFinder::RowPatternType::Match(const std::vector<double> & places, double shift) const
{
  double cost = 0.0;
  for (const double cusp : cusps)
  {
    double nearest = MissingCusp;
    for (const double place : places)
    {
      nearest = std::min(nearest, std::abs(place - cusp - shift));
    }
    cost += nearest * nearest / (CuspSigma * CuspSigma);
  }
  return cost;
}

template <typename TFunction>
std::optional<ToothFinder::PlaceType>
ToothFinder::FindByPattern(const std::vector<std::size_t> & points,
                           const RowPatternType &           pattern,
                           FeatureEnum                      feature,
                           const TFunction &                placeOf,
                           double                           sigmaAlong,
                           const char *                     source) const
{
  const auto          peaks = this->CollectPeaks(points, feature);
  std::vector<double> places;
  for (const std::size_t peak : peaks)
  {
    places.push_back(placeOf(peak));
  }
  // What speaks against the pattern being moved by so much, in squared standard deviations.
  const auto costOf = [&](double shift) {
    return shift * shift / (pattern.sigma * pattern.sigma) + pattern.Match(places, shift);
  };
  std::vector<double>        costs;
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    costs.push_back(costOf(places[k] - pattern.target));
    if (std::abs(places[k] - pattern.target) < ReachInSigmas * pattern.sigma && (!best || costs[k] < costs[*best]))
    {
      best = k;
    }
  }
  if (best && costs[*best] < costOf(0.0) + WithoutCusp)
  {
    double sum = 0.0;
    double moment = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      const double weight = std::exp(0.5 * (costs[*best] - costs[k]));
      sum += weight;
      moment += weight * (places[k] - places[*best]) * (places[k] - places[*best]);
    }
    return PlaceType{
      this->ToMesh(peaks[*best]), std::hypot(sigmaAlong, std::sqrt(moment / sum)), LabelSigmaAcross, source
    };
  }
  const bool lingual = feature == FeatureEnum::MesiolingualCusp || feature == FeatureEnum::DistolingualCusp;
  std::optional<std::size_t> highest;
  for (const std::size_t i : points)
  {
    const auto & p = m_Surface->points[i];
    if (std::abs(placeOf(i) - pattern.target) < CuspSigma && (m_Arch.Offset(p[0], p[1]) < 0.0) == lingual &&
        (!highest || this->Height(i) > this->Height(*highest)))
    {
      highest = i;
    }
  }
  return highest ? std::optional<PlaceType>(PlaceType{
                     this->ToMesh(*highest), std::hypot(sigmaAlong, pattern.sigma), ArchSigmaAcross, source })
                 : std::nullopt;
}

std::optional<TracedToothRow::SpanType>
ToothFinder::FindLine(const ToothCode & tooth) const
{
  if (!m_Tracing->bisected)
  {
    return m_Tracing->row.FindWithin(tooth);
  }
  const auto * line = m_Tracing->row.FindPosition(tooth.GetPosition());
  return line != nullptr ? std::optional<TracedToothRow::SpanType>(*line) : std::nullopt;
}

std::optional<ToothFinder::RowPatternType>
ToothFinder::MakeLinePattern(const ToothCode & tooth, FeatureEnum feature) const
{
  const auto line = this->FindLine(tooth);
  if (!line)
  {
    return {};
  }
  const TracedToothRow & row = m_Tracing->row;
  RowPatternType         pattern;
  pattern.pixelsPerMillimetre = line->GetExtent() / PoseArch::ExpectedWidth(tooth.GetFDI());
  pattern.target = row.GetPlace(*line, ShareBehindMiddle(feature)) / pattern.pixelsPerMillimetre;
  pattern.sigma = LineSigma;
  if (!IsBuccal(feature))
  {
    pattern.cusps = { pattern.target };
    return pattern;
  }
  for (const int step : { -1, 0, 1 })
  {
    const ToothCode other(static_cast<std::uint8_t>(tooth.GetFDI() + step));
    const auto      span = other.GetPosition() < FirstPremolar ? std::nullopt : this->FindLine(other);
    for (const double share : span ? BuccalCuspShares(other) : std::vector<double>())
    {
      pattern.cusps.push_back(row.GetPlace(*span, share) / pattern.pixelsPerMillimetre);
    }
  }
  return pattern;
}

std::optional<ToothFinder::PlaceType>
ToothFinder::FindOnLine(const ToothCode & tooth, FeatureEnum feature) const
{
  const auto pattern = this->MakeLinePattern(tooth, feature);
  if (!pattern)
  {
    return {};
  }
  const auto placeOf = [&](std::size_t i) { return this->ToRow(i) / pattern->pixelsPerMillimetre; };
  return this->FindByPattern(
    this->CollectRowPoints(tooth, pattern->target - PatternReach, pattern->target + PatternReach, placeOf),
    *pattern,
    feature,
    placeOf,
    TracedSigmaAlong,
    "the traced tooth");
}

std::optional<ToothFinder::PlaceType>
ToothFinder::FindBesideFellow(const ToothCode & tooth, FeatureEnum feature) const
{
  const ToothCode fellow = tooth.GetContralateral();
  const auto      place = this->FindOnLine(fellow, feature);
  if (!place)
  {
    return {};
  }
  const auto     placeOf = [this](std::size_t i) { return this->ArcOf(i); };
  RowPatternType pattern;
  pattern.target = std::abs(this->Arc(place->point));
  pattern.sigma = OtherSideSigma;
  const double low = pattern.target - PatternReach;
  const double high = pattern.target + PatternReach;
  for (const std::size_t peak : this->CollectPeaks(this->CollectRowPoints(fellow, low, high, placeOf), feature))
  {
    pattern.cusps.push_back(this->ArcOf(peak));
  }
  return this->FindByPattern(this->CollectRowPoints(tooth, low, high, placeOf),
                             pattern,
                             feature,
                             placeOf,
                             place->sigmaAlong,
                             "its place on the other side");
}

std::optional<ToothFinder::PlaceType>
ToothFinder::FindOnBisectedLine(const ToothCode & tooth, FeatureEnum feature) const
{
  const auto pattern = this->MakeLinePattern(tooth, feature);
  if (!pattern)
  {
    return {};
  }
  const auto               placeOf = [&](std::size_t i) { return this->ToRow(i) / pattern->pixelsPerMillimetre; };
  std::vector<std::size_t> peaks[2];
  std::vector<double>      places[2];
  std::vector<double>      matches[2];
  for (unsigned int side = 0; side < 2; ++side)
  {
    const ToothCode of = side == 0 ? tooth : tooth.GetContralateral();
    peaks[side] = this->CollectPeaks(
      this->CollectRowPoints(of, pattern->target - PatternReach, pattern->target + PatternReach, placeOf), feature);
    for (const std::size_t peak : peaks[side])
    {
      places[side].push_back(placeOf(peak));
    }
    for (const double place : places[side])
    {
      matches[side].push_back(pattern->Match(places[side], place - pattern->target));
    }
  }
  struct PairType
  {
    std::size_t own;
    double      middle;
    double      cost;
  };
  std::vector<PairType> pairs;
  for (std::size_t i = 0; i < places[0].size(); ++i)
  {
    for (std::size_t k = 0; k < places[1].size(); ++k)
    {
      const double middle = 0.5 * (places[0][i] + places[1][k]);
      const double off = (middle - pattern->target) / LineSigma;
      const double apart = 0.5 * (places[0][i] - places[1][k]) / HalfDistanceOfSidesSigma;
      if (std::abs(off) < ReachInSigmas)
      {
        pairs.push_back({ peaks[0][i], middle, off * off + apart * apart + matches[0][i] + matches[1][k] });
      }
    }
  }
  const auto best = std::min_element(
    pairs.begin(), pairs.end(), [](const PairType & a, const PairType & b) { return a.cost < b.cost; });
  if (best == pairs.end())
  {
    return {};
  }
  double sum = 0.0;
  double moment = 0.0;
  for (const PairType & pair : pairs)
  {
    const double weight = std::exp(0.5 * (best->cost - pair.cost));
    sum += weight;
    moment += weight * (pair.middle - best->middle) * (pair.middle - best->middle);
  }
  return PlaceType{
    this->ToMesh(best->own), std::hypot(TracedSigmaAlong, std::sqrt(moment / sum)), LabelSigmaAcross, "the traced tooth"
  };
}

std::optional<ToothFinder::PlaceType>
ToothFinder::FindTraced(const ToothCode & tooth, FeatureEnum feature)
{
  if (!m_Tracing || tooth.IsPrimary() || tooth.GetPosition() < FirstPremolar ||
      !(PoseArch::ExpectedWidth(tooth.GetFDI()) > 0.0))
  {
    return {};
  }
  this->Prepare();
  if (!m_Surface || !m_Arch.IsValid())
  {
    return {};
  }
  if (m_Tracing->bisected)
  {
    return this->FindOnBisectedLine(tooth, feature);
  }
  return m_Tracing->row.FindWithin(tooth) ? this->FindOnLine(tooth, feature) : this->FindBesideFellow(tooth, feature);
}

std::optional<ToothFinder::PlaceType>
ToothFinder::FindAlongArch(const ToothCode & tooth, FeatureEnum feature)
{
  this->Prepare();
  if (!m_Surface || !m_Arch.IsValid() || tooth.GetPosition() > 7)
  {
    return {};
  }
  const double width = PoseArch::ExpectedWidth(tooth.GetFDI());
  if (!(width > 0.0))
  {
    return {};
  }
  const double target =
    PoseArch::CurveShare * (PoseArch::ExpectedArc(tooth.GetFDI()) + ShareBehindMiddle(feature) * width);
  const double reach = (feature == FeatureEnum::Tip ? 0.25 : 0.5) * width;
  const auto   points =
    this->CollectPoints(tooth, target - reach, target + reach, [this](std::size_t i) { return this->ArcOf(i); });
  const bool incisor = tooth.GetPosition() == 1;
  return this->FindPeak(points,
                        target,
                        feature,
                        incisor ? EdgeSigmaAlong : ArchSigmaAlong * target / 36.0,
                        incisor ? EdgeSigmaAcross : ArchSigmaAcross,
                        "its place along the arch");
}

std::vector<std::size_t>
ToothFinder::CollectPeaks(const std::vector<std::size_t> & points, FeatureEnum feature) const
{
  // Half the distance of two cusps.
  constexpr double         neighbourhood = 1.7;
  std::vector<std::size_t> order = points;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double first = this->Height(a);
    const double second = this->Height(b);
    return first > second || (first == second && a < b);
  });
  const bool buccal = IsBuccal(feature);
  const bool lingual = feature == FeatureEnum::MesiolingualCusp || feature == FeatureEnum::DistolingualCusp;
  std::vector<std::size_t> peaks;
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    const auto & p = m_Surface->points[order[k]];
    if (this->Height(order[k]) < this->Height(order.front()) - CuspRange)
    {
      break;
    }
    const bool isPeak =
      std::none_of(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(k), [&](std::size_t other) {
        const auto & q = m_Surface->points[other];
        return std::hypot(q[0] - p[0], q[1] - p[1]) < neighbourhood;
      });
    if (!isPeak)
    {
      continue;
    }
    // Of an incisor's edge the highest is meant, whatever its place.
    if (feature == FeatureEnum::Tip)
    {
      return { order[k] };
    }
    const double offset = m_Arch.Offset(p[0], p[1]);
    if (!(buccal && offset < 0.0) && !(lingual && offset > 0.0))
    {
      peaks.push_back(order[k]);
    }
  }
  return peaks;
}

std::optional<ToothFinder::PlaceType>
ToothFinder::FindPeak(const std::vector<std::size_t> & points,
                      double                           target,
                      FeatureEnum                      feature,
                      double                           sigmaAlong,
                      double                           sigmaAcross,
                      const char *                     source) const
{
  const auto peaks = this->CollectPeaks(points, feature);
  const auto best = std::min_element(peaks.begin(), peaks.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(this->ArcOf(a) - target) < std::abs(this->ArcOf(b) - target);
  });
  if (best == peaks.end())
  {
    return {};
  }
  return PlaceType{ this->ToMesh(*best), sigmaAlong, sigmaAcross, source };
}

double
ToothFinder::ArcOf(std::size_t i) const
{
  return std::abs(m_Arch.Arc(m_Surface->points[i][0], m_Surface->points[i][1]));
}

double
ToothFinder::Arc(const PointType & meshPoint) const
{
  const PointType p = m_Frame->TransformPoint(meshPoint);
  return m_Arch.Arc(p[0], p[1]);
}

std::shared_ptr<const TriangleSurface>
ToothFinder::CutOut(const std::vector<std::uint8_t> & pointMarks) const
{
  std::vector<std::uint8_t> marks(m_Surface->triangles.size(), 0);
  for (std::size_t t = 0; t < marks.size(); ++t)
  {
    const auto & corners = m_Surface->triangles[t];
    marks[t] = pointMarks[corners[0]] != 0 && pointMarks[corners[1]] != 0 && pointMarks[corners[2]] != 0 ? 1 : 0;
  }
  auto       crown = std::make_shared<TriangleSurface>(KeepTriangles(*m_Surface, marks));
  const auto toMesh = m_Frame->GetInverseTransform();
  for (auto & p : crown->points)
  {
    PointType point;
    std::copy(p.begin(), p.end(), point.Begin());
    point = toMesh->TransformPoint(point);
    std::copy(point.Begin(), point.End(), p.begin());
  }
  return crown;
}

std::optional<ToothCrownSet::CrownType>
ToothFinder::FindCrown(const ToothCode & tooth)
{
  this->Prepare();
  if (!m_Surface || !m_Arch.IsValid())
  {
    return {};
  }
  if (m_Labels.size() == m_Surface->points.size())
  {
    std::vector<std::uint8_t> marks(m_Labels.size(), 0);
    for (std::size_t i = 0; i < m_Labels.size(); ++i)
    {
      marks[i] = m_Labels[i] == tooth.GetFDI() ? 1 : 0;
    }
    auto crown = this->CutOut(marks);
    if (crown->triangles.size() >= MinimumCrownTriangles)
    {
      return ToothCrownSet::CrownType{
        tooth, std::move(crown), LabelledCrownSigma, LabelledCrownSigma, "tooth labels"
      };
    }
  }
  return this->IsAbsent(tooth) ? std::nullopt : this->CutAlongArch(tooth);
}

std::optional<ToothCrownSet::CrownType>
ToothFinder::CutAlongArch(const ToothCode & tooth)
{
  const double width = PoseArch::ExpectedWidth(tooth.GetFDI());
  if (!(width > 0.0))
  {
    return {};
  }
  const bool               molar = tooth.GetPosition() >= 6;
  const FeatureEnum        feature = molar                      ? FeatureEnum::MesiobuccalCusp
                                     : tooth.GetPosition() <= 2 ? FeatureEnum::Tip
                                                                : FeatureEnum::Cusp;
  std::optional<PlaceType> front = this->Find(tooth, feature);
  if (!front)
  {
    return {};
  }
  double middle = std::abs(this->Arc(front->point));
  double sigma = front->sigmaAlong;
  if (molar)
  {
    const std::optional<PlaceType> back = this->Find(tooth, FeatureEnum::DistobuccalCusp);
    if (back && std::abs(this->Arc(back->point)) > middle)
    {
      middle = 0.5 * (middle + std::abs(this->Arc(back->point)));
      if (m_Jaw == JawEnum::Lower && tooth.GetPosition() == 6 && m_Landmarks != nullptr &&
          this->FindClicked(tooth, FeatureEnum::DistobuccalCusp))
      {
        middle += FiveCuspShare * width;
      }
      sigma = std::max(sigma, back->sigmaAlong);
    }
    else
    {
      middle += BuccalCuspShare * width;
      sigma = std::hypot(sigma, DerivedSigmaAlong);
    }
  }
  if (m_Landmarks == nullptr || !this->FindClicked(tooth, feature))
  {
    sigma *= TextbookFactor;
  }
  const double              reach = molar ? MolarCutReach : FrontCutReach;
  double                    top = -1e300;
  std::vector<std::uint8_t> marks(m_Surface->points.size(), 0);
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    const auto & p = m_Surface->points[i];
    // Right is the side of negative y.
    if ((p[1] < 0.0) == tooth.IsRight() && std::abs(std::abs(m_Arch.Arc(p[0], p[1])) - middle) < 0.5 * width &&
        std::abs(m_Arch.Offset(p[0], p[1])) < reach)
    {
      marks[i] = 1;
      top = std::max(top, this->Height(i));
    }
  }
  const double height = molar || tooth.GetPosition() > 3 ? BackCutHeight : FrontCutHeight;
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    if (this->Height(i) < top - height)
    {
      marks[i] = 0;
    }
  }
  auto crown = this->CutOut(marks);
  if (crown->triangles.size() < MinimumCrownTriangles)
  {
    return {};
  }
  ToothCrownSet::CrownType found;
  found.tooth = tooth;
  found.surface = std::move(crown);
  found.sigmaAlong = std::hypot(sigma, CutSigma);
  found.sigmaWidth = CutWidthSigma;
  found.source = front->source;
  if (tooth.GetPosition() <= 2)
  {
    for (std::size_t i = 0; i < marks.size(); ++i)
    {
      const auto & p = m_Surface->points[i];
      if (std::abs(std::abs(m_Arch.Arc(p[0], p[1])) - middle) > ProfileShare * width)
      {
        marks[i] = 0;
      }
    }
    auto profile = this->CutOut(marks);
    if (profile->triangles.size() >= MinimumCrownTriangles)
    {
      found.profile = std::move(profile);
    }
  }
  return found;
}
} // namespace itk

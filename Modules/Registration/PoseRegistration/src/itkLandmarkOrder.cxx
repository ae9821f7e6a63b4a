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
#include "itkLandmarkOrder.h"

#include "itkDentalLandmarkSet.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** mm from the mirror image of its fellow from which on a landmark is taken for one of another tooth, where something
 * else says that one of two is: half a tooth's width. Arches are less symmetrical than that only where teeth were
 * lost. */
constexpr double HalfATooth = 3.5;
/** A step is too long where it exceeds the other side's by a narrow tooth's width and by this factor. */
constexpr double TooMuch = 5.5;
constexpr double TooMuchByFactor = 1.5;
/** Steps below this length, mm, are none, where the other side's is twice as long: crowded teeth's tips are further
 * apart. */
constexpr double NoStep = 2.0;

bool
IsLingual(const std::string & suffix)
{
  return suffix == "ML" || suffix == "DL";
}

/** -1 mesial, 1 distal, 0 in between or for the whole tooth. */
int
BackwardOf(const std::string & suffix)
{
  return suffix == "MB" || suffix == "ML" ? -1 : suffix == "DB" || suffix == "DL" ? 1 : 0;
}
} // namespace

LandmarkOrder::LandmarkOrder(const DentalJawFrame & frame, const LandmarksType & landmarks)
{
  for (const LandmarkType & landmark : landmarks)
  {
    PlaceType place;
    place.tooth = DentalLandmarkSet<3>::ParseName(landmark.first);
    place.suffix = landmark.first.substr(landmark.first.rfind('_') + 1);
    for (unsigned int d = 0; d < 3; ++d)
    {
      place.x += frame.axes[0][d] * (landmark.second[d] - frame.midpoint[d]);
      place.y += frame.axes[1][d] * (landmark.second[d] - frame.midpoint[d]);
    }
    const int fromMiddle = 3 * static_cast<int>(place.tooth.GetPosition()) + BackwardOf(place.suffix);
    place.rank = place.tooth.IsRight() ? -fromMiddle : fromMiddle;
    m_Places.push_back(place);
  }
  this->MeasureFellows();
  this->FindOutOfOrder();
  this->FindWrongSteps();
  std::sort(m_Misplaced.begin(), m_Misplaced.end());
}

void
LandmarkOrder::MeasureFellows()
{
  const auto median = [](std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<double>                              sums;
  std::vector<double>                              differences;
  for (std::size_t i = 0; i < m_Places.size(); ++i)
  {
    for (std::size_t j = 0; j < m_Places.size(); ++j)
    {
      const PlaceType & a = m_Places[i];
      const PlaceType & b = m_Places[j];
      if (a.tooth.IsRight() && b.tooth == a.tooth.GetContralateral() && a.suffix == b.suffix)
      {
        pairs.emplace_back(i, j);
        sums.push_back(a.y + b.y);
        differences.push_back(a.x - b.x);
      }
    }
  }
  // The frame's midline is found to a millimetre or two; that of the pairs themselves is theirs. Fewer have none.
  constexpr std::size_t fewest = 3;
  if (pairs.size() < fewest)
  {
    return;
  }
  const double across = median(sums);
  const double along = median(differences);
  for (const auto & pair : pairs)
  {
    PlaceType & a = m_Places[pair.first];
    PlaceType & b = m_Places[pair.second];
    a.fromFellow = b.fromFellow = std::hypot(a.x - b.x - along, a.y + b.y - across);
  }
}

double
LandmarkOrder::ComputeOverlap(const PlaceType & a, const PlaceType & b) const
{
  if (a.rank == b.rank || IsLingual(a.suffix) != IsLingual(b.suffix))
  {
    return 0.0;
  }
  const PlaceType & right = a.rank < b.rank ? a : b;
  const PlaceType & left = a.rank < b.rank ? b : a;
  // Seen from the middle of the molars the row turns from the right, by the front, to the left. Third molars may stand
  // behind that middle.
  constexpr double quarter = 1.5707963267948966;
  const double     turn = std::atan2(right.y, right.x) - std::atan2(left.y, left.x);
  const double     radius = std::max(std::hypot(right.x, right.y), std::hypot(left.x, left.y));
  const double     overlap = turn > 0.0 ? radius * std::sin(std::min(turn, quarter)) : 0.0;
  return overlap > MaximumOverlap ? overlap : 0.0;
}

void
LandmarkOrder::Add(std::size_t index, double amount)
{
  if (std::find(m_Misplaced.begin(), m_Misplaced.end(), index) == m_Misplaced.end())
  {
    m_Misplaced.push_back(index);
  }
  m_Largest = std::max(m_Largest, amount);
}

void
LandmarkOrder::FindOutOfOrder()
{
  const std::size_t                count = m_Places.size();
  std::vector<std::vector<double>> overlaps(count, std::vector<double>(count, 0.0));
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t j = i + 1; j < count; ++j)
    {
      overlaps[i][j] = overlaps[j][i] = this->ComputeOverlap(m_Places[i], m_Places[j]);
    }
  }
  const auto isAgainst = [](double overlap) { return overlap > 0.0; };
  // The one that most others are against goes first, of several the one that its fellow is furthest from.
  std::vector<bool> isOut(count, false);
  for (;;)
  {
    std::size_t worst = count;
    std::size_t most = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      std::size_t against = 0;
      for (std::size_t j = 0; j < count; ++j)
      {
        against += !isOut[i] && !isOut[j] && isAgainst(overlaps[i][j]) ? 1 : 0;
      }
      if (against > most || (against == most && against > 0 && m_Places[i].fromFellow > m_Places[worst].fromFellow))
      {
        worst = i;
        most = against;
      }
    }
    if (most == 0)
    {
      break;
    }
    isOut[worst] = true;
    this->Add(worst, *std::max_element(overlaps[worst].begin(), overlaps[worst].end()));
    // Two neighbours exchanged: either may be wrong, unless its fellow says that it is right.
    if (most == 1)
    {
      for (std::size_t j = 0; j < count; ++j)
      {
        const double off = m_Places[j].fromFellow;
        const double offOther = m_Places[worst].fromFellow;
        if (!isOut[j] && isAgainst(overlaps[worst][j]) && (off > HalfATooth || (off < 0.0 && offOther <= HalfATooth)))
        {
          isOut[j] = true;
          this->Add(j, overlaps[worst][j]);
        }
      }
    }
  }
}

const LandmarkOrder::PlaceType *
LandmarkOrder::FindFirst(ToothCode tooth) const
{
  const PlaceType * found = nullptr;
  for (std::size_t i = 0; i < m_Places.size(); ++i)
  {
    const PlaceType & place = m_Places[i];
    if (place.tooth == tooth && !IsLingual(place.suffix) && BackwardOf(place.suffix) <= 0 &&
        std::find(m_Misplaced.begin(), m_Misplaced.end(), i) == m_Misplaced.end())
    {
      found = &place;
    }
  }
  return found;
}

void
LandmarkOrder::FindWrongSteps()
{
  // What is found here is judged by what was known before it.
  std::vector<std::pair<const PlaceType *, double>> wrong;
  for (const PlaceType & place : m_Places)
  {
    const ToothCode    tooth = place.tooth;
    constexpr unsigned last = 8;
    if (tooth.IsPrimary() || tooth.GetPosition() >= last)
    {
      continue;
    }
    const ToothCode   next(tooth.GetFDI() + 1u);
    const PlaceType * own[2] = { this->FindFirst(tooth), this->FindFirst(next) };
    const PlaceType * other[2] = { this->FindFirst(tooth.GetContralateral()),
                                   this->FindFirst(next.GetContralateral()) };
    if (own[0] != &place || own[1] == nullptr || other[0] == nullptr || other[1] == nullptr)
    {
      continue;
    }
    const double step = std::hypot(own[0]->x - own[1]->x, own[0]->y - own[1]->y);
    const double otherStep = std::hypot(other[0]->x - other[1]->x, other[0]->y - other[1]->y);
    const bool   isLong = step > otherStep + TooMuch && step > TooMuchByFactor * otherStep;
    const bool   isShort = step < NoStep && otherStep > 2.0 * NoStep;
    if (isLong || isShort)
    {
      for (const PlaceType * each : own)
      {
        if (each->fromFellow > HalfATooth)
        {
          wrong.emplace_back(each, std::abs(step - otherStep));
        }
      }
    }
  }
  for (const auto & each : wrong)
  {
    this->Add(static_cast<std::size_t>(each.first - m_Places.data()), each.second);
  }
}
} // namespace itk

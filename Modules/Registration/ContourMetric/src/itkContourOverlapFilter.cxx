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
#include "itkContourOverlapFilter.h"

#include "itkContourDistanceIndex.h"
#include "itkMakeContourArrays.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
/** Part of a segment's length within which a place is its end point. */
constexpr double Epsilon = 1e-9;

struct NearestPlace
{
  double distance{ std::numeric_limits<double>::quiet_NaN() };
  /** Whether the nearest place is an end of the contour, and whether the point lies beyond it and not beside. */
  bool atEnd{ false };
  bool beyondEnd{ false };
};

bool
IsUsed(const ContourArrays & contour, std::size_t i)
{
  return contour.weights.empty() || contour.weights[i] > 0.0;
}

double
GetWeight(const ContourArrays & contour, std::size_t i)
{
  return contour.weights.empty() ? 1.0 : contour.weights[i];
}

/** A contour to which distances are taken: its segments, and where it ends. */
class OverlapTarget
{
public:
  /** Ends of two polylines closer than the gap are none. Points of weight 0 are not there, nor are their segments. */
  OverlapTarget(const ContourArrays & contour, double gapLength)
  {
    const std::size_t          count = contour.GetNumberOfPoints();
    std::vector<std::uint32_t> number(count, 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (IsUsed(contour, i))
      {
        number[i] = static_cast<std::uint32_t>(m_Points.size() / 2);
        m_Points.push_back(contour.points[2 * i]);
        m_Points.push_back(contour.points[2 * i + 1]);
      }
    }
    const std::size_t        used = m_Points.size() / 2;
    std::vector<int>         degree(used, 0);
    std::vector<std::size_t> polyline(used);
    for (std::size_t i = 0; i < used; ++i)
    {
      polyline[i] = i;
    }
    for (std::size_t k = 0; k + 1 < contour.segments.size(); k += 2)
    {
      if (!IsUsed(contour, contour.segments[k]) || !IsUsed(contour, contour.segments[k + 1]))
      {
        continue;
      }
      const std::uint32_t from = number[contour.segments[k]];
      const std::uint32_t to = number[contour.segments[k + 1]];
      m_Segments.push_back(from);
      m_Segments.push_back(to);
      ++degree[from];
      ++degree[to];
      const std::size_t old = polyline[to];
      if (old != polyline[from])
      {
        // Segments come one after the other, so that there is seldom more than the point itself to rename.
        for (std::size_t i = 0; i < used && old != to; ++i)
        {
          polyline[i] = polyline[i] == old ? polyline[from] : polyline[i];
        }
        polyline[to] = polyline[from];
      }
    }
    m_Index.SetSegments(m_Points.data(), used, m_Segments.data(), m_Segments.size() / 2);
    m_IsEnd.assign(used, 0);
    for (std::size_t i = 0; i < used; ++i)
    {
      m_IsEnd[i] = degree[i] < 2;
      for (std::size_t k = 0; k < used && m_IsEnd[i]; ++k)
      {
        if (degree[k] < 2 && polyline[k] != polyline[i] &&
            std::hypot(m_Points[2 * i] - m_Points[2 * k], m_Points[2 * i + 1] - m_Points[2 * k + 1]) < gapLength)
        {
          m_IsEnd[i] = 0;
        }
      }
    }
  }

  bool
  IsEmpty() const
  {
    return m_Points.empty();
  }

  NearestPlace
  Find(double x, double y) const
  {
    NearestPlace place;
    const auto   nearest = m_Index.FindNearest(x, y);
    place.distance = std::sqrt(nearest.squaredDistance);
    if (2 * nearest.target >= m_Segments.size())
    {
      // A lone point has no sides: what lies beside it and what beyond is the same.
      return place;
    }
    for (int k = 0; k < 2; ++k)
    {
      const std::uint32_t end = m_Segments[2 * nearest.target + k];
      const std::uint32_t other = m_Segments[2 * nearest.target + 1 - k];
      const double        dx = m_Points[2 * end] - m_Points[2 * other];
      const double        dy = m_Points[2 * end + 1] - m_Points[2 * other + 1];
      const double        length = std::hypot(dx, dy);
      const bool          here =
        std::hypot(nearest.x - m_Points[2 * end], nearest.y - m_Points[2 * end + 1]) <= Epsilon * length;
      if (m_IsEnd[end] && here)
      {
        place.atEnd = true;
        place.beyondEnd = place.beyondEnd || dx * (x - nearest.x) + dy * (y - nearest.y) > Epsilon * length * length;
      }
    }
    return place;
  }

private:
  std::vector<double>        m_Points;
  std::vector<std::uint32_t> m_Segments;
  std::vector<char>          m_IsEnd;
  ContourDistanceIndex       m_Index;
};

/** Length of contour that each point stands for: half of its segments; 1 for a lone point. */
std::vector<double>
GetLengths(const ContourArrays & contour)
{
  std::vector<double> lengths(contour.GetNumberOfPoints(), 0.0);
  for (std::size_t k = 0; k + 1 < contour.segments.size(); k += 2)
  {
    const std::size_t a = contour.segments[k];
    const std::size_t b = contour.segments[k + 1];
    const double      half = 0.5 * std::hypot(contour.points[2 * a] - contour.points[2 * b],
                                         contour.points[2 * a + 1] - contour.points[2 * b + 1]);
    lengths[a] += half;
    lengths[b] += half;
  }
  for (double & length : lengths)
  {
    length = length > 0.0 ? length : 1.0;
  }
  return lengths;
}
} // namespace

ContourOverlapFilter::ContourOverlapFilter()
{
  this->SetPrimaryInputName("FixedContour");
  this->AddRequiredInputName("MovingContour", 1);
  this->AddOptionalInputName("Transform", 2);
  this->SetNumberOfRequiredOutputs(0);
  this->SetPrimaryOutputName("FixedShare");
  for (const char * name : { "FixedShare", "MovingShare", "RootMeanSquare", "LargestDistance" })
  {
    this->ProcessObject::SetOutput(name, this->MakeOutput(name));
  }
}

DataObject::Pointer
ContourOverlapFilter::MakeOutput(const DataObjectIdentifierType & name)
{
  return Superclass::MakeOutput(name).IsNull() ? nullptr : RealObjectType::New().GetPointer();
}

void
ContourOverlapFilter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetFixedContour() == nullptr)
  {
    itkExceptionMacro("No fixed contour: call SetFixedContour() with the tracing.");
  }
  if (this->GetMovingContour() == nullptr)
  {
    itkExceptionMacro("No moving contour: call SetMovingContour() with the aligned outline.");
  }
  if (!(m_MaximumDistance > 0.0) || !(m_GapLength >= 0.0))
  {
    itkExceptionMacro("MaximumDistance " << m_MaximumDistance << " px must be positive and GapLength " << m_GapLength
                                         << " px not negative.");
  }
  Superclass::VerifyPreconditions();
}

void
ContourOverlapFilter::GenerateData()
{
  ContourSimilarity similarity;
  if (this->GetTransform() != nullptr)
  {
    similarity.scale = this->GetTransform()->GetScale();
    similarity.angle = this->GetTransform()->GetAngle();
    similarity.tx = this->GetTransform()->GetOffset()[0];
    similarity.ty = this->GetTransform()->GetOffset()[1];
    if (!(similarity.scale > 0.0))
    {
      itkExceptionMacro("The transform's scale " << similarity.scale << " is not positive.");
    }
  }
  const ContourArrays fixed = MakeContourArrays(*this->GetFixedContour());
  ContourArrays       moving = MakeContourArrays(*this->GetMovingContour());
  const double        c = similarity.scale * std::cos(similarity.angle);
  const double        s = similarity.scale * std::sin(similarity.angle);
  for (std::size_t i = 0; i < moving.GetNumberOfPoints(); ++i)
  {
    const double x = moving.points[2 * i];
    const double y = moving.points[2 * i + 1];
    moving.points[2 * i] = c * x - s * y + similarity.tx;
    moving.points[2 * i + 1] = s * x + c * y + similarity.ty;
  }
  const OverlapTarget tracing(fixed, m_GapLength);
  // The ends of an outline are ends however close they are: what lies between them was not projected.
  const OverlapTarget outline(moving, 0.0);
  if (tracing.IsEmpty() || outline.IsEmpty())
  {
    itkExceptionMacro("There is nothing to measure: the " << (tracing.IsEmpty() ? "fixed" : "moving")
                                                          << " contour has no point of positive weight.");
  }
  double matched = 0.0;
  double all = 0.0;
  double squares = 0.0;
  double largest = 0.0;
  m_FixedDistances.assign(fixed.GetNumberOfPoints(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < m_FixedDistances.size(); ++i)
  {
    if (!IsUsed(fixed, i))
    {
      continue;
    }
    const NearestPlace place = outline.Find(fixed.points[2 * i], fixed.points[2 * i + 1]);
    const double       weight = GetWeight(fixed, i);
    m_FixedDistances[i] = place.distance;
    all += weight;
    if (place.distance <= m_MaximumDistance && !place.beyondEnd)
    {
      matched += weight;
      squares += weight * place.distance * place.distance;
      largest = std::max(largest, place.distance);
    }
  }
  this->UpdateProgress(0.5f);
  const std::vector<double> lengths = GetLengths(moving);
  double                    covered = 0.0;
  double                    length = 0.0;
  m_MovingDistances.assign(moving.GetNumberOfPoints(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < m_MovingDistances.size(); ++i)
  {
    if (!IsUsed(moving, i))
    {
      continue;
    }
    const NearestPlace place = tracing.Find(moving.points[2 * i], moving.points[2 * i + 1]);
    const double       weight = GetWeight(moving, i) * lengths[i];
    length += weight;
    if (!place.atEnd)
    {
      m_MovingDistances[i] = place.distance;
      covered += place.distance <= m_MaximumDistance ? weight : 0.0;
    }
  }
  this->SetFixedShare(matched / all);
  this->SetMovingShare(covered / length);
  this->SetRootMeanSquare(matched > 0.0 ? std::sqrt(squares / matched) : 0.0);
  this->SetLargestDistance(largest);
}

void
ContourOverlapFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MaximumDistance: " << m_MaximumDistance << std::endl;
  os << indent << "GapLength: " << m_GapLength << std::endl;
  os << indent << "FixedShare: " << this->GetFixedShare() << std::endl;
  os << indent << "MovingShare: " << this->GetMovingShare() << std::endl;
  os << indent << "RootMeanSquare: " << this->GetRootMeanSquare() << std::endl;
  os << indent << "LargestDistance: " << this->GetLargestDistance() << std::endl;
  os << indent << "FixedDistances: " << m_FixedDistances.size() << std::endl;
  os << indent << "MovingDistances: " << m_MovingDistances.size() << std::endl;
}
} // namespace itk

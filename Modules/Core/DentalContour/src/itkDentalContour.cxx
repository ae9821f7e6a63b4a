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
#include "itkDentalContour.h"

#include "itkLineCell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace itk
{
namespace
{
/** Appends what a polyline says of its points, or what holds where it says nothing. Nothing is kept as long as nobody
 * says anything. */
template <typename TValue>
void
AppendValues(std::vector<TValue> &       values,
             std::size_t                 first,
             std::size_t                 count,
             const std::vector<TValue> & given,
             TValue                      otherwise)
{
  if (given.empty() && values.empty())
  {
    return;
  }
  values.resize(first, otherwise);
  if (given.empty())
  {
    values.resize(first + count, otherwise);
  }
  else
  {
    values.insert(values.end(), given.begin(), given.end());
  }
}

DentalContour::NormalType
UnknownNormal()
{
  DentalContour::NormalType normal;
  normal.Fill(0.0);
  return normal;
}

DentalContour::RimPointType
UnknownRimPoint()
{
  DentalContour::RimPointType point;
  point.Fill(std::numeric_limits<double>::quiet_NaN());
  return point;
}

bool
IsKnown(const DentalContour::NormalType & normal)
{
  return normal[0] != 0.0 || normal[1] != 0.0;
}

bool
IsKnown(const DentalContour::RimPointType & point)
{
  return !std::isnan(point[0]);
}

/** What is known of no point of a polyline is not there. */
template <typename TValue>
void
DropUnknown(std::vector<TValue> & values)
{
  if (std::none_of(values.begin(), values.end(), [](const TValue & value) { return IsKnown(value); }))
  {
    values.clear();
  }
}
} // namespace

void
DentalContour::AddPolyline(const std::vector<PointType> & points, ToothCode code, bool closed)
{
  this->AddPolyline(PolylineType{ code, closed, points, {} });
}

void
DentalContour::AddPolyline(const PolylineType & polyline)
{
  if (polyline.points.empty())
  {
    return;
  }
  if (polyline.closed && polyline.points.size() < 3)
  {
    itkExceptionMacro("A closed contour needs at least 3 points, not " << polyline.points.size() << ".");
  }
  const auto verifyCount = [&](std::size_t given, const char * name) {
    if (given != 0 && given != polyline.points.size())
    {
      itkExceptionMacro("A polyline of " << polyline.points.size() << " points has " << given << ' ' << name
                                         << "; give one a point or none.");
    }
  };
  verifyCount(polyline.weights.size(), "weights");
  verifyCount(polyline.sigmas.size(), "sigmas");
  verifyCount(polyline.normals.size(), "normals");
  verifyCount(polyline.rimPoints.size(), "rim points");
  verifyCount(polyline.teeth.size(), "teeth");
  for (const PointType & point : polyline.points)
  {
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
    {
      itkExceptionMacro("A contour point " << point << " is not finite.");
    }
  }
  for (const double weight : polyline.weights)
  {
    if (!(weight >= 0.0 && weight <= 1.0))
    {
      itkExceptionMacro("A point's weight " << weight << " is not in [0, 1].");
    }
  }
  for (const double sigma : polyline.sigmas)
  {
    if (!(sigma >= 0.0) || !std::isfinite(sigma))
    {
      itkExceptionMacro("A point's sigma " << sigma << " is no standard deviation in pixels.");
    }
  }
  for (const NormalType & normal : polyline.normals)
  {
    // Far more than rounding, far less than a vector that was meant for another length.
    constexpr double tolerance = 1e-4;
    if (IsKnown(normal) && !(std::abs(normal.GetNorm() - 1.0) < tolerance))
    {
      itkExceptionMacro("A point's normal " << normal << " is no unit vector, and not (0, 0) for an unknown one.");
    }
  }
  for (const RimPointType & point : polyline.rimPoints)
  {
    const auto unknown = std::count_if(point.Begin(), point.End(), [](double x) { return std::isnan(x); });
    if (std::any_of(point.Begin(), point.End(), [](double x) { return std::isinf(x); }) ||
        (unknown != 0 && unknown != 3))
    {
      itkExceptionMacro("A rim point " << point << " is not finite, and not NaN as a whole for an unknown one.");
    }
  }
  const PointIdentifier first = this->GetNumberOfPoints();
  const auto            count = static_cast<PointIdentifier>(polyline.points.size());
  for (PointIdentifier i = 0; i < count; ++i)
  {
    this->SetPoint(first + i, polyline.points[i]);
    this->SetPointData(first + i, polyline.teeth.empty() ? polyline.code.GetFDI() : polyline.teeth[i].GetFDI());
  }
  AppendValues(m_PointWeights, first, count, polyline.weights, 1.0);
  AppendValues(m_PointSigmas, first, count, polyline.sigmas, 0.0);
  AppendValues(m_PointOutlines,
               first,
               count,
               std::vector<OutlineEnum>(polyline.outline == OutlineEnum::Unspecified ? 0 : count, polyline.outline),
               OutlineEnum::Unspecified);
  AppendValues(m_PointsDrafted, first, count, std::vector<bool>(polyline.drafted ? count : 0, true), false);
  AppendValues(m_PointNormals, first, count, polyline.normals, UnknownNormal());
  AppendValues(m_RimPoints, first, count, polyline.rimPoints, UnknownRimPoint());
  const PointIdentifier segments = polyline.closed ? count : count - 1;
  CellIdentifier        cellId = this->GetNumberOfCells();
  for (PointIdentifier i = 0; i < segments; ++i)
  {
    CellAutoPointer cell;
    cell.TakeOwnership(new LineCell<CellType>);
    cell->SetPointId(0, first + i);
    cell->SetPointId(1, first + (i + 1) % count);
    this->SetCell(cellId++, cell);
  }
  this->Modified();
}

auto
DentalContour::GetPolylines() const -> std::vector<PolylineType>
{
  std::vector<PolylineType> polylines;
  const auto *              points = this->GetPoints();
  if (points == nullptr)
  {
    return polylines;
  }
  std::vector<bool> used(points->Size(), false);
  const auto        append = [&](PolylineType & polyline, PointIdentifier id) {
    polyline.points.push_back(points->ElementAt(id));
    if (!m_PointWeights.empty())
    {
      polyline.weights.push_back(this->GetPointWeight(id));
    }
    if (!m_PointSigmas.empty())
    {
      polyline.sigmas.push_back(this->GetPointSigma(id));
    }
    if (!m_PointNormals.empty())
    {
      polyline.normals.push_back(this->GetPointNormal(id));
    }
    if (!m_RimPoints.empty())
    {
      polyline.rimPoints.push_back(this->GetRimPoint(id));
    }
    polyline.teeth.push_back(this->GetToothCode(id));
    polyline.outline = this->GetPointOutline(id);
    polyline.drafted = this->IsPointDrafted(id);
    used[id] = true;
  };
  const auto * cells = this->GetCells();
  if (cells != nullptr)
  {
    PointIdentifier firstId = 0;
    PointIdentifier lastId = 0;
    bool            open = false;
    for (auto it = cells->Begin(); it != cells->End(); ++it)
    {
      const CellType * cell = it.Value();
      if (cell->GetNumberOfPoints() != 2)
      {
        itkExceptionMacro("Cell " << it.Index() << " of the contour has " << cell->GetNumberOfPoints()
                                  << " points; a contour is made of line cells.");
      }
      const PointIdentifier from = cell->GetPointIds()[0];
      const PointIdentifier to = cell->GetPointIds()[1];
      if (from >= used.size() || to >= used.size())
      {
        itkExceptionMacro("Cell " << it.Index() << " of the contour names a point that it has not.");
      }
      if (!open || from != lastId)
      {
        polylines.emplace_back();
        polylines.back().code = this->GetToothCode(from);
        append(polylines.back(), from);
        firstId = from;
        open = true;
      }
      if (to == firstId && polylines.back().points.size() >= 3)
      {
        polylines.back().closed = true;
        open = false;
      }
      else
      {
        append(polylines.back(), to);
        lastId = to;
      }
    }
  }
  for (PointIdentifier id = 0; id < used.size(); ++id)
  {
    if (!used[id])
    {
      polylines.emplace_back();
      polylines.back().code = this->GetToothCode(id);
      append(polylines.back(), id);
    }
  }
  for (PolylineType & polyline : polylines)
  {
    DropUnknown(polyline.normals);
    DropUnknown(polyline.rimPoints);
    if (std::all_of(
          polyline.teeth.begin(), polyline.teeth.end(), [&](ToothCode tooth) { return tooth == polyline.code; }))
    {
      polyline.teeth.clear();
    }
  }
  return polylines;
}

double
DentalContour::GetLength() const
{
  double length = 0.0;
  for (const PolylineType & polyline : this->GetPolylines())
  {
    const std::size_t count = polyline.points.size();
    for (std::size_t i = 0; i + 1 < count + (polyline.closed ? 1 : 0); ++i)
    {
      length += polyline.points[i].EuclideanDistanceTo(polyline.points[(i + 1) % count]);
    }
  }
  return length;
}

ToothCode
DentalContour::GetToothCode(PointIdentifier id) const
{
  uint8_t fdi = 0;
  return this->GetPointData() != nullptr && this->GetPointData(id, &fdi) ? ToothCode(fdi) : ToothCode();
}

double
DentalContour::GetPointWeight(PointIdentifier id) const
{
  return id < m_PointWeights.size() ? m_PointWeights[id] : 1.0;
}

double
DentalContour::GetPointSigma(PointIdentifier id) const
{
  return id < m_PointSigmas.size() ? m_PointSigmas[id] : 0.0;
}

DentalContour::OutlineEnum
DentalContour::GetPointOutline(PointIdentifier id) const
{
  return id < m_PointOutlines.size() ? m_PointOutlines[id] : OutlineEnum::Unspecified;
}

bool
DentalContour::IsPointDrafted(PointIdentifier id) const
{
  return id < m_PointsDrafted.size() && m_PointsDrafted[id];
}

double
DentalContour::GetDraftedShare() const
{
  PointIdentifier drafted = 0;
  PointIdentifier all = 0;
  for (PointIdentifier id = 0; id < this->GetNumberOfPoints(); ++id)
  {
    const bool counts = this->GetPointWeight(id) > 0.0;
    all += counts ? 1 : 0;
    drafted += counts && this->IsPointDrafted(id) ? 1 : 0;
  }
  return all > 0 ? static_cast<double>(drafted) / static_cast<double>(all) : 0.0;
}

DentalContour::NormalType
DentalContour::GetPointNormal(PointIdentifier id) const
{
  return id < m_PointNormals.size() ? m_PointNormals[id] : UnknownNormal();
}

DentalContour::RimPointType
DentalContour::GetRimPoint(PointIdentifier id) const
{
  return id < m_RimPoints.size() ? m_RimPoints[id] : UnknownRimPoint();
}

DentalContour::OutlineEnum
DentalContour::OutlineFromString(const std::string & text)
{
  if (text == "crown")
  {
    return OutlineEnum::Crown;
  }
  if (text == "tooth")
  {
    return OutlineEnum::Tooth;
  }
  if (text == "labial")
  {
    return OutlineEnum::Labial;
  }
  throw std::invalid_argument("\"" + text + "\" is no outline (\"crown\", \"tooth\" or \"labial\")");
}

void
AppendPoint(const DentalContour::PolylineType & from, std::size_t index, DentalContour::PolylineType & to)
{
  const std::size_t before = to.points.size();
  const auto        append = [&](auto & own, const auto & others, const auto & otherwise) {
    if (!own.empty() || !others.empty())
    {
      own.resize(before, otherwise);
      own.push_back(others.empty() ? otherwise : others[index]);
    }
  };
  append(to.weights, from.weights, 1.0);
  append(to.sigmas, from.sigmas, 0.0);
  append(to.normals, from.normals, UnknownNormal());
  append(to.rimPoints, from.rimPoints, UnknownRimPoint());
  const ToothCode tooth = from.GetTooth(index);
  if (before == 0)
  {
    to.code = tooth;
    to.outline = from.outline;
    to.drafted = from.drafted;
  }
  else if (to.outline != from.outline)
  {
    to.outline = DentalContour::OutlineEnum::Unspecified;
  }
  // Of points of which some were mended the whole was.
  to.drafted = to.drafted && from.drafted;
  // Of a polyline that is all of one tooth its code says it.
  if (!to.teeth.empty() || tooth != to.code)
  {
    to.teeth.resize(before, to.code);
    to.teeth.push_back(tooth);
  }
  to.points.push_back(from.points[index]);
}

DentalContour::PolylinesType
KeepPoints(const DentalContour::PolylineType & polyline, const std::vector<bool> & keep)
{
  const auto firstDropped = std::find(keep.begin(), keep.end(), false);
  if (firstDropped == keep.end())
  {
    return { polyline };
  }
  DentalContour::PolylinesType runs;
  const std::size_t            count = polyline.points.size();
  const std::size_t            start = polyline.closed ? static_cast<std::size_t>(firstDropped - keep.begin()) : 0;
  bool                         open = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t k = (start + i) % count;
    if (keep[k] && !open)
    {
      runs.emplace_back();
    }
    open = keep[k];
    if (open)
    {
      AppendPoint(polyline, k, runs.back());
    }
  }
  return runs;
}

std::ostream &
operator<<(std::ostream & os, DentalContour::OutlineEnum outline)
{
  switch (outline)
  {
    case DentalContour::OutlineEnum::Crown:
      return os << "crown";
    case DentalContour::OutlineEnum::Tooth:
      return os << "tooth";
    case DentalContour::OutlineEnum::Labial:
      return os << "labial";
    default:
      return os << "unspecified";
  }
}

void
DentalContour::Initialize()
{
  Superclass::Initialize();
  m_PointWeights.clear();
  m_PointSigmas.clear();
  m_PointOutlines.clear();
  m_PointsDrafted.clear();
  m_PointNormals.clear();
  m_RimPoints.clear();
}

void
DentalContour::Graft(const DataObject * data)
{
  Superclass::Graft(data);
  const auto * contour = dynamic_cast<const Self *>(data);
  m_PointWeights = contour == nullptr ? std::vector<double>() : contour->m_PointWeights;
  m_PointSigmas = contour == nullptr ? std::vector<double>() : contour->m_PointSigmas;
  m_PointOutlines = contour == nullptr ? std::vector<OutlineEnum>() : contour->m_PointOutlines;
  m_PointsDrafted = contour == nullptr ? std::vector<bool>() : contour->m_PointsDrafted;
  m_PointNormals = contour == nullptr ? std::vector<NormalType>() : contour->m_PointNormals;
  m_RimPoints = contour == nullptr ? std::vector<RimPointType>() : contour->m_RimPoints;
}

void
DentalContour::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "PointWeights: " << m_PointWeights.size() << std::endl;
  os << indent << "PointSigmas: " << m_PointSigmas.size() << std::endl;
  os << indent << "PointOutlines: " << m_PointOutlines.size() << std::endl;
  os << indent << "PointsDrafted: " << std::count(m_PointsDrafted.begin(), m_PointsDrafted.end(), true) << std::endl;
  os << indent << "PointNormals: " << m_PointNormals.size() << std::endl;
  os << indent << "RimPoints: " << m_RimPoints.size() << std::endl;
}
} // namespace itk

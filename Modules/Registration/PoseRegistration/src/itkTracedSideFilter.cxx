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
#include "itkTracedSideFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;

/** Length by width of what a curve covers, along its own axes. */
double
ComputeElongation(const DentalContour::PolylineType & polyline)
{
  const double          count = static_cast<double>(polyline.points.size());
  double                mean[2] = { 0.0, 0.0 };
  std::array<double, 3> moments{ { 0.0, 0.0, 0.0 } };
  std::array<double, 2> lowest{ { 0.0, 0.0 } };
  std::array<double, 2> highest{ { 0.0, 0.0 } };
  for (const auto & point : polyline.points)
  {
    mean[0] += point[0] / count;
    mean[1] += point[1] / count;
  }
  for (const auto & point : polyline.points)
  {
    const double u = point[0] - mean[0];
    const double v = point[1] - mean[1];
    moments = { { moments[0] + u * u, moments[1] + u * v, moments[2] + v * v } };
  }
  const double angle = 0.5 * std::atan2(2.0 * moments[1], moments[0] - moments[2]);
  for (const auto & point : polyline.points)
  {
    const double u = point[0] - mean[0];
    const double v = point[1] - mean[1];
    const double along = std::cos(angle) * u + std::sin(angle) * v;
    const double across = std::cos(angle) * v - std::sin(angle) * u;
    lowest = { { std::min(lowest[0], along), std::min(lowest[1], across) } };
    highest = { { std::max(highest[0], along), std::max(highest[1], across) } };
  }
  const double width = highest[1] - lowest[1];
  return width > 0.0 ? (highest[0] - lowest[0]) / width : 0.0;
}

/** Closed outlines of incisors and molars of one side each, incisors with their roots. A whole incisor is three times
 * as long as wide in a lateral view and its crown one and a half times; a molar's shape tells nothing. */
bool
IsStandardTracing(const std::array<const DentalContour *, 2> & contours)
{
  using OutlineEnum = DentalContour::OutlineEnum;
  constexpr double  minimumElongation = 2.0;
  unsigned int      incisors = 0;
  unsigned int      molars = 0;
  std::set<uint8_t> seen;
  for (const DentalContour * contour : contours)
  {
    if (contour == nullptr)
    {
      continue;
    }
    for (const auto & polyline : contour->GetPolylines())
    {
      if (polyline.points.empty())
      {
        continue;
      }
      const unsigned int position = polyline.code.GetPosition();
      const bool         incisor = position == 1 || position == 2;
      const bool         molar = position >= 6;
      // What the file says of an outline goes before its shape.
      const bool said = polyline.outline != OutlineEnum::Unspecified;
      if (!polyline.closed || !(incisor || molar) || seen.count(polyline.code.GetContralateral().GetFDI()) > 0 ||
          (said && polyline.outline != OutlineEnum::Tooth) ||
          (!said && incisor && ComputeElongation(polyline) < minimumElongation))
      {
        return false;
      }
      seen.insert(polyline.code.GetFDI());
      incisors += incisor ? 1 : 0;
      molars += molar ? 1 : 0;
    }
  }
  return incisors > 0 && molars > 0;
}

/** Teeth that are drawn of both sides, each with its own code: the codes of the right ones, by jaw. */
std::set<std::uint8_t>
FindPairs(const DentalContour * contour)
{
  std::set<std::uint8_t> right;
  std::set<std::uint8_t> left;
  for (const auto & polyline : contour->GetPolylines())
  {
    if (!polyline.points.empty() && polyline.code.IsKnown())
    {
      (polyline.code.IsRight() ? right : left).insert(polyline.code.GetFDI());
    }
  }
  std::set<std::uint8_t> pairs;
  for (const std::uint8_t tooth : right)
  {
    if (left.count(ToothCode(tooth).GetContralateral().GetFDI()) != 0)
    {
      pairs.insert(tooth);
    }
  }
  return pairs;
}
} // namespace

TracedSideFilter::TracedSideFilter()
{
  this->AddOptionalInputName("UpperContour", 0);
  this->AddOptionalInputName("LowerContour", 1);
  this->AddOptionalInputName("CephalometricLandmarks", 2);
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(0, this->MakeOutput(0));
  this->SetNthOutput(1, this->MakeOutput(1));
}

TracedSideFilter::DataObjectPointer
TracedSideFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return ContourType::New().GetPointer();
}

TracedSideFilter::ContourType *
TracedSideFilter::GetOutput(JawEnum jaw)
{
  if (jaw == JawEnum::Unknown)
  {
    itkExceptionMacro("There is an output of the upper and one of the lower jaw, and none of an unknown one.");
  }
  return itkDynamicCastInDebugMode<ContourType *>(this->ProcessObject::GetOutput(jaw == JawEnum::Upper ? 0 : 1));
}

const TracedSideFilter::ContourType *
TracedSideFilter::GetContour(JawEnum jaw) const
{
  return jaw == JawEnum::Upper ? this->GetUpperContour() : this->GetLowerContour();
}

TracedSideEnum
TracedSideFilter::ReadSide()
{
  const std::array<const DentalContour *, 2> contours{ { this->GetUpperContour(), this->GetLowerContour() } };
  const bool traced = std::any_of(contours.begin(), contours.end(), [](const DentalContour * contour) {
    return contour != nullptr && contour->GetNumberOfPoints() > 0;
  });
  if (!traced && this->GetCephalometricLandmarks() != nullptr)
  {
    // Names that tell their sides are taken at their word.
    bool right = false;
    bool left = false;
    bool sideless = false;
    for (const auto & landmark : this->GetCephalometricLandmarks()->GetLandmarks())
    {
      const ToothCode & tooth = landmark.meaning.tooth;
      sideless = sideless || !tooth.IsKnown();
      right = right || tooth.IsRight();
      left = left || tooth.IsLeft();
    }
    if (!sideless && (right || left))
    {
      m_Reason = ReasonEnum::SidesOfLandmarks;
      return right && left ? TracedSideEnum::Both : right ? TracedSideEnum::Right : TracedSideEnum::Left;
    }
    m_Reason = ReasonEnum::LandmarksAlone;
    return TracedSideEnum::Standard;
  }
  if (!m_CodesHaveSides)
  {
    m_Reason = ReasonEnum::SidelessCodes;
    return TracedSideEnum::Standard;
  }
  if (IsStandardTracing(contours))
  {
    m_Reason = ReasonEnum::WholeTeeth;
    return TracedSideEnum::Standard;
  }
  // The incisors of both sides are often drawn together; teeth further back are drawn twice on purpose.
  std::size_t pairs = 0;
  for (const DentalContour * contour : contours)
  {
    const auto found = contour != nullptr ? FindPairs(contour) : std::set<std::uint8_t>();
    pairs += static_cast<std::size_t>(
      std::count_if(found.begin(), found.end(), [](std::uint8_t tooth) { return tooth % 10 > 2; }));
  }
  m_Reason = pairs >= 2 ? ReasonEnum::TeethOfBothSides : ReasonEnum::Nothing;
  return pairs >= 2 ? TracedSideEnum::Both : m_TracedSide;
}

void
TracedSideFilter::LeaveOutOtherSide(JawEnum jaw)
{
  ContourType * output = this->GetOutput(jaw);
  output->Initialize();
  // All there is: without it every Update() would execute again.
  output->SetBufferedRegion(0);
  const ContourType * contour = this->GetContour(jaw);
  if (contour == nullptr)
  {
    return;
  }
  const bool oneSide = m_SettledSide == TracedSideEnum::Right || m_SettledSide == TracedSideEnum::Left;
  const auto pairs = oneSide ? FindPairs(contour) : std::set<std::uint8_t>();
  for (const auto & polyline : contour->GetPolylines())
  {
    const bool      isOther = m_SettledSide == TracedSideEnum::Right ? polyline.code.IsLeft() : polyline.code.IsRight();
    const ToothCode right = polyline.code.IsRight() ? polyline.code : polyline.code.GetContralateral();
    if (isOther && pairs.count(right.GetFDI()) != 0)
    {
      m_LeftOutTeeth.push_back(polyline.code);
    }
    else
    {
      output->AddPolyline(polyline);
    }
  }
}

void
TracedSideFilter::GenerateData()
{
  m_LeftOutTeeth.clear();
  m_Reason = ReasonEnum::Given;
  m_SettledSide = m_TracedSideIsGiven ? m_TracedSide : this->ReadSide();
  this->LeaveOutOtherSide(JawEnum::Upper);
  this->LeaveOutOtherSide(JawEnum::Lower);
}

const char *
ToString(TracedSideFilter::ReasonEnum reason)
{
  switch (reason)
  {
    case TracedSideFilter::ReasonEnum::Given:
      return "it was given";
    case TracedSideFilter::ReasonEnum::SidesOfLandmarks:
      return "the landmarks' names say their sides";
    case TracedSideFilter::ReasonEnum::LandmarksAlone:
      return "there are landmarks of a cephalometric analysis and no tracing";
    case TracedSideFilter::ReasonEnum::SidelessCodes:
      return "codes of the tracing (U1, L6) do not say their side";
    case TracedSideFilter::ReasonEnum::WholeTeeth:
      return "whole incisors and molars alone are traced";
    case TracedSideFilter::ReasonEnum::TeethOfBothSides:
      return "teeth of both sides are traced";
    default:
      return "nothing in the drawing tells another";
  }
}

std::ostream &
operator<<(std::ostream & os, TracedSideFilter::ReasonEnum reason)
{
  return os << ToString(reason);
}

void
TracedSideFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "TracedSide: " << m_TracedSide << std::endl;
  os << indent << "TracedSideIsGiven: " << (m_TracedSideIsGiven ? "On" : "Off") << std::endl;
  os << indent << "CodesHaveSides: " << (m_CodesHaveSides ? "On" : "Off") << std::endl;
  os << indent << "SettledSide: " << m_SettledSide << std::endl;
  os << indent << "Reason: " << m_Reason << std::endl;
  os << indent << "LeftOutTeeth: " << m_LeftOutTeeth.size() << std::endl;
}
} // namespace itk

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
#include "itkCaseOverlay.h"

#include "itkWritePicture.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace itk
{
namespace
{
std::string
Number(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::vector<std::string>
MakeTextLines(const CaseResult & result, const JawResult & jaw)
{
  std::vector<std::string> lines;
  lines.push_back(std::string("preset ") + ToString(result.preset));
  for (const auto & metrics : jaw.metrics)
  {
    lines.push_back("Chamfer " + Number(metrics.second.chamfer, 1) + " px, Hausdorff " +
                    Number(metrics.second.hausdorff, 1) + " px (" + metrics.first + ")");
  }
  if (jaw.error)
  {
    const double millimetres = 0.5 * (result.geometry->GetPixelSpacing()[0] + result.geometry->GetPixelSpacing()[1]);
    lines.push_back("landmark error " + Number(jaw.error->mean, 2) +
                    " px = " + Number(jaw.error->mean * millimetres, 2) + " mm on the detector, mean of " +
                    std::to_string(jaw.error->count));
  }
  std::string used;
  for (const UsedLandmark & landmark : jaw.usedLandmarks)
  {
    used += (used.empty() ? "registered with " : ", ") + landmark.name + " (" +
            Number(std::hypot(landmark.residual[0], landmark.residual[1]), 1) + " px)";
  }
  if (!used.empty())
  {
    lines.push_back(used);
  }
  for (const std::string & reason : jaw.GetReasons())
  {
    lines.push_back(reason);
  }
  return lines;
}

/** The landmarks that were registered with: a cross where each was marked, a ring where its counterpart on the scan is
 * projected to, and a line between. They are no errors, and so no landmarks of the overlay, which counts these. */
DentalContour::Pointer
DrawUsedLandmarks(const CaseResult & result, const JawResult & jaw)
{
  using PointType = DentalContour::PointType;
  constexpr double       ringRadius = 0.8;
  constexpr double       crossArm = 1.1;
  constexpr unsigned int ringPoints = 16;
  constexpr double       fullCircle = 6.283185307179586;
  auto                   drawing = DentalContour::New();
  const auto             spacing = result.geometry->GetPixelSpacing();
  const auto             moved = [&](const PointType & from, double u, double v) {
    PointType point = from;
    point[0] += u / spacing[0];
    point[1] += v / spacing[1];
    return point;
  };
  for (const UsedLandmark & used : jaw.usedLandmarks)
  {
    const auto * mark = result.data->cephalometricLandmarks->Find(used.name);
    if (mark == nullptr)
    {
      continue;
    }
    const PointType marked = mark->point;
    PointType       projected = marked;
    projected[0] -= used.residual[0];
    projected[1] -= used.residual[1];
    for (const double slant : { -1.0, 1.0 })
    {
      drawing->AddPolyline({ moved(marked, -crossArm, -slant * crossArm), moved(marked, crossArm, slant * crossArm) });
    }
    std::vector<PointType> ring;
    for (unsigned int i = 0; i < ringPoints; ++i)
    {
      const double angle = fullCircle * i / ringPoints;
      ring.push_back(moved(projected, ringRadius * std::cos(angle), ringRadius * std::sin(angle)));
    }
    drawing->AddPolyline(ring, ToothCode(), true);
    drawing->AddPolyline({ marked, projected });
  }
  return drawing;
}
} // namespace

RegistrationOverlayFilter::Pointer
MakeCaseOverlay(const CaseResult & result, ToothCode::JawEnum jawName)
{
  const DentalCaseData & data = *result.data;
  const JawResult &      jaw = result.jaws.at(jawName);
  auto                   overlay = RegistrationOverlayFilter::New();
  if (data.image.IsNotNull())
  {
    overlay->SetRadiograph(data.image);
  }
  overlay->SetRadiographSize(data.imageSize[0], data.imageSize[1]);
  overlay->SetFixedContour(data.GetJaw(jawName).contour);
  // Number 0 is drawn bold: what was matched, where that is not the whole silhouette.
  unsigned int number = 0;
  for (auto contour = jaw.contours.rbegin(); contour != jaw.contours.rend(); ++contour)
  {
    overlay->SetMovingContour(number++,
                              contour->second,
                              contour->first == "whole" ? "silhouette of the whole scan" : "contour that was matched");
  }
  if (!jaw.usedLandmarks.empty() && result.data->cephalometricLandmarks.IsNotNull())
  {
    // Behind the contours, and never number 0.
    overlay->SetMovingContour(
      std::max(1u, number), DrawUsedLandmarks(result, jaw), "registered with (cross), on scan (ring)");
  }
  auto                          predicted = DentalLandmarkSet<2>::New();
  std::map<std::string, double> sigmas;
  for (const LandmarkPrediction & landmark : jaw.landmarks)
  {
    DentalLandmarkSet<2>::PointType point;
    point[0] = landmark.position[0];
    point[1] = landmark.position[1];
    predicted->AddLandmark(landmark.name, point);
    if (landmark.covariance)
    {
      sigmas[landmark.name] = landmark.GetSigma();
    }
  }
  overlay->SetPredictedLandmarks(predicted);
  overlay->SetLandmarkSigmas(sigmas);
  if (result.markedLandmarks.IsNotNull())
  {
    auto marked = DentalLandmarkSet<2>::New();
    for (const auto & landmark : result.markedLandmarks->GetLandmarks())
    {
      if (landmark.tooth.GetJaw() == jawName)
      {
        marked->AddLandmark(landmark.name, landmark.point);
      }
    }
    overlay->SetReferenceLandmarks(marked);
  }
  overlay->SetPixelSpacing(result.geometry->GetPixelSpacing());
  overlay->SetTitle(std::string(ToCapitalizedString(jawName)) + " jaw" +
                    (result.viewName.empty() ? "" : ", " + result.viewName));
  overlay->SetStatus(ToString(jaw.status));
  overlay->SetTextLines(MakeTextLines(result, jaw));
  return overlay;
}

void
WriteCaseOverlay(const CaseResult & result, ToothCode::JawEnum jaw, const std::string & fileName)
{
  const auto overlay = MakeCaseOverlay(result, jaw);
  overlay->Update();
  WritePicture(overlay->GetOutput(), fileName);
}
} // namespace itk

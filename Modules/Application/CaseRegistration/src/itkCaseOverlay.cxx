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
  for (const std::string & reason : jaw.reasons)
  {
    lines.push_back(reason);
  }
  return lines;
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
  overlay->SetTitle(jawName == ToothCode::JawEnum::Upper ? "Upper jaw" : "Lower jaw");
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

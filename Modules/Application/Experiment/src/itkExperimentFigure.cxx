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
#include "itkExperimentFigure.h"

#include "itkRegistrationOverlayFilter.h"
#include "itkWritePicture.h"

#include "itkTileImageFilter.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace itk
{
void
WriteExperimentFigure(const ExperimentCase &           experimentCase,
                      ExperimentRunner &               runner,
                      const std::vector<std::string> & methods,
                      ToothCode::JawEnum               jawName,
                      const std::string &              fileName)
{
  using PictureType = RegistrationOverlayFilter::PictureType;
  const DentalCaseData &                                     data = *experimentCase.data;
  auto                                                       tiles = TileImageFilter<PictureType, PictureType>::New();
  TileImageFilter<PictureType, PictureType>::LayoutArrayType layout;
  layout[0] = static_cast<unsigned int>(methods.size());
  layout[1] = 1;
  tiles->SetLayout(layout);

  auto marked = DentalLandmarkSet<2>::New();
  for (const auto & landmark : experimentCase.marked->GetLandmarks())
  {
    if (landmark.tooth.GetJaw() == jawName)
    {
      marked->AddLandmark(landmark.name, landmark.point);
    }
  }
  // The same part of the radiograph in every column.
  const auto * box = data.GetJaw(jawName).contour->GetBoundingBox();
  const double margin =
    0.35 * std::max(box->GetMaximum()[0] - box->GetMinimum()[0], box->GetMaximum()[1] - box->GetMinimum()[1]);
  unsigned int column = 0;
  for (const std::string & name : methods)
  {
    const ExperimentMethod & method = *FindExperimentMethod(name);
    const CaseResult         result = runner.Run(method);
    const auto               found = result.jaws.find(jawName);
    auto                     overlay = RegistrationOverlayFilter::New();
    overlay->SetPictureSize(1000, 640);
    if (data.image.IsNotNull())
    {
      overlay->SetRadiograph(data.image);
    }
    overlay->SetRadiographSize(data.imageSize[0], data.imageSize[1]);
    overlay->SetFixedContour(data.GetJaw(jawName).contour);
    overlay->SetReferenceLandmarks(marked);
    overlay->SetPixelSpacing(result.geometry->GetPixelSpacing());
    overlay->SetTitle(method.title);
    overlay->SetView(box->GetMinimum()[0] - margin,
                     box->GetMaximum()[0] + margin,
                     box->GetMinimum()[1] - margin,
                     box->GetMaximum()[1] + margin);
    std::vector<std::string> lines = { experimentCase.id +
                                       (jawName == ToothCode::JawEnum::Upper ? ", upper jaw" : ", lower jaw") };
    if (found != result.jaws.end() && found->second.registered)
    {
      const JawResult & jaw = found->second;
      unsigned int      number = 0;
      for (auto contour = jaw.contours.rbegin(); contour != jaw.contours.rend(); ++contour)
      {
        overlay->SetMovingContour(number++,
                                  contour->second,
                                  contour->first == "whole" ? "silhouette of the whole scan"
                                                            : "contour that was matched");
      }
      auto predicted = DentalLandmarkSet<2>::New();
      for (const LandmarkPrediction & landmark : jaw.landmarks)
      {
        if (marked->Find(landmark.name) != nullptr)
        {
          DentalLandmarkSet<2>::PointType point;
          point[0] = landmark.position[0];
          point[1] = landmark.position[1];
          predicted->AddLandmark(landmark.name, point);
        }
      }
      overlay->SetPredictedLandmarks(predicted);
      if (jaw.error)
      {
        std::ostringstream text;
        text << std::fixed << std::setprecision(2) << "landmark error " << jaw.error->mean << " px, mean of "
             << jaw.error->count;
        lines.push_back(text.str());
      }
    }
    else
    {
      lines.push_back("not registered");
    }
    overlay->SetTextLines(lines);
    overlay->Update();
    tiles->SetInput(column++, overlay->GetOutput());
  }
  tiles->Update();
  WritePicture(tiles->GetOutput(), fileName);
}
} // namespace itk

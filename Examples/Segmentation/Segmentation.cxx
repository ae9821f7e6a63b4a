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
// The crowns of a lateral radiograph by stock ITK filters, as contours that the robust registration takes.
#include "CrownSegmentation.h"

#include "itkCephalogramFileReader.h"
#include "itkContourMaskFilter.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalContourFileWriter.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkExtractImageFilter.h"
#include "itkLandmarkErrorFilter.h"
#include "itkPoseRegistrationMethod.h"
#include "itkRegistrationOverlayFilter.h"
#include "itkRegistrationVerdictFilter.h"
#include "itkSilhouetteContourFilter.h"
#include "itkUMidlineDentalAxisFilter.h"
#include "itkWritePicture.h"

#include <array>
#include <cstdlib>
#include <iostream>
#include <sstream>

namespace
{
using MeshType = itk::Mesh<float, 3>;

constexpr itk::ToothCode::JawEnum jaws[] = { itk::ToothCode::JawEnum::Upper, itk::ToothCode::JawEnum::Lower };

/** The outline of a label where the mask believes it: sub-pixel, closed, then cut to open stretches. */
itk::DentalContour::Pointer
OutlineOf(const LabelImageType * label, const LabelImageType * mask)
{
  auto outline = itk::SilhouetteContourFilter<LabelImageType>::New();
  outline->SetInput(label);
  outline->SetContent(itk::SilhouetteContourFilterEnums::Content::MergedLabels);
  outline->SetLabelSmoothing(1.0);
  auto believed = itk::ContourMaskFilter<LabelImageType>::New();
  believed->SetInput(outline->GetOutput());
  believed->SetMaskImage(mask);
  believed->SetMinimumNumberOfPoints(6);
  believed->Update();
  return believed->GetOutput();
}

void
Draw(const FloatImageType *                           radiograph,
     double                                           spacing,
     const std::array<itk::DentalContour::Pointer, 2> fixed,
     const std::array<itk::DentalContour::Pointer, 2> moving,
     const std::vector<std::string> &                 lines,
     const std::string &                              fileName)
{
  auto both = itk::DentalContour::New();
  for (const auto & contour : fixed)
  {
    for (const auto & polyline : contour->GetPolylines())
    {
      both->AddPolyline(polyline);
    }
  }
  auto overlay = itk::RegistrationOverlayFilter::New();
  overlay->SetRadiograph(radiograph);
  overlay->SetFixedContour(both);
  overlay->SetPixelSpacing(itk::RegistrationOverlayFilter::SpacingType(spacing));
  overlay->SetTitle("Outline by segmentation");
  overlay->SetTextLines(lines);
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    if (moving[jaw].IsNotNull())
    {
      overlay->SetMovingContour(jaw, moving[jaw], jaw == 0 ? "upper scan" : "lower scan");
    }
  }
  overlay->Update();
  itk::WritePicture(overlay->GetOutput(), fileName);
}

/** Segments; the contours of the upper and of the lower crowns. */
std::array<itk::DentalContour::Pointer, 2>
Segment(
  const FloatImageType * radiograph, itk::Size<2> imageSize, double spacing, int facing, const std::string & folder)
{
  const CrownSegmentation                          segmentation = SegmentCrowns(radiograph, spacing, facing);
  const std::array<itk::DentalContour::Pointer, 2> contours{
    { OutlineOf(segmentation.upper, segmentation.upperBorder), OutlineOf(segmentation.lower, segmentation.lowerBorder) }
  };
  WriteLabels(segmentation, folder + "/labels.png");
  auto writer = itk::DentalContourFileWriter::New();
  writer->SetUpper(contours[0]);
  writer->SetLower(contours[1]);
  writer->SetImageSize(imageSize);
  writer->SetFileName(folder + "/contours.json");
  writer->Update();
  std::cout << "upper points: " << contours[0]->GetNumberOfPoints()
            << "\nlower points: " << contours[1]->GetNumberOfPoints() << std::endl;
  return contours;
}

void
SegmentAndRegister(const std::string & caseFile, const std::string & folder)
{
  const itk::DentalCase description = itk::ReadDentalCase(caseFile);
  const auto            data = itk::LoadDentalCase(description);
  const auto            contours = Segment(data->image,
                                data->image->GetLargestPossibleRegion().GetSize(),
                                data->geometry->GetPixelSpacing()[0],
                                data->geometry->GetFacing() == itk::CephalometricGeometry::FacingEnum::Right ? 1 : -1,
                                folder);

  // What one outline of both sides determines: pitch, shift and scale, not which side hangs lower.
  itk::PoseRegistrationOptions options;
  options.useSideSelection = false;
  options.useFullPose = false;
  options.yawStarts = { 0.0 };
  options.kappaSigma = 0.008;
  options.estimateNoise = false;
  options.initialSmoothSigma = 2.0;
  // The scans are in occlusion: one frame for both, hence one pose.
  auto axis = itk::UMidlineDentalAxisFilter<MeshType>::New();
  axis->SetUpperMesh(data->upper.mesh);
  axis->SetLowerMesh(data->lower.mesh);
  axis->SetJawsShareFrame(itk::DentalFrameEnums::JawsShareFrame::On);
  axis->RefineMidlineOn();

  auto registration = itk::PoseRegistrationMethod<MeshType>::New();
  registration->SetJointFrame(axis->GetJointTransformOutput());
  registration->SetOptions(options);
  registration->SetUpperMesh(data->upper.mesh);
  registration->SetLowerMesh(data->lower.mesh);
  registration->SetUpperContour(contours[0]);
  registration->SetLowerContour(contours[1]);
  registration->SetGeometry(data->geometry);
  registration->SetPrincipalPointKnown(data->HasPrincipalPoint());
  auto verdict = itk::RegistrationVerdictFilter::New();
  verdict->SetSolution(registration->GetOutput());
  verdict->Update();

  const itk::PoseSolution *                  solution = registration->GetOutput();
  std::array<itk::DentalContour::Pointer, 2> moving;
  auto                                       predicted = itk::DentalLandmarkSet<2>::New();
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    // Both scans have one pose: where a jaw shows too little of a border, the other one's serves.
    const auto * geometry = registration->GetGeometryOutput(jaws[solution->IsRegistered(jaws[jaw]) ? jaw : 1 - jaw]);
    moving[jaw] = solution->MakeMovingContour(jaws[jaw]);
    for (const auto & landmark : data->landmarks3D->GetLandmarks())
    {
      if (landmark.tooth.GetJaw() == jaws[jaw])
      {
        const auto pixel = geometry->ProjectPoint(landmark.point);
        predicted->AddLandmark(landmark.name, pixel);
      }
    }
  }
  auto marked = itk::DentalLandmarkFileReader<2>::New();
  marked->SetFileName(description.landmarks2DFile);
  auto errors = itk::LandmarkErrorFilter::New();
  errors->SetPredictedLandmarks(predicted);
  errors->SetReferenceLandmarks(marked->GetOutput());
  std::vector<std::string> lines;
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    errors->SetJaw(jaws[jaw]);
    errors->Update();
    std::ostringstream line;
    line << (jaw == 0 ? "upper" : "lower") << " landmark error px: " << errors->GetStatistics().GetMean();
    std::cout << line.str() << std::endl;
    lines.push_back(line.str());
    const char * const verdicts[] = { "ok", "suspect", "failed" };
    std::cout << (jaw == 0 ? "upper" : "lower")
              << " verdict: " << verdicts[static_cast<int>(verdict->GetVerdict(jaws[jaw]).status)] << std::endl;
    for (const auto & reason : verdict->GetVerdict(jaws[jaw]).findings)
    {
      lines.push_back("  " + reason.code);
    }
  }
  Draw(data->image, data->geometry->GetPixelSpacing()[0], contours, moving, lines, folder + "/overlay.png");
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 3 && argc != 5 && argc != 9)
  {
    std::cerr << "Usage: " << argv[0] << " case.json folder\n       " << argv[0]
              << " radiograph pixelSpacing_mm right|left folder [firstU firstV lastU lastV]" << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    if (argc == 3)
    {
      SegmentAndRegister(argv[1], argv[2]);
    }
    else
    {
      auto reader = itk::CephalogramFileReader::New();
      reader->SetFileName(argv[1]);
      reader->Update();
      // A frame drawn around the teeth: other dense things are then no matter.
      auto window = itk::ExtractImageFilter<FloatImageType, FloatImageType>::New();
      auto region = reader->GetOutput()->GetLargestPossibleRegion();
      for (unsigned int d = 0; argc == 9 && d < 2; ++d)
      {
        region.SetIndex(d, std::atoi(argv[5 + d]));
        region.SetSize(d, std::atoi(argv[7 + d]) - std::atoi(argv[5 + d]) + 1);
      }
      window->SetInput(reader->GetOutput());
      window->SetExtractionRegion(region);
      window->Update();
      const auto contours = Segment(window->GetOutput(),
                                    reader->GetOutput()->GetLargestPossibleRegion().GetSize(),
                                    std::atof(argv[2]),
                                    std::string(argv[3]) == "left" ? -1 : 1,
                                    argv[4]);
      Draw(reader->GetOutput(), std::atof(argv[2]), contours, {}, {}, std::string(argv[4]) + "/overlay.png");
    }
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

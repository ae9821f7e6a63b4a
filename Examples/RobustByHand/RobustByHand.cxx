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
// Preset "robust" of the program, chained by hand: scans and tracing in, pose, verdict, landmarks and a picture out.
// One Update() on the last object runs all of it; the numbers are those of "dentalscr register", to the last bit.
#include "itkCephalogramFileReader.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkLandmarkProjectionFilter.h"
#include "itkMeshFileReader.h"
#include "itkMidlineSideMeshFilter.h"
#include "itkOpenMeshMeshIOFactory.h"
#include "itkOpenSilhouetteContourSource.h"
#include "itkPoseRegistrationMethod.h"
#include "itkRegistrationOverlayFilter.h"
#include "itkRegistrationVerdictFilter.h"
#include "itkUMidlineDentalAxisFilter.h"
#include "itkWritePicture.h"

#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

int
main(int argc, char * argv[])
{
  if (argc != 10)
  {
    std::cerr << "Usage: " << argv[0]
              << " upper.stl lower.stl contours.json landmarks3d.json ceph.png pixelSpacing_mm principalU principalV"
                 " overlay.png"
              << std::endl;
    return EXIT_FAILURE;
  }
  using MeshType = itk::Mesh<float, 3>;
  using JawEnum = itk::ToothCode::JawEnum;
  try
  {
    // Readers.
    itk::RegisterOpenMeshMeshIOFactories();
    auto upper = itk::MeshFileReader<MeshType>::New();
    upper->SetFileName(argv[1]);
    auto lower = itk::MeshFileReader<MeshType>::New();
    lower->SetFileName(argv[2]);
    auto tracing = itk::DentalContourFileReader::New();
    tracing->SetFileName(argv[3]);
    auto landmarks = itk::DentalLandmarkFileReader<3>::New();
    landmarks->SetFileName(argv[4]);
    auto radiograph = itk::CephalogramFileReader::New();
    radiograph->SetFileName(argv[5]);

    // What is known of the X-ray geometry. The patient faces right and the source is on the right unless said
    // otherwise.
    itk::CephalometricGeometry::PixelIndexType principalPoint;
    principalPoint[0] = std::stod(argv[7]);
    principalPoint[1] = std::stod(argv[8]);
    auto geometry = itk::CephalometricGeometry::New();
    geometry->SetPixelSpacing(itk::CephalometricGeometry::PixelSpacingType(std::stod(argv[6])));
    geometry->SetPrincipalPoint(principalPoint);

    // The frames of the teeth: one of each jaw, and one of both where they are in occlusion.
    auto axis = itk::UMidlineDentalAxisFilter<MeshType>::New();
    axis->SetUpperMesh(upper->GetOutput());
    axis->SetLowerMesh(lower->GetOutput());
    axis->RefineMidlineOn();

    auto registration = itk::PoseRegistrationMethod<MeshType>::New();
    registration->SetUpperMesh(upper->GetOutput());
    registration->SetLowerMesh(lower->GetOutput());
    registration->SetUpperContour(tracing->GetUpperOutput());
    registration->SetLowerContour(tracing->GetLowerOutput());
    registration->SetGeometry(geometry);
    registration->SetUpperFrame(axis->GetUpperTransformOutput());
    registration->SetLowerFrame(axis->GetLowerTransformOutput());
    registration->SetJointFrame(axis->GetJointTransformOutput());

    // What lies downstream of it.
    auto verdict = itk::RegistrationVerdictFilter::New();
    verdict->SetSolution(registration->GetOutput());
    auto projection = itk::LandmarkProjectionFilter::New();
    projection->SetSolution(registration->GetOutput());
    projection->SetLandmarks(landmarks->GetOutput());
    // The outline that the registration matched: the traced half of the scan, where it faces the other jaw or the lips.
    auto half = itk::MidlineSideMeshFilter<MeshType>::New();
    half->SetInput(upper->GetOutput());
    half->SetFrameTransformInput(axis->GetUpperTransformOutput());
    auto outline = itk::OpenSilhouetteContourSource<MeshType>::New();
    outline->SetInput(half->GetOutput());
    outline->SetFrameTransformInput(axis->GetUpperTransformOutput());
    outline->SetGeometry(registration->GetGeometryOutput(JawEnum::Upper));
    auto overlay = itk::RegistrationOverlayFilter::New();
    overlay->SetRadiograph(radiograph->GetOutput());
    overlay->SetFixedContour(tracing->GetUpperOutput());
    overlay->SetMovingContour(0, outline->GetOutput(), "outline of the upper scan");
    overlay->SetPixelSpacing(geometry->GetPixelSpacing());
    overlay->SetPredictedLandmarks(projection->GetOutput());

    // The verdict comes first, since the picture shows it; the second Update() runs only what the first did not need.
    const char * const words[] = { "ok", "suspect", "failed" };
    verdict->Update();
    overlay->SetStatus(words[static_cast<int>(verdict->GetVerdict(JawEnum::Upper).status)]);
    overlay->Update();
    itk::WritePicture(overlay->GetOutput(), argv[9]);

    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      const std::string name = itk::ToString(jaw);
      std::cout << name << " verdict: " << words[static_cast<int>(verdict->GetVerdict(jaw).status)] << std::endl;
      for (const auto & finding : verdict->GetVerdict(jaw).findings)
      {
        std::cout << name << " reason: " << finding.code << ", " << finding.text << std::endl;
      }
    }
    std::cout.precision(std::numeric_limits<double>::max_digits10);
    for (const auto & landmark : projection->GetOutput()->GetLandmarks())
    {
      std::cout << landmark.name << " u: " << landmark.point[0] << '\n'
                << landmark.name << " v: " << landmark.point[1] << '\n'
                << landmark.name << " sigma px: " << projection->GetSigma(landmark.name) << std::endl;
    }
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << std::endl;
    return EXIT_FAILURE;
  }
  catch (const std::exception & error)
  {
    std::cerr << "The pixel spacing and the principal point are numbers (" << error.what() << ")." << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

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
// The paper's chain in ten lines: reader, dental axis, surface DRR, contour, registration. One Update() on the last
// runs all of it. It is 20 to 45 px off on cases with known answers: Examples/RobustByHand is what to use.
#include "itkCephalometricGeometry.h"
#include "itkContourResampleFilter.h"
#include "itkDentalContourFileReader.h"
#include "itkMeshFileReader.h"
#include "itkOpenMeshMeshIOFactory.h"
#include "itkRegistrationIterationCommand.h"
#include "itkSilhouetteContourFilter.h"
#include "itkSilhouetteToContourRegistrationMethod.h"
#include "itkSurfaceDRRImageSource.h"
#include "itkUMidlineDentalAxisFilter.h"

#include <cstdlib>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 4)
  {
    std::cerr << "Usage: " << argv[0] << " upper.stl contours.json pixelSpacing_mm" << std::endl;
    return EXIT_FAILURE;
  }
  using MeshType = itk::Mesh<float, 3>;
  using ImageType = itk::Image<float, 2>;
  try
  {
    itk::RegisterOpenMeshMeshIOFactories();
    auto reader = itk::MeshFileReader<MeshType>::New();
    auto tracing = itk::DentalContourFileReader::New();
    auto axis = itk::UMidlineDentalAxisFilter<MeshType>::New();
    auto geometry = itk::CephalometricGeometry::New();
    auto drr = itk::SurfaceDRRImageSource<MeshType, ImageType>::New();
    auto silhouette = itk::SilhouetteContourFilter<ImageType>::New();
    auto resample = itk::ContourResampleFilter::New();
    auto registration = itk::SilhouetteToContourRegistrationMethod::New();

    reader->SetFileName(argv[1]);
    tracing->SetFileName(argv[2]);
    geometry->SetPixelSpacing(itk::CephalometricGeometry::PixelSpacingType(std::atof(argv[3])));

    axis->SetUpperMesh(reader->GetOutput());
    drr->SetInput(axis->GetUpperOutput());
    drr->SetGeometry(geometry);
    silhouette->SetInput(drr->GetOutput());
    silhouette->SetLevel(itk::SilhouetteContourFilterEnums::Level::Absolute);
    silhouette->SetLevelValue(0.5); // half a shell
    resample->SetInput(silhouette->GetOutput());
    resample->SetNumberOfPoints(441);
    registration->SetFixedContour(tracing->GetUpperOutput());
    registration->SetMovingContour(resample->GetOutput());

    auto log = itk::RegistrationIterationCommand::New();
    log->SetStream(&std::clog);
    log->Observe(registration);
    registration->Update();

    const auto * transform = registration->GetTransform();
    std::cout << "scale: " << transform->GetScale() << "\nangle: " << transform->GetAngle()
              << "\ntranslation u: " << transform->GetTranslation()[0]
              << "\ntranslation v: " << transform->GetTranslation()[1] << std::endl;
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

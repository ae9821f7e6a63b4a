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
// The chain from a phantom's mesh to a registered silhouette, with the installed headers and libraries alone.
#include "itkCephalometricGeometry.h"
#include "itkDentalPhantomMeshSource.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkSilhouetteToContourRegistrationMethod.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

int
main()
{
  auto phantom = itk::DentalPhantomMeshSource<>::New();
  auto geometry = itk::CephalometricGeometry::New();
  geometry->SetPixelSpacing(itk::CephalometricGeometry::PixelSpacingType(0.25));

  auto silhouette = itk::MeshSilhouetteContourSource<itk::Mesh<float, 3>>::New();
  silhouette->SetInput(phantom->GetUpperOutput());
  silhouette->SetGeometry(geometry);
  silhouette->SetNumberOfPoints(441);
  silhouette->Update();

  // The same contour, 12 px to the right: the answer is known.
  auto fixed = itk::DentalContour::New();
  for (auto polyline : silhouette->GetOutput()->GetPolylines())
  {
    for (auto & point : polyline.points)
    {
      point[0] += 12.0;
    }
    fixed->AddPolyline(polyline);
  }
  auto registration = itk::SilhouetteToContourRegistrationMethod::New();
  registration->SetFixedContour(fixed);
  registration->SetMovingContour(silhouette->GetOutput());
  registration->Update();
  const auto shift = registration->GetTransform()->GetTranslation();
  std::cout << "shift " << shift << std::endl;
  return std::abs(shift[0] - 12.0) < 0.05 && std::abs(shift[1]) < 0.05 ? EXIT_SUCCESS : EXIT_FAILURE;
}

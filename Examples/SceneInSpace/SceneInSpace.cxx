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
// A registered case in space: the chain ends in VTK, with a picture and with files for other programs.
#include "itkCaseRegistration.h"
#include "itkCaseScene.h"
#include "itkDentalCaseReader.h"
#include "itkMeshToVTKPolyDataFilter.h"
#include "itkRegistrationSceneWindow.h"
#include "itkVTKPolyDataToMeshFilter.h"
#include "itkVirtualScreen.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
using MeshType = itk::ScenePart::MeshType;

/** How far apart the ray through a landmark and the landmark's image are, on the detector, mm: a straight ray is a pose
 * that explains the picture. */
double
MeasureLargestBend(const itk::ScenePart & rays)
{
  double largest = 0.0;
  for (itk::IdentifierType i = 0; i + 2 < rays.mesh->GetNumberOfPoints(); i += 3)
  {
    const auto source = rays.mesh->GetPoint(i);
    const auto toEnd = rays.mesh->GetPoint(i + 2) - source;
    const auto toScan = rays.mesh->GetPoint(i + 1) - source;
    largest = std::max<double>(largest, itk::CrossProduct(toScan, toEnd).GetNorm() / toScan.GetNorm());
  }
  return largest;
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " case.json folder" << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    auto reader = itk::DentalCaseReader::New();
    reader->SetFileName(argv[1]);
    auto registration = itk::CaseRegistration::New();
    registration->SetPreset(itk::CasePresetEnum::Robust);
    registration->SetInput(reader->GetOutput());
    registration->Update();

    // 1. The scene: named parts in the cephalostat frame, no VTK yet. A second radiograph is one more AddView().
    const auto source = itk::MakeCaseScene(registration->GetResult());
    source->Update();
    const itk::RegistrationScene * const scene = source->GetOutput();
    std::cout << "parts: " << scene->GetParts().size() << '\n';
    std::cout << "source mm: " << scene->FindDetector("lateral")->GetSource()[1] << '\n';
    std::cout << "largest bend of a ray mm: " << MeasureLargestBend(*scene->FindPart("lateral upper rays")) << '\n';

    // 2. A scan to VTK, where its filters are, and back.
    auto toVTK = itk::MeshToVTKPolyDataFilter<MeshType>::New();
    toVTK->SetInput(scene->FindPart("upper scan")->mesh);
    auto fromVTK = itk::VTKPolyDataToMeshFilter<MeshType>::New();
    toVTK->Update();
    fromVTK->SetInput(toVTK->GetOutput());
    fromVTK->Update();
    std::cout << "triangles: " << fromVTK->GetOutput()->GetNumberOfCells() << '\n';

    // 3. Files for other programs, and a picture, which needs an X server: one that nobody sees will do.
    const std::string folder = argv[2];
    auto              window = itk::RegistrationSceneWindow::New();
    window->SetScene(scene);
    window->WriteExport(folder + "/scene.gltf");
    window->WriteExport(folder + "/scene.vtp");
    if (!itk::VirtualScreen::FindProgram().empty())
    {
      const itk::VirtualScreen screen(1200, 900);
      window->WriteSnapshot(folder + "/scene.png");
    }
    // window->Show() opens a window instead.
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

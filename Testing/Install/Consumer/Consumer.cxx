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
// A mesh made by hand to a radiograph of DentalSCR's, through ITK's own image factories to a file and back.
#include "itkSurfaceDRRImageSource.h"

#include "itkImageFileReader.h"
#include "itkImageFileWriter.h"
#include "itkRescaleIntensityImageFilter.h"
#include "itkTriangleCell.h"

#include <cstdlib>
#include <iostream>

int
main(int argc, char * argv[])
{
  using MeshType = itk::Mesh<float, 3>;
  using ImageType = itk::Image<float, 2>;
  using ByteType = itk::Image<unsigned char, 2>;
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " drr.png drr.mha" << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    auto        mesh = MeshType::New();
    const float corners[3][3] = { { 0.0f, 0.0f, 0.0f }, { 10.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 10.0f } };
    for (unsigned int i = 0; i < 3; ++i)
    {
      mesh->SetPoint(i, MeshType::PointType(corners[i]));
    }
    MeshType::CellAutoPointer       cell;
    const MeshType::PointIdentifier ids[3] = { 0, 1, 2 };
    cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
    cell->SetPointIds(ids);
    mesh->SetCell(0, cell);

    auto geometry = itk::CephalometricGeometry::New();
    geometry->SetPixelSpacing(itk::CephalometricGeometry::PixelSpacingType(0.25));
    auto drr = itk::SurfaceDRRImageSource<MeshType, ImageType>::New();
    drr->SetInput(mesh);
    drr->SetGeometry(geometry);
    drr->SetSigma(2.0);
    auto bytes = itk::RescaleIntensityImageFilter<ImageType, ByteType>::New();
    bytes->SetInput(drr->GetOutput());

    auto picture = itk::ImageFileWriter<ByteType>::New();
    picture->SetInput(bytes->GetOutput());
    picture->SetFileName(argv[1]);
    picture->Update();
    auto image = itk::ImageFileWriter<ImageType>::New();
    image->SetInput(drr->GetOutput());
    image->SetFileName(argv[2]);
    image->Update();
    auto reader = itk::ImageFileReader<ImageType>::New();
    reader->SetFileName(argv[2]);
    reader->Update();
    const auto size = reader->GetOutput()->GetLargestPossibleRegion().GetSize();
    std::cout << "size " << size[0] << ' ' << size[1] << std::endl;
    return size == drr->GetOutput()->GetLargestPossibleRegion().GetSize() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << std::endl;
    return EXIT_FAILURE;
  }
}

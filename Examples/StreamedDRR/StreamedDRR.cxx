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
// A simulated radiograph larger than one would hold in memory, written strip by strip.
#include "itkCephalometricGeometry.h"
#include "itkDentalPhantomMeshSource.h"
#include "itkImageFileReader.h"
#include "itkImageFileWriter.h"
#include "itkMetaImageIO.h"
#include "itkSurfaceDRRImageSource.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

using MeshType = itk::Mesh<float, 3>;
using ImageType = itk::Image<unsigned char, 2>;
using SourceType = itk::SurfaceDRRImageSource<MeshType, ImageType>;

namespace
{
SourceType::Pointer
MakeSource(const MeshType * mesh, double pixelSpacing)
{
  auto geometry = itk::CephalometricGeometry::New();
  geometry->SetPixelSpacing(itk::CephalometricGeometry::PixelSpacingType(pixelSpacing));
  auto drr = SourceType::New();
  drr->SetInput(mesh);
  drr->SetGeometry(geometry);
  drr->SetOutputMode(itk::SurfaceDRRImageSourceEnums::Output::InvertedIntensity);
  drr->SetSourceIntensity(255.0);
  return drr;
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 4)
  {
    std::cerr << "Usage: " << argv[0] << " pixelSpacing_mm strips drr.mha" << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    auto phantom = itk::DentalPhantomMeshSource<MeshType>::New();
    phantom->Update();
    const MeshType * mesh = phantom->GetUpperOutput();

    // The writer asks for one strip after another and writes each before it asks for the next.
    const auto drr = MakeSource(mesh, std::atof(argv[1]));
    auto       writer = itk::ImageFileWriter<ImageType>::New();
    writer->SetInput(drr->GetOutput());
    writer->SetImageIO(itk::MetaImageIO::New());
    writer->SetNumberOfStreamDivisions(std::atoi(argv[2]));
    writer->SetFileName(argv[3]);
    writer->Update();
    const auto whole = drr->GetOutput()->GetLargestPossibleRegion();
    const auto strip = drr->GetOutput()->GetBufferedRegion();
    std::cout << "megapixels: " << 1e-6 * static_cast<double>(whole.GetNumberOfPixels()) << "\nlargest part in memory: "
              << static_cast<double>(strip.GetNumberOfPixels()) / static_cast<double>(whole.GetNumberOfPixels())
              << "\nprojections of the mesh: " << drr->GetNumberOfProjections() << std::endl;

    // A strip across the middle by a source of its own: the same bits.
    auto       again = MakeSource(mesh, std::atof(argv[1]));
    auto       region = whole;
    const auto rows = std::min<itk::SizeValueType>(64, whole.GetSize(1));
    region.SetIndex(1, whole.GetIndex(1) + static_cast<itk::IndexValueType>((whole.GetSize(1) - rows) / 2));
    region.SetSize(1, rows);
    again->UpdateOutputInformation();
    again->GetOutput()->SetRequestedRegion(region);
    again->GetOutput()->Update();
    auto reader = itk::ImageFileReader<ImageType>::New();
    reader->SetImageIO(itk::MetaImageIO::New());
    reader->SetFileName(argv[3]);
    reader->UpdateOutputInformation();
    // A file has no start index.
    auto inFile = region;
    inFile.SetIndex(0, 0);
    inFile.SetIndex(1, region.GetIndex(1) - whole.GetIndex(1));
    reader->GetOutput()->SetRequestedRegion(inFile);
    reader->Update();
    std::size_t different = 0;
    for (itk::SizeValueType row = 0; row < rows; ++row)
    {
      for (itk::SizeValueType column = 0; column < region.GetSize(0); ++column)
      {
        const auto c = static_cast<itk::IndexValueType>(column);
        const auto r = static_cast<itk::IndexValueType>(row);
        different += again->GetOutput()->GetPixel({ { region.GetIndex(0) + c, region.GetIndex(1) + r } }) !=
                         reader->GetOutput()->GetPixel({ { c, inFile.GetIndex(1) + r } })
                       ? 1
                       : 0;
      }
    }
    std::cout << "different pixels: " << different << std::endl;
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

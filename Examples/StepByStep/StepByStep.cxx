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
// Each step of the chain alone, with its picture: axes, simulated radiograph, contour, registration.
#include "itkContourResampleFilter.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkImageFileWriter.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkPNGImageIO.h"
#include "itkRegistrationOverlayFilter.h"
#include "itkSilhouetteContourFilter.h"
#include "itkSilhouetteToContourRegistrationMethod.h"
#include "itkSurfaceDRRImageSource.h"
#include "itkUMidlineDentalAxisFilter.h"
#include "itkWritePicture.h"

#include <cstdlib>
#include <iostream>

using MeshType = itk::Mesh<float, 3>;
using ImageType = itk::Image<float, 2>;
using PictureType = itk::Image<unsigned char, 2>;

namespace
{
/** A radiograph of a mesh as a picture. */
void
WriteRadiograph(const MeshType * mesh, const itk::CephalometricGeometry * geometry, const std::string & fileName)
{
  auto drr = itk::SurfaceDRRImageSource<MeshType, PictureType>::New();
  drr->SetInput(mesh);
  drr->SetGeometry(geometry);
  drr->SetOutputMode(itk::SurfaceDRRImageSourceEnums::Output::InvertedIntensity);
  drr->SetSourceIntensity(255.0);
  drr->SetCoverMargin(5.0);
  auto writer = itk::ImageFileWriter<PictureType>::New();
  writer->SetInput(drr->GetOutput());
  writer->SetImageIO(itk::PNGImageIO::New());
  writer->SetFileName(fileName);
  writer->Update();
}

itk::DentalContour::Pointer
Move(const itk::DentalContour * contour, const itk::Similarity2DTransform<double> * transform)
{
  auto moved = itk::DentalContour::New();
  for (auto polyline : contour->GetPolylines())
  {
    for (auto & point : polyline.points)
    {
      point = transform->TransformPoint(point);
    }
    moved->AddPolyline(polyline);
  }
  return moved;
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
  const std::string folder = std::string(argv[2]) + "/";
  try
  {
    // 0. What a case holds: scans in mm, tracing in pixels, radiograph, geometry.
    const auto data = itk::LoadDentalCase(itk::ReadDentalCase(argv[1]));

    // 1. The anatomical frame. Its axes as rods, to look at.
    auto axis = itk::UMidlineDentalAxisFilter<MeshType>::New();
    axis->SetUpperMesh(data->upper.mesh);
    axis->EmbedAxesOn();
    axis->SetAxesLength(25.0);
    axis->Update();
    std::cout << "arch width mm: " << axis->GetArchWidth(itk::ToothCode::JawEnum::Upper) << std::endl;
    // The frame seen by a source far above: z becomes y.
    auto fromAbove = itk::CephalometricGeometry::New();
    fromAbove->SetPixelSpacing(data->geometry->GetPixelSpacing());
    itk::CephalometricGeometry::RotationType turn;
    turn.SetIdentity();
    turn(1, 1) = 0.0;
    turn(1, 2) = 1.0;
    turn(2, 1) = -1.0;
    turn(2, 2) = 0.0;
    fromAbove->SetPose(turn, itk::CephalometricGeometry::VectorType(0.0));
    WriteRadiograph(axis->GetUpperOutput(), fromAbove, folder + "1-axes.png");

    // 2. The simulated lateral radiograph: central ray through the origin of the frame.
    axis->EmbedAxesOff();
    axis->Update();
    WriteRadiograph(axis->GetUpperOutput(), data->geometry, folder + "2-radiograph.png");

    // 3. The contour: from the thickness at half a shell as the paper does, and exactly from the mesh.
    auto nominal = itk::CephalometricGeometry::New();
    nominal->CopyParameters(data->geometry);
    nominal->SetPrincipalPoint(itk::CephalometricGeometry::PixelIndexType());
    auto drr = itk::SurfaceDRRImageSource<MeshType, ImageType>::New();
    drr->SetInput(axis->GetUpperOutput());
    drr->SetGeometry(nominal);
    auto silhouette = itk::SilhouetteContourFilter<ImageType>::New();
    silhouette->SetInput(drr->GetOutput());
    silhouette->SetLevel(itk::SilhouetteContourFilterEnums::Level::Absolute);
    silhouette->SetLevelValue(0.5);
    auto resample = itk::ContourResampleFilter::New();
    resample->SetInput(silhouette->GetOutput());
    resample->SetNumberOfPoints(441);
    resample->Update();
    auto exact = itk::MeshSilhouetteContourSource<MeshType>::New();
    exact->SetInput(axis->GetUpperOutput());
    exact->SetGeometry(nominal);
    exact->Update();
    auto overlay = itk::RegistrationOverlayFilter::New();
    overlay->SetFixedContour(exact->GetOutput());
    overlay->SetMovingContour(0, resample->GetOutput(), "at half a shell of the radiograph");
    overlay->SetTitle("Contours");
    overlay->Update();
    itk::WritePicture(overlay->GetOutput(), folder + "3-contour.png");
    std::cout << "contour length px: " << resample->GetOutput()->GetLength()
              << "\nexact contour length px: " << exact->GetOutput()->GetLength() << std::endl;

    // 4. The registration, and where it put the contour.
    auto registration = itk::SilhouetteToContourRegistrationMethod::New();
    registration->SetFixedContour(data->upper.contour);
    registration->SetMovingContour(resample->GetOutput());
    registration->SetPixelSpacing(data->geometry->GetPixelSpacing()[0]);
    registration->Update();
    const auto moved = Move(resample->GetOutput(), registration->GetTransform());
    auto       result = itk::RegistrationOverlayFilter::New();
    result->SetRadiograph(data->image);
    result->SetFixedContour(data->upper.contour);
    result->SetMovingContour(0, moved, "aligned contour");
    result->SetPixelSpacing(data->geometry->GetPixelSpacing());
    result->SetTitle("Registration");
    result->Update();
    itk::WritePicture(result->GetOutput(), folder + "4-registration.png");
    std::cout << "scale: " << registration->GetTransform()->GetScale()
              << "\nmetric px: " << registration->GetMetricValue() << std::endl;
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

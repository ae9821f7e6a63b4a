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
// The chain of Documentation: one Update() on the last object runs all of it, and only what lies downstream runs again.
#include "itkContourDistanceFilter.h"
#include "itkContourResampleFilter.h"
#include "itkDentalPhantomMeshSource.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkSilhouetteContourFilter.h"
#include "itkSilhouetteToContourRegistrationMethod.h"
#include "itkSurfaceDRRImageSource.h"
#include "itkUMidlineDentalAxisFilter.h"

#include "itkCommand.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace
{
using MeshType = itk::Mesh<float, 3>;
using ImageType = itk::Image<float, 2>;

class RegistrationChain : public ::testing::Test
{
protected:
  void
  SetUp() override
  {
    itk::DentalPhantomParameters parameters;
    parameters.numberOfTriangles = 8000;
    m_Phantom->SetParameters(parameters);
    m_Geometry->SetPixelSpacing(itk::CephalometricGeometry::PixelSpacingType(0.25));

    m_Axis->SetUpperMesh(m_Phantom->GetUpperOutput());
    m_DRR->SetInput(m_Axis->GetUpperOutput());
    m_DRR->SetGeometry(m_Geometry);
    m_Silhouette->SetInput(m_DRR->GetOutput());
    m_Silhouette->SetLevel(itk::SilhouetteContourFilterEnums::Level::Absolute);
    m_Silhouette->SetLevelValue(0.5);
    m_Resample->SetInput(m_Silhouette->GetOutput());
    m_Resample->SetNumberOfPoints(200);

    // The fixed contour: the exact silhouette, moved by hand.
    auto exact = itk::MeshSilhouetteContourSource<MeshType>::New();
    exact->SetInput(m_Axis->GetUpperOutput());
    exact->SetGeometry(m_Geometry);
    exact->SetNumberOfPoints(150);
    exact->Update();
    for (auto polyline : exact->GetOutput()->GetPolylines())
    {
      for (auto & point : polyline.points)
      {
        point[0] += 30.0;
        point[1] -= 12.0;
      }
      m_Fixed->AddPolyline(polyline);
    }
    m_Registration->SetFixedContour(m_Fixed);
    m_Registration->SetMovingContour(m_Resample->GetOutput());
    m_Distances->SetFixedContour(m_Fixed);
    m_Distances->SetMovingContour(m_Resample->GetOutput());
    m_Distances->SetTransformInput(m_Registration->GetOutput());

    this->Count("phantom", m_Phantom);
    this->Count("axis", m_Axis);
    this->Count("drr", m_DRR);
    this->Count("silhouette", m_Silhouette);
    this->Count("resample", m_Resample);
    this->Count("registration", m_Registration);
    this->Count("distances", m_Distances);
  }

  void
  Count(const std::string & name, itk::ProcessObject * process)
  {
    m_Executions[name] = 0;
    process->AddObserver(itk::StartEvent(), [this, name](const itk::EventObject &) { ++m_Executions[name]; });
  }

  std::map<std::string, int>
  Run()
  {
    for (auto & entry : m_Executions)
    {
      entry.second = 0;
    }
    m_Distances->Update();
    return m_Executions;
  }

  itk::DentalPhantomMeshSource<MeshType>::Pointer          m_Phantom{ itk::DentalPhantomMeshSource<MeshType>::New() };
  itk::UMidlineDentalAxisFilter<MeshType>::Pointer         m_Axis{ itk::UMidlineDentalAxisFilter<MeshType>::New() };
  itk::CephalometricGeometry::Pointer                      m_Geometry{ itk::CephalometricGeometry::New() };
  itk::SurfaceDRRImageSource<MeshType, ImageType>::Pointer m_DRR{
    itk::SurfaceDRRImageSource<MeshType, ImageType>::New()
  };
  itk::SilhouetteContourFilter<ImageType>::Pointer    m_Silhouette{ itk::SilhouetteContourFilter<ImageType>::New() };
  itk::ContourResampleFilter::Pointer                 m_Resample{ itk::ContourResampleFilter::New() };
  itk::DentalContour::Pointer                         m_Fixed{ itk::DentalContour::New() };
  itk::SilhouetteToContourRegistrationMethod::Pointer m_Registration{
    itk::SilhouetteToContourRegistrationMethod::New()
  };
  itk::ContourDistanceFilter::Pointer m_Distances{ itk::ContourDistanceFilter::New() };
  std::map<std::string, int>          m_Executions;
};
} // namespace

TEST_F(RegistrationChain, OneUpdateOnTheLastRunsWhatIsMissingAndFindsTheShift)
{
  const auto executions = this->Run();
  for (const char * name : { "drr", "silhouette", "resample", "registration", "distances" })
  {
    EXPECT_EQ(executions.at(name), 1) << name;
  }
  const auto translation = m_Registration->GetTransform()->GetTranslation();
  // The contour of the DRR is the exact one up to the splats' width, about two pixels.
  EXPECT_NEAR(translation[0], 30.0, 2.0);
  EXPECT_NEAR(translation[1], -12.0, 2.0);
  EXPECT_LT(m_Distances->GetChamfer(), 4.0);
}

TEST_F(RegistrationChain, NothingRunsAgainWhereNothingChanged)
{
  this->Run();
  for (const auto & execution : this->Run())
  {
    EXPECT_EQ(execution.second, 0) << execution.first;
  }
}

TEST_F(RegistrationChain, AParameterReExecutesOnlyWhatLiesDownstream)
{
  this->Run();
  m_Resample->SetNumberOfPoints(300);
  auto executions = this->Run();
  EXPECT_EQ(executions.at("axis"), 0);
  EXPECT_EQ(executions.at("drr"), 0);
  EXPECT_EQ(executions.at("silhouette"), 0);
  EXPECT_EQ(executions.at("resample"), 1);
  EXPECT_EQ(executions.at("registration"), 1);
  EXPECT_EQ(executions.at("distances"), 1);

  m_Geometry->SetSourceToDetectorDistance(1700.0);
  executions = this->Run();
  EXPECT_EQ(executions.at("phantom"), 0);
  EXPECT_EQ(executions.at("axis"), 0);
  EXPECT_EQ(executions.at("drr"), 1);
  EXPECT_EQ(executions.at("registration"), 1);

  m_Registration->SetNumberOfLevels(2);
  executions = this->Run();
  EXPECT_EQ(executions.at("resample"), 0);
  EXPECT_EQ(executions.at("registration"), 1);
  EXPECT_EQ(executions.at("distances"), 1);
}

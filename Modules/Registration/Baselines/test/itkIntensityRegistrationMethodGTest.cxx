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
#include "itkIntensityRegistrationMethod.h"

#include "itkImageRegionIteratorWithIndex.h"
#include "itkMultiThreaderBase.h"
#include "itkSyntheticContours.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{
using MethodType = itk::IntensityRegistrationMethod;
using ImageType = MethodType::ImageType;
using MeasureEnum = MethodType::MeasureEnum;
using namespace SyntheticContours;

/** Blobs along the outline, brighter to one side, in the frame that the transform leads back to. */
ImageType::Pointer
MakeImage(const TransformType * toImage, long first, unsigned long size)
{
  auto                  image = ImageType::New();
  ImageType::RegionType region;
  for (unsigned int d = 0; d < 2; ++d)
  {
    region.SetIndex(d, first);
    region.SetSize(d, size);
  }
  image->SetRegions(region);
  image->Allocate();
  image->FillBuffer(0.0F);
  for (int blob = 0; blob < 24; ++blob)
  {
    const PointType p = toImage->TransformPoint(Outline(static_cast<double>(blob) / 24.0));
    for (itk::ImageRegionIteratorWithIndex<ImageType> it(image, region); !it.IsAtEnd(); ++it)
    {
      const double du = static_cast<double>(it.GetIndex()[0]) - p[0];
      const double dv = static_cast<double>(it.GetIndex()[1]) - p[1];
      it.Value() += static_cast<float>((10.0 + blob) * std::exp(-(du * du + dv * dv) / 200.0));
    }
  }
  return image;
}

class IntensityRegistration : public testing::TestWithParam<MeasureEnum>
{};

/** ITK's global number of threads, until the end of a block. */
class GlobalThreads
{
public:
  explicit GlobalThreads(itk::ThreadIdType number)
    : m_Before(itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads())
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(number);
  }
  ~GlobalThreads() { itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(m_Before); }

private:
  itk::ThreadIdType m_Before;
};
} // namespace

TEST_P(IntensityRegistration, RecoversAKnownShiftAndTurn)
{
  const auto truth = MakeTransform(1.0, 0.03, 200.0, 190.0);
  const auto method = MethodType::New();
  method->SetFixedContour(MakeTracing(truth));
  method->SetMovingContour(MakeSilhouette());
  method->SetFixedImage(MakeImage(truth, 0, 400));
  method->SetMovingImage(MakeImage(MakeTransform(1.0, 0.0, 0.0, 0.0), -200, 400));
  method->SetMeasure(GetParam());
  method->SetInitialTransform(MakeTransform(1.02, 0.0, 204.0, 187.0));
  const double before = LargestDifference(method->GetInitialTransform(), truth);
  method->Update();
  EXPECT_GT(before, 5.0);
  // The images are the same but for the motion; half a pixel of the half-resolution grid.
  EXPECT_LT(LargestDifference(method->GetTransform(), truth), 1.0) << method->GetOptimizerStopConditionDescription();

  const auto first = method->GetTransform()->GetParameters();
  method->SetNumberOfWorkUnits(4);
  method->Modified();
  method->Update();
  EXPECT_EQ(method->GetTransform()->GetParameters(), first);
}

TEST_P(IntensityRegistration, SameBitsForAnyGlobalNumberOfThreads)
{
  const auto truth = MakeTransform(1.0, 0.03, 200.0, 190.0);
  const auto fixedImage = MakeImage(truth, 0, 400);
  const auto movingImage = MakeImage(MakeTransform(1.0, 0.0, 0.0, 0.0), -200, 400);
  const auto run = [&](itk::ThreadIdType threads) {
    const GlobalThreads global(threads);
    const auto          method = MethodType::New();
    method->SetFixedContour(MakeTracing(truth));
    method->SetMovingContour(MakeSilhouette());
    method->SetFixedImage(fixedImage);
    method->SetMovingImage(movingImage);
    method->SetMeasure(GetParam());
    method->SetMaximumNumberOfIterations(20);
    method->SetInitialTransform(MakeTransform(1.02, 0.0, 204.0, 187.0));
    method->Update();
    return method->GetTransform()->GetParameters();
  };
  const auto first = run(1);
  EXPECT_EQ(run(3), first);
  EXPECT_EQ(run(8), first);
}

TEST_P(IntensityRegistration, ADRRBesideTheRadiographIsAnOutcomeAndPrintsNothing)
{
  const auto truth = MakeTransform(1.0, 0.0, 200.0, 190.0);
  const auto method = MethodType::New();
  method->SetFixedContour(MakeTracing(truth));
  method->SetMovingContour(MakeSilhouette());
  method->SetFixedImage(MakeImage(truth, 0, 400));
  method->SetMovingImage(MakeImage(MakeTransform(1.0, 0.0, 0.0, 0.0), -200, 400));
  method->SetMeasure(GetParam());
  method->SetInitialTransform(MakeTransform(1.0, 0.0, 5000.0, 5000.0));
  testing::internal::CaptureStderr();
  method->Update();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(itk::Object::GetGlobalWarningDisplay());
}

INSTANTIATE_TEST_SUITE_P(Measures,
                         IntensityRegistration,
                         testing::Values(MeasureEnum::MutualInformation,
                                         MeasureEnum::NormalizedCorrelation,
                                         MeasureEnum::GradientCorrelation));

TEST(IntensityRegistrationMethod, SaysWhatIsMissingAndEndsOnAbort)
{
  const auto truth = MakeTransform(1.0, 0.0, 200.0, 190.0);
  const auto method = MethodType::New();
  method->SetFixedContour(MakeTracing(truth));
  method->SetMovingContour(MakeSilhouette());
  try
  {
    method->Update();
    FAIL();
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("SetFixedImage"), std::string::npos);
  }
  method->SetFixedImage(MakeImage(truth, 0, 400));
  method->SetMovingImage(MakeImage(MakeTransform(1.0, 0.0, 0.0, 0.0), -200, 400));
  method->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) { method->AbortGenerateDataOn(); });
  EXPECT_THROW(method->Update(), itk::ProcessAborted);
  std::ostringstream text;
  method->Print(text);
  EXPECT_NE(text.str().find("Measure: MutualInformation"), std::string::npos);
}

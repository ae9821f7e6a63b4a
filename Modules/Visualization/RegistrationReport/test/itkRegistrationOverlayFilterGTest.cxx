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
#include "itkRegistrationOverlayFilter.h"

#include "itkImageRegionConstIterator.h"
#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace
{
using FilterType = itk::RegistrationOverlayFilter;
using Colour = std::array<std::uint8_t, 3>;

itk::DentalContour::Pointer
MakeLine(double u0, double v0, double u1, double v1)
{
  auto                          contour = itk::DentalContour::New();
  itk::DentalContour::PointType a;
  a[0] = u0;
  a[1] = v0;
  itk::DentalContour::PointType b;
  b[0] = u1;
  b[1] = v1;
  contour->AddPolyline({ a, b });
  return contour;
}

FilterType::RadiographType::Pointer
MakeRadiograph(unsigned int width, unsigned int height, float value)
{
  auto                                   image = FilterType::RadiographType::New();
  FilterType::RadiographType::RegionType region;
  region.SetSize(0, width);
  region.SetSize(1, height);
  image->SetRegions(region);
  image->Allocate();
  image->FillBuffer(value);
  return image;
}

Colour
AtIndex(const FilterType * filter, double u, double v)
{
  const auto                         p = filter->GetLayout().ToPicture({ u, v });
  const FilterType::PictureType *    picture = filter->GetOutput();
  FilterType::PictureType::IndexType index;
  index[0] = std::lround(p[0]);
  index[1] = std::lround(p[1]);
  const auto pixel = picture->GetPixel(index);
  return { pixel[0], pixel[1], pixel[2] };
}

int
Difference(const Colour & a, const Colour & b)
{
  int difference = 0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    difference = std::max(difference, std::abs(int(a[i]) - int(b[i])));
  }
  return difference;
}

std::vector<std::uint8_t>
Bytes(const FilterType::PictureType * picture)
{
  const auto * first = reinterpret_cast<const std::uint8_t *>(picture->GetBufferPointer());
  return { first, first + 3 * picture->GetBufferedRegion().GetNumberOfPixels() };
}

int
ExerciseBasicObjectMethods()
{
  auto filter = FilterType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, RegistrationOverlayFilter, ImageSource);
  return EXIT_SUCCESS;
}
} // namespace

TEST(RegistrationOverlayFilter, ObeysTheBasicObjectContract)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
}

TEST(RegistrationOverlayFilter, PaintsWithoutAnyInput)
{
  auto filter = FilterType::New();
  filter->SetPictureSize(400, 300);
  EXPECT_NO_THROW(filter->Update());
  EXPECT_EQ(filter->GetOutput()->GetBufferedRegion().GetSize(0), 400u);
  EXPECT_EQ(filter->GetOutput()->GetBufferedRegion().GetSize(1), 300u);
}

TEST(RegistrationOverlayFilter, DrawsItsInputsWhereTheyLie)
{
  auto filter = FilterType::New();
  filter->SetPictureSize(800, 500);
  filter->SetRadiographSize(300, 200);
  filter->SetView(0, 299, 0, 199);
  filter->SetFixedContour(MakeLine(20, 40, 280, 40));
  filter->SetMovingContour(MakeLine(20, 160, 280, 160));
  auto                  predicted = itk::DentalLandmarkSet<2>::New();
  auto                  reference = itk::DentalLandmarkSet<2>::New();
  itk::Point<double, 2> p;
  p[0] = 150.0;
  p[1] = 100.0;
  predicted->AddLandmark("UR1_tip", p);
  p[0] = 190.0;
  reference->AddLandmark("UR1_tip", p);
  filter->SetPredictedLandmarks(predicted);
  filter->SetReferenceLandmarks(reference);
  filter->Update();
  EXPECT_LE(Difference(AtIndex(filter, 150, 40), itk::OverlayColour::Tracing), 2);
  EXPECT_LE(Difference(AtIndex(filter, 200, 160), itk::OverlayColour::Silhouette), 30);
  EXPECT_LE(Difference(AtIndex(filter, 150, 100), itk::OverlayColour::Silhouette), 2);
  EXPECT_LE(Difference(AtIndex(filter, 170, 100), itk::OverlayColour::Error), 20);
  EXPECT_EQ(AtIndex(filter, 280, 100), itk::OverlayColour::Background);
}

TEST(RegistrationOverlayFilter, ReexecutesWhenAnInputChangesOnly)
{
  auto filter = FilterType::New();
  filter->SetPictureSize(400, 300);
  filter->SetRadiographSize(300, 200);
  filter->SetView(0, 299, 0, 199);
  const auto tracing = MakeLine(20, 40, 280, 40);
  filter->SetFixedContour(tracing);
  filter->Update();
  const auto time = filter->GetOutput()->GetUpdateMTime();
  const auto before = Bytes(filter->GetOutput());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetUpdateMTime(), time);
  itk::DentalContour::PointType a;
  a.Fill(20.0);
  itk::DentalContour::PointType b;
  b.Fill(120.0);
  tracing->AddPolyline({ a, b });
  filter->Update();
  EXPECT_NE(Bytes(filter->GetOutput()), before);
  EXPECT_LE(Difference(AtIndex(filter, 80, 80), itk::OverlayColour::Tracing), 2);
  // A parameter set to what it is changes nothing.
  const auto mtime = filter->GetMTime();
  filter->SetRadiographSize(300, 200);
  filter->SetTitle("");
  filter->SetTextLines({});
  filter->SetLandmarkSigmas({});
  filter->SetWindow(0.0, 0.0);
  EXPECT_EQ(filter->GetMTime(), mtime);
}

TEST(RegistrationOverlayFilter, GivesTheSameBitsForAnyRequestedRegionAndThreads)
{
  std::vector<std::uint8_t> first;
  for (const unsigned int threads : { 1u, 4u })
  {
    auto filter = FilterType::New();
    filter->SetPictureSize(400, 300);
    filter->SetTitle("Same");
    filter->SetRadiograph(MakeRadiograph(300, 200, 100.0f));
    filter->SetFixedContour(MakeLine(20, 40, 280, 40));
    filter->SetNumberOfWorkUnits(threads);
    filter->UpdateOutputInformation();
    FilterType::PictureType::RegionType strip;
    strip.SetSize(0, 400);
    strip.SetSize(1, 10);
    filter->GetOutput()->SetRequestedRegion(strip);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetBufferedRegion().GetSize(1), 300u);
    if (first.empty())
    {
      first = Bytes(filter->GetOutput());
    }
    EXPECT_EQ(Bytes(filter->GetOutput()), first);
  }
}

TEST(RegistrationOverlayFilter, WindowsTheRadiograph)
{
  auto   image = MakeRadiograph(300, 200, 1000.0f);
  auto * pixels = image->GetBufferPointer();
  for (unsigned int i = 0; i < 300 * 100; ++i)
  {
    pixels[i] = 3000.0f;
  }
  pixels[5] = std::numeric_limits<float>::quiet_NaN();
  pixels[6] = std::numeric_limits<float>::infinity();
  pixels[7] = 1e30f;
  auto filter = FilterType::New();
  filter->SetPictureSize(800, 500);
  filter->SetRadiograph(image);
  filter->SetView(0, 299, 0, 199);
  filter->Update();
  // Black and white of the window, dimmed by 0.85.
  EXPECT_NEAR(AtIndex(filter, 200, 50)[0], 217, 1);
  EXPECT_NEAR(AtIndex(filter, 200, 130)[0], 0, 1);
  filter->SetWindow(0.0, 4000.0);
  filter->Update();
  EXPECT_NEAR(AtIndex(filter, 200, 50)[0], 163, 2);
  EXPECT_NEAR(AtIndex(filter, 200, 130)[0], 54, 2);
  // An even radiograph has no window.
  filter->SetWindow(0.0, 0.0);
  filter->SetRadiograph(MakeRadiograph(300, 200, 7.0f));
  EXPECT_NO_THROW(filter->Update());
}

TEST(RegistrationOverlayFilter, ContourWithPointsThatAreNotFiniteIsDrawnWithoutThem)
{
  // AddPolyline() refuses them, the mesh interface does not.
  auto                          contour = MakeLine(20, 40, 280, 40);
  itk::DentalContour::PointType bad;
  bad.Fill(std::numeric_limits<double>::quiet_NaN());
  contour->SetPoint(2, bad);
  bad.Fill(1e250);
  contour->SetPoint(3, bad);
  auto filter = FilterType::New();
  filter->SetPictureSize(800, 500);
  filter->SetRadiographSize(300, 200);
  filter->SetFixedContour(contour);
  filter->SetMovingContour(itk::DentalContour::New());
  EXPECT_NO_THROW(filter->Update());
  EXPECT_LE(Difference(AtIndex(filter, 150, 40), itk::OverlayColour::Tracing), 2);
}

TEST(RegistrationOverlayFilter, MovingContoursAreNumberedAndRemovable)
{
  auto filter = FilterType::New();
  EXPECT_EQ(filter->GetNumberOfMovingContours(), 0u);
  const auto whole = MakeLine(0, 0, 10, 10);
  filter->SetMovingContour(1, whole, "Whole outline");
  EXPECT_EQ(filter->GetNumberOfMovingContours(), 2u);
  EXPECT_EQ(filter->GetMovingContour(1), whole.GetPointer());
  EXPECT_EQ(filter->GetMovingContour(0), nullptr);
  filter->SetMovingContour(1, nullptr);
  EXPECT_EQ(filter->GetMovingContour(1), nullptr);
  filter->SetPictureSize(400, 300);
  EXPECT_NO_THROW(filter->Update());
}

TEST(RegistrationOverlayFilter, ErrorsNameTheValueAndTheRemedy)
{
  auto filter = FilterType::New();
  filter->SetPictureSize(100, 100);
  try
  {
    filter->Update();
    FAIL() << "a picture too small for its text was made";
  }
  catch (const itk::ExceptionObject & error)
  {
    const std::string message = error.GetDescription();
    EXPECT_NE(message.find("100 x 100"), std::string::npos) << message;
    EXPECT_NE(message.find("at least 320 x 240"), std::string::npos) << message;
  }
  EXPECT_THROW(filter->SetView(10, 10, 0, 5), itk::ExceptionObject);
}

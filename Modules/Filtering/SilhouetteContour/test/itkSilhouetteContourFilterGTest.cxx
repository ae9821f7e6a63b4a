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
#include "itkIsoContourTracer.h"
#include "itkReproducibleRandom.h"
#include "itkSilhouetteContourFilter.h"
#include "itkTestingMacros.h"

#include "itkImageRegionIteratorWithIndex.h"
#include "itkMath.h"
#include "itkStreamingImageFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using ImageType = itk::Image<float, 2>;
using FilterType = itk::SilhouetteContourFilter<ImageType>;
using PolylineType = itk::DentalContour::PolylineType;

template <typename TImage>
typename TImage::Pointer
MakeImage(unsigned int width, unsigned int height, const std::function<double(double, double)> & value, int startU = 0)
{
  const auto                  image = TImage::New();
  typename TImage::RegionType region;
  region.SetIndex(0, startU);
  region.SetSize(0, width);
  region.SetSize(1, height);
  image->SetRegions(region);
  image->Allocate();
  for (itk::ImageRegionIteratorWithIndex<TImage> it(image, region); !it.IsAtEnd(); ++it)
  {
    it.Set(static_cast<typename TImage::PixelType>(value(it.GetIndex()[0], it.GetIndex()[1])));
  }
  return image;
}

/** A disc whose edge is a Gaussian's integral, as of a map smoothed with sigma. */
std::function<double(double, double)>
Disc(double u, double v, double radius, double sigma)
{
  return
    [=](double x, double y) { return 0.5 * std::erfc((std::hypot(x - u, y - v) - radius) / (std::sqrt(2.0) * sigma)); };
}

double
Area(const PolylineType & polyline)
{
  itk::IsoContourTracer::LoopType loop;
  for (const auto & p : polyline.points)
  {
    loop.push_back({ p[0], p[1] });
  }
  return itk::ComputeLoopArea(loop);
}

int
ExerciseBasics()
{
  const auto filter = FilterType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, SilhouetteContourFilter, ImageToMeshFilter);
  return EXIT_SUCCESS;
}
} // namespace

TEST(SilhouetteContourFilter, IsAnItkObject)
{
  EXPECT_EQ(ExerciseBasics(), EXIT_SUCCESS);
}

TEST(SilhouetteContourFilter, FindsADiscAtSubPixelPrecision)
{
  itk::ReproducibleRandom random(1);
  for (unsigned int trial = 0; trial < 20; ++trial)
  {
    const double u = random.Uniform(28, 36);
    const double v = random.Uniform(28, 36);
    const double radius = random.Uniform(10, 20);
    const auto   filter = FilterType::New();
    filter->SetInput(MakeImage<ImageType>(64, 64, Disc(u, v, radius, 1.0)));
    filter->SetLevel(FilterType::LevelEnum::Absolute);
    filter->SetLevelValue(0.5);
    filter->Update();
    const auto polylines = filter->GetOutput()->GetPolylines();
    ASSERT_EQ(polylines.size(), 1u);
    EXPECT_TRUE(polylines[0].closed);
    double sum = 0.0;
    for (const auto & p : polylines[0].points)
    {
      const double error = std::hypot(p[0] - u, p[1] - v) - radius;
      // Linear interpolation of the integral: h^2 / 8 times curvature over slope, the curvature of a Gaussian's
      // integral is at most 0.6 of its slope within a pixel.
      EXPECT_LT(std::abs(error), 0.05);
      sum += error;
    }
    EXPECT_LT(std::abs(sum / static_cast<double>(polylines[0].points.size())), 0.005);
    EXPECT_NEAR(Area(polylines[0]), itk::Math::pi * radius * radius, 0.01 * radius * radius);
  }
}

TEST(SilhouetteContourFilter, FindsTheSameContourByEveryLevel)
{
  const auto filter = FilterType::New();
  filter->SetInput(
    MakeImage<ImageType>(64, 64, [](double x, double y) { return 3.0 + 8.0 * Disc(31, 33, 15, 1.5)(x, y); }));
  filter->SetLevel(FilterType::LevelEnum::Fraction);
  filter->Update();
  EXPECT_NEAR(filter->GetUsedLevel(), 7.0, 1e-3);
  const auto time = filter->GetOutput()->GetMTime();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetMTime(), time) << "executed again without a reason";
  const double area = Area(filter->GetOutput()->GetPolylines()[0]);
  // The median is the plateau but for the blurred edge.
  filter->SetLevel(FilterType::LevelEnum::Automatic);
  filter->Update();
  EXPECT_NEAR(filter->GetUsedLevel(), 7.0, 0.05);
  EXPECT_NEAR(Area(filter->GetOutput()->GetPolylines()[0]) / area, 1.0, 0.005);

  filter->SetInput(
    MakeImage<ImageType>(64, 64, [](double x, double y) { return 20.0 - 8.0 * Disc(31, 33, 15, 1.5)(x, y); }));
  filter->SetLevel(FilterType::LevelEnum::Fraction);
  filter->ObjectIsDarkOn();
  filter->Update();
  EXPECT_NEAR(filter->GetUsedLevel(), 16.0, 1e-3);
  EXPECT_NEAR(Area(filter->GetOutput()->GetPolylines()[0]), area, 1e-2);
  filter->SetLevel(FilterType::LevelEnum::Absolute);
  filter->SetLevelValue(16.0);
  filter->Update();
  EXPECT_NEAR(Area(filter->GetOutput()->GetPolylines()[0]), area, 1e-2);
}

TEST(SilhouetteContourFilter, FindsAnAutomaticLevelInSpiteOfGrazingRays)
{
  // The shell of a sphere: thickness 1 / cos, cut off at 100 where rays graze it.
  const auto shell = [](double x, double y) {
    const double r = std::hypot(x - 40.0, y - 40.0) / 30.0;
    return r < 1.0 ? std::min(100.0, 2.0 / std::sqrt(1.0 - r * r)) : 0.0;
  };
  const auto filter = FilterType::New();
  filter->SetInput(MakeImage<ImageType>(80, 80, shell));
  filter->Update();
  // Half the disc's area lies beyond r = sqrt(1/2), where the thickness is 2 sqrt(2); half of that. A bin is 100 /
  // 4096.
  EXPECT_NEAR(filter->GetUsedLevel(), std::sqrt(2.0), 0.05);
  const auto polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  for (const auto & p : polylines[0].points)
  {
    EXPECT_LT(std::abs(std::hypot(p[0] - 40.0, p[1] - 40.0) - 30.0), 1.5);
  }
}

TEST(SilhouetteContourFilter, ClosesWhatTouchesTheBorder)
{
  const auto filter = FilterType::New();
  // A disc that the left border cuts, and an image that is all object but for one pixel.
  filter->SetInput(MakeImage<ImageType>(40, 60, Disc(0.0, 30.0, 20.0, 1.0)));
  filter->Update();
  auto polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_TRUE(polylines[0].closed);
  for (const auto & p : polylines[0].points)
  {
    EXPECT_GE(p[0], -1.0);
  }
  // Half the disc, and half a pixel of frame.
  EXPECT_NEAR(Area(polylines[0]), 0.5 * itk::Math::pi * 400.0 + 0.5 * 40.0, 3.0);
  filter->SetInput(MakeImage<ImageType>(5, 4, [](double x, double y) { return x == 2 && y == 2 ? 0.0 : 1.0; }));
  filter->Update();
  polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  // The level is half to a bin of 1/4096; eight corners and sides move by as much.
  EXPECT_NEAR(Area(polylines[0]), 20.0 - 4 * 0.125, 0.01);
}

TEST(SilhouetteContourFilter, IgnoresHolesAndWhatIsInThem)
{
  const auto ringWithIsland = [](double x, double y) {
    const double r = std::hypot(x - 40, y - 40);
    return (r > 15 && r < 30) || r < 6 || std::hypot(x - 90, y - 20) < 8 ? 1.0 : 0.0;
  };
  const auto filter = FilterType::New();
  filter->SetInput(MakeImage<ImageType>(110, 80, ringWithIsland));
  filter->LargestPartOnlyOff();
  filter->Update();
  auto polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 2u);
  // A raster disc's area scatters by a few pixels.
  EXPECT_NEAR(Area(polylines[0]), itk::Math::pi * 900, 20.0);
  EXPECT_NEAR(Area(polylines[1]), itk::Math::pi * 64, 10.0);
  filter->SetMinimumArea(500.0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPolylines().size(), 1u);
  filter->SetMinimumArea(0.0);
  filter->LargestPartOnlyOn();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPolylines().size(), 1u);
}

TEST(SilhouetteContourFilter, ContoursNoiseWithoutLosingALoop)
{
  // Every saddle and every equality with the level occurs: the winding number of all outer boundaries and holes is that
  // of the samples. Here: each sample above the level lies inside an outer boundary.
  itk::ReproducibleRandom random(3);
  for (unsigned int trial = 0; trial < 50; ++trial)
  {
    const auto image =
      MakeImage<ImageType>(17, 13, [&random](double, double) { return static_cast<double>(random.Integer(4)); });
    const auto filter = FilterType::New();
    filter->SetInput(image);
    filter->SetLevel(FilterType::LevelEnum::Absolute);
    filter->SetLevelValue(trial % 2 == 0 ? 1.5 : 1.0);
    filter->LargestPartOnlyOff();
    filter->Update();
    std::vector<itk::IsoContourTracer::LoopType> loops;
    for (const auto & polyline : filter->GetOutput()->GetPolylines())
    {
      EXPECT_TRUE(polyline.closed);
      EXPECT_GT(Area(polyline), 0.0);
      loops.emplace_back();
      for (const auto & p : polyline.points)
      {
        loops.back().push_back({ p[0], p[1] });
      }
    }
    for (itk::ImageRegionIteratorWithIndex<ImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
    {
      if (it.Get() > filter->GetLevelValue())
      {
        // Off the sample, where no contour passes.
        const std::array<double, 2> sample{ it.GetIndex()[0] + 1e-7, it.GetIndex()[1] + 2e-7 };
        EXPECT_TRUE(
          std::any_of(loops.begin(), loops.end(), [&](const auto & loop) { return itk::IsInsideLoop(loop, sample); }));
      }
    }
  }
}

TEST(SilhouetteContourFilter, ExpressesCoordinatesAsAsked)
{
  const auto             image = MakeImage<ImageType>(64, 64, Disc(20.25, 30.5, 12, 1.0), -5);
  ImageType::SpacingType spacing;
  spacing[0] = 0.25;
  spacing[1] = 0.5;
  image->SetSpacing(spacing);
  ImageType::PointType origin;
  origin[0] = -10.0;
  origin[1] = 2.0;
  image->SetOrigin(origin);
  const auto filter = FilterType::New();
  filter->SetInput(image);
  const auto centre = [&filter]() {
    filter->Update();
    const auto            points = filter->GetOutput()->GetPolylines()[0].points;
    std::array<double, 2> low{ 1e9, 1e9 };
    std::array<double, 2> high{ -1e9, -1e9 };
    for (const auto & p : points)
    {
      for (unsigned int d = 0; d < 2; ++d)
      {
        low[d] = std::min(low[d], p[d]);
        high[d] = std::max(high[d], p[d]);
      }
    }
    return std::array<double, 2>{ 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]) };
  };
  // Extremes of a contour whose points are a pixel apart: r / 8 pixel^2 ~ 0.01 px.
  auto c = centre();
  EXPECT_NEAR(c[0], 20.25, 0.02);
  EXPECT_NEAR(c[1], 30.5, 0.02);
  filter->SetOutputCoordinates(FilterType::OutputCoordinatesEnum::Physical);
  c = centre();
  EXPECT_NEAR(c[0], -10.0 + 0.25 * 20.25, 0.01);
  EXPECT_NEAR(c[1], 2.0 + 0.5 * 30.5, 0.01);
  filter->SetOutputCoordinates(FilterType::OutputCoordinatesEnum::PhysicalOverSpacing);
  c = centre();
  EXPECT_NEAR(c[0], 20.25 - 40.0, 0.02);
  EXPECT_NEAR(c[1], 30.5 + 4.0, 0.02);
  FilterType::OffsetType offset;
  offset[0] = 100.0;
  offset[1] = 200.0;
  filter->SetOutputOffset(offset);
  c = centre();
  EXPECT_NEAR(c[0], 20.25 - 140.0, 0.02);
  EXPECT_NEAR(c[1], 30.5 - 196.0, 0.02);
}

TEST(SilhouetteContourFilter, OutlinesLabelsWithTheirToothCodes)
{
  using LabelImageType = itk::Image<unsigned char, 2>;
  using LabelFilterType = itk::SilhouetteContourFilter<LabelImageType>;
  // 12 and 11 touch; 11 has a speck.
  const auto labels = MakeImage<LabelImageType>(40, 30, [](double x, double y) {
    if (x == 35 && y == 25)
    {
      return 11.0;
    }
    return y >= 5 && y < 15 ? (x >= 4 && x < 14 ? 12.0 : (x >= 14 && x < 30 ? 11.0 : 0.0)) : 0.0;
  });
  const auto filter = LabelFilterType::New();
  filter->SetInput(labels);
  filter->SetContent(LabelFilterType::ContentEnum::ToothLabels);
  filter->Update();
  auto polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 2u);
  EXPECT_EQ(polylines[0].code, itk::ToothCode(11));
  EXPECT_EQ(polylines[1].code, itk::ToothCode(12));
  // A rectangle without its four corners of half a pixel.
  EXPECT_NEAR(Area(polylines[0]), 160.0 - 4 * 0.125, 1e-12);
  EXPECT_NEAR(Area(polylines[1]), 100.0 - 4 * 0.125, 1e-12);
  filter->LargestPartOnlyOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPolylines().size(), 3u);
  filter->LargestPartOnlyOn();
  filter->SetContent(LabelFilterType::ContentEnum::MergedLabels);
  filter->Update();
  polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_FALSE(polylines[0].code.IsKnown());
  EXPECT_NEAR(Area(polylines[0]), 260.0 - 4 * 0.125, 1e-12);

  filter->SetInput(MakeImage<LabelImageType>(9, 9, [](double x, double y) { return x == 4 && y == 4 ? 19.0 : 0.0; }));
  filter->SetContent(LabelFilterType::ContentEnum::ToothLabels);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}

TEST(SilhouetteContourFilter, OutlinesASmoothedLabelWithoutStepsAndWithoutBias)
{
  using LabelImageType = itk::Image<unsigned char, 2>;
  using LabelFilterType = itk::SilhouetteContourFilter<LabelImageType>;
  constexpr double radius = 30.0;
  const auto       labels = MakeImage<LabelImageType>(
    100, 90, [](double x, double y) { return std::hypot(x - 50.3, y - 44.6) < radius ? 1.0 : 0.0; });
  const auto filter = LabelFilterType::New();
  filter->SetInput(labels);
  filter->SetContent(LabelFilterType::ContentEnum::MergedLabels);
  double worst[2];
  for (const double sigma : { 0.0, 2.0 })
  {
    filter->SetLabelSmoothing(sigma);
    filter->Update();
    const auto polylines = filter->GetOutput()->GetPolylines();
    ASSERT_EQ(polylines.size(), 1u);
    EXPECT_TRUE(polylines[0].closed);
    double & largest = worst[sigma > 0.0 ? 1 : 0];
    double   mean = 0.0;
    largest = 0.0;
    for (const auto & p : polylines[0].points)
    {
      // Inside by sigma^2 / (2 R).
      const double d = std::hypot(p[0] - 50.3, p[1] - 44.6) - radius + sigma * sigma / (2.0 * radius);
      largest = std::max(largest, std::abs(d));
      mean += d / static_cast<double>(polylines[0].points.size());
    }
    EXPECT_LT(std::abs(mean), 0.05) << sigma;
  }
  EXPECT_GT(worst[0], 0.45);
  // Steps vanish; where the circle runs along the grid for 15 px, part of the half pixel by which a mask is off stays.
  EXPECT_LT(worst[1], 0.3);
}

TEST(SilhouetteContourFilter, SmoothsALabelThatTouchesTheBorder)
{
  using LabelImageType = itk::Image<unsigned char, 2>;
  using LabelFilterType = itk::SilhouetteContourFilter<LabelImageType>;
  const auto filter = LabelFilterType::New();
  filter->SetInput(MakeImage<LabelImageType>(20, 16, [](double x, double) { return x < 8 ? 21.0 : 0.0; }));
  filter->SetContent(LabelFilterType::ContentEnum::ToothLabels);
  filter->SetLabelSmoothing(1.5);
  filter->Update();
  const auto polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_EQ(polylines[0].code, itk::ToothCode(21));
  double left = 100.0;
  double right = -100.0;
  for (const auto & p : polylines[0].points)
  {
    left = std::min(left, p[0]);
    right = std::max(right, p[0]);
  }
  // Outside of the image is background: the first column's outer edge and the edge between columns 7 and 8.
  EXPECT_NEAR(left, -0.5, 0.02);
  EXPECT_NEAR(right, 7.5, 0.02);
}

TEST(SilhouetteContourFilter, GivesNothingForAFlatImageAndRefusesWhatItCannotContour)
{
  const auto filter = FilterType::New();
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetInput(MakeImage<ImageType>(9, 9, [](double, double) { return 7.0; }));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0u);
  filter->SetInput(MakeImage<ImageType>(
    9, 9, [](double x, double) { return x == 3.0 ? std::numeric_limits<double>::quiet_NaN() : 7.0; }));
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetInput(MakeImage<ImageType>(9, 9, [](double x, double) { return x; }));
  filter->SetLevel(FilterType::LevelEnum::Fraction);
  filter->SetLevelFraction(1.0);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}

TEST(SilhouetteContourFilter, IsTheSameBehindAStreamedImageAndOnEveryRun)
{
  const auto image = MakeImage<ImageType>(64, 64, Disc(31, 33, 15, 1.5));
  const auto run = [&image](unsigned int divisions, unsigned int workUnits) {
    const auto streamer = itk::StreamingImageFilter<ImageType, ImageType>::New();
    streamer->SetInput(image);
    streamer->SetNumberOfStreamDivisions(divisions);
    const auto filter = FilterType::New();
    filter->SetInput(streamer->GetOutput());
    filter->SetNumberOfWorkUnits(workUnits);
    filter->Update();
    return filter->GetOutput()->GetPolylines()[0].points;
  };
  const auto once = run(1, 1);
  EXPECT_EQ(once, run(7, 1));
  EXPECT_EQ(once, run(1, 5));
}

namespace
{
/** Passes an image on, and counts how often it is asked and the most rows it was asked for. */
class CountingFilter : public itk::StreamingImageFilter<ImageType, ImageType>
{
public:
  using Self = CountingFilter;
  using Superclass = itk::StreamingImageFilter<ImageType, ImageType>;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);

  void
  UpdateOutputData(itk::DataObject * output) override
  {
    ++executions;
    rows = std::max(rows, this->GetOutput()->GetRequestedRegion().GetSize(1));
    Superclass::UpdateOutputData(output);
  }

  unsigned int       executions{ 0 };
  itk::SizeValueType rows{ 0 };
};

/** A jagged blob that touches three borders, a part of its own and one in its hole. */
double
Blobs(double x, double y)
{
  const double blob = 20.0 + 9.0 * std::sin(0.9 * x) - std::hypot(x - 20.0, 0.4 * (y - 15.0));
  const double part = 4.5 - std::hypot(x - 52.0, y - 30.0);
  return std::max({ blob, part, -3.0 });
}
} // namespace

TEST(SilhouetteContourFilter, HasTheSameBitsForAnyNumberOfStrips)
{
  using LevelEnum = FilterType::LevelEnum;
  using ContentEnum = FilterType::ContentEnum;
  const auto image = MakeImage<ImageType>(61, 47, Blobs, -5);
  const auto labels = MakeImage<ImageType>(
    61, 47, [](double x, double y) { return Blobs(x, y) > 0.0 ? (x > 40.0 ? 31.0 : (y > 20.0 ? 36.0 : 37.0)) : 0.0; });
  struct Setting
  {
    ContentEnum  content;
    LevelEnum    level;
    bool         dark;
    unsigned int passes;
  };
  for (const Setting & setting : { Setting{ ContentEnum::Intensity, LevelEnum::Absolute, false, 1 },
                                   Setting{ ContentEnum::Intensity, LevelEnum::Absolute, true, 1 },
                                   Setting{ ContentEnum::Intensity, LevelEnum::Fraction, true, 2 },
                                   Setting{ ContentEnum::Intensity, LevelEnum::Automatic, false, 3 },
                                   Setting{ ContentEnum::ToothLabels, LevelEnum::Automatic, false, 2 },
                                   Setting{ ContentEnum::MergedLabels, LevelEnum::Automatic, false, 2 } })
  {
    const auto run = [&](unsigned int strips, CountingFilter * source) {
      const auto filter = FilterType::New();
      source->SetInput(setting.content == ContentEnum::Intensity ? image : labels);
      filter->SetInput(source->GetOutput());
      filter->SetContent(setting.content);
      filter->SetLevel(setting.level);
      filter->SetObjectIsDark(setting.dark);
      filter->SetLevelFraction(0.6);
      filter->LargestPartOnlyOff();
      filter->SetNumberOfStreamDivisions(strips);
      filter->Update();
      std::vector<decltype(PolylineType::points)> lines;
      for (const auto & polyline : filter->GetOutput()->GetPolylines())
      {
        lines.push_back(polyline.points);
      }
      // Nothing changed: nothing runs.
      const unsigned int executions = source->executions;
      filter->Update();
      EXPECT_EQ(source->executions, executions);
      return std::make_pair(lines, filter->GetUsedLevel());
    };
    const auto once = CountingFilter::New();
    const auto whole = run(1, once);
    EXPECT_FALSE(whole.first.empty());
    EXPECT_EQ(once->executions, 1u);
    for (const unsigned int strips : { 2u, 7u, 47u, 1000u })
    {
      const auto source = CountingFilter::New();
      EXPECT_EQ(run(strips, source), whole) << strips << " strips";
      EXPECT_EQ(source->executions, setting.passes * std::min(strips, 47u));
      EXPECT_EQ(source->rows, (46 + std::min(strips, 47u)) / std::min(strips, 47u));
    }
  }
}

TEST(SilhouetteContourFilter, StripsEndInAnErrorOrAnAbortAsTheWholeDoes)
{
  const auto source = CountingFilter::New();
  source->SetInput(MakeImage<ImageType>(
    9, 40, [](double x, double y) { return y > 30.0 ? std::numeric_limits<double>::quiet_NaN() : x; }));
  const auto filter = FilterType::New();
  filter->SetInput(source->GetOutput());
  filter->SetNumberOfStreamDivisions(10);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  EXPECT_EQ(source->executions, 8u) << "the strip with the first such pixel";
  source->SetInput(MakeImage<ImageType>(9, 40, [](double x, double) { return x; }));
  EXPECT_NO_THROW(filter->Update());
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0u);

  filter->Modified();
  const auto tag = filter->AddObserver(itk::ProgressEvent(), [&filter](const itk::EventObject &) {
    if (filter->GetProgress() > 0.0f)
    {
      filter->AbortGenerateDataOn();
    }
  });
  source->executions = 0;
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
  EXPECT_EQ(source->executions, 1u);
  filter->RemoveObserver(tag);
  EXPECT_NO_THROW(filter->Update());
}

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
#include "itkSurfaceSplatKernel.h"

#include "itkReproducibleRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

namespace
{
using Kernel = itk::SurfaceSplatKernel;
using Layer = itk::SurfaceSplatLayer;
using Region = itk::SurfaceSplatRegion;
using Method = Kernel::MethodEnum;

void
Add(Layer & layer, double u, double v, double weight)
{
  layer.u.push_back(u);
  layer.v.push_back(v);
  layer.weight.push_back(static_cast<float>(weight));
}

std::vector<float>
Render(const Kernel & kernel, const Region & region, unsigned int threads = 1)
{
  std::vector<float> pixels(static_cast<std::size_t>(region.sizeU * region.sizeV), 0.0f);
  kernel.Render(region, pixels.data(), static_cast<std::size_t>(region.sizeU), threads);
  return pixels;
}

/** Largest difference from the definition, relative to the largest value on the detector plane: in the region, or at a
 * splat's centre outside of it. */
double
RelativeError(const Layer & layer, const Region & region, const std::vector<float> & pixels)
{
  std::vector<double> reference(pixels.size(), 0.0);
  itk::SurfaceSplatReference(layer, region, reference.data(), static_cast<std::size_t>(region.sizeU));
  double error = 0.0;
  double peak = layer.weight.empty() ? 0.0 : *std::max_element(layer.weight.begin(), layer.weight.end());
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    error = std::max(error, std::abs(pixels[i] - reference[i]));
    peak = std::max(peak, std::abs(reference[i]));
  }
  return peak > 0.0 ? error / peak : error;
}

/** Point sets that a surface may yield, and some that none would. */
std::vector<std::pair<std::string, Layer>>
PointSets()
{
  std::vector<std::pair<std::string, Layer>> sets;
  itk::ReproducibleRandom                    random(11);
  const auto                                 add = [&sets](const char * name) -> Layer & {
    sets.emplace_back(name, Layer());
    return sets.back().second;
  };
  Layer & dense = add("dense");
  for (int i = 0; i < 4000; ++i)
  {
    Add(dense, random.Uniform(5, 70), random.Uniform(0, 40), random.Uniform(0.1, 1.0));
  }
  Layer & sparse = add("sparse");
  for (int i = 0; i < 12; ++i)
  {
    Add(sparse, random.Uniform(-10, 100), random.Uniform(-10, 60), random.Uniform(0.1, 1.0));
  }
  Add(add("one point"), 31.37, 24.81, 2.0);
  Add(add("one point on a pixel"), 31.0, 24.0, 2.0);
  Layer & coincident = add("coincident points");
  for (int i = 0; i < 500; ++i)
  {
    Add(coincident, 40.25, 17.75, 0.3);
  }
  Layer & needle = add("needle");
  for (int i = 0; i < 300; ++i)
  {
    Add(needle, 10.0 + 0.2 * i, 20.0 + 1e-4 * i, 1e-6);
  }
  Layer & box = add("axis-aligned box");
  for (int i = 0; i < 40; ++i)
  {
    Add(box, 20.0 + i, 10.0, 1.0);
    Add(box, 20.0 + i, 35.0, 1.0);
    Add(box, 20.0, 10.0 + 0.625 * i, 1.0);
    Add(box, 60.0, 10.0 + 0.625 * i, 1.0);
  }
  Layer & far = add("points far outside");
  Add(far, 30.5, 20.5, 1.0);
  for (const double distance : { 200.0, 1e6, 1e12, 1e300 })
  {
    Add(far, distance, 20.0, 1e3);
    Add(far, -distance, 20.0, 1e3);
    Add(far, 30.0, distance, 1e3);
    Add(far, 30.0, -distance, 1e3);
  }
  Layer & border = add("points on the border");
  for (int i = 0; i < 80; ++i)
  {
    Add(border, i, -1.4, 1.0);
    Add(border, i, 50.2, 1.0);
    Add(border, -0.6, 0.6 * i, 1.0);
    Add(border, 80.3, 0.6 * i, 1.0);
  }
  return sets;
}
} // namespace

class SplatTolerance : public ::testing::TestWithParam<std::tuple<double, double>>
{};

TEST_P(SplatTolerance, HoldsOnRandomDegenerateAndAdversarialPoints)
{
  const auto [sigma, tolerance] = GetParam();
  const Region image{ -3, -2, 85, 54 };
  for (auto & [name, layer] : PointSets())
  {
    layer.sigmaU = sigma;
    layer.sigmaV = sigma;
    const Kernel kernel(layer, image, tolerance);
    EXPECT_LE(RelativeError(layer, image, Render(kernel, image)), tolerance)
      << name << ", sigma " << sigma << ", " << kernel.GetMethod();
  }
}

INSTANTIATE_TEST_SUITE_P(Widths,
                         SplatTolerance,
                         ::testing::Combine(::testing::Values(0.02, 0.3, 0.5, 0.8, 1.0, 1.4, 2.0, 3.3, 7.0, 25.0),
                                            ::testing::Values(1e-2, 1e-3, 1e-5)));

TEST(SurfaceSplatKernel, SplinesStayWithinTheirComputedErrorOnSurfaceLikeInput)
{
  const Region image{ 0, 0, 85, 54 };
  for (auto & [name, layer] : PointSets())
  {
    for (const double sigma : { 1.5, 2.0, 3.0 })
    {
      layer.sigmaU = sigma;
      layer.sigmaV = sigma;
      for (const Method method : { Method::CubicSpline, Method::QuinticSpline })
      {
        const Kernel kernel(layer, image, 1e-3, method);
        EXPECT_EQ(kernel.GetMethod(), method);
        // Errors of neighbouring splats oscillate and add up by less than a factor of two.
        EXPECT_LE(RelativeError(layer, image, Render(kernel, image)), 2.0 * kernel.GetSplatError())
          << name << ", sigma " << sigma << ", " << method;
      }
    }
  }
}

TEST(SurfaceSplatKernel, ComputedErrorOfASplatIsAttained)
{
  // The bound is of use only if it is not far above what happens.
  const Region image{ 0, 0, 60, 60 };
  for (const Method method : { Method::CubicSpline, Method::QuinticSpline })
  {
    double worst = 0.0;
    double bound = 0.0;
    for (int step = 0; step < 8; ++step)
    {
      Layer layer;
      layer.sigmaU = 1.3;
      layer.sigmaV = 1.3;
      Add(layer, 30.0 + step / 8.0, 30.0 + step / 8.0, 1.0);
      const Kernel kernel(layer, image, 1e-3, method);
      bound = kernel.GetSplatError();
      worst = std::max(worst, RelativeError(layer, image, Render(kernel, image)));
    }
    EXPECT_LE(worst, 1.1 * bound) << method;
    EXPECT_GE(worst, 0.4 * bound) << method;
  }
}

/** Splats so wide that an image shows where they are cut off: the tests above end within the first sigmas. */
class WideSplats : public ::testing::TestWithParam<std::tuple<Method, double>>
{
protected:
  static Layer
  MakeLayer(Method method, double sigma, const std::vector<std::array<double, 3>> & splats)
  {
    Layer layer;
    // Not square: no width may stand for the other.
    layer.sigmaU = sigma;
    layer.sigmaV = 0.7 * sigma;
    for (const auto & splat : splats)
    {
      Add(layer, splat[0], splat[1], splat[2]);
      if (method == Method::PerSplat)
      {
        layer.sigmaUs.push_back(static_cast<float>(layer.sigmaU));
        layer.sigmaVs.push_back(static_cast<float>(layer.sigmaV));
      }
    }
    return layer;
  }

  /** Six sigmas to every side: what is beyond is below 2e-8 of the peak. */
  static Region
  MakeImage(double sigma)
  {
    const auto reach = static_cast<std::int64_t>(6.0 * sigma);
    return { -reach, -reach, 2 * reach, 2 * reach };
  }
};

TEST_P(WideSplats, StayWithinTheComputedErrorWhichStaysWithinTheTolerance)
{
  const auto [method, sigma] = GetParam();
  const Region image = MakeImage(sigma);
  for (const double tolerance : { 1e-2, 1e-3, 1e-4 })
  {
    double worst = 0.0;
    double bound = 0.0;
    for (const double fraction : { 0.0, 0.31, 0.5 })
    {
      const Layer  layer = MakeLayer(method, sigma, { { { fraction, -fraction, 1.7 } } });
      const Kernel kernel(layer, image, tolerance, method == Method::PerSplat ? Method::Automatic : method);
      ASSERT_EQ(kernel.GetMethod(), method);
      bound = kernel.GetSplatError();
      worst = std::max(worst, RelativeError(layer, image, Render(kernel, image)));
    }
    // Single precision: the exponential, two factors and a sum, or a filter of a thousand taps.
    EXPECT_LE(worst, bound + 5e-6) << "tolerance " << tolerance;
    // Two tails of half a tolerance, the interpolation, and single precision.
    EXPECT_LE(bound, 1.2 * tolerance) << "tolerance " << tolerance;
    EXPECT_LE(worst, tolerance) << "tolerance " << tolerance;
    // The bound is of use only where it is not far above what happens.
    EXPECT_GE(worst, 0.3 * bound) << "tolerance " << tolerance;
  }
}

TEST_P(WideSplats, KeepTheToleranceInSumsOfManyWhereTheyAreCutOff)
{
  const auto [method, sigma] = GetParam();
  const Region                       image = MakeImage(sigma);
  itk::ReproducibleRandom            random(17);
  std::vector<std::array<double, 3>> splats;
  for (int i = 0; i < 40; ++i)
  {
    splats.push_back({ { random.Uniform(-0.8, 0.8) * sigma, random.Uniform(-0.8, 0.8) * sigma, random.Uniform() } });
  }
  const Layer layer = MakeLayer(method, sigma, splats);
  for (const double tolerance : { 1e-2, 1e-3, 1e-4 })
  {
    const Kernel kernel(layer, image, tolerance, method == Method::PerSplat ? Method::Automatic : method);
    ASSERT_EQ(kernel.GetMethod(), method);
    EXPECT_LE(RelativeError(layer, image, Render(kernel, image)), tolerance) << "tolerance " << tolerance;
  }
}

INSTANTIATE_TEST_SUITE_P(
  Cut,
  WideSplats,
  ::testing::Combine(::testing::Values(Method::Table, Method::CubicSpline, Method::QuinticSpline, Method::PerSplat),
                     ::testing::Values(11.0, 37.0)));

TEST(SurfaceSplatKernel, ChoosesSplinesForManyWideSplatsOnly)
{
  itk::ReproducibleRandom random(3);
  Layer                   layer;
  for (int i = 0; i < 20000; ++i)
  {
    Add(layer, random.Uniform(0, 200), random.Uniform(0, 100), 1.0);
  }
  const Region image{ 0, 0, 200, 100 };
  const auto   method = [&](double sigma, double tolerance) {
    layer.sigmaU = sigma;
    layer.sigmaV = sigma;
    return Kernel(layer, image, tolerance).GetMethod();
  };
  EXPECT_EQ(method(0.7, 1e-3), Method::Table);
  EXPECT_EQ(method(1.0, 1e-3), Method::Table);
  EXPECT_EQ(method(3.0, 1e-3), Method::CubicSpline);
  // A tighter tolerance needs the smoother spline.
  EXPECT_EQ(method(2.0, 1e-4), Method::QuinticSpline);
  EXPECT_EQ(method(1.5, 1e-6), Method::Table);
  layer.u.resize(20);
  layer.v.resize(20);
  layer.weight.resize(20);
  EXPECT_EQ(method(3.0, 1e-3), Method::Table) << "twenty splats do not pay for filtering an image";
}

class SplatMethods : public ::testing::TestWithParam<Method>
{
protected:
  static Layer
  MakeLayer(Method method)
  {
    itk::ReproducibleRandom random(5);
    Layer                   layer;
    layer.sigmaU = 2.1;
    layer.sigmaV = 1.7;
    for (int i = 0; i < 3000; ++i)
    {
      Add(layer, random.Uniform(-8, 150), random.Uniform(-8, 120), random.Uniform());
      if (method == Method::PerSplat)
      {
        layer.sigmaUs.push_back(static_cast<float>(random.Uniform(0.4, 4)));
        layer.sigmaVs.push_back(static_cast<float>(random.Uniform(0.4, 4)));
      }
    }
    return layer;
  }
};

TEST_P(SplatMethods, RendersEveryRegionAndThreadCountToTheSameBits)
{
  const Region image{ -5, -4, 141, 117 };
  const Kernel kernel(MakeLayer(GetParam()), image, 1e-3, GetParam());
  ASSERT_EQ(kernel.GetMethod(), GetParam());
  const std::vector<float> whole = Render(kernel, image);
  for (const unsigned int threads : { 2u, 5u, 0u })
  {
    EXPECT_EQ(Render(kernel, image, threads), whole) << threads << " threads";
  }
  const Region parts[] = { { -5, -4, 141, 1 }, { -5, 112, 141, 1 }, { -5, 20, 141, 17 },
                           { 17, 31, 9, 40 },  { 135, 90, 1, 23 },  { 60, 60, 33, 33 } };
  for (const Region & part : parts)
  {
    const std::vector<float> pixels = Render(kernel, part, 2);
    for (std::int64_t v = 0; v < part.sizeV; ++v)
    {
      for (std::int64_t u = 0; u < part.sizeU; ++u)
      {
        const auto at =
          static_cast<std::size_t>((v + part.startV - image.startV) * image.sizeU + u + part.startU - image.startU);
        ASSERT_EQ(pixels[static_cast<std::size_t>(v * part.sizeU + u)], whole[at])
          << "pixel " << u << ", " << v << " of the region at " << part.startU << ", " << part.startV;
      }
    }
  }
}

TEST_P(SplatMethods, LeavesPixelsOutsideTheRegionAlone)
{
  const Region       image{ 0, 0, 100, 80 };
  const Kernel       kernel(MakeLayer(GetParam()), image, 1e-3, GetParam());
  const Region       region{ 30, 20, 21, 11 };
  std::vector<float> pixels(40 * 31, 7.0f);
  kernel.Render(region, pixels.data() + 10 * 40 + 10, 40, 2);
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    const bool inside = i % 40 >= 10 && i % 40 < 31 && i / 40 >= 10 && i / 40 < 21;
    ASSERT_EQ(pixels[i] != 7.0f, inside) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
  All, SplatMethods, ::testing::Values(Method::Table, Method::CubicSpline, Method::QuinticSpline, Method::PerSplat));

TEST(SurfaceSplatKernel, WidthsOfTheirOwnMeetTheTolerance)
{
  itk::ReproducibleRandom random(8);
  Layer                   layer;
  for (int i = 0; i < 2000; ++i)
  {
    Add(layer, random.Uniform(-5, 105), random.Uniform(-5, 85), random.Uniform());
    layer.sigmaUs.push_back(static_cast<float>(std::exp(random.Uniform(std::log(0.1), std::log(12.0)))));
    layer.sigmaVs.push_back(static_cast<float>(std::exp(random.Uniform(std::log(0.1), std::log(12.0)))));
  }
  const Region image{ 0, 0, 100, 80 };
  for (const double tolerance : { 1e-2, 1e-3, 1e-5 })
  {
    EXPECT_LE(RelativeError(layer, image, Render(Kernel(layer, image, tolerance), image)), tolerance);
  }
}

TEST(SurfaceSplatKernel, AddsToWhatIsThere)
{
  Layer layer;
  Add(layer, 5.0, 5.0, 1.0);
  const Region       image{ 0, 0, 11, 11 };
  const Kernel       kernel(layer, image, 1e-3);
  std::vector<float> pixels(121, 2.0f);
  kernel.Render(image, pixels.data(), 11);
  EXPECT_FLOAT_EQ(pixels[60], 3.0f);
}

TEST(SurfaceSplatKernel, NoSplatOrNoneInReachLeavesTheImageUntouched)
{
  const Region image{ 0, 0, 20, 20 };
  Layer        layer;
  EXPECT_EQ(Render(Kernel(layer, image, 1e-3), image), std::vector<float>(400, 0.0f));
  Add(layer, 500.0, 10.0, 1.0);
  const Kernel kernel(layer, image, 1e-3);
  EXPECT_EQ(kernel.GetNumberOfSplats(), 0u);
  EXPECT_EQ(Render(kernel, image), std::vector<float>(400, 0.0f));
}

TEST(SurfaceSplatKernel, RefusesWhatItCannotRender)
{
  const Region image{ 0, 0, 20, 20 };
  Layer        layer;
  Add(layer, 5.0, 5.0, 1.0);
  EXPECT_THROW(Kernel(layer, image, 0.0), std::invalid_argument);
  EXPECT_THROW(Kernel(layer, image, std::nan("")), std::invalid_argument);
  Layer flat = layer;
  flat.sigmaU = 0.0;
  EXPECT_THROW(Kernel(flat, image, 1e-3), std::invalid_argument);
  Layer huge = layer;
  huge.sigmaV = 1e5;
  EXPECT_THROW(Kernel(huge, image, 1e-3), std::invalid_argument);
  Layer nan = layer;
  nan.u[0] = std::nan("");
  EXPECT_THROW(Kernel(nan, image, 1e-3), std::invalid_argument);
  Layer uneven = layer;
  uneven.v.push_back(1.0);
  EXPECT_THROW(Kernel(uneven, image, 1e-3), std::invalid_argument);
  Layer widths = layer;
  widths.sigmaUs = { 1.0f };
  EXPECT_THROW(Kernel(widths, image, 1e-3), std::invalid_argument);
}

TEST(SurfaceSplatKernel, FastExponentialIsWithinItsBound)
{
  for (double x = -80.0; x <= 0.0; x += 0.0137)
  {
    float value = static_cast<float>(x);
    itk::SurfaceSplatExp(&value, 1);
    const double truth = std::exp(static_cast<double>(static_cast<float>(x)));
    ASSERT_NEAR(value / truth, 1.0, 4e-6) << x;
  }
  float values[] = { -std::numeric_limits<float>::infinity(), -1e30f, 0.0f };
  itk::SurfaceSplatExp(values, 3);
  EXPECT_LT(values[0], 1e-37f);
  EXPECT_LT(values[1], 1e-37f);
  EXPECT_EQ(values[2], 1.0f);
}

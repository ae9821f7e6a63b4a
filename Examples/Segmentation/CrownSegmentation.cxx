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
#include "CrownSegmentation.h"

#include "itkAndImageFilter.h"
#include "itkBinaryBallStructuringElement.h"
#include "itkBinaryMorphologicalClosingImageFilter.h"
#include "itkBinaryMorphologicalOpeningImageFilter.h"
#include "itkBinaryThresholdImageFilter.h"
#include "itkChangeInformationImageFilter.h"
#include "itkConnectedComponentImageFilter.h"
#include "itkCyclicShiftImageFilter.h"
#include "itkHessianRecursiveGaussianImageFilter.h"
#include "itkImageFileWriter.h"
#include "itkImageRegionIteratorWithIndex.h"
#include "itkLabelStatisticsImageFilter.h"
#include "itkMaskImageFilter.h"
#include "itkMorphologicalWatershedFromMarkersImageFilter.h"
#include "itkOrImageFilter.h"
#include "itkOtsuMultipleThresholdsImageFilter.h"
#include "itkOtsuThresholdImageFilter.h"
#include "itkPNGImageIO.h"
#include "itkRelabelComponentImageFilter.h"
#include "itkSignedMaurerDistanceMapImageFilter.h"
#include "itkSmoothingRecursiveGaussianImageFilter.h"
#include "itkSymmetricEigenAnalysisImageFilter.h"
#include "itkThresholdImageFilter.h"
#include "itkVectorIndexSelectionCastImageFilter.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using ComponentImageType = itk::Image<unsigned int, 2>;
using HessianFilterType = itk::HessianRecursiveGaussianImageFilter<FloatImageType>;
using HessianImageType = HessianFilterType::OutputImageType;

// Lengths in mm; they are sizes of teeth and not of one radiograph.
constexpr double denseSmoothing = 0.5;
constexpr double valleyWidth = 1.0;
constexpr double ridgeWidth = 0.6;
constexpr double edgeSmoothing = 0.3;
constexpr double markerOffset = 3.5;
constexpr double crownHeight = 7.0;
/** Beyond the dense part of the teeth, where their thin edges may be. */
constexpr double reach = 6.5;

template <typename TFilter>
typename TFilter::OutputImageType::Pointer
Run(TFilter * filter)
{
  filter->Update();
  typename TFilter::OutputImageType::Pointer output = filter->GetOutput();
  output->DisconnectPipeline();
  return output;
}

template <typename TFunction>
LabelImageType::Pointer
MaskOf(const FloatImageType * like, const TFunction & value)
{
  auto mask = LabelImageType::New();
  mask->CopyInformation(like);
  mask->SetRegions(like->GetLargestPossibleRegion());
  mask->Allocate(true);
  for (itk::ImageRegionIteratorWithIndex<LabelImageType> it(mask, mask->GetLargestPossibleRegion()); !it.IsAtEnd();
       ++it)
  {
    it.Set(static_cast<unsigned char>(value(it.GetIndex())));
  }
  return mask;
}
FloatImageType::Pointer
Smooth(const FloatImageType * image, double sigma)
{
  auto filter = itk::SmoothingRecursiveGaussianImageFilter<FloatImageType>::New();
  filter->SetInput(image);
  filter->SetSigma(sigma);
  return Run(filter.GetPointer());
}

template <typename TImage>
LabelImageType::Pointer
Between(const TImage * image, double lower, double upper)
{
  auto filter = itk::BinaryThresholdImageFilter<TImage, LabelImageType>::New();
  filter->SetInput(image);
  filter->SetLowerThreshold(static_cast<typename TImage::PixelType>(lower));
  filter->SetUpperThreshold(static_cast<typename TImage::PixelType>(upper));
  filter->SetInsideValue(1);
  return Run(filter.GetPointer());
}

/** mm to the mask's border, negative inside. */
FloatImageType::Pointer
DistanceTo(const LabelImageType * mask)
{
  auto filter = itk::SignedMaurerDistanceMapImageFilter<LabelImageType, FloatImageType>::New();
  filter->SetInput(mask);
  filter->SquaredDistanceOff();
  filter->UseImageSpacingOn();
  return Run(filter.GetPointer());
}

LabelImageType::Pointer
And(const LabelImageType * a, const LabelImageType * b)
{
  auto filter = itk::AndImageFilter<LabelImageType>::New();
  filter->SetInput1(a);
  filter->SetInput2(b);
  return Run(filter.GetPointer());
}

LabelImageType::Pointer
Or(const LabelImageType * a, const LabelImageType * b)
{
  auto filter = itk::OrImageFilter<LabelImageType>::New();
  filter->SetInput1(a);
  filter->SetInput2(b);
  return Run(filter.GetPointer());
}

template <template <typename, typename, typename> class TFilter>
LabelImageType::Pointer
Morphology(const LabelImageType * mask, unsigned int radius)
{
  using BallType = itk::BinaryBallStructuringElement<unsigned char, 2>;
  BallType ball;
  ball.SetRadius(radius);
  ball.CreateStructuringElement();
  auto filter = TFilter<LabelImageType, LabelImageType, BallType>::New();
  filter->SetInput(mask);
  filter->SetKernel(ball);
  filter->SetForegroundValue(1);
  return Run(filter.GetPointer());
}

ComponentImageType::Pointer
Components(const LabelImageType * mask)
{
  auto filter = itk::ConnectedComponentImageFilter<LabelImageType, ComponentImageType>::New();
  filter->SetInput(mask);
  return Run(filter.GetPointer());
}

LabelImageType::Pointer
LargestComponent(const LabelImageType * mask)
{
  auto filter = itk::RelabelComponentImageFilter<ComponentImageType, ComponentImageType>::New();
  filter->SetInput(Components(mask));
  return Between(Run(filter.GetPointer()).GetPointer(), 1, 1);
}

HessianImageType::Pointer
Hessian(const FloatImageType * image, double sigma)
{
  auto filter = HessianFilterType::New();
  filter->SetInput(image);
  filter->SetSigma(sigma);
  return Run(filter.GetPointer());
}

template <typename TImage>
FloatImageType::Pointer
PositivePartOf(const TImage * image, unsigned int component)
{
  auto select = itk::VectorIndexSelectionCastImageFilter<TImage, FloatImageType>::New();
  select->SetInput(image);
  select->SetIndex(component);
  auto threshold = itk::ThresholdImageFilter<FloatImageType>::New();
  threshold->SetInput(select->GetOutput());
  threshold->ThresholdBelow(0.0f);
  return Run(threshold.GetPointer());
}

/** The larger principal second derivative: high along dark lines whatever their direction. */
FloatImageType::Pointer
DarkRidges(const FloatImageType * image, double sigma)
{
  using EigenImageType = itk::Image<itk::FixedArray<float, 2>, 2>;
  auto filter = itk::SymmetricEigenAnalysisImageFilter<HessianImageType, EigenImageType>::New();
  filter->SetInput(Hessian(image, sigma));
  filter->SetDimension(2);
  filter->OrderEigenValuesBy(itk::SymmetricEigenAnalysisEnums::EigenValueOrder::OrderByValue);
  return PositivePartOf(Run(filter.GetPointer()).GetPointer(), 1);
}

/** The dark line between upper and lower crowns: the strongest horizontal valley within the teeth. */
LabelImageType::Pointer
OcclusalValley(const FloatImageType * image, const LabelImageType * region)
{
  // Component 2 of the Hessian is the second derivative along v.
  const auto second = PositivePartOf(Hessian(image, valleyWidth).GetPointer(), 2);
  auto       mask = itk::MaskImageFilter<FloatImageType, LabelImageType>::New();
  mask->SetInput(second);
  mask->SetMaskImage(region);
  const auto inside = Run(mask.GetPointer());
  auto       otsu = itk::OtsuThresholdImageFilter<FloatImageType, LabelImageType, LabelImageType>::New();
  otsu->SetInput(inside);
  otsu->SetMaskImage(region);
  otsu->SetMaskValue(1);
  otsu->SetInsideValue(0);
  otsu->SetOutsideValue(1);
  const auto components = Components(Run(otsu.GetPointer()));
  auto       statistics = itk::LabelStatisticsImageFilter<FloatImageType, ComponentImageType>::New();
  statistics->SetInput(inside);
  statistics->SetLabelInput(components);
  statistics->Update();
  unsigned int best = 0;
  for (const auto label : statistics->GetValidLabelValues())
  {
    if (label != 0 && (best == 0 || statistics->GetSum(label) > statistics->GetSum(best)))
    {
      best = label;
    }
  }
  if (best == 0)
  {
    itkGenericExceptionMacro("No dark line between upper and lower crowns was found in the radiograph.");
  }
  return Between(components.GetPointer(), best, best);
}

/** 1 above, 2 below the valley, with the border along the darkest line. */
LabelImageType::Pointer
SplitAlong(const LabelImageType * valley, const FloatImageType * ridges, int offset)
{
  const auto shifted = [&](int rows) {
    auto                                                    filter = itk::CyclicShiftImageFilter<LabelImageType>::New();
    itk::CyclicShiftImageFilter<LabelImageType>::OffsetType shift{ { 0, rows } };
    filter->SetInput(valley);
    filter->SetShift(shift);
    return Run(filter.GetPointer());
  };
  const auto above = shifted(-offset);
  const auto below = shifted(offset);
  const auto markers = MaskOf(ridges, [&](const LabelImageType::IndexType & index) {
    return valley->GetPixel(index) != 0 ? 0 : above->GetPixel(index) != 0 ? 1 : below->GetPixel(index) != 0 ? 2 : 0;
  });
  auto       watershed = itk::MorphologicalWatershedFromMarkersImageFilter<FloatImageType, LabelImageType>::New();
  watershed->SetInput(ridges);
  watershed->SetMarkerImage(markers);
  watershed->MarkWatershedLineOff();
  watershed->FullyConnectedOn();
  return Run(watershed.GetPointer());
}

} // namespace

CrownSegmentation
SegmentCrowns(const FloatImageType * radiograph, double pixelSpacing, int facing)
{
  // Filters measure in mm.
  auto calibrate = itk::ChangeInformationImageFilter<FloatImageType>::New();
  calibrate->SetInput(radiograph);
  calibrate->SetOutputSpacing(FloatImageType::SpacingType(pixelSpacing));
  calibrate->ChangeSpacingOn();
  const FloatImageType::Pointer image = Run(calibrate.GetPointer());

  // 1. The dense part of the teeth: the brightest of four classes, its largest part.
  auto otsu = itk::OtsuMultipleThresholdsImageFilter<FloatImageType, LabelImageType>::New();
  otsu->SetInput(Smooth(image, denseSmoothing));
  otsu->SetNumberOfThresholds(3);
  const auto brightest = Between(Run(otsu.GetPointer()).GetPointer(), 3, 3);
  const auto teeth = LargestComponent(Morphology<itk::BinaryMorphologicalOpeningImageFilter>(brightest, 2));
  const auto toTeeth = DistanceTo(teeth);
  const auto region = Between(DistanceTo(Between(toTeeth.GetPointer(), -1e6, 6.0)).GetPointer(), -1e6, -5.0);

  // 2. The valley between the jaws, and on which side of it everything lies.
  const auto valley = OcclusalValley(image, region);
  const auto ridges = DarkRidges(image, ridgeWidth);
  const auto split = SplitAlong(valley, ridges, static_cast<int>(std::lround(markerOffset / pixelSpacing)));

  // 3. Where the valley ends in front, how high it lies, and how strong it is.
  double             front = -1e9;
  double             height = 0.0;
  std::vector<float> strengths;
  for (itk::ImageRegionConstIteratorWithIndex<LabelImageType> it(valley, valley->GetLargestPossibleRegion());
       !it.IsAtEnd();
       ++it)
  {
    if (it.Get() != 0)
    {
      front = std::max(front, facing * static_cast<double>(it.GetIndex()[0]));
      height += static_cast<double>(it.GetIndex()[1]);
      strengths.push_back(ridges->GetPixel(it.GetIndex()));
    }
  }
  height /= static_cast<double>(strengths.size());
  const auto third = strengths.begin() + static_cast<std::ptrdiff_t>(3 * strengths.size() / 10);
  std::nth_element(strengths.begin(), third, strengths.end());
  const float ridgeLevel = *third;

  // 4. Enamel fades out: what is clearly brighter than the soft tissue in front of the incisors is tooth.
  const auto fine = Smooth(image, edgeSmoothing);
  double     sum = 0.0;
  double     squares = 0.0;
  double     count = 0.0;
  for (itk::ImageRegionConstIteratorWithIndex<FloatImageType> it(fine, fine->GetLargestPossibleRegion()); !it.IsAtEnd();
       ++it)
  {
    const auto  index = it.GetIndex();
    const float distance = toTeeth->GetPixel(index);
    if (distance > 3.5f && distance < reach && facing * static_cast<double>(index[0]) > front &&
        std::abs(static_cast<double>(index[1]) - height) * pixelSpacing < 8.0)
    {
      sum += it.Get();
      squares += static_cast<double>(it.Get()) * it.Get();
      count += 1.0;
    }
  }
  if (count < 20.0)
  {
    itkGenericExceptionMacro("There is no soft tissue in front of the teeth to compare with. Check the facing.");
  }
  const double mean = sum / count;
  const double level = mean + 4.0 * std::sqrt(std::max(0.0, squares / count - mean * mean));
  const auto   bright = And(Between(fine.GetPointer(), level, 1e30), Between(toTeeth.GetPointer(), -1e6, reach));
  const auto   body = Morphology<itk::BinaryMorphologicalClosingImageFilter>(LargestComponent(Or(bright, valley)), 3);

  // 5. Crowns: within a crown's height of the valley, which is prolonged to the front.
  const int  width = static_cast<int>(std::lround(15.0 / pixelSpacing));
  const auto prolonged = MaskOf(image, [&](const LabelImageType::IndexType & index) {
    for (int shift = 0; shift <= width; shift += 2)
    {
      const LabelImageType::IndexType from{ { index[0] - facing * shift, index[1] } };
      if (valley->GetLargestPossibleRegion().IsInside(from) && valley->GetPixel(from) != 0)
      {
        return true;
      }
    }
    return false;
  });
  const auto toValley = DistanceTo(prolonged);
  const auto crowns = And(body, Between(toValley.GetPointer(), -1e6, crownHeight));

  // 6. What of the outlines is the border of a crown: in front, and for the upper crowns along the valley. The lower
  // ones end inside of the upper ones' shadow.
  const auto toBody = DistanceTo(body);
  const auto isEdge = [&](const LabelImageType::IndexType & index) {
    return toValley->GetPixel(index) < crownHeight - 1.0 && std::abs(toBody->GetPixel(index)) < 2.0 * pixelSpacing &&
           facing * static_cast<double>(index[0]) > front - 8.0 / pixelSpacing;
  };
  CrownSegmentation result;
  result.upper = And(crowns, Between(split.GetPointer(), 1, 1));
  result.lower = And(crowns, Between(split.GetPointer(), 2, 2));
  result.lowerBorder = MaskOf(image, isEdge);
  result.upperBorder = MaskOf(image, [&](const LabelImageType::IndexType & index) {
    return isEdge(index) || (toValley->GetPixel(index) < crownHeight - 1.0 && ridges->GetPixel(index) > ridgeLevel);
  });
  return result;
}

void
WriteLabels(const CrownSegmentation & segmentation, const std::string & fileName)
{
  auto picture = LabelImageType::New();
  picture->SetRegions(segmentation.upper->GetLargestPossibleRegion());
  picture->Allocate();
  for (itk::ImageRegionIteratorWithIndex<LabelImageType> it(picture, picture->GetLargestPossibleRegion());
       !it.IsAtEnd();
       ++it)
  {
    it.Set(segmentation.upper->GetPixel(it.GetIndex()) != 0   ? 128
           : segmentation.lower->GetPixel(it.GetIndex()) != 0 ? 255
                                                              : 0);
  }
  auto writer = itk::ImageFileWriter<LabelImageType>::New();
  writer->SetInput(picture);
  writer->SetImageIO(itk::PNGImageIO::New());
  writer->SetFileName(fileName);
  writer->Update();
}

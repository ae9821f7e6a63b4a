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

#include "itkCorrelationImageToImageMetricv4.h"
#include "itkGradientMagnitudeRecursiveGaussianImageFilter.h"
#include "itkMattesMutualInformationImageToImageMetricv4.h"
#include "itkRegularStepGradientDescentOptimizerv4.h"
#include "itkSmoothingRecursiveGaussianImageFilter.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <mutex>
#include <ostream>

namespace itk
{
namespace
{
using ImageType = IntensityRegistrationMethod::ImageType;
using TransformType = ContourBaselineRegistrationMethod::TransformType;
using MetricType = ImageToImageMetricv4<ImageType, ImageType>;
using OptimizerType = RegularStepGradientDescentOptimizerv4<double>;

/** The same pixels on the grid of their indices. */
ImageType::Pointer
OnIndexGrid(const ImageType * image)
{
  auto result = ImageType::New();
  result->SetRegions(image->GetBufferedRegion());
  result->SetPixelContainer(const_cast<ImageType::PixelContainer *>(image->GetPixelContainer()));
  return result;
}

ImageType::Pointer
Prepare(const ImageType * image, double sigma, bool gradient)
{
  ImageType::Pointer result;
  const auto         grid = OnIndexGrid(image);
  if (gradient)
  {
    auto filter = GradientMagnitudeRecursiveGaussianImageFilter<ImageType, ImageType>::New();
    filter->SetInput(grid);
    filter->SetSigma(sigma);
    filter->SetNumberOfWorkUnits(1);
    filter->Update();
    result = filter->GetOutput();
  }
  else
  {
    auto filter = SmoothingRecursiveGaussianImageFilter<ImageType, ImageType>::New();
    filter->SetInput(grid);
    filter->SetSigma(sigma);
    filter->SetNumberOfWorkUnits(1);
    filter->Update();
    result = filter->GetOutput();
  }
  result->DisconnectPipeline();
  return result;
}

/** A metric of ITK's in one work unit: more would add the same terms in another order, and
 * SetMaximumNumberOfWorkUnits() limits only the threads that share them. */
template <typename TThreader>
void
UseOneWorkUnit(TThreader & threader)
{
  threader.SetMaximumNumberOfThreads(1);
  threader.SetNumberOfWorkUnits(1);
}

class MutualInformationInOneWorkUnit : public MattesMutualInformationImageToImageMetricv4<ImageType, ImageType>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MutualInformationInOneWorkUnit);
  using Self = MutualInformationInOneWorkUnit;
  using Superclass = MattesMutualInformationImageToImageMetricv4<ImageType, ImageType>;
  using Pointer = SmartPointer<Self>;
  itkFactorylessNewMacro(Self);

protected:
  MutualInformationInOneWorkUnit() { UseOneWorkUnit(*this->m_DenseGetValueAndDerivativeThreader); }
  ~MutualInformationInOneWorkUnit() override = default;
};

class CorrelationInOneWorkUnit : public CorrelationImageToImageMetricv4<ImageType, ImageType>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CorrelationInOneWorkUnit);
  using Self = CorrelationInOneWorkUnit;
  using Superclass = CorrelationImageToImageMetricv4<ImageType, ImageType>;
  using Pointer = SmartPointer<Self>;
  itkFactorylessNewMacro(Self);

protected:
  CorrelationInOneWorkUnit()
  {
    UseOneWorkUnit(*this->m_DenseGetValueAndDerivativeThreader);
    // Sums the means before each evaluation; made with ITK's global number of threads.
    UseOneWorkUnit(*this->m_HelperDenseThreader);
  }
  ~CorrelationInOneWorkUnit() override = default;
};

/** ITK's metrics write to the error stream where the images do not overlap, which is an outcome here. The switch is
 * global: the last registration that ends sets it back. */
class QuietMetrics
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(QuietMetrics);
  QuietMetrics()
  {
    const std::lock_guard<std::mutex> guard(Mutex());
    if (Count()++ == 0)
    {
      Before() = Object::GetGlobalWarningDisplay();
      Object::SetGlobalWarningDisplay(false);
    }
  }
  ~QuietMetrics()
  {
    const std::lock_guard<std::mutex> guard(Mutex());
    if (--Count() == 0)
    {
      Object::SetGlobalWarningDisplay(Before());
    }
  }

private:
  static std::mutex &
  Mutex()
  {
    static std::mutex mutex;
    return mutex;
  }
  static unsigned int &
  Count()
  {
    static unsigned int count = 0;
    return count;
  }
  static bool &
  Before()
  {
    static bool before = true;
    return before;
  }
};

MetricType::Pointer
MakeMetric(IntensityRegistrationMethod::MeasureEnum measure)
{
  if (measure == IntensityRegistrationMethod::MeasureEnum::MutualInformation)
  {
    auto metric = MutualInformationInOneWorkUnit::New();
    metric->SetNumberOfHistogramBins(32);
    return metric.GetPointer();
  }
  return CorrelationInOneWorkUnit::New().GetPointer();
}

/** What the metric moves is the way back, from the radiograph to the DRR. */
TransformType::Pointer
ToMovingTransform(const ContourSimilarity & similarity, const TransformType::InputPointType & centre)
{
  const std::complex<double>    linear = std::polar(similarity.scale, similarity.angle);
  const std::complex<double>    c(centre[0], centre[1]);
  const std::complex<double>    shift = (c - std::complex<double>(similarity.tx, similarity.ty)) / linear - c;
  auto                          transform = TransformType::New();
  TransformType::ParametersType parameters(4);
  transform->SetCenter(centre);
  parameters[0] = 1.0 / similarity.scale;
  parameters[1] = -similarity.angle;
  parameters[2] = shift.real();
  parameters[3] = shift.imag();
  transform->SetParameters(parameters);
  return transform;
}

ContourSimilarity
FromMovingTransform(const TransformType * transform)
{
  const std::complex<double> linear = std::polar(1.0 / transform->GetScale(), -transform->GetAngle());
  const std::complex<double> translation =
    -linear * std::complex<double>(transform->GetOffset()[0], transform->GetOffset()[1]);
  return { 1.0 / transform->GetScale(), -transform->GetAngle(), translation.real(), translation.imag() };
}
} // namespace

std::ostream &
operator<<(std::ostream & os, IntensityRegistrationEnums::Measure measure)
{
  switch (measure)
  {
    case IntensityRegistrationEnums::Measure::MutualInformation:
      return os << "MutualInformation";
    case IntensityRegistrationEnums::Measure::NormalizedCorrelation:
      return os << "NormalizedCorrelation";
    default:
      return os << "GradientCorrelation";
  }
}

void
IntensityRegistrationMethod::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetFixedImage() == nullptr)
  {
    itkExceptionMacro("No fixed image: call SetFixedImage() with the radiograph.");
  }
  if (this->GetMovingImage() == nullptr)
  {
    itkExceptionMacro("No moving image: call SetMovingImage() with the DRR in q.");
  }
  Superclass::VerifyPreconditions();
}

ContourSimilarity
IntensityRegistrationMethod::RegisterContours(const PointsType & fixed,
                                              const PointsType &,
                                              const ContourSimilarity & start)
{
  // The region of interest.
  double low[2] = { fixed.points[0], fixed.points[1] };
  double high[2] = { fixed.points[0], fixed.points[1] };
  for (std::size_t i = 0; i < fixed.points.size(); ++i)
  {
    low[i % 2] = std::min(low[i % 2], fixed.points[i]);
    high[i % 2] = std::max(high[i % 2], fixed.points[i]);
  }
  const double margin = m_Margin * std::max(high[0] - low[0], high[1] - low[1]);
  const auto   region = this->GetFixedImage()->GetBufferedRegion();
  for (unsigned int d = 0; d < 2; ++d)
  {
    const auto first = static_cast<double>(region.GetIndex()[d]);
    const auto last = first + static_cast<double>(region.GetSize()[d]) - 1.0;
    low[d] = std::max(std::floor(low[d] - margin), first);
    high[d] = std::min(std::ceil(high[d] + margin), last);
    if (!(high[d] - low[d] >= 16.0))
    {
      itkExceptionMacro("The tracing's surroundings show " << std::max(0.0, high[d] - low[d])
                                                           << " px of the radiograph; at least 16 are needed.");
    }
  }
  TransformType::InputPointType centre;
  centre[0] = 0.5 * (low[0] + high[0]);
  centre[1] = 0.5 * (low[1] + high[1]);
  const double reach = 0.5 * std::hypot(high[0] - low[0], high[1] - low[1]);

  const QuietMetrics quiet;
  const double       shrinks[] = { 4.0, 2.0 };
  const double       firstSteps[] = { 4.0, 1.0 };
  ContourSimilarity  similarity = start;
  for (unsigned int level = 0; level < 2; ++level)
  {
    this->StartLevel(level, similarity);
    const bool   gradient = m_Measure == MeasureEnum::GradientCorrelation;
    const double sigma = 0.5 * shrinks[level];
    const auto   fixedImage = Prepare(this->GetFixedImage(), sigma, gradient);
    const auto   movingImage = Prepare(this->GetMovingImage(), sigma, gradient);

    ImageType::SpacingType spacing;
    spacing.Fill(shrinks[level]);
    ImageType::PointType     origin;
    ImageType::RegionType    domain;
    ImageType::DirectionType direction;
    direction.SetIdentity();
    for (unsigned int d = 0; d < 2; ++d)
    {
      origin[d] = low[d];
      domain.SetSize(d, static_cast<SizeValueType>(std::floor((high[d] - low[d]) / shrinks[level])) + 1);
    }
    const auto transform = ToMovingTransform(similarity, centre);
    const auto metric = MakeMetric(m_Measure);
    metric->SetFixedImage(fixedImage);
    metric->SetMovingImage(movingImage);
    metric->SetVirtualDomain(spacing, origin, direction, domain);
    metric->SetMovingTransform(transform);

    auto optimizer = OptimizerType::New();
    optimizer->SetNumberOfWorkUnits(1);
    OptimizerType::ScalesType scales(4);
    scales.Fill(1.0);
    scales[0] = reach * reach;
    scales[1] = reach * reach;
    optimizer->SetScales(scales);
    if (this->GetMotion() == MotionEnum::Rigid)
    {
      OptimizerType::ScalesType weights(4);
      weights.Fill(1.0);
      weights[0] = 0.0;
      optimizer->SetWeights(weights);
    }
    optimizer->SetDoEstimateLearningRateOnce(false);
    optimizer->SetLearningRate(firstSteps[level]);
    optimizer->SetMinimumStepLength(0.01);
    optimizer->SetRelaxationFactor(0.6);
    optimizer->SetGradientMagnitudeTolerance(1e-12);
    optimizer->SetNumberOfIterations(m_MaximumNumberOfIterations);
    ContourSimilarity last = similarity;
    optimizer->AddObserver(IterationEvent(), [&](const EventObject &) {
      if (transform->GetScale() > 1e-3)
      {
        last = FromMovingTransform(transform);
      }
      const float done = (static_cast<float>(level) + static_cast<float>(optimizer->GetCurrentIteration()) /
                                                        static_cast<float>(m_MaximumNumberOfIterations)) /
                         2.0F;
      this->ReportIteration(optimizer->GetCurrentIteration(), optimizer->GetValue(), last, std::min(done, 1.0F));
    });
    try
    {
      metric->Initialize();
      optimizer->SetMetric(metric);
      optimizer->StartOptimization();
      this->SetStopConditionDescription(optimizer->GetStopConditionDescription());
      if (transform->GetScale() > 1e-3)
      {
        last = FromMovingTransform(transform);
      }
    }
    catch (const ProcessAborted &)
    {
      throw;
    }
    catch (const ExceptionObject & error)
    {
      // The DRR left the region of interest: an outcome of this method, and no defect of the input.
      this->SetStopConditionDescription(std::string("The metric could not be evaluated: ") + error.GetDescription());
    }
    similarity = last;
  }
  return similarity;
}

void
IntensityRegistrationMethod::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Measure: " << m_Measure << std::endl;
  os << indent << "Margin: " << m_Margin << std::endl;
  os << indent << "MaximumNumberOfIterations: " << m_MaximumNumberOfIterations << std::endl;
}
} // namespace itk

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
#ifndef itkIntensityRegistrationMethod_h
#define itkIntensityRegistrationMethod_h

#include "itkContourBaselineRegistrationMethod.h"

#include "itkImage.h"

namespace itk
{
/** \class IntensityRegistrationEnums
 * \brief How two radiographs are compared.
 * \ingroup Baselines
 */
class IntensityRegistrationEnums
{
public:
  enum class Measure : std::uint8_t
  {
    /** MattesMutualInformationImageToImageMetricv4. */
    MutualInformation,
    /** CorrelationImageToImageMetricv4. */
    NormalizedCorrelation,
    /** The same on the magnitudes of the gradients. */
    GradientCorrelation
  };
};

/** \class IntensityRegistrationMethod
 * \brief Aligns a DRR with the radiograph by their grey values, with ITK's own v4 metrics and optimizer.
 *
 * Beside the contours of the base class it takes the radiograph and the DRR of the scan. Of both images only the index
 * counts: that of the radiograph is the pixel, that of the DRR is q (SurfaceDRRImageSource with the geometry whose
 * projection is q; its index may be negative). The DRR should be bright where it is dense, and have a border. The
 * contours give the start, as in the base class, and the fixed one the region of interest: its bounding box, larger by
 * Margin on each side, on a grid of 4 and then of 2 pixels after smoothing.
 *
 * RegularStepGradientDescentOptimizerv4 with steps that are the same in every parameter at the region's corners.
 * Deterministic: metrics run on one thread.
 *
 * Errors: an image missing, a region of interest that lies outside the radiograph. Where the DRR leaves the region of
 * interest the level ends where it was, and the stop condition says so.
 *
 * \ingroup Baselines
 */
class Baselines_EXPORT IntensityRegistrationMethod : public ContourBaselineRegistrationMethod
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(IntensityRegistrationMethod);

  using Self = IntensityRegistrationMethod;
  using Superclass = ContourBaselineRegistrationMethod;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(IntensityRegistrationMethod, ContourBaselineRegistrationMethod);

  using ImageType = Image<float, 2>;
  using MeasureEnum = IntensityRegistrationEnums::Measure;

  /** The radiograph. */
  itkSetInputMacro(FixedImage, ImageType);
  itkGetInputMacro(FixedImage, ImageType);

  /** The DRR, its index in q. */
  itkSetInputMacro(MovingImage, ImageType);
  itkGetInputMacro(MovingImage, ImageType);

  /** Default MutualInformation. */
  itkSetEnumMacro(Measure, MeasureEnum);
  itkGetEnumMacro(Measure, MeasureEnum);

  /** Free border of the region of interest, as a part of the tracing's larger extent. Default 0.15. */
  itkSetClampMacro(Margin, double, 0.0, 10.0);
  itkGetConstMacro(Margin, double);

  /** Of each level; default 100. */
  itkSetClampMacro(MaximumNumberOfIterations, unsigned int, 1, 1000000);
  itkGetConstMacro(MaximumNumberOfIterations, unsigned int);

protected:
  IntensityRegistrationMethod() = default;
  ~IntensityRegistrationMethod() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  VerifyPreconditions() ITKv5_CONST override;
  /** Radiograph and DRR are in different spaces by design. */
  void
  VerifyInputInformation() ITKv5_CONST override
  {}
  ContourSimilarity
  RegisterContours(const PointsType & fixed, const PointsType & moving, const ContourSimilarity & start) override;

private:
  MeasureEnum  m_Measure{ MeasureEnum::MutualInformation };
  double       m_Margin{ 0.15 };
  unsigned int m_MaximumNumberOfIterations{ 100 };
};

Baselines_EXPORT std::ostream &
                 operator<<(std::ostream & os, IntensityRegistrationEnums::Measure measure);
} // namespace itk

#endif

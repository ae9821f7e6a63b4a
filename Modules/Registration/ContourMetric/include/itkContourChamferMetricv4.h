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
#ifndef itkContourChamferMetricv4_h
#define itkContourChamferMetricv4_h

#include "itkContourToContourMetricv4.h"

namespace itk
{
/** \class ContourChamferMetricv4
 * \brief Symmetric or one-sided Chamfer distance between contours under a 2-D similarity, for stock v4 optimizers.
 *
 * The value is the paper's loss (section "Silhouette-to-Contour Registration"): the sum of the two directed mean
 * distances, pixels of the fixed frame; one of them in a one-sided direction. Note that the paper's tables, and
 * ContourDistanceFilter, give the average, half of the sum. Points are weighted as the contours say.
 *
 * Use: SetFixedContour(), SetMovingContour(), SetMovingTransform(), Initialize(), then optimizer->SetMetric(). What the
 * optimizer's parameters mean is said in ContourToContourMetricv4.
 *
 * \ingroup ContourMetric
 */
class ContourMetric_EXPORT ContourChamferMetricv4 : public ContourToContourMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ContourChamferMetricv4);

  using Self = ContourChamferMetricv4;
  using Superclass = ContourToContourMetricv4;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ContourChamferMetricv4, ContourToContourMetricv4);

  using DirectionEnum = ContourMetricEnums::Direction;
  using DistanceEnum = ContourMetricEnums::Distance;

  /** Symmetric (default), MovingToFixed (IOS -> CR) or FixedToMoving (CR -> IOS). */
  itkSetEnumMacro(Direction, DirectionEnum);
  itkGetEnumMacro(Direction, DirectionEnum);

  /** PointToPoint (default, the paper) or PointToSegment. Takes effect at the next Initialize(). */
  itkSetEnumMacro(Distance, DistanceEnum);
  itkGetEnumMacro(Distance, DistanceEnum);

  /** Distances beyond this many pixels count as this many; infinity (default) for none. Positive. */
  virtual void
  SetTruncation(double truncation);
  itkGetConstMacro(Truncation, double);

protected:
  ContourChamferMetricv4();
  ~ContourChamferMetricv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  InitializeContours(const ContourArrays & fixed, const ContourArrays & moving) override;
  MeasureType
  ComputeValue(const ContourSimilarity & similarity, ContourChamferKernel::GradientType * gradient) const override;
  MeasureType
  ComputeApproximateValue(const ContourSimilarity & similarity, SizeValueType numberOfPoints) const override;

private:
  DirectionEnum        m_Direction{ DirectionEnum::Symmetric };
  DistanceEnum         m_Distance{ DistanceEnum::PointToPoint };
  double               m_Truncation;
  ContourChamferKernel m_Kernel;
};
} // namespace itk

#endif

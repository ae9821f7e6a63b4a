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
#ifndef itkIterativeClosestPointContourRegistrationMethod_h
#define itkIterativeClosestPointContourRegistrationMethod_h

#include "itkContourBaselineRegistrationMethod.h"

namespace itk
{
/** \class IterativeClosestPointContourRegistrationMethod
 * \brief Iterative closest points between two contours (Besl, McKay 1992), rigid or similarity, plain or trimmed.
 *
 * Each iteration pairs every point of one contour with the nearest vertex of the other and takes the least-squares
 * motion of the pairs in closed form. By default the tracing's points look for the silhouette's (FixedToMoving): the
 * tracing shows a part of what the silhouette has. With a TrimmedFraction above 0 that share of the pairs, the farthest
 * apart, is left out of each fit (trimmed ICP, Chetverikov 2005).
 *
 * Ends where no point moves by more than Tolerance, or after MaximumNumberOfIterations. The metric's value is the mean
 * squared distance of the pairs that count, before the fit; it never grows for the plain method.
 *
 * \ingroup Baselines
 */
class Baselines_EXPORT IterativeClosestPointContourRegistrationMethod : public ContourBaselineRegistrationMethod
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(IterativeClosestPointContourRegistrationMethod);

  using Self = IterativeClosestPointContourRegistrationMethod;
  using Superclass = ContourBaselineRegistrationMethod;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(IterativeClosestPointContourRegistrationMethod, ContourBaselineRegistrationMethod);

  using DirectionEnum = ContourMetricEnums::Direction;

  /** FixedToMoving (default), MovingToFixed, or Symmetric: the pairs of both. */
  itkSetEnumMacro(Direction, DirectionEnum);
  itkGetEnumMacro(Direction, DirectionEnum);

  /** Share of the pairs that is left out, in [0, 0.9]; 0 (default) is plain ICP. */
  itkSetClampMacro(TrimmedFraction, double, 0.0, 0.9);
  itkGetConstMacro(TrimmedFraction, double);

  /** Default 200. */
  itkSetClampMacro(MaximumNumberOfIterations, unsigned int, 1, 1000000);
  itkGetConstMacro(MaximumNumberOfIterations, unsigned int);

  /** Pixels of the fixed contour; default 1e-4. */
  itkSetClampMacro(Tolerance, double, 0.0, 1e3);
  itkGetConstMacro(Tolerance, double);

protected:
  IterativeClosestPointContourRegistrationMethod() = default;
  ~IterativeClosestPointContourRegistrationMethod() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  ContourSimilarity
  RegisterContours(const PointsType & fixed, const PointsType & moving, const ContourSimilarity & start) override;

private:
  DirectionEnum m_Direction{ DirectionEnum::FixedToMoving };
  double        m_TrimmedFraction{ 0.0 };
  unsigned int  m_MaximumNumberOfIterations{ 200 };
  double        m_Tolerance{ 1e-4 };
};
} // namespace itk

#endif

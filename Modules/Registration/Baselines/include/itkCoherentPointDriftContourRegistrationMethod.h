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
#ifndef itkCoherentPointDriftContourRegistrationMethod_h
#define itkCoherentPointDriftContourRegistrationMethod_h

#include "itkContourBaselineRegistrationMethod.h"

namespace itk
{
/** \class CoherentPointDriftContourRegistrationMethod
 * \brief Coherent point drift between two contours, rigid or similarity (Myronenko, Song 2010, Fig. 2).
 *
 * The silhouette's vertices are the centroids of a Gaussian mixture, the tracing's points its samples; expectation
 * maximisation over the motion and one common variance, each step in closed form. OutlierWeight is the paper's w, the
 * share of samples that a uniform background explains: 0 (default) is the plain method, 0.2 or more the robust one.
 *
 * Ends where no point moves by more than Tolerance, or after MaximumNumberOfIterations. The metric's value is the
 * standard deviation of the mixture's components, pixels of the fixed contour.
 *
 * \ingroup Baselines
 */
class Baselines_EXPORT CoherentPointDriftContourRegistrationMethod : public ContourBaselineRegistrationMethod
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CoherentPointDriftContourRegistrationMethod);

  using Self = CoherentPointDriftContourRegistrationMethod;
  using Superclass = ContourBaselineRegistrationMethod;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CoherentPointDriftContourRegistrationMethod, ContourBaselineRegistrationMethod);

  /** In [0, 0.99]; default 0. */
  itkSetClampMacro(OutlierWeight, double, 0.0, 0.99);
  itkGetConstMacro(OutlierWeight, double);

  /** Default 150. */
  itkSetClampMacro(MaximumNumberOfIterations, unsigned int, 1, 1000000);
  itkGetConstMacro(MaximumNumberOfIterations, unsigned int);

  /** Pixels of the fixed contour; default 1e-3. */
  itkSetClampMacro(Tolerance, double, 0.0, 1e3);
  itkGetConstMacro(Tolerance, double);

protected:
  CoherentPointDriftContourRegistrationMethod() = default;
  ~CoherentPointDriftContourRegistrationMethod() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  ContourSimilarity
  RegisterContours(const PointsType & fixed, const PointsType & moving, const ContourSimilarity & start) override;

private:
  double       m_OutlierWeight{ 0.0 };
  unsigned int m_MaximumNumberOfIterations{ 150 };
  double       m_Tolerance{ 1e-3 };
};
} // namespace itk

#endif

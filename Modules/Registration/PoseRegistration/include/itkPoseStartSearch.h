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
#ifndef itkPoseStartSearch_h
#define itkPoseStartSearch_h

#include "itkPoseStart.h"

#include <vector>

namespace itk
{
/** \class PoseStartSearch
 * \brief Exhaustive search over in-plane rotation, shift and scale of the tracing against one contour.
 *
 * Distances in position and normal, truncated at 12 px of 0.25 mm, are read from a table (2 px, 16 directions); every
 * third tracing point is used. The starts are the best grid points that differ by more than 5 degrees or 10 px. Looks
 * at the terms of the metric that FindSilhouettesOfStart() finds: the jaws', not those of a user's further view.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT PoseStartSearch : public PoseStart
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PoseStartSearch);

  using Self = PoseStartSearch;
  using Superclass = PoseStart;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(PoseStartSearch, PoseStart);

  /** Half range and step of the rotation, rad: 32 and 4 degrees. */
  itkSetMacro(RotationRange, double);
  itkGetConstMacro(RotationRange, double);
  itkSetMacro(RotationStep, double);
  itkGetConstMacro(RotationStep, double);
  /** Half ranges and step of the shift of the contour's centre from the tracing's, px: 64, 40 and 8. */
  itkSetMacro(HorizontalRange, double);
  itkGetConstMacro(HorizontalRange, double);
  itkSetMacro(VerticalRange, double);
  itkGetConstMacro(VerticalRange, double);
  itkSetMacro(ShiftStep, double);
  itkGetConstMacro(ShiftStep, double);
  /** Logarithms of the scale factors that are tried where the scale is searched: 0 and +-35 % by 7 %. */
  void
  SetKappas(const std::vector<double> & kappas);
  const std::vector<double> &
  GetKappas() const
  {
    return m_Kappas;
  }

  std::vector<StartType>
  Search(const LeastSquaresMetricv4 & metric, const RequestType & request) const override;

protected:
  PoseStartSearch() = default;
  ~PoseStartSearch() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  double              m_RotationRange{ 0.5585053606381855 };
  double              m_RotationStep{ 0.06981317007977318 };
  double              m_HorizontalRange{ 64.0 };
  double              m_VerticalRange{ 40.0 };
  double              m_ShiftStep{ 8.0 };
  std::vector<double> m_Kappas{ 0.0, -0.35, -0.28, -0.21, -0.14, -0.07, 0.07, 0.14, 0.21, 0.28, 0.35 };
};
} // namespace itk

#endif

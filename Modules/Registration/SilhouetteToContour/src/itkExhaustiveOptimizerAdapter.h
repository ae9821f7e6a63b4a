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
#ifndef itkExhaustiveOptimizerAdapter_h
#define itkExhaustiveOptimizerAdapter_h

#include "itkOptimizerAdapter.h"

#include "itkExhaustiveOptimizerv4.h"

// Exhaustive walks a grid, whose reach its scales say. Private to this module.
namespace itk
{
/** \class ExhaustiveOptimizerAdapter
 * \brief Scales that make the grid reach the bounds, where none are given.
 */
class ExhaustiveOptimizerAdapter : public OptimizerAdapter
{
public:
  using OwnType = ExhaustiveOptimizerv4<double>;

  explicit ExhaustiveOptimizerAdapter(OwnType * optimizer);

  /** Its effort is its numbers of steps: no level changes them. */
  void
  SetNumberOfIterations(SizeValueType iterations) override;
  void
  Prepare(const ParametersType & start, const ParametersType & lower, const ParametersType & upper) override;
  void
  Restore() override;

private:
  OwnType * m_Own;
  bool      m_SetScales;
};
} // namespace itk

#endif

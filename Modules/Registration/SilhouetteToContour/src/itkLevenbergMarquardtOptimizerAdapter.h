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
#ifndef itkLevenbergMarquardtOptimizerAdapter_h
#define itkLevenbergMarquardtOptimizerAdapter_h

#include "itkOptimizerAdapter.h"

#include "itkLevenbergMarquardtOptimizerv4.h"

// Levenberg-Marquardt reports trials as well as steps. Private to this module.
namespace itk
{
/** \class LevenbergMarquardtOptimizerAdapter
 * \brief Tells the steps that were taken from those that were refused.
 */
class LevenbergMarquardtOptimizerAdapter : public OptimizerAdapter
{
public:
  using OwnType = LevenbergMarquardtOptimizerv4;

  explicit LevenbergMarquardtOptimizerAdapter(OwnType * optimizer);

  /** A step that was refused is no iteration, and the metric does not stand at the position that counts. */
  bool
  IsIteration(const EventObject & event) const override;

private:
  OwnType * m_Own;
};
} // namespace itk

#endif

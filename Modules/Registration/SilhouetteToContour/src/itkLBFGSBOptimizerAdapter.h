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
#ifndef itkLBFGSBOptimizerAdapter_h
#define itkLBFGSBOptimizerAdapter_h

#include "itkOptimizerAdapter.h"

#include "itkLBFGSBOptimizerv4.h"

// LBFGSB takes bounds, and its code is not reentrant. Private to this module.
namespace itk
{
/** \class LBFGSBOptimizerAdapter
 * \brief Bounds and first position of LBFGSB; one run at a time.
 */
class LBFGSBOptimizerAdapter : public OptimizerAdapter
{
public:
  using OwnType = LBFGSBOptimizerv4;

  explicit LBFGSBOptimizerAdapter(OwnType * optimizer);

  void
  Prepare(const ParametersType & start, const ParametersType & lower, const ParametersType & upper) override;
  std::string
  Start() override;

private:
  OwnType * m_Own;
};
} // namespace itk

#endif

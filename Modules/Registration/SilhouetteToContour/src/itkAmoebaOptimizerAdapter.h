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
#ifndef itkAmoebaOptimizerAdapter_h
#define itkAmoebaOptimizerAdapter_h

#include "itkOptimizerAdapter.h"

#include "itkAmoebaOptimizerv4.h"

// Amoeba takes no bounds but a simplex to begin with, and counts evaluations. Private to this module.
namespace itk
{
/** \class AmoebaOptimizerAdapter
 * \brief A simplex of a quarter of the bounds, where the optimizer is to make its own.
 */
class AmoebaOptimizerAdapter : public OptimizerAdapter
{
public:
  using OwnType = AmoebaOptimizerv4;

  explicit AmoebaOptimizerAdapter(OwnType * optimizer);

  void
  Prepare(const ParametersType & start, const ParametersType & lower, const ParametersType & upper) override;
  /** It reports its evaluations and nothing else. */
  bool
  IsIteration(const EventObject & event) const override;
  void
  Restore() override;

private:
  OwnType * m_Own;
  bool      m_SetSimplex;
};
} // namespace itk

#endif

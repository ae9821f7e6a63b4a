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
#ifndef itkOnePlusOneOptimizerAdapter_h
#define itkOnePlusOneOptimizerAdapter_h

#include "itkOptimizerAdapter.h"

#include "itkOnePlusOneEvolutionaryOptimizerv4.h"

// OnePlusOneEvolutionary draws its steps, and has a maximum of iterations of its own. Private to this module.
namespace itk
{
/** \class OnePlusOneOptimizerAdapter
 * \brief A generator that begins anew with each registration, so that a rerun repeats.
 */
class OnePlusOneOptimizerAdapter : public OptimizerAdapter
{
public:
  using OwnType = OnePlusOneEvolutionaryOptimizerv4<double>;

  OnePlusOneOptimizerAdapter(OwnType * optimizer, uint64_t seed);

  SizeValueType
  GetNumberOfIterations() const override;
  void
  SetNumberOfIterations(SizeValueType iterations) override;

private:
  OwnType * m_Own;
};
} // namespace itk

#endif

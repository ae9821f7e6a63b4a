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
#include "itkOptimizerAdapter.h"

#include "itkAmoebaOptimizerAdapter.h"
#include "itkExhaustiveOptimizerAdapter.h"
#include "itkLBFGSBOptimizerAdapter.h"
#include "itkOnePlusOneOptimizerAdapter.h"

#include <type_traits>
#include <typeinfo>

namespace itk
{
namespace
{
/** Null for another optimizer than the adapter's own. */
template <typename TAdapter>
std::unique_ptr<OptimizerAdapter>
MakeIfFits(OptimizerAdapter::OptimizerType * optimizer, uint64_t seed)
{
  using OwnType = typename TAdapter::OwnType;
  auto * own = dynamic_cast<OwnType *>(optimizer);
  if (own == nullptr)
  {
    return nullptr;
  }
  if constexpr (std::is_constructible_v<TAdapter, OwnType *, uint64_t>)
  {
    return std::make_unique<TAdapter>(own, seed);
  }
  else
  {
    return std::make_unique<TAdapter>(own);
  }
}

/** A row an optimizer that wants more than a metric. */
constexpr std::unique_ptr<OptimizerAdapter> (*Adapters[])(OptimizerAdapter::OptimizerType *,
                                                          uint64_t) = { MakeIfFits<LBFGSBOptimizerAdapter>,
                                                                        MakeIfFits<AmoebaOptimizerAdapter>,
                                                                        MakeIfFits<ExhaustiveOptimizerAdapter>,
                                                                        MakeIfFits<OnePlusOneOptimizerAdapter> };
} // namespace

std::unique_ptr<OptimizerAdapter>
OptimizerAdapter::Make(OptimizerType * optimizer, uint64_t seed)
{
  for (const auto make : Adapters)
  {
    if (auto adapter = make(optimizer, seed))
    {
      return adapter;
    }
  }
  return std::make_unique<OptimizerAdapter>(optimizer);
}

SizeValueType
OptimizerAdapter::GetNumberOfIterations() const
{
  return m_Optimizer->GetNumberOfIterations();
}

void
OptimizerAdapter::SetNumberOfIterations(SizeValueType iterations)
{
  m_Optimizer->SetNumberOfIterations(iterations);
}

void
OptimizerAdapter::Prepare(const ParametersType &, const ParametersType &, const ParametersType &)
{}

std::string
OptimizerAdapter::Start()
{
  m_Optimizer->StartOptimization();
  return m_Optimizer->GetStopConditionDescription();
}

bool
OptimizerAdapter::IsIteration(const EventObject & event) const
{
  return typeid(event) == typeid(IterationEvent);
}

void
OptimizerAdapter::Restore()
{}
} // namespace itk

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
#include "itkOnePlusOneOptimizerAdapter.h"

#include "itkRandomVariateGeneratorBase.h"
#include "itkReproducibleRandom.h"

namespace itk
{
namespace
{
/** A normal generator that starts anew with every run, so that a rerun repeats. */
class SeededNormalGenerator : public Statistics::RandomVariateGeneratorBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SeededNormalGenerator);
  using Self = SeededNormalGenerator;
  using Superclass = Statistics::RandomVariateGeneratorBase;
  using Pointer = SmartPointer<Self>;
  itkFactorylessNewMacro(Self);
  itkTypeMacro(SeededNormalGenerator, RandomVariateGeneratorBase);

  void
  SetSeed(uint64_t seed)
  {
    m_Random = ReproducibleRandom(seed);
  }
  double
  GetVariate() override
  {
    return m_Random.Normal();
  }

protected:
  SeededNormalGenerator() = default;
  ~SeededNormalGenerator() override = default;

private:
  ReproducibleRandom m_Random{ 0 };
};
} // namespace

OnePlusOneOptimizerAdapter::OnePlusOneOptimizerAdapter(OwnType * optimizer, uint64_t seed)
  : OptimizerAdapter(optimizer)
  , m_Own(optimizer)
{
  const auto generator = SeededNormalGenerator::New();
  generator->SetSeed(seed);
  optimizer->SetNormalVariateGenerator(generator);
}

SizeValueType
OnePlusOneOptimizerAdapter::GetNumberOfIterations() const
{
  return m_Own->GetMaximumIteration();
}

void
OnePlusOneOptimizerAdapter::SetNumberOfIterations(SizeValueType iterations)
{
  m_Own->SetMaximumIteration(iterations);
}
} // namespace itk

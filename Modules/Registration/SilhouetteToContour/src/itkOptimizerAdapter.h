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
#ifndef itkOptimizerAdapter_h
#define itkOptimizerAdapter_h

#include "itkObjectToObjectOptimizerBase.h"

#include <cstdint>
#include <memory>
#include <string>

// Each of ITK's optimizers is told its bounds, first position and effort in a way of its own. An adapter an optimizer
// does that, so that a registration's run reads the same for all of them. Private to this module.
namespace itk
{
/** \class OptimizerAdapter
 * \brief How a v4 optimizer is run within bounds: as any of them can be; a subclass knows what its own wants besides.
 */
class OptimizerAdapter
{
public:
  using OptimizerType = ObjectToObjectOptimizerBaseTemplate<double>;
  using ParametersType = OptimizerType::ParametersType;

  /** The adapter that fits the optimizer. The seed is for an optimizer that draws numbers. */
  static std::unique_ptr<OptimizerAdapter>
  Make(OptimizerType * optimizer, uint64_t seed);

  explicit OptimizerAdapter(OptimizerType * optimizer)
    : m_Optimizer(optimizer)
  {}
  virtual ~OptimizerAdapter() = default;
  OptimizerAdapter(const OptimizerAdapter &) = delete;
  OptimizerAdapter &
  operator=(const OptimizerAdapter &) = delete;

  /** The maximum, whatever the optimizer calls it. */
  virtual SizeValueType
  GetNumberOfIterations() const;
  virtual void
  SetNumberOfIterations(SizeValueType iterations);

  /** Says to the optimizer where it begins and what its bounds are, as far as it can be told: the metric keeps the
   * others within them. */
  virtual void
  Prepare(const ParametersType & start, const ParametersType & lower, const ParametersType & upper);

  /** Runs the optimizer, whose metric is set. \return the stop condition. */
  virtual std::string
  Start();

  /** Whether what the optimizer sends tells of an iteration that counts: evaluations are subclasses of the event. */
  virtual bool
  IsIteration(const EventObject & event) const;

  /** Takes back what Prepare() set for good. */
  virtual void
  Restore();

private:
  OptimizerType * m_Optimizer;
};
} // namespace itk

#endif

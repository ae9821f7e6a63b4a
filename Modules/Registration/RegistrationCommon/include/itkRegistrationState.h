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
#ifndef itkRegistrationState_h
#define itkRegistrationState_h

#include "RegistrationCommonExport.h"

#include "itkOptimizerParameters.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace itk
{
/** \class RegistrationState
 * \brief What a registration estimates: named blocks of parameters, of which some are free and the others held.
 *
 * A pose of a body, the scale of a view, the pose of one view relative to another: each is a block. A metric declares
 * the blocks that it reads (LeastSquaresMetricv4::DeclareBlocks()); a sum of metrics owns the union, so that two terms
 * that name the same block are about the same unknowns. Adding a view or separating two jaws is another block and
 * nothing else.
 *
 * Values are in natural units (rad, mm, 1). What an optimizer moves are the free ones, each multiplied by its scale:
 * with scales in mm a unit (the lever arm of an angle) all of an optimizer's parameters are millimetres, and optimizers
 * that know no scales, as LBFGSB, are well conditioned all the same.
 *
 * Order: blocks as they were added, parameters as in the block.
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT RegistrationState
{
public:
  /** One unknown. */
  struct ParameterType
  {
    std::string name;         /**< Unique in its block. */
    double      value{ 0.0 }; /**< Natural unit. */
    /** Optimizer's units in one natural unit, positive. */
    double scale{ 1.0 };
    /** The longest step an optimizer should take, natural units; 0: any. */
    double maximumStep{ 0.0 };
    bool   isFree{ true };
  };
  /** Unknowns that belong together. */
  struct BlockType
  {
    std::string                name;       /**< Unique in the state. */
    std::vector<ParameterType> parameters; /**< In the order of the state's vector. */
  };
  using BlocksType = std::vector<BlockType>;
  using OptimizerParametersType = OptimizerParameters<double>;

  /** Appends a block. A block of that name and size stays as it is; one of another size is an error that names both. */
  void
  AddBlock(const BlockType & block);
  /** All blocks, in the order in which they were added; whether there is one of a name. */
  const BlocksType &
  GetBlocks() const
  {
    return m_Blocks;
  }
  bool
  HasBlock(const std::string & name) const;
  /** Throws an exception that lists the blocks there are. */
  const BlockType &
  GetBlock(const std::string & name) const;
  /** Place of a block's first parameter among all parameters. */
  std::size_t
  GetOffset(const std::string & name) const;

  /** Values of a block, in natural units. Throws where the number is not the block's. */
  std::vector<double>
  GetBlockValues(const std::string & name) const;
  void
  SetBlockValues(const std::string & name, const std::vector<double> & values);
  /** Which of a block's parameters an optimizer may move. */
  void
  SetBlockFree(const std::string & name, const std::vector<bool> & isFree);
  void
  SetBlockFree(const std::string & name, bool isFree);

  /** Values of all parameters, natural units. */
  const std::vector<double> &
  GetValues() const
  {
    return m_Values;
  }
  void
  SetValues(const std::vector<double> & values);
  /** Free parameters and those that are held. */
  std::size_t
  GetNumberOfParameters() const
  {
    return m_Values.size();
  }

  /** Places of the free parameters among all. */
  const std::vector<std::size_t> &
  GetFreeIndices() const
  {
    return m_FreeIndices;
  }
  std::size_t
  GetNumberOfFreeParameters() const
  {
    return m_FreeIndices.size();
  }

  /** The free parameters as an optimizer has them: value times scale. */
  OptimizerParametersType
  GetFreeParameters() const;
  void
  SetFreeParameters(const OptimizerParametersType & parameters);
  /** All values with the free ones replaced; the state stays. */
  std::vector<double>
  Expand(const OptimizerParametersType & parameters) const;

  /** Optimizer's units in one natural unit, of each free parameter. */
  double
  GetFreeScale(std::size_t freeIndex) const;
  /** Longest step of the free parameters in the optimizer's units; 0: any. */
  OptimizerParametersType
  GetMaximumSteps() const;
  /** Writes a line for each parameter. */
  void
  Print(std::ostream & os, const std::string & indent) const;

private:
  BlockType &
  FindBlock(const std::string & name);
  void
  Update();

  BlocksType               m_Blocks;
  std::vector<double>      m_Values;
  std::vector<double>      m_Scales;
  std::vector<std::size_t> m_FreeIndices;
};
} // namespace itk

#endif

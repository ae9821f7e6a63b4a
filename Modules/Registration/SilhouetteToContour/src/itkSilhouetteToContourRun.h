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
#ifndef itkSilhouetteToContourRun_h
#define itkSilhouetteToContourRun_h

#include "itkOptimizerAdapter.h"
#include "itkSilhouetteToContourRegistrationMethod.h"

#include <memory>
#include <string>
#include <vector>

// What a registration does while it runs, apart from what it is told and what it answers: the method's own file has
// those. Private to this module.
namespace itk
{
/** \class SilhouetteToContourRegistrationMethod::RunType
 * \brief One run of GenerateData(): level by level, candidates first, then the optimizer from the best of them.
 *
 * Metric and optimizer are as they were when it goes.
 */
class SilhouetteToContourRegistrationMethod::RunType
{
public:
  explicit RunType(Self * method);
  ~RunType();
  RunType(const RunType &) = delete;
  RunType &
  operator=(const RunType &) = delete;

  /** Runs a level from the similarity and returns where it ends. */
  ContourSimilarity
  RunLevel(unsigned int index, const ContourSimilarity & initial);

private:
  void
  SetBounds();

  /** The best candidates of the level's grid that are no neighbours of each other, best first. */
  std::vector<ParametersType>
  FindStarts(std::size_t & numberOfCandidates);

  /** Returns the stop condition. */
  std::string
  RunOptimizer(const ParametersType & start);

  void
  OnEvent(const EventObject & event);

  void
  ReportProgress(double fractionOfLevel);

  Self *                            m_Method;
  MetricType::Pointer               m_Metric;
  OptimizerType::Pointer            m_Optimizer;
  std::unique_ptr<OptimizerAdapter> m_Adapter;
  SizeValueType                     m_NumberOfIterations;
  unsigned long                     m_ObserverTag{ 0 };
  const LevelType *                 m_Level{ nullptr };
  ParametersType                    m_Lower;
  ParametersType                    m_Upper;
  double                            m_StartFraction{ 0.0 };
  double                            m_StartShare{ 0.0 };
  std::size_t                       m_IterationsOfStart{ 0 };
  ParametersType                    m_LastPosition;
};
} // namespace itk

#endif

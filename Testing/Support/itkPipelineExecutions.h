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
#ifndef itkPipelineExecutions_h
#define itkPipelineExecutions_h

#include "itkCommand.h"
#include "itkProcessObject.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace itk
{
/** \class PipelineExecutions
 * \brief Counts how often every process object of a pipeline executes, by the StartEvents that each sends.
 *
 * It finds the objects by itself: the ones that are given and all that lies upstream of them. An object goes by its
 * object name, or by the name of its class where it has none.
 */
class PipelineExecutions
{
public:
  using NamesType = std::vector<std::string>;

  explicit PipelineExecutions(const std::vector<ProcessObject *> & last)
  {
    for (ProcessObject * process : last)
    {
      this->Add(process);
    }
  }

  ~PipelineExecutions()
  {
    for (const auto & entry : m_Tags)
    {
      entry.first->RemoveObserver(entry.second);
    }
  }
  PipelineExecutions(const PipelineExecutions &) = delete;
  PipelineExecutions &
  operator=(const PipelineExecutions &) = delete;

  /** Every object of the pipeline, in alphabetical order. */
  NamesType
  GetNames() const
  {
    return NamesType(m_Names.begin(), m_Names.end());
  }

  /** Does something and returns what executed meanwhile, in alphabetical order: "name" once, "name x16" 16 times. */
  template <typename TAction>
  NamesType
  During(TAction && action)
  {
    m_Counts.clear();
    action();
    NamesType executed;
    for (const auto & entry : m_Counts)
    {
      executed.push_back(entry.second == 1 ? entry.first : entry.first + " x" + std::to_string(entry.second));
    }
    return executed;
  }

private:
  void
  Add(ProcessObject * process)
  {
    if (m_Tags.count(process) > 0)
    {
      return;
    }
    std::string name = process->GetObjectName();
    if (name.empty())
    {
      name = process->GetNameOfClass();
    }
    if (!m_Names.insert(name).second)
    {
      itkGenericExceptionMacro("Two objects are called " << name << "; call SetObjectName().");
    }
    m_Tags[process] = process->AddObserver(StartEvent(), [this, name](const EventObject &) { ++m_Counts[name]; });
    for (const DataObject::Pointer & input : process->GetInputs())
    {
      if (input.IsNotNull() && input->GetSource() != nullptr)
      {
        this->Add(input->GetSource());
      }
    }
  }

  // Held, so that an observer never outlives the counter that it counts for.
  std::map<ProcessObject::Pointer, unsigned long> m_Tags;
  std::set<std::string>                           m_Names;
  std::map<std::string, unsigned int>             m_Counts;
};
} // namespace itk

#endif

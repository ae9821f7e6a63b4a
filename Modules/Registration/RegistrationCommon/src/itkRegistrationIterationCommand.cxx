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
#include "itkRegistrationIterationCommand.h"

#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkRegistrationIterationInformation.h"

#include "itkObjectToObjectOptimizerBase.h"

#include <algorithm>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <typeinfo>

namespace itk
{
unsigned long
RegistrationIterationCommand::Observe(Object * caller)
{
  if (caller == nullptr)
  {
    itkExceptionMacro("There is nothing to observe: give Observe() a registration method or an optimizer.");
  }
  if (dynamic_cast<const RegistrationIterationInformation *>(caller) == nullptr &&
      dynamic_cast<const ObjectToObjectOptimizerBaseTemplate<double> *>(caller) == nullptr)
  {
    itkExceptionMacro(<< caller->GetNameOfClass()
                      << " tells nothing of iterations: give Observe() a registration method, as "
                         "PoseRegistrationMethod, a CaseRegistration or a v4 optimizer. A class of one's own derives "
                         "from RegistrationIterationInformation.");
  }
  return caller->AddObserver(AnyEvent(), this);
}

void
RegistrationIterationCommand::SetStream(std::ostream * stream)
{
  m_Stream = stream;
}

void
RegistrationIterationCommand::SetWriteEvery(unsigned int iterations)
{
  if (iterations == 0)
  {
    itkExceptionMacro("Writing every 0th iteration makes no sense; give 1 or more.");
  }
  m_WriteEvery = iterations;
}

void
RegistrationIterationCommand::Execute(Object * caller, const EventObject & event)
{
  this->Execute(const_cast<const Object *>(caller), event);
}

void
RegistrationIterationCommand::Execute(const Object * caller, const EventObject & event)
{
  // The exact types: optimizers report mere evaluations by subclasses of IterationEvent.
  RecordType record;
  if (typeid(event) == typeid(StartEvent))
  {
    m_Records.clear();
    record.kind = KindEnum::Start;
  }
  else if (typeid(event) == typeid(MultiResolutionIterationEvent))
  {
    record.kind = KindEnum::Level;
  }
  else if (typeid(event) == typeid(IterationEvent))
  {
    record.kind = KindEnum::Iteration;
  }
  else if (typeid(event) == typeid(AbortEvent))
  {
    record.kind = KindEnum::Abort;
  }
  else if (typeid(event) == typeid(EndEvent))
  {
    record.kind = KindEnum::End;
  }
  else
  {
    return;
  }
  if (const auto * method = dynamic_cast<const RegistrationIterationInformation *>(caller))
  {
    if (record.kind != KindEnum::Start)
    {
      record.level = method->GetCurrentLevel();
      record.iteration = method->GetOptimizerIteration();
      record.value = method->GetMetricValue();
      record.parameters = method->GetOptimizerPosition();
      if (record.kind == KindEnum::Iteration)
      {
        record.candidate = method->GetCurrentCandidate();
        record.stepLength = method->GetStepLength();
        record.accepted = method->GetStepAccepted();
      }
      else
      {
        record.stopReason = method->GetOptimizerStopConditionDescription();
      }
    }
  }
  else if (const auto * optimizer = dynamic_cast<const ObjectToObjectOptimizerBaseTemplate<double> *>(caller))
  {
    if (record.kind != KindEnum::Start)
    {
      record.iteration = optimizer->GetCurrentIteration();
      record.value = optimizer->GetValue();
      record.parameters = optimizer->GetCurrentPosition();
      const auto * leastSquares = dynamic_cast<const LevenbergMarquardtOptimizerv4 *>(optimizer);
      if (record.kind == KindEnum::Iteration && leastSquares != nullptr)
      {
        record.stepLength = leastSquares->GetStepLength();
        record.accepted = leastSquares->GetStepAccepted();
      }
      if (record.kind != KindEnum::Iteration)
      {
        record.stopReason = optimizer->GetStopConditionDescription();
      }
    }
  }
  else
  {
    return;
  }
  m_Records.push_back(record);
  this->Write(record);
}

void
RegistrationIterationCommand::Write(const RecordType & record)
{
  if (m_Stream == nullptr ||
      (record.kind == KindEnum::Iteration && m_WriteEvery > 1 && record.iteration % m_WriteEvery != 0))
  {
    return;
  }
  std::ostringstream line;
  line.precision(9);
  switch (record.kind)
  {
    case KindEnum::Start:
      line << "start";
      break;
    case KindEnum::Level:
      line << "level " << record.level;
      break;
    case KindEnum::Iteration:
      line << "level " << record.level;
      if (record.candidate > 0)
      {
        line << " candidate " << record.candidate;
      }
      line << " iteration " << record.iteration;
      if (!record.accepted)
      {
        line << " refused a step of " << record.stepLength;
      }
      break;
    case KindEnum::Abort:
      line << "abort level " << record.level << " iteration " << record.iteration;
      break;
    case KindEnum::End:
      line << "end level " << record.level << " iteration " << record.iteration;
      break;
  }
  if (record.kind != KindEnum::Start)
  {
    line << " value " << record.value << " parameters";
    for (const double parameter : record.parameters)
    {
      line << ' ' << parameter;
    }
  }
  if (!record.stopReason.empty())
  {
    line << " (" << record.stopReason << ')';
  }
  *m_Stream << line.str() << '\n';
}

void
RegistrationIterationCommand::WriteTable(std::ostream & stream) const
{
  std::size_t numberOfParameters = 0;
  for (const RecordType & record : m_Records)
  {
    numberOfParameters = std::max<std::size_t>(numberOfParameters, record.parameters.GetSize());
  }
  std::ostringstream table;
  table.imbue(std::locale::classic());
  table.precision(std::numeric_limits<double>::max_digits10);
  table << "level,candidate,iteration,value,step_length,accepted";
  for (std::size_t i = 0; i < numberOfParameters; ++i)
  {
    table << ",p" << i;
  }
  table << '\n';
  for (const RecordType & record : m_Records)
  {
    if (record.kind != KindEnum::Iteration)
    {
      continue;
    }
    table << record.level << ',' << record.candidate << ',' << record.iteration << ',' << record.value << ','
          << record.stepLength << ',' << (record.accepted ? 1 : 0);
    for (const double parameter : record.parameters)
    {
      table << ',' << parameter;
    }
    table << '\n';
  }
  stream << table.str();
}
} // namespace itk

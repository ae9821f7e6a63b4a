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
#ifndef itkRegistrationIterationCommand_h
#define itkRegistrationIterationCommand_h

#include "RegistrationCommonExport.h"

#include "itkCommand.h"
#include "itkOptimizerParameters.h"

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace itk
{
/** \class RegistrationIterationCommand
 * \brief Ready observer of a registration: level, candidate, iteration, value, step, parameters, stop reason.
 *
 * \code
 * auto observer = itk::RegistrationIterationCommand::New();
 * observer->SetStream(&std::cout);       // or none: records only
 * observer->Observe(method);
 * method->Update();
 * for (const auto & record : observer->GetRecords()) ...
 * observer->WriteTable(file);            // or all iterations as CSV
 * \endcode
 *
 * Observes a RegistrationIterationInformation (every registration method here, and CaseRegistration, which tells the
 * iterations of the method that it runs and as levels its stages) or a bare v4 optimizer. Optimizers send
 * subclasses of IterationEvent for mere evaluations; only the exact IterationEvent counts as an iteration, and a
 * MultiResolutionIterationEvent as the start of a level. Records are cleared at each StartEvent, so that an observer
 * serves many runs. Nothing is printed unless a stream is given.
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT RegistrationIterationCommand : public Command
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(RegistrationIterationCommand);

  using Self = RegistrationIterationCommand;
  using Superclass = Command;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(RegistrationIterationCommand, Command);
  /** What happened: a run or a level began, an iteration went by, the run was stopped or came to its end. */
  enum class KindEnum : std::uint8_t
  {
    Start,
    Level,
    Iteration,
    Abort,
    End
  };
  /** One event. */
  struct RecordType
  {
    KindEnum                    kind{ KindEnum::Start }; /**< What happened. */
    unsigned int                level{ 0 };              /**< Level of the run, from 0. */
    unsigned int                candidate{ 0 };          /**< Start among several, from 0. */
    std::size_t                 iteration{ 0 };          /**< Iteration of the level, from 0. */
    double                      value{ 0.0 };            /**< Of the metric, in its unit. */
    OptimizerParameters<double> parameters;              /**< Of the optimizer, in its units. */
    /** Of iterations. A step that was tried and not taken is a record of its own where the observed object reports it;
     * value and parameters are then those of the best position as before. */
    double stepLength{ 0.0 };
    bool   accepted{ true };
    /** Set at a level's start (of the level before), at the end and at an abort. */
    std::string stopReason;
  };

  /** Adds itself to the object for all the events it understands; returns the observer's tag. Throws for an object that
   * tells nothing of iterations, of which there would be no record. */
  unsigned long
  Observe(Object * caller);

  /** A stream of the caller's to write one line an event to; nullptr (default) writes nothing. The caller keeps it
   * alive.
   */
  void
  SetStream(std::ostream * stream);

  /** Writes every n-th iteration (default 1); records all. */
  void
  SetWriteEvery(unsigned int iterations);
  unsigned int
  GetWriteEvery() const
  {
    return m_WriteEvery;
  }
  /** All events since the last start. */
  const std::vector<RecordType> &
  GetRecords() const
  {
    return m_Records;
  }

  /** All iterations as comma-separated values, with a line of names: level, candidate, iteration, value, step_length,
   * accepted (1 or 0), p0, p1 ... the parameters. */
  void
  WriteTable(std::ostream & stream) const;
  /** Called by the observed object. */
  void
  Execute(Object * caller, const EventObject & event) override;
  void
  Execute(const Object * caller, const EventObject & event) override;

protected:
  RegistrationIterationCommand() = default;
  ~RegistrationIterationCommand() override = default;

private:
  void
  Write(const RecordType & record);

  std::ostream *          m_Stream{ nullptr };
  unsigned int            m_WriteEvery{ 1 };
  std::vector<RecordType> m_Records;
};
} // namespace itk

#endif

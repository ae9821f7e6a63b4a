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
#include "dentalscrBinding.h"

#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>
#include <thread>

#include "itkCommand.h"
#include "itkMultiThreaderBase.h"

namespace dentalscr
{
namespace
{
/** A run of a process object that Python started: keeps the first Python exception of its commands and ends the run. */
class RunContext
{
public:
  explicit RunContext(itk::ProcessObject * process)
    : m_Process(process)
  {
    {
      const std::lock_guard<std::mutex> lock(Mutex());
      if (!Runs().emplace(process, this).second)
      {
        throw std::runtime_error(std::string(process->GetNameOfClass()) +
                                 " is running already; use one object a thread");
      }
    }
    const auto watch = [this](const itk::EventObject &) { this->Watch(); };
    m_Tags[0] = process->AddObserver(itk::ProgressEvent(), watch);
    m_Tags[1] = process->AddObserver(itk::IterationEvent(), watch);
  }

  ~RunContext()
  {
    for (const unsigned long tag : m_Tags)
    {
      m_Process->RemoveObserver(tag);
    }
    const std::lock_guard<std::mutex> lock(Mutex());
    Runs().erase(m_Process);
  }

  RunContext(const RunContext &) = delete;
  RunContext &
  operator=(const RunContext &) = delete;

  /** Null where the process is not run from Python. */
  static RunContext *
  Find(const itk::Object * process)
  {
    const std::lock_guard<std::mutex> lock(Mutex());
    const auto                        found = Runs().find(process);
    return found == Runs().end() ? nullptr : found->second;
  }

  /** Called with the interpreter taken. */
  void
  Fail(py::error_already_set && error)
  {
    if (!m_Failed)
    {
      m_Error.emplace(std::move(error));
      m_Failed = true;
    }
    m_Process->AbortGenerateDataOn();
  }

  /** Called with the interpreter taken: throws what a command threw. */
  void
  Rethrow()
  {
    if (m_Failed)
    {
      throw *m_Error;
    }
  }

private:
  static std::mutex &
  Mutex()
  {
    static std::mutex mutex;
    return mutex;
  }

  static std::map<const itk::Object *, RunContext *> &
  Runs()
  {
    static std::map<const itk::Object *, RunContext *> runs;
    return runs;
  }

  /** At each event: the abort flag again, which a start clears, and Ctrl-C, for which the interpreter is taken at most
   * twenty times a second. */
  void
  Watch()
  {
    if (m_Failed)
    {
      m_Process->AbortGenerateDataOn();
      return;
    }
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    const auto wait = std::chrono::steady_clock::duration(std::chrono::milliseconds(50)).count();
    if (now - m_LastLook < wait)
    {
      return;
    }
    m_LastLook = now;
    const py::gil_scoped_acquire interpreter;
    if (PyErr_CheckSignals() != 0)
    {
      this->Fail(py::error_already_set());
    }
  }

  itk::ProcessObject *                                  m_Process;
  unsigned long                                         m_Tags[2]{ 0, 0 };
  std::atomic<bool>                                     m_Failed{ false };
  std::optional<py::error_already_set>                  m_Error;
  std::atomic<std::chrono::steady_clock::duration::rep> m_LastLook{ 0 };
};

/** Calls _InvokeCommand(key) of a Python process object, which it does not keep alive: the callables are the object's,
 * so that a callable that refers to the object makes a cycle which Python can collect. */
class PythonCommand : public itk::Command
{
public:
  using Self = PythonCommand;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);

  void
  Execute(itk::Object * caller, const itk::EventObject & event) override
  {
    this->Execute(const_cast<const itk::Object *>(caller), event);
  }

  void
  Execute(const itk::Object * caller, const itk::EventObject &) override
  {
    if (!Py_IsInitialized())
    {
      return;
    }
    const py::gil_scoped_acquire interpreter;
    const py::object             owner = (*m_Owner)();
    if (owner.is_none())
    {
      return;
    }
    try
    {
      owner.attr("_InvokeCommand")(m_Key);
    }
    catch (py::error_already_set & error)
    {
      RunContext * run = RunContext::Find(caller);
      if (run == nullptr)
      {
        throw;
      }
      run->Fail(std::move(error));
    }
  }

  void
  SetOwner(const py::object & owner, unsigned long key)
  {
    m_Owner.emplace(owner);
    m_Key = key;
  }

protected:
  PythonCommand() = default;
  ~PythonCommand() override
  {
    if (!m_Owner)
    {
      return;
    }
    if (Py_IsInitialized())
    {
      const py::gil_scoped_acquire interpreter;
      m_Owner.reset();
    }
    else
    {
      m_Owner->release();
    }
  }

private:
  std::optional<py::weakref> m_Owner;
  unsigned long              m_Key{ 0 };
};

/** The numbers are SimpleITK's. */
const itk::EventObject &
FindEvent(int number)
{
  static const itk::AnyEvent                      any;
  static const itk::AbortEvent                    abort;
  static const itk::DeleteEvent                   deletion;
  static const itk::EndEvent                      end;
  static const itk::IterationEvent                iteration;
  static const itk::ProgressEvent                 progress;
  static const itk::StartEvent                    start;
  static const itk::UserEvent                     user;
  static const itk::MultiResolutionIterationEvent level;
  switch (number)
  {
    case 0:
      return any;
    case 1:
      return abort;
    case 2:
      return deletion;
    case 3:
      return end;
    case 4:
      return iteration;
    case 5:
      return progress;
    case 6:
      return start;
    case 7:
      return user;
    case 9:
      return level;
    default:
      throw std::invalid_argument("there is no event " + std::to_string(number) + "; use the constants sitk...Event");
  }
}
} // namespace

unsigned long
AddPythonCommand(itk::Object & object, const py::object & owner, int event, unsigned long key)
{
  const auto command = PythonCommand::New();
  command->SetOwner(owner, key);
  return object.AddObserver(FindEvent(event), command);
}

void
Run(itk::ProcessObject * process, const std::function<void()> & body)
{
  // Whoever holds the last reference, the object outlives its run.
  const itk::SmartPointer<itk::ProcessObject> keep = process;
  RunContext                                  run(process);
  try
  {
    const py::gil_scoped_release released;
    body();
  }
  catch (...)
  {
    process->ResetPipeline();
    run.Rethrow();
    throw;
  }
  run.Rethrow();
}

void
WrapProcessObject(py::module_ & module)
{
  using itk::MultiThreaderBase;
  using itk::ProcessObject;
  py::class_<ProcessObject, itk::SmartPointer<ProcessObject>>(module, "ProcessObject", "What every filter has.")
    .def(
      "GetName",
      [](const ProcessObject & self) { return std::string(self.GetNameOfClass()); },
      "Name of the class in C++.")
    .def("GetProgress", &ProcessObject::GetProgress, "Share that is done, 0 to 1.")
    .def(
      "Abort",
      [](ProcessObject & self) { self.AbortGenerateDataOn(); },
      "Ends the run that is under way: Execute raises AbortedError.")
    .def("SetNumberOfWorkUnits",
         &ProcessObject::SetNumberOfWorkUnits,
         py::arg("numberOfWorkUnits"),
         "Sets the number of parts that the work is split in; the result does not depend on it.")
    .def("GetNumberOfWorkUnits", &ProcessObject::GetNumberOfWorkUnits, "The number of parts that the work is split in.")
    .def("__str__",
         [](const ProcessObject & self) {
           std::ostringstream text;
           self.Print(text);
           return text.str();
         })
    .def("__repr__",
         [](const ProcessObject & self) { return "<dentalscr." + std::string(self.GetNameOfClass()) + ">"; })
    .def_static(
      "SetGlobalDefaultNumberOfThreads",
      [](unsigned int threads) {
        if (threads == 0)
        {
          threads = std::thread::hardware_concurrency();
        }
        MultiThreaderBase::SetGlobalMaximumNumberOfThreads(threads);
        MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
      },
      py::arg("threads"),
      "Threads of every object made from now on; 0: all of the machine's. No result depends on it.")
    .def_static(
      "GetGlobalDefaultNumberOfThreads",
      []() { return static_cast<unsigned int>(MultiThreaderBase::GetGlobalDefaultNumberOfThreads()); },
      "The number of threads of every process object that is made from now on.")
    .def(
      "_AddCommand",
      [](py::object self, int event, unsigned long key) {
        return AddPythonCommand(self.cast<ProcessObject &>(), self, event, key);
      },
      py::arg("event"),
      py::arg("key"))
    .def(
      "_RemoveCommand", [](ProcessObject & self, unsigned long tag) { self.RemoveObserver(tag); }, py::arg("tag"))
    .def("_Update", [](ProcessObject & self) {
      // Execute() always executes, also where nothing has changed: commands wait for its events.
      self.Modified();
      Run(&self);
    });
}
} // namespace dentalscr

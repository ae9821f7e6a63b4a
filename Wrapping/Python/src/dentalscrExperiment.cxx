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

#include "itkCohortExperiment.h"
#include "itkExperimentMethod.h"

namespace dentalscr
{
void
WrapExperiment(py::module_ & module)
{
  using ExperimentType = itk::CohortExperiment;
  using StudyEnum = ExperimentType::StudyEnum;
  BindEnum<StudyEnum>(module,
                      "ExperimentStudy",
                      { { "Tables", StudyEnum::Tables },
                        { "Capture", StudyEnum::Capture },
                        { "Sensitivity", StudyEnum::Sensitivity },
                        { "Ablation", StudyEnum::Ablation },
                        { "Coverage", StudyEnum::Coverage },
                        { "Verdict", StudyEnum::Verdict },
                        { "Practice", StudyEnum::Practice } },
                      "What an experiment asks.");
  ProcessClass<ExperimentType>(module, "CohortExperiment", "Methods on a cohort: tables, statistics, plot data.")
    .def(New<ExperimentType>())
    .dentalscrProperty(ExperimentType, NumberOfCases)
    .dentalscrProperty(ExperimentType, Seed)
    .def("SetLevel", &ExperimentType::SetLevel, py::arg("level"))
    .def("GetLevel", &ExperimentType::GetLevel)
    .def(
      "SetCaseDirectory",
      [](ExperimentType & self, const std::string & folder) { self.SetCaseDirectory(folder); },
      py::arg("folder"))
    .def("GetCaseDirectory", [](const ExperimentType & self) { return std::string(self.GetCaseDirectory()); })
    .def(
      "SetOutputDirectory",
      [](ExperimentType & self, const std::string & folder) { self.SetOutputDirectory(folder); },
      py::arg("folder"))
    .def("GetOutputDirectory", [](const ExperimentType & self) { return std::string(self.GetOutputDirectory()); })
    .def("SetStudy", &ExperimentType::SetStudy, py::arg("study"))
    .def("GetStudy", &ExperimentType::GetStudy)
    .dentalscrProperty(ExperimentType, NumberOfStarts)
    .def("SetMethods", &ExperimentType::SetMethods, py::arg("names"))
    .def("GetMethods", &ExperimentType::GetMethods)
    .dentalscrBoolean(ExperimentType, DrawFigures)
    .def("GetCurrentStage", [](const ExperimentType & self) { return self.GetCurrentStage(); })
    .def("GetWrittenFiles", &ExperimentType::GetWrittenFiles, "Names in the output folder, after Execute().")
    .def("GetNumberOfResumedCases", &ExperimentType::GetNumberOfResumedCases);
  module.def(
    "experiment_methods",
    []() {
      std::vector<std::pair<std::string, std::string>> methods;
      for (const auto & method : itk::GetExperimentMethods())
      {
        methods.emplace_back(method.name, method.title);
      }
      return methods;
    },
    "Name and title of every method that an experiment compares.");
}
} // namespace dentalscr

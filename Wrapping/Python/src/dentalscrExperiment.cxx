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
    .dentalscrProperty(ExperimentType, NumberOfCases, "the number of simulated cases; 34 by default, the paper's.")
    .dentalscrProperty(ExperimentType, Seed, "the seed of the first case and of the statistics; 1 by default.")
    .def("SetLevel",
         &ExperimentType::SetLevel,
         py::arg("level"),
         "Sets the level of difficulty of the simulated cases; Typical by default. Some studies have "
         "levels of their own.")
    .def("GetLevel",
         &ExperimentType::GetLevel,
         "Returns the level of difficulty of the simulated cases; Typical by default. Some studies "
         "have levels of their own.")
    .def(
      "SetCaseDirectory",
      [](ExperimentType & self, const std::string & folder) { self.SetCaseDirectory(folder); },
      py::arg("folder"),
      "Sets the folder whose cases are used instead of simulated ones, by the studies Tables and "
      "Capture.")
    .def(
      "GetCaseDirectory",
      [](const ExperimentType & self) { return std::string(self.GetCaseDirectory()); },
      "Returns the folder whose cases are used instead of simulated ones, by the studies Tables "
      "and Capture.")
    .def(
      "SetOutputDirectory",
      [](ExperimentType & self, const std::string & folder) { self.SetOutputDirectory(folder); },
      py::arg("folder"),
      "Sets the folder that everything is written to. It is made where it is missing, and an "
      "experiment that was stopped goes on from it.")
    .def(
      "GetOutputDirectory",
      [](const ExperimentType & self) { return std::string(self.GetOutputDirectory()); },
      "Returns the folder that everything is written to. It is made where it is missing, and an "
      "experiment that was stopped goes on from it.")
    .def("SetStudy", &ExperimentType::SetStudy, py::arg("study"), "Sets the study that is run; Tables by default.")
    .def("GetStudy", &ExperimentType::GetStudy, "Returns the study that is run; Tables by default.")
    .dentalscrProperty(ExperimentType,
                       NumberOfStarts,
                       "the number of starts a case and jaw in the study of the capture range; 100 by default.")
    .def("SetMethods",
         &ExperimentType::SetMethods,
         py::arg("names"),
         "Sets the names of methods and of groups of them that are compared; see experiment_methods().")
    .def("GetMethods",
         &ExperimentType::GetMethods,
         "Returns the names of methods and of groups of them that are compared; see "
         "experiment_methods().")
    .dentalscrBoolean(
      ExperimentType, DrawFigures, "whether the study Tables draws the figure of representative cases. On by default.")
    .def(
      "GetCurrentStage",
      [](const ExperimentType & self) { return self.GetCurrentStage(); },
      "How far it is, in words: \"12 of 34 cases\".")
    .def("GetWrittenFiles", &ExperimentType::GetWrittenFiles, "Names in the output folder, after Execute().")
    .def("GetNumberOfResumedCases",
         &ExperimentType::GetNumberOfResumedCases,
         "How many cases were in the output folder before, valid after Execute().");
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

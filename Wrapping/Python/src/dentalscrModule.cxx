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

#include "dentalscrCommands.h"
#include "dentalscrRegisterImageFormats.h"

#include "itkDentalSCRVersion.h"
#include "itkOpenMeshMeshIOFactory.h"
#include "itkTxtTransformIOFactory.h"
#include "itkVersion.h"

PYBIND11_MODULE(_core, module)
{
  using namespace dentalscr;
#if PYBIND11_VERSION_HEX < 0x020C0000
  // numpy 2 moved a field that older pybind11 reads: arrays would be wrong without an error.
  const auto numpyVersion = py::module_::import("numpy").attr("__version__").cast<std::string>();
  if (std::stoi(numpyVersion) >= 2)
  {
    throw py::import_error("this dentalscr was built with pybind11 " PYBIND11_TOSTRING(PYBIND11_VERSION_MAJOR) "." //
                           PYBIND11_TOSTRING(PYBIND11_VERSION_MINOR) ", which numpy " +
                           numpyVersion +
                           " does not support; use numpy < 2, or `pip install .`, which takes a newer one");
  }
#endif
  module.doc() = "The compiled part of dentalscr.";
  itk::RegisterOpenMeshMeshIOFactories();
  itk::TxtTransformIOFactory::RegisterOneFactory();
  RegisterImageFormats();

  module.attr("__version__") = itk::DentalSCRVersion;
  module.attr("ITK_VERSION") = itk::Version::GetITKVersion();
  module.def(
    "_Main",
    [](const std::vector<std::string> & arguments) {
      std::vector<const char *> words;
      for (const std::string & argument : arguments)
      {
        words.push_back(argument.c_str());
      }
      words.push_back(nullptr);
      return Main(static_cast<int>(arguments.size()), words.data());
    },
    py::arg("arguments"),
    py::call_guard<py::gil_scoped_release>());

  WrapErrors(module);
  WrapData(module);
  WrapTransforms(module);
  WrapGeometry(module);
  WrapPoseTransform(module);
  WrapProcessObject(module);
  WrapInputOutput(module);
  WrapFilters(module);
  WrapRegistration(module);
  WrapPoseMetrics(module);
  WrapPoseRegistration(module);
  WrapEvaluation(module);
  WrapPhantom(module);
  WrapExperiment(module);
  WrapCase(module);
}

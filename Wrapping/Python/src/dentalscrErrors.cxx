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

#include "itkDentalInputError.h"
#include "itkDescribePlainly.h"

#include <filesystem>

namespace dentalscr
{
namespace
{
/** Raises a class of dentalscr._errors with members beside its message. */
void
Raise(const char *                                              className,
      const std::string &                                       message,
      const std::vector<std::pair<const char *, std::string>> & members)
{
  const py::object type = py::module_::import("dentalscr._errors").attr(className);
  const py::object error = type(message);
  for (const auto & member : members)
  {
    error.attr(member.first) = member.second;
  }
  PyErr_SetObject(type.ptr(), error.ptr());
}
} // namespace

void
WrapErrors(py::module_ & module)
{
  (void)module;
  py::register_exception_translator([](std::exception_ptr pointer) {
    try
    {
      std::rethrow_exception(pointer);
    }
    catch (const itk::DentalInputError & error)
    {
      // Python's own name of it as well: who looks for a file that may be absent looks for that. A file is missing that
      // was named in the call, or in a case file.
      std::error_code code;
      const bool      isMissing = (error.GetField().empty() && !error.GetInputFile().empty() &&
                              !std::filesystem::exists(error.GetInputFile(), code) && !code) ||
                             error.GetProblem().rfind("there is no file ", 0) == 0;
      Raise(isMissing ? "MissingFileError" : "InputError",
            error.GetOneLine(),
            { { "file", error.GetInputFile() },
              { "field", error.GetField() },
              { "problem", error.GetProblem() },
              { "remedy", error.GetRemedy() } });
    }
    catch (const itk::ProcessAborted & error)
    {
      Raise("AbortedError", itk::DescribePlainly(error), { { "location", error.GetLocation() } });
    }
    catch (const itk::ExceptionObject & error)
    {
      Raise("FilterError", itk::DescribePlainly(error), { { "location", error.GetLocation() } });
    }
    catch (const std::invalid_argument & error)
    {
      Raise("ArgumentError", error.what(), {});
    }
  });
}
} // namespace dentalscr

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
#include "itkRequireJsonName.h"

#include "itkDentalInputError.h"
#include "itkLowerCase.h"

#include <filesystem>

namespace itk
{
void
RequireJsonName(const std::string & fileName, const std::string & what)
{
  const std::filesystem::path path = fileName;
  const std::string           extension = LowerCase(path.extension().string());
  const std::string           before = LowerCase(path.stem().extension().string());
  // A name without an extension is that of a device or of one's own choice. Markups of 3D Slicer end in .mrk.json.
  if ((extension.empty() || extension == ".json") && before != ".mrk")
  {
    return;
  }
  itkDentalInputErrorMacro(fileName,
                           "",
                           what + " are written as JSON, and the name is that of another format",
                           "name a file that ends in .json");
}
} // namespace itk

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
#ifndef itkCaseFileFields_h
#define itkCaseFileFields_h

#include "itkCephalometricLandmarkSet.h"
#include "itkJsonDocument.h"
#include "itkToothCode.h"

#include <array>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace itk
{
/** Not installed. The fields that a case and each of its views have. */

/** The member as a path beside the case file; "" where absent. Throws where there is no such file. */
std::string
FindFile(const JsonNode & root, const std::string & key, const std::filesystem::path & directory);

/** Turns the words' std::invalid_argument into an error at the node. */
template <typename TFunction>
auto
Interpret(const JsonNode & node, TFunction && function)
{
  const std::string & text = node.AsString();
  try
  {
    return function(text);
  }
  catch (const std::invalid_argument & error)
  {
    node.Fail(error.what(), "correct the field");
  }
}

/** A distance of an X-ray machine, mm; the limits only catch slips of unit or digit. */
double
MachineDistance(const JsonNode & node);

/** "right" or "left". */
bool
IsLeft(const JsonNode & node);

std::optional<std::array<unsigned int, 2>>
ReadImageSize(const JsonNode & node);
std::optional<std::array<double, 2>>
ReadPixelSpacing(const JsonNode & node);
std::optional<std::array<double, 2>>
ReadPrincipalPoint(const JsonNode & node);
/** "markups_spacing_mm". */
std::optional<std::array<double, 2>>
ReadMarkupsSpacing(const JsonNode & node);

/** A file's name, or the landmarks themselves. */
struct CaseLandmarkField
{
  std::string                            fileName;
  CephalometricLandmarkSet::ConstPointer landmarks;
  std::vector<std::string>               warnings;
};
CaseLandmarkField
ReadCephalometricLandmarks(const JsonNode &                                root,
                           const std::filesystem::path &                   directory,
                           const std::optional<ToothCode::NumberingEnum> & numbering);
} // namespace itk

#endif

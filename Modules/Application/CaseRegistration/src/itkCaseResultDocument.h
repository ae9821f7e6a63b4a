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
#ifndef itkCaseResultDocument_h
#define itkCaseResultDocument_h

#include "itkCephalometricGeometry.h"
#include "itkJsonDocument.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace itk
{
/** Not installed. A result.json that was opened: what every reader of one needs. What is wrong in it is a
 * DentalInputError that names the field. */
class CaseResultDocument
{
public:
  static constexpr char Schema[] = "dentalscr-result/1";

  /** The file, or the folder that it lies in. */
  explicit CaseResultDocument(const std::string & name);
  /** A text that lies in no file, and is called by this name. */
  CaseResultDocument(const std::string & name, const std::string & text);

  const std::string &
  GetFileName() const
  {
    return m_FileName;
  }
  /** Where it lies. */
  const std::filesystem::path &
  GetFolder() const
  {
    return m_Folder;
  }
  const std::string &
  GetText() const
  {
    return m_Text;
  }
  const JsonNode &
  GetRoot() const
  {
    return *m_Root;
  }
  /** "geometry" and "jaws" of a further view, by its name; for "" and "lateral" the root, which has those of the first
   * radiograph. */
  JsonNode
  GetView(const std::string & name) const;

  /** mm in one unit of the scans' files. */
  double
  GetMillimetresPerUnit() const;

  /** Where a file lies that the result was made of, "upper" or "views.frontal.contours": seen from the case file, from
   * here, or from beside the result. "" where it says none, or none is there. */
  std::string
  FindInput(const std::string & field) const;
  /** As the result says it; "" where it says none. */
  std::string
  GetInputPath(const std::string & field) const;

  /** "geometry" of the result or of a view: complete, identity pose. */
  static CephalometricGeometry::Pointer
  ReadGeometry(const JsonNode & node);

  /** Rows of numbers; `form` says in the message what a row is. */
  template <std::size_t VRows, std::size_t VColumns>
  static std::array<double, VRows * VColumns>
  ReadMatrix(const JsonNode & node, const char * form)
  {
    std::array<double, VRows * VColumns> matrix{};
    if (node.GetSize() != VRows)
    {
      node.Fail("has " + std::to_string(node.GetSize()) + " rows, not " + std::to_string(VRows),
                "register the case again");
    }
    for (std::size_t row = 0; row < VRows; ++row)
    {
      const auto numbers = node.At(row).AsNumbers(VColumns, form);
      std::copy(numbers.begin(), numbers.end(), matrix.begin() + static_cast<std::ptrdiff_t>(VColumns * row));
    }
    return matrix;
  }

private:
  void
  Parse();

  std::string             m_FileName;
  std::filesystem::path   m_Folder;
  std::string             m_Text;
  std::optional<JsonNode> m_Root;
};
} // namespace itk

#endif

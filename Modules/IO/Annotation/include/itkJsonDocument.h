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
#ifndef itkJsonDocument_h
#define itkJsonDocument_h

#include "AnnotationExport.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
class JsonDocument;

/** \class JsonNode
 * \brief One value of a JsonDocument together with its path, so that a wrong one is reported by name.
 *
 * Every accessor checks: what is missing, of the wrong type or out of range throws a DentalInputError with the file and
 * a path such as `contours.upper[3].points[7]`. A node is a light handle; it keeps its document alive.
 *
 * \ingroup Annotation
 */
class Annotation_EXPORT JsonNode
{
public:
  enum class KindEnum : uint8_t
  {
    Null,
    Boolean,
    Number,
    String,
    Array,
    Object
  };
  /** What the value is. */
  KindEnum
  GetKind() const;
  bool
  IsObject() const
  {
    return this->GetKind() == KindEnum::Object;
  }
  bool
  IsArray() const
  {
    return this->GetKind() == KindEnum::Array;
  }
  bool
  IsString() const
  {
    return this->GetKind() == KindEnum::String;
  }
  bool
  IsNumber() const
  {
    return this->GetKind() == KindEnum::Number;
  }
  bool
  IsNull() const
  {
    return this->GetKind() == KindEnum::Null;
  }

  /** Path from the root, "" for the root itself. */
  const std::string &
  GetPath() const
  {
    return m_Path;
  }
  const std::string &
  GetFileName() const;

  /** \name Objects
   * @{ */
  /** The member, or nothing where it is absent. Throws where this is no object. */
  std::optional<JsonNode>
  Find(const std::string & key) const;
  /** Throws "missing" with the member's path. */
  JsonNode
  Get(const std::string & key) const;
  /** In the order of the file. */
  std::vector<std::pair<std::string, JsonNode>>
  GetMembers() const;
  /** Adds a warning to the document for every member that is not named, but for those whose names begin with "_": these
   * are a person's own notes. */
  void
  WarnAboutUnknownFields(std::initializer_list<const char *> known) const;
  /** @} */

  /** \name Arrays
   * @{ */
  std::size_t
  GetSize() const; /**< Number of elements; throws where the value is no array. */
  JsonNode
  At(std::size_t index) const; /**< Throws where there is no such element. */
  /** @} */

  /** \name Values
   * @{ */
  double
  AsNumber() const;
  /** A whole number within the limits. */
  int64_t
  AsInteger(int64_t minimum, int64_t maximum) const;
  bool
  AsBoolean() const;
  const std::string &
  AsString() const;
  /** An array of exactly so many numbers; `form` says in the message what they are, e.g. "[u, v]". */
  std::vector<double>
  AsNumbers(std::size_t count, const std::string & form) const;
  /** @} */

  /** Throws a DentalInputError at this node. */
  [[noreturn]] void
  Fail(const std::string & problem, const std::string & remedy) const;
  /** Adds a warning at this node to the document. */
  void
  Warn(const std::string & text) const;

private:
  friend class JsonDocument;
  struct Storage;
  struct Value;

  JsonNode(std::shared_ptr<Storage> storage, const Value * value, std::string path);

  std::string
  Describe() const;
  void
  Require(KindEnum kind, const char * expected) const;

  std::shared_ptr<Storage> m_Storage;
  const Value *            m_Value;
  std::string              m_Path;
};

/** \class JsonDocument
 * \brief A JSON file, read strictly: errors name the file and either line and column or the field.
 *
 * Throws DentalInputError for a missing, empty or over-long (32 MiB) file, a directory, a syntax error (line and
 * column), text that is not UTF-8, a member that is there twice, numbers that overflow, and nesting deeper than 64. A
 * UTF-8 byte order mark is accepted. The parser behind it is nlohmann's; no header of it is needed here.
 *
 * \ingroup Annotation
 */
class Annotation_EXPORT JsonDocument
{
public:
  static JsonDocument
  ReadFile(const std::string & fileName); /**< Throws where it is no JSON. */

  /** `fileName` is for the messages. */
  static JsonDocument
  Parse(const std::string & text, const std::string & fileName);

  /** Throws what Parse() throws. Comes before any other parser that interprets what others wrote: most of them follow
   * nested values by recursion, and a file of two million brackets ends the process. */
  static void
  Verify(const std::string & text, const std::string & fileName);
  /** The value that the document is. */
  JsonNode
  GetRoot() const;

  /** "file: field: what" of every Warn() so far. */
  const std::vector<std::string> &
  GetWarnings() const;

private:
  JsonDocument() = default;
  std::shared_ptr<JsonNode::Storage> m_Storage;
};
} // namespace itk

#endif

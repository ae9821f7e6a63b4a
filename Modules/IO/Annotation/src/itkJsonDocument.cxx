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
#include "itkJsonDocument.h"

#include "itkAppendWarning.h"
#include "itkDentalInputError.h"
#include "itkTextFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace itk
{
/** Small, because most values of a tracing are numbers. */
struct JsonNode::Value
{
  struct Payload
  {
    std::string text;
    /** Elements of an array, or members of an object with their keys beside. */
    std::vector<Value>       children;
    std::vector<std::string> keys;
  };
  KindEnum                 kind{ KindEnum::Null };
  bool                     boolean{ false };
  double                   number{ 0.0 };
  std::unique_ptr<Payload> payload;

  void
  SetKind(KindEnum newKind)
  {
    kind = newKind;
    if (kind >= KindEnum::String)
    {
      payload = std::make_unique<Payload>();
    }
  }
};

struct JsonNode::Storage
{
  std::string              fileName;
  Value                    root;
  std::vector<std::string> warnings;
};

namespace
{
constexpr std::size_t MaximumDepth = 64;
/** Of texts, arrays and objects. A tracing of the most points has a tenth; of a file of empty ones each takes 120
 * bytes. */
constexpr std::size_t MaximumNumberOfParts = 3000000;
constexpr std::size_t MaximumQuote = 60;

/** What may stand in a one-line message: printable, short. */
std::string
Quote(const std::string & text)
{
  std::string quoted;
  for (const char character : text.substr(0, MaximumQuote))
  {
    const auto byte = static_cast<unsigned char>(character);
    quoted += byte < 0x20 || byte >= 0x7f ? '?' : character;
  }
  return text.size() > MaximumQuote ? quoted + "..." : quoted;
}

std::string
MemberPath(const std::string & parent, const std::string & key)
{
  return parent.empty() ? Quote(key) : parent + '.' + Quote(key);
}

std::string
ElementPath(const std::string & parent, std::size_t index)
{
  return parent + '[' + std::to_string(index) + ']';
}

std::string
LineAndColumn(const std::string & text, std::size_t position)
{
  position = std::min(position, text.size());
  const auto        begin = text.begin();
  const auto        end = begin + static_cast<std::ptrdiff_t>(position);
  const auto        line = 1 + std::count(begin, end, '\n');
  const std::size_t lineStart = position == 0 ? std::string::npos : text.rfind('\n', position - 1);
  const std::size_t column = position - (lineStart == std::string::npos ? 0 : lineStart + 1);
  return "line " + std::to_string(line) + ", column " + std::to_string(column + 1);
}

/** The parser's message without its own prefix and position. */
std::string
ShortenSyntaxMessage(std::string message)
{
  for (const char * marker : { "syntax error ", "] " })
  {
    const std::size_t start = message.find(marker);
    if (start != std::string::npos)
    {
      message.erase(0, start + std::char_traits<char>::length(marker));
      break;
    }
  }
  constexpr std::size_t longest = 160;
  std::string           shortened;
  for (const char character : message.substr(0, longest))
  {
    const auto byte = static_cast<unsigned char>(character);
    shortened += byte < 0x20 || byte >= 0x7f ? '?' : character;
  }
  return shortened;
}
} // namespace

namespace
{
/** Builds the tree from the parser's events; templated because JsonNode::Value is private. */
template <typename TValue, typename TKind>
class TreeBuilder : public nlohmann::json_sax<nlohmann::json>
{
public:
  TreeBuilder(TValue & root, const std::string & text, const std::string & fileName)
    : m_Root(root)
    , m_Text(text)
    , m_FileName(fileName)
  {}

  bool
  null() override
  {
    this->Add(TKind::Null);
    return true;
  }
  bool
  boolean(bool value) override
  {
    this->Add(TKind::Boolean).boolean = value;
    return true;
  }
  bool
  number_integer(number_integer_t value) override
  {
    this->Add(TKind::Number).number = static_cast<double>(value);
    return true;
  }
  bool
  number_unsigned(number_unsigned_t value) override
  {
    this->Add(TKind::Number).number = static_cast<double>(value);
    return true;
  }
  bool
  number_float(number_float_t value, const string_t &) override
  {
    this->Add(TKind::Number).number = value;
    return true;
  }
  bool
  string(string_t & value) override
  {
    this->Add(TKind::String).payload->text = std::move(value);
    return true;
  }
  bool
  binary(binary_t &) override
  {
    return false;
  }
  bool
  start_object(std::size_t) override
  {
    this->Open(TKind::Object);
    return true;
  }
  bool
  start_array(std::size_t) override
  {
    this->Open(TKind::Array);
    return true;
  }
  bool
  key(string_t & value) override
  {
    if (!m_Keys.back().insert(value).second)
    {
      itkDentalInputErrorMacro(m_FileName, MemberPath(this->Path(), value), "is there twice", "keep one of the two");
    }
    m_Open.back()->payload->keys.push_back(std::move(value));
    return true;
  }
  bool
  end_object() override
  {
    this->Close();
    return true;
  }
  bool
  end_array() override
  {
    this->Close();
    return true;
  }
  bool
  parse_error(std::size_t position, const std::string &, const nlohmann::json::exception & exception) override
  {
    // The parser counts the bytes it has read; the last of them is where it stopped.
    itkDentalInputErrorMacro(m_FileName,
                             LineAndColumn(m_Text, position == 0 ? 0 : position - 1),
                             "JSON syntax error: " + ShortenSyntaxMessage(exception.what()),
                             "correct the file at that place");
  }

private:
  TValue &
  Add(TKind kind)
  {
    const bool isPart = kind == TKind::String || kind == TKind::Array || kind == TKind::Object;
    if (isPart && ++m_NumberOfParts > MaximumNumberOfParts)
    {
      itkDentalInputErrorMacro(m_FileName,
                               this->Path(),
                               "has more than " + std::to_string(MaximumNumberOfParts) + " texts, arrays and objects",
                               "check that this is the right file");
    }
    TValue * value = &m_Root;
    if (!m_Open.empty())
    {
      m_Open.back()->payload->children.emplace_back();
      value = &m_Open.back()->payload->children.back();
    }
    value->SetKind(kind);
    return *value;
  }

  void
  Open(TKind kind)
  {
    if (m_Open.size() == MaximumDepth)
    {
      itkDentalInputErrorMacro(m_FileName,
                               this->Path(),
                               "is nested deeper than " + std::to_string(MaximumDepth) + " levels",
                               "check that this is the right file");
    }
    // An element grows only while it is the last one, so that no pointer of the stack moves.
    m_Open.push_back(&this->Add(kind));
    m_Keys.emplace_back();
  }

  void
  Close()
  {
    m_Open.pop_back();
    m_Keys.pop_back();
  }

  std::string
  Path() const
  {
    std::string path;
    for (std::size_t level = 0; level + 1 < m_Open.size(); ++level)
    {
      path = m_Open[level]->kind == TKind::Object ? MemberPath(path, m_Open[level]->payload->keys.back())
                                                  : ElementPath(path, m_Open[level]->payload->children.size() - 1);
    }
    return path;
  }

  TValue &                           m_Root;
  std::size_t                        m_NumberOfParts{ 0 };
  const std::string &                m_Text;
  const std::string &                m_FileName;
  std::vector<TValue *>              m_Open;
  std::vector<std::set<std::string>> m_Keys;
};
} // namespace

JsonNode::JsonNode(std::shared_ptr<Storage> storage, const Value * value, std::string path)
  : m_Storage(std::move(storage))
  , m_Value(value)
  , m_Path(std::move(path))
{}

JsonNode::KindEnum
JsonNode::GetKind() const
{
  return m_Value->kind;
}

const std::string &
JsonNode::GetFileName() const
{
  return m_Storage->fileName;
}

std::string
JsonNode::Describe() const
{
  switch (m_Value->kind)
  {
    case KindEnum::Null:
      return "null";
    case KindEnum::Boolean:
      return m_Value->boolean ? "true" : "false";
    case KindEnum::Number: {
      const nlohmann::json number = m_Value->number;
      return number.dump();
    }
    case KindEnum::String:
      return '"' + Quote(m_Value->payload->text) + '"';
    case KindEnum::Array:
      return "an array of " + std::to_string(m_Value->payload->children.size());
    default:
      return "an object";
  }
}

void
JsonNode::Require(KindEnum kind, const char * expected) const
{
  if (m_Value->kind != kind)
  {
    this->Fail("is " + this->Describe() + ", expected " + expected, "correct the field");
  }
}

std::optional<JsonNode>
JsonNode::Find(const std::string & key) const
{
  this->Require(KindEnum::Object, "an object");
  for (std::size_t i = 0; i < m_Value->payload->keys.size(); ++i)
  {
    if (m_Value->payload->keys[i] == key)
    {
      return JsonNode(m_Storage, &m_Value->payload->children[i], MemberPath(m_Path, key));
    }
  }
  return std::nullopt;
}

JsonNode
JsonNode::Get(const std::string & key) const
{
  std::optional<JsonNode> member = this->Find(key);
  if (!member)
  {
    itkDentalInputErrorMacro(m_Storage->fileName, MemberPath(m_Path, key), "missing field", "add it");
  }
  return *std::move(member);
}

std::vector<std::pair<std::string, JsonNode>>
JsonNode::GetMembers() const
{
  this->Require(KindEnum::Object, "an object");
  std::vector<std::pair<std::string, JsonNode>> members;
  members.reserve(m_Value->payload->keys.size());
  for (std::size_t i = 0; i < m_Value->payload->keys.size(); ++i)
  {
    const std::string & key = m_Value->payload->keys[i];
    members.emplace_back(key, JsonNode(m_Storage, &m_Value->payload->children[i], MemberPath(m_Path, key)));
  }
  return members;
}

void
JsonNode::WarnAboutUnknownFields(std::initializer_list<const char *> known) const
{
  for (const auto & [key, member] : this->GetMembers())
  {
    // A name that begins so is a person's own: "_notes".
    const bool isOwn = !key.empty() && key[0] == '_';
    if (!isOwn && std::find(known.begin(), known.end(), key) == known.end())
    {
      member.Warn("unknown field, ignored");
    }
  }
}

std::size_t
JsonNode::GetSize() const
{
  this->Require(KindEnum::Array, "an array");
  return m_Value->payload->children.size();
}

JsonNode
JsonNode::At(std::size_t index) const
{
  this->Require(KindEnum::Array, "an array");
  if (index >= m_Value->payload->children.size())
  {
    this->Fail("has " + std::to_string(m_Value->payload->children.size()) + " elements, no number " +
                 std::to_string(index),
               "add them");
  }
  return JsonNode(m_Storage, &m_Value->payload->children[index], ElementPath(m_Path, index));
}

double
JsonNode::AsNumber() const
{
  this->Require(KindEnum::Number, "a number");
  return m_Value->number;
}

int64_t
JsonNode::AsInteger(int64_t minimum, int64_t maximum) const
{
  const double value = this->AsNumber();
  if (value != std::floor(value) || value < static_cast<double>(minimum) || value > static_cast<double>(maximum))
  {
    this->Fail("is " + this->Describe() + ", expected a whole number from " + std::to_string(minimum) + " to " +
                 std::to_string(maximum),
               "correct the field");
  }
  return static_cast<int64_t>(value);
}

bool
JsonNode::AsBoolean() const
{
  this->Require(KindEnum::Boolean, "true or false");
  return m_Value->boolean;
}

const std::string &
JsonNode::AsString() const
{
  this->Require(KindEnum::String, "a string");
  return m_Value->payload->text;
}

std::vector<double>
JsonNode::AsNumbers(std::size_t count, const std::string & form) const
{
  if (m_Value->kind != KindEnum::Array || m_Value->payload->children.size() != count)
  {
    this->Fail("is " + this->Describe() + ", expected " + std::to_string(count) + " numbers " + form,
               "correct the field");
  }
  std::vector<double> numbers;
  numbers.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Value & element = m_Value->payload->children[i];
    // The path of an element is only built for an error: a tracing has many of them.
    numbers.push_back(element.kind == KindEnum::Number ? element.number : this->At(i).AsNumber());
  }
  return numbers;
}

void
JsonNode::Fail(const std::string & problem, const std::string & remedy) const
{
  itkDentalInputErrorMacro(m_Storage->fileName, m_Path, problem, remedy);
}

void
JsonNode::Warn(const std::string & text) const
{
  AppendWarning(m_Storage->warnings, m_Storage->fileName, (m_Path.empty() ? "" : m_Path + ": ") + text);
}

JsonDocument
JsonDocument::ReadFile(const std::string & fileName)
{
  return Parse(ReadTextFile(fileName, "a JSON file"), fileName);
}

JsonDocument
JsonDocument::Parse(const std::string & text, const std::string & fileName)
{
  if (text.compare(0, 2, "\xff\xfe") == 0 || text.compare(0, 2, "\xfe\xff") == 0)
  {
    itkDentalInputErrorMacro(fileName, "", "is UTF-16", "save it as UTF-8");
  }
  JsonDocument document;
  document.m_Storage = std::make_shared<JsonNode::Storage>();
  document.m_Storage->fileName = fileName;
  TreeBuilder<JsonNode::Value, JsonNode::KindEnum> builder(document.m_Storage->root, text, fileName);
  nlohmann::json::sax_parse(text, &builder);
  return document;
}

void
JsonDocument::Verify(const std::string & text, const std::string & fileName)
{
  Parse(text, fileName);
}

JsonNode
JsonDocument::GetRoot() const
{
  return JsonNode(m_Storage, &m_Storage->root, "");
}

const std::vector<std::string> &
JsonDocument::GetWarnings() const
{
  return m_Storage->warnings;
}
} // namespace itk

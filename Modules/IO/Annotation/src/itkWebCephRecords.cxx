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
#include "itkWebCephRecords.h"

#include "itkDentalInputError.h"
#include "itkForeignAnnotationRecords.h"
#include "itkInputFile.h"
#include "itkJsonDocument.h"
#include "itkReadFileTail.h"
#include "itkTextFile.h"

#include <unzip.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

namespace itk
{
namespace
{
constexpr const char * IndexName = "index.json";
/** An archive with all pictures of a patient has a few tens of MB. */
constexpr std::size_t MaximumArchiveSize = std::size_t(1) << 30;
/** What JsonDocument takes: an entry that unfolds to more is none. */
constexpr std::size_t MaximumIndexSize = std::size_t(32) << 20;

// ---- minizip on bytes that were read: files are opened by InputFile alone -------------------------------------------

struct Stream
{
  const std::string * bytes;
  ZPOS64_T            place{ 0 };
};

voidpf ZCALLBACK
Open(voidpf opaque, const void *, int)
{
  return opaque;
}

uLong ZCALLBACK
Read(voidpf, voidpf stream, void * buffer, uLong size)
{
  auto &             self = *static_cast<Stream *>(stream);
  const std::size_t  left = self.bytes->size() - static_cast<std::size_t>(self.place);
  const std::size_t  count = std::min<std::size_t>(size, left);
  const char * const begin = self.bytes->data() + self.place;
  std::memcpy(buffer, begin, count);
  self.place += count;
  return static_cast<uLong>(count);
}

uLong ZCALLBACK
Write(voidpf, voidpf, const void *, uLong)
{
  return 0;
}

ZPOS64_T ZCALLBACK
Tell(voidpf, voidpf stream)
{
  return static_cast<Stream *>(stream)->place;
}

long ZCALLBACK
Seek(voidpf, voidpf stream, ZPOS64_T offset, int origin)
{
  auto &         self = *static_cast<Stream *>(stream);
  const ZPOS64_T size = self.bytes->size();
  const ZPOS64_T base = origin == ZLIB_FILEFUNC_SEEK_CUR ? self.place : origin == ZLIB_FILEFUNC_SEEK_END ? size : 0;
  // A damaged directory points anywhere.
  if (offset > size || base + offset > size)
  {
    return -1;
  }
  self.place = base + offset;
  return 0;
}

int ZCALLBACK
Close(voidpf, voidpf)
{
  return 0;
}

struct CloseArchive
{
  void
  operator()(void * archive) const
  {
    unzClose(archive);
  }
};

[[noreturn]] void
FailDamaged(const std::string & fileName, const std::string & problem)
{
  itkDentalInputErrorMacro(
    fileName, IndexName, problem, "save the file in WebCeph again, or give the points as CSV with label,x,y");
}

/** The text of index.json. */
std::string
ReadIndex(const std::string & fileName)
{
  const std::string                         bytes = ReadTextFile(fileName, "an archive", MaximumArchiveSize);
  Stream                                    stream{ &bytes };
  zlib_filefunc64_def                       functions{ Open, Read, Write, Tell, Seek, Close, Close, &stream };
  const std::unique_ptr<void, CloseArchive> archive(unzOpen2_64(fileName.c_str(), &functions));
  if (!archive)
  {
    FailDamaged(fileName, "cannot be found: the archive is damaged or not complete");
  }
  unz_file_info64 info{};
  if (unzLocateFile(archive.get(), IndexName, 1) != UNZ_OK ||
      unzGetCurrentFileInfo64(archive.get(), &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK)
  {
    FailDamaged(fileName, "is missing in the archive, or its directory is damaged");
  }
  if (info.uncompressed_size > MaximumIndexSize)
  {
    FailDamaged(fileName, "has " + std::to_string(info.uncompressed_size) + " bytes, more than any has");
  }
  if ((info.flag & 1) != 0)
  {
    FailDamaged(fileName, "is encrypted");
  }
  std::string text(static_cast<std::size_t>(info.uncompressed_size), '\0');
  if (unzOpenCurrentFile(archive.get()) != UNZ_OK)
  {
    FailDamaged(fileName, "cannot be unpacked: the archive is damaged, or packed in a way that is not read");
  }
  const int count = unzReadCurrentFile(archive.get(), &text[0], static_cast<unsigned int>(text.size()));
  // Closing is what compares the check sum.
  const int closed = unzCloseCurrentFile(archive.get());
  if (count < 0 || static_cast<std::size_t>(count) != text.size() || closed != UNZ_OK)
  {
    FailDamaged(fileName, "cannot be unpacked: the archive is damaged");
  }
  return text;
}

// ---- index.json -----------------------------------------------------------------------------------------------------

bool
IsTrue(const JsonNode & picture, const char * key)
{
  const auto node = picture.Find(key);
  return node && !node->IsNull() && node->AsBoolean();
}

/** Whether landmarks of the picture may be a cephalogram's: of photographs and panoramic pictures they are not. */
bool
MayBeCephalogram(const JsonNode & picture)
{
  const auto type = picture.Find("type");
  if (!type || type->IsNull())
  {
    return true;
  }
  const std::string text = type->AsString();
  return text == "ceph_lateral" || text == "ceph_pa" || text == "lateral_cephalo" || text == "frontal_cephalo";
}
} // namespace

bool
IsWebCephFile(const std::string & fileName)
{
  // The directory of an archive, with the names of all that is in it, is at its end.
  return ReadFileHead(fileName, 4) == "PK\x03\x04" &&
         ReadFileTail(fileName, 65536).find(IndexName) != std::string::npos;
}

AnnotationRecords
ReadWebCephRecords(const std::string & fileName, const IsDentalLandmarkType & isDental, const std::string & imageName)
{
  const JsonDocument document = JsonDocument::Parse(ReadIndex(fileName), fileName);
  const JsonNode     root = document.GetRoot();
  const JsonNode     version = root.Get("version");
  if (version.AsInteger(INT64_MIN, INT64_MAX) != 1)
  {
    version.Fail("is not 1, the version of WebCeph's files that is known", "give the points as CSV with label,x,y");
  }
  std::vector<std::pair<JsonNode, JsonNode>> pictures;
  std::vector<std::string>                   names;
  for (const auto & [id, picture] : root.Get("data").GetMembers())
  {
    const JsonNode landmarks = picture.Get("tracing").Get("manualLandmarks");
    if (MayBeCephalogram(picture) && !landmarks.GetMembers().empty())
    {
      const auto name = picture.Find("name");
      pictures.emplace_back(picture, landmarks);
      names.push_back(name && !name->IsNull() ? name->AsString() : id);
    }
  }
  if (pictures.empty())
  {
    root.Get("data").Fail("has no landmarks on a cephalogram", "mark U1 Incisal Edge, L1 Incisal Edge, U6 and L6");
  }
  const auto & [picture, landmarks] = pictures[ChooseImage(fileName, "data", names, imageName)];

  AnnotationRecords records;
  records.format = AnnotationFileFormatEnum::WebCeph;
  for (const auto & [name, node] : landmarks.GetMembers())
  {
    // Lines and angles that were drawn by hand have the ends of their lines in other members.
    if (!isDental(name) || !node.IsObject() || !node.Find("x") || !node.Find("y"))
    {
      records.leftOut.push_back(name);
      continue;
    }
    records.landmarks.push_back(
      { node.GetPath(), name, { { node.Get("x").AsNumber(), node.Get("y").AsNumber(), 0.0 } } });
  }
  records.warnings = document.GetWarnings();
  if (IsTrue(picture, "flipX") || IsTrue(picture, "flipY"))
  {
    records.warnings.push_back(
      fileName + ": " + picture.GetPath() +
      ": WebCeph shows this picture mirrored; its points are read as those of the picture that "
      "lies in the file, which is the one to give as the radiograph");
  }
  return records;
}
} // namespace itk

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
#include "itkNiftiPictureIO.h"

#include "itkDentalInputError.h"
#include "itkPictureSizeCheck.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include <zlib.h>

namespace itk
{
namespace
{
/** Of the header, without the four bytes behind it that tell of extensions. */
constexpr std::size_t HeaderSize = 348;
/** Beyond the pixels a file may have so much; what is longer is another thing than its header says. */
constexpr std::size_t MostBytesBehind = 65536;

template <typename TValue>
TValue
Swap(TValue value, bool isSwapped)
{
  if (isSwapped)
  {
    auto * const bytes = reinterpret_cast<unsigned char *>(&value);
    std::reverse(bytes, bytes + sizeof(value));
  }
  return value;
}

template <typename TValue>
TValue
Take(const char * bytes, bool isSwapped)
{
  TValue value;
  std::memcpy(&value, bytes, sizeof(value));
  return Swap(value, isSwapped);
}

/** How values are kept, by the number that the header has for it. */
struct DataType
{
  int             code;
  IOComponentEnum component;
  unsigned int    bytes;
  double (*take)(const char *, bool);
};

template <typename TValue>
double
TakeNumber(const char * bytes, bool isSwapped)
{
  return static_cast<double>(Take<TValue>(bytes, isSwapped));
}

template <typename TValue>
constexpr DataType
MakeType(int code, IOComponentEnum component)
{
  return { code, component, sizeof(TValue), TakeNumber<TValue> };
}

constexpr DataType DataTypes[] = {
  MakeType<std::uint8_t>(2, IOComponentEnum::UCHAR),       MakeType<std::int16_t>(4, IOComponentEnum::SHORT),
  MakeType<std::int32_t>(8, IOComponentEnum::INT),         MakeType<float>(16, IOComponentEnum::FLOAT),
  MakeType<double>(64, IOComponentEnum::DOUBLE),           MakeType<std::int8_t>(256, IOComponentEnum::CHAR),
  MakeType<std::uint16_t>(512, IOComponentEnum::USHORT),   MakeType<std::uint32_t>(768, IOComponentEnum::UINT),
  MakeType<std::int64_t>(1024, IOComponentEnum::LONGLONG), MakeType<std::uint64_t>(1280, IOComponentEnum::ULONGLONG),
};

/** What the header says. */
struct Header
{
  bool isSwapped{ false };
  int  numberOfDimensions{ 0 };
  /** Of them, at most 7. */
  std::vector<long> dimensions;
  int               dataType{ 0 };
  int               bits{ 0 };
  double            offset{ 0.0 };
  double            slope{ 0.0 };
  double            intercept{ 0.0 };
  double            spacing[2]{ 0.0, 0.0 };
  /** Millimetres a unit. */
  double unit{ 1.0 };
  int    qform{ 0 };
  int    sform{ 0 };
  /** In which columns and rows run, and where the first pixel is: to the patient's left, to the back and up, as ITK has
   * it. Of the quaternion and of the matrix. */
  double quaternion[3][3]{};
  double matrix[3][3]{};

  const DataType *
  FindType() const
  {
    const auto found = std::find_if(
      std::begin(DataTypes), std::end(DataTypes), [this](const DataType & type) { return type.code == dataType; });
    return found == std::end(DataTypes) ? nullptr : &*found;
  }

  /** Whether the values are not those that are stored. */
  bool
  IsScaled() const
  {
    return std::isfinite(slope) && std::isfinite(intercept) && slope != 0.0 && (slope != 1.0 || intercept != 0.0);
  }
};

bool
HasHeader(std::string_view bytes)
{
  return bytes.size() >= HeaderSize && bytes.compare(344, 4, std::string_view("n+1\0", 4)) == 0 &&
         (Take<std::int32_t>(bytes.data(), false) == 348 || Take<std::int32_t>(bytes.data(), true) == 348);
}

/** Of bytes that have one. */
Header
ReadHeader(std::string_view bytes)
{
  const char * const at = bytes.data();
  Header             header;
  header.isSwapped = Take<std::int32_t>(at, false) != 348;
  const auto whole = [&](std::size_t place) { return int{ Take<std::int16_t>(at + place, header.isSwapped) }; };
  const auto real = [&](std::size_t place) { return double{ Take<float>(at + place, header.isSwapped) }; };
  header.numberOfDimensions = whole(40);
  for (int i = 1; i <= std::min(header.numberOfDimensions, 7); ++i)
  {
    header.dimensions.push_back(whole(40 + 2 * static_cast<std::size_t>(i)));
  }
  header.dataType = whole(70);
  header.bits = whole(72);
  header.spacing[0] = real(80);
  header.spacing[1] = real(84);
  header.offset = real(108);
  header.slope = real(112);
  header.intercept = real(116);
  const int unit = at[123] & 7;
  header.unit = unit == 1 ? 1e3 : unit == 3 ? 1e-3 : 1.0;
  header.qform = whole(252);
  header.sform = whole(254);
  const double b = real(256);
  const double c = real(260);
  const double d = real(264);
  const double a = std::sqrt(std::max(0.0, 1.0 - b * b - c * c - d * d));
  // Columns of the rotation that a quaternion means, to the patient's right, the front and up.
  const double columns[2][3] = { { a * a + b * b - c * c - d * d, 2.0 * (b * c + a * d), 2.0 * (b * d - a * c) },
                                 { 2.0 * (b * c - a * d), a * a + c * c - b * b - d * d, 2.0 * (c * d + a * b) } };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double sign = i < 2 ? -1.0 : 1.0;
    for (std::size_t j = 0; j < 2; ++j)
    {
      header.quaternion[j][i] = sign * columns[j][i];
      header.matrix[j][i] = sign * real(280 + 16 * i + 4 * j);
    }
    header.quaternion[2][i] = sign * real(268 + 4 * i);
    header.matrix[2][i] = sign * real(292 + 16 * i);
  }
  return header;
}

/** The first bytes of what gzip has compressed, at most as many; of a damaged file those before it. Where there are
 * several parts they follow each other, as gzip has it.
 *
 * \param problem Gets why there are no more; "" at the end, or where all that were asked for are there. */
std::string
Unpack(std::string_view packed, std::size_t most, std::string & problem)
{
  std::string unpacked;
  z_stream    stream{};
  // 16 for gzip's head and its checksum.
  if (::inflateInit2(&stream, 15 + 16) != Z_OK)
  {
    problem = "there is no memory to unpack it";
    return unpacked;
  }
  stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  problem.clear();
  int         result = Z_OK;
  std::size_t count = 0;
  while (count < most)
  {
    if (count == unpacked.size())
    {
      unpacked.resize(std::min(most, count + (std::size_t{ 1 } << 20)));
    }
    // What room there is stays from part to part: a million parts without a byte would clear it as often.
    stream.next_out = reinterpret_cast<Bytef *>(&unpacked[count]);
    stream.avail_out = static_cast<uInt>(unpacked.size() - count);
    result = ::inflate(&stream, Z_NO_FLUSH);
    count = unpacked.size() - stream.avail_out;
    if (result == Z_STREAM_END)
    {
      // What follows is a further part, or what somebody has added, which gzip leaves out.
      if (stream.avail_in < 2 || stream.next_in[0] != 0x1f || stream.next_in[1] != 0x8b ||
          ::inflateReset(&stream) != Z_OK)
      {
        break;
      }
    }
    else if (result != Z_OK)
    {
      problem = result == Z_BUF_ERROR ? "its compressed bytes end too early" : "its compressed bytes are damaged";
      break;
    }
  }
  ::inflateEnd(&stream);
  unpacked.resize(count);
  return unpacked;
}

bool
IsCompressed(std::string_view bytes)
{
  return bytes.substr(0, 2) == "\x1f\x8b";
}

[[noreturn]] void
Refuse(const std::string & fileName, const std::string & field, const std::string & problem)
{
  itkDentalInputErrorMacro(fileName, field, problem, "copy or export it again, as .nii, .nii.gz, NRRD or PNG");
}

/** Throws where it is no picture of one value a pixel. \return how long the file has to be */
std::size_t
VerifyHeader(const std::string & fileName, const Header & header)
{
  const auto list = [&header] {
    std::string text;
    for (const long dimension : header.dimensions)
    {
      text += (text.empty() ? "" : " x ") + std::to_string(dimension);
    }
    return text;
  };
  if (header.numberOfDimensions < 2 || header.numberOfDimensions > 7)
  {
    Refuse(fileName, "dim", "is no picture: it has " + std::to_string(header.numberOfDimensions) + " dimensions");
  }
  if (std::any_of(header.dimensions.begin(), header.dimensions.end(), [](long count) { return count < 1; }))
  {
    Refuse(fileName, "dim", "\"" + list() + "\" is no image size");
  }
  const DataType * const type = header.FindType();
  if (type == nullptr)
  {
    Refuse(fileName,
           "datatype",
           std::to_string(header.dataType) +
             " is no type of a grey pixel (colours, complex numbers and single bits are "
             "not read)");
  }
  if (header.bits != static_cast<int>(8 * type->bytes))
  {
    Refuse(fileName,
           "bitpix",
           "is " + std::to_string(header.bits) + ", and " + std::to_string(8 * type->bytes) + " of its datatype " +
             std::to_string(header.dataType));
  }
  if (header.dimensions.size() > 4 && header.dimensions[4] > 1)
  {
    Refuse(
      fileName, "dim", "has " + std::to_string(header.dimensions[4]) + " values a pixel (" + list() + "), not one");
  }
  if (header.dimensions.size() > 2 && header.dimensions[2] > 1 &&
      (header.dimensions[0] == 1 || header.dimensions[1] == 1))
  {
    Refuse(
      fileName, "dim", "\"" + list() + "\" is a picture across the slices: columns have to be first and rows second");
  }
  Size<2>       size;
  SizeValueType frames = 1;
  for (std::size_t i = 0; i < header.dimensions.size(); ++i)
  {
    const auto count = static_cast<SizeValueType>(header.dimensions[i]);
    if (i < 2)
    {
      size[i] = count;
    }
    else
    {
      // Each is below 2^15.
      frames = std::min(frames * count, SizeValueType{ 1 } << 40);
    }
  }
  VerifyPictureSize(fileName, size, frames, header.IsScaled() ? sizeof(double) : type->bytes);
  // A header's own extensions are short; of a NaN the comparison is false.
  if (!(header.offset >= static_cast<double>(HeaderSize) && header.offset <= double{ 1 << 24 } &&
        header.offset == std::floor(header.offset)))
  {
    Refuse(fileName, "vox_offset", "is not where pixels can begin");
  }
  return static_cast<std::size_t>(header.offset) + size[0] * size[1] * type->bytes;
}

/** The patient's side to which an axis runs, as programs of volumes name it. */
char
NameAxis(const double (&axis)[3])
{
  const auto largest =
    std::max_element(axis, axis + 3, [](double left, double right) { return std::abs(left) < std::abs(right); });
  return (*largest > 0.0 ? "LPS" : "RAI")[largest - axis];
}

/** Whether columns run to the right and rows to the front, from a first pixel at the origin: numpy.eye(4), with a
 * spacing or without. What programs write of a picture has other signs, and what was turned over begins elsewhere. */
bool
HasAxesOfPlainArray(const Header & header)
{
  if (header.sform <= 0 && header.qform <= 0)
  {
    return false;
  }
  const auto & axes = header.sform > 0 ? header.matrix : header.quaternion;
  bool         isPlain = true;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double * const axis = axes[i];
    const double         length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const double         pixel = header.sform > 0 ? length : header.spacing[i];
    // A quarter of a degree, as in FindTurns(). A picture of one pixel a side begins where it ends.
    isPlain =
      isPlain && -axis[i] >= (1.0 - 1e-5) * length && std::abs(axes[2][i]) < 0.5 * pixel && header.dimensions[i] > 1;
  }
  return isPlain;
}

/** Where a picture's upper left pixel is: whether columns and rows run from there or to it. Throws where that is not
 * known. */
std::array<bool, 2>
FindTurns(const std::string & fileName, const Header & header)
{
  std::array<bool, 2> turned{ { false, false } };
  if ((header.sform <= 0 && header.qform <= 0) || HasAxesOfPlainArray(header))
  {
    return turned;
  }
  const auto & axes = header.sform > 0 ? header.matrix : header.quaternion;
  const auto   fail = [&](const std::string & why) {
    itkDentalInputErrorMacro(fileName,
                             header.sform > 0 ? "srow_x, srow_y" : "quatern",
                             std::string("columns run to ") + NameAxis(axes[0]) + " and rows to " + NameAxis(axes[1]) +
                               ", " + why,
                             "write it as SimpleITK, ITK-SNAP and 3D Slicer write a picture, with columns to the left "
                               "(L) and rows to the back "
                               "(P); in nibabel that is the array [column, row] with the affine diag(-1, -1, 1, 1)");
  };
  // Of a cosine: a quarter of a degree, which no rounding to float makes.
  constexpr double tolerance = 1e-5;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double * const axis = axes[i];
    const double         length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const double         along = axis[i] / length;
    // Negated so that what is not finite is refused.
    if (!(std::abs(along) >= 1.0 - tolerance))
    {
      fail("which is no picture from left to right and from top to bottom");
    }
    if (along > 0.0)
    {
      continue;
    }
    const double pixel = header.sform > 0 ? length : header.spacing[i];
    const double last = axes[2][i] - pixel * static_cast<double>(header.dimensions[i] - 1);
    if (!(std::abs(last) < 0.5 * pixel))
    {
      fail("and where the pixels lie doesn't tell whether the picture was turned over");
    }
    turned[i] = true;
  }
  return turned;
}

/** Of a stream at its beginning; throws where it has none. */
Header
ReadHeader(std::istream & stream)
{
  std::string bytes(HeaderSize, '\0');
  stream.read(&bytes[0], static_cast<std::streamsize>(bytes.size()));
  if (!stream || !HasHeader(bytes))
  {
    throw std::invalid_argument("it is no NIfTI file");
  }
  return ReadHeader(std::string_view(bytes));
}
} // namespace

bool
NiftiPictureIO::IsNifti(std::string_view bytes)
{
  if (!IsCompressed(bytes))
  {
    return HasHeader(bytes);
  }
  std::string problem;
  return HasHeader(Unpack(bytes, HeaderSize, problem));
}

bool
NiftiPictureIO::IsOfPlainArray(std::string_view bytes)
{
  std::string       problem;
  const std::string head =
    IsCompressed(bytes) ? Unpack(bytes, HeaderSize, problem) : std::string(bytes.substr(0, HeaderSize));
  return HasHeader(head) && HasAxesOfPlainArray(ReadHeader(std::string_view(head)));
}

void
NiftiPictureIO::Verify(const std::string & fileName, std::string & bytes)
{
  std::string problem;
  const bool  isCompressed = IsCompressed(bytes);
  const auto  header =
    ReadHeader(std::string_view(isCompressed ? Unpack(bytes, HeaderSize, problem) : bytes.substr(0, HeaderSize)));
  const auto expected = VerifyHeader(fileName, header);
  FindTurns(fileName, header);
  if (isCompressed)
  {
    // To its end, where its checksum is, but no further than what its header asks for: a bomb has more.
    bytes = Unpack(bytes, expected + MostBytesBehind + 1, problem);
  }
  if (bytes.size() < expected || !problem.empty())
  {
    Refuse(fileName,
           "",
           "the NIfTI file is truncated or damaged: " + std::to_string(bytes.size()) + " of " +
             std::to_string(expected) + " bytes are there" + (problem.empty() ? "" : ", and " + problem));
  }
  if (bytes.size() - expected > MostBytesBehind)
  {
    Refuse(fileName, "dim", "the file has more pixels than its header says");
  }
}

void
NiftiPictureIO::ReadImageInformation()
{
  std::ifstream stream(this->GetFileName(), std::ios::binary);
  const Header  header = ReadHeader(stream);
  VerifyHeader(this->GetFileName(), header);
  m_IsTurned = FindTurns(this->GetFileName(), header);
  const bool   isPlaced = header.sform > 0 || header.qform > 0;
  const auto & axes = header.sform > 0 ? header.matrix : header.quaternion;
  this->SetNumberOfDimensions(2);
  for (unsigned int i = 0; i < 2; ++i)
  {
    this->SetDimensions(i, static_cast<SizeValueType>(header.dimensions[i]));
    this->SetSpacing(i, header.unit * header.spacing[i]);
    this->SetOrigin(i, isPlaced && !m_IsTurned[i] ? header.unit * axes[2][i] : 0.0);
    std::vector<double> direction(2, 0.0);
    direction[i] = 1.0;
    this->SetDirection(i, direction);
  }
  this->SetNumberOfComponents(1);
  this->SetPixelType(IOPixelEnum::SCALAR);
  this->SetComponentType(header.IsScaled() ? IOComponentEnum::DOUBLE : header.FindType()->component);
}

void
NiftiPictureIO::Read(void * buffer)
{
  std::ifstream stream(this->GetFileName(), std::ios::binary);
  const Header  header = ReadHeader(stream);
  VerifyHeader(this->GetFileName(), header);
  if (header.dimensions[0] != static_cast<long>(this->GetDimensions(0)) ||
      header.dimensions[1] != static_cast<long>(this->GetDimensions(1)))
  {
    throw std::invalid_argument("it was changed since its header was read");
  }
  const DataType &  type = *header.FindType();
  auto * const      destination = static_cast<char *>(buffer);
  const std::size_t columns = this->GetDimensions(0);
  const std::size_t rows = this->GetDimensions(1);
  const bool        isScaled = header.IsScaled();
  const std::size_t length = isScaled ? sizeof(double) : type.bytes;
  const bool        isWhole = type.component != IOComponentEnum::FLOAT && type.component != IOComponentEnum::DOUBLE;
  // Whole numbers that were squeezed into few bits come back to within half a step, but not exactly: labels do.
  const double      step = std::min(0.5 * std::abs(header.slope), 0.05);
  std::vector<char> stored(columns * type.bytes);
  stream.seekg(static_cast<std::streamoff>(header.offset));
  for (std::size_t v = 0; v < rows; ++v)
  {
    if (!stream.read(stored.data(), static_cast<std::streamsize>(stored.size())))
    {
      throw std::invalid_argument("its pixels are not whole");
    }
    const char * source = stored.data();
    for (std::size_t u = 0; u < columns; ++u, source += type.bytes)
    {
      const std::size_t column = m_IsTurned[0] ? columns - 1 - u : u;
      const std::size_t row = m_IsTurned[1] ? rows - 1 - v : v;
      char * const      pixel = destination + (row * columns + column) * length;
      if (isScaled)
      {
        double       value = header.slope * type.take(source, header.isSwapped) + header.intercept;
        const double whole = std::round(value);
        // The slope and the intercept are rounded to float, too.
        if (isWhole && std::abs(value - whole) <= step + 1e-6 * std::abs(value))
        {
          value = whole;
        }
        std::memcpy(pixel, &value, sizeof(value));
        continue;
      }
      std::memcpy(pixel, source, type.bytes);
      if (header.isSwapped)
      {
        std::reverse(pixel, pixel + type.bytes);
      }
    }
  }
}

void
NiftiPictureIO::Write(const void *)
{
  itkExceptionMacro("This class reads only.");
}

void
NiftiPictureIO::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "IsTurned: " << m_IsTurned[0] << ' ' << m_IsTurned[1] << std::endl;
}
} // namespace itk

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
#include "itkOpenMeshMeshIO.h"

#include "itkDentalInputError.h"
#include "itkForeignFile.h"
#include "itkInputFile.h"
#include "itkOpenMeshWriter.h"
#include "itkOutputFile.h"
#include "itkReadDentalMesh.h"
#include "itkSurfaceMeshFile.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <ostream>
#include <streambuf>

namespace itk
{
namespace
{
constexpr const char * Extensions[] = { ".stl", ".ply", ".obj", ".off" };

template <typename TCoordinate>
void
CopyPoints(const void * buffer, std::size_t count, std::vector<std::array<float, 3>> & points)
{
  const auto * coordinates = static_cast<const TCoordinate *>(buffer);
  points.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      points[i][d] = static_cast<float>(coordinates[3 * i + d]);
    }
  }
}

/** \return the number of the cell that is no triangle of these points, or the number of cells. */
template <typename TIndex>
std::size_t
CopyTriangles(const void *                                 buffer,
              std::size_t                                  count,
              std::size_t                                  points,
              std::vector<SurfaceMeshFile::TriangleType> & triangles)
{
  const auto * values = static_cast<const TIndex *>(buffer);
  triangles.resize(count);
  for (std::size_t i = 0; i < count; ++i, values += 5)
  {
    const auto type = static_cast<CellGeometryEnum>(static_cast<int>(values[0]));
    if ((type != CellGeometryEnum::TRIANGLE_CELL && type != CellGeometryEnum::POLYGON_CELL) || values[1] != 3)
    {
      return i;
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      if (!(values[2 + c] >= 0) || static_cast<std::size_t>(values[2 + c]) >= points)
      {
        return i;
      }
      triangles[i][c] = static_cast<std::uint32_t>(values[2 + c]);
    }
  }
  return count;
}

/** Hands what a stream is given to a file, in pieces. */
class OutputFileBuffer : public std::streambuf
{
public:
  explicit OutputFileBuffer(OutputFile & file)
    : m_File(file)
    , m_Bytes(std::size_t{ 1 } << 16)
  {
    this->setp(m_Bytes.data(), m_Bytes.data() + m_Bytes.size());
  }

  /** Not sync(): the stream would take the error for one of its own, without the words. */
  void
  Flush()
  {
    m_File.Write(this->pbase(), static_cast<std::size_t>(this->pptr() - this->pbase()));
    this->setp(m_Bytes.data(), m_Bytes.data() + m_Bytes.size());
  }

protected:
  int_type
  overflow(int_type character) override
  {
    this->Flush();
    return traits_type::eq_int_type(character, traits_type::eof()) ? traits_type::not_eof(character)
                                                                   : this->sputc(traits_type::to_char_type(character));
  }

private:
  OutputFile &      m_File;
  std::vector<char> m_Bytes;
};
} // namespace

OpenMeshMeshIO::OpenMeshMeshIO()
{
  for (const char * extension : Extensions)
  {
    this->AddSupportedReadExtension(extension);
    this->AddSupportedWriteExtension(extension);
  }
}

OpenMeshMeshIO::~OpenMeshMeshIO() = default;

bool
OpenMeshMeshIO::CanReadFile(const char * fileName)
{
  if (fileName == nullptr || *fileName == '\0')
  {
    return false;
  }
  if (MeshFileFormatFromName(fileName) != MeshFileFormatEnum::Unknown)
  {
    return true;
  }
  // The file may be of any kind and size: look at its head alone.
  InputFile         file(fileName);
  std::vector<char> head(std::min(file.GetSize(), MeshFileFormatHeadSize));
  return !head.empty() && file.Read(head.data(), head.size()) == head.size() &&
         DetectMeshFileFormat(head.data(), file.GetSize(), fileName) != MeshFileFormatEnum::Unknown;
}

void
OpenMeshMeshIO::ReadMeshInformation()
{
  m_Surface.reset();
  try
  {
    m_Surface = std::make_unique<SurfaceMeshFile>(ReadSurfaceMeshFile(m_FileName));
  }
  catch (const SurfaceMeshFileError & error)
  {
    // What it is says more than what it is not.
    RefuseForeignFile(m_FileName, FilePurposeEnum::Scan);
    itkDentalInputErrorMacro(m_FileName, error.field, error.problem, error.remedy);
  }
  catch (const std::bad_alloc &)
  {
    itkDentalInputErrorMacro(m_FileName, "", "there is not enough memory to read it", "decimate it, or free memory");
  }
  m_Format = m_Surface->format;
  m_NumberOfFacesInFile = m_Surface->numberOfFacesInFile;
  m_NumberOfDegenerateFaces = m_Surface->numberOfDegenerateFaces;
  m_FileType = m_Format == MeshFileFormatEnum::BinarySTL ? IOFileEnum::BINARY : IOFileEnum::ASCII;

  this->SetPointDimension(3);
  this->SetPointComponentType(m_Surface->floatPoints.empty() ? IOComponentEnum::DOUBLE : IOComponentEnum::FLOAT);
  this->SetNumberOfPoints(m_Surface->GetNumberOfPoints());
  this->SetUpdatePoints(true);
  this->SetCellComponentType(IOComponentEnum::UINT);
  this->SetNumberOfCells(m_Surface->triangles.size());
  this->SetCellBufferSize(5 * m_Surface->triangles.size());
  this->SetUpdateCells(true);
  this->SetNumberOfPointPixels(0);
  this->SetUpdatePointData(false);
  this->SetNumberOfCellPixels(0);
  this->SetUpdateCellData(false);
}

void
OpenMeshMeshIO::ReadPoints(void * buffer)
{
  if (m_Surface == nullptr)
  {
    itkExceptionMacro("Nothing has been read: call ReadMeshInformation() before ReadPoints().");
  }
  if (m_Surface->floatPoints.empty())
  {
    auto * values = static_cast<double *>(buffer);
    for (const auto & point : m_Surface->doublePoints)
    {
      values = std::copy(point.begin(), point.end(), values);
    }
  }
  else
  {
    auto * values = static_cast<float *>(buffer);
    for (const auto & point : m_Surface->floatPoints)
    {
      values = std::copy(point.begin(), point.end(), values);
    }
  }
}

void
OpenMeshMeshIO::ReadCells(void * buffer)
{
  if (m_Surface == nullptr)
  {
    itkExceptionMacro("Nothing has been read: call ReadMeshInformation() before ReadCells().");
  }
  auto * values = static_cast<unsigned int *>(buffer);
  for (const auto & triangle : m_Surface->triangles)
  {
    *values++ = static_cast<unsigned int>(CellGeometryEnum::TRIANGLE_CELL);
    *values++ = 3;
    values = std::copy(triangle.begin(), triangle.end(), values);
  }
  // The reader lives on in a pipeline; the copy has been made.
  m_Surface.reset();
}

void
OpenMeshMeshIO::ReadPointData(void *)
{}

void
OpenMeshMeshIO::ReadCellData(void *)
{}

bool
OpenMeshMeshIO::CanWriteFile(const char * fileName)
{
  return fileName != nullptr && MeshFileFormatFromName(fileName) != MeshFileFormatEnum::Unknown;
}

void
OpenMeshMeshIO::WriteMeshInformation()
{
  if (m_PointDimension != 3)
  {
    itkExceptionMacro("The mesh has points in " << m_PointDimension << " dimensions; a surface has 3.");
  }
  m_Surface = std::make_unique<SurfaceMeshFile>();
}

void
OpenMeshMeshIO::WritePoints(void * buffer)
{
  if (m_Surface == nullptr)
  {
    itkExceptionMacro("Call WriteMeshInformation() before WritePoints().");
  }
  std::vector<std::array<float, 3>> & points = m_Surface->floatPoints;
  switch (m_PointComponentType)
  {
    case IOComponentEnum::FLOAT:
      CopyPoints<float>(buffer, m_NumberOfPoints, points);
      break;
    case IOComponentEnum::DOUBLE:
      CopyPoints<double>(buffer, m_NumberOfPoints, points);
      break;
    case IOComponentEnum::LDOUBLE:
      CopyPoints<long double>(buffer, m_NumberOfPoints, points);
      break;
    default:
      itkExceptionMacro("Points of type " << this->GetComponentTypeAsString(m_PointComponentType)
                                          << " cannot be written: use a mesh with float or double coordinates.");
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (const float coordinate : points[i])
    {
      if (!std::isfinite(coordinate))
      {
        itkExceptionMacro("Point " << i << " of the mesh is not finite in single precision: it cannot be written to "
                                   << m_FileName << '.');
      }
    }
  }
}

void
OpenMeshMeshIO::WriteCells(void * buffer)
{
  if (m_Surface == nullptr)
  {
    itkExceptionMacro("Call WriteMeshInformation() before WriteCells().");
  }
  std::size_t       good = 0;
  const std::size_t points = m_Surface->floatPoints.size();
  auto &            triangles = m_Surface->triangles;
  // Only a buffer of triangles alone has five values a cell.
  if (m_CellBufferSize == 5 * m_NumberOfCells)
  {
    switch (m_CellComponentType)
    {
      case IOComponentEnum::UINT:
        good = CopyTriangles<unsigned int>(buffer, m_NumberOfCells, points, triangles);
        break;
      case IOComponentEnum::INT:
        good = CopyTriangles<int>(buffer, m_NumberOfCells, points, triangles);
        break;
      case IOComponentEnum::ULONG:
        good = CopyTriangles<unsigned long>(buffer, m_NumberOfCells, points, triangles);
        break;
      case IOComponentEnum::LONG:
        good = CopyTriangles<long>(buffer, m_NumberOfCells, points, triangles);
        break;
      case IOComponentEnum::ULONGLONG:
        good = CopyTriangles<unsigned long long>(buffer, m_NumberOfCells, points, triangles);
        break;
      case IOComponentEnum::LONGLONG:
        good = CopyTriangles<long long>(buffer, m_NumberOfCells, points, triangles);
        break;
      default:
        itkExceptionMacro("Cells of type " << this->GetComponentTypeAsString(m_CellComponentType)
                                           << " cannot be written: use an integer point identifier.");
    }
  }
  if (good != m_NumberOfCells)
  {
    m_Surface.reset();
    itkExceptionMacro("Cell " << good << " or another is no triangle of the mesh's points: triangulate the mesh before "
                              << "writing " << m_FileName << '.');
  }
}

void
OpenMeshMeshIO::WritePointData(void *)
{}

void
OpenMeshMeshIO::WriteCellData(void *)
{}

void
OpenMeshMeshIO::Write()
{
  const std::unique_ptr<SurfaceMeshFile> surface = std::move(m_Surface);
  if (surface == nullptr || surface->triangles.empty())
  {
    itkExceptionMacro("The mesh has no triangles: nothing to write to " << m_FileName << '.');
  }
  const MeshFileFormatEnum format = MeshFileFormatFromName(m_FileName);
  if (format == MeshFileFormatEnum::Unknown)
  {
    itkDentalInputErrorMacro(
      m_FileName, "", "its extension names no format that can be written", "use .stl, .ply, .obj or .off");
  }
  const bool binary =
    m_FileType == IOFileEnum::BINARY && (format == MeshFileFormatEnum::BinarySTL || format == MeshFileFormatEnum::PLY);
  OutputFile       file(m_FileName);
  OutputFileBuffer buffer(file);
  std::ostream     stream(&buffer);
  // What the file can't take is told in its own words.
  stream.exceptions(std::ios::badbit);
  if (!WriteWithOpenMesh(stream, format, surface->floatPoints, surface->triangles, binary))
  {
    itkDentalInputErrorMacro(
      m_FileName, "", "cannot be written", "check the folder, its permissions and the free space");
  }
  buffer.Flush();
  file.Commit();
}

void
OpenMeshMeshIO::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Format: " << m_Format << std::endl;
  os << indent << "NumberOfFacesInFile: " << m_NumberOfFacesInFile << std::endl;
  os << indent << "NumberOfDegenerateFaces: " << m_NumberOfDegenerateFaces << std::endl;
  os << indent << "Surface: " << (m_Surface == nullptr ? "none" : "held") << std::endl;
}

template Mesh<float, 3>::Pointer
ReadDentalMesh<Mesh<float, 3>>(const std::string &, std::vector<std::string> *);
template Mesh<double, 3>::Pointer
ReadDentalMesh<Mesh<double, 3>>(const std::string &, std::vector<std::string> *);
template void
WriteDentalMesh<Mesh<float, 3>>(const Mesh<float, 3> *, const std::string &);
template void
WriteDentalMesh<Mesh<double, 3>>(const Mesh<double, 3> *, const std::string &);
} // namespace itk

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
#ifndef itkOpenMeshMeshIO_h
#define itkOpenMeshMeshIO_h

#include "MeshOpenMeshExport.h"
#include "itkMeshFileFormat.h"

#include "itkMeshIOBase.h"

#include <memory>
#include <vector>

namespace itk
{
struct SurfaceMeshFile;

/** \class OpenMeshMeshIO
 * \brief Strict reading, and writing, of triangle surfaces: STL (binary, ASCII), PLY, OBJ, OFF.
 *
 * For the stock MeshFileReader and MeshFileWriter; call RegisterOpenMeshMeshIOFactories() once. The format is told by
 * content, then by extension. Anything that is not a whole, finite mesh is a DentalInputError that names the file, the
 * place in it and the remedy: OpenMesh and VTK read truncated files in silence. What is done to the points and faces is
 * told at SurfaceMeshFile. Coordinates stay in the file's unit.
 *
 * Writing takes triangles only. The format is the extension's; STL and PLY are binary where the writer's
 * FileTypeIsBINARY is set, else ASCII; OBJ and OFF are text always. Coordinates are written in single precision, in
 * text with the digits that bring back the same number. The file appears whole or not at all. Point and cell data are
 * not part of these files here and are ignored.
 *
 * \sa ReadDentalMesh, WriteDentalMesh
 * \ingroup MeshOpenMesh
 */
class MeshOpenMesh_EXPORT OpenMeshMeshIO : public MeshIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(OpenMeshMeshIO);

  using Self = OpenMeshMeshIO;
  using Superclass = MeshIOBase;
  using ConstPointer = SmartPointer<const Self>;
  using Pointer = SmartPointer<Self>;

  itkNewMacro(Self);
  itkTypeMacro(OpenMeshMeshIO, MeshIOBase);

  /** True by content or, so that a broken or missing file is reported as such, by extension. */
  bool
  CanReadFile(const char * fileName) override;

  /** Reads and checks the whole file: ReadPoints() and ReadCells() only copy. */
  void
  ReadMeshInformation() override;
  void
  ReadPoints(void * buffer) override;
  void
  ReadCells(void * buffer) override;
  /** There are none. */
  void
  ReadPointData(void * buffer) override;
  void
  ReadCellData(void * buffer) override;

  /** By extension. */
  bool
  CanWriteFile(const char * fileName) override;
  void
  WriteMeshInformation() override;
  void
  WritePoints(void * buffer) override;
  void
  WriteCells(void * buffer) override;
  void
  WritePointData(void * buffer) override;
  void
  WriteCellData(void * buffer) override;
  void
  Write() override;

  /** Of the last file read: its format, its faces as the file counts them, and the triangles left out because two of
   * their corners are one point. */
  MeshFileFormatEnum
  GetFormat() const
  {
    return m_Format;
  }
  itkGetConstMacro(NumberOfFacesInFile, SizeValueType);
  itkGetConstMacro(NumberOfDegenerateFaces, SizeValueType);

  /** What ReadMeshInformation() has read, until ReadCells(); else null. */
  const SurfaceMeshFile *
  GetSurface() const
  {
    return m_Surface.get();
  }

protected:
  OpenMeshMeshIO();
  ~OpenMeshMeshIO() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  MeshFileFormatEnum               m_Format{ MeshFileFormatEnum::Unknown };
  SizeValueType                    m_NumberOfFacesInFile{ 0 };
  SizeValueType                    m_NumberOfDegenerateFaces{ 0 };
  std::unique_ptr<SurfaceMeshFile> m_Surface;
};
} // namespace itk

#endif

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
#include "itkMeshFileBytes.h"

#include "itkDentalInputError.h"
#include "itkMakeTriangleSurface.h"
#include "itkOpenMeshMeshIOFactory.h"
#include "itkReadDentalMesh.h"
#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>

#include <sys/stat.h>

namespace
{
using MeshType = itk::Mesh<float, 3>;

/** An empty folder for one test. */
class OpenMeshMeshIO : public testing::Test
{
protected:
  void
  SetUp() override
  {
    m_Folder =
      std::filesystem::path(DENTALSCR_TEST_OUTPUT_DIR) / testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(m_Folder);
    std::filesystem::create_directories(m_Folder);
  }
  void
  TearDown() override
  {
    std::filesystem::remove_all(m_Folder);
  }

  std::string
  Path(const std::string & name) const
  {
    return (m_Folder / name).string();
  }
  std::string
  Write(const std::string & name, const std::string & bytes) const
  {
    std::ofstream(this->Path(name), std::ios::binary) << bytes;
    return this->Path(name);
  }
  std::size_t
  CountFiles() const
  {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(m_Folder), {}));
  }

private:
  std::filesystem::path m_Folder;
};

/** Points of every magnitude, and three faces on one edge. */
MeshType::Pointer
MakeFan()
{
  const auto                 mesh = MeshType::New();
  const std::array<float, 3> points[] = { { 0.123456789f, 0, -1e-7f },
                                          { 12345.678f, 0, 0 },
                                          { 1, std::nextafter(1.0f, 2.0f), 0 },
                                          { 0, -1, 1e-30f },
                                          { 0, 0, 16777215.0f } };
  for (std::size_t i = 0; i < std::size(points); ++i)
  {
    MeshType::PointType point;
    std::copy(points[i].begin(), points[i].end(), point.Begin());
    mesh->SetPoint(i, point);
  }
  for (unsigned long i = 0; i < 3; ++i)
  {
    MeshType::CellAutoPointer cell;
    cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
    const MeshType::PointIdentifier ids[] = { 0, 1, 2 + i };
    cell->SetPointIds(ids);
    mesh->SetCell(i, cell);
  }
  return mesh;
}

template <typename TFunction>
std::string
ErrorOf(TFunction && function)
{
  try
  {
    function();
  }
  catch (const itk::DentalInputError & error)
  {
    return error.GetOneLine();
  }
  catch (const std::exception & error)
  {
    return std::string("other exception: ") + error.what();
  }
  return "nothing thrown";
}

MeshType::Pointer
ReadWithStockReader(const std::string & fileName)
{
  const auto reader = itk::MeshFileReader<MeshType>::New();
  reader->SetFileName(fileName);
  reader->Update();
  return reader->GetOutput();
}

int
ExerciseBasicMethods()
{
  const auto io = itk::OpenMeshMeshIO::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(io, OpenMeshMeshIO, MeshIOBase);
  const auto factory = itk::OpenMeshMeshIOFactory::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(factory, OpenMeshMeshIOFactory, ObjectFactoryBase);
  return EXIT_SUCCESS;
}

bool
StockReaderUsesOurs(const std::string & fileName)
{
  const auto reader = itk::MeshFileReader<MeshType>::New();
  reader->SetFileName(fileName);
  reader->UpdateOutputInformation();
  return dynamic_cast<itk::OpenMeshMeshIO *>(reader->GetModifiableMeshIO()) != nullptr;
}
} // namespace

TEST_F(OpenMeshMeshIO, BasicMethods)
{
  EXPECT_EQ(ExerciseBasicMethods(), EXIT_SUCCESS);
}

TEST_F(OpenMeshMeshIO, StockReaderReadsEveryFormat)
{
  itk::RegisterOpenMeshMeshIOFactories();
  const std::string files[] = {
    this->Write("binary.stl", mesh_file_bytes::BinarySTL(mesh_file_bytes::TetrahedronFacets(), "solid trap")),
    this->Write("ascii.stl", mesh_file_bytes::TetrahedronAsciiSTL()),
    this->Write("a.obj", mesh_file_bytes::TetrahedronOBJ()),
    this->Write("a.off", mesh_file_bytes::TetrahedronOFF()),
    this->Write("a.ply", mesh_file_bytes::TetrahedronPLY()),
    this->Write("b.PLY", mesh_file_bytes::TetrahedronBinaryPLY(true)),
    this->Write("no_extension", mesh_file_bytes::TetrahedronOFF())
  };
  for (const std::string & file : files)
  {
    const MeshType::Pointer    mesh = ReadWithStockReader(file);
    const itk::TriangleSurface surface = itk::MakeTriangleSurface(mesh.GetPointer());
    EXPECT_EQ(surface.points.size(), 4u) << file;
    ASSERT_EQ(surface.triangles.size(), 4u) << file;
    // The legs are 1.5, 2.25 and 3.125; outward faces enclose a positive volume.
    double volume = 0.0;
    for (std::size_t t = 0; t < 4; ++t)
    {
      const auto   normal = surface.AreaNormal(t);
      const auto & corner = surface.points[surface.triangles[t][0]];
      volume += (normal[0] * corner[0] + normal[1] * corner[1] + normal[2] * corner[2]) / 3.0;
    }
    EXPECT_NEAR(volume, 1.5 * 2.25 * 3.125 / 6.0, 1e-6) << file;
  }
}

TEST_F(OpenMeshMeshIO, StockWriterAndReaderReturnTheSameBits)
{
  itk::RegisterOpenMeshMeshIOFactories();
  const MeshType::Pointer mesh = MakeFan();
  const auto              expected = itk::MakeTriangleSurface(mesh.GetPointer());
  for (const char * name : { "a.stl", "a.ply", "a.obj", "a.off" })
  {
    for (const bool binary : { false, true })
    {
      const auto writer = itk::MeshFileWriter<MeshType>::New();
      writer->SetFileName(this->Path(name));
      writer->SetInput(mesh);
      if (binary)
      {
        writer->SetFileTypeAsBINARY();
      }
      writer->Update();
      const auto read = itk::MakeTriangleSurface(ReadWithStockReader(this->Path(name)).GetPointer());
      EXPECT_EQ(read.points, expected.points) << name << binary;
      EXPECT_EQ(read.triangles, expected.triangles) << name << binary;
    }
  }
  EXPECT_EQ(this->CountFiles(), 4u) << "a temporary file was left";
}

TEST_F(OpenMeshMeshIO, BinaryIsBinaryAndTextIsText)
{
  const MeshType::Pointer mesh = MakeFan();
  itk::WriteDentalMesh(mesh.GetPointer(), this->Path("a.stl"));
  EXPECT_EQ(std::filesystem::file_size(this->Path("a.stl")), 84u + 3u * 50u);
  const auto io = itk::OpenMeshMeshIO::New();
  io->SetFileName(this->Path("a.stl"));
  io->ReadMeshInformation();
  EXPECT_EQ(io->GetFormat(), itk::MeshFileFormatEnum::BinarySTL);
  const auto writer = itk::MeshFileWriter<MeshType>::New();
  writer->SetMeshIO(itk::OpenMeshMeshIO::New());
  writer->SetFileName(this->Path("a.stl"));
  writer->SetInput(mesh);
  writer->Update();
  io->ReadMeshInformation();
  EXPECT_EQ(io->GetFormat(), itk::MeshFileFormatEnum::AsciiSTL);
}

TEST_F(OpenMeshMeshIO, WritesTheSameUnderAnotherLocaleAndPrintsNothing)
{
  struct CommaPunctuation : public std::numpunct<char>
  {
    char
    do_decimal_point() const override
    {
      return ',';
    }
  };
  const MeshType::Pointer mesh = MakeFan();
  const auto              expected = itk::MakeTriangleSurface(mesh.GetPointer());
  const std::locale       before = std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation));
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  for (const char * name : { "a.stl", "a.ply", "a.obj", "a.off" })
  {
    const auto writer = itk::MeshFileWriter<MeshType>::New();
    writer->SetMeshIO(itk::OpenMeshMeshIO::New());
    writer->SetFileName(this->Path(name));
    writer->SetInput(mesh);
    writer->Update();
    EXPECT_EQ(itk::MakeTriangleSurface(itk::ReadDentalMesh<MeshType>(this->Path(name)).GetPointer()).points,
              expected.points)
      << name;
  }
  std::locale::global(before);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(OpenMeshMeshIO, DoubleCoordinatesKeepTheDigitsOfText)
{
  using Traits = itk::DefaultStaticMeshTraits<double, 3, 3, double>;
  using DoubleMesh = itk::Mesh<double, 3, Traits>;
  const auto mesh =
    itk::ReadDentalMesh<DoubleMesh>(this->Write("a.obj", "v 0.1234567890123 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_EQ(mesh->GetPoint(0)[0], 0.1234567890123);
}

TEST_F(OpenMeshMeshIO, ReportsFacesLeftOut)
{
  const auto io = itk::OpenMeshMeshIO::New();
  io->SetFileName(this->Write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n"));
  io->ReadMeshInformation();
  EXPECT_EQ(io->GetNumberOfFacesInFile(), 2u);
  EXPECT_EQ(io->GetNumberOfDegenerateFaces(), 1u);
  EXPECT_EQ(io->GetNumberOfCells(), 1u);
}

TEST_F(OpenMeshMeshIO, OneLineWithTheFilesNameThroughTheStockReaderToo)
{
  itk::RegisterOpenMeshMeshIOFactories();
  std::string truncated = mesh_file_bytes::BinarySTL(mesh_file_bytes::TetrahedronFacets());
  truncated.resize(150);
  std::filesystem::create_directory(this->Path("folder.stl"));
  const std::pair<std::string, std::string> rows[] = {
    { this->Write("short.stl", truncated), "is truncated: 4 facets need 284 bytes, the file has 150" },
    { this->Write("empty.ply", ""), "the file is empty (0 bytes)" },
    { this->Path("folder.stl"), "this is a directory" },
    { this->Path("missing.stl"), "there is no such file" },
    { this->Path("missing/missing.obj"), "there is no such file" },
    { "/dev/null/a.off", "there is no such file" },
    { this->Write("index.obj", "v 0 0 0\nf 1 2 3\n"), "line 2: a face names point 3, the file has 1" },
    { this->Write("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "has no triangles" }
  };
  for (const auto & row : rows)
  {
    for (const std::string & message : { ErrorOf([&]() { ReadWithStockReader(row.first); }),
                                         ErrorOf([&]() { itk::ReadDentalMesh<MeshType>(row.first); }) })
    {
      EXPECT_EQ(message.find(row.first + ": " + row.second), 0u) << message;
      EXPECT_NE(message.find("; "), std::string::npos) << message << " has no remedy";
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

TEST_F(OpenMeshMeshIO, UnknownFormatIsOneLineToo)
{
  const std::string file = this->Write("a.txt", "hello");
  EXPECT_EQ(ErrorOf([&]() { itk::ReadDentalMesh<MeshType>(file); }),
            file +
              ": neither its content nor its extension is of a known mesh format; give an STL, PLY, OBJ or OFF file");
  EXPECT_NE(ErrorOf([]() { itk::ReadDentalMesh<MeshType>(""); }).find("the name is empty"), std::string::npos);
}

TEST_F(OpenMeshMeshIO, ANamedPipeIsRefusedWithoutWaiting)
{
  for (const char * name : { "pipe.stl", "pipe" })
  {
    ASSERT_EQ(::mkfifo(this->Path(name).c_str(), 0600), 0);
    EXPECT_NE(ErrorOf([&]() { itk::ReadDentalMesh<MeshType>(this->Path(name)); }).find("this is not a regular file"),
              std::string::npos);
  }
  EXPECT_FALSE(itk::OpenMeshMeshIO::New()->CanReadFile(this->Path("pipe").c_str()));
}

TEST_F(OpenMeshMeshIO, LeavesOtherFilesToOtherReaders)
{
  const auto io = itk::OpenMeshMeshIO::New();
  EXPECT_FALSE(io->CanReadFile(this->Write("a.vtk", "# vtk DataFile Version 3.0\n").c_str()));
  EXPECT_FALSE(io->CanReadFile(this->Write("empty", "").c_str()));
  EXPECT_FALSE(io->CanReadFile(this->Path("missing").c_str()));
  EXPECT_FALSE(io->CanReadFile(this->Path("").c_str()));
  EXPECT_FALSE(io->CanReadFile(""));
  EXPECT_FALSE(io->CanReadFile(nullptr));
  // Longer than what is looked at.
  std::vector<mesh_file_bytes::Facet> facets(2000, mesh_file_bytes::TetrahedronFacets()[0]);
  EXPECT_TRUE(io->CanReadFile(this->Write("scan", mesh_file_bytes::BinarySTL(facets)).c_str()));
}

TEST_F(OpenMeshMeshIO, AFailedReadLeavesTheReaderUsable)
{
  const auto reader = itk::MeshFileReader<MeshType>::New();
  reader->SetMeshIO(itk::OpenMeshMeshIO::New());
  reader->SetFileName(this->Path("missing.stl"));
  EXPECT_THROW(reader->Update(), itk::DentalInputError);
  reader->SetFileName(this->Write("a.off", mesh_file_bytes::TetrahedronOFF()));
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 4u);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 4u);
}

TEST_F(OpenMeshMeshIO, RefusesToWriteWhatCannotBeReadBack)
{
  const MeshType::Pointer mesh = MakeFan();
  EXPECT_NE(ErrorOf([&]() { itk::WriteDentalMesh(mesh.GetPointer(), this->Path("a.vtk")); }).find("extension"),
            std::string::npos);
  EXPECT_NE(ErrorOf([&]() {
              itk::WriteDentalMesh(mesh.GetPointer(), this->Path("missing/a.stl"));
            }).find("a.stl: cannot be written: No such file or directory; name a file in an existing folder"),
            std::string::npos);
  std::filesystem::create_directory(this->Path("b.stl"));
  EXPECT_NE(ErrorOf([&]() { itk::WriteDentalMesh(mesh.GetPointer(), this->Path("b.stl")); }).find("is a directory"),
            std::string::npos);
  const auto empty = MeshType::New();
  EXPECT_NE(ErrorOf([&]() { itk::WriteDentalMesh(empty.GetPointer(), this->Path("a.stl")); }).find("has no triangles"),
            std::string::npos);
  MeshType::PointType point;
  point.Fill(std::numeric_limits<float>::quiet_NaN());
  mesh->SetPoint(2, point);
  EXPECT_NE(
    ErrorOf([&]() { itk::WriteDentalMesh(mesh.GetPointer(), this->Path("a.stl")); }).find("Point 2 of the mesh"),
    std::string::npos);
  const MeshType::Pointer   lines = MakeFan();
  MeshType::CellAutoPointer cell;
  cell.TakeOwnership(new itk::LineCell<MeshType::CellType>);
  lines->SetCell(3, cell);
  EXPECT_NE(ErrorOf([&]() { itk::WriteDentalMesh(lines.GetPointer(), this->Path("a.stl")); }).find("triangulate"),
            std::string::npos);
  const MeshType::Pointer broken = MakeFan();
  cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
  const MeshType::PointIdentifier ids[] = { 0, 1, 77 };
  cell->SetPointIds(ids);
  broken->SetCell(3, cell);
  EXPECT_NE(ErrorOf([&]() { itk::WriteDentalMesh(broken.GetPointer(), this->Path("a.stl")); }).find("triangulate"),
            std::string::npos);
  EXPECT_EQ(this->CountFiles(), 1u) << "something was left half-written";
}

TEST_F(OpenMeshMeshIO, RegistrationComesFirstAndOnlyOnce)
{
  itk::RegisterOpenMeshMeshIOFactories();
  const std::size_t count = itk::ObjectFactoryBase::GetRegisteredFactories().size();
  itk::RegisterOpenMeshMeshIOFactories();
  itk::OpenMeshMeshIOFactory::RegisterOneFactory();
  EXPECT_EQ(itk::ObjectFactoryBase::GetRegisteredFactories().size(), count);
  EXPECT_TRUE(StockReaderUsesOurs(this->Write("a.obj", mesh_file_bytes::TetrahedronOBJ())));
}

#if defined(DENTALSCR_MESH_OPENMESH_LIBRARY)
TEST_F(OpenMeshMeshIO, LoadsFromTheAutoloadPath)
{
  const std::string file = this->Write("a.off", mesh_file_bytes::TetrahedronOFF());
  std::filesystem::create_directory(this->Path("plugins"));
  std::filesystem::create_symlink(DENTALSCR_MESH_OPENMESH_LIBRARY, this->Path("plugins/libMeshOpenMesh.so"));
  ASSERT_EQ(::setenv("ITK_AUTOLOAD_PATH", this->Path("plugins").c_str(), 1), 0);
  itk::ObjectFactoryBase::ReHash();
  EXPECT_TRUE(StockReaderUsesOurs(file));
  // In front of ITK's own readers.
  EXPECT_NE(dynamic_cast<itk::OpenMeshMeshIOFactory *>(itk::ObjectFactoryBase::GetRegisteredFactories().front()),
            nullptr);
  ASSERT_EQ(::unsetenv("ITK_AUTOLOAD_PATH"), 0);
}
#endif

TEST_F(OpenMeshMeshIO, ReadsTheSharedScans)
{
  const std::string cases = std::string(DENTALSCR_SHARED_DIR) + "/cases/";
  if (!std::filesystem::exists(cases))
  {
    GTEST_SKIP() << "the shared cases are not here: " << cases;
  }
  const auto cast = itk::MakeTriangleSurface(itk::ReadDentalMesh<MeshType>(cases + "casts/upper.obj").GetPointer());
  // A jaw of 30 to 120 mm, in metres.
  double low = 1e9;
  double high = -1e9;
  for (const auto & point : cast.points)
  {
    low = std::min(low, point[0]);
    high = std::max(high, point[0]);
  }
  EXPECT_GT(high - low, 0.03);
  EXPECT_LT(high - low, 0.12);
  const auto phantom =
    itk::MakeTriangleSurface(itk::ReadDentalMesh<MeshType>(cases + "phantom-ideal-1/upper.stl").GetPointer());
  // Welded: about half as many points as triangles.
  EXPECT_LT(phantom.points.size(), 0.6 * static_cast<double>(phantom.triangles.size()));
}

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
#include "itkRegistrationSceneWindow.h"
#include "itkMessageOfCall.h"

#include "itkSceneTestCase.h"
#include "itkSceneToVTK.h"
#include "itkVirtualScreen.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include "gtest/gtest.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

using namespace SceneTestCase;

namespace
{
namespace fs = std::filesystem;

class RegistrationSceneWindowTest : public ::testing::Test
{
protected:
  void
  SetUp() override
  {
    m_Folder =
      fs::path(DENTALSCR_TEST_OUTPUT_DIR) / "scene" / ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(m_Folder);
    fs::create_directories(m_Folder);
    m_Source = MakeScene();
    m_Source->Update();
    m_Window = itk::RegistrationSceneWindow::New();
    m_Window->SetScene(m_Source->GetOutput());
  }

  std::string
  NameOf(const char * file) const
  {
    return (m_Folder / file).string();
  }

  std::size_t
  CountFiles() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_Folder), fs::directory_iterator()));
  }

  fs::path                              m_Folder;
  itk::RegistrationSceneSource::Pointer m_Source;
  itk::RegistrationSceneWindow::Pointer m_Window;
};

std::string
ReadAll(const std::string & fileName)
{
  std::ifstream      file(fileName, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}
} // namespace

TEST_F(RegistrationSceneWindowTest, ExportsEveryPartAsABlockOfItsName)
{
  m_Window->WriteExport(NameOf("scene.vtm"));
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName(NameOf("scene.vtm").c_str());
  reader->Update();
  auto * const blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
  const auto & parts = m_Source->GetOutput()->GetParts();
  // One radiograph beside the parts.
  ASSERT_EQ(blocks->GetNumberOfBlocks(), parts.size() + 1);
  std::size_t number = 0;
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    const std::string name = blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME());
    if (name == "lateral radiograph")
    {
      EXPECT_EQ(parts[number - 1].name, "lateral detector");
      continue;
    }
    EXPECT_EQ(name, parts[number].name);
    auto * const polyData = vtkPolyData::SafeDownCast(blocks->GetBlock(i));
    ASSERT_NE(polyData, nullptr) << name;
    ASSERT_EQ(static_cast<std::size_t>(polyData->GetNumberOfPoints()), parts[number].mesh->GetNumberOfPoints()) << name;
    EXPECT_EQ(static_cast<std::size_t>(polyData->GetNumberOfCells()), parts[number].mesh->GetNumberOfCells()) << name;
    const auto last = parts[number].mesh->GetNumberOfPoints() - 1;
    for (unsigned int d = 0; d < 3; ++d)
    {
      EXPECT_EQ(polyData->GetPoint(static_cast<vtkIdType>(last))[d], parts[number].mesh->GetPoint(last)[d]) << name;
    }
    EXPECT_EQ(polyData->GetFieldData()->GetArray("Color")->GetComponent(0, 1), parts[number].color[1]);
    ++number;
  }
}

TEST_F(RegistrationSceneWindowTest, PutsTheRadiographsPixelsOnTheirRays)
{
  const auto & part = *m_Source->GetOutput()->FindPart("lateral detector");
  const auto & detector = *m_Source->GetOutput()->FindDetector("lateral");
  const auto   image = itk::ScenePictureToVTK(part);
  ASSERT_NE(image, nullptr);
  int                           ids[3] = { 417, 123, 0 };
  itk::SceneDetector::PointType point;
  image->TransformIndexToPhysicalPoint(ids, point.GetDataPointer());
  EXPECT_NEAR(detector.GetPixel(point)[0], 417.0, 1e-3);
  EXPECT_NEAR(detector.GetPixel(point)[1], 123.0, 1e-3);
  EXPECT_EQ(image->GetScalarComponentAsDouble(417, 123, 0, 0), part.picture->GetPixel({ { 417, 123 } }));
}

TEST_F(RegistrationSceneWindowTest, ExportsOneSurfaceWithColoursAndNamesOfParts)
{
  m_Window->WriteExport(NameOf("scene.vtp"));
  EXPECT_EQ(CountFiles(), 1u);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(NameOf("scene.vtp").c_str());
  reader->Update();
  vtkPolyData * const whole = reader->GetOutput();
  auto * const        names = vtkStringArray::SafeDownCast(whole->GetFieldData()->GetAbstractArray("PartNames"));
  ASSERT_NE(names, nullptr);
  const auto & parts = m_Source->GetOutput()->GetParts();
  ASSERT_EQ(static_cast<std::size_t>(names->GetNumberOfValues()), parts.size());
  EXPECT_EQ(names->GetValue(0), "upper scan");
  vtkDataArray * const colors = whole->GetPointData()->GetArray("Color");
  ASSERT_NE(colors, nullptr);
  EXPECT_EQ(colors->GetNumberOfTuples(), whole->GetNumberOfPoints());
  EXPECT_EQ(colors->GetComponent(0, 0), std::round(255.0 * parts[0].color[0]));
  vtkDataArray * const numbers = whole->GetCellData()->GetArray("Part");
  ASSERT_NE(numbers, nullptr);
  EXPECT_EQ(numbers->GetRange()[1], static_cast<double>(parts.size() - 1));
  // The radiograph is in the colours: from black to white.
  double       darkest = 255.0;
  double       brightest = 0.0;
  const auto & detector = *m_Source->GetOutput()->FindDetector("lateral");
  const auto & picture = *m_Source->GetOutput()->FindPart("lateral detector")->picture;
  const auto   size = picture.GetBufferedRegion().GetSize();
  unsigned int count = 0;
  unsigned int inPlace = 0;
  for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i)
  {
    itk::SceneDetector::PointType point;
    whole->GetPoint(i, point.GetDataPointer());
    const double grey = colors->GetComponent(i, 0);
    if (std::abs((point - detector.GetSource()) * detector.GetAxis() - SourceToDetector) < 1e-3 &&
        grey == colors->GetComponent(i, 2))
    {
      darkest = std::min(darkest, grey);
      brightest = std::max(brightest, grey);
      // Where it lies it has the grey of the radiograph; between two pixels that of either.
      const auto pixel = detector.GetPixel(point);
      const auto has = [&](double shift) {
        itk::Index<2> index;
        for (unsigned int d = 0; d < 2; ++d)
        {
          index[d] = std::clamp<itk::IndexValueType>(std::lround(pixel[d] + shift), 0, size[d] - 1);
        }
        return picture.GetPixel(index) == grey;
      };
      ++count;
      inPlace += has(1e-3) || has(-1e-3) ? 1 : 0;
    }
  }
  EXPECT_GT(count, 100u);
  // What is drawn on the detector may be grey as well.
  EXPECT_GT(inPlace, 0.9 * count);
  EXPECT_LT(darkest, 5.0);
  EXPECT_GT(brightest, 250.0);
}

TEST_F(RegistrationSceneWindowTest, ExportsGLTFWithEverythingInOneFile)
{
  m_Window->WriteExport(NameOf("scene.gltf"));
  EXPECT_EQ(CountFiles(), 1u);
  const std::string text = ReadAll(NameOf("scene.gltf"));
  EXPECT_NE(text.find("data:application/octet-stream;base64,"), std::string::npos);
  EXPECT_NE(text.find("image/png"), std::string::npos);
  EXPECT_EQ(text.find(".bin\""), std::string::npos);
  EXPECT_EQ(text.find(".png\""), std::string::npos);
  EXPECT_NE(text.find("\"frontal upper silhouette\""), std::string::npos);
}

TEST_F(RegistrationSceneWindowTest, RefusesNamesOfOtherFormatsAndFoldersThatAreNotThere)
{
  const auto message = [&](const std::string & name) {
    return itk::MessageOfCall([&] { m_Window->WriteExport(name); });
  };
  EXPECT_NE(message(NameOf("scene.glb")).find("Name it .gltf"), std::string::npos);
  EXPECT_NE(message(NameOf("scene.obj")).find("\".obj\""), std::string::npos);
  EXPECT_NE(message(NameOf("nowhere/scene.vtp")).find("nowhere/scene.vtp: cannot be written"), std::string::npos);
  EXPECT_THROW(m_Window->WriteSnapshot(NameOf("scene.jpg")), itk::ExceptionObject);
  EXPECT_EQ(CountFiles(), 0u);
}

TEST_F(RegistrationSceneWindowTest, ReplacesWhatItExportedBefore)
{
  m_Window->WriteExport(NameOf("scene.vtm"));
  std::ofstream(NameOf("scene/scene_99.vtp")) << "of an earlier one";
  m_Window->WriteExport(NameOf("scene.vtm"));
  EXPECT_FALSE(fs::exists(NameOf("scene/scene_99.vtp")));
  EXPECT_EQ(CountFiles(), 2u);
}

TEST_F(RegistrationSceneWindowTest, KeepsAFolderThatHoldsSomethingElse)
{
  m_Window->WriteExport(NameOf("scene.vtm"));
  std::ofstream(NameOf("scene/notes.txt")) << "of the user's";
  EXPECT_THROW(m_Window->WriteExport(NameOf("scene.vtm")), itk::ExceptionObject);
  EXPECT_TRUE(fs::exists(NameOf("scene/notes.txt")));
}

TEST_F(RegistrationSceneWindowTest, LeavesNothingOfAnExportThatFailed)
{
  // The blocks are there when the file turns out to be a folder.
  fs::create_directory(NameOf("scene.vtm"));
  EXPECT_THROW(m_Window->WriteExport(NameOf("scene.vtm")), itk::ExceptionObject);
  EXPECT_FALSE(fs::exists(NameOf("scene")));
  EXPECT_EQ(CountFiles(), 1u);
  // Blocks of an earlier export are put back.
  fs::remove(NameOf("scene.vtm"));
  m_Window->WriteExport(NameOf("scene.vtm"));
  std::ofstream(NameOf("scene/scene_99.vtp")) << "of an earlier one";
  fs::remove(NameOf("scene.vtm"));
  fs::create_directory(NameOf("scene.vtm"));
  EXPECT_THROW(m_Window->WriteExport(NameOf("scene.vtm")), itk::ExceptionObject);
  EXPECT_TRUE(fs::exists(NameOf("scene/scene_99.vtp")));
  EXPECT_EQ(CountFiles(), 2u);
}

TEST_F(RegistrationSceneWindowTest, AnyNameOfAnExportMayBeReplaced)
{
  // Also one that earlier blocks might be kept under meanwhile.
  for (const char * name : { "old.vtm", "old.vtm", "scene.old.vtm", "scene.old.vtm" })
  {
    EXPECT_NO_THROW(m_Window->WriteExport(NameOf(name))) << name;
  }
  EXPECT_TRUE(fs::exists(NameOf("old")));
  EXPECT_TRUE(fs::exists(NameOf("scene.old")));
}

TEST_F(RegistrationSceneWindowTest, SaysThatThereIsNoScreen)
{
  const char * const old = std::getenv("DISPLAY");
  const std::string  kept = old == nullptr ? "" : old;
  unsetenv("DISPLAY");
  EXPECT_THROW(m_Window->WriteSnapshot(NameOf("scene.png")), itk::ExceptionObject);
  EXPECT_THROW(m_Window->Show(), itk::ExceptionObject);
  if (old != nullptr)
  {
    setenv("DISPLAY", kept.c_str(), 1);
  }
}

TEST_F(RegistrationSceneWindowTest, ListsCamerasAndRefusesOthers)
{
  const std::vector<std::string> cameras = m_Window->GetCameras();
  EXPECT_EQ(
    cameras,
    (std::vector<std::string>{ "overview", "front", "side", "above", "all", "source", "teeth", "lateral", "frontal" }));
  m_Window->SetCamera("behind");
  try
  {
    m_Window->WriteSnapshot(NameOf("scene.png"));
    FAIL() << "it was drawn";
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("overview, front"), std::string::npos);
  }
}

TEST_F(RegistrationSceneWindowTest, SeesTheDetectorUprightFromTheSource)
{
  if (itk::VirtualScreen::FindProgram().empty())
  {
    GTEST_SKIP() << "Xvfb is not installed";
  }
  const itk::VirtualScreen                     screen(700, 500);
  const itk::RegistrationSceneWindow::SizeType size{ { 700, 500 } };
  m_Window->SetSize(size);
  m_Window->SetCamera("source");
  m_Window->ShowLegendOff();
  m_Window->WriteSnapshot(NameOf("source.png"));
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(NameOf("source.png").c_str());
  reader->Update();
  vtkImageData * const picture = reader->GetOutput();
  ASSERT_EQ(picture->GetDimensions()[0], 700);
  ASSERT_EQ(picture->GetDimensions()[1], 500);
  // The radiograph fills the picture but for a margin of 4 %, so that its pixel is nearly the picture's: far left and
  // far right of the scans it shows its ramp. VTK counts rows from below.
  const auto grey = [&](int u, int v) { return picture->GetScalarComponentAsDouble(u, 499 - v, 0, 0); };
  EXPECT_LT(grey(60, 30), 40.0);
  EXPECT_GT(grey(60, 470), 170.0);
  EXPECT_GT(grey(640, 470), grey(60, 470) + 15.0);
  // The tracing's middle, pixel (420, 385), is seen where it was drawn: blue against grey.
  double bluest = 0.0;
  for (int u = -4; u <= 4; ++u)
  {
    for (int v = -4; v <= 4; ++v)
    {
      const int column = static_cast<int>(std::lround(349.5 + (420.0 - 349.5) / 1.04)) + u;
      const int row = 499 - (static_cast<int>(std::lround(249.5 + (385.0 - 249.5) / 1.04)) + v);
      bluest = std::max(bluest,
                        picture->GetScalarComponentAsDouble(column, row, 0, 2) -
                          picture->GetScalarComponentAsDouble(column, row, 0, 0));
    }
  }
  EXPECT_GT(bluest, 50.0);
}

TEST_F(RegistrationSceneWindowTest, DrawsEveryCamera)
{
  if (itk::VirtualScreen::FindProgram().empty())
  {
    GTEST_SKIP() << "Xvfb is not installed";
  }
  const itk::VirtualScreen                     screen(200, 150);
  const itk::RegistrationSceneWindow::SizeType size{ { 200, 150 } };
  m_Window->SetSize(size);
  for (const std::string & camera : m_Window->GetCameras())
  {
    m_Window->SetCamera(camera);
    const std::string name = NameOf((camera + ".png").c_str());
    m_Window->WriteSnapshot(name);
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(name.c_str());
    reader->Update();
    // Something is drawn on the grey background.
    double most = 0.0;
    for (int u = 0; u < 200; ++u)
    {
      for (int v = 0; v < 150; ++v)
      {
        most = std::max(most, std::abs(reader->GetOutput()->GetScalarComponentAsDouble(u, v, 0, 0) - 70.0));
      }
    }
    EXPECT_GT(most, 60.0) << camera;
  }
}

TEST(RegistrationSceneWindow, DefaultsAreThoseOfTheDocumentation)
{
  const auto window = itk::RegistrationSceneWindow::New();
  EXPECT_STREQ(window->GetCamera(), "overview");
  EXPECT_EQ(window->GetSize()[0], 1200u);
  EXPECT_EQ(window->GetSize()[1], 900u);
  EXPECT_TRUE(window->GetShowLegend());
  EXPECT_THROW(window->WriteExport("scene.vtp"), itk::ExceptionObject);
}

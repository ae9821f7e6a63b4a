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
// Scans with tooth labels, from the files to the result.
#include "itkCaseRegistration.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalContourFileWriter.h"
#include "itkDentalPhantomCaseSource.h"
#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace
{
using JawEnum = itk::ToothCode::JawEnum;
using itk::Contains;
using itk::ExpectInputError;

itk::DentalPhantomCaseSource *
Phantom()
{
  static const auto source = [] {
    auto s = itk::DentalPhantomCaseSource::New();
    s->SetSeed(11);
    s->SetNumberOfTriangles(12000);
    s->MakeRadiographOff();
    s->Update();
    return s;
  }();
  return source;
}

/** A jaw as a legacy VTK file, with universal numbers where wanted. */
std::string
WriteVTK(unsigned int jaw, bool labels)
{
  const auto *       mesh = Phantom()->GetMesh(jaw);
  std::ostringstream text;
  text << "# vtk DataFile Version 4.2\nscan\nASCII\nDATASET POLYDATA\nPOINTS " << mesh->GetNumberOfPoints()
       << " float\n";
  text.precision(9);
  for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
  {
    text << it.Value()[0] << ' ' << it.Value()[1] << ' ' << it.Value()[2] << '\n';
  }
  text << "POLYGONS " << mesh->GetNumberOfCells() << ' ' << 4 * mesh->GetNumberOfCells() << '\n';
  for (auto it = mesh->GetCells()->Begin(); it != mesh->GetCells()->End(); ++it)
  {
    const auto * ids = it.Value()->GetPointIds();
    text << "3 " << ids[0] << ' ' << ids[1] << ' ' << ids[2] << '\n';
  }
  if (labels)
  {
    text << "POINT_DATA " << mesh->GetNumberOfPoints() << "\nSCALARS Universal_ID int 1\nLOOKUP_TABLE default\n";
    for (auto it = mesh->GetPointData()->Begin(); it != mesh->GetPointData()->End(); ++it)
    {
      const auto fdi = static_cast<unsigned int>(it.Value());
      text << (fdi == 0 ? 33u : itk::ToothCode(fdi).GetUniversal()) << '\n';
    }
  }
  return itk::WriteTestFile(jaw == 0 ? "upper.vtk" : "lower.vtk", text.str());
}

std::string
WriteCase(const std::string & more, bool labels)
{
  WriteVTK(0, labels);
  WriteVTK(1, labels);
  auto writer = itk::DentalContourFileWriter::New();
  writer->SetUpper(Phantom()->GetTracing(0));
  writer->SetLower(Phantom()->GetTracing(1));
  itk::Size<2> size;
  size[0] = 703;
  size[1] = 938;
  writer->SetImageSize(size);
  writer->SetFileName(itk::TestFolder() + "/contours.json");
  writer->Update();
  const auto *       geometry = Phantom()->GetNominalGeometry();
  std::ostringstream text;
  text.precision(17);
  text
    << R"({"upper": "upper.vtk", "lower": "lower.vtk", "contours": "contours.json", "cephalogram": {"pixel_spacing_mm": [)"
    << geometry->GetPixelSpacing()[0] << ", " << geometry->GetPixelSpacing()[1]
    << R"(]}, "geometry": {"source_to_midsagittal_mm": )" << geometry->GetSourceToMidsagittalDistance()
    << R"(, "source_to_detector_mm": )" << geometry->GetSourceToDetectorDistance() << R"(, "principal_point_px": [)"
    << geometry->GetPrincipalPoint()[0] << ", " << geometry->GetPrincipalPoint()[1] << "]}" << more << "}";
  return itk::WriteTestFile("case.json", text.str());
}

/** Mean distance of the landmarks of the right side to their true places, pixels. */
double
Error(const itk::CaseResult & result, JawEnum jaw)
{
  const unsigned int index = jaw == JawEnum::Upper ? 0 : 1;
  const auto &       p = result.jaws.at(jaw).projection;
  double             sum = 0.0;
  double             count = 0.0;
  for (const auto & landmark : Phantom()->GetLandmarks2D(index)->GetLandmarks())
  {
    const auto   x = Phantom()->GetLandmarks3D(index)->Find(landmark.name)->point;
    const double w = p[8] * x[0] + p[9] * x[1] + p[10] * x[2] + p[11];
    sum += std::hypot((p[0] * x[0] + p[1] * x[1] + p[2] * x[2] + p[3]) / w - landmark.point[0],
                      (p[4] * x[0] + p[5] * x[1] + p[6] * x[2] + p[7]) / w - landmark.point[1]);
    count += 1.0;
  }
  return sum / count;
}

TEST(CaseCrowns, AreRegisteredByLabelsAndByShapeAsWellAsTheWholeSide)
{
  for (const char * crowns : { "off", "labels", "shape" })
  {
    const auto data =
      itk::LoadDentalCase(itk::ReadDentalCase(WriteCase(std::string(R"(, "crowns": ")") + crowns + '"', true)));
    EXPECT_EQ(data->upper.mesh->GetNumberOfPoints(), Phantom()->GetMesh(0)->GetNumberOfPoints());
    EXPECT_EQ(data->upper.labels.empty(), std::string(crowns) != "labels");
    auto registration = itk::CaseRegistration::New();
    registration->SetPreset(itk::CasePresetEnum::Robust);
    registration->SetData(data);
    registration->Update();
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      // As the other tests of a typical case on a coarse mesh.
      EXPECT_LT(Error(registration->GetResult(), jaw), 3.0) << crowns;
    }
  }
}

TEST(CaseCrowns, LabelsFDINumbersByPoint)
{
  const auto data = itk::LoadDentalCase(itk::ReadDentalCase(WriteCase(R"(, "crowns": "labels")", true)));
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const auto * labels = Phantom()->GetMesh(jaw == JawEnum::Upper ? 0 : 1)->GetPointData();
    ASSERT_EQ(data->GetJaw(jaw).labels.size(), labels->Size());
    for (auto it = labels->Begin(); it != labels->End(); ++it)
    {
      ASSERT_EQ(data->GetJaw(jaw).labels[it.Index()], static_cast<std::uint8_t>(it.Value()));
    }
  }
}

TEST(CaseCrowns, SayWhatIsMissingOrExchanged)
{
  const auto refusal = [](const std::string & more, bool labels) {
    const std::string file = WriteCase(more, labels);
    return ExpectInputError([&]() { itk::LoadDentalCase(itk::ReadDentalCase(file)); }).GetOneLine();
  };
  EXPECT_TRUE(Contains(refusal(R"(, "crowns": "labels")", false), "upper.vtk: has no tooth labels"));
  itk::WriteTestFile("short.json", R"({"jaw": "upper", "labels": [0, 11]})");
  EXPECT_TRUE(Contains(refusal(R"(, "upper_labels": "short.json")", false), "2 labels"));
  EXPECT_TRUE(Contains(refusal(R"(, "upper_labels": "lower.vtk")", true), "lower.vtk"));
}
} // namespace

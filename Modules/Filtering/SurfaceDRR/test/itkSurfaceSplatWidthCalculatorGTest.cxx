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
#include "itkSurfaceSplatWidthCalculator.h"
#include "itkMessageOfCall.h"

#include "itkTriangleCell.h"

#include <gtest/gtest.h>

#include <string>

namespace
{
using CalculatorType = itk::SurfaceSplatWidthCalculator;
using MeshType = CalculatorType::MeshType;

/** A square of 10 mm in cells of a millimetre: 121 vertices, 100 square mm. */
MeshType::Pointer
MakeSquare()
{
  auto               mesh = MeshType::New();
  const unsigned int n = 10;
  for (unsigned int i = 0; i <= n; ++i)
  {
    for (unsigned int j = 0; j <= n; ++j)
    {
      MeshType::PointType point;
      point[0] = static_cast<float>(i);
      point[1] = 0.0F;
      point[2] = static_cast<float>(j);
      mesh->SetPoint((n + 1) * i + j, point);
    }
  }
  MeshType::CellIdentifier id = 0;
  for (unsigned int i = 0; i < n; ++i)
  {
    for (unsigned int j = 0; j < n; ++j)
    {
      const itk::IdentifierType corner = (n + 1) * i + j;
      const itk::IdentifierType triangles[2][3] = { { corner, corner + 1, corner + n + 1 },
                                                    { corner + 1, corner + n + 2, corner + n + 1 } };
      for (const auto & triangle : triangles)
      {
        MeshType::CellAutoPointer cell;
        cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
        cell->SetPointIds(triangle);
        mesh->SetCell(id++, cell);
      }
    }
  }
  return mesh;
}

itk::CephalometricGeometry::Pointer
MakeGeometry(double spacing)
{
  auto geometry = itk::CephalometricGeometry::New();
  geometry->SetPixelSpacing(itk::CephalometricGeometry::PixelSpacingType(spacing));
  geometry->SetSourceToMidsagittalDistance(1000.0);
  geometry->SetSourceToDetectorDistance(1200.0);
  return geometry;
}

double
SigmaAt(double spacing, double factor = 0.7)
{
  auto calculator = CalculatorType::New();
  calculator->SetMesh(MakeSquare());
  calculator->SetGeometry(MakeGeometry(spacing));
  calculator->SetWidthFactor(factor);
  calculator->Update();
  return calculator->GetSigma();
}
} // namespace

TEST(SurfaceSplatWidthCalculator, IsTheMagnifiedDistanceBetweenVertices)
{
  // sqrt(100 / 121) = 10 / 11 mm between vertices, 1.2 times magnified.
  EXPECT_NEAR(SigmaAt(0.1), 0.7 * 1.2 * 10.0 / 11.0, 1e-6);
  EXPECT_NEAR(SigmaAt(0.1, 1.4), 2.0 * SigmaAt(0.1), 1e-12);
}

TEST(SurfaceSplatWidthCalculator, IsNeverFinerThanAPixel)
{
  EXPECT_EQ(SigmaAt(2.0), 2.0);
}

TEST(SurfaceSplatWidthCalculator, SaysWhatIsMissing)
{
  const auto message = [](CalculatorType * calculator) { return itk::MessageOfCall([&] { calculator->Update(); }); };
  auto       calculator = CalculatorType::New();
  EXPECT_NE(message(calculator).find("SetMesh()"), std::string::npos);
  calculator->SetMesh(MeshType::New());
  EXPECT_NE(message(calculator).find("SetGeometry()"), std::string::npos);
  calculator->SetGeometry(itk::CephalometricGeometry::New());
  EXPECT_NE(message(calculator).find("SetPixelSpacing()"), std::string::npos);
  calculator->SetGeometry(MakeGeometry(0.25));
  EXPECT_NE(message(calculator).find("no points"), std::string::npos);
  calculator->SetMesh(MakeSquare());
  calculator->SetWidthFactor(0.0);
  EXPECT_NE(message(calculator).find("SetWidthFactor()"), std::string::npos);
}

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
#include "itkSceneToVTK.h"

#include "itkMeshToVTKPolyDataFilter.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using VectorType = Vector<double, 3>;

/** Where the picture of a detector begins, and its whole width and height as vectors; blocks at its edge may reach
 * beyond the detector. */
struct PictureFrame
{
  Point<double, 3> corner;
  VectorType       width;
  VectorType       height;

  explicit PictureFrame(const ScenePart & part)
  {
    std::array<Point<double, 3>, 4> corners;
    for (unsigned int i = 0; i < 4; ++i)
    {
      corners[i].CastFrom(part.mesh->GetPoint(i));
    }
    corner = corners[0];
    width = (corners[1] - corners[0]) / static_cast<double>(part.pictureCoordinates[2][0]);
    height = (corners[3] - corners[0]) / static_cast<double>(part.pictureCoordinates[2][1]);
  }
};

unsigned char
ToByte(double share)
{
  return static_cast<unsigned char>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

/** A grid of squares over the picture with its grey as their points' colours. */
vtkSmartPointer<vtkPolyData>
MakePictureGrid(const ScenePart & part, unsigned int largest, vtkUnsignedCharArray * colors)
{
  const auto         size = part.picture->GetBufferedRegion().GetSize();
  const std::size_t  longest = std::max(size[0], size[1]);
  const std::size_t  step = (longest + largest - 1) / largest;
  const PictureFrame frame(part);
  const auto &       end = part.pictureCoordinates[2];
  // Points at the middles of blocks, and the outermost at the detector's edge.
  const auto places = [&](unsigned int axis) {
    std::vector<double> shares;
    const std::size_t   blocks = (size[axis] + step - 1) / step;
    for (std::size_t block = 0; block < blocks; ++block)
    {
      const double middle =
        (static_cast<double>(block) + 0.5) * static_cast<double>(step) / static_cast<double>(size[axis]);
      shares.push_back(block == 0 ? 0.0 : block + 1 == blocks ? end[axis] : std::min<double>(middle, end[axis]));
    }
    if (blocks == 1)
    {
      shares.push_back(end[axis]);
    }
    return shares;
  };
  const auto            us = places(0);
  const auto            vs = places(1);
  vtkNew<vtkPoints>     points;
  vtkNew<vtkCellArray>  squares;
  const unsigned char * pixels = part.picture->GetBufferPointer();
  for (const double v : vs)
  {
    for (const double u : us)
    {
      const Point<double, 3> point = frame.corner + frame.width * u + frame.height * v;
      points->InsertNextPoint(point.GetDataPointer());
      const auto column =
        std::min<std::size_t>(static_cast<std::size_t>(u * static_cast<double>(size[0])), size[0] - 1);
      const auto row = std::min<std::size_t>(static_cast<std::size_t>(v * static_cast<double>(size[1])), size[1] - 1);
      const unsigned char grey = pixels[row * size[0] + column];
      for (unsigned int i = 0; i < 3; ++i)
      {
        colors->InsertNextValue(grey);
      }
    }
  }
  const auto columns = static_cast<vtkIdType>(us.size());
  for (vtkIdType row = 0; row + 1 < static_cast<vtkIdType>(vs.size()); ++row)
  {
    for (vtkIdType column = 0; column + 1 < columns; ++column)
    {
      const vtkIdType first = row * columns + column;
      const vtkIdType corners[] = { first, first + 1, first + columns + 1, first + columns };
      squares->InsertNextCell(4, corners);
    }
  }
  auto grid = vtkSmartPointer<vtkPolyData>::New();
  grid->SetPoints(points);
  grid->SetPolys(squares);
  return grid;
}
} // namespace

vtkSmartPointer<vtkPolyData>
ScenePartToVTK(const ScenePart & part)
{
  auto convert = MeshToVTKPolyDataFilter<ScenePart::MeshType>::New();
  convert->SetInput(part.mesh);
  convert->SetPointDataName("FDI");
  convert->Update();
  vtkSmartPointer<vtkPolyData> polyData = convert->GetOutput();
  if (vtkDataArray * const teeth = polyData->GetPointData()->GetArray("FDI"))
  {
    vtkNew<vtkUnsignedCharArray> codes;
    codes->DeepCopy(teeth);
    codes->SetName("FDI");
    // Not the active scalars: these would be taken for colours.
    polyData->GetPointData()->SetActiveScalars(nullptr);
    polyData->GetPointData()->RemoveArray("FDI");
    polyData->GetPointData()->AddArray(codes);
  }
  vtkNew<vtkDoubleArray> color;
  color->SetName("Color");
  color->SetNumberOfComponents(4);
  color->InsertNextTuple4(part.color[0], part.color[1], part.color[2], part.opacity);
  polyData->GetFieldData()->AddArray(color);
  if (!part.pictureCoordinates.empty())
  {
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetName("TextureCoordinates");
    coordinates->SetNumberOfComponents(2);
    for (const auto & place : part.pictureCoordinates)
    {
      coordinates->InsertNextTuple2(place[0], 1.0F - place[1]);
    }
    polyData->GetPointData()->SetTCoords(coordinates);
  }
  return polyData;
}

vtkSmartPointer<vtkImageData>
ScenePictureToVTK(const ScenePart & part)
{
  if (part.picture.IsNull())
  {
    return nullptr;
  }
  const auto         size = part.picture->GetBufferedRegion().GetSize();
  const PictureFrame frame(part);
  VectorType         u = frame.width / static_cast<double>(size[0]);
  VectorType         v = frame.height / static_cast<double>(size[1]);
  const auto         first = frame.corner + u * 0.5 + v * 0.5;
  auto               image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(size[0]), static_cast<int>(size[1]), 1);
  image->SetOrigin(first.GetDataPointer());
  image->SetSpacing(u.GetNorm(), v.GetNorm(), 1.0);
  u.Normalize();
  v.Normalize();
  const VectorType     normal = CrossProduct(u, v);
  vtkNew<vtkMatrix3x3> direction;
  for (int row = 0; row < 3; ++row)
  {
    direction->SetElement(row, 0, u[row]);
    direction->SetElement(row, 1, v[row]);
    direction->SetElement(row, 2, normal[row]);
  }
  image->SetDirectionMatrix(direction);
  vtkNew<vtkUnsignedCharArray> pixels;
  pixels->SetName("radiograph");
  pixels->SetNumberOfTuples(static_cast<vtkIdType>(size[0] * size[1]));
  std::copy_n(part.picture->GetBufferPointer(), size[0] * size[1], pixels->GetPointer(0));
  image->GetPointData()->SetScalars(pixels);
  return image;
}

vtkSmartPointer<vtkMultiBlockDataSet>
SceneToVTK(const RegistrationScene & scene)
{
  auto       blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const auto add = [&blocks](const std::string & name, vtkDataObject * object) {
    const unsigned int number = blocks->GetNumberOfBlocks();
    blocks->SetBlock(number, object);
    blocks->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  };
  for (const ScenePart & part : scene.GetParts())
  {
    add(part.name, ScenePartToVTK(part));
    if (const auto picture = ScenePictureToVTK(part))
    {
      add(part.name.substr(0, part.name.rfind(' ')) + " radiograph", picture);
    }
  }
  return blocks;
}

vtkSmartPointer<vtkPolyData>
SceneToOnePolyData(const RegistrationScene & scene, unsigned int pictureSize)
{
  vtkNew<vtkAppendPolyData> append;
  vtkNew<vtkStringArray>    names;
  names->SetName("PartNames");
  for (const ScenePart & part : scene.GetParts())
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("Color");
    colors->SetNumberOfComponents(3);
    vtkSmartPointer<vtkPolyData> piece;
    if (part.picture.IsNotNull())
    {
      piece = MakePictureGrid(part, pictureSize, colors);
    }
    else
    {
      piece = ScenePartToVTK(part);
      colors->SetNumberOfTuples(piece->GetNumberOfPoints());
      for (int i = 0; i < 3; ++i)
      {
        colors->FillComponent(i, ToByte(part.color[static_cast<std::size_t>(i)]));
      }
    }
    vtkNew<vtkUnsignedCharArray> teeth;
    teeth->SetName("FDI");
    teeth->SetNumberOfTuples(piece->GetNumberOfPoints());
    teeth->FillValue(0);
    if (vtkDataArray * const own = piece->GetPointData()->GetArray("FDI"))
    {
      teeth->DeepCopy(own);
    }
    // An array that one piece lacks would be dropped from all.
    piece->GetPointData()->Initialize();
    piece->GetFieldData()->Initialize();
    piece->GetPointData()->SetScalars(colors);
    piece->GetPointData()->AddArray(teeth);
    vtkNew<vtkIntArray> number;
    number->SetName("Part");
    number->SetNumberOfTuples(piece->GetNumberOfCells());
    number->FillValue(static_cast<int>(names->GetNumberOfValues()));
    piece->GetCellData()->AddArray(number);
    names->InsertNextValue(part.name);
    append->AddInputData(piece);
  }
  auto whole = vtkSmartPointer<vtkPolyData>::New();
  if (names->GetNumberOfValues() > 0)
  {
    append->Update();
    whole->ShallowCopy(append->GetOutput());
  }
  whole->GetFieldData()->AddArray(names);
  return whole;
}
} // namespace itk

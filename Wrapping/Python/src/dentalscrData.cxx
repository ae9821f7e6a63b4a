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
#include "dentalscrData.h"

#include "itkMakeTriangleSurface.h"
#include "itkToothCode.h"
#include "itkTriangleCell.h"
#include "itkWritePicture.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace dentalscr
{
namespace
{
using IndexArray = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/** The same as integers. A number with a fraction, or a yes and no, is never rounded to an index: it was meant for
 * something else. */
template <typename TArray>
TArray
ToIntegers(const py::object & values, const char * what)
{
  const auto array = py::module_::import("numpy").attr("asarray")(values).cast<py::array>();
  const char kind = array.dtype().kind();
  if (kind != 'i' && kind != 'u' && array.size() > 0)
  {
    throw std::invalid_argument(std::string(what) + " are " + py::str(array.dtype()).cast<std::string>() +
                                ", and integers are needed; where they are whole numbers, convert them by " +
                                ".astype(int)");
  }
  return array.cast<TArray>();
}

void
SetLabels(MeshType & mesh, const py::object & numbers)
{
  const auto labels = ToIntegers<IndexArray>(numbers, "labels");
  if (labels.ndim() != 1 || static_cast<std::size_t>(labels.size()) != mesh.GetNumberOfPoints())
  {
    throw std::invalid_argument("there are " + std::to_string(labels.size()) + " labels for " +
                                std::to_string(mesh.GetNumberOfPoints()) + " points; give one a point");
  }
  auto data = MeshType::PointDataContainer::New();
  data->Reserve(mesh.GetNumberOfPoints());
  for (py::ssize_t i = 0; i < labels.size(); ++i)
  {
    if (labels.at(i) < 0 || labels.at(i) > std::numeric_limits<std::uint8_t>::max())
    {
      throw std::invalid_argument("label " + std::to_string(labels.at(i)) + " of point " + std::to_string(i) +
                                  " is no FDI number, nor 0 for gingiva");
    }
    data->SetElement(i, static_cast<float>(labels.at(i)));
  }
  mesh.SetPointData(data);
  mesh.Modified();
}

MeshType::Pointer
MakeMesh(const FloatArray & points, const py::object & triangleIndices, const py::object & labels)
{
  const auto triangles = ToIntegers<IndexArray>(triangleIndices, "triangles");
  CheckShape(points, 3, "points");
  CheckShape(triangles, 3, "triangles");
  const auto           numberOfPoints = static_cast<std::size_t>(points.shape(0));
  const auto           numberOfTriangles = static_cast<std::size_t>(triangles.shape(0));
  auto                 mesh = MeshType::New();
  const float *        p = points.data();
  const std::int64_t * t = triangles.data();
  {
    const py::gil_scoped_release released;
    for (std::size_t i = 0; i < 3 * numberOfPoints; ++i)
    {
      if (!std::isfinite(p[i]))
      {
        throw std::invalid_argument("point " + std::to_string(i / 3) + " is not finite");
      }
    }
    for (std::size_t i = 0; i < 3 * numberOfTriangles; ++i)
    {
      if (t[i] < 0 || static_cast<std::size_t>(t[i]) >= numberOfPoints)
      {
        throw std::invalid_argument("triangle " + std::to_string(i / 3) + " names point " + std::to_string(t[i]) +
                                    " of " + std::to_string(numberOfPoints));
      }
    }
    auto   container = MeshType::PointsContainer::New();
    auto & values = container->CastToSTLContainer();
    values.resize(numberOfPoints);
    for (std::size_t i = 0; i < numberOfPoints; ++i)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        values[i][d] = p[3 * i + d];
      }
    }
    mesh->SetPoints(container);
    auto cells = MeshType::CellsContainer::New();
    cells->Reserve(numberOfTriangles);
    for (std::size_t i = 0; i < numberOfTriangles; ++i)
    {
      MeshType::CellAutoPointer cell;
      cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
      for (unsigned int corner = 0; corner < 3; ++corner)
      {
        cell->SetPointId(corner, static_cast<MeshType::PointIdentifier>(t[3 * i + corner]));
      }
      cells->SetElement(i, cell.ReleaseOwnership());
    }
    mesh->SetCellsAllocationMethod(itk::MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
    mesh->SetCells(cells);
  }
  if (!labels.is_none())
  {
    SetLabels(*mesh, labels);
  }
  return mesh;
}

/** A view on memory that the object owns: no copy, not writeable, keeps the object alive. */
template <typename T>
py::array_t<T>
MakeView(const T * values, std::vector<py::ssize_t> shape, const py::object & owner)
{
  py::array_t<T> view(shape, values, owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

py::array_t<float>
ViewPoints(const py::object & self)
{
  const auto & mesh = self.cast<const MeshType &>();
  if (mesh.GetNumberOfPoints() == 0)
  {
    return py::array_t<float>(std::vector<py::ssize_t>{ 0, 3 });
  }
  const auto & values = mesh.GetPoints()->CastToSTLConstContainer();
  return MakeView(&values[0][0], { static_cast<py::ssize_t>(values.size()), 3 }, self);
}

py::array_t<std::uint32_t>
CopyTriangles(const MeshType & mesh)
{
  const itk::TriangleSurface surface = itk::MakeTriangleSurface(&mesh);
  py::array_t<std::uint32_t> triangles({ static_cast<py::ssize_t>(surface.triangles.size()), py::ssize_t{ 3 } });
  std::uint32_t *            out = triangles.mutable_data();
  for (const auto & triangle : surface.triangles)
  {
    out = std::copy(triangle.begin(), triangle.end(), out);
  }
  return triangles;
}

py::object
CopyLabels(const MeshType & mesh)
{
  const auto * data = mesh.GetPointData();
  if (data == nullptr || data->Size() == 0)
  {
    return py::none();
  }
  py::array_t<std::uint8_t> labels(static_cast<py::ssize_t>(mesh.GetNumberOfPoints()));
  for (py::ssize_t i = 0; i < labels.size(); ++i)
  {
    float value = 0.0F;
    data->GetElementIfIndexExists(i, &value);
    labels.mutable_at(i) = static_cast<std::uint8_t>(value);
  }
  return labels;
}

void
WrapMesh(py::module_ & module)
{
  py::class_<MeshType, itk::DataObject, itk::SmartPointer<MeshType>>(module,
                                                                     "Mesh",
                                                                     R"(A triangle mesh: a scan of a jaw.

Coordinates are kept as 32-bit floats, as STL has them, in mm unless a function says otherwise. Triangles are wound
counter-clockwise seen from outside.

Parameters
----------
points : (N, 3) array of numbers
triangles : (M, 3) array of integers
    Indices into the points.
labels : (N,) array of integers, optional
    FDI number of the tooth of each point, 0 for gingiva.)")
    .def(py::init(&MakeMesh), py::arg("points"), py::arg("triangles"), py::arg("labels") = py::none())
    .def(
      "GetNumberOfPoints",
      [](const MeshType & self) { return self.GetNumberOfPoints(); },
      "How many vertices the mesh has.")
    .def(
      "GetNumberOfTriangles",
      [](const MeshType & self) { return self.GetNumberOfCells(); },
      "How many triangles the mesh has.")
    .def_property_readonly("points", &ViewPoints, "(N, 3) float32: a read-only view, no copy.")
    .def_property_readonly("triangles", &CopyTriangles, "(M, 3) uint32: a copy.")
    .def_property_readonly("vertices", &ViewPoints, "The points, under the name that trimesh has.")
    .def_property_readonly("faces", &CopyTriangles, "The triangles, under the name that trimesh has.")
    .def_property("labels", &CopyLabels, &SetLabels, "(N,) uint8 or None: a copy. FDI numbers, 0 for gingiva.")
    .def_property_readonly(
      "bounds",
      [](const py::object & self) {
        const py::object points = ViewPoints(self);
        if (py::len(points) == 0)
        {
          throw std::invalid_argument("the mesh has no points");
        }
        const py::module_ numpy = py::module_::import("numpy");
        return py::array_t<double>(numpy.attr("stack")(
          py::make_tuple(points.attr("min")(py::arg("axis") = 0), points.attr("max")(py::arg("axis") = 0))));
      },
      "(2, 3): smallest and largest coordinates.")
    .def("__repr__",
         [](const MeshType & self) {
           return "<dentalscr.Mesh of " + std::to_string(self.GetNumberOfPoints()) + " points, " +
                  std::to_string(self.GetNumberOfCells()) + " triangles>";
         })
    .def(py::pickle(
      [](const py::object & self) {
        const auto & mesh = self.cast<const MeshType &>();
        return py::make_tuple(ViewPoints(self), CopyTriangles(mesh), CopyLabels(mesh));
      },
      [](const py::tuple & state) { return MakeMesh(state[0].cast<FloatArray>(), state[1], state[2]); }));
}

using VectorType = itk::Vector<double, 2>;
using PointType = itk::Point<double, 2>;

ImageType::Pointer
MakeImage(const FloatArray &            array,
          const VectorType &            spacing,
          const PointType &             origin,
          const std::array<double, 4> & direction,
          const ImageType::IndexType &  index)
{
  if (array.ndim() != 2)
  {
    throw std::invalid_argument("an image is a 2-D array of rows and columns, not one of " +
                                std::to_string(array.ndim()) + " dimensions");
  }
  if (!(spacing[0] > 0.0 && spacing[1] > 0.0))
  {
    throw std::invalid_argument("a spacing is above 0");
  }
  auto                     image = ImageType::New();
  ImageType::SizeType      size{ { static_cast<itk::SizeValueType>(array.shape(1)),
                                   static_cast<itk::SizeValueType>(array.shape(0)) } };
  ImageType::DirectionType matrix;
  for (unsigned int i = 0; i < 4; ++i)
  {
    matrix(i / 2, i % 2) = direction[i];
  }
  image->SetRegions(ImageType::RegionType(index, size));
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(matrix);
  image->Allocate();
  std::copy(array.data(), array.data() + array.size(), image->GetBufferPointer());
  return image;
}

py::array_t<float>
ViewPixels(const py::object & self)
{
  const auto & image = self.cast<const ImageType &>();
  const auto   size = image.GetBufferedRegion().GetSize();
  if (size[0] * size[1] == 0)
  {
    return py::array_t<float>(std::vector<py::ssize_t>{ 0, 0 });
  }
  return MakeView(
    image.GetBufferPointer(), { static_cast<py::ssize_t>(size[1]), static_cast<py::ssize_t>(size[0]) }, self);
}

std::array<double, 4>
GetDirection(const ImageType & image)
{
  const auto & matrix = image.GetDirection();
  return { { matrix(0, 0), matrix(0, 1), matrix(1, 0), matrix(1, 1) } };
}

void
WrapImage(py::module_ & module)
{
  const std::array<double, 4> identity{ { 1.0, 0.0, 0.0, 1.0 } };
  py::class_<ImageType, itk::DataObject, itk::SmartPointer<ImageType>>(
    module,
    "Image",
    py::buffer_protocol(),
    R"(A grey picture of 32-bit floats: radiograph, DRR or label map.

Arrays are [row, column] = [v, u]; sizes, spacings and points are (u, v) as in SimpleITK. ``numpy.asarray(image)`` is a
read-only view.

Parameters
----------
array : (height, width) array
    Copied.
spacing, origin : pair of numbers, optional
    mm a pixel, and the place of the pixel (0, 0).
direction : 4 numbers, optional
    Row-major.
index : pair of int, optional
    Index of the first pixel; a DRR may begin at a negative one.)")
    .def(py::init(&MakeImage),
         py::arg("array"),
         py::arg("spacing") = VectorType(1.0),
         py::arg("origin") = PointType(0.0),
         py::arg("direction") = identity,
         py::arg("index") = ImageType::IndexType{ { 0, 0 } })
    .def_buffer([](ImageType & self) {
      const auto size = self.GetBufferedRegion().GetSize();
      return py::buffer_info(self.GetBufferPointer(),
                             { static_cast<py::ssize_t>(size[1]), static_cast<py::ssize_t>(size[0]) },
                             { static_cast<py::ssize_t>(size[0] * sizeof(float)), py::ssize_t{ sizeof(float) } },
                             true);
    })
    .def(
      "GetSize", [](const ImageType & self) { return self.GetBufferedRegion().GetSize(); }, "(width, height)")
    .def(
      "GetIndex",
      [](const ImageType & self) { return self.GetBufferedRegion().GetIndex(); },
      "First pixel of the image's region, (u, v). A simulated radiograph may begin below 0.")
    .def(
      "GetSpacing",
      [](const ImageType & self) { return VectorType(self.GetSpacing()); },
      "Distance between pixels, (u, v), in mm where a spacing is known and 1 otherwise.")
    .def(
      "GetOrigin",
      [](const ImageType & self) { return self.GetOrigin(); },
      "Physical point of the pixel with index (0, 0), (u, v), in the unit of the spacing.")
    .def(
      "GetDirection",
      [](const ImageType & self) {
        const auto direction = GetDirection(self);
        return py::make_tuple(direction[0], direction[1], direction[2], direction[3]);
      },
      "Directions of the axes as a row-major tuple of 4; the identity for radiographs.")
    .def(
      "GetWidth", [](const ImageType & self) { return self.GetBufferedRegion().GetSize()[0]; }, "Number of columns.")
    .def(
      "GetHeight", [](const ImageType & self) { return self.GetBufferedRegion().GetSize()[1]; }, "Number of rows.")
    .def(
      "GetDimension", [](const ImageType &) { return 2; }, "Number of axes, which is 2.")
    .def(
      "TransformContinuousIndexToPhysicalPoint",
      [](const ImageType & self, const itk::ContinuousIndex<double, 2> & index) {
        PointType point;
        self.TransformContinuousIndexToPhysicalPoint(index, point);
        return point;
      },
      py::arg("index"),
      "Continuous pixel index (u, v) to the physical point (x, y).")
    .def(
      "TransformPhysicalPointToContinuousIndex",
      [](const ImageType & self, const PointType & point) {
        return self.TransformPhysicalPointToContinuousIndex<double, double>(point);
      },
      py::arg("point"),
      "Physical point (x, y) to the continuous pixel index (u, v).")
    .def_property_readonly("array", &ViewPixels, "(height, width) float32: a read-only view, no copy.")
    .def(
      "_repr_png_",
      [](const py::object & self) {
        return py::module_::import("dentalscr._pictures").attr("grey_png")(ViewPixels(self)).cast<py::bytes>();
      },
      "The picture, for notebooks.")
    .def("__repr__",
         [](const ImageType & self) {
           std::ostringstream text;
           const auto         region = self.GetBufferedRegion();
           text << "<dentalscr.Image of " << region.GetSize()[0] << " x " << region.GetSize()[1] << " pixels, spacing ("
                << self.GetSpacing()[0] << ", " << self.GetSpacing()[1] << "), first index (" << region.GetIndex()[0]
                << ", " << region.GetIndex()[1] << ")>";
           return text.str();
         })
    .def(py::pickle(
      [](const py::object & self) {
        const auto & image = self.cast<const ImageType &>();
        return py::make_tuple(ViewPixels(self),
                              VectorType(image.GetSpacing()),
                              image.GetOrigin(),
                              GetDirection(image),
                              image.GetBufferedRegion().GetIndex());
      },
      [](const py::tuple & state) {
        return MakeImage(state[0].cast<FloatArray>(),
                         state[1].cast<VectorType>(),
                         state[2].cast<PointType>(),
                         state[3].cast<std::array<double, 4>>(),
                         state[4].cast<ImageType::IndexType>());
      }));

  py::class_<PictureType, itk::DataObject, itk::SmartPointer<PictureType>>(
    module, "Picture", py::buffer_protocol(), "A colour picture; ``numpy.asarray(picture)`` is a read-only view.")
    .def_buffer([](PictureType & self) {
      const auto size = self.GetBufferedRegion().GetSize();
      return py::buffer_info(reinterpret_cast<unsigned char *>(self.GetBufferPointer()),
                             { static_cast<py::ssize_t>(size[1]), static_cast<py::ssize_t>(size[0]), py::ssize_t{ 3 } },
                             { static_cast<py::ssize_t>(3 * size[0]), py::ssize_t{ 3 }, py::ssize_t{ 1 } },
                             true);
    })
    .def(
      "GetSize", [](const PictureType & self) { return self.GetBufferedRegion().GetSize(); }, "(width, height)")
    .def(
      "Write",
      [](const PictureType & self, const std::string & fileName) { itk::WritePicture(&self, fileName); },
      py::arg("fileName"),
      py::call_guard<py::gil_scoped_release>(),
      "As PNG, whole or not at all.")
    .def(
      "_repr_png_",
      [](const py::object & self) {
        const py::object array = py::module_::import("numpy").attr("asarray")(self);
        return py::module_::import("dentalscr._pictures").attr("encode_png")(array).cast<py::bytes>();
      },
      "The picture, for notebooks.")
    .def("__repr__", [](const PictureType & self) {
      const auto size = self.GetBufferedRegion().GetSize();
      return "<dentalscr.Picture of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " pixels>";
    });
}
} // namespace

void
WrapData(py::module_ & module)
{
  py::class_<itk::DataObject, itk::SmartPointer<itk::DataObject>>(
    module, "DataObject", "What process objects exchange.");
  using itk::ToothCode;
  BindEnum<ToothCode::JawEnum>(module,
                               "Jaw",
                               { { "Upper", ToothCode::JawEnum::Upper },
                                 { "Lower", ToothCode::JawEnum::Lower },
                                 { "Unknown", ToothCode::JawEnum::Unknown } },
                               "A jaw; Unknown stands for both where a filter takes it.");
  BindEnum<ToothCode::NumberingEnum>(module,
                                     "Numbering",
                                     { { "Quadrant", ToothCode::NumberingEnum::Quadrant },
                                       { "FDI", ToothCode::NumberingEnum::FDI },
                                       { "Universal", ToothCode::NumberingEnum::Universal } },
                                     "How tooth codes are written: UR1, 11 or 8.");
  WrapMesh(module);
  WrapImage(module);
  WrapContour(module);
}
} // namespace dentalscr

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

#include "itkDentalContour.h"

#include <sstream>

namespace dentalscr
{
namespace
{
using itk::DentalContour;
using PolylineType = DentalContour::PolylineType;

/** By name or FDI number; empty or 0 is unknown. */
itk::ToothCode
MakeToothCode(const py::object & code)
{
  if (py::isinstance<py::str>(code))
  {
    return itk::ToothCode::FromString(code.cast<std::string>());
  }
  return itk::ToothCode(code.is_none() ? 0U : code.cast<unsigned int>());
}

PolylineType
MakePolyline(const DoubleArray & points,
             const py::object &  code,
             bool                closed,
             const py::object &  weights,
             const py::object &  sigmas,
             const py::object &  outline,
             const py::object &  normals,
             const py::object &  rimPoints,
             const py::object &  teeth,
             bool                drafted)
{
  CheckShape(points, 2, "points");
  PolylineType polyline;
  polyline.code = MakeToothCode(code);
  polyline.closed = closed;
  polyline.drafted = drafted;
  polyline.points.resize(static_cast<std::size_t>(points.shape(0)));
  for (std::size_t i = 0; i < polyline.points.size(); ++i)
  {
    polyline.points[i][0] = points.at(i, 0);
    polyline.points[i][1] = points.at(i, 1);
  }
  if (!weights.is_none())
  {
    const auto array = weights.cast<DoubleArray>();
    polyline.weights.assign(array.data(), array.data() + array.size());
  }
  if (!sigmas.is_none())
  {
    // One number is of every point.
    const auto array = sigmas.cast<DoubleArray>();
    polyline.sigmas.assign(array.data(), array.data() + array.size());
    if (array.ndim() == 0)
    {
      polyline.sigmas.assign(polyline.points.size(), polyline.sigmas.front());
    }
  }
  if (!outline.is_none())
  {
    polyline.outline = DentalContour::OutlineFromString(outline.cast<std::string>());
  }
  if (!normals.is_none())
  {
    const auto array = normals.cast<DoubleArray>();
    CheckShape(array, 2, "normals");
    for (py::ssize_t i = 0; i < array.shape(0); ++i)
    {
      polyline.normals.emplace_back(array.data(i, 0));
    }
  }
  if (!rimPoints.is_none())
  {
    const auto array = rimPoints.cast<DoubleArray>();
    CheckShape(array, 3, "rimPoints");
    for (py::ssize_t i = 0; i < array.shape(0); ++i)
    {
      polyline.rimPoints.emplace_back(array.data(i, 0));
    }
  }
  if (!teeth.is_none())
  {
    for (const py::handle name : teeth)
    {
      polyline.teeth.push_back(MakeToothCode(py::reinterpret_borrow<py::object>(name)));
    }
  }
  return polyline;
}

/** What a silhouette's points know, each None where they do not. */
py::object
NormalsOf(const PolylineType & polyline)
{
  return polyline.normals.empty() ? py::object(py::none()) : py::object(MakeRows<2>(polyline.normals));
}

py::object
RimPointsOf(const PolylineType & polyline)
{
  return polyline.rimPoints.empty() ? py::object(py::none()) : py::object(MakeRows<3>(polyline.rimPoints));
}

py::object
TeethOf(const PolylineType & polyline)
{
  if (polyline.teeth.empty())
  {
    return py::none();
  }
  std::vector<std::string> names;
  for (const itk::ToothCode & tooth : polyline.teeth)
  {
    names.push_back(tooth.GetName());
  }
  return py::cast(names);
}

/** "crown", "tooth", "labial", or None. */
py::object
OutlineOf(const PolylineType & polyline)
{
  if (polyline.outline == DentalContour::OutlineEnum::Unspecified)
  {
    return py::none();
  }
  std::ostringstream text;
  text << polyline.outline;
  return py::str(text.str());
}

py::object
SigmasOf(const PolylineType & polyline)
{
  return polyline.sigmas.empty() ? py::object(py::none()) : py::object(MakeArray(polyline.sigmas));
}

py::tuple
MakeState(const DentalContour & contour)
{
  py::list state;
  for (const PolylineType & polyline : contour.GetPolylines())
  {
    py::object weights = py::none();
    if (!polyline.weights.empty())
    {
      weights = MakeArray(polyline.weights);
    }
    state.append(py::make_tuple(MakeRows<2>(polyline.points),
                                polyline.code.GetName(),
                                polyline.closed,
                                std::move(weights),
                                SigmasOf(polyline),
                                OutlineOf(polyline),
                                NormalsOf(polyline),
                                RimPointsOf(polyline),
                                TeethOf(polyline),
                                polyline.drafted));
  }
  return py::tuple(state);
}
} // namespace

void
WrapContour(py::module_ & module)
{
  py::class_<PolylineType>(module,
                           "Polyline",
                           R"(One stretch of a contour.

Parameters
----------
points : (N, 2) array
    Continuous pixel indices (u, v); a closed one does not repeat its first.
code : str or int, optional
    "UR1" or the FDI number; "" is unknown.
closed : bool, optional
weights : (N,) array, optional
    In [0, 1], 0 is ignored.
sigmas : float or (N,) array, optional
    Drawing errors of the points, pixels; 0 where nobody knows.
outline : "crown", "tooth" or "labial", optional
    What of the tooth was drawn; found out unless given.
normals : (N, 2) array, optional
    Of a silhouette: outward unit normals in the image, (0, 0) where one is not known.
rimPoints : (N, 3) array, optional
    Of a silhouette: the points of the scan that project to its points, frame of the mesh, mm; NaN where one is not
    known.
teeth : sequence of str or int, optional
    The teeth of the points where they are not all of one; the code is then that of the first.
drafted : bool, optional
    A registration projected it and nobody has mended it: no independent evidence.)")
    .def(py::init(&MakePolyline),
         py::arg("points"),
         py::arg("code") = "",
         py::arg("closed") = false,
         py::arg("weights") = py::none(),
         py::arg("sigmas") = py::none(),
         py::arg("outline") = py::none(),
         py::arg("normals") = py::none(),
         py::arg("rimPoints") = py::none(),
         py::arg("teeth") = py::none(),
         py::arg("drafted") = false)
    .def_property_readonly(
      "normals", &NormalsOf, "(N, 2) copy: outward unit normals in the image, (0, 0) where one is not known; or None.")
    .def_property_readonly(
      "rimPoints",
      &RimPointsOf,
      "(N, 3) copy: the points of the scan that project to these, frame of the mesh, mm, NaN where "
      "one is not known; or None.")
    .def_property_readonly("teeth", &TeethOf, "The names of the points' teeth where they are not all of one, or None.")
    .def_property_readonly(
      "points", [](const PolylineType & self) { return MakeRows<2>(self.points); }, "(N, 2) copy.")
    .def_property_readonly(
      "code", [](const PolylineType & self) { return self.code.GetName(); }, "\"UR1\" or \"\".")
    .def_property_readonly(
      "fdi", [](const PolylineType & self) { return static_cast<int>(self.code.GetFDI()); }, "0 is unknown.")
    .def_readonly(
      "closed", &PolylineType::closed, "Whether the last point is joined to the first, which is not repeated.")
    .def_property_readonly(
      "weights",
      [](const PolylineType & self) -> py::object {
        return self.weights.empty() ? py::object(py::none()) : py::object(MakeArray(self.weights));
      },
      "(N,) copy, or None.")
    .def_property_readonly("sigmas", &SigmasOf, "(N,) copy, or None.")
    .def_property_readonly("outline", &OutlineOf, "\"crown\", \"tooth\", \"labial\", or None.")
    .def_readonly("drafted", &PolylineType::drafted, "Whether a registration projected it and nobody has mended it.")
    .def("__len__", [](const PolylineType & self) { return self.points.size(); })
    .def("__repr__", [](const PolylineType & self) {
      return "<dentalscr.Polyline " + self.code.GetName() + (self.closed ? ", closed" : "") + ", " +
             std::to_string(self.points.size()) + " points>";
    });

  py::class_<DentalContour, itk::DataObject, itk::SmartPointer<DentalContour>>(
    module,
    "Contour",
    R"(Polylines in a radiograph, each with the code of its tooth.

Points are continuous pixel indices (u, v): (0, 0) is the centre of the first pixel. A tracing is one, a silhouette and
what a segmentation yields are others.

Parameters
----------
polylines : sequence of Polyline, optional)")
    .def(py::init([](const std::vector<PolylineType> & polylines) {
           auto contour = DentalContour::New();
           for (const auto & polyline : polylines)
           {
             contour->AddPolyline(polyline);
           }
           return contour;
         }),
         py::arg("polylines") = std::vector<PolylineType>())
    .def(
      "AddPolyline",
      [](DentalContour &     self,
         const DoubleArray & points,
         const py::object &  code,
         bool                closed,
         const py::object &  weights,
         const py::object &  sigmas,
         const py::object &  outline,
         const py::object &  normals,
         const py::object &  rimPoints,
         const py::object &  teeth,
         bool                drafted) {
        self.AddPolyline(
          MakePolyline(points, code, closed, weights, sigmas, outline, normals, rimPoints, teeth, drafted));
      },
      py::arg("points"),
      py::arg("code") = "",
      py::arg("closed") = false,
      py::arg("weights") = py::none(),
      py::arg("sigmas") = py::none(),
      py::arg("outline") = py::none(),
      py::arg("normals") = py::none(),
      py::arg("rimPoints") = py::none(),
      py::arg("teeth") = py::none(),
      py::arg("drafted") = false,
      "Appends a polyline of continuous pixel indices (u, v), as Polyline describes it. It raises an error where a "
      "point is not finite, where weights, sigmas, normals, rimPoints or teeth are not one a point, or where a closed "
      "one has fewer than 3 points.")
    .def_property_readonly("polylines", &DentalContour::GetPolylines, "Copies.")
    .def_property_readonly(
      "points",
      [](const DentalContour & self) {
        std::vector<DentalContour::PointType> points;
        for (const PolylineType & polyline : self.GetPolylines())
        {
          points.insert(points.end(), polyline.points.begin(), polyline.points.end());
        }
        return MakeRows<2>(points);
      },
      "(N, 2) float64: the points of all polylines, a copy.")
    .def(
      "GetNumberOfPoints",
      [](const DentalContour & self) { return self.GetNumberOfPoints(); },
      "How many points all polylines have together.")
    .def("GetDraftedShare",
         &DentalContour::GetDraftedShare,
         "Share of the points with a weight above 0 that a registration drafted and nobody mended, 0 to 1.")
    .def("GetLength", &DentalContour::GetLength, "Sum of the segments' lengths, pixels.")
    .def("__len__", [](const DentalContour & self) { return self.GetPolylines().size(); })
    .def(
      "_repr_svg_",
      [](const py::object & self) {
        return py::module_::import("dentalscr._pictures").attr("contour_svg")(self).cast<std::string>();
      },
      "The picture, for notebooks.")
    .def("__repr__",
         [](const DentalContour & self) {
           return "<dentalscr.Contour of " + std::to_string(self.GetPolylines().size()) + " polylines, " +
                  std::to_string(self.GetNumberOfPoints()) + " points>";
         })
    .def(py::pickle([](const DentalContour & self) { return MakeState(self); },
                    [](const py::tuple & state) {
                      auto contour = DentalContour::New();
                      for (const py::handle item : state)
                      {
                        const auto polyline = item.cast<py::tuple>();
                        // Earlier pickles have four, six or nine members.
                        const auto member = [&polyline](std::size_t i) {
                          return i < polyline.size() ? py::object(polyline[i]) : py::object(py::none());
                        };
                        contour->AddPolyline(MakePolyline(polyline[0].cast<DoubleArray>(),
                                                          polyline[1],
                                                          polyline[2].cast<bool>(),
                                                          member(3),
                                                          member(4),
                                                          member(5),
                                                          member(6),
                                                          member(7),
                                                          member(8),
                                                          polyline.size() > 9 && polyline[9].cast<bool>()));
                      }
                      return contour;
                    }));
  module.def(
    "tooth_name",
    [](const py::object & code) { return MakeToothCode(code).GetName(); },
    py::arg("code"),
    "\"UR1\" from \"UR1\", \"11\" or 11.");
  module.def(
    "tooth_fdi",
    [](const py::object & code) { return static_cast<int>(MakeToothCode(code).GetFDI()); },
    py::arg("code"),
    "11 from \"UR1\", \"11\" or 11.");
}
} // namespace dentalscr

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
#include "dentalscrConversions.h"

#include "itkCephalometricGeometry.h"
#include "itkRigidTransformRows.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace dentalscr
{
namespace
{
using GeometryType = itk::CephalometricGeometry;
using SideEnum = GeometryType::SourceSideEnum;
using FacingEnum = GeometryType::FacingEnum;
using DirectionEnum = GeometryType::DirectionEnum;
using FrontalSourceEnum = GeometryType::FrontalSourceEnum;
using PatientLeftEnum = GeometryType::PatientLeftEnum;

std::array<double, 12>
GetPose(const GeometryType & geometry)
{
  return itk::MakeRigidTransformRows(geometry.GetPoseRotation(), geometry.GetPoseTranslation());
}

void
SetPose(GeometryType & geometry, const DoubleArray & matrix)
{
  if (matrix.ndim() != 2 || matrix.shape(0) < 3 || matrix.shape(0) > 4 || matrix.shape(1) != 4)
  {
    throw std::invalid_argument("a pose is a rigid 4 x 4 or 3 x 4 matrix");
  }
  GeometryType::RotationType rotation;
  GeometryType::VectorType   translation;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      rotation(row, column) = matrix.at(row, column);
    }
    translation[row] = matrix.at(row, 3);
  }
  geometry.SetPose(rotation, translation);
}

/** Two numbers, or an error that names the keyword. */
template <typename TPair>
TPair
ToPair(const py::object & object, const char * name, const char * remedy)
{
  try
  {
    return object.cast<TPair>();
  }
  catch (const py::cast_error &)
  {
    throw std::invalid_argument(std::string(name) + " is " + py::repr(object).cast<std::string>() + "; " + remedy);
  }
}

/** One number or two; what is no spacing is refused, as it would count as an unknown one. */
GeometryType::PixelSpacingType
ToPixelSpacing(const py::object & object)
{
  const char * const remedy = "give mm a pixel, > 0, one number or two (u, v), or leave it out where it is unknown";
  const bool         isNumber = PyNumber_Check(object.ptr()) && !PySequence_Check(object.ptr());
  const auto         spacing = isNumber ? GeometryType::PixelSpacingType(ToPair<double>(object, "pixelSpacing", remedy))
                                        : ToPair<GeometryType::PixelSpacingType>(object, "pixelSpacing", remedy);
  for (const double value : spacing)
  {
    if (!(std::isfinite(value) && value > 0.0))
    {
      throw std::invalid_argument("pixelSpacing is " + py::repr(object).cast<std::string>() + "; " + remedy);
    }
  }
  return spacing;
}

GeometryType::Pointer
MakeGeometry(double             sourceToMidsagittal,
             double             sourceToDetector,
             const py::object & pixelSpacing,
             const py::object & principalPoint,
             SideEnum           sourceSide,
             FacingEnum         facing,
             DirectionEnum      direction,
             FrontalSourceEnum  frontalSource,
             PatientLeftEnum    patientLeft)
{
  auto geometry = GeometryType::New();
  geometry->SetSourceToMidsagittalDistance(sourceToMidsagittal);
  geometry->SetSourceToDetectorDistance(sourceToDetector);
  if (!pixelSpacing.is_none())
  {
    geometry->SetPixelSpacing(ToPixelSpacing(pixelSpacing));
  }
  if (!principalPoint.is_none())
  {
    geometry->SetPrincipalPoint(ToPair<GeometryType::PixelIndexType>(
      principalPoint, "principalPoint", "give a continuous pixel index, two numbers (u, v)"));
  }
  geometry->SetSourceSide(sourceSide);
  geometry->SetFacing(facing);
  geometry->SetDirection(direction);
  geometry->SetFrontalSource(frontalSource);
  geometry->SetPatientLeft(patientLeft);
  return geometry;
}
} // namespace

void
WrapGeometry(py::module_ & module)
{
  py::class_<GeometryType, itk::DataObject, itk::SmartPointer<GeometryType>> type(
    module,
    "CephalometricGeometry",
    R"(Where source, detector and pixels of a cephalogram are.

Cephalostat frame, mm: origin where the central ray meets the midsagittal plane, x anterior, y to the patient's left, z
superior. The pose maps the object's frame to it.

Parameters
----------
sourceToMidsagittal, sourceToDetector : float, optional
    mm.
pixelSpacing : float or pair of float, optional
    mm in the detector plane. There is no default: projecting without one raises.
principalPoint : pair of float, optional
    Continuous pixel index where the central ray meets the detector.
sourceSide : SourceSide or str, optional
    The side of the patient on which the source stands.
facing : Facing or str, optional
    Where the face points in the image.
direction : Direction or str, optional
    Of the rays: Lateral, or Frontal, with ``sourceToMidsagittal`` the distance to the midcoronal plane.
frontalSource : FrontalSource or str, optional
    Where the source of a frontal radiograph stands.
patientLeft : PatientLeft or str, optional
    Where the patient's left is in a frontal radiograph.)");
  BindEnum<DirectionEnum>(type,
                          "Direction",
                          { { "Lateral", DirectionEnum::Lateral }, { "Frontal", DirectionEnum::Frontal } },
                          "From which side of the head the rays come.");
  BindEnum<FrontalSourceEnum>(type,
                              "FrontalSource",
                              { { "Behind", FrontalSourceEnum::Behind }, { "InFront", FrontalSourceEnum::InFront } },
                              "Where the X-ray source of a frontal radiograph stands.");
  BindEnum<PatientLeftEnum>(type,
                            "PatientLeft",
                            { { "Right", PatientLeftEnum::Right }, { "Left", PatientLeftEnum::Left } },
                            "Where the patient's left is in a frontal radiograph.");
  BindEnum<SideEnum>(
    type, "SourceSide", { { "Right", SideEnum::Right }, { "Left", SideEnum::Left } }, "Side of the X-ray source.");
  BindEnum<FacingEnum>(
    type, "Facing", { { "Right", FacingEnum::Right }, { "Left", FacingEnum::Left } }, "Where the face points.");
  type
    .def(py::init(&MakeGeometry),
         py::arg("sourceToMidsagittal") = 1524.0,
         py::arg("sourceToDetector") = 1674.0,
         py::arg("pixelSpacing") = py::none(),
         py::arg("principalPoint") = py::none(),
         py::arg_v("sourceSide", SideEnum::Right, "SourceSide.Right"),
         py::arg_v("facing", FacingEnum::Right, "Facing.Right"),
         py::arg_v("direction", DirectionEnum::Lateral, "Direction.Lateral"),
         py::arg_v("frontalSource", FrontalSourceEnum::Behind, "FrontalSource.Behind"),
         py::arg_v("patientLeft", PatientLeftEnum::Right, "PatientLeft.Right"))
    .def("SetDirection",
         &GeometryType::SetDirection,
         py::arg("direction"),
         "Sets the direction of the radiograph: Lateral (the default) or Frontal. What is said of "
         "sides holds in its own direction.")
    .def(
      "GetDirection",
      [](const GeometryType & self) { return self.GetDirection(); },
      "Returns the direction of the radiograph: Lateral (the default) or Frontal. What is said of "
      "sides holds in its own direction.")
    .def("SetFrontalSource",
         &GeometryType::SetFrontalSource,
         py::arg("source"),
         "Sets where the source of a frontal radiograph is: Behind (the default) the patient or in "
         "front.")
    .def(
      "GetFrontalSource",
      [](const GeometryType & self) { return self.GetFrontalSource(); },
      "Returns where the source of a frontal radiograph is: Behind (the default) the patient or in "
      "front.")
    .def("SetPatientLeft",
         &GeometryType::SetPatientLeft,
         py::arg("side"),
         "Sets the side of a frontal image at which the patient's left is: Right by default, as one "
         "faces the patient.")
    .def(
      "GetPatientLeft",
      [](const GeometryType & self) { return self.GetPatientLeft(); },
      "Returns the side of a frontal image at which the patient's left is: Right by default, as "
      "one faces the patient.")
    .dentalscrProperty(GeometryType,
                       SourceToMidsagittalDistance,
                       "the distance from the source to the midsagittal plane, mm, above 0 and below that to the "
                       "detector; 1524 by default (60 inches). In a frontal cephalogram it is that to the "
                       "midcoronal plane.")
    .dentalscrProperty(
      GeometryType, SourceToDetectorDistance, "the distance from the source to the detector, mm; 1674 by default.")
    .def("SetSourceSide",
         &GeometryType::SetSourceSide,
         py::arg("side"),
         "Sets the patient's side at which the source of a lateral radiograph is; Right by default.")
    .def(
      "GetSourceSide",
      [](const GeometryType & self) { return self.GetSourceSide(); },
      "Returns the patient's side at which the source of a lateral radiograph is; Right by default.")
    .def("SetFacing",
         &GeometryType::SetFacing,
         py::arg("facing"),
         "Sets the side of the image to which the face of a lateral radiograph looks; Right by "
         "default.")
    .def(
      "GetFacing",
      [](const GeometryType & self) { return self.GetFacing(); },
      "Returns the side of the image to which the face of a lateral radiograph looks; Right by "
      "default.")
    .def("SetPrincipalPoint",
         &GeometryType::SetPrincipalPoint,
         py::arg("index"),
         "Sets the continuous pixel index (u, v) where the central ray meets the detector, the "
         "ear-rod ring of a cephalostat; (0, 0) by default.")
    .def(
      "GetPrincipalPoint",
      [](const GeometryType & self) { return self.GetPrincipalPoint(); },
      "Returns the continuous pixel index (u, v) where the central ray meets the detector, the "
      "ear-rod ring of a cephalostat; (0, 0) by default.")
    .def("SetPixelSpacing",
         &GeometryType::SetPixelSpacing,
         py::arg("spacing"),
         "Sets the pixel spacing (u, v) in the detector plane, mm, both above 0. It is not set by "
         "default.")
    .def(
      "GetPixelSpacing",
      [](const GeometryType & self) { return self.GetPixelSpacing(); },
      "Returns the pixel spacing (u, v) in the detector plane, mm, both above 0. It is not set by "
      "default.")
    .def("HasPixelSpacing", &GeometryType::HasPixelSpacing, "Whether a pixel spacing was set.")
    .def("SetPose", &SetPose, py::arg("matrix"), "Rigid 4x4 or 3x4: object frame (mm) to cephalostat frame (mm).")
    .def("SetPoseToIdentity", &GeometryType::SetPoseToIdentity, "Takes the object frame for the cephalostat frame.")
    .def(
      "GetPose", [](const GeometryType & self) { return MakeMatrix44(GetPose(self)); }, "(4, 4), a copy.")
    .def("GetMagnification",
         &GeometryType::GetMagnification,
         py::arg("point"),
         "Magnification of a point of the object frame (mm): the length of its picture in the "
         "detector plane over its own.")
    .def("TransformToCephalostat",
         &GeometryType::TransformToCephalostat,
         py::arg("point"),
         "Point of the object frame (mm) to the cephalostat frame (mm).")
    .def("ProjectPoint",
         &GeometryType::ProjectPoint,
         py::arg("point"),
         "Object frame (mm) to continuous pixel index (u, v).")
    .def(
      "ProjectPoints",
      [](const GeometryType & self, const DoubleArray & points) {
        if (points.ndim() != 2 || points.shape(1) != 3)
        {
          throw std::invalid_argument("points have the wrong shape; (N, 3) is needed");
        }
        std::vector<GeometryType::PixelIndexType> result(static_cast<std::size_t>(points.shape(0)));
        for (std::size_t i = 0; i < result.size(); ++i)
        {
          GeometryType::PointType point;
          for (unsigned int d = 0; d < 3; ++d)
          {
            point[d] = points.at(i, d);
          }
          result[i] = self.ProjectPoint(point);
        }
        return MakeRows<2>(result);
      },
      py::arg("points"),
      "All rows of an (N, 3) array: (N, 2), a copy.")
    .def(
      "ComputePointJacobian",
      [](const GeometryType & self, const GeometryType::PointType & point) {
        return MatrixToArray(self.ComputePointJacobian(point));
      },
      py::arg("point"),
      "(2, 3): d(u, v) / d(point).")
    .def(
      "ComputePoseJacobian",
      [](const GeometryType & self, const GeometryType::PointType & point) {
        return MatrixToArray(self.ComputePoseJacobian(point));
      },
      py::arg("point"),
      "(2, 6): three rotations (rad) about the cephalostat's axes, three translations (mm).")
    .def(
      "BackProject",
      [](const GeometryType & self, const GeometryType::PixelIndexType & index) {
        const auto ray = self.BackProject(index);
        return std::make_pair(ray.origin, ray.direction);
      },
      py::arg("index"),
      "The ray of a pixel in the object frame: the source, and the unit direction.")
    .def("GetSourcePosition", &GeometryType::GetSourcePosition, "The X-ray source in the object frame, mm.")
    .def(
      "GetProjectionMatrix",
      [](const GeometryType & self) { return MatrixToArray(self.GetProjectionMatrix()); },
      "(3, 4): object frame (mm) to homogeneous pixel index, pose included.")
    .def("VerifyComplete",
         &GeometryType::VerifyComplete,
         "Raises an error that names what is missing, and the remedy, unless the geometry can project.")
    .def("__copy__",
         [](const GeometryType & self) {
           auto copy = GeometryType::New();
           copy->CopyParameters(&self);
           return copy;
         })
    .def(
      "__deepcopy__",
      [](const GeometryType & self, const py::dict &) {
        auto copy = GeometryType::New();
        copy->CopyParameters(&self);
        return copy;
      },
      py::arg("memo"))
    .def("__repr__",
         [](const GeometryType & self) {
           std::ostringstream text;
           const bool         isLateral = self.GetDirection() == DirectionEnum::Lateral;
           text << "<dentalscr.CephalometricGeometry " << (isLateral ? "" : "frontal, ") << "source to "
                << (isLateral ? "midsagittal " : "midcoronal ") << self.GetSourceToMidsagittalDistance()
                << " mm, to detector " << self.GetSourceToDetectorDistance() << " mm, source ";
           if (isLateral)
           {
             text << self.GetSourceSide() << ", facing " << self.GetFacing();
           }
           else
           {
             text << self.GetFrontalSource() << ", patient's left " << self.GetPatientLeft();
           }
           text << ", pixel spacing ";
           if (self.HasPixelSpacing())
           {
             text << self.GetPixelSpacing() << " mm";
           }
           else
           {
             text << "unknown";
           }
           text << ", principal point " << self.GetPrincipalPoint() << ">";
           return text.str();
         })
    .def(py::pickle(
      [](const GeometryType & self) {
        py::object spacing = py::none();
        if (self.HasPixelSpacing())
        {
          spacing = py::cast(self.GetPixelSpacing());
        }
        return py::make_tuple(self.GetSourceToMidsagittalDistance(),
                              self.GetSourceToDetectorDistance(),
                              spacing,
                              self.GetPrincipalPoint(),
                              static_cast<int>(self.GetSourceSide()),
                              static_cast<int>(self.GetFacing()),
                              MakeMatrix44(GetPose(self)),
                              static_cast<int>(self.GetDirection()),
                              static_cast<int>(self.GetFrontalSource()),
                              static_cast<int>(self.GetPatientLeft()));
      },
      [](const py::tuple & state) {
        auto geometry = MakeGeometry(state[0].cast<double>(),
                                     state[1].cast<double>(),
                                     state[2],
                                     state[3],
                                     static_cast<SideEnum>(state[4].cast<int>()),
                                     static_cast<FacingEnum>(state[5].cast<int>()),
                                     static_cast<DirectionEnum>(state[7].cast<int>()),
                                     static_cast<FrontalSourceEnum>(state[8].cast<int>()),
                                     static_cast<PatientLeftEnum>(state[9].cast<int>()));
        SetPose(*geometry, state[6].cast<DoubleArray>());
        return geometry;
      }));
}
} // namespace dentalscr

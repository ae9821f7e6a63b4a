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
#include "dentalscrLandmarks.h"

#include "itkDentalPhantomCaseSource.h"
#include "itkDentalPhantomCaseWriter.h"
#include "itkDentalPhantomMeshSource.h"
#include "itkDentalPhantomStandardTracing.h"

#include <sstream>
#include <stdexcept>

namespace dentalscr
{
namespace
{
using SourceType = itk::DentalPhantomCaseSource;
using MeshSourceType = itk::DentalPhantomMeshSource<MeshType>;
using ParametersType = itk::DentalPhantomParameters;
using CohortEnum = SourceType::CohortEnum;
using FrameEnum = SourceType::FrameEnum;
using FamilyEnum = ParametersType::ArchFamilyEnum;
using GeometryType = itk::CephalometricGeometry;
using JawEnum = itk::ToothCode::JawEnum;

unsigned int
ToNumber(JawEnum jaw)
{
  return jaw == JawEnum::Lower ? 1 : 0;
}

GeometryType::Pointer
Copy(const GeometryType * geometry)
{
  auto copy = GeometryType::New();
  copy->CopyParameters(geometry);
  return copy;
}

/** FDI numbers to the parameters' right 1..7, left 1..7 and back. */
std::vector<unsigned int>
GetMissingTeeth(const ParametersType & self)
{
  const unsigned int        quadrant[2][2] = { { 1, 2 }, { 4, 3 } };
  std::vector<unsigned int> teeth;
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    for (unsigned int i = 0; i < 14; ++i)
    {
      if (self.jaws[jaw].teeth[i].missing)
      {
        teeth.push_back(10 * quadrant[jaw][i / 7] + i % 7 + 1);
      }
    }
  }
  return teeth;
}

void
SetMissingTeeth(ParametersType & self, const std::vector<unsigned int> & teeth)
{
  ParametersType changed = self;
  for (auto & jaw : changed.jaws)
  {
    for (auto & tooth : jaw.teeth)
    {
      tooth.missing = false;
    }
  }
  for (const unsigned int fdi : teeth)
  {
    const unsigned int quadrant = fdi / 10;
    const unsigned int position = fdi % 10;
    if (quadrant < 1 || quadrant > 4 || position < 1 || position > 7)
    {
      throw std::invalid_argument("a phantom has no tooth " + std::to_string(fdi) +
                                  "; FDI numbers 11-17, 21-27, 31-37, 41-47 are known");
    }
    const bool right = quadrant == 1 || quadrant == 4;
    changed.jaws[quadrant > 2 ? 1 : 0].teeth[(right ? 0 : 7) + position - 1].missing = true;
  }
  self = changed;
}

ImageType::Pointer
ToGrey(const SourceType::ImageType * image)
{
  auto result = ImageType::New();
  result->SetRegions(image->GetBufferedRegion());
  result->SetSpacing(image->GetSpacing());
  result->SetOrigin(image->GetOrigin());
  result->Allocate();
  const auto * from = image->GetBufferPointer();
  std::copy(from, from + image->GetBufferedRegion().GetNumberOfPixels(), result->GetBufferPointer());
  return result;
}
} // namespace

void
WrapPhantom(py::module_ & module)
{
  BindEnum<CohortEnum>(module,
                       "PhantomCohort",
                       { { "Ideal", CohortEnum::Ideal },
                         { "Typical", CohortEnum::Typical },
                         { "Hard", CohortEnum::Hard },
                         { "Real", CohortEnum::Real },
                         { "RealHard", CohortEnum::RealHard },
                         { "Standard", CohortEnum::Standard },
                         { "Practice", CohortEnum::Practice } },
                       "The level of a simulated case: how well it is taken and traced, and the arches that it is of.");
  BindEnum<FrameEnum>(module,
                      "PhantomFrame",
                      { { "Anatomical", FrameEnum::Anatomical },
                        { "SharedScanner", FrameEnum::SharedScanner },
                        { "SeparateScanner", FrameEnum::SeparateScanner } },
                      "The frame of a phantom's meshes.");
  BindEnum<FamilyEnum>(
    module,
    "PhantomArchFamily",
    { { "Tapered", FamilyEnum::Tapered }, { "Ovoid", FamilyEnum::Ovoid }, { "Square", FamilyEnum::Square } },
    "The shape of a phantom's arches.");
  py::class_<ParametersType>(module, "DentalPhantomParameters", "What shapes a pair of phantom jaws; mm and radians.")
    .def(py::init<>())
    .def_static(
      "Draw", [](std::uint64_t seed) { return ParametersType::Draw(seed); }, py::arg("seed"), "One of a kind.")
    .def("Validate", &ParametersType::Validate, "Raises where no jaws can be made of it.")
    .def("SetMissingTeeth",
         &SetMissingTeeth,
         py::arg("teeth"),
         "FDI numbers: 11-17, 21-27, 31-37, 41-47. All others are there.")
    .def("GetMissingTeeth", &GetMissingTeeth, "FDI numbers of the teeth that the jaws lack.")
    .def_readwrite("archFamily", &ParametersType::archFamily, "The shape of the arch.")
    .def_readwrite("archExponent",
                   &ParametersType::archExponent,
                   "Exponent p of the arch ``|y/w|^p + |x/d|^p = 1``: 2 is an ellipse, more is squarer.")
    .def_readwrite("archCoverage",
                   &ParametersType::archCoverage,
                   "How far along a quarter of the arch's curve the second molar ends: less is more tapered.")
    .def_readwrite("archHalfWidth",
                   &ParametersType::archHalfWidth,
                   "Half the width of the upper arch between the crown lines at the distal ends of the second "
                   "molars, mm.")
    .def_readwrite(
      "overjet", &ParametersType::overjet, "How far the upper incisors stand in front of the lower ones, mm.")
    .def_readwrite("overbite", &ParametersType::overbite, "How far the upper incisors cover the lower ones, mm.")
    .def_readwrite("speeDepth", &ParametersType::speeDepth, "Depth of the curve of Spee, mm.")
    .def_readwrite("wilson", &ParametersType::wilson, "Curve of Wilson: factor on the molars' transverse inclination.")
    .def_readwrite(
      "stoneBase", &ParametersType::stoneBase, "Whether the scan is a trimmed plaster cast, a closed body with a base.")
    .def_readwrite("baseHeight", &ParametersType::baseHeight, "Thickness of the base below the deepest gingiva, mm.")
    .def_readwrite(
      "scannerNoise", &ParametersType::scannerNoise, "Standard deviation of the scan along its normals, mm.")
    .def_readwrite("noiseSeed", &ParametersType::noiseSeed, "Seed of the scan's noise.")
    .def_readwrite("frame", &ParametersType::frame, "The frame that the meshes come in.")
    .def_readwrite("frameSeed", &ParametersType::frameSeed, "Seed of the frame, where it is drawn.")
    .def_readwrite(
      "numberOfTriangles", &ParametersType::numberOfTriangles, "Triangles of each jaw, reached within 10 %.")
    .def("__repr__", [](const ParametersType & self) {
      std::ostringstream text;
      self.Print(text, "  ");
      return "<dentalscr.DentalPhantomParameters\n" + text.str() + ">";
    });

  ProcessClass<MeshSourceType>(module, "DentalPhantomMeshSource", "A pair of parametric arches in occlusion.")
    .def(New<MeshSourceType>())
    .def("SetParameters",
         &MeshSourceType::SetParameters,
         py::arg("parameters"),
         "Sets what to make. The default is an average pair of jaws in the anatomical frame.")
    .def(
      "GetParameters", [](const MeshSourceType & self) { return self.GetParameters(); }, "A copy.")
    .def("DrawParameters",
         &MeshSourceType::DrawParameters,
         py::arg("seed"),
         "Draws parameters of a kind for a seed; the same seed gives the same jaws.")
    .def("_TakeMesh",
         [](MeshSourceType & self, JawEnum jaw) {
           return Detach(jaw == JawEnum::Lower ? self.GetLowerOutput() : self.GetUpperOutput());
         })
    .def("_GetLandmarks", [](MeshSourceType & self, JawEnum jaw) {
      return ToDict<3>(jaw == JawEnum::Lower ? self.GetLowerLandmarks() : self.GetUpperLandmarks());
    });

  ProcessClass<SourceType>(module, "DentalPhantomCaseSource", "A simulated case for a seed, with the truth.")
    .def(New<SourceType>())
    .dentalscrProperty(SourceType, Seed, "the seed: the same one gives the same case.")
    .def("SetCohort",
         &SourceType::SetCohort,
         py::arg("cohort"),
         "Sets the level's table of parameters; Typical by default. It sets traced side, frame and "
         "number of triangles too, hence comes first.")
    .def("GetCohort",
         &SourceType::GetCohort,
         "Returns the level's table of parameters; Typical by default. It sets traced side, frame and "
         "number of triangles too, hence comes first.")
    .def("SetTracedSide",
         &SourceType::SetTracedSide,
         py::arg("side"),
         "Sets the patient's side whose outline is traced; Right by default.")
    .def("GetTracedSide",
         &SourceType::GetTracedSide,
         "Returns the patient's side whose outline is traced; Right by default.")
    .dentalscrBoolean(SourceType,
                      BuccalOutline,
                      "whether the tracing follows the buccal cusps of premolars and molars, which lie inside the "
                      "silhouette where the oral ones hang lower. Off by default.")
    .dentalscrProperty(SourceType,
                       ToothBias,
                       "the error with which each tooth is drawn, as a factor on 1.2 px shift, 2 degrees and 3 % "
                       "scale (standard deviations); 0 by default.")
    .dentalscrProperty(SourceType, DropOutFraction, "the part of each tooth's border that is not drawn; 0 by default.")
    .dentalscrProperty(SourceType,
                       AdditionalYaw,
                       "the turn of the head about the vertical axis beyond what the level draws, rad; 0 by default.")
    .dentalscrProperty(SourceType,
                       AdditionalRoll,
                       "the turn of the head about the anterior axis beyond what the level draws, rad; 0 by default.")
    .dentalscrProperty(SourceType,
                       MissingTeeth,
                       "the FDI numbers of teeth that the jaws lack beyond what the level draws; none by default.")
    .dentalscrProperty(
      SourceType, UpperNumberOfPoints, "the number of points of the upper tracing; 79 by default, as in the paper.")
    .dentalscrProperty(
      SourceType, LowerNumberOfPoints, "the number of points of the lower tracing; 75 by default, as in the paper.")
    .def("SetFacing",
         &SourceType::SetFacing,
         py::arg("facing"),
         "Sets the side of the image to which the face looks; Right by default.")
    .def(
      "GetFacing", &SourceType::GetFacing, "Returns the side of the image to which the face looks; Right by default.")
    .def("SetSourceSide",
         &SourceType::SetSourceSide,
         py::arg("side"),
         "Sets the patient's side at which the source is; Right by default.")
    .def("GetSourceSide",
         &SourceType::GetSourceSide,
         "Returns the patient's side at which the source is; Right by default.")
    .def("SetFrame", &SourceType::SetFrame, py::arg("frame"), "Sets the frame of the meshes; SharedScanner by default.")
    .def("GetFrame", &SourceType::GetFrame, "Returns the frame of the meshes; SharedScanner by default.")
    .dentalscrBoolean(
      SourceType, StoneBase, "whether the scans are closed casts with bases instead of open shells. Off by default.")
    .dentalscrProperty(
      SourceType, NumberOfTriangles, "the number of triangles of each jaw, from 2000 to 4000000; 60000 by default.")
    .def("SetImageSize",
         &SourceType::SetImageSize,
         py::arg("size"),
         "Sets the width and height of the radiograph, pixels; 703 by 938 by default.")
    .def(
      "GetImageSize",
      [](const SourceType & self) { return self.GetImageSize(); },
      "Returns the width and height of the radiograph, pixels; 703 by 938 by default.")
    .dentalscrBoolean(
      SourceType, MakeRadiograph, "whether the radiograph is simulated, which costs most of the time. On by default.")
    .def(
      "GetParameters", [](const SourceType & self) { return self.GetParameters(); }, "What was drawn; a copy.")
    .def("_TakeMesh", [](SourceType & self, JawEnum jaw) { return Detach(self.GetMesh(ToNumber(jaw))); })
    .def("_TakeTracing", [](SourceType & self, JawEnum jaw) { return Detach(self.GetTracing(ToNumber(jaw))); })
    .def("_TakeTrueTracing",
         [](SourceType & self, JawEnum jaw) {
           auto copy = itk::DentalContour::New();
           for (const auto & polyline : self.GetTrueTracing(ToNumber(jaw))->GetPolylines())
           {
             copy->AddPolyline(polyline);
           }
           return copy;
         })
    .def("_GetLandmarks3D",
         [](SourceType & self, JawEnum jaw) { return ToDict<3>(self.GetLandmarks3D(ToNumber(jaw))); })
    .def("_GetLandmarks2D",
         [](SourceType & self, JawEnum jaw) { return ToDict<2>(self.GetLandmarks2D(ToNumber(jaw))); })
    .def("_GetCephalometricLandmarks",
         [](SourceType & self) -> py::object {
           if (self.GetStandardTracing() == nullptr || !self.GetLevel().giveLandmarks)
           {
             return py::none();
           }
           py::dict landmarks;
           for (const auto & landmark : self.GetStandardTracing()->GetLandmarks())
           {
             landmarks[py::str(landmark.name)] = py::make_tuple(landmark.drawn[0], landmark.drawn[1]);
           }
           return std::move(landmarks);
         })
    .def("_GetTrueGeometry", [](SourceType & self, JawEnum jaw) { return Copy(self.GetTrueGeometry(ToNumber(jaw))); })
    .def("_GetNominalGeometry", [](SourceType & self) { return Copy(self.GetNominalGeometry()); })
    .def("_GetRadiograph",
         [](SourceType & self) -> ImageType::Pointer {
           return self.GetMakeRadiograph() ? ToGrey(self.GetRadiograph()) : nullptr;
         })
    .def(
      "_Write",
      [](SourceType & self, const std::string & folder, const std::string & meshExtension) {
        auto writer = itk::DentalPhantomCaseWriter::New();
        writer->SetCaseSource(&self);
        writer->SetDirectoryName(folder);
        writer->SetMeshExtension(meshExtension);
        Run(&self, [&]() { writer->Write(); });
      },
      py::arg("folder"),
      py::arg("meshExtension"));
}
} // namespace dentalscr

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
#include "dentalscrLandmarks.h"

#include "itkDentalPhantomCaseSource.h"
#include "itkDentalPhantomCaseWriter.h"
#include "itkDentalPhantomMeshSource.h"

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

template <typename TOutput>
itk::SmartPointer<TOutput>
Detach(TOutput * output)
{
  itk::SmartPointer<TOutput> result = output;
  result->DisconnectPipeline();
  return result;
}

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
  BindEnum<CohortEnum>(
    module,
    "PhantomCohort",
    { { "Ideal", CohortEnum::Ideal }, { "Typical", CohortEnum::Typical }, { "Hard", CohortEnum::Hard } },
    "How well a simulated case is taken and traced.");
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
    .def("GetMissingTeeth", &GetMissingTeeth)
    .def_readwrite("archFamily", &ParametersType::archFamily)
    .def_readwrite("archExponent", &ParametersType::archExponent)
    .def_readwrite("archCoverage", &ParametersType::archCoverage)
    .def_readwrite("archHalfWidth", &ParametersType::archHalfWidth)
    .def_readwrite("overjet", &ParametersType::overjet)
    .def_readwrite("overbite", &ParametersType::overbite)
    .def_readwrite("speeDepth", &ParametersType::speeDepth)
    .def_readwrite("wilson", &ParametersType::wilson)
    .def_readwrite("stoneBase", &ParametersType::stoneBase)
    .def_readwrite("baseHeight", &ParametersType::baseHeight)
    .def_readwrite("scannerNoise", &ParametersType::scannerNoise)
    .def_readwrite("noiseSeed", &ParametersType::noiseSeed)
    .def_readwrite("frame", &ParametersType::frame)
    .def_readwrite("frameSeed", &ParametersType::frameSeed)
    .def_readwrite("numberOfTriangles", &ParametersType::numberOfTriangles)
    .def("__repr__", [](const ParametersType & self) {
      std::ostringstream text;
      self.Print(text, "  ");
      return "<dentalscr.DentalPhantomParameters\n" + text.str() + ">";
    });

  ProcessClass<MeshSourceType>(module, "DentalPhantomMeshSource", "A pair of parametric arches in occlusion.")
    .def(New<MeshSourceType>())
    .def("SetParameters", &MeshSourceType::SetParameters, py::arg("parameters"))
    .def(
      "GetParameters", [](const MeshSourceType & self) { return self.GetParameters(); }, "A copy.")
    .def("DrawParameters", &MeshSourceType::DrawParameters, py::arg("seed"))
    .def("_TakeMesh",
         [](MeshSourceType & self, JawEnum jaw) {
           return Detach(jaw == JawEnum::Lower ? self.GetLowerOutput() : self.GetUpperOutput());
         })
    .def("_GetLandmarks", [](MeshSourceType & self, JawEnum jaw) {
      return ToDict<3>(jaw == JawEnum::Lower ? self.GetLowerLandmarks() : self.GetUpperLandmarks());
    });

  ProcessClass<SourceType>(module, "DentalPhantomCaseSource", "A simulated case for a seed, with the truth.")
    .def(New<SourceType>())
    .dentalscrProperty(SourceType, Seed)
    .def("SetCohort", &SourceType::SetCohort, py::arg("cohort"))
    .def("GetCohort", &SourceType::GetCohort)
    .def("SetTracedSide", &SourceType::SetTracedSide, py::arg("side"))
    .def("GetTracedSide", &SourceType::GetTracedSide)
    .dentalscrBoolean(SourceType, BuccalOutline)
    .dentalscrProperty(SourceType, ToothBias)
    .dentalscrProperty(SourceType, DropOutFraction)
    .dentalscrProperty(SourceType, AdditionalYaw)
    .dentalscrProperty(SourceType, AdditionalRoll)
    .dentalscrProperty(SourceType, MissingTeeth)
    .dentalscrProperty(SourceType, UpperNumberOfPoints)
    .dentalscrProperty(SourceType, LowerNumberOfPoints)
    .def("SetFacing", &SourceType::SetFacing, py::arg("facing"))
    .def("GetFacing", &SourceType::GetFacing)
    .def("SetSourceSide", &SourceType::SetSourceSide, py::arg("side"))
    .def("GetSourceSide", &SourceType::GetSourceSide)
    .def("SetFrame", &SourceType::SetFrame, py::arg("frame"))
    .def("GetFrame", &SourceType::GetFrame)
    .dentalscrBoolean(SourceType, StoneBase)
    .dentalscrProperty(SourceType, NumberOfTriangles)
    .def("SetImageSize", &SourceType::SetImageSize, py::arg("size"))
    .def("GetImageSize", [](const SourceType & self) { return self.GetImageSize(); })
    .dentalscrBoolean(SourceType, MakeRadiograph)
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

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
#ifndef dentalscrPoseConversions_h
#define dentalscrPoseConversions_h

#include "dentalscrConversions.h"

#include "itkCephalometricLandmarkSet.h"
#include "itkLandmarkCounterpartSet.h"
#include "itkRegistrationVerdict.h"
#include "itkToothCrownSet.h"

#include "itkDataObjectDecorator.h"
#include "itkVersorRigid3DTransform.h"

/** What the bindings around a registration of poses make of Python's objects, and back. */
namespace dentalscr
{
using RigidType = itk::VersorRigid3DTransform<double>;
using FrameType = itk::DataObjectDecorator<RigidType>;

inline itk::ToothCode::JawEnum
Checked(itk::ToothCode::JawEnum jaw)
{
  if (jaw == itk::ToothCode::JawEnum::Unknown)
  {
    throw std::invalid_argument("a jaw is Upper or Lower here");
  }
  return jaw;
}

inline const char *
ToText(itk::RegistrationStatusEnum status)
{
  return status == itk::RegistrationStatusEnum::Ok        ? "ok"
         : status == itk::RegistrationStatusEnum::Suspect ? "suspect"
                                                          : "failed";
}

/** A frame as the input of a filter: the transform is shared, so that it maps with the same bits. */
inline FrameType::Pointer
ToFrame(const RigidType * transform)
{
  if (transform == nullptr)
  {
    return nullptr;
  }
  auto frame = FrameType::New();
  frame->Set(transform);
  return frame;
}

inline std::vector<itk::ToothCode>
ToTeeth(const std::vector<std::string> & codes)
{
  std::vector<itk::ToothCode> teeth;
  for (const std::string & code : codes)
  {
    teeth.push_back(itk::ToothCode::FromString(code, itk::ToothCode::NumberingEnum::Quadrant));
  }
  return teeth;
}

/** What FindLandmarkCounterparts() of the Python package gives, as the method takes it. */
inline itk::LandmarkCounterpartSet::Pointer
ToCounterparts(const py::dict & counterparts)
{
  using SetType = itk::LandmarkCounterpartSet;
  auto made = SetType::New();
  for (const auto & item : counterparts)
  {
    const auto               values = item.second.cast<py::tuple>();
    const auto               points = values[0].cast<py::array_t<double, py::array::c_style | py::array::forcecast>>();
    SetType::CounterpartType counterpart;
    counterpart.name = item.first.cast<std::string>();
    counterpart.jaw = itk::CephalometricLandmarkSet::ParseName(counterpart.name).jaw;
    if (points.ndim() != 2 || points.shape(1) != 3)
    {
      throw std::invalid_argument("the points of " + counterpart.name + " are (1 or 2, 3)");
    }
    for (py::ssize_t i = 0; i < points.shape(0); ++i)
    {
      counterpart.points.emplace_back(points.data(i, 0));
    }
    const auto rule = values[1].cast<std::string>();
    if (rule != "foremost" && rule != "middle")
    {
      throw std::invalid_argument("the rule of " + counterpart.name + " is foremost or middle, not " + rule);
    }
    counterpart.rule = rule == "foremost" ? SetType::RuleEnum::Foremost : SetType::RuleEnum::Middle;
    counterpart.sigmaAlong = values[2].cast<double>();
    counterpart.sigmaAcross = values[3].cast<double>();
    counterpart.source = values[4].cast<std::string>();
    made->Add(counterpart);
  }
  return made;
}

/** What FindToothCrowns() of the Python package gives. */
inline itk::ToothCrownSet::Pointer
ToCrowns(const py::dict & crowns)
{
  auto made = itk::ToothCrownSet::New();
  for (const auto & item : crowns)
  {
    const auto values = item.second.cast<py::tuple>();
    const auto points = values[0].cast<py::array_t<double, py::array::c_style | py::array::forcecast>>();
    const auto triangles = values[1].cast<py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>>();
    const auto name = item.first.cast<std::string>();
    itk::ToothCrownSet::CrownType crown;
    crown.tooth = itk::ToothCode::FromString(name, itk::ToothCode::NumberingEnum::Quadrant);
    if (points.ndim() != 2 || points.shape(1) != 3 || triangles.ndim() != 2 || triangles.shape(1) != 3)
    {
      throw std::invalid_argument("points and triangles of " + name + " are (n, 3) and (m, 3)");
    }
    auto surface = std::make_shared<itk::TriangleSurface>();
    for (py::ssize_t i = 0; i < points.shape(0); ++i)
    {
      surface->points.push_back({ points.at(i, 0), points.at(i, 1), points.at(i, 2) });
    }
    for (py::ssize_t i = 0; i < triangles.shape(0); ++i)
    {
      surface->triangles.push_back({ triangles.at(i, 0), triangles.at(i, 1), triangles.at(i, 2) });
      for (const std::uint32_t corner : surface->triangles.back())
      {
        if (corner >= surface->points.size())
        {
          throw std::invalid_argument("a triangle of " + name + " has a point that is not there");
        }
      }
    }
    crown.surface = surface;
    crown.sigmaAlong = values[2].cast<double>();
    crown.sigmaWidth = values[3].cast<double>();
    crown.source = values[4].cast<std::string>();
    made->Add(crown);
  }
  return made;
}
} // namespace dentalscr

#endif

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
#ifndef dentalscrLandmarks_h
#define dentalscrLandmarks_h

#include "dentalscrBinding.h"

#include "itkCephalometricLandmarkSet.h"
#include "itkDentalLandmarkSet.h"

namespace dentalscr
{
/** Landmarks as Python has them: a dictionary from name to coordinates, in their order. */
template <unsigned int VDimension>
py::dict
ToDict(const itk::DentalLandmarkSet<VDimension> * landmarks)
{
  py::dict result;
  if (landmarks != nullptr)
  {
    for (const auto & landmark : landmarks->GetLandmarks())
    {
      result[py::str(landmark.name)] = MakeArray(std::vector<double>(landmark.point.Begin(), landmark.point.End()));
    }
  }
  return result;
}

template <unsigned int VDimension>
typename itk::DentalLandmarkSet<VDimension>::Pointer
FromDict(const py::dict & landmarks)
{
  auto result = itk::DentalLandmarkSet<VDimension>::New();
  for (const auto & item : landmarks)
  {
    const auto                     name = item.first.cast<std::string>();
    itk::Point<double, VDimension> point;
    try
    {
      point = item.second.cast<itk::Point<double, VDimension>>();
    }
    catch (const py::cast_error &)
    {
      throw std::invalid_argument("landmark " + name + " is not " + std::to_string(VDimension) + " numbers");
    }
    result->AddLandmark(name, point);
  }
  return result;
}

/** Each a dictionary as a file of ours has it: position, and sigma_px and confidence where they are known. */
inline py::dict
ToDict(const itk::CephalometricLandmarkSet * landmarks)
{
  py::dict result;
  if (landmarks != nullptr)
  {
    for (const auto & landmark : landmarks->GetLandmarks())
    {
      py::dict entry;
      entry["position"] = MakeArray(std::vector<double>(landmark.point.Begin(), landmark.point.End()));
      if (landmark.sigma > 0.0)
      {
        entry["sigma_px"] = landmark.sigma;
      }
      if (landmark.confidence >= 0.0)
      {
        entry["confidence"] = landmark.confidence;
      }
      result[py::str(landmark.name)] = entry;
    }
  }
  return result;
}

/** Of entries such as ToDict() makes. */
inline itk::CephalometricLandmarkSet::Pointer
FromCephalometricDict(const py::dict & landmarks)
{
  auto result = itk::CephalometricLandmarkSet::New();
  for (const auto & item : landmarks)
  {
    const auto name = item.first.cast<std::string>();
    const auto entry = item.second.cast<py::dict>();
    const auto number = [&](const char * key, double absent) {
      return entry.contains(key) ? entry[key].cast<double>() : absent;
    };
    itk::CephalometricLandmarkSet::PointType point;
    try
    {
      point = entry["position"].cast<itk::CephalometricLandmarkSet::PointType>();
    }
    catch (const py::cast_error &)
    {
      throw std::invalid_argument("landmark " + name + " is not 2 numbers");
    }
    const double sigma = number("sigma_px", 0.0);
    // 0 stands for "nobody said one", which whoever writes it does not mean.
    if (entry.contains("sigma_px") && !(sigma > 0.0))
    {
      throw std::invalid_argument("the sigma_px of landmark " + name + " is " + std::to_string(sigma) +
                                  ", no standard deviation: give pixels above 0, or leave it out");
    }
    result->AddLandmark(name, point, sigma, number("confidence", -1.0));
  }
  return result;
}
} // namespace dentalscr

#endif

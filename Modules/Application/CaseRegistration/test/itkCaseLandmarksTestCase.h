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
#ifndef itkCaseLandmarksTestCase_h
#define itkCaseLandmarksTestCase_h

#include "itkCaseRegistrationTestCase.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>

/** A case as a cephalometric analysis has it: landmarks, outlines of whole teeth, or both. */
struct LandmarkCase : PhantomCase
{
  using Mark = itk::DentalPhantomStandardTracing::Landmark;

  enum class EvidenceEnum
  {
    Landmarks,
    Outlines,
    Both
  };

  explicit LandmarkCase(std::uint64_t       seed,
                        const std::string & level = "standard",
                        double              errors = 1.0,
                        EvidenceEnum        evidence = EvidenceEnum::Landmarks)
    : PhantomCase(MakeSource(seed, level))
  {
    data->description.tracedSide = itk::TracedSideEnum::Standard;
    data->cephalometricLandmarks = itk::CephalometricLandmarkSet::New();
    for (const Mark & mark : source->GetStandardTracing()->GetLandmarks())
    {
      itk::CephalometricLandmarkSet::PointType point;
      for (unsigned int d = 0; d < 2; ++d)
      {
        point[d] = mark.exact[d] + errors * (mark.drawn[d] - mark.exact[d]);
      }
      data->cephalometricLandmarks->AddLandmark(mark.name, point);
    }
    if (evidence == EvidenceEnum::Outlines)
    {
      data->cephalometricLandmarks = nullptr;
    }
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      data->GetJaw(jaw).contour = nullptr;
      if (evidence != EvidenceEnum::Landmarks)
      {
        auto outlines = itk::DentalContour::New();
        for (const auto & outline : source->GetStandardTracing()->GetOutlines(jaw == JawEnum::Upper ? 0 : 1))
        {
          std::vector<itk::DentalContour::PointType> points;
          for (std::size_t i = 0; i < outline.exact.size(); ++i)
          {
            itk::DentalContour::PointType point;
            for (unsigned int d = 0; d < 2; ++d)
            {
              point[d] = outline.exact[i][d] + errors * (outline.drawn[i][d] - outline.exact[i][d]);
            }
            points.push_back(point);
          }
          outlines->AddPolyline(points, itk::ToothCode(outline.fdi), true);
        }
        data->GetJaw(jaw).contour = outlines;
      }
    }
  }

  static itk::DentalPhantomCaseSource::Pointer
  MakeSource(std::uint64_t seed, const std::string & level)
  {
    auto source = itk::DentalPhantomCaseSource::New();
    source->SetSeed(seed);
    source->SetLevel(itk::DentalPhantomLevel::Named(level));
    source->SetNumberOfTriangles(12000);
    source->SetMakeRadiograph(false);
    source->Update();
    return source;
  }

  /** Moves a mark. */
  void
  Move(const std::string & name, double u, double v)
  {
    auto moved = itk::CephalometricLandmarkSet::New();
    for (const auto & landmark : data->cephalometricLandmarks->GetLandmarks())
    {
      auto point = landmark.point;
      if (landmark.name == name)
      {
        point[0] += u;
        point[1] += v;
      }
      moved->AddLandmark(landmark.name, point, landmark.sigma, landmark.confidence);
    }
    data->cephalometricLandmarks = moved;
  }

  /** Keeps marks whose names begin so. */
  void
  Keep(const std::set<std::string> & names)
  {
    auto kept = itk::CephalometricLandmarkSet::New();
    for (const auto & landmark : data->cephalometricLandmarks->GetLandmarks())
    {
      if (names.count(landmark.name) != 0)
      {
        kept->AddLandmark(landmark.name, landmark.point, landmark.sigma, landmark.confidence);
      }
    }
    data->cephalometricLandmarks = kept;
  }

  itk::CaseResult
  Run() const
  {
    auto registration = itk::CaseRegistration::New();
    registration->SetData(data);
    registration->Update();
    return registration->GetResult();
  }
};

/** Errors of the middles of both sides, of all landmarks of a jaw, pixels: what such drawings determine. By the
 * projection, which a case without landmarks of the scan has as well. */

/** Displacement, pixels, by the middle's name. */
inline std::map<std::string, std::array<double, 2>>
MiddleDisplacements(const LandmarkCase & phantom, const itk::CaseResult & result, itk::ToothCode::JawEnum jaw)
{
  const auto & p = result.jaws.at(jaw).projection;
  const auto * scan = phantom.source->GetLandmarks3D(jaw == itk::ToothCode::JawEnum::Upper ? 0 : 1);
  const auto   errorOf = [&](const std::string & name, double error[2]) {
    const auto * own = scan->Find(name);
    const auto * marked = phantom.marked->Find(name);
    if (own == nullptr || marked == nullptr)
    {
      return false;
    }
    double h[3];
    for (unsigned int row = 0; row < 3; ++row)
    {
      h[row] = p[4 * row + 3];
      for (unsigned int d = 0; d < 3; ++d)
      {
        h[row] += p[4 * row + d] * own->point[d];
      }
    }
    error[0] = h[0] / h[2] - marked->point[0];
    error[1] = h[1] / h[2] - marked->point[1];
    return true;
  };
  std::map<std::string, std::array<double, 2>> errors;
  for (const auto & landmark : scan->GetLandmarks())
  {
    const std::string other = landmark.name[0] + ("L" + landmark.name.substr(2));
    double            right[2], left[2];
    if (landmark.tooth.IsRight() && errorOf(landmark.name, right) && errorOf(other, left))
    {
      errors[landmark.name[0] + landmark.name.substr(2)] = { { 0.5 * (right[0] + left[0]),
                                                               0.5 * (right[1] + left[1]) } };
    }
  }
  return errors;
}

/** Distance, pixels, by the middle's name. */
inline std::map<std::string, double>
MiddleErrors(const LandmarkCase & phantom, const itk::CaseResult & result, itk::ToothCode::JawEnum jaw)
{
  std::map<std::string, double> errors;
  for (const auto & [name, displacement] : MiddleDisplacements(phantom, result, jaw))
  {
    errors[name] = std::hypot(displacement[0], displacement[1]);
  }
  return errors;
}

/** Mean displacement of a jaw's middles, pixels. */
inline std::array<double, 2>
MiddleBias(const LandmarkCase & phantom, const itk::CaseResult & result, itk::ToothCode::JawEnum jaw)
{
  std::array<double, 2> mean{};
  const auto            displacements = MiddleDisplacements(phantom, result, jaw);
  for (const auto & entry : displacements)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      mean[d] += entry.second[d] / static_cast<double>(displacements.size());
    }
  }
  return mean;
}

inline double
MiddleError(const LandmarkCase & phantom, const itk::CaseResult & result, itk::ToothCode::JawEnum jaw)
{
  double     sum = 0.0;
  const auto errors = MiddleErrors(phantom, result, jaw);
  for (const auto & error : errors)
  {
    sum += error.second;
  }
  return errors.empty() ? std::numeric_limits<double>::infinity() : sum / static_cast<double>(errors.size());
}

#endif

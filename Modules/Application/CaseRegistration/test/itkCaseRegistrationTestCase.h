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
#ifndef itkCaseRegistrationTestCase_h
#define itkCaseRegistrationTestCase_h

#include "itkCaseRegistration.h"
#include "itkCaseResultWriter.h"
#include "itkMeasureLandmarkErrors.h"
#include "itkDentalPhantomCaseSource.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

/** A phantom case in memory; the 2-D landmarks stay outside of it. */
struct PhantomCase
{
  using JawEnum = itk::ToothCode::JawEnum;
  using SideEnum = itk::DentalPhantomCaseSource::TracedSideEnum;

  explicit PhantomCase(std::uint64_t seed,
                       SideEnum      side = SideEnum::Right,
                       unsigned int  numberOfTriangles = 12000,
                       bool          stoneBase = false)
  {
    auto phantom = itk::DentalPhantomCaseSource::New();
    phantom->SetSeed(seed);
    phantom->SetTracedSide(side);
    phantom->SetNumberOfTriangles(numberOfTriangles);
    phantom->SetStoneBase(stoneBase);
    phantom->SetMakeRadiograph(false);
    phantom->Update();
    this->Fill(phantom);
  }

  explicit PhantomCase(itk::DentalPhantomCaseSource * phantom) { this->Fill(phantom); }

  void
  Fill(itk::DentalPhantomCaseSource * phantom)
  {
    source = phantom;
    data = std::make_shared<itk::DentalCaseData>();
    data->geometry = itk::CephalometricGeometry::New();
    data->geometry->CopyParameters(source->GetNominalGeometry());
    data->sources.pixelSpacing = itk::ValueSourceEnum::Given;
    data->sources.principalPoint = itk::ValueSourceEnum::Given;
    data->imageSize = { { 703, 938 } };
    data->landmarks3D = itk::DentalLandmarkSet<3>::New();
    marked = itk::DentalLandmarkSet<2>::New();
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      const unsigned int index = jaw == JawEnum::Upper ? 0 : 1;
      data->GetJaw(jaw).mesh = source->GetMesh(index);
      data->GetJaw(jaw).contour = source->GetTracing(index);
      for (const auto & landmark : source->GetLandmarks3D(index)->GetLandmarks())
      {
        data->landmarks3D->AddLandmark(landmark.name, landmark.point);
      }
      for (const auto & landmark : source->GetLandmarks2D(index)->GetLandmarks())
      {
        marked->AddLandmark(landmark.name, landmark.point);
      }
    }
  }
  std::shared_ptr<itk::DentalCaseData>  data;
  itk::DentalLandmarkSet<2>::Pointer    marked;
  itk::DentalPhantomCaseSource::Pointer source;
};

inline itk::CaseResult
Register(const PhantomCase & phantom, itk::CasePresetEnum preset = itk::CasePresetEnum::Robust)
{
  auto registration = itk::CaseRegistration::New();
  registration->SetPreset(preset);
  registration->SetData(phantom.data);
  registration->Update();
  itk::CaseResult result = registration->GetResult();
  itk::MeasureLandmarkErrors(result, phantom.marked);
  return result;
}
/** A number of the method; NaN where it is not there. */
inline double
Detail(const itk::JawResult & jaw, const std::string & name)
{
  const auto found =
    std::find_if(jaw.details.begin(), jaw.details.end(), [&](const auto & detail) { return detail.first == name; });
  return found != jaw.details.end() ? found->second : std::numeric_limits<double>::quiet_NaN();
}

inline bool
HasLineWith(const std::vector<std::string> & lines, const std::string & words)
{
  return std::any_of(
    lines.begin(), lines.end(), [&](const std::string & line) { return line.find(words) != std::string::npos; });
}

#endif

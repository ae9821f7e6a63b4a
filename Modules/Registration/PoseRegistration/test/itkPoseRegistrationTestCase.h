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
#ifndef itkPoseRegistrationTestCase_h
#define itkPoseRegistrationTestCase_h

#include "itkDentalPhantomCaseSource.h"
#include "itkMakeTriangleSurface.h"
#include "itkPoseRegistrationKernel.h"

#include <cmath>
#include <map>
#include <string>

/** A phantom case in its anatomical frame as the kernel takes it, with the true places of the landmarks. */
struct PoseRegistrationTestCase
{
  using Source = itk::DentalPhantomCaseSource;

  itk::TriangleSurface                         surfaces[2];
  std::vector<itk::PoseJawInput>               jaws;
  itk::PoseGeometry                            geometry;
  std::map<std::string, std::array<double, 3>> landmarks;
  std::map<std::string, std::array<double, 2>> truth;

  PoseRegistrationTestCase(std::uint64_t          seed,
                           Source::CohortEnum     cohort,
                           Source::TracedSideEnum side,
                           double                 additionalYaw = 0.0,
                           unsigned int           numberOfTriangles = 16000)
  {
    auto source = Source::New();
    source->SetSeed(seed);
    source->SetCohort(cohort);
    source->SetTracedSide(side);
    source->SetAdditionalYaw(additionalYaw);
    source->SetFrame(itk::DentalPhantomParameters::FrameEnum::Anatomical);
    source->SetNumberOfTriangles(numberOfTriangles);
    source->MakeRadiographOff();
    source->Update();
    jaws.resize(2);
    for (unsigned int j = 0; j < 2; ++j)
    {
      surfaces[j] = itk::MakeTriangleSurface(source->GetMesh(j));
      jaws[j].surface = &surfaces[j];
      jaws[j].upper = j == 0;
      for (const auto & polyline : source->GetTracing(j)->GetPolylines())
      {
        itk::PosePolyline converted;
        converted.tooth = polyline.code.GetFDI();
        for (const auto & p : polyline.points)
        {
          converted.points.push_back({ { p[0], p[1] } });
        }
        jaws[j].tracing.push_back(converted);
      }
      for (const auto & landmark : source->GetLandmarks3D(j)->GetLandmarks())
      {
        const auto & p = landmark.point;
        const auto   q = source->GetTrueGeometry(j)->ProjectPoint(p);
        landmarks[landmark.name] = { { p[0], p[1], p[2] } };
        truth[landmark.name] = { { q[0], q[1] } };
      }
    }
    const auto * nominal = source->GetNominalGeometry();
    geometry.sourceToMidsagittal = nominal->GetSourceToMidsagittalDistance();
    geometry.sourceToDetector = nominal->GetSourceToDetectorDistance();
    for (unsigned int d = 0; d < 2; ++d)
    {
      geometry.pixelSpacing[d] = nominal->GetPixelSpacing()[d];
      geometry.principalPoint[d] = nominal->GetPrincipalPoint()[d];
    }
  }
  PoseRegistrationTestCase(const PoseRegistrationTestCase &) = delete;

  /** Mean distance, pixels, over the landmarks of a jaw and side ('R', 'L'). */
  double
  Error(const itk::PoseRegistrationResult & result, unsigned int jaw, char side) const
  {
    const auto & a = result.jaws[jaw].projection;
    double       sum = 0.0;
    unsigned int count = 0;
    for (const auto & landmark : landmarks)
    {
      if ((landmark.first[0] == 'U') != (jaw == 0) || landmark.first[1] != side)
      {
        continue;
      }
      const auto & p = landmark.second;
      const auto & q = truth.at(landmark.first);
      const double w = a[8] * p[0] + a[9] * p[1] + a[10] * p[2] + a[11];
      sum += std::hypot((a[0] * p[0] + a[1] * p[1] + a[2] * p[2] + a[3]) / w - q[0],
                        (a[4] * p[0] + a[5] * p[1] + a[6] * p[2] + a[7]) / w - q[1]);
      ++count;
    }
    return sum / count;
  }
};

#endif

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
#ifndef itkPosePhantom_h
#define itkPosePhantom_h

#include "itkDentalPhantomCaseSource.h"
#include "itkMakeTriangleSurface.h"
#include "itkPoseTypes.h"

#include <array>
#include <map>
#include <string>

/** A phantom case whose meshes are in their dental frame, with everything that is true of it. Of PoseMetric's and
 * PoseRegistration's tests. */
struct PosePhantom
{
  using Source = itk::DentalPhantomCaseSource;
  using GeometryType = itk::CephalometricGeometry;

  itk::TriangleSurface                         surfaces[2];
  itk::DentalContour::Pointer                  contours[2];
  GeometryType::Pointer                        nominalGeometry;
  GeometryType::Pointer                        trueGeometry[2];
  itk::PoseGeometry                            geometry;
  std::map<std::string, std::array<double, 3>> landmarks;
  std::map<std::string, std::array<double, 2>> truth;

  PosePhantom(std::uint64_t          seed,
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
    nominalGeometry = source->GetNominalGeometry();
    for (unsigned int j = 0; j < 2; ++j)
    {
      surfaces[j] = itk::MakeTriangleSurface(source->GetMesh(j));
      contours[j] = source->GetTracing(j);
      trueGeometry[j] = source->GetTrueGeometry(j);
      for (const auto & landmark : source->GetLandmarks3D(j)->GetLandmarks())
      {
        const auto & p = landmark.point;
        const auto   q = source->GetTrueGeometry(j)->ProjectPoint(p);
        landmarks[landmark.name] = { { p[0], p[1], p[2] } };
        truth[landmark.name] = { { q[0], q[1] } };
      }
    }
    geometry.sourceToMidsagittal = nominalGeometry->GetSourceToMidsagittalDistance();
    geometry.sourceToDetector = nominalGeometry->GetSourceToDetectorDistance();
    for (unsigned int d = 0; d < 2; ++d)
    {
      geometry.pixelSpacing[d] = nominalGeometry->GetPixelSpacing()[d];
      geometry.principalPoint[d] = nominalGeometry->GetPrincipalPoint()[d];
    }
  }
  PosePhantom(const PosePhantom &) = delete;
};

#endif

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

#include "itkPosePhantom.h"
#include "itkDentalContour.h"
#include "itkPoseRegistrationMethod.h"

#include "itkTriangleCell.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

/** A jaw as flat arrays that a test may bend: the surface in its dental frame, and its tracing. */
struct PoseTestJaw
{
  const itk::TriangleSurface *      surface{ nullptr };
  bool                              upper{ true };
  itk::DentalContour::PolylinesType tracing;
};

/** A phantom case in its anatomical frame, and the registration of it and of what tests make of it. */
struct PoseRegistrationTestCase : PosePhantom
{
  using MeshType = itk::Mesh<double, 3>;
  using MethodType = itk::PoseRegistrationMethod<MeshType>;
  using JawEnum = MethodType::JawEnum;
  using JawsType = std::vector<PoseTestJaw>;

  JawsType jaws;

  PoseRegistrationTestCase(std::uint64_t          seed,
                           Source::CohortEnum     cohort,
                           Source::TracedSideEnum side,
                           double                 additionalYaw = 0.0,
                           unsigned int           numberOfTriangles = 16000)
    : PosePhantom(seed, cohort, side, additionalYaw, numberOfTriangles)
  {
    for (unsigned int j = 0; j < 2; ++j)
    {
      jaws.push_back({ &surfaces[j], j == 0, contours[j]->GetPolylines() });
    }
  }

  /** Double precision: the surface comes back with the same bits. */
  static MeshType::Pointer
  MakeMesh(const itk::TriangleSurface & surface)
  {
    auto mesh = MeshType::New();
    for (std::size_t i = 0; i < surface.points.size(); ++i)
    {
      MeshType::PointType point;
      for (unsigned int d = 0; d < 3; ++d)
      {
        point[d] = surface.points[i][d];
      }
      mesh->SetPoint(i, point);
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      MeshType::CellAutoPointer cell;
      cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
      for (unsigned int corner = 0; corner < 3; ++corner)
      {
        cell->SetPointId(static_cast<int>(corner), surface.triangles[t][corner]);
      }
      mesh->SetCell(t, cell);
    }
    return mesh;
  }

  static itk::DentalContour::Pointer
  MakeContour(const itk::DentalContour::PolylinesType & tracing)
  {
    auto contour = itk::DentalContour::New();
    for (const auto & polyline : tracing)
    {
      contour->AddPolyline(polyline);
    }
    return contour;
  }

  static itk::CephalometricGeometry::Pointer
  MakeGeometry(const itk::PoseGeometry & geometry)
  {
    using GeometryType = itk::CephalometricGeometry;
    auto made = GeometryType::New();
    made->SetSourceToMidsagittalDistance(geometry.sourceToMidsagittal);
    made->SetSourceToDetectorDistance(geometry.sourceToDetector);
    made->SetSourceSide(geometry.sourceSign > 0.0 ? GeometryType::SourceSideEnum::Right
                                                  : GeometryType::SourceSideEnum::Left);
    made->SetFacing(geometry.facingSign > 0.0 ? GeometryType::FacingEnum::Right : GeometryType::FacingEnum::Left);
    GeometryType::PixelSpacingType spacing;
    GeometryType::PixelIndexType   principal;
    for (unsigned int d = 0; d < 2; ++d)
    {
      spacing[d] = geometry.pixelSpacing[d];
      principal[d] = geometry.principalPoint[d];
    }
    if (geometry.pixelSpacingKnown)
    {
      made->SetPixelSpacing(spacing);
    }
    made->SetPrincipalPoint(principal);
    return made;
  }

  /** The registration of these jaws, whose frame is the meshes' own. */
  static MethodType::Pointer
  MakeMethod(const JawsType & jaws, const itk::PoseGeometry & geometry, const itk::PoseRegistrationOptions & options)
  {
    auto method = MethodType::New();
    for (const PoseTestJaw & jaw : jaws)
    {
      if (jaw.upper)
      {
        method->SetUpperMesh(MakeMesh(*jaw.surface));
        method->SetUpperContour(MakeContour(jaw.tracing));
      }
      else
      {
        method->SetLowerMesh(MakeMesh(*jaw.surface));
        method->SetLowerContour(MakeContour(jaw.tracing));
      }
    }
    method->SetGeometry(MakeGeometry(geometry));
    method->SetPrincipalPointKnown(geometry.principalPointKnown);
    auto frame = MethodType::DecoratedTransformType::New();
    frame->Set(MethodType::RigidTransformType::New());
    method->SetJointFrame(frame);
    method->SetOptions(options);
    if (options.numberOfThreads > 0)
    {
      method->SetNumberOfWorkUnits(options.numberOfThreads);
    }
    return method;
  }

  static itk::PoseRegistrationResult
  Run(const JawsType & jaws, const itk::PoseGeometry & geometry, const itk::PoseRegistrationOptions & options)
  {
    const auto method = MakeMethod(jaws, geometry, options);
    method->Update();
    return method->GetOutput()->GetResult();
  }

  /** Covariance of a landmark, square pixels. */
  static itk::PoseSolution::CovarianceType
  LandmarkCovariance(const itk::PoseRegistrationResult & result, unsigned int jaw, const std::array<double, 3> & point)
  {
    auto solution = itk::PoseSolution::New();
    solution->SetResult(result, itk::PoseRegistrationOptions());
    itk::PoseSolution::PointType p;
    std::copy(point.begin(), point.end(), p.Begin());
    return solution->ComputeCovariance(jaw == 0 ? JawEnum::Upper : JawEnum::Lower, p);
  }

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

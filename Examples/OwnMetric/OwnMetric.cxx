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
// A metric of one's own joins the sum that PoseRegistrationMethod minimizes: the incisal edge of the upper scan lies on
// a horizontal plane of the cephalostat whose height somebody has measured, as far as that measurement goes.
#include "itkDentalPhantomCaseSource.h"
#include "itkLeastSquaresFunctionMetricv4.h"
#include "itkPoseModel.h"
#include "itkPoseRegistrationMethod.h"
#include "itkPoseStateBlocks.h"
#include "itkUMidlineDentalAxisFilter.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

/** One residual: (z of a point under the pose - height of the plane) / sigma, in the cephalostat frame. The point is in
 * the dental frame that the pose is of, mm; height and sigma are those of the plane, mm. */
itk::LeastSquaresMetricv4::Pointer
MakePlaneMetric(const itk::Point<double, 3> & point, double height, double sigma)
{
  auto plane = itk::LeastSquaresFunctionMetricv4::New();
  // What the residuals depend on: the pose is pitch, roll, yaw (rad), tx, ty, tz (mm). The scale is a block of its own.
  plane->SetBlocks({ itk::PoseStateBlocks::MakePose() });
  plane->SetFunction([=](const std::vector<double> & x) {
    const itk::PoseModel pose(itk::PoseGeometry(), { { x[0], x[1], x[2], x[3], x[4], x[5], 0.0 } });
    const auto &         r = pose.GetRotation();
    const double         z = r[6] * point[0] + r[7] * point[1] + r[8] * point[2] + x[5];
    return std::vector<double>{ (z - height) / sigma };
  });
  return plane.GetPointer();
}

int
main()
{
  using MeshType = itk::Mesh<float, 3>;
  using JawEnum = itk::ToothCode::JawEnum;
  try
  {
    // A simulated case with a known answer.
    auto phantom = itk::DentalPhantomCaseSource::New();
    phantom->SetSeed(8);
    phantom->MakeRadiographOff();
    phantom->Update();
    auto axis = itk::UMidlineDentalAxisFilter<MeshType>::New();
    axis->SetUpperMesh(phantom->GetMesh(0));
    axis->RefineMidlineOn();
    axis->Update();
    auto registration = itk::PoseRegistrationMethod<MeshType>::New();
    registration->SetUpperMesh(phantom->GetMesh(0));
    registration->SetUpperContour(phantom->GetTracing(0));
    registration->SetUpperFrame(axis->GetUpperTransformOutput());
    registration->SetGeometry(phantom->GetNominalGeometry());

    // The plane goes through the place where the incisal edge truly is, and is known to a tenth of a millimetre.
    const auto   edge = axis->GetIncisalEdge(itk::ToothCode::JawEnum::Upper);
    const double height = phantom->GetTrueGeometry(0)->TransformToCephalostat(edge)[2];
    const auto   plane = MakePlaneMetric(axis->GetUpperTransformOutput()->Get()->TransformPoint(edge), height, 0.1);

    for (const std::string name : { "without", "with" })
    {
      if (name == "with")
      {
        registration->AddMetric(plane);
      }
      registration->Update();
      const char * const parameters[] = { "pitch rad", "roll rad", "yaw rad", "tx mm", "ty mm", "tz mm", "kappa" };
      const auto &       pose = registration->GetOutput()->GetGroup(JawEnum::Upper).parameters;
      for (unsigned int k = 0; k < pose.size(); ++k)
      {
        std::cout << name << ' ' << parameters[k] << ": " << pose[k] << std::endl;
      }
      const auto placed = registration->GetTransform(JawEnum::Upper)->TransformPoint(edge);
      std::cout << name << " edge to plane mm: " << std::abs(placed[2] - height) << std::endl;
    }
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

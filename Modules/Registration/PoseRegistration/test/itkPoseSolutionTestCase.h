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
#ifndef itkPoseSolutionTestCase_h
#define itkPoseSolutionTestCase_h

#include "itkPoseModel.h"
#include "itkPoseSolution.h"
#include "itkReproducibleRandom.h"

#include <array>
#include <cmath>
#include <string>

/** A solution made by hand, nothing registered: both jaws, each with a frame and a pose of its own, in a geometry in
 * which no two lengths are alike. */
namespace PoseSolutionTestCase
{
using SolutionType = itk::PoseSolution;
using JawEnum = SolutionType::JawEnum;
constexpr JawEnum Jaws[] = { JawEnum::Upper, JawEnum::Lower };

inline itk::PoseRegistrationResult
MakeResult(double facingSign = 1.0, double sourceSign = 1.0)
{
  itk::PoseRegistrationResult result;
  result.geometry.sourceToMidsagittal = 1500.0;
  result.geometry.sourceToDetector = 1650.0;
  result.geometry.sourceSign = sourceSign;
  result.geometry.facingSign = facingSign;
  result.geometry.pixelSpacing = { { 0.31, 0.19 } };
  result.geometry.principalPoint = { { 420.0, 530.0 } };
  itk::ReproducibleRandom random(29);
  const double            sigmas[7] = { 0.01, 0.03, 0.04, 0.5, 1.5, 0.4, 0.02 };
  for (unsigned int j = 0; j < 2; ++j)
  {
    itk::PoseGroupResult group;
    group.jaws = { j };
    group.parameters = { { 0.12 - 0.2 * j, 0.06, -0.09 + 0.1 * j, 3.0 - 5.0 * j, 0.8, -2.0 + 4.0 * j, 0.015 } };
    // A covariance with every correlation.
    double root[7][7];
    for (unsigned int a = 0; a < 7; ++a)
    {
      for (unsigned int b = 0; b < 7; ++b)
      {
        root[a][b] = sigmas[a] * (a == b ? 1.0 : random.Uniform(-0.5, 0.5));
      }
    }
    for (unsigned int a = 0; a < 7; ++a)
    {
      for (unsigned int b = 0; b < 7; ++b)
      {
        for (unsigned int k = 0; k < 7; ++k)
        {
          group.covariance[7 * a + b] += root[a][k] * root[b][k];
        }
      }
    }
    group.score = 0.1;
    group.converged = true;
    group.stopCondition = "by hand";

    itk::PoseJawResult jaw;
    jaw.jaw = j == 0 ? itk::ToothCode::JawEnum::Upper : itk::ToothCode::JawEnum::Lower;
    jaw.registered = true;
    // A frame that turns and shifts: rows are the axes.
    jaw.frame.rotation = { { 0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6 } };
    jaw.frame.origin = { { 7.0 + j, -11.0, 4.0 } };
    const itk::PoseModel model(result.geometry, group.parameters);
    jaw.projection = model.GetPixelProjection(jaw.frame);
    for (unsigned int a = 0; a < 3; ++a)
    {
      jaw.translation[a] = group.parameters[itk::PoseTx + a];
      for (unsigned int b = 0; b < 3; ++b)
      {
        for (unsigned int k = 0; k < 3; ++k)
        {
          jaw.rotation[3 * a + b] += model.GetRotation()[3 * a + k] * jaw.frame.rotation[3 * k + b];
        }
        jaw.translation[a] -= jaw.rotation[3 * a + b] * jaw.frame.origin[b];
      }
    }
    jaw.archWidth = 58.0;
    jaw.winding = 0.4;
    jaw.fit.numberOfPoints = 100;
    jaw.fit.cost = 0.1;
    jaw.fit.medianResidual = 0.8;
    jaw.fit.p90Residual = 2.0;
    jaw.fit.inlierShare = 0.98;
    jaw.fit.hasCodes = true;
    jaw.fit.codeOffset = 1.0;
    jaw.fit.predictedSigma = 0.6;
    jaw.fit.extrapolatedSigma = 1.2;
    jaw.contour = { { { 1.0, 2.0 } }, { { 2.0, 2.5 } }, { { 3.5, 2.0 } } };
    result.jaws.push_back(jaw);
    result.groupOfJaw.push_back(j);
    result.groups.push_back(group);
  }
  return result;
}

inline SolutionType::Pointer
MakeSolution(const itk::PoseRegistrationResult & result)
{
  auto solution = SolutionType::New();
  solution->SetResult(result, itk::PoseRegistrationOptions());
  return solution;
}

inline bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}
} // namespace PoseSolutionTestCase

#endif

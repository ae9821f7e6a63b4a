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
#include "dentalscrBinding.h"

#include "itkPoseRegistrationMethod.h"

namespace dentalscr
{
namespace
{
using MethodType = itk::PoseRegistrationMethod<MeshType>;
using OptionsType = itk::PoseRegistrationOptions;
using RigidType = itk::VersorRigid3DTransform<double>;
using itk::RegistrationVerdict;
using StatusEnum = RegistrationVerdict::StatusEnum;
using SideEnum = itk::PoseTracedSideEnum;
using JawEnum = itk::ToothCode::JawEnum;

unsigned int
ToNumber(JawEnum jaw)
{
  if (jaw == JawEnum::Unknown)
  {
    throw std::invalid_argument("a jaw is Upper or Lower here");
  }
  return jaw == JawEnum::Upper ? 0 : 1;
}

const char *
ToText(StatusEnum status)
{
  return status == StatusEnum::Ok ? "ok" : status == StatusEnum::Suspect ? "suspect" : "failed";
}

py::dict
ToDict(const itk::PoseFitStatistics & fit)
{
  py::dict result;
  result["numberOfPoints"] = fit.numberOfPoints;
  result["cost"] = fit.cost;
  result["medianResidual"] = fit.medianResidual;
  result["rmsResidual"] = fit.rmsResidual;
  result["p90Residual"] = fit.p90Residual;
  result["inlierShare"] = fit.inlierShare;
  result["overlap"] = fit.overlap;
  result["codeOffset"] = fit.codeOffset;
  result["predictedSigma"] = fit.predictedSigma;
  result["extrapolatedSigma"] = fit.extrapolatedSigma;
  return result;
}

itk::PoseFrame
ToFrame(const RigidType & transform)
{
  // q = R p + b = R (p - o), o = -R' b.
  itk::PoseFrame frame;
  const auto &   rotation = transform.GetMatrix();
  const auto &   offset = transform.GetOffset();
  for (unsigned int row = 0; row < 3; ++row)
  {
    frame.origin[row] = 0.0;
    for (unsigned int column = 0; column < 3; ++column)
    {
      frame.rotation[3 * row + column] = rotation(row, column);
      frame.origin[row] -= rotation(column, row) * offset[column];
    }
  }
  return frame;
}

py::dict
GetJaw(MethodType & self, JawEnum name)
{
  const unsigned int jaw = ToNumber(name);
  py::dict           result;
  const int          index = self.GetResultIndex(jaw);
  if (index < 0)
  {
    return result;
  }
  const itk::PoseJawResult & found = self.GetResult().jaws[static_cast<std::size_t>(index)];
  result["registered"] = found.registered;
  result["failure"] = found.failure;
  const auto & verdict = self.GetVerdict(jaw);
  result["status"] = ToText(verdict.status);
  py::list reasons;
  for (const auto & reason : verdict.reasons)
  {
    reasons.append(py::make_tuple(reason.code, reason.text));
  }
  result["reasons"] = py::tuple(reasons);
  if (!found.registered)
  {
    return result;
  }
  auto transform = RigidType::New();
  transform->SetFixedParameters(self.GetTransform(jaw)->GetFixedParameters());
  transform->SetParameters(self.GetTransform(jaw)->GetParameters());
  auto geometry = itk::CephalometricGeometry::New();
  geometry->CopyParameters(self.GetGeometryOutput(jaw));
  result["transform"] = transform;
  result["geometry"] = geometry;
  result["projection"] = MakeMatrix34(found.projection);
  result["contour"] = MakeRows<2>(found.contour);
  result["contourPoints"] = MakeRows<3>(found.contourPoints);
  result["fit"] = ToDict(found.fit);
  return result;
}
} // namespace

void
WrapPoseRegistration(py::module_ & module)
{
  BindEnum<SideEnum>(module,
                     "TracedSide",
                     { { "Right", SideEnum::Right },
                       { "Left", SideEnum::Left },
                       { "Mean", SideEnum::Mean },
                       { "Both", SideEnum::Both } },
                     "Which side's outline was traced.");
  py::class_<OptionsType>(module,
                          "PoseRegistrationOptions",
                          "Every ingredient of the robust method; lengths in px of 0.25 mm, angles in rad.")
    .def(py::init<>())
    .def_readwrite("tracedSide", &OptionsType::tracedSide)
    .def_readwrite("useSideSelection", &OptionsType::useSideSelection)
    .def_readwrite("midlineMargin", &OptionsType::midlineMargin)
    .def_readwrite("useFacingFilter", &OptionsType::useFacingFilter)
    .def_readwrite("useOrientation", &OptionsType::useOrientation)
    .def_readwrite("orientationWeight", &OptionsType::orientationWeight)
    .def_readwrite("useCorrelatedNoise", &OptionsType::useCorrelatedNoise)
    .def_readwrite("correlationLength", &OptionsType::correlationLength)
    .def_readwrite("covarianceCorrelationLength", &OptionsType::covarianceCorrelationLength)
    .def_readwrite("covarianceInflation", &OptionsType::covarianceInflation)
    .def_readwrite("estimateNoise", &OptionsType::estimateNoise)
    .def_readwrite("initialSmoothSigma", &OptionsType::initialSmoothSigma)
    .def_readwrite("initialWhiteSigma", &OptionsType::initialWhiteSigma)
    .def_readwrite("useRobustKernel", &OptionsType::useRobustKernel)
    .def_readwrite("useFullPose", &OptionsType::useFullPose)
    .def_readwrite("useJointPose", &OptionsType::useJointPose)
    .def_readwrite("yawStarts", &OptionsType::yawStarts)
    .def_readwrite("startsPerYaw", &OptionsType::startsPerYaw)
    .def_readwrite("codeWeight", &OptionsType::codeWeight)
    .def_readwrite("regenerateOutline", &OptionsType::regenerateOutline)
    .def_readwrite("maximumEvaluations", &OptionsType::maximumEvaluations)
    .def_readwrite("rollSigma", &OptionsType::rollSigma)
    .def_readwrite("yawSigma", &OptionsType::yawSigma)
    .def_readwrite("tySigma", &OptionsType::tySigma)
    .def_readwrite("kappaSigma", &OptionsType::kappaSigma)
    .def_readwrite("kappaSigmaWithoutSpacing", &OptionsType::kappaSigmaWithoutSpacing)
    .def_readwrite("unobservedRotationSigma", &OptionsType::unobservedRotationSigma)
    .def_readwrite("heldPitchSigma", &OptionsType::heldPitchSigma)
    .def_readwrite("heldTranslationSigma", &OptionsType::heldTranslationSigma)
    .def_readwrite("checkHypotheses", &OptionsType::checkHypotheses)
    .def_readwrite("poorScore", &OptionsType::poorScore)
    .def_readwrite("fixScale", &OptionsType::fixScale)
    .def_readwrite("fixRotation", &OptionsType::fixRotation)
    .def_readwrite("fixTranslation", &OptionsType::fixTranslation)
    .def_readwrite("maximumTracingPoints", &OptionsType::maximumTracingPoints)
    .def_property(
      "excludedTeeth",
      [](const OptionsType & self) { return std::vector<int>(self.excludedTeeth.begin(), self.excludedTeeth.end()); },
      [](OptionsType & self, const std::vector<int> & teeth) { self.excludedTeeth.assign(teeth.begin(), teeth.end()); },
      "FDI numbers; a copy.");

  ProcessClass<MethodType>(module, "PoseRegistrationMethod", "The robust registration.")
    .def(New<MethodType>())
    .def("_SetUpperMesh", &MethodType::SetUpperMesh, py::arg("mesh"))
    .def("_SetLowerMesh", &MethodType::SetLowerMesh, py::arg("mesh"))
    .def("_SetUpperContour", &MethodType::SetUpperContour, py::arg("contour"))
    .def("_SetLowerContour", &MethodType::SetLowerContour, py::arg("contour"))
    .def("_SetGeometry", &MethodType::SetGeometry, py::arg("geometry"))
    .def("SetOptions", &MethodType::SetOptions, py::arg("options"))
    .def(
      "GetOptions", [](const MethodType & self) { return self.GetOptions(); }, "A copy.")
    .def("SetTracedSide", &MethodType::SetTracedSide, py::arg("side"))
    .def("GetTracedSide", &MethodType::GetTracedSide)
    .dentalscrBoolean(MethodType, PrincipalPointKnown)
    .def(
      "_SetFrames",
      [](MethodType & self, const RigidType & upper, const RigidType & lower, bool jawsShareFrame) {
        self.SetFrames(ToFrame(upper), ToFrame(lower), jawsShareFrame);
      },
      py::arg("upper"),
      py::arg("lower"),
      py::arg("jawsShareFrame"))
    .def("EstimateFrames", &MethodType::EstimateFrames, "Back from given frames to estimated ones, the default.")
    .def("GetJawsShareFrame", &MethodType::GetJawsShareFrame)
    .def("GetCurrentLevel", &MethodType::GetCurrentLevel, "0 start, 1 candidates, 2 refinement, 3 uncertainty.")
    .def("_GetJaw", &GetJaw, py::arg("jaw"))
    .def(
      "ComputeLandmarkCovariance",
      [](const MethodType & self, JawEnum jaw, const itk::Point<double, 3> & point) {
        const auto covariance = self.ComputeLandmarkCovariance(ToNumber(jaw), point);
        return MakeArray<double>({ covariance(0, 0), covariance(0, 1), covariance(1, 0), covariance(1, 1) }, { 2, 2 });
      },
      py::arg("jaw"),
      py::arg("point"),
      "(2, 2) square pixels: of the projection of a point of the jaw's mesh.");
}
} // namespace dentalscr

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
#ifndef dentalscrPoseRegistration_h
#define dentalscrPoseRegistration_h

#include "dentalscrBinding.h"

#include "itkLeastSquaresMetricv4.h"
#include "itkObjectToObjectOptimizerBase.h"
#include "itkPoseFitStatistics.h"

#include <stdexcept>
#include <string>

namespace dentalscr
{
using MetricBaseType = itk::LeastSquaresMetricv4;
using OptimizerBaseType = itk::ObjectToObjectOptimizerBaseTemplate<double>;

template <typename T>
using MetricClass = py::class_<T, MetricBaseType, itk::SmartPointer<T>>;

inline py::dict
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

/** A metric that has its blocks: before Initialize() a metric knows them only when it is asked. */
inline const MetricBaseType &
Ready(const MetricBaseType & metric)
{
  if (metric.GetState().GetNumberOfParameters() == 0)
  {
    throw std::invalid_argument(std::string(metric.GetNameOfClass()) +
                                " reads no parameters yet; set its inputs and call Initialize()");
  }
  return metric;
}

/** Terms of a scan on a radiograph (silhouettes, landmarks, whole teeth, other views); options, iterations and
 * solutions of a registration of poses; verdict, projections and other filters after it. */
void
WrapPoseTerms(py::module_ & module);
void
WrapPoseSolution(py::module_ & module);
void
WrapPoseDownstream(py::module_ & module);
} // namespace dentalscr

#endif

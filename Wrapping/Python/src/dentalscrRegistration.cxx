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
#include "dentalscrOptimizers.h"
#include "dentalscrPythonContourMetric.h"

#include "itkCoherentPointDriftContourRegistrationMethod.h"
#include "itkContourChamferMetricv4.h"
#include "itkContourDistanceFilter.h"
#include "itkContourOverlapFilter.h"
#include "itkIntensityRegistrationMethod.h"
#include "itkIterativeClosestPointContourRegistrationMethod.h"
#include "itkScalePrior.h"
#include "itkSilhouetteToContourRegistrationMethod.h"

#include "itkAmoebaOptimizerv4.h"
#include "itkExhaustiveOptimizerv4.h"
#include "itkGradientDescentLineSearchOptimizerv4.h"
#include "itkGradientDescentOptimizerv4.h"
#include "itkOnePlusOneEvolutionaryOptimizerv4.h"
#include "itkPowellOptimizerv4.h"
#include "itkRegularStepGradientDescentOptimizerv4.h"

#include <limits>
#include <sstream>

namespace dentalscr
{
namespace
{
using ContourMethodType = itk::SilhouetteToContourRegistrationMethod;
using SimilarityType = itk::Similarity2DTransform<double>;
using itk::DentalContour;
using DistanceFilterType = itk::ContourDistanceFilter;
using OverlapFilterType = itk::ContourOverlapFilter;
using MetricDirectionEnum = itk::ContourMetricEnums::Direction;
using DistanceEnum = itk::ContourMetricEnums::Distance;

using GradientDescentType = itk::GradientDescentOptimizerv4Template<double>;
using RegularStepType = itk::RegularStepGradientDescentOptimizerv4<double>;
using LineSearchType = itk::GradientDescentLineSearchOptimizerv4Template<double>;
using PowellType = itk::PowellOptimizerv4<double>;
using OnePlusOneType = itk::OnePlusOneEvolutionaryOptimizerv4<double>;
using ExhaustiveType = itk::ExhaustiveOptimizerv4<double>;

SimilarityType::Pointer
Copy(const SimilarityType * transform)
{
  auto copy = SimilarityType::New();
  copy->SetFixedParameters(transform->GetFixedParameters());
  copy->SetParameters(transform->GetParameters());
  return copy;
}

py::tuple
ToTuple(const itk::OptimizerParameters<double> & parameters)
{
  return py::tuple(py::cast(std::vector<double>(parameters.begin(), parameters.end())));
}

/** What the registration of contours has in common, whatever the method. */
template <typename TMethod>
void
DefineContourMethod(ProcessClass<TMethod> & type)
{
  type.def("_SetFixedContour", &TMethod::SetFixedContour, py::arg("contour"))
    .def("_SetMovingContour", &TMethod::SetMovingContour, py::arg("contour"))
    .def(
      "_SetInitialTransform",
      [](TMethod & self, const SimilarityType * transform) {
        if (transform == nullptr)
        {
          self.SetInitialTransformInput(nullptr);
        }
        else
        {
          self.SetInitialTransform(transform);
        }
      },
      py::arg("transform"))
    .def("_GetTransform", [](const TMethod & self) { return Copy(self.GetTransform()); })
    .def(
      "GetInitialParameters",
      [](const TMethod & self) { return ToTuple(self.GetInitialParameters()); },
      "The start (scale, rad, px, px).")
    .def(
      "GetCurrentLevel", [](const TMethod & self) { return self.GetCurrentLevel(); }, "0 is the coarsest.")
    .def(
      "GetOptimizerIteration",
      [](const TMethod & self) { return self.GetOptimizerIteration(); },
      "Number of the current iteration, from 0.")
    .def(
      "GetMetricValue",
      [](const TMethod & self) { return self.GetMetricValue(); },
      "Value of the metric at the current iteration, pixels for the chamfer metrics.")
    .def(
      "GetOptimizerPosition",
      [](const TMethod & self) { return ToTuple(self.GetOptimizerPosition()); },
      "Parameters of the transform: (scale, rad, px, px).")
    .def(
      "GetOptimizerStopConditionDescription",
      [](const TMethod & self) { return self.GetOptimizerStopConditionDescription(); },
      "Why the optimizer ended, in words.");
}

void
WrapMetrics(py::module_ & module)
{
  BindEnum<MetricDirectionEnum>(module,
                                "ContourDirection",
                                { { "Symmetric", MetricDirectionEnum::Symmetric },
                                  { "MovingToFixed", MetricDirectionEnum::MovingToFixed },
                                  { "FixedToMoving", MetricDirectionEnum::FixedToMoving } },
                                "Which way distances between two contours are taken.");
  BindEnum<DistanceEnum>(
    module,
    "ContourPointDistance",
    { { "PointToPoint", DistanceEnum::PointToPoint }, { "PointToSegment", DistanceEnum::PointToSegment } },
    "To what distances are taken: the nearest point, or the nearest place on a line.");
  ProcessClass<DistanceFilterType>(module, "ContourDistanceFilter", "Distances between two contours.")
    .def(New<DistanceFilterType>())
    .def("_SetFixedContour", &DistanceFilterType::SetFixedContour, py::arg("contour"))
    .def("_SetMovingContour", &DistanceFilterType::SetMovingContour, py::arg("contour"))
    .def(
      "_SetTransform",
      [](DistanceFilterType & self, const SimilarityType * transform) {
        if (transform == nullptr)
        {
          self.SetTransformInput(nullptr);
        }
        else
        {
          self.SetTransform(transform);
        }
      },
      py::arg("transform"))
    .def("SetDistance",
         &DistanceFilterType::SetDistance,
         py::arg("distance"),
         "Sets how the distance of a point, in pixels, is measured: PointToPoint (the default, the paper's) or "
         "PointToSegment.")
    .def("GetDistance",
         &DistanceFilterType::GetDistance,
         "Returns how the distance of a point is measured: PointToPoint (the default, the paper's) or "
         "PointToSegment.")
    .def(
      "GetMovingToFixedMean", [](const DistanceFilterType & self) { return self.GetMovingToFixedMean(); }, "px.")
    .def(
      "GetFixedToMovingMean", [](const DistanceFilterType & self) { return self.GetFixedToMovingMean(); }, "px.")
    .def(
      "GetChamfer", [](const DistanceFilterType & self) { return self.GetChamfer(); }, "Average of the two means, px.")
    .def(
      "GetMovingToFixedHausdorff",
      [](const DistanceFilterType & self) { return self.GetMovingToFixedHausdorff(); },
      "px.")
    .def(
      "GetFixedToMovingHausdorff",
      [](const DistanceFilterType & self) { return self.GetFixedToMovingHausdorff(); },
      "px.")
    .def(
      "GetHausdorff", [](const DistanceFilterType & self) { return self.GetHausdorff(); }, "px.")
    .def(
      "GetMovingToFixedDistances",
      [](const DistanceFilterType & self) { return MakeArray(self.GetMovingToFixedDistances()); },
      "One a point, px; NaN for points of weight 0.")
    .def(
      "GetFixedToMovingDistances",
      [](const DistanceFilterType & self) { return MakeArray(self.GetFixedToMovingDistances()); },
      "One a point, px; NaN for points of weight 0.")
    .def(
      "GetFixedToMovingDistancesByTooth",
      [](const DistanceFilterType & self) {
        py::dict teeth;
        for (const auto & tooth : self.GetFixedToMovingDistancesByTooth())
        {
          py::dict figures;
          figures["count"] = tooth.numberOfPoints;
          figures["mean"] = tooth.mean;
          figures["rms"] = tooth.rms;
          figures["maximum"] = tooth.maximum;
          teeth[py::str(tooth.tooth.GetName())] = figures;
        }
        return teeth;
      },
      "{\"UR1\": {\"count\", \"mean\", \"rms\", \"maximum\"}}, px: how far the fixed contour's drawing of each tooth "
      "lies "
      "from the moving contour, over its points that count; \"\" for those without a code.");
  ProcessClass<OverlapFilterType>(
    module, "ContourOverlapFilter", "How much of an open tracing and of a contour lies together.")
    .def(New<OverlapFilterType>())
    .def("_SetFixedContour", &OverlapFilterType::SetFixedContour, py::arg("contour"))
    .def("_SetMovingContour", &OverlapFilterType::SetMovingContour, py::arg("contour"))
    .def(
      "_SetTransform",
      [](OverlapFilterType & self, const SimilarityType * transform) {
        if (transform == nullptr)
        {
          self.SetTransformInput(nullptr);
        }
        else
        {
          self.SetTransform(transform);
        }
      },
      py::arg("transform"))
    .dentalscrProperty(OverlapFilterType,
                       MaximumDistance,
                       "the distance beyond which contours do not lie together, pixels; 5 by default.")
    .dentalscrProperty(OverlapFilterType,
                       GapLength,
                       "the length of a gap in the tracing below which it has no ends there, pixels; 8 by default.")
    .def(
      "GetFixedShare", [](const OverlapFilterType & self) { return self.GetFixedShare(); }, "Of the tracing, 0 to 1.")
    .def(
      "GetMovingShare", [](const OverlapFilterType & self) { return self.GetMovingShare(); }, "Of the outline, 0 to 1.")
    .def(
      "GetRootMeanSquare", [](const OverlapFilterType & self) { return self.GetRootMeanSquare(); }, "px.")
    .def(
      "GetLargestDistance", [](const OverlapFilterType & self) { return self.GetLargestDistance(); }, "px.")
    .def(
      "GetFixedDistances",
      [](const OverlapFilterType & self) { return MakeArray(self.GetFixedDistances()); },
      "One a point, px; NaN for points that are ignored.")
    .def(
      "GetMovingDistances",
      [](const OverlapFilterType & self) { return MakeArray(self.GetMovingDistances()); },
      "One a point, px; NaN for points without tracing beside them.");
}

using MetricType = itk::ContourToContourMetricv4;
using ChamferType = itk::ContourChamferMetricv4;

/** Metrics as objects: what SetMetric() takes. */
void
WrapMetricObjects(py::module_ & module)
{
  using SpacingSourceEnum = itk::ScalePrior::SpacingSource;
  BindEnum<SpacingSourceEnum>(module,
                              "SpacingSource",
                              { { "Given", SpacingSourceEnum::Given },
                                { "Dicom", SpacingSourceEnum::Dicom },
                                { "Default", SpacingSourceEnum::Default },
                                { "Estimated", SpacingSourceEnum::Estimated } },
                              "Where a pixel spacing comes from, for the scale's prior.");
  py::class_<MetricType, itk::SmartPointer<MetricType>>(
    module, "ContourToContourMetricv4", "A figure of merit between two contours, for SetMetric().")
    .def(
      "GetName",
      [](const MetricType & self) { return std::string(self.GetNameOfClass()); },
      "Name of the class in C++.")
    .def(
      "GetPivot",
      [](const MetricType & self) { return std::make_pair(self.GetPivot()[0], self.GetPivot()[1]); },
      "Of scale and rotation, in the moving frame, px.")
    .def("GetReferenceLength", &MetricType::GetReferenceLength, "What makes the four parameters alike, px.")
    .def("__str__", [](const MetricType & self) {
      std::ostringstream text;
      self.Print(text);
      return text.str();
    });
  py::class_<ChamferType, MetricType, itk::SmartPointer<ChamferType>>(
    module, "ContourChamferMetricv4", "Symmetric or one-sided Chamfer distance: the sum of the directed means, px.")
    .def(New<ChamferType>())
    .def("SetDirection",
         &ChamferType::SetDirection,
         py::arg("direction"),
         "Sets which contour's points are measured: Symmetric (both, the default), MovingToFixed or "
         "FixedToMoving.")
    .def("GetDirection",
         &ChamferType::GetDirection,
         "Returns which contour's points are measured: Symmetric (both, the default), MovingToFixed "
         "or FixedToMoving.")
    .def("SetDistance",
         &ChamferType::SetDistance,
         py::arg("distance"),
         "Sets how the distance of a point, in pixels, is measured: PointToPoint (the default, the paper's) or "
         "PointToSegment.")
    .def("GetDistance",
         &ChamferType::GetDistance,
         "Returns how the distance of a point is measured: PointToPoint (the default, the paper's) or "
         "PointToSegment.")
    .dentalscrProperty(
      ChamferType, Truncation, "the distance that all larger ones count as, pixels; infinity by default.");
}

void
WrapLevels(py::module_ & module)
{
  using LevelType = itk::SilhouetteToContourLevel;
  using ResultType = itk::SilhouetteToContourLevelResult;
  py::class_<LevelType>(
    module,
    "RegistrationLevel",
    R"(What one level of a registration may search, and how. Bounds are half-widths around the estimate.

Parameters
----------
scaleBound : float
    Fraction: 0.35 allows 0.65 to 1.35 times the present scale.
rotationBound : float
    Radians.
translationBound : float
    Shift of the silhouette's centroid in u and v, mm.
numberOfScales, numberOfRotations, numberOfTranslations : int
    Candidates a parameter before the optimizer runs; 0 is none.
numberOfStarts : int
    The optimizer runs from so many of the best candidates.
numberOfIterations : int
    From a start; 0 leaves the optimizer's own.)")
    .def(py::init([](double       scaleBound,
                     double       rotationBound,
                     double       translationBound,
                     unsigned int numberOfScales,
                     unsigned int numberOfRotations,
                     unsigned int numberOfTranslations,
                     unsigned int numberOfStarts,
                     std::size_t  numberOfIterations) {
           return LevelType{ scaleBound,        rotationBound,        translationBound, numberOfScales,
                             numberOfRotations, numberOfTranslations, numberOfStarts,   numberOfIterations };
         }),
         py::arg("scaleBound") = 0.35,
         py::arg("rotationBound") = 0.0,
         py::arg("translationBound") = 0.0,
         py::arg("numberOfScales") = 0,
         py::arg("numberOfRotations") = 0,
         py::arg("numberOfTranslations") = 0,
         py::arg("numberOfStarts") = 1,
         py::arg("numberOfIterations") = 0)
    .def_readwrite("scaleBound",
                   &LevelType::scaleBound,
                   "How far the scale may move, as a part of the current one, in [0, 1): 0.35 allows 0.65 to "
                   "1.35 times it.")
    .def_readwrite("rotationBound", &LevelType::rotationBound, "How far the angle may move from the current one, rad.")
    .def_readwrite("translationBound",
                   &LevelType::translationBound,
                   "How far the silhouette's centroid may move in u and in v, mm in the plane of the pixel "
                   "spacing.")
    .def_readwrite("numberOfScales",
                   &LevelType::numberOfScales,
                   "How many scales within the bound are tried before the optimizer runs; 0 is none.")
    .def_readwrite("numberOfRotations",
                   &LevelType::numberOfRotations,
                   "How many angles within the bound are tried before the optimizer runs; 0 is none.")
    .def_readwrite("numberOfTranslations",
                   &LevelType::numberOfTranslations,
                   "How many shifts an axis within the bound are tried before the optimizer runs; 0 is none.")
    .def_readwrite("numberOfStarts", &LevelType::numberOfStarts, "How many of the best places are refined.")
    .def_readwrite("numberOfIterations",
                   &LevelType::numberOfIterations,
                   "The most iterations of the optimizer from a start; 0 leaves the optimizer's own limit.")
    .def("__repr__",
         [](const LevelType & self) {
           return "<dentalscr.RegistrationLevel scale " + std::to_string(self.scaleBound) + ", rotation " +
                  std::to_string(self.rotationBound) + " rad, translation " + std::to_string(self.translationBound) +
                  " mm>";
         })
    .def("__copy__", [](const LevelType & self) { return LevelType(self); })
    .def(
      "__deepcopy__", [](const LevelType & self, const py::dict &) { return LevelType(self); }, py::arg("memo"))
    .def(py::pickle(
      [](const LevelType & self) {
        return py::make_tuple(self.scaleBound,
                              self.rotationBound,
                              self.translationBound,
                              self.numberOfScales,
                              self.numberOfRotations,
                              self.numberOfTranslations,
                              self.numberOfStarts,
                              self.numberOfIterations);
      },
      [](const py::tuple & state) {
        return LevelType{ state[0].cast<double>(),       state[1].cast<double>(),       state[2].cast<double>(),
                          state[3].cast<unsigned int>(), state[4].cast<unsigned int>(), state[5].cast<unsigned int>(),
                          state[6].cast<unsigned int>(), state[7].cast<std::size_t>() };
      }));
  py::class_<ResultType>(module, "RegistrationLevelResult", "How a level went.")
    .def_readonly("initialParameters",
                  &ResultType::initialParameters,
                  "Parameters at which the level began: scale, angle (rad), shift (pixels).")
    .def_readonly("finalParameters",
                  &ResultType::finalParameters,
                  "Parameters at which the level ended: scale, angle (rad), shift (pixels).")
    .def_readonly("initialValue", &ResultType::initialValue, "Value of the metric at the beginning.")
    .def_readonly("finalValue", &ResultType::finalValue, "Value of the metric at the end.")
    .def_readonly("boundsHit",
                  &ResultType::boundsHit,
                  "Of scale, rotation, shift in u and in v: -1 where the result lies on the lower bound, 1 on "
                  "the upper, else 0.")
    .def_readonly("numberOfIterations", &ResultType::numberOfIterations, "How many iterations the optimizer needed.")
    .def_readonly("numberOfEvaluations", &ResultType::numberOfEvaluations, "How many times the metric was evaluated.")
    .def_readonly("numberOfCandidates", &ResultType::numberOfCandidates, "How many places the exploration tried.")
    .def_readonly(
      "stopConditionDescription", &ResultType::stopConditionDescription, "Why the optimizer ended, in words.")
    .def("__repr__", [](const ResultType & self) {
      return "<dentalscr.RegistrationLevelResult " + std::to_string(self.initialValue) + " to " +
             std::to_string(self.finalValue) + ", " + std::to_string(self.numberOfIterations) + " iterations, " +
             self.stopConditionDescription + ">";
    });
}

void
WrapOptimizers(ProcessClass<ContourMethodType> & type)
{
  DefineQuasiNewton(type);
  type
    .def(
      "SetOptimizerAsGradientDescent",
      [](ContourMethodType & self,
         double              learningRate,
         unsigned int        numberOfIterations,
         double              convergenceMinimumValue,
         unsigned int        convergenceWindowSize) {
        auto optimizer = GradientDescentType::New();
        optimizer->SetLearningRate(learningRate);
        optimizer->SetNumberOfIterations(numberOfIterations);
        optimizer->SetMinimumConvergenceValue(convergenceMinimumValue);
        optimizer->SetConvergenceWindowSize(convergenceWindowSize);
        optimizer->SetReturnBestParametersAndValue(true);
        self.SetOptimizer(optimizer);
      },
      py::arg("learningRate"),
      py::arg("numberOfIterations"),
      py::arg("convergenceMinimumValue") = 1e-6,
      py::arg("convergenceWindowSize") = 10,
      "Optimizes with ITK's GradientDescentOptimizerv4. The parameters are ITK's.")
    .def(
      "SetOptimizerAsRegularStepGradientDescent",
      [](ContourMethodType & self,
         double              learningRate,
         double              minStep,
         unsigned int        numberOfIterations,
         double              relaxationFactor,
         double              gradientMagnitudeTolerance) {
        auto optimizer = RegularStepType::New();
        optimizer->SetLearningRate(learningRate);
        optimizer->SetMinimumStepLength(minStep);
        optimizer->SetNumberOfIterations(numberOfIterations);
        optimizer->SetRelaxationFactor(relaxationFactor);
        optimizer->SetGradientMagnitudeTolerance(gradientMagnitudeTolerance);
        self.SetOptimizer(optimizer);
      },
      py::arg("learningRate"),
      py::arg("minStep"),
      py::arg("numberOfIterations"),
      py::arg("relaxationFactor") = 0.5,
      py::arg("gradientMagnitudeTolerance") = 1e-4,
      "Optimizes with ITK's RegularStepGradientDescentOptimizerv4. The parameters are ITK's.")
    .def(
      "SetOptimizerAsGradientDescentLineSearch",
      [](ContourMethodType & self,
         double              learningRate,
         unsigned int        numberOfIterations,
         double              convergenceMinimumValue,
         unsigned int        convergenceWindowSize,
         double              lineSearchLowerLimit,
         double              lineSearchUpperLimit,
         double              lineSearchEpsilon,
         unsigned int        lineSearchMaximumIterations) {
        auto optimizer = LineSearchType::New();
        optimizer->SetLearningRate(learningRate);
        optimizer->SetNumberOfIterations(numberOfIterations);
        optimizer->SetMinimumConvergenceValue(convergenceMinimumValue);
        optimizer->SetConvergenceWindowSize(convergenceWindowSize);
        optimizer->SetLowerLimit(lineSearchLowerLimit);
        optimizer->SetUpperLimit(lineSearchUpperLimit);
        optimizer->SetEpsilon(lineSearchEpsilon);
        optimizer->SetMaximumLineSearchIterations(lineSearchMaximumIterations);
        optimizer->SetReturnBestParametersAndValue(true);
        self.SetOptimizer(optimizer);
      },
      py::arg("learningRate"),
      py::arg("numberOfIterations"),
      py::arg("convergenceMinimumValue") = 1e-6,
      py::arg("convergenceWindowSize") = 10,
      py::arg("lineSearchLowerLimit") = 0.0,
      py::arg("lineSearchUpperLimit") = 5.0,
      py::arg("lineSearchEpsilon") = 0.01,
      py::arg("lineSearchMaximumIterations") = 20,
      "Optimizes with ITK's GradientDescentLineSearchOptimizerv4. The parameters are ITK's.")
    .def(
      "SetOptimizerAsAmoeba",
      [](ContourMethodType & self,
         double              simplexDelta,
         unsigned int        numberOfIterations,
         double              parametersConvergenceTolerance,
         double              functionConvergenceTolerance,
         bool                withRestarts) {
        auto optimizer = itk::AmoebaOptimizerv4::New();
        if (simplexDelta > 0.0)
        {
          itk::AmoebaOptimizerv4::ParametersType simplex(4);
          simplex.Fill(simplexDelta);
          optimizer->SetInitialSimplexDelta(simplex);
        }
        optimizer->SetNumberOfIterations(numberOfIterations);
        optimizer->SetParametersConvergenceTolerance(parametersConvergenceTolerance);
        optimizer->SetFunctionConvergenceTolerance(functionConvergenceTolerance);
        optimizer->SetOptimizeWithRestarts(withRestarts);
        self.SetOptimizer(optimizer);
      },
      py::arg("simplexDelta") = 0.0,
      py::arg("numberOfIterations") = 500,
      py::arg("parametersConvergenceTolerance") = 1e-8,
      py::arg("functionConvergenceTolerance") = 1e-4,
      py::arg("withRestarts") = false,
      "simplexDelta 0: a quarter of the level's bounds.")
    .def(
      "SetOptimizerAsPowell",
      [](ContourMethodType & self,
         unsigned int        numberOfIterations,
         unsigned int        maximumLineIterations,
         double              stepLength,
         double              stepTolerance,
         double              valueTolerance) {
        auto optimizer = PowellType::New();
        optimizer->SetMaximumIteration(numberOfIterations);
        optimizer->SetMaximumLineIteration(maximumLineIterations);
        optimizer->SetStepLength(stepLength);
        optimizer->SetStepTolerance(stepTolerance);
        optimizer->SetValueTolerance(valueTolerance);
        self.SetOptimizer(optimizer);
      },
      py::arg("numberOfIterations") = 100,
      py::arg("maximumLineIterations") = 100,
      py::arg("stepLength") = 1.0,
      py::arg("stepTolerance") = 1e-6,
      py::arg("valueTolerance") = 1e-6,
      "Optimizes with ITK's PowellOptimizerv4, which needs no derivatives. The parameters are "
      "ITK's.")
    .def(
      "SetOptimizerAsOnePlusOneEvolutionary",
      [](ContourMethodType & self,
         unsigned int        numberOfIterations,
         double              epsilon,
         double              initialRadius,
         double              growthFactor,
         double              shrinkFactor,
         std::uint64_t       seed) {
        auto optimizer = OnePlusOneType::New();
        optimizer->SetMaximumIteration(numberOfIterations);
        optimizer->SetEpsilon(epsilon);
        optimizer->SetInitialRadius(initialRadius);
        // 0: ITK's own, 1.05 and its power.
        if (growthFactor > 0.0)
        {
          optimizer->SetGrowthFactor(growthFactor);
        }
        if (shrinkFactor > 0.0)
        {
          optimizer->SetShrinkFactor(shrinkFactor);
        }
        self.SetRandomSeed(seed);
        self.SetOptimizer(optimizer);
      },
      py::arg("numberOfIterations") = 100,
      py::arg("epsilon") = 1.5e-4,
      py::arg("initialRadius") = 1.01,
      py::arg("growthFactor") = 0.0,
      py::arg("shrinkFactor") = 0.0,
      py::arg("seed") = 0,
      "The seed is recorded: the same seed, the same result.")
    .def(
      "SetOptimizerAsExhaustive",
      [](ContourMethodType & self, const std::array<unsigned int, 4> & numberOfSteps, double stepLength) {
        auto                      optimizer = ExhaustiveType::New();
        ExhaustiveType::StepsType steps(4);
        std::copy(numberOfSteps.begin(), numberOfSteps.end(), steps.begin());
        optimizer->SetNumberOfSteps(steps);
        optimizer->SetStepLength(stepLength);
        self.SetOptimizer(optimizer);
      },
      py::arg("numberOfSteps"),
      py::arg("stepLength") = 1.0,
      "Steps to each side in scale, rotation, u and v: the grid reaches the level's bounds.");
}

void
WrapMethod(py::module_ & module)
{
  ProcessClass<ContourMethodType> type(
    module, "SilhouetteToContourRegistrationMethod", "Aligns a silhouette with a tracing by a 2-D similarity.");
  type.def(New<ContourMethodType>());
  DefineContourMethod(type);
  WrapOptimizers(type);
  type
    .def(
      "SetMetricAsChamfer",
      [](ContourMethodType & self, MetricDirectionEnum direction, DistanceEnum distance, double truncation) {
        auto metric = itk::ContourChamferMetricv4::New();
        metric->SetDirection(direction);
        metric->SetDistance(distance);
        metric->SetTruncation(truncation);
        self.SetMetric(metric);
      },
      py::arg_v("direction", MetricDirectionEnum::Symmetric, "ContourDirection.Symmetric"),
      py::arg_v("distance", DistanceEnum::PointToPoint, "ContourPointDistance.PointToPoint"),
      py::arg_v("truncation", std::numeric_limits<double>::infinity(), "float('inf')"),
      "The paper's: symmetric, point to point, no truncation (px).")
    .def(
      "SetMetricAsSymmetricChamfer",
      [](ContourMethodType & self, double truncation) {
        auto metric = itk::ContourChamferMetricv4::New();
        metric->SetTruncation(truncation);
        self.SetMetric(metric);
      },
      py::arg_v("truncation", std::numeric_limits<double>::infinity(), "float('inf')"),
      "Measures the mean distance of each contour's points from the other contour, pixels.")
    .def(
      "SetMetric",
      [](ContourMethodType & self, MetricType * metric) { self.SetMetric(metric); },
      py::arg("metric"),
      "A metric object; None: the paper's.")
    .def(
      "SetMetricAsFunction",
      [](ContourMethodType & self, const py::function & function) {
        auto metric = PythonContourMetric::New();
        metric->SetFunction(function);
        self.SetMetric(metric);
      },
      py::arg("function"),
      R"(A metric of your own: ``function(fixed, moved)``.

Parameters
----------
function : callable
    Given two (N, 2) arrays in pixels of the radiograph, the tracing and the silhouette under the similarity that is
    tried; returns the value, or the value and its derivatives by ``moved``. Without derivatives they are found by
    central differences.)")
    .def("_GetMetricName",
         [](ContourMethodType & self) {
           return self.GetModifiableMetric() == nullptr ? std::string() : self.GetModifiableMetric()->GetNameOfClass();
         })
    .def("_GetOptimizerName",
         [](ContourMethodType & self) {
           return self.GetModifiableOptimizer() == nullptr ? std::string()
                                                           : self.GetModifiableOptimizer()->GetNameOfClass();
         })
    .def(
      "StopRegistration",
      [](ContourMethodType & self) {
        auto * optimizer = self.GetModifiableOptimizer();
        if (auto * descent = dynamic_cast<itk::GradientDescentOptimizerBasev4Template<double> *>(optimizer))
        {
          descent->StopOptimization();
          return true;
        }
        if (auto * powell = dynamic_cast<PowellType *>(optimizer))
        {
          powell->StopOptimization();
          return true;
        }
        if (auto * evolution = dynamic_cast<OnePlusOneType *>(optimizer))
        {
          evolution->StopOptimization();
          return true;
        }
        return false;
      },
      "Ends the optimizer's present run at the present iteration, keeping the result; False where it can't.")
    .def("SetNumberOfLevels",
         &ContourMethodType::SetNumberOfLevels,
         py::arg("number"),
         "Sets the number of levels; 3 by default, and 0 gives the start itself. A level that is "
         "added has half the bounds of the one before.")
    .def("GetNumberOfLevels",
         &ContourMethodType::GetNumberOfLevels,
         "Returns the number of levels; 3 by default, and 0 gives the start itself. A level that is "
         "added has half the bounds of the one before.")
    .def("SetLevel",
         &ContourMethodType::SetLevel,
         py::arg("index"),
         py::arg("level"),
         "Sets bounds and effort of a level by its number, from 0.")
    .def(
      "GetLevel",
      [](const ContourMethodType & self, unsigned int index) { return self.GetLevel(index); },
      py::arg("index"),
      "Bounds and effort of a level by its number, from 0.")
    .def("GetLevelResults", &ContourMethodType::GetLevelResults, "How the levels went, after Execute().")
    .def("SetPixelSpacing", &ContourMethodType::SetPixelSpacing, py::arg("spacing"), "mm, mean of u and v.")
    .def("GetPixelSpacing",
         &ContourMethodType::GetPixelSpacing,
         "Pixel spacing of the fixed contour (mean of u and v), mm; 0.25 by default. It turns the "
         "bounds on the shift into pixels.")
    .dentalscrBoolean(ContourMethodType, FixScale, "whether the scale of the start is held. Off by default.")
    .dentalscrBoolean(ContourMethodType, FixRotation, "whether the angle of the start is held. Off by default.")
    .dentalscrBoolean(
      ContourMethodType, FixTranslation, "whether the translation of the start is held. Off by default.")
    .dentalscrProperty(ContourMethodType,
                       RandomSeed,
                       "the seed that the evolutionary optimizer gets at each run; the others draw nothing.")
    .def("SetPresetToPaper",
         &ContourMethodType::SetPresetToPaper,
         "Sets the paper's three levels, the default: scale 35, 10 and 3 %, rotation 20, 6 and 2 "
         "degrees, shift 15, 3.75 and 1 mm.")
    .def("SetPresetToGlobal",
         &ContourMethodType::SetPresetToGlobal,
         "Sets two levels for a start that is far off: scale 50 %, rotation 45 degrees, shift 15 mm, "
         "of which the first explores all.")
    .def("SetPresetToBoundingBox",
         &ContourMethodType::SetPresetToBoundingBox,
         "Takes all levels away: the start from bounding box and centroid is the result.")
    .def("SetPresetToSingleStage",
         &ContourMethodType::SetPresetToSingleStage,
         "Sets one level with the broad bounds and 80 iterations that does not explore: the paper's "
         "\"w/o coarse-to-fine\".")
    .def_static(
      "_ComputeBoundingBoxTransform",
      [](const DentalContour & fixed, const DentalContour & moving) {
        return ContourMethodType::ComputeBoundingBoxTransform(&fixed, &moving);
      },
      py::arg("fixed"),
      py::arg("moving"))
    .def(
      "_MetricEvaluate",
      [](ContourMethodType &    self,
         const DentalContour *  fixed,
         const DentalContour *  moving,
         const SimilarityType & transform) {
        itk::SmartPointer<itk::ContourToContourMetricv4> metric = self.GetModifiableMetric();
        if (metric.IsNull())
        {
          metric = itk::ContourChamferMetricv4::New().GetPointer();
        }
        const py::gil_scoped_release released;
        metric->SetFixedContour(fixed);
        metric->SetMovingContour(moving);
        metric->RemoveBounds();
        metric->SetMovingTransform(Copy(&transform));
        metric->Initialize();
        // The reference of Initialize() is the transform as it stands: the origin.
        itk::ContourToContourMetricv4::ParametersType origin(4);
        origin.Fill(0.0);
        return metric->EvaluateAt(origin);
      },
      py::arg("fixed"),
      py::arg("moving"),
      py::arg("transform"));
}

void
WrapBaselines(py::module_ & module)
{
  using MotionEnum = itk::ContourBaselineEnums::Motion;
  BindEnum<MotionEnum>(module,
                       "Motion",
                       { { "Rigid", MotionEnum::Rigid }, { "Similarity", MotionEnum::Similarity } },
                       "What a baseline may estimate; Rigid keeps the start's scale.");
  const auto defineBaseline = [](auto & type) {
    using MethodClass = typename std::decay_t<decltype(type)>::type;
    type.def(New<MethodClass>());
    DefineContourMethod(type);
    type
      .def(
        "SetMotion",
        [](MethodClass & self, MotionEnum motion) { self.SetMotion(motion); },
        py::arg("motion"),
        "Sets what may move: Rigid (shift and angle) or Similarity (the default, and scale).")
      .def(
        "GetMotion",
        [](const MethodClass & self) { return self.GetMotion(); },
        "Returns what may move: Rigid (shift and angle) or Similarity (the default, and scale).")
      .def("SetMaximumNumberOfIterations",
           &MethodClass::SetMaximumNumberOfIterations,
           py::arg("value"),
           "Sets the most iterations of a run.")
      .def("GetMaximumNumberOfIterations",
           &MethodClass::GetMaximumNumberOfIterations,
           "Returns the most iterations of a run.");
  };

  using ICPType = itk::IterativeClosestPointContourRegistrationMethod;
  ProcessClass<ICPType> icp(
    module, "IterativeClosestPointContourRegistrationMethod", "Iterative closest points between two contours.");
  defineBaseline(icp);
  icp
    .def("SetDirection",
         &ICPType::SetDirection,
         py::arg("direction"),
         "Sets whose points look for their nearest: FixedToMoving (the default), MovingToFixed or "
         "Symmetric.")
    .def("GetDirection",
         &ICPType::GetDirection,
         "Returns whose points look for their nearest: FixedToMoving (the default), MovingToFixed or "
         "Symmetric.")
    .dentalscrProperty(ICPType,
                       TrimmedFraction,
                       "the share of the pairs that is left out, in [0, 0.9]; 0 by default, which is plain ICP.")
    .dentalscrProperty(
      ICPType, Tolerance, "the move below which it ends, pixels of the fixed contour; 1e-4 by default.");

  using CPDType = itk::CoherentPointDriftContourRegistrationMethod;
  ProcessClass<CPDType> cpd(
    module, "CoherentPointDriftContourRegistrationMethod", "Coherent point drift between two contours.");
  defineBaseline(cpd);
  cpd
    .dentalscrProperty(
      CPDType, OutlierWeight, "the share of points that belong to nothing, in [0, 0.99]; 0 by default.")
    .dentalscrProperty(
      CPDType, Tolerance, "the move below which it ends, pixels of the fixed contour; 1e-3 by default.");

  using IntensityType = itk::IntensityRegistrationMethod;
  using MeasureEnum = itk::IntensityRegistrationEnums::Measure;
  BindEnum<MeasureEnum>(module,
                        "IntensityMeasure",
                        { { "MutualInformation", MeasureEnum::MutualInformation },
                          { "NormalizedCorrelation", MeasureEnum::NormalizedCorrelation },
                          { "GradientCorrelation", MeasureEnum::GradientCorrelation } },
                        "How two radiographs are compared.");
  ProcessClass<IntensityType> intensity(
    module, "IntensityRegistrationMethod", "Aligns a DRR with the radiograph by their grey values.");
  defineBaseline(intensity);
  intensity.def("_SetFixedImage", &IntensityType::SetFixedImage, py::arg("image"))
    .def("_SetMovingImage", &IntensityType::SetMovingImage, py::arg("image"))
    .def("SetMeasure",
         &IntensityType::SetMeasure,
         py::arg("measure"),
         "Sets the measure of likeness of the two images; MutualInformation by default.")
    .def("GetMeasure",
         &IntensityType::GetMeasure,
         "Returns the measure of likeness of the two images; MutualInformation by default.")
    .dentalscrProperty(IntensityType,
                       Margin,
                       "the free border of the region of interest, as a part of the tracing's larger extent; 0.15 "
                       "by default.");
}
} // namespace

void
WrapRegistration(py::module_ & module)
{
  WrapMetrics(module);
  WrapMetricObjects(module);
  WrapLevels(module);
  WrapMethod(module);
  WrapBaselines(module);
}
} // namespace dentalscr

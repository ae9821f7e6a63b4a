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
#include "dentalscrContourMethod.h"
#include "dentalscrOptimizers.h"
#include "dentalscrPythonContourMetric.h"

#include "itkContourChamferMetricv4.h"
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
using ContourMetricType = itk::ContourToContourMetricv4;
using MetricDirectionEnum = itk::ContourMetricEnums::Direction;
using DistanceEnum = itk::ContourMetricEnums::Distance;

using GradientDescentType = itk::GradientDescentOptimizerv4Template<double>;
using RegularStepType = itk::RegularStepGradientDescentOptimizerv4<double>;
using LineSearchType = itk::GradientDescentLineSearchOptimizerv4Template<double>;
using PowellType = itk::PowellOptimizerv4<double>;
using OnePlusOneType = itk::OnePlusOneEvolutionaryOptimizerv4<double>;
using ExhaustiveType = itk::ExhaustiveOptimizerv4<double>;

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
      [](ContourMethodType & self, ContourMetricType * metric) { self.SetMetric(metric); },
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
        metric->SetMovingTransform(CopySimilarity(&transform));
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
} // namespace

void
WrapRegistration(py::module_ & module)
{
  WrapContourMetrics(module);
  WrapLevels(module);
  WrapMethod(module);
  WrapBaselines(module);
}
} // namespace dentalscr

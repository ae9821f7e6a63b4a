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
#include "dentalscrConversions.h"
#include "dentalscrPythonLeastSquaresMetric.h"

#include "itkCorrelatedNoiseModel.h"
#include "itkGemanMcClureKernel.h"
#include "itkLeastSquaresSumMetricv4.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkParameterPriorMetricv4.h"
#include "itkPoseStateBlocks.h"
#include "itkRegistrationIterationCommand.h"
#include "itkSquaresKernel.h"
#include "itkToothCode.h"
#include "itkTracedSide.h"

#include <limits>
#include <sstream>

namespace dentalscr
{
namespace
{
using StateType = itk::RegistrationState;
using ParameterType = StateType::ParameterType;
using BlockType = StateType::BlockType;
using OptimizerType = itk::LevenbergMarquardtOptimizerv4;
using HoldEnum = MetricBaseType::HoldEnum;
using ArrayType = py::array_t<double>;

template <typename TParameters>
ArrayType
ToArray(const TParameters & parameters)
{
  return MakeArray(std::vector<double>(parameters.begin(), parameters.end()));
}

void
WrapState(py::module_ & module)
{
  py::class_<ParameterType>(module,
                            "StateParameter",
                            R"(One unknown of a registration.

Parameters
----------
name : str
value : float, optional
    Natural units: rad, mm, 1.
scale : float, optional
    Units of the optimizer in one natural unit, positive: mm a rad for an angle.
maximumStep : float, optional
    The longest step an optimizer should take, natural units; 0 is any.
isFree : bool, optional
    Whether an optimizer may move it.)")
    .def(py::init([](const std::string & name, double value, double scale, double maximumStep, bool isFree) {
           if (!(scale > 0.0))
           {
             throw std::invalid_argument("the scale of a parameter is positive");
           }
           return ParameterType{ name, value, scale, maximumStep, isFree };
         }),
         py::arg("name"),
         py::arg("value") = 0.0,
         py::arg("scale") = 1.0,
         py::arg("maximumStep") = 0.0,
         py::arg("isFree") = true)
    .def_readonly("name", &ParameterType::name, "Name of the parameter.")
    .def_readonly("value", &ParameterType::value, "Its value, in its natural unit: mm, rad or none.")
    .def_readonly("scale",
                  &ParameterType::scale,
                  "How many of the optimizer's units there are in one natural unit: the lever arm of an angle "
                  "in mm, 1 of a length.")
    .def_readonly("maximumStep",
                  &ParameterType::maximumStep,
                  "The longest step that an optimizer should take, in the natural unit; 0 is any.")
    .def_readonly("isFree", &ParameterType::isFree, "Whether an optimizer may move it.")
    .def("__repr__", [](const ParameterType & self) {
      return "<dentalscr.StateParameter " + self.name + " = " + std::to_string(self.value) +
             (self.isFree ? ">" : ", held>");
    });
  py::class_<BlockType>(
    module,
    "StateBlock",
    "Unknowns of a registration that belong together. Metrics that name the same block are about the same unknowns.")
    .def(py::init([](const std::string & name, const std::vector<ParameterType> & parameters) {
           return BlockType{ name, parameters };
         }),
         py::arg("name"),
         py::arg("parameters"))
    .def_readonly("name", &BlockType::name, "Name of the block.")
    .def_property_readonly(
      "parameters",
      [](const BlockType & self) { return self.parameters; },
      "Its parameters in their order, a list of StateParameter.")
    .def("__repr__", [](const BlockType & self) {
      std::string text = "<dentalscr.StateBlock " + self.name + ":";
      for (const auto & parameter : self.parameters)
      {
        text += ' ' + parameter.name;
      }
      return text + '>';
    });
  // An attribute, not a property: pybind11 loses the words on a static one.
  py::class_<itk::PoseStateBlocks>(module,
                                   "PoseStateBlocks",
                                   "The blocks that the metrics of a pose read. ``Arm`` is the length that an angle is "
                                   "multiplied by, mm.")
    .def_static(
      "MakePose", &itk::PoseStateBlocks::MakePose, py::arg("name") = "pose", "pitch, roll, yaw (rad), tx, ty, tz (mm).")
    .def_static("MakeScale",
                &itk::PoseStateBlocks::MakeScale,
                py::arg("name") = "scale",
                "kappa, the logarithm of the factor on the geometry's magnification.")
    .attr("Arm") = double(itk::PoseStateBlocks::Arm);
}

void
WrapModels(py::module_ & module)
{
  using KernelType = itk::RobustKernel;
  py::class_<KernelType, itk::SmartPointer<KernelType>>(
    module, "RobustKernel", "How much a residual counts by its size.")
    .def(
      "GetName",
      [](const KernelType & self) { return std::string(self.GetNameOfClass()); },
      "Name of the class in C++.")
    .def("GetWeight",
         &KernelType::GetWeight,
         py::arg("squaredDistance"),
         py::arg("width"),
         "Between 1 at distance 0 and 0 far away.")
    .def("GetCharge", &KernelType::GetCharge, py::arg("weight"), "For a weight, in units of the squared width.");
  py::class_<itk::GemanMcClureKernel, KernelType, itk::SmartPointer<itk::GemanMcClureKernel>>(
    module, "GemanMcClureKernel", "Robust: far residuals hardly count.")
    .def(New<itk::GemanMcClureKernel>());
  py::class_<itk::SquaresKernel, KernelType, itk::SmartPointer<itk::SquaresKernel>>(
    module, "SquaresKernel", "Least squares: all residuals count alike.")
    .def(New<itk::SquaresKernel>());
  using NoiseType = itk::ResidualNoiseModel;
  py::class_<NoiseType, itk::SmartPointer<NoiseType>>(
    module, "ResidualNoiseModel", "How the errors of a tracing's points hang together.")
    .def(
      "GetName", [](const NoiseType & self) { return std::string(self.GetNameOfClass()); }, "Name of the class in C++.")
    .def("GetCorrelation", &NoiseType::GetCorrelation, py::arg("arcDistance"), "px of 0.25 mm along the tracing.");
  using CorrelatedType = itk::CorrelatedNoiseModel;
  py::class_<CorrelatedType, NoiseType, itk::SmartPointer<CorrelatedType>>(
    module, "CorrelatedNoiseModel", "The hand drifts smoothly along a tracing; length 0 is independent errors.")
    .def(New<CorrelatedType>())
    .dentalscrProperty(CorrelatedType,
                       CorrelationLength,
                       "the length along the tracing over which its errors hang together, in pixels of 0.25 mm; 14 "
                       "by default, 0 is independent.");
}

void
WrapMetricBase(py::module_ & module)
{
  BindEnum<HoldEnum>(
    module,
    "MetricHold",
    { { "Nothing", HoldEnum::Nothing }, { "Contours", HoldEnum::Contours }, { "Matches", HoldEnum::Matches } },
    "What of a metric stays as it is while the parameters move.");
  using JoinsEnum = MetricBaseType::JoinsEnum;
  BindEnum<JoinsEnum>(
    module,
    "MetricJoins",
    { { "Start", JoinsEnum::Start }, { "Candidates", JoinsEnum::Candidates }, { "Refinement", JoinsEnum::Refinement } },
    "From when on a registration evaluates a term: the search for where to begin, the first steps "
    "from each start, the last refinement.");
  py::class_<MetricBaseType, itk::SmartPointer<MetricBaseType>>(
    module,
    "LeastSquaresMetricv4",
    R"(A figure of merit that is, or is majorised by, a sum of squares over named blocks of parameters.

Values of blocks are in natural units (rad, mm, 1). The parameters of SetParameters(), GetParameters() and
GetDerivative() are an optimizer's: the free ones alone, each multiplied by its scale.)")
    .def(
      "GetName",
      [](const MetricBaseType & self) { return std::string(self.GetNameOfClass()); },
      "Name of the class in C++.")
    .def(
      "GetBlocks",
      [](const MetricBaseType & self) { return self.GetState().GetBlocks(); },
      "Blocks, values and what is free; a copy.")
    .def(
      "GetBlockValues",
      [](const MetricBaseType & self, const std::string & block) { return ToArray(self.GetBlockValues(block)); },
      py::arg("block"),
      "Values of a block by its name, natural units.")
    .def("SetBlockValues",
         &MetricBaseType::SetBlockValues,
         py::arg("block"),
         py::arg("values"),
         "Sets the values of a block by its name, natural units. Initialize() keeps them.")
    .def(
      "GetValues",
      [](const MetricBaseType & self) { return ToArray(self.GetState().GetValues()); },
      "Of all blocks, one behind the other.")
    .def("SetJoins",
         &MetricBaseType::SetJoins,
         py::arg("joins"),
         "Sets from when on a registration evaluates this term (MetricJoins): Start by default.")
    .def("GetJoins", &MetricBaseType::GetJoins, "Returns from when on a registration evaluates this term.")
    .def("SetValues",
         &MetricBaseType::SetValues,
         py::arg("values"),
         "Sets the values of all blocks, one behind the other, natural units.")
    .def(
      "SetBlockFree",
      [](MetricBaseType & self, const std::string & block, const std::vector<bool> & isFree) {
        self.SetBlockFree(block, isFree);
      },
      py::arg("block"),
      py::arg("isFree"),
      "Sets which parameters of a block an optimizer may move.")
    .def(
      "SetBlockFree",
      [](MetricBaseType & self, const std::string & block, bool isFree) { self.SetBlockFree(block, isFree); },
      py::arg("block"),
      py::arg("isFree"),
      "Whether an optimizer may move the block's parameters, all alike or one by one.")
    .def(
      "GetFreeIndices",
      [](const MetricBaseType & self) { return self.GetState().GetFreeIndices(); },
      "Places of the free parameters among GetValues().")
    .def("Initialize",
         &MetricBaseType::Initialize,
         py::call_guard<py::gil_scoped_release>(),
         "Checks the inputs and prepares the evaluation; values stay.")
    .def(
      "GetValue",
      [](const MetricBaseType & self) { return Ready(self).GetValue(); },
      py::call_guard<py::gil_scoped_release>(),
      "What is minimized, at the current values.")
    .def(
      "GetDerivative",
      [](const MetricBaseType & self) {
        MetricBaseType::DerivativeType derivative;
        {
          const py::gil_scoped_release released;
          Ready(self).GetDerivative(derivative);
        }
        return ToArray(derivative);
      },
      "By the optimizer's parameters, with ITK's sign: minus the gradient.")
    .def(
      "GetValueAndDerivative",
      [](const MetricBaseType & self) {
        MetricBaseType::MeasureType    value;
        MetricBaseType::DerivativeType derivative;
        {
          const py::gil_scoped_release released;
          Ready(self).GetValueAndDerivative(value, derivative);
        }
        return py::make_tuple(value, ToArray(derivative));
      },
      "The value and its derivatives by the free parameters, at the current values.")
    .def(
      "GetNumberOfParameters",
      [](const MetricBaseType & self) { return self.GetState().GetNumberOfFreeParameters(); },
      "The free ones.")
    .def(
      "SetParameters",
      [](MetricBaseType & self, const std::vector<double> & values) {
        const std::size_t count = self.GetState().GetNumberOfFreeParameters();
        if (values.size() != count)
        {
          throw std::invalid_argument("the metric has " + std::to_string(count) + " free parameters, not " +
                                      std::to_string(values.size()));
        }
        MetricBaseType::ParametersType parameters(static_cast<unsigned int>(count));
        std::copy(values.begin(), values.end(), parameters.begin());
        self.SetParameters(parameters);
      },
      py::arg("parameters"),
      "Sets the free parameters, in the optimizer's unit.")
    .def(
      "GetParameters",
      [](const MetricBaseType & self) { return ToArray(self.GetState().GetFreeParameters()); },
      "The free parameters, in the optimizer's unit.")
    .def(
      "GetNumberOfResiduals",
      [](const MetricBaseType & self) { return Ready(self).GetNumberOfResiduals(); },
      py::call_guard<py::gil_scoped_release>(),
      "How many residuals the metric has at the current values.")
    .def(
      "GetResiduals",
      [](const MetricBaseType & self) {
        MetricBaseType::VectorType residuals;
        {
          const py::gil_scoped_release released;
          Ready(self).GetResiduals(residuals, nullptr);
        }
        return ToArray(residuals);
      },
      "(N,): divided by their standard deviations.")
    .def(
      "GetResidualsAndJacobian",
      [](const MetricBaseType & self) {
        MetricBaseType::VectorType residuals;
        MetricBaseType::MatrixType jacobian;
        {
          const py::gil_scoped_release released;
          Ready(self).GetResiduals(residuals, &jacobian);
        }
        return py::make_tuple(ToArray(residuals), MatrixToArray(jacobian));
      },
      "(N,) and (N, M): by the optimizer's parameters, plus sign.")
    .def(
      "SetKernelWidth",
      [](MetricBaseType & self, double width) { self.SetKernelWidth(width); },
      py::arg("width"),
      "Of the robust kernel, px of 0.25 mm.")
    .def(
      "SetRobustKernel",
      [](MetricBaseType & self, const itk::RobustKernel * kernel) { self.SetRobustKernel(kernel); },
      py::arg("kernel"),
      "Sets the robust kernel of every term that has one; widths are in pixels of 0.25 mm.")
    .def(
      "SetNoiseModel",
      [](MetricBaseType & self, const itk::ResidualNoiseModel * model) { self.SetNoiseModel(model); },
      py::arg("model"),
      "Sets the model of the noise of every term that has one.")
    .def(
      "SetNoiseLevels",
      [](MetricBaseType & self, double smooth, double white) {
        self.SetNoiseLevels({ smooth, white });
      },
      py::arg("smooth"),
      py::arg("white"),
      "Standard deviations of the drift along a tracing and of each point, px of 0.25 mm.")
    .def(
      "GetNoiseLevels",
      [](const MetricBaseType & self) -> py::object {
        itk::ContourNoiseLevels levels;
        if (!self.GetNoiseLevels(levels))
        {
          return py::none();
        }
        return py::make_tuple(levels.smooth, levels.white);
      },
      "(smooth, white), or None where no term has such noise.")
    .def(
      "UpdateNoiseCorrelation",
      [](MetricBaseType & self) { self.UpdateNoiseCorrelation(Ready(self).GetState().GetValues()); },
      py::call_guard<py::gil_scoped_release>(),
      R"(Takes the correlation of the noise from the current values, where it is held from then on.

A metric that was not told takes it from the first place that is evaluated: call this between runs of an optimizer.)")
    .def(
      "EstimateNoise",
      [](MetricBaseType & self, double minimumWeight) {
        Ready(self);
        return self.EstimateNoise(minimumWeight);
      },
      py::arg("minimumWeight") = 0.0,
      py::call_guard<py::gil_scoped_release>(),
      "Estimates the levels of the noise at the current values and sets them; minus twice the log likelihood.")
    .def(
      "Hold",
      [](MetricBaseType & self, HoldEnum what) {
        Ready(self);
        self.Hold(what);
      },
      py::arg("what"),
      "Says what stays as it is at the current values while the parameters move: Nothing, Contours "
      "or Matches.")
    .def("Modified", &MetricBaseType::Modified, "Says that what the metric computes has changed.")
    .def(
      "Clone",
      [](const MetricBaseType & self) {
        const itk::LightObject::Pointer   clone = self.Clone().GetPointer();
        itk::SmartPointer<MetricBaseType> metric = dynamic_cast<MetricBaseType *>(clone.GetPointer());
        return metric;
      },
      "A metric of its own with the same inputs and state.")
    .def("__str__", [](const MetricBaseType & self) {
      std::ostringstream text;
      self.Print(text);
      return text.str();
    });
}

void
WrapTerms(py::module_ & module)
{
  using SideEnum = itk::TracedSideEnum;
  BindEnum<SideEnum>(module,
                     "TracedSide",
                     { { "Right", SideEnum::Right },
                       { "Left", SideEnum::Left },
                       { "Mean", SideEnum::Mean },
                       { "Both", SideEnum::Both },
                       { "Standard", SideEnum::Standard } },
                     "Which side's outline was traced, or is to be; Standard is a cephalometric analysis's own way.");
  using PythonType = PythonLeastSquaresMetric;
  py::class_<PythonType, MetricBaseType, itk::SmartPointer<PythonType>>(module,
                                                                        "_LeastSquaresMetric",
                                                                        "What a metric written in Python stands on.",
                                                                        py::custom_type_setup(&PythonType::SetupType))
    .def(New<PythonType>())
    .def("_Bind", &PythonType::Bind, py::arg("object"));

  using SumType = itk::LeastSquaresSumMetricv4;
  MetricClass<SumType>(module,
                       "LeastSquaresSumMetricv4",
                       R"(Sum of metrics over one state: silhouettes, priors, terms of your own.

Terms that name the same block are about the same unknowns. A term's own values and what is free there are the sum's
from the moment it is added.)")
    .def(New<SumType>())
    .def(
      "AddMetric",
      [](SumType & self, MetricBaseType * metric, bool keepsSettings) {
        self.AddMetric(metric, keepsSettings ? SumType::SettingsEnum::Own : SumType::SettingsEnum::OfTheSum);
      },
      py::arg("metric"),
      py::arg("keepsSettings") = false,
      "keepsSettings: robust kernel and noise stay as the term has them, where else the sum's setters reach them.")
    .def(
      "RemoveMetric",
      [](SumType & self, MetricBaseType * metric) { self.RemoveMetric(metric); },
      py::arg("metric"),
      "Takes a term out of the sum.")
    .def("GetNumberOfMetrics", &SumType::GetNumberOfMetrics, "How many terms the sum has.")
    .def(
      "GetMetric",
      [](const SumType & self, std::size_t index) { return itk::SmartPointer<MetricBaseType>(self.GetMetric(index)); },
      py::arg("index"),
      "A term of the sum by its number.");

  using PriorMetricType = itk::ParameterPriorMetricv4;
  using PriorType = PriorMetricType::PriorType;
  py::class_<PriorType>(module,
                        "ParameterPrior",
                        "What is known of a parameter beforehand: Gaussian, or Student's t where degreesOfFreedom > 2.")
    .def(py::init([](double mean, double sigma, double degreesOfFreedom) {
           return PriorType{ mean, sigma, degreesOfFreedom };
         }),
         py::arg("mean") = 0.0,
         py::arg("sigma") = 1.0,
         py::arg("degreesOfFreedom") = 0.0)
    .def_readonly("mean", &PriorType::mean, "Mean, in the parameter's natural unit.")
    .def_readonly("sigma", &PriorType::sigma, "Infinity: nothing is known.")
    .def_readonly("degreesOfFreedom",
                  &PriorType::degreesOfFreedom,
                  "Degrees of freedom of Student's t distribution; infinite for a normal one.")
    .def("__repr__", [](const PriorType & self) {
      std::ostringstream text;
      text << "<dentalscr.ParameterPrior " << self.mean << " +- " << self.sigma << '>';
      return text.str();
    });
  MetricClass<PriorMetricType>(
    module, "ParameterPriorMetricv4", "What is known of a block's parameters beforehand, as a term.")
    .def(New<PriorMetricType>())
    .def("SetBlock",
         &PriorMetricType::SetBlock,
         py::arg("block"),
         "Sets the name of the block whose parameters the priors hold for.")
    .def(
      "GetBlock",
      [](const PriorMetricType & self) { return self.GetBlock(); },
      "Returns the name of the block whose parameters the priors hold for.")
    .def("SetPriors", &PriorMetricType::SetPriors, py::arg("priors"), "One a parameter of the block.")
    .def(
      "GetPriors",
      [](const PriorMetricType & self) { return self.GetPriors(); },
      "The priors in the order of the block's parameters.")
    .dentalscrBoolean(PriorMetricType,
                      UseVariancePrecision,
                      "whether the curvature is that of the prior's variance, also where its long tails are "
                      "flatter.");
}

void
WrapOptimizer(py::module_ & module)
{
  using StopEnum = itk::LevenbergMarquardtOptimizerv4Enums::StopCondition;
  BindEnum<StopEnum>(module,
                     "StopCondition",
                     { { "NotStarted", StopEnum::NotStarted },
                       { "Running", StopEnum::Running },
                       { "StepTolerance", StopEnum::StepTolerance },
                       { "ValueTolerance", StopEnum::ValueTolerance },
                       { "MaximumNumberOfIterations", StopEnum::MaximumNumberOfIterations },
                       { "MaximumNumberOfEvaluations", StopEnum::MaximumNumberOfEvaluations },
                       { "StoppedByObserver", StopEnum::StoppedByObserver },
                       { "NotFinite", StopEnum::NotFinite },
                       { "Exception", StopEnum::Exception } },
                     "Why a run of LevenbergMarquardtOptimizerv4 ended.");
  py::class_<OptimizerBaseType, itk::SmartPointer<OptimizerBaseType>>(
    module, "ObjectToObjectOptimizerBase", "An optimizer of ITK's v4 framework.")
    .def(
      "GetName",
      [](const OptimizerBaseType & self) { return std::string(self.GetNameOfClass()); },
      "Name of the class in C++.")
    .def(
      "GetStopConditionDescription",
      [](const OptimizerBaseType & self) { return self.GetStopConditionDescription(); },
      "Why the last run ended, in words.")
    .def("__str__", [](const OptimizerBaseType & self) {
      std::ostringstream text;
      self.Print(text);
      return text.str();
    });
  py::class_<OptimizerType, OptimizerBaseType, itk::SmartPointer<OptimizerType>>(
    module,
    "LevenbergMarquardtOptimizerv4",
    "Levenberg-Marquardt for metrics that are, or are majorised by, sums of squares.")
    .def(New<OptimizerType>())
    .def(
      "SetMetric",
      [](OptimizerType & self, MetricBaseType * metric) { self.SetMetric(metric); },
      py::arg("metric"),
      "Sets the sum of squares that is minimized.")
    .def(
      "SetNumberOfIterations", &OptimizerType::SetNumberOfIterations, py::arg("value"), "Most steps that are accepted.")
    .def(
      "GetNumberOfIterations",
      [](const OptimizerType & self) { return self.GetNumberOfIterations(); },
      "The most steps accepted in a run; 100 by default.")
    .dentalscrProperty(
      OptimizerType, MaximumNumberOfEvaluations, "the most steps tried in a run, accepted or not; 1000 by default.")
    .dentalscrProperty(OptimizerType,
                       StepTolerance,
                       "the length of step below which a run ends, in the metric's own unit of step length "
                       "(pixels); 1e-6 by default.")
    .dentalscrProperty(OptimizerType,
                       ValueTolerance,
                       "the part of the value below which an accepted step ends a run; 1e-8 by default, 0 is never.")
    .dentalscrProperty(
      OptimizerType, InitialDamping, "the damping of the first step of a run; 0 by default, which is Gauss-Newton.")
    .def(
      "StartOptimization",
      [](OptimizerType & self) {
        // Ctrl-C ends it at a step.
        const unsigned long observer = self.AddObserver(itk::IterationEvent(), [](const itk::EventObject &) {
          const py::gil_scoped_acquire interpreter;
          if (PyErr_CheckSignals() != 0)
          {
            throw py::error_already_set();
          }
        });
        try
        {
          const py::gil_scoped_release released;
          self.StartOptimization();
        }
        catch (...)
        {
          self.RemoveObserver(observer);
          throw;
        }
        self.RemoveObserver(observer);
      },
      "Runs from the metric's position and leaves the metric at the best one found.")
    .def("StopOptimization", &OptimizerType::StopOptimization, "In a command: the run ends before the next evaluation.")
    .def(
      "GetCurrentIteration",
      [](const OptimizerType & self) { return self.GetCurrentIteration(); },
      "How many steps were accepted in this or the last run.")
    .def(
      "GetCurrentPosition",
      [](const OptimizerType & self) { return ToArray(self.GetCurrentPosition()); },
      "The optimizer's parameters: the best so far in commands, the metric's outside of them.")
    .def(
      "GetCurrentMetricValue", [](const OptimizerType & self) { return self.GetCurrentMetricValue(); }, "There.")
    .def("GetTrialValue", &OptimizerType::GetTrialValue, "Where the last step was tried.")
    .def("GetStepAccepted", &OptimizerType::GetStepAccepted, "Whether the last step tried lowered the value.")
    .def("GetStepLength", &OptimizerType::GetStepLength, "In the metric's own unit.")
    .def("GetDamping", &OptimizerType::GetDamping, "The damping now or at the end of the last run.")
    .def("GetNumberOfEvaluations",
         &OptimizerType::GetNumberOfEvaluations,
         "How many steps were tried in this or the last run.")
    .def("GetStopCondition", &OptimizerType::GetStopCondition, "Why the last run ended.")
    .def("HasConverged", &OptimizerType::HasConverged, "Whether the last run ended by one of the two tolerances.")
    .def(
      "_AddCommand",
      [](const py::object & self, int event, unsigned long key) {
        return AddPythonCommand(self.cast<OptimizerType &>(), self, event, key);
      },
      py::arg("event"),
      py::arg("key"))
    .def(
      "_RemoveCommand", [](OptimizerType & self, unsigned long tag) { self.RemoveObserver(tag); }, py::arg("tag"));
}
/** Writes to a Python stream what the command says, in the thread in which events come, with the interpreter taken. */
class PythonIterationCommand : public itk::RegistrationIterationCommand
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PythonIterationCommand);
  using Self = PythonIterationCommand;
  using Superclass = itk::RegistrationIterationCommand;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);

  void
  SetPythonStream(const py::object & stream)
  {
    m_PythonStream = stream;
    this->SetStream(stream.is_none() ? nullptr : &m_Lines);
  }

  void
  Execute(itk::Object * caller, const itk::EventObject & event) override
  {
    this->Execute(const_cast<const itk::Object *>(caller), event);
  }

  void
  Execute(const itk::Object * caller, const itk::EventObject & event) override
  {
    Superclass::Execute(caller, event);
    const std::string lines = m_Lines.str();
    if (lines.empty() || !Py_IsInitialized())
    {
      return;
    }
    m_Lines.str(std::string());
    const py::gil_scoped_acquire interpreter;
    m_PythonStream.attr("write")(lines);
  }

protected:
  PythonIterationCommand() = default;
  ~PythonIterationCommand() override
  {
    if (Py_IsInitialized())
    {
      const py::gil_scoped_acquire interpreter;
      m_PythonStream = py::object();
    }
    else
    {
      m_PythonStream.release();
    }
  }

private:
  std::ostringstream m_Lines;
  py::object         m_PythonStream;
};

void
WrapIterationCommand(py::module_ & module)
{
  using RecordType = itk::RegistrationIterationCommand::RecordType;
  using KindEnum = itk::RegistrationIterationCommand::KindEnum;
  BindEnum<KindEnum>(module,
                     "RegistrationEventKind",
                     { { "Start", KindEnum::Start },
                       { "Level", KindEnum::Level },
                       { "Iteration", KindEnum::Iteration },
                       { "Abort", KindEnum::Abort },
                       { "End", KindEnum::End } },
                     "What a record of RegistrationIterationCommand is of.");
  py::class_<RecordType>(module, "RegistrationIterationRecord", "One event of a registration.")
    .def_readonly("kind", &RecordType::kind, "What the record is of: a start, an iteration or an end.")
    .def_readonly("level", &RecordType::level, "Number of the level, from 0.")
    .def_readonly("candidate", &RecordType::candidate, "Number of the candidate that is refined, from 0.")
    .def_readonly("iteration", &RecordType::iteration, "Number of the iteration, from 0.")
    .def_readonly("value", &RecordType::value, "Of the metric, at parameters.")
    .def_property_readonly(
      "parameters",
      [](const RecordType & self) { return ToArray(self.parameters); },
      "The parameters, as the registration reports them.")
    .def_readonly("stepLength", &RecordType::stepLength, "In the method's own unit of length.")
    .def_readonly("accepted", &RecordType::accepted, "Whether the step was taken.")
    .def_readonly("stopReason", &RecordType::stopReason, "At a level's start that of the level before; at the end.")
    .def("__repr__", [](const RecordType & self) {
      std::ostringstream text;
      text << "<dentalscr.RegistrationIterationRecord level " << self.level << ", iteration " << self.iteration
           << ", value " << self.value << '>';
      return text.str();
    });
  py::class_<PythonIterationCommand, itk::SmartPointer<PythonIterationCommand>>(
    module,
    "RegistrationIterationCommand",
    R"(Ready observer of any registration: level, candidate, iteration, value, step, parameters, stop reason.

Records every step, not the mere evaluations, and is cleared at each start, so that one serves many runs.)")
    .def(New<PythonIterationCommand>())
    .def(
      "Observe",
      [](PythonIterationCommand & self, itk::ProcessObject * method) { self.Observe(method); },
      py::arg("method").none(false),
      "Adds itself to a registration method; which keeps it.")
    .def(
      "Observe",
      [](PythonIterationCommand & self, OptimizerBaseType * optimizer) { self.Observe(optimizer); },
      py::arg("optimizer").none(false),
      "Adds itself to an optimizer that runs alone.")
    .def("SetStream",
         &PythonIterationCommand::SetPythonStream,
         py::arg("stream"),
         "What has a write(text), as sys.stdout, to write one line an event to; None writes nothing.")
    .def("SetWriteEvery", &PythonIterationCommand::SetWriteEvery, py::arg("iterations"), "Records all of them.")
    .def(
      "GetWriteEvery",
      [](const PythonIterationCommand & self) { return self.GetWriteEvery(); },
      "Every how many iterations a line is written; 1 by default. All are recorded.")
    .def(
      "GetRecords", [](const PythonIterationCommand & self) { return self.GetRecords(); }, "A copy.")
    .def(
      "GetTable",
      [](const PythonIterationCommand & self) {
        std::ostringstream table;
        self.WriteTable(table);
        return table.str();
      },
      "All iterations as comma-separated values: level, candidate, iteration, value, step_length, accepted, p0 ...");
}
} // namespace

void
WrapPoseMetrics(py::module_ & module)
{
  WrapState(module);
  WrapModels(module);
  WrapMetricBase(module);
  WrapTerms(module);
  WrapPoseTerms(module);
  WrapOptimizer(module);
  WrapIterationCommand(module);
}
} // namespace dentalscr

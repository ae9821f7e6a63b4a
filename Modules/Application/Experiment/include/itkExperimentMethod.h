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
#ifndef itkExperimentMethod_h
#define itkExperimentMethod_h

#include "ExperimentExport.h"
#include "itkCaseResult.h"
#include "itkCaseSimilarityRegistration.h"
#include "itkContourRegistrationMethodBase.h"
#include "itkExperimentCase.h"

#include "itkImage.h"
#include "itkSimilarity2DTransform.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace itk
{
class PoseRegistrationMethodBase;

/** \struct ExperimentMethod
 * \brief A method that an experiment compares.
 *
 * \ingroup Experiment
 */
struct ExperimentMethod
{
  enum class KindEnum : uint8_t
  {
    /** Our own, by CaseRegistration. */
    Pose,
    /** A registration of the silhouette with the tracing by a similarity. */
    Contour,
    /** The same by grey values: needs a radiograph. */
    Intensity
  };
  /** What is done differently before the registration. */
  enum class ChainEnum : uint8_t
  {
    Paper,
    FileAxes,
    ParallelProjection
  };

  std::string name;                      /**< Short and stable, for tables and programs. */
  std::string title;                     /**< In words, for a reader of the report. */
  KindEnum    kind{ KindEnum::Contour }; /**< What the method computes. */
  ChainEnum   chain{ ChainEnum::Paper }; /**< What stands before and after its registration. */

  /** Of kinds Contour and Intensity: makes the registration of this row, all but its inputs, for a pixel spacing in mm;
   * of kind Intensity an IntensityRegistrationMethod. */
  std::function<ContourRegistrationMethodBase::Pointer(const ExperimentMethod &, double)> make{};
  /** What the result is called, and the levels of our own registration. */
  CasePresetEnum preset{ CasePresetEnum::Paper };
  /** The motion is rigid. */
  bool keepsScale{ false };
  /** The share of points that a method with a say in it takes for outliers. */
  double outliers{ 0.0 };
  /** Of kind Pose: NAME=VALUE, see CaseRegistration::SetOption(). */
  std::vector<std::string> options{};
  /** Of kind Pose: exchanges parts of the method, see CaseRegistration::SetPoseMethodCallback(); and what it does, in
   * words of the table. */
  std::function<void(PoseRegistrationMethodBase &)> exchange{};
  std::string                                       exchanged{};
};

/** All methods in the order of the tables. */
Experiment_EXPORT const std::vector<ExperimentMethod> &
                        GetExperimentMethods();

/** Null where there is none. */
Experiment_EXPORT const ExperimentMethod *
FindExperimentMethod(const std::string & name);

/** The methods of a list of names, in the order of the tables; "default" stands for all without the intensity-driven
 * ones, "intensity" for those, "all" for both; "no-coarse-to-fine" is "single-stage", one method by two names. Throws
 * std::invalid_argument that names the unknown one and lists what there is. */
Experiment_EXPORT std::vector<ExperimentMethod>
                  SelectExperimentMethods(const std::vector<std::string> & names);

/** \class ExperimentRunner
 * \brief Runs methods on one case; what they share (silhouettes, DRRs) is made once. One object serves one thread.
 *
 * \ingroup Experiment
 */
class Experiment_EXPORT ExperimentRunner
{
public:
  using JawEnum = ToothCode::JawEnum;
  using TransformType = Similarity2DTransform<double>;
  using ImageType = DentalCaseData::ImageType;
  /** Prepares what all methods of a case share: frames, silhouettes, tracings. */
  explicit ExperimentRunner(const ExperimentCase & experimentCase);

  /** Polled while a method runs; true ends it with ProcessAborted. */
  void
  SetAbort(std::function<bool()> abort)
  {
    m_Abort = std::move(abort);
  }

  /** Registers every jaw and measures the errors. What a method can't do is a failed jaw with the reason. */
  CaseResult
  Run(const ExperimentMethod & method);

  /** One jaw by a method of kind Contour or Intensity, from a start where one is given. */
  JawResult
  RunJaw(const ExperimentMethod & method, JawEnum jaw, const TransformType * start = nullptr);

  /** Whether the case has a scan and a tracing of the jaw. */
  bool
  HasJaw(JawEnum jaw) const;

  /** The jaw's marked landmarks with where a chain's central ray through the centroid projects them, q, in their order
   * in `marked`. */
  std::vector<std::pair<std::array<double, 2>, std::array<double, 2>>>
  GetLandmarkPairs(JawEnum jaw, ExperimentMethod::ChainEnum chain = ExperimentMethod::ChainEnum::Paper);

  /** mm in the detector plane; the estimate where the case has none. */
  double
  GetMeanPixelSpacing(JawEnum jaw);

private:
  struct PreparedType
  {
    CephalometricGeometry::Pointer geometry;
    CephalometricGeometry::Pointer centred;
    DentalContour::Pointer         silhouette;
    ImageType::Pointer             radiograph;
    CaseFrameType::Pointer         frame;
    JawResult                      result;
  };

  PreparedType &
  Prepare(JawEnum jaw, ExperimentMethod::ChainEnum chain);
  TransformType::Pointer
  Register(const ExperimentMethod & method, JawEnum jaw, PreparedType & prepared, const TransformType * start);

  const ExperimentCase &                                                  m_Case;
  std::function<bool()>                                                   m_Abort;
  std::map<std::pair<JawEnum, ExperimentMethod::ChainEnum>, PreparedType> m_Prepared;
};
} // namespace itk

#endif

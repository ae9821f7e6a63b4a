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
#ifndef itkExperimentCase_h
#define itkExperimentCase_h

#include "ExperimentExport.h"
#include "itkDentalCaseData.h"
#include "itkDentalFrameEstimator.h"
#include "itkDentalPhantomCaseSource.h"
#include "itkExperimentMistake.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace itk
{
/** \struct ExperimentCase
 * \brief A case with what is needed to measure it: the marked landmarks, which no method sees.
 *
 * \ingroup Experiment
 */
struct ExperimentCase
{
  /** "typical-0001", or the folder's name. */
  std::string   id;
  std::uint64_t seed{ 0 };

  std::shared_ptr<const DentalCaseData> data;   /**< What methods may see: the case without its marked landmarks. */
  DentalLandmarkSet<2>::ConstPointer    marked; /**< What they are measured by, continuous pixel indices. */

  /** Without the toolkit's midline: the paper's frames. */
  DentalFrameResult frames;
  /** For the row without UMDA: rows are the file's own axes, mesh to frame. For a phantom those of a file that is
   * tilted by at most 15 degrees, else the signed permutation of the file's axes that is nearest to the frame. */
  std::array<std::array<std::array<double, 3>, 3>, 2> fileAxes{};
};

/** What a phantom case of an experiment may differ in from its cohort. */
struct ExperimentVariation
{
  using TracedSideEnum = DentalPhantomCaseSource::TracedSideEnum;
  enum class JawsEnum : std::uint8_t
  {
    Both,
    UpperAlone,
    LowerAlone
  };

  /** Of the level where it is not said. */
  std::optional<TracedSideEnum> tracedSide{};
  bool                          buccalOutline{ false };
  /** Each tooth drawn with an error of its own, as a factor on what DentalPhantomCaseSource says. */
  double toothBias{ 0.0 };
  /** The patient faces left, the source is on the left. */
  bool facesLeft{ false };
  /** A scanner frame for each jaw. */
  bool     separateFrames{ false };
  bool     knowsPixelSpacing{ true };
  bool     knowsPrincipalPoint{ true };
  JawsEnum jaws{ JawsEnum::Both };
  /** What is wrong with the case. */
  ExperimentMistakeEnums::Mistake mistake{ ExperimentMistakeEnums::Mistake::None };
  /** Share of each tooth's border that is not drawn. */
  double dropOut{ 0.0 };
  /** Added to the tracing, px: half of the variance white, half correlated along the tracing. */
  double extraNoise{ 0.0 };
  /** Factor on the stated source-to-midsagittal distance; the detector stays as far from the midsagittal plane. */
  double sourceDistanceFactor{ 1.0 };
  /** Factor on the stated pixel spacing. */
  double spacingFactor{ 1.0 };
  /** Of the head, degrees, added to what was drawn. */
  double yawDegrees{ 0.0 };
  double rollDegrees{ 0.0 };
  /** FDI numbers of teeth that the jaws lack. */
  std::vector<unsigned int> missingTeeth;
  /** What the scans lack at their distal end, mm. */
  double distalTrim{ 0.0 };
};

/** Draws the phantom case of a seed, with a radiograph only where asked for. Runs on the calling thread alone. What a
 * level gives beside the tracing is in the case: landmarks of an analysis and what is said of their errors. A frontal
 * radiograph is not. The function isAborted is polled meanwhile: where it gives true, ProcessAborted is thrown. */
Experiment_EXPORT ExperimentCase
MakePhantomExperimentCase(std::uint64_t                 seed,
                          const DentalPhantomLevel &    level,
                          bool                          withRadiograph,
                          const ExperimentVariation &   variation = ExperimentVariation(),
                          const std::function<bool()> & isAborted = {});

/** The same of a level's table. */
Experiment_EXPORT ExperimentCase
MakePhantomExperimentCase(std::uint64_t                       seed,
                          DentalPhantomCaseSource::CohortEnum cohort,
                          bool                                withRadiograph,
                          const ExperimentVariation &         variation = ExperimentVariation(),
                          const std::function<bool()> &       isAborted = {});

/** Reads a case file; throws DentalInputError where it is unusable or has no landmarks_2d to measure with, and
 * ProcessAborted where isAborted gives true meanwhile. */
Experiment_EXPORT ExperimentCase
LoadExperimentCase(const std::string & fileName, const std::string & id, const std::function<bool()> & isAborted = {});
} // namespace itk

#endif

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
#ifndef itkCaseSimilarityRegistration_h
#define itkCaseSimilarityRegistration_h

#include "itkCaseResult.h"
#include "itkDentalFrameEstimator.h"

#include "itkProcessObject.h"

namespace itk
{
/** \struct CaseSimilaritySettings
 * \brief What the paper's chain needs beside the data. */
struct CaseSimilaritySettings
{
  CasePresetEnum preset{ CasePresetEnum::Paper };
  unsigned int   numberOfContourPoints{ 441 };
  bool           useSurfaceDRR{ true };
  /** The caller: polled for abort while the registration iterates. */
  const ProcessObject * caller{ nullptr };
};

/** The paper's chain from the dental frame on, for one jaw: projection with the central ray through the centroid,
 * silhouette, similarity. `geometry` has a pixel spacing; its principal point is not used but to say where the jaw is
 * in the cephalostat. */
void
RegisterJawBySimilarity(const DentalCaseData &         data,
                        ToothCode::JawEnum             jaw,
                        const DentalJawFrame &         frame,
                        const CephalometricGeometry *  geometry,
                        const CaseSimilaritySettings & settings,
                        JawResult &                    result);

/** A pixel spacing that makes silhouette and tracing equally wide: what is left where none is known. */
double
EstimatePixelSpacing(const DentalCaseData & data, ToothCode::JawEnum jaw, const DentalJawFrame & frame);

/** The rigid map of a frame, mesh (mm) to frame, row-major 3x4. */
std::array<double, 12>
MeshToFrame(const DentalJawFrame & frame);

class ContourDistanceFilter;

/** The figures of an updated filter. */
ContourFigures
ToContourFigures(const ContourDistanceFilter * distances);

/** Every 3-D landmark of the jaw through the matrix that users act on. */
void
PredictLandmarks(const DentalCaseData & data, ToothCode::JawEnum jaw, JawResult & result);
} // namespace itk

#endif

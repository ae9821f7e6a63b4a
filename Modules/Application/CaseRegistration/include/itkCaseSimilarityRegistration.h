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

#include "CaseRegistrationExport.h"
#include "itkCaseResult.h"
#include "itkDentalFrameEstimator.h"

#include "itkProcessObject.h"
#include "itkSimilarity2DTransform.h"

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

/** \name The parts of the paper's chain
 * For whoever puts another registration in the middle: geometry about the jaw's centroid, whose projection is q; the
 * silhouette in q (its seconds are added to the result); and, with the similarity that was found between silhouette and
 * tracing, everything of the result that follows from it but the landmarks.
 *
 * \ingroup CaseRegistration
 * @{ */
CaseRegistration_EXPORT CephalometricGeometry::Pointer
                        MakeCentredGeometry(const CephalometricGeometry * geometry, const DentalJawFrame & frame);
CaseRegistration_EXPORT DentalContour::Pointer
                        MakeWholeSilhouette(const DentalCaseData::MeshType * mesh,
                                            CephalometricGeometry *          centred,
                                            const CaseSimilaritySettings &   settings,
                                            JawResult &                      result);
CaseRegistration_EXPORT void
SetSimilarityOfJaw(const DentalCaseData &                data,
                   ToothCode::JawEnum                    jaw,
                   const DentalJawFrame &                frame,
                   const CephalometricGeometry *         geometry,
                   const CephalometricGeometry *         centred,
                   DentalContour *                       silhouette,
                   const Similarity2DTransform<double> * transform,
                   JawResult &                           result);
/** @} */

/** The paper's chain from the dental frame on, for one jaw: projection with the central ray through the centroid,
 * silhouette, similarity. `geometry` has a pixel spacing; its principal point is not used but to say where the jaw is
 * in the cephalostat. */
CaseRegistration_EXPORT void
RegisterJawBySimilarity(const DentalCaseData &         data,
                        ToothCode::JawEnum             jaw,
                        const DentalJawFrame &         frame,
                        const CephalometricGeometry *  geometry,
                        const CaseSimilaritySettings & settings,
                        JawResult &                    result);

/** A pixel spacing that makes silhouette and tracing equally wide: what is left where none is known. */
CaseRegistration_EXPORT double
EstimatePixelSpacing(const DentalCaseData & data, ToothCode::JawEnum jaw, const DentalJawFrame & frame);

/** Where a similarity puts the jaw in the cephalostat: the in-plane rotation is one about y, the translation one in the
 * midsagittal plane; its scale is no rigid motion, but a factor on the magnification, which says how many mm a pixel
 * is. */
CaseRegistration_EXPORT std::array<double, 12>
                        PlaceInCephalostat(const std::array<double, 12> & meshToFrame,
                                           const SimilarityParameters &   similarity,
                                           const CephalometricGeometry *  geometry);

/** The rigid map of a frame, mesh (mm) to frame, row-major 3x4. */
CaseRegistration_EXPORT std::array<double, 12>
                        MeshToFrame(const DentalJawFrame & frame);

class ContourDistanceFilter;

/** The figures of an updated filter. */
CaseRegistration_EXPORT ContourFigures
ToContourFigures(const ContourDistanceFilter * distances);

/** Every 3-D landmark of the jaw through the matrix that users act on. */
CaseRegistration_EXPORT void
PredictLandmarks(const DentalCaseData & data, ToothCode::JawEnum jaw, JawResult & result);
} // namespace itk

#endif

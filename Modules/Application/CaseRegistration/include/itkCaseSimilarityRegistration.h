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

#include "itkDataObjectDecorator.h"
#include "itkProcessObject.h"
#include "itkSimilarity2DTransform.h"
#include "itkVersorRigid3DTransform.h"

#include <functional>

namespace itk
{
/** \struct CaseSimilaritySettings
 * \brief What the paper's chain needs beside the data. */
struct CaseSimilaritySettings
{
  CasePresetEnum preset{ CasePresetEnum::Paper }; /**< Named in the result. */
  unsigned int   numberOfContourPoints{ 441 };    /**< Points that the silhouette is resampled to. */
  bool           useSurfaceDRR{ true };           /**< Silhouette of the DRR as in the paper, or of the mesh. */
  /** Updates the registration, with the caller's events and abort; where it is not set the registration runs alone. */
  std::function<void(ProcessObject *)> run;
};

/** \name The parts of the paper's chain
 * For whoever puts another registration in the middle: each wires process objects and writes what they say into the
 * result. The geometry has a pixel spacing; the frame is the jaw's own, mesh (mm) to dental frame.
 *
 * \ingroup CaseRegistration
 * @{ */

/** The frame as an output of UMidlineDentalAxisFilter. */
using CaseFrameType = DataObjectDecorator<VersorRigid3DTransform<double>>;

/** The whole scan's silhouette, central ray through the frame's origin; its seconds are added to the result. */
CaseRegistration_EXPORT DentalContour::Pointer
                        MakeWholeSilhouette(const DentalCaseData::MeshType * mesh,
                                            const CaseFrameType *            frame,
                                            const CephalometricGeometry *    geometry,
                                            const CaseSimilaritySettings &   settings,
                                            JawResult &                      result);

/** Everything of the result that follows from the similarity that was found between silhouette and tracing, but the
 * landmarks. */
CaseRegistration_EXPORT void
SetSimilarityOfJaw(const DentalCaseData &                data,
                   ToothCode::JawEnum                    jaw,
                   const CaseFrameType *                 frame,
                   const CephalometricGeometry *         geometry,
                   DentalContour *                       silhouette,
                   const Similarity2DTransform<double> * transform,
                   JawResult &                           result);
/** @} */

/** The paper's chain from the dental frame on, for one jaw: projection with the central ray through the centroid,
 * silhouette, similarity. The geometry's principal point is not used but to say where the jaw is in the cephalostat. */
CaseRegistration_EXPORT void
RegisterJawBySimilarity(const DentalCaseData &         data,
                        ToothCode::JawEnum             jaw,
                        const CaseFrameType *          frame,
                        const CephalometricGeometry *  geometry,
                        const CaseSimilaritySettings & settings,
                        JawResult &                    result);

/** Where the similarity of a case puts the jaw in the cephalostat. */
CaseRegistration_EXPORT VersorRigid3DTransform<double>::ConstPointer
                        PlaceInCephalostat(const CaseFrameType *         frame,
                                           const SimilarityParameters &  similarity,
                                           const CephalometricGeometry * geometry);

class ContourDistanceFilter;

/** The figures of an updated filter. */
CaseRegistration_EXPORT ContourFigures
ToContourFigures(const ContourDistanceFilter * distances);

/** Every 3-D landmark of the jaw through the matrix that users act on. */
CaseRegistration_EXPORT void
PredictLandmarks(const DentalCaseData & data, ToothCode::JawEnum jaw, JawResult & result);
} // namespace itk

#endif

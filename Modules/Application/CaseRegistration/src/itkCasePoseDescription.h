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
#ifndef itkCasePoseDescription_h
#define itkCasePoseDescription_h

#include "itkCaseResult.h"
#include "itkDentalCaseData.h"
#include "itkLandmarkCounterpartSet.h"
#include "itkPoseSolution.h"
#include "itkScalePrior.h"
#include "itkUMidlineDentalAxisFilter.h"

#include <array>
#include <string>
#include <vector>

namespace itk
{
/** Not installed. What a case result says of a solution, of the first view and of further ones. */
using CaseAxisType = UMidlineDentalAxisFilter<DentalCaseData::MeshType>;

CaseAxisType::DecoratedTransformType *
FrameOf(CaseAxisType * axis, ToothCode::JawEnum jaw);

std::array<double, 12>
ToRows(const PoseSolution::ProjectionMatrixType & projection);

/** Where the landmarks are on the scans; what is not used, and why, is a warning that begins with the prefix. */
LandmarkCounterpartSet::Pointer
FindCaseCounterparts(const DentalCaseData &               data,
                     const CephalometricLandmarkSet *     landmarks,
                     CephalometricGeometry::DirectionEnum direction,
                     bool                                 ignoreSides,
                     CaseAxisType *                       axis,
                     const std::string &                  prefix,
                     CaseResult &                         result);

/** What a pixel's length is known by. */
ScalePrior::SpacingSource
SpacingSourceOf(const DentalRadiographData & radiograph);

/** Where a registered jaw is, and how the landmarks and outlines that it was registered with fit. */
void
DescribePlacedJaw(const PoseSolution &           solution,
                  ToothCode::JawEnum             jaw,
                  double                         millimetresPerUnit,
                  const LandmarkCounterpartSet * counterparts,
                  JawResult &                    result);

/** The exact silhouettes of the whole scans at the solution, their points given numbers: upper, lower, each null where
 * the jaw is not registered. */
std::array<DentalContour::Pointer, 2>
MakeWholeSilhouettes(const DentalCaseData &              data,
                     const PoseSolution &                solution,
                     const std::array<unsigned int, 2> & numberOfPoints,
                     unsigned int                        numberOfThreads);

/** The paper's figures between a jaw's tracing and a contour. */
void
Measure(DentalContour * tracing, DentalContour * contour, const char * name, JawResult & result);

/** The points of the scan that project to a contour, in its order. */
std::vector<std::array<double, 3>>
CollectRimPoints(const DentalContour & contour);

/** The contours of a jaw without a tracing that distances could be measured from, to look at: the silhouette of its
 * whole scan, and the crowns that outlines of single teeth were compared with. */
void
DescribeWithoutDistances(const PoseSolution & solution,
                         ToothCode::JawEnum   jaw,
                         DentalContour *      whole,
                         JawResult &          result);

/** The same figures of what of the moving contour lies within a few mm of the tracing; its points on the scan are kept:
 * of the rest nobody can see whether it fits. */
void
MeasureMatched(DentalContour * tracing, const PoseSolution & solution, ToothCode::JawEnum jaw, JawResult & result);

/** How far each point of the tracing, and each tooth's drawing, lies from the contour that it was matched with. */
void
MeasureTeeth(DentalContour * tracing, DentalContour * contour, JawResult & jaw);

/** Of the jaws that are there, registered or not, with how far off they are expected to be. By the scans' axes tips and
 * cusps are found where nobody marked them on the scans; null: not. */
void
ProjectLandmarks(const DentalCaseData & data, const PoseSolution * solution, CaseAxisType * axis, CaseResult & result);
/** A jaw that may lie anywhere on the radiograph and beyond has no expected error: its finding "undetermined" says so,
 * and a number of that size says less. */
void
LeaveOutBoundlessError(const std::array<unsigned int, 2> & imageSize, JawResult & jaw);
} // namespace itk

#endif

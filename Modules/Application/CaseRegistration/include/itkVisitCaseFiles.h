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
#ifndef itkVisitCaseFiles_h
#define itkVisitCaseFiles_h

#include "itkDentalCase.h"

#include <string>
#include <utility>

namespace itk
{
/** Calls a function with the field and the path of every file that a case may name, in the order of the contract, empty
 * ones too: "upper", "contours.UR1", "views.frontal.cephalogram.image". The case is a DentalCase or a const one; of the
 * former the paths may be set. Fields that end in "landmarks_2d" are only read to measure errors.
 *
 * What records, digests, names or hides the files of a case goes by it, so that a field that is new is missing nowhere.
 *
 * \ingroup CaseRegistration */
template <typename TCase, typename TVisit>
void
VisitCaseFiles(TCase & dentalCase, TVisit && visit)
{
  const auto visitRadiograph = [&visit](const std::string & prefix, auto & radiograph) {
    visit(prefix + "cephalogram.image", radiograph.imageFile);
    visit(prefix + "contours", radiograph.contoursFile);
    visit(prefix + "cephalometric_landmarks", radiograph.cephalometricLandmarksFile);
    visit(prefix + "landmarks_2d", radiograph.landmarks2DFile);
  };
  visit(std::string("upper"), dentalCase.upperFile);
  visit(std::string("lower"), dentalCase.lowerFile);
  visit(std::string("upper_labels"), dentalCase.upperLabelsFile);
  visit(std::string("lower_labels"), dentalCase.lowerLabelsFile);
  visitRadiograph("", dentalCase);
  visit(std::string("landmarks_3d"), dentalCase.landmarks3DFile);
  visit(std::string("stock_outlines"), dentalCase.stockOutlinesFile);
  for (auto & classFile : dentalCase.contourClassFiles)
  {
    visit("contours." + classFile.first, classFile.second);
  }
  for (auto & view : dentalCase.views)
  {
    visitRadiograph("views." + view.name + '.', view);
  }
}

/** Whether a file of this field is only read to measure errors. \ingroup CaseRegistration */
inline bool
IsOnlyForEvaluation(const std::string & field)
{
  const std::string end = "landmarks_2d";
  return field.size() >= end.size() && field.compare(field.size() - end.size(), end.size(), end) == 0;
}
} // namespace itk

#endif

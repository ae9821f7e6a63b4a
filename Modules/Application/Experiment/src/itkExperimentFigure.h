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
#ifndef itkExperimentFigure_h
#define itkExperimentFigure_h

#include "itkExperimentMethod.h"

#include <string>
#include <vector>

namespace itk
{
/** The paper's qualitative figure: one jaw of a case by several methods side by side, as PNG. */
void
WriteExperimentFigure(const ExperimentCase &           experimentCase,
                      ExperimentRunner &               runner,
                      const std::vector<std::string> & methods,
                      ToothCode::JawEnum               jaw,
                      const std::string &              fileName);
} // namespace itk

#endif

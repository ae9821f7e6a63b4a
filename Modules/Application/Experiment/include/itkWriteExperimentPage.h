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
#ifndef itkWriteExperimentPage_h
#define itkWriteExperimentPage_h

#include "ExperimentExport.h"

#include <string>

namespace itk
{
/** Writes index.html into the folder of an experiment (CohortExperiment): one page that asks nothing of the network,
 * with the tables that are there, to sort and filter, and the figures, those of plots/ included. Call it when they are
 * drawn. Times of computing are left out: the same settings give the same page. A table of more than 2 MB is linked and
 * not shown. Throws DentalInputError where the folder is no experiment's, a table or a picture in it can't be read, or
 * the page can't be written. \ingroup Experiment */
Experiment_EXPORT void
WriteExperimentPage(const std::string & folder);
} // namespace itk

#endif

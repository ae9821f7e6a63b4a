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
#ifndef itkRadiographForPage_h
#define itkRadiographForPage_h

#include "ReportPageExport.h"

#include "itkImage.h"

#include <string>

namespace itk
{
/** \struct RadiographForPage
 * \brief A radiograph that travels in a page.
 * \ingroup ReportPage
 */
struct RadiographForPage
{
  /** "data:image/jpeg;base64,…" */
  std::string uri;
  /** How many of the radiograph's pixels it covers: a few more than there are, where it was shrunk. */
  std::size_t width{ 0 };
  std::size_t height{ 0 };
};

/** Grey JPEG between the 0.2 and 99.8 % quantiles, as the overlays show it, shrunk by a whole factor where a side is
 * longer than asked for. Throws ExceptionObject where it cannot be compressed. \ingroup ReportPage */
ReportPage_EXPORT RadiographForPage
MakeRadiographForPage(const Image<float, 2> * radiograph, unsigned int maximumSide);
} // namespace itk

#endif

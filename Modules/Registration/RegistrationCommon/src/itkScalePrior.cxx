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
#include "itkScalePrior.h"

#include <ostream>

namespace itk
{
double
ScalePrior::GetSigma(SpacingSource source)
{
  switch (source)
  {
    case SpacingSource::Given:
      return 0.016;
    case SpacingSource::Dicom:
      return 0.05;
    case SpacingSource::Default:
    case SpacingSource::Estimated:
      break;
  }
  return 0.25;
}

std::ostream &
operator<<(std::ostream & os, ScalePrior::SpacingSource value)
{
  switch (value)
  {
    case ScalePrior::SpacingSource::Given:
      return os << "itk::ScalePrior::SpacingSource::Given";
    case ScalePrior::SpacingSource::Dicom:
      return os << "itk::ScalePrior::SpacingSource::Dicom";
    case ScalePrior::SpacingSource::Default:
      return os << "itk::ScalePrior::SpacingSource::Default";
    case ScalePrior::SpacingSource::Estimated:
      return os << "itk::ScalePrior::SpacingSource::Estimated";
  }
  return os << "INVALID VALUE FOR itk::ScalePrior::SpacingSource";
}
} // namespace itk

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
#define UMIDLINEDENTALAXIS_INSTANTIATE
#include "itkUMidlineDentalAxisFilter.h"

namespace itk
{
std::ostream &
operator<<(std::ostream & os, DentalFrameEnums::JawsShareFrame mode)
{
  switch (mode)
  {
    case DentalFrameEnums::JawsShareFrame::Off:
      return os << "Off";
    case DentalFrameEnums::JawsShareFrame::On:
      return os << "On";
    default:
      return os << "Check";
  }
}

template class UMidlineDentalAxis_EXPORT UMidlineDentalAxisFilter<Mesh<float, 3>>;
template class UMidlineDentalAxis_EXPORT UMidlineDentalAxisFilter<Mesh<double, 3>>;
} // namespace itk

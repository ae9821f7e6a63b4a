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
#include "itkSilhouetteContourFilter.h"

namespace itk
{
std::ostream &
operator<<(std::ostream & os, SilhouetteContourFilterEnums::Content content)
{
  switch (content)
  {
    case SilhouetteContourFilterEnums::Content::Intensity:
      return os << "Intensity";
    case SilhouetteContourFilterEnums::Content::ToothLabels:
      return os << "ToothLabels";
    case SilhouetteContourFilterEnums::Content::MergedLabels:
      return os << "MergedLabels";
  }
  return os << "unknown content";
}

std::ostream &
operator<<(std::ostream & os, SilhouetteContourFilterEnums::Level level)
{
  switch (level)
  {
    case SilhouetteContourFilterEnums::Level::Absolute:
      return os << "Absolute";
    case SilhouetteContourFilterEnums::Level::Fraction:
      return os << "Fraction";
    case SilhouetteContourFilterEnums::Level::Automatic:
      return os << "Automatic";
  }
  return os << "unknown level";
}

std::ostream &
operator<<(std::ostream & os, SilhouetteContourFilterEnums::OutputCoordinates coordinates)
{
  switch (coordinates)
  {
    case SilhouetteContourFilterEnums::OutputCoordinates::Index:
      return os << "Index";
    case SilhouetteContourFilterEnums::OutputCoordinates::Physical:
      return os << "Physical";
    case SilhouetteContourFilterEnums::OutputCoordinates::PhysicalOverSpacing:
      return os << "PhysicalOverSpacing";
  }
  return os << "unknown coordinates";
}

template class SilhouetteContourFilter<Image<float, 2>>;
template class SilhouetteContourFilter<Image<double, 2>>;
template class SilhouetteContourFilter<Image<unsigned char, 2>>;
template class SilhouetteContourFilter<Image<unsigned short, 2>>;
template class SilhouetteContourFilter<Image<short, 2>>;
} // namespace itk

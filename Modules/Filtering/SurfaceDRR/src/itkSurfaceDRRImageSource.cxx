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
#include "itkSurfaceDRRImageSource.h"

namespace itk
{
std::ostream &
operator<<(std::ostream & os, SurfaceDRRImageSourceEnums::Normalization normalization)
{
  return os << (normalization == SurfaceDRRImageSourceEnums::Normalization::Paper ? "Paper" : "Physical");
}

std::ostream &
operator<<(std::ostream & os, SurfaceDRRImageSourceEnums::Output output)
{
  switch (output)
  {
    case SurfaceDRRImageSourceEnums::Output::Thickness:
      return os << "Thickness";
    case SurfaceDRRImageSourceEnums::Output::Intensity:
      return os << "Intensity";
    default:
      return os << "InvertedIntensity";
  }
}

template class SurfaceDRRImageSource<Mesh<float, 3>, Image<float, 2>>;
template class SurfaceDRRImageSource<Mesh<double, 3>, Image<float, 2>>;
template class SurfaceDRRImageSource<Mesh<float, 3>, Image<unsigned char, 2>>;
template class SurfaceDRRImageSource<Mesh<double, 3>, Image<unsigned char, 2>>;
} // namespace itk

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
#include "itkDentalLandmarkSet.h"

#include <algorithm>
#include <stdexcept>

namespace itk
{
template <unsigned int VDimension>
ToothCode
DentalLandmarkSet<VDimension>::ParseName(const std::string & name)
{
  static const char * const suffixes[] = { "tip", "cusp", "B", "MB", "DB", "ML", "DL" };
  const std::size_t         underscore = name.find('_');
  if (underscore != std::string::npos)
  {
    const std::string suffix = name.substr(underscore + 1);
    if (std::find(std::begin(suffixes), std::end(suffixes), suffix) != std::end(suffixes))
    {
      const ToothCode code = ToothCode::FromString(name.substr(0, underscore));
      if (code.IsKnown())
      {
        return code;
      }
    }
  }
  throw std::invalid_argument("\"" + name + "\" is no landmark: a tooth code, \"_\" and one of tip cusp B MB DB ML DL");
}

template <unsigned int VDimension>
void
DentalLandmarkSet<VDimension>::AddLandmark(const std::string & name, const PointType & point)
{
  const ToothCode tooth = ParseName(name);
  if (this->Find(name) != nullptr)
  {
    throw std::invalid_argument("landmark \"" + name + "\" is there twice");
  }
  m_Landmarks.push_back({ name, tooth, point });
  this->Modified();
}

template <unsigned int VDimension>
auto
DentalLandmarkSet<VDimension>::Find(const std::string & name) const -> const LandmarkType *
{
  for (const LandmarkType & landmark : m_Landmarks)
  {
    if (landmark.name == name)
    {
      return &landmark;
    }
  }
  return nullptr;
}

template <unsigned int VDimension>
void
DentalLandmarkSet<VDimension>::Initialize()
{
  Superclass::Initialize();
  m_Landmarks.clear();
}

template <unsigned int VDimension>
void
DentalLandmarkSet<VDimension>::Graft(const DataObject * data)
{
  const auto * landmarks = dynamic_cast<const Self *>(data);
  if (landmarks == nullptr)
  {
    itkExceptionMacro("Graft() needs a DentalLandmarkSet of dimension " << VDimension << '.');
  }
  m_Landmarks = landmarks->m_Landmarks;
  this->Modified();
}

template <unsigned int VDimension>
void
DentalLandmarkSet<VDimension>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  for (const LandmarkType & landmark : m_Landmarks)
  {
    os << indent << landmark.name << ": " << landmark.point << std::endl;
  }
}

template class DentalLandmarkSet<2>;
template class DentalLandmarkSet<3>;
} // namespace itk

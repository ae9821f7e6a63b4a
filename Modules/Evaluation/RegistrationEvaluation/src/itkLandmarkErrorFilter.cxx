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
#include "itkLandmarkErrorFilter.h"

#include <cmath>
#include <map>
#include <utility>

namespace itk
{
namespace
{
/** What a landmark is, whatever the numbering of its name. */
using KeyType = std::pair<ToothCode, std::string>;
using IndexType = std::map<KeyType, const DentalLandmarkSet<2>::LandmarkType *>;

KeyType
KeyOf(const DentalLandmarkSet<2>::LandmarkType & landmark)
{
  return { landmark.tooth, landmark.name.substr(landmark.name.find('_') + 1) };
}

bool
IsOfJaw(const DentalLandmarkSet<2>::LandmarkType & landmark, ToothCode::JawEnum jaw)
{
  return jaw == ToothCode::JawEnum::Unknown || landmark.tooth.GetJaw() == jaw;
}

IndexType
MakeIndex(const DentalLandmarkSet<2> & landmarks, ToothCode::JawEnum jaw, const char * which)
{
  IndexType index;
  for (const auto & landmark : landmarks.GetLandmarks())
  {
    if (!IsOfJaw(landmark, jaw))
    {
      continue;
    }
    if (!std::isfinite(landmark.point[0]) || !std::isfinite(landmark.point[1]))
    {
      itkGenericExceptionMacro("The " << which << " landmark " << landmark.name << " is at " << landmark.point
                                      << ", which is not finite.");
    }
    const auto entry = index.emplace(KeyOf(landmark), &landmark);
    if (!entry.second)
    {
      itkGenericExceptionMacro("The " << which << " landmarks " << entry.first->second->name << " and " << landmark.name
                                      << " are the same one. Keep one of them.");
    }
  }
  return index;
}

const DentalLandmarkSet<2>::LandmarkType *
Find(const IndexType & index, const KeyType & key)
{
  const auto found = index.find(key);
  return found == index.end() ? nullptr : found->second;
}

LandmarkErrorFilter::PointType
Middle(const LandmarkErrorFilter::PointType & a, const LandmarkErrorFilter::PointType & b)
{
  LandmarkErrorFilter::PointType middle;
  middle.SetToMidPoint(a, b);
  return middle;
}
} // namespace

LandmarkErrorFilter::LandmarkErrorFilter()
{
  m_PixelSpacing.Fill(0.0);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

DataObject::Pointer
LandmarkErrorFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  const auto output = StatisticsObjectType::New();
  output->Set(LandmarkErrorStatistics());
  return output.GetPointer();
}

const LandmarkErrorFilter::StatisticsObjectType *
LandmarkErrorFilter::GetStatisticsOutput() const
{
  return static_cast<const StatisticsObjectType *>(this->ProcessObject::GetOutput(0));
}

const LandmarkErrorStatistics &
LandmarkErrorFilter::GetStatistics() const
{
  return this->GetStatisticsOutput()->Get();
}

void
LandmarkErrorFilter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetPredictedLandmarks() == nullptr)
  {
    itkExceptionMacro("There are no predicted landmarks: call SetPredictedLandmarks().");
  }
  if (this->GetReferenceLandmarks() == nullptr)
  {
    itkExceptionMacro("There are no reference landmarks: call SetReferenceLandmarks().");
  }
  const bool unknown = m_PixelSpacing[0] == 0.0 && m_PixelSpacing[1] == 0.0;
  const bool known = m_PixelSpacing[0] > 0.0 && m_PixelSpacing[1] > 0.0 && std::isfinite(m_PixelSpacing[0]) &&
                     std::isfinite(m_PixelSpacing[1]);
  if (!unknown && !known)
  {
    itkExceptionMacro("The pixel spacing " << m_PixelSpacing
                                           << " is none: call SetPixelSpacing() with mm a pixel, both > 0, or both 0 "
                                              "where it is unknown.");
  }
  Superclass::VerifyPreconditions();
}

void
LandmarkErrorFilter::GenerateData()
{
  const LandmarkSetType & predictedSet = *this->GetPredictedLandmarks();
  const LandmarkSetType & referenceSet = *this->GetReferenceLandmarks();
  const IndexType         predictedIndex = MakeIndex(predictedSet, m_Jaw, "predicted");
  const IndexType         referenceIndex = MakeIndex(referenceSet, m_Jaw, "reference");
  m_Errors.clear();
  m_UnpairedLandmarks.clear();
  LandmarkErrorStatistics statistics;
  for (const auto & reference : referenceSet.GetLandmarks())
  {
    if (!IsOfJaw(reference, m_Jaw))
    {
      continue;
    }
    const KeyType     key = KeyOf(reference);
    const auto *      predicted = Find(predictedIndex, key);
    LandmarkErrorType error;
    error.name = reference.name;
    error.tooth = reference.tooth;
    bool paired = predicted != nullptr;
    if (paired)
    {
      error.predicted = predicted->point;
      error.reference = reference.point;
    }
    if (m_BisectSides)
    {
      const KeyType counterpart{ reference.tooth.GetContralateral(), key.second };
      const auto *  otherPredicted = Find(predictedIndex, counterpart);
      const auto *  otherReference = Find(referenceIndex, counterpart);
      paired = paired && otherPredicted != nullptr && otherReference != nullptr;
      if (paired)
      {
        if (reference.tooth.IsLeft())
        {
          // Measured with its right one.
          continue;
        }
        error.name += '+' + otherReference->name;
        error.predicted = Middle(error.predicted, otherPredicted->point);
        error.reference = Middle(error.reference, otherReference->point);
      }
    }
    if (!paired)
    {
      m_UnpairedLandmarks.push_back(reference.name);
      continue;
    }
    const Vector<double, 2> difference = error.predicted - error.reference;
    error.distance = difference.GetNorm();
    if (m_PixelSpacing[0] > 0.0)
    {
      error.millimetres = std::hypot(difference[0] * m_PixelSpacing[0], difference[1] * m_PixelSpacing[1]);
      statistics.Add(error.tooth.GetGroup(), error.distance, *error.millimetres);
    }
    else
    {
      statistics.Add(error.tooth.GetGroup(), error.distance);
    }
    m_Errors.push_back(error);
  }
  for (const auto & predicted : predictedSet.GetLandmarks())
  {
    if (IsOfJaw(predicted, m_Jaw) && Find(referenceIndex, KeyOf(predicted)) == nullptr)
    {
      m_UnpairedLandmarks.push_back(predicted.name);
    }
  }
  static_cast<StatisticsObjectType *>(this->ProcessObject::GetOutput(0))->Set(statistics);
}

void
LandmarkErrorFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Jaw: " << m_Jaw << std::endl;
  os << indent << "BisectSides: " << m_BisectSides << std::endl;
  os << indent << "PixelSpacing: " << m_PixelSpacing << std::endl;
  os << indent << "Statistics: " << this->GetStatistics() << std::endl;
  for (const LandmarkErrorType & error : m_Errors)
  {
    os << indent << error.name << ": " << error.distance << " px" << std::endl;
  }
  os << indent << "UnpairedLandmarks:";
  for (const std::string & name : m_UnpairedLandmarks)
  {
    os << ' ' << name;
  }
  os << std::endl;
}
} // namespace itk

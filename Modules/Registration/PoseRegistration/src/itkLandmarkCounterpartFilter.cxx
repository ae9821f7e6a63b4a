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
#include "itkLandmarkCounterpartFilter.h"

#include "itkJawIndex.h"
#include "itkToothFinder.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using FeatureEnum = CephalometricLandmarkSet::FeatureEnum;
} // namespace

LandmarkCounterpartFilter::LandmarkCounterpartFilter()
{
  this->AddRequiredInputName("CephalometricLandmarks", 0);
  this->AddOptionalInputName("ScanLandmarks", 1);
  this->AddOptionalInputName("UpperMesh", 2);
  this->AddOptionalInputName("LowerMesh", 3);
  this->AddOptionalInputName("UpperFrame", 4);
  this->AddOptionalInputName("LowerFrame", 5);
  this->AddOptionalInputName("Solution", 6);
  this->AddOptionalInputName("UpperTracing", 7);
  this->AddOptionalInputName("LowerTracing", 8);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

DataObject::Pointer
LandmarkCounterpartFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return OutputType::New().GetPointer();
}

void
LandmarkCounterpartFilter::SetLabels(JawEnum jaw, const LabelsType & labels)
{
  LabelsType & own = m_Labels[ToIndex(jaw)];
  if (own != labels)
  {
    own = labels;
    this->Modified();
  }
}

const LandmarkCounterpartFilter::LabelsType &
LandmarkCounterpartFilter::GetLabels(JawEnum jaw) const
{
  return m_Labels[ToIndex(jaw)];
}

void
LandmarkCounterpartFilter::SetExcludedTeeth(const std::vector<ToothCode> & teeth)
{
  if (m_ExcludedTeeth != teeth)
  {
    m_ExcludedTeeth = teeth;
    this->Modified();
  }
}

LandmarkCounterpartFilter::OutputType *
LandmarkCounterpartFilter::GetOutput()
{
  return itkDynamicCastInDebugMode<OutputType *>(this->ProcessObject::GetOutput(0));
}

const LandmarkCounterpartFilter::OutputType *
LandmarkCounterpartFilter::GetOutput() const
{
  return itkDynamicCastInDebugMode<const OutputType *>(this->ProcessObject::GetOutput(0));
}

void
LandmarkCounterpartFilter::SetUnusableLandmarks(const std::vector<std::string> & names)
{
  if (names != m_UnusableLandmarks)
  {
    m_UnusableLandmarks = names;
    this->Modified();
  }
}

void
LandmarkCounterpartFilter::GenerateData()
{
  OutputType * output = this->GetOutput();
  output->Initialize();
  m_Unused.clear();
  const auto  frameOf = [](const FrameType * frame) { return frame != nullptr ? frame->Get() : nullptr; };
  ToothFinder scans[2] = { ToothFinder(this->GetUpperMesh(),
                                       frameOf(this->GetUpperFrame()),
                                       m_Labels[0],
                                       this->GetScanLandmarks(),
                                       m_MillimetresPerUnit,
                                       JawEnum::Upper),
                           ToothFinder(this->GetLowerMesh(),
                                       frameOf(this->GetLowerFrame()),
                                       m_Labels[1],
                                       this->GetScanLandmarks(),
                                       m_MillimetresPerUnit,
                                       JawEnum::Lower) };
  for (ToothFinder & scan : scans)
  {
    scan.SetUnusableLandmarks(m_UnusableLandmarks);
  }
  if (const PoseSolution * solution = this->GetSolution())
  {
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      const DentalContour * tracing = jaw == JawEnum::Upper ? this->GetUpperTracing() : this->GetLowerTracing();
      if (tracing != nullptr && solution->IsRegistered(jaw))
      {
        scans[ToIndex(jaw)].SetTracing({ TracedToothRow(tracing->GetPolylines()),
                                         [solution, jaw](const ToothFinder::PointType & point) {
                                           const auto pixel = solution->ProjectPoint(jaw, point);
                                           return std::array<double, 2>{ { pixel[0], pixel[1] } };
                                         },
                                         m_Bisected });
      }
    }
  }
  for (const auto & landmark : this->GetCephalometricLandmarks()->GetLandmarks())
  {
    const auto & meaning = landmark.meaning;
    if (meaning.feature == FeatureEnum::Apex)
    {
      m_Unused.push_back({ landmark.name, "no scan shows the end of a root" });
      continue;
    }
    if ((meaning.jaw == JawEnum::Upper ? this->GetUpperMesh() : this->GetLowerMesh()) == nullptr)
    {
      m_Unused.push_back({ landmark.name, "there is no scan of the jaw" });
      continue;
    }
    const unsigned int right = meaning.jaw == JawEnum::Upper ? 10 : 40;
    const unsigned int left = meaning.jaw == JawEnum::Upper ? 20 : 30;
    const bool         both = m_IgnoreSides || !meaning.tooth.IsKnown();
    if (both && m_Direction == DirectionEnum::Frontal && meaning.position > 1)
    {
      m_Unused.push_back(
        { landmark.name, "the name tells no side, and a frontal radiograph shows both: name it as UR6_MB or UL6_MB" });
      continue;
    }
    std::vector<ToothCode> teeth;
    if (both)
    {
      teeth = { ToothCode(right + meaning.position), ToothCode(left + meaning.position) };
    }
    else
    {
      teeth = { meaning.tooth };
    }
    teeth.erase(std::remove_if(teeth.begin(),
                               teeth.end(),
                               [this](const ToothCode & tooth) {
                                 return std::find(m_ExcludedTeeth.begin(), m_ExcludedTeeth.end(), tooth) !=
                                        m_ExcludedTeeth.end();
                               }),
                teeth.end());
    if (teeth.empty())
    {
      m_Unused.push_back({ landmark.name, "the tooth is excluded" });
      continue;
    }
    OutputType::CounterpartType counterpart;
    counterpart.name = CephalometricLandmarkSet::MakeName(meaning);
    counterpart.jaw = meaning.jaw;
    // An analysis draws the most prominent of the incisors, and between the images of posterior teeth.
    counterpart.rule = meaning.position == 1 ? OutputType::RuleEnum::Foremost : OutputType::RuleEnum::Middle;
    for (const ToothCode & tooth : teeth)
    {
      if (const auto place = scans[ToIndex(meaning.jaw)].Find(tooth, meaning.feature))
      {
        counterpart.points.push_back(place->point);
        counterpart.sigmaAlong = std::max(counterpart.sigmaAlong, place->sigmaAlong);
        counterpart.sigmaAcross = std::max(counterpart.sigmaAcross, place->sigmaAcross);
        // The two teeth of a pair may be found by different means.
        counterpart.source += counterpart.source.empty()            ? place->source
                              : counterpart.source != place->source ? std::string(" and ") + place->source
                                                                    : "";
      }
    }
    if (counterpart.points.empty())
    {
      m_Unused.push_back({ landmark.name, "found neither in landmarks_3d nor by labels nor on the arch" });
      continue;
    }
    if (both && counterpart.points.size() == 1 && meaning.position > 1)
    {
      counterpart.sigmaAlong = std::hypot(counterpart.sigmaAlong, OutputType::OneSideSigmaAlong);
      counterpart.sigmaAcross = std::hypot(counterpart.sigmaAcross, OutputType::OneSideSigmaAcross);
    }
    output->Add(counterpart);
  }
}

void
LandmarkCounterpartFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MillimetresPerUnit: " << m_MillimetresPerUnit << std::endl;
  os << indent << "UnusableLandmarks: " << m_UnusableLandmarks.size() << std::endl;
  os << indent << "IgnoreSides: " << (m_IgnoreSides ? "On" : "Off") << std::endl;
  os << indent << "Bisected: " << (m_Bisected ? "On" : "Off") << std::endl;
  os << indent << "Direction: " << m_Direction << std::endl;
  os << indent << "UpperLabels: " << m_Labels[0].size() << std::endl;
  os << indent << "LowerLabels: " << m_Labels[1].size() << std::endl;
  os << indent << "ExcludedTeeth: " << m_ExcludedTeeth.size() << std::endl;
  os << indent << "Unused: " << m_Unused.size() << std::endl;
}
} // namespace itk

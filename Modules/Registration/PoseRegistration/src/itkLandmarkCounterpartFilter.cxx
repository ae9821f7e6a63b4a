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

#include "itkMakeTriangleSurface.h"
#include "itkPoseArch.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using FeatureEnum = CephalometricLandmarkSet::FeatureEnum;
using PointType = LandmarkCounterpartSet::PointType;

unsigned int
ToIndex(JawEnum jaw)
{
  return jaw == JawEnum::Upper ? 0 : 1;
}

/** Where a landmark is on the scan, and how far it may be from there. */
struct PlaceType
{
  PointType    point;
  double       sigmaAlong;
  double       sigmaAcross;
  const char * source;
};

// Errors of counterparts, mm, along the occlusal plane and across it.
/** A scan's landmark is a click on a cusp. */
constexpr double ClickSigma = 0.2;
/** The highest labelled point of a tooth's part is its cusp or near it; worn ones have none. */
constexpr double LabelSigmaAlong = 0.6;
constexpr double LabelSigmaAcross = 0.4;
/** The arch's front is an incisal edge whose middle may be another tooth's; canines and premolars stand in between. */
constexpr double EdgeSigmaAlong = 0.6;
constexpr double EdgeSigmaAcross = 0.5;
/** Teeth are some 7 % wider or narrower than the textbook's, all of a mouth alike: 2 mm at the first molar; gaps and
 * crowding move it as well. */
constexpr double ArchSigmaAlong = 2.2;
constexpr double ArchSigmaAcross = 0.7;
/** Edges and cusps are not lower than this below the highest point near them, mm; gingiva and palate are. */
constexpr double CuspRange = 2.5;
/** A contact derived from the cusps, and the middle of an occlusal surface. */
constexpr double DerivedSigmaAlong = 0.6;
constexpr double DerivedSigmaAcross = 0.8;
/** A molar's point of which nobody said which lies between the mesial contact and the middle of the surface. */
constexpr double UnspecifiedSigmaAlong = 2.0;
constexpr double UnspecifiedSigmaAcross = 0.8;
/** The image of the other side's tooth, where only one was found: arches are not symmetric, heads turn by two degrees,
 * and 45 mm lie between first molars. */
constexpr double OneSideSigmaAlong = 1.2;
constexpr double OneSideSigmaAcross = 0.6;

/** Distances of a first molar's points, mm: mesiobuccal cusp to the mesial contact, along and down; cusps to the floor
 * of the occlusal surface. */
constexpr double CuspToContact = 2.4;
constexpr double ContactBelowCusp = 2.5;
constexpr double FloorBelowCusps = 1.5;

const char *
SuffixOf(FeatureEnum feature, unsigned int position)
{
  switch (feature)
  {
    case FeatureEnum::Tip:
      return "tip";
    case FeatureEnum::Cusp:
      return position == 3 ? "cusp" : "B";
    case FeatureEnum::MesiobuccalCusp:
      return "MB";
    case FeatureEnum::DistobuccalCusp:
      return "DB";
    case FeatureEnum::MesiolingualCusp:
      return "ML";
    default:
      return "DL";
  }
}

/** One jaw's scan in its dental frame, prepared when it is first needed. */
class ScanType
{
public:
  ScanType(const LandmarkCounterpartFilter::MeshType *          mesh,
           const VersorRigid3DTransform<double> *               frame,
           const LandmarkCounterpartFilter::LabelsType &        labels,
           const LandmarkCounterpartFilter::ScanLandmarksType * landmarks,
           double                                               millimetresPerUnit,
           JawEnum                                              jaw)
    : m_Mesh(mesh)
    , m_Frame(frame)
    , m_Labels(labels)
    , m_Landmarks(landmarks)
    , m_MillimetresPerUnit(millimetresPerUnit)
    , m_Jaw(jaw)
  {}

  std::optional<PlaceType>
  Find(const ToothCode & tooth, FeatureEnum feature)
  {
    if (feature == FeatureEnum::Unspecified)
    {
      std::optional<PlaceType> place = this->Find(tooth, FeatureEnum::MesiobuccalCusp);
      Widen(place, UnspecifiedSigmaAlong, UnspecifiedSigmaAcross);
      return place;
    }
    if (feature == FeatureEnum::MesialContact || feature == FeatureEnum::OcclusalMiddle)
    {
      return this->FindDerived(tooth, feature);
    }
    if (const auto clicked = this->FindClicked(tooth, feature))
    {
      return PlaceType{ *clicked, ClickSigma, ClickSigma, "landmarks_3d" };
    }
    if (auto labelled = this->FindLabelled(tooth, feature))
    {
      return labelled;
    }
    return this->FindAlongArch(tooth, feature);
  }

private:
  static void
  Widen(std::optional<PlaceType> & place, double along, double across)
  {
    if (place)
    {
      place->sigmaAlong = std::hypot(place->sigmaAlong, along);
      place->sigmaAcross = std::hypot(place->sigmaAcross, across);
    }
  }

  std::optional<PointType>
  FindClicked(const ToothCode & tooth, FeatureEnum feature) const
  {
    if (m_Landmarks == nullptr)
    {
      return {};
    }
    const auto * landmark = m_Landmarks->Find(tooth.GetName() + '_' + SuffixOf(feature, tooth.GetPosition()));
    if (landmark == nullptr)
    {
      return {};
    }
    PointType point;
    for (unsigned int d = 0; d < 3; ++d)
    {
      point[d] = landmark->point[d] * m_MillimetresPerUnit;
    }
    return point;
  }

  /** A point below a place, away from the occlusal side. */
  PointType
  Below(const PointType & point, double distance) const
  {
    if (m_Frame == nullptr)
    {
      return point;
    }
    PointType place = m_Frame->TransformPoint(point);
    place[2] += m_Jaw == JawEnum::Upper ? distance : -distance;
    return m_Frame->GetInverseTransform()->TransformPoint(place);
  }

  std::optional<PlaceType>
  FindDerived(const ToothCode & tooth, FeatureEnum feature)
  {
    std::optional<PlaceType> front = this->Find(tooth, FeatureEnum::MesiobuccalCusp);
    if (!front || tooth.GetPosition() < 6)
    {
      return {};
    }
    const std::optional<PlaceType> back = this->Find(tooth, FeatureEnum::DistobuccalCusp);
    const auto                     along = back ? front->point - back->point : PointType::VectorType();
    const double                   length = back ? along.GetNorm() : 0.0;
    if (feature == FeatureEnum::MesialContact)
    {
      if (length > 1.0)
      {
        front->point += along * (CuspToContact / length);
      }
      front->point = this->Below(front->point, ContactBelowCusp);
      Widen(front, length > 1.0 ? DerivedSigmaAlong : CuspToContact, DerivedSigmaAcross);
      return front;
    }
    if (length > 1.0)
    {
      front->point -= along * 0.5;
    }
    front->point = this->Below(front->point, FloorBelowCusps);
    Widen(front, length > 1.0 ? DerivedSigmaAlong : UnspecifiedSigmaAlong, DerivedSigmaAcross);
    return front;
  }

  void
  Prepare()
  {
    if (m_Surface || m_Mesh == nullptr || m_Frame == nullptr)
    {
      return;
    }
    m_Surface = std::make_unique<TriangleSurface>(MakeTriangleSurface(m_Mesh));
    for (auto & p : m_Surface->points)
    {
      PointType point;
      for (unsigned int d = 0; d < 3; ++d)
      {
        point[d] = p[d];
      }
      point = m_Frame->TransformPoint(point);
      for (unsigned int d = 0; d < 3; ++d)
      {
        p[d] = static_cast<float>(point[d]);
      }
    }
    m_Arch = PoseArch(*m_Surface, m_Jaw);
  }

  double
  Height(std::size_t i) const
  {
    return m_Jaw == JawEnum::Upper ? -m_Surface->points[i][2] : m_Surface->points[i][2];
  }

  PointType
  ToMesh(std::size_t i) const
  {
    PointType point;
    for (unsigned int d = 0; d < 3; ++d)
    {
      point[d] = m_Surface->points[i][d];
    }
    return m_Frame->GetInverseTransform()->TransformPoint(point);
  }

  /** How far a feature lies from the tooth's middle toward the back, in widths of the tooth. */
  static double
  ShareBehindMiddle(FeatureEnum feature)
  {
    return feature == FeatureEnum::MesiobuccalCusp || feature == FeatureEnum::MesiolingualCusp   ? -0.24
           : feature == FeatureEnum::DistobuccalCusp || feature == FeatureEnum::DistolingualCusp ? 0.24
                                                                                                 : 0.0;
  }

  std::optional<PlaceType>
  FindLabelled(const ToothCode & tooth, FeatureEnum feature)
  {
    if (m_Labels.empty())
    {
      return {};
    }
    this->Prepare();
    if (!m_Surface || !m_Arch.IsValid() || m_Labels.size() != m_Surface->points.size())
    {
      return {};
    }
    std::vector<std::size_t> points;
    std::vector<double>      arcs;
    for (std::size_t i = 0; i < m_Labels.size(); ++i)
    {
      if (m_Labels[i] == tooth.GetFDI())
      {
        points.push_back(i);
        arcs.push_back(std::abs(m_Arch.Arc(m_Surface->points[i][0], m_Surface->points[i][1])));
      }
    }
    if (points.size() < 10)
    {
      return {};
    }
    const auto   range = std::minmax_element(arcs.begin(), arcs.end());
    const double middle = 0.5 * (*range.first + *range.second);
    const double width = *range.second - *range.first;
    const double share = ShareBehindMiddle(feature);
    return this->FindPeak(
      points, arcs, middle + share * width, feature, LabelSigmaAlong, LabelSigmaAcross, "tooth labels");
  }

  std::optional<PlaceType>
  FindAlongArch(const ToothCode & tooth, FeatureEnum feature)
  {
    this->Prepare();
    if (!m_Surface || !m_Arch.IsValid() || tooth.GetPosition() > 7)
    {
      return {};
    }
    const double width = PoseArch::ExpectedWidth(tooth.GetFDI());
    const double target = PoseArch::CurveShare * (PoseArch::ExpectedArc(tooth.GetFDI()) + ShareBehindMiddle(feature) * width);
    std::vector<std::size_t> points;
    std::vector<double>      arcs;
    for (std::size_t i = 0; i < m_Surface->points.size(); ++i)
    {
      const auto & p = m_Surface->points[i];
      // Right is the side of negative y.
      if ((p[1] < 0.0F) != tooth.IsRight())
      {
        continue;
      }
      const double arc = std::abs(m_Arch.Arc(p[0], p[1]));
      if (std::abs(arc - target) < (feature == FeatureEnum::Tip ? 0.25 : 0.5) * width)
      {
        points.push_back(i);
        arcs.push_back(arc);
      }
    }
    const bool incisor = tooth.GetPosition() == 1;
    return this->FindPeak(points,
                          arcs,
                          target,
                          feature,
                          incisor ? EdgeSigmaAlong : ArchSigmaAlong * target / 36.0,
                          incisor ? EdgeSigmaAcross : ArchSigmaAcross,
                          "its place along the arch");
  }

  /** The cusp or edge near a place along the arch: of the points that are the highest around themselves the nearest;
   * a buccal cusp is outside the arch's curve, a lingual one inside. */
  std::optional<PlaceType>
  FindPeak(const std::vector<std::size_t> & points,
           const std::vector<double> &      arcs,
           double                           target,
           FeatureEnum                      feature,
           double                           sigmaAlong,
           double                           sigmaAcross,
           const char *                     source) const
  {
    // Half the distance of two cusps.
    constexpr double         neighbourhood = 1.7;
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{ 0 });
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const double first = this->Height(points[a]);
      const double second = this->Height(points[b]);
      return first > second || (first == second && points[a] < points[b]);
    });
    const bool buccal = feature == FeatureEnum::MesiobuccalCusp || feature == FeatureEnum::DistobuccalCusp ||
                        feature == FeatureEnum::Cusp;
    const bool  lingual = feature == FeatureEnum::MesiolingualCusp || feature == FeatureEnum::DistolingualCusp;
    const auto  none = m_Surface->points.size();
    std::size_t best = none;
    double      bestDistance = 0.0;
    for (std::size_t k = 0; k < order.size(); ++k)
    {
      const auto & p = m_Surface->points[points[order[k]]];
      if (this->Height(points[order[k]]) < this->Height(points[order.front()]) - CuspRange)
      {
        break;
      }
      const bool isPeak =
        std::none_of(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(k), [&](std::size_t other) {
          const auto & q = m_Surface->points[points[other]];
          return std::hypot(q[0] - p[0], q[1] - p[1]) < neighbourhood;
        });
      if (!isPeak)
      {
        continue;
      }
      // Of an incisor's edge the highest is meant, whatever its place.
      if (feature == FeatureEnum::Tip)
      {
        best = points[order[k]];
        break;
      }
      const double offset = m_Arch.Offset(p[0], p[1]);
      if ((buccal && offset < 0.0) || (lingual && offset > 0.0))
      {
        continue;
      }
      const double distance = std::abs(arcs[order[k]] - target);
      if (best == none || distance < bestDistance)
      {
        best = points[order[k]];
        bestDistance = distance;
      }
    }
    if (best == none)
    {
      return {};
    }
    return PlaceType{ this->ToMesh(best), sigmaAlong, sigmaAcross, source };
  }

  const LandmarkCounterpartFilter::MeshType *          m_Mesh;
  const VersorRigid3DTransform<double> *               m_Frame;
  const LandmarkCounterpartFilter::LabelsType &        m_Labels;
  const LandmarkCounterpartFilter::ScanLandmarksType * m_Landmarks;
  double                                               m_MillimetresPerUnit;
  JawEnum                                              m_Jaw;
  std::unique_ptr<TriangleSurface>                     m_Surface;
  PoseArch                                             m_Arch;
};
} // namespace

LandmarkCounterpartFilter::LandmarkCounterpartFilter()
{
  this->AddRequiredInputName("CephalometricLandmarks", 0);
  this->AddOptionalInputName("ScanLandmarks", 1);
  this->AddOptionalInputName("UpperMesh", 2);
  this->AddOptionalInputName("LowerMesh", 3);
  this->AddOptionalInputName("UpperFrame", 4);
  this->AddOptionalInputName("LowerFrame", 5);
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
LandmarkCounterpartFilter::GenerateData()
{
  OutputType * output = this->GetOutput();
  output->Initialize();
  m_Unused.clear();
  const auto frameOf = [](const FrameType * frame) { return frame != nullptr ? frame->Get() : nullptr; };
  ScanType   scans[2] = { ScanType(this->GetUpperMesh(),
                                 frameOf(this->GetUpperFrame()),
                                 m_Labels[0],
                                 this->GetScanLandmarks(),
                                 m_MillimetresPerUnit,
                                 JawEnum::Upper),
                          ScanType(this->GetLowerMesh(),
                                 frameOf(this->GetLowerFrame()),
                                 m_Labels[1],
                                 this->GetScanLandmarks(),
                                 m_MillimetresPerUnit,
                                 JawEnum::Lower) };
  for (const auto & landmark : this->GetCephalometricLandmarks()->GetLandmarks())
  {
    const auto & meaning = landmark.meaning;
    if (meaning.feature == FeatureEnum::Apex)
    {
      m_Unused.push_back({ landmark.name, "it is the end of a root, which no scan shows" });
      continue;
    }
    if ((meaning.jaw == JawEnum::Upper ? this->GetUpperMesh() : this->GetLowerMesh()) == nullptr)
    {
      m_Unused.push_back({ landmark.name, "there is no scan of its jaw" });
      continue;
    }
    const unsigned int     right = meaning.jaw == JawEnum::Upper ? 10 : 40;
    const unsigned int     left = meaning.jaw == JawEnum::Upper ? 20 : 30;
    const bool             both = m_IgnoreSides || !meaning.tooth.IsKnown();
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
      m_Unused.push_back({ landmark.name, "its tooth is excluded" });
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
        counterpart.source = place->source;
      }
    }
    if (counterpart.points.empty())
    {
      m_Unused.push_back({ landmark.name, "it was found neither in landmarks_3d nor by labels nor on the arch" });
      continue;
    }
    if (both && counterpart.points.size() == 1 && meaning.position > 1)
    {
      counterpart.sigmaAlong = std::hypot(counterpart.sigmaAlong, OneSideSigmaAlong);
      counterpart.sigmaAcross = std::hypot(counterpart.sigmaAcross, OneSideSigmaAcross);
    }
    output->Add(counterpart);
  }
}

void
LandmarkCounterpartFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MillimetresPerUnit: " << m_MillimetresPerUnit << std::endl;
  os << indent << "IgnoreSides: " << (m_IgnoreSides ? "On" : "Off") << std::endl;
  os << indent << "UpperLabels: " << m_Labels[0].size() << std::endl;
  os << indent << "LowerLabels: " << m_Labels[1].size() << std::endl;
  os << indent << "ExcludedTeeth: " << m_ExcludedTeeth.size() << std::endl;
  os << indent << "Unused: " << m_Unused.size() << std::endl;
}
} // namespace itk

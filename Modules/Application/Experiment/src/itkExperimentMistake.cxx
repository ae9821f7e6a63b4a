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
#include "itkExperimentMistake.h"

#include "itkExperimentMistakeMaker.h"

#include <utility>

namespace itk
{
namespace
{
using MistakeEnum = ExperimentMistakeEnums::Mistake;
using MeshType = DentalCaseData::MeshType;
using JawEnum = ToothCode::JawEnum;

void
ScalePoints(DentalCaseData & data, double factor)
{
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    if (data.GetJaw(jaw).mesh.IsNull())
    {
      continue;
    }
    auto * points = data.GetJaw(jaw).mesh->GetPoints();
    for (auto it = points->Begin(); it != points->End(); ++it)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        it.Value()[d] = static_cast<float>(it.Value()[d] * factor);
      }
    }
    data.GetJaw(jaw).mesh->Modified();
  }
  auto scaled = DentalLandmarkSet<3>::New();
  for (const auto & landmark : data.landmarks3D->GetLandmarks())
  {
    auto point = landmark.point;
    for (unsigned int d = 0; d < 3; ++d)
    {
      point[d] *= factor;
    }
    scaled->AddLandmark(landmark.name, point);
  }
  data.landmarks3D = scaled;
}

/** x to -x, as a viewer with another handedness saves it; landmarks get the names of what they look like. */
void
Mirror(DentalCaseData & data, bool windOutward)
{
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    MeshType * mesh = data.GetJaw(jaw).mesh;
    if (mesh == nullptr)
    {
      continue;
    }
    for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
    {
      it.Value()[0] = -it.Value()[0];
    }
    for (auto it = mesh->GetCells()->Begin(); windOutward && it != mesh->GetCells()->End(); ++it)
    {
      const auto * ids = it.Value()->GetPointIds();
      const auto   second = ids[1];
      const auto   third = ids[2];
      it.Value()->SetPointId(1, third);
      it.Value()->SetPointId(2, second);
    }
    mesh->Modified();
  }
  auto mirrored = DentalLandmarkSet<3>::New();
  for (const auto & landmark : data.landmarks3D->GetLandmarks())
  {
    auto point = landmark.point;
    point[0] = -point[0];
    mirrored->AddLandmark(landmark.tooth.GetContralateral().GetName() + landmark.name.substr(landmark.name.find('_')),
                          point);
  }
  data.landmarks3D = mirrored;
}

/** The polylines under other codes; those for which it gives the unknown tooth are left out. */
template <typename TFunction>
DentalContour::Pointer
Recode(const DentalContour * contour, TFunction && codeOf)
{
  if (contour == nullptr)
  {
    return nullptr;
  }
  auto recoded = DentalContour::New();
  for (auto polyline : contour->GetPolylines())
  {
    polyline.code = codeOf(polyline.code);
    if (polyline.code.IsKnown())
    {
      recoded->AddPolyline(polyline);
    }
  }
  return recoded;
}

template <typename TFunction>
void
RecodeBoth(DentalCaseData & data, TFunction && codeOf)
{
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    data.GetJaw(jaw).contour = Recode(data.GetJaw(jaw).contour, codeOf);
  }
}
} // namespace

const std::vector<MistakeEnum> &
GetExperimentMistakes()
{
  static const std::vector<MistakeEnum> mistakes = { MistakeEnum::ScansExchanged,  MistakeEnum::TracingsExchanged,
                                                     MistakeEnum::WrongUnit,       MistakeEnum::WrongFacing,
                                                     MistakeEnum::OtherSideTraced, MistakeEnum::OtherSideTracedAndCoded,
                                                     MistakeEnum::MirroredScans,   MistakeEnum::MirroredScansInward,
                                                     MistakeEnum::WrongSpacing,    MistakeEnum::FrontTeethOnly,
                                                     MistakeEnum::OtherPatient };
  return mistakes;
}

const char *
Describe(MistakeEnum mistake)
{
  switch (mistake)
  {
    case MistakeEnum::None:
      return "nothing";
    case MistakeEnum::ScansExchanged:
      return "scans exchanged";
    case MistakeEnum::TracingsExchanged:
      return "tracings exchanged, codes too";
    case MistakeEnum::WrongUnit:
      return "scans in cm, said to be in mm";
    case MistakeEnum::WrongFacing:
      return "wrong facing";
    case MistakeEnum::OtherSideTraced:
      return "other side traced, codes wrong too";
    case MistakeEnum::OtherSideTracedAndCoded:
      return "other side traced, codes right";
    case MistakeEnum::MirroredScans:
      return "mirrored scans, wound outward";
    case MistakeEnum::MirroredScansInward:
      return "mirrored scans, wound inward";
    case MistakeEnum::WrongSpacing:
      return "pixel spacing x 1.3";
    case MistakeEnum::FrontTeethOnly:
      return "incisors and canines only";
    default:
      return "radiograph of another patient";
  }
}

void
MakeExperimentMistake(MistakeEnum mistake, DentalCaseData & data)
{
  switch (mistake)
  {
    case MistakeEnum::ScansExchanged:
      std::swap(data.upper.mesh, data.lower.mesh);
      break;
    case MistakeEnum::TracingsExchanged:
      std::swap(data.upper.contour, data.lower.contour);
      RecodeBoth(data, [](ToothCode code) { return ToothCode(10 * (5 - code.GetQuadrant()) + code.GetPosition()); });
      break;
    case MistakeEnum::WrongUnit:
      ScalePoints(data, 0.1);
      break;
    case MistakeEnum::WrongFacing:
      data.geometry->SetFacing(data.geometry->GetFacing() == CephalometricGeometry::FacingEnum::Right
                                 ? CephalometricGeometry::FacingEnum::Left
                                 : CephalometricGeometry::FacingEnum::Right);
      break;
    case MistakeEnum::OtherSideTraced:
      RecodeBoth(data, [](ToothCode code) { return code.GetContralateral(); });
      break;
    case MistakeEnum::MirroredScans:
    case MistakeEnum::MirroredScansInward:
      Mirror(data, mistake == MistakeEnum::MirroredScans);
      break;
    case MistakeEnum::WrongSpacing:
      data.geometry->SetPixelSpacing(data.geometry->GetPixelSpacing() * 1.3);
      break;
    case MistakeEnum::FrontTeethOnly:
      RecodeBoth(data, [](ToothCode code) { return code.GetPosition() <= 3 ? code : ToothCode(); });
      break;
    default:
      // Nothing, or made with the case.
      break;
  }
}
} // namespace itk

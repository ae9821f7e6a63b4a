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
#include "itkCaseCrowns.h"

#include "itkCrownRegionMeshFilter.h"
#include "itkDentalInputError.h"
#include "itkToothCrownFilter.h"

#include <algorithm>

namespace itk
{
DentalCaseData::MeshType::Pointer
SelectCaseCrowns(const DentalCaseData & data, ToothCode::JawEnum jaw, const VersorRigid3DTransform<double> * frame)
{
  using MeshType = DentalCaseData::MeshType;
  const bool                        upper = jaw == ToothCode::JawEnum::Upper;
  const bool                        byLabels = data.description.crowns == CrownsEnum::Labels;
  const std::vector<std::uint8_t> & labels = data.GetJaw(jaw).labels;
  const std::string &               file = upper ? data.description.upperFile : data.description.lowerFile;
  auto                              filter = CrownRegionMeshFilter<MeshType>::New();
  const auto                        fail = [&]() {
    itkDentalInputErrorMacro(file,
                             "",
                             byLabels ? "its labels name no tooth" : "no crowns were found in it by shape",
                             "leave \"crowns\" out of the case file");
  };
  filter->SetJaw(jaw);
  filter->SetUseLabels(byLabels);
  filter->SetFrameTransform(frame);
  if (byLabels)
  {
    if (std::all_of(labels.begin(), labels.end(), [](std::uint8_t label) { return label == 0; }))
    {
      fail();
    }
    // The labels were read beside the scan: a mesh that shares its points and cells carries them.
    auto pointData = MeshType::PointDataContainer::New();
    for (std::size_t i = 0; i < labels.size(); ++i)
    {
      pointData->InsertElement(i, static_cast<MeshType::PixelType>(labels[i]));
    }
    auto labelled = MeshType::New();
    labelled->Graft(data.GetJaw(jaw).mesh);
    labelled->SetPointData(pointData);
    filter->SetInput(labelled);
  }
  else
  {
    filter->SetInput(data.GetJaw(jaw).mesh);
  }
  try
  {
    filter->Update();
  }
  catch (const ProcessAborted &)
  {
    throw;
  }
  catch (const ExceptionObject &)
  {
    fail();
  }
  MeshType::Pointer crowns = filter->GetOutput();
  crowns->DisconnectPipeline();
  return crowns;
}

ToothCrownSet::Pointer
FindCaseToothCrowns(const DentalCaseData &           data,
                    CaseAxisType *                   axis,
                    const std::vector<std::string> & unusableLandmarks)
{
  using JawEnum = ToothCode::JawEnum;
  auto filter = ToothCrownFilter::New();
  bool isAnyDrawn = false;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const auto & input = data.GetJaw(jaw);
    // Of all radiographs, since of a drawing the codes alone are read.
    const auto drawn = DentalContour::New();
    const auto add = [&drawn](const DentalContour * contour) {
      if (contour != nullptr)
      {
        for (const auto & polyline : contour->GetPolylines())
        {
          drawn->AddPolyline(polyline.points, polyline.code);
        }
      }
    };
    if (data.description.tracedSide == TracedSideEnum::Standard)
    {
      add(input.contour);
    }
    for (const DentalViewData & view : data.views)
    {
      if (view.description.direction == CephalometricGeometry::DirectionEnum::Frontal)
      {
        add(view.GetContour(jaw));
      }
    }
    if (input.mesh.IsNull() || drawn->GetNumberOfPoints() == 0)
    {
      continue;
    }
    isAnyDrawn = true;
    filter->SetLabels(jaw, input.labels);
    if (jaw == JawEnum::Upper)
    {
      filter->SetUpperContour(drawn);
      filter->SetUpperMesh(input.mesh);
      filter->SetUpperFrame(FrameOf(axis, jaw));
    }
    else
    {
      filter->SetLowerContour(drawn);
      filter->SetLowerMesh(input.mesh);
      filter->SetLowerFrame(FrameOf(axis, jaw));
    }
  }
  if (!isAnyDrawn)
  {
    return nullptr;
  }
  if (data.landmarks3D.IsNotNull())
  {
    filter->SetScanLandmarks(data.landmarks3D);
    filter->SetUnusableLandmarks(unusableLandmarks);
    filter->SetMillimetresPerUnit(data.description.millimetresPerUnit);
  }
  filter->SetExcludedTeeth(data.description.excludedTeeth);
  filter->Update();
  ToothCrownSet::Pointer crowns = filter->GetOutput();
  crowns->DisconnectPipeline();
  return crowns;
}
} // namespace itk

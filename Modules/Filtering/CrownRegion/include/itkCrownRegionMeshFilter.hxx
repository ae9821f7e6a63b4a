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
#ifndef itkCrownRegionMeshFilter_hxx
#define itkCrownRegionMeshFilter_hxx

#include "itkCrownRegionMeshFilter.h"

#include "itkMakeTriangleSurface.h"
#include "itkSelectMeshTriangles.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace itk
{
template <typename TMesh>
CrownRegionMeshFilter<TMesh>::CrownRegionMeshFilter()
{
  this->AddOptionalInputName("FrameTransform");
}

template <typename TMesh>
void
CrownRegionMeshFilter<TMesh>::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetInput() == nullptr)
  {
    itkExceptionMacro("There is no mesh. Call SetInput().");
  }
  Superclass::VerifyPreconditions();
  if (m_Jaw == JawEnum::Unknown)
  {
    itkExceptionMacro("The jaw of the mesh is unknown. Call SetJaw() with Upper or Lower.");
  }
  if (!(m_MinimumCrownHeight >= 0.5 && m_MinimumCrownHeight < m_MaximumCrownHeight && m_MaximumCrownHeight <= 25.0))
  {
    itkExceptionMacro("MinimumCrownHeight is " << m_MinimumCrownHeight << " and MaximumCrownHeight "
                                               << m_MaximumCrownHeight
                                               << " mm; they must rise and lie in [0.5, 25]. Call "
                                                  "SetMinimumCrownHeight() and SetMaximumCrownHeight().");
  }
  if (m_LabelNumbering == NumberingEnum::Quadrant)
  {
    itkExceptionMacro("LabelNumbering is Quadrant, but point data are numbers. Call SetLabelNumbering() with FDI or "
                      "Universal.");
  }
}

template <typename TMesh>
auto
CrownRegionMeshFilter<TMesh>::CollectLabels() const -> MaskType
{
  const MeshType * input = this->GetInput();
  const auto *     data = input->GetPointData();
  MaskType         labels;
  if (data == nullptr || data->Size() == 0)
  {
    return labels;
  }
  const bool  universal = m_LabelNumbering == NumberingEnum::Universal;
  bool        any = false;
  std::size_t ofOtherJaw = 0;
  std::size_t ofThisJaw = 0;
  // A scan has few labels and many points: each number is looked up once.
  std::vector<int> known(256, -1);
  labels.reserve(input->GetNumberOfPoints());
  for (auto it = input->GetPoints()->Begin(); it != input->GetPoints()->End(); ++it)
  {
    typename MeshType::PixelType pixel{};
    data->GetElementIfIndexExists(it.Index(), &pixel);
    const double value = static_cast<double>(pixel);
    if (value == 0.0)
    {
      labels.push_back(0);
      continue;
    }
    any = true;
    const bool whole = value > 0.0 && value < 256.0 && value == std::floor(value);
    // 33 is the gingiva of the array Universal_ID.
    if (universal && value == 33.0)
    {
      labels.push_back(0);
      continue;
    }
    int fdi = whole ? known[static_cast<std::size_t>(value)] : 0;
    if (whole && fdi < 0)
    {
      try
      {
        fdi = ToothCode::FromString(std::to_string(static_cast<unsigned int>(value)), m_LabelNumbering).GetFDI();
      }
      catch (const std::invalid_argument &)
      {
        fdi = 0;
      }
      known[static_cast<std::size_t>(value)] = fdi;
    }
    if (fdi == 0)
    {
      itkExceptionMacro("Point " << it.Index() << " has the data " << value << ", which is no tooth's "
                                 << (universal ? "universal" : "FDI")
                                 << " number. Call SetLabelNumbering(), or UseLabelsOff() where the point data are no "
                                    "tooth labels.");
    }
    ++(ToothCode(static_cast<unsigned int>(fdi)).GetJaw() == m_Jaw ? ofThisJaw : ofOtherJaw);
    labels.push_back(static_cast<std::uint8_t>(fdi));
  }
  if (!any)
  {
    labels.clear();
  }
  else if (ofOtherJaw > ofThisJaw)
  {
    itkExceptionMacro("The tooth labels are those of the other jaw at "
                      << ofOtherJaw << " of " << ofOtherJaw + ofThisJaw << " labelled points, but Jaw is " << m_Jaw
                      << ". Call SetJaw(), or SetLabelNumbering().");
  }
  return labels;
}

template <typename TMesh>
void
CrownRegionMeshFilter<TMesh>::GenerateData()
{
  const MeshType *      input = this->GetInput();
  const TriangleSurface surface = MakeTriangleSurface(input);
  if (surface.triangles.empty())
  {
    itkExceptionMacro("The mesh has " << surface.points.size()
                                      << " points and no triangles. Set a triangle mesh of the jaw.");
  }
  const auto stopIfAborted = [this]() {
    if (this->GetAbortGenerateData())
    {
      this->ResetPipeline();
      throw ProcessAborted(__FILE__, __LINE__);
    }
  };
  this->UpdateProgress(0.1f);
  stopIfAborted();
  const MaskType labels = m_UseLabels ? this->CollectLabels() : MaskType();
  m_LabelsWereUsed = !labels.empty();
  if (m_LabelsWereUsed)
  {
    m_Region = CrownRegionFromLabels(surface, labels);
  }
  else
  {
    const bool     isUpper = m_Jaw == JawEnum::Upper;
    DentalJawFrame frame;
    if (const TransformType * transform = this->GetFrameTransform())
    {
      frame = JawFrameFromTransform(*transform);
    }
    else
    {
      DentalFrameOptions options;
      options.threads = this->GetNumberOfWorkUnits();
      options.abort = [this]() { return this->GetAbortGenerateData(); };
      const DentalFrameResult found =
        EstimateDentalFrame(isUpper ? &surface : nullptr, isUpper ? nullptr : &surface, options);
      frame = found.GetJaw(m_Jaw);
    }
    stopIfAborted();
    this->UpdateProgress(0.5f);
    if (frame.valid)
    {
      CrownRegionOptions options;
      options.minimumCrownHeight = m_MinimumCrownHeight;
      options.maximumCrownHeight = m_MaximumCrownHeight;
      options.abort = [this]() {
        // Whoever can end this, Ctrl-C say, is asked in the midst of it: it takes half a second for 400,000 triangles.
        this->InvokeEvent(ProgressEvent());
        return this->GetAbortGenerateData();
      };
      m_Region = ComputeCrownRegion(surface, m_Jaw, frame.axes, frame.origin, options);
    }
    stopIfAborted();
    if (!frame.valid || !m_Region.valid)
    {
      itkExceptionMacro("No crowns were found in the mesh (" << surface.triangles.size() << " triangles, "
                                                             << surface.Area()
                                                             << " mm^2). Check its unit (mm), SetJaw(), and that "
                                                                "SetFrameTransform() maps the mesh to UMDA.");
    }
  }
  this->UpdateProgress(0.8f);

  MeshType * output = this->GetOutput();
  output->Initialize();
  // All there is: without it every Update() would execute again.
  output->SetBufferedRegion(0);
  SelectMeshTriangles(input, m_KeepWholeMesh ? MaskType(surface.triangles.size(), 1) : m_Region.triangles, output);
  if (m_KeepWholeMesh)
  {
    // All points, also those of no triangle, under their own numbers.
    auto        points = MeshType::PointsContainer::New();
    auto        data = MeshType::PointDataContainer::New();
    std::size_t rank = 0;
    for (auto it = input->GetPoints()->Begin(); it != input->GetPoints()->End(); ++it, ++rank)
    {
      points->InsertElement(it.Index(), it.Value());
      data->InsertElement(it.Index(), static_cast<typename MeshType::PixelType>(m_Region.points[rank]));
    }
    auto target = output->GetCells()->Begin();
    for (auto it = input->GetCells()->Begin(); it != input->GetCells()->End(); ++it, ++target)
    {
      std::copy(it.Value()->PointIdsBegin(), it.Value()->PointIdsEnd(), target.Value()->PointIdsBegin());
    }
    output->SetPoints(points);
    output->SetPointData(data);
  }
  this->UpdateProgress(1.0f);
}

template <typename TMesh>
void
CrownRegionMeshFilter<TMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Jaw: " << m_Jaw << std::endl;
  os << indent << "UseLabels: " << m_UseLabels << std::endl;
  os << indent << "LabelNumbering: " << m_LabelNumbering << std::endl;
  os << indent << "KeepWholeMesh: " << m_KeepWholeMesh << std::endl;
  os << indent << "MinimumCrownHeight: " << m_MinimumCrownHeight << std::endl;
  os << indent << "MaximumCrownHeight: " << m_MaximumCrownHeight << std::endl;
  os << indent << "LabelsWereUsed: " << m_LabelsWereUsed << std::endl;
  os << indent << "CrownArea: " << m_Region.area << std::endl;
  os << indent << "MeanCrownHeight: " << m_Region.meanCrownHeight << std::endl;
  os << indent << "MarginAngle: " << m_Region.marginAngle << std::endl;
}
} // namespace itk

#endif

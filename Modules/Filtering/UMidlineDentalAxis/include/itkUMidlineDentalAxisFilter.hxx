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
#ifndef itkUMidlineDentalAxisFilter_hxx
#define itkUMidlineDentalAxisFilter_hxx

#include "itkUMidlineDentalAxisFilter.h"

#include "itkMakeDentalFrameTransform.h"
#include "itkMakeTriangleSurface.h"
#include "itkTriangleCell.h"

#include <cmath>

namespace itk
{
template <typename TMesh>
UMidlineDentalAxisFilter<TMesh>::UMidlineDentalAxisFilter()
{
  this->SetPrimaryInputName("UpperMesh");
  this->AddOptionalInputName("LowerMesh", 1);
  this->SetNumberOfRequiredInputs(0);
  this->SetNumberOfRequiredOutputs(6);
  for (DataObjectPointerArraySizeType index = 0; index < 6; ++index)
  {
    this->SetNthOutput(index, this->MakeOutput(index));
  }
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::MakeOutput(DataObjectPointerArraySizeType index) -> DataObjectPointer
{
  if (index < 2)
  {
    return MeshType::New().GetPointer();
  }
  if (index == 5)
  {
    return FrameObjectType::New().GetPointer();
  }
  return DecoratedTransformType::New().GetPointer();
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetUpperOutput() -> MeshType *
{
  return static_cast<MeshType *>(this->ProcessObject::GetOutput(0));
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetLowerOutput() -> MeshType *
{
  return static_cast<MeshType *>(this->ProcessObject::GetOutput(1));
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetUpperTransformOutput() -> DecoratedTransformType *
{
  return static_cast<DecoratedTransformType *>(this->ProcessObject::GetOutput(2));
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetLowerTransformOutput() -> DecoratedTransformType *
{
  return static_cast<DecoratedTransformType *>(this->ProcessObject::GetOutput(3));
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetJointTransformOutput() -> DecoratedTransformType *
{
  return static_cast<DecoratedTransformType *>(this->ProcessObject::GetOutput(4));
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetFrameOutput() -> FrameObjectType *
{
  return static_cast<FrameObjectType *>(this->ProcessObject::GetOutput(5));
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetFrameOutput() const -> const FrameObjectType *
{
  return static_cast<const FrameObjectType *>(this->ProcessObject::GetOutput(5));
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::MakeTransform(const DentalJawFrame & frame) const -> typename TransformType::Pointer
{
  // As a rotation matrix it is orthogonal to rounding, which the tolerance of 1e-10 allows.
  return MakeDentalFrameTransform(frame.axes, frame.origin);
}

template <typename TMesh>
void
UMidlineDentalAxisFilter<TMesh>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (this->GetUpperMesh() == nullptr && this->GetLowerMesh() == nullptr)
  {
    itkExceptionMacro("There is no mesh. Call SetUpperMesh() or SetLowerMesh().");
  }
  if (!(m_CrownFraction > 0.0 && m_CrownFraction <= 1.0))
  {
    itkExceptionMacro("CrownFraction is " << m_CrownFraction << "; it is a share in (0, 1]. Call SetCrownFraction().");
  }
  if (!(m_AxesLength > 0.0))
  {
    itkExceptionMacro("AxesLength is " << m_AxesLength << " mm; it must be positive. Call SetAxesLength().");
  }
}

template <typename TMesh>
void
UMidlineDentalAxisFilter<TMesh>::GenerateData()
{
  const MeshType *              meshes[2] = { this->GetUpperMesh(), this->GetLowerMesh() };
  static constexpr const char * names[2] = { "upper", "lower" };
  TriangleSurface               surfaces[2];
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    if (meshes[jaw] != nullptr)
    {
      surfaces[jaw] = MakeTriangleSurface(meshes[jaw]);
      if (surfaces[jaw].triangles.empty())
      {
        itkExceptionMacro("The " << names[jaw] << " mesh has " << surfaces[jaw].points.size()
                                 << " points and no triangles. Set a triangle mesh of the jaw.");
      }
    }
  }
  this->UpdateProgress(0.1f);

  DentalFrameOptions options;
  options.jawsShareFrame = m_JawsShareFrame;
  options.crownFraction = m_CrownFraction;
  options.maximumIterations = m_MaximumIterations;
  options.refineMidline = m_RefineMidline;
  options.threads = this->GetNumberOfWorkUnits();
  options.abort = [this]() { return this->GetAbortGenerateData(); };
  const DentalFrameResult found = EstimateDentalFrame(
    meshes[0] != nullptr ? &surfaces[0] : nullptr, meshes[1] != nullptr ? &surfaces[1] : nullptr, options);
  if (this->GetAbortGenerateData())
  {
    this->ResetPipeline();
    throw ProcessAborted(__FILE__, __LINE__);
  }
  this->GetFrameOutput()->Set(found);
  this->UpdateProgress(0.8f);

  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    auto * output = static_cast<MeshType *>(this->ProcessObject::GetOutput(jaw));
    auto * decorator = static_cast<DecoratedTransformType *>(this->ProcessObject::GetOutput(2 + jaw));
    output->Initialize();
    decorator->Initialize();
    // All there is, also where a transform was asked for: without it every Update() of what takes the mesh, and every
    // strip of it, would execute again.
    output->SetBufferedRegion(0);
    if (meshes[jaw] == nullptr)
    {
      decorator->Set(nullptr);
      continue;
    }
    const DentalJawFrame & jawFrame = jaw == 0 ? found.upper : found.lower;
    if (!jawFrame.valid && !m_RequireArches)
    {
      decorator->Set(nullptr);
      continue;
    }
    if (!jawFrame.valid)
    {
      itkExceptionMacro("No dental arch was found in the " << names[jaw] << " mesh (" << surfaces[jaw].triangles.size()
                                                           << " triangles, " << surfaces[jaw].Area()
                                                           << " mm^2). Check its unit (mm) and that it shows the teeth "
                                                              "of a whole jaw.");
    }
    const auto transform = this->MakeTransform(jawFrame);
    decorator->Set(transform);
    if (!m_TransformMeshes)
    {
      continue;
    }
    this->TransformJaw(meshes[jaw], transform, output);
    if (m_EmbedAxes)
    {
      this->AddAxes(output);
    }
  }
  const bool joint = found.jawsShareFrame && found.joint.valid;
  this->GetJointTransformOutput()->Set(joint ? this->MakeTransform(found.joint).GetPointer() : nullptr);
  this->UpdateProgress(1.0f);
}

template <typename TMesh>
void
UMidlineDentalAxisFilter<TMesh>::TransformJaw(const MeshType *      input,
                                              const TransformType * transform,
                                              MeshType *            output) const
{
  using CoordinateType = typename MeshType::PointType::ValueType;
  const auto * inputPoints = input->GetPoints();
  auto         points = MeshType::PointsContainer::New();
  points->Reserve(inputPoints->Size());
  auto target = points->Begin();
  for (auto it = inputPoints->Begin(); it != inputPoints->End(); ++it, ++target)
  {
    const auto & p = it.Value();
    const auto   q = transform->TransformPoint(PointType(std::array<double, 3>{ { p[0], p[1], p[2] } }.data()));
    for (unsigned int d = 0; d < 3; ++d)
    {
      target.Value()[d] = static_cast<CoordinateType>(q[d]);
    }
  }
  output->SetPoints(points);
  if (input->GetPointData() != nullptr)
  {
    auto data = MeshType::PointDataContainer::New();
    for (auto it = input->GetPointData()->Begin(); it != input->GetPointData()->End(); ++it)
    {
      data->InsertElement(it.Index(), it.Value());
    }
    output->SetPointData(data);
  }
  // Copies: cells that two meshes share are freed by whoever goes last, by the rule of the one that allocated them.
  auto cells = MeshType::CellsContainer::New();
  cells->Reserve(input->GetNumberOfCells());
  typename MeshType::CellIdentifier id = 0;
  for (auto it = input->GetCells()->Begin(); it != input->GetCells()->End(); ++it)
  {
    typename MeshType::CellAutoPointer copy;
    it.Value()->MakeCopy(copy);
    cells->SetElement(id++, copy.ReleaseOwnership());
  }
  output->SetCellsAllocationMethod(MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  output->SetCells(cells);
  if (input->GetCellData() != nullptr)
  {
    auto data = MeshType::CellDataContainer::New();
    for (auto it = input->GetCellData()->Begin(); it != input->GetCellData()->End(); ++it)
    {
      data->InsertElement(it.Index(), it.Value());
    }
    output->SetCellData(data);
  }
}

template <typename TMesh>
void
UMidlineDentalAxisFilter<TMesh>::AddAxes(MeshType * output) const
{
  using CoordinateType = typename MeshType::PointType::ValueType;
  using CellType = typename MeshType::CellType;
  constexpr unsigned int sides = 12;
  constexpr double       pi = 3.14159265358979323846;
  const double           lengths[3] = { m_AxesLength, 0.8 * m_AxesLength, 0.6 * m_AxesLength };
  auto                   pointId = static_cast<typename MeshType::PointIdentifier>(output->GetNumberOfPoints());
  auto                   cellId = static_cast<typename MeshType::CellIdentifier>(output->GetNumberOfCells());
  const auto             addTriangle = [&](IdentifierType a, IdentifierType b, IdentifierType c) {
    typename MeshType::CellAutoPointer cell;
    cell.TakeOwnership(new TriangleCell<CellType>);
    cell->SetPointId(0, a);
    cell->SetPointId(1, b);
    cell->SetPointId(2, c);
    output->SetCell(cellId++, cell);
  };
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    // Rings of a shaft and a head, from the origin to the tip: distance along the axis and radius.
    const double rings[5][2] = { { 0.0, 0.0 },
                                 { 0.0, 0.012 * m_AxesLength },
                                 { lengths[axis] - 0.1 * m_AxesLength, 0.012 * m_AxesLength },
                                 { lengths[axis] - 0.1 * m_AxesLength, 0.03 * m_AxesLength },
                                 { lengths[axis], 0.0 } };
    const auto   first = pointId;
    for (const auto & ring : rings)
    {
      for (unsigned int side = 0; side < sides; ++side)
      {
        const double                 angle = 2.0 * pi * side / sides;
        typename MeshType::PointType point;
        point[axis] = static_cast<CoordinateType>(ring[0]);
        point[(axis + 1) % 3] = static_cast<CoordinateType>(ring[1] * std::cos(angle));
        point[(axis + 2) % 3] = static_cast<CoordinateType>(ring[1] * std::sin(angle));
        output->SetPoint(pointId, point);
        if (output->GetPointData() != nullptr)
        {
          output->SetPointData(pointId, NumericTraits<typename MeshType::PixelType>::ZeroValue());
        }
        ++pointId;
      }
    }
    for (unsigned int ring = 0; ring + 1 < 5; ++ring)
    {
      for (unsigned int side = 0; side < sides; ++side)
      {
        const auto a = first + ring * sides + side;
        const auto b = first + ring * sides + (side + 1) % sides;
        if (ring != 0)
        {
          addTriangle(a, b, b + sides);
        }
        if (ring != 3)
        {
          addTriangle(a, b + sides, a + sides);
        }
        else
        {
          continue;
        }
      }
    }
  }
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetBaselineRight(JawEnum jaw) const -> PointType
{
  return PointType(this->GetJawFrame(jaw).baselineRight.data());
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetBaselineLeft(JawEnum jaw) const -> PointType
{
  return PointType(this->GetJawFrame(jaw).baselineLeft.data());
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetBaselineMidpoint(JawEnum jaw) const -> PointType
{
  return PointType(this->GetJawFrame(jaw).midpoint.data());
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetIncisalEdge(JawEnum jaw) const -> PointType
{
  return PointType(this->GetJawFrame(jaw).incisalEdge.data());
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::MakePlane(JawEnum jaw, unsigned int axis) const -> PlaneType
{
  const DentalJawFrame & frame = this->GetJawFrame(jaw);
  return { PointType(frame.origin.data()), VectorType(frame.axes[axis].data()) };
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetOcclusalPlane(JawEnum jaw) const -> PlaneType
{
  return this->MakePlane(jaw, 2);
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetMidlinePlane(JawEnum jaw) const -> PlaneType
{
  return this->MakePlane(jaw, 1);
}

template <typename TMesh>
auto
UMidlineDentalAxisFilter<TMesh>::GetCoronalPlane(JawEnum jaw) const -> PlaneType
{
  return this->MakePlane(jaw, 0);
}

template <typename TMesh>
void
UMidlineDentalAxisFilter<TMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "JawsShareFrame: " << m_JawsShareFrame << std::endl;
  os << indent << "CrownFraction: " << m_CrownFraction << std::endl;
  os << indent << "MaximumIterations: " << m_MaximumIterations << std::endl;
  os << indent << "RefineMidline: " << (m_RefineMidline ? "On" : "Off") << std::endl;
  os << indent << "EmbedAxes: " << (m_EmbedAxes ? "On" : "Off") << std::endl;
  os << indent << "AxesLength: " << m_AxesLength << std::endl;
  os << indent << "TransformMeshes: " << m_TransformMeshes << std::endl;
  os << indent << "RequireArches: " << m_RequireArches << std::endl;
  os << indent << "JawsAreInOneFrame: " << (this->GetFrame().jawsShareFrame ? "Yes" : "No") << std::endl;
  os << indent << "Overjet: " << this->GetFrame().overjet << std::endl;
  os << indent << "Overbite: " << this->GetFrame().overbite << std::endl;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const DentalJawFrame & frame = this->GetJawFrame(jaw);
    os << indent << jaw << ": " << (frame.valid ? "" : "(none)") << std::endl;
    const Indent next = indent.GetNextIndent();
    os << next << "Origin: " << PointType(frame.origin.data()) << std::endl;
    for (const auto & axis : frame.axes)
    {
      os << next << "Axis: " << VectorType(axis.data()) << std::endl;
    }
    os << next << "ArchWidth: " << frame.archWidth << std::endl;
    os << next << "ArchDepth: " << frame.archDepth << std::endl;
    os << next << "Confidence: " << frame.confidence << std::endl;
  }
}
} // namespace itk

#endif

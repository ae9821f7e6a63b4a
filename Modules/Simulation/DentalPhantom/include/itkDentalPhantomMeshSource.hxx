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
#ifndef itkDentalPhantomMeshSource_hxx
#define itkDentalPhantomMeshSource_hxx

#include "itkDentalPhantomMeshSource.h"
#include "itkDentalPhantomModel.h"

#include "itkTriangleCell.h"

#include <cmath>

namespace itk
{
template <typename TOutputMesh>
DentalPhantomMeshSource<TOutputMesh>::DentalPhantomMeshSource()
{
  this->SetNumberOfRequiredOutputs(4);
  for (DataObjectPointerArraySizeType index = 0; index < 4; ++index)
  {
    this->SetNthOutput(index, this->MakeOutput(index));
  }
}

template <typename TOutputMesh>
auto
DentalPhantomMeshSource<TOutputMesh>::MakeOutput(DataObjectPointerArraySizeType index) -> DataObjectPointer
{
  if (index < 2)
  {
    return TOutputMesh::New().GetPointer();
  }
  return LandmarkSetType::New().GetPointer();
}

template <typename TOutputMesh>
void
DentalPhantomMeshSource<TOutputMesh>::SetParameters(const ParametersType & parameters)
{
  m_Parameters = parameters;
  m_Model = nullptr;
  this->Modified();
}

template <typename TOutputMesh>
void
DentalPhantomMeshSource<TOutputMesh>::DrawParameters(std::uint64_t seed)
{
  this->SetParameters(ParametersType::Draw(seed));
}

template <typename TOutputMesh>
TOutputMesh *
DentalPhantomMeshSource<TOutputMesh>::GetUpperOutput()
{
  return static_cast<TOutputMesh *>(this->ProcessObject::GetOutput(0));
}

template <typename TOutputMesh>
TOutputMesh *
DentalPhantomMeshSource<TOutputMesh>::GetLowerOutput()
{
  return static_cast<TOutputMesh *>(this->ProcessObject::GetOutput(1));
}

template <typename TOutputMesh>
auto
DentalPhantomMeshSource<TOutputMesh>::GetUpperLandmarks() -> LandmarkSetType *
{
  return static_cast<LandmarkSetType *>(this->ProcessObject::GetOutput(2));
}

template <typename TOutputMesh>
auto
DentalPhantomMeshSource<TOutputMesh>::GetLowerLandmarks() -> LandmarkSetType *
{
  return static_cast<LandmarkSetType *>(this->ProcessObject::GetOutput(3));
}

template <typename TOutputMesh>
auto
DentalPhantomMeshSource<TOutputMesh>::GetFrameRotation(unsigned int jaw) const -> RotationType
{
  const auto   motion = m_Parameters.ComputeFrame(jaw);
  RotationType rotation;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      rotation(row, column) = motion.rotation[3 * row + column];
    }
  }
  return rotation;
}

template <typename TOutputMesh>
auto
DentalPhantomMeshSource<TOutputMesh>::GetFrameTranslation(unsigned int jaw) const -> VectorType
{
  return VectorType(m_Parameters.ComputeFrame(jaw).translation.data());
}

template <typename TOutputMesh>
void
DentalPhantomMeshSource<TOutputMesh>::GenerateData()
{
  try
  {
    m_Parameters.Validate();
  }
  catch (const std::invalid_argument & error)
  {
    itkExceptionMacro(<< error.what() << " Correct it before SetParameters().");
  }
  const unsigned int threads = this->GetNumberOfWorkUnits();
  m_Model = std::make_shared<const DentalPhantomModel>(m_Parameters, threads);
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    const auto            made = m_Model->MakeScan(jaw, threads, [this, jaw](double done) {
      this->UpdateProgress(static_cast<float>(0.3 + 0.35 * (jaw + done)));
      if (this->GetAbortGenerateData())
      {
        throw ProcessAborted(__FILE__, __LINE__);
      }
    });
    std::array<double, 3> centre{};
    for (const auto & p : made.surface.points)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        centre[d] += p[d] / static_cast<double>(made.surface.points.size());
      }
    }
    m_Parameters.frameCentres[jaw] = centre;
    const auto motion = m_Parameters.ComputeFrame(jaw);
    const auto place = [&motion](const std::array<double, 3> & point) {
      auto p = motion.Apply(point);
      for (double & value : p)
      {
        // The raster again: a rotation leaves it.
        value = std::nearbyint(value * 1e4) / 1e4;
      }
      return p;
    };

    TOutputMesh * mesh = jaw == 0 ? this->GetUpperOutput() : this->GetLowerOutput();
    mesh->Initialize();
    mesh->SetCellsAllocationMethod(MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
    auto points = TOutputMesh::PointsContainer::New();
    auto data = TOutputMesh::PointDataContainer::New();
    points->Reserve(made.surface.points.size());
    data->Reserve(made.surface.points.size());
    for (std::size_t i = 0; i < made.surface.points.size(); ++i)
    {
      const auto                      p = place(made.surface.points[i]);
      typename TOutputMesh::PointType point;
      for (unsigned int d = 0; d < 3; ++d)
      {
        point[d] = static_cast<typename TOutputMesh::CoordRepType>(p[d]);
      }
      points->SetElement(i, point);
      data->SetElement(i, static_cast<typename TOutputMesh::PixelType>(made.labels[i]));
    }
    mesh->SetPoints(points);
    mesh->SetPointData(data);
    using TriangleType = TriangleCell<typename TOutputMesh::CellType>;
    mesh->SetCells(TOutputMesh::CellsContainer::New());
    mesh->GetCells()->Reserve(made.surface.triangles.size());
    for (std::size_t i = 0; i < made.surface.triangles.size(); ++i)
    {
      typename TOutputMesh::CellAutoPointer cell;
      cell.TakeOwnership(new TriangleType);
      for (unsigned int corner = 0; corner < 3; ++corner)
      {
        cell->SetPointId(corner, made.surface.triangles[i][corner]);
      }
      mesh->SetCell(i, cell);
    }
    mesh->SetBufferedRegion(0);

    LandmarkSetType * landmarks = jaw == 0 ? this->GetUpperLandmarks() : this->GetLowerLandmarks();
    landmarks->Initialize();
    for (const auto & landmark : made.landmarks)
    {
      landmarks->AddLandmark(landmark.name, LandmarkSetType::PointType(place(landmark.point).data()));
    }
  }
}

template <typename TOutputMesh>
void
DentalPhantomMeshSource<TOutputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Parameters:" << std::endl;
  m_Parameters.Print(os, indent.GetNextIndent());
  os << indent << "Model: " << (m_Model ? "made" : "(null)") << std::endl;
}
} // namespace itk

#endif

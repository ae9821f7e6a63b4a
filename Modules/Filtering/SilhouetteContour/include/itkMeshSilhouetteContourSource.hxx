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
#ifndef itkMeshSilhouetteContourSource_hxx
#define itkMeshSilhouetteContourSource_hxx

#include "itkContourResampling.h"

#include <algorithm>
#include <stdexcept>

namespace itk
{
template <typename TInputMesh>
void
MeshSilhouetteContourSource<TInputMesh>::GenerateData()
{
  DentalContour * const output = this->GetOutput();
  output->Initialize();
  // Without it every Update() would execute again.
  output->SetBufferedRegion(0);
  m_Samples.clear();
  m_Silhouette.loops.clear();
  this->GetGeometry()->VerifyComplete();
  const PerspectiveProjection projection = this->GetGeometry()->GetProjection();
  this->UseSilhouette(
    [&](const MeshSilhouette & silhouette) { m_Silhouette = silhouette.ComputeOuterBoundary(projection); });

  const std::size_t parts =
    m_LargestPartOnly ? std::min<std::size_t>(1, m_Silhouette.loops.size()) : m_Silhouette.loops.size();
  std::vector<std::size_t> counts;
  if (m_NumberOfPoints > 0 && parts > 0)
  {
    std::vector<double> lengths;
    for (std::size_t l = 0; l < parts; ++l)
    {
      lengths.push_back(ComputePolylineLength(m_Silhouette.loops[l].points, true));
    }
    try
    {
      counts = DistributeContourPoints(lengths, std::vector<std::size_t>(parts, 3), m_NumberOfPoints);
    }
    catch (const std::invalid_argument & error)
    {
      itkExceptionMacro(<< error.what() << " Call SetNumberOfPoints() with more, or LargestPartOnlyOn().");
    }
  }
  typename Superclass::ToothLookup teeth;
  if (this->GetUseLabels())
  {
    teeth = this->MakeToothLookup();
  }
  for (std::size_t l = 0; l < parts; ++l)
  {
    const SilhouetteLoop & loop = m_Silhouette.loops[l];
    // A flat part seen edge-on has two corners; a closed polyline needs three points.
    const std::size_t count = !counts.empty() ? counts[l] : (loop.points.size() < 3 ? 4 : 0);
    const SamplesType samples =
      count > 0 ? ResampleSilhouetteLoop(loop, projection, count) : SampleSilhouetteLoopCorners(loop);
    DentalContour::PolylineType polyline;
    polyline.closed = true;
    for (const SilhouetteSample & sample : samples)
    {
      DentalContour::PointType point;
      point[0] = sample.u;
      point[1] = sample.v;
      polyline.points.push_back(point);
      polyline.normals.emplace_back(sample.normal.data());
      polyline.rimPoints.emplace_back(sample.rim.data());
      if (this->GetUseLabels())
      {
        polyline.teeth.push_back(teeth.Find(loop.edges[sample.segment], sample.rim));
      }
    }
    output->AddPolyline(polyline);
    m_Samples.insert(m_Samples.end(), samples.begin(), samples.end());
  }
  this->UpdateProgress(1.0f);
}

template <typename TInputMesh>
void
MeshSilhouetteContourSource<TInputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "LargestPartOnly: " << (m_LargestPartOnly ? "On" : "Off") << std::endl;
  os << indent << "NumberOfPoints: " << m_NumberOfPoints << std::endl;
  os << indent << "Silhouette: " << m_Silhouette.loops.size() << " parts" << std::endl;
  os << indent << "Samples: " << m_Samples.size() << std::endl;
}
} // namespace itk

#endif

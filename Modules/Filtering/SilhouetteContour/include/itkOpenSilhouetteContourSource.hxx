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
#ifndef itkOpenSilhouetteContourSource_hxx
#define itkOpenSilhouetteContourSource_hxx

#include <cmath>

namespace itk
{
template <typename TInputMesh>
OpenSilhouetteContourSource<TInputMesh>::OpenSilhouetteContourSource()
{
  this->AddOptionalInputName("FrameTransform");
}

template <typename TInputMesh>
void
OpenSilhouetteContourSource<TInputMesh>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_Jaw == JawEnum::Unknown)
  {
    itkExceptionMacro("Jaw is unknown: call SetJaw() with Upper or Lower.");
  }
  if (!(m_Spacing >= 0.01 && m_Spacing <= 1.0))
  {
    itkExceptionMacro("Spacing is " << m_Spacing << " mm: call SetSpacing() with 0.01 to 1.");
  }
}

template <typename TInputMesh>
void
OpenSilhouetteContourSource<TInputMesh>::GenerateData()
{
  DentalContour * const output = this->GetOutput();
  output->Initialize();
  // Without it every Update() would execute again.
  output->SetBufferedRegion(0);
  m_RimPoints.clear();
  m_Normals.clear();
  const GeometryType * const geometry = this->GetGeometry();
  geometry->VerifyComplete();

  // The rule works in a picture of 0.25 mm a unit with the patient facing right.
  constexpr double      unit = 0.25;
  const double          scale[2] = { geometry->GetFacingSign() * geometry->GetPixelSpacing()[0] / unit,
                                     geometry->GetPixelSpacing()[1] / unit };
  PerspectiveProjection projection = geometry->GetProjection();
  for (unsigned int row = 0; row < 2; ++row)
  {
    for (unsigned int column = 0; column < 4; ++column)
    {
      double & value = projection.matrix[4 * row + column];
      value = scale[row] * (value - geometry->GetPrincipalPoint()[row] * projection.matrix[8 + column]);
    }
  }

  // Pitch of the dental frame in the cephalostat: where its vertical axis points in the midsagittal plane.
  Vector<double, 3> vertical;
  vertical.Fill(0.0);
  vertical[2] = 1.0;
  if (this->GetFrameTransformInput() != nullptr)
  {
    const TransformType * const frame = this->GetFrameTransform();
    if (frame == nullptr)
    {
      itkExceptionMacro("The frame is empty: UMidlineDentalAxisFilter had no mesh of this jaw. Connect the transform "
                        "of the same jaw with SetFrameTransformInput().");
    }
    for (unsigned int d = 0; d < 3; ++d)
    {
      vertical[d] = frame->GetMatrix()(2, d);
    }
  }
  vertical = geometry->GetPoseRotation() * vertical;

  OpenSilhouetteOptions options;
  options.jaw = m_Jaw;
  options.pitch = std::atan2(vertical[0], vertical[2]);
  options.spacing = m_Spacing / unit;
  options.keepEdges = this->GetUseLabels();
  OpenSilhouette contour;
  this->UseSilhouette(
    [&](const MeshSilhouette & silhouette) { contour = ComputeOpenSilhouette(silhouette, projection, options); });

  typename Superclass::ToothLookup teeth;
  if (this->GetUseLabels())
  {
    teeth = this->MakeToothLookup();
  }
  for (std::size_t r = 0; r < contour.runs.size(); ++r)
  {
    const std::size_t end = r + 1 < contour.runs.size() ? contour.runs[r + 1] : contour.Size();
    // A lone sample is no line.
    if (end < contour.runs[r] + 2)
    {
      continue;
    }
    DentalContour::PolylineType polyline;
    for (std::size_t i = contour.runs[r]; i < end; ++i)
    {
      DentalContour::PointType point;
      point[0] = geometry->GetPrincipalPoint()[0] + contour.u[i] / scale[0];
      point[1] = geometry->GetPrincipalPoint()[1] + contour.v[i] / scale[1];
      polyline.points.push_back(point);
      const double nu = contour.nu[i] * scale[0];
      const double nv = contour.nv[i] * scale[1];
      const double length = std::hypot(nu, nv);
      m_Normals.push_back({ { nu / length, nv / length } });
      m_RimPoints.push_back(contour.rim[i]);
      polyline.normals.emplace_back(m_Normals.back().data());
      polyline.rimPoints.emplace_back(contour.rim[i].data());
      if (this->GetUseLabels())
      {
        polyline.teeth.push_back(teeth.Find(contour.edges[i], contour.rim[i]));
      }
    }
    output->AddPolyline(polyline);
  }
  this->UpdateProgress(1.0f);
}

template <typename TInputMesh>
void
OpenSilhouetteContourSource<TInputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Jaw: " << m_Jaw << std::endl;
  os << indent << "Spacing: " << m_Spacing << std::endl;
  os << indent << "RimPoints: " << m_RimPoints.size() << std::endl;
  os << indent << "Normals: " << m_Normals.size() << std::endl;
}
} // namespace itk

#endif

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
#include "itkPoseSolution.h"

#include "itkPoseGeometryConversion.h"

#include "itkPoseFrameOperations.h"
#include "itkPoseModel.h"
#include "itkRigidTransformRows.h"

#include <cmath>

namespace itk
{
void
PoseSolution::SetResult(const PoseRegistrationResult & result, const PoseRegistrationOptions & options)
{
  // A result made by hand may name what it does not have; all that lies downstream goes by these numbers.
  if (result.groupOfJaw.size() != result.jaws.size())
  {
    itkExceptionMacro("The result has " << result.jaws.size() << " jaws and groups of " << result.groupOfJaw.size()
                                        << "; set groupOfJaw to the group of each jaw.");
  }
  for (std::size_t j = 0; j < result.jaws.size(); ++j)
  {
    if (result.jaws[j].registered && result.groupOfJaw[j] >= result.groups.size())
    {
      itkExceptionMacro("groupOfJaw of jaw " << j << " is " << result.groupOfJaw[j] << ", of " << result.groups.size()
                                             << " groups; count groups from 0.");
    }
  }
  for (std::size_t g = 0; g < result.groups.size(); ++g)
  {
    for (const std::size_t j : result.groups[g].jaws)
    {
      if (j >= result.jaws.size())
      {
        itkExceptionMacro("Group " << g << " has jaw " << j << ", of " << result.jaws.size()
                                   << " jaws; count jaws from 0.");
      }
    }
  }
  m_Result = result;
  m_Options = options;
  this->Modified();
}

void
PoseSolution::Initialize()
{
  Superclass::Initialize();
  m_Result = PoseRegistrationResult();
  m_Options = PoseRegistrationOptions();
}

void
PoseSolution::Graft(const DataObject * data)
{
  const auto * other = dynamic_cast<const Self *>(data);
  if (other == nullptr)
  {
    itkExceptionMacro("Graft() takes a PoseSolution.");
  }
  Superclass::Graft(data);
  this->SetResult(other->m_Result, other->m_Options);
}

int
PoseSolution::GetIndex(JawEnum jaw) const
{
  for (std::size_t j = 0; j < m_Result.jaws.size(); ++j)
  {
    if (m_Result.jaws[j].jaw == jaw)
    {
      return static_cast<int>(j);
    }
  }
  return -1;
}

bool
PoseSolution::IsRegistered(JawEnum jaw) const
{
  const int index = this->GetIndex(jaw);
  return index >= 0 && m_Result.jaws[static_cast<std::size_t>(index)].registered;
}

const PoseJawResult &
PoseSolution::GetJaw(JawEnum jaw) const
{
  const int index = this->GetIndex(jaw);
  if (index < 0)
  {
    itkExceptionMacro("The " << ToString(jaw) << " jaw had no input: give the registration its mesh and its contour.");
  }
  return m_Result.jaws[static_cast<std::size_t>(index)];
}

const PoseGroupResult &
PoseSolution::GetGroup(JawEnum jaw) const
{
  const PoseJawResult & result = this->GetJaw(jaw);
  if (!result.registered)
  {
    itkExceptionMacro("The " << ToString(jaw) << " jaw was not registered: " << result.failure
                             << ". Ask IsRegistered() first.");
  }
  return m_Result.groups[m_Result.groupOfJaw[static_cast<std::size_t>(this->GetIndex(jaw))]];
}

PoseSolution::ProjectionMatrixType
PoseSolution::ToProjectionMatrix(const std::array<double, 12> & rows, double millimetresPerUnit)
{
  ProjectionMatrixType matrix;
  for (unsigned int i = 0; i < 12; ++i)
  {
    matrix(i / 4, i % 4) = rows[i] * (i % 4 < 3 ? millimetresPerUnit : 1.0);
  }
  return matrix;
}

PoseSolution::ProjectionMatrixType
PoseSolution::GetProjectionMatrix(JawEnum jaw, double millimetresPerUnit) const
{
  this->GetGroup(jaw);
  return ToProjectionMatrix(this->GetJaw(jaw).projection, millimetresPerUnit);
}

PoseSolution::ProjectionMatrixType
PoseSolution::GetProjectionMatrix(JawEnum jaw, const PoseParameters & parameters, double millimetresPerUnit) const
{
  this->GetGroup(jaw);
  return ToProjectionMatrix(PoseModel(m_Result.geometry, parameters).GetPixelProjection(this->GetJaw(jaw).frame),
                            millimetresPerUnit);
}

double
PoseSolution::ComputeMotion(std::size_t group, const PoseParameters & from, const PoseParameters & to) const
{
  if (group >= m_Result.groups.size())
  {
    itkExceptionMacro("There are " << m_Result.groups.size() << " groups of jaws with one pose, and no group " << group
                                   << '.');
  }
  const PoseModel models[2] = { PoseModel(m_Result.geometry, from), PoseModel(m_Result.geometry, to) };
  double          sum = 0.0;
  std::size_t     count = 0;
  for (const std::size_t j : m_Result.groups[group].jaws)
  {
    for (const auto & point : m_Result.jaws[j].contourPoints)
    {
      const auto p = ToDentalFrame(m_Result.jaws[j].frame, point);
      double     w[2][2];
      if (models[0].Project(p.data(), w[0]) && models[1].Project(p.data(), w[1]))
      {
        const double du = w[1][0] - w[0][0];
        const double dv = w[1][1] - w[0][1];
        sum += du * du + dv * dv;
        ++count;
      }
    }
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

double
PoseSolution::ToRadiographPixels(double workingPixels) const
{
  const auto & spacing = m_Result.geometry.pixelSpacing;
  return workingPixels * PoseWorkingPixel / (0.5 * (spacing[0] + spacing[1]));
}

double
PoseSolution::GetTracingSigma(JawEnum jaw) const
{
  return this->ToRadiographPixels(this->GetJaw(jaw).fit.predictedSigma);
}

double
PoseSolution::GetMiddleSigma(JawEnum jaw) const
{
  return this->ToRadiographPixels(this->GetJaw(jaw).middleSigma);
}

std::vector<PoseSolution::AlternativeType>
PoseSolution::GetAlternatives(JawEnum jaw, double millimetresPerUnit) const
{
  constexpr double             samePlace = 1.0;
  std::vector<AlternativeType> alternatives;
  for (const PoseCandidate & minimum : this->GetGroup(jaw).candidates)
  {
    if (!alternatives.empty() && minimum.distance < samePlace)
    {
      continue;
    }
    AlternativeType alternative;
    alternative.projection = this->GetProjectionMatrix(jaw, minimum.parameters, millimetresPerUnit);
    alternative.score = minimum.score;
    alternative.distance = this->ToRadiographPixels(minimum.distance);
    alternatives.push_back(alternative);
  }
  return alternatives;
}

PoseSolution::PixelIndexType
PoseSolution::ProjectPoint(JawEnum jaw, const PointType & point) const
{
  const ProjectionMatrixType p = this->GetProjectionMatrix(jaw);
  double                     q[3];
  for (unsigned int i = 0; i < 3; ++i)
  {
    q[i] = p(i, 0) * point[0] + p(i, 1) * point[1] + p(i, 2) * point[2] + p(i, 3);
  }
  PixelIndexType index;
  index[0] = q[0] / q[2];
  index[1] = q[1] / q[2];
  return index;
}

PoseSolution::CovarianceType
PoseSolution::ComputeCovariance(JawEnum jaw, const PointType & point) const
{
  const PoseGroupResult & group = this->GetGroup(jaw);
  const auto              p = ToDentalFrame(this->GetJaw(jaw).frame, { { point[0], point[1], point[2] } });
  double                  w[2], jacobian[14];
  PoseModel(m_Result.geometry, group.parameters).ProjectWithJacobian(p.data(), w, jacobian);
  // From the working plane to pixels.
  const double scale[2] = { PoseWorkingPixel * m_Result.geometry.facingSign / m_Result.geometry.pixelSpacing[0],
                            PoseWorkingPixel / m_Result.geometry.pixelSpacing[1] };
  std::array<double, 4> working = PoseModel::PropagateCovariance(jacobian, group.covariance);
  // What the other jaw placed is where the bite puts it.
  const double bite = this->GetJaw(jaw).GetBiteVariance(m_Result.geometry);
  working[0] += bite;
  working[3] += bite;
  CovarianceType covariance;
  for (unsigned int a = 0; a < 2; ++a)
  {
    for (unsigned int b = 0; b < 2; ++b)
    {
      covariance(a, b) = scale[a] * scale[b] * working[2 * a + b];
    }
  }
  return covariance;
}

std::vector<std::string>
PoseSolution::GetViewNames() const
{
  std::vector<std::string> names;
  for (const PoseViewResult & view : m_Result.views)
  {
    names.push_back(view.name);
  }
  return names;
}

const PoseViewResult &
PoseSolution::GetView(const std::string & name) const
{
  std::string names;
  for (const PoseViewResult & view : m_Result.views)
  {
    if (view.name == name)
    {
      return view;
    }
    names += (names.empty() ? "" : ", ") + view.name;
  }
  itkExceptionMacro("There is no view \"" << name << "\"; beside the first there "
                                          << (names.empty() ? "is none" : "are: ") << names << '.');
}

PoseSolution::Pointer
PoseSolution::MakeViewSolution(const std::string & name) const
{
  auto solution = Self::New();
  solution->SetResult(this->GetView(name).result, m_Options);
  return solution;
}

DentalContour::Pointer
PoseSolution::MakeMovingContour(JawEnum jaw) const
{
  const PoseJawResult &       own = this->GetJaw(jaw);
  DentalContour::PolylineType polyline;
  for (const auto & position : own.contour)
  {
    polyline.points.emplace_back(position.data());
  }
  for (const auto & normal : own.contourNormals)
  {
    polyline.normals.emplace_back(normal.data());
  }
  for (const auto & rim : own.contourPoints)
  {
    polyline.rimPoints.emplace_back(rim.data());
  }
  auto contour = DentalContour::New();
  contour->AddPolyline(polyline);
  return contour;
}

PoseSolution::RigidTransformType::Pointer
PoseSolution::MakeRigidTransform(JawEnum jaw) const
{
  this->GetGroup(jaw);
  const PoseJawResult & result = this->GetJaw(jaw);
  // As far as rounding goes: products of rotations.
  return ToRigidTransform(MakeRigidTransformRows(result.rotation, result.translation), 1e-6);
}

CephalometricPoseTransform::Pointer
PoseSolution::MakePoseTransform(JawEnum jaw) const
{
  const PoseGroupResult & group = this->GetGroup(jaw);
  using TransformType = CephalometricPoseTransform;
  TransformType::ParametersType parameters(TransformType::NumberOfParameters);
  for (unsigned int k = 0; k < TransformType::NumberOfParameters; ++k)
  {
    parameters[k] = group.parameters[k];
  }
  auto transform = TransformType::New();
  transform->SetPoseGeometry(m_Result.geometry);
  transform->SetParameters(parameters);
  return transform;
}

void
PoseSolution::CopyToGeometry(JawEnum jaw, CephalometricGeometry * geometry) const
{
  const auto rigid = this->MakeRigidTransform(jaw);
  itk::CopyToGeometry(m_Result.geometry, std::exp(this->GetGroup(jaw).parameters[PoseKappa]), *geometry);
  geometry->SetPose(rigid->GetMatrix(), rigid->GetOffset());
}

void
PoseSolution::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Jaws: " << m_Result.jaws.size() << std::endl;
  for (const PoseJawResult & jaw : m_Result.jaws)
  {
    os << indent.GetNextIndent() << ToString(jaw.jaw) << ": " << (jaw.registered ? "registered" : jaw.failure)
       << std::endl;
  }
  os << indent << "Groups: " << m_Result.groups.size() << std::endl;
  for (const PoseGroupResult & group : m_Result.groups)
  {
    os << indent.GetNextIndent() << "score " << group.score << ", candidates " << group.candidates.size() << ", pose";
    for (const double parameter : group.parameters)
    {
      os << ' ' << parameter;
    }
    os << std::endl;
  }
}
} // namespace itk

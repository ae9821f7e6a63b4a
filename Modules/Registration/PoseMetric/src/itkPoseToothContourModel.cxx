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
#include "itkPoseToothContourModel.h"

#include "itkMeshSilhouette.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace itk
{
namespace
{
/** Of a unit normal's component toward the root: beyond it the outline is where the crown was cut, not where it ends.
 */
constexpr double FacesRoot = 0.5;
/** px within which a sample of the fellow's outline is looked for, centres together: half a crown's height. */
constexpr double ToothPairingReach = 16.0;
/** px a unit normal: opposite flanks of a crown, whose normals are 2 apart, are never paired. */
constexpr double ToothPairingNormalWeight = 12.0;
} // namespace

PoseToothContourModel::PoseToothContourModel(const std::vector<std::shared_ptr<const TriangleSurface>> & crowns,
                                             RuleEnum                                                    rule,
                                             ToothCode::JawEnum                                          jaw)
  : m_Rule(rule)
  , m_Jaw(jaw)
{
  std::array<std::array<double, 3>, 2> box{};
  bool                                 isEmpty = true;
  for (const auto & crown : crowns)
  {
    m_Silhouettes.push_back(std::make_unique<MeshSilhouette>(*crown));
    const auto centroid = crown->AreaCentroid();
    m_Centroids.push_back({ { centroid[0], centroid[1], centroid[2] } });
    for (unsigned int d = 0; d < 3; ++d)
    {
      m_Centre[d] += centroid[d] / static_cast<double>(crowns.size());
    }
    for (const auto & point : crown->points)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        box[0][d] = isEmpty ? point[d] : std::min(box[0][d], point[d]);
        box[1][d] = isEmpty ? point[d] : std::max(box[1][d], point[d]);
      }
      isEmpty = false;
    }
  }
  for (unsigned int corner = 0; !isEmpty && corner < 8; ++corner)
  {
    m_Corners.push_back({ { box[corner & 1][0], box[(corner >> 1) & 1][1], box[(corner >> 2) & 1][2] } });
  }
}

PoseToothContourModel::~PoseToothContourModel() = default;

PoseContour
PoseToothContourModel::ComputeOne(std::size_t crown, const PoseModel & model) const
{
  OpenSilhouetteOptions options;
  options.jaw = m_Jaw;
  options.direction = model.GetGeometry().direction;
  // What turns the occlusal direction in the picture: from the side the head's pitch, from the front nothing much.
  options.pitch = options.direction == CephalometricDirectionEnum::Lateral ? model.GetParameters()[PosePitch] : 0.0;
  options.spacing = Spacing;
  options.facingOnly = false;
  const OpenSilhouette all = ComputeOpenSilhouette(*m_Silhouettes[crown], model.GetProjection(), options);
  // The occlusal direction in the picture: the dental frame's z.
  const double sign = m_Jaw == ToothCode::JawEnum::Upper ? 1.0 : -1.0;
  const double occlusal[2] = { -sign * std::sin(options.pitch), sign * std::cos(options.pitch) };
  PoseContour  kept;
  for (std::size_t r = 0; r < all.runs.size(); ++r)
  {
    const std::size_t begin = all.runs[r];
    const std::size_t end = r + 1 < all.runs.size() ? all.runs[r + 1] : all.Size();
    bool              open = false;
    for (std::size_t i = begin; i < end; ++i)
    {
      if (all.nu[i] * occlusal[0] + all.nv[i] * occlusal[1] < -FacesRoot)
      {
        open = false;
        continue;
      }
      if (!open)
      {
        kept.runs.push_back(kept.u.size());
        open = true;
      }
      kept.u.push_back(all.u[i]);
      kept.v.push_back(all.v[i]);
      kept.nu.push_back(all.nu[i]);
      kept.nv.push_back(all.nv[i]);
      kept.rim.push_back(all.rim[i]);
    }
  }
  return kept;
}

PoseContour
PoseToothContourModel::ComputeMiddle(const PoseModel & model) const
{
  const PoseContour one = this->ComputeOne(0, model);
  const PoseContour other = this->ComputeOne(1, model);
  double            a[2] = { 0.0, 0.0 };
  double            b[2] = { 0.0, 0.0 };
  model.Project(m_Centroids[0].data(), a);
  model.Project(m_Centroids[1].data(), b);
  const double du = b[0] - a[0];
  const double dv = b[1] - a[1];
  PoseContour  middle;
  for (std::size_t r = 0; r < one.runs.size(); ++r)
  {
    const std::size_t end = r + 1 < one.runs.size() ? one.runs[r + 1] : one.Size();
    bool              open = false;
    for (std::size_t i = one.runs[r]; i < end; ++i)
    {
      double      best = ToothPairingReach * ToothPairingReach;
      std::size_t partner = other.Size();
      for (std::size_t j = 0; j < other.Size(); ++j)
      {
        const double u = one.u[i] + du - other.u[j];
        const double v = one.v[i] + dv - other.v[j];
        const double turned = 2.0 - 2.0 * (one.nu[i] * other.nu[j] + one.nv[i] * other.nv[j]);
        const double d = u * u + v * v + ToothPairingNormalWeight * ToothPairingNormalWeight * turned;
        if (d < best)
        {
          best = d;
          partner = j;
        }
      }
      const double nu = partner < other.Size() ? one.nu[i] + other.nu[partner] : 0.0;
      const double nv = partner < other.Size() ? one.nv[i] + other.nv[partner] : 0.0;
      const double length = std::hypot(nu, nv);
      if (length < 1e-9)
      {
        open = false;
        continue;
      }
      if (!open)
      {
        middle.runs.push_back(middle.u.size());
        open = true;
      }
      middle.u.push_back(0.5 * (one.u[i] + other.u[partner]));
      middle.v.push_back(0.5 * (one.v[i] + other.v[partner]));
      middle.nu.push_back(nu / length);
      middle.nv.push_back(nv / length);
      middle.rim.push_back(one.rim[i]);
      middle.rimOther.push_back(other.rim[partner]);
    }
  }
  return middle;
}

PoseContour
PoseToothContourModel::Compute(const PoseModel & model) const
{
  VerifyPlaces(model, m_Corners);
  if (m_Silhouettes.size() == 1)
  {
    return this->ComputeOne(0, model);
  }
  if (m_Rule == RuleEnum::Middle)
  {
    return this->ComputeMiddle(model);
  }
  // By the crowns' foremost samples: u is anterior.
  PoseContour one = this->ComputeOne(0, model);
  PoseContour other = this->ComputeOne(1, model);
  const auto  front = [](const PoseContour & contour) {
    return contour.Size() == 0 ? -LargestExtent : *std::max_element(contour.u.begin(), contour.u.end());
  };
  return front(one) >= front(other) ? std::move(one) : std::move(other);
}
} // namespace itk

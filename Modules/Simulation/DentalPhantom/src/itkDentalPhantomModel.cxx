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
#include "itkDentalPhantomModel.h"

#include "itkDentalPhantomMath.h"
#include "itkDentalPhantomOcclusion.h"
#include "itkDentalPhantomScanDefects.h"

#include <cmath>

namespace itk
{
using namespace DentalPhantomMath;

namespace
{
const DentalPhantomParameters &
Validated(const DentalPhantomParameters & parameters)
{
  parameters.Validate();
  return parameters;
}
} // namespace

DentalPhantomModel::DentalPhantomModel(const DentalPhantomParameters & parameters, unsigned int threads)
  : m_Dentition(Validated(parameters))
{
  SettleDentalPhantom(m_Dentition, threads, m_Settlement);
}

auto
DentalPhantomModel::MakeJaw(unsigned int jaw, unsigned int threads, const ProgressType & progress) const -> JawSurface
{
  return DentalPhantomMesher(m_Dentition)
    .MakeJaw(jaw, m_Dentition.GetParameters().numberOfTriangles, true, threads, progress);
}

auto
DentalPhantomModel::MakeScan(unsigned int jaw, unsigned int threads, const ProgressType & progress) const -> JawSurface
{
  JawSurface result = this->MakeJaw(jaw, threads, progress);
  ApplyDentalPhantomScanDefects(jaw, m_Dentition.GetParameters().scan, result);
  return result;
}

auto
DentalPhantomModel::MakeCleanJaw(unsigned int jaw, std::uint32_t numberOfTriangles, unsigned int threads) const
  -> JawSurface
{
  return DentalPhantomMesher(m_Dentition).MakeJaw(jaw, numberOfTriangles, false, threads, {});
}

std::array<double, 2>
DentalPhantomModel::RayThroughTooth(unsigned int      jaw,
                                    unsigned int      tooth,
                                    const PointType & origin,
                                    const PointType & direction) const
{
  const DentalPhantomToothBody & body = m_Dentition.GetBody(jaw, tooth);
  const double                   flip = jaw == 0 ? -1.0 : 1.0;
  const double                   radius = this->GetToothRadius(jaw, tooth);
  const auto                     centre = this->GetToothCentre(jaw, tooth);
  double                         along = 0.0;
  for (unsigned int d = 0; d < 3; ++d)
  {
    along += (centre[d] - origin[d]) * direction[d];
  }
  double squared = 0.0;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double r = origin[d] + along * direction[d] - centre[d];
    squared += r * r;
  }
  std::array<double, 2> length{ { 0.0, 0.0 } };
  if (!body.present || squared >= radius * radius)
  {
    return length;
  }
  const double     half = std::sqrt(radius * radius - squared);
  constexpr double step = 0.5;
  const double     begin = along - half + 0.5 * step;
  const PointType  a = body.ToLocal({ { origin[0] + begin * direction[0],
                                        origin[1] + begin * direction[1],
                                        flip * (origin[2] + begin * direction[2]) } });
  PointType        d{};
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    d[axis] =
      body.axes[axis][0] * direction[0] + body.axes[axis][1] * direction[1] + body.axes[axis][2] * flip * direction[2];
  }
  for (double t = 0.0; t < 2.0 * half; t += step)
  {
    const PointType local = { { a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2] } };
    if (local[2] > body.height + 1.0 || local[2] < -body.rootLength - 1.0 ||
        std::abs(local[0]) > 0.5 * body.width + 1.0 || std::abs(local[1]) > 0.55 * body.depth + 1.0)
    {
      continue;
    }
    const double f = body.Evaluate(local, true);
    // A soft step of the sampling width instead of a count of samples.
    length[local[2] > 0.0 ? 0 : 1] += step * Clamp(0.5 - f / step, 0.0, 1.0);
  }
  return length;
}

auto
DentalPhantomModel::GetToothCentre(unsigned int jaw, unsigned int tooth) const -> PointType
{
  const DentalPhantomToothBody & body = m_Dentition.GetBody(jaw, tooth);
  PointType                      centre = body.ToJaw({ { 0.0, 0.0, 0.5 * (body.height - body.rootLength) } });
  if (jaw == 0)
  {
    centre[2] = -centre[2];
  }
  return centre;
}

double
DentalPhantomModel::GetToothRadius(unsigned int jaw, unsigned int tooth) const
{
  const DentalPhantomToothBody & body = m_Dentition.GetBody(jaw, tooth);
  const double                   half = 0.5 * (body.height + body.rootLength);
  return std::sqrt(half * half + 0.25 * body.width * body.width + 0.25 * body.depth * body.depth);
}

auto
DentalPhantomModel::GetBuccalDirection(unsigned int jaw, unsigned int tooth) const -> PointType
{
  const DentalPhantomToothBody & body = m_Dentition.GetBody(jaw, tooth);
  return { { body.axes[1][0], body.axes[1][1], jaw == 0 ? -body.axes[1][2] : body.axes[1][2] } };
}

auto
DentalPhantomModel::TransformToTooth(unsigned int jaw, unsigned int tooth, const PointType & point) const -> PointType
{
  return m_Dentition.GetBody(jaw, tooth).ToLocal({ { point[0], point[1], jaw == 0 ? -point[2] : point[2] } });
}
} // namespace itk

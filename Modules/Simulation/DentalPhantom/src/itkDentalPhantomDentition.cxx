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
#include "itkDentalPhantomDentition.h"

#include "itkDentalPhantomMath.h"

namespace itk
{
using namespace DentalPhantomMath;

DentalPhantomDentition::DentalPhantomDentition(const DentalPhantomParameters & parameters)
  : m_Parameters(parameters)
  , m_Arch(parameters)
{
  this->PlaceTeeth(0);
  this->PlaceTeeth(1);
}

std::uint8_t
DentalPhantomDentition::ToothFDI(unsigned int jaw, unsigned int tooth)
{
  const unsigned int left = DentalPhantomJaw::IsLeft(tooth) ? 1 : 0;
  const unsigned int quadrant = jaw == 0 ? 1 + left : 4 - left;
  return static_cast<std::uint8_t>(10 * quadrant + DentalPhantomJaw::GetPosition(tooth) + 1);
}

const DentalPhantomToothBody &
DentalPhantomDentition::GetLastBody(unsigned int jaw, unsigned int side) const
{
  const DentalPhantomToothBody & third = m_Bodies[jaw][DentalPhantomJaw::GetIndex(side == 1, 7)];
  return third.space ? third : m_Bodies[jaw][DentalPhantomJaw::GetIndex(side == 1, 6)];
}

void
DentalPhantomDentition::Move(unsigned int jaw, unsigned int tooth, double shift)
{
  m_Bodies[jaw][tooth].cervix[2] += shift;
  m_Bodies[jaw][tooth].centre[2] += shift;
}

void
DentalPhantomDentition::PlaceTeeth(unsigned int jaw)
{
  const DentalPhantomJaw & source = m_Parameters.jaws[jaw];
  for (unsigned int i = 0; i < NumberOfTeeth; ++i)
  {
    const DentalPhantomTooth & tooth = source.GetTooth(i);
    DentalPhantomToothBody &   body = m_Bodies[jaw][i];
    const unsigned int         k = DentalPhantomJaw::GetPosition(i);
    const double               side = DentalPhantomJaw::IsLeft(i) ? 1.0 : -1.0;
    const double               W = tooth.mesiodistal;
    const double               B = tooth.buccolingual;
    const double               H = tooth.height;
    // A closed gap is no place; neither is that of a third molar that is not there.
    body.space = !tooth.missing || (k < 7 && tooth.mesiodistal > 0.5);
    if (!body.space)
    {
      continue;
    }
    body.Shape(jaw, k, tooth);

    // Along the arch.
    double begin = 0.0;
    for (unsigned int m = 0; m < k; ++m)
    {
      const DentalPhantomTooth & before = source.GetTooth(DentalPhantomJaw::GetIndex(side > 0.0, m));
      begin += before.mesialGap + before.mesiodistal;
    }
    begin += tooth.mesialGap;
    body.begin = side < 0.0 ? -(begin + W) : begin;
    body.end = side < 0.0 ? -begin : begin + W;
    const double s = side * (begin + 0.5 * W);
    double       point[2];
    double       normal[2];
    m_Arch.GetPoint(jaw, s, point, normal);
    // Of the chord, not of the arch's smooth guide.
    double a[2];
    double b[2];
    double unused[2];
    m_Arch.GetPoint(jaw, body.begin, a, unused);
    m_Arch.GetPoint(jaw, body.end, b, unused);
    // From right to left; outward is to its right-hand side seen from above.
    double tangent[2] = { b[0] - a[0], b[1] - a[1] };
    double l = std::hypot(tangent[0], tangent[1]);
    tangent[0] /= l;
    tangent[1] /= l;
    const double outward[3] = { tangent[1], -tangent[0], 0.0 };
    const double mesial[3] = { -side * tangent[0], -side * tangent[1], 0.0 };
    const double occlusal[3] = { 0.0, 0.0, 1.0 };

    const double spee = std::sin(3.141592653589793 * std::min(std::abs(s) / 60.0, 1.0));
    const double plane = -m_Parameters.speeDepth * spee * spee;
    const double over = k < 2 ? 0.5 * m_Parameters.overbite : k == 2 ? 0.25 * m_Parameters.overbite + 0.6 : 0.6;
    const double level = (jaw == 0 ? -plane : plane) + over + tooth.occlusalOffset;

    const double torque = tooth.torque * (k < 3 ? 1.0 : m_Parameters.wilson);
    const double ct = std::cos(torque);
    const double st = std::sin(torque);
    const double cp = std::cos(tooth.tip);
    const double sp = std::sin(tooth.tip);
    const double cr = std::cos(tooth.rotation);
    const double sr = std::sin(tooth.rotation);
    const auto   turn = [&](const PointType & v) {
      const PointType r = { { cr * v[0] - sr * v[1], sr * v[0] + cr * v[1], v[2] } };
      const PointType t = { { cp * r[0] + sp * r[2], r[1], -sp * r[0] + cp * r[2] } };
      return PointType{ { t[0], ct * t[1] + st * t[2], -st * t[1] + ct * t[2] } };
    };
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      PointType v{};
      v[axis] = 1.0;
      const PointType t = turn(v);
      for (unsigned int d = 0; d < 3; ++d)
      {
        body.axes[axis][d] = t[0] * mesial[d] + t[1] * outward[d] + t[2] * occlusal[d];
      }
    }
    // Turned about the edge or the occlusal surface, so that the arch line holds what the teeth show.
    const double target[3] = { point[0] + tooth.buccalOffset * outward[0],
                               point[1] + tooth.buccalOffset * outward[1],
                               level };
    for (unsigned int d = 0; d < 3; ++d)
    {
      body.cervix[d] = target[d] - body.axes[1][d] * body.edge - body.axes[2][d] * H;
    }
    body.centre = body.ToJaw({ { 0.0, 0.0, 0.5 * H } });
    body.radius = std::sqrt(0.25 * W * W + 0.25 * B * B + 0.25 * H * H) + 1.0;
  }
}
} // namespace itk

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
#include "itkDentalPhantomMesher.h"

#include "itkDentalPhantomCastBase.h"
#include "itkDentalPhantomGrid.h"
#include "itkDentalPhantomLandmarks.h"
#include "itkDentalPhantomMath.h"
#include "itkParallelFor.h"
#include "itkReproducibleRandom.h"

#include <utility>

namespace itk
{
using namespace DentalPhantomMath;

namespace
{
/** Angle by which the fan goes below the horizontal: a right angle. */
constexpr double FanAngle = 1.5707963267948966;
} // namespace

auto
DentalPhantomMesher::MakeStation(unsigned int jaw, double s) const -> Station
{
  const DentalPhantomJaw & source = m_Dentition.GetParameters().jaws[jaw];
  Station                  station;
  double                   point[2];
  m_Dentition.GetArch().GetPoint(jaw, s, point, station.normal);

  // Smooth along the arch: where the cervices are, how thick the teeth are there, how high the papillae.
  double sum = 0.0;
  double lateral = 0.0;
  double level = 0.0;
  double buccal = 0.0;
  double lingual = 0.0;
  double papilla = 0.0;
  double scallop = 1.0;
  double gingivaTop = 0.0;
  // Beyond the last tooth everything stays as at the last tooth.
  const DentalPhantomToothBody & rightEnd = m_Dentition.GetLastBody(jaw, 0);
  const DentalPhantomToothBody & leftEnd = m_Dentition.GetLastBody(jaw, 1);
  const double                   first = 0.5 * (rightEnd.begin + rightEnd.end);
  const double                   last = 0.5 * (leftEnd.begin + leftEnd.end);
  for (unsigned int i = 0; i < DentalPhantomDentition::NumberOfTeeth; ++i)
  {
    const DentalPhantomToothBody & body = m_Dentition.GetBody(jaw, i);
    if (!body.space)
    {
      continue;
    }
    const double c = 0.5 * (body.begin + body.end);
    const double d = (Clamp(s, first, last) - c) / 3.5;
    const double w = std::exp(-0.5 * d * d) + 1e-12;
    double       q[2];
    double       n[2];
    m_Dentition.GetArch().GetPoint(jaw, c, q, n);
    const double offset = (body.cervix[0] - q[0]) * n[0] + (body.cervix[1] - q[1]) * n[1];
    sum += w;
    lateral += w * offset;
    level += w * body.cervix[2];
    buccal += w * 0.44 * body.depth;
    lingual += w * 0.45 * body.depth;
    papilla += w * (body.present ? (DentalPhantomJaw::GetPosition(i) < 3 ? 2.4 : 1.5) : 0.2);
    const double a = std::abs(s - c) / (0.5 * (body.end - body.begin));
    if (a < scallop)
    {
      scallop = a;
    }
  }
  lateral /= sum;
  level /= sum;
  papilla /= sum;
  const double beyond = std::max({ 0.0, rightEnd.begin - s, s - leftEnd.end });
  gingivaTop = 0.8 + papilla * scallop * scallop * (1.0 - SmoothStep(0.0, 2.5, beyond));

  station.origin = { { point[0] + lateral * station.normal[0], point[1] + lateral * station.normal[1], level } };
  station.buccalExtent = buccal / sum + 0.6;
  station.lingualExtent = lingual / sum + 0.6;
  station.crest = gingivaTop;

  // Neighbouring stations' planes meet at the arch's centre of curvature: stay on this side of it.
  double before[2];
  double after[2];
  double normalBefore[2];
  double normalAfter[2];
  m_Dentition.GetArch().GetPoint(jaw, s - 5.0, before, normalBefore);
  m_Dentition.GetArch().GetPoint(jaw, s + 5.0, after, normalAfter);
  const double bend = std::hypot(normalAfter[0] - normalBefore[0], normalAfter[1] - normalBefore[1]);
  const double radius = 10.0 / std::max(bend, 1e-3);
  station.lingualExtent = std::min(station.lingualExtent, std::max(1.5, radius + lateral - 5.0));

  const double wave = source.trimWave * (std::sin(0.23 * s + source.trimPhase) + 0.5 * std::sin(0.61 * s));
  const double slope = source.trimSlopeAnterior * (point[0] - 22.0) + source.trimSlopeLeft * point[1];
  station.buccalFlange = std::max(1.0, source.buccalFlange + slope + wave);
  station.lingualFlange = source.palate ? 2.0 : std::max(1.0, source.lingualFlange + slope - 0.6 * wave);

  station.numberOfNear = 0;
  for (unsigned int i = 0; i < DentalPhantomDentition::NumberOfTeeth; ++i)
  {
    const DentalPhantomToothBody & body = m_Dentition.GetBody(jaw, i);
    if (body.present && s > body.begin - 5.0 && s < body.end + 5.0 && station.numberOfNear < 6)
    {
      station.near[station.numberOfNear++] = static_cast<int>(i);
    }
  }
  return station;
}

double
DentalPhantomMesher::Gingiva(unsigned int jaw, const Station & station, double q, double o) const
{
  // Flares apically, most on the palatal side; the papilla narrows occlusally.
  const double down = std::max(-o, 0.0);
  const double up = std::max(o, 0.0);
  const double buccal = station.buccalExtent + 0.12 * down - 0.3 * up;
  const double lingual =
    station.lingualExtent + (jaw == 0 || m_Dentition.GetParameters().jaws[jaw].palate ? 0.3 : 0.05) * down - 0.3 * up;
  return SmoothMax(std::max(q - buccal, -q - lingual), o - station.crest, 1.6);
}

DentalPhantomGrid
DentalPhantomMesher::MakeLayout(unsigned int jaw, std::uint32_t numberOfTriangles) const
{
  DentalPhantomGrid        layout;
  const DentalPhantomJaw & source = m_Dentition.GetParameters().jaws[jaw];
  const double             lengths[2] = { -m_Dentition.GetLastBody(jaw, 0).begin + source.distalExtension[0],
                                          m_Dentition.GetLastBody(jaw, 1).end + source.distalExtension[1] };
  // Rows and columns that give the wanted number of triangles with about square cells.
  const double fan = 27.0;
  const double palateLength = source.palate ? 20.0 : 0.0;
  const double lingualFlange = source.palate ? 2.0 : source.lingualFlange;
  // The base is coarser by half.
  const double wall = m_Dentition.GetParameters().baseHeight + 3.0;
  const double ground = 14.0;
  const double baseLength =
    m_Dentition.GetParameters().stoneBase ? 0.5 * ((source.palate ? 1.0 : 2.0) * wall + ground) : 0.0;
  const double profile = fan + source.buccalFlange + lingualFlange + palateLength + baseLength;
  const double cell = std::sqrt(2.0 * (lengths[0] + lengths[1]) * profile / numberOfTriangles);
  layout.buccalRows = std::max(1, static_cast<int>(std::lround(source.buccalFlange / cell)));
  layout.fanRows = std::max(6, static_cast<int>(std::lround(fan / cell)));
  layout.lingualRows = std::max(1, static_cast<int>(std::lround(lingualFlange / cell)));
  layout.palateRows = source.palate ? std::max(2, static_cast<int>(std::lround(palateLength / cell))) : 0;
  layout.wallRows = std::max(2, static_cast<int>(std::lround(0.5 * wall / cell)));
  layout.bottomRows = std::max(2, static_cast<int>(std::lround(0.5 * ground / cell)));
  const int baseRows =
    m_Dentition.GetParameters().stoneBase ? (source.palate ? 1 : 2) * layout.wallRows + layout.bottomRows : 0;
  const int rows = layout.buccalRows + layout.fanRows + layout.lingualRows;
  layout.rayRows = rows + 1;
  layout.half =
    std::max(8, static_cast<int>(std::lround(numberOfTriangles / (4.0 * (rows + layout.palateRows + baseRows)))));
  layout.columns = 2 * layout.half + 1;

  // Denser columns between the teeth, where the surface dives.
  std::vector<double> & stations = layout.stations;
  stations.assign(layout.columns, 0.0);
  for (unsigned int side = 0; side < 2; ++side)
  {
    std::vector<double> cumulative{ 0.0 };
    constexpr double    step = 0.05;
    const int           n = std::max(2, static_cast<int>(lengths[side] / step));
    for (int k = 0; k < n; ++k)
    {
      const double s = (side == 0 ? -1.0 : 1.0) * lengths[side] * (k + 0.5) / n;
      double       nearest = 1e9;
      for (const DentalPhantomToothBody & body : m_Dentition.GetBodies(jaw))
      {
        if (!body.space)
        {
          continue;
        }
        nearest = std::min({ nearest, std::abs(s - body.begin), std::abs(s - body.end) });
      }
      cumulative.push_back(cumulative.back() + 1.0 + 1.2 * std::exp(-nearest * nearest / 0.8));
    }
    int k = 0;
    for (int i = 1; i <= layout.half; ++i)
    {
      const double wanted = cumulative.back() * i / layout.half;
      while (k + 1 < n && cumulative[k + 1] < wanted)
      {
        ++k;
      }
      const double t = Clamp((wanted - cumulative[k]) / (cumulative[k + 1] - cumulative[k]), 0.0, 1.0);
      stations[side == 0 ? layout.half - i : layout.half + i] = (side == 0 ? -1.0 : 1.0) * lengths[side] * (k + t) / n;
    }
  }
  // Denser rays upward, where the surface is far from the fan's centre.
  layout.angles.resize(layout.fanRows + 1);
  for (int j = 0; j <= layout.fanRows; ++j)
  {
    const double t = 1.0 - 2.0 * j / layout.fanRows;
    layout.angles[j] = FanAngle * t * (0.62 + 0.38 * t * t);
  }
  return layout;
}

void
DentalPhantomMesher::ShootRays(unsigned int                jaw,
                               const DentalPhantomGrid &   layout,
                               bool                        brackets,
                               unsigned int                threads,
                               const ProgressType &        progress,
                               std::vector<PointType> &    rays,
                               std::vector<std::uint8_t> & rayLabels) const
{
  const int rayRows = layout.rayRows;
  rays.resize(static_cast<std::size_t>(layout.columns) * rayRows);
  rayLabels.assign(rays.size(), 0);
  const auto column = [&](std::size_t c) {
    const Station station = this->MakeStation(jaw, layout.stations[c]);
    const auto    evaluate = [&](double q, double o, int * label) {
      const PointType p = {
        { station.origin[0] + q * station.normal[0], station.origin[1] + q * station.normal[1], station.origin[2] + o }
      };
      double teeth = 1e9;
      for (int k = 0; k < station.numberOfNear; ++k)
      {
        const DentalPhantomToothBody & body = m_Dentition.GetBodies(jaw)[station.near[k]];
        const double                   dx = p[0] - body.centre[0];
        const double                   dy = p[1] - body.centre[1];
        const double                   dz = p[2] - body.centre[2];
        const double                   far = std::sqrt(dx * dx + dy * dy + dz * dz) - body.radius;
        double                         f = far;
        if (far <= 0.5)
        {
          const PointType local = body.ToLocal(p);
          f = body.Evaluate(local, false);
          if (brackets && body.bracket[0] > 0.0)
          {
            f = std::min(f, body.EvaluateBracket(local));
          }
        }
        if (label && f < teeth)
        {
          *label = station.near[k];
        }
        teeth = k == 0 ? f : SmoothMin(teeth, f, 0.15);
      }
      const double gingiva = this->Gingiva(jaw, station, q, o);
      if (label && gingiva < teeth)
      {
        *label = -1;
      }
      return SmoothMin(teeth, gingiva, 0.3);
    };
    for (int r = 0; r < rayRows; ++r)
    {
      // Horizontal rays on the flanges, a fan between them.
      double q = 1.0;
      double o = 0.0;
      double level = 0.0;
      if (r < layout.buccalRows)
      {
        level = -station.buccalFlange * (1.0 - static_cast<double>(r) / layout.buccalRows);
      }
      else if (r <= layout.buccalRows + layout.fanRows)
      {
        const double angle = layout.angles[r - layout.buccalRows];
        q = std::sin(angle);
        o = std::cos(angle);
      }
      else
      {
        q = -1.0;
        level =
          -station.lingualFlange * static_cast<double>(r - layout.buccalRows - layout.fanRows) / layout.lingualRows;
      }
      // From outside inward to the first hit: the outer envelope. The field overestimates distances: half steps.
      double t = 17.0;
      double f = evaluate(t * q, level + t * o, nullptr);
      double outside = t;
      while (f > 0.0 && t > 0.2)
      {
        outside = t;
        t -= std::max(0.06, 0.45 * f);
        f = evaluate(t * q, level + t * o, nullptr);
      }
      double inside = t;
      for (unsigned int k = 0; k < 24; ++k)
      {
        const double middle = 0.5 * (inside + outside);
        (evaluate(middle * q, level + middle * o, nullptr) > 0.0 ? outside : inside) = middle;
      }
      int label = -1;
      t = 0.5 * (inside + outside);
      evaluate(t * q, level + t * o, &label);
      const std::size_t id = c * rayRows + r;
      rays[id] = { { station.origin[0] + t * q * station.normal[0],
                     station.origin[1] + t * q * station.normal[1],
                     station.origin[2] + level + t * o } };
      rayLabels[id] = label < 0 ? 0 : DentalPhantomDentition::ToothFDI(jaw, static_cast<unsigned int>(label));
    }
  };
  constexpr std::size_t block = 32;
  for (std::size_t begin = 0; begin < static_cast<std::size_t>(layout.columns); begin += block)
  {
    const std::size_t count = std::min(block, layout.columns - begin);
    ParallelFor(count, threads, [&](std::size_t c) { column(begin + c); });
    if (progress)
    {
      progress(static_cast<double>(begin + count) / layout.columns);
    }
  }
}

void
DentalPhantomMesher::AddPalate(unsigned int jaw, DentalPhantomGrid & layout, JawSurface & result) const
{
  const DentalPhantomJaw & source = m_Dentition.GetParameters().jaws[jaw];
  std::vector<PointType> & points = result.surface.points;
  // From the lingual border to a seam on the midline that the two sides share.
  const auto border = [&](int c) { return points[static_cast<std::size_t>(c) * layout.rayRows + layout.rayRows - 1]; };
  const double               front = border(layout.half)[0] - 8.0;
  const double               back = 0.5 * (border(0)[0] + border(layout.columns - 1)[0]) - 1.0;
  std::vector<std::uint32_t> seam;
  for (int i = 0; i <= layout.half; ++i)
  {
    const double t = static_cast<double>(i) / layout.half;
    const double level = 0.5 * (border(layout.half - i)[2] + border(layout.half + i)[2]);
    seam.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back({ { front + (back - front) * std::pow(t, 1.2),
                         0.0,
                         level - source.palateDepth * (0.3 + 0.7 * SmoothStep(0.0, 0.7, t)) } });
    result.labels.push_back(0);
  }
  for (int c = 0; c < layout.columns; ++c)
  {
    const PointType a = border(c);
    const PointType b = points[seam[std::abs(c - layout.half)]];
    for (int r = 1; r < layout.palateRows; ++r)
    {
      const double t = static_cast<double>(r) / layout.palateRows;
      const double u = 1.0 - (1.0 - t) * (1.0 - t);
      layout.ids[c].push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back({ { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + u * (b[2] - a[2]) } });
      result.labels.push_back(0);
    }
    layout.ids[c].push_back(seam[std::abs(c - layout.half)]);
  }
}

auto
DentalPhantomMesher::MakeJaw(unsigned int         jaw,
                             std::uint32_t        numberOfTriangles,
                             bool                 finish,
                             unsigned int         threads,
                             const ProgressType & progress) const -> JawSurface
{
  DentalPhantomGrid         layout = this->MakeLayout(jaw, numberOfTriangles);
  std::vector<PointType>    rays;
  std::vector<std::uint8_t> rayLabels;
  this->ShootRays(jaw, layout, finish, threads, progress, rays, rayLabels);

  // Points in the jaw's frame (o occlusal), ids of the grid.
  JawSurface               result;
  std::vector<PointType> & points = result.surface.points;
  layout.ids.assign(layout.columns, {});
  for (int c = 0; c < layout.columns; ++c)
  {
    for (int r = 0; r < layout.rayRows; ++r)
    {
      layout.ids[c].push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(rays[static_cast<std::size_t>(c) * layout.rayRows + r]);
      result.labels.push_back(rayLabels[static_cast<std::size_t>(c) * layout.rayRows + r]);
    }
  }
  if (m_Dentition.GetParameters().jaws[jaw].palate)
  {
    this->AddPalate(jaw, layout, result);
  }
  for (int c = 0; c + 1 < layout.columns; ++c)
  {
    DentalPhantomGrid::AddStrip(result.surface, layout.ids[c], layout.ids[c + 1]);
  }
  if (m_Dentition.GetParameters().stoneBase)
  {
    AddDentalPhantomCastBase(jaw, m_Dentition, layout, result);
  }

  AddDentalPhantomLandmarks(jaw, m_Dentition, result);
  if (finish && m_Dentition.GetParameters().scannerNoise > 0.0)
  {
    const auto         normals = result.surface.VertexNormals();
    ReproducibleRandom random(m_Dentition.GetParameters().noiseSeed, jaw);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double d = random.Normal(0.0, m_Dentition.GetParameters().scannerNoise);
      for (unsigned int k = 0; k < 3; ++k)
      {
        points[i][k] += d * normals[i][k];
      }
    }
  }
  // From occlusal-up to the anatomical frame. The upper jaw is turned over, which turns the winding.
  for (PointType & p : points)
  {
    for (double & value : p)
    {
      value = Quantise(value);
    }
    if (jaw == 0)
    {
      p[2] = -p[2];
    }
  }
  if (jaw == 0)
  {
    for (auto & triangle : result.surface.triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  for (JawSurface::Landmark & landmark : result.landmarks)
  {
    // The point field holds the vertex's id until here.
    landmark.point = points[static_cast<std::size_t>(landmark.point[0])];
  }
  return result;
}
} // namespace itk

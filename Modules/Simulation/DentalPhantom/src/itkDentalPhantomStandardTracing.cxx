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
#include "itkDentalPhantomStandardTracing.h"

#include "itkDentalPhantomOutline.h"
#include "itkDentalPhantomSpline.h"
#include "itkDentalPhantomTracer.h"
#include "itkReproducibleRandom.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using PixelType = DentalPhantomStandardTracing::PixelType;
using PointType = DentalPhantomModel::PointType;

enum StandardTracingStream : std::uint64_t
{
  TemplateStream = 401,
  PalatalStream = 3000,
  DriftStream = 230
};

/** A similarity that takes two points to two others. */
struct Similarity
{
  double a{ 1.0 };
  double b{ 0.0 };
  double u{ 0.0 };
  double v{ 0.0 };

  Similarity(const PixelType & p, const PixelType & q, const PixelType & toP, const PixelType & toQ)
  {
    const PixelType d = { { q[0] - p[0], q[1] - p[1] } };
    const PixelType e = { { toQ[0] - toP[0], toQ[1] - toP[1] } };
    const double    n = d[0] * d[0] + d[1] * d[1];
    a = (d[0] * e[0] + d[1] * e[1]) / n;
    b = (d[0] * e[1] - d[1] * e[0]) / n;
    u = toP[0] - a * p[0] + b * p[1];
    v = toP[1] - b * p[0] - a * p[1];
  }
  PixelType
  operator()(const PixelType & p) const
  {
    return { { a * p[0] - b * p[1] + u, b * p[0] + a * p[1] + v } };
  }
};

/** Pixels a millimetre about the teeth. */
double
MagnificationOf(const PerspectiveProjection & projection)
{
  const PointType a = { { 10.0, 0.0, 0.0 } };
  const PointType b = { { 30.0, 0.0, 0.0 } };
  PixelType       p{};
  PixelType       q{};
  projection.Project(a.data(), p[0], p[1]);
  projection.Project(b.data(), q[0], q[1]);
  return std::hypot(q[0] - p[0], q[1] - p[1]) / 20.0;
}

PixelType
Middle(const PixelType & a, const PixelType & b)
{
  return { { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) } };
}
} // namespace

auto
DentalPhantomStandardTracing::ComputeAlong(const PerspectiveProjection & projection) -> PixelType
{
  const PointType a = { { 10.0, 0.0, 0.0 } };
  const PointType b = { { 30.0, 0.0, 0.0 } };
  PixelType       p{};
  PixelType       q{};
  projection.Project(a.data(), p[0], p[1]);
  projection.Project(b.data(), q[0], q[1]);
  const double l = std::hypot(q[0] - p[0], q[1] - p[1]);
  return { { (q[0] - p[0]) / l, (q[1] - p[1]) / l } };
}

auto
DentalPhantomStandardTracing::GetTemplate(unsigned int jaw, bool molar, unsigned int set) -> std::vector<PixelType>
{
  std::vector<PixelType> knots;
  if (!molar && jaw == 0)
  {
    knots = { { { 0.0, 0.0 } },   { { 0.9, 2.0 } },   { { 1.6, 4.5 } },   { { 1.9, 7.0 } },   { { 1.95, 9.5 } },
              { { 1.75, 11.5 } }, { { 1.5, 14.5 } },  { { 1.1, 18.5 } },  { { 0.6, 21.8 } },  { { 0.0, 23.5 } },
              { { -0.7, 22.8 } }, { { -1.9, 19.0 } }, { { -3.0, 15.0 } }, { { -4.2, 11.5 } }, { { -4.8, 9.6 } },
              { { -4.7, 8.0 } },  { { -3.6, 6.0 } },  { { -2.2, 3.8 } },  { { -1.1, 1.8 } },  { { -0.5, 0.4 } } };
  }
  else if (!molar)
  {
    knots = { { { 0.0, 0.0 } },   { { 0.6, 2.0 } },   { { 1.2, 4.5 } },  { { 1.7, 7.0 } },  { { 1.9, 9.0 } },
              { { 1.8, 11.5 } },  { { 1.4, 15.0 } },  { { 0.8, 18.5 } }, { { 0.1, 21.3 } }, { { -0.6, 20.4 } },
              { { -1.8, 16.0 } }, { { -2.9, 12.0 } }, { { -3.7, 9.2 } }, { { -3.6, 7.5 } }, { { -2.6, 5.0 } },
              { { -1.4, 2.5 } },  { { -0.5, 0.5 } } };
  }
  else if (jaw == 0)
  {
    knots = { { { 0.0, 0.0 } },   { { 1.4, 0.7 } },   { { 2.5, 2.2 } },   { { 2.5, 4.0 } },   { { 1.8, 6.5 } },
              { { 1.9, 10.0 } },  { { 1.7, 14.0 } },  { { 1.1, 18.0 } },  { { 0.5, 19.6 } },  { { -0.3, 18.6 } },
              { { -0.9, 15.0 } }, { { -1.8, 12.0 } }, { { -2.8, 11.0 } }, { { -3.9, 12.0 } }, { { -5.2, 15.0 } },
              { { -6.2, 18.0 } }, { { -6.9, 19.0 } }, { { -7.5, 17.8 } }, { { -7.4, 14.0 } }, { { -6.9, 10.0 } },
              { { -6.7, 6.8 } },  { { -7.5, 4.0 } },  { { -7.5, 2.2 } },  { { -6.4, 0.8 } },  { { -4.9, 0.15 } },
              { { -3.6, 0.5 } },  { { -2.5, 1.1 } },  { { -1.2, 0.6 } } };
  }
  else
  {
    knots = { { { 0.0, 0.0 } },   { { 1.4, 0.7 } },   { { 2.4, 2.2 } },   { { 2.3, 4.2 } },   { { 1.5, 6.8 } },
              { { 1.4, 10.0 } },  { { 1.1, 15.0 } },  { { 0.6, 19.5 } },  { { 0.1, 20.9 } },  { { -0.8, 20.0 } },
              { { -1.6, 16.0 } }, { { -2.3, 12.0 } }, { { -3.3, 10.6 } }, { { -4.3, 12.0 } }, { { -5.9, 15.5 } },
              { { -7.6, 19.0 } }, { { -8.6, 20.0 } }, { { -9.2, 18.8 } }, { { -8.9, 15.0 } }, { { -8.1, 10.5 } },
              { { -7.7, 6.8 } },  { { -8.6, 4.2 } },  { { -8.7, 2.4 } },  { { -7.4, 0.8 } },  { { -5.9, 0.8 } },
              { { -4.3, 0.15 } }, { { -2.9, 0.8 } },  { { -1.3, 0.6 } } };
  }
  // The second set is slimmer and longer, as another publisher's might be.
  const double across = set == 0 ? 1.0 : 0.93;
  const double length = set == 0 ? 1.0 : 1.05;
  for (PixelType & p : knots)
  {
    p = { { across * p[0], length * p[1] } };
  }
  return DentalPhantomSpline(knots, true, 8);
}

DentalPhantomStandardTracing::DentalPhantomStandardTracing(const DentalPhantomModel &               model,
                                                           const PerspectiveProjection &            projection,
                                                           const std::map<std::string, PixelType> & tips,
                                                           int                                      facing,
                                                           double                                   spacing,
                                                           const DentalPhantomLevel &               level,
                                                           std::uint64_t                            seed,
                                                           unsigned int                             threads)
{
  const PixelType         along = ComputeAlong(projection);
  const DentalPhantomHand hand(level, seed, along, spacing);
  const auto project = [&projection](unsigned int jaw, const DentalPhantomToothBody & body, const PointType & local) {
    PointType p = body.ToJaw(local);
    p[2] *= jaw == 0 ? -1.0 : 1.0;
    PixelType pixel{};
    projection.Project(p.data(), pixel[0], pixel[1]);
    return pixel;
  };
  ReproducibleRandom stock(seed, TemplateStream);
  // A reader who uses templates uses one set for all teeth.
  const bool         usesTemplates = stock.Uniform() < level.templateProbability;
  const unsigned int set = stock.Integer(2);

  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    const std::string prefix = jaw == 0 ? "U" : "L";
    for (const bool molar : { false, true })
    {
      // The reference points of each side's tooth: edge or mesiobuccal cusp, apex of its axis, mesial contact.
      struct Reference
      {
        bool         present{ false };
        unsigned int tooth{ 0 };
        PixelType    tip{};
        PixelType    axis{};
        PixelType    apex{};
        PixelType    contact{};
      };
      Reference sides[2];
      for (unsigned int side = 0; side < 2; ++side)
      {
        const unsigned int tooth = DentalPhantomJaw::GetIndex(side == 1, molar ? 5 : 0);
        const auto &       body = model.GetDentition().GetBody(jaw, tooth);
        const auto         tip = tips.find(prefix + (side == 0 ? "R" : "L") + (molar ? "6_MB" : "1_tip"));
        if (!body.present || tip == tips.end())
        {
          continue;
        }
        sides[side] = { true,
                        tooth,
                        tip->second,
                        project(jaw, body, { { 0.0, 0.0, -10.0 } }),
                        project(jaw, body, body.GetApex()),
                        project(jaw, body, { { 0.5 * body.width, 0.0, 0.66 * body.height } }) };
      }
      if (!sides[0].present && !sides[1].present)
      {
        continue;
      }
      Reference middle = sides[0].present ? sides[0] : sides[1];
      if (sides[0].present && sides[1].present)
      {
        if (!molar)
        {
          middle = facing * (sides[0].tip[0] - sides[1].tip[0]) >= 0.0 ? sides[0] : sides[1];
        }
        else
        {
          middle.tip = Middle(sides[0].tip, sides[1].tip);
          middle.axis = Middle(sides[0].axis, sides[1].axis);
          middle.apex = Middle(sides[0].apex, sides[1].apex);
          middle.contact = Middle(sides[0].contact, sides[1].contact);
        }
      }
      const unsigned int position = molar ? 6 : 1;
      const unsigned int item = 10 * (jaw == 0 ? 1 : 4) + position;

      if (level.drawOutlines)
      {
        Outline outline;
        outline.fdi = static_cast<std::uint8_t>(item);
        outline.isTemplate = usesTemplates;
        const Reference & from = sides[0].present ? sides[0] : sides[1];
        if (usesTemplates)
        {
          // By tip and axis: the stock outline keeps its size, magnified as all of the picture is.
          const PixelType & top = middle.tip;
          const PixelType & end = molar ? middle.axis : middle.apex;
          const double      l = std::hypot(end[0] - top[0], end[1] - top[1]);
          // The molar's axis passes behind its mesiobuccal cusp: the axis gives the direction alone.
          PixelType apical = { { (end[0] - top[0]) / l, (end[1] - top[1]) / l } };
          if (molar)
          {
            const auto &    body = model.GetDentition().GetBody(jaw, from.tooth);
            const PixelType crown = project(jaw, body, { { 0.0, 0.0, body.height } });
            const double    m = std::hypot(from.axis[0] - crown[0], from.axis[1] - crown[1]);
            apical = { { (from.axis[0] - crown[0]) / m, (from.axis[1] - crown[1]) / m } };
          }
          // Anterior is the apical direction turned by a right angle, to the side that the face looks to.
          PixelType    anterior = { { -apical[1], apical[0] } };
          const double turn = facing * anterior[0] >= 0.0 ? 1.0 : -1.0;
          const double magnification = MagnificationOf(projection);
          for (const PixelType & p : GetTemplate(jaw, molar, set))
          {
            outline.exact.push_back({ { top[0] + magnification * (turn * p[0] * anterior[0] + p[1] * apical[0]),
                                        top[1] + magnification * (turn * p[0] * anterior[1] + p[1] * apical[1]) } });
          }
        }
        else
        {
          outline.exact =
            DentalPhantomOutline::Trace(model, jaw, molar ? from.tooth : middle.tooth, projection, true, 0.7, threads);
          if (molar)
          {
            const Similarity toMiddle(from.tip, from.axis, middle.tip, middle.axis);
            for (PixelType & p : outline.exact)
            {
              p = toMiddle(p);
            }
          }
        }
        // As many points as a careful hand sets: one in about two pixels.
        const std::size_t count = molar ? 104 : jaw == 0 ? 80 : 64;
        outline.exact = DentalPhantomOutline::Resample(outline.exact, count);
        if (!outline.exact.empty())
        {
          outline.drawn = outline.exact;
          // The palatal or lingual side, which other structures hide: one bulge between tip and apex.
          ReproducibleRandom palatal(seed, PalatalStream + item);
          const double       bulge = usesTemplates ? 0.0 : level.palatalError / spacing * palatal.Normal();
          if (!molar)
          {
            const PixelType d = { { middle.apex[0] - middle.tip[0], middle.apex[1] - middle.tip[1] } };
            const double    n = std::hypot(d[0], d[1]);
            const double    sign = facing * d[1] >= 0.0 ? 1.0 : -1.0;
            // Toward the tongue.
            const PixelType lingual = { { -sign * d[1] / n, sign * d[0] / n } };
            for (PixelType & p : outline.drawn)
            {
              const PixelType r = { { p[0] - middle.tip[0], p[1] - middle.tip[1] } };
              const double    depth = r[0] * lingual[0] + r[1] * lingual[1];
              const double    t = (r[0] * d[0] + r[1] * d[1]) / (n * n);
              if (depth > 0.0 && t > 0.0 && t < 1.0)
              {
                // Grows from the axis to the border, so that the line stays smooth.
                const double w = 4.0 * t * (1.0 - t) * std::min(1.0, depth * spacing / 2.0);
                p[0] += w * bulge * lingual[0];
                p[1] += w * bulge * lingual[1];
              }
            }
          }
          outline.slip = hand.DrawOutline(item);
          DentalPhantomHand::Apply(outline.slip, outline.drawn);
          std::vector<DentalPhantomTracer::Polyline> lines(1);
          lines[0].fdi = outline.fdi;
          lines[0].points = outline.drawn;
          DentalPhantomTracer::Noise noise;
          noise.correlated = level.correlatedNoise;
          noise.white = level.whiteNoise;
          noise.correlationLength = CorrelationLength;
          if (usesTemplates)
          {
            // A stock outline has no hand's drift: it is placed wrongly, and that is all.
            noise.correlated = 0.0;
            noise.white = 0.0;
          }
          DentalPhantomTracer::AddNoise(lines, noise, seed, DriftStream + 2 * jaw + (molar ? 1 : 0));
          outline.drawn = lines[0].points;
          m_Outlines[jaw].push_back(outline);
        }
      }

      const auto give = [&](const std::string & name, const PixelType & exact, unsigned int kind) {
        Landmark landmark;
        landmark.name = name;
        landmark.exact = exact;
        landmark.slip = hand.DrawLandmark(item, kind);
        for (unsigned int d = 0; d < 2; ++d)
        {
          landmark.drawn[d] = std::nearbyint(1e3 * (exact[d] + landmark.slip.shift[d])) / 1e3;
        }
        m_Landmarks.push_back(landmark);
      };
      if (molar && level.molarLandmark == "contact")
      {
        give(jaw == 0 ? "Ms" : "Mi", middle.contact, 1);
      }
      else
      {
        give(prefix + (molar ? "6_MB" : "1_tip"), middle.tip, 0);
      }
      if (!molar && level.giveApices)
      {
        give(prefix + "1A", middle.apex, 2);
      }
    }
  }
}
} // namespace itk

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
#include "itkDentalPhantomOutline.h"

#include "itkContourExtractor2DImageFilter.h"
#include "itkImage.h"
#include "itkParallelFor.h"
#include "itkInvertedProjection.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using PointType = DentalPhantomModel::PointType;
} // namespace

auto
DentalPhantomOutline::Trace(const DentalPhantomModel &    model,
                            unsigned int                  jaw,
                            unsigned int                  tooth,
                            const PerspectiveProjection & projection,
                            bool                          whole,
                            double                        step,
                            unsigned int                  threads) -> std::vector<PixelType>
{
  const DentalPhantomToothBody & body = model.GetDentition().GetBody(jaw, tooth);
  if (!body.present)
  {
    return {};
  }
  // The box of the tooth's corners in the picture.
  const double low[3] = { -0.75 * body.width, -0.85 * body.depth, whole ? -19.5 : -1.5 };
  const double high[3] = { 0.75 * body.width, 0.75 * body.depth, body.height + 0.8 };
  double       box[4] = { 1e9, 1e9, -1e9, -1e9 };
  const double flip = jaw == 0 ? -1.0 : 1.0;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    PointType p = body.ToJaw({ { (corner & 1u) != 0 ? high[0] : low[0],
                                 (corner & 2u) != 0 ? high[1] : low[1],
                                 (corner & 4u) != 0 ? high[2] : low[2] } });
    p[2] *= flip;
    double u = 0.0;
    double v = 0.0;
    projection.Project(p.data(), u, v);
    box[0] = std::min(box[0], u);
    box[1] = std::min(box[1], v);
    box[2] = std::max(box[2], u);
    box[3] = std::max(box[3], v);
  }
  const int    nu = static_cast<int>((box[2] - box[0]) / step) + 5;
  const int    nv = static_cast<int>((box[3] - box[1]) / step) + 5;
  const double u0 = box[0] - 2.0 * step;
  const double v0 = box[1] - 2.0 * step;

  using ImageType = Image<float, 2>;
  auto image = ImageType::New();
  image->SetRegions(ImageType::SizeType{ { static_cast<SizeValueType>(nu), static_cast<SizeValueType>(nv) } });
  image->Allocate();
  const auto      inverse = InvertedProjection(projection);
  const auto      toLocal = [&](const PointType & p) { return body.ToLocal({ { p[0], p[1], flip * p[2] } }); };
  const PointType source = toLocal(projection.source);
  ParallelFor(static_cast<std::size_t>(nv), threads, [&](std::size_t row) {
    const double v = v0 + step * static_cast<double>(row);
    for (int column = 0; column < nu; ++column)
    {
      const double u = u0 + step * column;
      PointType    d{};
      for (unsigned int k = 0; k < 3; ++k)
      {
        d[k] = inverse[3 * k] * u + inverse[3 * k + 1] * v + inverse[3 * k + 2];
      }
      PointType direction{};
      for (unsigned int k = 0; k < 3; ++k)
      {
        direction[k] = body.axes[k][0] * d[0] + body.axes[k][1] * d[1] + body.axes[k][2] * flip * d[2];
      }
      // Where the ray is in the box of the tooth.
      double begin = 0.0;
      double end = 1e300;
      for (unsigned int k = 0; k < 3; ++k)
      {
        const double a = (low[k] - source[k]) / direction[k];
        const double b = (high[k] - source[k]) / direction[k];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
      }
      double smallest = 3.0;
      if (begin < end)
      {
        const double norm =
          std::sqrt(direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]);
        const auto value = [&](double t) {
          const PointType p = {
            { source[0] + t * direction[0], source[1] + t * direction[1], source[2] + t * direction[2] }
          };
          return whole ? body.EvaluateWhole(p) : body.Evaluate(p, false);
        };
        const int    n = std::max(3, static_cast<int>((end - begin) * norm / 0.5));
        const double h = (end - begin) / n;
        double       at = begin;
        for (int i = 0; i <= n; ++i)
        {
          const double f = value(begin + i * h);
          if (f < smallest)
          {
            smallest = f;
            at = begin + i * h;
          }
        }
        for (double s = 0.5 * h; s > 0.02 * h; s *= 0.5)
        {
          for (const double t : { at - s, at + s })
          {
            const double f = value(t);
            if (f < smallest)
            {
              smallest = f;
              at = t;
            }
          }
        }
      }
      image->SetPixel({ { column, static_cast<IndexValueType>(row) } }, static_cast<float>(smallest));
    }
  });
  using ExtractorType = ContourExtractor2DImageFilter<ImageType>;
  auto extractor = ExtractorType::New();
  extractor->SetInput(image);
  extractor->SetContourValue(0.0);
  extractor->Update();
  std::vector<PixelType> longest;
  for (unsigned int i = 0; i < extractor->GetNumberOfOutputs(); ++i)
  {
    if (extractor->GetOutput(i) == nullptr)
    {
      continue;
    }
    const auto * vertices = extractor->GetOutput(i)->GetVertexList();
    if (vertices->Size() > longest.size())
    {
      longest.clear();
      for (const auto & vertex : vertices->CastToSTLConstContainer())
      {
        longest.push_back({ { u0 + step * vertex[0], v0 + step * vertex[1] } });
      }
    }
  }
  if (longest.size() > 1)
  {
    // A closed line repeats its first vertex.
    longest.pop_back();
  }
  return longest;
}

auto
DentalPhantomOutline::Resample(const std::vector<PixelType> & closed, std::size_t numberOfPoints)
  -> std::vector<PixelType>
{
  std::vector<PixelType> result;
  if (closed.size() < 3)
  {
    return result;
  }
  std::vector<double> sum{ 0.0 };
  for (std::size_t i = 0; i < closed.size(); ++i)
  {
    const auto & a = closed[i];
    const auto & b = closed[(i + 1) % closed.size()];
    sum.push_back(sum.back() + std::hypot(b[0] - a[0], b[1] - a[1]));
  }
  std::size_t i = 0;
  for (std::size_t k = 0; k < numberOfPoints; ++k)
  {
    const double wanted = sum.back() * static_cast<double>(k) / static_cast<double>(numberOfPoints);
    while (i + 1 < closed.size() && sum[i + 1] < wanted)
    {
      ++i;
    }
    const auto & a = closed[i];
    const auto & b = closed[(i + 1) % closed.size()];
    const double t = (wanted - sum[i]) / std::max(sum[i + 1] - sum[i], 1e-12);
    result.push_back({ { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) } });
  }
  return result;
}
} // namespace itk

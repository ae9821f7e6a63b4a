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
#ifndef itkDentalPhantomTestCase_h
#define itkDentalPhantomTestCase_h

#include "itkDentalPhantomCaseSource.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

/** Cases whose scans are measured: in the anatomical frame (x anterior, y left, z superior), without a picture. */
namespace DentalPhantomTestCase
{
using CaseType = itk::DentalPhantomCaseSource;
using LevelType = itk::DentalPhantomLevel;
using PointType = std::array<double, 3>;

/** A typical case with what a JSON text asks for. */
inline CaseType::Pointer
Make(std::uint64_t seed, const std::string & json, unsigned int triangles = 16000)
{
  LevelType level;
  level.ParseJson(json, "test");
  auto source = CaseType::New();
  source->SetLevel(level);
  source->SetSeed(seed);
  if (level.frame == "shared")
  {
    source->SetFrame(CaseType::FrameEnum::Anatomical);
  }
  if (level.numberOfTriangles == LevelType().numberOfTriangles)
  {
    source->SetNumberOfTriangles(triangles);
  }
  source->SetMakeRadiograph(false);
  source->Update();
  return source;
}

inline const itk::DentalPhantomTrait *
Find(const CaseType * source, const std::string & name)
{
  for (const auto & trait : source->GetTraits())
  {
    if (trait.name == name)
    {
      return &trait;
    }
  }
  return nullptr;
}

/** The vertices with an FDI number. */
inline std::vector<PointType>
Crown(CaseType * source, unsigned int fdi)
{
  std::vector<PointType> points;
  const auto *           mesh = source->GetMesh(fdi / 10 > 2 ? 1 : 0);
  for (itk::IdentifierType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    float label = 0.0f;
    mesh->GetPointData(i, &label);
    if (static_cast<unsigned int>(label) == fdi)
    {
      const auto p = mesh->GetPoint(i);
      points.push_back({ { p[0], p[1], p[2] } });
    }
  }
  return points;
}

inline std::set<unsigned int>
Teeth(CaseType * source, unsigned int jaw)
{
  std::set<unsigned int> teeth;
  for (auto it = source->GetMesh(jaw)->GetPointData()->Begin(); it != source->GetMesh(jaw)->GetPointData()->End(); ++it)
  {
    teeth.insert(static_cast<unsigned int>(it.Value()));
  }
  teeth.erase(0);
  return teeth;
}

inline PointType
Landmark(CaseType * source, const std::string & name)
{
  const auto * landmark = source->GetLandmarks3D(name[0] == 'U' ? 0 : 1)->Find(name);
  if (landmark == nullptr)
  {
    throw std::runtime_error("no landmark " + name);
  }
  return { { landmark->point[0], landmark->point[1], landmark->point[2] } };
}

/** The smallest distance between two crowns, mm. */
inline double
Gap(CaseType * source, unsigned int first, unsigned int second)
{
  double     best = 1e9;
  const auto a = Crown(source, first);
  const auto b = Crown(source, second);
  for (const auto & p : a)
  {
    for (const auto & q : b)
    {
      best = std::min(best, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
  }
  return best;
}

/** The largest horizontal extent of a crown, mm. */
inline double
Extent(CaseType * source, unsigned int fdi)
{
  double     best = 0.0;
  const auto a = Crown(source, fdi);
  for (const auto & p : a)
  {
    for (const auto & q : a)
    {
      best = std::max(best, std::hypot(p[0] - q[0], p[1] - q[1]));
    }
  }
  return best;
}
} // namespace DentalPhantomTestCase

#endif

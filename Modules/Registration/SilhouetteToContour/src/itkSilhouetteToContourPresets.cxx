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
#include "itkSilhouetteToContourPresets.h"

#include "itkMath.h"

namespace itk
{
namespace
{
using PresetEnum = SilhouetteToContourPresetEnum;

struct RowType
{
  PresetEnum   preset;
  double       scale;
  double       degrees;
  double       millimetres;
  unsigned int scales;
  unsigned int rotations;
  unsigned int translations;
  unsigned int starts;
  std::size_t  iterations;
};

// Bounds on scale, rotation and shift; candidates of scale, rotation and shift an axis; starts; iterations.
// clang-format off
constexpr RowType Rows[] = {
  { PresetEnum::Paper,       0.35, 20.0, 15.0,  5, 5, 7,  4,  60 },
  { PresetEnum::Paper,       0.10,  6.0,  3.75, 0, 0, 0,  1, 100 },
  { PresetEnum::Paper,       0.03,  2.0,  1.0,  0, 0, 0,  1, 200 },
  { PresetEnum::SingleStage, 0.35, 20.0, 15.0,  0, 0, 0,  1,  80 },
  { PresetEnum::Global,      0.5,  45.0, 15.0,  5, 9, 5,  4,  15 },
  { PresetEnum::Global,      0.10,  6.0,  3.75, 0, 0, 0,  1, 100 },
};
// clang-format on
} // namespace

std::vector<SilhouetteToContourLevel>
MakePresetLevels(SilhouetteToContourPresetEnum preset)
{
  std::vector<SilhouetteToContourLevel> levels;
  for (const RowType & row : Rows)
  {
    if (row.preset == preset)
    {
      SilhouetteToContourLevel level;
      level.scaleBound = row.scale;
      level.rotationBound = row.degrees * (Math::pi / 180.0);
      level.translationBound = row.millimetres;
      level.numberOfScales = row.scales;
      level.numberOfRotations = row.rotations;
      level.numberOfTranslations = row.translations;
      level.numberOfStarts = row.starts;
      level.numberOfIterations = row.iterations;
      levels.push_back(level);
    }
  }
  return levels;
}
} // namespace itk

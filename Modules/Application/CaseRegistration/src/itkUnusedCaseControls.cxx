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
#include "itkUnusedCaseControls.h"

#include "itkDentalCaseFileReader.h"

#include <utility>

namespace itk
{
namespace
{
/** Of the presets that register one contour with another by a similarity. */
std::vector<std::string>
OfSimilarities(const DentalCaseData & data, CasePresetEnum preset, const CaseControls & controls)
{
  const DentalCase & description = data.description;
  const std::string  name = ToString(preset);
  std::string        options;
  for (const std::string & option : controls.options)
  {
    options += (options.empty() ? "" : ", ") + option;
  }
  const bool isLabelled = !description.upperLabelsFile.empty() || !description.lowerLabelsFile.empty();
  const bool isFixed = description.fixScale || description.fixRotation || description.fixTranslation;
  const std::vector<std::pair<bool, std::string>> controlsAndWords{
    { !data.views.empty(),
      "\"views\" are not used by preset " + name + ", which registers with one radiograph: use preset robust" },
    { data.cephalometricLandmarks.IsNotNull(),
      "\"cephalometric_landmarks\" are not used by preset " + name + ", which registers contours: use preset robust" },
    { description.initialPose.has_value() || !description.initialPlacements.empty(),
      "\"init.pose\" is not used by preset " + name + ": it starts from a similarity" },
    { description.crowns != CrownsEnum::Off,
      std::string("\"crowns\": \"") + ToString(description.crowns) + "\" is not used by preset " + name +
        ", which takes the silhouette of the whole scan: use preset robust" },
    { isLabelled && description.crowns == CrownsEnum::Off,
      "tooth labels of the scans are not used by preset " + name +
        ", which takes the silhouette of the whole scan: use preset robust" },
    { isFixed && preset == CasePresetEnum::BoundingBox,
      "\"fix\" changes nothing with preset " + name +
        ", whose result is its start: use preset paper, single-stage or robust" },
    { !controls.options.empty(),
      options + ": options of preset robust, which are not used by preset " + name + ": use preset robust" },
    { controls.hasPoseMethodCallback,
      "the callback for the method is not called by preset " + name + ", which has another one: use preset robust" }
  };
  std::vector<std::string> sentences;
  for (const auto & entry : controlsAndWords)
  {
    if (entry.first)
    {
      sentences.push_back(entry.second);
    }
  }
  return sentences;
}
} // namespace

std::vector<std::string>
DescribeUnusedControls(const DentalCaseData & data, CasePresetEnum preset, const CaseControls & controls)
{
  if (preset != CasePresetEnum::Robust)
  {
    return OfSimilarities(data, preset, controls);
  }
  if (!controls.useSurfaceDRR)
  {
    return {
      "the silhouette's source is a choice of the paper's presets and not used by preset robust, which takes its "
      "outlines from the mesh: leave it out, or use preset paper"
    };
  }
  return {};
}
} // namespace itk

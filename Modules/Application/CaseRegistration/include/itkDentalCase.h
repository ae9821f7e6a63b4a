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
#ifndef itkDentalCase_h
#define itkDentalCase_h

#include "itkCephalometricGeometry.h"
#include "itkDentalRadiograph.h"
#include "itkDentalView.h"
#include "itkToothCode.h"
#include "itkTracedSide.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** Whether upper and lower mesh share one frame in occlusion. */
enum class OcclusionEnum : uint8_t
{
  Yes,
  No,
  Check
};

/** What of the scans preset robust fits. */
enum class CrownsEnum : uint8_t
{
  /** All of the traced side. */
  Off,
  /** The crowns by the tooth labels of the scan. */
  Labels,
  /** The crowns by shape. */
  Shape
};

/** A similarity in pixels on the geometry's own projection: p = scale R(rotation) q + translation. */
struct SimilarityParameters
{
  double                scale{ 1.0 };                /**< Factor. */
  double                rotation{ 0.0 };             /**< Radians, from u towards v. */
  std::array<double, 2> translation{ { 0.0, 0.0 } }; /**< Pixels, (u, v). */
};

/** \struct DentalCase
 * \brief One patient as a case file says it: scans, the lateral radiograph, further views, manual control.
 *
 * Documentation/FileFormats.md is the contract. Nothing is defaulted here but what the contract defaults: an absent
 * optional is unknown. Paths are as they can be opened from the current directory.
 *
 * \ingroup CaseRegistration
 */
struct DentalCase : public DentalRadiograph
{
  /** The case file itself, for messages. */
  std::string fileName;
  /** SHA-256 of its bytes as they were read, 64 hexadecimal digits; "" for a case of no file. */
  std::string fileSHA256;

  std::string upperFile;        /**< Scan of the upper jaw; "" where there is none. */
  std::string lowerFile;        /**< Scan of the lower jaw; "" where there is none. */
  std::string meshUnit{ "mm" }; /**< Unit of both scans: mm, cm, m, um or inch. */
  /** mm in one unit of the mesh files. */
  double        millimetresPerUnit{ 1.0 };
  OcclusionEnum occlusion{ OcclusionEnum::Check };
  /** Tooth labels by point; "" where none are named. A scan may carry its own. */
  std::string upperLabelsFile;
  std::string lowerLabelsFile;
  CrownsEnum  crowns{ CrownsEnum::Off };

  /** Masks or drawn lines of one tooth or jaw each, in place of contoursFile: code and file. */
  std::vector<std::pair<std::string, std::string>> contourClassFiles;
  TracedSideEnum                                   tracedSide{ TracedSideEnum::Right };
  /** Where the side is not given, and Right, what was drawn may say that it is Standard. */
  bool                                    tracedSideIsGiven{ false };
  std::optional<ToothCode::NumberingEnum> numbering;
  std::string                             landmarks3DFile;
  /** Outlines of whole teeth that the reader's software offers, which tell templates. */
  std::string stockOutlinesFile;

  /** Radiographs beside the lateral one. */
  std::vector<DentalView> views;

  /** Where a jaw starts instead of a search, as an earlier result has it. */
  struct PlacementType
  {
    /** Mesh (mm) to cephalostat frame, row-major 3x4. */
    std::array<double, 12> meshToCephalostat{};
    /** Factor on the geometry's magnification. */
    double scale{ 1.0 };
  };

  /** Manual control. The key is the jaw. */
  std::map<ToothCode::JawEnum, SimilarityParameters> initialSimilarity;
  /** Mesh (mm) to cephalostat frame, row-major 3x4, for all jaws. */
  std::optional<std::array<double, 12>> initialPose;
  /** Before the others, for the jaws that it has. */
  std::map<ToothCode::JawEnum, PlacementType> initialPlacements;
  /** The geometry that these placements are of, which the case's own may differ from. */
  CephalometricGeometry::ConstPointer initialGeometry;

  /** Whether any jaw is to start somewhere. */
  bool
  HasStart() const
  {
    return initialPose.has_value() || !initialSimilarity.empty() || !initialPlacements.empty();
  }
  std::vector<ToothCode> excludedTeeth;
  bool                   fixScale{ false };
  bool                   fixRotation{ false };
  bool                   fixTranslation{ false };

  /** What the file has that is not understood or looks odd, a line each. */
  std::vector<std::string> warnings;
};
} // namespace itk

#endif

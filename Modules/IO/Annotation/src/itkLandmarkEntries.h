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
#ifndef itkLandmarkEntries_h
#define itkLandmarkEntries_h

#include "itkJsonDocument.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** One landmark as JSON of no program in particular has it; not installed. */
struct LandmarkEntry
{
  JsonNode node;
  /** What it is called, the most telling first: a list's entry may have a symbol beside a title. */
  std::vector<std::string> names;
  /** Whether it stands in a list, and not under its name. */
  bool isListed{ false };
};

/** The landmarks of JSON that a script or a small program wrote: by name, {"U1_tip": ...}, or as a list, [{"name":
 * "U1_tip", ...}, ["U1_tip", u, v]], either one alone or under "landmarks", "points" or "keypoints" beside other
 * things. Throws DentalInputError where the file says that its coordinates are no pixels.
 *
 * \param dimension 2 of the radiograph, 3 of a scan */
std::vector<LandmarkEntry>
FindLandmarkEntries(const JsonNode & root, unsigned int dimension);

/** Whether JSON holds landmarks as a list. */
bool
HasListOfLandmarks(const JsonNode & root);

/** Whether the value has the form of a place at all, as what stands beside landmarks has not. */
bool
IsLandmarkPlace(const JsonNode & node);

/** Where an entry says that the landmark lies: [u, v], {"x": u, "y": v} or {"u": u, "v": v}, or one of these as its
 * "position", "point", "coordinates" or the like. Nothing where it says null. Throws DentalInputError where it says
 * nothing or no numbers.
 *
 * \param missing The member that an error asks for */
std::optional<std::array<double, 3>>
ReadLandmarkPlace(const JsonNode & node, unsigned int dimension, const char * missing);
} // namespace itk

#endif

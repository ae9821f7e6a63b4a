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
#include "itkLandmarkEntries.h"

#include "itkLowerCase.h"

#include <algorithm>

namespace itk
{
namespace
{
constexpr const char * Lists[] = { "landmarks", "points", "keypoints" };
constexpr const char * Names[] = { "symbol", "name", "label", "title", "landmark", "landmark_name", "code" };
constexpr const char * Places[] = { "position", "point", "coordinates", "coordinate", "coords",
                                    "location", "pos",   "xy",          "xyz",        "value" };
/** Of three axes. */
constexpr const char * Coordinates[][3] = { { "x", "u", "X" }, { "y", "v", "Y" }, { "z", "z", "Z" } };

std::optional<JsonNode>
FindAxis(const JsonNode & place, unsigned int axis)
{
  std::optional<JsonNode> found;
  for (const char * const name : Coordinates[axis])
  {
    const auto member = place.Find(name);
    // Of "x" in mm and "u" in pixels nothing says which is meant. That "z" is tried twice is no contradiction.
    if (member && found && member->IsNumber() && found->IsNumber() && member->AsNumber() != found->AsNumber())
    {
      member->Fail("is another coordinate than \"" + std::string(Coordinates[axis][0]) + "\"",
                   "keep the coordinates in pixels alone");
    }
    found = found ? found : member;
  }
  return found;
}

/** Whether an entry says that its landmark is not there, as detectors and programs for skeletons write it, often with a
 * place at 0, 0. */
bool
SaysItIsMissing(const JsonNode & entry)
{
  const auto says = [&entry](const char * name, bool value) {
    const auto member = entry.Find(name);
    return member && ((member->GetKind() == JsonNode::KindEnum::Boolean && member->AsBoolean() == value) ||
                      (member->IsNumber() && (member->AsNumber() != 0.0) == value));
  };
  return says("visible", false) || says("visibility", false) || says("detected", false) || says("missing", true) ||
         says("outside", true);
}

/** Throws where a place of a radiograph has a depth, or is the corner of a box: both would be read as another point. */
void
VerifyIsPointOfPicture(const JsonNode & entry, const JsonNode & place, const std::array<double, 3> & point)
{
  const auto depth = FindAxis(place, 2);
  if (depth && depth->IsNumber() && depth->AsNumber() != 0.0)
  {
    depth->Fail("is a third coordinate, and points of a radiograph have two",
                "name the landmarks of a scan as \"landmarks_3d\", or leave it out");
  }
  constexpr const char * sizes[][2] = { { "width", "w" }, { "height", "h" } };
  for (unsigned int i = 0; i < 2; ++i)
  {
    for (const char * const name : sizes[i])
    {
      const auto size = entry.Find(name);
      // The picture's size would hold the place.
      if (size && size->IsNumber() && point[i] > size->AsNumber())
      {
        size->Fail("is the size of a box, of which x and y are a corner",
                   "write the middle of each box, and leave its size out");
      }
    }
  }
}

/** The member of an entry that is its place; the entry itself where it has none. */
JsonNode
FindPlace(const JsonNode & entry)
{
  for (const char * const name : Places)
  {
    const auto member = entry.Find(name);
    if (member && (member->IsArray() || member->IsObject() || member->IsNull()))
    {
      return *member;
    }
  }
  return entry;
}

/** Throws where the object says that what it holds is not in pixels: nothing else would tell a file in mm. */
void
VerifyUnit(const JsonNode & node)
{
  for (const char * const name : { "unit", "units", "coordinate_unit", "coordinateUnits" })
  {
    const auto        unit = node.Find(name);
    const std::string word = unit && unit->IsString() ? LowerCase(unit->AsString()) : std::string();
    if (!word.empty() && word != "px" && word != "pixel" && word != "pixels")
    {
      unit->Fail("is \"" + unit->AsString().substr(0, 40) + "\"", "convert the coordinates to pixels");
    }
  }
  const auto normalized = node.Find("normalized");
  if (normalized && normalized->GetKind() == JsonNode::KindEnum::Boolean && normalized->AsBoolean())
  {
    normalized->Fail("is true: coordinates are shares of the picture's size",
                     "multiply x by its width and y by its height");
  }
}

void
AppendEntries(const JsonNode & holder, std::vector<LandmarkEntry> & entries)
{
  const auto append = [&entries](const JsonNode & node, const std::string & key, bool isListed) {
    LandmarkEntry entry{ node, {}, isListed };
    if (node.IsObject())
    {
      for (const char * const name : Names)
      {
        const auto member = node.Find(name);
        if (member && member->IsString())
        {
          entry.names.push_back(member->AsString());
        }
      }
      const auto id = node.Find("id");
      // A number of its own kind, "L6" of a sixth landmark, where something else is the name.
      if (isListed && entry.names.empty() && id && id->IsString())
      {
        entry.names.push_back(id->AsString());
      }
    }
    else if (isListed && node.IsArray() && node.GetSize() > 1 && node.At(0).IsString())
    {
      entry.names.push_back(node.At(0).AsString());
    }
    if (!isListed)
    {
      // A name that is the entry's own says more than a number that it stands under, and is the same otherwise.
      entry.names.push_back(key);
    }
    entries.push_back(std::move(entry));
  };
  if (holder.IsArray())
  {
    for (std::size_t i = 0; i < holder.GetSize(); ++i)
    {
      append(holder.At(i), std::string(), true);
    }
    return;
  }
  for (const auto & [name, node] : holder.GetMembers())
  {
    append(node, name, false);
  }
}

std::optional<JsonNode>
FindList(const JsonNode & root)
{
  for (const char * const name : Lists)
  {
    const auto member = root.IsObject() ? root.Find(name) : std::nullopt;
    if (member && (member->IsArray() || member->IsObject()))
    {
      return member;
    }
  }
  return std::nullopt;
}
} // namespace

std::vector<LandmarkEntry>
FindLandmarkEntries(const JsonNode & root, unsigned int dimension)
{
  // Places alone say nothing of what lies there.
  const auto hasNames = [](const JsonNode & entry) {
    return entry.IsObject() || (entry.IsArray() && entry.GetSize() > 1 && entry.At(0).IsString());
  };
  if (!root.IsObject() && !(root.IsArray() && root.GetSize() > 0 && hasNames(root.At(0))))
  {
    root.Fail("is no JSON object",
              dimension == 2 ? R"(landmarks are {"U1_tip": [u, v], "L1_tip": [u, v]})"
                             : R"(landmarks are {"UR1_tip": [x, y, z], "UR6_MB": [x, y, z]})");
  }
  std::vector<LandmarkEntry> entries;
  const auto                 list = FindList(root);
  AppendEntries(list ? *list : root, entries);
  if (dimension == 2)
  {
    for (const JsonNode & node : { root, list ? *list : root })
    {
      if (node.IsObject())
      {
        VerifyUnit(node);
      }
    }
    for (const char * const name : { "metadata", "meta", "info", "image" })
    {
      const auto about = list && root.IsObject() ? root.Find(name) : std::nullopt;
      if (about && about->IsObject())
      {
        VerifyUnit(*about);
      }
    }
    for (const LandmarkEntry & entry : entries)
    {
      if (entry.node.IsObject())
      {
        VerifyUnit(entry.node);
      }
    }
  }
  return entries;
}

bool
HasListOfLandmarks(const JsonNode & root)
{
  const auto list = FindList(root);
  return list ? list->IsArray() : root.IsArray();
}

bool
IsLandmarkPlace(const JsonNode & node)
{
  if (!node.IsObject())
  {
    return node.IsArray() || node.IsNumber();
  }
  const JsonNode place = FindPlace(node);
  return !place.IsObject() || FindAxis(place, 0);
}

std::optional<std::array<double, 3>>
ReadLandmarkPlace(const JsonNode & node, unsigned int dimension, const char * missing)
{
  std::array<double, 3> point{ { 0.0, 0.0, 0.0 } };
  const JsonNode        place = node.IsObject() ? FindPlace(node) : node;
  if (place.IsNull() || (node.IsObject() && SaysItIsMissing(node)))
  {
    return std::nullopt;
  }
  if (place.IsObject())
  {
    std::vector<JsonNode> axes;
    for (unsigned int i = 0; i < dimension; ++i)
    {
      const auto axis = FindAxis(place, i);
      axes.push_back(axis ? *axis : place.Get(axes.empty() && missing != nullptr ? missing : Coordinates[i][0]));
    }
    if (std::any_of(axes.begin(), axes.end(), [](const JsonNode & axis) { return axis.IsNull(); }))
    {
      return std::nullopt;
    }
    std::transform(axes.begin(), axes.end(), point.begin(), [](const JsonNode & axis) { return axis.AsNumber(); });
    if (dimension == 2)
    {
      VerifyIsPointOfPicture(node, place, point);
    }
    return point;
  }
  // ["U1_tip", u, v]
  const bool named = place.IsArray() && place.GetSize() == dimension + 1 && place.At(0).IsString();
  if (named)
  {
    for (unsigned int i = 0; i < dimension; ++i)
    {
      point[i] = place.At(i + 1).AsNumber();
    }
    return point;
  }
  const std::vector<double> numbers =
    place.AsNumbers(dimension, dimension == 2 ? R"([u, v] or {"position": [u, v], "sigma_px": s})" : "[x, y, z]");
  std::copy(numbers.begin(), numbers.end(), point.begin());
  return point;
}
} // namespace itk

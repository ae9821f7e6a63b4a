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
#include "itkForeignAnnotationRecords.h"

#include "itkAnnotationText.h"
#include "itkDentalInputError.h"
#include "itkJsonDocument.h"
#include "itkLabelImageRecords.h"
#include "itkLowerCase.h"
#include "itkRunLengthMask.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace itk
{
namespace
{
using Format = AnnotationFileFormatEnum;
using PointsType = std::vector<std::array<double, 3>>;

/** The last part of a path or address. */
std::string
FileNameOf(const std::string & path)
{
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

/** The member as text, a whole number in digits; "" where there is neither. */
std::string
FindText(const JsonNode & node, const char * key)
{
  const auto member = node.Find(key);
  if (member && member->IsString())
  {
    return member->AsString();
  }
  // From 2^53 on not every whole number is one of floating point.
  constexpr double limit = 9007199254740992.0;
  const double     number = member && member->IsNumber() ? member->AsNumber() : limit;
  return std::abs(number) < limit && number == std::floor(number) ? std::to_string(static_cast<int64_t>(number))
                                                                  : std::string();
}

void
TakeImageSize(const JsonNode & width, const JsonNode & height, AnnotationRecords & records)
{
  records.imageSizeField = width.GetPath();
  records.imageSize = { static_cast<std::size_t>(width.AsInteger(1, MaximumImageSize)),
                        static_cast<std::size_t>(height.AsInteger(1, MaximumImageSize)) };
}

/** Points in pairs [x, y]. */
PointsType
ReadPairs(const JsonNode & node)
{
  PointsType points;
  for (std::size_t i = 0; i < node.GetSize(); ++i)
  {
    const std::vector<double> point = node.At(i).AsNumbers(2, "[x, y]");
    points.push_back({ { point[0], point[1], 0.0 } });
  }
  return points;
}

void
AddPolyline(
  const JsonNode & node, const std::string & label, bool closed, PointsType points, AnnotationRecords & records)
{
  AnnotationPolyline polyline;
  polyline.field = node.GetPath();
  polyline.codeField = node.GetPath();
  polyline.label = label;
  polyline.closed = closed;
  polyline.points = std::move(points);
  records.polylines.push_back(std::move(polyline));
}

void
AddLandmark(const JsonNode & node, const std::string & label, double x, double y, AnnotationRecords & records)
{
  records.landmarks.push_back({ node.GetPath(), label, { { x, y, 0.0 } } });
}

// ---- COCO ---------------------------------------------------------------------------------------------------------

struct Category
{
  std::string              name;
  std::vector<std::string> keypoints;
};

/** x1, y1, x2, y2, ... */
PointsType
ReadFlatPolygon(const JsonNode & node)
{
  if (node.GetSize() % 2 != 0)
  {
    node.Fail("has an odd number of coordinates", "export the polygons again");
  }
  PointsType points;
  for (std::size_t i = 0; i + 1 < node.GetSize(); i += 2)
  {
    points.push_back({ { node.At(i).AsNumber(), node.At(i + 1).AsNumber(), 0.0 } });
  }
  return points;
}

void
ReadKeypoints(const JsonNode & annotation, const Category & category, AnnotationRecords & records)
{
  const auto keypoints = annotation.Find("keypoints");
  if (!keypoints || keypoints->IsNull())
  {
    return;
  }
  const std::size_t count = category.keypoints.size();
  if (keypoints->GetSize() != 3 * count)
  {
    keypoints->Fail("has " + std::to_string(keypoints->GetSize()) + " numbers, and its category names " +
                      std::to_string(count) + " points of three",
                    "export categories with their \"keypoints\", and of each point x, y and visibility");
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    // Visibility 0: nobody marked it.
    if (keypoints->At(3 * i + 2).AsNumber() > 0.0)
    {
      AddLandmark(keypoints->At(3 * i),
                  category.keypoints[i],
                  keypoints->At(3 * i).AsNumber(),
                  keypoints->At(3 * i + 1).AsNumber(),
                  records);
    }
  }
}

void
ReadCOCO(const JsonNode & root, const std::string & imageName, AnnotationRecords & records)
{
  std::map<int64_t, Category> categories;
  const JsonNode              list = root.Get("categories");
  for (std::size_t i = 0; i < list.GetSize(); ++i)
  {
    Category category{ list.At(i).Get("name").AsString(), {} };
    if (const auto keypoints = list.At(i).Find("keypoints"))
    {
      for (std::size_t j = 0; j < keypoints->GetSize(); ++j)
      {
        category.keypoints.push_back(keypoints->At(j).AsString());
      }
    }
    categories[list.At(i).Get("id").AsInteger(INT64_MIN, INT64_MAX)] = category;
  }
  const JsonNode           images = root.Get("images");
  std::vector<std::string> names;
  for (std::size_t i = 0; i < images.GetSize(); ++i)
  {
    names.push_back(FindText(images.At(i), "file_name"));
  }
  const JsonNode image = images.At(ChooseImage(root.GetFileName(), "images", names, imageName));
  TakeImageSize(image.Get("width"), image.Get("height"), records);
  const int64_t  imageId = image.Get("id").AsInteger(INT64_MIN, INT64_MAX);
  const JsonNode annotations = root.Get("annotations");
  for (std::size_t i = 0; i < annotations.GetSize(); ++i)
  {
    const JsonNode annotation = annotations.At(i);
    if (annotation.Get("image_id").AsInteger(INT64_MIN, INT64_MAX) != imageId)
    {
      continue;
    }
    const JsonNode id = annotation.Get("category_id");
    const auto     category = categories.find(id.AsInteger(INT64_MIN, INT64_MAX));
    if (category == categories.end())
    {
      id.Fail("names no category of the file", "export the categories too");
    }
    ReadKeypoints(annotation, category->second, records);
    const auto segmentation = annotation.Find("segmentation");
    if (segmentation && segmentation->IsObject())
    {
      const RunLengthMask mask(*segmentation, *records.imageSize);
      if (AppendMaskOutlines(
            mask.GetImage(), mask.GetOffset(), segmentation->GetPath(), category->second.name, records))
      {
        segmentation->Warn("specks are left out beside the mask");
      }
    }
    else if (segmentation && !segmentation->IsNull())
    {
      for (std::size_t j = 0; j < segmentation->GetSize(); ++j)
      {
        AddPolyline(segmentation->At(j), category->second.name, true, ReadFlatPolygon(segmentation->At(j)), records);
      }
    }
  }
}

// ---- VGG Image Annotator ------------------------------------------------------------------------------------------

/** The metadata of all pictures: of a project in a member, of an export the root itself. */
JsonNode
FindVIAImages(const JsonNode & root)
{
  const auto project = root.Find("_via_img_metadata");
  return project ? *project : root;
}

PointsType
ReadTwoLists(const JsonNode & xs, const JsonNode & ys)
{
  if (xs.GetSize() != ys.GetSize())
  {
    ys.Fail("has another number of values than all_points_x", "export the annotations again");
  }
  PointsType points;
  for (std::size_t i = 0; i < xs.GetSize(); ++i)
  {
    points.push_back({ { xs.At(i).AsNumber(), ys.At(i).AsNumber(), 0.0 } });
  }
  return points;
}

} // namespace

void
ReadVIARegion(const JsonNode & region, AnnotationRecords & records)
{
  std::vector<std::string> labels;
  if (const auto attributes = region.Find("region_attributes"))
  {
    for (const auto & [name, value] : attributes->GetMembers())
    {
      if (value.IsString())
      {
        labels.push_back(value.AsString());
      }
      else if (value.IsObject())
      {
        // A check box: {"UR1": true}.
        for (const auto & [option, chosen] : value.GetMembers())
        {
          if (chosen.GetKind() == JsonNode::KindEnum::Boolean && chosen.AsBoolean())
          {
            labels.push_back(option);
          }
        }
      }
    }
  }
  const std::string label = ChooseLabel(labels);
  const JsonNode    shape = region.Get("shape_attributes");
  const std::string kind = shape.Get("name").AsString();
  if (kind == "polygon" || kind == "polyline")
  {
    AddPolyline(
      region, label, kind == "polygon", ReadTwoLists(shape.Get("all_points_x"), shape.Get("all_points_y")), records);
  }
  else if (kind == "point")
  {
    AddLandmark(region, ChoosePointLabel(labels), shape.Get("cx").AsNumber(), shape.Get("cy").AsNumber(), records);
  }
  else
  {
    region.Warn("a region of the shape " + kind + " is no contour, ignored");
  }
}

namespace
{
bool
IsVIA3(const JsonNode & root)
{
  return root.IsObject() && root.Find("metadata") && root.Find("file") && root.Find("view") && root.Find("attribute");
}

/** The texts of an attribute's value in version 3: what was written, or of choices, "0,2", what they are called. */
void
AppendVIA3Labels(const JsonNode &           attributes,
                 const std::string &        id,
                 const JsonNode &           value,
                 std::vector<std::string> & labels)
{
  if (!value.IsString())
  {
    return;
  }
  const auto attribute = attributes.IsObject() ? attributes.Find(id) : std::nullopt;
  const auto options = attribute && attribute->IsObject() ? attribute->Find("options") : std::nullopt;
  for (const std::string & choice : Split(value.AsString(), ','))
  {
    const auto option = options && options->IsObject() ? options->Find(choice) : std::nullopt;
    if (option && option->IsString())
    {
      labels.push_back(option->AsString());
    }
  }
  labels.push_back(value.AsString());
}

/** Version 3 numbers pictures, their views and attributes, and writes a shape as one list of numbers, the first of
 * which is its kind. */
void
ReadVIA3(const JsonNode & root, const std::string & imageName, AnnotationRecords & records)
{
  const auto               files = root.Get("file").GetMembers();
  std::vector<std::string> names;
  for (const auto & [id, file] : files)
  {
    names.push_back(FindText(file, "fname"));
  }
  const std::string        fileId = files[ChooseImage(root.GetFileName(), "file", names, imageName)].first;
  const JsonNode           attributes = root.Get("attribute");
  std::vector<std::string> views;
  for (const auto & [id, view] : root.Get("view").GetMembers())
  {
    const JsonNode list = view.Get("fid_list");
    for (std::size_t i = 0; i < list.GetSize(); ++i)
    {
      const std::string listed =
        list.At(i).IsString() ? list.At(i).AsString() : std::to_string(list.At(i).AsInteger(0, INT64_MAX));
      if (listed == fileId)
      {
        views.push_back(id);
      }
    }
  }
  for (const auto & [id, region] : root.Get("metadata").GetMembers())
  {
    const JsonNode shape = region.Get("xy");
    if (std::find(views.begin(), views.end(), FindText(region, "vid")) == views.end() || shape.GetSize() == 0)
    {
      // Of another picture, or a word about the whole of it.
      continue;
    }
    std::vector<std::string> labels;
    for (const auto & [attribute, value] : region.Get("av").GetMembers())
    {
      AppendVIA3Labels(attributes, attribute, value, labels);
    }
    PointsType points;
    for (std::size_t i = 1; i + 1 < shape.GetSize(); i += 2)
    {
      points.push_back({ { shape.At(i).AsNumber(), shape.At(i + 1).AsNumber(), 0.0 } });
    }
    constexpr int64_t point = 1;
    constexpr int64_t line = 5;
    constexpr int64_t polyline = 6;
    constexpr int64_t polygon = 7;
    const int64_t     kind = shape.At(0).AsInteger(0, 100);
    if (kind == point && !points.empty())
    {
      AddLandmark(region, ChoosePointLabel(labels), points[0][0], points[0][1], records);
    }
    else if (kind == line || kind == polyline || kind == polygon)
    {
      AddPolyline(region, ChooseLabel(labels), kind == polygon, std::move(points), records);
    }
    else
    {
      region.Warn("a region of VIA's shape " + std::to_string(kind) + " is no contour, ignored");
    }
  }
}

void
ReadVIA(const JsonNode & root, const std::string & imageName, AnnotationRecords & records)
{
  if (IsVIA3(root))
  {
    ReadVIA3(root, imageName, records);
    return;
  }
  const auto               images = FindVIAImages(root).GetMembers();
  std::vector<std::string> names;
  for (const auto & [key, image] : images)
  {
    names.push_back(FindText(image, "filename"));
  }
  const JsonNode image = images[ChooseImage(root.GetFileName(), "_via_img_metadata", names, imageName)].second;
  const JsonNode regions = image.Get("regions");
  if (regions.IsObject())
  {
    // Version 1 numbered them.
    for (const auto & [number, region] : regions.GetMembers())
    {
      ReadVIARegion(region, records);
    }
    return;
  }
  for (std::size_t i = 0; i < regions.GetSize(); ++i)
  {
    ReadVIARegion(regions.At(i), records);
  }
}

// ---- Label Studio -------------------------------------------------------------------------------------------------

/** The results of one task, whichever export: JSON has them in annotations, JSON-MIN in the members of the task. */
std::vector<JsonNode>
FindResults(const JsonNode & task)
{
  std::vector<JsonNode> results;
  const auto            append = [&](const JsonNode & list) {
    for (std::size_t i = 0; i < list.GetSize(); ++i)
    {
      if (list.At(i).IsObject())
      {
        results.push_back(list.At(i));
      }
    }
  };
  auto annotations = task.Find("annotations");
  annotations = annotations ? annotations : task.Find("completions");
  if (annotations)
  {
    // Several people may have drawn one picture; the first who did not give it up is taken.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < annotations->GetSize(); ++i)
    {
      const JsonNode annotation = annotations->At(i);
      const auto     cancelled = annotation.Find("was_cancelled");
      if (cancelled && cancelled->GetKind() == JsonNode::KindEnum::Boolean && cancelled->AsBoolean())
      {
        continue;
      }
      if (++kept == 1)
      {
        append(annotation.Get("result"));
      }
      else
      {
        annotation.Warn("a second annotation of the picture, left out");
      }
    }
    return results;
  }
  for (const auto & [name, member] : task.GetMembers())
  {
    if (member.IsArray())
    {
      append(member);
    }
  }
  return results;
}

std::string
FindImageOfTask(const JsonNode & task)
{
  const auto        data = task.Find("data");
  const JsonNode    holder = data && data->IsObject() ? *data : task;
  const std::string image = FindText(holder, "image");
  if (!image.empty())
  {
    return image;
  }
  for (const auto & [name, member] : holder.GetMembers())
  {
    if (member.IsString() && member.AsString().find('.') != std::string::npos)
    {
      return member.AsString();
    }
  }
  return std::string();
}

void
ReadLabelStudioResult(const JsonNode & result, AnnotationRecords & records)
{
  const auto     inner = result.Find("value");
  const JsonNode value = inner && inner->IsObject() ? *inner : result;
  // Labels stand under the kind's own name: "polygonlabels": ["UR1"].
  std::vector<std::string> labels;
  bool                     shape = false;
  for (const auto & [name, member] : value.GetMembers())
  {
    if (EndsWith(name, "labels") && member.IsArray())
    {
      shape = true;
      for (std::size_t i = 0; i < member.GetSize(); ++i)
      {
        labels.push_back(member.At(i).AsString());
      }
    }
  }
  const auto points = value.Find("points");
  const auto x = value.Find("x");
  if (!shape && !points)
  {
    // A choice or a text about the whole picture.
    return;
  }
  const std::string label = ChooseLabel(labels);
  if (!points && (!x || value.Find("format")))
  {
    result.Warn("a region of this kind is no contour: export polygons; left out");
    return;
  }
  const auto rotation = result.Find("image_rotation");
  if (rotation && rotation->IsNumber() && rotation->AsNumber() != 0.0)
  {
    rotation->Fail("is not 0: the picture was turned for drawing", "draw on the picture as it is");
  }
  const JsonNode width = result.Get("original_width");
  const JsonNode height = result.Get("original_height");
  if (!records.imageSize)
  {
    TakeImageSize(width, height, records);
  }
  const double scale[2] = { 0.01 * static_cast<double>(width.AsInteger(1, MaximumImageSize)),
                            0.01 * static_cast<double>(height.AsInteger(1, MaximumImageSize)) };
  if (points)
  {
    PointsType pixels = ReadPairs(*points);
    for (auto & point : pixels)
    {
      point = { { scale[0] * point[0], scale[1] * point[1], 0.0 } };
    }
    const auto closed = value.Find("closed");
    AddPolyline(result,
                label,
                !closed || closed->GetKind() != JsonNode::KindEnum::Boolean || closed->AsBoolean(),
                std::move(pixels),
                records);
  }
  else if (value.Find("height"))
  {
    result.Warn("a rectangle is no contour, ignored");
  }
  else
  {
    AddLandmark(
      result, ChoosePointLabel(labels), scale[0] * x->AsNumber(), scale[1] * value.Get("y").AsNumber(), records);
  }
}

void
ReadLabelStudio(const JsonNode & root, const std::string & imageName, AnnotationRecords & records)
{
  std::vector<JsonNode> tasks;
  if (root.IsArray())
  {
    for (std::size_t i = 0; i < root.GetSize(); ++i)
    {
      tasks.push_back(root.At(i));
    }
  }
  else
  {
    tasks.push_back(root);
  }
  std::vector<std::string> names;
  names.reserve(tasks.size());
  for (const JsonNode & task : tasks)
  {
    names.push_back(FindImageOfTask(task));
  }
  for (const JsonNode & result : FindResults(tasks[ChooseImage(root.GetFileName(), "", names, imageName)]))
  {
    ReadLabelStudioResult(result, records);
  }
}

// ---- Supervisely --------------------------------------------------------------------------------------------------

void
ReadSupervisely(const JsonNode & root, AnnotationRecords & records)
{
  const JsonNode size = root.Get("size");
  TakeImageSize(size.Get("width"), size.Get("height"), records);
  const JsonNode objects = root.Get("objects");
  for (std::size_t i = 0; i < objects.GetSize(); ++i)
  {
    const JsonNode           object = objects.At(i);
    std::vector<std::string> labels{ object.Get("classTitle").AsString() };
    if (const auto tags = object.Find("tags"))
    {
      for (std::size_t j = 0; j < tags->GetSize(); ++j)
      {
        for (const char * key : { "value", "name" })
        {
          const std::string text = FindText(tags->At(j), key);
          if (!text.empty())
          {
            labels.push_back(text);
          }
        }
      }
    }
    const std::string label = ChooseLabel(labels);
    const std::string kind = object.Get("geometryType").AsString();
    if (kind == "polygon" || kind == "line")
    {
      AddPolyline(object, label, kind == "polygon", ReadPairs(object.Get("points").Get("exterior")), records);
    }
    else if (kind == "point")
    {
      const PointsType points = ReadPairs(object.Get("points").Get("exterior"));
      if (!points.empty())
      {
        AddLandmark(object, ChoosePointLabel(labels), points[0][0], points[0][1], records);
      }
    }
    else if (kind == "graph")
    {
      // A skeleton: its joints are points with names.
      for (const auto & [name, node] : object.Get("nodes").GetMembers())
      {
        const std::vector<double> point = node.Get("loc").AsNumbers(2, "[x, y]");
        AddLandmark(node, name, point[0], point[1], records);
      }
    }
    else
    {
      object.Warn("an object of the kind " + kind + " is not read: export polygons, or a label map; left out");
    }
  }
}
} // namespace

std::size_t
ChooseImage(const std::string &              fileName,
            const std::string &              field,
            const std::vector<std::string> & images,
            const std::string &              imageName)
{
  if (images.empty())
  {
    itkDentalInputErrorMacro(fileName, field, "has no picture", "export the annotations of the radiograph");
  }
  if (images.size() == 1)
  {
    return 0;
  }
  const std::string        wanted = LowerCase(FileNameOf(imageName));
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < images.size() && !wanted.empty(); ++i)
  {
    // Label Studio puts a number before an uploaded file's name: "1a2b3c4d-ceph.png".
    const std::string name = LowerCase(FileNameOf(images[i]));
    if (name == wanted || (name.size() > wanted.size() + 1 && EndsWith(name, "-" + wanted)))
    {
      found.push_back(i);
    }
  }
  if (found.size() != 1)
  {
    std::vector<std::string> names;
    std::transform(images.begin(), images.end(), std::back_inserter(names), FileNameOf);
    itkDentalInputErrorMacro(fileName,
                             field,
                             "has " + std::to_string(images.size()) + " pictures (" + ListNames(names) + "), " +
                               (found.empty() ? "none" : std::to_string(found.size())) + " of the radiograph's name" +
                               (wanted.empty() ? "" : " \"" + FileNameOf(imageName) + "\""),
                             "name the radiograph as it was called there, or export its annotations alone");
  }
  return found.front();
}

AnnotationFileFormatEnum
RecognizeForeignAnnotation(const JsonNode & root)
{
  if (root.IsArray())
  {
    const bool tasks = root.GetSize() > 0 && root.At(0).IsObject() &&
                       (root.At(0).Find("annotations") || root.At(0).Find("completions") || root.At(0).Find("image") ||
                        root.At(0).Find("data"));
    return tasks ? Format::LabelStudio : Format::DentalSCR;
  }
  if (!root.IsObject())
  {
    return Format::DentalSCR;
  }
  const auto annotations = root.Find("annotations");
  if (annotations && root.Find("categories"))
  {
    return Format::COCO;
  }
  if (annotations && root.Find("data"))
  {
    return Format::LabelStudio;
  }
  if (root.Find("objects") && root.Find("size"))
  {
    return Format::Supervisely;
  }
  if (root.Find("_via_img_metadata") || IsVIA3(root))
  {
    return Format::VIA;
  }
  for (const auto & [name, member] : root.GetMembers())
  {
    // Every member of an export is a picture.
    if (!member.IsObject() || !member.Find("regions") || !member.Find("filename"))
    {
      return Format::DentalSCR;
    }
    return Format::VIA;
  }
  return Format::DentalSCR;
}

void
RefuseUnknownAnnotation(const JsonNode & root)
{
  const JsonNode first = root.IsArray() && root.GetSize() > 0 ? root.At(0) : root;
  if (!first.IsObject())
  {
    return;
  }
  const auto   has = [&first](const char * name) { return first.Find(name).has_value(); };
  const auto   type = first.Find("type");
  const char * program = nullptr;
  if (type && type->IsString() && has(type->AsString() == "FeatureCollection" ? "features" : "geometry"))
  {
    program = "GeoJSON, as QuPath writes it";
  }
  else if (has("categories") && has("items"))
  {
    program = "Datumaro's JSON";
  }
  else if (has("annotations") && has("item"))
  {
    program = "JSON of V7 Darwin";
  }
  else if (has("Labeled Data") || (has("data_row") && has("projects")))
  {
    program = "JSON of Labelbox";
  }
  else if (has("data_units") && has("label_hash"))
  {
    program = "JSON of Encord";
  }
  if (program != nullptr)
  {
    itkDentalInputErrorMacro(root.GetFileName(),
                             "",
                             std::string("is ") + program + ", which is not read",
                             "export COCO, CVAT for images 1.1 or labelme, or write a table .csv with label,x,y");
  }
}

void
ReadForeignAnnotation(const JsonNode & root, const std::string & imageName, AnnotationRecords & records)
{
  switch (records.format)
  {
    case Format::COCO:
      return ReadCOCO(root, imageName, records);
    case Format::VIA:
      return ReadVIA(root, imageName, records);
    case Format::LabelStudio:
      return ReadLabelStudio(root, imageName, records);
    default:
      return ReadSupervisely(root, records);
  }
}
} // namespace itk

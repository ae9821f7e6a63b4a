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
#include "itkCaseResultWriter.h"

#include "itkCaseOverlay.h"
#include "itkCaseResultDocument.h"
#include "itkCaseResultToJson.h"
#include "itkDentalInputError.h"
#include "itkMakeAnonymous.h"
#include "itkMemoryFile.h"
#include "itkOutputFolder.h"
#include "itkReadDentalMesh.h"
#include "itkReportDetails.h"
#include "itkReportPageWriter.h"
#include "itkRigidTransformRows.h"
#include "itkTextFile.h"
#include "itkTransformFile.h"

#include "itkSimilarity2DTransform.h"
#include "itkVersorRigid3DTransform.h"

#include <filesystem>
#include <iterator>
#include <set>
#include <vector>

namespace itk
{
namespace
{
namespace fs = std::filesystem;
using JawEnum = ToothCode::JawEnum;
using MeshType = DentalCaseData::MeshType;

MeshType::Pointer
MoveMesh(const MeshType * mesh, const std::array<double, 12> & matrix)
{
  auto moved = MeshType::New();
  moved->Graft(mesh);
  auto points = MeshType::PointsContainer::New();
  points->Reserve(mesh->GetNumberOfPoints());
  for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
  {
    MeshType::PointType point;
    for (unsigned int row = 0; row < 3; ++row)
    {
      double sum = matrix[4 * row + 3];
      for (unsigned int d = 0; d < 3; ++d)
      {
        sum += matrix[4 * row + d] * it.Value()[d];
      }
      point[row] = static_cast<float>(sum);
    }
    points->SetElement(it.Index(), point);
  }
  moved->SetPoints(points);
  return moved;
}

/** As ITK writes it, with a comment below the header line. */
void
WriteTransform(const TransformBaseTemplate<double> * transform, const std::string & comment, const fs::path & path)
{
  const MemoryFile memory;
  WriteTransformFile(transform, memory.GetName());
  const std::string text = memory.GetContent();
  const std::size_t end = text.find('\n');
  WriteFileAtomically(path.string(), text.substr(0, end + 1) + "# " + comment + '\n' + text.substr(end + 1));
}

/** A name for the page: of the case's folder, where it is not to be kept. */
std::string
MakeTitle(const CaseResult & result)
{
  if (result.anonymous)
  {
    return "Registration";
  }
  std::error_code error;
  const fs::path  file = fs::absolute(fs::u8path(result.data->description.fileName), error);
  const auto      folder = file.parent_path().filename().u8string();
  const auto      stem = file.stem().u8string();
  // A case file that is called so like any other says nothing.
  return stem == "case" || !fs::is_regular_file(file, error) ? (folder.empty() ? "Registration" : folder)
                                                             : folder + " / " + stem;
}

std::string
ViewOverlayName(const std::string & view, const std::string & jaw)
{
  return "overlay_" + view + '_' + jaw + ".png";
}

void
WriteFiles(const CaseResult & result, const fs::path & folder, const CaseOutputOptions & options)
{
  const auto look = [&options]() {
    if (options.between)
    {
      options.between();
    }
  };
  auto page = ReportPageWriter::New();
  for (const auto & entry : result.jaws)
  {
    const JawResult & jaw = entry.second;
    const std::string name = ToString(entry.first);
    if (!jaw.registered)
    {
      continue;
    }
    if (options.report)
    {
      const auto scan = MoveMesh(result.data->GetJaw(entry.first).mesh, jaw.meshToCephalostat);
      WriteDentalMesh(scan.GetPointer(), (folder / (name + "_ceph.stl")).string());
      look();
      if (entry.first == ToothCode::JawEnum::Upper)
      {
        page->SetUpperScan(scan);
      }
      else
      {
        page->SetLowerScan(scan);
      }
      WriteCaseOverlay(result, entry.first, (folder / ("overlay_" + name + ".png")).string());
      look();
      for (const CaseViewResult & view : result.views)
      {
        if (view.result->jaws.count(entry.first) != 0)
        {
          WriteCaseOverlay(*view.result, entry.first, (folder / ViewOverlayName(view.name, name)).string());
          look();
        }
      }
    }
    WriteUMDATransform(jaw.meshToUMDA, (folder / (name + "_umda.tfm")).string());
    using SimilarityType = Similarity2DTransform<double>;
    auto                           similarity = SimilarityType::New();
    SimilarityType::ParametersType parameters(4);
    parameters[0] = jaw.similarity.scale;
    parameters[1] = jaw.similarity.rotation;
    parameters[2] = jaw.similarity.translation[0];
    parameters[3] = jaw.similarity.translation[1];
    similarity->SetParameters(parameters);
    WriteTransform(
      similarity,
      "maps the geometry's own projection q (pixels) to the radiograph's pixels; 2-D: for ITK, not for Slicer",
      folder / (name + "_similarity2d.tfm"));
  }
  const std::string json = CaseResultToJson(result);
  if (options.report)
  {
    const std::string details = MakeReportDetails(result);
    WriteFileAtomically((folder / "report.json").string(), details);
    if (options.page)
    {
      if (result.data->image.IsNotNull())
      {
        page->SetRadiograph(result.data->image);
      }
      for (const CaseViewResult & view : result.views)
      {
        page->SetViewRadiograph(view.name, view.result->data->image);
      }
      page->SetResult(json);
      page->SetDetails(details);
      page->SetTitle(MakeTitle(result));
      page->SetFileName((folder / "report.html").string());
      page->Update();
    }
  }
  look();
  // Last: where it is, everything is.
  WriteFileAtomically((folder / "result.json").string(), json);
}

/** Names of every file that a run can leave beside those of views: those of an earlier run that this one does not make
 * are stale. */
const char * const OutputNames[] = { "upper_ceph.stl",
                                     "lower_ceph.stl",
                                     "upper_umda.tfm",
                                     "lower_umda.tfm",
                                     "upper_similarity2d.tfm",
                                     "lower_similarity2d.tfm",
                                     "overlay_upper.png",
                                     "overlay_lower.png",
                                     "report.json",
                                     "report.html",
                                     "result.json" };

/** Of the views that the result of a folder has; none where there is no result that can be read. */
std::set<std::string>
FindViewNames(const fs::path & folder)
{
  std::set<std::string> names;
  std::error_code       error;
  const fs::path        file = folder / "result.json";
  if (!fs::is_regular_file(file, error))
  {
    return names;
  }
  try
  {
    const CaseResultDocument document(file.u8string());
    if (const auto views = document.GetRoot().Find("views"))
    {
      for (const auto & member : views->GetMembers())
      {
        names.insert(member.first);
      }
    }
  }
  catch (const DentalInputError &)
  {
    // What is no result of ours has no files of ours.
  }
  return names;
}

/** Every file that runs of these views can leave, result.json last. A file that has a name like an overlay's, and is of
 * no view that the folder's result or this one has, is somebody else's. */
std::vector<std::string>
ListOutputs(const std::set<std::string> & views)
{
  std::vector<std::string> names;
  for (const std::string & view : views)
  {
    // A name from a file is a file of this folder, or none.
    if (view.find_first_of("/\\") == std::string::npos)
    {
      names.push_back(ViewOverlayName(view, "upper"));
      names.push_back(ViewOverlayName(view, "lower"));
    }
  }
  names.insert(names.end(), std::begin(OutputNames), std::end(OutputNames));
  return names;
}
} // namespace

void
WriteUMDATransform(const std::array<double, 12> & matrix, const std::string & fileName)
{
  // ITK's own tolerance: the frame's axes are orthogonal but for rounding.
  WriteTransform(ToRigidTransform(matrix, 1e-10),
                 "maps points of the scan (mm) to its UMDA frame (mm): x anterior, y patient's left, z superior",
                 fs::path(fileName));
}

void
RemoveCaseResult(const std::string & folderName)
{
  std::error_code error;
  for (const std::string & name : ListOutputs(FindViewNames(fs::u8path(folderName))))
  {
    fs::remove(fs::u8path(folderName) / name, error);
  }
}

void
WriteCaseResult(const CaseResult & result, OutputFolder & folder, const CaseOutputOptions & options)
{
  if (options.anonymous && !result.anonymous)
  {
    WriteCaseResult(MakeAnonymous(result), folder, options);
    return;
  }
  WriteFiles(result, folder.GetStagingFolder(), options);
  std::set<std::string> views = FindViewNames(fs::u8path(folder.GetName()));
  for (const CaseViewResult & view : result.views)
  {
    views.insert(view.name);
  }
  folder.Publish("result.json", ListOutputs(views));
}

void
WriteCaseResult(const CaseResult & result, const std::string & folderName, const CaseOutputOptions & options)
{
  OutputFolder folder(folderName);
  WriteCaseResult(result, folder, options);
}
} // namespace itk

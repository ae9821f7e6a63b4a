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
#include "dentalscrCommands.h"
#include "dentalscrScanOptions.h"

#include "itkContourResampleFilter.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalContourFileWriter.h"
#include "itkDentalInputError.h"
#include "itkDescribePlainly.h"
#include "itkImage.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkReadLabelImage.h"
#include "itkRequireJsonName.h"
#include "itkSilhouetteContourFilter.h"

#include <iostream>
#include <memory>

namespace dentalscr
{
namespace
{
using JawEnum = itk::ToothCode::JawEnum;
using MeshType = itk::DentalCaseData::MeshType;

struct ContourOptions
{
  ScanOptions  scans;
  std::string  labels;
  std::string  jaw{ "upper" };
  bool         wholeLabels{ false };
  std::string  output;
  std::string  result;
  std::string  view;
  unsigned int points{ 0 };
};

itk::DentalContour::Pointer
Resample(itk::DentalContour * contour, unsigned int points)
{
  if (points == 0)
  {
    // Held here: the filter lets go of what is disconnected.
    itk::DentalContour::Pointer held = contour;
    held->DisconnectPipeline();
    return held;
  }
  auto resample = itk::ContourResampleFilter::New();
  resample->SetInput(contour);
  resample->SetNumberOfPoints(points);
  resample->Update();
  itk::DentalContour::Pointer output = resample->GetOutput();
  output->DisconnectPipeline();
  return output;
}

/** The contours of a label map; with teeth as labels (FDI numbers) each goes to its jaw. */
void
ContoursOfLabels(const ContourOptions & options, itk::DentalContour * contours[2], itk::Size<2> & size)
{
  using LabelType = itk::Image<std::uint16_t, 2>;
  itk::LabelImageNotes     notes;
  const LabelType::Pointer labels = itk::ReadLabelImage(options.labels, notes);
  if (!options.wholeLabels && (!notes.segments.empty() || notes.isOfPlainArray))
  {
    // What a segmentation calls its labels, and where its part of the picture lies, is read as a case's tracing is.
    auto reader = itk::DentalContourFileReader::New();
    reader->SetFileName(options.labels);
    if (notes.isPart && notes.pictureSize[0] == 0)
    {
      reader->SetImageSize({ { notes.offset[0] + labels->GetLargestPossibleRegion().GetSize()[0],
                               notes.offset[1] + labels->GetLargestPossibleRegion().GetSize()[1] } });
    }
    reader->Update();
    for (const std::string & warning : reader->GetWarnings())
    {
      std::cerr << "dentalscr: warning: " << warning << std::endl;
    }
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      for (const auto & polyline : Resample(reader->GetOutput(jaw), options.points)->GetPolylines())
      {
        contours[jaw == JawEnum::Upper ? 0 : 1]->AddPolyline(polyline);
      }
    }
    size = { { reader->GetReadImageSize()[0], reader->GetReadImageSize()[1] } };
    return;
  }
  size = labels->GetLargestPossibleRegion().GetSize();
  using FilterType = itk::SilhouetteContourFilter<LabelType>;
  auto filter = FilterType::New();
  filter->SetInput(labels);
  filter->SetContent(options.wholeLabels ? FilterType::ContentEnum::MergedLabels
                                         : FilterType::ContentEnum::ToothLabels);
  filter->SetLargestPartOnly(options.wholeLabels);
  try
  {
    filter->Update();
  }
  catch (const itk::ExceptionObject &)
  {
    // The one thing that can be wrong with an image that was read: its numbers.
    itkDentalInputErrorMacro(options.labels,
                             "",
                             options.wholeLabels ? "has no outline" : "has labels that are no FDI tooth numbers",
                             options.wholeLabels ? "name an image with pixels that are not 0"
                                                 : "use --whole for one outline around everything that is not 0");
  }
  if (filter->GetOutput()->GetNumberOfPoints() == 0)
  {
    itkDentalInputErrorMacro(
      options.labels, "", "has no label: all its pixels are 0", "name the label map of the teeth");
  }
  const auto contour = Resample(filter->GetOutput(), options.points);
  for (auto polyline : contour->GetPolylines())
  {
    if (polyline.code.IsKnown())
    {
      std::vector<std::array<double, 2>> points;
      for (const auto & point : polyline.points)
      {
        points.push_back({ { point[0], point[1] } });
      }
      polyline.weights = itk::ComputeLabelBorderWeights(labels, points, polyline.code.GetJaw() == JawEnum::Upper);
    }
    const JawEnum jaw =
      polyline.code.IsKnown() ? polyline.code.GetJaw() : (options.jaw == "upper" ? JawEnum::Upper : JawEnum::Lower);
    contours[jaw == JawEnum::Upper ? 0 : 1]->AddPolyline(polyline);
  }
}

/** Moves silhouettes about the central ray into an image of their own, a border of 20 pixels around them. */
void
ShiftIntoView(itk::DentalContour * contours[2], itk::Size<2> & size)
{
  constexpr double border = 20.0;
  double           low[2] = { 0.0, 0.0 };
  double           high[2] = { 0.0, 0.0 };
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    for (const auto & polyline : contours[jaw]->GetPolylines())
    {
      for (const auto & point : polyline.points)
      {
        for (unsigned int d = 0; d < 2; ++d)
        {
          low[d] = std::min(low[d], point[d]);
          high[d] = std::max(high[d], point[d]);
        }
      }
    }
  }
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    auto polylines = contours[jaw]->GetPolylines();
    contours[jaw]->Initialize();
    for (auto & polyline : polylines)
    {
      for (auto & point : polyline.points)
      {
        for (unsigned int d = 0; d < 2; ++d)
        {
          point[d] += border - low[d];
        }
      }
      contours[jaw]->AddPolyline(polyline);
    }
  }
  for (unsigned int d = 0; d < 2; ++d)
  {
    size[d] = static_cast<itk::SizeValueType>(high[d] - low[d] + 2.0 * border) + 1;
  }
}

void
ContoursOfScans(const ContourOptions & options, itk::DentalContour * contours[2], itk::Size<2> & size)
{
  const auto   data = options.scans.Load();
  const auto & view = FindView(*data, options.view);
  const auto   scans = FindFrames(*data);
  size[0] = view.imageSize[0];
  size[1] = view.imageSize[1];
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    if (data->GetJaw(jaw).mesh.IsNull())
    {
      continue;
    }
    const auto geometry = PlaceJaw(*data, jaw, scans.axis->GetFrame(), options.result, options.view);
    auto       source = itk::MeshSilhouetteContourSource<MeshType>::New();
    source->SetInput(data->GetJaw(jaw).mesh);
    source->SetGeometry(geometry);
    source->SetNumberOfPoints(options.points);
    try
    {
      source->Update();
    }
    catch (const itk::ExceptionObject & error)
    {
      const auto & description = data->description;
      itkDentalInputErrorMacro(
        jaw == JawEnum::Upper ? description.upperFile : description.lowerFile, "", itk::DescribePlainly(error), "");
    }
    for (const auto & polyline : source->GetOutput()->GetPolylines())
    {
      contours[jaw == JawEnum::Upper ? 0 : 1]->AddPolyline(polyline);
    }
  }
  if (options.result.empty())
  {
    ShiftIntoView(contours, size);
  }
}

int
Contour(const ContourOptions & options, const CommonOptions & common)
{
  itk::RequireJsonName(options.output, "contours");
  auto                 upper = itk::DentalContour::New();
  auto                 lower = itk::DentalContour::New();
  itk::DentalContour * contours[2] = { upper, lower };
  itk::Size<2>         size;
  size.Fill(0);
  if (!options.labels.empty())
  {
    ContoursOfLabels(options, contours, size);
  }
  else
  {
    ContoursOfScans(options, contours, size);
  }
  auto writer = itk::DentalContourFileWriter::New();
  writer->SetUpper(upper);
  writer->SetLower(lower);
  writer->SetImageSize(size);
  writer->SetFileName(options.output);
  writer->Update();
  if (!common.quiet)
  {
    std::cout << "upper " << upper->GetNumberOfPoints() << " points, lower " << lower->GetNumberOfPoints()
              << " points, written to " << options.output << std::endl;
  }
  return AllRegistered;
}
} // namespace

void
AddContourCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<ContourOptions>();
  auto * command =
    program.add_subcommand("contour", "Contours in pixels: silhouettes of scans, or the outlines of a label image");
  options->scans.AddTo(command, true);
  command->add_option("--labels", options->labels, "Label image; a label is a tooth's FDI number")
    ->check(CLI::ExistingFile);
  command->add_flag("--whole", options->wholeLabels, "One outline around everything that is not 0");
  command->add_option("--jaw", options->jaw, "Jaw of outlines without a tooth")
    ->check(CLI::IsMember({ "upper", "lower" }))
    ->capture_default_str();
  command->add_option("-o,--output", options->output, "The contours (.json)")->type_name("FILE")->required();
  command
    ->add_option("--result", options->result, "result.json, or its folder: silhouettes where the case was registered")
    ->type_name("FILE");
  AddViewOption(command, options->view);
  command->add_option("--points", options->points, "Resample to so many points (0: as they come)")
    ->check(CLI::Range(0u, 1000000u))
    ->capture_default_str();
  command->footer(
    "Without --result the central ray passes through the centroid of the jaws, and the image is as large as the\n"
    "silhouettes with a border.\n"
    "Examples:\n"
    "  dentalscr contour --case case.json --result result/result.json --output silhouettes.json\n"
    "  dentalscr contour --labels crowns.png --output contours.json\n");
  command->callback([options, &common, &run]() { run = [options, &common]() { return Contour(*options, common); }; });
}
} // namespace dentalscr

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
#include "dentalscrRegisterImageFormats.h"
#include "dentalscrScanOptions.h"

#include "itkAddImageFilter.h"
#include "itkDentalInputError.h"
#include "itkImageFileWriter.h"
#include "itkLowerCase.h"
#include "itkRescaleIntensityImageFilter.h"
#include "itkSurfaceDRRImageSource.h"
#include "itkWriteThroughMemory.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

namespace dentalscr
{
namespace
{
using JawEnum = itk::ToothCode::JawEnum;
using MeshType = itk::DentalCaseData::MeshType;
using ImageType = itk::Image<float, 2>;
using RadiographSourceType = itk::SurfaceDRRImageSource<MeshType, ImageType>;

struct RenderOptions
{
  ScanOptions scans;
  std::string output;
  std::string result;
  std::string view;
  double      sigma{ 0.5 };
  std::string mode{ "thickness" };
  std::string normalization{ "physical" };
  double      attenuation{ 0.08 };
};

template <typename TImage>
void
WriteImageFile(const TImage * image, const std::string & extension, const std::string & fileName)
{
  RegisterImageFormats();
  auto writer = itk::ImageFileWriter<TImage>::New();
  writer->SetInput(image);
  itk::WriteThroughMemory(writer.GetPointer(), fileName, extension);
}

/** Formats that hold floats get them; a picture gets 8 bits over the full range. */
void
WriteRadiograph(ImageType * image, const std::string & fileName)
{
  const std::string extension = itk::LowerCase(std::filesystem::path(fileName).extension().string());
  if (extension == ".mha" || extension == ".nrrd" || extension == ".tif" || extension == ".tiff")
  {
    WriteImageFile(image, extension, fileName);
  }
  else if (extension == ".png" || extension == ".jpg" || extension == ".jpeg" || extension == ".bmp")
  {
    using PictureType = itk::Image<unsigned char, 2>;
    auto rescale = itk::RescaleIntensityImageFilter<ImageType, PictureType>::New();
    rescale->SetInput(image);
    rescale->Update();
    WriteImageFile<PictureType>(rescale->GetOutput(), extension, fileName);
  }
  else
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "can't be written: its extension names no image format of one file",
                             "name a .png, .jpg, .bmp, .tif, .mha or .nrrd file");
  }
}

int
Render(const RenderOptions & options, const CommonOptions & common)
{
  const auto   data = options.scans.Load();
  const auto & view = FindView(*data, options.view);
  const auto   scans = FindFrames(*data);

  // Jaws have a pose each, hence a source each; where both are there the images share one grid and are added.
  RadiographSourceType::Pointer sources[2];
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    if (data->GetJaw(jaw).mesh.IsNull())
    {
      continue;
    }
    const auto geometry = PlaceJaw(*data, jaw, scans.axis->GetFrame(), options.result, options.view);
    auto       source = RadiographSourceType::New();
    source->SetInput(data->GetJaw(jaw).mesh);
    source->SetGeometry(geometry);
    source->SetSigma(options.sigma);
    source->SetNormalization(options.normalization == "paper"
                               ? itk::SurfaceDRRImageSourceEnums::Normalization::Paper
                               : itk::SurfaceDRRImageSourceEnums::Normalization::Physical);
    sources[jaw == JawEnum::Upper ? 0 : 1] = source;
  }
  itk::ImageRegion<2> region;
  if (!options.result.empty())
  {
    // On the radiograph's own grid, so that the two can be laid over each other.
    if (view.imageSize[0] == 0)
    {
      itkDentalInputErrorMacro(data->description.fileName,
                               "contours",
                               "the radiograph's size is unknown",
                               "use --result together with --case");
    }
    region.SetSize(0, view.imageSize[0]);
    region.SetSize(1, view.imageSize[1]);
  }
  else
  {
    bool first = true;
    for (const auto & source : sources)
    {
      if (source.IsNotNull())
      {
        source->UpdateOutputInformation();
        const auto own = source->GetOutput()->GetLargestPossibleRegion();
        if (first)
        {
          region = own;
          first = false;
          continue;
        }
        for (unsigned int d = 0; d < 2; ++d)
        {
          const auto low = std::min(region.GetIndex(d), own.GetIndex(d));
          const auto high = std::max(region.GetUpperIndex()[d], own.GetUpperIndex()[d]);
          region.SetIndex(d, low);
          region.SetSize(d, static_cast<itk::SizeValueType>(high - low + 1));
        }
      }
    }
  }
  ImageType::Pointer thickness;
  for (const auto & source : sources)
  {
    if (source.IsNull())
    {
      continue;
    }
    source->SetSize(region.GetSize());
    source->SetStartIndex(region.GetIndex());
    source->Update();
    if (thickness.IsNull())
    {
      thickness = source->GetOutput();
      thickness->DisconnectPipeline();
    }
    else
    {
      auto add = itk::AddImageFilter<ImageType>::New();
      add->SetInput1(thickness);
      add->SetInput2(source->GetOutput());
      add->Update();
      thickness = add->GetOutput();
      thickness->DisconnectPipeline();
    }
  }
  if (options.mode != "thickness")
  {
    // Beer-Lambert on the sum of the shells.
    const bool inverted = options.mode == "radiograph";
    float *    pixel = thickness->GetBufferPointer();
    for (itk::SizeValueType i = 0; i < thickness->GetBufferedRegion().GetNumberOfPixels(); ++i)
    {
      const double transmitted = std::exp(-options.attenuation * pixel[i]);
      pixel[i] = static_cast<float>(inverted ? 1.0 - transmitted : transmitted);
    }
  }
  WriteRadiograph(thickness, options.output);
  if (!common.quiet)
  {
    std::cout << "written to " << options.output << ", first pixel " << region.GetIndex() << ", size "
              << region.GetSize() << std::endl;
  }
  return AllRegistered;
}
} // namespace

void
AddRenderCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<RenderOptions>();
  auto * command = program.add_subcommand("render", "Renders scans as a radiograph would show them (surface DRR)");
  options->scans.AddTo(command, true);
  command->add_option("-o,--output", options->output, "Image: .png (8 bit), .tif, .mha, .nrrd (float)")
    ->type_name("FILE")
    ->required();
  command
    ->add_option("--result",
                 options->result,
                 "result.json, or its folder: render where the case was registered, on its radiograph's grid")
    ->type_name("FILE");
  AddViewOption(command, options->view);
  command->add_option("--sigma", options->sigma, "Width of the splats in the detector plane, mm")
    ->check(CLI::Range(0.01, 25.0))
    ->capture_default_str();
  command->add_option("--mode", options->mode, "thickness, intensity (Beer-Lambert) or radiograph (inverted)")
    ->check(CLI::IsMember({ "thickness", "intensity", "radiograph" }))
    ->capture_default_str();
  command->add_option("--normalization", options->normalization, "paper (unnormalised) or physical (mm of shell)")
    ->check(CLI::IsMember({ "paper", "physical" }))
    ->capture_default_str();
  command->add_option("--attenuation", options->attenuation, "mu_0 of the modes intensity and radiograph, 1/mm")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  command->footer(
    "Without --result the central ray passes through the centroid of the jaws.\n"
    "Examples:\n"
    "  dentalscr render --upper upper.stl --spacing 0.25 0.25 --output upper.png\n"
    "  dentalscr render --case case.json --result result/result.json --mode radiograph --output drr.mha\n"
    "  dentalscr render --case case.json --result result/result.json --view frontal --output frontal.png\n");
  command->callback([options, &common, &run]() { run = [options, &common]() { return Render(*options, common); }; });
}
} // namespace dentalscr

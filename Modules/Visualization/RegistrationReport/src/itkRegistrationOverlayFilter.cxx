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
#include "itkRegistrationOverlayFilter.h"

#include "itkGreyWindow.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace itk
{
namespace
{
std::string
MovingName(unsigned int number)
{
  return "MovingContour" + std::to_string(number);
}

OverlayScene::ContourType
Flatten(const DentalContour * contour, OverlayScene::RoleEnum role, const std::string & label)
{
  OverlayScene::ContourType result;
  result.role = role;
  result.label = label;
  for (const DentalContour::PolylineType & polyline : contour->GetPolylines())
  {
    OverlayScene::StrokeType stroke;
    stroke.closed = polyline.closed;
    for (const auto & point : polyline.points)
    {
      stroke.points.push_back({ point[0], point[1] });
    }
    result.strokes.push_back(std::move(stroke));
  }
  return result;
}

/** Windowed to bytes. Values that are not finite are black. */
std::vector<std::uint8_t>
ToGrey(const Image<float, 2> * image, double black, double white)
{
  const float *     pixels = image->GetBufferPointer();
  const std::size_t count = image->GetBufferedRegion().GetNumberOfPixels();
  const bool        isGiven = black != 0.0 || white != 0.0;
  const GreyWindow  window = isGiven ? GreyWindow{ black, white } : GreyWindow::FromQuantiles(pixels, count, 0.002);
  std::vector<std::uint8_t> grey(count);
  std::transform(pixels, pixels + count, grey.begin(), [&window](float value) { return window.ToByte(value); });
  return grey;
}
} // namespace

RegistrationOverlayFilter::RegistrationOverlayFilter()
{
  m_PixelSpacing.Fill(0.0);
  m_RadiographSize.Fill(0);
  m_PictureSize[0] = 1400;
  m_PictureSize[1] = 900;
  this->RemoveRequiredInputName("Primary");
}

void
RegistrationOverlayFilter::SetMovingContour(unsigned int          number,
                                            const DentalContour * contour,
                                            const std::string &   label)
{
  if (contour == nullptr)
  {
    this->RemoveInput(MovingName(number));
    return;
  }
  if (number >= m_MovingLabels.size())
  {
    m_MovingLabels.resize(number + 1);
  }
  if (m_MovingLabels[number] != label)
  {
    m_MovingLabels[number] = label;
    this->Modified();
  }
  this->ProcessObject::SetInput(MovingName(number), const_cast<DentalContour *>(contour));
}

const DentalContour *
RegistrationOverlayFilter::GetMovingContour(unsigned int number) const
{
  return dynamic_cast<const DentalContour *>(this->ProcessObject::GetInput(MovingName(number)));
}

void
RegistrationOverlayFilter::SetLandmarkSigmas(const std::map<std::string, double> & sigmas)
{
  if (m_LandmarkSigmas != sigmas)
  {
    m_LandmarkSigmas = sigmas;
    this->Modified();
  }
}

void
RegistrationOverlayFilter::SetRadiographSize(unsigned int width, unsigned int height)
{
  if (m_RadiographSize[0] != width || m_RadiographSize[1] != height)
  {
    m_RadiographSize[0] = width;
    m_RadiographSize[1] = height;
    this->Modified();
  }
}

void
RegistrationOverlayFilter::SetWindow(double black, double white)
{
  if (m_WindowBlack != black || m_WindowWhite != white)
  {
    m_WindowBlack = black;
    m_WindowWhite = white;
    this->Modified();
  }
}

void
RegistrationOverlayFilter::SetPictureSize(unsigned int width, unsigned int height)
{
  if (m_PictureSize[0] != width || m_PictureSize[1] != height)
  {
    m_PictureSize[0] = width;
    m_PictureSize[1] = height;
    this->Modified();
  }
}

void
RegistrationOverlayFilter::SetTextLines(const std::vector<std::string> & lines)
{
  if (m_TextLines != lines)
  {
    m_TextLines = lines;
    this->Modified();
  }
}

void
RegistrationOverlayFilter::SetView(double firstU, double lastU, double firstV, double lastV)
{
  if (!(lastU > firstU) || !(lastV > firstV))
  {
    itkExceptionMacro("The view from (" << firstU << ", " << firstV << ") to (" << lastU << ", " << lastV
                                        << ") is empty; give first and last index of u, then of v.");
  }
  const std::array<double, 4> view{ firstU, lastU, firstV, lastV };
  if (m_View != view)
  {
    m_View = view;
    this->Modified();
  }
}

void
RegistrationOverlayFilter::SetViewToContours()
{
  const std::array<double, 4> none{ 0.0, 0.0, 0.0, 0.0 };
  if (m_View != none)
  {
    m_View = none;
    this->Modified();
  }
}

void
RegistrationOverlayFilter::GenerateOutputInformation()
{
  PictureType *           picture = this->GetOutput();
  PictureType::RegionType region;
  region.SetSize(m_PictureSize);
  picture->SetLargestPossibleRegion(region);
}

void
RegistrationOverlayFilter::EnlargeOutputRequestedRegion(DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

OverlayScene
RegistrationOverlayFilter::MakeScene() const
{
  OverlayScene scene;
  if (const RadiographType * radiograph = this->GetRadiograph())
  {
    const auto size = radiograph->GetBufferedRegion().GetSize();
    if (size[0] > 32767 || size[1] > 32767)
    {
      itkExceptionMacro("The radiograph has " << size
                                              << " pixels; at most 32767 a side can be shown. Shrink it first.");
    }
    scene.width = static_cast<int>(size[0]);
    scene.height = static_cast<int>(size[1]);
    scene.grey = ToGrey(radiograph, m_WindowBlack, m_WindowWhite);
  }
  else
  {
    scene.width = static_cast<int>(std::min<SizeValueType>(m_RadiographSize[0], 32767));
    scene.height = static_cast<int>(std::min<SizeValueType>(m_RadiographSize[1], 32767));
  }
  scene.pixelSpacing = { m_PixelSpacing[0], m_PixelSpacing[1] };
  if (const DentalContour * contour = this->GetFixedContour())
  {
    scene.contours.push_back(Flatten(contour, OverlayScene::RoleEnum::Fixed, "Tracing on the radiograph"));
  }
  for (unsigned int number = 0; number < m_MovingLabels.size(); ++number)
  {
    if (const DentalContour * contour = this->GetMovingContour(number))
    {
      const std::string & label = m_MovingLabels[number];
      scene.contours.push_back(
        Flatten(contour,
                number == 0 ? OverlayScene::RoleEnum::Moving : OverlayScene::RoleEnum::Secondary,
                !label.empty() ? label : (number == 0 ? "Aligned scan" : "Aligned scan, whole outline")));
    }
  }
  std::map<std::string, std::size_t> slots;
  const auto                         slot = [&](const std::string & name) -> OverlayScene::LandmarkType & {
    const auto found = slots.emplace(name, scene.landmarks.size());
    if (found.second)
    {
      scene.landmarks.emplace_back();
      scene.landmarks.back().name = name;
    }
    return scene.landmarks[found.first->second];
  };
  if (const LandmarkSetType * predicted = this->GetPredictedLandmarks())
  {
    for (const auto & landmark : predicted->GetLandmarks())
    {
      OverlayScene::LandmarkType & shown = slot(landmark.name);
      shown.predicted = { landmark.point[0], landmark.point[1] };
      const auto sigma = m_LandmarkSigmas.find(landmark.name);
      shown.sigma = sigma != m_LandmarkSigmas.end() ? sigma->second : 0.0;
    }
  }
  if (const LandmarkSetType * reference = this->GetReferenceLandmarks())
  {
    for (const auto & landmark : reference->GetLandmarks())
    {
      slot(landmark.name).reference = { landmark.point[0], landmark.point[1] };
    }
  }
  scene.title = m_Title;
  scene.status = m_Status;
  scene.lines = m_TextLines;
  scene.view = m_View;
  scene.margin = m_Margin;
  return scene;
}

void
RegistrationOverlayFilter::GenerateData()
{
  this->UpdateProgress(0.0f);
  const OverlayScene        scene = this->MakeScene();
  std::vector<std::uint8_t> pixels;
  if (this->GetAbortGenerateData())
  {
    throw ProcessAborted(__FILE__, __LINE__);
  }
  this->UpdateProgress(0.2f);
  try
  {
    const auto width = static_cast<int>(std::min<SizeValueType>(m_PictureSize[0], 1u << 20));
    const auto height = static_cast<int>(std::min<SizeValueType>(m_PictureSize[1], 1u << 20));
    m_Layout = LayOutOverlay(scene, width, height);
    pixels = PaintOverlay(scene, width, height);
  }
  catch (const std::invalid_argument & error)
  {
    itkExceptionMacro(<< error.what());
  }
  catch (const std::runtime_error & error)
  {
    itkExceptionMacro(<< error.what());
  }
  this->AllocateOutputs();
  static_assert(sizeof(RGBPixel<unsigned char>) == 3, "Pixels are packed.");
  auto * out = reinterpret_cast<std::uint8_t *>(this->GetOutput()->GetBufferPointer());
  std::copy(pixels.begin(), pixels.end(), out);
  this->UpdateProgress(1.0f);
}

void
RegistrationOverlayFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  for (unsigned int number = 0; number < m_MovingLabels.size(); ++number)
  {
    os << indent << "MovingContour " << number << ": " << m_MovingLabels[number] << std::endl;
  }
  os << indent << "LandmarkSigmas: " << m_LandmarkSigmas.size() << std::endl;
  os << indent << "PixelSpacing: " << m_PixelSpacing << std::endl;
  os << indent << "RadiographSize: " << m_RadiographSize << std::endl;
  os << indent << "WindowBlack: " << m_WindowBlack << std::endl;
  os << indent << "WindowWhite: " << m_WindowWhite << std::endl;
  os << indent << "PictureSize: " << m_PictureSize << std::endl;
  os << indent << "Title: " << m_Title << std::endl;
  os << indent << "Status: " << m_Status << std::endl;
  os << indent << "TextLines: " << m_TextLines.size() << std::endl;
  os << indent << "View: " << m_View[0] << ", " << m_View[1] << ", " << m_View[2] << ", " << m_View[3] << std::endl;
  os << indent << "Margin: " << m_Margin << std::endl;
  os << indent << "Layout.first: " << m_Layout.first[0] << ", " << m_Layout.first[1] << std::endl;
  os << indent << "Layout.scale: " << m_Layout.scale[0] << ", " << m_Layout.scale[1] << std::endl;
}
} // namespace itk

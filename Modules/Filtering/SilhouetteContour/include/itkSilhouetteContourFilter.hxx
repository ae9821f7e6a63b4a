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
#ifndef itkSilhouetteContourFilter_hxx
#define itkSilhouetteContourFilter_hxx

#include "itkImageRegionConstIterator.h"
#include "itkImageScanlineConstIterator.h"
#include "itkProgressReporter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>

namespace itk
{
template <typename TInputImage>
SilhouetteContourFilter<TInputImage>::SilhouetteContourFilter()
{
  this->SetNumberOfRequiredInputs(0);
  m_OutputOffset.Fill(0.0);
}

template <typename TInputImage>
void
SilhouetteContourFilter<TInputImage>::VerifyPreconditions() ITKv5_CONST
{
  if (this->ProcessObject::GetPrimaryInput() == nullptr)
  {
    itkExceptionMacro("No image: call SetInput() with a silhouette map, a DRR or a label map.");
  }
  if (m_Content == ContentEnum::Intensity && m_Level == LevelEnum::Fraction &&
      !(m_LevelFraction > 0.0 && m_LevelFraction < 1.0))
  {
    itkExceptionMacro("The level's fraction " << m_LevelFraction
                                              << " is not between 0 and 1: call SetLevelFraction() with one that is.");
  }
  if (!std::isfinite(m_LevelValue))
  {
    itkExceptionMacro("The level " << m_LevelValue << " is not finite: call SetLevelValue() with one that is.");
  }
  Superclass::VerifyPreconditions();
}

template <typename TInputImage>
void
SilhouetteContourFilter<TInputImage>::GenerateData()
{
  DentalContour * const output = this->GetOutput();
  output->Initialize();
  // Without it every Update() would execute again.
  output->SetBufferedRegion(output->GetRequestedRegion());
  m_UsedLevel = 0.0;
  if (this->GetInput()->GetBufferedRegion().GetNumberOfPixels() == 0)
  {
    return;
  }
  if (m_Content == ContentEnum::Intensity)
  {
    this->TraceIntensity();
  }
  else
  {
    this->TraceLabels();
  }
}

template <typename TInputImage>
double
SilhouetteContourFilter<TInputImage>::FindLevel(double background, double extreme)
{
  const double sign = m_ObjectIsDark ? -1.0 : 1.0;
  if (m_Level == LevelEnum::Absolute)
  {
    return sign * m_LevelValue;
  }
  if (m_Level == LevelEnum::Fraction)
  {
    return background + m_LevelFraction * (extreme - background);
  }
  // Half the median of the object by a histogram: of what is not background first, then of what is above that level,
  // so that a blurred edge counts for less.
  constexpr std::size_t    bins = 4096;
  const double             scale = static_cast<double>(bins) / (extreme - background);
  std::vector<std::size_t> histogram(bins, 0);
  for (ImageRegionConstIterator<InputImageType> it(this->GetInput(), this->GetInput()->GetBufferedRegion());
       !it.IsAtEnd();
       ++it)
  {
    const double height = (sign * static_cast<double>(it.Get()) - background) * scale;
    ++histogram[std::min(bins - 1, static_cast<std::size_t>(height))];
  }
  double level = 0.01 * static_cast<double>(bins);
  for (unsigned int pass = 0; pass < 2; ++pass)
  {
    const auto        first = static_cast<std::size_t>(level) + 1;
    const std::size_t count =
      std::accumulate(histogram.begin() + static_cast<std::ptrdiff_t>(first), histogram.end(), std::size_t{ 0 });
    std::size_t bin = first;
    for (std::size_t below = histogram[bin]; 2 * below < count && bin + 1 < bins; below += histogram[bin])
    {
      ++bin;
    }
    level = 0.5 * (static_cast<double>(bin) + 0.5);
  }
  return background + level / scale;
}

template <typename TInputImage>
void
SilhouetteContourFilter<TInputImage>::AddLoops(const std::vector<IsoContourTracer::LoopType> & loops,
                                               const RegionType &                              region,
                                               ToothCode                                       code)
{
  const InputImageType * const image = this->GetInput();
  for (const IsoContourTracer::LoopType & loop : loops)
  {
    if (ComputeLoopArea(loop) < m_MinimumArea)
    {
      break;
    }
    DentalContour::PolylineType polyline;
    polyline.code = code;
    polyline.closed = true;
    polyline.points.reserve(loop.size());
    for (const auto & p : loop)
    {
      ContinuousIndex<double, 2> index;
      DentalContour::PointType   point;
      for (unsigned int d = 0; d < 2; ++d)
      {
        index[d] = static_cast<double>(region.GetIndex(d)) + p[d];
        point[d] = index[d];
      }
      if (m_OutputCoordinates != OutputCoordinatesEnum::Index)
      {
        image->TransformContinuousIndexToPhysicalPoint(index, point);
      }
      for (unsigned int d = 0; d < 2; ++d)
      {
        if (m_OutputCoordinates == OutputCoordinatesEnum::PhysicalOverSpacing)
        {
          point[d] /= image->GetSpacing()[d];
        }
        point[d] -= m_OutputOffset[d];
      }
      polyline.points.push_back(point);
    }
    this->GetOutput()->AddPolyline(polyline);
    if (m_LargestPartOnly)
    {
      break;
    }
  }
}

template <typename TInputImage>
void
SilhouetteContourFilter<TInputImage>::TraceIntensity()
{
  const InputImageType * const image = this->GetInput();
  const RegionType             region = image->GetBufferedRegion();
  const double                 sign = m_ObjectIsDark ? -1.0 : 1.0;
  double                       background = std::numeric_limits<double>::max();
  double                       extreme = std::numeric_limits<double>::lowest();
  for (ImageRegionConstIterator<InputImageType> it(image, region); !it.IsAtEnd(); ++it)
  {
    const auto value = sign * static_cast<double>(it.Get());
    if (!std::isfinite(value))
    {
      itkExceptionMacro("The pixel " << it.GetIndex() << " is " << value
                                     << ", and an iso-contour needs finite values. Replace such pixels first.");
    }
    background = std::min(background, value);
    extreme = std::max(extreme, value);
  }
  if (!(extreme > background))
  {
    return;
  }
  const double level = this->FindLevel(background, extreme);
  m_UsedLevel = sign * level;
  if (level < background)
  {
    // Everything is above: no background that a contour could separate.
    return;
  }
  IsoContourTracer                           tracer(static_cast<std::size_t>(region.GetSize(0)), level, background);
  ProgressReporter                           progress(this, 0, region.GetSize(1));
  std::vector<double>                        row(static_cast<std::size_t>(region.GetSize(0)));
  ImageScanlineConstIterator<InputImageType> it(image, region);
  while (!it.IsAtEnd())
  {
    for (double & value : row)
    {
      value = sign * static_cast<double>(it.Get());
      ++it;
    }
    tracer.AddRow(row.data());
    it.NextLine();
    progress.CompletedPixel();
  }
  this->AddLoops(tracer.Finish(), region, ToothCode());
}

template <typename TInputImage>
void
SilhouetteContourFilter<TInputImage>::TraceLabels()
{
  using PixelType = typename InputImageType::PixelType;
  const InputImageType * const image = this->GetInput();
  const RegionType             whole = image->GetBufferedRegion();
  const bool                   merged = m_Content == ContentEnum::MergedLabels;
  m_UsedLevel = 0.5;

  // Where each label is.
  struct BoxType
  {
    IndexValueType low[2];
    IndexValueType high[2];
  };
  std::map<PixelType, BoxType> boxes;
  for (ImageRegionConstIterator<InputImageType> it(image, whole); !it.IsAtEnd(); ++it)
  {
    const PixelType label = merged && it.Get() != PixelType{} ? PixelType{ 1 } : it.Get();
    if (label != PixelType{})
    {
      const auto index = it.GetIndex();
      const auto inserted = boxes.emplace(label, BoxType{ { index[0], index[1] }, { index[0], index[1] } });
      BoxType &  box = inserted.first->second;
      for (unsigned int d = 0; d < 2; ++d)
      {
        box.low[d] = std::min(box.low[d], index[d]);
        box.high[d] = std::max(box.high[d], index[d]);
      }
    }
  }
  ProgressReporter progress(this, 0, std::max<SizeValueType>(1, boxes.size()));
  for (const auto & entry : boxes)
  {
    ToothCode code;
    if (!merged)
    {
      const auto label = static_cast<double>(entry.first);
      const bool isWhole = label == std::floor(label) && label > 0.0 && label < 100.0;
      try
      {
        code = ToothCode(isWhole ? static_cast<unsigned int>(label) : 99u);
      }
      catch (const std::invalid_argument &)
      {
        itkExceptionMacro("The label " << label << " at index [" << entry.second.low[0] << ", " << entry.second.low[1]
                                       << "] onward is no FDI number of a permanent tooth. Map the labels to FDI, or "
                                          "call SetContent(MergedLabels).");
      }
    }
    RegionType region;
    for (unsigned int d = 0; d < 2; ++d)
    {
      region.SetIndex(d, entry.second.low[d]);
      region.SetSize(d, static_cast<SizeValueType>(entry.second.high[d] - entry.second.low[d] + 1));
    }
    std::vector<double> mask;
    mask.reserve(region.GetNumberOfPixels());
    for (ImageRegionConstIterator<InputImageType> it(image, region); !it.IsAtEnd(); ++it)
    {
      mask.push_back((merged ? it.Get() != PixelType{} : it.Get() == entry.first) ? 1.0 : 0.0);
    }
    this->AddLoops(TraceMask(mask, static_cast<std::size_t>(region.GetSize(0)), m_LabelSmoothing), region, code);
    progress.CompletedPixel();
  }
}

template <typename TInputImage>
void
SilhouetteContourFilter<TInputImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Content: " << m_Content << std::endl;
  os << indent << "Level: " << m_Level << std::endl;
  os << indent << "LevelValue: " << m_LevelValue << std::endl;
  os << indent << "LevelFraction: " << m_LevelFraction << std::endl;
  os << indent << "ObjectIsDark: " << (m_ObjectIsDark ? "On" : "Off") << std::endl;
  os << indent << "LargestPartOnly: " << (m_LargestPartOnly ? "On" : "Off") << std::endl;
  os << indent << "MinimumArea: " << m_MinimumArea << std::endl;
  os << indent << "LabelSmoothing: " << m_LabelSmoothing << std::endl;
  os << indent << "OutputCoordinates: " << m_OutputCoordinates << std::endl;
  os << indent << "OutputOffset: " << m_OutputOffset << std::endl;
  os << indent << "UsedLevel: " << m_UsedLevel << std::endl;
}
} // namespace itk

#endif

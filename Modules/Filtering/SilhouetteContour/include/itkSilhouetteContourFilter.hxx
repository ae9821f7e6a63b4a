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

#include "itkImageRegionConstIteratorWithIndex.h"
#include "itkImageScanlineConstIterator.h"

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
  output->SetBufferedRegion(0);
  m_UsedLevel = 0.0;
  if (this->GetWholeRegion().GetNumberOfPixels() == 0)
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
void
SilhouetteContourFilter<TInputImage>::PropagateRequestedRegion(DataObject * output)
{
  if (m_NumberOfStreamDivisions <= 1)
  {
    Superclass::PropagateRequestedRegion(output);
    return;
  }
  if (!this->m_Updating)
  {
    this->EnlargeOutputRequestedRegion(output);
    this->GenerateOutputRequestedRegion(output);
  }
}

template <typename TInputImage>
void
SilhouetteContourFilter<TInputImage>::UpdateOutputData(DataObject * output)
{
  if (m_NumberOfStreamDivisions <= 1)
  {
    Superclass::UpdateOutputData(output);
    return;
  }
  if (this->m_Updating)
  {
    return;
  }
  // What ProcessObject does, but for its update of the inputs: as StreamingProcessObject, from which a filter to a mesh
  // cannot be derived.
  this->PrepareOutputs();
  this->SetAbortGenerateData(false);
  this->InvokeEvent(StartEvent());
  this->UpdateProgress(0.0f);
  this->m_Updating = true;
  try
  {
    this->GenerateData();
  }
  catch (const ProcessAborted &)
  {
    this->InvokeEvent(AbortEvent());
    this->ResetPipeline();
    this->RestoreInputReleaseDataFlags();
    throw;
  }
  catch (...)
  {
    this->ResetPipeline();
    this->RestoreInputReleaseDataFlags();
    throw;
  }
  this->UpdateProgress(1.0f);
  this->InvokeEvent(EndEvent());
  this->GetOutput()->DataHasBeenGenerated();
  this->ReleaseInputs();
  this->m_Updating = false;
}

template <typename TInputImage>
auto
SilhouetteContourFilter<TInputImage>::GetWholeRegion() -> RegionType
{
  const InputImageType * const image = this->GetInput();
  return image->GetSource() != nullptr ? image->GetLargestPossibleRegion() : image->GetBufferedRegion();
}

template <typename TInputImage>
template <typename TVisit>
void
SilhouetteContourFilter<TInputImage>::ForEachStrip(float first, float share, TVisit && visit)
{
  auto * const        image = const_cast<InputImageType *>(this->GetInput());
  const RegionType    whole = this->GetWholeRegion();
  const SizeValueType height = whole.GetSize(1);
  // An image that is there is visited in pieces too, for progress and abort.
  const bool          pull = m_NumberOfStreamDivisions > 1;
  const SizeValueType strips = std::min<SizeValueType>(pull ? m_NumberOfStreamDivisions : 32u, height);
  for (SizeValueType strip = 0; strip < strips; ++strip)
  {
    const SizeValueType begin = height * strip / strips;
    const SizeValueType end = height * (strip + 1) / strips;
    RegionType          region = whole;
    region.SetIndex(1, whole.GetIndex(1) + static_cast<IndexValueType>(begin));
    region.SetSize(1, end - begin);
    if (pull)
    {
      image->SetRequestedRegion(region);
      image->PropagateRequestedRegion();
      image->UpdateOutputData();
    }
    visit(region);
    this->UpdateProgress(first + share * static_cast<float>(end) / static_cast<float>(height));
    if (this->GetAbortGenerateData())
    {
      throw ProcessAborted(__FILE__, __LINE__);
    }
  }
}

template <typename TInputImage>
template <typename TVisit>
void
SilhouetteContourFilter<TInputImage>::ForEachValue(float first, float share, TVisit && visit)
{
  const double sign = m_ObjectIsDark ? -1.0 : 1.0;
  this->ForEachStrip(first, share, [this, sign, &visit](const RegionType & region) {
    for (ImageScanlineConstIterator<InputImageType> it(this->GetInput(), region); !it.IsAtEnd(); it.NextLine())
    {
      for (SizeValueType column = 0; !it.IsAtEndOfLine(); ++it, ++column)
      {
        visit(sign * static_cast<double>(it.Get()), column, it);
      }
    }
  });
}

template <typename TInputImage>
double
SilhouetteContourFilter<TInputImage>::FindAutomaticLevel(double background, double extreme)
{
  // Of what is not background first, then of what is above that level, so that a blurred edge counts for less.
  constexpr std::size_t    bins = 4096;
  const double             scale = static_cast<double>(bins) / (extreme - background);
  std::vector<std::size_t> histogram(bins, 0);
  this->ForEachValue(0.3f, 0.3f, [&](double value, SizeValueType, const auto &) {
    ++histogram[std::min(bins - 1, static_cast<std::size_t>((value - background) * scale))];
  });
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
  const RegionType    whole = this->GetWholeRegion();
  const SizeValueType width = whole.GetSize(0);
  const double        sign = m_ObjectIsDark ? -1.0 : 1.0;
  double              background = std::numeric_limits<double>::max();
  double              extreme = std::numeric_limits<double>::lowest();
  const auto          see = [&](double value, const auto & it) {
    if (!std::isfinite(value))
    {
      itkExceptionMacro("The pixel " << it.GetIndex() << " is " << value
                                     << ", and an iso-contour needs finite values. Replace such pixels first.");
    }
    background = std::min(background, value);
    extreme = std::max(extreme, value);
  };
  // A level that does not depend on the image is traced on the first way through it.
  const bool  known = m_Level == LevelEnum::Absolute;
  double      level = sign * m_LevelValue;
  const float seen = known ? 0.0f : (m_Level == LevelEnum::Fraction ? 0.5f : 0.6f);
  if (!known)
  {
    this->ForEachValue(0.0f,
                       m_Level == LevelEnum::Fraction ? 0.5f : 0.3f,
                       [&](double value, SizeValueType, const auto & it) { see(value, it); });
    if (!(extreme > background))
    {
      return;
    }
    level = m_Level == LevelEnum::Fraction ? background + m_LevelFraction * (extreme - background)
                                           : this->FindAutomaticLevel(background, extreme);
  }
  IsoContourTracer    tracer(static_cast<std::size_t>(width), level);
  std::vector<double> row(static_cast<std::size_t>(width));
  this->ForEachValue(seen, 1.0f - seen, [&](double value, SizeValueType column, const auto & it) {
    if (known)
    {
      see(value, it);
    }
    row[column] = value;
    if (column + 1 == width)
    {
      tracer.AddRow(row.data());
    }
  });
  if (!(extreme > background))
  {
    return;
  }
  m_UsedLevel = sign * level;
  // Above the level everywhere there is no background that a contour could separate.
  if (level >= background)
  {
    this->AddLoops(tracer.Finish(background), whole, ToothCode());
  }
}

template <typename TInputImage>
void
SilhouetteContourFilter<TInputImage>::TraceLabels()
{
  using PixelType = typename InputImageType::PixelType;
  const bool merged = m_Content == ContentEnum::MergedLabels;
  m_UsedLevel = 0.5;

  // Where each label is, and its mask there.
  struct PartType
  {
    IndexValueType             low[2];
    IndexValueType             high[2];
    ToothCode                  code;
    RegionType                 region;
    std::vector<unsigned char> mask;
  };
  std::map<PixelType, PartType> parts;
  const auto                    forEachLabelled = [this, merged](float first, float share, auto && visit) {
    this->ForEachStrip(first, share, [this, merged, &visit](const RegionType & region) {
      for (ImageRegionConstIteratorWithIndex<InputImageType> it(this->GetInput(), region); !it.IsAtEnd(); ++it)
      {
        if (it.Get() != PixelType{})
        {
          visit(merged ? PixelType{ 1 } : it.Get(), it.GetIndex());
        }
      }
    });
  };
  forEachLabelled(0.0f, 0.3f, [&parts](PixelType label, const auto & index) {
    const auto inserted = parts.emplace(label, PartType());
    PartType & part = inserted.first->second;
    for (unsigned int d = 0; d < 2; ++d)
    {
      part.low[d] = inserted.second ? index[d] : std::min(part.low[d], index[d]);
      part.high[d] = inserted.second ? index[d] : std::max(part.high[d], index[d]);
    }
  });
  for (auto & entry : parts)
  {
    PartType & part = entry.second;
    if (!merged)
    {
      const auto label = static_cast<double>(entry.first);
      const bool isWhole = label == std::floor(label) && label > 0.0 && label < 100.0;
      try
      {
        part.code = ToothCode(isWhole ? static_cast<unsigned int>(label) : 99u);
      }
      catch (const std::invalid_argument &)
      {
        itkExceptionMacro("The label " << label << " at index [" << part.low[0] << ", " << part.low[1]
                                       << "] onward is no FDI number of a permanent tooth. Map the labels to FDI, or "
                                          "call SetContent(MergedLabels).");
      }
    }
    for (unsigned int d = 0; d < 2; ++d)
    {
      part.region.SetIndex(d, part.low[d]);
      part.region.SetSize(d, static_cast<SizeValueType>(part.high[d] - part.low[d] + 1));
    }
    part.mask.assign(part.region.GetNumberOfPixels(), 0);
  }
  forEachLabelled(0.3f, 0.3f, [&parts](PixelType label, const auto & index) {
    PartType & part = parts.find(label)->second;
    part.mask[static_cast<std::size_t>(index[1] - part.low[1]) * part.region.GetSize(0) +
              static_cast<std::size_t>(index[0] - part.low[0])] = 1;
  });
  SizeValueType done = 0;
  for (const auto & entry : parts)
  {
    const PartType &          part = entry.second;
    const std::vector<double> mask(part.mask.begin(), part.mask.end());
    this->AddLoops(
      TraceMask(mask, static_cast<std::size_t>(part.region.GetSize(0)), m_LabelSmoothing), part.region, part.code);
    this->UpdateProgress(0.6f + 0.4f * static_cast<float>(++done) / static_cast<float>(parts.size()));
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
  os << indent << "NumberOfStreamDivisions: " << m_NumberOfStreamDivisions << std::endl;
  os << indent << "UsedLevel: " << m_UsedLevel << std::endl;
}
} // namespace itk

#endif

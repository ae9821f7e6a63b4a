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
#ifndef CrownSegmentation_h
#define CrownSegmentation_h

#include "itkImage.h"

#include <string>

using FloatImageType = itk::Image<float, 2>;
using LabelImageType = itk::Image<unsigned char, 2>;

/** Crowns as masks, and where the outline of each mask is the border of a crown. */
struct CrownSegmentation
{
  LabelImageType::Pointer upper;
  LabelImageType::Pointer lower;
  LabelImageType::Pointer upperBorder;
  LabelImageType::Pointer lowerBorder;
};

/** \param facing +1 where the patient looks to the right. Throws where no crowns are found. */
CrownSegmentation
SegmentCrowns(const FloatImageType * radiograph, double pixelSpacing, int facing);

/** 128 upper, 255 lower. */
void
WriteLabels(const CrownSegmentation & segmentation, const std::string & fileName);

#endif

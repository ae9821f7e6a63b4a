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
#ifndef itkReadLabelImage_h
#define itkReadLabelImage_h

#include "CephalogramExport.h"

#include "itkImage.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace itk
{
/** What a label map's file says beside its pixels.
 *
 * \ingroup Cephalogram */
struct LabelImageNotes
{
  /** What 3D Slicer calls the label's segment, in small letters, by label; of other files empty. */
  std::map<std::uint16_t, std::string> segments;
  /** Where its first pixel lies in the radiograph: 3D Slicer stores the part that has something in it. */
  std::array<int, 2> offset{ { 0, 0 } };
  /** Width and height of the radiograph, where the file is a part of it and says so; else 0. */
  std::array<std::size_t, 2> pictureSize{ { 0, 0 } };
  /** Whether the file has a part of the radiograph, and not all of it. */
  bool isPart{ false };
  /** Whether it is the NIfTI file of an array whose directions nobody knew (numpy.eye(4)): its pixels are taken as they
   * are stored, and it may have rows for columns. */
  bool isOfPlainArray{ false };
};

/** A label map in the pixel grid of a radiograph: PNG (grey or palette, whose index is the label), TIFF (whole numbers
 * of up to 32 bits), BMP, NRRD, MetaImage, NIfTI or DICOM. What an image viewer needs colours for is a number here: a
 * colour picture is an error unless its colours are grey.
 *
 * Spacing and origin are those of pixels, whatever the file says. Throws DentalInputError for what
 * CephalogramFileReader refuses, and for pixels that are no whole number from 0 to 65535.
 *
 * \ingroup Cephalogram */
Cephalogram_EXPORT Image<std::uint16_t, 2>::Pointer
                   ReadLabelImage(const std::string & fileName);
/** The same, and what else the file says.
 *
 * \ingroup Cephalogram */
Cephalogram_EXPORT Image<std::uint16_t, 2>::Pointer
                   ReadLabelImage(const std::string & fileName, LabelImageNotes & notes);

/** Weights of the points of a tooth's outline in a label map of FDI numbers: 0 where it runs along a tooth of the other
 * jaw. A pixel has one label, so that where the jaws overlap, as front teeth do in a bite, one of both teeth ends where
 * the other one begins and not where it ends; nothing says which. Empty where there is no such point.
 *
 * \param labels The label map.
 * \param points Of one outline, continuous pixel index.
 * \param isUpper Whether the tooth is of the upper jaw.
 *
 * \ingroup Cephalogram */
Cephalogram_EXPORT std::vector<double>
                   ComputeLabelBorderWeights(const Image<std::uint16_t, 2> *            labels,
                                             const std::vector<std::array<double, 2>> & points,
                                             bool                                       isUpper);

/** A picture of two tones, a mask or drawn lines, as 1 where something is drawn and 0 elsewhere. The rarer tone is what
 * is drawn, so that white on black and black on white are read alike; colours count by their luminance. Throws as
 * ReadLabelImage(), and where all pixels are alike.
 *
 * \ingroup Cephalogram */
Cephalogram_EXPORT Image<std::uint8_t, 2>::Pointer
                   ReadMaskImage(const std::string & fileName);

/** Whether a file is the NIfTI file of an array whose directions nobody knew, as in LabelImageNotes. False for a file
 * that cannot be opened.
 *
 * \ingroup Cephalogram */
Cephalogram_EXPORT bool
IsImageOfPlainArray(const std::string & fileName);

/** Whether a file begins as an image that these functions take. False for a file that cannot be opened.
 *
 * \ingroup Cephalogram */
Cephalogram_EXPORT bool
IsImageFile(const std::string & fileName);
} // namespace itk

#endif

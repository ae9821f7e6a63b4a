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
#ifndef itkAnnotationRecords_h
#define itkAnnotationRecords_h

#include "itkAnnotationFileFormat.h"
#include "itkDentalContour.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
class JsonNode;

/** What every annotation format comes down to; not installed. Points have three coordinates, of which contours use two.
 */
struct AnnotationPolyline
{
  /** Path of the polyline, of its code and of its points in the file, for messages. */
  std::string field;
  std::string codeField;
  std::string label;
  /** "upper" or "lower" where the file says so, else "". */
  std::string                        jaw;
  bool                               closed{ false };
  std::vector<std::array<double, 3>> points;
  std::vector<double>                weights;
  /** Drawing errors, px; one a point, or empty. */
  std::vector<double>        sigmas;
  DentalContour::OutlineEnum outline{ DentalContour::OutlineEnum::Unspecified };
  bool                       drafted{ false };
  /** Whether the points are continuous pixel indices, whatever the format counts from: those of a mask are. */
  bool isPixelIndex{ false };
};

/** A line of known length that somebody drew along a ruler. */
struct AnnotationCalibration
{
  std::string           field;
  std::string           label;
  double                millimetres{ 0.0 };
  std::array<double, 2> pixels{ { 0.0, 0.0 } };
};

struct AnnotationLandmark
{
  std::string           field;
  std::string           name;
  std::array<double, 3> point;
  /** Standard deviation an axis, pixels; 0 where none is said. */
  double sigma{ 0.0 };
  /** 0 to 1, of a detector; negative where none is said. */
  double confidence{ -1.0 };
};

struct AnnotationRecords
{
  AnnotationFileFormatEnum                  format{ AnnotationFileFormatEnum::DentalSCR };
  std::optional<std::array<std::size_t, 2>> imageSize;
  std::string                               imageSizeField;
  std::optional<std::string>                numbering;
  std::string                               numberingField;
  std::vector<AnnotationPolyline>           polylines;
  std::vector<AnnotationLandmark>           landmarks;
  std::vector<AnnotationCalibration>        calibrations;
  /** Names of landmarks that were not wanted. */
  std::vector<std::string> leftOut;
  std::vector<std::string> warnings;
};

/** Pixels across or down that a file may state; no radiograph has a tenth of it. */
constexpr int64_t MaximumImageSize = 1000000;

/** Points of all outlines of a file together; a tracing has some hundreds, those of masks some ten thousand. */
constexpr std::size_t MaximumNumberOfContourPoints = 200000;

/** Throws DentalInputError for a coordinate, of a pixel or in the unit of a scan, that is on no radiograph and on no
 * scan: one point far away would make what follows take memory and time for all the way to it. */
void
VerifyCoordinate(const std::string & fileName, const std::string & field, double coordinate);

/** Throws where all coordinates are shares of the picture's size, as detectors and YOLO write them: everything would
 * lie in its first pixel. */
void
VerifyAreNoShares(const std::string & fileName, const AnnotationRecords & records);

/** Every polyline of a file. Where the file is of several pictures, imageName tells which is meant. Throws
 * DentalInputError.
 *
 * \param imageSize Width and height of the radiograph, 0 where they are not known. */
AnnotationRecords
ReadContourRecords(const std::string &                fileName,
                   AnnotationFileFormatEnum           format,
                   const std::string &                imageName,
                   const std::array<std::size_t, 2> & imageSize = { { 0, 0 } });

/** Every landmark of a file, with `dimension` coordinates. Throws DentalInputError. */
AnnotationRecords
ReadLandmarkRecords(const std::string &      fileName,
                    AnnotationFileFormatEnum format,
                    unsigned int             dimension,
                    const std::string &      imageName);

/** The same of JSON that was read; its warnings stay with its document. */
AnnotationRecords
ReadLandmarkRecords(const JsonNode &         root,
                    AnnotationFileFormatEnum format,
                    unsigned int             dimension,
                    const std::string &      imageName);

/** What a file is by its name and its first bytes: CSV, CVAT or LabelImage; Automatic where it is JSON, whose content
 * tells more, or what nobody knows. */
AnnotationFileFormatEnum
AnnotationFormatFromFile(const std::string & fileName);

/** What JSON is by what it holds; DentalSCR where it is nobody else's. Lists of landmarks are not looked at. */
AnnotationFileFormatEnum
AnnotationFormatFromContent(const JsonNode & root);
} // namespace itk

#endif

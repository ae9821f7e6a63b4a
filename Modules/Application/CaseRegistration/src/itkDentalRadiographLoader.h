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
#ifndef itkDentalRadiographLoader_h
#define itkDentalRadiographLoader_h

#include "itkCephalogramFileReader.h"
#include "itkDentalCase.h"
#include "itkDentalContour.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalRadiographData.h"

#include <array>
#include <string>
#include <vector>

namespace itk
{
/** Not installed. Reads one radiograph of a case and what was drawn on it, and settles its geometry: case file before
 * DICOM before default. The lateral one is read by it, and so is each view.
 *
 * What is to be read in which order is its caller's to say; each step needs those before it. */
class DentalRadiographLoader
{
public:
  using DirectionEnum = CephalometricGeometry::DirectionEnum;
  using ContoursType = std::array<DentalContour::Pointer, 2>;

  /** `prefix` stands before the radiograph's fields in the case file: "" or "views.NAME.". All that is named outlives
   * the loader. */
  DentalRadiographLoader(const DentalCase &         dentalCase,
                         const DentalRadiograph &   description,
                         DirectionEnum              direction,
                         std::string                prefix,
                         DentalRadiographData &     data,
                         std::vector<std::string> & warnings);

  /** The picture and its size. */
  void
  LoadImage();
  /** Distances, facing, source side, principal point and pixel spacing, as far as they are known, and the grid of
   * markups. */
  void
  SettleGeometry();
  /** Of the files that the radiograph names, or of one file a tooth: upper, lower, each null where nothing is drawn.
   * Codes without a side are the left side's where `sidelessCodesAreLeft`. */
  ContoursType
  LoadContours(const std::vector<std::pair<std::string, std::string>> & classFiles, bool sidelessCodesAreLeft);
  void
  LoadLandmarks();

  /** Null where the radiograph has no picture. */
  const CephalogramFileReader *
  GetImageReader() const
  {
    return m_Image;
  }
  /** A field as the case file calls it. */
  std::string
  Field(const std::string & name) const
  {
    return m_Prefix + name;
  }
  /** Of a field of this radiograph. */
  void
  Warn(const std::string & field, const std::string & text);

private:
  /** What the plane through the ear rods is called: midsagittal, or frontal, midcoronal. */
  std::string
  Plane() const;
  bool
  Compare(const std::string & field, double given, double fromDicom);
  void
  SettleDistances();
  /** Warns where the distances magnify otherwise than a DICOM file says. */
  void
  CompareMagnification();
  void
  SettlePixelSpacing();
  /** Pixels that are no squares are most often a slip. */
  void
  CheckPixelShape();
  void
  SettleMarkupsGrid();
  void
  SettleCalibration(const DentalContourFileReader & reader);
  void
  RequireMarkupsGrid(const AnnotationFileReaderBase & reader) const;

  const DentalCase &             m_Case;
  const DentalRadiograph &       m_Description;
  DirectionEnum                  m_Direction;
  std::string                    m_Prefix;
  DentalRadiographData &         m_Data;
  std::vector<std::string> &     m_Warnings;
  CephalogramFileReader::Pointer m_Image;
};
} // namespace itk

#endif

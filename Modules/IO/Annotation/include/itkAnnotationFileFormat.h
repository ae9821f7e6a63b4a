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
#ifndef itkAnnotationFileFormat_h
#define itkAnnotationFileFormat_h

#include "AnnotationExport.h"

#include <cstdint>
#include <ostream>

namespace itk
{
/** What an annotation file is written in. \ingroup Annotation */
enum class AnnotationFileFormatEnum : uint8_t
{
  /** Names that end in .csv, .tsv or .txt are CSV; all else is recognised by what it holds. JSON that is nobody else's
   * is the toolkit's own. */
  Automatic,
  /** contours.json, landmarks2d.json, landmarks3d.json of Documentation/FileFormats.md. */
  DentalSCR,
  /** 3D Slicer's .mrk.json. */
  SlicerMarkups,
  Labelme,
  /** Lines "label,x,y" or "label,x,y,z", or columns in the order that a header names; comma, semicolon or tab, decimal
   * point or comma. Empty lines and lines that start with '#' are skipped. */
  CSV,
  /** JSON of the data sets Aariz and CEPHA29, cephalometric landmarks only. */
  Aariz,
  /** JSON of landmark detectors such as CephTrace, cephalometric landmarks only. */
  LandmarkDetector,
  /** CSV of the challenge CL-Detection 2023, "file,scale,p1x,p1y..p38y", cephalometric landmarks only. */
  CLDetection,
  /** Text of the challenge ISBI 2015: 19 lines "x,y", then class codes; cephalometric landmarks only. */
  ISBI2015,
  /** XML "CVAT for images 1.1". */
  CVAT,
  /** JSON with "images", "annotations" and "categories": polygons and keypoints. */
  COCO,
  /** JSON of the VGG Image Annotator, an export or a whole project. */
  VIA,
  /** JSON of Label Studio; its coordinates are per cent of the picture. */
  LabelStudio,
  /** JSON of Supervisely, a file a picture. */
  Supervisely,
  /** A label map, one mask a class, or drawn lines; contours only. */
  LabelImage,
  /** The archive .wceph of the program WebCeph, cephalometric landmarks only. */
  WebCeph
};

/** Where a 2-D annotation's (0, 0) is. \ingroup Annotation */
enum class AnnotationPixelOriginEnum : uint8_t
{
  /** Corner for labelme, CVAT, COCO, VIA, Label Studio, Supervisely and WebCeph, which draw on a canvas; Centre for all
   * others. */
  FormatDefault,
  /** The centre of the first pixel, as ITK's continuous index has it. */
  Centre,
  /** The corner of the first pixel: half a pixel is taken off both coordinates. */
  Corner
};

Annotation_EXPORT std::ostream &
                  operator<<(std::ostream & os, AnnotationFileFormatEnum format);
Annotation_EXPORT std::ostream &
                  operator<<(std::ostream & os, AnnotationPixelOriginEnum origin);
} // namespace itk

#endif

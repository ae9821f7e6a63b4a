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
#ifndef itkForeignFile_h
#define itkForeignFile_h

#include "DentalCommonExport.h"

#include <cstdint>
#include <string>

namespace itk
{
/** What a file was named for. \ingroup DentalCommon */
enum class FilePurposeEnum : uint8_t
{
  Scan,
  Radiograph,
  Tracing,
  Landmarks
};

/** Throws a DentalInputError where a file is of a kind that people do have but that cannot serve the purpose: it says
 * what the file is, by its first bytes, and what to export instead. "JSON syntax error at line 1" helps nobody who
 * named a spreadsheet. Does nothing for files that are not known, and for those that cannot be opened.
 *
 * Known are 3Shape's HPS, ZIP archives and what hides in them (Excel, 3MF, WebCeph), other archives, old Office files,
 * PDF, SVG, HTML, DXF, Slicer's .fcsv, .vtk and HDF5 files, text in UTF-16, pictures, DICOM, meshes, JSON and XML where
 * none is wanted.
 *
 * \ingroup DentalCommon */
DentalCommon_EXPORT void
RefuseForeignFile(const std::string & fileName, FilePurposeEnum purpose);
} // namespace itk

#endif

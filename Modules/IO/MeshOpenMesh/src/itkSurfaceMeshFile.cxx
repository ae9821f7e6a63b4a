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
#include "itkSurfaceMeshFile.h"

#include "itkBinarySTLKernel.h"
#include "itkScanFile.h"
#include "itkMeshTextParsers.h"
#include "itkPLYParser.h"

namespace itk
{
SurfaceMeshFileError::SurfaceMeshFileError(const std::string & inField,
                                           const std::string & inProblem,
                                           const std::string & inRemedy)
  : std::runtime_error(inField + (inField.empty() ? "" : ": ") + inProblem)
  , field(inField)
  , problem(inProblem)
  , remedy(inRemedy)
{}

SurfaceMeshFileError::~SurfaceMeshFileError() = default;

SurfaceMeshFile
ParseSurfaceMesh(const char * bytes, std::size_t size, const std::string & fileName)
{
  if (size == 0)
  {
    throw SurfaceMeshFileError("", "the file is empty (0 bytes)", "export or copy the scan again");
  }
  const MeshFileFormatEnum format = DetectMeshFileFormat(bytes, size, fileName);
  SurfaceMeshFile          surface;
  switch (format)
  {
    case MeshFileFormatEnum::BinarySTL: {
      WeldedTriangles welded = ParseBinarySTL(bytes, size);
      surface.floatPoints = std::move(welded.points);
      surface.triangles = std::move(welded.triangles);
      surface.numberOfFacesInFile = welded.numberOfFacets;
      surface.numberOfDegenerateFaces = welded.numberOfDegenerateFacets;
      if (welded.numberOfTrailingBytes > 0)
      {
        surface.warning = "has " + std::to_string(welded.numberOfTrailingBytes) + " bytes behind its " +
                          std::to_string(welded.numberOfFacets) + " facets, which are not looked at";
      }
      break;
    }
    case MeshFileFormatEnum::AsciiSTL:
      surface = ParseAsciiSTL(bytes, size);
      break;
    case MeshFileFormatEnum::PLY:
      surface = ParsePLY(bytes, size);
      break;
    case MeshFileFormatEnum::OBJ:
      surface = ParseOBJ(bytes, size);
      break;
    case MeshFileFormatEnum::OFF:
      surface = ParseOFF(bytes, size);
      break;
    default:
      throw SurfaceMeshFileError(
        "", "neither its content nor its extension is of a known mesh format", "give an STL, PLY, OBJ or OFF file");
  }
  surface.format = format;
  if (surface.triangles.empty())
  {
    throw SurfaceMeshFileError("",
                               surface.numberOfFacesInFile == 0
                                 ? std::string("has no triangles")
                                 : "all of its " + std::to_string(surface.numberOfFacesInFile) +
                                     " faces name a point twice",
                               "export or copy the scan again");
  }
  return surface;
}

SurfaceMeshFile
ReadSurfaceMeshFile(const std::string & fileName)
{
  const ScanFile file(fileName);
  return ParseSurfaceMesh(file.GetData(), file.GetSize(), fileName);
}
} // namespace itk

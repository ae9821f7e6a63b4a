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
#ifndef itkWebCephRecords_h
#define itkWebCephRecords_h

#include "itkCephalometricLandmarkRecords.h"

#include <string>

namespace itk
{
/** Not installed. Whether a file is an archive of the program WebCeph: ZIP with an "index.json" at its root. */
bool
IsWebCephFile(const std::string & fileName);

/** Every dental landmark that was set by hand on one picture of such an archive, and the names of all others in
 * leftOut. Of several cephalograms the one with the radiograph's name is taken. Throws DentalInputError.
 *
 * The points are of the picture as it lies in the archive, counted from its corner. flipX, flipY say how WebCeph shows
 * it and turn nothing: the archive among its own tests has a flipped picture, and its landmarks lie on the anatomy of
 * the one that is not. */
AnnotationRecords
ReadWebCephRecords(const std::string & fileName, const IsDentalLandmarkType & isDental, const std::string & imageName);
} // namespace itk

#endif

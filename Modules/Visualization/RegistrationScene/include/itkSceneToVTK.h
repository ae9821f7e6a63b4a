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
#ifndef itkSceneToVTK_h
#define itkSceneToVTK_h

#include "RegistrationSceneVTKExport.h"
#include "itkRegistrationScene.h"

#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace itk
{
/** A part as VTK's surface or lines. Its colour (red, green, blue, opacity; 0 to 1) is the field data "Color", teeth
 * are the point data "FDI", and places in a picture are texture coordinates as VTK counts them, from the lower left
 * corner.
 *
 * \ingroup RegistrationScene */
RegistrationSceneVTK_EXPORT vtkSmartPointer<vtkPolyData>
                            ScenePartToVTK(const ScenePart & part);

/** The picture on a detector as an image in its place in space, first row uppermost: what shows a radiograph in
 * ParaView and Slicer. Null where the part has no picture.
 *
 * \ingroup RegistrationScene */
RegistrationSceneVTK_EXPORT vtkSmartPointer<vtkImageData>
                            ScenePictureToVTK(const ScenePart & part);

/** Every part as a block of its name, and the radiograph of view "lateral" as block "lateral radiograph" behind its
 * detector.
 *
 * \ingroup RegistrationScene */
RegistrationSceneVTK_EXPORT vtkSmartPointer<vtkMultiBlockDataSet>
                            SceneToVTK(const RegistrationScene & scene);

/** All of it as one surface, for programs that read no blocks: colours are the point data "Color" (0 to 255), the
 * part's number is the cell data "Part" and its name in the field data "PartNames". A detector is a grid that has its
 * radiograph as colours, of at most `pictureSize` pixels in width and height.
 *
 * \ingroup RegistrationScene */
RegistrationSceneVTK_EXPORT vtkSmartPointer<vtkPolyData>
                            SceneToOnePolyData(const RegistrationScene & scene, unsigned int pictureSize = 512);
} // namespace itk

#endif

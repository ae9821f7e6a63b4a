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
#ifndef itkOverlayPanel_h
#define itkOverlayPanel_h

#include "itkOverlayCanvas.h"

// What stands beside the radiograph: title and badge, legend, table of landmark errors. Private to this module.
namespace itk
{
namespace OverlayDrawing
{
/** The title with the badge of the status. */
void
DrawHeader(Canvas & canvas, const OverlayScene & scene, const Box & box, double font);

/** \return the first free row. */
double
DrawLegend(Canvas & canvas, const OverlayScene & scene, const Box & box, double font);

/** Landmark errors, their mean last. */
void
DrawTable(Canvas & canvas, const OverlayScene & scene, const Box & box, double font);
} // namespace OverlayDrawing
} // namespace itk

#endif

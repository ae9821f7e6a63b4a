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
#ifndef itkOverlayView_h
#define itkOverlayView_h

#include "itkOverlayCanvas.h"

// What lies on the radiograph: the picture itself, contours, landmarks with their labels, the scale bar. The large view
// and the small one in the panel share it. Private to this module.
namespace itk
{
namespace OverlayDrawing
{
struct PenType
{
  Colour colour;
  double width;
  double alpha;
};

/** The tracing is drawn wide and the silhouette narrow on top of it: where they agree both are seen. */
PenType
PenOf(OverlayScene::RoleEnum role);

/** A landmark's name as it is printed. */
std::string
LandmarkText(const std::string & name);

/** Not a number where one of the two places is unknown. */
double
LandmarkErrorInPixels(const OverlayScene::LandmarkType & landmark);

void
DrawRadiograph(Canvas & canvas, cairo_surface_t * radiograph, const OverlayScene & scene, const Mapping & map);

void
DrawContours(Canvas & canvas, const OverlayScene & scene, const Mapping & map, const Box & box, double thickness);

/** Error vectors, marks, 95 % regions, and each name where it hides least. */
void
DrawLandmarks(Canvas & canvas, const OverlayScene & scene, const Mapping & map, const Box & box, double font);

void
DrawScaleBar(Canvas & canvas, const OverlayScene & scene, const Mapping & map, const Box & box, double font);
} // namespace OverlayDrawing
} // namespace itk

#endif

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
#ifndef itkOverlayFont_h
#define itkOverlayFont_h

#include <cairo.h>

namespace itk
{
namespace OverlayDrawing
{
/** DejaVu Sans, which travels in this library: a picture has the same letters on every machine, whatever fonts are
 * installed there, and has letters where none are. One for the process, never released; cairo takes care of threads. */
cairo_font_face_t *
GetFontFace(bool bold);
} // namespace OverlayDrawing
} // namespace itk

#endif

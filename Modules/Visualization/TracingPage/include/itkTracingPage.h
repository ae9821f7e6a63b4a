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
#ifndef itkTracingPage_h
#define itkTracingPage_h

#include "TracingPageExport.h"

#include "itkImage.h"

#include <array>
#include <string>

namespace itk
{
/** \struct TracingPageContent
 * \brief What a tracing page is made of.
 * \ingroup TracingPage
 */
struct TracingPageContent
{
  /** As the toolkit reads it, hence upright. Not null. */
  Image<float, 2>::ConstPointer radiograph;
  /** mm a pixel, u and v; where they differ the page shows the pixels as they are, not square. {1, 1} where unknown. */
  std::array<double, 2> pixelSpacing{ { 1.0, 1.0 } };
  /** mm a pixel, and the first pixel's centre, mm, of the grid in which 3D Slicer shows the radiograph: u and v of
   * each. Without a word of it Slicer gives a picture pixels of a millimetre. */
  std::array<double, 4> markupsGrid{ { 1.0, 1.0, 0.0, 0.0 } };
  /** For a person: the radiograph's name. */
  std::string title;
  /** What tells this radiograph from another one, for the drawing that the browser keeps: a digest. */
  std::string identity;
  /** What is drawn already, as the texts of files: contours.json, and an object of landmarks by name. "": nothing. */
  std::string contours;
  std::string landmarks;
  /** The page is answered by a server, which takes what is drawn; else the page stands alone. */
  bool served{ false };
  /** The number by which the server knows the page. */
  unsigned int number{ 0 };
  /** The names of the files that the server writes; "" where it writes none. */
  std::string contoursFile;
  std::string landmarksFile;
  /** These files hold what is drawn already, which may be from others. */
  bool contoursAreSaved{ false };
  bool landmarksAreSaved{ false };
  /** Begin with saving after each change: where there is nothing yet that could be lost by it. */
  bool savesItself{ false };
  /** The server knows the scans. */
  bool canRegister{ false };
};

/** The page, HTML with everything in it: it asks nothing of the network but its own server. Throws ExceptionObject
 * where there is no radiograph or it cannot be compressed, and DentalInputError where what was drawn already is no
 * JSON.
 *
 * \ingroup TracingPage */
TracingPage_EXPORT std::string
                   MakeTracingPage(const TracingPageContent & content);
} // namespace itk

#endif

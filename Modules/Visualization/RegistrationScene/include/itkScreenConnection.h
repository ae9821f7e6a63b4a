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
#ifndef itkScreenConnection_h
#define itkScreenConnection_h

#include "RegistrationSceneVTKExport.h"

#include "itkMacro.h"

namespace itk
{
/** \class ScreenConnection
 * \brief A connection with the X server that DISPLAY names, for as long as the object lives.
 *
 * It tells whether there is a screen, and keeps it there: a server that was not told otherwise begins anew when its
 * last client goes, as one of xvfb-run does, and turns others away meanwhile. VTK crashes where it is turned away.
 * Hence who asks whether there is a screen, in order to draw on it, holds the connection until it has drawn.
 *
 * \ingroup RegistrationScene
 */
class RegistrationSceneVTK_EXPORT ScreenConnection
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ScreenConnection);

  ScreenConnection();
  ~ScreenConnection();

  /** Whether the server answers. */
  bool
  IsOpen() const
  {
    return m_Display != nullptr;
  }

private:
  /** Xlib's Display. */
  void * m_Display;
};
} // namespace itk

#endif

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
#ifndef itkVirtualScreen_h
#define itkVirtualScreen_h

#include "RegistrationSceneVTKExport.h"

#include "itkMacro.h"

#include <string>

namespace itk
{
/** \class VirtualScreen
 * \brief A screen that nobody sees, for as long as the object lives.
 *
 * Debian's VTK draws to an X window alone, and ends the program where there is none. This starts Xvfb, an X server that
 * draws to memory, on a display number that Xvfb itself finds free, and makes it the DISPLAY of this process; the
 * destructor stops it and puts the old DISPLAY back. The server also ends with the process, however that ends (and with
 * the thread that made this object: let that one outlive it). One at a time, before other threads read the environment.
 *
 * \test itkVirtualScreenGTest.cxx
 *
 * \ingroup RegistrationScene
 */
class RegistrationSceneVTK_EXPORT VirtualScreen
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VirtualScreen);

  /** Throws an ExceptionObject where Xvfb is not installed or does not start. */
  VirtualScreen(unsigned int width, unsigned int height);
  ~VirtualScreen();

  /** "" where it is not on the PATH. */
  static std::string
  FindProgram();

  /** ":99", the value that DISPLAY has meanwhile. */
  const std::string &
  GetDisplay() const
  {
    return m_Display;
  }
  /** Of the server's process. */
  long
  GetProcessId() const
  {
    return m_ProcessId;
  }

private:
  void
  Stop();

  std::string m_Display;
  std::string m_OldDisplay;
  bool        m_HadDisplay{ false };
  long        m_ProcessId{ -1 };
};
} // namespace itk

#endif

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
#include "dentalscrCommandTools.h"
#include "dentalscrViewOptions.h"

#include "itkCaseSceneFileReader.h"
#include "itkDentalInputError.h"
#include "itkDescribePlainly.h"
#include "itkRegistrationSceneWindow.h"
#include "itkScreenConnection.h"
#include "itkVirtualScreen.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <memory>
#include <string>

namespace
{
int
Fail(std::string message)
{
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "dentalscr: " << message << std::endl;
  return dentalscr::UnusableInput;
}

int
Show(const dentalscr::ViewOptions & options, bool quiet)
{
  // What the options alone tell is said before a case is read.
  if (!options.exportFile.empty())
  {
    itk::RegistrationSceneWindow::VerifyExportName(options.exportFile);
  }
  const bool                          wantsScreen = options.exportFile.empty() || !options.snapshot.empty();
  std::unique_ptr<itk::VirtualScreen> screen;
  if (!options.snapshot.empty() && !itk::VirtualScreen::FindProgram().empty())
  {
    // Also where there is a screen: the picture is the same on every machine, and no window flashes up.
    screen = std::make_unique<itk::VirtualScreen>(options.size[0], options.size[1]);
  }
  // Held for as long as something is drawn.
  std::unique_ptr<itk::ScreenConnection> connection;
  if (wantsScreen)
  {
    connection = std::make_unique<itk::ScreenConnection>();
  }
  if (wantsScreen && !connection->IsOpen())
  {
    return Fail(
      options.snapshot.empty()
        ? "view: there is no screen to open a window on (DISPLAY names none that answers); use --snapshot FILE.png "
          "or --export FILE.gltf"
        : "--snapshot: there is no screen, and no Xvfb to draw without one; install it (apt-get install xvfb)");
  }

  auto reader = itk::CaseSceneFileReader::New();
  reader->SetFileName(options.result);
  reader->SetCaseFileName(options.caseFile);
  reader->Update();
  for (const std::string & warning : reader->GetWarnings())
  {
    std::cerr << "dentalscr: warning: " << warning << std::endl;
  }
  auto window = itk::RegistrationSceneWindow::New();
  window->SetScene(reader->GetOutput());
  window->SetCamera(options.camera);
  window->SetSize(options.size);
  window->SetTitle("DentalSCR: " + options.result);
  if (!options.exportFile.empty())
  {
    window->WriteExport(options.exportFile);
  }
  if (!options.snapshot.empty())
  {
    window->WriteSnapshot(options.snapshot);
  }
  for (const std::string & file : { options.exportFile, options.snapshot })
  {
    if (!file.empty() && !quiet)
    {
      std::cout << "written to " << file << std::endl;
    }
  }
  if (options.exportFile.empty() && options.snapshot.empty())
  {
    window->Show();
  }
  return dentalscr::AllRegistered;
}
} // namespace

int
main(int argc, char * argv[])
{
  CLI::App program{ "Shows a registered case in space. Called by the verb view of dentalscr, which has the examples." };
  program.name("dentalscr-view");
  dentalscr::ViewOptions options;
  bool                   quiet = false;
  options.AddTo(&program);
  program.add_flag("--quiet", quiet, "No word of what was written");
  try
  {
    program.parse(argc, argv);
  }
  catch (const CLI::ParseError & error)
  {
    return error.get_exit_code() == 0 ? program.exit(error)
                                      : Fail(std::string(error.what()) + "; see dentalscr view --help");
  }
  try
  {
    return Show(options, quiet);
  }
  catch (const itk::DentalInputError & error)
  {
    return Fail(error.GetOneLine());
  }
  catch (const itk::ExceptionObject & error)
  {
    return Fail(itk::DescribePlainly(error));
  }
  catch (const std::bad_alloc &)
  {
    return Fail("out of memory");
  }
  catch (const std::exception & error)
  {
    return Fail(error.what());
  }
}

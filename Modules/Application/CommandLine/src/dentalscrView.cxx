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
#include "dentalscrRunGuarded.h"
#include "dentalscrViewOptions.h"

#include "itkCaseSceneFileReader.h"
#include "itkRegistrationSceneWindow.h"
#include "itkScreenConnection.h"
#include "itkVirtualScreen.h"

#include <iostream>
#include <memory>
#include <string>

namespace
{
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
    return dentalscr::Fail(
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

int
Run(int argc, const char * const * argv)
{
  CLI::App program{ "Shows a registered case in space. Called by the verb view of dentalscr, which has the examples." };
  program.name("dentalscr-view");
  dentalscr::ViewOptions options;
  bool                   quiet = false;
  unsigned int           threads = 0;
  options.AddTo(&program);
  program.add_flag("--quiet", quiet, "No word of what was written");
  program.add_option("--threads", threads, "Number of threads (0: all)")->check(CLI::Range(0u, 1024u));
  try
  {
    program.parse(argc, argv);
  }
  catch (const CLI::ParseError & error)
  {
    return error.get_exit_code() == 0 ? program.exit(error)
                                      : dentalscr::Fail(std::string(error.what()) + "; see dentalscr view --help");
  }
  dentalscr::SetNumberOfThreads(threads);
  return Show(options, quiet);
}
} // namespace

int
main(int argc, char * argv[])
{
  return dentalscr::RunGuarded([&]() { return Run(argc, argv); });
}
